/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_joint.c - rows of bodies and pistons that touch, with the walls that their particles touch
 * at the same time, from the first row to the ledger. State: ledgers of contact.
 * Start reading at scene_add_row(). */
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- rows --- */

int scene_find_row(const scene_joint *joint, int end, const scene_row *row)
{
    for (int n = joint->ends[end].row; n >= 0; n = joint->rows[n].next) {
        const scene_row *known = &joint->rows[n];
        if (known->facet != row->facet) continue;
        if (row->facet >= 0) return n;
        if (known->body == row->body && known->from == row->from && known->to == row->to) return n;
    }
    return -1;
}

fw_status scene_append_row(fw_scene *scene, int owner, const scene_row *row,
                           const fw_joint_row *what, fw_error *error)
{
    scene_joint *joint = scene->joint;
    int mover[3] = {0};
    fw_vec2 offset[3] = {{0, 0}, {0, 0}, {0, 0}};
    for (int k = 0; k < fw_joint_end_count(what); ++k)
        FW_TRY(scene_find_mover(scene, what->end[k], &mover[k], &offset[k], error));
    if (joint->row_count == joint->row_capacity) {
        const size_t capacity = 2 * (size_t)joint->row_capacity + 64;
        scene_row *rows = realloc(joint->rows, capacity * sizeof *rows);
        if (rows) joint->rows = rows;
        fw_joint_row *joint_rows = realloc(joint->joint_rows, capacity * sizeof *joint_rows);
        if (joint_rows) joint->joint_rows = joint_rows;
        if (!rows || !joint_rows) return fw_fail_memory(error, "the contact of bodies");
        joint->row_capacity = (int)capacity;
    }
    scene_end *end = &joint->ends[owner];
    joint->rows[joint->row_count] = *row;
    joint->rows[joint->row_count].next = end->row;
    fw_joint_row *made = &joint->joint_rows[joint->row_count];
    *made = *what;
    memcpy(made->end, mover, sizeof mover);
    memcpy(made->offset, offset, sizeof offset);
    made->fresh = true;
    end->row = joint->row_count++;
    joint->changes += 1;
    return FW_OK;
}

/* A wall holds back along its normal; one that sticks, along its tangent both ways as well. */
static fw_status add_wall(fw_scene *scene, int end, int number, bool open, fw_error *error)
{
    scene_joint *joint = scene->joint;
    const fw_candidate candidate = scene_candidate_for(scene, number, joint->ends[end].later);
    const fw_facet *facet = candidate.facet;
    const bool borne = scene->walls[facet->wall].yields;
    int piston = 0;
    if (borne) FW_TRY(scene_find_piston(scene, facet->wall, &piston, error));
    const fw_vec2 at = fw_vec2_subtract(joint->joint_ends[end].position, candidate.place);
    const bool curved = fw_facet_is_curved(facet);
    fw_joint_row what = {.kind = curved ? FW_JOINT_ROUND : FW_JOINT_PLANE,
                         .end = {end, piston},
                         .borne = borne,
                         .normal = fw_facet_normal(facet, fw_vec2_subtract(at, facet->a)),
                         .centre = fw_vec2_add(facet->a, candidate.place),
                         .inside = curved && facet->side == FW_INSIDE,
                         .motion = candidate.motion,
                         .behind = fmax(0, -fw_facet_gap(facet, at)),
                         .open = open,
                         .rub = scene_take_wall_rub(scene, end, number)};
    const scene_row row = {.facet = number};
    FW_TRY(scene_append_row(scene, end, &row, &what, error));
    joint->ends[end].wall_rows += 1;
    if (candidate.surface.law != FW_STICK) return FW_OK;
    what.kind = FW_JOINT_PLANE;
    what.behind = 0;
    what.both = true;
    what.normal = fw_vec2_turn(what.normal);
    return scene_append_row(scene, end, &row, &what, error);
}

/* Whether the row was there already. It is closed, if `open` is not asked for. */
static bool close_known(scene_joint *joint, int end, const scene_row *row, bool open)
{
    const int known = scene_find_row(joint, end, row);
    if (known < 0) return false;
    fw_joint_row *there = &joint->joint_rows[known];
    if (!there->open || open) return true;
    there->open = false;
    there->fresh = true;
    joint->changes += 1;
    return true;
}

fw_status scene_add_facet(fw_scene *scene, int end, int facet, bool open, fw_error *error)
{
    const scene_row row = {.facet = facet};
    if (close_known(scene->joint, end, &row, open)) return FW_OK;
    return add_wall(scene, end, facet, open, error);
}

