/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_edges.c - who meets whom: the contours of bodies that keep out of each other, and the
 * refusal of those that start in each other. State: contours follow from links. Start reading at
 * scene_make_edges(). */
#include "scene_parts.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* A point may start so far inside another body, in units of the coordinates' size. */
static const double ON_EDGE = 1e-12;
/* How far behind a segment its matter is looked for, in lengths of the segment. */
static const double BEHIND = 1e-2;

bool fw_scene_bodies_meet(const fw_scene *scene, int a, int b)
{
    const fw_solid_model *first = scene->bodies[a].solid->model;
    const fw_solid_model *second = scene->bodies[b].solid->model;
    return a != b && first->solid_between_links && second->solid_between_links &&
           first->ticks_per_step == second->ticks_per_step;
}

static bool meets_any(const fw_scene *scene, int body)
{
    for (int other = 0; other < scene->body_count; ++other)
        if (fw_scene_bodies_meet(scene, body, other)) return true;
    return false;
}

static void clear_points(scene_edge *edge)
{
    fw_contour_clear(&edge->contour);
    free(edge->predictions);
    free(edge->paths);
    free(edge->end);
    free(edge->entry);
    edge->predictions = NULL;
    edge->paths = NULL;
    edge->end = edge->entry = NULL;
}

static fw_status make_points(scene_edge *edge, const fw_solid *solid, fw_error *error)
{
    clear_points(edge);
    FW_TRY(fw_contour_create(&edge->contour, solid, edge->home, error));
    const size_t count = (size_t)edge->contour.point_count + 1;
    edge->predictions = calloc(count, sizeof *edge->predictions);
    edge->paths = calloc(count, sizeof *edge->paths);
    edge->end = calloc(count, sizeof *edge->end);
    edge->entry = calloc(count, sizeof *edge->entry);
    if (!edge->predictions || !edge->paths || !edge->end || !edge->entry)
        return fw_fail_memory(error, "the contour of a body");
    for (size_t point = 0; point < count; ++point) edge->end[point] = -1;
    edge->revision = solid->boundary_revision;
    edge->entries_revision = -1;
    return FW_OK;
}

static fw_status make_edge(scene_body *body, double friction, fw_error *error)
{
    const fw_solid *solid = body->solid;
    body->edge = calloc(1, sizeof *body->edge);
    if (body->edge) body->edge->home = calloc((size_t)solid->count, sizeof *body->edge->home);
    if (!body->edge || !body->edge->home) return fw_fail_memory(error, "the contour of a body");
    if (friction > 0) {
        body->edge->rubs = calloc((size_t)solid->count, sizeof *body->edge->rubs);
        if (!body->edge->rubs) return fw_fail_memory(error, "the friction of a body");
    }
    for (int i = 0; i < solid->count; ++i) body->edge->home[i] = fw_solid_position(solid, i);
    return make_points(body->edge, solid, error);
}

static void destroy_edge(scene_edge *edge)
{
    if (!edge) return;
    clear_points(edge);
    free(edge->home);
    free(edge->rubs);
    free(edge);
}

/* --- bodies that start in each other --- */

static fw_vec2 place_of(const scene_body *body, int point)
{
    return fw_solid_position(body->solid, body->edge->contour.particles[point]);
}

