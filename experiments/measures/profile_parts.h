/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile_parts.h - what a profile is made of, for the files that fill and read it. */
#ifndef FW_PROFILE_PARTS_H
#define FW_PROFILE_PARTS_H

#include "bond_history.h"
#include "experiments/measures/profile.h"

/* What is summed. Pairs of a sum and what it is divided by. */
typedef enum fw_sum {
    SUM_PARTICLES,
    SUM_RETURN_FORCE,
    SUM_BOND_FORCE,
    SUM_BONDED, /* particles with bonds in their own body */
    SUM_ORDER,
    SUM_HEAT,    /* m (v - mean)^2 of what no grip holds */
    SUM_FREEDOM, /* degrees of freedom that it belongs to */
    SUM_DRIFT,   /* particles times square of the mean velocity */
    SUM_BROKEN,
    SUM_LOOKS, /* particles looked at */
    SUM_CHANGE,
    SUM_ACROSS,
    SUM_CHANGED, /* bonds that were followed over one lag */
    SUM_ACROSS_LATE,
    SUM_CHANGED_LATE, /* bonds that were followed over FW_HISTORY_LAGS */
    SUMS
} fw_sum;

/* Velocities of a bin in one sample. */
typedef struct fw_flow {
    double count, along, across;
} fw_flow;

/* A solid that is looked at; its particles stand in the profile's arrays from `first` on. */
typedef struct profile_part {
    const fw_solid *solid;
    int body, first; /* of the scene */
} profile_part;

struct fw_profile {
    fw_scenario_profile plan;
    int part_count;
    profile_part *parts; /* all movable particles; where there are none, all bodies of the scene */
    bool flows;          /* movable particles: they have bonds and order */
    double window_low, window_high, time_step;
    int particle_count, bin_count, first_bin; /* bin b is centred on middle + (first + b) width */
    double (*sums)[SUMS];                     /* bins, contact, far */
    fw_flow *flow, *free_flow;                /* the same rows: of all, of what no grip holds */
    uint8_t *held;                            /* by a grip, in the last sample */
    double *force_x, *force_y, *bond_force, *velocity_x, *velocity_y, *mass;
    double *scratch;         /* the six above, one after the other */
    double *past_x, *past_y; /* places one step before the next sample; NULL where particles flow */
    int *numbers; /* 0, 1, ..., and what is predicted of them; NULL where particles flow */
    fw_prediction *predictions;
    int64_t samples;
    fw_bond_history *history; /* NULL unless they flow */
};

/* profile_parts.c: who is looked at, and the look. FW_SYSTEM_FAILED without memory. */
fw_status profile_list_parts(fw_profile *profile, const fw_experiment *experiment, fw_error *error);
/* Fills `held`, velocities, and restoring forces of all. */
void profile_look(fw_profile *profile, const fw_experiment *experiment);
/* To be called one step before a look, where they do not flow. */
void profile_remember_places(fw_profile *profile);
/* Restoring forces alone: of movable particles their return forces (NULL: `bond_force` stays);
 * elsewhere what links pull with; NaN in a solid that knows none. */
void profile_fill_forces(fw_profile *profile);

#endif
