/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlap.c - particles of a body behind a wall. Keeps no state. */
#include "experiments/setup/overlap.h"

#include <math.h>

int fw_overlap_find_behind(const fw_scene *scene, const fw_body_range *range, int wall,
                           double *depth)
{
    static const double on_surface = 1e-14;
    const fw_solid *solid = fw_body_range_solid(scene, range);
    const fw_wall *of = fw_scene_wall(scene, wall);
    const fw_vec2 place = fw_wall_displacement(of, 0);
    for (int l = 0; l < range->count; ++l) {
        const fw_vec2 at = fw_solid_position(solid, range->first + l);
        *depth = fw_wall_depth(of, at, place);
        if (*depth > on_surface * (1 + fabs(at.x) + fabs(at.y))) return l;
    }
    return -1;
}
