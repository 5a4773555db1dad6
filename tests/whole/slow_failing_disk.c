/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_failing_disk.c - every call to the disk fails once, with an error or since it is full,
 * wherever the program makes one: it says so and ends with its code, or does not need it. */
#include "tests/support/laws.h"

#include "tests/support/failed_calls.h"

static const char sheets[] =
    "title: an automaton at two speeds\n"
    "materials: {sheet: {elastic-automaton: {c1: .4, c2: .2, break-at: .02}}}\n"
    "parameters: {v: .1}\n"
    "bodies: {sheet: {material: sheet, shape: {rectangle: [6, 5]}, velocity: [v, 0]}}\n"
    "walls: {stop: {chain: [[7, -3], [7, 9]], surface: frictionless}}\n"
    "run: {steps: 40, record-every: 10, measure-every: 10}\n"
    "measure: [energy]\n"
    "expect: [{quantity: energy, above: 0}]\n"
    "study: {sweep: {parameters: {v: {values: [.05, .1]}}}}\n"
    "pictures: {energy: {kind: sweep, observables: [energy]}}\n";

static char folder[64];

static void begin_with(const char *text, const char *line)
{
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", text);
    const outcome seen = run_program(folder, line);
    expect_end(&seen, 0, "");
}

static int begin_blocks(void **state)
{
    (void)state;
    begin_with(two_blocks, "run file.yaml -o good --quiet --no-plot");
    return 0;
}

static int begin_crystal(void **state)
{
    (void)state;
    begin_with(held_crystal, "run file.yaml -o good --quiet --no-plot");
    return 0;
}

static int begin_sheets(void **state)
{
    (void)state;
    begin_with(sheets, "run file.yaml -o good --quiet --no-plot");
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static void fail_everywhere(const failing_line *f, int least)
{
    assert_true(fail_calls(folder, f, EIO, 1, 1) >= least);
    assert_true(fail_calls(folder, f, ENOSPC, 1, 1) >= 0);
}

static void runs_go_on_or_begin_again(void **state)
{
    (void)state;
    const failing_line run = {"run file.yaml -o out --quiet", "out", NULL, look_at_run, false};
    fail_everywhere(&run, 100);
}

/* As it lies there when its second checkpoint is written and something fails. */
static void what_is_resumed_goes_on_or_begins_again(void **state)
{
    (void)state;
    for (int place = 20; !exists(folder, "out/checkpoint-B"); place += 3) {
        shell(folder, "rm -rf out failed");
        run_failing(folder, "run file.yaml -o out --quiet --no-plot", place, EIO);
        if (!exists(folder, "failed")) fail_msg("no run stops");
    }
    shell(folder, "rm -f failed; mv out stopped");
    const failing_line resume = {"resume out --quiet --no-plot", "out", "cp -r stopped out",
                                 look_at_run, false};
    fail_everywhere(&resume, 50);
}

static void seeds_go_on_or_begin_again(void **state)
{
    (void)state;
    const failing_line run = {"run file.yaml -o out --quiet -j 1", "out", NULL, look_at_run, false};
    fail_everywhere(&run, 100);
}

/* The same line, or where it refuses what lies there the same over it, makes the whole sweep. */
static void expect_sweep(const char *line)
{
    char over[256];
    outcome again = run_program(folder, line);
    if (again.code == 2 && strstr(again.err, "overwrite")) {
        snprintf(over, sizeof over, "%s --overwrite", line);
        again = run_program(folder, over);
    }
    if (again.code != 0) fail_msg("%s ends with %d: %s", line, again.code, again.err);
}

static void look_at_sweep(const char *where, const outcome *seen)
{
    if (seen->code == 4) expect_sweep("run file.yaml -o out --quiet --no-plot -j 1");
    expect_equal_runs(where, "keep/out/v=0.05", "out/v=0.05");
    expect_equal_runs(where, "keep/out/v=0.1", "out/v=0.1");
    if (!holds(where, "cmp out/sweep.csv %s/sweep.csv", "keep/out")) fail_msg("tables differ");
}

static void look_at_case(const char *where, const outcome *seen)
{
    if (seen->code == 4) expect_sweep("sweep out --case v=0.1 --quiet");
    expect_equal_runs(where, "keep/out/v=0.1", "out/v=0.1");
}

static void look_at_table(const char *where, const outcome *seen)
{
    if (seen->code == 4) expect_sweep("collect out --no-plot");
    if (!holds(where, "cmp out/sweep.csv %s/sweep.csv", "keep/out")) fail_msg("tables differ");
}

static void look_at_extension(const char *where, const outcome *seen)
{
    if (seen->code == 4) {
        const outcome again = run_program(where, "extend out --add v=.07 --quiet --no-plot -j 1");
        if (again.code == 2 && strstr(again.err, "has that already"))
            expect_sweep("resume out --quiet --no-plot -j 1");
        else if (again.code != 0)
            fail_msg("extend ends with %d: %s", again.code, again.err);
    }
    expect_equal_runs(where, "keep/out/v=0.07", "out/v=0.07");
    if (!holds(where, "cmp out/sweep.csv %s/sweep.csv", "keep/out")) fail_msg("tables differ");
}

static void sweeps_go_on(void **state)
{
    (void)state;
    const failing_line run = {"run file.yaml -o out --quiet --no-plot -j 1", "out", NULL,
                              look_at_sweep, false};
    fail_everywhere(&run, 100);
    shell(folder, "cp -r good cases; rm -rf cases/sweep.csv cases/sweep.h5");
    const failing_line table = {"collect out --no-plot", "out", "cp -r cases out", look_at_table,
                                false};
    fail_everywhere(&table, 20);
    shell(folder, "rm -rf cases/v=0.1");
    const failing_line one = {"sweep out --case v=0.1 --quiet", "out", "cp -r cases out",
                              look_at_case, false};
    fail_everywhere(&one, 50);
    const failing_line more = {"extend out --add v=.07 --quiet --no-plot -j 1", "out",
                               "cp -r good out", look_at_extension, false};
    fail_everywhere(&more, 50);
}

static void pictures_are_whole_or_not_there(void **state)
{
    (void)state;
    const failing_line lines[] = {
        {"plot whole", "whole", "cp -r good whole", look_at_plot, false},
        {"plot good -o p.svg", "p.svg", NULL, NULL, false},
        {"film good -o f.mp4", "f.mp4", NULL, NULL, false},
        {"report good -o r.html", "r.html", NULL, NULL, false},
        {"check file.yaml -o c.png", "c.png", NULL, NULL, true},
    };
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n) fail_everywhere(&lines[n], 5);
}

