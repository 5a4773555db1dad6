/* SPDX-License-Identifier: GPL-3.0-or-later */
/* recorder.c - frames, rows and checkpoints of a run.
 * State: counters of what was written; they are part of each checkpoint. Invariant: rows and frames
 * that a checkpoint counts are on disk before it is. */
#include "experiments/study/recorder.h"

#include "experiments/measures/profile_table.h"
#include "experiments/results/checkpoint.h"
#include "experiments/text/spelling.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Arrays of one body as a frame takes them. */
typedef struct body_frame {
    double *velocity_x, *velocity_y, *force_x, *force_y;
    double **fields; /* NULL where the body does not have that field */
} body_frame;

struct fw_recorder {
    fw_observer *observer;
    fw_experiment *experiment; /* of the observer */
    const fw_measurement *measurement;
    char *directory, *scenario_text;
    fw_trajectory_def def;
    fw_trajectory *trajectory;
    fw_checkpoint *checkpoint;
    int section_count;
    fw_checkpoint_section *sections;
    fw_state_list *states;
    fw_written written; /* part of every checkpoint */
    char warnings[FW_WARNINGS_SIZE + 1];
    body_frame *bodies;
    fw_frame_body *frame;
    /* Arrays per solid of the scene: whole solids are asked, bodies are parts of them. */
    double **solid_x, **solid_y;
};

/* --- what the file holds --- */

static int64_t frame_count(const fw_scenario *scenario)
{
    int64_t whole = scenario->run.steps / scenario->run.record_every;
    return whole + 1 + (scenario->run.steps % scenario->run.record_every != 0);
}

static fw_status describe_bodies(fw_recorder *r, fw_error *error)
{
    const fw_experiment *experiment = r->experiment;
    int count = experiment->body_count;
    fw_trajectory_body *bodies = calloc((size_t)count, sizeof *bodies);
    r->def.bodies = bodies;
    r->def.body_count = count;
    if (!bodies) return fw_fail_memory(error, "the bodies of a results file");
    for (int b = 0; b < count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        double *mass = calloc((size_t)solid->count, sizeof *mass);
        int *links = calloc(2 * (size_t)solid->link_count + 1, sizeof *links);
        bodies[b] = (fw_trajectory_body){
            .name = range->name, .count = range->count, .mass = mass, .links = links};
        if (!mass || !links) return fw_fail_memory(error, "the bodies of a results file");
        solid->model->masses(solid, mass);
        memmove(mass, mass + range->first, (size_t)range->count * sizeof *mass);
        for (int n = 0; n < solid->link_count; ++n) {
            int one = solid->links[n][0] - range->first, other = solid->links[n][1] - range->first;
            if (one < 0 || one >= range->count || other < 0 || other >= range->count) continue;
            links[2 * bodies[b].link_count] = one;
            links[2 * bodies[b].link_count + 1] = other;
            bodies[b].link_count += 1;
        }
    }
    return FW_OK;
}

/* A field by name, from the first body that has it; once. */
static fw_status refuse_field(const fw_recorder *r, fw_scenario_name name, fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name.text);
    for (int b = 0; b < r->experiment->body_count; ++b) {
        const fw_field *field = fw_experiment_solid(r->experiment, b)->model->fields;
        for (; field && field->name; ++field) fw_suggestion_offer(&suggestion, field->name);
    }
    if (suggestion.best)
        return fw_scenario_fail(r->experiment->scenario, name.place, error,
                                "no body has a field %s; did you mean %s?", name.text,
                                suggestion.best);
    return fw_scenario_fail(r->experiment->scenario, name.place, error,
                            "no body has a field %s, expected one of those that `fretwork "
                            "quantities` lists",
                            name.text);
}

static fw_status add_field(fw_recorder *r, fw_trajectory_field *fields, fw_scenario_name name,
                           fw_error *error)
{
    for (int n = 0; n < r->def.field_count; ++n)
        if (strcmp(fields[n].name, name.text) == 0) return FW_OK;
    for (int b = 0; b < r->experiment->body_count; ++b) {
        const fw_field *field =
            fw_solid_find_field(fw_experiment_solid(r->experiment, b), name.text);
        if (!field) continue;
        fields[r->def.field_count++] = (fw_trajectory_field){field->name, field->meaning};
        return FW_OK;
    }
    return refuse_field(r, name, error);
}

