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

struct fw_profile {
    fw_scenario_profile plan;
    double window_low, window_high, time_step;
    int particle_count, bin_count, first_bin; /* bin b is centred on middle + (first + b) width */
    double (*sums)[SUMS];                     /* bins, contact, far */
    fw_flow *flow, *free_flow;                /* the same rows: of all, of what no grip holds */
    uint8_t *held;                            /* by a grip, in the last sample */
    double *force_x, *force_y, *bond_force, *velocity_x, *velocity_y, *mass;
    double *scratch; /* the six above, one after the other */
    int64_t samples;
    fw_bond_history *history;
};

#endif
