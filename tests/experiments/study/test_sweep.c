/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_sweep.c - sweeps: what stands for a parameter, what is refused, and cases that are asked for
 * something. */
#include "tests/support/laws.h"

#include "experiments/scenario/scenario.h"
#include "experiments/study/sweep.h"
#include "experiments/text/number.h"
#include "tests/support/program.h"

static const char flights[] =
    "title: a sheet flies at several speeds\n"
    "materials: {rubber: {lattice-boltzmann: {rest-mass: 0, damping: 0}}}\n"
    "bodies: {sheet: {material: rubber, shape: {rectangle: [4, 4]}, origin: [3.3, 4.7]}}\n"
    "walls: {box: {box: [0, 0, 20, 20]}}\n"
    "run: {steps: 40, record-every: 10}\n"
    "study:\n"
    "  sweep:\n"
    "    parameters:\n"
    "      v: {values: [0.1, 0.05, 0.2], unit: length/time}\n"
    "    set: ['bodies.sheet.velocity=[-v, 0.5*v]']\n"
    "expect:\n"
    "  - {quantity: energy-drift, statistic: largest, below: 1e-12}\n"
    /* The ends of 24 links: M = 24 in all, and E = M (v^2 + v^2/4)/2 = 15 v^2. */
    "  - {quantity: energy, when: 0.2, value: 0.6, within: 1e-9}\n"
    "  - {quantity: energy, trend: rises}\n"
    "pictures:\n"
    "  speeds: {kind: sweep}\n"
    "  way: {kind: motion}\n";

/* What follows the parameter v in the text above. */
#define TAIL(more, speed, when)                                                                    \
    "length/time}\n" more "    set: ['bodies.sheet.velocity=[-" speed ", 0.5*v]']\nexpect:\n"      \
    "  - {quantity: energy-drift, statistic: largest, below: 1e-12}\n"                             \
    "  - {quantity: energy, when: " when ", value: 0.6"

/* In the text above the first `written` becomes `instead`. */
static char *change(const char *written, const char *instead)
{
    const char *at = strstr(flights, written);
    char *text = malloc(sizeof flights + strlen(instead));
    assert_non_null(at);
    assert_non_null(text);
    sprintf(text, "%.*s%s%s", (int)(at - flights), flights, instead, at + strlen(written));
    return text;
}

/* --- parameters --- */

static void written_numbers_read_back(void **state)
{
    static const double values[] = {0,    1.0 / 3, -1e-300, 1e14, 1e15,       123456789.125,
                                    1e22, 5e-324,  0.1,     -2.5, 1.0e15 + 2, 0.30000000000000004};
    (void)state;
    for (size_t n = 0; n < sizeof values / sizeof values[0]; ++n) {
        char text[FW_NUMBER_TEXT];
        double back = 7;
        fw_number_write(text, values[n]);
        assert_int_equal(fw_number_read(text, strlen(text), &back), FW_NUMBER_FINE);
        assert_true(back == values[n]);
    }
}

/* A case as it was run says which case it is, reads back as itself, and can be changed further: its
 * control is not undone. */
static void case_is_a_scenario_of_its_own(void **state)
{
    fw_scenario *sweep, *made, *again;
    char *text, *text_again;
    static const char *const settings[] = {"bodies.sheet.velocity=[0, 0]"};
    (void)state;
    assert_fine(fw_scenario_read(&sweep, "s", flights, strlen(flights), NULL, 0, &error));
    assert_true(fw_scenario_is_sweep(sweep));
    assert_fine(fw_scenario_read_case(&made, sweep, 2, &error));
    assert_false(fw_scenario_is_sweep(made));
    assert_int_equal(made->study.sweep.case_count, 1);
    assert_true(fw_sweep_value(&made->study.sweep, 0, 0) == 0.2);
    assert_true(made->bodies[0].velocity.x == -0.2 && made->bodies[0].velocity.y == 0.1);
    assert_true(sweep->bodies[0].velocity.x == 0);
    assert_fine(fw_scenario_print(made, &text, &error));
    assert_fine(fw_scenario_read(&again, "s", text, strlen(text), NULL, 0, &error));
    assert_true(again->bodies[0].velocity.x == -0.2);
    assert_fine(fw_scenario_print(again, &text_again, &error));
    assert_string_equal(text, text_again);
    fw_scenario_destroy(again);
    assert_fine(fw_scenario_read(&again, "s", text, strlen(text), settings, 1, &error));
    assert_true(again->bodies[0].velocity.x == 0);
    free(text);
    free(text_again);
    fw_scenario_destroy(again);
    fw_scenario_destroy(made);
    fw_scenario_destroy(sweep);
}

