/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_verdict.c - statistics of series by hand, and what is said of numbers that there are not. */
#include "tests/support/laws.h"

#include "experiments/measures/layer.h"
#include "experiments/measures/verdict.h"

#include <string.h>

enum { ROWS = 5, LONG = 64 };

static int64_t steps[LONG];
static double times[LONG], values[LONG];

/* What is found of the values in the steps from .. until; two time units are a row of ten steps. */
static fw_verdict found_in(const char *quantity, int rows, fw_statistic what, int64_t from,
                           int64_t until)
{
    static fw_expectation e;
    static int expected, component;
    static fw_probe probe;
    e = (fw_expectation){.quantity.text = quantity,
                         .statistic = what,
                         .from = from,
                         .until = until,
                         .kind = FW_VERDICT_BOUNDS,
                         .has_above = true,
                         .above = -1e9};
    const fw_scenario scenario = {.expectations = &e, .expectation_count = 1, .study.seeds = 1};
    probe = (fw_probe){.quantity = fw_quantity_find(quantity), .components = 1};
    snprintf(probe.label, sizeof probe.label, "%s", quantity);
    for (int n = 0; n < rows; ++n) steps[n] = 10 * n, times[n] = 2 * n;
    const fw_measurement m = {.probe_count = 1,
                              .probes = &probe,
                              .width = 1,
                              .count = rows,
                              .steps = steps,
                              .times = times,
                              .values = values,
                              .expected = &expected,
                              .component = &component};
    return fw_verdict_of(&scenario, &m, 0);
}

static double five(fw_statistic what)
{
    memcpy(values, (double[]){3, -5, 4, 4, 1}, ROWS * sizeof *values);
    const fw_verdict v = found_in("energy", ROWS, what, 0, INT64_MAX);
    assert_true(v.holds);
    assert_string_equal(fw_verdict_word(&v), "holds");
    return v.measured;
}

static void statistics_are_those_by_hand(void **state)
{
    (void)state;
    assert_close(five(FW_STATISTIC_FIRST), 3, 0);
    assert_close(five(FW_STATISTIC_LAST), 1, 0);
    assert_close(five(FW_STATISTIC_MAXIMUM), 4, 0);
    assert_close(five(FW_STATISTIC_MINIMUM), -5, 0);
    assert_close(five(FW_STATISTIC_LARGEST), 5, 0);
    assert_close(five(FW_STATISTIC_MEAN), 1.4, 1e-15);
    assert_close(five(FW_STATISTIC_SPREAD), sqrt(57.2 / 4), 1e-15);
    assert_close(five(FW_STATISTIC_CHANGE), -2, 0);
    assert_close(five(FW_STATISTIC_RATE), .25, 1e-15); /* 5/10 a row, of two time units */
    assert_close(five(FW_STATISTIC_TIME_OF_MAXIMUM), 4, 0);
    assert_close(five(FW_STATISTIC_TIME_OF_MINIMUM), 2, 0);
}

static void a_window_takes_both_its_ends(void **state)
{
    (void)state;
    memcpy(values, (double[]){3, -5, 4, 4, 1}, ROWS * sizeof *values);
    assert_close(found_in("energy", ROWS, FW_STATISTIC_MEAN, 10, 20).measured, -.5, 1e-15);
    assert_close(found_in("energy", ROWS, FW_STATISTIC_FIRST, 11, 40).measured, 4, 0);
    assert_close(found_in("energy", ROWS, FW_STATISTIC_LAST, 0, 39).measured, 4, 0);
}

/* Whatever was expected, what is no number does not hold it. */
static void what_is_no_number_is_not_measured(void **state)
{
    (void)state;
    static const fw_statistic two[] = {FW_STATISTIC_SPREAD, FW_STATISTIC_CHANGE, FW_STATISTIC_RATE};
    memcpy(values, (double[]){3, -5, 4, 4, 1}, ROWS * sizeof *values);
    for (size_t n = 0; n < sizeof two / sizeof two[0]; ++n) {
        const fw_verdict v = found_in("energy", ROWS, two[n], 10, 19);
        assert_true(isnan(v.measured) && !v.holds);
        assert_string_equal(v.found, "no number: one sample, where two are needed");
        assert_string_equal(fw_verdict_word(&v), "not measured");
    }
    fw_verdict v = found_in("energy", ROWS, FW_STATISTIC_MEAN, 10, 19);
    assert_close(v.measured, -5, 0);
    v = found_in("energy", ROWS, FW_STATISTIC_MEAN, 11, 19);
    assert_false(v.holds);
    assert_string_equal(v.found, "no number: nothing is measured in these steps");
    values[2] = NAN;
    for (int what = 0; what <= FW_STATISTIC_TIME_OF_MINIMUM; ++what) {
        if (what == FW_STATISTIC_FIRST || what == FW_STATISTIC_LAST ||
            what == FW_STATISTIC_CHANGE || what >= FW_STATISTIC_TIME_OF_MAXIMUM)
            continue;
        v = found_in("friction-ratio", ROWS, (fw_statistic)what, 0, INT64_MAX);
        assert_false(v.holds);
        assert_string_equal(v.found, "no number: nothing has pressed on the wall");
    }
}

