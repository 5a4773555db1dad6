/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_walls.h - walls and pistons as plain data. */
#ifndef FW_SCENARIO_WALLS_H
#define FW_SCENARIO_WALLS_H

#include "contact/geometry/wall.h"
#include "experiments/scenario/scenario_grips.h"

typedef struct fw_scenario_piston {
    double mass, damping;
    fw_vec2 velocity;
    fw_scenario_drive motion;
    int meets_count;
    int *meets; /* walls, by number */
} fw_scenario_piston;

typedef struct fw_scenario_wall {
    fw_place place;
    fw_wall_def def; /* with its name */
    bool is_piston;
    fw_scenario_piston piston;
} fw_scenario_wall;

#endif