/* --- refusals --- */

static const struct {
    const char *written, *instead, *sentence; /* after "flights.yaml:" */
} mistakes[] = {
    {"parameters:", "parameter:",
     "8:5: unknown key 'parameter' in study.sweep; it is now called 'parameters'"},
    {"parameters:\n      v:", "parameters:\n      2v:",
     "9:7: '2v' as a name in study.sweep.parameters, expected a letter and then letters, digits, "
     "'-' or '_'"},
    {"parameters:\n      v:", "parameters:\n      v-x:",
     "9:7: 'v-x' cannot stand in a formula, expected a letter and then letters, digits or '_'"},
    {"parameters:\n      v:", "parameters:\n      sin:",
     "9:7: 'sin' is a function or constant of formulas, expected another name"},
    {"parameters:\n      v:", "parameters:\n      pi:",
     "9:7: 'pi' is a function or constant of formulas, expected another name"},
    {"values: [0.1, 0.05, 0.2]", "values: []",
     "9:19: study.sweep.parameters.v.values has 0 items, expected 1 to 1024"},
    {"[0.1, 0.05, 0.2]", "[0.1, 0.2, 1e-1]",
     "9:30: the values of v have 1e-1 twice, expected values that differ"},
    {"[0.1, 0.05, 0.2]", "[0.1, fast]",
     "9:25: study.sweep.parameters.v.values.1 is 'fast', expected a number"},
    {"values: [0.1, 0.05, 0.2], ", "",
     "9:7: v has no values, expected 'values', or 'from', 'to' and 'count', or 'points' of the "
     "sweep"},
    {"values: [0.1, 0.05, 0.2]", "values: [0.2], from: 1, to: 2, count: 2",
     "9:26: v has both 'values' and 'from', expected one of them"},
    {"values: [0.1, 0.05, 0.2]", "from: 1, to: 2",
     "9:11: v has 'from' and 'to', expected 'count' too, or 'tolerance' where it is bisected"},
    {"values: [0.1, 0.05, 0.2]", "from: 1, to: 2, count: 1",
     "9:34: study.sweep.parameters.v.count is '1', expected a whole number from 2 to 1024"},
    {"values: [0.1, 0.05, 0.2]", "from: 2, to: 2, count: 3",
     "9:24: the range of v goes from 2 to 2, expected values that differ"},
    {"values: [0.1, 0.05, 0.2]", "from: 0, to: 2, count: 3, spacing: logarithmic",
     "9:17: the range of v goes from 0 to 2, which no equal factors do: expected two numbers above "
     "0"},
    {"values: [0.1, 0.05, 0.2]", "from: 0, to: 2, count: 3, spacing: log",
     "9:46: study.sweep.parameters.v.spacing is 'log', expected one of linear, logarithmic"},
    {"length/time}\n", "length/time}\n    points: [{v: 1}]\n",
     "9:11: v has 'values', but study.sweep has 'points': expected one of the two"},
    {"values: [0.1, 0.05, 0.2], unit: length/time}\n", "unit: m}\n    points: [{v: 1}, {w: 2}]\n",
     "10:23: 'w' is no parameter of study.sweep, expected one of v"},
    {"values: [0.1, 0.05, 0.2], unit: length/time}\n",
     "unit: m}\n    points: [{v: 1}, {v: 2}, {v: 1}]\n",
     "10:30: the points 0 and 2 of study.sweep are the same, expected points that differ"},
    {"values: [0.1, 0.05, 0.2], unit: length/time}\n",
     "unit: m}\n      w: {}\n    points: [{v: 1, w: 1}, {v: 2}]\n",
     "11:28: 'a point' has no value of w, expected one of each parameter"},
    {"length/time}\n", "length/time}\n      w: {values: [1, 2]}\n",
     "10:7: the parameter w changes nothing: it occurs in no setting of study.sweep.set"},
    {"values: [0.1, 0.05, 0.2], unit: length/time}\n",
     "from: 1, to: 2, count: 1000}\n      w: {from: 1, to: 2, count: 1000}\n",
     "7:3: study.sweep has 1000000 cases, expected at most 10000"},
    {"    set: ['bodies.sheet.velocity=[-v, 0.5*v]']\n", "",
     "7:3: study.sweep has no 'set', which says what the values of v change: it is none of the "
     "scenario's 'parameters'"},
    {"[-v, 0.5*v]", "[1, 2]",
     "10:11: no parameter occurs in the setting 'bodies.sheet.velocity=[1, 2]', expected KEY=VALUE "
     "with v, or a formula of it such as 2*v, in the value"},
    {"0.5*v]", "0.5*v*x]",
     "10:11: the formula '0.5*v*x' has the unknown name 'x', expected a parameter or "
     "a function such as sqrt"},
    {"bodies.sheet.velocity=[-v, 0.5*v]", "study.seeds=v",
     "10:11: the setting 'study.seeds=v' changes the study that it is part of, expected another "
     "key"},
    {"bodies.sheet.velocity=[-v, 0.5*v]", "study={seeds: v}",
     "10:11: the setting 'study={seeds: v}' changes the study that it is part of, expected another "
     "key"},
    {"bodies.sheet.velocity=[-v, 0.5*v]", "study.sweep.parameters.v.values=[v]",
     "10:11: the setting 'study.sweep.parameters.v.values=[v]' changes the study that it is part "
     "of, expected another key"},
    {"unit: length/time", "unit: \"len\\ngth\"",
     "9:43: the unit of v is 'len gth', expected at most 63 bytes in one line"},
    {"when: 0.2", "when: 0.3", "13:30: 'when' is v=0.3, where study.sweep has no case"},
    {"when: 0.2", "when: {w: 0.2}", "13:31: 'w' is no parameter of study.sweep, expected one of v"},
    {"trend: rises", "trend: rises, when: 0.1",
     "14:38: the expectation of 'energy' has both 'trend' and 'when', expected one of them"},
    {"trend: rises", "trend: rises, above: 1",
     "14:38: the expectation of 'energy' has both 'trend' and 'above', expected one of them"},
    {"trend: rises", "trend: rises, along: w",
     "14:45: 'w' is no parameter of study.sweep, expected one of v"},
    {"[0.1, 0.05, 0.2]", "[0.2]",
     "14:24: the expectation of 'energy' has a 'trend', but the study has no 'sweep' of two values "
     "or more"},
    {"kind: sweep", "kind: sweep, field: speed",
     "16:25: pictures.speeds has 'field', which a picture of kind 'sweep' does not draw"},
    {"kind: sweep", "kind: map",
     "16:18: pictures.speeds is of kind 'map', but study.sweep has 1 parameter, expected two"},
    {"kind: sweep", "kind: sweep, along: w",
     "16:32: 'w' is no parameter of study.sweep, expected one of v"},
    /* What shows in a case alone. */
    {"[-v, 0.5*v]", "[-v, 0.01/(v - 0.2)]",
     "7:3: the case v=0.2: flights.yaml:10:11: the formula '0.01/(v - 0.2)' is infinite where "
     "v=0.2, expected a finite "
     "number"},
    {"bodies.sheet.velocity", "bodies.shet.velocity",
     "7:3: the case v=0.1: --set bodies.shet.velocity=[-0.1, 0.05]: there is no 'shet' in bodies; "
     "did you mean 'sheet'?"},
    {"bodies.sheet.velocity=[-v, 0.5*v]", "run.steps=v",
     "7:3: the case v=0.1: --set run.steps=0.1: run.steps is '0.1', expected a whole number of at "
     "least 1, written without point, exponent or leading zeros"},
    {"bodies.sheet.velocity=[-v, 0.5*v]", "bodies.sheet.origin=[100*v, 5]",
     "7:3: the case v=0.2: flights.yaml:4:9: body sheet starts in wall box: particle 3 at (23, 5) "
     "lies 3 behind its surface, expected all particles on the free side"},
    {"bodies.sheet.velocity=[-v, 0.5*v]", "expect.3={quantity: energy, above: v}",
     "7:3: the case v=0.1: it has 4 expectations, expected the 3 of the sweep"},
    {"kind: sweep", "kind: sweep, observables: [momentum]",
     "7:3: the case v=0.1: flights.yaml:16:39: a picture of a sweep draws momentum, which the "
     "sweep "
     "does not compare: expected a quantity of 'expect'"},
    {"kind: sweep", "kind: sweep, observables: [energy.sheet]",
     "7:3: the case v=0.1: flights.yaml:16:39: a picture of a sweep draws energy.sheet, expected "
     "energy alone: it shows what 'expect' asks of it"},
    /* Of two parameters. */
    {TAIL("", "v", "0.2"), TAIL("      w: {values: [1, 2]}\n", "w*v", "0.2"),
     "14:30: 'when' is 0.2, but study.sweep has 2 parameters: expected their names, as {v: 0.2}"},
    {TAIL("", "v", "0.2"), TAIL("      w: {values: [1, 2]}\n", "w*v", "{v: 0.2, w: 3}"),
     "14:30: 'when' is v=0.2,w=3, where study.sweep has no case"},
    {TAIL("", "v", "0.2"), TAIL("      w: {values: [1, 2]}\n", "w*v", "{v: 0.2}"),
     "15:24: the expectation of 'energy' has a 'trend', but study.sweep has 2 parameters: expected "
     "'along' with one of them"},
};

