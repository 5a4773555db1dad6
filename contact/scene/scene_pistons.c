/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_pistons.c - the pistons of a scene: how they move in a tick, which depends on what they
 * meet, which depends on how they move.
 *
 * A piston's motion W and the push R(W) of the bodies are found together, W = W0 + A R(W), as for
 * two particles in contact: then energy and momentum of bodies and pistons are exact, while a
 * piston that moved first and got the push afterwards would gain energy in each impact.
 *
 * R falls with W, by straight lines between points where a row is activated or released,
 * and jumps where one more is reached. A particle that was reached stays a row of its problem for
 * the tick; so that none is that the piston never comes to, the rows it reaches first are
 * activated first, and it is drawn back from the others. On the lines Newton's method ends after a
 * few tries. A particle that has no way out jams the piston, and passes on to the wall behind it
 * what that takes.
 *
 * State: none but the pistons' own. Start reading at scene_move_pistons(). */
#include "scene_parts.h"

#include <math.h>

enum { TRIES = 200 };

/* Particles reached within this part of the farthest that any is passed by count as reached
 * together. */
static const double TOGETHER = 0.1;

/* W - W0 - A R is left smaller than this part of the terms it is a difference of: at first a few
 * rounding errors; more where R turns out to be less exact. */
static double agreement(int tries)
{
    return tries < 20 ? 1e-14 : tries < 40 ? 1e-13 : tries < 60 ? 1e-12 : 1e-11;
}

/* After a row was activated, what was found before does not count. */
static void search_anew(scene_search *search)
{
    search->x = search->y = (scene_bracket){-INFINITY, INFINITY};
    search->least_error = INFINITY;
    search->stale = 0;
    search->part = 1;
}

/* As if they met nothing. */
static void begin_motions(fw_scene *scene)
{
    const double now = fw_scene_time(scene);
    for (int w = 0; w < scene->wall_count; ++w) {
        scene_wall *wall = &scene->walls[w];
        if (!wall->piston) continue;
        wall->motion = fw_piston_displacement(wall->piston, (fw_vec2){0, 0}, now, scene->tick);
        wall->search.jam = (fw_jam){0};
        wall->search.jammed = 0;
        search_anew(&wall->search);
    }
}

/* Once boundaries are up to date: what is kept from try to try goes by their entries. */
static void begin_rows(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        const int *particles = fw_boundary_particles(body->boundary);
        for (int entry = 0; entry < fw_boundary_count(body->boundary); ++entry) {
            body->rows[entry] = (fw_row_list){0};
            if (body->memory) body->memory_before[entry] = body->memory[particles[entry]];
        }
    }
}

static void forget_try(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        const int *particles = fw_boundary_particles(body->boundary);
        for (int entry = 0; body->memory && entry < fw_boundary_count(body->boundary); ++entry)
            body->memory[particles[entry]] = body->memory_before[entry];
    }
}

static fw_status check_motions(const fw_scene *scene, fw_error *error)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        const scene_wall *wall = &scene->walls[w];
        if (!wall->piston || (isfinite(wall->motion.x) && isfinite(wall->motion.y))) continue;
        return fw_fail(error, FW_DIVERGED,
                       "step %lld: piston %s would move by (%g, %g) under the push (%g, %g) of the "
                       "bodies, expected finite numbers",
                       (long long)scene->clock.step, fw_wall_name(wall->wall), wall->motion.x,
                       wall->motion.y, wall->search.push.x, wall->search.push.y);
    }
    return FW_OK;
}

/* --- which particles are reached --- */

static bool knows(const fw_row_list *rows, int facet)
{
    for (int k = 0; k < rows->count; ++k)
        if (rows->facet[k] == facet) return true;
    return false;
}

/* By how much the facet, as it moves now, passes the free path of a particle; its normal goes into
 * *normal. */
