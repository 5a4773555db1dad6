/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_grips.c - what grips hold meets walls, pistons and other bodies. All particles of a grip
 * are one end of the joint contact: with the mobility of the whole block where forces drive it, on
 * a prescribed path otherwise, and then like a moving wall to what it meets. Where two ends close
 * on each other of which neither gives way the run cannot go on, and says so before anything
 * passes. (Springs, penalty walls, do not act on gripped particles.) State: of one tick only. Start
 * reading at scene_add_gripped(). */
#include "scene_parts.h"

#include <math.h>

/* How far inside a gripped point may be carried by rounding, in units of the coordinates' size. */
static const double GRIPPED_ROUNDING = 1e-9;

/* What they rubbed on in the last tick. (Where pistons are, they have done that of all particles.)
 */
static void set_memory_apart(fw_scene *scene, const scene_grip *grip)
{
    const scene_body *body = &scene->bodies[grip->body];
    const int *particles = fw_grip_particles(grip->grip);
    if (!body->memory_before || scene->piston_count > 0) return;
    for (int k = 0; k < fw_grip_particle_count(grip->grip); ++k) {
        body->memory_before[particles[k]] = body->memory[particles[k]];
        body->memory[particles[k]] = (fw_contact_memory){0};
    }
}

void scene_begin_grips(fw_scene *scene)
{
    for (int n = 0; n < scene->grip_count; ++n) {
        scene_grip *grip = &scene->grips[n];
        grip->path =
            fw_grip_displacement(grip->grip, scene->bodies[grip->body].solid, fw_scene_time(scene));
        grip->mobility = fw_grip_mobility(grip->grip);
        set_memory_apart(scene, grip);
    }
}

void scene_follow_grips(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    for (int n = 0; n < scene->grip_count; ++n) {
        scene_grip *grip = &scene->grips[n];
        const scene_edge *edge = scene->bodies[grip->body].edge;
        const int *particles = fw_grip_particles(grip->grip);
        if (grip->end >= 0) grip->path = joint->joint_ends[grip->end].displacement;
        for (int k = 0; edge && k < fw_grip_particle_count(grip->grip); ++k) {
            const int point = edge->contour.points[particles[k]];
            if (point >= 0) edge->paths[point] = grip->path;
        }
    }
    for (int e = 0; e < joint->end_count; ++e)
        if (joint->ends[e].grip >= 0)
            joint->joint_ends[e].displacement = scene->grips[joint->ends[e].grip].path;
}

/* --- what gives way --- */

/* By a force along that direction. */
static double mobility_along(fw_vec2 direction, fw_sym2 mobility)
{
    return fw_sym2_form(direction, mobility, direction);
}

static bool grip_gives_way(const fw_scene *scene, int grip, fw_vec2 direction)
{
    return mobility_along(direction, scene->grips[grip].mobility) > 0;
}

/* Whom a point of a body's edge moves with: its grip, or -1. */
static int grip_of(const scene_body *body, int point)
{
    return body->gripped ? body->gripped[body->edge->contour.particles[point]] - 1 : -1;
}

fw_status scene_refuse_gripped(const fw_scene *scene, const scene_row *row, fw_error *error)
{
    const scene_body *body = &scene->bodies[row->point_body], *other = &scene->bodies[row->body];
    const int grips[3] = {grip_of(body, row->point), grip_of(other, row->from),
                          grip_of(other, row->to)};
    if (grips[0] < 0 || grips[1] < 0 || grips[2] < 0) return FW_OK;
    const fw_vec2 at = fw_vec2_add(scene_place_of(body, row->point), body->edge->paths[row->point]);
    const fw_vec2 from =
        fw_vec2_add(scene_place_of(other, row->from), other->edge->paths[row->from]);
    const fw_vec2 to = fw_vec2_add(scene_place_of(other, row->to), other->edge->paths[row->to]);
    const fw_vec2 along = fw_vec2_subtract(to, from);
    const double length = sqrt(fw_vec2_dot(along, along));
    const fw_vec2 outward = fw_vec2_scale(1 / length, fw_vec2_turn(along));
    const double depth = scene_distance_between(scene, row->point_body, row->body) -
                         fw_vec2_dot(outward, fw_vec2_subtract(at, from));
    for (int k = 0; k < 3; ++k)
        if (grip_gives_way(scene, grips[k], outward)) return FW_OK;
    if (!(depth > GRIPPED_ROUNDING * (1 + fabs(at.x) + fabs(at.y)))) return FW_OK;
    return fw_fail(error, FW_DIVERGED,
                   "step %lld: grips carry particle %d of body %s into body %s, whose edge is held "
                   "as well: at (%g, %g) it would lie %g inside",
                   (long long)scene->clock.step, body->edge->contour.particles[row->point],
                   body->name, other->name, at.x, at.y, depth);
}

