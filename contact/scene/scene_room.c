/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_room.c - a run in which a particle is taken through a wall cannot go on: rigid walls have
 * closed on it, or its grip has carried it there. State: none. Start reading at scene_check_room().
 *
 * Contact keeps all other particles on the free side of every wall, so that only those are looked
 * at here: grips hold without asking walls, and where no displacement suits all walls a particle is
 * pinned to one of them (`unresolved`), though another may come. */
#include "scene_parts.h"

#include <math.h>

/* The wall through which a particle that is at `end` came by `displacement` in this tick, further
 * than rounding could take it; -1: none. *depth is how far behind it lies. */
static int find_wall_passed(const fw_scene *scene, fw_vec2 end, fw_vec2 displacement, double *depth)
{
    for (int f = 0; f < scene->facet_count; ++f) {
        const fw_facet *facet = scene->candidates[f].facet;
        const scene_wall *wall = &scene->walls[facet->wall];
        if (scene->candidates[f].surface.law == FW_PENALTY) continue;
        const double away = fmax(fabs(wall->place.x), fabs(wall->place.y));
        const fw_vec2 way = fw_vec2_subtract(displacement, wall->motion);
        const fw_vec2 to = fw_vec2_subtract(end, fw_vec2_add(wall->place, wall->motion));
        *depth = -fw_facet_gap(facet, to);
        if (*depth <= fw_facet_tolerance(facet, away)) continue;
        if (fw_facet_is_passed(facet, fw_vec2_subtract(to, way), way, away)) return facet->wall;
    }
    return -1;
}

static const char *name_of(const fw_scene *scene, int wall)
{
    return fw_wall_name(scene->walls[wall].wall);
}

static fw_status check_contact(const fw_scene *scene, const scene_body *body,
                               const scene_contact *contact, fw_error *error)
{
    const fw_contact_solution *solution = &contact->solution;
    const fw_vec2 at = fw_solid_position(body->solid, contact->particle);
    double depth;
    if (!solution->unresolved) return FW_OK;
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

static fw_status check_grip(const fw_scene *scene, const scene_grip *held, fw_error *error)
{
    const scene_body *body = &scene->bodies[held->body];
    const int *particles = fw_grip_particles(held->grip);
    const fw_constraint *constraint = body->constraints;
    for (int n = 0; n < fw_grip_particle_count(held->grip); ++n) {
        while (constraint->particle != particles[n]) ++constraint;
        const fw_vec2 at = fw_solid_position(body->solid, particles[n]);
        double depth;
        const int passed = find_wall_passed(scene, at, constraint->displacement, &depth);
        if (passed < 0) continue;
        return fw_fail(error, FW_DIVERGED,
                       "step %lld: grip %s carries particle %d of body %s through wall %s: at "
                       "(%g, %g) it lies %g behind its surface",
                       (long long)scene->clock.step, fw_grip_name(held->grip), particles[n],
                       body->name, name_of(scene, passed), at.x, at.y, depth);
    }
    return FW_OK;
}

fw_status scene_check_room(fw_scene *scene, fw_error *error)
{
    if (scene->facet_count == 0) return FW_OK;
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int w = 0; w < scene->wall_count; ++w)
            scene_follow_wall(scene, w, body->solid->model->ticks_per_step);
        for (int n = 0; n < body->contact_count; ++n)
            FW_TRY(check_contact(scene, body, &body->contacts[n], error));
    }
    for (int n = 0; n < scene->grip_count; ++n) FW_TRY(check_grip(scene, &scene->grips[n], error));
    return FW_OK;
}
