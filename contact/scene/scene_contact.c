/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_contact.c - the contact phase of a step: from runs of candidates to constraints. State:
 * that of the scene (scene_parts.h). Start reading at scene_find_contacts(), then
 * scene_constrain_bodies(). */
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>

/* A colour of an automaton moves in every second tick only, and then for both: it meets the walls
 * where they were when it moved last. Otherwise a wall would run over a colour that rests. (A
 * piston moves once in a step: both colours meet it on the whole of its way.) */
void scene_follow_wall(fw_scene *scene, int w, int ticks)
{
    const double now = fw_scene_time(scene);
    const double since = fmax(0, now - (ticks - 1) * scene->tick);
    scene_wall *wall = &scene->walls[w];
    if (wall->piston) {
        wall->place = fw_piston_observe_ledger(wall->piston)->displacement;
        return;
    }
    wall->place = fw_wall_displacement(wall->wall, since);
    wall->motion =
        fw_vec2_subtract(fw_wall_displacement(wall->wall, now + scene->tick), wall->place);
}

/* Place, motion and friction of all facets in this tick for that body. */
static void place_candidates(fw_scene *scene, int body)
{
    const int ticks = scene->bodies[body].solid->model->ticks_per_step;
    for (int w = 0; w < scene->wall_count; ++w) scene_follow_wall(scene, w, ticks);
    for (int f = 0; f < scene->facet_count; ++f) {
        fw_candidate *candidate = &scene->candidates[f];
        candidate->place = scene->walls[candidate->facet->wall].place;
        candidate->motion = scene->walls[candidate->facet->wall].motion;
        scene_take_surface(scene, body, &candidate->surface);
    }
}

void scene_predict_boundary(const fw_scene *scene, scene_body *body)
{
    const int *particles = fw_boundary_particles(body->boundary);
    const int count = fw_boundary_count(body->boundary);
    fw_prediction *predictions = fw_boundary_predictions(body->boundary);
    if (scene_pistons_take_steps(scene) && !scene_is_second_tick(scene))
        scene_predict_points(body->solid, particles, count, predictions);
    else
        fw_solid_predict(body->solid, particles, count, predictions);
}

static fw_status refresh_boundaries(fw_scene *scene, scene_body *body, fw_error *error)
{
    if (body->boundary_revision != body->solid->boundary_revision) {
        fw_boundary_destroy(body->boundary);
        body->boundary = NULL;
        FW_TRY(fw_boundary_create(&body->boundary, body->solid, error));
        body->boundary_revision = body->solid->boundary_revision;
        scene_predict_boundary(scene, body);
    }
    return fw_boundary_refresh(body->boundary, body->solid, scene->broadphase, error);
}

fw_status scene_find_contacts(fw_scene *scene, fw_error *error)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        if (!fw_wall_moves(scene->walls[w].wall)) continue;
        scene_follow_wall(scene, w, scene->ticks_per_step);
        /* Both ticks are one problem. */
        if (scene->joint && scene->ticks_per_step == 2 && !scene->walls[w].piston) {
            const fw_vec2 place = scene->walls[w].place;
            scene_follow_wall_later(scene, w);
            scene->walls[w].motion =
                fw_vec2_subtract(fw_vec2_add(scene->walls[w].place, scene->walls[w].motion), place);
            scene->walls[w].place = place;
        }
        fw_broadphase_move_wall(scene->broadphase, w, scene->walls[w].place,
                                scene->walls[w].motion);
    }
    for (int b = 0; b < scene->body_count && scene->wall_count > 0; ++b)
        FW_TRY(refresh_boundaries(scene, &scene->bodies[b], error));
    return FW_OK;
}

static int compare_contacts(const void *left, const void *right)
{
    const scene_contact *a = left, *b = right;
    return (a->particle > b->particle) - (a->particle < b->particle);
}

void scene_sort_contacts(scene_body *body)
{
    qsort(body->contacts, (size_t)body->contact_count, sizeof *body->contacts, compare_contacts);
    body->unsorted = false;
}

/* Springs are no constraints, and pistons that yield are ends of the joint contact. */
void scene_list_near(fw_scene *scene, fw_boundary_run run)
{
    scene->near_count = 0;
    for (int n = 0; n < run.facet_count; ++n) {
        const fw_candidate *candidate = &scene->candidates[run.facets[n]];
        if (candidate->surface.law != FW_PENALTY && !scene->walls[candidate->facet->wall].yields)
            scene->near[scene->near_count++] = *candidate;
    }
}

/* No wall can hold or rub this particle. */
static bool has_no_rows(const fw_scene *scene, const scene_body *body)
{
    return scene->near_count == 0 && !body->memory;
}

/* One particle of a run against hard walls. Where they push it further than its free path, the list
 * is extended and the particle solved again, from the same memory. */
