/* SPDX-License-Identifier: GPL-3.0-or-later */
/* penalty.c - springs of soft walls. Keeps no state. Start reading at push_between(). */
#include "contact/constraint/penalty.h"

#include <math.h>

static double depth_behind(double gap)
{
    return gap < 0 ? -gap : 0;
}

/* The force along a normal along which the gap changes from g0 to g1, over the stiffness:
 *     (d0^2 - d1^2)/2 / (g1 - g0) = (d0 + d1)/2 where both ends are behind the surface. */
static double push_between(double g0, double g1)
{
    const double d0 = depth_behind(g0), d1 = depth_behind(g1);
    if (d0 > 0 && d1 > 0) return 0.5 * (d0 + d1);
    if (d0 == 0 && d1 == 0) return 0;
    return 0.5 * (d0 - d1) * (d0 + d1) / (g1 - g0);
}

/* Which facet of a convex wall seen from outside is nearest to a point behind all of them; -1: the
 * point is free. */
static int nearest_facet(const fw_wall *wall, fw_vec2 point, double *depth)
{
    int nearest = -1;
    *depth = INFINITY;
    for (int n = 0; n < fw_wall_facet_count(wall); ++n) {
        const double behind = depth_behind(fw_facet_gap(fw_wall_facet(wall, n), point));
        if (behind == 0) {
            *depth = 0;
            return -1;
        }
        if (behind >= *depth) continue;
        *depth = behind;
        nearest = n;
    }
    return nearest;
}

/* Of a convex obstacle. Where the nearest side changes on the way, no force along one normal may be
 * able to account for both ends; then energy is kept but for that step. */
static fw_vec2 push_out(const fw_wall *wall, fw_vec2 from, fw_vec2 to)
{
    double d0, d1;
    const int first = nearest_facet(wall, from, &d0), last = nearest_facet(wall, to, &d1);
    if (first < 0 && last < 0) return (fw_vec2){0, 0};
    const fw_facet *facet = fw_wall_facet(wall, first < 0 ? last : first);
    const double opening = fw_facet_gap(facet, to) - fw_facet_gap(facet, from);
    double push = 0.5 * (d0 + d1);
    if (first != last) push = 0.5 * (d0 - d1) * (d0 + d1) / opening;
    const double most = fmax(d0, d1);
    push = push > 0 ? fmin(push, most) : 0.5 * most;
    return fw_vec2_scale(push, facet->normal);
}

/* Of a circle: along the middle of the path, where n . w = (r1^2 - r0^2)/|from + to|. */
static fw_vec2 push_round(const fw_facet *facet, fw_vec2 from, fw_vec2 to)
{
    const fw_vec2 r0 = fw_vec2_subtract(from, facet->a), r1 = fw_vec2_subtract(to, facet->a);
    const fw_vec2 sum = fw_vec2_add(r0, r1);
    const double length0 = sqrt(fw_vec2_dot(r0, r0)), length1 = sqrt(fw_vec2_dot(r1, r1));
    const double sign = facet->side == FW_INSIDE ? -1 : 1;
    const double push =
        push_between(sign * (length0 - facet->length), sign * (length1 - facet->length));
    if (!(push > 0)) return (fw_vec2){0, 0};
    /* push . |sum|/(length0 + length1) along sum/|sum| */
    return fw_vec2_scale(sign * push / (length0 + length1), sum);
}

static bool is_obstacle(const fw_wall *wall)
{
    return fw_wall_definition(wall)->side == FW_OUTSIDE;
}

double fw_penalty_energy(const fw_wall *wall, fw_vec2 point)
{
    const double stiffness = fw_wall_surface(wall).stiffness;
    double squares = 0, depth;
    if (!fw_facet_is_curved(fw_wall_facet(wall, 0)) && is_obstacle(wall)) {
        nearest_facet(wall, point, &depth);
        return 0.5 * stiffness * depth * depth;
    }
    for (int n = 0; n < fw_wall_facet_count(wall); ++n) {
        depth = depth_behind(fw_facet_gap(fw_wall_facet(wall, n), point));
        squares += depth * depth;
    }
    return 0.5 * stiffness * squares;
}

fw_vec2 fw_penalty_force(const fw_wall *wall, fw_vec2 from, fw_vec2 to)
{
    fw_vec2 push = {0, 0};
    if (fw_facet_is_curved(fw_wall_facet(wall, 0))) {
        push = push_round(fw_wall_facet(wall, 0), from, to);
    } else if (is_obstacle(wall)) {
        push = push_out(wall, from, to);
    } else {
        for (int n = 0; n < fw_wall_facet_count(wall); ++n) {
            const fw_facet *facet = fw_wall_facet(wall, n);
            const double along = push_between(fw_facet_gap(facet, from), fw_facet_gap(facet, to));
            push = fw_vec2_add(push, fw_vec2_scale(along, facet->normal));
        }
    }
    return fw_vec2_scale(fw_wall_surface(wall).stiffness, push);
}
