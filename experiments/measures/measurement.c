/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measurement.c - which quantities are measured, and their series.
 * Invariant: no two probes have the same quantity and subject; rows ascend in step. */
#include "experiments/measures/measurement.h"

#include "core/particles/particles.h"
#include "experiments/measures/layer.h"

#include "experiments/text/spelling.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is measured where `measure` is not given. */
static const char *const standard_set[] = {"energy",         "kinetic-energy", "elastic-energy",
                                           "energy-error",   "momentum",       "momentum-error",
                                           "centre-of-mass", "reaction",       NULL};

/* What the measures of a profile's layer are made of. */
static const char *const profile_set[] = {"slip", "interface-force", "contact-return-force", NULL};

static const char *const piston_place = "piston-displacement";

typedef struct request {
    const fw_observer *observer;
    const fw_experiment *experiment; /* of the observer */
    fw_measurement *measurement;
    fw_error *error;
} request;

static void write_label(const fw_experiment *experiment, fw_probe *probe)
{
    const fw_subject s = probe->subject;
    int length = snprintf(probe->label, sizeof probe->label, "%s", probe->quantity->name);
    char *end = probe->label + length;
    size_t room = sizeof probe->label - (size_t)length;
    if (s.particle >= 0) {
        fw_site site = experiment->bodies[s.body].sites.site[s.particle];
        snprintf(end, room, ".%s[%d,%d]", experiment->bodies[s.body].name, site.i, site.j);
    } else if (s.body >= 0) {
        snprintf(end, room, ".%s", experiment->bodies[s.body].name);
    } else if (s.analysis) {
        snprintf(end, room, ".%s", s.analysis->what->name);
    } else if (s.wall >= 0) {
        snprintf(end, room, ".%s", fw_wall_name(fw_scene_wall(experiment->scene, s.wall)));
    } else if (s.grip >= 0) {
        snprintf(end, room, ".%s", fw_grip_name(fw_scene_observe_grip(experiment->scene, s.grip)));
    }
}

static fw_subject no_subject(const request *r)
{
    return (fw_subject){
        .body = -1, .wall = -1, .grip = -1, .particle = -1, .profile = r->observer->profile};
}

/* Adds a probe unless there is one already; returns its number, or -1 without memory. */
static int add_probe(request *r, const fw_quantity *quantity, fw_subject subject)
{
    fw_measurement *m = r->measurement;
    for (int n = 0; n < m->probe_count; ++n) {
        const fw_probe *p = &m->probes[n];
        if (p->quantity == quantity && p->subject.body == subject.body &&
            p->subject.wall == subject.wall && p->subject.grip == subject.grip &&
            p->subject.particle == subject.particle && p->subject.analysis == subject.analysis)
            return n;
    }
    fw_probe *probes = realloc(m->probes, ((size_t)m->probe_count + 1) * sizeof *probes);
    if (!probes) {
        fw_fail_memory(r->error, "the list of what is measured");
        return -1;
    }
    m->probes = probes;
    fw_probe *probe = &m->probes[m->probe_count];
    *probe = (fw_probe){.quantity = quantity,
                        .subject = subject,
                        .first = m->width,
                        .components = fw_quantity_component_count(quantity)};
    write_label(r->experiment, probe);
    m->width += probe->components;
    return m->probe_count++;
}

static fw_status find_quantity(request *r, fw_scenario_name name, const fw_quantity **quantity)
{
    *quantity = fw_quantity_find(name.text);
    if (*quantity) return FW_OK;
    for (const fw_renamed_quantity *renamed = fw_renamed_quantities; renamed->name; ++renamed)
        if (strcmp(renamed->old_name, name.text) == 0)
            return fw_scenario_fail(r->experiment->scenario, name.place, r->error,
                                    "quantity %s is not known; it is now called %s", name.text,
                                    renamed->name);
    fw_suggestion suggestion = fw_suggestion_begin(name.text);
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q))
        fw_suggestion_offer(&suggestion, q->name);
    if (suggestion.best)
        return fw_scenario_fail(r->experiment->scenario, name.place, r->error,
                                "quantity %s is not known; did you mean %s?", name.text,
                                suggestion.best);
    return fw_scenario_fail(r->experiment->scenario, name.place, r->error,
                            "quantity %s is not known, expected one of `fretwork quantities`",
                            name.text);
}

