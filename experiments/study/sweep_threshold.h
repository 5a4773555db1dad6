/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_threshold.h - where a number that the cases of a sweep show crosses a level along one
 * parameter, and the values at which that would be known better. */
#ifndef FW_SWEEP_THRESHOLD_H
#define FW_SWEEP_THRESHOLD_H

#include "sweep_case.h"

/* A case is on one side of the level for sure where its mean differs from it by more than the
 * standard error. The threshold lies between the last case that is surely on the side of the low
 * end, all before it being so too, and the first that is surely on that of the high end, all behind
 * it being so too: `at` is the middle of that interval, `error` half its width. So the error holds
 * what the cases are apart, and how far the seeds leave the crossing open. */
typedef struct fw_threshold {
    double at, error;          /* NaN where there is none */
    char line[FW_CASE_NAME];   /* "A=2": values of the other parameters; "" without any */
    char why[FW_VERDICT_TEXT]; /* there is none */
    int seeds;
    int next_count; /* values with which the gaps beside the sure cases would be halved */
    double next[2];
} fw_threshold;

/* Is it the first case of its line, on which only that parameter differs? */
bool fw_sweep_is_head(const fw_scenario_sweep *plan, int number, int along);

/* Of the line of a case, for the level of an expectation of the sweep. FW_SYSTEM_FAILED without
 * memory. */
fw_status fw_sweep_threshold_find(fw_threshold *threshold, const fw_scenario *sweep,
                                  const fw_sweep_case *cases, int head, int expectation,
                                  fw_error *error);

/* DIRECTORY/thresholds.csv: a row per crossing and line, where any is expected. */
#define FW_THRESHOLDS_FILE "thresholds.csv"
fw_status fw_sweep_thresholds_write(const char *directory, const fw_scenario *sweep,
                                    const fw_sweep_case *cases, fw_error *error);

/* The sweep with the cases that its bisection asks for next; *larger NULL: it is at its end. */
fw_status fw_sweep_bisect(fw_scenario **larger, const fw_scenario *sweep,
                          const fw_sweep_case *cases, fw_error *error);

#endif
