/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_sweep_parameters.c - sweeps over several parameters: which cases they make, in which order,
 * and what comes out of them. */
#include "tests/support/laws.h"

#include "experiments/scenario/scenario.h"
#include "experiments/study/sweep_table.h"
#include "tests/support/program.h"

#define TEXT(sweep)                                                                                \
    "title: a sheet flies\n"                                                                       \
    "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"                                   \
    "bodies: {sheet: {material: rubber, shape: {rectangle: [4, 4]}, origin: [3.3, 4.7]}}\n"        \
    "run: {steps: 40, record-every: 10}\n"                                                         \
    "study: {sweep: {" sweep "}}\n"                                                                \
    "expect:\n"                                                                                    \
    "  - {quantity: energy, value: 1, within: 1e-9}\n"                                             \
    "  - {quantity: energy, when: {v: 0.2}, above: 0.3}\n"                                         \
    "  - {quantity: energy, trend: rises, along: v}\n"                                             \
    "  - {quantity: energy, trend: rises, along: w}\n"                                             \
    "pictures:\n"                                                                                  \
    "  lines: {kind: sweep, along: v}\n"                                                           \
    "  map: {kind: map, observables: [energy]}\n"
/* E = M (v^2 + w^2)/2 with M = 24, see test_sweep.c. */
#define SET                                                                                        \
    "set: ['bodies.sheet.velocity=[v, w]', expect.0.value=12*(v^2 + w^2), run.steps=rint(4/v)]"

static fw_scenario *scenario_of(const char *text)
{
    fw_scenario *scenario;
    assert_fine(fw_scenario_read(&scenario, "s", text, strlen(text), NULL, 0, &error));
    return scenario;
}

static void assert_cases(const char *text, int count, const char *const *names)
{
    fw_scenario *scenario = scenario_of(text);
    assert_int_equal(scenario->study.sweep.case_count, count);
    for (int n = 0; n < count; ++n) {
        char name[FW_CASE_NAME];
        fw_scenario_case_name(scenario, n, name);
        assert_string_equal(name, names[n]);
    }
    fw_scenario_destroy(scenario);
}

static void every_value_meets_every_other(void **state)
{
    static const char *const product[] = {"v=0.2,w=3", "v=0.2,w=1", "v=0.2,w=2",
                                          "v=0.1,w=3", "v=0.1,w=1", "v=0.1,w=2"};
    static const char *const points[] = {"v=0.1,w=1", "v=0.2,w=4"};
    (void)state;
    assert_cases(TEXT("parameters: {v: {values: [0.2, 0.1]}, w: {values: [3, 1, 2]}}, " SET), 6,
                 product);
    assert_cases(TEXT("parameters: {v: {}, w: {}}, points: [{w: 1, v: 0.1}, {v: 0.2, w: 4}], " SET),
                 2, points);
}

/* As somebody would write them: steps without the noise of the last digit. */
static void ranges_have_round_values(void **state)
{
    static const char *const steps[] = {"v=0.1,w=1", "v=0.2,w=1", "v=0.3,w=1", "v=0.4,w=1",
                                        "v=0.5,w=1", "v=0.6,w=1", "v=0.7,w=1"};
    static const char *const through_zero[] = {"v=0.2,w=-0.3", "v=0.2,w=-0.1", "v=0.2,w=0.1",
                                               "v=0.2,w=0.3"};
    static const char *const middle[] = {"v=0.2,w=-0.3", "v=0.2,w=0", "v=0.2,w=0.3"};
    static const char *const factors[] = {"v=0.2,w=100", "v=0.2,w=21.5443", "v=0.2,w=4.64159",
                                          "v=0.2,w=1"};
    (void)state;
    assert_cases(TEXT("parameters: {v: {from: 0.1, to: 0.7, count: 7}, w: {values: [1]}}, " SET), 7,
                 steps);
    assert_cases(TEXT("parameters: {v: {values: [0.2]}, w: {from: -0.3, to: 0.3, count: 4}}, " SET),
                 4, through_zero);
    assert_cases(TEXT("parameters: {v: {values: [0.2]}, w: {from: -0.3, to: 0.3, count: 3}}, " SET),
                 3, middle);
    assert_cases(TEXT("parameters: {v: {values: [0.2]}, w: {from: 100, to: 1, count: 4, spacing: "
                      "logarithmic}}, " SET),
                 4, factors);
}

