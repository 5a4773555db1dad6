/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_pistons.c - the pistons of a scene: ends of the joint contact, as particles are.
 *
 * The motion of a piston and the pushes of the bodies on it are found together with all else that
 * touches (joint.h), so that energy and momentum of bodies and pistons are exact. A piston that no
 * force moves is a wall on a path.
 *
 * A row keeps a particle back for the rest of the tick, whether the piston comes to it in the end
 * or not. So the particles that a piston passes the furthest get their rows first; it may be that
 * it never comes to the others.
 *
 * State: none but the pistons' own. Start reading at scene_add_reached(). */
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>

/* Particles passed by this part less than the one that is passed the furthest get their rows with
 * it. */
static const double TOGETHER = 0.1;

double scene_step_start(const fw_scene *scene)
{
    return (double)(scene->clock.step * scene->ticks_per_step) * scene->tick;
}

double scene_step_length(const fw_scene *scene)
{
    return scene->ticks_per_step * scene->tick;
}

static fw_status check_motion(const fw_scene *scene, const scene_wall *wall, fw_error *error)
{
    if (isfinite(wall->motion.x) && isfinite(wall->motion.y)) return FW_OK;
    return fw_fail(
        error, FW_DIVERGED, "step %lld: piston %s would move by (%g, %g), expected finite numbers",
        (long long)scene->clock.step, fw_wall_name(wall->wall), wall->motion.x, wall->motion.y);
}

/* A particle that rubbed on a piston meets other walls as if it had touched nothing. (What a grip
 * holds is no business of walls alone.) */
static void set_memory_apart(fw_scene *scene, scene_body *body)
{
    for (int i = 0; body->memory_before && i < body->solid->count; ++i) {
        const int facet = body->memory[i].facet;
        body->memory_before[i] = body->memory[i];
        if (facet > 0 && ((body->gripped && body->gripped[i]) ||
                          scene->walls[scene->candidates[facet - 1].facet->wall].yields))
            body->memory[i] = (fw_contact_memory){0};
    }
}

fw_status scene_begin_pistons(fw_scene *scene, fw_error *error)
{
    const double start = scene_step_start(scene), length = scene_step_length(scene);
    if (scene_is_second_tick(scene)) return FW_OK; /* they are on their way */
    for (int w = 0; w < scene->wall_count && scene->piston_count > 0; ++w) {
        scene_wall *wall = &scene->walls[w];
        if (!wall->piston) continue;
        wall->motion = fw_piston_displacement(wall->piston, (fw_vec2){0, 0}, start, length);
        wall->yields = fw_piston_yields(wall->piston);
        FW_TRY(check_motion(scene, wall, error));
    }
    for (int b = 0; b < scene->body_count && scene->piston_count > 0; ++b)
        set_memory_apart(scene, &scene->bodies[b]);
    return FW_OK;
}

/* --- whom a piston comes to --- */

static fw_status note(scene_joint *joint, const scene_reach *reach, fw_error *error)
{
    if (joint->reach_count == joint->reach_capacity) {
        const size_t capacity = 2 * (size_t)joint->reach_capacity + 64;
        scene_reach *reached = realloc(joint->reached, capacity * sizeof *reached);
        if (!reached) return fw_fail_memory(error, "the contact of pistons");
        joint->reached = reached;
        joint->reach_capacity = (int)capacity;
    }
    joint->reached[joint->reach_count++] = *reach;
    return FW_OK;
}

/* By how much the facet, as it moves now, passes that path of a particle. */
static double excess_of(const scene_wall *wall, const fw_facet *facet, fw_vec2 position, fw_vec2 w)
{
    const fw_vec2 from = fw_vec2_subtract(position, wall->place);
    const fw_vec2 normal = fw_facet_normal(facet, fw_vec2_subtract(from, facet->a));
    const double gap = fmax(fw_facet_gap(facet, from), 0);
    return -(gap + fw_vec2_dot(normal, fw_vec2_subtract(w, wall->motion)));
}

