/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rubbing.h - the ledger of the contact where two bodies in grips rub: path length, forces and
 * work, summed in every step, so that they do not depend on how often anything is measured.
 *
 * Slip is the displacement of the first grip less that of the second; the force is that of the
 * second body of movable particles on the first, or of two other bodies its reaction. */
#ifndef FW_RUBBING_H
#define FW_RUBBING_H

#include "experiments/setup/experiment.h"

/* Along the interface, which lies across the profile's axis, where nothing else is said. All of it
 * are doubles, and state. */
typedef struct fw_rubbing_sums {
    double last_slip, last_force; /* of the last step that was followed */
    double path_before;           /* sum |change of slip| in the phase before the samples */
    double path;                  /* the same while samples are taken */
    double work;                  /* what rubbing takes there: integral of -force over slip */
    double steps;                 /* that the sums below have */
    double slip, force, pressing; /* sums of slip, |force|, and of |force across| */
} fw_rubbing_sums;

typedef struct fw_rubbing {
    int along, across;           /* components */
    int64_t before, from, until; /* steps: the phase before the samples, and the samples */
    fw_rubbing_sums sums;
} fw_rubbing;

/* NaN where there are fewer than two grips, or fewer than two bodies of movable particles
 * and no other two. */
fw_vec2 fw_rubbing_slip(const fw_experiment *experiment);
fw_vec2 fw_rubbing_force(const fw_experiment *experiment);

/* Of a scenario that has a profile. */
fw_rubbing fw_rubbing_begin(const fw_scenario *scenario);
/* To be called after each step, and at the start. */
void fw_rubbing_follow(fw_rubbing *rubbing, const fw_experiment *experiment, int64_t step);
void fw_rubbing_state(fw_rubbing *rubbing, fw_state_list *list);

#endif
