/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_averages.c - errors of means know about correlation in time. */
#include "tests/support/laws.h"

#include "core/averages.h"
#include "core/noise.h"

#include <stdlib.h>

/* x_{k+1} = memory x_k + sqrt(1 - memory^2) xi: variance 1, and (1 + memory)/(1 - memory) values
 * count as one. */
static void correlated_series(double *values, int count, double memory, uint64_t seed)
{
    double x = fw_noise_gaussian(seed, 0, 0, 0).x;
    for (int k = 0; k < count; ++k) {
        values[k] = x;
        x = memory * x + sqrt(1 - memory * memory) * fw_noise_gaussian(seed, 1, (uint64_t)k, 0).x;
    }
}

/* Over 200 series the estimated error is that of the means themselves: to 15 %, three times what
 * 200 of them can tell, plus what blocks of finite length lack. */
static void estimated_errors_are_the_spread_of_means(void **state)
{
    (void)state;
    enum { SERIES = 200, COUNT = 8192 };
    double *values = malloc(COUNT * sizeof *values), means[SERIES], errors[SERIES];
    const double memories[] = {0, 0.8, 0.95};
    for (int m = 0; m < 3; ++m) {
        double inefficiency = 0;
        for (int s = 0; s < SERIES; ++s) {
            correlated_series(values, COUNT, memories[m], (uint64_t)(s + 1000 * m));
            fw_average average;
            assert_int_equal(fw_average_of_series(&average, values, COUNT, NULL), FW_OK);
            assert_true(average.converged);
            means[s] = average.mean;
            errors[s] = average.error * average.error;
            inefficiency += average.correlation / SERIES;
        }
        const double spread = fw_average_of_replicas(means, SERIES).deviation;
        const double estimated = sqrt(fw_average_of_replicas(errors, SERIES).mean);
        assert_close(estimated / spread, 1, 0.15);
        const double exact = (1 + memories[m]) / (1 - memories[m]);
        assert_close(inefficiency / exact, 1, 0.12);
    }
    free(values);
}

static void short_series_say_that_they_are(void **state)
{
    (void)state;
    double values[64];
    correlated_series(values, 64, 0.99, 5);
    fw_average average;
    assert_int_equal(fw_average_of_series(&average, values, 64, NULL), FW_OK);
    assert_false(average.converged);
    assert_int_equal(fw_average_of_series(&average, values, 1, NULL), FW_OK);
    assert_false(average.converged);
    assert_true(isinf(average.error));
    for (int k = 0; k < 64; ++k) values[k] = 2;
    assert_int_equal(fw_average_of_series(&average, values, 64, NULL), FW_OK);
    assert_close(average.mean, 2, 0);
    assert_close(average.error, 0, 0);
}

static void replicas_have_the_plain_error(void **state)
{
    (void)state;
    const double values[] = {1, 2, 3, 4};
    const fw_average average = fw_average_of_replicas(values, 4);
    assert_close(average.mean, 2.5, 1e-15);
    assert_close(average.deviation, sqrt(5. / 3), 1e-15);
    assert_close(average.error, sqrt(5. / 12), 1e-15);
}

static void only_what_is_known_is_averaged(void **state)
{
    (void)state;
    double values[] = {NAN, 1, INFINITY, 2, 3, -INFINITY, 4}, one[] = {NAN, 7}, none[] = {NAN};
    fw_average average = fw_average_of_known(values, 7);
    assert_int_equal(average.count, 4);
    assert_close(average.mean, 2.5, 1e-15);
    assert_close(average.error, sqrt(5. / 12), 1e-15);
    average = fw_average_of_known(one, 2);
    assert_int_equal(average.count, 1);
    assert_close(average.mean, 7, 0);
    assert_true(isnan(average.error));
    average = fw_average_of_known(none, 1);
    assert_int_equal(average.count, 0);
    assert_true(isnan(average.mean) && isnan(average.error));
    average = fw_average_of_known(NULL, 0);
    assert_true(isnan(average.mean));
}

static void drift_tells_a_steady_state(void **state)
{
    (void)state;
    enum { COUNT = 4096 };
    double *values = malloc(COUNT * sizeof *values), drift;
    correlated_series(values, COUNT, 0.5, 3);
    assert_int_equal(fw_average_drift(&drift, values, COUNT, NULL), FW_OK);
    assert_below(drift, 3);
    for (int k = 0; k < COUNT; ++k) values[k] += 1. * k / COUNT;
    assert_int_equal(fw_average_drift(&drift, values, COUNT, NULL), FW_OK);
    assert_below(3, drift);
    /* Without any spread: none, or more than any number. */
    for (int n = 0; n < COUNT; ++n) values[n] = 2;
    assert_int_equal(fw_average_drift(&drift, values, COUNT, NULL), FW_OK);
    assert_close(drift, 0, 0);
    for (int n = COUNT / 2; n < COUNT; ++n) values[n] = 3;
    assert_int_equal(fw_average_drift(&drift, values, COUNT, NULL), FW_OK);
    assert_true(isinf(drift));
    free(values);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(estimated_errors_are_the_spread_of_means),
        cmocka_unit_test(short_series_say_that_they_are),
        cmocka_unit_test(replicas_have_the_plain_error),
        cmocka_unit_test(only_what_is_known_is_averaged),
        cmocka_unit_test(drift_tells_a_steady_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