fw_status scene_add_spring(fw_scene *scene, int end, int wall, fw_error *error)
{
    const scene_row row = {.facet = scene->walls[wall].first_facet};
    int piston;
    FW_TRY(scene_find_piston(scene, wall, &piston, error));
    const fw_joint_row what = {.kind = FW_JOINT_SPRING, .end = {end, piston}};
    return scene_append_row(scene, end, &row, &what, error);
}

fw_status scene_add_row(fw_scene *scene, const scene_row *row, fw_error *error)
{
    scene_joint *joint = scene->joint;
    int end, from, to;
    FW_TRY(scene_find_end(scene, row->point_body, row->point, &end, error));
    if (close_known(joint, end, row, false)) return FW_OK;
    FW_TRY(scene_find_end(scene, row->body, row->from, &from, error));
    FW_TRY(scene_find_end(scene, row->body, row->to, &to, error));
    fw_joint_row what = {.kind = from == to ? FW_JOINT_POINT : FW_JOINT_SEGMENT,
                         .end = {end, from, to},
                         .distance = scene_distance_between(scene, row->point_body, row->body)};
    if (what.kind == FW_JOINT_SEGMENT) what.rub = scene_take_rub(scene, row, end);
    return scene_append_row(scene, end, row, &what, error);
}

/* Walls that the end passes on its present path. Where it is pushed further than its run foresaw,
 * the list of the run is extended first. (Pistons that yield see scene_add_reached().) */
static fw_status add_walls_of(fw_scene *scene, int number, fw_error *error)
{
    const scene_end *end = &scene->joint->ends[number];
    if (end->body < 0 || end->grip >= 0) return FW_OK; /* see scene_add_gripped() */
    scene_body *body = &scene->bodies[end->body];
    if (!body->boundary || end->entry >= fw_boundary_count(body->boundary)) return FW_OK;
    const bool later = end->later;
    const fw_vec2 position = scene->joint->joint_ends[number].position;
    const fw_vec2 w = scene->joint->joint_ends[number].displacement;
    const int run = fw_boundary_run_of(body->boundary, end->entry);
    FW_TRY(fw_boundary_extend(body->boundary, scene->broadphase, run, fw_vec2_add(position, w),
                              error));
    scene_list_near(scene, fw_boundary_observe_run(body->boundary, run));
    for (int n = 0; n < scene->near_count; ++n) {
        const fw_candidate candidate = scene_candidate_for(scene, scene->near[n].number, later);
        const double away = fmax(fabs(candidate.place.x), fabs(candidate.place.y));
        if (scene->joint->ends[number].wall_rows == FW_WALL_CONTACTS) break;
        if (fw_facet_is_passed(candidate.facet, fw_vec2_subtract(position, candidate.place),
                               fw_vec2_subtract(w, candidate.motion), away))
            FW_TRY(scene_add_facet(scene, number, candidate.number, false, error));
    }
    return FW_OK;
}

fw_status scene_add_passed_walls(fw_scene *scene, fw_error *error)
{
    if (scene->wall_count == 0) return FW_OK;
    for (int e = 0; e < scene->joint->end_count; ++e) FW_TRY(add_walls_of(scene, e, error));
    return FW_OK;
}

/* --- the solution --- */

static double size_of(fw_vec2 v)
{
    return fabs(v.x) + fabs(v.y);
}

/* What rounding left along the normal of a wall is taken out, as for a particle that meets walls
 * alone: on a wall along an axis it stays where it is to the last bit. */
static void put_on_walls(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    for (int n = 0; n < joint->row_count; ++n) {
        const fw_joint_row *row = &joint->joint_rows[n];
        if (row->kind != FW_JOINT_PLANE || row->lambda == 0 || joint->rows[n].met) continue;
        fw_joint_end *end = &joint->joint_ends[row->end[0]];
        const double excess = fw_joint_motion(row, joint->joint_ends) - row->bound;
        double size = size_of(end->displacement) + fabs(row->bound);
        if (row->borne) size += size_of(end->free) + size_of(joint->joint_ends[row->end[1]].free);
        if (fabs(excess) > 1e-14 * size) continue;
        end->displacement = fw_vec2_subtract(end->displacement, fw_vec2_scale(excess, row->normal));
    }
}

