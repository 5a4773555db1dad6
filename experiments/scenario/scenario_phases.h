/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_phases.h - the parts of a run that have parameters of their own, as plain data. */
#ifndef FW_SCENARIO_PHASES_H
#define FW_SCENARIO_PHASES_H

#include "experiments/scenario/scenario_grips.h"

/* The drive of a grip during a phase, with what it has from the grip's own. */
typedef struct fw_phase_drive {
    fw_place place;
    int grip; /* index into the scenario's grips */
    fw_scenario_drive motion;
} fw_phase_drive;

/* The drive of a piston during a phase, with what it has from the piston's own. */
typedef struct fw_phase_piston {
    fw_place place;
    int wall;       /* index into the scenario's walls */
    double damping; /* < 0: as by itself */
    fw_scenario_drive motion;
} fw_phase_piston;

typedef struct fw_scenario_phase {
    const char *name;
    fw_place place;
    int64_t from, until;         /* the steps from <= step < until */
    double damping, temperature; /* < 0: those of `dynamics` */
    int drive_count, piston_count;
    fw_phase_drive *drives;
    fw_phase_piston *pistons;
} fw_scenario_phase;

#endif