static fw_status constrain_hard(fw_scene *scene, scene_body *body, int run_number, int entry,
                                const fw_prediction *free, fw_contact_solution *solution,
                                fw_error *error)
{
    const int particle = fw_boundary_particles(body->boundary)[entry];
    const fw_vec2 position = fw_solid_position(body->solid, particle);
    fw_contact_memory *memory = body->memory ? &body->memory[particle] : NULL;
    const fw_contact_memory before = memory ? *memory : (fw_contact_memory){0};
    if (has_no_rows(scene, body)) {
        *solution = (fw_contact_solution){.displacement = free->displacement};
        return FW_OK;
    }
    for (;;) {
        fw_boundary_run run = fw_boundary_observe_run(body->boundary, run_number);
        *solution =
            fw_constrain(position, free, scene->near, scene->near_count, scene->candidates, memory);
        if (!solution->held) {
            solution->displacement = free->displacement;
            return FW_OK;
        }
        FW_TRY(fw_boundary_extend(body->boundary, scene->broadphase, run_number,
                                  fw_vec2_add(position, solution->displacement), error));
        fw_boundary_run extended = fw_boundary_observe_run(body->boundary, run_number);
        if (extended.facet_count == run.facet_count) return FW_OK;
        scene_list_near(scene, extended);
        if (memory) *memory = before;
    }
}

/* The path sets the push of soft walls, and the push sets the path: w = hard(w_p + A F(w)). F falls
 * with w by at most half the stiffness, so steps of 1/(1 + A K/2) end quickly. */
static fw_status constrain_entry(fw_scene *scene, scene_body *body, int run_number, int entry,
                                 fw_error *error)
{
    enum { ROUNDS = 60 };
    const int particle = fw_boundary_particles(body->boundary)[entry];
    const fw_vec2 position = fw_solid_position(body->solid, particle);
    fw_prediction free = fw_boundary_predictions(body->boundary)[entry];
    const fw_vec2 alone = free.displacement;
    if (has_no_rows(scene, body) && scene_is_clear_of_soft(scene, position, alone)) return FW_OK;
    const fw_contact_memory before = body->memory ? body->memory[particle] : (fw_contact_memory){0};
    scene_contact contact = {
        .particle = particle, .entry = entry, .mobility = fmax(free.mobility.xx, free.mobility.yy)};
    const double yielding = 0.5 * scene->soft_stiffness * contact.mobility;
    fw_vec2 w = alone;
    for (int round = 0; round < ROUNDS; ++round) {
        if (scene->soft_count > 0 && free.mobility.xx > 0)
            contact.soft = scene_soft_force(scene, position, w);
        contact.soft_path = w;
        free.displacement = fw_vec2_add(alone, fw_sym2_apply(free.mobility, contact.soft));
        if (round > 0 && body->memory) body->memory[particle] = before;
        FW_TRY(constrain_hard(scene, body, run_number, entry, &free, &contact.solution, error));
        const fw_vec2 change = fw_vec2_subtract(contact.solution.displacement, w);
        if (scene->soft_count == 0 ||
            fabs(change.x) + fabs(change.y) <= 4e-16 * (fabs(w.x) + fabs(w.y)))
            break;
        w = fw_vec2_add(w, fw_vec2_scale(1 / (1 + yielding), change));
    }
    if (contact.solution.held || contact.soft.x != 0 || contact.soft.y != 0)
        body->contacts[body->contact_count++] = contact;
    return FW_OK;
}

/* How well friction keeps to its law. */
static void book_friction(fw_scene *scene, scene_body *body, const scene_contact *contact)
{
    scene_record_rub_on_walls(scene, body, contact);
    for (int n = 0; n < contact->solution.wall_contact_count; ++n) {
        const fw_wall_contact *of = &contact->solution.wall_contact[n];
        scene_wall *wall = &scene->walls[of->wall];
        wall->cone = fmax(wall->cone, of->cone);
        wall->beyond = fmax(wall->beyond, of->beyond);
    }
    const fw_contact_memory *memory = body->memory ? &body->memory[contact->particle] : NULL;
    if (!memory || memory->facet == 0) return;
    fw_wall_ledger *ledger = &scene->ledgers[scene->candidates[memory->facet - 1].facet->wall];
    ledger->creep = fmax(ledger->creep, fabs(memory->crept));
}

/* The work on the particle is what the spring stored less, and what the piston's motion did. */
static void book_spring(fw_scene *scene, const scene_contact *contact,
                        const fw_wall_contact *spring, fw_vec2 position)
{
    const fw_vec2 w = contact->solution.displacement;
    const double stored = scene_stored_by(&scene->walls[spring->wall], position, w);
    fw_wall_ledger *ledger = &scene->ledgers[spring->wall];
    ledger->stored += stored;
    ledger->work += fw_vec2_dot(spring->force, w) + stored - spring->work;
}