static void every_mistake_gets_its_sentence_and_leaves_nothing(void **state)
{
    char folder[64], path[96], expected[FW_SENTENCE_SIZE];
    int wrong = 0;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/results", folder);
    const fw_run_options options = {.directory = path, .threads = 1};
    for (size_t n = 0; n < sizeof mistakes / sizeof mistakes[0]; ++n) {
        char *text = change(mistakes[n].written, mistakes[n].instead);
        fw_scenario *scenario;
        fw_sweep *sweep = NULL;
        error = (fw_error){FW_OK, "accepted"};
        fw_status status =
            fw_scenario_read(&scenario, "flights.yaml", text, strlen(text), NULL, 0, &error);
        if (status == FW_OK) status = fw_sweep_begin(&sweep, scenario, &options, &error);
        snprintf(expected, sizeof expected, "flights.yaml:%s", mistakes[n].sentence);
        if (status != FW_BAD_INPUT || strcmp(error.sentence, expected) != 0) {
            print_error("'%s':\n  found    %s\n  expected %s\n", mistakes[n].instead,
                        error.sentence, expected);
            wrong += 1;
        }
        assert_null(sweep);
        fw_scenario_destroy(scenario);
        free(text);
    }
    assert_int_equal(wrong, 0);
    assert_false(exists(folder, "results"));
    remove_folder(folder);
}

