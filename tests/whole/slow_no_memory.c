/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_no_memory.c - every allocation of the program fails once, wherever it is asked for: the
 * program says so and ends with its code, or goes on to the same results. It never ends by a
 * signal, and never blames the user or his files. */
#include "tests/support/laws.h"

#include "tests/support/program.h"
#include "tests/support/small_scenarios.h"

static const char sheets[] =
    "title: an automaton that breaks, at two speeds\n"
    "materials: {sheet: {elastic-automaton: {c1: .4, c2: .2, break-at: .02}}}\n"
    "parameters: {w: 2*v, v: .1}\n"
    "bodies: {sheet: {material: sheet, shape: {rectangle: [6, 5]}, velocity: [v, 0*w]}}\n"
    "walls: {stop: {chain: [[7, -3], [7, 9]], surface: frictionless}}\n"
    "run: {steps: 40, record-every: 10, measure-every: 10}\n"
    "measure: [energy]\n"
    "expect: [{quantity: energy, above: 0}]\n"
    "study: {sweep: {parameters: {v: {values: [.05, .1]}}, set: [run.seed=1 + 0*v]}}\n";

/* Runs a line once for each place that asks for memory. `made`, unless NULL: results that it leaves
 * behind; where it succeeds they are those that it leaves with enough memory. */
static void fail_everywhere(const char *folder, const char *line, const char *made)
{
    char failed[512], number[16];
    snprintf(failed, sizeof failed, "%s/failed", folder);
    assert_int_equal(run_program(folder, line).code, 0);
    if (made) {
        char keep[1200];
        snprintf(keep, sizeof keep, "rm -rf whole; mv %s whole", made);
        shell(folder, keep);
    }
    int places = 0, refused = 0;
    for (;; ++places) {
        char clean[1200];
        snprintf(clean, sizeof clean, "rm -rf failed %s", made ? made : "");
        shell(folder, clean);
        snprintf(number, sizeof number, "%d", places + 1);
        setenv("FW_FAIL_AT", number, 1);
        setenv("FW_FAILED", failed, 1);
        setenv("LD_PRELOAD", FW_FAILING_MEMORY, 1);
        const outcome seen = run_program(folder, line);
        unsetenv("LD_PRELOAD");
        if (!exists(folder, "failed")) break;
        if (seen.code != 0 && seen.code != 4)
            fail_msg("place %d: code %d, signal %d: %s", places + 1, seen.code, seen.signal,
                     seen.err);
        if (seen.code == 4 && !strstr(seen.err, "memory"))
            fail_msg("place %d: %s", places + 1, seen.err);
        if (seen.code == 0 && made && exists(folder, "whole/trajectory.h5"))
            expect_same_results(folder, "whole", made);
        if (seen.code == 0 && made && exists(folder, "whole/sweep.csv"))
            shell(folder, "cmp whole/sweep.csv out/sweep.csv && cmp whole/sweep.h5 out/sweep.h5");
        refused += seen.code == 4;
    }
    print_message("%s: %d places, %d refused\n", line, places, refused);
    assert_true(places > 20 && refused > places / 2);
}

/* The run, then what reads its results, and one line of its own kind. */
static void check_study(const char *text, const char *line)
{
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", text);
    fail_everywhere(folder, "run file.yaml -o out --quiet", "out");
    fail_everywhere(folder, "plot whole", NULL);
    fail_everywhere(folder, line, NULL);
    remove_folder(folder);
}

static void run_with_contact_says_that_memory_is_missing(void **state)
{
    (void)state;
    check_study(two_blocks, "table whole");
}

static void run_over_seeds_says_that_memory_is_missing(void **state)
{
    (void)state;
    check_study(held_crystal, "profile whole");
}

static void sweep_says_that_memory_is_missing(void **state)
{
    (void)state;
    check_study(sheets, "collect whole");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(run_with_contact_says_that_memory_is_missing),
        cmocka_unit_test(run_over_seeds_says_that_memory_is_missing),
        cmocka_unit_test(sweep_says_that_memory_is_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
