/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlap.c - particles of two bodies at one place: those in the common part of both frames,
 * sorted along x, each compared with the few that follow it closely. Keeps no state. Start
 * reading at fw_overlap_find(). */
#include "experiments/setup/overlap.h"

#include <math.h>
#include <stdlib.h>

/* The smallest distance that two bodies may keep, in spacings: closer ones share a place. */
static const double APART = 0.5;

typedef struct point {
    fw_vec2 at;
    const fw_body_range *body;
} point;

static fw_box frame_of(const fw_scene *scene, const fw_body_range *range)
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    fw_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int i = range->first; i < range->first + range->count; ++i) {
        box.low.x = fmin(box.low.x, solid->x[i]);
        box.low.y = fmin(box.low.y, solid->y[i]);
        box.high.x = fmax(box.high.x, solid->x[i]);
        box.high.y = fmax(box.high.y, solid->y[i]);
    }
    return box;
}

static int compare_points(const void *left, const void *right)
{
    const point *a = left, *b = right;
    if (a->at.x != b->at.x) return a->at.x < b->at.x ? -1 : 1;
    return (a->at.y > b->at.y) - (a->at.y < b->at.y);
}

static int collect(const fw_scene *scene, const fw_body_range *range, fw_box common, point *points)
{
    const fw_solid *solid = fw_body_range_solid(scene, range);
    int count = 0;
    for (int i = range->first; i < range->first + range->count; ++i) {
        fw_vec2 at = fw_solid_position(solid, i);
        if (at.x >= common.low.x && at.x <= common.high.x && at.y >= common.low.y &&
            at.y <= common.high.y)
            points[count++] = (point){at, range};
    }
    return count;
}

static bool find_pair(const point *points, int count, double apart, fw_vec2 *where)
{
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count && points[j].at.x - points[i].at.x < apart; ++j) {
            fw_vec2 between = fw_vec2_subtract(points[j].at, points[i].at);
            if (points[i].body == points[j].body || hypot(between.x, between.y) >= apart) continue;
            *where = fw_vec2_add(points[i].at, fw_vec2_scale(0.5, between));
            return true;
        }
    return false;
}

fw_status fw_overlap_find(const fw_scene *scene, const fw_body_range *a, const fw_body_range *b,
                          bool *found, fw_vec2 *where, fw_error *error)
{
    const double apart = APART * fmin(a->spacing, b->spacing);
    fw_box fa = frame_of(scene, a), fb = frame_of(scene, b);
    const fw_box common = {
        {fmax(fa.low.x, fb.low.x) - apart, fmax(fa.low.y, fb.low.y) - apart},
        {fmin(fa.high.x, fb.high.x) + apart, fmin(fa.high.y, fb.high.y) + apart}};
    *found = false;
    if (!(common.low.x <= common.high.x && common.low.y <= common.high.y)) return FW_OK;
    size_t most = (size_t)a->count + (size_t)b->count;
    point *points = calloc(most, sizeof *points);
    if (!points) return fw_fail_memory(error, "a look at where bodies overlap");
    int count = collect(scene, a, common, points);
    count += collect(scene, b, common, points + count);
    qsort(points, (size_t)count, sizeof *points, compare_points);
    *found = find_pair(points, count, apart, where);
    free(points);
    return FW_OK;
}

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