static void sweep_words_without_a_sweep_are_refused(void **state)
{
    static const char *const settings[] = {"study={seeds: 1}"};
    fw_scenario *scenario;
    (void)state;
    assert_refused(fw_scenario_read(&scenario, "s", flights, strlen(flights), settings, 1, &error),
                   FW_BAD_INPUT, "'when' names a value of a sweep, but the study has no 'sweep'");
    char *text = change("  - {quantity: energy, when: 0.2, value: 0.6, within: 1e-9}\n"
                        "  - {quantity: energy, trend: rises}\n",
                        "");
    assert_refused(fw_scenario_read(&scenario, "s", text, strlen(text), settings, 1, &error),
                   FW_BAD_INPUT, "pictures.speeds is of kind 'sweep', but the study has no");
    free(text);
    text = change("expect:\n"
                  "  - {quantity: energy-drift, statistic: largest, below: 1e-12}\n"
                  "  - {quantity: energy, when: 0.2, value: 0.6, within: 1e-9}\n"
                  "  - {quantity: energy, trend: rises}\n",
                  "");
    assert_refused(fw_scenario_read(&scenario, "s", text, strlen(text), NULL, 0, &error),
                   FW_BAD_INPUT, "the scenario has neither 'expect' nor 'profile'");
    free(text);
}

/* --- what comes out --- */

