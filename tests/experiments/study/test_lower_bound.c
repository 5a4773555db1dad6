/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lower_bound.c - an error that is a lower bound is called one in all that a sweep leaves. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

/* One correlation time of a Brownian particle on a spring. */
static void an_error_that_is_a_lower_bound_stays_one(void **state)
{
    static const char text[] =
        "title: wanders\n"
        "materials: {m: {movable-particles: {strength: 0}}}\n"
        "bodies: {c: {material: m, shape: {sites: [[0, 0]]}, temperature: 1}}\n"
        "grips: {g: {body: c, tether: [0.01, 0.01]}}\n"
        "dynamics: {time-step: 0.05, damping: 1, temperature: 1}\n"
        "run: {steps: 2000, measure-every: 10, seed: 2}\n"
        "study: {sweep: {parameters: {T: {values: [1, 2]}}, set: [dynamics.temperature=T]}}\n"
        "expect:\n"
        "  - {quantity: centre-of-mass, component: x, statistic: mean, below: 1e3}\n"
        "  - {quantity: temperature, statistic: mean, below: 1}\n";
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "wanders.yaml", text);
    outcome seen = run_program(folder, "run wanders.yaml -q -o it");
    expect_end(&seen, 1, "");
    const char *const own = "centre-of-mass.c x, mean";
    char command[512];
    snprintf(command, sizeof command,
             "grep -q '\"%s error\",\"%s error is lower bound\"' it/sweep.csv &&"
             " test $(grep -c ',1,' it/sweep.csv) = 2 &&"
             " grep -q '^\"%s\",< 1000,.*,holds,1,,' it/T=1/summary.csv &&"
             " grep -q 'fewer than two of its particles are free,' it/T=1/summary.csv",
             own, own, own);
    shell(folder, command);
    /* A sweep that goes on reads it back. */
    shell(folder, "cp it/sweep.csv whole.csv && rm it/sweep.csv");
    seen = run_program(folder, "resume it -q");
    expect_end(&seen, 1, "");
    assert_non_null(strstr(seen.out, " +- >= "));
    assert_non_null(strstr(seen.out, "no number: fewer than two of its particles are free"));
    shell(folder, "cmp whole.csv it/sweep.csv && head -c 4 it/sweep.png | grep -q PNG");
    seen = run_program(folder, "verify wanders.yaml -q --json -");
    expect_end(&seen, 1, "");
    assert_non_null(strstr(seen.out, "\"error-is-lower-bound\": true"));
    assert_non_null(strstr(seen.out, "\"no-number-since\": \"fewer than two"));
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_error_that_is_a_lower_bound_stays_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