/* What a picture shows that names none: the field of its kind, where nothing is recorded in any
 * case and a body has it. */
static fw_scenario_name standard_field(const fw_recorder *r, const fw_scenario_picture *picture)
{
    const char *wanted = fw_picture_rows[picture->kind].field;
    if (r->def.field_count > 0 || !wanted) return (fw_scenario_name){0};
    for (int b = 0; b < r->experiment->body_count; ++b) {
        const fw_solid *solid = fw_experiment_solid(r->experiment, b);
        if (wanted[0] && fw_solid_find_field(solid, wanted))
            return (fw_scenario_name){.text = wanted};
        if (!wanted[0] && solid->model->fields && solid->model->fields[0].name)
            return (fw_scenario_name){.text = solid->model->fields[0].name};
    }
    return (fw_scenario_name){0};
}

/* Those of `record`, and those that pictures show. */
static fw_status describe_fields(fw_recorder *r, fw_error *error)
{
    const fw_scenario *scenario = r->experiment->scenario;
    const fw_scenario_names *wanted = &scenario->record.fields;
    size_t most = (size_t)wanted->count + (size_t)scenario->picture_count;
    fw_trajectory_field *fields = calloc(most + 1, sizeof *fields);
    r->def.fields = fields;
    if (!fields) return fw_fail_memory(error, "the fields of a results file");
    for (int n = 0; n < wanted->count; ++n) FW_TRY(add_field(r, fields, wanted->item[n], error));
    for (int p = 0; p < scenario->picture_count; ++p)
        if (scenario->pictures[p].field.text)
            FW_TRY(add_field(r, fields, scenario->pictures[p].field, error));
    for (int p = 0; p < scenario->picture_count; ++p) {
        const fw_scenario_name standard = standard_field(r, &scenario->pictures[p]);
        if (!scenario->pictures[p].field.text && standard.text)
            FW_TRY(add_field(r, fields, standard, error));
    }
    return FW_OK;
}

static fw_status describe_observables(fw_recorder *r, fw_error *error)
{
    const fw_measurement *m = r->measurement;
    fw_observable *observables = calloc((size_t)m->probe_count + 1, sizeof *observables);
    r->def.observables = observables;
    r->def.observable_count = m->probe_count;
    if (!observables) return fw_fail_memory(error, "the observables of a results file");
    for (int n = 0; n < m->probe_count; ++n) {
        const fw_probe *probe = &m->probes[n];
        observables[n] = (fw_observable){probe->label, probe->quantity->unit,
                                         probe->quantity->meaning, probe->components};
    }
    return FW_OK;
}

static fw_status describe_analyses(fw_recorder *r, fw_error *error)
{
    const fw_observer *observer = r->observer;
    fw_table_group *groups = calloc((size_t)observer->analysis_count + 1, sizeof *groups);
    r->def.groups = groups;
    if (!groups) return fw_fail_memory(error, "the analyses of a results file");
    for (int n = 0; n < observer->analysis_count; ++n) {
        const fw_analysis *analysis = observer->analyses[n];
        if (analysis->table_count == 0) continue;
        groups[r->def.group_count++] =
            (fw_table_group){analysis->what->name, analysis->tables, analysis->table_count};
    }
    return FW_OK;
}

static fw_status describe(fw_recorder *r, const char *directory, int threads, fw_error *error)
{
    const fw_scenario *scenario = r->experiment->scenario;
    r->directory = strdup(directory);
    if (!r->directory) return fw_fail_memory(error, "a recorder");
    FW_TRY(fw_scenario_print(scenario, &r->scenario_text, error));
    r->def = fw_trajectory_def_default();
    r->def.directory = r->directory;
    r->def.title = scenario->title;
    r->def.scenario = r->scenario_text;
    r->def.seed = (uint64_t)scenario->run.seed;
    r->def.threads = threads;
    r->def.velocity = scenario->record.velocity;
    r->def.force = scenario->record.force;
    r->def.frame_count = frame_count(scenario);
    r->def.sample_count = fw_measurement_row_count(scenario);
    FW_TRY(describe_bodies(r, error));
    FW_TRY(describe_fields(r, error));
    if (r->observer->profile) {
        fw_trajectory_array *arrays;
        FW_TRY(fw_profile_table_arrays(&arrays, &r->def.array_count,
                                       fw_profile_bin_count(r->observer->profile), error));
        r->def.arrays = arrays;
    }
    FW_TRY(describe_analyses(r, error));
    return describe_observables(r, error);
}

