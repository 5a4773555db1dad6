/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_constants.c - formulas of named numbers where a number may be: their values, what keeps
 * them, sweeps that vary the names, and what is said of wrong ones. */
#include "tests/support/laws.h"

#include "experiments/scenario/scenario.h"
#include "tests/support/program.h"

#include <stdlib.h>
#include <string.h>

static fw_status read_text(fw_scenario **scenario, const char *text, const char *setting)
{
    error = (fw_error){FW_OK, "accepted"};
    return fw_scenario_read(scenario, "s", text, strlen(text), &setting, setting != NULL, &error);
}

static fw_scenario *scenario_of(const char *text, const char *setting)
{
    fw_scenario *scenario;
    assert_fine(read_text(&scenario, text, setting));
    return scenario;
}

/* --- values --- */

#define HEAD      "title: a sheet flies\n"
#define MATERIALS "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
static const char formulas[] =
    HEAD "parameters: {half: w/2, v: 0.2, w: 24*v, n: 4}\n" MATERIALS "bodies:\n"
         "  sheet:\n"
         "    material: rubber\n"
         "    shape: {rectangle: [n, rint(n/3)]}\n"
         "    origin: [1/3, -half]\n"
         "    velocity: [v, \"max(v, w)/100\"]\n"
         "    angle: 15*n\n"
         "run: {steps: 10*n, record-every: n}\n"
         "expect:\n"
         "  - {quantity: energy, value: 12*v^2, within: 1e-9 + 0*pi}\n";

static void a_formula_has_the_value_of_its_names(void **state)
{
    fw_scenario *s = scenario_of(formulas, NULL);
    (void)state;
    const fw_scenario_body *sheet = &s->bodies[0];
    assert_int_equal((int)sheet->shape.count, 4);
    assert_true(sheet->lattice.origin.x == 1.0 / 3 &&
                sheet->lattice.origin.y == -2.4000000000000004);
    assert_true(sheet->velocity.x == 0.2 && sheet->velocity.y == 24 * 0.2 / 100);
    assert_close(sheet->lattice.angle, acos(0.5), 1e-15);
    assert_int_equal(s->run.steps, 40);
    assert_int_equal(s->run.record_every, 4);
    assert_true(s->expectations[0].value == 12 * (0.2 * 0.2));
    fw_scenario_destroy(s);
}

/* Another value of a name reaches all that rests on it, also through other names. */
static void a_setting_changes_what_rests_on_a_name(void **state)
{
    fw_scenario *s = scenario_of(formulas, "parameters.v=0.1");
    (void)state;
    assert_true(s->bodies[0].velocity.x == 0.1 &&
                s->bodies[0].lattice.origin.y == -2.4000000000000004 / 2);
    fw_scenario_destroy(s);
    s = scenario_of(formulas, "run.steps=100*n");
    assert_int_equal(s->run.steps, 400);
    fw_scenario_destroy(s);
    s = scenario_of(formulas, "parameters.n=2*3");
    assert_int_equal(s->run.steps, 60);
    fw_scenario_destroy(s);
}

/* What was written and what it is worth are both kept, and read again. */
static void formulas_are_printed_with_their_values(void **state)
{
    static const char *const lines[] = {
        ("parameters: {half: \"w/2\", v: 0.2, w: \"24*v\", n: 4}  # = 2.4000000000000004, "
         "4.800000000000001\n"),
        "    velocity: [\"v\", \"max(v, w)/100\"]  # = 0.2, 0.04800000000000001\n",
        "run: {steps: \"10*n\", record-every: \"n\"}  # = 40, 4\n"};
    fw_scenario *first = scenario_of(formulas, NULL), *second;
    char *text, *again;
    (void)state;
    assert_fine(fw_scenario_print(first, &text, &error));
    for (size_t n = 0; n < sizeof lines / sizeof lines[0]; ++n)
        if (!strstr(text, lines[n])) fail_msg("without '%s':\n%s", lines[n], text);
    second = scenario_of(text, NULL);
    assert_fine(fw_scenario_print(second, &again, &error));
    assert_string_equal(text, again);
    assert_true(second->bodies[0].velocity.y == first->bodies[0].velocity.y);
    fw_scenario_destroy(first);
    fw_scenario_destroy(second);
    /* With another value, formulas are still there to follow it. */
    second = scenario_of(text, "parameters.v=0.1");
    assert_true(second->bodies[0].velocity.x == 0.1);
    fw_scenario_destroy(second);
    free(text);
    free(again);
}

/* --- sweeps --- */