static double excess_of(const fw_scene *scene, const scene_body *body, const scene_contact *contact,
                        int facet, fw_vec2 *normal)
{
    const fw_candidate *candidate = &scene->candidates[facet];
    const scene_wall *wall = &scene->walls[candidate->facet->wall];
    const fw_vec2 path = fw_boundary_predictions(body->boundary)[contact->entry].displacement;
    const fw_vec2 from =
        fw_vec2_subtract(fw_solid_position(body->solid, contact->particle), wall->place);
    const fw_vec2 relative = fw_vec2_subtract(path, wall->motion);
    *normal = fw_facet_normal(candidate->facet, fw_vec2_subtract(from, candidate->facet->a));
    return -(fmax(fw_facet_gap(candidate->facet, from), 0) + fw_vec2_dot(*normal, relative));
}

/* The new rows of a contact, with the pistons in `deepest` and `normals` (per wall) that pass it
 * the furthest; or, with `take`, those of them that count. Returns how many were left. */
static int look_at_rows(fw_scene *scene, scene_body *body, const scene_contact *contact, bool take)
{
    fw_row_list *known = &body->rows[contact->entry];
    const fw_row_list *found = &contact->solution.rows;
    int left = 0;
    for (int k = 0; k < found->count; ++k) {
        const int facet = found->facet[k];
        scene_wall *wall = &scene->walls[scene->candidates[facet].facet->wall];
        fw_vec2 normal;
        /* Walls that do not yield are found anew in each try, where they stand. */
        if (!wall->piston || knows(known, facet)) continue;
        const double excess = excess_of(scene, body, contact, facet, &normal);
        if (!take) {
            if (excess > wall->search.deepest) {
                wall->search.deepest = excess;
                wall->search.deepest_normal = normal;
            }
        } else if (wall->search.deepest > 0 && excess < (1 - TOGETHER) * wall->search.deepest) {
            wall->search.draws_back = true;
            left += 1;
        } else if (known->count < FW_WALL_CONTACTS) {
            known->facet[known->count++] = facet;
            wall->search.takes = true;
        }
    }
    return left;
}

/* Activates the rows that are reached first, and draws pistons back from the others. Can this try
 * stand? */
static bool activate_rows(fw_scene *scene)
{
    int left = 0;
    for (int w = 0; w < scene->wall_count; ++w) {
        scene->walls[w].search.deepest = 0;
        scene->walls[w].search.draws_back = scene->walls[w].search.takes = false;
    }
    for (int take = 0; take < 2; ++take)
        for (int b = 0; b < scene->body_count; ++b)
            for (int n = 0; n < scene->bodies[b].contact_count; ++n)
                left += look_at_rows(scene, &scene->bodies[b], &scene->bodies[b].contacts[n], take);
    for (int w = 0; w < scene->wall_count; ++w) {
        scene_wall *wall = &scene->walls[w];
        if (!wall->search.takes) continue;
        search_anew(&wall->search);
        if (wall->search.draws_back)
            wall->motion =
                fw_vec2_subtract(wall->motion, fw_vec2_scale((1 - TOGETHER) * wall->search.deepest,
                                                             wall->search.deepest_normal));
    }
    return left == 0;
}

/* --- how they push --- */

/* The slope of a spring's force, seen through a particle that yields to half of it. */
static fw_sym2 soft_stiffness(const fw_scene *scene, const scene_wall *wall, double mobility)
{
    const double half = 0.5 * fw_wall_surface(wall->wall).stiffness;
    return fw_sym2_scalar(half / (1 + 0.5 * mobility * scene->soft_stiffness));
}