/* --- memory of frames and sections --- */

static fw_status allocate_solids(fw_recorder *r, fw_error *error)
{
    int count = fw_scene_body_count(r->experiment->scene);
    r->solid_x = calloc((size_t)count, sizeof *r->solid_x);
    r->solid_y = calloc((size_t)count, sizeof *r->solid_y);
    if (!r->solid_x || !r->solid_y) return fw_fail_memory(error, "a frame");
    for (int s = 0; s < count; ++s) {
        size_t particles = (size_t)fw_scene_observe_body(r->experiment->scene, s)->count;
        r->solid_x[s] = fw_array_of_doubles(particles);
        r->solid_y[s] = fw_array_of_doubles(particles);
        if (!r->solid_x[s] || !r->solid_y[s]) return fw_fail_memory(error, "a frame");
    }
    return FW_OK;
}

static fw_status allocate_frames(fw_recorder *r, fw_error *error)
{
    int count = r->experiment->body_count;
    r->bodies = calloc((size_t)count, sizeof *r->bodies);
    r->frame = calloc((size_t)count, sizeof *r->frame);
    if (!r->bodies || !r->frame) return fw_fail_memory(error, "a frame");
    for (int b = 0; b < count; ++b) {
        body_frame *body = &r->bodies[b];
        const fw_solid *solid = fw_experiment_solid(r->experiment, b);
        size_t particles = (size_t)r->experiment->bodies[b].count;
        body->velocity_x = fw_array_of_doubles(particles);
        body->velocity_y = fw_array_of_doubles(particles);
        body->force_x = fw_array_of_doubles(particles);
        body->force_y = fw_array_of_doubles(particles);
        body->fields = calloc((size_t)r->def.field_count + 1, sizeof *body->fields);
        if (!body->velocity_x || !body->velocity_y || !body->force_x || !body->force_y ||
            !body->fields)
            return fw_fail_memory(error, "a frame");
        for (int n = 0; n < r->def.field_count; ++n) {
            if (!fw_solid_find_field(solid, r->def.fields[n].name)) continue;
            body->fields[n] = fw_array_of_doubles(particles);
            if (!body->fields[n]) return fw_fail_memory(error, "a frame");
        }
    }
    return allocate_solids(r, error);
}

/* The scene's sections, the recorder's own counters, and the profile's sums. */
static fw_status list_sections(fw_recorder *r, fw_error *error)
{
    int count = fw_scene_section_count(r->experiment->scene);
    r->section_count = count + 1 + (r->observer->profile != NULL);
    r->sections = calloc((size_t)r->section_count, sizeof *r->sections);
    r->states = calloc((size_t)r->section_count, sizeof *r->states);
    if (!r->sections || !r->states) return fw_fail_memory(error, "a checkpoint");
    for (int n = 0; n < count; ++n) {
        r->sections[n].name = fw_scene_section(r->experiment->scene, n, &r->states[n]);
        r->sections[n].state = &r->states[n];
    }
    fw_state_list_add(&r->states[count], "written", FW_I64, sizeof r->written / sizeof(int64_t),
                      &r->written);
    r->sections[count] = (fw_checkpoint_section){"recorder", &r->states[count]};
    if (!r->observer->profile) return FW_OK;
    fw_profile_state(r->observer->profile, &r->states[count + 1]);
    r->sections[count + 1] = (fw_checkpoint_section){"profile", &r->states[count + 1]};
    return FW_OK;
}

