/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frame.c - a frame's numbers, from whole solids to bodies. State: fw_frame, arrays for the frame
 * at hand. Start reading at fw_frame_fill(). */
#include "frame.h"

#include "core/array.h"
#include "experiments/setup/body_field.h"

#include <stdlib.h>
#include <string.h>

/* Of one body. */
struct fw_body_arrays {
    double *velocity_x, *velocity_y, *force_x, *force_y;
    double **fields; /* NULL where the body does not have that field */
};

static fw_status allocate_solids(fw_frame *f, fw_error *error)
{
    int count = fw_scene_body_count(f->experiment->scene);
    f->solid_x = calloc((size_t)count, sizeof *f->solid_x);
    f->solid_y = calloc((size_t)count, sizeof *f->solid_y);
    if (!f->solid_x || !f->solid_y) return fw_fail_memory(error, "a frame");
    for (int s = 0; s < count; ++s) {
        size_t particles = (size_t)fw_scene_observe_body(f->experiment->scene, s)->count;
        f->solid_x[s] = fw_array_of_doubles(particles);
        f->solid_y[s] = fw_array_of_doubles(particles);
        if (!f->solid_x[s] || !f->solid_y[s]) return fw_fail_memory(error, "a frame");
    }
    return FW_OK;
}

fw_status fw_frame_make(fw_frame *f, const fw_experiment *experiment, const fw_trajectory_def *def,
                        fw_error *error)
{
    *f = (fw_frame){.experiment = experiment, .def = def};
    int count = f->experiment->body_count;
    f->bodies = calloc((size_t)count, sizeof *f->bodies);
    f->content = calloc((size_t)count, sizeof *f->content);
    if (!f->bodies || !f->content) return fw_fail_memory(error, "a frame");
    for (int b = 0; b < count; ++b) {
        fw_body_arrays *body = &f->bodies[b];
        size_t particles = (size_t)f->experiment->bodies[b].count;
        body->velocity_x = fw_array_of_doubles(particles);
        body->velocity_y = fw_array_of_doubles(particles);
        body->force_x = fw_array_of_doubles(particles);
        body->force_y = fw_array_of_doubles(particles);
        body->fields = calloc((size_t)f->def->field_count + 1, sizeof *body->fields);
        if (!body->velocity_x || !body->velocity_y || !body->force_x || !body->force_y ||
            !body->fields)
            return fw_fail_memory(error, "a frame");
        for (int n = 0; n < f->def->field_count; ++n) {
            if (!fw_body_field_find(experiment, b, f->def->fields[n].name).name) continue;
            body->fields[n] = fw_array_of_doubles(particles);
            if (!body->fields[n]) return fw_fail_memory(error, "a frame");
        }
    }
    return allocate_solids(f, error);
}

static void copy_part(double *to, const double *from, const fw_body_range *range)
{
    memcpy(to, from + range->first, (size_t)range->count * sizeof *to);
}

static void fill_velocities(fw_frame *f)
{
    const fw_experiment *experiment = f->experiment;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s) {
        const fw_solid *solid = fw_scene_observe_body(experiment->scene, s);
        solid->model->velocities(solid, f->solid_x[s], f->solid_y[s]);
    }
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        copy_part(f->bodies[b].velocity_x, f->solid_x[range->solid], range);
        copy_part(f->bodies[b].velocity_y, f->solid_y[range->solid], range);
    }
}

/* External forces and reactions of contacts together. */
static void fill_forces(fw_frame *f)
{
    const fw_experiment *experiment = f->experiment;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s) {
        const fw_solid *solid = fw_scene_observe_body(experiment->scene, s);
        size_t bytes = (size_t)solid->count * sizeof(double);
        memcpy(f->solid_x[s], solid->external_x, bytes);
        memcpy(f->solid_y[s], solid->external_y, bytes);
        fw_scene_add_contact_forces(experiment->scene, s, f->solid_x[s], f->solid_y[s]);
    }
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        copy_part(f->bodies[b].force_x, f->solid_x[range->solid], range);
        copy_part(f->bodies[b].force_y, f->solid_y[range->solid], range);
    }
}

static void fill_fields(fw_frame *f)
{
    const fw_experiment *experiment = f->experiment;
    for (int n = 0; n < f->def->field_count; ++n)
        for (int b = 0; b < experiment->body_count; ++b) {
            const fw_body_range *range = &experiment->bodies[b];
            const fw_body_field field = fw_body_field_find(experiment, b, f->def->fields[n].name);
            if (!field.name) continue;
            fw_body_field_fill(experiment, b, &field, f->solid_x[range->solid]);
            copy_part(f->bodies[b].fields[n], f->solid_x[range->solid], range);
        }
}

const fw_frame_body *fw_frame_fill(fw_frame *f)
{
    const fw_experiment *experiment = f->experiment;
    if (f->def->velocity) fill_velocities(f);
    if (f->def->force) fill_forces(f);
    fill_fields(f);
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        const fw_body_arrays *body = &f->bodies[b];
        f->content[b] = (fw_frame_body){
            .x = solid->x + experiment->bodies[b].first,
            .y = solid->y + experiment->bodies[b].first,
            .velocity_x = body->velocity_x,
            .velocity_y = body->velocity_y,
            .force_x = body->force_x,
            .force_y = body->force_y,
            .fields = (const double *const *)body->fields,
        };
    }
    return f->content;
}

void fw_frame_clear(fw_frame *f)
{
    if (!f->experiment) return;
    for (int b = 0; f->bodies && b < f->experiment->body_count; ++b) {
        for (int n = 0; f->bodies[b].fields && n < f->def->field_count; ++n)
            free(f->bodies[b].fields[n]);
        free(f->bodies[b].fields);
        free(f->bodies[b].velocity_x);
        free(f->bodies[b].velocity_y);
        free(f->bodies[b].force_x);
        free(f->bodies[b].force_y);
    }
    for (int s = 0; s < fw_scene_body_count(f->experiment->scene); ++s) {
        if (f->solid_x) free(f->solid_x[s]);
        if (f->solid_y) free(f->solid_y[s]);
    }
    free(f->bodies);
    free(f->content);
    free(f->solid_x);
    free(f->solid_y);
    *f = (fw_frame){0};
}