static bool fits_model(const request *r, const fw_quantity *quantity, int body)
{
    return fw_quantity_fits(quantity, fw_experiment_solid(r->experiment, body)->model->name);
}

/* What is measured of the whole scene needs at least one body of its model. */
static fw_status expect_model(const request *r, const fw_quantity *quantity, fw_place place)
{
    for (int b = 0; b < r->experiment->body_count; ++b)
        if (fits_model(r, quantity, b)) return FW_OK;
    return fw_scenario_fail(r->experiment->scenario, place, r->error,
                            "%s is measured of a %s solid, but no body is one", quantity->name,
                            quantity->model);
}

/* Of walls: all, or those that are pistons. */
static bool fits_wall(const request *r, const fw_quantity *quantity, int wall)
{
    return quantity->scope == FW_SCOPE_WALL ||
           (quantity->scope == FW_SCOPE_PISTON && r->experiment->scenario->walls[wall].is_piston);
}

static bool fits_kind(const request *r, const fw_quantity *quantity, int analysis)
{
    const fw_analysis *of = r->observer->analyses[analysis];
    return strcmp(quantity->model, fw_analysis_kind_name(of->what->kind)) == 0;
}

/* What is measured where two bodies rub needs two that do. */
static bool has_what_it_takes(const request *r, const fw_quantity *quantity)
{
    const fw_solid *particles = fw_experiment_particles(r->experiment);
    if (strcmp(quantity->name, "slip") == 0) return fw_scene_grip_count(r->experiment->scene) >= 2;
    if (strcmp(quantity->name, "interface-force") == 0)
        return particles && fw_particles_group_count(particles) > 1;
    if (strcmp(quantity->name, "contact-return-force") == 0) return r->observer->profile != NULL;
    return true;
}

/* A quantity by its name alone: of everything that it can be measured of. */
static fw_status add_everywhere(request *r, const fw_quantity *quantity, fw_place place)
{
    const fw_subject nothing = no_subject(r);
    fw_subject subject = nothing;
    if (!has_what_it_takes(r, quantity)) return FW_OK;
    switch (quantity->scope) {
    case FW_SCOPE_SCENE:
    case FW_SCOPE_BODIES:
        FW_TRY(expect_model(r, quantity, place));
        return add_probe(r, quantity, nothing) < 0 ? FW_SYSTEM_FAILED : FW_OK;
    case FW_SCOPE_BODY:
        for (subject.body = 0; subject.body < r->experiment->body_count; ++subject.body)
            if (fits_model(r, quantity, subject.body) && add_probe(r, quantity, subject) < 0)
                return FW_SYSTEM_FAILED;
        return FW_OK;
    case FW_SCOPE_WALL:
    case FW_SCOPE_PISTON:
        for (subject.wall = 0; subject.wall < fw_scene_wall_count(r->experiment->scene);
             ++subject.wall)
            if (fits_wall(r, quantity, subject.wall) && add_probe(r, quantity, subject) < 0)
                return FW_SYSTEM_FAILED;
        return FW_OK;
    case FW_SCOPE_GRIP:
        for (subject.grip = 0; subject.grip < fw_scene_grip_count(r->experiment->scene);
             ++subject.grip)
            if (add_probe(r, quantity, subject) < 0) return FW_SYSTEM_FAILED;
        return FW_OK;
    case FW_SCOPE_STUDY:
        return fw_scenario_fail(r->experiment->scenario, place, r->error,
                                "%s comes out of all runs together; expected it in `expect`",
                                quantity->name);
    case FW_SCOPE_ANALYSIS:
        for (int n = 0; n < r->observer->analysis_count; ++n) {
            subject.analysis = r->observer->analyses[n];
            if (fits_kind(r, quantity, n) && add_probe(r, quantity, subject) < 0)
                return FW_SYSTEM_FAILED;
        }
        return FW_OK;
    case FW_SCOPE_SITE:
        break;
    }
    return fw_scenario_fail(r->experiment->scenario, place, r->error,
                            "%s is measured of a single site; expected it in `expect`, with body "
                            "and site",
                            quantity->name);
}

/* What a picture draws: "elongation", "elongation.chain", and either with ".x" behind it. All
 * components are measured, whichever is drawn. */