static fw_status prepare(fw_recorder **recorder, fw_observer *observer,
                         const fw_measurement *measurement, const char *directory, int threads,
                         fw_error *error)
{
    fw_recorder *made = calloc(1, sizeof *made);
    *recorder = made;
    if (!made) return fw_fail_memory(error, "a recorder");
    made->observer = observer;
    made->experiment = observer->experiment;
    made->measurement = measurement;
    FW_TRY(describe(made, directory, threads, error));
    FW_TRY(allocate_frames(made, error));
    return list_sections(made, error);
}

static fw_status give_up(fw_recorder **recorder, fw_status status)
{
    if (status == FW_OK) return FW_OK;
    fw_recorder_destroy(*recorder);
    *recorder = NULL;
    return status;
}

fw_status fw_recorder_create(fw_recorder **recorder, fw_observer *observer,
                             const fw_measurement *measurement, const char *directory,
                             bool overwrite, int threads, fw_error *error)
{
    fw_status status = prepare(recorder, observer, measurement, directory, threads, error);
    if (status == FW_OK) {
        fw_recorder *r = *recorder;
        r->def.overwrite = overwrite;
        status = fw_trajectory_create(&r->trajectory, &r->def, error);
        if (status == FW_OK)
            status = fw_checkpoint_open(&r->checkpoint, directory, r->scenario_text, error);
        if (status != FW_OK) {
            fw_trajectory_abandon(r->trajectory);
            r->trajectory = NULL;
        }
    }
    return give_up(recorder, status);
}

/* A checkpoint may come from anybody: what it says must be what this run could have written. */
static fw_status check_restored(const fw_recorder *r, const fw_checkpoint_origin *origin,
                                fw_error *error)
{
    const fw_scene *scene = r->experiment->scene;
    const int64_t step = fw_scene_steps(scene), rows = r->written.rows, frames = r->written.frames;
    FW_TRY(fw_scene_restored(r->experiment->scene, error));
    if (r->observer->profile) FW_TRY(fw_profile_restored(r->observer->profile, error));
    if (step != origin->step || step > r->experiment->scenario->run.steps)
        return fw_fail(error, FW_BAD_INPUT, "it is of step %lld and holds step %lld of %lld",
                       (long long)origin->step, (long long)step,
                       (long long)r->experiment->scenario->run.steps);
    if (r->written.warning_bytes < 0 || r->written.warning_bytes > FW_WARNINGS_SIZE)
        return fw_fail(error, FW_BAD_INPUT, "it speaks of %lld bytes of warnings, expected 0 to %d",
                       (long long)r->written.warning_bytes, FW_WARNINGS_SIZE);
    if (rows >= 1 && rows <= r->def.sample_count && frames >= 1 && frames <= r->def.frame_count)
        return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "it speaks of %lld measured rows and %lld frames, expected 1 to %lld and 1 to "
                   "%lld",
                   (long long)rows, (long long)frames, (long long)r->def.sample_count,
                   (long long)r->def.frame_count);
}

static fw_status load(fw_recorder *r, fw_checkpoint_origin *origin, fw_error *error)
{
    FW_TRY(fw_checkpoint_load(r->checkpoint, r->sections, r->section_count, origin, error));
    if (check_restored(r, origin, error) == FW_OK) return FW_OK;
    return fw_fail_within(error, "%s/%s", r->directory, origin->name);
}

static void tell_fallback(const fw_checkpoint_origin *origin, char note[FW_SENTENCE_SIZE])
{
    fw_error told;
    fw_fail(&told, FW_OK,
            "going on from %s at step %lld, since the other checkpoint cannot be used: %s",
            origin->name, (long long)origin->step, origin->newer_error.sentence);
    snprintf(note, FW_SENTENCE_SIZE, "%s", told.sentence);
}

fw_status fw_recorder_reopen(fw_recorder **recorder, fw_observer *observer,
                             const fw_measurement *measurement, const char *directory, int threads,
                             fw_written *written, char note[FW_SENTENCE_SIZE], fw_error *error)
{
    fw_status status = prepare(recorder, observer, measurement, directory, threads, error);
    fw_recorder *r = *recorder;
    fw_checkpoint_origin origin = {0};
    if (status == FW_OK)
        status = fw_checkpoint_open(&r->checkpoint, directory, r->scenario_text, error);
    if (status == FW_OK && !fw_checkpoint_exists(r->checkpoint)) {
        *written = (fw_written){0};
        snprintf(note, FW_SENTENCE_SIZE,
                 "the run ended before its first checkpoint, it begins again");
    } else if (status == FW_OK) {
        status = load(r, &origin, error);
        *written = r->written;
        if (status == FW_OK && origin.fallen_back) tell_fallback(&origin, note);
    }
    return give_up(recorder, status);
}

