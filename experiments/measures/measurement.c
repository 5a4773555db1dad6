/* SPDX-License-Identifier: GPL-3.0-or-later */
/* measurement.c - the series of what is measured. Invariant: rows ascend in step. State:
 * fw_measurement, its rows so far. Start reading at fw_measurement_take(). */
#include "experiments/measures/measurement.h"

#include "measurement_plan.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    fw_status status = made->expected && made->component
                           ? fw_measurement_plan(made, observer, error)
                           : fw_fail_memory(error, "the expectations");
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
    return fw_scenario_count_samples(scenario, step, step) > 0;
}

int64_t fw_measurement_row_count(const fw_scenario *scenario)
{
    return fw_scenario_count_samples(scenario, 0, scenario->run.steps);
}

bool fw_measurement_needs_positions(const fw_measurement *measurement)
{
    for (int n = 0; n < measurement->probe_count; ++n)
        if (measurement->probes[n].quantity->needs != FW_NEEDS_NO_POSITIONS) return true;
    return false;
}

const double *fw_measurement_take(fw_measurement *measurement, const fw_experiment *experiment)
{
    assert(measurement->count < measurement->capacity);
    double *row = measurement->values + measurement->count * measurement->width;
    measurement->steps[measurement->count] = fw_scene_steps(experiment->scene);
    measurement->times[measurement->count] = fw_scene_time(experiment->scene);
    for (int n = 0; n < measurement->probe_count; ++n) {
        const fw_probe *probe = &measurement->probes[n];
        probe->quantity->measure(experiment, probe->subject, row + probe->first);
    }
    /* One NaN for all that is no number, whatever its sign and bits. */
    for (int c = 0; c < measurement->width; ++c)
        if (!isfinite(row[c])) row[c] = NAN;
    measurement->count += 1;
    return row;
}

void fw_measurement_restore(fw_measurement *measurement, int64_t step, double time,
                            const double *row)
{
    assert(measurement->count < measurement->capacity);
    measurement->steps[measurement->count] = step;
    measurement->times[measurement->count] = time;
    memcpy(measurement->values + measurement->count * measurement->width, row,
           (size_t)measurement->width * sizeof *row);
    measurement->count += 1;
}