/* Is the facet, or the spring, a row of that end already? */
static bool is_known(const scene_joint *joint, int end, int facet)
{
    const scene_row row = {.facet = facet};
    const int known = end >= 0 ? scene_find_row(joint, end, &row) : -1;
    return known >= 0 && !joint->joint_rows[known].open;
}

static fw_status look_at(fw_scene *scene, scene_reach reach, fw_vec2 w, fw_error *error)
{
    const scene_body *body = &scene->bodies[reach.body];
    const fw_candidate *candidate = &scene->candidates[reach.facet];
    scene_wall *wall = &scene->walls[candidate->facet->wall];
    const int end = *scene_end_of_entry(body, reach.entry);
    const fw_vec2 position = fw_solid_position(body->solid, reach.particle);
    if (wall->soft && body->gripped && body->gripped[reach.particle]) return FW_OK;
    if (wall->soft) {
        const fw_vec2 force = scene_soft_force_of(wall, position, w);
        reach.facet = wall->first_facet;
        reach.spring = true;
        if ((force.x == 0 && force.y == 0) || is_known(scene->joint, end, reach.facet))
            return FW_OK;
        return note(scene->joint, &reach, error);
    }
    const double away = fmax(fabs(wall->place.x), fabs(wall->place.y));
    if (is_known(scene->joint, end, reach.facet) ||
        (end >= 0 && scene->joint->ends[end].wall_rows >= FW_WALL_CONTACTS) ||
        !fw_facet_is_passed(candidate->facet, fw_vec2_subtract(position, wall->place),
                            fw_vec2_subtract(w, wall->motion), away))
        return FW_OK;
    reach.excess = excess_of(wall, candidate->facet, position, w);
    wall->deepest = fmax(wall->deepest, reach.excess);
    return note(scene->joint, &reach, error);
}

/* Displacement of a particle in this tick, as far as it is known. */
static fw_vec2 path_of(const fw_scene *scene, const scene_body *body, int entry, int particle)
{
    const int end = *scene_end_of_entry(body, entry);
    if (end >= 0) return scene->joint->joint_ends[end].displacement;
    if (body->gripped && body->gripped[particle])
        return scene->grips[body->gripped[particle] - 1].path;
    const int contact = scene_find_contact(body, particle);
    if (contact >= 0) return body->contacts[contact].solution.displacement;
    return fw_boundary_predictions(body->boundary)[entry].displacement;
}

static bool any_yields(const fw_scene *scene, fw_boundary_run run)
{
    for (int n = 0; n < run.facet_count; ++n)
        if (scene->walls[scene->candidates[run.facets[n]].facet->wall].yields) return true;
    return false;
}

/* May a facet that yields come to a particle on a path that long? Never says no where one passes
 * it, and depends on nothing but places. */
static bool any_comes_near(const fw_scene *scene, fw_boundary_run run, fw_vec2 position, fw_vec2 w)
{
    for (int n = 0; n < run.facet_count; ++n) {
        const fw_facet *facet = scene->candidates[run.facets[n]].facet;
        const scene_wall *wall = &scene->walls[facet->wall];
        const fw_vec2 from = fw_vec2_subtract(position, wall->place);
        const double room =
            fmax(fabs(w.x), fabs(w.y)) + fmax(fabs(wall->motion.x), fabs(wall->motion.y));
        const fw_box box = fw_box_grown(fw_box_around(from, from), room);
        const double away = fmax(fabs(wall->place.x), fabs(wall->place.y));
        if (wall->yields && fw_facet_meets_box(facet, box, away)) return true;
    }
    return false;
}

/* A particle that moves in the second tick is not where it was predicted, if other walls act on it
 * then. */
