/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_ends.c - who takes part in the joint contact of a tick: particles, grips, and pistons that
 * yield.
 * State: of one tick only. Start reading at make_end(). */
#include "scene_parts.h"

#include <stdlib.h>

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
    return scene->bodies[body].gripped ? scene->bodies[body].gripped[particle] - 1 : -1;
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

/* Entries are numbered anew with each boundary. */
static void list_entries(scene_body *body)
{
    const int *particles = fw_boundary_particles(body->boundary);
    for (int i = 0; i < body->solid->count; ++i) body->entry_of[i] = -1;
    for (int e = 0; e < fw_boundary_count(body->boundary); ++e) body->entry_of[particles[e]] = e;
    body->entry_of_revision = body->boundary_revision;
}

int scene_entry_of(scene_body *body, int particle)
{
    if (!body->entry_of) return -1;
    if (body->entry_of_revision != body->boundary_revision) list_entries(body);
    return body->entry_of[particle];
}

int *scene_end_of_entry(const scene_body *body, int entry)
{
    const int particle = fw_boundary_particles(body->boundary)[entry];
    const int point = body->edge ? body->edge->contour.points[particle] : -1;
    return point >= 0 ? &body->edge->end[point] : &body->entry_end[entry];
}

/* Rows that walls alone had, and that on which it rubbed in the last tick. */
static fw_status add_known_walls(fw_scene *scene, int end, fw_error *error)
{
    const scene_end e = scene->joint->ends[end];
    const scene_body *body = &scene->bodies[e.body];
    if (e.contact >= 0) {
        const fw_row_list *rows = &body->contacts[e.contact].solution.rows;
        for (int k = 0; k < rows->count; ++k)
            FW_TRY(scene_add_facet(scene, end, rows->facet[k], false, error));
    }
    if (!scene_walls_rub(scene, &e)) return FW_OK;
    const fw_contact_memory *before = &body->memory_before[e.particle];
    if (before->facet == 0 || !(before->reaction > 0)) return FW_OK;
    return scene_add_facet(scene, end, before->facet - 1, true, error);
}

static fw_status make_end(fw_scene *scene, const scene_end *made, const fw_joint_end *what,
                          int *slot, fw_error *error)
{
    scene_joint *joint = scene->joint;
    FW_TRY(reserve_end(joint, error));
    *slot = joint->end_count++;
    joint->ends[*slot] = *made;
    joint->joint_ends[*slot] = *what;
    return FW_OK;
}

/* `free` is the prediction of the particle; `path` what is known of its way. */
static fw_status make_particle(fw_scene *scene, scene_end made, const fw_prediction *free,
                               fw_vec2 path, int *slot, fw_error *error)
{
    const scene_body *of = &scene->bodies[made.body];
    made.contact = free->later ? -1 : scene_find_contact(of, made.particle);
    made.grip = find_grip(scene, made.body, made.particle);
    made.row = -1;
    made.later = free->later;
    made.alone = free->displacement;
    fw_joint_end what = {.position = fw_solid_position(of->solid, made.particle),
                         .free = free->displacement,
                         .unled = free->displacement,
                         .inertial = free->inertial,
                         .mobility = free->mobility,
                         .displacement = path};
    if (made.grip >= 0) {
        what.free = what.inertial = path;
        what.mobility = (fw_sym2){0, 0, 0};
    }
    FW_TRY(make_end(scene, &made, &what, slot, error));
    return add_known_walls(scene, *slot, error);
}

fw_status scene_find_end(fw_scene *scene, int body, int point, int *end, fw_error *error)
{
    scene_body *of = &scene->bodies[body];
    *end = of->edge->end[point];
    if (*end >= 0) return FW_OK;
    number_entries(of);
    const scene_end made = {.body = body,
                            .particle = of->edge->contour.particles[point],
                            .point = point,
                            .entry = of->edge->entry[point]};
    FW_TRY(make_particle(scene, made, &of->edge->predictions[point], of->edge->paths[point],
                         &of->edge->end[point], error));
    *end = of->edge->end[point];
    return scene_couple_end(scene, *end, error);
}

