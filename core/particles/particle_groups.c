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

static double weighted_sum(const fw_solid *solid, int number, const double *values)
{
    const fw_particle_group *group = fw_particles_group(solid, number);
    const fw_langevin *motion = motion_of(solid);
    for (int i = group->first; i < group->first + group->count; ++i)
        motion->scratch[i] = motion->mass[i] * values[i];
    return sum_over(group, motion->scratch);
}

fw_energies fw_particle_group_energies(const fw_solid *solid, int number)
{
    const fw_particle_group *group = fw_particles_group(solid, number);
    const fw_langevin *motion = motion_of(solid);
    fw_energies energies;
    energies.elastic = sum_over(group, fw_particles_own_energies((const fw_particles *)solid));
    for (int i = group->first; i < group->first + group->count; ++i)
        motion->scratch[i] = 0.5 * motion->mass[i] *
                             (motion->velocity_x[i] * motion->velocity_x[i] +
                              motion->velocity_y[i] * motion->velocity_y[i]);
    energies.kinetic = sum_over(group, motion->scratch);
    return energies;
}

fw_vec2 fw_particle_group_momentum(const fw_solid *solid, int group)
{
    const double x = weighted_sum(solid, group, motion_of(solid)->velocity_x);
    return (fw_vec2){x, weighted_sum(solid, group, motion_of(solid)->velocity_y)};
}

double fw_particle_group_mass(const fw_solid *solid, int group)
{
    return sum_over(fw_particles_group(solid, group), motion_of(solid)->mass);
}

fw_vec2 fw_particle_group_centre_of_mass(const fw_solid *solid, int group)
{
    const double mass = fw_particle_group_mass(solid, group);
    const double x = weighted_sum(solid, group, solid->x);
    return (fw_vec2){x / mass, weighted_sum(solid, group, solid->y) / mass};
}