static bool is_left_to_walls(fw_scene *scene, const scene_body *body, fw_boundary_run run,
                             int entry)
{
    const fw_prediction *free = &fw_boundary_predictions(body->boundary)[entry];
    const int particle = fw_boundary_particles(body->boundary)[entry];
    const fw_vec2 position = fw_solid_position(body->solid, particle), w = free->displacement;
    if (!free->later || !any_comes_near(scene, run, position, w)) return false;
    if (body->memory && body->memory[particle].reaction > 0) return true;
    if (scene->soft_count > 0 && !scene_is_clear_of_soft(scene, position, w)) return true;
    scene_list_near(scene, run);
    for (int n = 0; n < scene->near_count; ++n) {
        const fw_candidate near = scene_candidate_for(scene, scene->near[n].number, true);
        if (fw_facet_is_passed(near.facet, fw_vec2_subtract(position, near.place),
                               fw_vec2_subtract(w, near.motion),
                               fmax(fabs(near.place.x), fabs(near.place.y))))
            return true;
    }
    return false;
}

static fw_status look_at_entry(fw_scene *scene, int b, int run, int entry, fw_error *error)
{
    const scene_body *body = &scene->bodies[b];
    const int particle = fw_boundary_particles(body->boundary)[entry];
    if (*scene_end_of_entry(body, entry) < 0 &&
        is_left_to_walls(scene, body, fw_boundary_observe_run(body->boundary, run), entry))
        return note(scene->joint,
                    &(scene_reach){.body = b, .entry = entry, .particle = particle, .facet = -1},
                    error);
    const fw_vec2 w = path_of(scene, body, entry, particle);
    const fw_boundary_run found = fw_boundary_observe_run(body->boundary, run);
    for (int n = 0; n < found.facet_count; ++n) {
        const scene_reach reach = {
            .body = b, .entry = entry, .particle = particle, .facet = found.facets[n]};
        if (scene->walls[scene->candidates[reach.facet].facet->wall].yields)
            FW_TRY(look_at(scene, reach, w, error));
    }
    return FW_OK;
}

/* Runs follow a curve through space that is another one after a restart. */
static int compare_reached(const void *left, const void *right)
{
    const scene_reach *a = left, *b = right;
    if (a->body != b->body) return a->body < b->body ? -1 : 1;
    if (a->particle != b->particle) return a->particle < b->particle ? -1 : 1;
    return (a->facet > b->facet) - (a->facet < b->facet);
}

static void sort_reached(scene_joint *joint)
{
    if (joint->reach_count > 1)
        qsort(joint->reached, (size_t)joint->reach_count, sizeof *joint->reached, compare_reached);
}

/* Ends may be pushed further than their runs foresaw. */
static fw_status extend_runs(fw_scene *scene, fw_error *error)
{
    for (int e = 0; e < scene->joint->end_count; ++e) {
        const scene_end *end = &scene->joint->ends[e];
        const fw_joint_end *moved = &scene->joint->joint_ends[e];
        if (end->body < 0) continue;
        fw_boundary *boundary = scene->bodies[end->body].boundary;
        if (end->entry >= fw_boundary_count(boundary)) continue;
        FW_TRY(fw_boundary_extend(boundary, scene->broadphase,
                                  fw_boundary_run_of(boundary, end->entry),
                                  fw_vec2_add(moved->position, moved->displacement), error));
    }
    return FW_OK;
}

static fw_status find_reached(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    joint->reach_count = 0;
    FW_TRY(extend_runs(scene, error));
    for (int w = 0; w < scene->wall_count; ++w) scene->walls[w].deepest = 0;
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int n = 0; n < fw_boundary_run_count(body->boundary); ++n) {
            const fw_boundary_run run = fw_boundary_observe_run(body->boundary, n);
            if (!any_yields(scene, run)) continue;
            for (int entry = run.first; entry < run.first + run.count; ++entry)
                FW_TRY(look_at_entry(scene, b, n, entry, error));
        }
    }
    sort_reached(joint);
    return FW_OK;
}