/* They hold times, which differ; what ends as it should is whole. */
static void look_at_verdicts(const char *where, const outcome *seen)
{
    if (seen->code == 4 && !exists(where, "v.json")) return;
    if (!holds(where, "tail -n 1 v.json | cmp - %s", "end")) fail_msg("verdicts are not whole");
}

static void what_is_written_of_results_is_whole_or_not_there(void **state)
{
    (void)state;
    shell(folder, "echo '}' > end");
    const failing_line lines[] = {
        {"table good -o t.csv", "t.csv", NULL, NULL, false},
        {"export good --to xdmf -o x.xdmf", "x.xdmf", NULL, NULL, false},
        {"export good --to extxyz -o x.xyz", "x.xyz", NULL, NULL, false},
        {"verify file.yaml --json v.json --quiet", "v.json", NULL, look_at_verdicts, true},
        {"list good", "", NULL, NULL, false},
        {"show file.yaml", "", NULL, NULL, false},
        {"cite good", "", NULL, NULL, false},
    };
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n) fail_everywhere(&lines[n], 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(runs_go_on_or_begin_again, begin_blocks, end),
        cmocka_unit_test_setup_teardown(what_is_resumed_goes_on_or_begins_again, begin_blocks, end),
        cmocka_unit_test_setup_teardown(sweeps_go_on, begin_sheets, end),
        cmocka_unit_test_setup_teardown(seeds_go_on_or_begin_again, begin_crystal, end),
        cmocka_unit_test_setup_teardown(pictures_are_whole_or_not_there, begin_blocks, end),
        cmocka_unit_test_setup_teardown(what_is_written_of_results_is_whole_or_not_there,
                                        begin_blocks, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