fw_status fw_recorder_go_on(fw_recorder *recorder, const char *warnings, fw_error *error)
{
    snprintf(recorder->warnings, sizeof recorder->warnings, "%.*s",
             (int)recorder->written.warning_bytes, warnings);
    FW_TRY(fw_trajectory_reopen(&recorder->trajectory, &recorder->def, recorder->written.frames,
                                recorder->written.rows, error));
    return fw_trajectory_warn(recorder->trajectory, recorder->warnings, error);
}

/* --- writing --- */

fw_status fw_recorder_write_row(fw_recorder *recorder, int64_t step, double time, const double *row,
                                fw_error *error)
{
    recorder->written.rows += 1;
    return fw_trajectory_write_sample(recorder->trajectory, step, time, row, error);
}

static void copy_part(double *to, const double *from, const fw_body_range *range)
{
    memcpy(to, from + range->first, (size_t)range->count * sizeof *to);
}

static void fill_velocities(fw_recorder *r)
{
    const fw_experiment *experiment = r->experiment;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s) {
        const fw_solid *solid = fw_scene_observe_body(experiment->scene, s);
        solid->model->velocities(solid, r->solid_x[s], r->solid_y[s]);
    }
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        copy_part(r->bodies[b].velocity_x, r->solid_x[range->solid], range);
        copy_part(r->bodies[b].velocity_y, r->solid_y[range->solid], range);
    }
}

/* External and contact forces together. */
static void fill_forces(fw_recorder *r)
{
    const fw_experiment *experiment = r->experiment;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s) {
        const fw_solid *solid = fw_scene_observe_body(experiment->scene, s);
        size_t bytes = (size_t)solid->count * sizeof(double);
        memcpy(r->solid_x[s], solid->external_x, bytes);
        memcpy(r->solid_y[s], solid->external_y, bytes);
        fw_scene_add_contact_forces(experiment->scene, s, r->solid_x[s], r->solid_y[s]);
    }
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        copy_part(r->bodies[b].force_x, r->solid_x[range->solid], range);
        copy_part(r->bodies[b].force_y, r->solid_y[range->solid], range);
    }
}

static void fill_fields(fw_recorder *r)
{
    const fw_experiment *experiment = r->experiment;
    for (int n = 0; n < r->def.field_count; ++n)
        for (int b = 0; b < experiment->body_count; ++b) {
            const fw_body_range *range = &experiment->bodies[b];
            const fw_solid *solid = fw_experiment_solid(experiment, b);
            const fw_field *field = fw_solid_find_field(solid, r->def.fields[n].name);
            if (!field) continue;
            field->fill(solid, r->solid_x[range->solid]);
            copy_part(r->bodies[b].fields[n], r->solid_x[range->solid], range);
        }
}

fw_status fw_recorder_write_frame(fw_recorder *recorder, fw_error *error)
{
    const fw_experiment *experiment = recorder->experiment;
    if (recorder->def.velocity) fill_velocities(recorder);
    if (recorder->def.force) fill_forces(recorder);
    fill_fields(recorder);
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        const body_frame *body = &recorder->bodies[b];
        recorder->frame[b] = (fw_frame_body){
            .x = solid->x + experiment->bodies[b].first,
            .y = solid->y + experiment->bodies[b].first,
            .velocity_x = body->velocity_x,
            .velocity_y = body->velocity_y,
            .force_x = body->force_x,
            .force_y = body->force_y,
            .fields = (const double *const *)body->fields,
        };
    }
    recorder->written.frames += 1;
    return fw_trajectory_write_frame(recorder->trajectory, fw_scene_steps(experiment->scene),
                                     fw_scene_time(experiment->scene), recorder->frame, error);
}

