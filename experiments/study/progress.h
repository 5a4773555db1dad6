/* SPDX-License-Identifier: GPL-3.0-or-later */
/* progress.h - how far a whole command is, with all runs of its study or sweep: its rate, and the
 * time left. On a terminal it is one line that is written over and over and fits the width;
 * elsewhere a line now and then. Work is counted in particle steps. */
#ifndef FW_PROGRESS_H
#define FW_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct fw_progress {
    FILE *out;           /* NULL: says nothing */
    char label[160];     /* what is running: "friction-sweep 2/7 A=2.5" */
    double total;        /* work of all runs; whoever makes them adds it */
    double done;         /* work that is done, also by others before this process */
    double found;        /* the part of others */
    double began, shown; /* seconds; 0: no work was done yet */
    double every;        /* seconds between two lines */
    bool terminal;
    int width; /* columns of a terminal; 0: as it says itself */
} fw_progress;

/* NULL as `out`: says nothing. */
fw_progress fw_progress_begin(FILE *out, const char *label);
/* What is running now, by any thread (printf format). */
void fw_progress_name(fw_progress *progress, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* Work that was done before. `progress` may be NULL, here, above and below. */
void fw_progress_find(fw_progress *progress, double work);
/* More work was done, by any thread; shows it when it is time. */
void fw_progress_add(fw_progress *progress, double work);
/* Wipes the line. */
void fw_progress_end(fw_progress *progress);

/* Seconds of a clock that never goes back. */
double fw_progress_clock(void);

#endif
