/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_offset.c - surfaces moved along their normals. Keeps no state. Start reading at
 * fw_wall_offset(). */
#include "contact/geometry/wall_offset.h"

#include <math.h>
#include <string.h>

static fw_status refuse(const fw_wall_def *def, double distance, fw_error *error)
{
    return fw_fail(error, FW_BAD_INPUT,
                   "wall %s is too small for a contact distance of %g: nothing of it is left",
                   def->name, distance);
}

static double area_of(const fw_wall_def *def)
{
    double sum = 0;
    for (int n = 0; n < def->point_count; ++n)
        sum += fw_vec2_cross(def->points[n], def->points[(n + 1) % def->point_count]);
    return sum;
}

/* From point n to the next one, of length 1. */
static fw_vec2 direction_of(const fw_vec2 *points, int count, int n)
{
    const fw_vec2 along = fw_vec2_subtract(points[(n + 1) % count], points[n]);
    return fw_vec2_scale(1 / sqrt(fw_vec2_dot(along, along)), along);
}

/* To the free side of both pieces that meet in a point: (n1 + n2)/(1 + n1.n2). */
static fw_vec2 corner_between(fw_vec2 first, fw_vec2 second)
{
    return fw_vec2_scale(1 / (1 + fw_vec2_dot(first, second)), fw_vec2_add(first, second));
}

/* Straight pieces, free to the left (`sign` 1) or to the right (-1) of the way along them. */
static fw_status move_pieces(const fw_wall_def *def, bool closed, double sign, double distance,
                             fw_vec2 *points, fw_error *error)
{
    const int count = def->point_count, pieces = closed ? count : count - 1;
    for (int n = 0; n < count; ++n) {
        const int before = n > 0 ? n - 1 : closed ? count - 1 : 0;
        const int after = n < pieces ? n : pieces - 1;
        const fw_vec2 first = fw_vec2_turn(direction_of(def->points, count, before));
        const fw_vec2 second = fw_vec2_turn(direction_of(def->points, count, after));
        points[n] = fw_vec2_add(def->points[n],
                                fw_vec2_scale(sign * distance, corner_between(first, second)));
        /* Where the chain turns back on itself, neither is. */
        if (!isfinite(points[n].x)) return refuse(def, distance, error);
    }
    for (int n = 0; n < pieces; ++n) {
        const fw_vec2 moved = fw_vec2_subtract(points[(n + 1) % count], points[n]);
        if (!(fw_vec2_dot(moved, direction_of(def->points, count, n)) > 0))
            return refuse(def, distance, error);
    }
    return FW_OK;
}

fw_status fw_wall_offset(const fw_wall_def *def, double distance, fw_vec2 *points,
                         fw_wall_def *moved, fw_error *error)
{
    const double out = def->side == FW_INSIDE ? -1 : 1, outward = out * distance;
    *moved = *def;
    moved->points = points;
    memcpy(points, def->points, (size_t)def->point_count * sizeof *points);
    switch (def->shape) {
    case FW_BOX: {
        const bool rises_x = points[1].x > points[0].x, rises_y = points[1].y > points[0].y;
        const fw_vec2 by = {rises_x ? outward : -outward, rises_y ? outward : -outward};
        points[0] = fw_vec2_subtract(points[0], by);
        points[1] = fw_vec2_add(points[1], by);
        if ((points[1].x > points[0].x) != rises_x || (points[1].y > points[0].y) != rises_y)
            return refuse(def, distance, error);
        return FW_OK;
    }
    case FW_CIRCLE:
        moved->radius += outward;
        return moved->radius > 0 ? FW_OK : refuse(def, distance, error);
    case FW_POLYGON:
        /* Counter-clockwise, its inside lies to the left. */
        return move_pieces(def, true, area_of(def) > 0 ? -out : out, distance, points, error);
    case FW_CHAIN:
        break;
    }
    return move_pieces(def, def->closed, 1, distance, points, error);
}
