/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_sweep_extend.c - further values of a finished sweep, what is refused of them, and studies
 * that keep all their runs. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

#define GAS(sweep)                                                                                 \
    "title: a gas of few particles\n"                                                              \
    "materials: {grain: {movable-particles: {return-force: {amplitude: 0}}}}\n"                    \
    "dynamics: {time-step: 0.005, damping: 0.5, temperature: 1}\n"                                 \
    "bodies: {gas: {material: grain, lattice: square, spacing: 3, shape: {rectangle: [3, 3]}}}\n"  \
    "run: {steps: 200, record-every: 50}\n"                                                        \
    "study:\n"                                                                                     \
    "  seeds: 2\n"                                                                                 \
    "  sweep: {" sweep ", set: [dynamics.temperature=T, dynamics.damping=mu]}\n"                   \
    "expect:\n"                                                                                    \
    "  - {quantity: temperature, statistic: mean, above: 0}\n"
static const char product[] = GAS("parameters: {T: {from: 0.1, to: 0.3, count: 3, unit: \"k's "
                                  "energy\"}, mu: {values: [2], unit: mass}}");
static const char whole[] =
    GAS("parameters: {T: {values: [0.1, 0.2, 0.3, 0.6], unit: \"k's energy\"}, "
        "mu: {values: [2, 0.5, 1], unit: mass}}");
static const char points[] =
    GAS("parameters: {T: {}, mu: {}}, points: [{T: 0.1, mu: 1}, {T: 0.2, mu: 2}]");

static void further_values_are_as_if_they_had_been_there(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", product);
    write_scenario(folder, "whole.yaml", whole);
    outcome seen = run_program(folder, "run whole.yaml -q --no-plot -o whole");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "run gas.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    const ino_t old = inode_of(folder, "it/T=0.2,mu=2/trajectory.h5");
    seen = run_program(folder, "extend it --add mu=0.5 -q --no-plot");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "extend it --add T=0.6 --add=mu=1 -q --no-plot -j 2");
    expect_end(&seen, 0, "");
    shell(folder, "cmp it/sweep.csv whole/sweep.csv");
    expect_same_results(folder, "whole/T=0.6,mu=0.5", "it/T=0.6,mu=0.5");
    assert_true(old != 0 && inode_of(folder, "it/T=0.2,mu=2/trajectory.h5") == old);
    write_scenario(folder, "points.yaml", points);
    seen = run_program(folder, "run points.yaml -q --no-plot -o points");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "extend points --add mu=0.5,T=0.6 -q");
    expect_end(&seen, 0, "");
    shell(folder, "test \"$(sed -n '3,$p' points/sweep.csv | cut -d, -f1-2 | tr '\\n' ' ')\" ="
                  " 'T,mu 0.1,1 0.2,2 0.6,0.5 '");
    shell(folder, "cmp points/T=0.6,mu=0.5/summary.csv it/T=0.6,mu=0.5/summary.csv");
    remove_folder(folder);
    skip_unseen();
}

