/* SPDX-License-Identifier: GPL-3.0-or-later */
/* status.h - how a failure of the outer world (user, disk, memory) travels up to the command line.
 * A programmer's mistake is an assert instead. Only the command line prints and exits.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_STATUS_H
#define FW_STATUS_H

#include "core/public.h"

FW_PUBLIC_BEGIN

/* The values are the program's exit codes, see `fretwork --help`. */
typedef enum fw_status {
    FW_OK = 0,
    FW_EXPECTATION_FAILED = 1, /* a run ended well, but a number it was to show did not come out */
    FW_BAD_INPUT = 2,          /* what the user wrote cannot be run */
    FW_DIVERGED = 3,           /* a particle's numbers are no longer finite, or it escaped */
    FW_SYSTEM_FAILED = 4,      /* disk, memory, permissions */
    FW_HUNG_UP = 129,          /* SIGHUP, after a checkpoint */
    FW_INTERRUPTED = 130,      /* SIGINT, after a checkpoint */
    FW_TERMINATED = 143        /* SIGTERM, after a checkpoint */
} fw_status;

/* Room for two paths and what is wrong with them. */
enum { FW_SENTENCE_SIZE = 10240 };

/* One clear sentence: what was found, where, and what was expected. */
typedef struct fw_error {
    fw_status status;
    char sentence[FW_SENTENCE_SIZE];
} fw_error;

/* Writes the sentence (printf format) into *error, which may be NULL, and returns `status`. One
 * that is too long loses its middle, not its end. */
fw_status fw_fail(fw_error *error, fw_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The failure of an allocation of `what` ("positions of 10000 particles"). */
fw_status fw_fail_memory(fw_error *error, const char *what);

/* A case that the program itself rules out, as a value of an enum that it does not know: a mistake
 * of the program that must not pass for success. FW_SYSTEM_FAILED; `what` names the case. */
fw_status fw_fail_impossible(fw_error *error, const char *what);

/* Puts "prefix: " before an error on its way up; returns its status, FW_SYSTEM_FAILED of NULL. */
fw_status fw_fail_within(fw_error *error, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Hands a failure on to the caller at once. */
#define FW_TRY(call)                                                                               \
    do {                                                                                           \
        fw_status fw_try_status = (call);                                                          \
        if (fw_try_status != FW_OK) return fw_try_status;                                          \
    } while (0)

FW_PUBLIC_END

#endif
