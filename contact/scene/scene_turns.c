/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_turns.c - bodies against bodies and pistons where two colours move in turn. In a half-step
 * only one of them can take up momentum, and the edge of a body that moves as a whole is ragged
 * then; so the contact of both half-steps is one problem, which is solved before the first. What
 * holds is said of whole steps: no body is in another one after each, and their energy and momentum
 * stay. Cells that move in the first half-step get their forces then, the others in the second.
 * State: none but ends and forces, between the two half-steps. Start reading at scene_couple_end().
 */
#include "scene_parts.h"

#include <assert.h>
#include <math.h>

/* Where a planned displacement is missed by more than this part of it, a link has broken. */
static const double BROKEN = 1e-9;

bool scene_is_second_tick(const fw_scene *scene)
{
    return scene->ticks_per_step == 2 && scene->clock.ticks % 2 == 1;
}

void scene_predict_points(const fw_solid *solid, const int *particles, int count,
                          fw_prediction *out)
{
    if (solid->model->predict_step)
        solid->model->predict_step(solid, particles, count, out);
    else
        fw_solid_predict(solid, particles, count, out);
}

/* What walls did to those that lead the particle. */
static fw_vec2 led_by_walls(const scene_body *body, int particle)
{
    fw_partner partners[FW_PARTNERS];
    const int count = body->solid->model->partners(body->solid, particle, partners);
    fw_vec2 sum = {0, 0};
    for (int k = 0; k < count; ++k) {
        const int contact = scene_find_contact(body, partners[k].particle);
        if (contact < 0) continue;
        fw_prediction free;
        fw_solid_predict(body->solid, &partners[k].particle, 1, &free);
        const fw_vec2 more =
            fw_vec2_subtract(body->contacts[contact].solution.displacement, free.displacement);
        sum = fw_vec2_add(
            sum, (fw_vec2){fw_vec2_dot(partners[k].x, more), fw_vec2_dot(partners[k].y, more)});
    }
    return sum;
}

void scene_lead_points(fw_scene *scene, int first_busy)
{
    const scene_joint *joint = scene->joint;
    int count;
    const int *busy = fw_meeting_busy(joint->search, &count);
    if (scene->ticks_per_step == 1) return;
    for (int n = first_busy; n < count; ++n) {
        const fw_meeting_run run = fw_meeting_observe_run(joint->search, busy[n]);
        const scene_body *body = &scene->bodies[joint->member_bodies[run.body]];
        const scene_edge *edge = body->edge;
        for (int k = run.first; body->contact_count > 0 && k < run.first + run.count; ++k)
            for (int side = 0; side < 2; ++side) {
                const fw_contour_segment *s = &edge->contour.segments[k];
                const int point = side == 0 ? s->from : s->to;
                fw_prediction *free = &edge->predictions[point];
                if (!free->later || free->led) continue;
                free->displacement = fw_vec2_add(
                    free->displacement, led_by_walls(body, edge->contour.particles[point]));
                free->led = true;
                if (edge->end[point] < 0) edge->paths[point] = free->displacement;
            }
    }
}

fw_status scene_lead_entries(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count && scene_pistons_take_steps(scene); ++b) {
        const scene_body *body = &scene->bodies[b];
        fw_prediction *predictions = fw_boundary_predictions(body->boundary);
        for (int e = 0; body->contact_count > 0 && e < fw_boundary_count(body->boundary); ++e) {
            if (!predictions[e].later) continue;
            const int particle = fw_boundary_particles(body->boundary)[e];
            const fw_vec2 more = led_by_walls(body, particle);
            if (more.x == 0 && more.y == 0) continue;
            fw_vec2 *w = &predictions[e].displacement;
            *w = fw_vec2_add(*w, more);
            FW_TRY(fw_boundary_extend(
                body->boundary, scene->broadphase, fw_boundary_run_of(body->boundary, e),
                fw_vec2_add(fw_solid_position(body->solid, particle), *w), error));
        }
    }
    return FW_OK;
}

/* An end leads each of its followers once: it is made once. */
static void couple(fw_scene *scene, int leader, int follower, int particle)
{
    scene_joint *joint = scene->joint;
    const scene_body *body = &scene->bodies[joint->ends[follower].body];
    fw_joint_end *led = &joint->joint_ends[follower], *leads = &joint->joint_ends[leader];
    fw_partner partners[FW_PARTNERS];
    const int count =
        body->solid->model->partners(body->solid, joint->ends[follower].particle, partners);
    for (int k = 0; k < count; ++k) {
        if (partners[k].particle != particle) continue;
        assert(led->lead_count < FW_JOINT_LEADS && leads->follower_count < FW_JOINT_LEADS);
        led->lead[led->lead_count++] = (fw_joint_lead){
            .end = leader, .x = partners[k].x, .y = partners[k].y, .expected = leads->displacement};
        leads->follower[leads->follower_count++] = follower;
    }
}

