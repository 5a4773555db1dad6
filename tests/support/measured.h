/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measured.h - one experiment from text, and the quantities of it by name. */
#ifndef FW_TEST_MEASURED_H
#define FW_TEST_MEASURED_H

#include "experiments/measures/quantity.h"
#include "tests/support/scenarios.h"

static fw_scenario *scenario;
static fw_experiment *experiment;
static const char *const tensor_names[] __attribute__((unused)) = {"xx", "xy", "yx", "yy"};

static inline void begin(const char *text)
{
    scenario = read_right(text);
    experiment = build_right(scenario);
}

static inline void end(void)
{
    fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
}

/* component NULL: of what is one number. */
static inline double value_at(const char *name, fw_subject subject, const char *component)
{
    double out[FW_COMPONENTS_MAX];
    const fw_quantity *quantity = fw_quantity_find(name);
    assert_non_null(quantity);
    quantity->measure(experiment, subject, out);
    const int c = component ? fw_quantity_find_component(quantity, component) : 0;
    assert_true(c >= 0);
    return out[c];
}

/* body -1: of the scene. */
static inline double value_of(const char *name, int body, const char *component)
{
    return value_at(name, (fw_subject){.body = body, .wall = -1, .grip = -1, .particle = -1},
                    component);
}

static inline fw_solid *solid_of_body(int body)
{
    return fw_scene_body(experiment->scene, experiment->bodies[body].solid);
}

static inline void run_steps(int steps)
{
    for (int step = 0; step < steps; ++step) assert_fine(fw_experiment_step(experiment, &error));
}

#endif
