/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_contact_keys.c - distances that a scenario may ask for, and those that it may not. */
#include "tests/support/laws.h"

#include "experiments/setup/experiment.h"
#include "tests/support/scratch.h"

#define BODIES                                                                                     \
    "title: two\n"                                                                                 \
    "materials: {m: {lattice-boltzmann: {}}}\n"                                                    \
    "bodies:\n"                                                                                    \
    "  one: {material: m, shape: {rectangle: [3, 3]}, surface: wax}\n"
#define RUN "run: {steps: 1}\n"

static fw_status make(const char *text)
{
    fw_scenario *scenario;
    fw_experiment *experiment;
    error = (fw_error){0};
    fw_status status = fw_scenario_read(&scenario, "s.yaml", text, strlen(text), NULL, 0, &error);
    if (status != FW_OK) return status;
    status = fw_experiment_create(&experiment, scenario, &error);
    if (status == FW_OK) fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
    return status;
}

static void distances_are_kept_by_what_has_an_edge(void **state)
{
    (void)state;
    assert_refused(make("title: grains\nmaterials: {n: {movable-particles: {}}}\nbodies: {two: "
                        "{material: n, lattice: hexagonal, shape: {rectangle: [3, 3]}}}\n"
                        "contact: {distance: 0.5}\n" RUN),
                   FW_BAD_INPUT, "body two is of model movable-particles");
    assert_refused(make(BODIES "contact: {distance: -1}\n" RUN), FW_BAD_INPUT,
                   "s.yaml:5:21: contact.distance is '-1', expected");
}

static void bodies_start_no_nearer(void **state)
{
    (void)state;
    static const char near[] =
        BODIES "  two: {material: m, origin: [2.4, 0], shape: {rectangle: [3, 3]}, surface: wax}\n";
    char text[1024];
    snprintf(text, sizeof text, "%scontact: {distance: 0.3}\n%s", near, RUN);
    assert_int_equal(make(text), FW_OK);
    snprintf(text, sizeof text, "%scontact: {distance: 0.5}\n%s", near, RUN);
    assert_refused(make(text), FW_BAD_INPUT, "expected at least the contact distance, 0.5");
    snprintf(text, sizeof text,
             "%scontact: {pairs: [{between: [wax, wax], friction: 0, distance: 0.6}]}\n%s", near,
             RUN);
    assert_refused(make(text), FW_BAD_INPUT, "expected at least the contact distance, 0.6");
    assert_refused(make(BODIES "walls: {floor: {chain: [[-9, -0.2], [9, -0.2]]}}\n"
                               "contact: {distance: 0.5}\n" RUN),
                   FW_BAD_INPUT, "body one starts in wall floor");
}

static void walls_have_one_distance(void **state)
{
    (void)state;
    assert_refused(
        make(BODIES "walls: {floor: {chain: [[-9, -1], [9, -1]], surface: {named: ice}}}\n"
                    "contact: {pairs: [{between: [wax, ice], friction: 0, distance: 0.6}]}\n" RUN),
        FW_BAD_INPUT, "bodies keep contact.distance from walls, and wall floor is of the surface");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_are_kept_by_what_has_an_edge),
        cmocka_unit_test(bodies_start_no_nearer),
        cmocka_unit_test(walls_have_one_distance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
