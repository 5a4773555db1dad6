/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_overlap.c - bodies that lie in each other: refused at the start, and measured. State: none.
 * Start reading at scene_refuse_overlaps(). */
#include "contact/geometry/crossing.h"
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>

/* A point may start so far inside another body, in units of the coordinates' size. */
static const double ON_EDGE = 1e-12;
/* How far behind a segment its matter is looked for, in lengths of the segment. */
static const double BEHIND = 1e-2;

static fw_vec2 place_of(const fw_meeting_body *body, int point)
{
    return fw_solid_position(body->solid, body->contour->particles[point]);
}

/* Every point of a body begins a segment. */
static fw_box frame_of(const fw_meeting_body *body)
{
    fw_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int n = body->first; n < body->first + body->count; ++n) {
        const fw_vec2 at = place_of(body, body->contour->segments[n].from);
        box = fw_box_joined(box, (fw_box){at, at});
    }
    return box;
}

static double distance_to(fw_vec2 at, fw_vec2 from, fw_vec2 to)
{
    const fw_vec2 along = fw_vec2_subtract(to, from), apart = fw_vec2_subtract(at, from);
    const double squared = fw_vec2_dot(along, along);
    const double part = squared > 0 ? fw_vec2_dot(apart, along) / squared : 0;
    const fw_vec2 nearest = fw_vec2_subtract(apart, fw_vec2_scale(fmin(fmax(part, 0), 1), along));
    return sqrt(fw_vec2_dot(nearest, nearest));
}

/* How deep a place lies in the matter of a body, and how much nearer than `distance`; 0: it lies
 * outside. A ray to the right leaves
 * matter as often as it enters it, and once more where it starts in it. */
static double depth_in(const fw_meeting_body *body, fw_vec2 at, double distance)
{
    double nearest = INFINITY;
    bool inside = false;
    for (int n = body->first; n < body->first + body->count; ++n) {
        const fw_contour_segment *s = &body->contour->segments[n];
        if (s->two_sided && !(distance > 0)) continue;
        const fw_vec2 from = place_of(body, s->from), to = place_of(body, s->to);
        nearest = fmin(nearest, distance_to(at, from, to));
        if (s->two_sided) continue;
        if ((from.y > at.y) == (to.y > at.y)) continue;
        const double side = fw_vec2_cross(fw_vec2_subtract(to, from), fw_vec2_subtract(at, from));
        inside ^= (side > 0) == (to.y > from.y);
    }
    return inside ? nearest + distance : fmax(0, distance - nearest);
}

static bool lies_deeper(const fw_meeting_body *in, fw_vec2 at, fw_box common, double distance,
                        double *depth)
{
    if (at.x < common.low.x || at.x > common.high.x || at.y < common.low.y || at.y > common.high.y)
        return false;
    const double deep = depth_in(in, at, distance);
    if (deep <= *depth || deep <= ON_EDGE * (1 + fabs(at.x) + fabs(at.y))) return false;
    *depth = deep;
    return true;
}

/* In the matter that a segment bounds. */
static fw_vec2 behind_middle(const fw_meeting_body *body, const fw_contour_segment *s)
{
    const fw_vec2 from = place_of(body, s->from), to = place_of(body, s->to);
    const fw_vec2 along = fw_vec2_subtract(to, from);
    const fw_vec2 middle = fw_vec2_scale(0.5, fw_vec2_add(from, to));
    return fw_vec2_add(middle, fw_vec2_scale(-BEHIND, fw_vec2_turn(along)));
}

/* The particle at which a body lies deepest in another one; -1: it does not. Points may lie on the
 * other's edge, all of them where one body fills the place of the other: so the matter behind the
 * middle of each segment is looked for, too. */
static int find_deepest(const fw_meeting_body *body, const fw_meeting_body *in, fw_box common,
                        double distance, double *depth)
{
    int deepest = -1;
    *depth = 0;
    const fw_contour_segment *segments = body->contour->segments;
    const int end = body->first + body->count;
    for (int n = body->first; n < end; ++n)
        if (lies_deeper(in, place_of(body, segments[n].from), common, distance, depth))
            deepest = segments[n].from;
    for (int n = body->first; n < end; ++n) {
        const fw_contour_segment *s = &segments[n];
        if (!s->two_sided && lies_deeper(in, behind_middle(body, s), common, distance, depth))
            deepest = s->from;
    }
    return deepest;
}

