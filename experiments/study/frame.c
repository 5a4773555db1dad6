/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frame.c - a frame's numbers, from whole solids to bodies. State: fw_frame, arrays for the frame
 * at hand. Start reading at fw_frame_fill(). */
#include "frame.h"

#include "core/array.h"
#include "experiments/setup/body_field.h"

#include <stdlib.h>
#include <string.h>

/* Of one body: what it has of the fields. */
struct fw_body_arrays {
    double **fields; /* NULL where the body does not have that field */
};

/* Of one solid of the scene, whose bodies are parts of it. */
struct fw_solid_arrays {
    double *velocity_x, *velocity_y, *force_x, *force_y;
    double *field;
};

static bool allocate(double **array, bool wanted, size_t count)
{
    if (wanted) *array = fw_array_of_doubles(count);
    return *array || !wanted;
}

/* Its positions and velocities go straight into the file. */
static bool tells_motions(const fw_frame *f, int solid)
{
    return f->def->velocity &&
           fw_scene_observe_body(f->experiment->scene, solid)->model->motions != NULL;
}

static fw_status allocate_solids(fw_frame *f, fw_error *error)
{
    const int count = fw_scene_body_count(f->experiment->scene);
    const bool velocity = f->def->velocity, force = f->def->force, field = f->def->field_count > 0;
    f->solids = calloc((size_t)count, sizeof *f->solids);
    if (!f->solids) return fw_fail_memory(error, "a frame");
    for (int s = 0; s < count; ++s) {
        fw_solid_arrays *solid = &f->solids[s];
        const size_t particles = (size_t)fw_scene_observe_body(f->experiment->scene, s)->count;
        const bool arrays = velocity && !tells_motions(f, s);
        if (!allocate(&solid->velocity_x, arrays, particles) ||
            !allocate(&solid->velocity_y, arrays, particles) ||
            !allocate(&solid->force_x, force, particles) ||
            !allocate(&solid->force_y, force, particles) ||
            !allocate(&solid->field, field, particles))
            return fw_fail_memory(error, "a frame");
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
        body->fields = calloc((size_t)f->def->field_count + 1, sizeof *body->fields);
        if (!body->fields) return fw_fail_memory(error, "a frame");
        for (int n = 0; n < f->def->field_count; ++n) {
            if (!fw_body_field_find(experiment, b, f->def->fields[n].name).name) continue;
            body->fields[n] = fw_array_of_doubles(particles);
            if (!body->fields[n]) return fw_fail_memory(error, "a frame");
        }
    }
    return allocate_solids(f, error);
}

/* Of a body, from that of its solid; NULL where frames do not hold it. */
static const double *part_of(const double *whole, const fw_body_range *range)
{
    return whole ? whole + range->first : NULL;
}

static void fill_velocities(fw_frame *f)
{
    const fw_experiment *experiment = f->experiment;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s) {
        const fw_solid *solid = fw_scene_observe_body(experiment->scene, s);
        if (tells_motions(f, s)) continue;
        solid->model->velocities(solid, f->solids[s].velocity_x, f->solids[s].velocity_y);
    }
}

/* External forces and reactions of contacts together. */
static void fill_forces(fw_frame *f)
{
    const fw_experiment *experiment = f->experiment;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s) {
        const fw_solid *solid = fw_scene_observe_body(experiment->scene, s);
        size_t bytes = (size_t)solid->count * sizeof(double);
        memcpy(f->solids[s].force_x, solid->external_x, bytes);
        memcpy(f->solids[s].force_y, solid->external_y, bytes);
        fw_scene_add_contact_forces(experiment->scene, s, f->solids[s].force_x,
                                    f->solids[s].force_y);
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
            fw_body_field_fill(experiment, b, &field, f->solids[range->solid].field);
            memcpy(f->bodies[b].fields[n], f->solids[range->solid].field + range->first,
                   (size_t)range->count * sizeof(double));
        }
}

bool fw_frame_needs_positions(const fw_frame *f)
{
    for (int s = 0; s < fw_scene_body_count(f->experiment->scene); ++s)
        if (!tells_motions(f, s)) return true;
    return f->def->force || f->def->field_count > 0;
}

const fw_frame_body *fw_frame_fill(fw_frame *f)
{
    const fw_experiment *experiment = f->experiment;
    if (f->def->velocity) fill_velocities(f);
    if (f->def->force) fill_forces(f);
    fill_fields(f);
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        const fw_body_range *range = &experiment->bodies[b];
        const fw_solid_arrays *arrays = &f->solids[range->solid];
        f->content[b] = (fw_frame_body){
            .x = part_of(solid->x, range),
            .y = part_of(solid->y, range),
            .velocity_x = part_of(arrays->velocity_x, range),
            .velocity_y = part_of(arrays->velocity_y, range),
            .force_x = part_of(arrays->force_x, range),
            .force_y = part_of(arrays->force_y, range),
            .fields = (const double *const *)f->bodies[b].fields,
            .solid = tells_motions(f, range->solid) ? solid : NULL,
            .first = range->first,
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
    }
    for (int s = 0; f->solids && s < fw_scene_body_count(f->experiment->scene); ++s) {
        free(f->solids[s].velocity_x);
        free(f->solids[s].velocity_y);
        free(f->solids[s].force_x);
        free(f->solids[s].force_y);
        free(f->solids[s].field);
    }
    free(f->bodies);
    free(f->content);
    free(f->solids);
    *f = (fw_frame){0};
}
