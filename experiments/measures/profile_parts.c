/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile_parts.c - the solids of a profile, and one look at their particles.
 * State: none but the lists. Start reading at profile_look(). */
#include "profile_parts.h"

#include "core/particles/particles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void add_part(fw_profile *p, const fw_scene *scene, int body)
{
    const fw_solid *solid = fw_scene_observe_body(scene, body);
    p->parts[p->part_count++] =
        (profile_part){.solid = solid, .body = body, .first = p->particle_count};
    p->particle_count += solid->count;
    p->time_step = solid->tick * solid->model->ticks_per_step;
}

static int largest_part(const fw_profile *p)
{
    int most = 0;
    for (int n = 0; n < p->part_count; ++n)
        if (p->parts[n].solid->count > most) most = p->parts[n].solid->count;
    return most;
}

fw_status profile_list_parts(fw_profile *p, const fw_experiment *experiment, fw_error *error)
{
    const fw_scene *scene = experiment->scene;
    const int count = fw_scene_body_count(scene);
    p->flows = fw_experiment_particles(experiment) != NULL;
    p->parts = calloc((size_t)count + 1, sizeof *p->parts);
    if (!p->parts) return fw_fail_memory(error, "a profile");
    for (int b = 0; b < count; ++b)
        if (!p->flows || fw_solid_is_particles(fw_scene_observe_body(scene, b)))
            add_part(p, scene, b);
    if (p->flows) return FW_OK;
    const size_t most = (size_t)largest_part(p);
    p->numbers = fw_array_allocate(most, sizeof *p->numbers);
    p->predictions = fw_array_allocate(most, sizeof *p->predictions);
    p->past_x = fw_array_of_doubles((size_t)p->particle_count);
    p->past_y = fw_array_of_doubles((size_t)p->particle_count);
    if (!p->numbers || !p->predictions || !p->past_x || !p->past_y)
        return fw_fail_memory(error, "a profile");
    for (size_t i = 0; i < most; ++i) p->numbers[i] = (int)i;
    return FW_OK;
}

/* With w = w_0 + A (f + F), where w_0 is the displacement by momentum alone and F the external
 * force, the links pull with f. (An automaton knows of no forces: its cells are reflected. What has
 * no links may have no mass.) */
static void fill_pulls(fw_profile *p, const profile_part *part)
{
    const fw_solid *solid = part->solid;
    const bool knows = solid->model->ticks_per_step == 1;
    if (knows) fw_solid_predict(solid, p->numbers, solid->count, p->predictions);
    for (int i = 0; i < solid->count; ++i) {
        const fw_prediction *free = &p->predictions[i];
        fw_vec2 pull = {knows ? 0 : NAN, knows ? 0 : NAN};
        if (knows && free->mobility.xx > 0)
            pull = fw_sym2_apply(fw_sym2_invert(free->mobility),
                                 fw_vec2_subtract(free->displacement, free->inertial));
        if (solid->loaded)
            pull = fw_vec2_subtract(pull, (fw_vec2){solid->external_x[i], solid->external_y[i]});
        p->force_x[part->first + i] = pull.x;
        p->force_y[part->first + i] = pull.y;
        p->bond_force[part->first + i] = NAN;
    }
}

void profile_fill_forces(fw_profile *p)
{
    for (int n = 0; n < p->part_count; ++n) {
        const profile_part *part = &p->parts[n];
        if (p->flows)
            fw_particles_return_forces(part->solid, p->force_x + part->first,
                                       p->force_y + part->first);
        else
            fill_pulls(p, part);
    }
}

void profile_remember_places(fw_profile *p)
{
    for (int n = 0; n < p->part_count; ++n) {
        const profile_part *part = &p->parts[n];
        const size_t size = (size_t)part->solid->count * sizeof(double);
        memcpy(p->past_x + part->first, part->solid->x, size);
        memcpy(p->past_y + part->first, part->solid->y, size);
    }
}

/* By what they moved in the last step: the momentum of what is held alternates, and damping takes
 * a part of it before anything moves. */
static void fill_velocities(fw_profile *p, const profile_part *part)
{
    const fw_solid *solid = part->solid;
    for (int i = 0; i < solid->count; ++i) {
        const int at = part->first + i;
        p->velocity_x[at] = (solid->x[i] - p->past_x[at]) / p->time_step;
        p->velocity_y[at] = (solid->y[i] - p->past_y[at]) / p->time_step;
    }
}

void profile_look(fw_profile *p, const fw_experiment *experiment)
{
    memset(p->held, 0, (size_t)p->particle_count * sizeof *p->held);
    profile_fill_forces(p);
    for (int n = 0; n < p->part_count; ++n) {
        const profile_part *part = &p->parts[n];
        fw_scene_mark_held(experiment->scene, part->body, p->held + part->first);
        if (!p->flows) fill_velocities(p, part);
        if (!p->flows) continue;
        fw_particles_bond_return_forces(part->solid, p->bond_force + part->first);
        part->solid->model->velocities(part->solid, p->velocity_x + part->first,
                                       p->velocity_y + part->first);
    }
}
