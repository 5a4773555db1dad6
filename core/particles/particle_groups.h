/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_groups.h - energy, momentum, mass and centre of one body among the movable particles of
 * a scene. The energy of a bond between two bodies belongs to either by half. */
#ifndef FW_PARTICLE_GROUPS_H
#define FW_PARTICLE_GROUPS_H

#include "core/particles/particles.h"

fw_energies fw_particle_group_energies(const fw_solid *solid, int group);
fw_vec2 fw_particle_group_momentum(const fw_solid *solid, int group);
double fw_particle_group_mass(const fw_solid *solid, int group);
fw_vec2 fw_particle_group_centre_of_mass(const fw_solid *solid, int group);

#endif
