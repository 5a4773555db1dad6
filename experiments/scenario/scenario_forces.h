/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_forces.h - external forces as plain data. */
#ifndef FW_SCENARIO_FORCES_H
#define FW_SCENARIO_FORCES_H

#include "experiments/scenario/scenario_selection.h"

typedef enum fw_force_kind {
    FW_FORCE_EACH,         /* vector on each particle */
    FW_FORCE_TOTAL,        /* vector shared equally among the particles */
    FW_FORCE_ACCELERATION, /* vector times the particle's mass */
    FW_FORCE_RANDOM        /* each component uniform in [-random, random), new in each step */
} fw_force_kind;

typedef struct fw_scenario_force {
    const char *name;
    fw_place place;
    int body; /* index into the scenario's bodies */
    fw_selection sites;
    fw_force_kind kind;
    fw_vec2 vector;
    double random;
    bool balanced;        /* random forces minus their mean over the selection */
    int64_t from, until;  /* acts in the steps from <= step < until */
    int64_t ramp;         /* grows linearly over so many steps after `from`; 0: at once */
    double period, phase; /* times sin(2 pi step / period + phase); period 0: constant */
} fw_scenario_force;

#endif