static fw_status add_drawn(request *r, fw_scenario_name name)
{
    char word[3][FW_NAME_BYTES + 1] = {"", "", ""};
    const char *rest = name.text;
    int words = 0;
    for (; rest && words < 3; ++words) {
        size_t length = strcspn(rest, ".");
        snprintf(word[words], sizeof word[words], "%.*s", (int)length, rest);
        rest = rest[length] ? rest + length + 1 : NULL;
    }
    const fw_quantity *quantity;
    FW_TRY(find_quantity(r, (fw_scenario_name){word[0], name.place}, &quantity));
    bool component = words > 1 && fw_quantity_find_component(quantity, word[words - 1]) >= 0;
    if (!has_what_it_takes(r, quantity))
        return fw_scenario_fail(r->experiment->scenario, name.place, r->error,
                                "there is nothing to measure %s of", quantity->name);
    if (words - component == 1 && !rest) return add_everywhere(r, quantity, name.place);
    fw_subject subject = no_subject(r);
    bool of_body = quantity->scope == FW_SCOPE_BODIES || quantity->scope == FW_SCOPE_BODY;
    for (int b = 0; b < r->experiment->body_count && of_body; ++b)
        if (strcmp(r->experiment->bodies[b].name, word[1]) == 0 && fits_model(r, quantity, b))
            subject.body = b;
    for (int w = 0; w < r->experiment->scenario->wall_count; ++w)
        if (fits_wall(r, quantity, w) &&
            strcmp(r->experiment->scenario->walls[w].def.name, word[1]) == 0)
            subject.wall = w;
    if (words - component == 2 && !rest && (subject.body >= 0 || subject.wall >= 0))
        return add_probe(r, quantity, subject) < 0 ? FW_SYSTEM_FAILED : FW_OK;
    return fw_scenario_fail(r->experiment->scenario, name.place, r->error,
                            "%s is not measured of %s, expected %s%s%s%s", quantity->name,
                            name.text + strlen(word[0]) + 1, quantity->name,
                            of_body                              ? " with the name of a body"
                            : quantity->scope == FW_SCOPE_WALL   ? " with the name of a wall"
                            : quantity->scope == FW_SCOPE_PISTON ? " with the name of a piston"
                                                                 : " alone",
                            quantity->components[0] ? " or with one of the components " : "",
                            quantity->components);
}

static fw_status choose_body(request *r, const fw_expectation *e, const fw_quantity *quantity,
                             fw_subject *subject)
{
    const fw_scenario *scenario = r->experiment->scenario;
    subject->body = e->body_index;
    if (subject->body < 0) FW_TRY(expect_model(r, quantity, e->quantity.place));
    if (subject->body < 0 && quantity->scope != FW_SCOPE_BODIES) {
        if (r->experiment->body_count != 1)
            return fw_scenario_fail(scenario, e->place, r->error,
                                    "%s is measured of one body, expected the key `body`",
                                    quantity->name);
        subject->body = 0;
    }
    if (subject->body >= 0 && !fits_model(r, quantity, subject->body))
        return fw_scenario_fail(scenario, e->quantity.place, r->error,
                                "%s is measured of bodies of model %s, but body %s is of model %s",
                                quantity->name, quantity->model,
                                r->experiment->bodies[subject->body].name,
                                fw_experiment_solid(r->experiment, subject->body)->model->name);
    if (quantity->scope == FW_SCOPE_SITE && !e->has_site)
        return fw_scenario_fail(scenario, e->place, r->error,
                                "%s is measured of a single site, expected the key `site`",
                                quantity->name);
    if (quantity->scope == FW_SCOPE_SITE)
        subject->particle = fw_sites_find(&r->experiment->bodies[subject->body].sites, e->site);
    return FW_OK;
}

static fw_status choose_wall(request *r, const fw_expectation *e, const fw_quantity *quantity,
                             fw_subject *subject)
{
    const char *kind = quantity->scope == FW_SCOPE_PISTON ? "piston" : "wall";
    int fitting = 0;
    subject->wall = e->wall_index;
    if (subject->wall >= 0 && !fits_wall(r, quantity, subject->wall))
        return fw_scenario_fail(r->experiment->scenario, e->wall.place, r->error,
                                "%s is measured of pistons, and the wall %s is none",
                                quantity->name, e->wall.text);
    if (subject->wall >= 0) return FW_OK;
    for (int w = fw_scene_wall_count(r->experiment->scene) - 1; w >= 0; --w) {
        if (!fits_wall(r, quantity, w)) continue;
        subject->wall = w;
        fitting += 1;
    }
    if (fitting != 1)
        return fw_scenario_fail(r->experiment->scenario, e->place, r->error,
                                "%s is measured of one %s, expected %s", quantity->name, kind,
                                fitting > 0 ? "the key `wall`" : "a wall with the key `piston`");
    return FW_OK;
}

