/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_joint.c - ends and rows of bodies that touch, with the walls that their particles touch at
 * the same time, from the first row to the ledger. State: ledgers of contact.
 * Start reading at scene_add_row(). */
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>

/* --- ends --- */

static fw_status reserve_end(scene_joint *joint, fw_error *error)
{
    if (joint->end_count < joint->end_capacity) return FW_OK;
    const size_t capacity = 2 * (size_t)joint->end_capacity + 64;
    scene_end *ends = realloc(joint->ends, capacity * sizeof *ends);
    if (ends) joint->ends = ends;
    fw_joint_end *joint_ends = realloc(joint->joint_ends, capacity * sizeof *joint_ends);
    if (joint_ends) joint->joint_ends = joint_ends;
    if (!ends || !joint_ends) return fw_fail_memory(error, "the contact of bodies");
    joint->end_capacity = (int)capacity;
    return FW_OK;
}

/* Contacts ascend by particle. */
int scene_find_contact(const scene_body *body, int particle)
{
    int low = 0, high = body->contact_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (body->contacts[middle].particle < particle)
            low = middle + 1;
        else
            high = middle;
    }
    return low < body->contact_count && body->contacts[low].particle == particle ? low : -1;
}

static int find_grip(const fw_scene *scene, int body, int particle)
{
    if (!scene->bodies[body].gripped || !scene->bodies[body].gripped[particle]) return -1;
    for (int n = 0; n < scene->grip_count; ++n) {
        const int *particles = fw_grip_particles(scene->grips[n].grip);
        const int count = fw_grip_particle_count(scene->grips[n].grip);
        for (int k = 0; scene->grips[n].body == body && k < count; ++k)
            if (particles[k] == particle) return n;
    }
    return -1;
}

/* Points that the boundary has come first in `entry`, in its own order; the others, which meet no
 * walls, follow. */
static void number_entries(scene_body *body)
{
    scene_edge *edge = body->edge;
    const int count = body->boundary ? fw_boundary_count(body->boundary) : 0;
    const int *particles = body->boundary ? fw_boundary_particles(body->boundary) : NULL;
    int next = count;
    if (edge->entries_revision == body->boundary_revision) return;
    for (int point = 0; point < edge->contour.point_count; ++point) edge->entry[point] = -1;
    for (int entry = 0; entry < count; ++entry) {
        const int point = edge->contour.points[particles[entry]];
        if (point >= 0) edge->entry[point] = entry;
    }
    for (int point = 0; point < edge->contour.point_count; ++point)
        if (edge->entry[point] < 0) edge->entry[point] = next++;
    edge->entries_revision = body->boundary_revision;
}

/* Rows that walls alone had, or that earlier tries of this tick found. */
static fw_status add_known_walls(fw_scene *scene, int end, fw_error *error)
{
    const scene_end *e = &scene->joint->ends[end];
    const scene_body *body = &scene->bodies[e->body];
    const fw_row_list *rows = NULL;
    if (e->grip >= 0) return FW_OK;
    if (e->contact >= 0)
        rows = &body->contacts[e->contact].solution.rows;
    else if (body->rows)
        rows = &body->rows[body->edge->entry[e->point]];
    for (int k = 0; rows && k < rows->count; ++k) {
        const scene_row row = {
            .facet = rows->facet[k], .point_body = e->body, .point = e->point, .next = -1};
        FW_TRY(scene_add_row(scene, &row, error));
    }
    return FW_OK;
}

fw_status scene_find_end(fw_scene *scene, int body, int point, int *end, fw_error *error)
{
    scene_joint *joint = scene->joint;
    scene_body *of = &scene->bodies[body];
    *end = of->edge->end[point];
    if (*end >= 0) return FW_OK;
    FW_TRY(reserve_end(joint, error));
    number_entries(of);
    const int particle = of->edge->contour.particles[point];
    const fw_prediction *free = &of->edge->predictions[point];
    *end = of->edge->end[point] = joint->end_count++;
    scene_end *made = &joint->ends[*end];
    *made = (scene_end){.body = body,
                        .point = point,
                        .contact = free->later ? -1 : scene_find_contact(of, particle),
                        .grip = find_grip(scene, body, particle),
                        .row = -1,
                        .later = free->later};
    fw_joint_end *joint_end = &joint->joint_ends[*end];
    *joint_end = (fw_joint_end){.position = fw_solid_position(of->solid, particle),
                                .free = free->displacement,
                                .unled = free->displacement,
                                .inertial = free->inertial,
                                .mobility = free->mobility,
                                .displacement = of->edge->paths[point]};
    if (made->grip >= 0) {
        joint_end->free = joint_end->inertial = of->edge->paths[point];
        joint_end->mobility = (fw_sym2){0, 0, 0};
    }
    FW_TRY(add_known_walls(scene, *end, error));
    return scene_couple_end(scene, *end, error);
}

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