static void push_by(fw_scene *scene, const scene_body *body, const scene_contact *contact)
{
    const fw_vec2 position = fw_solid_position(body->solid, contact->particle);
    for (int t = 0; t < contact->solution.wall_contact_count; ++t) {
        const fw_wall_contact *wall_contact = &contact->solution.wall_contact[t];
        scene_push_piston(&scene->walls[wall_contact->wall], position, wall_contact->force,
                          wall_contact->stiffness);
    }
    for (int w = 0; w < scene->wall_count && scene->soft_count > 0; ++w) {
        scene_wall *wall = &scene->walls[w];
        const fw_vec2 force = scene_soft_force_of(wall, position, contact->soft_path);
        if (force.x != 0 || force.y != 0)
            scene_push_piston(wall, position, force,
                              soft_stiffness(scene, wall, contact->mobility));
    }
}

/* What the contacts of this try do to the pistons, and what jams them. */
static void add_up_pushes(fw_scene *scene, bool stands)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        scene->walls[w].search.push = (fw_vec2){0, 0};
        scene->walls[w].search.stiffness = (fw_sym2){0, 0, 0};
        scene->walls[w].search.torque = 0;
        scene->walls[w].search.jam = (fw_jam){0};
    }
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        for (int n = 0; n < body->contact_count; ++n) {
            const scene_contact *contact = &body->contacts[n];
            push_by(scene, body, contact);
            body->rows[contact->entry].released |= contact->solution.rows.released;
            if (stands) scene_note_jam(scene, body, contact);
        }
    }
}

/* --- the motion that fits --- */

/* Along one component the error falls as the motion grows: between a motion that was too small and
 * one that was too large lies the right one, and Newton's step must not leave them. (Friction that
 * slides one way or the other, and sticks between, throws it from side to side.) What was found
 * while the other component was wrong does not count, nor what turned out to leave no room. */
static double step_within(scene_bracket *bracket, double at, double error, double newton,
                          bool other_is_right)
{
    if (error > 0) bracket->low = fmax(bracket->low, at);
    if (error < 0) bracket->high = fmin(bracket->high, at);
    const double middle = 0.5 * (bracket->low + bracket->high);
    const bool bounded = isfinite(middle);
    const bool collapsed = bounded && !(middle > bracket->low && middle < bracket->high);
    const bool leaves = newton <= bracket->low || newton >= bracket->high;
    if (!other_is_right || collapsed) *bracket = (scene_bracket){-INFINITY, INFINITY};
    return leaves && bounded && !collapsed ? middle : newton;
}

/* Where tries go in circles, shorter steps end that. */
static void shorten_steps(scene_search *search, double error)
{
    if (error < 0.5 * search->least_error) {
        search->least_error = error;
        search->stale = 0;
    } else if (++search->stale >= 6) {
        search->part = fmax(0.5 * search->part, 1.0 / 64);
        search->stale = 0;
    }
}

/* Keeps to the jam, in the metric of the piston's mobility. */
static fw_vec2 kept_back(const fw_jam *jam, fw_sym2 mobility, fw_vec2 motion)
{
    const double beyond = fw_vec2_dot(jam->normal, motion) - jam->limit;
    const double yielding = fw_sym2_form(jam->normal, mobility, jam->normal);
    if (jam->piston == 0 || !(beyond > 0) || !(yielding > 0)) return motion;
    return fw_vec2_subtract(motion,
                            fw_vec2_scale(beyond / yielding, fw_sym2_apply(mobility, jam->normal)));
}

/* Newton's next motion: (1 + A K) dW = error, A diagonal. */
static fw_vec2 newton_motion(const scene_wall *wall, fw_sym2 a, fw_vec2 error)
{
    const fw_sym2 k = wall->search.stiffness;
    const double xx = 1 + a.xx * k.xx, xy = a.xx * k.xy, yx = a.yy * k.xy, yy = 1 + a.yy * k.yy;
    const double part = wall->search.part / (xx * yy - xy * yx);
    return (fw_vec2){wall->motion.x + part * (yy * error.x - xy * error.y),
                     wall->motion.y + part * (xx * error.y - yx * error.x)};
}

