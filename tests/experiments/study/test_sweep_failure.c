/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_sweep_failure.c - runs that go wrong: a case that diverges is told in the table of its
 * sweep, what a run warned of in its results, and a sweep that is interrupted goes on. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "experiments/study/sweep_table.h"
#include "tests/support/program.h"

static const char hopeless[] = "title: a sweep with one hopeless case\n"
                               "materials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
                               "bodies: {b: {material: m, shape: {rectangle: [4, 4]}}}\n"
                               "run: {steps: 3}\n"
                               "study: {sweep: {parameters: {v: {values: [0.1, 1e6, 0.2]}}, set: "
                               "['bodies.b.velocity=[v, 0]']}}\n"
                               "expect:\n"
                               "  - {quantity: mean-velocity, component: x, above: -1}\n"
                               "  - {quantity: mean-velocity, component: x, trend: rises}\n";

static void check_table(const char *folder)
{
    char path[128];
    fw_sweep_table table;
    snprintf(path, sizeof path, "%s/it", folder);
    assert_fine(fw_sweep_table_read(&table, path, 1, &error));
    assert_int_equal(table.row_count, 3);
    assert_int_equal(table.column_count, 1);
    assert_close(table.columns[0].mean[0], 0.1, 1e-12);
    assert_true(isnan(table.columns[0].mean[1]));
    assert_close(table.columns[0].mean[2], 0.2, 1e-12);
    assert_null(table.failures[0]);
    assert_non_null(strstr(table.failures[1], "expected finite numbers"));
    assert_null(table.failures[2]);
    fw_sweep_table_clear(&table);
    /* As many commas outside of quotes in each line of the table. */
    shell(folder, "test $(tail -n +3 it/sweep.csv | sed 's/\"[^\"]*\"//g; s/[^,]//g' | sort -u |"
                  " wc -l) = 1");
}

static void a_case_that_diverges_leaves_the_others(void **state)
{
    static const char words[] = "case v=1000000 of 3 failed: step 1: particle";
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "hopeless.yaml", hopeless);
    outcome seen = run_program(folder, "run hopeless.yaml -q --no-plot -o it");
    expect_end(&seen, 3, words);
    /* The rise is that from 0.1 to 0.2. */
    assert_non_null(strstr(seen.out, "least rise (from v=0.1)"));
    assert_null(strstr(seen.out, "FAILS"));
    check_table(folder);
    /* An interrupted sweep goes on: what is finished stays, what has failed is not tried again. */
    shell(folder, "rm -r it/sweep.csv it/v=0.2; touch -r hopeless.yaml it/v=*/trajectory.h5;"
                  " ls -l --time-style=full-iso it/v=*/trajectory.h5 > before");
    seen = run_program(folder, "resume it -q --no-plot");
    expect_end(&seen, 3, words);
    shell(folder, "ls -l --time-style=full-iso it/v=0.1/trajectory.h5 it/v=1000000/trajectory.h5 |"
                  " cmp - before");
    check_table(folder);
    remove_folder(folder);
}

static const char loud[] = "title: a fast sheet flies over a floor\n"
                           "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
                           "bodies: {sheet: {material: rubber, shape: {rectangle: [3, 3]},"
                           " velocity: [0.9, 0]}}\n"
                           "walls: {floor: {chain: [[-50, -5], [500, -5]]}}\n"
                           "run: {steps: 20, record-every: 5}\n";

static void warnings_are_kept_in_the_results(void **state)
{
    char folder[64], path[128];
    fw_playback *playback;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "loud.yaml", loud);
    const outcome seen = run_program(folder, "run loud.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "warning: body sheet moves");
    snprintf(path, sizeof path, "%s/it", folder);
    assert_fine(fw_playback_open(&playback, path, &error));
    if (!strstr(seen.err, playback->warnings) || !playback->warnings[0])
        fail_msg("said: %s kept: %s", seen.err, playback->warnings);
    fw_playback_close(playback);
    remove_folder(folder);
}

