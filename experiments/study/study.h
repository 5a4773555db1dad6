/* SPDX-License-Identifier: GPL-3.0-or-later */
/* study.h - a scenario run as a whole: the experiment itself, its replicas over seeds, and the
 * control of each, side by side. Only the experiment with the scenario's own seed, and its control,
 * leave results on disk (the control in DIR/control), unless the scenario keeps all; of the others
 * remains what the profile, layer.csv and summary.csv say: what each seed showed of the layer, and
 * of what is expected. No result depends on how many run at a time. */
#ifndef FW_STUDY_H
#define FW_STUDY_H

#include "experiments/measures/profile_table.h"
#include "experiments/study/run.h"

#define FW_CONTROL_FOLDER "control"
#define FW_PROFILE_FILE   "profile.csv"
#define FW_LAYER_FILE     "layer.csv"

typedef struct fw_study fw_study;

/* Begins the experiment, or goes on with it from its newest checkpoint (see fw_run_resume); then
 * the other runs, which are repeated from their beginning. `scenario` must live as long. */
fw_status fw_study_begin(fw_study **study, const fw_scenario *scenario,
                         const fw_run_options *options, fw_error *error);
fw_status fw_study_resume(fw_study **study, const fw_scenario *scenario,
                          const fw_run_options *options, char note[FW_SENTENCE_SIZE],
                          fw_error *error);
/* Everything to its end, and into the results. As fw_run_to_end. */
fw_status fw_study_to_end(fw_study *study, fw_error *error);
/* The experiment's own run, that may be advanced before all are run to their end. */
fw_run *fw_study_run(fw_study *study);
/* Particle steps of all its runs. */
double fw_study_work(const fw_scenario *scenario);
/* How many runs it has: those of all seeds, then their controls. */
int fw_study_run_count(const fw_scenario *scenario);
/* Folder of a run within that of the study; false: it has none of its own. */
enum { FW_RUN_FOLDER = 48 };
bool fw_study_folder(const fw_scenario *scenario, int number, char folder[FW_RUN_FOLDER]);
void fw_study_destroy(fw_study *study);

/* The experiment's own; a measurement that has the outcome. */
const fw_measurement *fw_study_measurement(const fw_study *study);
/* The worst of all seeds, once they have ended. */
const fw_certificate *fw_study_certificate(const fw_study *study);
/* What the user was warned of in the experiment's own run, a line each; "" if of nothing. */
const char *fw_study_warnings(const fw_study *study);
/* NULL where the scenario has no profile, or before the end. */
const fw_profile_table *fw_study_table(const fw_study *study);

#endif
