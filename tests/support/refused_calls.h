/* SPDX-License-Identifier: GPL-3.0-or-later */
/* refused_calls.h - calls to the system that a test named *_refused_calls lets it refuse, or do by
 * half. */
#ifndef FW_REFUSED_CALLS_H
#define FW_REFUSED_CALLS_H

#include <stdbool.h>

typedef enum refused_call {
    REFUSED_NONE,
    REFUSED_OPEN,
    REFUSED_FSTAT,
    REFUSED_READ,
    REFUSED_PREAD,
    REFUSED_PWRITE,
    REFUSED_FREAD,
    REFUSED_FSYNC,
    REFUSED_FLOCK,
    REFUSED_ACCESS,
    REFUSED_FCLOSE
} refused_call;

/* What moves bytes then moves half of them, and does not fail. */
enum { BY_HALF = 0 };
/* It moves none, and does not fail. */
enum { NOTHING_MOVES = -1 };

/* Lets the call of that kind with number `which`, from 1 on, fail once with `reason`, an errno or
 * one of the above. A stream that fails to close is closed all the same. */
void refuse_call(refused_call kind, int which, int reason);
/* Whether that happened; from then on all calls are as they are. */
bool call_was_refused(void);

#endif