/* Do two segments share a stretch of one line? */
static bool coincide(fw_vec2 a, fw_vec2 b, fw_vec2 c, fw_vec2 d)
{
    const fw_vec2 ab = fw_vec2_subtract(b, a), cd = fw_vec2_subtract(d, c);
    const double squared = fw_vec2_dot(ab, ab), size = squared + fw_vec2_dot(cd, cd);
    const double c_side = fw_vec2_cross(ab, fw_vec2_subtract(c, a));
    const double d_side = fw_vec2_cross(ab, fw_vec2_subtract(d, a));
    if (fmax(fabs(c_side), fabs(d_side)) > 1e-9 * size || squared == 0) return false;
    const double c_along = fw_vec2_dot(ab, fw_vec2_subtract(c, a)) / squared;
    const double d_along = fw_vec2_dot(ab, fw_vec2_subtract(d, a)) / squared;
    return fmin(fmax(c_along, d_along), 1) - fmax(fmin(c_along, d_along), 0) > 1e-9;
}

/* Of two segments of two bodies. A chain of single particles has no side of its own: on an edge it
 * could not be told on which side of it it belongs. */
static const char *find_fault(const fw_meeting_body *first, const fw_contour_segment *s,
                              const fw_meeting_body *second, const fw_contour_segment *t)
{
    const fw_vec2 a = place_of(first, s->from), b = place_of(first, s->to);
    const fw_vec2 c = place_of(second, t->from), d = place_of(second, t->to);
    if (fw_crossing_of_still(a, b, c, d)) return "their edges cross";
    if ((s->two_sided || t->two_sided) && coincide(a, b, c, d))
        return "a link of single particles lies on the other's edge";
    return NULL;
}

static fw_status refuse_crossing(fw_scene *scene, fw_error *error)
{
    int count;
    const scene_joint *joint = scene->joint;
    const fw_meeting_pair *pairs = fw_meeting_pairs(joint->search, &count);
    for (int n = 0; n < count; ++n) {
        const fw_meeting_run a = fw_meeting_observe_run(joint->search, pairs[n].a),
                             b = fw_meeting_observe_run(joint->search, pairs[n].b);
        const fw_meeting_body *first = &joint->members[a.body];
        const fw_meeting_body *second = &joint->members[b.body];
        for (int i = 0; i < a.count; ++i)
            for (int k = 0; k < b.count; ++k) {
                const fw_contour_segment *s = &first->contour->segments[a.first + i];
                const fw_contour_segment *t = &second->contour->segments[b.first + k];
                const char *fault = find_fault(first, s, second, t);
                const fw_vec2 from = place_of(first, s->from);
                if (!fault) continue;
                scene->refused = 1 + joint->member_bodies[b.body];
                return fw_fail(error, FW_BAD_INPUT,
                               "body %s starts in body %s: %s near (%g, %g), expected bodies side "
                               "by side",
                               scene_member_name(scene, b.body), scene_member_name(scene, a.body),
                               fault, from.x, from.y);
            }
    }
    return FW_OK;
}

/* Looks at a pair of members, of which one may lie in the other within the common part of both
 * frames. */
typedef fw_status pair_look(const fw_scene *scene, int body, int in, fw_box common, void *context,
                            fw_error *error);

/* At all pairs of bodies whose frames meet, in either order, until one fails. */
static fw_status look_at_pairs(const fw_scene *scene, pair_look *look, void *context,
                               fw_error *error)
{
    const scene_joint *joint = scene->joint;
    fw_box *frames = joint->frames;
    fw_status status = FW_OK;
    for (int m = 0; m < joint->member_count; ++m) {
        const fw_vec2 room = {scene->distance, scene->distance};
        frames[m] = frame_of(&joint->members[m]);
        frames[m].low = fw_vec2_subtract(frames[m].low, room);
        frames[m].high = fw_vec2_add(frames[m].high, room);
    }
    for (int m = 0; m < joint->member_count; ++m)
        for (int n = 0; n < m && status == FW_OK; ++n) {
            const fw_box common = {
                {fmax(frames[m].low.x, frames[n].low.x), fmax(frames[m].low.y, frames[n].low.y)},
                {fmin(frames[m].high.x, frames[n].high.x),
                 fmin(frames[m].high.y, frames[n].high.y)}};
            if (common.low.x > common.high.x || common.low.y > common.high.y) continue;
            status = look(scene, m, n, common, context, error);
            if (status == FW_OK) status = look(scene, n, m, common, context, error);
        }
    return status;
}

