/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_bodies.h - bodies as plain data. */
#ifndef FW_SCENARIO_BODIES_H
#define FW_SCENARIO_BODIES_H

#include "experiments/scenario/scenario_patterns.h"
#include "experiments/scenario/scenario_shapes.h"

typedef struct fw_scenario_body fw_scenario_body;

struct fw_scenario_body {
    const char *name;
    fw_place place;
    int material; /* index into the scenario's materials */
    fw_scenario_shape shape;
    fw_place shape_place;
    fw_lattice lattice; /* kind, spacing, angle in radians, origin = position of site (0, 0) */
    int surface; /* number among those of `contact` */
    fw_vec2 velocity;
    fw_patterns displacement;
    fw_patterns velocities;
    double spin;             /* angular velocity about its middle at the start */
    double temperature;      /* of its velocities at the start */
    bool displaced_as_given; /* elastic automaton: both colours alike */
    fw_replacements rest_mass;
    fw_replacements link_stiffness;
};

/* Makes the body's sites: row by row, the order of the particles. Caller clears with
 * fw_sites_clear. */
fw_status fw_scenario_sites(const fw_scenario_body *body, fw_sites *sites, fw_error *error);

#endif
