/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_met.c - pistons that meet other pistons and walls. Both are rigid and do not turn, so that
 * all that matters is how they go relative to each other: the first time that a corner of one
 * passes a facet of the other, or a circle does, becomes a row between the two, as of a particle
 * and a piston. It holds along the facet's normal, hard and without friction, whatever surfaces
 * are: a hit is elastic, and under load they stay together. Rows of pistons come once all else has
 * settled: what lies between them may keep them apart.
 * State: who meets whom, from the definition. Start reading at scene_add_met(). */
#include "contact/geometry/crossing.h"
#include "scene_parts.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How far shapes may overlap at the start, in units of the coordinates' size: rounding. */
static const double ON_SURFACE = 1e-14;

/* One of a pair as it moves in this step. */
typedef struct mover {
    int wall;
    fw_vec2 place, motion;
} mover;

/* A point of `carrier`, or a circle of its own around it, that passes a facet of the other one. */
typedef struct passage {
    const mover *carrier, *barring;
    int facet;       /* of the barring wall */
    int corner;      /* of the carrier: twice the number of its facet, and 1 for the end of that */
    fw_facet offset; /* that facet, further out by the circle's radius */
    fw_vec2 point;   /* in the frame of the barring wall */
    double when;
} passage;

fw_status fw_scene_let_meet(fw_scene *scene, int piston, int other, fw_error *error)
{
    assert(piston >= 0 && piston < scene->wall_count && scene->walls[piston].piston);
    assert(other >= 0 && other < scene->wall_count && other != piston);
    scene_met *met = realloc(scene->met, ((size_t)scene->met_count + 1) * sizeof *met);
    if (!met) return fw_fail_memory(error, "pistons that meet");
    scene->met = met;
    for (int n = 0; n < scene->met_count; ++n)
        if ((met[n].a == piston && met[n].b == other) || (met[n].a == other && met[n].b == piston))
            return FW_OK;
    scene->met[scene->met_count++] = (scene_met){piston, other};
    return FW_OK;
}

static mover mover_of(const fw_scene *scene, int w)
{
    const scene_wall *wall = &scene->walls[w];
    const double start = scene_step_start(scene), end = start + scene_step_length(scene);
    if (wall->piston)
        return (mover){w, fw_piston_observe_ledger(wall->piston)->displacement, wall->motion};
    const fw_vec2 place = fw_wall_displacement(wall->wall, start);
    return (mover){w, place, fw_vec2_subtract(fw_wall_displacement(wall->wall, end), place)};
}

/* Part of the way after which the path comes to the facet. */
static double when_of(const fw_facet *facet, fw_vec2 point, fw_vec2 path)
{
    const double gap = fw_facet_gap(facet, point);
    if (!fw_facet_is_curved(facet)) {
        const double fall = -fw_vec2_dot(path, facet->normal);
        return fall > 0 ? fmin(fmax(gap / fall, 0), 1) : 1;
    }
    const fw_vec2 from = fw_vec2_subtract(point, facet->a);
    const double a = fw_vec2_dot(path, path), b = fw_vec2_dot(from, path),
                 c = fw_vec2_dot(from, from) - facet->length * facet->length;
    const double root = sqrt(fmax(b * b - a * c, 0));
    const double way = facet->side == FW_INSIDE ? -b + root : -b - root;
    return a > 0 ? fmin(fmax(way / a, 0), 1) : 1;
}

/* Round a circle a path may lead through what its ends keep out of: one row is enough. */
static bool is_known(const fw_scene *scene, int wall, int corner, int facet)
{
    const scene_joint *joint = scene->joint;
    for (int n = 0; n < joint->row_count; ++n) {
        const scene_row *row = &joint->rows[n];
        if (row->met && row->facet == facet && row->point_body == wall && row->point == corner)
            return true;
    }
    return false;
}

