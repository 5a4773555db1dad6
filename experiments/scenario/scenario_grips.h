/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_grips.h - what drives a grip or piston, and grips, as plain data. */
#ifndef FW_SCENARIO_GRIPS_H
#define FW_SCENARIO_GRIPS_H

#include "contact/scene/grip.h"
#include "experiments/scenario/scenario_selection.h"

typedef enum fw_hold_choice { FW_HOLD_NONE, FW_HOLD_X, FW_HOLD_Y, FW_HOLD_BOTH } fw_hold_choice;

typedef struct fw_scenario_drive {
    fw_hold_choice hold;      /* as written; what follows from it is in `drive` */
    fw_schema_name time_from; /* as written */
    int origin;               /* index of the phase whose beginning is time 0; -1: the run's */
    fw_drive drive;           /* its origin is set when the time step is known */
} fw_scenario_drive;

typedef struct fw_scenario_grip {
    const char *name;
    fw_place place;
    int body; /* index into the scenario's bodies */
    fw_selection sites;
    double layer; /* > 0: of these only what is so near to the outer face of `side` */
    fw_outer_side side;
    fw_scenario_drive motion;
} fw_scenario_grip;

#endif