static void cases_are_asked_and_compared(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flights.yaml", flights);
    outcome seen = run_program(folder, "run flights.yaml -q -o it");
    expect_end(&seen, 0, "");
    /* From 0.05 to 0.1 it rises by less than from there to 0.2, whatever their order. */
    assert_non_null(strstr(seen.out, "v=0.1   energy, at the end, least rise (from v=0.05)"));
    /* Asked of v = 0.2 alone; measured of all. */
    shell(folder, "test $(grep -c 'not asked$\\|not asked,' it/v=0.1/summary.csv) = 2");
    shell(folder, "grep -q '\"energy, at the end\",0.6 +- 1e-09,.*,holds' it/v=0.2/summary.csv");
    shell(folder, "test \"$(ls it)\" = \"$(printf 'manifest\\nspeeds.png\\nsweep-as-run.yaml\\n"
                  "sweep-seeds.csv\\nsweep.csv\\nsweep.h5\\n"
                  "v=0.05\\nv=0.1\\nv=0.2')\"");
    shell(folder, "head -c 4 it/speeds.png | grep -q PNG");
    /* The pictures of single runs are drawn in each case. */
    shell(folder,
          "for v in 0.05 0.1 0.2; do head -c 4 it/v=$v/way.png | grep -q PNG || exit 1; done");
    /* Each case is a result like any other. */
    seen = run_program(folder, "plot it/v=0.05");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, "picture: it/v=0.05/way.png\n");
    seen = run_program(folder, "table it/v=0.05 --observable energy");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "table it");
    expect_end(&seen, 2,
               "it holds a sweep, expected the folder of one of its cases, such as "
               "it/v=0.1");
    seen = run_program(folder, "plot it --observable energy -o energy.svg");
    expect_end(&seen, 0, "");
    shell(folder, "grep -q '<svg' energy.svg");
    seen = run_program(folder, "plot it --observable enery");
    expect_end(&seen, 2, "it: the sweep has no enery; did you mean energy?");
    seen = run_program(folder, "plot it --picture way");
    expect_end(&seen, 2, "the picture way is one of its cases: `fretwork plot it/v=0.1");
    seen = run_program(folder, "resume it");
    expect_end(&seen, 2, "it: the sweep is finished, there is nothing to resume");
    /* What does not hold fails: a trend, and what one case is asked. */
    seen = run_program(folder, "verify flights.yaml -q --set expect.2.trend=falls");
    expect_end(&seen, 1, "");
    assert_non_null(strstr(seen.out, "1 experiments, 5 expectations, 1 failed\n"));
    /* What speaks most against a fall is the largest rise. */
    assert_non_null(strstr(seen.out, "v=0.2   energy, at the end, least fall (from v=0.1)"));
    seen = run_program(folder, "verify flights.yaml -q --set expect.1.when=0.1 --json -");
    expect_end(&seen, 1, "");
    assert_non_null(strstr(seen.out, "\"case\": \"v=0.1\",\n"));
    /* One case by itself. */
    seen = run_program(folder, "verify flights.yaml -q --set study.sweep.case=0.2");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "1 experiments, 2 expectations, 0 failed\n"));
    remove_folder(folder);
}

/* A change counts as far as it is known; one that is no number never does. */
static void trends_are_judged_beyond_their_errors(void **state)
{
    static const struct {
        double change, error;
        bool rises, falls;
    } rows[] = {{.3, .2, true, false},  {.1, .2, false, false},   {-.1, .2, false, false},
                {-.3, .2, false, true}, {1e-9, NAN, true, false}, {-1e-9, NAN, false, true},
                {0, NAN, false, false}, {NAN, .2, false, false},  {NAN, NAN, false, false}};
    (void)state;
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        const fw_expectation rises = {.kind = FW_VERDICT_RISES}, falls = {.kind = FW_VERDICT_FALLS};
        fw_verdict verdict = {
            .expectation = &rises, .measured = rows[n].change, .error = rows[n].error};
        fw_verdict_judge(&verdict);
        assert_int_equal(verdict.holds, rows[n].rises);
        verdict.expectation = &falls;
        fw_verdict_judge(&verdict);
        assert_int_equal(verdict.holds, rows[n].falls);
    }
}