static double distance_of_members(const fw_scene *scene, int number, int other)
{
    const int *bodies = scene->joint->member_bodies;
    return scene_distance_between(scene, bodies[number], bodies[other]);
}

static fw_status refuse_inside(const fw_scene *scene, int number, int other, fw_box common,
                               void *context, fw_error *error)
{
    const fw_meeting_body *body = &scene->joint->members[number];
    const fw_meeting_body *in = &scene->joint->members[other];
    int *refused = context;
    const double distance = distance_of_members(scene, number, other);
    double depth;
    const int point = find_deepest(body, in, common, distance, &depth);
    if (point < 0) return FW_OK;
    const fw_vec2 at = place_of(body, point);
    *refused = 1 + scene->joint->member_bodies[number];
    if (depth <= distance)
        return fw_fail(error, FW_BAD_INPUT,
                       "body %s starts %g from body %s: at its particle %d near (%g, %g), expected "
                       "at least the contact distance, %g",
                       scene_member_name(scene, number), distance - depth,
                       scene_member_name(scene, other), body->contour->particles[point], at.x, at.y,
                       distance);
    return fw_fail(error, FW_BAD_INPUT,
                   "body %s starts in body %s: at its particle %d near (%g, %g) it lies %g inside, "
                   "expected bodies side by side",
                   scene_member_name(scene, number), scene_member_name(scene, other),
                   body->contour->particles[point], at.x, at.y, depth);
}

fw_status scene_refuse_overlaps(fw_scene *scene, fw_error *error)
{
    int jumped;
    FW_TRY(fw_meeting_begin(scene->joint->search, scene->joint->members, 0, &jumped, error));
    FW_TRY(fw_meeting_find(scene->joint->search, scene->distance, error));
    FW_TRY(refuse_crossing(scene, error));
    return look_at_pairs(scene, refuse_inside, &scene->refused, error);
}

int fw_scene_refused_body(const fw_scene *scene)
{
    return scene->refused - 1;
}

static fw_status note_depth(const fw_scene *scene, int number, int other, fw_box common,
                            void *context, fw_error *error)
{
    double depth, *most = context;
    (void)error;
    find_deepest(&scene->joint->members[number], &scene->joint->members[other], common,
                 distance_of_members(scene, number, other), &depth);
    *most = fmax(*most, depth);
    return FW_OK;
}

double fw_scene_body_penetration(const fw_scene *scene)
{
    double most = 0;
    if (scene->joint) (void)look_at_pairs(scene, note_depth, &most, NULL); /* which cannot fail */
    return most;
}

fw_status fw_scene_find_fold(fw_scene *scene, int number, const fw_vec2 *home, bool *found,
                             fw_vec2 *where, fw_error *error)
{
    scene_body *body = &scene->bodies[number];
    fw_solid *solid = body->solid;
    int segment;
    *found = false;
    if (!solid->model->solid_between_links || solid->model->list_links) return FW_OK;
    if (!body->edge && (!body->fold.points || body->fold_revision != solid->boundary_revision)) {
        fw_solid_place(solid); /* which lists the links that are left */
        FW_TRY(fw_contour_renew(&body->fold, solid, home, error));
        body->fold_revision = solid->boundary_revision;
    }
    const fw_contour *contour = body->edge ? &body->edge->contour : &body->fold;
    FW_TRY(fw_contour_find_fold(contour, solid, &segment, error));
    *found = segment >= 0;
    if (*found)
        *where = fw_solid_position(solid, contour->particles[contour->segments[segment].from]);
    return FW_OK;
}

void fw_scene_set_distance(fw_scene *scene, double distance)
{
    scene->distance = distance;
}

fw_status fw_scene_set_distances(fw_scene *scene, const double *distances, fw_error *error)
{
    const size_t size = (size_t)scene->surface_count * (size_t)scene->surface_count;
    double *copy = malloc((size + 1) * sizeof *copy);
    if (!copy) return fw_fail_memory(error, "the distances of pairs of surfaces");
    scene->distance = 0;
    for (size_t n = 0; n < size; ++n) {
        copy[n] = distances[n];
        scene->distance = fmax(scene->distance, copy[n]);
    }
    free(scene->distances);
    scene->distances = copy;
    return FW_OK;
}

double scene_distance_between(const fw_scene *scene, int a, int b)
{
    const size_t row = (size_t)scene->bodies[a].surface, column = (size_t)scene->bodies[b].surface;
    return scene->distances ? scene->distances[row * (size_t)scene->surface_count + column]
                            : scene->distance;
}
