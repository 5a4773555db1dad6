/* SPDX-License-Identifier: GPL-3.0-or-later */
/* experiment.h - a scenario turned into a scene that is ready to run. */
#ifndef FW_EXPERIMENT_H
#define FW_EXPERIMENT_H

#include "contact/scene/scene.h"
#include "experiments/scenario/scenario.h"
#include "experiments/setup/body_range.h"

typedef struct fw_experiment {
    const fw_scenario *scenario; /* observed: must live as long */
    fw_scene *scene;
    int body_count;
    fw_body_range *bodies; /* one per body of the scenario, same order */
    int phase;             /* whose parameters the scene has; -1: none yet */
    /* As it was at the start, per body, for what is measured relative to it. */
    double *energy_at_start;
    fw_vec2 *momentum_at_start;
    fw_vec2 **start; /* positions */
} fw_experiment;

/* Builds solids, walls and forces. FW_BAD_INPUT with file, line and column where the scenario
 * demands for something impossible (a body in a wall, bodies in each other, an LB particle without
 * mass).
 */
fw_status fw_experiment_create(fw_experiment **experiment, const fw_scenario *scenario,
                               fw_error *error);
void fw_experiment_destroy(fw_experiment *experiment);

/* 1 to `most` steps, as fw_scene_advance(), with what the scenario does to the scene at certain
 * steps (phases, reversal). */
fw_status fw_experiment_advance(fw_experiment *experiment, int64_t most, fw_error *error);
/* One step, all positions included. */
fw_status fw_experiment_step(fw_experiment *experiment, fw_error *error);

/* All movable particles of the scenario, or NULL where it has none. */
const fw_solid *fw_experiment_particles(const fw_experiment *experiment);
/* The energy that the solid in which a body lives, and thus its ledger, started with. */
double fw_experiment_energy_at_start(const fw_experiment *experiment, int member);
/* The solid in which a body lives. */
const fw_solid *fw_experiment_solid(const fw_experiment *experiment, int body);

#endif
