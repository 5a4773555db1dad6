/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenarios.h - scenarios from text, and experiments built from them. */
#ifndef FW_TEST_SCENARIOS_H
#define FW_TEST_SCENARIOS_H

#include "experiments/setup/experiment.h"
#include "tests/support/laws.h"
#include "tests/support/scratch.h"

#include <string.h>

static inline fw_status read_text(fw_scenario **scenario, const char *text)
{
    return fw_scenario_read(scenario, "t.yaml", text, strlen(text), NULL, 0, &error);
}

static inline fw_scenario *read_right(const char *text)
{
    fw_scenario *scenario;
    assert_fine(read_text(&scenario, text));
    return scenario;
}

static inline fw_experiment *build_right(const fw_scenario *scenario)
{
    fw_experiment *experiment;
    assert_fine(fw_experiment_create(&experiment, scenario, &error));
    return experiment;
}

#endif