/* Notes it, if it comes before what was found so far. */
static void look(const fw_scene *scene, const mover *carrier, const mover *barring, int number,
                 int corner, fw_vec2 point, double radius, passage *first)
{
    const fw_facet *facet = scene->candidates[number].facet;
    const fw_vec2 from = fw_vec2_subtract(fw_vec2_add(point, carrier->place), barring->place);
    const fw_vec2 path = fw_vec2_subtract(carrier->motion, barring->motion);
    const double away = fmax(fabs(barring->place.x), fabs(barring->place.y));
    passage found = {carrier, barring, number, corner, *facet, from, 0};
    if (radius > 0 && fw_facet_is_curved(facet)) {
        const double sum =
            facet->side == FW_OUTSIDE ? facet->length + radius : facet->length - radius;
        if (!(sum > 0)) return;
        found.offset = fw_facet_round(facet->wall, facet->a, sum, facet->side, 0);
    } else if (radius > 0) {
        const fw_vec2 out = fw_vec2_scale(radius, facet->normal);
        found.offset = fw_facet_straight(facet->wall, fw_vec2_add(facet->a, out),
                                         fw_vec2_add(facet->b, out), 0);
    }
    if (!fw_facet_is_passed(&found.offset, from, path, away) ||
        is_known(scene, carrier->wall, corner, number))
        return;
    found.when = when_of(&found.offset, from, path);
    if (found.when < first->when) *first = found;
}

/* Corners of a box or polygon that is free inside are met by nothing first. */
static bool has_corners(const fw_wall *wall)
{
    const fw_wall_def *def = fw_wall_definition(wall);
    return def->shape == FW_CHAIN || def->side == FW_OUTSIDE;
}

static void look_from(const fw_scene *scene, const mover *carrier, const mover *barring,
                      passage *first)
{
    const fw_wall *wall = scene->walls[carrier->wall].wall;
    const int begin = scene->walls[barring->wall].first_facet;
    const int end = begin + fw_wall_facet_count(scene->walls[barring->wall].wall);
    if (!has_corners(wall)) return;
    for (int n = 0; n < fw_wall_facet_count(wall); ++n) {
        const fw_facet *own = fw_wall_facet(wall, n);
        for (int f = begin; f < end; ++f) {
            if (fw_facet_is_curved(own)) {
                look(scene, carrier, barring, f, 2 * n, own->a, own->length, first);
                continue;
            }
            look(scene, carrier, barring, f, 2 * n, own->a, 0, first);
            look(scene, carrier, barring, f, 2 * n + 1, own->b, 0, first);
        }
    }
}

/* Of the two, end 0 of the row is one that forces move. */
static fw_status add_row(fw_scene *scene, const passage *found, fw_error *error)
{
    const bool turned = !scene->walls[found->carrier->wall].yields;
    const mover *first = turned ? found->barring : found->carrier;
    const mover *second = turned ? found->carrier : found->barring;
    const double sign = turned ? -1 : 1;
    const fw_facet *facet = &found->offset;
    const fw_vec2 from = fw_vec2_subtract(found->point, facet->a);
    int end, other = 0;
    FW_TRY(scene_find_piston(scene, first->wall, &end, error));
    const bool borne = scene->walls[second->wall].yields;
    if (borne) FW_TRY(scene_find_piston(scene, second->wall, &other, error));
    const bool curved = fw_facet_is_curved(facet);
    const fw_joint_row what = {.kind = curved ? FW_JOINT_ROUND : FW_JOINT_PLANE,
                               .end = {end, other},
                               .borne = borne,
                               .normal = fw_vec2_scale(sign, fw_facet_normal(facet, from)),
                               .centre = fw_vec2_scale(-sign, from),
                               .inside = curved && facet->side == FW_INSIDE,
                               .motion = second->motion,
                               .behind = fmax(0, -fw_facet_gap(facet, found->point))};
    const scene_row row = {.facet = found->facet,
                           .met = true,
                           .point_body = found->carrier->wall,
                           .point = found->corner};
    return scene_append_row(scene, end, &row, &what, error);
}