fw_status scene_find_entry(fw_scene *scene, int body, int entry, int *end, fw_error *error)
{
    scene_body *of = &scene->bodies[body];
    int *slot = scene_end_of_entry(of, entry);
    *end = *slot;
    if (*end >= 0) return FW_OK;
    const int particle = fw_boundary_particles(of->boundary)[entry];
    const scene_end made = {.body = body,
                            .particle = particle,
                            .point = of->edge ? of->edge->contour.points[particle] : -1,
                            .entry = entry};
    const fw_prediction *free = &fw_boundary_predictions(of->boundary)[entry];
    const int contact = scene_find_contact(of, particle);
    FW_TRY(make_particle(scene, made, free,
                         contact >= 0 ? of->contacts[contact].solution.displacement
                                      : free->displacement,
                         slot, error));
    *end = *slot;
    return scene_couple_end(scene, *end, error);
}

fw_status scene_find_piston(fw_scene *scene, int w, int *end, fw_error *error)
{
    scene_wall *wall = &scene->walls[w];
    const double start = scene_step_start(scene), length = scene_step_length(scene);
    if (wall->end < 0) {
        const scene_end made = {.body = SCENE_PISTON,
                                .particle = w,
                                .point = -1,
                                .entry = -1,
                                .contact = -1,
                                .grip = -1,
                                .row = -1,
                                .alone = wall->motion};
        const fw_joint_end what = {.free = wall->motion,
                                   .inertial = fw_piston_inertial(wall->piston, start, length),
                                   .mobility = fw_piston_mobility(wall->piston, length),
                                   .displacement = wall->motion,
                                   .wide = true};
        FW_TRY(make_end(scene, &made, &what, &wall->end, error));
    }
    *end = wall->end;
    return FW_OK;
}

fw_status scene_find_grip(fw_scene *scene, int g, int *end, fw_error *error)
{
    scene_grip *grip = &scene->grips[g];
    if (grip->end < 0) {
        const scene_end made = {.body = SCENE_GRIP,
                                .particle = g,
                                .point = -1,
                                .entry = -1,
                                .contact = -1,
                                .grip = -1,
                                .row = -1,
                                .alone = grip->path};
        const fw_joint_end what = {.free = grip->path,
                                   .inertial = fw_grip_inertial(grip->grip, grip->path),
                                   .mobility = grip->mobility,
                                   .displacement = grip->path,
                                   .wide = true};
        FW_TRY(make_end(scene, &made, &what, &grip->end, error));
    }
    *end = grip->end;
    return FW_OK;
}

fw_status scene_find_mover(fw_scene *scene, int end, int *mover, fw_vec2 *offset, fw_error *error)
{
    *mover = end;
    *offset = (fw_vec2){0, 0};
    if (scene->joint->ends[end].grip < 0) return FW_OK;
    *offset = scene->joint->joint_ends[end].position;
    return scene_find_grip(scene, scene->joint->ends[end].grip, mover, error);
}

void scene_forget_ends(fw_scene *scene)
{
    scene_joint *joint = scene->joint;
    for (int e = 0; e < joint->end_count; ++e) {
        const scene_end *end = &joint->ends[e];
        if (end->body == SCENE_PISTON)
            scene->walls[end->particle].end = -1;
        else if (end->body == SCENE_GRIP)
            scene->grips[end->particle].end = -1;
        else if (end->point >= 0)
            scene->bodies[end->body].edge->end[end->point] = -1;
        else
            scene->bodies[end->body].entry_end[end->entry] = -1;
    }
    joint->end_count = joint->row_count = joint->changes = 0;
    joint->outcome = (fw_joint_outcome){0};
}