#define FLIGHTS(parameters, v, steps, energy, sweep)                                               \
    HEAD parameters MATERIALS                                                                      \
        "bodies: {sheet: {material: rubber, shape: {rectangle: [4, 4]}, origin: [3.3, 4.7],"       \
        " velocity: [" v ", 0]}}\n"                                                                \
        "run: {steps: " steps ", record-every: 10}\n"                                              \
        "study: {seeds: 2, sweep: {parameters: {v: {values: [0.2, 0.1, 0.4]}}" sweep "}}\n"        \
        "expect: [{quantity: energy, value: " energy ", within: 1e-9}]\n"
static const char by_name[] = FLIGHTS("parameters: {v: 3, V: v^2}\n", "v", "rint(4/v)", "12*V", "");
static const char by_setting[] =
    FLIGHTS("", "3", "5", "1",
            ", set: ['bodies.sheet.velocity=[v, 0]', run.steps=rint(4/v), expect.0.value=12*v^2]");

static void a_sweep_varies_a_name_as_settings_would(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "name.yaml", by_name);
    write_scenario(folder, "setting.yaml", by_setting);
    outcome seen = run_program(folder, "run name.yaml -q --no-plot -o name");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "run setting.yaml -q --no-plot -o setting");
    expect_end(&seen, 0, "");
    shell(folder, "cmp name/sweep.csv setting/sweep.csv");
    shell(folder, "cmp name/v=0.4/summary.csv setting/v=0.4/summary.csv");
    /* A case knows its value, and nothing of the others. */
    seen = run_program(folder, "run name.yaml -q --no-plot -o one --set 'study.sweep.case={v: "
                               "0.4}'");
    expect_end(&seen, 0, "");
    expect_same_results(folder, "one", "name/v=0.4");
    seen = run_program(folder, "extend name --add v=0.3 --no-plot -q");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "extend name --add v=0.5 --set parameters.V=v^3");
    expect_end(&seen, 2,
               "old and new cases would be different things: parameters.V would change "
               "in v=0.2");
    remove_folder(folder);
    skip_unseen();
}

/* Settings of a case may use what rests on the name that varies. */
static void settings_see_the_names_of_their_case(void **state)
{
    fw_scenario *one,
        *sweep = scenario_of(FLIGHTS("parameters: {v: 3, V: 7*v}\n", "v", "40", "1",
                                     ", set: [run.steps=rint(10*V), 'expect.0.within=v + V']"),
                             NULL);
    (void)state;
    assert_fine(fw_scenario_read_case(&one, sweep, 1, &error));
    assert_int_equal(one->run.steps, 7);
    assert_close(one->expectations[0].within, 0.8, 1e-15);
    fw_scenario_destroy(one);
    fw_scenario_destroy(sweep);
}

static void a_control_changes_a_name_of_its_case(void **state)
{
    char text[1024];
    fw_scenario *one, *control, *sweep;
    char *printed;
    (void)state;
    snprintf(text, sizeof text, "%s", by_name);
    sweep = scenario_of(text, NULL);
    assert_fine(fw_scenario_read_case(&one, sweep, 2, &error));
    assert_true(one->bodies[0].velocity.x == 0.4 && one->run.steps == 10);
    assert_fine(fw_scenario_print(one, &printed, &error));
    control = scenario_of(printed, "parameters.v=0.8");
    assert_true(control->bodies[0].velocity.x == 0.8 && control->run.steps == 5);
    assert_true(control->study.sweep.is_case && control->study.sweep.values[0] == 0.4);
    free(printed);
    fw_scenario_destroy(control);
    fw_scenario_destroy(one);
    fw_scenario_destroy(sweep);
}

/* --- refusals --- */

#define WRONG(parameters, vx, steps)                                                               \
    HEAD parameters MATERIALS                                                                      \
        "bodies: {sheet: {material: rubber, shape: {rectangle: [4, 4]}, velocity: [" vx ", 0]}}\n" \
        "run: {steps: " steps ", record-every: 10}\n"
#define SWEPT(parameters, sweep)                                                                   \
    WRONG(parameters, "v", "40")                                                                   \
    "study: {sweep: {" sweep "}}\n"                                                                \
    "expect: [{quantity: energy, above: 0}]\n"
