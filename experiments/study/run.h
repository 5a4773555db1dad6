/* SPDX-License-Identifier: GPL-3.0-or-later */
/* run.h - runs an experiment: steps, measures, records, checkpoints, and goes on where it stopped.
 */
#ifndef FW_RUN_H
#define FW_RUN_H

#include "experiments/measures/measurement.h"
#include "experiments/study/progress.h"
#include "experiments/study/recorder.h"

#include <stdio.h>

/* Plain data. */
typedef struct fw_run_options {
    const char *directory; /* of the results; NULL: only measured, nothing is written */
    bool overwrite;        /* an earlier result is replaced, else refused */
    int threads;
    int at_once;           /* runs of a study side by side; 0: as many as there are processors */
    const char *name;      /* of the experiment, in sentences */
    fw_progress *progress; /* of all runs together; NULL: none */
    bool keep_open;        /* the results file is ended by fw_run_finish, not by the last step */
    FILE *warnings;        /* where warnings (warning.h) are written; NULL: nowhere */
} fw_run_options;

typedef struct fw_run fw_run;

/* Builds what is run, which shows whether it can be: no folder is taken, nothing is measured. */
fw_status fw_run_make(fw_run **run, const fw_scenario *scenario, const fw_run_options *options,
                      fw_error *error);
/* Takes the folder and measures the start. After a failure the run is there to be abandoned. */
fw_status fw_run_start(fw_run *run, fw_error *error);
/* Both: from the beginning. On failure nothing of it stays on disk. */
fw_status fw_run_begin(fw_run **run, const fw_scenario *scenario, const fw_run_options *options,
                       fw_error *error);
/* From the newest checkpoint in options->directory. FW_BAD_INPUT: the run is finished, or there is
 * nothing to go on from. `scenario` is the one in the results file. *note, if not empty, says what
 * the user should know. */
fw_status fw_run_resume(fw_run **run, const fw_scenario *scenario, const fw_run_options *options,
                        char note[FW_SENTENCE_SIZE], fw_error *error);

/* To the end. FW_INTERRUPTED, FW_TERMINATED or FW_HUNG_UP: a signal came; a checkpoint was written.
 * FW_DIVERGED, FW_SYSTEM_FAILED: the last checkpoint stays whole. */
fw_status fw_run_to_end(fw_run *run, fw_error *error);

/* 1 to `most` steps, or fewer to the end, measured and recorded as on the way there; positions are
 * right. Fails as fw_run_to_end; the results then say why. */
fw_status fw_run_advance(fw_run *run, int64_t most, fw_error *error);
/* Leaves off where it is, as at a signal: what was written can be resumed. Never FW_OK: as a
 * signal, FW_INTERRUPTED with the sentence that the results keep. */
fw_status fw_run_stop(fw_run *run, fw_error *error);
/* Lets the folder of the results go; they are ended, and nothing follows but looking. */
void fw_run_close(fw_run *run);

/* Particle steps of one run, for the progress. */
double fw_run_work(const fw_scenario *scenario);

/* With keep_open: what is known of the run as a whole, and the end. */
fw_status fw_run_write_array(fw_run *run, const fw_trajectory_array *array, const double *values,
                             fw_error *error);
fw_status fw_run_finish(fw_run *run, fw_error *error);
/* The same where another run of the study has failed. */
void fw_run_fail(fw_run *run, fw_status status, const char *reason);
/* What the user was warned of, a line each, as the results keep it; "" without results. */
const char *fw_run_warnings(const fw_run *run);
/* For expectations of a study's outcome; all are observed. */
void fw_run_set_outcome(fw_run *run, const fw_outcome *outcome, const double *outcome_of_seeds);
/* For all other expectations: what all seeds measured; observed. */
void fw_run_set_seeds(fw_run *run, const fw_measurement *const *seeds, int count);

/* Of a study: with what another one of its runs has shown. */
void fw_run_join_certificate(fw_run *run, const fw_run *other);
const fw_certificate *fw_run_certificate(const fw_run *run);

void fw_run_destroy(fw_run *run);
/* The same, of a run that has just begun and is not to be: nothing of it stays on disk. */
void fw_run_abandon(fw_run *run);

const fw_experiment *fw_run_experiment(const fw_run *run);
const fw_observer *fw_run_observer(const fw_run *run);
const fw_measurement *fw_run_measurement(const fw_run *run);

/* What the whole run will leave on disk, without making it. */
fw_status fw_run_size(const fw_run *run, fw_results_size *size, fw_error *error);

/* Steps and measures for about so many seconds, or to the end, and reports what a step takes. The
 * run should have no folder: it is of no further use. */
fw_status fw_run_rehearse(fw_run *run, double seconds, double *seconds_per_step, fw_error *error);

#endif
