/* SPDX-License-Identifier: GPL-3.0-or-later */
/* asked.h - a scenario from text as it is measured, and its numbers by their whole names. */
#ifndef FW_TEST_ASKED_H
#define FW_TEST_ASKED_H

#include "experiments/measures/measurement.h"
#include "tests/support/scratch.h"

static fw_scenario *scenario;
static fw_observer *observer;

static inline void observe(const char *text)
{
    assert_fine(fw_scenario_read(&scenario, "t.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_observer_create(&observer, scenario, &error));
}

static inline void end(void)
{
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

/* One number: "phase-speed.two.slow". */
static inline double number(const char *name)
{
    double out[FW_COMPONENTS_MAX];
    int count;
    assert_fine(fw_measurement_look(observer, name, out, &count, &error));
    assert_int_equal(count, 1);
    return out[0];
}

#endif
