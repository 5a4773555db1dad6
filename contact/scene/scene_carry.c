/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_carry.c - after a tick, what is held on a path gets the velocity of the path: the particles
 * of grips, and those that stick to walls on a prescribed path. What that takes enters the
 * ledger where the force of the tick was. (Forces alone would leave them with 0, 2V, 0, 2V, ...) On
 * a wall that never moves the hold rule stands as it is, p -> -p. State: none. Start reading at
 * scene_carry(). */
#include "scene_parts.h"

#include <stdlib.h>

/* Does the wall hold the particle in all components, and move whatever that takes? */
static bool carries(const fw_scene *scene, const scene_contact *contact)
{
    const fw_contact_solution *solution = &contact->solution;
    if (!solution->held || solution->wall_contact_count != 1) return false;
    const scene_wall *wall = &scene->walls[solution->wall_contact[0].wall];
    if (fw_wall_surface(wall->wall).law != FW_STICK || !fw_wall_moves(wall->wall)) return false;
    if (wall->yields) return false;
    return solution->displacement.x == wall->motion.x && solution->displacement.y == wall->motion.y;
}

static fw_vec2 velocity_of(const fw_scene *scene, const scene_wall *wall)
{
    if (wall->piston) return fw_vec2_scale(1 / scene->tick, wall->motion);
    return fw_path_velocity(&fw_wall_definition(wall->wall)->path,
                            fw_scene_time(scene) + scene->tick, scene->tick);
}

/* Owners are grips from 0 on, and contacts as -1 - index. */
static int list_carries(fw_scene *scene, int number)
{
    scene_body *body = &scene->bodies[number];
    const double end = fw_scene_time(scene) + scene->tick;
    int count = 0;
    for (int n = 0; n < scene->grip_count; ++n)
        if (scene->grips[n].body == number)
            count +=
                fw_grip_carry(scene->grips[n].grip, n, end, scene->tick, body->carries + count);
    for (int n = 0; n < body->contact_count; ++n) {
        const scene_contact *contact = &body->contacts[n];
        if (!carries(scene, contact)) continue;
        const scene_wall *wall = &scene->walls[contact->solution.wall_contact[0].wall];
        body->carries[count++] = (fw_carry){.particle = contact->particle,
                                            .owner = -1 - n,
                                            .x = true,
                                            .y = true,
                                            .velocity = velocity_of(scene, wall)};
    }
    return count;
}

static int compare_carries(const void *left, const void *right)
{
    const fw_carry *a = left, *b = right;
    return (a->particle > b->particle) - (a->particle < b->particle);
}

/* The wall's motion does the work of the impulse; what does not arrive is the heat of a particle
 * that stops sliding on it. */
static void book_on_wall(fw_scene *scene, const scene_body *body, const fw_carry *carry)
{
    const int w = body->contacts[-1 - carry->owner].solution.wall_contact[0].wall;
    const fw_vec2 force = fw_vec2_scale(1 / scene->tick, carry->impulse);
    const double work = fw_vec2_dot(carry->impulse, carry->velocity);
    fw_wall_ledger *ledger = &scene->ledgers[w];
    ledger->force = fw_vec2_add(ledger->force, force);
    ledger->work += work;
    ledger->dissipated += work - carry->work;
    scene_push_piston(&scene->walls[w], fw_solid_position(body->solid, carry->particle), force);
}

void scene_carry(fw_scene *scene, int number)
{
    scene_body *body = &scene->bodies[number];
    if (!body->solid->model->carry || body->constraint_count == 0) return;
    for (int w = 0; w < scene->wall_count; ++w) scene_follow_wall(scene, w, 1);
    const int count = list_carries(scene, number);
    if (count == 0) return;
    qsort(body->carries, (size_t)count, sizeof *body->carries, compare_carries);
    body->solid->model->carry(body->solid, body->carries, count);
    fw_constraint *constraint = body->constraints;
    for (int n = 0; n < count; ++n) {
        const fw_carry *carry = &body->carries[n];
        while (constraint->particle != carry->particle) ++constraint;
        constraint->force =
            fw_vec2_add(constraint->force, fw_vec2_scale(1 / scene->tick, carry->impulse));
        if (carry->owner >= 0)
            fw_grip_book_carry(scene->grips[carry->owner].grip, carry, scene->tick);
        else
            book_on_wall(scene, body, carry);
    }
}