static fw_box frame_of(const scene_body *body)
{
    fw_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int point = 0; point < body->edge->contour.point_count; ++point) {
        const fw_vec2 at = place_of(body, point);
        box.low = (fw_vec2){fmin(box.low.x, at.x), fmin(box.low.y, at.y)};
        box.high = (fw_vec2){fmax(box.high.x, at.x), fmax(box.high.y, at.y)};
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

/* How deep a place lies in the matter of a body; 0: it lies outside. A ray to the right leaves
 * matter as often as it enters it, and once more where it starts in it. */
static double depth_in(const scene_body *body, fw_vec2 at)
{
    const fw_contour *contour = &body->edge->contour;
    double nearest = INFINITY;
    bool inside = false;
    for (int n = 0; n < contour->segment_count; ++n) {
        const fw_contour_segment *s = &contour->segments[n];
        if (s->two_sided) continue;
        const fw_vec2 from = place_of(body, s->from), to = place_of(body, s->to);
        nearest = fmin(nearest, distance_to(at, from, to));
        if ((from.y > at.y) == (to.y > at.y)) continue;
        const double side = fw_vec2_cross(fw_vec2_subtract(to, from), fw_vec2_subtract(at, from));
        inside ^= (side > 0) == (to.y > from.y);
    }
    return inside ? nearest : 0;
}

static bool lies_deeper(const scene_body *in, fw_vec2 at, fw_box common, double *depth)
{
    if (at.x < common.low.x || at.x > common.high.x || at.y < common.low.y || at.y > common.high.y)
        return false;
    const double deep = depth_in(in, at);
    if (deep <= *depth || deep <= ON_EDGE * (1 + fabs(at.x) + fabs(at.y))) return false;
    *depth = deep;
    return true;
}

/* In the matter that a segment bounds. */
static fw_vec2 behind_middle(const scene_body *body, const fw_contour_segment *s)
{
    const fw_vec2 from = place_of(body, s->from), to = place_of(body, s->to);
    const fw_vec2 along = fw_vec2_subtract(to, from);
    const fw_vec2 middle = fw_vec2_scale(0.5, fw_vec2_add(from, to));
    return fw_vec2_add(middle, fw_vec2_scale(-BEHIND, fw_vec2_turn(along)));
}

/* The particle at which a body lies deepest in another one; -1: it does not. Points may lie on the
 * other's edge, all of them where one body fills the place of the other: so the matter behind the
 * middle of each segment is looked for, too. */
static int find_deepest(const scene_body *body, const scene_body *in, fw_box common, double *depth)
{
    int deepest = -1;
    *depth = 0;
    const fw_contour *contour = &body->edge->contour;
    for (int point = 0; point < contour->point_count; ++point)
        if (lies_deeper(in, place_of(body, point), common, depth)) deepest = point;
    for (int n = 0; n < contour->segment_count; ++n) {
        const fw_contour_segment *s = &contour->segments[n];
        if (!s->two_sided && lies_deeper(in, behind_middle(body, s), common, depth))
            deepest = s->from;
    }
    return deepest;
}

/* Does a pair of segments cross well between their ends? */
static bool cross(fw_vec2 a, fw_vec2 b, fw_vec2 c, fw_vec2 d)
{
    const fw_vec2 ab = fw_vec2_subtract(b, a), cd = fw_vec2_subtract(d, c);
    const double least = 1e-9 * (fw_vec2_dot(ab, ab) + fw_vec2_dot(cd, cd));
    const double c_side = fw_vec2_cross(ab, fw_vec2_subtract(c, a));
    const double d_side = fw_vec2_cross(ab, fw_vec2_subtract(d, a));
    const double a_side = fw_vec2_cross(cd, fw_vec2_subtract(a, c));
    const double b_side = fw_vec2_cross(cd, fw_vec2_subtract(b, c));
    return fmin(fabs(c_side), fabs(d_side)) > least && fmin(fabs(a_side), fabs(b_side)) > least &&
           (c_side > 0) != (d_side > 0) && (a_side > 0) != (b_side > 0);
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
static const char *find_fault(const scene_body *first, const fw_contour_segment *s,
                              const scene_body *second, const fw_contour_segment *t)
{
    const fw_vec2 a = place_of(first, s->from), b = place_of(first, s->to);
    const fw_vec2 c = place_of(second, t->from), d = place_of(second, t->to);
    if (cross(a, b, c, d)) return "their edges cross";
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
        const scene_body *first = &scene->bodies[joint->member_bodies[a.body]];
        const scene_body *second = &scene->bodies[joint->member_bodies[b.body]];
        for (int i = 0; i < a.count; ++i)
            for (int k = 0; k < b.count; ++k) {
                const fw_contour_segment *s = &first->edge->contour.segments[a.first + i];
                const fw_contour_segment *t = &second->edge->contour.segments[b.first + k];
                const char *fault = find_fault(first, s, second, t);
                const fw_vec2 from = place_of(first, s->from);
                if (!fault) continue;
                scene->refused = 1 + joint->member_bodies[b.body];
                return fw_fail(error, FW_BAD_INPUT,
                               "body %s starts in body %s: %s near (%g, %g), expected bodies side "
                               "by side",
                               second->name, first->name, fault, from.x, from.y);
            }
    }
    return FW_OK;
}

/* Looks at a pair of bodies, of which one may lie in the other within the common part of both
 * frames. */
typedef fw_status pair_look(const fw_scene *scene, int body, int in, fw_box common, void *context,
                            fw_error *error);

/* At all pairs of bodies whose frames meet, in either order, until one fails. */
static fw_status look_at_pairs(const fw_scene *scene, pair_look *look, void *context,
                               fw_error *error)
{
    const scene_joint *joint = scene->joint;
    fw_box *frames = calloc((size_t)joint->member_count, sizeof *frames);
    if (!frames) return fw_fail_memory(error, "a look at where bodies overlap");
    fw_status status = FW_OK;
    for (int m = 0; m < joint->member_count; ++m)
        frames[m] = frame_of(&scene->bodies[joint->member_bodies[m]]);
    for (int m = 0; m < joint->member_count; ++m)
        for (int n = 0; n < m && status == FW_OK; ++n) {
            const int a = joint->member_bodies[m], b = joint->member_bodies[n];
            const fw_box common = {
                {fmax(frames[m].low.x, frames[n].low.x), fmax(frames[m].low.y, frames[n].low.y)},
                {fmin(frames[m].high.x, frames[n].high.x),
                 fmin(frames[m].high.y, frames[n].high.y)}};
            if (common.low.x > common.high.x || common.low.y > common.high.y) continue;
            status = look(scene, a, b, common, context, error);
            if (status == FW_OK) status = look(scene, b, a, common, context, error);
        }
    free(frames);
    return status;
}

static fw_status refuse_inside(const fw_scene *scene, int number, int other, fw_box common,
                               void *context, fw_error *error)
{
    const scene_body *body = &scene->bodies[number], *in = &scene->bodies[other];
    int *refused = context;
    double depth;
    const int point = find_deepest(body, in, common, &depth);
    if (point < 0) return FW_OK;
    const fw_vec2 at = place_of(body, point);
    *refused = 1 + number;
    return fw_fail(error, FW_BAD_INPUT,
                   "body %s starts in body %s: at its particle %d near (%g, %g) it lies %g inside, "
                   "expected bodies side by side",
                   body->name, in->name, body->edge->contour.particles[point], at.x, at.y, depth);
}

static fw_status refuse_overlaps(fw_scene *scene, fw_error *error)
{
    int jumped;
    FW_TRY(fw_meeting_begin(scene->joint->search, scene->joint->members, 0, &jumped, error));
    FW_TRY(fw_meeting_find(scene->joint->search, 0, error));
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
    find_deepest(&scene->bodies[number], &scene->bodies[other], common, &depth);
    *most = fmax(*most, depth);
    return FW_OK;
}

/* NAN without memory for it. */
double fw_scene_body_penetration(const fw_scene *scene)
{
    double most = 0;
    if (!scene->joint) return 0;
    return look_at_pairs(scene, note_depth, &most, NULL) == FW_OK ? most : NAN;
}

/* --- making and renewing --- */

static fw_status renew_search(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    for (int m = 0; m < joint->member_count; ++m) {
        const scene_body *body = &scene->bodies[joint->member_bodies[m]];
        joint->members[m] =
            (fw_meeting_body){.solid = body->solid, .contour = &body->edge->contour};
    }
    joint->search_is_new = true;
    fw_meeting_destroy(joint->search);
    joint->search = NULL;
    return fw_meeting_create(&joint->search, joint->members, joint->member_count, error);
}

fw_status scene_make_edges(fw_scene *scene, fw_error *error)
{
    int count = 0;
    for (int b = 0; b < scene->body_count; ++b) count += meets_any(scene, b);
    if (count == 0) return FW_OK;
    scene_joint *joint = scene->joint = calloc(1, sizeof *joint);
    if (!joint) return fw_fail_memory(error, "the contact of bodies");
    joint->members = calloc((size_t)count, sizeof *joint->members);
    joint->member_bodies = calloc((size_t)count, sizeof *joint->member_bodies);
    joint->bodies = calloc((size_t)scene->body_count, sizeof *joint->bodies);
    joint->solver = fw_joint_create();
    if (!joint->members || !joint->member_bodies || !joint->bodies || !joint->solver)
        return fw_fail_memory(error, "the contact of bodies");
    for (int b = 0; b < scene->body_count; ++b) {
        if (!meets_any(scene, b)) continue;
        FW_TRY(make_edge(&scene->bodies[b], scene->friction, error));
        joint->member_bodies[joint->member_count++] = b;
    }
    FW_TRY(renew_search(scene, error));
    FW_TRY(refuse_overlaps(scene, error));
    /* The search shall take the first step, or what is resumed, for its first look. */
    return renew_search(scene, error);
}

fw_status scene_restore_edges(fw_scene *scene, fw_error *error)
{
    if (!scene->joint) return FW_OK;
    for (int m = 0; m < scene->joint->member_count; ++m) {
        const scene_body *body = &scene->bodies[scene->joint->member_bodies[m]];
        FW_TRY(make_points(body->edge, body->solid, error));
    }
    scene->joint->end_count = 0;
    return renew_search(scene, error);
}

void scene_destroy_edges(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b) destroy_edge(scene->bodies[b].edge);
    if (!scene->joint) return;
    scene_joint *joint = scene->joint;
    fw_joint_destroy(joint->solver);
    fw_meeting_destroy(joint->search);
    free(joint->members);
    free(joint->member_bodies);
    free(joint->ends);
    free(joint->joint_ends);
    free(joint->rows);
    free(joint->joint_rows);
    free(joint->found);
    free(joint->bodies);
    free(joint);
}

