/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep.h - a study for each of several values of parameters, one after the other or side by side,
 * by one process or by several. Each case has a folder of results of its own, DIR/A=1,p=2; DIR
 * holds the scenario of the sweep from the beginning, and its table from the end on. */
#ifndef FW_SWEEP_H
#define FW_SWEEP_H

#include "experiments/storage/folder.h"
#include "experiments/study/run.h"
#include "experiments/study/sweep_table.h"

typedef struct fw_sweep fw_sweep;

/* Makes every case, checks that it could begin, and takes the folder; nothing runs yet.
 * FW_BAD_INPUT leaves the folder as it was. `scenario` and what `options` point to must live as
 * long. */
fw_status fw_sweep_begin(fw_sweep **sweep, const fw_scenario *scenario,
                         const fw_run_options *options, fw_error *error);
/* Goes on in a folder that fw_sweep_begin took: cases that are finished are read back. */
fw_status fw_sweep_resume(fw_sweep **sweep, const fw_scenario *scenario,
                          const fw_run_options *options, fw_error *error);
/* Holds such a folder, whether its sweep is finished or not. */
fw_status fw_sweep_open(fw_sweep **sweep, const fw_scenario *scenario,
                        const fw_run_options *options, fw_error *error);

/* Holds the folder of a sweep that becomes `scenario`, which has all its cases and more.
 * FW_BAD_INPUT leaves it as it was. */
fw_status fw_sweep_grow(fw_sweep **sweep, const fw_scenario *scenario,
                        const fw_run_options *options, fw_error *error);

/* Every case to its end, options->at_once side by side (0: as many as there are processors), then
 * the table, unless others are at work on some cases. No result depends on how many run at a time.
 * As fw_study_to_end; FW_DIVERGED when all cases were run, but some have failed: the table says
 * which and why. */
fw_status fw_sweep_to_end(fw_sweep *sweep, fw_error *error);
/* The table of cases that were all run. As fw_sweep_to_end; FW_BAD_INPUT where some were not, and
 * where a bisection needs further ones, which the folder's scenario has then. */
fw_status fw_sweep_collect(fw_sweep *sweep, fw_error *error);
/* Cases that others are at work on. */
int fw_sweep_missing(const fw_sweep *sweep);
void fw_sweep_destroy(fw_sweep *sweep);

/* One case by its name, of a sweep whose folder was taken, beside others who run theirs: nothing
 * but the case is held. *taken: somebody else is at work on it. FW_BAD_INPUT where there is no such
 * case; else as fw_study_to_end. */
fw_status fw_sweep_run_case(const fw_scenario *scenario, const char *name,
                            const fw_run_options *options, bool *taken, fw_error *error);

/* Of all cases, one case after the other, then the trends; after the end. */
const fw_verdicts *fw_sweep_verdicts(const fw_sweep *sweep);
int fw_sweep_case_count(const fw_sweep *sweep);
const fw_scenario *fw_sweep_scenario(const fw_sweep *sweep, int number);

/* Does the folder hold a sweep, finished or not? */
bool fw_sweep_is_in(const char *directory);
/* FW_BAD_INPUT where it does, for what speaks of single results; else FW_OK. */
fw_status fw_sweep_refuse(const char *directory, fw_error *error);
/* The scenario of the sweep in a folder. */
fw_status fw_sweep_load(fw_scenario **scenario, const char *directory, fw_error *error);

#endif