/* One step on W - W0 - A R(W) = 0; whether it was there already. */
static bool improve(const fw_scene *scene, scene_wall *wall, double tolerance)
{
    scene_search *search = &wall->search;
    const fw_vec2 wanted =
        fw_piston_displacement(wall->piston, search->push, fw_scene_time(scene), scene->tick);
    const fw_sym2 a = fw_piston_mobility(wall->piston, scene->tick);
    const fw_vec2 size = {fabs(wanted.x) + a.xx * fabs(search->push.x),
                          fabs(wanted.y) + a.yy * fabs(search->push.y)};
    fw_vec2 error = fw_vec2_subtract(wanted, wall->motion);
    search->jammed = 0;
    search->fits = false;
    if (search->jam.piston > 0) {
        const fw_vec2 n = search->jam.normal;
        const double beyond = fw_vec2_dot(n, wanted) - search->jam.limit;
        const double room = search->jam.limit - fw_vec2_dot(n, wall->motion);
        if (room < -tolerance * (size.x + size.y)) {
            wall->motion = kept_back(&search->jam, a, wall->motion);
            return false;
        }
        if (beyond > 0 && fabs(room) <= tolerance * (size.x + size.y)) {
            search->jammed = fw_vec2_dot(n, error) / fw_sym2_form(n, a, n);
            error = fw_vec2_subtract(error, fw_vec2_scale(search->jammed, fw_sym2_apply(a, n)));
        }
    }
    const bool right_x = fabs(error.x) <= tolerance * size.x;
    const bool right_y = fabs(error.y) <= tolerance * size.y;
    search->fits = right_x && right_y;
    if (search->fits) return true;
    shorten_steps(search,
                  fmax(fabs(error.x) / fmax(size.x, 1e-300), fabs(error.y) / fmax(size.y, 1e-300)));
    const fw_vec2 newton = newton_motion(wall, a, error);
    const fw_vec2 motion = {step_within(&search->x, wall->motion.x, error.x, newton.x, right_y),
                            step_within(&search->y, wall->motion.y, error.y, newton.y, right_x)};
    wall->motion = kept_back(&search->jam, a, motion);
    return false;
}

/* --- all together --- */

/* The last try stands even where it does not fit; the ledger shows it. */
static void note_failures(fw_scene *scene)
{
    scene_look_for_overrun(scene);
    for (int w = 0; w < scene->wall_count; ++w)
        if (scene->walls[w].piston && !scene->walls[w].search.fits)
            fw_piston_ledger_of(scene->walls[w].piston)->unresolved += 1;
}

fw_status scene_move_pistons(fw_scene *scene, fw_error *error)
{
    begin_motions(scene);
    for (int tries = 0;; ++tries) {
        FW_TRY(check_motions(scene, error));
        FW_TRY(scene_find_contacts(scene, error));
        if (tries == 0) begin_rows(scene);
        FW_TRY(scene_constrain_bodies(scene, error));
        const bool stands = activate_rows(scene);
        bool fits = stands;
        add_up_pushes(scene, stands);
        if (tries == TRIES) break;
        for (int w = 0; w < scene->wall_count && stands; ++w)
            if (scene->walls[w].piston) fits &= improve(scene, &scene->walls[w], agreement(tries));
        if (fits) break;
        forget_try(scene);
    }
    note_failures(scene);
    for (int w = 0; w < scene->wall_count; ++w)
        if (scene->walls[w].piston && scene->walls[w].search.jammed > 0)
            scene_pass_on_jam(scene, w);
    return FW_OK;
}

void scene_advance_pistons(fw_scene *scene)
{
    const double now = fw_scene_time(scene);
    for (int w = 0; w < scene->wall_count; ++w) {
        const scene_wall *wall = &scene->walls[w];
        const double work = scene->ledgers[w].work - wall->work_before;
        if (wall->piston)
            fw_piston_advance(wall->piston, wall->motion, wall->search.push, -work,
                              wall->search.torque, now, scene->tick);
    }
}