static fw_status append_row(scene_joint *joint, const scene_row *row, const fw_joint_row *what,
                            fw_error *error)
{
    if (joint->row_count == joint->row_capacity) {
        const size_t capacity = 2 * (size_t)joint->row_capacity + 64;
        scene_row *rows = realloc(joint->rows, capacity * sizeof *rows);
        if (rows) joint->rows = rows;
        fw_joint_row *joint_rows = realloc(joint->joint_rows, capacity * sizeof *joint_rows);
        if (joint_rows) joint->joint_rows = joint_rows;
        if (!rows || !joint_rows) return fw_fail_memory(error, "the contact of bodies");
        joint->row_capacity = (int)capacity;
    }
    scene_end *end = &joint->ends[what->end[0]];
    joint->rows[joint->row_count] = *row;
    joint->rows[joint->row_count].next = end->row;
    joint->joint_rows[joint->row_count] = *what;
    joint->joint_rows[joint->row_count].fresh = true;
    end->row = joint->row_count++;
    joint->changes += 1;
    return FW_OK;
}

/* A wall holds back along its normal; one that sticks, along its tangent both ways as well. (A wall
 * with Coulomb friction does not rub a particle that touches another body in the same tick.) */
static fw_status add_wall(fw_scene *scene, const scene_row *row, int end, fw_error *error)
{
    scene_joint *joint = scene->joint;
    const fw_candidate candidate = scene_candidate_for(scene, row->facet, joint->ends[end].later);
    const fw_facet *facet = candidate.facet;
    const fw_vec2 at = fw_vec2_subtract(joint->joint_ends[end].position, candidate.place);
    const bool curved = fw_facet_is_curved(facet);
    fw_joint_row what = {.kind = curved ? FW_JOINT_ROUND : FW_JOINT_PLANE,
                         .end = {end},
                         .normal = fw_facet_normal(facet, fw_vec2_subtract(at, facet->a)),
                         .centre = fw_vec2_add(facet->a, candidate.place),
                         .inside = curved && facet->side == FW_INSIDE,
                         .motion = candidate.motion,
                         .behind = fmax(0, -fw_facet_gap(facet, at))};
    FW_TRY(append_row(joint, row, &what, error));
    joint->ends[end].wall_rows += 1;
    if (candidate.surface.law != FW_STICK) return FW_OK;
    what.kind = FW_JOINT_PLANE;
    what.behind = 0;
    what.normal = fw_vec2_turn(what.normal);
    FW_TRY(append_row(joint, row, &what, error));
    what.normal = fw_vec2_scale(-1, what.normal);
    return append_row(joint, row, &what, error);
}

fw_status scene_add_row(fw_scene *scene, const scene_row *row, fw_error *error)
{
    scene_joint *joint = scene->joint;
    int end, from, to;
    FW_TRY(scene_find_end(scene, row->point_body, row->point, &end, error));
    const int known = scene_find_row(joint, end, row);
    if (known >= 0) {
        fw_joint_row *open = &joint->joint_rows[known];
        if (!open->open) return FW_OK;
        open->open = false;
        open->fresh = true;
        joint->changes += 1;
        return FW_OK;
    }
    if (row->facet >= 0) return add_wall(scene, row, end, error);
    FW_TRY(scene_find_end(scene, row->body, row->from, &from, error));
    FW_TRY(scene_find_end(scene, row->body, row->to, &to, error));
    fw_joint_row what = {.kind = from == to ? FW_JOINT_POINT : FW_JOINT_SEGMENT,
                         .end = {end, from, to}};
    if (what.kind == FW_JOINT_SEGMENT) what.rub = scene_take_rub(scene, row, end);
    return append_row(joint, row, &what, error);
}

/* Walls that the end passes on its present path. Where it is pushed further than its run foresaw,
 * the list of the run is extended first. */