static void what_would_make_cases_differ_is_refused(void **state)
{
    static const struct {
        const char *line, *sentence;
    } rows[] = {
        {"extend it", "it: nothing to add, expected --add such as --add T=1"},
        {"extend it --add T", "--add T: expected NAME=VALUE, such as T=1"},
        {"extend it --add T=hot", "--add T=hot: 'hot' is no number"},
        {"extend it --add T=0.2", "--add T=0.2: the sweep has that already"},
        {"extend it --add T=4 --add T=4", "--add T=4 is given twice"},
        {"extend it --add nu=4", "--add nu=4: the sweep has no parameter nu; did you mean mu?"},
        {"extend it --add nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn=4",
         "expected NAME=VALUE, such as T=1"},
        {"extend it --add pressure=4",
         "--add pressure=4: the sweep has no parameter pressure, expected one such as T"},
        {"extend points --add T=4,T=5", "--add T=4,T=5: T has two values, expected one"},
        {"extend it --add T=4 --set record.force=true --set measure=[energy,momentum]",
         "different things: record, measure would change in T=0.1,mu=2"},
        {"extend it --add T=4 --set run.seed=2 --set run.record-every=40",
         "different things: run.record-every, run.seed would change in T=0.1,mu=2"},
        {"extend it --add T=4 --set 'study.sweep.parameters={mu: {values: [2]}}' --set "
         "study.sweep.set=[dynamics.damping=mu]",
         "it: the case T=0.1,mu=2 would be lost"},
        {"extend it --add T=4,mu=1", "--add T=4,mu=1: every value of one parameter meets all"},
        {"extend it --add T=4 --set run.steps=300",
         "it: old and new cases would be different things: run.steps would change in T=0.1,mu=2"},
        {"extend it --add T=4 --set study.seeds=3 --set dynamics.time-step=0.004",
         "different things: dynamics.time-step, study.seeds would change in T=0.1,mu=2"},
        {"extend it --add T=4 --set expect.0.above=1", "expect.0.above would change in T=0.1,mu=2"},
        {"extend it --add T=4 --set study.sweep.set=[dynamics.temperature=T*2,dynamics.damping=mu]",
         "dynamics.temperature would change in T=0.1,mu=2"},
        {"extend it --add T=4 --set study.sweep.parameters.mu.values=[3]",
         "it: the case T=0.1,mu=2 would be lost"},
        {"extend it --add T=4 --set study.sweep.case={T: 4}", "expected"},
        {"extend it --add T=-1", "temperature"},
        {"extend points --add T=4", "--add T=4: the sweep has points, expected a value of each of "
                                    "its 2 parameters"},
        {"extend points --add T=0.2,mu=2", "--add T=0.2,mu=2: the sweep has that already"},
        {"extend nothing --add T=1", "nothing holds no sweep that could be extended"},
    };
    char folder[64];
    int wrong = 0;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", product);
    write_scenario(folder, "points.yaml", points);
    outcome seen = run_program(folder, "run gas.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "sweep points.yaml -o points --list");
    expect_end(&seen, 0, "");
    shell(folder, "cp -r it kept");
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        seen = run_program(folder, rows[n].line);
        if (seen.code == 2 && strstr(seen.err, rows[n].sentence)) continue;
        print_error("%s:\n  found    %d %s  expected %s\n", rows[n].line, seen.code, seen.err,
                    rows[n].sentence);
        wrong += 1;
    }
    assert_int_equal(wrong, 0);
    shell(folder, "diff -r it kept");
    remove_folder(folder);
}

/* Two crystals, with a control. */
static const char rubbing[] =
    "title: two crystals rub\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "dynamics: {time-step: 0.005, damping: 0.4, temperature: 0.01}\n"
    "bodies:\n"
    "  left: {material: grain, lattice: hexagonal, shape: {rectangle: [5, 6]}, origin: [-5, 0]}\n"
    "  right: {material: grain, lattice: hexagonal, shape: {rectangle: [5, 6]}, origin: [0.5, 0]}\n"
    "run: {steps: 100, record-every: 50, seed: 7}\n"
    "profile: {axis: x, every: 20, bin: 0.9, far: [2, 4]}\n"
    "study: {seeds: 3, keep: true, control: [dynamics.damping=1]}\n";

static void kept_runs_are_those_of_their_seeds(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "rubbing.yaml", rubbing);
    outcome seen = run_program(folder, "run rubbing.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    shell(folder, "test \"$(cd it && ls -d */ | tr '\\n' ' ')\" = "
                  "'control-seed-8/ control-seed-9/ control/ seed-8/ seed-9/ '");
    seen = run_program(folder, "run rubbing.yaml -q --no-plot -o few --set study.keep=false");
    expect_end(&seen, 0, "");
    shell(folder, "test \"$(cd few && ls -d */)\" = control/ && cmp few/layer.csv it/layer.csv");
    seen = run_program(folder, "run rubbing.yaml -q --no-plot -o one --seed 9");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "table one --observable energy -o one.csv");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "table it/seed-9 --observable energy -o nine.csv");
    expect_end(&seen, 0, "");
    shell(folder, "cmp one.csv nine.csv");
    seen = run_program(folder, "table it/seed-8 --observable energy -o eight.csv");
    expect_end(&seen, 0, "");
    shell(folder, "! cmp -s one.csv eight.csv");
    /* What the next result has not goes. */
    seen = run_program(folder, "run rubbing.yaml -q --no-plot -o it --overwrite --set "
                               "study.keep=false");
    expect_end(&seen, 0, "");
    shell(folder, "test \"$(cd it && ls -d */)\" = control/");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(further_values_are_as_if_they_had_been_there),
        cmocka_unit_test(what_would_make_cases_differ_is_refused),
        cmocka_unit_test(kept_runs_are_those_of_their_seeds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
