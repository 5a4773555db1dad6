/* SPDX-License-Identifier: GPL-3.0-or-later */
/* simulation_look.c - what can be read of a simulation. State: the simulation's windows, which only
 * grow in number. Start reading at fw_simulation_velocities(). */
#include "simulation_parts.h"

#include "core/array.h"
#include "experiments/measures/verdict.h"
#include "experiments/setup/body_field.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static_assert((int)FW_SIMULATION_NUMBERS == (int)FW_COMPONENTS_MAX, "room for every quantity");

static const char VELOCITY[] = "velocity", FORCE[] = "force";

static const fw_experiment *experiment_of(const fw_simulation *s)
{
    return fw_run_experiment(s->run);
}

const fw_scene *fw_simulation_scene(const fw_simulation *s)
{
    return experiment_of(s)->scene;
}

const char *fw_simulation_name(const fw_simulation *s)
{
    return s->name;
}

const char *fw_simulation_title(const fw_simulation *s)
{
    return s->scenario->title;
}

const char *fw_simulation_warnings(const fw_simulation *s)
{
    return fflush(s->warnings) == 0 ? s->warning_lines : "";
}

/* --- bodies --- */

int fw_simulation_body_count(const fw_simulation *s)
{
    return experiment_of(s)->body_count;
}

static const fw_body_range *range_of(const fw_simulation *s, int body)
{
    assert(body >= 0 && body < fw_simulation_body_count(s));
    return &experiment_of(s)->bodies[body];
}

fw_body_view fw_simulation_body(const fw_simulation *s, int body)
{
    const fw_body_range *range = range_of(s, body);
    const fw_solid *solid = fw_experiment_solid(experiment_of(s), body);
    return (fw_body_view){.name = range->name,
                          .model = solid->model->name,
                          .count = range->count,
                          .x = solid->x + range->first,
                          .y = solid->y + range->first};
}

int fw_simulation_find_body(const fw_simulation *s, const char *name)
{
    for (int b = 0; b < fw_simulation_body_count(s); ++b)
        if (strcmp(range_of(s, b)->name, name) == 0) return b;
    return -1;
}

/* --- numbers per particle --- */

/* The window of that name onto a solid, as it was filled the last time. `components`: numbers per
 * particle. */
static fw_status find_window(fw_simulation *s, int solid, const char *name, size_t components,
                             double **values, fw_error *error)
{
    simulation_window *window = s->windows;
    while (window && (window->solid != solid || strcmp(window->name, name) != 0))
        window = window->next;
    if (!window) {
        const fw_solid *observed = fw_scene_observe_body(fw_simulation_scene(s), solid);
        window = calloc(1, sizeof *window);
        if (!window) return fw_fail_memory(error, name);
        *window = (simulation_window){.next = s->windows, .solid = solid, .name = name};
        window->values = fw_array_of_doubles(components * (size_t)observed->count);
        if (!window->values) {
            free(window);
            return fw_fail_memory(error, name);
        }
        s->windows = window;
    }
    *values = window->values;
    return FW_OK;
}

fw_status fw_simulation_velocities(fw_simulation *s, int body, const double **x, const double **y,
                                   fw_error *error)
{
    const fw_body_range *range = range_of(s, body);
    const fw_solid *solid = fw_experiment_solid(experiment_of(s), body);
    double *all;
    FW_TRY(find_window(s, range->solid, VELOCITY, 2, &all, error));
    solid->model->velocities(solid, all, all + solid->count);
    *x = all + range->first;
    *y = *x + solid->count;
    return FW_OK;
}

fw_status fw_simulation_forces(fw_simulation *s, int body, const double **x, const double **y,
                               fw_error *error)
{
    const fw_body_range *range = range_of(s, body);
    const fw_solid *solid = fw_experiment_solid(experiment_of(s), body);
    const size_t bytes = (size_t)solid->count * sizeof(double);
    double *all;
    FW_TRY(find_window(s, range->solid, FORCE, 2, &all, error));
    memcpy(all, solid->external_x, bytes);
    memcpy(all + solid->count, solid->external_y, bytes);
    fw_scene_add_contact_forces(fw_simulation_scene(s), range->solid, all, all + solid->count);
    *x = all + range->first;
    *y = *x + solid->count;
    return FW_OK;
}

fw_status fw_simulation_field(fw_simulation *s, int body, const char *name, const double **values,
                              fw_error *error)
{
    const fw_body_range *range = range_of(s, body);
    const fw_body_field field = fw_body_field_find(experiment_of(s), body, name);
    const char *first = fw_simulation_field_name(s, body, 0); /* every solid has some */
    double *all;
    if (!field.name)
        return fw_fail(error, FW_BAD_INPUT,
                       "body %s has no field %s, expected one that it has, such as %s", range->name,
                       name, first);
    FW_TRY(find_window(s, range->solid, field.name, 1, &all, error));
    fw_body_field_fill(experiment_of(s), body, &field, all);
    *values = all + range->first;
    return FW_OK;
}

const char *fw_simulation_field_name(const fw_simulation *s, int body, int n)
{
    return fw_body_field_at(experiment_of(s), body, n).name;
}

/* --- what is measured --- */

fw_status fw_simulation_measure(const fw_simulation *s, const char *name,
                                double values[FW_SIMULATION_NUMBERS], int *count, fw_error *error)
{
    return fw_measurement_look(fw_run_observer(s->run), name, values, count, error);
}

int fw_simulation_series_count(const fw_simulation *s)
{
    return fw_run_measurement(s->run)->probe_count;
}

fw_series_view fw_simulation_series(const fw_simulation *s, int number)
{
    const fw_measurement *m = fw_run_measurement(s->run);
    assert(number >= 0 && number < m->probe_count);
    const fw_probe *probe = &m->probes[number];
    return (fw_series_view){.name = probe->label,
                            .components = probe->components,
                            .count = m->count,
                            .stride = m->width,
                            .values = m->values + probe->first,
                            .steps = m->steps,
                            .times = m->times};
}

fw_status fw_simulation_judge(const fw_simulation *s, int *expected, int *failed, fw_error *error)
{
    fw_verdicts verdicts;
    *expected = *failed = 0;
    if (!s->at_end) return FW_OK;
    FW_TRY(fw_verdicts_create(&verdicts, s->scenario, fw_study_measurement(s->study), error));
    *expected = fw_verdicts_asked(&verdicts);
    *failed = fw_verdicts_failed(&verdicts);
    fw_verdicts_clear(&verdicts);
    return FW_OK;
}
