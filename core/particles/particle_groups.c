/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_groups.c - sums over the particles of one body. Keeps no state. */
#include "core/particles/particle_groups.h"

#include "particle_forces.h"

static const fw_langevin *motion_of(const fw_solid *solid)
{
    return (const fw_langevin *)solid;
}

/* sum of values[i] over the body. */
static double sum_over(const fw_particle_group *group, const double *values)
{
    return fw_array_sum(values + group->first, (size_t)group->count);
}

static fw_motion_sums sum_motion(const fw_solid *solid, int number)
{
    const fw_particle_group *group = fw_particles_group(solid, number);
    return fw_langevin_sum_motion(motion_of(solid), group->first, group->count);
}

fw_energies fw_particle_group_energies(const fw_solid *solid, int number)
{
    const double *own = fw_particles_own_energies((const fw_particles *)solid);
    return (fw_energies){.kinetic = sum_motion(solid, number).kinetic,
                         .elastic = sum_over(fw_particles_group(solid, number), own)};
}

fw_vec2 fw_particle_group_momentum(const fw_solid *solid, int number)
{
    return sum_motion(solid, number).momentum;
}

double fw_particle_group_mass(const fw_solid *solid, int group)
{
    return sum_over(fw_particles_group(solid, group), motion_of(solid)->mass);
}

fw_vec2 fw_particle_group_centre_of_mass(const fw_solid *solid, int number)
{
    const fw_particle_group *group = fw_particles_group(solid, number);
    const double mass = fw_particle_group_mass(solid, number);
    const fw_vec2 sum = fw_langevin_sum_places(motion_of(solid), group->first, group->count);
    return (fw_vec2){sum.x / mass, sum.y / mass};
}