/* A force acts on its particle for `ticks`, from one move to the next. */
static void book(fw_scene *scene, scene_body *body, const scene_contact *contact)
{
    const fw_contact_solution *solution = &contact->solution;
    const int ticks = body->solid->model->ticks_per_step;
    const fw_vec2 position = fw_solid_position(body->solid, contact->particle);
    if (contact->soft.x != 0 || contact->soft.y != 0)
        scene_book_soft(scene, contact, position, ticks);
    for (int n = 0; n < solution->wall_contact_count; ++n) {
        const fw_wall_contact *wall_contact = &solution->wall_contact[n];
        fw_wall_ledger *ledger = &scene->ledgers[wall_contact->wall];
        ledger->force = fw_vec2_add(ledger->force, fw_vec2_scale(ticks, wall_contact->force));
        ledger->work += wall_contact->work;
        scene_push_piston(&scene->walls[wall_contact->wall], position, wall_contact->force);
        if (wall_contact->spring) book_spring(scene, contact, wall_contact, position);
        ledger->dissipated += wall_contact->dissipated;
        bool counted = false;
        for (int m = 0; m < n; ++m) counted |= solution->wall_contact[m].wall == wall_contact->wall;
        ledger->contacts += !counted;
    }
    book_friction(scene, body, contact);
    scene->clock.unresolved += solution->unresolved;
}

/* What grips bear is no constraint on its particle, but is what the wall does all the same. */
static void book_gripped(fw_scene *scene)
{
    const scene_joint *joint = scene->joint;
    for (int e = 0; joint && e < joint->end_count; ++e) {
        const scene_end *end = &joint->ends[e];
        if (end->grip < 0 || end->row < 0) continue;
        const scene_contact contact = {.particle = end->particle,
                                       .entry = end->entry,
                                       .solution = scene_solution_of(scene, e)};
        book(scene, &scene->bodies[end->body], &contact);
    }
}

void scene_book_contacts(fw_scene *scene)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        scene->walls[w].force_before = scene->ledgers[w].force;
        scene->ledgers[w].force = (fw_vec2){0, 0};
        scene->ledgers[w].contacts = 0;
        scene->walls[w].cone = scene->walls[w].beyond = 0;
        if (scene_is_second_tick(scene)) continue;
        scene->walls[w].work_before = scene->ledgers[w].work;
        scene->walls[w].push = (fw_vec2){0, 0};
        scene->walls[w].torque = 0;
    }
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        for (int w = 0; w < scene->wall_count; ++w)
            scene_follow_wall(scene, w, body->solid->model->ticks_per_step);
        for (int n = 0; n < body->contact_count; ++n) book(scene, body, &body->contacts[n]);
    }
    book_gripped(scene);
}

static fw_status constrain_body(fw_scene *scene, scene_body *body, fw_error *error)
{
    body->contact_count = 0;
    if (scene->wall_count == 0) return FW_OK;
    for (int n = 0; n < fw_boundary_run_count(body->boundary); ++n) {
        fw_boundary_run run = fw_boundary_observe_run(body->boundary, n);
        if (run.facet_count == 0 && !body->memory && scene->soft_count == 0) continue;
        scene_list_near(scene, run);
        for (int entry = run.first; entry < run.first + run.count; ++entry) {
            if (body->gripped && body->gripped[fw_boundary_particles(body->boundary)[entry]])
                continue;
            if (fw_boundary_predictions(body->boundary)[entry].later) continue;
            FW_TRY(constrain_entry(scene, body, n, entry, error));
        }
    }
    /* Runs follow a curve through space that is another one after a restart; sums go by particle.
     */
    scene_sort_contacts(body);
    return FW_OK;
}

fw_status scene_constrain_bodies(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count; ++b) {
        place_candidates(scene, b);
        FW_TRY(constrain_body(scene, &scene->bodies[b], error));
    }
    return scene->joint ? scene_meet_bodies(scene, error) : FW_OK;
}

static int compare_constraints(const void *left, const void *right)
{
    const fw_constraint *a = left, *b = right;
    return (a->particle > b->particle) - (a->particle < b->particle);
}

/* Particles of each grip ascend, and often those of one grip follow those of another. */
static bool constraints_ascend(const scene_body *body)
{
    for (int n = 1; n < body->constraint_count; ++n)
        if (body->constraints[n - 1].particle > body->constraints[n].particle) return false;
    return true;
}

void scene_collect_constraints(fw_scene *scene, int number)
{
    scene_body *body = &scene->bodies[number];
    body->constraint_count = body->contact_count;
    for (int n = 0; n < body->contact_count; ++n) {
        const scene_contact *contact = &body->contacts[n];
        body->constraints[n] = (fw_constraint){contact->particle, contact->solution.displacement,
                                               fw_vec2_add(contact->solution.force, contact->soft)};
    }
    for (int n = 0; body->gripped && n < scene->grip_count; ++n) {
        if (scene->grips[n].body != number) continue;
        fw_grip *grip = scene->grips[n].grip;
        const fw_vec2 w = scene->joint
                              ? scene->grips[n].path
                              : fw_grip_displacement(grip, body->solid, fw_scene_time(scene));
        fw_grip_constrain(grip, body->solid, w, body->constraints + body->constraint_count);
        body->constraint_count += fw_grip_particle_count(grip);
    }
    if (body->gripped) {
        scene_book_on_grips(scene, number);
        if (!constraints_ascend(body))
            qsort(body->constraints, (size_t)body->constraint_count, sizeof *body->constraints,
                  compare_constraints);
    }
    scene_record_forces(scene, number);
}
