/* SPDX-License-Identifier: GPL-3.0-or-later */
/* verdict.h - what a scenario expects, held against what was measured. */
#ifndef FW_VERDICT_H
#define FW_VERDICT_H

#include "experiments/measures/measurement.h"

#include <stdio.h>

enum { FW_VERDICT_TEXT = 224 };

typedef struct fw_verdict {
    const fw_expectation *expectation;
    const char *in;  /* name of the case of a sweep that it speaks of; NULL: there are none */
    bool asked;      /* whether it counts: not where only another case is asked */
    double measured; /* in a study: the mean over its seeds */
    double error;    /* standard error of it, over the seeds of a study, or of a mean over time with
                        its samples' correlation (averages.h); NaN: not known */
    bool at_least;   /* the series is too short for its correlation: the error is a lower bound */
    int seeds;       /* that have a number ... */
    int seeds_asked; /* ... of so many; 0: not known */
    bool holds;      /* never, where the measured number is not finite */
    char quantity[FW_VERDICT_TEXT]; /* "elongation.chain x, maximum" */
    char expected[FW_VERDICT_TEXT]; /* "0.8 +- 1e-10", "< 1e-11" */
    char why[FW_VERDICT_TEXT];      /* why there is no number, where there is none; "": not known */
    char found[FW_VERDICT_TEXT];    /* "0.7999", "1.0005 +- 0.0036 (4 seeds)" */
} fw_verdict;

/* Judges expectation `number` of the scenario. */
fw_verdict fw_verdict_of(const fw_scenario *scenario, const fw_measurement *measurement,
                         int number);

/* "holds", "FAILS", or "not measured": no number holds nothing. */
const char *fw_verdict_word(const fw_verdict *verdict);

/* The measured number of one seed alone: 0 is the first, or the only one. */
double fw_verdict_of_seed(const fw_scenario *scenario, const fw_measurement *measurement,
                          int number, int seed);

/* What follows from `expectation`, `measured`, `error` and `seeds`: expected, found, holds. Of a
 * trend, measured is the change from one value to the next that speaks most against it. */
void fw_verdict_judge(fw_verdict *verdict);

/* Several verdicts. */
typedef struct fw_verdicts {
    int count;
    fw_verdict *item; /* owned */
} fw_verdicts;

/* Of a run or study: one per expectation. FW_SYSTEM_FAILED without memory. */
fw_status fw_verdicts_create(fw_verdicts *verdicts, const fw_scenario *scenario,
                             const fw_measurement *measurement, fw_error *error);
/* All zero is legal. */
void fw_verdicts_clear(fw_verdicts *verdicts);
/* Does the expectation count in that scenario? */
bool fw_verdict_is_asked(const fw_scenario *scenario, const fw_expectation *expectation);
/* How many are asked, and how many of these fail. */
int fw_verdicts_asked(const fw_verdicts *verdicts);
int fw_verdicts_failed(const fw_verdicts *verdicts);

/* The table that a run ends with, of those that are asked: case of the sweep, quantity, expected,
 * measured, verdict, source; nothing where nothing is expected. */
void fw_verdicts_print(FILE *out, const fw_verdicts *verdicts);

#endif
