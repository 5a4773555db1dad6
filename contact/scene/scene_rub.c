/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_rub.c - friction between bodies, from tick to tick: on what each particle rubbed, and the
 * heat of it. State: the memory of each particle. Start reading at scene_add_rubbing(). */
#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>

void fw_scene_set_friction(fw_scene *scene, double coefficient)
{
    scene->friction = fw_friction_of(coefficient, coefficient);
}

fw_status fw_scene_set_surfaces(fw_scene *scene, int count, const fw_friction *pairs,
                                const int *of_bodies, fw_error *error)
{
    const size_t size = (size_t)count * (size_t)count;
    fw_friction *copy = malloc((size + 1) * sizeof *copy);
    if (!copy) return fw_fail_memory(error, "the friction of pairs of surfaces");
    for (size_t n = 0; n < size; ++n) copy[n] = fw_friction_of(pairs[n].kinetic, pairs[n].at_rest);
    free(scene->pairs);
    scene->pairs = copy;
    scene->surface_count = count;
    for (int b = 0; b < scene->body_count; ++b) scene->bodies[b].surface = of_bodies[b];
    return FW_OK;
}

static fw_friction friction_of_surfaces(const fw_scene *scene, int a, int b)
{
    return scene->pairs ? scene->pairs[(size_t)a * (size_t)scene->surface_count + (size_t)b]
                        : scene->friction;
}

static fw_friction friction_between(const fw_scene *scene, int a, int b)
{
    return friction_of_surfaces(scene, scene->bodies[a].surface, scene->bodies[b].surface);
}

bool scene_bodies_rub(const fw_scene *scene)
{
    for (int a = 0; a < scene->body_count; ++a)
        for (int b = 0; b <= a; ++b)
            if (fw_scene_bodies_meet(scene, a, b) && friction_between(scene, a, b).kinetic > 0)
                return true;
    return false;
}

void scene_take_surface(const fw_scene *scene, int body, fw_surface *surface)
{
    if (surface->number == 0) return;
    const fw_friction friction =
        friction_of_surfaces(scene, scene->bodies[body].surface, surface->number - 1);
    surface->friction = friction.kinetic;
    surface->static_friction = friction.at_rest;
}

bool fw_scene_bodies_rub(const fw_scene *scene)
{
    return scene->joint && scene->joint->rubs;
}

/* A point rubs on one segment at a time: the one that it passes, rather than the one on which it
 * rubbed before. */
fw_joint_rub scene_take_rub(fw_scene *scene, const scene_row *row, int end)
{
    const scene_joint *joint = scene->joint;
    const scene_edge *edge = scene->bodies[row->point_body].edge;
    const fw_friction friction = friction_between(scene, row->point_body, row->body);
    fw_joint_rub rub = {.coefficient = friction.kinetic, .at_rest = friction.at_rest};
    if (!edge->rubs) return (fw_joint_rub){0};
    const scene_rub *memory = &edge->rubs[edge->contour.particles[row->point]];
    for (int n = joint->ends[end].row; n >= 0; n = joint->rows[n].next) {
        fw_joint_row *other = &joint->joint_rows[n];
        if (joint->rows[n].facet >= 0 || !(other->rub.coefficient > 0)) continue;
        if (!other->open) return (fw_joint_rub){0};
        other->rub = (fw_joint_rub){0};
    }
    if (memory->other != 1 + row->body) return rub;
    rub.before = memory->lambda;
    rub.inertial_before = memory->inertial;
    rub.stuck_before = true;
    rub.slides = !memory->stuck;
    return rub;
}

/* The segment that follows along the chain, or comes before; itself where there is none. */
static int next_along(const fw_contour *contour, int segment, bool forward)
{
    const fw_contour_segment *s = &contour->segments[segment];
    const int near = forward ? segment + 1 : segment - 1;
    const int wanted = forward ? s->to : s->from;
    if (near >= 0 && near < contour->segment_count &&
        (forward ? contour->segments[near].from : contour->segments[near].to) == wanted)
        return near;
    for (int n = 0; n < contour->segment_count; ++n)
        if ((forward ? contour->segments[n].from : contour->segments[n].to) == wanted) return n;
    return segment;
}

/* Where a particle has slid over the end of its segment, it rubs on the next one. */
static int segment_below(const scene_body *of, fw_vec2 at, int segment)
{
    const fw_contour *contour = &of->edge->contour;
    const fw_contour_segment *s = &contour->segments[segment];
    const fw_vec2 from = fw_solid_position(of->solid, contour->particles[s->from]);
    const fw_vec2 edge =
        fw_vec2_subtract(fw_solid_position(of->solid, contour->particles[s->to]), from);
    const double part = fw_vec2_dot(fw_vec2_subtract(at, from), edge) / fw_vec2_dot(edge, edge);
    if (part > 1) return next_along(contour, segment, true);
    return part < 0 ? next_along(contour, segment, false) : segment;
}

/* Also in the tick after a release. Bodies and points in their order. */
fw_status scene_add_rubbing(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        const scene_edge *edge = body->edge;
        if (!edge || !edge->rubs) continue;
        for (int point = 0; point < edge->contour.point_count; ++point) {
            const int particle = edge->contour.particles[point];
            const scene_rub *rub = &edge->rubs[particle];
            if (rub->other == 0) continue;
            const scene_body *of = &scene->bodies[rub->other - 1];
            const int segment =
                segment_below(of, fw_solid_position(body->solid, particle), rub->segment);
            const fw_contour_segment *s = &of->edge->contour.segments[segment];
            const scene_row row = {.facet = -1,
                                   .body = rub->other - 1,
                                   .from = s->from,
                                   .to = s->to,
                                   .segment = segment,
                                   .next = -1,
                                   .point_body = b,
                                   .point = point};
            const int known = scene->joint->row_count;
            FW_TRY(scene_add_row(scene, &row, error));
            if (scene->joint->row_count > known)
                scene->joint->joint_rows[scene->joint->row_count - 1].open = true;
        }
    }
    return FW_OK;
}

