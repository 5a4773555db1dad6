/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_sweep_bisection.c - thresholds by bisection: against those that are known in closed form,
 * with and without noise, on several lines, interrupted; and what is refused. */
#include "tests/support/laws.h"

#include "experiments/scenario/scenario.h"
#include "tests/support/program.h"

/* A sheet that flies with v for 40 steps: its centre of mass, at 5 in the beginning, passes X where
 * v = (X - 5)/40; and it has the energy 12 v^2, see test_sweep.c. */
#define FLIGHT(parameters, set, expect)                                                            \
    "title: a sheet flies\n"                                                                       \
    "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"                                   \
    "bodies: {sheet: {material: rubber, shape: {rectangle: [4, 4]}, origin: [3.5, 4.5]}}\n"        \
    "run: {steps: 40, record-every: 40}\n"                                                         \
    "study: {sweep: {parameters: {" parameters "}, set: [" set "]}}\n"                             \
    "expect:\n"                                                                                    \
    "  - {quantity: energy-drift, statistic: largest, below: 1e-12}\n"                             \
    "  - " expect "\n"
#define ALONG_X  "'bodies.sheet.velocity=[v, 0]'"
#define CROSSING "{quantity: centre-of-mass, component: x, crosses: 9, "

static void known_threshold_is_found_to_its_tolerance(void **state)
{
    static const char flight[] =
        FLIGHT("v: {from: 0, to: 0.5, tolerance: 0.001, unit: length/time}", ALONG_X,
               CROSSING "value: 0.1, within: 0.0005}");
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flight.yaml", flight);
    outcome seen = run_program(folder, "run flight.yaml -q --no-plot -o it -j 1");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "v where centre-of-mass.sheet x, at the end crosses 9"));
    /* 0 and 0.5, and the halves between: 9 of them, until two are a 512th part of 0.5 apart. */
    shell(folder, "test $(sed -n '4,$p' it/sweep.csv | wc -l) = 11");
    shell(folder, "test $(ls -d it/v=* | wc -l) = 11 && grep -q 'points:' it/sweep-as-run.yaml");
    /* Nothing is left to do, and nothing is done. */
    seen = run_program(folder, "resume it");
    expect_end(&seen, 2, "it: the sweep is finished");
    seen = run_program(folder, "collect it --no-plot");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "plot it -o it.svg");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "extend it --add v=0.3");
    expect_end(&seen, 2, "it: the sweep bisects v, whose values follow from each other");
    /* By any engine, a round after the other: as long as there are further cases. */
    seen = run_program(folder, "sweep flight.yaml -o other --list");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, "fretwork sweep other --case v=0\n"
                                  "fretwork sweep other --case v=0.5\n");
    int rounds = 0;
    do {
        shell(folder,
              FW_PROGRAM " sweep other --list | sed 's,^fretwork," FW_PROGRAM ",' | sh >said");
        seen = run_program(folder, "collect other --no-plot");
        if (rounds == 0)
            expect_end(&seen, 2,
                       "other: the bisection goes on with 1 further cases, which `fretwork sweep "
                       "other --list` lists and `fretwork resume other` runs");
    } while (seen.code == 2 && ++rounds < 20);
    expect_end(&seen, 0, "");
    assert_int_equal(rounds, 9);
    shell(folder,
          "cmp it/sweep.csv other/sweep.csv && cmp it/thresholds.csv other/thresholds.csv &&"
          " cmp it/sweep.h5 other/sweep.h5");
    /* A threshold that is not there. */
    seen = run_program(folder, "verify flight.yaml -q --set expect.1.crosses=100");
    expect_end(&seen, 1, "");
    assert_non_null(strstr(seen.out, "no number: it is below the level at both ends"));
    seen = run_program(folder, "verify flight.yaml -q --set expect.1.value=0.0985");
    expect_end(&seen, 1, "");
    /* By factors, and downwards. */
    seen =
        run_program(folder, "verify flight.yaml -q --set 'study.sweep.parameters.v={from: 1, to: "
                            "0.01, tolerance: 0.001, spacing: logarithmic}'");
    expect_end(&seen, 0, "");
    /* Every middle is the geometric one, and has the sign of both. */
    seen = run_program(folder,
                       "run flight.yaml -q --no-plot -o it --overwrite --set expect.1.crosses=13 "
                       "--set expect.1.value=0.247 --set 'study.sweep.parameters.v={from: 0.01, "
                       "to: 1, tolerance: 0.2, spacing: logarithmic}'");
    expect_end(&seen, 0, "");
    shell(folder, "test \"$(ls -d it/v=* | tr '\\n' ' ')\" = 'it/v=0.01 it/v=0.1 "
                  "it/v=0.177827941 it/v=0.316227766 it/v=1 '");
    seen = run_program(folder,
                       "run flight.yaml -q --no-plot -o it --overwrite --set expect.1.crosses=-3 "
                       "--set expect.1.value=-0.55 --set expect.1.within=0.01 --set "
                       "'study.sweep.parameters.v={from: -1, to: -0.01, tolerance: 0.92, spacing: "
                       "logarithmic}'");
    expect_end(&seen, 0, "");
    shell(folder, "test -d it/v=-0.1");
    /* What is written over it leaves nothing behind. */
    seen = run_program(folder, "run flight.yaml -q --no-plot -o it --overwrite --set "
                               "study.sweep.parameters.v.tolerance=0.2 --set expect.1.within=0.1");
    expect_end(&seen, 0, "");
    shell(folder,
          "test \"$(ls -d it/v=* | tr '\\n' ' ')\" = 'it/v=0 it/v=0.125 it/v=0.25 it/v=0.5 '");
    seen =
        run_program(folder, "run flight.yaml -q --no-plot -o it --overwrite --set study={} --set "
                            "expect=[]");
    expect_end(&seen, 0, "");
    assert_false(exists(folder, "it/thresholds.csv"));
    remove_folder(folder);
}