/* A case is the same whatever others there are: a sweep can be extended. */
static void a_case_knows_no_other(void **state)
{
    fw_scenario *few =
        scenario_of(TEXT("parameters: {v: {values: [0.2, 0.3]}, w: {values: [3], unit: a}}, " SET));
    fw_scenario *many = scenario_of(TEXT(
        "parameters: {v: {from: 0.1, to: 0.2, count: 2}, w: {values: [1, 3], unit: a}}, " SET));
    fw_scenario *one, *other;
    char *text, *other_text;
    (void)state;
    assert_fine(fw_scenario_read_case(&one, few, 0, &error));
    assert_fine(fw_scenario_read_case(&other, many, 3, &error));
    assert_int_equal(one->run.steps, 20);
    assert_close(one->expectations[0].value, 12 * (0.04 + 9), 1e-12);
    assert_fine(fw_scenario_print(one, &text, &error));
    assert_fine(fw_scenario_print(other, &other_text, &error));
    assert_string_equal(text, other_text);
    free(text);
    free(other_text);
    fw_scenario_destroy(one);
    fw_scenario_destroy(other);
    fw_scenario_destroy(few);
    fw_scenario_destroy(many);
}

static const char flights[] = TEXT(
    "parameters: {v: {values: [0.2, 0.1], unit: length/time}, w: {values: [0.1, 0.4, 0.2]}}, " SET);

static void what_comes_out_has_a_column_per_parameter(void **state)
{
    char folder[64], path[96];
    fw_sweep_table table;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flights.yaml", flights);
    outcome seen = run_program(folder, "run flights.yaml -q -o it");
    expect_end(&seen, 0, "");
    /* The least rise along each: compared with the same value of the other. */
    assert_non_null(strstr(seen.out, "energy, at the end, least rise (from v=0.1,w="));
    assert_non_null(strstr(seen.out, "w=0.2  energy, at the end, least rise (from v="));
    shell(folder, "test \"$(ls -d it/v* | tr '\\n' ' ')\" = \"it/v=0.1,w=0.1 it/v=0.1,w=0.2 "
                  "it/v=0.1,w=0.4 it/v=0.2,w=0.1 it/v=0.2,w=0.2 it/v=0.2,w=0.4 \"");
    shell(folder, "sed -n 2,4p it/sweep.csv | cut -d, -f1-2 > head;"
                  " printf '# units: length/time,\\nv,w\\n0.2,0.1\\n' | cmp - head");
    snprintf(path, sizeof path, "%s/it", folder);
    assert_fine(fw_sweep_table_read(&table, path, 2, &error));
    assert_int_equal(table.row_count, 6);
    assert_string_equal(table.axes[0].unit, "length/time");
    assert_string_equal(table.axes[1].name, "w");
    assert_true(table.values[2 * 2] == 0.2 && table.values[2 * 2 + 1] == 0.2);
    assert_close(table.columns[0].mean[1], 12 * (0.04 + 0.16), 1e-12);
    fw_sweep_table_clear(&table);
    shell(folder, "head -c 4 it/lines.png | grep -q PNG && head -c 4 it/map.png | grep -q PNG");
    seen = run_program(folder, "plot it --kind map --observable energy -o map.svg");
    expect_end(&seen, 0, "");
    shell(folder, "grep -q '<svg' map.svg");
    seen = run_program(folder, "plot it/v=0.1,w=0.1 --kind map");
    expect_end(&seen, 2, "no pictures of kind map");
    /* One case by itself, as any engine runs it. */
    seen = run_program(folder, "run flights.yaml -q --no-plot -o one --set 'study.sweep.case={v: "
                               "0.1, w: 0.4}'");
    expect_end(&seen, 0, "");
    shell(folder, "cmp one/summary.csv it/v=0.1,w=0.4/summary.csv");
    expect_same_results(folder, "one", "it/v=0.1,w=0.4");
    seen = run_program(folder, "run flights.yaml --set 'study.sweep.case={v: 0.1, w: 0.5}'");
    expect_end(&seen, 2, "'case' is v=0.1,w=0.5, where study.sweep has no case");
    seen = run_program(folder, "run flights.yaml --set 'study.sweep.case={v: 0.1}'");
    expect_end(&seen, 2, "'case' has no value of w, expected one of each parameter");
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_meets_every_other),
        cmocka_unit_test(ranges_have_round_values),
        cmocka_unit_test(a_case_knows_no_other),
        cmocka_unit_test(what_comes_out_has_a_column_per_parameter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