fw_status scene_add_reached(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    if (scene->piston_count == 0) return FW_OK;
    FW_TRY(find_reached(scene, error));
    for (int n = 0; n < joint->reach_count; ++n) {
        const scene_reach reach = joint->reached[n];
        int end;
        if (reach.facet < 0) {
            FW_TRY(scene_find_entry(scene, reach.body, reach.entry, &end, error));
            joint->changes += 1;
            continue;
        }
        const int w = scene->candidates[reach.facet].facet->wall;
        const double deepest = scene->walls[w].deepest;
        if (!reach.spring && deepest > 0 && reach.excess < (1 - TOGETHER) * deepest) continue;
        FW_TRY(scene_find_entry(scene, reach.body, reach.entry, &end, error));
        if (is_known(joint, end, reach.facet)) continue;
        FW_TRY(reach.spring ? scene_add_spring(scene, end, w, error)
                            : scene_add_facet(scene, end, reach.facet, false, error));
    }
    return FW_OK;
}

fw_status scene_add_rubbed_by_pistons(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    joint->reach_count = 0;
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int e = 0; body->memory_before && e < fw_boundary_count(body->boundary); ++e) {
            const int particle = fw_boundary_particles(body->boundary)[e];
            const fw_contact_memory *before = &body->memory_before[particle];
            if (before->facet == 0 || !(before->reaction > 0)) continue;
            const scene_reach reach = {
                .body = b, .entry = e, .particle = particle, .facet = before->facet - 1};
            if ((body->gripped && body->gripped[particle]) ||
                scene->walls[scene->candidates[reach.facet].facet->wall].yields)
                FW_TRY(note(joint, &reach, error));
        }
    }
    sort_reached(joint);
    for (int n = 0; n < joint->reach_count; ++n) {
        const scene_reach reach = joint->reached[n];
        int end;
        FW_TRY(scene_find_entry(scene, reach.body, reach.entry, &end, error));
    }
    return FW_OK;
}

/* --- where that takes them --- */

fw_status scene_follow_ends(fw_scene *scene, fw_error *error)
{
    bool moved = false;
    for (int w = 0; w < scene->wall_count && scene->piston_count > 0; ++w) {
        scene_wall *wall = &scene->walls[w];
        if (!wall->yields || wall->end < 0) continue;
        wall->motion = scene->joint->joint_ends[wall->end].displacement;
        FW_TRY(check_motion(scene, wall, error));
        moved = true;
    }
    if (!moved) return FW_OK;
    for (int f = 0; f < scene->facet_count; ++f) {
        const scene_wall *wall = &scene->walls[scene->candidates[f].facet->wall];
        if (wall->yields) scene->candidates[f].motion = wall->motion;
    }
    return scene_find_contacts(scene, error);
}

void scene_push_piston(scene_wall *wall, fw_vec2 position, fw_vec2 force)
{
    const fw_vec2 middle = fw_vec2_add(
        wall->place, fw_vec2_scale(0.5, fw_vec2_add(wall->bounds.low, wall->bounds.high)));
    if (!wall->piston) return;
    wall->push = fw_vec2_subtract(wall->push, force);
    wall->torque -= fw_vec2_cross(fw_vec2_subtract(position, middle), force);
}

void scene_advance_pistons(fw_scene *scene)
{
    const double start = scene_step_start(scene), length = scene_step_length(scene);
    if (scene->ticks_per_step == 2 && !scene_is_second_tick(scene)) return;
    scene_push_met(scene);
    for (int w = 0; w < scene->wall_count; ++w) {
        const scene_wall *wall = &scene->walls[w];
        const double work = scene->ledgers[w].work - wall->work_before;
        if (wall->piston)
            fw_piston_advance(wall->piston, wall->motion, wall->push, wall->met, -work,
                              wall->torque, start, length);
    }
}