void scene_predict_busy(fw_scene *scene)
{
    enum { POINTS_MAX = 64 };
    scene_joint *joint = scene->joint;
    int count;
    const int *busy = fw_meeting_busy(joint->search, &count);
    for (; joint->predicted < count; ++joint->predicted) {
        const fw_meeting_run run = fw_meeting_observe_run(joint->search, busy[joint->predicted]);
        const scene_body *body = &scene->bodies[joint->member_bodies[run.body]];
        const fw_contour *contour = &body->edge->contour;
        int points[POINTS_MAX], particles[POINTS_MAX], found = 0;
        fw_prediction predictions[POINTS_MAX];
        assert(2 * run.count <= POINTS_MAX);
        for (int n = run.first; n < run.first + run.count; ++n) {
            if (found == 0 || points[found - 1] != contour->segments[n].from)
                points[found++] = contour->segments[n].from;
            points[found++] = contour->segments[n].to;
        }
        for (int n = 0; n < found; ++n) particles[n] = contour->particles[points[n]];
        fw_solid_predict(body->solid, particles, found, predictions);
        for (int n = 0; n < found; ++n) {
            body->edge->predictions[points[n]] = predictions[n];
            if (body->edge->end[points[n]] < 0)
                body->edge->paths[points[n]] = predictions[n].displacement;
        }
    }
}