fw_status scene_add_met(fw_scene *scene, fw_error *error)
{
    for (int n = 0; n < scene->met_count; ++n) {
        const mover a = mover_of(scene, scene->met[n].a), b = mover_of(scene, scene->met[n].b);
        passage first = {.when = INFINITY};
        if (!scene->walls[a.wall].yields && !scene->walls[b.wall].yields) continue;
        look_from(scene, &a, &b, &first);
        look_from(scene, &b, &a, &first);
        if (first.when < INFINITY) FW_TRY(add_row(scene, &first, error));
    }
    return FW_OK;
}

void scene_push_met(fw_scene *scene)
{
    const scene_joint *joint = scene->joint;
    for (int w = 0; w < scene->wall_count; ++w) scene->walls[w].met = (fw_vec2){0, 0};
    for (int n = 0; joint && n < joint->row_count; ++n) {
        const fw_joint_row *row = &joint->joint_rows[n];
        for (int k = 0; joint->rows[n].met && k < (row->borne ? 2 : 1); ++k) {
            scene_wall *wall = &scene->walls[joint->ends[row->end[k]].particle];
            wall->met = fw_vec2_add(wall->met, fw_vec2_scale(row->lambda, row->weight[k]));
        }
    }
}

/* --- at the start --- */

static double distance_from(const fw_facet *facet, fw_vec2 point)
{
    const fw_vec2 along = fw_vec2_subtract(facet->b, facet->a),
                  from = fw_vec2_subtract(point, facet->a);
    if (fw_facet_is_curved(facet)) return fabs(fw_facet_gap(facet, point));
    const double part = fw_vec2_dot(from, along) / fw_vec2_dot(along, along);
    const fw_vec2 off = fw_vec2_subtract(from, fw_vec2_scale(fmin(fmax(part, 0), 1), along));
    return sqrt(fw_vec2_dot(off, off));
}

/* Does any corner or circle of the first lie in the second, or do their edges cross? */
static bool overlap(const fw_wall *wall, const fw_wall *other)
{
    const fw_vec2 start = fw_wall_displacement(wall, 0), place = fw_wall_displacement(other, 0);
    const fw_vec2 apart = fw_vec2_subtract(start, place);
    for (int n = 0; n < fw_wall_facet_count(wall); ++n) {
        const fw_facet *own = fw_wall_facet(wall, n);
        const fw_vec2 a = fw_vec2_add(own->a, apart), b = fw_vec2_add(own->b, apart);
        const double rounding = ON_SURFACE * (1 + fabs(a.x) + fabs(a.y));
        const double radius = fw_facet_is_curved(own) ? own->length : 0;
        if (has_corners(wall) && (fw_wall_depth(other, a, (fw_vec2){0, 0}) > rounding ||
                                  fw_wall_depth(other, b, (fw_vec2){0, 0}) > rounding))
            return true;
        for (int f = 0; f < fw_wall_facet_count(other); ++f) {
            const fw_facet *theirs = fw_wall_facet(other, f);
            if (has_corners(wall) && radius > 0 && distance_from(theirs, a) < radius - rounding)
                return true;
            if (radius == 0 && !fw_facet_is_curved(theirs) &&
                fw_crossing_of_still(a, b, theirs->a, theirs->b))
                return true;
        }
    }
    return false;
}

fw_status scene_refuse_met(const fw_scene *scene, fw_error *error)
{
    for (int n = 0; n < scene->met_count; ++n) {
        const fw_wall *a = scene->walls[scene->met[n].a].wall,
                      *b = scene->walls[scene->met[n].b].wall;
        if (overlap(a, b) || overlap(b, a))
            return fw_fail(error, FW_BAD_INPUT,
                           "piston %s starts in wall %s, which it meets; expected shapes that do "
                           "not overlap",
                           fw_wall_name(a), fw_wall_name(b));
    }
    return FW_OK;
}
