/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_soft.c - the penalty walls of a scene: their forces as a part of the contact phase.
 * State: what each wall stores, in its ledger. Start reading at scene_soft_force(). */
#include "contact/constraint/penalty.h"
#include "scene_parts.h"

#include <math.h>

static bool lies_in(fw_vec2 point, fw_vec2 low, fw_vec2 high)
{
    return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
}

/* Does a path keep away from the wall, beside an obstacle or well inside a room? Most do. */
static bool is_clear_of(const scene_wall *wall, fw_vec2 from, fw_vec2 to)
{
    const fw_wall_def *def = fw_wall_definition(wall->wall);
    const fw_box *box = &wall->bounds;
    if (def->side == FW_OUTSIDE)
        return fmax(from.x, to.x) < box->low.x || fmin(from.x, to.x) > box->high.x ||
               fmax(from.y, to.y) < box->low.y || fmin(from.y, to.y) > box->high.y;
    if (def->shape == FW_BOX)
        return lies_in(from, box->low, box->high) && lies_in(to, box->low, box->high);
    if (def->shape != FW_CIRCLE) return false;
    const double half = 0.7 * def->radius; /* a square in the circle */
    const fw_vec2 centre = def->points[0];
    const fw_vec2 low = {centre.x - half, centre.y - half},
                  high = {centre.x + half, centre.y + half};
    return lies_in(from, low, high) && lies_in(to, low, high);
}

bool scene_is_clear_of_soft(const fw_scene *scene, fw_vec2 position, fw_vec2 w)
{
    for (int n = 0; n < scene->wall_count; ++n) {
        const scene_wall *wall = &scene->walls[n];
        const fw_vec2 from = fw_vec2_subtract(position, wall->place);
        const fw_vec2 to = fw_vec2_add(from, fw_vec2_subtract(w, wall->motion));
        if (wall->soft && !wall->yields && !is_clear_of(wall, from, to)) return false;
    }
    return true;
}

fw_vec2 scene_soft_force_of(const scene_wall *wall, fw_vec2 position, fw_vec2 w)
{
    if (!wall->soft) return (fw_vec2){0, 0};
    const fw_vec2 from = fw_vec2_subtract(position, wall->place);
    const fw_vec2 to = fw_vec2_add(from, fw_vec2_subtract(w, wall->motion));
    return is_clear_of(wall, from, to) ? (fw_vec2){0, 0} : fw_penalty_force(wall->wall, from, to);
}

fw_vec2 scene_soft_force(const fw_scene *scene, fw_vec2 position, fw_vec2 w)
{
    fw_vec2 force = {0, 0};
    for (int n = 0; n < scene->wall_count; ++n)
        if (!scene->walls[n].yields)
            force = fw_vec2_add(force, scene_soft_force_of(&scene->walls[n], position, w));
    return force;
}

double scene_stored_by(const scene_wall *wall, fw_vec2 position, fw_vec2 w)
{
    const fw_vec2 from = fw_vec2_subtract(position, wall->place);
    const fw_vec2 to = fw_vec2_add(from, fw_vec2_subtract(w, wall->motion));
    return fw_penalty_energy(wall->wall, to) - fw_penalty_energy(wall->wall, from);
}

/* The work on the particle is what the wall stored less, and what its motion did. Both are taken
 * from the energies themselves: a force that could not follow them shows as work of the wall. */
void scene_book_soft(fw_scene *scene, const scene_contact *contact, fw_vec2 position, int ticks)
{
    const fw_vec2 w = contact->solution.displacement;
    for (int n = 0; n < scene->wall_count; ++n) {
        scene_wall *wall = &scene->walls[n];
        if (!wall->soft || wall->yields) continue;
        const fw_vec2 force = scene_soft_force_of(wall, position, contact->soft_path);
        const double stored = scene_stored_by(wall, position, w);
        if (stored == 0 && force.x == 0 && force.y == 0) continue;
        fw_wall_ledger *ledger = &scene->ledgers[n];
        ledger->force = fw_vec2_add(ledger->force, fw_vec2_scale(ticks, force));
        ledger->stored += stored;
        ledger->work += fw_vec2_dot(force, w) + stored;
        ledger->contacts += 1;
        scene_push_piston(wall, position, force);
    }
}