static fw_status choose_grip(request *r, const fw_expectation *e, const fw_quantity *quantity,
                             fw_subject *subject)
{
    subject->grip = e->grip_index;
    if (subject->grip >= 0) return FW_OK;
    if (fw_scene_grip_count(r->experiment->scene) != 1)
        return fw_scenario_fail(r->experiment->scenario, e->place, r->error,
                                "%s is measured of one grip, expected the key `grip`",
                                quantity->name);
    subject->grip = 0;
    return FW_OK;
}

static fw_status choose_analysis(request *r, const fw_expectation *e, const fw_quantity *quantity,
                                 fw_subject *subject)
{
    const fw_scenario *scenario = r->experiment->scenario;
    int fitting = 0;
    for (int n = 0; n < scenario->analysis_count; ++n) {
        if (!fits_kind(r, quantity, n) || (e->analysis_index >= 0 && e->analysis_index != n))
            continue;
        subject->analysis = r->observer->analyses[n];
        fitting += 1;
    }
    if (fitting == 1) return FW_OK;
    if (fitting > 1)
        return fw_scenario_fail(scenario, e->place, r->error,
                                "%s is measured of one analysis, expected the key `analysis`",
                                quantity->name);
    if (e->analysis.text)
        return fw_scenario_fail(scenario, e->analysis.place, r->error,
                                "%s is measured of an analysis of kind %s, which %s is not",
                                quantity->name, quantity->model, e->analysis.text);
    return fw_scenario_fail(scenario, e->quantity.place, r->error,
                            "%s is measured of an analysis of kind %s, and the scenario has none",
                            quantity->name, quantity->model);
}

static fw_status choose_subject(request *r, const fw_expectation *e, const fw_quantity *quantity,
                                fw_subject *subject)
{
    const fw_scenario *scenario = r->experiment->scenario;
    *subject = no_subject(r);
    if (quantity->scope != FW_SCOPE_WALL && quantity->scope != FW_SCOPE_PISTON && e->wall.text)
        return fw_scenario_fail(scenario, e->wall.place, r->error,
                                "%s is not measured of a wall, expected no key `wall`",
                                quantity->name);
    if (quantity->scope != FW_SCOPE_GRIP && e->grip.text)
        return fw_scenario_fail(scenario, e->grip.place, r->error,
                                "%s is not measured of a grip, expected no key `grip`",
                                quantity->name);
    if (quantity->scope != FW_SCOPE_BODIES && quantity->scope != FW_SCOPE_BODY &&
        quantity->scope != FW_SCOPE_SITE && e->body.text)
        return fw_scenario_fail(scenario, e->body.place, r->error,
                                "%s is not measured of a body, expected no key `body`",
                                quantity->name);
    if (quantity->scope != FW_SCOPE_ANALYSIS && e->analysis.text)
        return fw_scenario_fail(scenario, e->analysis.place, r->error,
                                "%s is not measured of an analysis, expected no key `analysis`",
                                quantity->name);
    if (quantity->scope == FW_SCOPE_ANALYSIS) return choose_analysis(r, e, quantity, subject);
    if (!has_what_it_takes(r, quantity))
        return fw_scenario_fail(scenario, e->quantity.place, r->error,
                                "there is nothing to measure %s of", quantity->name);
    if (quantity->scope == FW_SCOPE_SCENE) return expect_model(r, quantity, e->quantity.place);
    if (quantity->scope == FW_SCOPE_WALL || quantity->scope == FW_SCOPE_PISTON)
        return choose_wall(r, e, quantity, subject);
    if (quantity->scope == FW_SCOPE_GRIP) return choose_grip(r, e, quantity, subject);
    return choose_body(r, e, quantity, subject);
}

