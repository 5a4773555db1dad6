/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_pistons.c - the pistons of a scene: how they move in a tick, which depends on what they
 * meet, which depends on how they move.
 *
 * A piston's motion W and the push R(W) of the bodies are found together, W = W0 + A R(W), as for
 * two particles in contact: then energy and momentum of bodies and pistons are exact, while a
 * piston that moved first and was told of the push afterwards would gain energy in each impact. R
 * falls with W, by straight lines between points where a particle begins to be held or is let go,
 * and jumps where the hold rule takes hold of one more. So Newton's method ends after a few rounds
 * on the lines, if particles once taken hold of stay rows of the problem for the tick.
 *
 * State: none but the pistons' own. Start reading at scene_move_pistons(). */
#include "contact/scene_parts.h"

#include <math.h>
#include <string.h>

static const int ROUNDS = 150;

/* W - W0 - A R is left smaller than this part of the terms it is a difference of: at first a few
 * rounding errors; more where it turns out that R cannot be told as well as that. */
static double agreement(int round)
{
    return round < 10 ? 1e-14 : round < 20 ? 1e-13 : round < 30 ? 1e-12 : 1e-11;
}

static void begin(fw_scene *scene)
{
    const double now = fw_scene_time(scene);
    for (int w = 0; w < scene->wall_count; ++w) {
        scene_wall *wall = &scene->walls[w];
        if (!wall->piston) continue;
        wall->motion = fw_piston_displacement(wall->piston, (fw_vec2){0, 0}, now, scene->tick);
        wall->bracket_x = wall->bracket_y = (scene_bracket){-INFINITY, INFINITY};
    }
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        const size_t count = (size_t)body->solid->count;
        memset(body->rows, 0, count * sizeof *body->rows);
        if (body->memory) memcpy(body->memory_before, body->memory, count * sizeof *body->memory);
    }
}

static void forget_try(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        if (body->memory)
            memcpy(body->memory, body->memory_before,
                   (size_t)body->solid->count * sizeof *body->memory);
    }
}

static fw_vec2 middle_of(const scene_wall *wall)
{
    return fw_vec2_add(wall->place,
                       fw_vec2_scale(0.5, fw_vec2_add(wall->bounds.low, wall->bounds.high)));
}

static void push(scene_wall *wall, fw_vec2 position, fw_vec2 force, fw_sym2 stiffness)
{
    wall->push = fw_vec2_subtract(wall->push, force);
    wall->stiffness = fw_sym2_add(wall->stiffness, stiffness);
    wall->torque -= fw_vec2_cross(fw_vec2_subtract(position, middle_of(wall)), force);
}

/* The slope of a spring's force, seen through a particle that yields to half of it. */
static fw_sym2 soft_stiffness(const fw_scene *scene, const scene_wall *wall, double mobility)
{
    const double half = 0.5 * fw_wall_surface(wall->wall).stiffness;
    return fw_sym2_scalar(half / (1 + 0.5 * mobility * scene->soft_stiffness));
}

/* What the contacts of this try do to the pistons. */
static void add_up_pushes(fw_scene *scene)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        scene->walls[w].push = (fw_vec2){0, 0};
        scene->walls[w].stiffness = (fw_sym2){0, 0, 0};
        scene->walls[w].torque = 0;
    }
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int n = 0; n < body->contact_count; ++n) {
            const scene_contact *contact = &body->contacts[n];
            const fw_vec2 position = fw_solid_position(body->solid, contact->particle);
            for (int t = 0; t < contact->constraint.touch_count; ++t) {
                const fw_touch *touch = &contact->constraint.touch[t];
                push(&scene->walls[touch->wall], position, touch->force, touch->stiffness);
            }
            for (int w = 0; w < scene->wall_count && scene->soft_count > 0; ++w) {
                scene_wall *wall = &scene->walls[w];
                const fw_vec2 force = scene_soft_force_of(wall, position, contact->soft_path);
                if (force.x != 0 || force.y != 0)
                    push(wall, position, force, soft_stiffness(scene, wall, contact->mobility));
            }
        }
    }
}

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

/* One round of Newton's method on W - W0 - A R(W); whether it was there already. */
static bool improve(fw_scene *scene, scene_wall *wall, double part)
{
    const fw_vec2 wanted =
        fw_piston_displacement(wall->piston, wall->push, fw_scene_time(scene), scene->tick);
    const fw_sym2 a = fw_piston_mobility(wall->piston, scene->tick), k = wall->stiffness;
    const fw_vec2 error = fw_vec2_subtract(wanted, wall->motion);
    const fw_vec2 size = {fabs(wanted.x) + a.xx * fabs(wall->push.x),
                          fabs(wanted.y) + a.yy * fabs(wall->push.y)};
    const bool right_x = fabs(error.x) <= part * size.x;
    const bool right_y = fabs(error.y) <= part * size.y;
    if (right_x && right_y) return true;
    /* (1 + A K) dW = error, A diagonal. */
    const double xx = 1 + a.xx * k.xx, xy = a.xx * k.xy, yx = a.yy * k.xy, yy = 1 + a.yy * k.yy;
    const double determinant = xx * yy - xy * yx;
    const fw_vec2 newton = {wall->motion.x + (yy * error.x - xy * error.y) / determinant,
                            wall->motion.y + (xx * error.y - yx * error.x) / determinant};
    wall->motion.x = step_within(&wall->bracket_x, wall->motion.x, error.x, newton.x, right_y);
    wall->motion.y = step_within(&wall->bracket_y, wall->motion.y, error.y, newton.y, right_x);
    return false;
}

fw_status scene_move_pistons(fw_scene *scene, fw_error *error)
{
    begin(scene);
    for (int round = 0;; ++round) {
        bool agreed = true;
        FW_TRY(scene_find_contacts(scene, error));
        FW_TRY(scene_constrain_bodies(scene, error));
        add_up_pushes(scene);
        if (round == ROUNDS) {
            scene->clock.unresolved += 1;
            return FW_OK;
        }
        for (int w = 0; w < scene->wall_count; ++w)
            if (scene->walls[w].piston)
                agreed &= improve(scene, &scene->walls[w], agreement(round));
        if (agreed) return FW_OK;
        forget_try(scene);
    }
}

void scene_advance_pistons(fw_scene *scene)
{
    const double now = fw_scene_time(scene);
    for (int w = 0; w < scene->wall_count; ++w) {
        const scene_wall *wall = &scene->walls[w];
        if (wall->piston)
            fw_piston_advance(wall->piston, wall->motion, wall->push, wall->torque, now,
                              scene->tick);
    }
}