static double largest_mobility(const scene_body *body)
{
    double largest = 0;
    const fw_prediction *predictions = fw_boundary_predictions(body->boundary);
    for (int k = 0; k < fw_boundary_count(body->boundary); ++k) {
        const fw_sym2 m = predictions[k].mobility;
        const double half = 0.5 * (m.xx - m.yy);
        largest = fmax(largest, 0.5 * (m.xx + m.yy) + sqrt(half * half + m.xy * m.xy));
    }
    return largest;
}

/* Mobility is dt^2/2m for Verlet's step: mobility times stiffness below 2 is
 * dt < 2/(stiffness/m)^(1/2). */
fw_status scene_check_soft(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count && scene->soft_count > 0; ++b) {
        scene_body *body = &scene->bodies[b];
        fw_solid_predict(body->solid, fw_boundary_particles(body->boundary),
                         fw_boundary_count(body->boundary),
                         fw_boundary_predictions(body->boundary));
        const double most = 2 / largest_mobility(body);
        for (int n = 0; n < scene->wall_count; ++n) {
            const double stiffness = fw_wall_surface(scene->walls[n].wall).stiffness;
            if (scene->walls[n].soft && !(stiffness < most))
                return fw_fail(error, FW_BAD_INPUT,
                               "wall %s has a penalty of %g, expected less than %.4g: beyond it a "
                               "particle of body %s crosses its spring in one time step (dt < "
                               "2/(K/m)^(1/2))",
                               fw_wall_name(scene->walls[n].wall), stiffness, most, body->name);
        }
    }
    return FW_OK;
}

static fw_vec2 free_with_springs(void *context, int number, fw_vec2 displacement)
{
    fw_scene *scene = context;
    scene_end *end = &scene->joint->ends[number];
    const fw_joint_end *solved = &scene->joint->joint_ends[number];
    if (end->body < 0) return end->alone;
    for (int w = 0; w < scene->wall_count && scene->ticks_per_step == 2; ++w)
        if (end->later)
            scene_follow_wall_later(scene, w);
        else
            scene_follow_wall(scene, w, scene->ticks_per_step);
    end->soft = scene_soft_force(scene, solved->position, displacement);
    end->soft_path = displacement;
    return fw_vec2_add(end->alone, fw_sym2_apply(solved->mobility, end->soft));
}

static double softening_of(void *context, int number)
{
    const fw_scene *scene = context;
    const fw_sym2 mobility = scene->joint->joint_ends[number].mobility;
    if (scene->joint->ends[number].body < 0) return 0;
    return 0.5 * scene->soft_stiffness * fmax(mobility.xx, mobility.yy);
}

/* Of a piston that is a spring, on a path relative to it. The slope is that over a small part of
 * the stiffness's own length, the path. */
static fw_vec2 push_of_spring(void *context, int number, fw_vec2 relative, double *slope)
{
    const fw_scene *scene = context;
    const scene_joint *joint = scene->joint;
    const scene_wall *wall =
        &scene->walls[scene->candidates[joint->rows[number].facet].facet->wall];
    const double half = 0.5 * fw_wall_surface(wall->wall).stiffness;
    const fw_vec2 position = joint->joint_ends[joint->joint_rows[number].end[0]].position;
    const fw_vec2 force = scene_soft_force_of(wall, position, fw_vec2_add(relative, wall->motion));
    const double size = sqrt(fw_vec2_dot(force, force));
    *slope = half;
    if (!(size > 0)) return (fw_vec2){0, 0};
    const double step = 1e-6 * size / half;
    const fw_vec2 less = scene_soft_force_of(
        wall, position,
        fw_vec2_add(fw_vec2_add(relative, wall->motion), fw_vec2_scale(step / size, force)));
    const double change = size - sqrt(fw_vec2_dot(less, less));
    *slope = fmin(fmax(change / step, 1e-3 * half), 2 * half);
    return force;
}

fw_joint_springs scene_springs(fw_scene *scene)
{
    return (fw_joint_springs){free_with_springs, softening_of, push_of_spring, scene};
}