static fw_status choose_component(request *r, const fw_expectation *e, const fw_quantity *quantity,
                                  int *component)
{
    const fw_scenario *scenario = r->experiment->scenario;
    *component = 0;
    if (!e->component.text) {
        if (fw_quantity_component_count(quantity) == 1) return FW_OK;
        return fw_scenario_fail(scenario, e->place, r->error,
                                "%s has the components %s, expected one of them in the key "
                                "`component`",
                                quantity->name, quantity->components);
    }
    if (quantity->components[0] == '\0')
        return fw_scenario_fail(scenario, e->component.place, r->error,
                                "%s is one number, expected no key `component`", quantity->name);
    *component = fw_quantity_find_component(quantity, e->component.text);
    if (*component >= 0) return FW_OK;
    return fw_scenario_fail(scenario, e->component.place, r->error,
                            "component %s of %s, expected one of %s", e->component.text,
                            quantity->name, quantity->components);
}

static fw_status add_outcome(request *r, int number, const fw_quantity *quantity)
{
    const fw_scenario *scenario = r->experiment->scenario;
    r->measurement->expected[number] = -1;
    r->measurement->component[number] = (int)(quantity - fw_layer_quantities);
    const fw_place place = scenario->expectations[number].quantity.place;
    if (!r->observer->profile)
        return fw_scenario_fail(scenario, place, r->error,
                                "%s comes out of a profile, and the scenario has none",
                                quantity->name);
    if (scenario->study.control_count > 0 ||
        !fw_layer_needs_control(r->measurement->component[number]))
        return FW_OK;
    return fw_scenario_fail(scenario, place, r->error,
                            "%s is measured against a control, and the study has none",
                            quantity->name);
}

static fw_status add_expected(request *r, int number)
{
    const fw_scenario *scenario = r->experiment->scenario;
    const fw_expectation *e = &scenario->expectations[number];
    const fw_quantity *quantity;
    fw_subject subject;
    FW_TRY(find_quantity(r, e->quantity, &quantity));
    if (quantity->scope == FW_SCOPE_STUDY) return add_outcome(r, number, quantity);
    FW_TRY(choose_subject(r, e, quantity, &subject));
    FW_TRY(choose_component(r, e, quantity, &r->measurement->component[number]));
    if (e->has_at && (e->at > scenario->run.steps || !fw_measurement_is_due(scenario, e->at)))
        return fw_scenario_fail(scenario, e->place, r->error,
                                "%s is expected after %lld steps, but it is measured every %lld "
                                "of %lld steps",
                                quantity->name, (long long)e->at,
                                (long long)scenario->run.measure_every,
                                (long long)scenario->run.steps);
    r->measurement->expected[number] = add_probe(r, quantity, subject);
    return r->measurement->expected[number] < 0 ? FW_SYSTEM_FAILED : FW_OK;
}

/* A sweep compares what is expected, and the measures of a layer. */
static fw_status check_compared(request *r, fw_scenario_name name)
{
    const fw_scenario *scenario = r->experiment->scenario;
    const fw_quantity *quantity;
    FW_TRY(find_quantity(r, name, &quantity));
    if (quantity->scope == FW_SCOPE_STUDY && scenario->profile.every != 0) return FW_OK;
    for (int n = 0; n < scenario->expectation_count; ++n)
        if (strcmp(scenario->expectations[n].quantity.text, name.text) == 0) return FW_OK;
    return fw_scenario_fail(scenario, name.place, r->error,
                            "a picture of a sweep draws %s, which the sweep does not compare: "
                            "expected a quantity of 'expect'%s",
                            name.text,
                            scenario->profile.every != 0 ? ", or a measure of the layer" : "");
}

static bool is_measured(const request *r, const fw_quantity *quantity)
{
    for (int n = 0; n < r->measurement->probe_count; ++n)
        if (r->measurement->probes[n].quantity == quantity) return true;
    return false;
}