fw_status scene_solve_joint(fw_scene *scene, fw_error *error)
{
    scene_joint *joint = scene->joint;
    const fw_joint_springs springs = scene_springs(scene);
    fw_joint_outcome outcome;
    FW_TRY(fw_joint_solve(joint->solver, joint->joint_ends, joint->end_count, joint->joint_rows,
                          joint->row_count, scene->soft_count > 0 ? &springs : NULL, &outcome,
                          error));
    put_on_walls(scene);
    scene_follow_grips(scene);
    for (int e = 0; e < joint->end_count; ++e)
        if (joint->ends[e].point >= 0)
            scene->bodies[joint->ends[e].body].edge->paths[joint->ends[e].point] =
                joint->joint_ends[e].displacement;
    joint->outcome.islands += outcome.islands;
    joint->outcome.iterations += outcome.iterations;
    joint->outcome.unconverged += outcome.unconverged;
    joint->outcome.residual = fmax(joint->outcome.residual, outcome.residual);
    return scene_follow_ends(scene, error);
}

/* --- what becomes of it --- */

/* Adds the row's forces to what its wall does to the particle. */
static void add_wall_contact(const fw_scene *scene, fw_contact_solution *solution,
                             const scene_row *row, const fw_joint_row *solved)
{
    const int wall = scene->candidates[row->facet].facet->wall;
    const fw_joint_rub *rub = &solved->rub;
    const fw_vec2 motion = scene->walls[wall].yields ? scene->walls[wall].motion : solved->motion;
    const fw_vec2 force = fw_vec2_add(fw_vec2_scale(solved->lambda, solved->weight[0]),
                                      fw_vec2_scale(rub->traction, rub->weight[0]));
    int k = 0;
    while (k < solution->wall_contact_count && solution->wall_contact[k].wall != wall) ++k;
    if (k == FW_WALL_CONTACTS) {
        solution->unresolved = true; /* the books would lack its force: that is counted */
        return;
    }
    fw_wall_contact *contact = &solution->wall_contact[k];
    if (k == solution->wall_contact_count)
        solution->wall_contact[solution->wall_contact_count++] = (fw_wall_contact){.wall = wall};
    contact->force = fw_vec2_add(contact->force, force);
    contact->work += fw_vec2_dot(force, motion);
    contact->spring = solved->kind == FW_JOINT_SPRING;
    if (!(rub->coefficient > 0)) return;
    const double cone = fw_joint_cone(solved);
    contact->dissipated -= rub->traction * rub->slip;
    contact->cone = fmax(contact->cone, cone);
    contact->beyond = fmax(contact->beyond, fabs(rub->traction) - cone * (1 + 1e-9));
}

/* Walls left it no room: some row is passed by more than rounding. */
static bool passes(const fw_scene *scene, const scene_row *row, const fw_joint_row *solved)
{
    const fw_candidate *candidate = &scene->candidates[row->facet];
    const double away = fmax(fabs(candidate->place.x), fabs(candidate->place.y));
    if (solved->open || solved->both || solved->kind == FW_JOINT_SPRING) return false;
    return fw_joint_motion(solved, scene->joint->joint_ends) - solved->bound <
           -fw_facet_tolerance(candidate->facet, away);
}

static void list_facet(fw_row_list *rows, int facet)
{
    for (int k = 0; k < rows->count; ++k)
        if (rows->facet[k] == facet) return;
    if (rows->count < FW_WALL_CONTACTS) rows->facet[rows->count++] = facet;
}

/* Rows of an end stand in a list from the latest to the first. */
fw_contact_solution scene_solution_of(const fw_scene *scene, int number)
{
    const scene_joint *joint = scene->joint;
    const fw_joint_end *end = &joint->joint_ends[number];
    fw_contact_solution solution = {.displacement = end->displacement, .force = end->force};
    solution.held = end->force.x != 0 || end->force.y != 0;
    for (int n = joint->ends[number].row; n >= 0; n = joint->rows[n].next) {
        const fw_joint_row *solved = &joint->joint_rows[n];
        if (joint->rows[n].facet < 0) continue;
        list_facet(&solution.rows, joint->rows[n].facet);
        solution.unresolved |= passes(scene, &joint->rows[n], solved);
        if (solved->lambda != 0 || solved->rub.traction != 0)
            add_wall_contact(scene, &solution, &joint->rows[n], solved);
    }
    return solution;
}

scene_contact *scene_hand_over_end(fw_scene *scene, int number)
{
    const scene_joint *joint = scene->joint;
    const scene_end *end = &joint->ends[number];
    scene_body *body = &scene->bodies[end->body];
    const fw_sym2 mobility = joint->joint_ends[number].mobility;
    scene_contact *contact =
        &body->contacts[end->contact >= 0 ? end->contact : body->contact_count++];
    body->unsorted |= end->contact < 0;
    *contact = (scene_contact){.particle = end->particle,
                               .entry = end->entry,
                               .solution = scene_solution_of(scene, number),
                               .soft = end->soft,
                               .soft_path = end->soft_path,
                               .mobility = fmax(mobility.xx, mobility.yy)};
    if (body->memory) scene_remember_wall(scene, number);
    return contact;
}

