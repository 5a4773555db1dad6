/* SPDX-License-Identifier: GPL-3.0-or-later */
/* member.c - asks the solid, or the group of movable particles that the body is. Keeps no state. */
#include "experiments/setup/member.h"

#include "core/particles/particle_groups.h"

int fw_member_group(const fw_experiment *experiment, int member)
{
    const fw_solid *solid = fw_experiment_solid(experiment, member);
    if (!fw_solid_is_particles(solid)) return -1;
    return fw_particles_find_group(solid, experiment->members[member].name);
}

static bool shares_solid(const fw_experiment *experiment, int member)
{
    return experiment->members[member].count < fw_experiment_solid(experiment, member)->count;
}

fw_energies fw_member_energies(const fw_experiment *experiment, int member)
{
    const fw_solid *solid = fw_experiment_solid(experiment, member);
    if (!shares_solid(experiment, member)) return fw_solid_energies(solid);
    return fw_particle_group_energies(solid, fw_member_group(experiment, member));
}

fw_vec2 fw_member_momentum(const fw_experiment *experiment, int member)
{
    const fw_solid *solid = fw_experiment_solid(experiment, member);
    if (!shares_solid(experiment, member)) return fw_solid_momentum(solid);
    return fw_particle_group_momentum(solid, fw_member_group(experiment, member));
}

fw_sym2 fw_member_mass(const fw_experiment *experiment, int member)
{
    const fw_solid *solid = fw_experiment_solid(experiment, member);
    if (!shares_solid(experiment, member)) return solid->model->mass(solid);
    return fw_sym2_scalar(fw_particle_group_mass(solid, fw_member_group(experiment, member)));
}

fw_vec2 fw_member_centre_of_mass(const fw_experiment *experiment, int member)
{
    const fw_solid *solid = fw_experiment_solid(experiment, member);
    if (!shares_solid(experiment, member)) return solid->model->centre_of_mass(solid);
    return fw_particle_group_centre_of_mass(solid, fw_member_group(experiment, member));
}