static void forget(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_edge *edge = scene->bodies[b].edge;
        for (int point = 0; edge && edge->rubs && point < edge->contour.point_count; ++point)
            edge->rubs[edge->contour.particles[point]] = (scene_rub){0};
    }
}

/* What sticks, and stuck in the tick before, should stay where it is but for what the filter lets
 * through. */
static void follow_creep(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    for (int n = 0; n < joint->row_count; ++n) {
        scene_row *row = &joint->rows[n];
        const fw_joint_rub *rub = &joint->joint_rows[n].rub;
        row->crept = 0;
        if (row->facet >= 0 || !(rub->coefficient > 0) || !rub->stuck) continue;
        const scene_edge *edge = scene->bodies[row->point_body].edge;
        const scene_rub *before = &edge->rubs[edge->contour.particles[row->point]];
        if (before->stuck && before->other == 1 + row->body) row->crept = before->crept + rub->slip;
        joint->ledger.creep = fmax(joint->ledger.creep, fabs(row->crept));
    }
}

void scene_remember_rubbing(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    double widest = 0, beyond = 0;
    if (!scene->joint->rubs) return;
    follow_creep(scene);
    forget(scene);
    for (int n = 0; n < joint->row_count; ++n)
        if (joint->rows[n].facet < 0 && joint->joint_rows[n].rub.coefficient > 0)
            scene_record_hold(scene, &joint->rows[n], &joint->joint_rows[n].rub);
    for (int n = 0; n < joint->row_count; ++n) {
        const scene_row *row = &joint->rows[n];
        const fw_joint_row *solved = &joint->joint_rows[n];
        const fw_joint_rub *rub = &solved->rub;
        if (row->facet >= 0 || !(rub->coefficient > 0)) continue;
        joint->ledger.heat -= rub->traction * rub->slip;
        scene_record_rub(scene, row, rub);
        const double cone = fw_joint_cone(solved);
        widest = fmax(widest, cone);
        beyond = fmax(beyond, fabs(rub->traction) - cone * (1 + 1e-9));
        /* A particle that is held is let go in every other step, and sticks all the same. */
        if (!(solved->lambda > 0 || rub->before > 0)) continue;
        const scene_edge *edge = scene->bodies[row->point_body].edge;
        edge->rubs[edge->contour.particles[row->point]] = (scene_rub){.lambda = solved->lambda,
                                                                      .inertial = rub->inertial,
                                                                      .crept = row->crept,
                                                                      .other = 1 + row->body,
                                                                      .segment = row->segment,
                                                                      .stuck = rub->stuck};
    }
    if (beyond > 0 && widest > 0)
        joint->ledger.overstep = fmax(joint->ledger.overstep, beyond / widest);
}

/* --- on walls --- */

bool scene_walls_rub(const fw_scene *scene, const scene_end *end)
{
    return scene->bodies[end->body].memory_before && (scene->piston_count > 0 || end->grip >= 0);
}

fw_joint_rub scene_take_wall_rub(const fw_scene *scene, int number, int facet)
{
    const scene_end *end = &scene->joint->ends[number];
    const scene_body *body = &scene->bodies[end->body];
    const int wall = scene->candidates[facet].facet->wall;
    fw_surface surface = scene->candidates[facet].surface;
    if (surface.law != FW_COULOMB || !scene_walls_rub(scene, end)) return (fw_joint_rub){0};
    scene_take_surface(scene, end->body, &surface);
    const fw_contact_memory *before = &body->memory_before[end->particle];
    fw_joint_rub rub = {.coefficient = surface.friction, .at_rest = surface.static_friction};
    if (before->facet == 0 || scene->candidates[before->facet - 1].facet->wall != wall) return rub;
    rub.before = before->reaction;
    rub.inertial_before = before->inertial;
    rub.stuck_before = before->stuck;
    rub.slides = !before->stuck;
    return rub;
}

/* Of the walls that rub a particle it remembers the one that pushes the most. */
void scene_remember_wall(fw_scene *scene, int number)
{
    const scene_joint *joint = scene->joint;
    const scene_end *end = &joint->ends[number];
    const scene_body *body = &scene->bodies[end->body];
    fw_contact_memory memory = {0};
    double most = 0;
    for (int n = joint->ends[number].row; n >= 0; n = joint->rows[n].next) {
        const fw_joint_row *solved = &joint->joint_rows[n];
        const fw_joint_rub *rub = &solved->rub;
        const double pushes = solved->lambda + rub->before;
        if (joint->rows[n].facet < 0 || !(rub->coefficient > 0) || !(pushes > most)) continue;
        const fw_contact_memory *before = &body->memory_before[end->particle];
        most = pushes;
        memory = (fw_contact_memory){.reaction = solved->lambda,
                                     .inertial = rub->inertial,
                                     .facet = 1 + joint->rows[n].facet,
                                     .stuck = rub->stuck};
        if (rub->stuck && rub->stuck_before) memory.crept = before->crept + rub->slip;
    }
    body->memory[end->particle] = memory;
}
