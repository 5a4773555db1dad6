/* SPDX-License-Identifier: GPL-3.0-or-later */
/* file_plan.c - bodies, fields, observables and arrays of a results file, as an experiment has
 * them. Keeps no state. Start reading at fw_file_plan_make(). */
#include "file_plan.h"

#include "experiments/measures/profile_table.h"
#include "experiments/setup/body_field.h"
#include "experiments/text/spelling.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int64_t frame_count(const fw_scenario *scenario)
{
    int64_t whole = scenario->run.steps / scenario->run.record_every;
    return whole + 1 + (scenario->run.steps % scenario->run.record_every != 0);
}

static fw_status describe_bodies(fw_file_plan *plan, fw_error *error)
{
    const fw_experiment *experiment = plan->experiment;
    int count = experiment->body_count;
    fw_trajectory_body *bodies = calloc((size_t)count, sizeof *bodies);
    plan->bodies = bodies;
    plan->masses = calloc((size_t)count, sizeof *plan->masses);
    plan->links = calloc((size_t)count, sizeof *plan->links);
    plan->def.bodies = bodies;
    if (!bodies || !plan->masses || !plan->links)
        return fw_fail_memory(error, "the bodies of a results file");
    plan->def.body_count = count;
    for (int b = 0; b < count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        double *mass = calloc((size_t)solid->count, sizeof *mass);
        plan->masses[b] = mass;
        plan->links[b] = fw_body_range_links(experiment->scene, range, &bodies[b].link_count);
        bodies[b].name = range->name;
        bodies[b].count = range->count;
        bodies[b].mass = mass;
        bodies[b].links = (const int(*)[2])plan->links[b];
        if (!mass || !plan->links[b]) return fw_fail_memory(error, "the bodies of a results file");
        solid->model->masses(solid, mass);
        memmove(mass, mass + range->first, (size_t)range->count * sizeof *mass);
    }
    return FW_OK;
}

/* Which of several algorithms the bodies run with. */
static fw_status describe_forms(fw_file_plan *plan, fw_error *error)
{
    size_t size;
    FILE *out = open_memstream(&plan->forms, &size);
    if (!out) return fw_fail_memory(error, "the bodies of a results file");
    for (int b = 0; b < plan->experiment->body_count; ++b) {
        const fw_solid *solid = fw_experiment_solid(plan->experiment, b);
        if (!solid->model->form) continue;
        fprintf(out, "%s: %s\n", plan->experiment->bodies[b].name, solid->model->form(solid));
    }
    if (fclose(out) != 0) return fw_fail_memory(error, "the bodies of a results file");
    plan->def.forms = plan->forms;
    return FW_OK;
}

/* A field by name, from the first body that has it; once. */
static fw_status refuse_field(const fw_file_plan *plan, fw_schema_name name, fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name.text);
    for (int b = 0; b < plan->experiment->body_count; ++b) {
        fw_body_field field;
        for (int n = 0; (field = fw_body_field_at(plan->experiment, b, n)).name; ++n)
            fw_suggestion_offer(&suggestion, field.name);
    }
    if (suggestion.best)
        return fw_scenario_fail(plan->experiment->scenario, name.place, error,
                                "no body has a field %s; did you mean %s?", name.text,
                                suggestion.best);
    return fw_scenario_fail(plan->experiment->scenario, name.place, error,
                            "no body has a field %s, expected one of those that `fretwork "
                            "quantities` lists",
                            name.text);
}

static fw_status add_field(fw_file_plan *plan, fw_trajectory_field *fields, fw_schema_name name,
                           fw_error *error)
{
    for (int n = 0; n < plan->def.field_count; ++n)
        if (strcmp(fields[n].name, name.text) == 0) return FW_OK;
    for (int b = 0; b < plan->experiment->body_count; ++b) {
        const fw_body_field field = fw_body_field_find(plan->experiment, b, name.text);
        if (!field.name) continue;
        fields[plan->def.field_count++] =
            (fw_trajectory_field){field.name, field.unit, field.meaning};
        return FW_OK;
    }
    return refuse_field(plan, name, error);
}

/* What a picture shows that names none: the field of its kind, where nothing is recorded in any
 * case and a body has it. */
static fw_schema_name default_field(const fw_file_plan *plan, const fw_scenario_picture *picture)
{
    const char *wanted = fw_picture_rows[picture->kind].field;
    if (plan->def.field_count > 0 || !wanted) return (fw_schema_name){0};
    for (int b = 0; b < plan->experiment->body_count; ++b) {
        const fw_body_field field = wanted[0] ? fw_body_field_find(plan->experiment, b, wanted)
                                              : fw_body_field_at(plan->experiment, b, 0);
        if (field.name) return (fw_schema_name){.text = field.name};
    }
    return (fw_schema_name){0};
}

static fw_status add_fields_of_friction(fw_file_plan *plan, fw_trajectory_field *fields,
                                        fw_place place, fw_error *error)
{
    for (const fw_contact_field *field = fw_contact_fields; field->name; ++field)
        FW_TRY(add_field(plan, fields, (fw_schema_name){field->name, place}, error));
    return FW_OK;
}