/* A series that wanders once up and down is too short to tell its own error. */
static void an_error_that_is_a_lower_bound_is_called_one(void **state)
{
    (void)state;
    for (int n = 0; n < LONG; ++n) values[n] = cos(2 * acos(-1) * n / LONG);
    fw_verdict v = found_in("energy", LONG, FW_STATISTIC_MEAN, 0, INT64_MAX);
    assert_true(v.at_least);
    assert_non_null(strstr(v.found, " +- >= "));
    for (int n = 0; n < LONG; ++n) values[n] = n * 7919 % 64 - 31.5;
    v = found_in("energy", LONG, FW_STATISTIC_MEAN, 0, INT64_MAX);
    assert_false(v.at_least);
    assert_null(strstr(v.found, ">="));
    assert_non_null(strstr(v.found, " +- "));
}

/* "100 +- 1" holds 100.9 and not 101.1, "100 +- 1 %" too; "2 +- 1 %" does not hold 2.1. */
static void bounds_are_absolute_or_relative(void **state)
{
    (void)state;
    static const struct {
        fw_verdict_kind kind;
        double value, within, measured;
        bool holds;
    } cases[] = {
        {FW_VERDICT_VALUE, 100, 1, 100.9, true},      {FW_VERDICT_VALUE, 100, 1, 101.1, false},
        {FW_VERDICT_RELATIVE, 100, .01, 100.9, true}, {FW_VERDICT_RELATIVE, 100, .01, 98.9, false},
        {FW_VERDICT_RELATIVE, 2, .01, 2.1, false},    {FW_VERDICT_RELATIVE, -2, .01, -2.01, true},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        const fw_expectation e = {.quantity.text = "energy",
                                  .kind = cases[n].kind,
                                  .value = cases[n].value,
                                  .within = cases[n].within};
        fw_verdict v = {.expectation = &e, .measured = cases[n].measured, .error = NAN, .seeds = 1};
        fw_verdict_judge(&v);
        assert_int_equal(v.holds, cases[n].holds);
    }
}

/* --- studies --- */

enum { SEEDS = 3 };

/* The last value of each seed, expected above 0. */
static fw_verdict found_over(const double last[SEEDS])
{
    static fw_expectation e = {.quantity.text = "friction-ratio",
                               .until = INT64_MAX,
                               .kind = FW_VERDICT_BOUNDS,
                               .has_above = true};
    static int expected, component;
    static fw_probe probe = {.label = "friction-ratio", .components = 1};
    static fw_measurement all[SEEDS];
    static const fw_measurement *seeds[SEEDS];
    static double of_seeds[SEEDS];
    const fw_scenario scenario = {.expectations = &e, .expectation_count = 1, .study.seeds = SEEDS};
    probe.quantity = fw_quantity_find(probe.label);
    for (int n = 0; n < SEEDS; ++n) {
        of_seeds[n] = last[n];
        all[n] = (fw_measurement){.probe_count = 1,
                                  .probes = &probe,
                                  .width = 1,
                                  .count = 1,
                                  .steps = steps,
                                  .times = times,
                                  .values = &of_seeds[n],
                                  .expected = &expected,
                                  .component = &component,
                                  .seeds = seeds,
                                  .seed_count = SEEDS};
        seeds[n] = &all[n];
    }
    for (int n = 0; n < SEEDS; ++n) {
        const double found = fw_verdict_of_seed(&scenario, &all[0], 0, n);
        assert_true(found == last[n] || (isnan(found) && isnan(last[n])));
    }
    return fw_verdict_of(&scenario, &all[0], 0);
}

/* Of 1, 2 and 6 the mean is 3 and its error (14/2/3)^(1/2); one that is none spoils all. */
static void a_study_shows_the_mean_of_its_seeds(void **state)
{
    (void)state;
    fw_verdict v = found_over((double[]){1, 2, 6});
    assert_close(v.measured, 3, 1e-15);
    assert_close(v.error, sqrt(7. / 3), 1e-14);
    assert_string_equal(v.found, "3.0 +- 1.5 (3 seeds)");
    assert_true(v.holds);
    v = found_over((double[]){1, NAN, 6});
    assert_true(isnan(v.measured) && isnan(v.error) && !v.holds);
    assert_string_equal(v.found, "no number: nothing has pressed on the wall (3 seeds)");
    v = found_over((double[]){2, 2, 2});
    assert_string_equal(v.found, "2 (3 seeds)");
}

