/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_sweep_outcome.c - the columns of a sweep's table: names, units and numbers of each kind of
 * expectation, of a body whose way is known; and thresholds on lines that lack a case. */
#include "tests/support/laws.h"

#include "experiments/study/sweep_table.h"
#include "experiments/study/threshold_table.h"
#include "tests/support/program.h"

/* Nine free particles: their middle is at 1 + v t, and a step takes .01. */
static const char dust[] =
    "title: dust flies\n"
    "materials: {dust: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: dust, shape: {rectangle: [3, 3]}}}\n"
    "dynamics: {time-step: 0.01}\n"
    "phases: {early: {until: 20}, late: {until: 40}}\n"
    "run: {steps: 40, measure-every: 10}\n"
    "study: {sweep: {parameters: {v: {values: [1, 2], unit: length/time}}, set: "
    "['bodies.cloud.velocity=[v, 0]']}}\n"
    "expect:\n"
    "  - {quantity: centre-of-mass, component: x, statistic: rate, value: 1, within: 9}\n"
    "  - {quantity: centre-of-mass, component: x, statistic: time-of-maximum, value: 0.4, "
    "within-relative: 0.25}\n"
    "  - {quantity: centre-of-mass, component: x, statistic: mean, from: 20, above: 0}\n"
    "  - {quantity: centre-of-mass, component: x, statistic: mean, from: 10, until: 30, above: 0}\n"
    "  - {quantity: centre-of-mass, component: x, statistic: mean, phase: early, above: 0}\n"
    "  - {quantity: centre-of-mass, component: x, at: 20, above: 0}\n"
    "  - {quantity: centre-of-mass, component: x, trend: rises}\n"
    "  - {quantity: centre-of-mass, component: x, statistic: mean, from: 20, trend: rises}\n";

static char folder[64];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

typedef struct wanted_column {
    const char *name, *unit;
    double mean[2], error[2]; /* of v = 1 and v = 2; NaN: none */
    bool at_least;
    double expected, within;
} wanted_column;

static void expect_number(const char *name, double found, double wanted)
{
    if (isnan(wanted) ? !isnan(found) : !(fabs(found - wanted) <= 1e-12))
        fail_msg("%s: %.17g, expected %.17g", name, found, wanted);
}

static void every_kind_of_number_has_its_column(void **state)
{
    (void)state;
    /* Of three values d apart: the spread is d, the error of their mean d / sqrt 3, at least. */
    const double apart = .1 / sqrt(3);
    const wanted_column wanted[] = {
        {"centre-of-mass.cloud x, rate", "length/time", {1, 2}, {NAN, NAN}, false, 1, 9},
        {"centre-of-mass.cloud x, time of maximum", "time", {.4, .4}, {NAN, NAN}, false, .4, .1},
        {"centre-of-mass.cloud x, mean from 20",
         "length",
         {1.3, 1.6},
         {apart, 2 * apart},
         true,
         NAN,
         NAN},
        {"centre-of-mass.cloud x, mean from 10 to 30",
         "length",
         {1.2, 1.4},
         {apart, 2 * apart},
         true,
         NAN,
         NAN},
        {"centre-of-mass.cloud x, mean in early",
         "length",
         {1.1, 1.2},
         {apart, 2 * apart},
         true,
         NAN,
         NAN},
        {"centre-of-mass.cloud x, step 20", "length", {1.2, 1.4}, {NAN, NAN}, false, NAN, NAN},
        {"centre-of-mass.cloud x, at the end", "length", {1.4, 1.8}, {NAN, NAN}, false, NAN, NAN},
    };
    enum { COLUMNS = sizeof wanted / sizeof *wanted };
    fw_sweep_table table;
    write_scenario(folder, "dust.yaml", dust);
    const outcome seen = run_program(folder, "run dust.yaml -q --no-plot -j 1 -o .");
    expect_end(&seen, 0, "");
    /* The rise of a mean is as sure as the less sure of the two. */
    assert_non_null(strstr(seen.out,
                           "v=2   centre-of-mass.cloud x, mean, least rise (from v=1)        "
                           "rises        0.30 +- >= 0.13    holds"));
    assert_fine(fw_sweep_table_read(&table, folder, 1, &error));
    assert_int_equal(table.row_count, 2);
    assert_int_equal(table.seed_count, 1);
    assert_string_equal(table.axes[0].name, "v");
    assert_string_equal(table.axes[0].unit, "length/time");
    assert_int_equal(table.column_count, COLUMNS);
    for (int c = 0; c < COLUMNS; ++c) {
        const fw_sweep_column *column = &table.columns[c];
        assert_string_equal(column->name, wanted[c].name);
        assert_string_equal(column->unit, wanted[c].unit);
        for (int row = 0; row < 2; ++row) {
            expect_number(column->name, column->mean[row], wanted[c].mean[row]);
            expect_number(column->name, column->error[row], wanted[c].error[row]);
            assert_true((column->at_least[row] != 0) == wanted[c].at_least);
            expect_number(column->name, column->expected[row], wanted[c].expected);
            expect_number(column->name, column->within[row], wanted[c].within);
        }
    }
    fw_sweep_table_clear(&table);
}

/* A speck that comes to v t, with 1e6 out of all bounds; w does nothing. */
static const char speck[] =
    "title: a speck flies\n"
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}}}\n"
    "run: {steps: 10, limit: 1000}\n"
    "study: {sweep: {parameters: {v: {}, w: {}}, points: [{v: 0.1, w: 0}, {v: 0.3, w: 0}, "
    "{v: 0.1, w: 1}, {v: 0.1, w: 2}, {v: 1e6, w: 2}, {v: 1e6, w: 3}, {v: 0.1, w: 3}], "
    "set: ['bodies.speck.velocity=[v, 0*w]']}}\n"
    "expect:\n"
    "  - {quantity: centre-of-mass, component: x, along: v, crosses: 2, when: {w: 0}, value: 0.2, "
    "within: 0.11}\n";

static void lines_that_lack_a_case_have_no_threshold(void **state)
{
    (void)state;
    fw_threshold_row *rows;
    int count;
    write_scenario(folder, "speck.yaml", speck);
    const outcome seen = run_program(folder, "run speck.yaml -q --no-plot -j 1 -o it");
    expect_end(&seen, 3, "2 of 7 cases failed; the first is v=1000000,w=2: step 1: ");
    assert_non_null(strstr(seen.out, "v where centre-of-mass.speck x, at the end crosses 2, w=0"));
    char path[96];
    snprintf(path, sizeof path, "%s/it", folder);
    assert_fine(fw_threshold_table_read(&rows, &count, path, 2, &error));
    assert_int_equal(count, 4);
    for (int n = 0; n < 4; ++n) assert_true(rows[n].values[1] == n && rows[n].level == 2);
    assert_close(rows[0].values[0], .2, 1e-15);
    assert_close(rows[0].error, .1, 1e-15);
    for (int n = 1; n < 4; ++n) assert_true(isnan(rows[n].values[0]) && isnan(rows[n].error));
    free(rows);
    shell(folder, "grep -q ',2,,1,,1,there is only one case$' it/thresholds.csv");
    shell(folder, "grep -q ',2,,2,,1,\"v=1000000,w=2 has no number\"$' it/thresholds.csv");
    shell(folder,
          "grep -q '^centre-of-mass,2,,3,,1,\"v=1000000,w=3 has no number\"$' it/thresholds.csv");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_kind_of_number_has_its_column, begin, end),
        cmocka_unit_test_setup_teardown(lines_that_lack_a_case_have_no_threshold, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