/* One threshold for every value of the other parameter. */
static void every_line_has_its_threshold(void **state)
{
    static const char flight[] =
        FLIGHT("w: {values: [0, 0.3, 2]}, v: {from: 0, to: 1, tolerance: 0.01}",
               "'bodies.sheet.velocity=[v, w]'",
               "{quantity: energy, crosses: 12, when: {w: 0.3}, value: 0.9539392014169456, within: "
               "0.005}\n"
               "  - {quantity: momentum, component: x, along: v, trend: rises}");
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flight.yaml", flight);
    outcome seen = run_program(folder, "run flight.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "v where energy, at the end crosses 12, w=0.3"));
    seen = run_program(folder, "verify flight.yaml -q --set 'expect.1={quantity: energy, crosses: "
                               "12}'");
    expect_end(&seen, 1, "");
    shell(folder,
          "head -1 it/thresholds.csv | grep -qx 'quantity,crosses,w,v,error,seeds,no number "
          "since' && test $(wc -l < it/thresholds.csv) = 4 && grep -q "
          "'^.energy, at the end.,12,0.29999999999999999,0.95[0-9]*,0.00[0-9]*,1,$' "
          "it/thresholds.csv && grep -q ',12,2,,,1,it is above the level at both ends$' "
          "it/thresholds.csv");
    /* At w = 0 it only just comes to it, at w = 2 it is beyond. */
    assert_non_null(strstr(seen.out, "no number: at an end it is the level within its error"));
    assert_non_null(strstr(seen.out, "no number: it is above the level at both ends"));
    remove_folder(folder);
}

/* Free particles in a heat bath have the mean temperature of the bath. With noise the threshold is
 * known as far as the seeds know on which side of the level a case lies. */
static const char gas[] =
    "title: a gas of few particles\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 0}}}}\n"
    "dynamics: {time-step: 0.01, damping: 2, temperature: 1}\n"
    "bodies: {gas: {material: grain, lattice: square, spacing: 9, shape: {rectangle: [3, 3]}}}\n"
    "run: {steps: 2000, record-every: 2000, measure-every: 10}\n"
    "study:\n"
    "  seeds: 6\n"
    "  sweep: {parameters: {T: {from: 0.1, to: 0.9, tolerance: 0.001}}, set: "
    "[dynamics.temperature=T]}\n"
    "expect:\n"
    "  - {quantity: temperature, statistic: mean, from: 200, crosses: 0.3, value: 0.3, within: "
    "0.03}\n";

static void noise_widens_the_uncertainty(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    outcome seen = run_program(folder, "run gas.yaml -q --no-plot -o it");
    expect_end(&seen, 0, "");
    const char *found = strstr(seen.out, "+- 0.03");
    assert_non_null(found);
    found = strstr(found + 7, "0.");
    const double at = strtod(found, NULL), unsure = strtod(strstr(found, "+- ") + 3, NULL);
    assert_non_null(strstr(found, "(6 seeds)"));
    /* Far more than half the tolerance, and the true value lies in it, or not far from it. */
    assert_true(unsure > 0.001 && unsure < 0.03);
    assert_close(at, 0.3, 3 * unsure);
    /* Killed, and gone on with: the same bytes, with any number of jobs. */
    running run = start_program(folder, "run gas.yaml -q --no-plot -o part -j 2");
    await_file(folder, "part/T=0.5/trajectory.h5");
    kill(run.process, SIGKILL);
    await_program(run);
    seen = run_program(folder, "collect part");
    expect_end(&seen, 2, "part: ");
    seen = run_program(folder, "resume part -q --no-plot -j 1");
    assert_int_equal(seen.code, 0);
    shell(folder, "cmp it/sweep.csv part/sweep.csv && cmp it/sweep-as-run.yaml "
                  "part/sweep-as-run.yaml");
    remove_folder(folder);
}

#define RANGE "v: {from: 0, to: 0.5, tolerance: 0.001}"
static void wrong_bisections_get_their_sentence(void **state)
{
    static const struct {
        const char *text, *sentence; /* after "f.yaml:5:" or the like */
    } rows[] = {
        {FLIGHT("v: {from: 0, to: 0.5}", ALONG_X, CROSSING "above: 0}"),
         "v has 'from' and 'to', expected 'count' too, or 'tolerance' where it is bisected"},
        {FLIGHT("v: {from: 0, to: 0.5, count: 3, tolerance: 0.1}", ALONG_X, CROSSING "above: 0}"),
         "v has both 'count' and 'tolerance', expected one of them"},
        {FLIGHT("v: {values: [1, 2], tolerance: 0.1}", ALONG_X, CROSSING "above: 0}"),
         "study.sweep.parameters.v has 'tolerance' but no 'to', without which it means nothing"},
        {FLIGHT("v: {from: 0, to: 0.5, tolerance: 0}", ALONG_X, CROSSING "above: 0}"),
         "study.sweep.parameters.v.tolerance is '0', expected a number above 0"},
        {FLIGHT("v: {from: 0, to: 0.5, tolerance: 0.5}", ALONG_X, CROSSING "above: 0}"),
         "v is bisected from 0 to 0.5 with the tolerance 0.5, expected one below their distance"},
        {FLIGHT(RANGE ", w: {from: 0, to: 1, tolerance: 0.1}", "'bodies.sheet.velocity=[v, w]'",
                CROSSING "above: 0}"),
         "w has a 'tolerance' as v has, expected one parameter that is bisected"},
        {FLIGHT(RANGE, ALONG_X, "{quantity: energy, above: 0}"),
         "v is bisected, and 0 expectations cross a level, expected one with 'crosses'"},
        {FLIGHT(RANGE, ALONG_X, CROSSING "above: 0}\n  - {quantity: energy, crosses: 1}"),
         "v is bisected, and 2 expectations cross a level, expected one with 'crosses'"},
        {FLIGHT(RANGE ", w: {values: [1, 2]}", "'bodies.sheet.velocity=[v, w]'",
                CROSSING "along: w}"),
         "crosses a level along w, but v is bisected: expected it along that"},
        {FLIGHT(RANGE, ALONG_X, CROSSING "trend: rises}"), "has both 'trend' and 'crosses'"},
        {FLIGHT(RANGE, ALONG_X, CROSSING "value: 1}"),
         "has a 'value' without 'within' or 'within-relative'"},
        {FLIGHT(RANGE, ALONG_X, CROSSING "}\n  - {quantity: energy, above: 0, along: v}"),
         "has 'along', but neither 'trend' nor 'crosses'"},
        {FLIGHT("v: {values: [1]}", ALONG_X, CROSSING "above: 0}"),
         "has the key 'crosses', but the study has no 'sweep' of two values or more"},
        {FLIGHT("v: {values: [1, 2]}, w: {values: [1, 2]}", "'bodies.sheet.velocity=[v, w]'",
                CROSSING "above: 0}"),
         "has the key 'crosses', but study.sweep has 2 parameters: expected 'along'"},
    };
    int wrong = 0;
    (void)state;
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        fw_scenario *scenario;
        error = (fw_error){FW_OK, "accepted"};
        const fw_status status = fw_scenario_read(&scenario, "f.yaml", rows[n].text,
                                                  strlen(rows[n].text), NULL, 0, &error);
        fw_scenario_destroy(scenario);
        if (status == FW_BAD_INPUT && strstr(error.sentence, rows[n].sentence)) continue;
        print_error("%zu: found    %s\n   expected %s\n", n, error.sentence, rows[n].sentence);
        wrong += 1;
    }
    assert_int_equal(wrong, 0);
}

/* A plain sweep tells between which of its values the level is crossed. */
static void plain_sweep_brackets_a_threshold(void **state)
{
    static const char flight[] =
        FLIGHT("v: {values: [0.3, 0.1, 0.2]}", ALONG_X,
               "{quantity: centre-of-mass, component: x, crosses: 11, value: 0.15, within: 0.051}");
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flight.yaml", flight);
    const outcome seen = run_program(folder, "verify flight.yaml -q");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "0.150 +- 0.05"));
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_threshold_is_found_to_its_tolerance),
        cmocka_unit_test(every_line_has_its_threshold),
        cmocka_unit_test(noise_widens_the_uncertainty),
        cmocka_unit_test(wrong_bisections_get_their_sentence),
        cmocka_unit_test(plain_sweep_brackets_a_threshold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