/* --- walls --- */

/* The wall and the grip close on each other, and neither gives way. */
static fw_status refuse_wall(const fw_scene *scene, const scene_body *body, int particle,
                             const fw_candidate *candidate, fw_error *error)
{
    const scene_grip *grip = &scene->grips[body->gripped[particle] - 1];
    const scene_wall *wall = &scene->walls[candidate->facet->wall];
    const fw_vec2 at = fw_vec2_add(fw_solid_position(body->solid, particle), grip->path);
    const fw_vec2 there = fw_vec2_subtract(at, fw_vec2_add(candidate->place, candidate->motion));
    const fw_vec2 normal =
        fw_facet_normal(candidate->facet, fw_vec2_subtract(there, candidate->facet->a));
    const double depth = -fw_facet_gap(candidate->facet, there);
    const double away = fmax(fabs(candidate->place.x), fabs(candidate->place.y));
    if (grip_gives_way(scene, body->gripped[particle] - 1, normal)) return FW_OK;
    if (wall->yields && mobility_along(normal, fw_piston_mobility(wall->piston, scene->tick)) > 0)
        return FW_OK;
    if (!(depth > fw_facet_tolerance(candidate->facet, away))) return FW_OK;
    return fw_fail(error, FW_DIVERGED,
                   "step %lld: grip %s carries particle %d of body %s through wall %s: at (%g, %g) "
                   "it would lie %g behind its surface",
                   (long long)scene->clock.step, fw_grip_name(grip->grip), particle, body->name,
                   fw_wall_name(wall->wall), at.x, at.y, depth);
}

/* Facets of walls that do not yield get rows; pistons see scene_add_reached(). */
static fw_status look_at_facet(fw_scene *scene, int b, int entry, int facet, fw_error *error)
{
    const scene_body *body = &scene->bodies[b];
    const int particle = fw_boundary_particles(body->boundary)[entry];
    const fw_candidate *candidate = &scene->candidates[facet];
    const scene_wall *wall = &scene->walls[candidate->facet->wall];
    const double away = fmax(fabs(candidate->place.x), fabs(candidate->place.y));
    const fw_vec2 w = scene->grips[body->gripped[particle] - 1].path;
    const fw_vec2 position = fw_solid_position(body->solid, particle);
    int end;
    if (wall->soft ||
        !fw_facet_is_passed(candidate->facet, fw_vec2_subtract(position, candidate->place),
                            fw_vec2_subtract(w, candidate->motion), away))
        return FW_OK;
    FW_TRY(refuse_wall(scene, body, particle, candidate, error));
    if (wall->yields) return FW_OK;
    FW_TRY(scene_find_entry(scene, b, entry, &end, error));
    if (scene->joint->ends[end].wall_rows == FW_WALL_CONTACTS) return FW_OK;
    return scene_add_facet(scene, end, facet, false, error);
}

static fw_status look_at_run(fw_scene *scene, int b, int run, fw_error *error)
{
    const scene_body *body = &scene->bodies[b];
    fw_boundary *boundary = body->boundary;
    const fw_boundary_run entries = fw_boundary_observe_run(boundary, run);
    const int *particles = fw_boundary_particles(boundary);
    for (int entry = entries.first; entry < entries.first + entries.count; ++entry) {
        if (!body->gripped[particles[entry]]) continue;
        const fw_vec2 to = fw_vec2_add(fw_solid_position(body->solid, particles[entry]),
                                       scene->grips[body->gripped[particles[entry]] - 1].path);
        FW_TRY(fw_boundary_extend(boundary, scene->broadphase, run, to, error));
        const fw_boundary_run found = fw_boundary_observe_run(boundary, run);
        for (int n = 0; n < found.facet_count; ++n)
            FW_TRY(look_at_facet(scene, b, entry, found.facets[n], error));
    }
    return FW_OK;
}

fw_status scene_add_gripped(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count && scene->wall_count > 0; ++b) {
        const scene_body *body = &scene->bodies[b];
        for (int run = 0; body->gripped && run < fw_boundary_run_count(body->boundary); ++run)
            FW_TRY(look_at_run(scene, b, run, error));
    }
    return FW_OK;
}