static const struct {
    const char *text, *sentence, *setting;
} refusals[] = {
    {WRONG("parameters: {speed: 2}\n", "24*sped", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula '24*sped' has the unknown name 'sped'; did you "
     "mean 'speed'?",
     NULL},
    {WRONG("parameters: {speed: 2}\n", "spee", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula 'spee' has the unknown name 'spee'; did you "
     "mean 'speed'?",
     NULL},
    {WRONG("", "24*v", "40"),
     "s:3:75: bodies.sheet.velocity.0: the formula '24*v' has the unknown name 'v', expected a "
     "parameter or a function such as sqrt",
     NULL},
    {WRONG("", "fast", "40"), "s:3:75: bodies.sheet.velocity.0 is 'fast', expected a number", NULL},
    {WRONG("parameters: {v: 0}\n", "1/v", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula '1/v' is infinite where v=0, expected a finite "
     "number",
     NULL},
    {WRONG("", "1/0", "40"),
     "s:3:75: bodies.sheet.velocity.0: the formula '1/0' is infinite, expected a finite number",
     NULL},
    {WRONG("parameters: {v: 2}\n", "sqrt(1 - v)", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula 'sqrt(1 - v)' is not a number where v=2, "
     "expected a finite number",
     NULL},
    {WRONG("parameters: {v: 2}\n", "3*(v", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula '3*(v' cannot be read to its end", NULL},
    {WRONG("parameters: {v: 2}\n", "3*v)", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula '3*v)' cannot be read from its character 4 on, "
     "')'",
     NULL},
    {WRONG("parameters: {v: 2}\n", "3*", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula '3*' ends where more is expected", NULL},
    {WRONG("parameters: {v: 2}\n", "2*v m", "40"),
     "s:4:75: bodies.sheet.velocity.0: the formula '2*v m' has the unknown name 'm', expected a "
     "parameter or a function such as sqrt",
     NULL},
    {WRONG("parameters: {v: 2}\n", "1", "40/(v + 1)"),
     "s:5:14: run.steps is '40/(v + 1)' = 13.333333333333334, expected a whole number of at least "
     "1, "
     "which rint(...) makes",
     NULL},
    {WRONG("parameters: {v: 2}\n", "1", "1 - v"),
     "s:5:14: run.steps is '1 - v' = -1, expected a whole number of at least 1", NULL},
    {WRONG("parameters: {v: 1e6}\n", "v^3", "40"),
     "s:4:75: bodies.sheet.velocity.0 is 'v^3' = 1e+18, expected a number, finite and at most "
     "1e+15 in size",
     NULL},
    {WRONG("parameters: {a: 2*a}\n", "a", "40"),
     "s:2:17: parameters.a is '2*a', which needs its own value", NULL},
    {WRONG("parameters: {a: 2*b, b: c + 1, c: a/2}\n", "a", "40"),
     "s:2:35: parameters.c is 'a/2', but the value of a needs that of c in its turn", NULL},
    {WRONG("parameters: {a: b*c, b: 2}\n", "a", "40"),
     "s:2:17: parameters.a: the formula 'b*c' has the unknown name 'c', expected a parameter or a "
     "function such as sqrt",
     NULL},
    {WRONG("parameters: {sin: 2}\n", "sin", "40"),
     "s:2:14: parameters: 'sin' is a function or constant of formulas, expected another name",
     NULL},
    {WRONG("parameters: {a-b: 2}\n", "1", "40"),
     "s:2:14: parameters: 'a-b' cannot stand in a formula, expected a letter and then letters, "
     "digits or '_'",
     NULL},
    {WRONG("parameters: {a: fast}\n", "1", "40"),
     "s:2:17: parameters.a: the formula 'fast' has the unknown name 'fast', expected a parameter "
     "or a function such as sqrt",
     NULL},
    {WRONG("parameters: {a: '2'}\n", "a", "40"),
     "s:2:17: parameters.a is the text '2', expected a number", NULL},
    {WRONG("parameters: {a: {values: [1, 2]}}\n", "a", "40"),
     "s:2:17: parameters.a is a mapping of 1, expected a number", NULL},
    {WRONG("parameters: {a: [1, 2]}\n", "a", "40"),
     "s:2:17: parameters.a is a list of 2, expected a number", NULL},
    {WRONG("parameters: 3\n", "1", "40"),
     "s:2:13: parameters is '3', expected names with a number each; such as {A: 2, F: 24*A}", NULL},
    {WRONG("parameters: {a: 1}\n", "a", "a=3"),
     "s:5:14: run.steps is 'a=3', expected a whole number of at least 1", NULL},
    {WRONG("parameters: {a: 1}\n", "1", "40"),
     "--set parameters.b=2: the parameter b changes nothing: no formula names it",
     "parameters.b=2"},
    {WRONG("parameters: {a: 1}\n", "a", "40"),
     "--set parameters.a=2*c: parameters.a: the formula '2*c' has the unknown name 'c', expected a "
     "parameter or a function such as sqrt",
     "parameters.a=2*c"},
    {SWEPT("parameters: {v: 1, w: 2}\n", "parameters: {w: {values: [1, 2]}}"),
     "s:6:30: the parameter w changes nothing: it occurs in no formula", NULL},
    {SWEPT("parameters: {v: 1}\n", "parameters: {v: {values: [1, 2]}, u: {values: [1, 2]}}"),
     "s:6:9: study.sweep has no 'set', which says what the values of u change: it is none of the "
     "scenario's 'parameters'",
     NULL},
    {SWEPT("parameters: {v: 1}\n", "parameters: {v: {values: [1, 3, 1]}}"),
     "s:6:49: the values of v have 1 twice, expected values that differ", NULL},
    {SWEPT("parameters: {v: 1}\n", "parameters: {v: {values: [1, 4/2, 2]}}"),
     "s:6:51: the values of v have 2 twice, expected values that differ", NULL},
    {SWEPT("parameters: {v: 1}\n", "parameters: {v: {}}, points: [{v: 1}, {v: 2/2}]"),
     "s:6:55: the points 0 and 1 of study.sweep are the same, expected points that differ", NULL},
    {SWEPT("parameters: {v: 1}\n", "parameters: {v: {values: [1]}}, set: [study.seeds=2*v]"),
     "s:6:55: the setting 'study.seeds=2*v' changes the study that it is part of, expected another "
     "key",
     NULL},
    {SWEPT("parameters: {v: 1}\n", "parameters: {v: {}}, case: {v: 2, u: 1}"),
     "s:6:51: 'u' is no parameter of study.sweep, expected one of v", NULL},
    {SWEPT("parameters: {v: 1, w: 1/v}\n", "parameters: {v: {from: 1, to: w, count: 3}}"),
     "s:6:47: the range of v goes from 1 to 1, expected values that differ", NULL},
};

static void every_mistake_gets_its_sentence(void **state)
{
    int wrong = 0;
    (void)state;
    for (size_t n = 0; n < sizeof refusals / sizeof refusals[0]; ++n) {
        fw_scenario *scenario;
        const fw_status status = read_text(&scenario, refusals[n].text, refusals[n].setting);
        if (status != FW_BAD_INPUT || strcmp(error.sentence, refusals[n].sentence) != 0) {
            print_error("  found    %s\n  expected %s\n", error.sentence, refusals[n].sentence);
            wrong += 1;
        }
        fw_scenario_destroy(scenario);
    }
    assert_int_equal(wrong, 0);
    assert_true(sizeof refusals / sizeof refusals[0] >= 30);
}

/* A case in which a formula has no value is named before anything runs. */
static void a_case_without_a_value_is_named(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "s.yaml",
                   FLIGHTS("parameters: {v: 3, V: 1/(v - 0.1)}\n", "V", "40", "1", ""));
    outcome seen = run_program(folder, "run s.yaml -q -o it");
    expect_end(&seen, 2,
               "s.yaml:6:19: the case v=0.1: s.yaml:2:23: parameters.V: the formula '1/(v - 0.1)' "
               "is infinite "
               "where v=0.1, expected a finite number");
    shell(folder, "test ! -e it");
    remove_folder(folder);
}

/* --- show --- */

static void show_prints_formulas_and_values(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "s.yaml", formulas);
    outcome seen = run_program(folder, "show s.yaml");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "    velocity: [v, \"max(v, w)/100\"]  # = 0.2, 0.048"));
    shell(folder, FW_PROGRAM " show s.yaml > again.yaml && " FW_PROGRAM
                             " show again.yaml --set run.steps=8 > a &&" FW_PROGRAM
                             " show s.yaml --set run.steps=8 > b && cmp a b");
    seen = run_program(folder, "show s.yaml --set parameters.n=0.5");
    expect_end(&seen, 2, "bodies.sheet.shape.rectangle.0 is 'n' = 0.5, expected a whole number");
    seen = run_program(folder, "show missing.yaml");
    expect_end(&seen, 2, "missing.yaml");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_formula_has_the_value_of_its_names),
        cmocka_unit_test(a_setting_changes_what_rests_on_a_name),
        cmocka_unit_test(formulas_are_printed_with_their_values),
        cmocka_unit_test(a_sweep_varies_a_name_as_settings_would),
        cmocka_unit_test(settings_see_the_names_of_their_case),
        cmocka_unit_test(a_control_changes_a_name_of_its_case),
        cmocka_unit_test(every_mistake_gets_its_sentence),
        cmocka_unit_test(a_case_without_a_value_is_named),
        cmocka_unit_test(show_prints_formulas_and_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