fw_status fw_recorder_add_warnings(fw_recorder *recorder, const char *lines, int64_t warned,
                                   fw_error *error)
{
    const size_t before = strlen(recorder->warnings), more = strlen(lines);
    recorder->written.warned = warned;
    if (more == 0) return FW_OK;
    /* What there is no room for was said all the same. */
    if (before + more > FW_WARNINGS_SIZE) return FW_OK;
    memcpy(recorder->warnings + before, lines, more + 1);
    recorder->written.warning_bytes = (int64_t)(before + more);
    return fw_trajectory_warn(recorder->trajectory, recorder->warnings, error);
}

const char *fw_recorder_warnings(const fw_recorder *recorder)
{
    return recorder->warnings;
}

fw_status fw_recorder_checkpoint(fw_recorder *recorder, fw_error *error)
{
    FW_TRY(fw_trajectory_sync(recorder->trajectory, error));
    return fw_checkpoint_write(recorder->checkpoint, recorder->sections, recorder->section_count,
                               fw_scene_steps(recorder->experiment->scene), error);
}

fw_status fw_recorder_write_array(fw_recorder *recorder, const fw_trajectory_array *array,
                                  const double *values, fw_error *error)
{
    return fw_trajectory_write_array(recorder->trajectory, array, values, error);
}

fw_status fw_recorder_finish(fw_recorder *recorder, fw_status status, const char *reason,
                             fw_error *error)
{
    if (status == FW_DIVERGED) fw_trajectory_fail(recorder->trajectory, status);
    return fw_trajectory_finish(recorder->trajectory, reason ? reason : FW_RUN_FINISHED, error);
}

static void destroy_bodies(fw_recorder *r)
{
    for (int b = 0; b < r->experiment->body_count; ++b) {
        if (r->def.bodies) {
            free((double *)r->def.bodies[b].mass);
            free((int *)r->def.bodies[b].links);
        }
        if (!r->bodies) continue;
        for (int n = 0; r->bodies[b].fields && n < r->def.field_count; ++n)
            free(r->bodies[b].fields[n]);
        free(r->bodies[b].fields);
        free(r->bodies[b].velocity_x);
        free(r->bodies[b].velocity_y);
        free(r->bodies[b].force_x);
        free(r->bodies[b].force_y);
    }
    for (int s = 0; s < fw_scene_body_count(r->experiment->scene); ++s) {
        if (r->solid_x) free(r->solid_x[s]);
        if (r->solid_y) free(r->solid_y[s]);
    }
}

void fw_recorder_abandon(fw_recorder *recorder)
{
    if (!recorder) return;
    fw_trajectory_abandon(recorder->trajectory);
    recorder->trajectory = NULL;
    fw_recorder_destroy(recorder);
}

void fw_recorder_destroy(fw_recorder *recorder)
{
    if (!recorder) return;
    fw_trajectory_destroy(recorder->trajectory);
    fw_checkpoint_close(recorder->checkpoint);
    destroy_bodies(recorder);
    free((fw_trajectory_body *)recorder->def.bodies);
    free((fw_trajectory_field *)recorder->def.fields);
    free((fw_observable *)recorder->def.observables);
    free((fw_trajectory_array *)recorder->def.arrays);
    free((fw_table_group *)recorder->def.groups);
    free(recorder->bodies);
    free(recorder->frame);
    free(recorder->solid_x);
    free(recorder->solid_y);
    free(recorder->sections);
    free(recorder->states);
    free(recorder->scenario_text);
    free(recorder->directory);
    free(recorder);
}

fw_status fw_recorder_size(fw_observer *observer, const fw_measurement *measurement,
                           fw_results_size *size, fw_error *error)
{
    fw_recorder *r;
    /* Nothing is created on disk: only the definition is made. */
    fw_status status = prepare(&r, observer, measurement, "", 1, error);
    if (status == FW_OK)
        *size = (fw_results_size){
            .frames = r->def.frame_count,
            .rows = r->def.sample_count,
            .row_width = measurement->width,
            .file = fw_trajectory_size(&r->def),
            .checkpoint = (double)fw_checkpoint_size(r->sections, r->section_count),
        };
    fw_recorder_destroy(r);
    return status;
}
