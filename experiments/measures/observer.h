/* SPDX-License-Identifier: GPL-3.0-or-later */
/* observer.h - an experiment together with what is followed beside it: the profile across its
 * contact, and what is computed without running. The experiment knows nothing of either. */
#ifndef FW_OBSERVER_H
#define FW_OBSERVER_H

#include "experiments/measures/analysis.h"
#include "experiments/measures/certificate.h"
#include "experiments/measures/profile.h"
#include "experiments/measures/rubbing.h"
#include "experiments/setup/experiment.h"

/* Everybody may read it; all of it is owned. */
typedef struct fw_observer {
    fw_experiment *experiment;
    fw_profile *profile; /* NULL where the scenario has none */
    fw_rubbing rubbing;  /* followed where there is a profile */
    /* Of each body of the scenario, by its own ledger, what fw_scene_energy_scale is of the scene:
     * the largest energy or work so far. Part of the state. */
    double *energy_scale;
    fw_certificate certificate; /* part of the state */
    int analysis_count;
    fw_analysis **analyses; /* same order as the scenario's */
} fw_observer;

/* Builds the experiment as fw_experiment_create does, then profile and analyses. FW_BAD_INPUT at
 * the place of what is impossible. */
fw_status fw_observer_create(fw_observer **observer, const fw_scenario *scenario, fw_error *error);
void fw_observer_destroy(fw_observer *observer);

/* What changes beside the scene, for checkpoints. */
void fw_observer_state(fw_observer *observer, fw_state_list *list);

/* Enters the present in the certificate; to be called where positions of boundaries are right. */
void fw_observer_certify(fw_observer *observer);

/* 1 to `most` steps of the experiment, as fw_scene_advance(), followed. All positions are right
 * after `most` of them; in between they wait for fw_scene_settle(). */
fw_status fw_observer_advance(fw_observer *observer, int64_t most, fw_error *error);
/* The same, but after `most` steps, too, positions wait for fw_scene_settle() or
 * fw_scene_settle_boundaries(), which the caller calls. */
fw_status fw_observer_move(fw_observer *observer, int64_t most, fw_error *error);

#endif
