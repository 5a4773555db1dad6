/* SPDX-License-Identifier: GPL-3.0-or-later */
/* verdict.h - what a scenario expects, held against what was measured. */
#ifndef FW_VERDICT_H
#define FW_VERDICT_H

#include "experiments/measurement.h"

#include <stdio.h>

enum { FW_VERDICT_TEXT = 224 };

typedef struct fw_verdict {
    const fw_expectation *expectation;
    double measured; /* in a study: the mean over its seeds */
    double error;    /* standard error of it, over the seeds of a study, or of a mean over time with
                        its samples' correlation (averages.h); NaN: not known */
    int seeds;
    bool holds;                     /* never, where the measured number is not finite */
    char quantity[FW_VERDICT_TEXT]; /* "elongation.chain x, maximum" */
    char expected[FW_VERDICT_TEXT]; /* "0.8 +- 1e-10", "< 1e-11" */
    char found[FW_VERDICT_TEXT];    /* "0.7999", "1.0005 +- 0.0036 (4 seeds)" */
} fw_verdict;

/* Judges expectation `number` of the scenario. */
fw_verdict fw_verdict_of(const fw_scenario *scenario, const fw_measurement *measurement,
                         int number);

/* The measured number of one seed alone: 0 is the first, or the only one. */
double fw_verdict_of_seed(const fw_scenario *scenario, const fw_measurement *measurement,
                          int number, int seed);

/* The table that a run ends with: quantity, expected, measured, verdict, source; nothing where
 * nothing is expected. Returns how many expectations failed. */
int fw_verdict_print(FILE *out, const fw_scenario *scenario, const fw_measurement *measurement);

#endif