/* A point that no search has come to. */
static void predict_point(scene_body *body, int point)
{
    scene_edge *edge = body->edge;
    const int particle = edge->contour.particles[point];
    fw_prediction *free = &edge->predictions[point];
    if (edge->end[point] >= 0) return;
    scene_predict_points(body->solid, &particle, 1, free);
    free->displacement = fw_vec2_add(free->displacement, led_by_walls(body, particle));
    free->led = true;
    edge->paths[point] = free->displacement;
}

/* -1: the particle meets neither walls nor bodies. */
static fw_status find_follower(fw_scene *scene, int number, int particle, int *end, fw_error *error)
{
    scene_body *body = &scene->bodies[number];
    const int entry = scene_entry_of(body, particle);
    const int point = body->edge ? body->edge->contour.points[particle] : -1;
    *end = -1;
    if (entry >= 0) return scene_find_entry(scene, number, entry, end, error);
    if (point < 0) return FW_OK;
    if (scene_pistons_take_steps(scene)) predict_point(body, point);
    return scene_find_end(scene, number, point, end, error);
}

fw_status scene_couple_end(fw_scene *scene, int number, fw_error *error)
{
    const scene_end end = scene->joint->ends[number];
    const fw_solid *solid = scene->bodies[end.body].solid;
    fw_partner partners[FW_PARTNERS];
    if (!solid->model->partners || end.later) return FW_OK;
    const int count = solid->model->partners(solid, end.particle, partners);
    for (int k = 0; k < count; ++k) {
        int follower;
        FW_TRY(find_follower(scene, end.body, partners[k].particle, &follower, error));
        if (follower >= 0) couple(scene, number, follower, end.particle);
    }
    return FW_OK;
}

/* A link that broke in the first half-step changes where a cell would go. It gets the force that
 * was found, so that momentum stays; what work that does now belongs to the link. A cell that has
 * lost its last link takes up nothing. */
static void follow_broken_links(fw_scene *scene, const scene_end *end, scene_contact *contact)
{
    fw_solid *solid = scene->bodies[end->body].solid;
    fw_contact_solution *solution = &contact->solution;
    fw_prediction free;
    fw_solid_predict(solid, &contact->particle, 1, &free);
    const fw_vec2 force = fw_vec2_add(solution->force, contact->soft), w = solution->displacement;
    const fw_vec2 there = fw_vec2_add(free.displacement, fw_sym2_apply(free.mobility, force));
    const fw_vec2 change = fw_vec2_subtract(there, w);
    const double work = fw_vec2_dot(force, change);
    fw_solid_ledger part = {.dissipated = -work, .fracture = -work};
    if (end->wall_rows > 0 ||
        fabs(change.x) + fabs(change.y) <= BROKEN * (1 + fabs(w.x) + fabs(w.y)))
        return;
    if (free.mobility.xx == 0) part.drag = fw_vec2_scale(-1, force);
    fw_solid_ledger_add(&solid->ledger, &part);
    solution->displacement = there;
}

void scene_hand_over_second(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    for (int e = 0; e < joint->end_count; ++e) {
        scene_end *end = &joint->ends[e];
        const fw_vec2 force = joint->joint_ends[e].force;
        const bool pushed = force.x != 0 || force.y != 0 || end->soft.x != 0 || end->soft.y != 0;
        if (!end->later || !pushed) continue;
        scene_body *body = &scene->bodies[end->body];
        end->contact = scene_find_contact(body, end->particle);
        scene_contact *contact = scene_hand_over_end(scene, e);
        follow_broken_links(scene, end, contact);
        scene_sort_contacts(body);
    }
}

void scene_follow_wall_later(fw_scene *scene, int w)
{
    const double now = fw_scene_time(scene);
    scene_wall *wall = &scene->walls[w];
    if (wall->piston) {
        scene_follow_wall(scene, w, 2);
        return;
    }
    wall->place = fw_wall_displacement(wall->wall, now);
    wall->motion =
        fw_vec2_subtract(fw_wall_displacement(wall->wall, now + 2 * scene->tick), wall->place);
}

fw_candidate scene_candidate_for(const fw_scene *scene, int facet, bool later)
{
    fw_candidate candidate = scene->candidates[facet];
    if (!later || scene->walls[candidate.facet->wall].piston) return candidate;
    const double now = fw_scene_time(scene);
    const fw_wall *wall = scene->walls[candidate.facet->wall].wall;
    candidate.place = fw_wall_displacement(wall, now);
    candidate.motion =
        fw_vec2_subtract(fw_wall_displacement(wall, now + 2 * scene->tick), candidate.place);
    return candidate;
}
