/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_room.c - a run in which a particle is taken through a wall cannot go on: rigid walls have
 * closed on it, or its grip has carried it there. State: none. Start reading at scene_check_room().
 *
 * Contact keeps all other particles on the free side of every wall, so that only those are looked
 * at here: of grips their inner particles as well, which contact does not ask for, and what more
 * than one wall closes on; and where no displacement suits all walls a particle is pinned to one of
 * them (`unresolved`), though another may come. */
#include "scene_parts.h"

#include <math.h>

/* Particles of a grip that are looked at together, with one query of the tree. */
enum { BLOCK = 32 };

/* Where a particle that is at `end` came from by `displacement` in this tick, and where it went. */
static fw_box box_of_path(fw_vec2 end, fw_vec2 displacement)
{
    const fw_vec2 start = fw_vec2_subtract(end, displacement);
    return fw_box_around(start, end);
}

/* Lists all facets that a path inside the box can pass in this tick. */
static void list_passable(fw_scene *scene, fw_box box)
{
    scene->passable_count =
        fw_broadphase_query(scene->broadphase, box, scene->passable, scene->facet_count);
}

/* The wall, of those in the list, through which a particle that is at `end` came by `displacement`
 * in this tick, further than rounding could take it; -1: none. *depth is how far behind it lies. */
static int find_wall_passed(const fw_scene *scene, fw_vec2 end, fw_vec2 displacement, double *depth)
{
    for (int n = 0; n < scene->passable_count; ++n) {
        const fw_candidate *candidate = &scene->candidates[scene->passable[n]];
        const fw_facet *facet = candidate->facet;
        const scene_wall *wall = &scene->walls[facet->wall];
        if (candidate->surface.law == FW_PENALTY) continue;
        const double away = fmax(fabs(wall->place.x), fabs(wall->place.y));
        const fw_vec2 path = fw_vec2_subtract(displacement, wall->motion);
        const fw_vec2 to = fw_vec2_subtract(end, fw_vec2_add(wall->place, wall->motion));
        *depth = -fw_facet_gap(facet, to);
        if (*depth <= fw_facet_tolerance(facet, away)) continue;
        if (fw_facet_is_passed(facet, fw_vec2_subtract(to, path), path, away)) return facet->wall;
    }
    return -1;
}

static const char *name_of(const fw_scene *scene, int wall)
{
    return fw_wall_name(scene->walls[wall].wall);
}

static fw_status check_contact(fw_scene *scene, const scene_body *body,
                               const scene_contact *contact, fw_error *error)
{
    const fw_contact_solution *solution = &contact->solution;
    const fw_vec2 at = fw_solid_position(body->solid, contact->particle);
    double depth;
    if (!solution->unresolved) return FW_OK;
    list_passable(scene, box_of_path(at, solution->displacement));
    const int passed = find_wall_passed(scene, at, solution->displacement, &depth);
    if (passed < 0) return FW_OK;
    int other = passed;
    for (int k = 0; k < solution->rows.count && other == passed; ++k)
        other = scene->candidates[solution->rows.facet[k]].facet->wall;
    if (other == passed)
        return fw_fail(error, FW_DIVERGED,
                       "step %lld: wall %s leaves particle %d of body %s at (%g, %g) no room, it "
                       "lies %g behind its surface",
                       (long long)scene->clock.step, name_of(scene, passed), contact->particle,
                       body->name, at.x, at.y, depth);
    return fw_fail(error, FW_DIVERGED,
                   "step %lld: the room between walls %s and %s has closed on particle %d of body "
                   "%s at (%g, %g), it lies %g behind wall %s",
                   (long long)scene->clock.step, name_of(scene, other), name_of(scene, passed),
                   contact->particle, body->name, at.x, at.y, depth, name_of(scene, passed));
}

/* `constraint` is that of the block's first particle or an earlier one; moved on to the last. */
static fw_status check_block(fw_scene *scene, const scene_grip *held, int first, int count,
                             const fw_constraint **constraint, fw_error *error)
{
    const scene_body *body = &scene->bodies[held->body];
    const int *particles = fw_grip_particles(held->grip) + first;
    fw_vec2 at[BLOCK], displacement[BLOCK];
    fw_box box;
    for (int n = 0; n < count; ++n) {
        while ((*constraint)->particle != particles[n]) ++*constraint;
        at[n] = fw_solid_position(body->solid, particles[n]);
        displacement[n] = (*constraint)->displacement;
        const fw_box path = box_of_path(at[n], displacement[n]);
        box = n > 0 ? fw_box_joined(box, path) : path;
    }
    list_passable(scene, box);
    for (int n = 0; n < count; ++n) {
        double depth;
        const int passed = find_wall_passed(scene, at[n], displacement[n], &depth);
        if (passed < 0) continue;
        return fw_fail(error, FW_DIVERGED,
                       "step %lld: grip %s carries particle %d of body %s through wall %s: at "
                       "(%g, %g) it lies %g behind its surface",
                       (long long)scene->clock.step, fw_grip_name(held->grip), particles[n],
                       body->name, name_of(scene, passed), at[n].x, at[n].y, depth);
    }
    return FW_OK;
}

static void follow_walls(fw_scene *scene, const scene_body *body)
{
    for (int w = 0; w < scene->wall_count; ++w)
        scene_follow_wall(scene, w, body->solid->model->ticks_per_step);
}

static fw_status check_grip(fw_scene *scene, const scene_grip *held, fw_error *error)
{
    const fw_constraint *constraint = scene->bodies[held->body].constraints;
    const int total = fw_grip_particle_count(held->grip);
    follow_walls(scene, &scene->bodies[held->body]);
    for (int first = 0; first < total; first += BLOCK) {
        const int count = total - first < BLOCK ? total - first : BLOCK;
        FW_TRY(check_block(scene, held, first, count, &constraint, error));
    }
    return FW_OK;
}

fw_status scene_check_room(fw_scene *scene, fw_error *error)
{
    if (scene->facet_count == 0) return FW_OK;
    /* Only now it is known how far pistons move. */
    for (int w = 0; w < scene->wall_count; ++w)
        if (scene->walls[w].piston)
            fw_broadphase_move_wall(scene->broadphase, w, scene->walls[w].place,
                                    scene->walls[w].motion);
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        follow_walls(scene, body);
        for (int n = 0; n < body->contact_count; ++n)
            FW_TRY(check_contact(scene, body, &body->contacts[n], error));
    }
    for (int n = 0; n < scene->grip_count; ++n) FW_TRY(check_grip(scene, &scene->grips[n], error));
    return FW_OK;
}
