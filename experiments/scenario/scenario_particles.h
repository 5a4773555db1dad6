/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_particles.h - a material of movable particles as plain data. */
#ifndef FW_SCENARIO_PARTICLES_H
#define FW_SCENARIO_PARTICLES_H

#include "core/particles/pair_potential.h"
#include "core/particles/return_force.h"

typedef struct fw_scenario_particles {
    fw_pair_potential potential;
    fw_return_force return_force; /* amplitude 0: none */
    int64_t symmetry;             /* its fold, as written */
    bool own_angle;               /* the axes were given an angle; else they are the lattice's */
    double mass, strength;
} fw_scenario_particles;

#endif