/* Those of `record`, and those that pictures show. */
static fw_status describe_fields(fw_file_plan *plan, fw_error *error)
{
    const fw_scenario *scenario = plan->experiment->scenario;
    const fw_schema_names *wanted = &scenario->record.fields;
    const size_t most = (size_t)wanted->count + (size_t)scenario->picture_count + FW_CONTACT_FIELDS;
    fw_trajectory_field *fields = calloc(most + 1, sizeof *fields);
    plan->def.fields = plan->fields = fields;
    if (!fields) return fw_fail_memory(error, "the fields of a results file");
    for (int n = 0; n < wanted->count; ++n) FW_TRY(add_field(plan, fields, wanted->item[n], error));
    for (int p = 0; p < scenario->picture_count; ++p)
        if (scenario->pictures[p].field.text)
            FW_TRY(add_field(plan, fields, scenario->pictures[p].field, error));
    for (int p = 0; p < scenario->picture_count; ++p) {
        const fw_schema_name shown = default_field(plan, &scenario->pictures[p]);
        if (!scenario->pictures[p].field.text && shown.text)
            FW_TRY(add_field(plan, fields, shown, error));
    }
    for (int p = 0; p < scenario->picture_count; ++p)
        if (fw_picture_rows[scenario->pictures[p].kind].needs & FW_PICTURE_NEEDS_FRICTION)
            FW_TRY(add_fields_of_friction(plan, fields, scenario->pictures[p].place, error));
    return FW_OK;
}

static fw_status describe_observables(fw_file_plan *plan, fw_error *error)
{
    const fw_measurement *m = plan->measurement;
    fw_observable *observables = calloc((size_t)m->probe_count + 1, sizeof *observables);
    plan->def.observables = plan->observables = observables;
    plan->def.observable_count = m->probe_count;
    if (!observables) return fw_fail_memory(error, "the observables of a results file");
    for (int n = 0; n < m->probe_count; ++n) {
        const fw_probe *probe = &m->probes[n];
        observables[n] = (fw_observable){probe->label, probe->quantity->unit,
                                         probe->quantity->meaning, probe->components};
    }
    return FW_OK;
}

static fw_status describe_analyses(fw_file_plan *plan, fw_error *error)
{
    const fw_observer *observer = plan->observer;
    fw_table_group *groups = calloc((size_t)observer->analysis_count + 1, sizeof *groups);
    plan->def.groups = plan->groups = groups;
    if (!groups) return fw_fail_memory(error, "the analyses of a results file");
    for (int n = 0; n < observer->analysis_count; ++n) {
        const fw_analysis *analysis = observer->analyses[n];
        if (analysis->table_count == 0) continue;
        groups[plan->def.group_count++] =
            (fw_table_group){analysis->what->name, analysis->tables, analysis->table_count};
    }
    return FW_OK;
}

/* What is known at the end of the run: a profile, and the items of the certificate that apply. */
static fw_status describe_arrays(fw_file_plan *plan, fw_error *error)
{
    const fw_observer *observer = plan->observer;
    fw_trajectory_array *profile = NULL;
    int count = 0;
    if (observer->profile)
        FW_TRY(fw_profile_table_arrays(&profile, &count, fw_profile_bin_count(observer->profile),
                                       error));
    plan->arrays = realloc(profile, ((size_t)count + FW_CERTIFICATE_ITEMS) * sizeof *plan->arrays);
    if (!plan->arrays) {
        free(profile);
        return fw_fail_memory(error, "the arrays of a results file");
    }
    for (int n = 0; n < FW_CERTIFICATE_ITEMS; ++n)
        if (!isnan(observer->certificate.worst[n]))
            plan->arrays[count++] = fw_certificate_array((fw_certificate_item)n);
    plan->def.arrays = plan->arrays;
    plan->def.array_count = count;
    return FW_OK;
}

fw_status fw_file_plan_make(fw_file_plan *plan, const fw_observer *observer,
                            const fw_measurement *measurement, const char *directory, int threads,
                            fw_error *error)
{
    const fw_scenario *scenario = observer->experiment->scenario;
    *plan = (fw_file_plan){
        .observer = observer, .experiment = observer->experiment, .measurement = measurement};
    plan->directory = strdup(directory);
    if (!plan->directory) return fw_fail_memory(error, "the plan of a results file");
    FW_TRY(fw_scenario_print(scenario, &plan->scenario, error));
    plan->def = fw_trajectory_def_default();
    plan->def.directory = plan->directory;
    plan->def.title = scenario->title;
    plan->def.units = &scenario->units;
    plan->def.scenario = plan->scenario;
    plan->def.seed = (uint64_t)scenario->run.seed;
    plan->def.threads = threads;
    plan->def.velocity = scenario->record.velocity;
    plan->def.force = fw_scenario_records_force(scenario);
    plan->def.frame_count = frame_count(scenario);
    plan->def.sample_count = fw_measurement_row_count(scenario);
    FW_TRY(describe_bodies(plan, error));
    FW_TRY(describe_forms(plan, error));
    FW_TRY(describe_fields(plan, error));
    FW_TRY(describe_arrays(plan, error));
    FW_TRY(describe_analyses(plan, error));
    return describe_observables(plan, error);
}

void fw_file_plan_clear(fw_file_plan *plan)
{
    for (int b = 0; b < plan->def.body_count; ++b) {
        free(plan->masses[b]);
        free(plan->links[b]);
    }
    free(plan->masses);
    free(plan->links);
    free(plan->bodies);
    free(plan->fields);
    free(plan->observables);
    free(plan->arrays);
    free(plan->groups);
    free(plan->forms);
    free(plan->scenario);
    free(plan->directory);
    *plan = (fw_file_plan){0};
}
