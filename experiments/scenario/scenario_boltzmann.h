/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_boltzmann.h - a lattice Boltzmann material as plain data. */
#ifndef FW_SCENARIO_BOLTZMANN_H
#define FW_SCENARIO_BOLTZMANN_H

#include "core/vec2.h"

typedef struct fw_scenario_boltzmann {
    fw_sym2 rest_mass;
    double damping; /* 1 - mu, 0 <= damping < 1/2 */
    fw_sym2 link_stiffness;
    double break_at; /* stretch beyond which a link breaks; 0: never */
} fw_scenario_boltzmann;

#endif
