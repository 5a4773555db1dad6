/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measurement_plan.c - which quantities a scenario needs, and of what: in `measure`, in its
 * expectations, in its pictures. Keeps no state; fills the probes of a measurement.
 * Invariant: no two probes have the same quantity and subject. Start reading at add_all(). */
#include "measurement_plan.h"

#include "experiments/measures/layer.h"
#include "experiments/measures/subject.h"

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

/* Adds a probe unless there is one already; returns its number, or -1 without memory. */
static int add_probe(request *r, const fw_quantity *quantity, fw_subject subject)
{
    fw_measurement *m = r->measurement;
    for (int n = 0; n < m->probe_count; ++n) {
        const fw_probe *p = &m->probes[n];
        if (p->quantity == quantity && fw_subject_equals(p->subject, subject)) return n;
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
    char name[FW_SUBJECT_NAME];
    fw_subject_name(r->observer, subject, name);
    snprintf(probe->label, sizeof probe->label, "%s%s%s", quantity->name, name[0] ? "." : "", name);
    m->width += probe->components;
    return m->probe_count++;
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

/* A quantity by its name alone: of everything that it can be measured of. */
static fw_status add_everywhere(request *r, const fw_quantity *quantity, fw_place place)
{
    const fw_scenario *scenario = r->experiment->scenario;
    const int count = fw_subject_count(r->observer, quantity);
    if (quantity->scope == FW_SCOPE_STUDY)
        return fw_scenario_fail(scenario, place, r->error,
                                "%s comes out of all runs together; expected it in `expect`",
                                quantity->name);
    if (quantity->scope == FW_SCOPE_SITE)
        return fw_scenario_fail(scenario, place, r->error,
                                "%s is measured of a single site; expected it in `expect`, with "
                                "body and site",
                                quantity->name);
    if (!fw_subject_exists(r->observer, quantity)) return FW_OK;
    const bool of_scene = quantity->scope == FW_SCOPE_SCENE || quantity->scope == FW_SCOPE_BODIES;
    if (of_scene) FW_TRY(expect_model(r, quantity, place));
    for (int n = 0; n < count; ++n) {
        fw_subject subject;
        if (!fw_subject_at(r->observer, quantity, n, &subject)) continue;
        if (add_probe(r, quantity, subject) < 0) return FW_SYSTEM_FAILED;
        if (of_scene) break; /* of bodies: all together */
    }
    return FW_OK;
}

/* What `measure` or a picture names: "elongation", "elongation.chain", and either with ".x" behind
 * it. All components are measured, whichever is drawn. */
static fw_status add_named(request *r, fw_schema_name name)
{
    const fw_quantity *quantity;
    fw_subject subject;
    bool named;
    FW_TRY(fw_subject_find_quantity(r->observer, name, &quantity, r->error));
    if (quantity->scope == FW_SCOPE_STUDY) return add_everywhere(r, quantity, name.place);
    if (!fw_subject_exists(r->observer, quantity))
        return fw_scenario_fail(r->experiment->scenario, name.place, r->error,
                                "there is nothing to measure %s of", quantity->name);
    FW_TRY(fw_subject_find(r->observer, quantity, name, &named, &subject, r->error));
    if (!named) return add_everywhere(r, quantity, name.place);
    return add_probe(r, quantity, subject) < 0 ? FW_SYSTEM_FAILED : FW_OK;
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
    *subject = fw_subject_none(r->observer);
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
    if (!fw_subject_exists(r->observer, quantity))
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
    FW_TRY(fw_subject_find_quantity(r->observer, e->quantity, &quantity, r->error));
    if (quantity->scope == FW_SCOPE_STUDY) return add_outcome(r, number, quantity);
    FW_TRY(choose_subject(r, e, quantity, &subject));
    FW_TRY(choose_component(r, e, quantity, &r->measurement->component[number]));
    r->measurement->expected[number] = add_probe(r, quantity, subject);
    return r->measurement->expected[number] < 0 ? FW_SYSTEM_FAILED : FW_OK;
}

/* A sweep compares what is expected, and the measures of a layer. */
static fw_status check_compared(request *r, fw_schema_name name)
{
    const fw_scenario *scenario = r->experiment->scenario;
    const fw_quantity *quantity;
    FW_TRY(fw_subject_find_quantity(r->observer, name, &quantity, r->error));
    if (quantity->scope == FW_SCOPE_STUDY && scenario->profile.every != 0) return FW_OK;
    const char *near = NULL;
    for (int n = 0; n < scenario->expectation_count; ++n) {
        const char *expected = scenario->expectations[n].quantity.text;
        if (strcmp(expected, name.text) == 0) return FW_OK;
        if (strcmp(expected, quantity->name) == 0) near = expected;
    }
    if (near)
        return fw_scenario_fail(scenario, name.place, r->error,
                                "a picture of a sweep draws %s, expected %s alone: it shows what "
                                "'expect' asks of it",
                                name.text, near);
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
        FW_TRY(
            fw_subject_find_quantity(r->observer, scenario->measure.item[n], &quantity, r->error));
        int probes = r->measurement->probe_count;
        FW_TRY(add_named(r, scenario->measure.item[n]));
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
                       : add_named(r, picture->observables.item[n]));
    }
    return FW_OK;
}

fw_status fw_measurement_plan(fw_measurement *measurement, const fw_observer *observer,
                              fw_error *error)
{
    request r = {observer, observer->experiment, measurement, error};
    return add_all(&r);
}

fw_status fw_measurement_plan_named(fw_measurement *measurement, const fw_observer *observer,
                                    fw_schema_name name, fw_error *error)
{
    request r = {observer, observer->experiment, measurement, error};
    return add_named(&r, name);
}
