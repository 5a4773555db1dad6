/* SPDX-License-Identifier: GPL-3.0-or-later */
/* averages.c - blocking analysis of time series. Keeps no state.
 * Start reading at fw_average_of_series(). */
#include "core/averages.h"

#include "core/array.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCKS_LEAST = 8 }; /* fewer say nothing about their spread */

fw_average fw_average_of_replicas(const double *values, size_t count)
{
    assert(count >= 1);
    const double mean = fw_array_sum(values, count) / (double)count;
    double squares = 0;
    for (size_t k = 0; k < count; ++k) squares += (values[k] - mean) * (values[k] - mean);
    fw_average average = {
        .mean = mean, .error = INFINITY, .correlation = 1, .count = count, .converged = count > 1};
    if (count > 1) {
        const double variance = squares / (double)(count - 1);
        average.deviation = sqrt(variance);
        average.error = sqrt(variance / (double)count);
    }
    return average;
}

fw_average fw_average_of_known(double *values, size_t count)
{
    size_t known = 0;
    for (size_t k = 0; k < count; ++k)
        if (isfinite(values[k])) values[known++] = values[k];
    fw_average average = {.mean = NAN, .correlation = 1};
    if (known > 0) average = fw_average_of_replicas(values, known);
    if (known < 2) average.error = NAN;
    return average;
}

/* Means of pairs of neighbours, in place; an odd last one is left out. */
static size_t pair_up(double *values, size_t count)
{
    for (size_t k = 0; k < count / 2; ++k) values[k] = 0.5 * (values[2 * k] + values[2 * k + 1]);
    return count / 2;
}

fw_status fw_average_of_series(fw_average *average, const double *values, size_t count,
                               fw_error *error)
{
    *average = fw_average_of_replicas(values, count);
    const double plain = average->error;
    if (count < 2 || !(plain > 0)) return FW_OK;
    double *blocks = fw_array_of_doubles(count);
    if (!blocks) return fw_fail_memory(error, "the blocks of a time series");
    memcpy(blocks, values, count * sizeof *blocks);
    average->converged = false;
    double length = 1;
    for (size_t left = count; left >= BLOCKS_LEAST; left = pair_up(blocks, left), length *= 2) {
        const double now = fw_average_of_replicas(blocks, left).error;
        average->error = fmax(now, average->error);
        const double ratio = now / plain;
        if (length * length * length > 2 * (double)count * ratio * ratio * ratio * ratio) {
            average->error = now;
            average->converged = true;
            break;
        }
    }
    free(blocks);
    average->correlation = average->error * average->error / (plain * plain);
    return FW_OK;
}

fw_status fw_average_drift(double *drift, const double *values, size_t count, fw_error *error)
{
    assert(count >= 4);
    const size_t half = count / 2;
    fw_average first, second;
    FW_TRY(fw_average_of_series(&first, values, half, error));
    FW_TRY(fw_average_of_series(&second, values + (count - half), half, error));
    const double spread = hypot(first.error, second.error);
    *drift = spread > 0 ? fabs(second.mean - first.mean) / spread
                        : (second.mean == first.mean ? 0 : INFINITY);
    return FW_OK;
}