/* A measure of the layer, of all seeds together and of each. `asked`: what the study told. */
static fw_verdict found_of_layer(fw_layer_measure measure, const fw_outcome *told,
                                 const double of_seeds[SEEDS])
{
    static fw_expectation e;
    static fw_outcome outcome[FW_LAYER_MEASURES];
    static double each[SEEDS * FW_LAYER_MEASURES];
    int expected = -1, component = (int)measure;
    e = (fw_expectation){.quantity.text = fw_layer_quantities[measure].name,
                         .kind = FW_VERDICT_BOUNDS,
                         .has_above = true,
                         .has_below = true,
                         .below = 9};
    const fw_scenario scenario = {.expectations = &e, .expectation_count = 1, .study.seeds = SEEDS};
    if (told) outcome[measure] = *told;
    for (int n = 0; of_seeds && n < SEEDS; ++n)
        each[n * FW_LAYER_MEASURES + component] = of_seeds[n];
    const fw_measurement m = {.expected = &expected,
                              .component = &component,
                              .outcome = told ? outcome : NULL,
                              .outcome_of_seeds = of_seeds ? each : NULL};
    return fw_verdict_of(&scenario, &m, 0);
}

static void a_measure_of_the_layer_is_that_of_the_seeds_that_have_it(void **state)
{
    (void)state;
    const double two[] = {NAN, 2, 3};
    fw_verdict v = found_of_layer(FW_LAYER_CONTACT, &(fw_outcome){.mean = 2.5, .error = .5}, two);
    assert_string_equal(v.quantity, "layer-contact");
    assert_string_equal(v.expected, "0 to 9");
    assert_string_equal(v.found, "2.50 +- 0.5 (2 of 3 seeds)");
    assert_int_equal(v.seeds, 2);
    assert_true(v.holds);
    const fw_outcome none = {.mean = NAN, .error = NAN};
    v = found_of_layer(FW_LAYER_CONTACT, &none, (double[]){NAN, NAN, NAN});
    assert_string_equal(v.found, "no number: no seed shows it (0 of 3 seeds)");
    assert_false(v.holds);
    v = found_of_layer(FW_LAYER_CONTACT_OVER_FAR, &none, (double[]){NAN, NAN, NAN});
    assert_string_equal(v.found,
                        "no number: no return force acts far from the contact (0 of 3 seeds)");
    /* Before the study's end nothing is known. */
    v = found_of_layer(FW_LAYER_CONTACT, NULL, NULL);
    assert_string_equal(v.found, "no number: no seed shows it (3 seeds)");
    assert_string_equal(fw_verdict_word(&v), "not measured");
}

/* --- what is told --- */

static void a_table_has_notes_below_and_cases_in_front(void **state)
{
    (void)state;
    static const fw_expectation noted = {.quantity.text = "energy",
                                         .kind = FW_VERDICT_BOUNDS,
                                         .has_below = true,
                                         .below = 1,
                                         .source = "Eq 1",
                                         .note = "as it is"};
    fw_verdict items[] = {
        {.expectation = &noted,
         .in = "v=1",
         .asked = true,
         .measured = 2,
         .error = NAN,
         .seeds = 1,
         .quantity = "energy, last"},
        {.expectation = &noted,
         .in = "v=2",
         .asked = false,
         .measured = 2,
         .error = NAN,
         .quantity = "a quantity with a long name"},
    };
    char text[512] = "";
    FILE *out = fmemopen(text, sizeof text, "w");
    assert_non_null(out);
    for (int n = 0; n < 2; ++n) fw_verdict_judge(&items[n]);
    const fw_verdicts all = {.count = 2, .item = items}, unasked = {.count = 1, .item = items + 1};
    assert_int_equal(fw_verdicts_asked(&all), 1);
    assert_int_equal(fw_verdicts_failed(&all), 1);
    fw_verdicts_print(out, &unasked);
    fw_verdicts_print(out, &all);
    fclose(out);
    assert_string_equal(text, "case  quantity      expected  measured          verdict  source\n"
                              "v=1   energy, last  < 1       2                 FAILS    Eq 1\n"
                              "                    as it is\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(statistics_are_those_by_hand),
        cmocka_unit_test(a_window_takes_both_its_ends),
        cmocka_unit_test(what_is_no_number_is_not_measured),
        cmocka_unit_test(an_error_that_is_a_lower_bound_is_called_one),
        cmocka_unit_test(bounds_are_absolute_or_relative),
        cmocka_unit_test(a_study_shows_the_mean_of_its_seeds),
        cmocka_unit_test(a_measure_of_the_layer_is_that_of_the_seeds_that_have_it),
        cmocka_unit_test(a_table_has_notes_below_and_cases_in_front),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
