/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_case.h - one case of a sweep: a study of its own, run, gone on with, or read back from a
 * folder where it is finished. */
#ifndef FW_SWEEP_CASE_H
#define FW_SWEEP_CASE_H

#include "experiments/measures/profile_table.h"
#include "experiments/measures/verdict.h"
#include "experiments/study/run.h"

typedef struct fw_sweep_case {
    char name[FW_CASE_NAME]; /* "A=2.5" */
    fw_scenario *scenario;
    fw_verdicts verdicts;                /* one per expectation; none before the end */
    fw_outcome layer[FW_LAYER_MEASURES]; /* where there is a profile */
    fw_error failure;                    /* FW_DIVERGED, and why: it has none of the above */
    bool missing;                        /* nor has it yet: somebody else is at work on it */
} fw_sweep_case;

/* Case `number` of the sweep; to be cleared also after a failure. */
fw_status fw_sweep_case_make(fw_sweep_case *made, const fw_scenario *sweep, int number,
                             fw_error *error);
void fw_sweep_case_clear(fw_sweep_case *c);
/* Could it begin? */
fw_status fw_sweep_case_check(const fw_sweep_case *c, fw_error *error);

/* Where a case stands, as its folder says. */
typedef enum fw_sweep_stage {
    FW_STAGE_NOT_BEGUN,
    FW_STAGE_BEGUN,
    FW_STAGE_FINISHED,
    FW_STAGE_FAILED /* its numbers have diverged */
} fw_sweep_stage;

/* To its end, from where it stands in options->directory; NULL: from its beginning, without
 * results. A case that somebody else claims is left to them, and is missing then. As
 * fw_study_to_end; a case that has diverged earlier is not run again. FW_BAD_INPUT: the results are
 * of another scenario. */
fw_status fw_sweep_case_complete(fw_sweep_case *c, const fw_run_options *options, fw_error *error);
/* Reads a case back that has come to its end there; any other is missing then, and *stage says
 * where it stands. FW_DIVERGED as above. */
fw_status fw_sweep_case_read(fw_sweep_case *c, const fw_run_options *options, fw_sweep_stage *stage,
                             fw_error *error);

#endif