void scene_hand_over_joint(fw_scene *scene)
{
    const scene_joint *joint = scene->joint;
    for (int e = 0; e < joint->end_count; ++e)
        if (joint->ends[e].body >= 0 && joint->ends[e].grip < 0 && !joint->ends[e].later &&
            joint->joint_ends[e].mobility.xx != 0)
            (void)scene_hand_over_end(scene, e);
        else if (joint->ends[e].grip >= 0 && scene->bodies[joint->ends[e].body].memory_before)
            scene_remember_wall(scene, e);
    for (int b = 0; b < scene->body_count; ++b)
        if (scene->bodies[b].unsorted) scene_sort_contacts(&scene->bodies[b]);
}

/* A force on a particle that moves once in a step of two ticks acts for both. */
static void book_row(fw_scene *scene, int number)
{
    const scene_joint *joint = scene->joint;
    const scene_row *about = &joint->rows[number];
    const fw_joint_row *row = &joint->joint_rows[number];
    const int bodies[3] = {about->point_body, about->body, about->body};
    const int points[3] = {about->point, about->from, about->to};
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const scene_body *body = &scene->bodies[bodies[k]];
        fw_body_ledger *ledger =
            &joint->bodies[joint->slots[bodies[k]] +
                           scene_part_of(body->solid, body->edge->contour.particles[points[k]])];
        ledger->force = fw_vec2_add(ledger->force, fw_vec2_scale(row->lambda, row->weight[k]));
        if (row->rub.traction != 0)
            ledger->force =
                fw_vec2_add(ledger->force, fw_vec2_scale(row->rub.traction, row->rub.weight[k]));
        if (k < 2 && row->lambda > 0) ledger->contacts += 1;
    }
}

static void book_impulses(fw_scene *scene)
{
    for (int b = 0; b < scene->joint->slot_count; ++b) {
        fw_body_ledger *ledger = &scene->joint->bodies[b];
        ledger->impulse = fw_vec2_add(ledger->impulse, fw_vec2_scale(scene->tick, ledger->force));
    }
}

void scene_book_joint(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    if (!joint) return;
    bool touches = false;
    if (scene_is_second_tick(scene)) {
        book_impulses(scene);
        return;
    }
    for (int b = 0; b < joint->slot_count; ++b) {
        fw_body_ledger *ledger = &joint->bodies[b];
        ledger->reaction = fw_vec2_scale(0.5, ledger->force);
        ledger->force = (fw_vec2){0, 0};
        ledger->contacts = 0;
    }
    for (int n = 0; n < joint->row_count; ++n) {
        const fw_joint_row *row = &joint->joint_rows[n];
        if (joint->rows[n].facet >= 0 || !(row->lambda > 0 || row->rub.traction != 0)) continue;
        book_row(scene, n);
        touches = true;
    }
    for (int b = 0; b < joint->slot_count; ++b) {
        fw_body_ledger *ledger = &joint->bodies[b];
        ledger->reaction = fw_vec2_add(ledger->reaction, fw_vec2_scale(0.5, ledger->force));
    }
    book_impulses(scene);
    scene_remember_rubbing(scene);
    joint->ledger.ticks += touches;
    joint->ledger.iterations += joint->outcome.iterations;
    joint->ledger.unconverged += joint->outcome.unconverged > 0;
    joint->ledger.residual = fmax(joint->ledger.residual, joint->outcome.residual);
}

void scene_book_on_grips(fw_scene *scene, int body)
{
    for (int n = 0; scene->joint && n < scene->grip_count; ++n) {
        const scene_grip *grip = &scene->grips[n];
        if (grip->end < 0 || grip->body != body) continue;
        const fw_joint_end *end = &scene->joint->joint_ends[grip->end];
        fw_grip_book_contact(grip->grip, end->force, end->displacement, scene->tick);
    }
}

const fw_body_ledger *fw_scene_body_ledger(const fw_scene *scene, int body, int part)
{
    static const fw_body_ledger untouched;
    return scene->joint ? &scene->joint->bodies[scene->joint->slots[body] + part] : &untouched;
}

const fw_contact_ledger *fw_scene_contact_ledger(const fw_scene *scene)
{
    static const fw_contact_ledger none;
    return scene->joint ? &scene->joint->ledger : &none;
}
