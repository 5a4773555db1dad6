/* SPDX-License-Identifier: GPL-3.0-or-later */
/* body_range.c - computes from the solid, or from the group of movable particles that the body is.
 * Keeps no state. */
#include "experiments/setup/body_range.h"

#include "core/particles/particle_groups.h"

#include <stdlib.h>

const fw_solid *fw_body_range_solid(const fw_scene *scene, const fw_body_range *range)
{
    return fw_scene_observe_body(scene, range->solid);
}

int fw_body_range_group(const fw_scene *scene, const fw_body_range *range)
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    if (!fw_solid_is_particles(solid)) return -1;
    return fw_particles_find_group(solid, range->name);
}

static bool shares_solid(const fw_scene *scene, const fw_body_range *range)
{
    return range->count < fw_body_range_solid(scene, range)->count;
}

fw_energies fw_body_range_energies(const fw_scene *scene, const fw_body_range *range)
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    if (!shares_solid(scene, range)) return fw_solid_energies(solid);
    return fw_particle_group_energies(solid, fw_body_range_group(scene, range));
}

fw_vec2 fw_body_range_momentum(const fw_scene *scene, const fw_body_range *range)
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    if (!shares_solid(scene, range)) return fw_solid_momentum(solid);
    return fw_particle_group_momentum(solid, fw_body_range_group(scene, range));
}

fw_sym2 fw_body_range_mass(const fw_scene *scene, const fw_body_range *range)
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    if (!shares_solid(scene, range)) return solid->model->mass(solid);
    return fw_sym2_scalar(fw_particle_group_mass(solid, fw_body_range_group(scene, range)));
}

fw_vec2 fw_body_range_centre_of_mass(const fw_scene *scene, const fw_body_range *range)
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    if (!shares_solid(scene, range)) return solid->model->centre_of_mass(solid);
    return fw_particle_group_centre_of_mass(solid, fw_body_range_group(scene, range));
}

int (*fw_body_range_links(const fw_scene *scene, const fw_body_range *range, int *count))[2]
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    int(*links)[2] = malloc((size_t)(solid->link_count + 1) * sizeof *links);
    *count = 0;
    for (int n = 0; n < solid->link_count && links; ++n) {
        const int one = solid->links[n][0] - range->first,
                  other = solid->links[n][1] - range->first;
        if (one < 0 || one >= range->count || other < 0 || other >= range->count) continue;
        links[*count][0] = one;
        links[*count][1] = other;
        *count += 1;
    }
    return links;
}
