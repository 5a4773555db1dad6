/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_edges.c - who meets whom: the contours of bodies that keep out of each other. State:
 * contours follow from links. Start reading at scene_make_edges(). */
#include "scene_parts.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

bool fw_scene_bodies_meet(const fw_scene *scene, int a, int b)
{
    const fw_solid_model *first = scene->bodies[a].solid->model;
    const fw_solid_model *second = scene->bodies[b].solid->model;
    if (a == b) return fw_solid_parts(scene->bodies[a].solid, 0, NULL) > 1;
    return first->solid_between_links && second->solid_between_links;
}

int scene_part_of(const fw_solid *solid, int particle)
{
    fw_part part;
    const int count = fw_solid_parts(solid, 0, &part);
    int number = 0;
    while (number + 1 < count && particle >= part.first + part.count)
        fw_solid_parts(solid, ++number, &part);
    return number;
}

static bool meets_any(const fw_scene *scene, int body)
{
    for (int other = 0; other < scene->body_count; ++other)
        if (fw_scene_bodies_meet(scene, body, other)) return true;
    return false;
}

static void clear_points(scene_edge *edge)
{
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
    if (solid->model->list_links) /* what flows is looked at as it lies now */
        for (int i = 0; i < solid->count; ++i) edge->home[i] = fw_solid_position(solid, i);
    if (solid->model->list_links || !edge->contour.points) {
        fw_contour_clear(&edge->contour);
        FW_TRY(fw_contour_create(&edge->contour, solid, edge->home, error));
    } else {
        FW_TRY(fw_contour_renew(&edge->contour, solid, edge->home, error));
    }
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

static fw_status make_edge(scene_body *body, bool rubs, fw_error *error)
{
    fw_solid *solid = body->solid;
    bool changed;
    if (solid->model->list_links) FW_TRY(solid->model->list_links(solid, &changed, error));
    body->edge = calloc(1, sizeof *body->edge);
    if (body->edge) body->edge->home = calloc((size_t)solid->count, sizeof *body->edge->home);
    if (!body->edge || !body->edge->home) return fw_fail_memory(error, "the contour of a body");
    if (rubs) {
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
    fw_contour_clear(&edge->contour);
    free(edge->home);
    free(edge->rubs);
    free(edge);
}

/* Segments of one part: chains come in the order of their first particles. */
static fw_meeting_body member_of(const scene_body *body, const fw_part *part)
{
    const fw_contour *contour = &body->edge->contour;
    fw_meeting_body member = {.solid = body->solid, .contour = contour};
    while (member.first < contour->segment_count &&
           contour->particles[contour->segments[member.first].from] < part->first)
        ++member.first;
    while (member.first + member.count < contour->segment_count &&
           contour->particles[contour->segments[member.first + member.count].from] <
               part->first + part->count)
        ++member.count;
    return member;
}

/* Members of a body follow each other. */
static fw_part part_of(const fw_scene *scene, int member)
{
    const int *bodies = scene->joint->member_bodies;
    int number = 0;
    while (number < member && bodies[member - 1 - number] == bodies[member]) ++number;
    fw_part part;
    fw_solid_parts(scene->bodies[bodies[member]].solid, number, &part);
    return part;
}

const char *scene_member_name(const fw_scene *scene, int member)
{
    const fw_part part = part_of(scene, member);
    return part.name ? part.name : scene->bodies[scene->joint->member_bodies[member]].name;
}

fw_status scene_renew_search(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    if (!joint || joint->member_count == 0) return FW_OK;
    for (int m = 0; m < joint->member_count; ++m) {
        const fw_part part = part_of(scene, m);
        joint->members[m] = member_of(&scene->bodies[joint->member_bodies[m]], &part);
    }
    joint->search_is_new = true;
    fw_meeting_destroy(joint->search);
    joint->search = NULL;
    return fw_meeting_create(&joint->search, joint->members, joint->member_count, error);
}

fw_status scene_make_edges(fw_scene *scene, fw_error *error)
{
    int count = 0;
    int slots = 0;
    for (int b = 0; b < scene->body_count; ++b) {
        const int parts = fw_solid_parts(scene->bodies[b].solid, 0, NULL);
        count += meets_any(scene, b) ? parts : 0;
        slots += parts;
    }
    const bool meets_walls = scene->piston_count > 0 || scene->grip_count > 0;
    if (count == 0 && !(meets_walls && scene->wall_count > 0)) return FW_OK;
    scene_joint *joint = scene->joint = calloc(1, sizeof *joint);
    if (!joint) return fw_fail_memory(error, "the contact of bodies");
    joint->members = calloc((size_t)count + 1, sizeof *joint->members);
    joint->member_bodies = calloc((size_t)count + 1, sizeof *joint->member_bodies);
    joint->frames = calloc((size_t)count + 1, sizeof *joint->frames);
    joint->slots = calloc((size_t)scene->body_count + 1, sizeof *joint->slots);
    joint->bodies = calloc((size_t)slots + 1, sizeof *joint->bodies);
    joint->solver = fw_joint_create();
    joint->rubs = count > 0 && scene_bodies_rub(scene);
    if (!joint->members || !joint->member_bodies || !joint->frames || !joint->slots ||
        !joint->bodies || !joint->solver)
        return fw_fail_memory(error, "the contact of bodies");
    for (int b = 0; b < scene->body_count; ++b) {
        const int parts = fw_solid_parts(scene->bodies[b].solid, 0, NULL);
        joint->slots[b] = joint->slot_count;
        joint->slot_count += parts;
        if (!meets_any(scene, b)) continue;
        FW_TRY(make_edge(&scene->bodies[b], joint->rubs, error));
        for (int n = 0; n < parts; ++n) joint->member_bodies[joint->member_count++] = b;
    }
    if (count == 0) return FW_OK;
    FW_TRY(scene_renew_search(scene, error));
    FW_TRY(scene_refuse_overlaps(scene, error));
    /* The search shall take the first step, or what is resumed, for its first look. */
    return scene_renew_search(scene, error);
}

fw_status scene_restore_edges(fw_scene *scene, fw_error *error)
{
    if (!scene->joint) return FW_OK;
    scene_forget_ends(scene);
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        bool changed;
        if (!body->edge) continue;
        if (body->solid->model->list_links)
            FW_TRY(body->solid->model->list_links(body->solid, &changed, error));
        FW_TRY(make_points(body->edge, body->solid, error));
    }
    return scene_renew_search(scene, error);
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
    free(joint->frames);
    free(joint->slots);
    free(joint->ends);
    free(joint->joint_ends);
    free(joint->rows);
    free(joint->joint_rows);
    free(joint->found);
    free(joint->reached);
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
        scene_predict_points(body->solid, particles, found, predictions);
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
    const fw_vec2 at = scene_place_of(body, body->edge->contour.segments[run.first].from);
    return fw_fail(error, FW_DIVERGED,
                   "step %lld: the edge of body %s near (%g, %g) came there in one step from so "
                   "far that it may have passed another body, expected less than a spacing",
                   (long long)scene->clock.step, scene_member_name(scene, run.body), at.x, at.y);
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
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        const scene_edge *edge = body->edge;
        if (!edge) continue;
        scene_predict_points(body->solid, edge->contour.particles, edge->contour.point_count,
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
    if (!scene->joint || scene_is_second_tick(scene)) return FW_OK;
    scene_forget_ends(scene);
    if (!scene->joint->search) return FW_OK;
    bool changed = false;
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        bool relinked = false;
        if (!body->edge) continue;
        if (body->solid->model->list_links)
            FW_TRY(body->solid->model->list_links(body->solid, &relinked, error));
        if (!relinked && body->edge->revision == body->solid->boundary_revision) continue;
        fw_solid_place(body->solid); /* which lists the links that are left */
        FW_TRY(make_points(body->edge, body->solid, error));
        changed = true;
        forget_rubbing(scene, b);
    }
    if (changed) FW_TRY(scene_renew_search(scene, error));
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