static fw_status add_walls_of(fw_scene *scene, int number, fw_error *error)
{
    const scene_end *end = &scene->joint->ends[number];
    scene_body *body = &scene->bodies[end->body];
    const int entry = body->edge->entry[end->point];
    if (end->grip >= 0 || !body->boundary || entry >= fw_boundary_count(body->boundary))
        return FW_OK;
    const bool later = end->later;
    const fw_vec2 position = scene->joint->joint_ends[number].position;
    const fw_vec2 w = body->edge->paths[end->point];
    const int run = fw_boundary_run_of(body->boundary, entry);
    FW_TRY(fw_boundary_extend(body->boundary, scene->broadphase, run, fw_vec2_add(position, w),
                              error));
    scene_list_near(scene, fw_boundary_observe_run(body->boundary, run));
    for (int n = 0; n < scene->near_count; ++n) {
        const fw_candidate candidate = scene_candidate_for(scene, scene->near[n].number, later);
        const double away = fmax(fabs(candidate.place.x), fabs(candidate.place.y));
        if (scene->joint->ends[number].wall_rows == FW_WALL_CONTACTS) break;
        if (!fw_facet_is_passed(candidate.facet, fw_vec2_subtract(position, candidate.place),
                                fw_vec2_subtract(w, candidate.motion), away))
            continue;
        const scene_row row = {.facet = candidate.number,
                               .point_body = scene->joint->ends[number].body,
                               .point = scene->joint->ends[number].point};
        FW_TRY(scene_add_row(scene, &row, error));
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

/* What rounding left along the normal of a wall is taken out, as for a particle that meets walls
 * alone: on a wall along an axis it stays where it is to the last bit. */
static void put_on_walls(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    for (int n = 0; n < joint->row_count; ++n) {
        const fw_joint_row *row = &joint->joint_rows[n];
        if (row->kind != FW_JOINT_PLANE || !(row->lambda > 0)) continue;
        fw_vec2 *w = &joint->joint_ends[row->end[0]].displacement;
        const double excess = fw_vec2_dot(row->normal, *w) - row->bound;
        if (fabs(excess) > 1e-14 * (fabs(w->x) + fabs(w->y) + fabs(row->bound))) continue;
        *w = fw_vec2_subtract(*w, fw_vec2_scale(excess, row->normal));
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
    for (int e = 0; e < joint->end_count; ++e)
        scene->bodies[joint->ends[e].body].edge->paths[joint->ends[e].point] =
            joint->joint_ends[e].displacement;
    joint->outcome.islands += outcome.islands;
    joint->outcome.iterations += outcome.iterations;
    joint->outcome.unconverged += outcome.unconverged;
    joint->outcome.residual = fmax(joint->outcome.residual, outcome.residual);
    return FW_OK;
}

/* --- what becomes of it --- */

/* Adds the row's force to what its wall does to the particle. */
static void add_wall_contact(const fw_scene *scene, fw_contact_solution *solution,
                             const scene_row *row, const fw_joint_row *solved, fw_sym2 mobility)
{
    const int wall = scene->candidates[row->facet].facet->wall;
    const fw_vec2 normal = solved->weight[0];
    const fw_vec2 force = fw_vec2_scale(solved->lambda, normal);
    int k = 0;
    while (k < solution->wall_contact_count && solution->wall_contact[k].wall != wall) ++k;
    if (k == FW_WALL_CONTACTS) return;
    fw_wall_contact *contact = &solution->wall_contact[k];
    if (k == solution->wall_contact_count)
        solution->wall_contact[solution->wall_contact_count++] = (fw_wall_contact){.wall = wall};
    contact->force = fw_vec2_add(contact->force, force);
    contact->work += fw_vec2_dot(force, solved->motion);
    const double stiffness = 1 / fw_sym2_form(normal, mobility, normal);
    contact->stiffness =
        fw_sym2_add(contact->stiffness,
                    (fw_sym2){stiffness * normal.x * normal.x, stiffness * normal.x * normal.y,
                              stiffness * normal.y * normal.y});
}

static void list_facet(fw_row_list *rows, int facet)
{
    for (int k = 0; k < rows->count; ++k)
        if (rows->facet[k] == facet) return;
    if (rows->count < FW_WALL_CONTACTS) rows->facet[rows->count++] = facet;
}

/* Rows of an end stand in a list from the latest to the first. */
static fw_contact_solution solution_of(const fw_scene *scene, int number)
{
    const scene_joint *joint = scene->joint;
    const fw_joint_end *end = &joint->joint_ends[number];
    fw_contact_solution solution = {.displacement = end->displacement, .force = end->force};
    solution.held = end->force.x != 0 || end->force.y != 0;
    for (int n = joint->ends[number].row; n >= 0; n = joint->rows[n].next) {
        if (joint->rows[n].facet < 0) continue;
        list_facet(&solution.rows, joint->rows[n].facet);
        if (joint->joint_rows[n].lambda > 0)
            add_wall_contact(scene, &solution, &joint->rows[n], &joint->joint_rows[n],
                             end->mobility);
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
    *contact = (scene_contact){.particle = body->edge->contour.particles[end->point],
                               .entry = body->edge->entry[end->point],
                               .solution = solution_of(scene, number),
                               .soft = end->soft,
                               .soft_path = end->soft_path,
                               .mobility = fmax(mobility.xx, mobility.yy)};
    if (body->memory) body->memory[contact->particle] = (fw_contact_memory){0};
    return contact;
}

void scene_hand_over_joint(fw_scene *scene)
{
    const scene_joint *joint = scene->joint;
    for (int e = 0; e < joint->end_count; ++e)
        if (joint->ends[e].grip < 0 && !joint->ends[e].later &&
            joint->joint_ends[e].mobility.xx != 0)
            (void)scene_hand_over_end(scene, e);
    for (int e = 0; e < joint->end_count; ++e) {
        const int b = joint->ends[e].body;
        if (e > 0 && b == joint->ends[e - 1].body) continue;
        scene_sort_contacts(&scene->bodies[b]);
    }
}

/* A force on a particle that moves once in a step of two ticks acts for both. */
static void book_row(fw_scene *scene, const fw_joint_row *row)
{
    const scene_joint *joint = scene->joint;
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const scene_end *end = &joint->ends[row->end[k]];
        fw_body_ledger *ledger = &joint->bodies[end->body];
        ledger->force = fw_vec2_add(ledger->force, fw_vec2_scale(row->lambda, row->weight[k]));
        if (row->rub.traction != 0)
            ledger->force =
                fw_vec2_add(ledger->force, fw_vec2_scale(row->rub.traction, row->rub.weight[k]));
        if (k < 2 && row->lambda > 0) ledger->contacts += 1;
    }
}

void scene_book_joint(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    if (!joint) return;
    bool touches = false;
    for (int b = 0; b < scene->body_count && scene_is_second_tick(scene); ++b) {
        fw_body_ledger *ledger = &joint->bodies[b];
        ledger->impulse = fw_vec2_add(ledger->impulse, fw_vec2_scale(scene->tick, ledger->force));
    }
    if (scene_is_second_tick(scene)) return;
    for (int b = 0; b < scene->body_count; ++b) {
        fw_body_ledger *ledger = &joint->bodies[b];
        ledger->reaction = fw_vec2_scale(0.5, ledger->force);
        ledger->force = (fw_vec2){0, 0};
        ledger->contacts = 0;
    }
    for (int n = 0; n < joint->row_count; ++n) {
        const fw_joint_row *row = &joint->joint_rows[n];
        if (joint->rows[n].facet >= 0 || !(row->lambda > 0 || row->rub.traction != 0)) continue;
        book_row(scene, row);
        touches = true;
    }
    for (int b = 0; b < scene->body_count; ++b) {
        fw_body_ledger *ledger = &joint->bodies[b];
        ledger->reaction = fw_vec2_add(ledger->reaction, fw_vec2_scale(0.5, ledger->force));
        ledger->impulse = fw_vec2_add(ledger->impulse, fw_vec2_scale(scene->tick, ledger->force));
    }
    scene_remember_rubbing(scene);
    joint->ledger.ticks += touches;
    joint->ledger.iterations += joint->outcome.iterations;
    joint->ledger.unconverged += joint->outcome.unconverged > 0;
    joint->ledger.residual = fmax(joint->ledger.residual, joint->outcome.residual);
}

void scene_book_on_grips(fw_scene *scene, int body)
{
    const scene_joint *joint = scene->joint;
    for (int e = 0; joint && e < joint->end_count; ++e) {
        const scene_end *end = &joint->ends[e];
        if (end->grip < 0 || end->body != body) continue;
        fw_grip_book_contact(scene->grips[end->grip].grip, joint->joint_ends[e].force,
                             joint->joint_ends[e].displacement, scene->tick);
    }
}

const fw_body_ledger *fw_scene_body_ledger(const fw_scene *scene, int body)
{
    static const fw_body_ledger untouched;
    return scene->joint ? &scene->joint->bodies[body] : &untouched;
}

const fw_contact_ledger *fw_scene_contact_ledger(const fw_scene *scene)
{
    static const fw_contact_ledger none;
    return scene->joint ? &scene->joint->ledger : &none;
}