/* While a case is being written by itself, its sweep is not replaced. */
static void a_case_that_is_held_is_not_replaced(void **state)
{
    char folder[64], path[128];
    fw_folder *held;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flights.yaml", flights);
    outcome seen = run_program(folder, "run flights.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    snprintf(path, sizeof path, "%s/it/v=0.05", folder);
    assert_fine(fw_folder_open(&held, path, &error));
    seen = run_program(folder, "run flights.yaml -q --no-plot --overwrite -o it");
    expect_end(&seen, 2, "it/v=0.05");
    assert_true(exists(folder, "it/v=0.05/trajectory.h5") && exists(folder, "it/sweep.csv"));
    fw_folder_close(held);
    remove_folder(folder);
}

/* The table has the numbers that single runs show. */
static void table_holds_what_the_cases_show(void **state)
{
    char folder[64], path[128];
    fw_sweep_table table;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flights.yaml", flights);
    outcome seen = run_program(folder, "run flights.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    snprintf(path, sizeof path, "%s/it", folder);
    assert_fine(fw_sweep_table_read(&table, path, 1, &error));
    assert_string_equal(table.axes[0].name, "v");
    assert_string_equal(table.axes[0].unit, "length/time");
    assert_int_equal(table.row_count, 3);
    assert_int_equal(table.column_count, 2);
    static const double values[] = {0.1, 0.05, 0.2};
    const fw_sweep_column *energy = &table.columns[1];
    assert_string_equal(energy->name, "energy, at the end");
    assert_string_equal(energy->unit, "energy");
    for (int n = 0; n < 3; ++n) {
        assert_true(table.values[n] == values[n]);
        assert_close(energy->mean[n], 15 * values[n] * values[n], 1e-9);
        assert_true(isnan(energy->error[n]));
        assert_true(n == 2 ? energy->expected[n] == 0.6 && energy->within[n] == 1e-9
                           : isnan(energy->expected[n]));
    }
    fw_sweep_table_clear(&table);
    shell(folder, "sed '$ s/,[^,]*$//' it/sweep.csv > cut.csv && mv cut.csv it/sweep.csv");
    assert_refused(fw_sweep_table_read(&table, path, 1, &error), FW_BAD_INPUT,
                   "it/sweep.csv is damaged or was changed");
    remove_folder(folder);
}

/* A result is replaced only when that is asked for, and then nothing of it stays. */
static void results_of_runs_and_sweeps_do_not_mix(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flights.yaml", flights);
    outcome seen = run_program(folder, "run flights.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    shell(folder, "cp -r it kept");
    seen = run_program(folder, "run flights.yaml -q --no-plot -o it");
    expect_end(&seen, 2, "it holds a result already; --overwrite replaces it");
    seen = run_program(folder, "run free-particle -q --no-plot -o it");
    expect_end(&seen, 2, "it holds a result already; --overwrite replaces it");
    shell(folder, "diff -r it kept");
    /* A case's own folder counts as well. */
    shell(folder, "mkdir half && cp -r it/v=0.2 half");
    seen = run_program(folder, "run flights.yaml -q --no-plot -o half");
    expect_end(&seen, 2, "half/v=0.2 holds a result already");
    seen = run_program(folder, "run free-particle -q --no-plot --overwrite -o it");
    expect_end(&seen, 0, "");
    shell(folder, "test -f it/trajectory.h5 && ! ls it | grep -q sweep");
    seen = run_program(folder, "run flights.yaml -q --no-plot --overwrite -o it");
    expect_end(&seen, 0, "");
    shell(folder, "! test -f it/trajectory.h5 && cmp it/sweep.csv kept/sweep.csv");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(written_numbers_read_back),
        cmocka_unit_test(case_is_a_scenario_of_its_own),
        cmocka_unit_test(every_mistake_gets_its_sentence_and_leaves_nothing),
        cmocka_unit_test(sweep_words_without_a_sweep_are_refused),
        cmocka_unit_test(cases_are_asked_and_compared),
        cmocka_unit_test(trends_are_judged_beyond_their_errors),
        cmocka_unit_test(a_case_that_is_held_is_not_replaced),
        cmocka_unit_test(table_holds_what_the_cases_show),
        cmocka_unit_test(results_of_runs_and_sweeps_do_not_mix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