/* Cases with two seeds and a control each. */
static const char rubbing[] =
    "title: two crystals rub\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "dynamics: {time-step: 0.005, damping: 0.4, temperature: 0.01}\n"
    "bodies:\n"
    "  left: {material: grain, lattice: hexagonal, shape: {rectangle: [5, 6]}, origin: [-5, 0]}\n"
    "  right: {material: grain, lattice: hexagonal, shape: {rectangle: [5, 6]}, origin: [0.5, 0]}\n"
    "grips:\n"
    "  left: {body: left, side: left, layer: 1.2, force: [9, 0], tether: [0, 2]}\n"
    "  right: {body: right, side: right, layer: 1.2, force: [-9, 0], tether: [0, 2]}\n"
    "phases:\n"
    "  settle: {until: 200, damping: 1}\n"
    "  sample: {until: 1600, grips: {left: {force: [9, 0], amplitude: [0, 9], period: 2}}}\n"
    "run: {steps: 1600, record-every: 50, measure-every: 10, checkpoint-every: 100}\n"
    "profile: {axis: x, phase: sample, every: 20, bin: 0.9, far: [2, 4]}\n"
    "study:\n"
    "  seeds: 2\n"
    "  control: ['phases.sample.grips.left.amplitude=[0, 0]']\n"
    "  sweep:\n"
    "    parameters: {A: {values: [1, 0.5, 2]}}\n"
    "    set: ['phases.sample.grips.left.amplitude=[0, 6*A]']\n"
    "expect:\n"
    "  - {quantity: momentum-error, component: x, statistic: largest, below: 1}\n"
    "  - {quantity: layer-slip-path, above: 0}\n";

static void interrupted_sweep_comes_to_the_same_bytes(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "rubbing.yaml", rubbing);
    outcome seen = run_program(folder, "run rubbing.yaml -q --no-plot --threads 2 -o whole");
    expect_end(&seen, 0, "");
    running run = start_program(folder, "run rubbing.yaml -q --no-plot --threads 1 -o part");
    await_file(folder, "part/A=0.5/checkpoint-B");
    kill(run.process, SIGTERM);
    seen = await_program(run);
    expect_end(&seen, 143, "interrupted in case 2 of 3, A=0.5; `fretwork resume part` goes on");
    assert_true(exists(folder, "part/sweep-as-run.yaml"));
    assert_false(exists(folder, "part/sweep.csv"));
    assert_false(exists(folder, "part/A=2"));
    seen = run_program(folder, "plot part");
    expect_end(&seen, 2, "part: the sweep is not finished; `fretwork resume part` goes on");
    /* The finished case is read back: its folder could not be written to. */
    const ino_t finished = inode_of(folder, "part/A=1/summary.csv");
    run = start_program(folder, "resume part -q --no-plot");
    await_file(folder, "part/A=2/checkpoint-B");
    kill(run.process, SIGKILL);
    await_program(run);
    assert_false(exists(folder, "part/sweep.csv"));
    seen = run_program(folder, "resume part -q --no-plot --threads 2");
    expect_end(&seen, 0, "");
    assert_true(finished != 0 && inode_of(folder, "part/A=1/summary.csv") == finished);
    shell(folder, "cmp whole/sweep.csv part/sweep.csv");
    shell(folder, "for c in 1 0.5 2; do for f in summary layer profile; do"
                  " cmp whole/A=$c/$f.csv part/A=$c/$f.csv || exit 1; done; done");
    expect_same_results(folder, "whole/A=0.5", "part/A=0.5");
    expect_same_results(folder, "whole/A=0.5/control", "part/A=0.5/control");
    /* A case of another sweep in its place is not taken for this one's. */
    shell(folder, "rm part/sweep.csv && rm -r part/A=2 && cp -r whole/A=1 part/A=2");
    seen = run_program(folder, "resume part -q --no-plot");
    expect_end(&seen, 2, "part/A=2 holds results of another scenario than the sweep");
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_case_that_diverges_leaves_the_others),
        cmocka_unit_test(warnings_are_kept_in_the_results),
        cmocka_unit_test(interrupted_sweep_comes_to_the_same_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