static fw_status report_jump(const fw_scene *scene, int jumped, fw_error *error)
{
    const fw_meeting_run run = fw_meeting_observe_run(scene->joint->search, jumped);
    const scene_body *body = &scene->bodies[scene->joint->member_bodies[run.body]];
    const fw_vec2 at = place_of(body, body->edge->contour.segments[run.first].from);
    return fw_fail(error, FW_DIVERGED,
                   "step %lld: the edge of body %s near (%g, %g) came there in one step from so "
                   "far that it may have passed another body, expected less than a spacing",
                   (long long)scene->clock.step, body->name, at.x, at.y);
}

/* Segments have other numbers now. */
static void forget_rubbing(const fw_scene *scene, int changed)
{
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int i = 0; body->edge && body->edge->rubs && i < body->solid->count; ++i)
            if (body->edge->rubs[i].other == 1 + changed) body->edge->rubs[i] = (scene_rub){0};
    }
}

/* How far any point of any edge will go in this step. Predicts them all. */
static double longest_prediction(const fw_scene *scene)
{
    double squared = 0;
    for (int m = 0; m < scene->joint->member_count; ++m) {
        const scene_body *body = &scene->bodies[scene->joint->member_bodies[m]];
        const scene_edge *edge = body->edge;
        fw_solid_predict(body->solid, edge->contour.particles, edge->contour.point_count,
                         edge->predictions);
        for (int point = 0; point < edge->contour.point_count; ++point) {
            const fw_vec2 w = edge->predictions[point].displacement;
            squared = fmax(squared, fw_vec2_dot(w, w));
        }
    }
    return sqrt(squared);
}

fw_status scene_predict_edges(fw_scene *scene, fw_error *error)
{
    if (!scene->joint) return FW_OK;
    bool changed = false;
    for (int m = 0; m < scene->joint->member_count; ++m) {
        const scene_body *body = &scene->bodies[scene->joint->member_bodies[m]];
        if (body->edge->revision == body->solid->boundary_revision) continue;
        FW_TRY(make_points(body->edge, body->solid, error));
        changed = true;
        forget_rubbing(scene, scene->joint->member_bodies[m]);
    }
    if (changed) FW_TRY(renew_search(scene, error));
    int jumped;
    const double expected = scene->joint->search_is_new ? longest_prediction(scene) : 0;
    const fw_status status =
        fw_meeting_begin(scene->joint->search, scene->joint->members, expected, &jumped, error);
    scene->joint->search_is_new = false;
    if (jumped >= 0) return report_jump(scene, jumped, error);
    FW_TRY(status);
    scene->joint->predicted = 0;
    scene_predict_busy(scene);
    return FW_OK;
}