static fw_status add_all(request *r)
{
    const fw_scenario *scenario = r->experiment->scenario;
    const fw_quantity *quantity;
    for (int n = 0; n < scenario->measure.count; ++n) {
        FW_TRY(find_quantity(r, scenario->measure.item[n], &quantity));
        int probes = r->measurement->probe_count;
        FW_TRY(add_everywhere(r, quantity, scenario->measure.item[n].place));
        if (r->measurement->probe_count == probes && !is_measured(r, quantity))
            return fw_scenario_fail(scenario, scenario->measure.item[n].place, r->error,
                                    "there is nothing to measure %s of", quantity->name);
    }
    for (int n = 0; scenario->measure.count == 0 && standard_set[n]; ++n)
        FW_TRY(add_everywhere(r, fw_quantity_find(standard_set[n]), (fw_place){0}));
    for (int n = 0; scenario->profile.every != 0 && profile_set[n]; ++n)
        FW_TRY(add_everywhere(r, fw_quantity_find(profile_set[n]), (fw_place){0}));
    /* Pictures draw pistons where they were. */
    FW_TRY(add_everywhere(r, fw_quantity_find(piston_place), (fw_place){0}));
    for (int n = 0; n < scenario->expectation_count; ++n) FW_TRY(add_expected(r, n));
    for (int p = 0; p < scenario->picture_count; ++p) {
        const fw_scenario_picture *picture = &scenario->pictures[p];
        for (int n = 0; n < picture->observables.count; ++n)
            FW_TRY(fw_picture_rows[picture->kind].needs & FW_PICTURE_NEEDS_SWEEP
                       ? check_compared(r, picture->observables.item[n])
                       : add_drawn(r, picture->observables.item[n]));
    }
    return FW_OK;
}

static fw_status allocate_rows(fw_measurement *m, const fw_scenario *scenario, fw_error *error)
{
    m->capacity = fw_measurement_row_count(scenario);
    size_t rows = (size_t)m->capacity;
    m->steps = fw_array_allocate(rows, sizeof *m->steps);
    m->times = fw_array_allocate(rows, sizeof *m->times);
    m->values = fw_array_allocate(rows, (size_t)m->width * sizeof *m->values);
    if (m->steps && m->times && m->values) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED,
                   "not enough memory for %lld rows of %d measured numbers; a larger "
                   "run.measure-every takes fewer",
                   (long long)m->capacity, m->width);
}

fw_status fw_measurement_create(fw_measurement **measurement, const fw_observer *observer,
                                fw_error *error)
{
    *measurement = NULL;
    const fw_scenario *scenario = observer->experiment->scenario;
    fw_measurement *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "a measurement");
    made->expected = calloc((size_t)scenario->expectation_count + 1, sizeof *made->expected);
    made->component = calloc((size_t)scenario->expectation_count + 1, sizeof *made->component);
    request r = {observer, observer->experiment, made, error};
    fw_status status =
        made->expected && made->component ? add_all(&r) : fw_fail_memory(error, "the expectations");
    if (status == FW_OK) status = allocate_rows(made, scenario, error);
    if (status != FW_OK) {
        fw_measurement_destroy(made);
        return status;
    }
    *measurement = made;
    return FW_OK;
}

void fw_measurement_destroy(fw_measurement *measurement)
{
    if (!measurement) return;
    free(measurement->probes);
    free(measurement->steps);
    free(measurement->times);
    free(measurement->values);
    free(measurement->expected);
    free(measurement->component);
    free(measurement);
}

bool fw_measurement_is_due(const fw_scenario *scenario, int64_t step)
{
    return step % scenario->run.measure_every == 0 || step == scenario->run.steps;
}

int64_t fw_measurement_row_count(const fw_scenario *scenario)
{
    int64_t whole = scenario->run.steps / scenario->run.measure_every;
    return whole + 1 + (scenario->run.steps % scenario->run.measure_every != 0);
}

const double *fw_measurement_take(fw_measurement *measurement, const fw_experiment *experiment)
{
    double *row = measurement->values + measurement->count * measurement->width;
    measurement->steps[measurement->count] = fw_scene_steps(experiment->scene);
    measurement->times[measurement->count] = fw_scene_time(experiment->scene);
    for (int n = 0; n < measurement->probe_count; ++n) {
        const fw_probe *probe = &measurement->probes[n];
        probe->quantity->measure(experiment, probe->subject, row + probe->first);
    }
    measurement->count += 1;
    return row;
}

void fw_measurement_restore(fw_measurement *measurement, int64_t step, double time,
                            const double *row)
{
    measurement->steps[measurement->count] = step;
    measurement->times[measurement->count] = time;
    memcpy(measurement->values + measurement->count * measurement->width, row,
           (size_t)measurement->width * sizeof *row);
    measurement->count += 1;
}
