/* SPDX-License-Identifier: GPL-3.0-or-later */
/* progress.h - a line that says how far a run is, its rate, and the time left. */
#ifndef FW_PROGRESS_H
#define FW_PROGRESS_H

#include <stdint.h>
#include <stdio.h>

typedef struct fw_progress {
    FILE *out; /* NULL: says nothing */
    const char *name;
    int64_t first, last;
    double started, shown; /* seconds */
    double particles;
} fw_progress;

/* Shows itself on `out` if that is a terminal; NULL: never. */
fw_progress fw_progress_begin(FILE *out, const char *name, int64_t first, int64_t last,
                              double particles);
/* To be called often; writes at most ten times a second. */
void fw_progress_show(fw_progress *progress, int64_t step);
/* Wipes the line. */
void fw_progress_end(fw_progress *progress);

/* Seconds of a clock that never goes back. */
double fw_progress_clock(void);

#endif
