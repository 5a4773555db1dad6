/* SPDX-License-Identifier: GPL-3.0-or-later */
/* body_range.c - asks the solid, or the group of movable particles that the body is. Keeps no
 * state. */
#include "experiments/setup/body_range.h"

#include "core/particles/particle_groups.h"

int fw_body_range_group(const fw_experiment *experiment, int body)
{
    const fw_solid *solid = fw_experiment_solid(experiment, body);
    if (!fw_solid_is_particles(solid)) return -1;
    return fw_particles_find_group(solid, experiment->bodies[body].name);
}

static bool shares_solid(const fw_experiment *experiment, int body)
{
    return experiment->bodies[body].count < fw_experiment_solid(experiment, body)->count;
}

fw_energies fw_body_range_energies(const fw_experiment *experiment, int body)
{
    const fw_solid *solid = fw_experiment_solid(experiment, body);
    if (!shares_solid(experiment, body)) return fw_solid_energies(solid);
    return fw_particle_group_energies(solid, fw_body_range_group(experiment, body));
}

fw_vec2 fw_body_range_momentum(const fw_experiment *experiment, int body)
{
    const fw_solid *solid = fw_experiment_solid(experiment, body);
    if (!shares_solid(experiment, body)) return fw_solid_momentum(solid);
    return fw_particle_group_momentum(solid, fw_body_range_group(experiment, body));
}

fw_sym2 fw_body_range_mass(const fw_experiment *experiment, int body)
{
    const fw_solid *solid = fw_experiment_solid(experiment, body);
    if (!shares_solid(experiment, body)) return solid->model->mass(solid);
    return fw_sym2_scalar(fw_particle_group_mass(solid, fw_body_range_group(experiment, body)));
}

fw_vec2 fw_body_range_centre_of_mass(const fw_experiment *experiment, int body)
{
    const fw_solid *solid = fw_experiment_solid(experiment, body);
    if (!shares_solid(experiment, body)) return solid->model->centre_of_mass(solid);
    return fw_particle_group_centre_of_mass(solid, fw_body_range_group(experiment, body));
}
