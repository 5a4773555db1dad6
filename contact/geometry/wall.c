/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall.c - builds the facets of a shape and follows its path.
 * State: a copy of the definition, and its facets; nothing changes after creation, displacements
 * are a pure function of time.
 * Start reading at fw_wall_create(). */
#include "contact/geometry/wall.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct fw_wall {
    fw_wall_def def; /* name and points are ours */
    char *name;
    fw_vec2 *points;
    bool moves;
    int facet_count;
    fw_facet *facets;
};

fw_wall_def fw_wall_def_default(void)
{
    static const fw_vec2 unit_square[] = {{0, 0}, {1, 1}};
    return (fw_wall_def){.name = "wall",
                         .shape = FW_BOX,
                         .side = FW_INSIDE,
                         .points = unit_square,
                         .point_count = 2,
                         .path = {.until = INFINITY}};
}

fw_status fw_wall_create(fw_wall **wall, int index, const fw_wall_def *def, fw_error *error)
{
    *wall = NULL;
    FW_TRY(fw_wall_def_check(def, error));
    fw_wall *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "a wall");
    const size_t point_count = (size_t)def->point_count;
    made->def = *def;
    made->facet_count = fw_wall_shape_of(def)->facet_count(def);
    made->name = strdup(def->name ? def->name : "");
    made->points = malloc(point_count * sizeof *made->points);
    made->facets = malloc((size_t)made->facet_count * sizeof *made->facets);
    if (!made->name || !made->points || !made->facets) {
        fw_wall_destroy(made);
        return fw_fail_memory(error, "a wall");
    }
    memcpy(made->points, def->points, point_count * sizeof *made->points);
    made->def.name = made->name;
    made->def.points = made->points;
    const fw_path *path = &def->path;
    made->moves = ((path->velocity.x != 0 || path->velocity.y != 0) && path->until > path->from) ||
                  path->amplitude.x != 0 || path->amplitude.y != 0;
    fw_wall_shape_of(def)->build(&made->def, index, hypot(path->amplitude.x, path->amplitude.y),
                                 made->facets);
    *wall = made;
    return FW_OK;
}

void fw_wall_destroy(fw_wall *wall)
{
    if (!wall) return;
    free(wall->name);
    free(wall->points);
    free(wall->facets);
    free(wall);
}

const char *fw_wall_name(const fw_wall *wall)
{
    return wall->name;
}

fw_surface fw_wall_surface(const fw_wall *wall)
{
    return wall->def.surface;
}

const fw_wall_def *fw_wall_definition(const fw_wall *wall)
{
    return &wall->def;
}

bool fw_wall_moves(const fw_wall *wall)
{
    return wall->moves || wall->def.driven;
}

fw_vec2 fw_wall_displacement(const fw_wall *wall, double time)
{
    if (!wall->moves) return (fw_vec2){0, 0};
    return fw_path_displacement(&wall->def.path, time);
}

int fw_wall_facet_count(const fw_wall *wall)
{
    return wall->facet_count;
}

const fw_facet *fw_wall_facet(const fw_wall *wall, int number)
{
    assert(number >= 0 && number < wall->facet_count);
    return &wall->facets[number];
}

fw_box fw_wall_bounds(const fw_wall *wall)
{
    fw_box bounds = fw_facet_bounds(&wall->facets[0]);
    for (int i = 1; i < wall->facet_count; ++i)
        bounds = fw_box_joined(bounds, fw_facet_bounds(&wall->facets[i]));
    return bounds;
}

static double distance_from_segment(const fw_facet *facet, fw_vec2 point)
{
    fw_vec2 along = fw_vec2_subtract(facet->b, facet->a), from = fw_vec2_subtract(point, facet->a);
    double part = fw_vec2_dot(from, along) / (facet->length * facet->length);
    part = fmin(fmax(part, 0), 1);
    return hypot(from.x - part * along.x, from.y - part * along.y);
}

/* Is the end of the facet that is nearest to the point a corner of the chain, not an open end? */
static bool is_joined(const fw_wall *wall, const fw_facet *facet, fw_vec2 point)
{
    fw_vec2 along = fw_vec2_subtract(facet->b, facet->a);
    bool at_start = fw_vec2_dot(fw_vec2_subtract(point, facet->a), along) <= 0;
    int number = (int)(facet - wall->facets);
    if (wall->def.closed) return true;
    return at_start ? number > 0 : number + 1 < wall->facet_count;
}

/* Distance to the nearest piece of a chain if the point lies behind it. Where two are as near (a
 * corner, both faces of a blade) the sum of the gaps decides: the sign of the distance along the
 * mean of both normals. Beyond an open end a chain has no back. */
static double depth_behind_chain(const fw_wall *wall, fw_vec2 point, double away)
{
    double nearest = INFINITY, gaps = 0;
    for (int i = 0; i < wall->facet_count; ++i)
        nearest = fmin(nearest, distance_from_segment(&wall->facets[i], point));
    for (int i = 0; i < wall->facet_count; ++i) {
        const fw_facet *facet = &wall->facets[i];
        double tolerance = fw_facet_tolerance(facet, away);
        if (distance_from_segment(facet, point) > nearest + tolerance) continue;
        double gap = fw_facet_gap(facet, point);
        if (fabs(gap) < nearest - tolerance && !is_joined(wall, facet, point)) return 0;
        gaps += gap;
    }
    return gaps < -fw_facet_tolerance(&wall->facets[0], away) ? nearest : 0;
}

double fw_wall_depth(const fw_wall *wall, fw_vec2 point, fw_vec2 place)
{
    const fw_vec2 from = fw_vec2_subtract(point, place); /* in the wall's frame */
    if (!fw_wall_shape_of(&wall->def)->sided)
        return depth_behind_chain(wall, from, fmax(fabs(place.x), fabs(place.y)));
    /* Free inside a convex shape: in front of all facets; outside: in front of any. */
    const bool inside = wall->def.side == FW_INSIDE;
    double depth = inside ? 0 : INFINITY;
    for (int i = 0; i < wall->facet_count; ++i) {
        double behind = fmax(-fw_facet_gap(&wall->facets[i], from), 0);
        depth = inside ? fmax(depth, behind) : fmin(depth, behind);
    }
    return depth;
}
