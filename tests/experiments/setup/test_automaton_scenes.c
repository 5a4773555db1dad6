/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_scenes.c - elastic automata in scenario files: what is read, modes and the
 * quantities that follow them, analyses, warnings, and the catalogue's automata. */
#include "tests/support/laws.h"

#include "experiments/measures/verdict.h"
#include "experiments/results/playback.h"
#include "experiments/scenario/catalogue.h"
#include "experiments/setup/build_automaton.h"
#include "experiments/study/run.h"
#include "tests/support/program.h"
#include "tests/support/scenarios.h"

#define HEAD "title: t\nmaterials:\n  m: {elastic-automaton: "
#define BODY "}\nbodies:\n  b: {material: m, shape: {rectangle: [6, 6]}"
#define TAIL "}\nrun: {steps: 10}\n"

static const fw_scenario_automaton *automaton_of(const fw_scenario *scenario)
{
    assert_int_equal(scenario->materials[0].kind, FW_ELASTIC_AUTOMATON);
    return &scenario->materials[0].automaton;
}

/* --- materials --- */

static void materials_are_what_was_written(void **state)
{
    (void)state;
    fw_scenario *s = read_right(HEAD "{c1: 0.4, c2: 0.58}" BODY TAIL);
    const fw_scenario_automaton *m = automaton_of(s);
    assert_true(m->speeds.transverse == 0.4 && m->speeds.coupling == 0.58);
    assert_int_equal(m->boundary, FW_EDGES_BOND);
    assert_true(m->damping == 0 && m->black == 0 && m->break_at == 0);
    fw_scenario_destroy(s);
    s = read_right(HEAD "{shear-modulus: 0.16, poisson-ratio: 0.35, boundary: trapezoid, "
                        "damping: 0.1, black: odd}" BODY TAIL);
    m = automaton_of(s);
    const double mu = m->speeds.transverse * m->speeds.transverse;
    const double lambda = m->speeds.coupling * m->speeds.coupling - mu;
    assert_close(mu, 0.16, 1e-15);
    assert_close(lambda / (lambda + 2 * mu), 0.35, 1e-15);
    assert_int_equal(m->boundary, FW_EDGES_TRAPEZOID);
    assert_true(m->damping == 0.1 && m->black == 1);
    fw_scenario_destroy(s);
    s = read_right(HEAD "{chopard: true, break-at: 0.2}" BODY TAIL);
    m = automaton_of(s);
    assert_true(m->speeds.transverse == fw_automaton_chopard().transverse);
    assert_true(m->speeds.coupling == 0 && m->break_at == 0.2);
    fw_scenario_destroy(s);
}

static void settings_reach_every_key(void **state)
{
    (void)state;
    const char *const text = HEAD "{c1: 0.4, c2: 0.5}" BODY TAIL;
    const char *const settings[] = {"materials.m.elastic-automaton.c2=0.3",
                                    "materials.m.elastic-automaton.boundary=mirror",
                                    "materials.m.elastic-automaton.damping=0.03",
                                    "materials.m.elastic-automaton.black=odd",
                                    "bodies.b.displacement=[{sites: [[2, 1]], by: [-0.3, 0]}]",
                                    "bodies.b.displaced-as-given=true",
                                    "walls.w={box: [-9, -9, 9, 9], surface: componentwise}"};
    fw_scenario *s;
    assert_fine(fw_scenario_read(&s, "t.yaml", text, strlen(text), settings, 7, &error));
    const fw_scenario_automaton *m = automaton_of(s);
    assert_true(m->speeds.coupling == 0.3 && m->damping == 0.03 && m->black == 1);
    assert_int_equal(m->boundary, FW_EDGES_MIRROR);
    assert_true(s->bodies[0].displaced_as_given);
    assert_int_equal(s->walls[0].def.surface.law, FW_COMPONENTWISE);
    fw_scenario_destroy(s);
    const char *const chopard[] = {"materials.m.elastic-automaton={chopard: true}"};
    assert_fine(fw_scenario_read(&s, "t.yaml", text, strlen(text), chopard, 1, &error));
    assert_true(automaton_of(s)->speeds.coupling == 0);
    fw_scenario_destroy(s);
}

/* --- warnings --- */

static void componentwise_walls_are_warned_of(void **state)
{
    (void)state;
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, "check bounce-as-printed");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "the surface of wall box is 'componentwise', which does not "
                                     "conserve energy"));
    assert_non_null(strstr(seen.out, "can be run, with 1 warning"));
    seen = run_program(folder, "run bounce-as-printed -q --no-plot -o it --set run.steps=400");
    expect_end(&seen, 0,
               "warning: the surface of wall box "
               "is 'componentwise', which does not conserve energy");
    seen = run_program(folder, "run bounce -q --no-plot -o other");
    expect_end(&seen, 0, "");
    remove_folder(folder);
}

/* --- starts --- */

static void moving_start_has_the_velocity_and_nothing_else(void **state)
{
    (void)state;
    fw_scenario *s = read_right(HEAD "{c1: 0.9, c2: 0.5}}\nbodies:\n  b: {material: m, shape: "
                                     "{disc: 4}, spacing: 1.5, angle: 20, origin: [3, 4], "
                                     "velocity: [0.05, -0.03]" TAIL);
    fw_experiment *e = build_right(s);
    const fw_solid *solid = fw_experiment_solid(e, 0);
    const fw_vec2 begin = solid->model->centre_of_mass(solid);
    for (int step = 0; step < 100; ++step) assert_fine(fw_experiment_step(e, &error));
    const fw_vec2 end = solid->model->centre_of_mass(solid);
    assert_close(end.x - begin.x, 5, 1e-12);
    assert_close(end.y - begin.y, -3, 1e-12);
    assert_below(fabs(fw_solid_energies(solid).elastic), 1e-15);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

static double measured(const fw_experiment *e, const char *name)
{
    double out[FW_COMPONENTS_MAX];
    fw_quantity_find(name)->measure(e, (fw_subject){.wall = -1, .grip = -1, .particle = -1}, out);
    return out[0];
}

static void modes_keep_their_promises(void **state)
{
    (void)state;
    /* On a turned lattice, black odd, in three materials; Chopard's branches are told apart. */
    static const char *const materials[] = {"{c1: 0.4, c2: 0.58, boundary: periodic, black: odd}",
                                            "{c1: 0.5, c2: 1, boundary: periodic}",
                                            "{chopard: true, boundary: periodic}"};
    for (int n = 0; n < 3; ++n)
        for (int fast = 0; fast < 2; ++fast) {
            char text[1024];
            snprintf(text, sizeof text,
                     HEAD "%s}\nbodies:\n  b: {material: m, shape: {rectangle: [12, 8]}, angle: 30,"
                          " displacement: [{mode: {wave-vector: [1.0471975511965976, "
                          "0.7853981633974483], branch: %s, amplitude: 0.5, phase: 40}}]" TAIL,
                     materials[n], fast ? "fast" : "slow");
            fw_scenario *s = read_right(text);
            fw_experiment *e = build_right(s);
            assert_close(measured(e, "wave-turn"), 0, 1e-13);
            for (int step = 0; step < 200; ++step) assert_fine(fw_experiment_step(e, &error));
            assert_below(measured(e, "mode-error"), 1e-12);
            assert_close(measured(e, "wave-size"), 1, 1e-12);
            assert_close(measured(e, "wave-damping"), 1, 1e-13);
            double squared[FW_MODES];
            fw_automaton_closed_form(automaton_of(s)->speeds,
                                     (fw_vec2){1.0471975511965976, 0.7853981633974483}, squared);
            const double omega = 2 * asin(sqrt(squared[fast]) / 2);
            assert_close(measured(e, "wave-turn"), remainder(200 * omega, 2 * M_PI), 1e-11);
            fw_experiment_destroy(e);
            fw_scenario_destroy(s);
        }
}

static void chopards_modes_are_longitudinal_and_transverse(void **state)
{
    (void)state;
    const fw_scenario_automaton chopard = {.speeds = fw_automaton_chopard()};
    const fw_lattice lattice = {.kind = FW_SQUARE, .spacing = 1};
    const fw_vec2 wave = {0.3, 0.4};
    fw_automaton_mode mode;
    assert_fine(fw_build_automaton_mode(&chopard, &lattice, wave, FW_FAST, &mode, &error));
    assert_close(creal(mode.white[0]), 0.6, 1e-15);
    assert_close(creal(mode.white[1]), 0.8, 1e-15);
    assert_fine(fw_build_automaton_mode(&chopard, &lattice, wave, FW_SLOW, &mode, &error));
    assert_close(creal(mode.white[0]), 0.8, 1e-15);
    assert_close(creal(mode.white[1]), -0.6, 1e-15);
}

static void waves_that_cannot_be_told_apart_are_no_numbers(void **state)
{
    (void)state;
    fw_scenario *s = read_right(
        HEAD "{c1: 0.5, c2: 1, boundary: periodic}}\nbodies:\n  b: {material: m, shape: {rectangle:"
             " [8, 8]}, displacement: [{mode: {wave-vector: [-1.5707963267948966, "
             "-1.5707963267948966], branch: slow, amplitude: 1}}]" TAIL);
    fw_experiment *e = build_right(s);
    assert_true(isnan(measured(e, "wave-turn")));
    assert_true(isnan(measured(e, "wave-path")));
    assert_true(isnan(measured(e, "wave-size")));
    assert_true(isnan(measured(e, "wave-damping")));
    assert_below(measured(e, "mode-error"), 1e-15);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

static void displacement_as_given_moves_the_body(void **state)
{
    (void)state;
    for (int as_given = 0; as_given < 2; ++as_given) {
        char text[512];
        snprintf(text, sizeof text,
                 HEAD "{c1: 0.4, c2: 0.5, black: odd}" BODY
                      ", spacing: 1.5, displacement: [{sites: "
                      "[[2, 1]], by: [-0.3, 0]}], displaced-as-given: %s" TAIL,
                 as_given ? "true" : "false");
        fw_scenario *s = read_right(text);
        fw_experiment *e = build_right(s);
        assert_close(measured(e, "mean-velocity"), as_given ? 0.04 : 0, 1e-14);
        fw_experiment_destroy(e);
        fw_scenario_destroy(s);
    }
}

static void displaced_body_starts_at_rest(void **state)
{
    (void)state;
    fw_scenario *s =
        read_right(HEAD "{c1: 0.9, c2: 0.5}}\nbodies:\n  b: {material: m, shape: {disc: "
                        "5}, displacement: [{random: 0.2}]" TAIL);
    fw_experiment *e = build_right(s);
    assert_true(fw_solid_energies(fw_experiment_solid(e, 0)).elastic > 0.1);
    assert_below(fw_solid_energies(fw_experiment_solid(e, 0)).kinetic, 1e-28);
    assert_close(measured(e, "mean-velocity"), 0, 1e-16);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

/* --- bonds --- */

static void torn_bar_counts_its_bonds(void **state)
{
    (void)state;
    fw_scenario *s = read_right(
        HEAD "{c1: 0.9, c2: 0.5, break-at: 0.2, damping: 0.03}}\nbodies:\n  b: {material: m, shape:"
             " {rectangle: [12, 3]}}\nforces:\n  l: {body: b, sites: left, force: [-0.3, 0]}\n  r: "
             "{body: b, sites: right, force: [0.3, 0]}\nrun: {steps: 60}\n");
    fw_experiment *e = build_right(s);
    assert_true(measured(e, "broken-bonds") == 0);
    for (int step = 0; step < 60; ++step) assert_fine(fw_experiment_step(e, &error));
    assert_true(measured(e, "broken-bonds") > 0);
    assert_true(measured(e, "fracture-energy") > 0);
    assert_below(fabs(measured(e, "energy-error")), 1e-13);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

/* --- analyses in the results file --- */

static void tables_read_back_as_they_were_computed(void **state)
{
    (void)state;
    char folder[64], results[128];
    make_quick_folder(folder, sizeof folder);
    snprintf(results, sizeof results, "%s/it", folder);
    fw_scenario *s = read_right(
        HEAD "{c1: 0.5, c2: 1, boundary: periodic}" BODY "}\nrun: {steps: 2}\nanalysis:\n  map: "
             "{stability-map: {c1: [0, 1.5], c2: [0, 1.2], points: [4, 3], waves: 8}}\n  bands: "
             "{dispersion: {material: m, size: 8, steps: 10}}\n  one: {plane-mode: {material: m, "
             "wave-vector: [0.3, 0.1]}}\n");
    const fw_run_options options = {.directory = results, .threads = 1, .name = "it"};
    fw_run *run;
    assert_fine(fw_run_begin(&run, s, &options, &error));
    assert_fine(fw_run_to_end(run, &error));
    const fw_observer *e = fw_run_observer(run);
    fw_playback *playback;
    assert_fine(fw_playback_open(&playback, results, &error));
    for (int a = 0; a < 2; ++a)
        for (int n = 0; n < e->analyses[a]->table_count; ++n) {
            const fw_table *wanted = &e->analyses[a]->tables[n];
            fw_table found;
            assert_fine(fw_playback_read_table(playback, e->analyses[a]->what->name, wanted->name,
                                               &found, &error));
            assert_int_equal(found.rank, wanted->rank);
            for (int axis = 0; axis < wanted->rank; ++axis)
                assert_int_equal(found.extent[axis], wanted->extent[axis]);
            assert_memory_equal(found.values, wanted->values,
                                (size_t)fw_table_size(wanted) * sizeof(double));
            free(found.values);
        }
    const fw_table *growth = fw_analysis_find(e->analyses[0], "growth");
    assert_int_equal(growth->extent[0], 3);
    assert_int_equal(growth->extent[1], 4);
    assert_true(growth->values[0] == 1);             /* (0, 0) */
    assert_close(growth->values[11], 5.18722, 1e-5); /* (1.5, 1.2): h^2 = 7.38 */
    fw_table none;
    assert_refused(fw_playback_read_table(playback, "map", "grwth", &none, &error), FW_BAD_INPUT,
                   "no grwth of an analysis map");
    fw_playback_close(playback);
    fw_run_destroy(run);
    fw_scenario_destroy(s);
    outcome seen = run_program(folder, "plot it --kind analysis -o map.png");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "plot it --kind analysis --at 1 -o map.png");
    expect_end(&seen, 2, "a picture of kind analysis does not draw steps");
    remove_folder(folder);
}

/* Waves along no axis and no diagonal; the frequency over the whole length of the wave vector. */
static void a_mode_has_the_speed_of_the_closed_form(void **state)
{
    (void)state;
    static const fw_vec2 waves[] = {{0.3, 0.1}, {-0.2, 0.5}, {0, 0.4}};
    fw_scenario *s = read_right(
        HEAD "{c1: 0.5, c2: 1, boundary: periodic}" BODY "}\nrun: {steps: 2}\nanalysis:\n  one: "
             "{plane-mode: {material: m, wave-vector: [0.3, 0.1]}}\n  two: {plane-mode: {material: "
             "m, wave-vector: [-0.2, 0.5]}}\n  up: {plane-mode: {material: m, wave-vector: "
             "[0, 0.4]}}\n");
    fw_run *run;
    assert_fine(fw_run_begin(&run, s, &(fw_run_options){.threads = 1}, &error));
    for (int a = 0; a < 3; ++a)
        for (int m = 0; m < FW_MODES; ++m)
            assert_close(fw_run_observer(run)->analyses[a]->mode.speed[m],
                         fw_automaton_phase_speed(automaton_of(s)->speeds, waves[a], m), 1e-12);
    fw_run_destroy(run);
    fw_scenario_destroy(s);
}

static void threads_do_not_change_an_analysis(void **state)
{
    (void)state;
    fw_scenario *s = read_right(HEAD "{chopard: true}" BODY
                                     "}\nrun: {steps: 2}\nanalysis:\n  map: {stability-map: {c1: "
                                     "[0, 1.5], c2: [0, 1.2], points: [9, 7], waves: 8}}\n");
    double values[3][63];
    for (int n = 0; n < 3; ++n) {
        const fw_run_options options = {.threads = n + 1};
        fw_run *run;
        assert_fine(fw_run_begin(&run, s, &options, &error));
        const fw_table *growth =
            fw_analysis_find(fw_run_observer(run)->analyses[0], "singular-value");
        memcpy(values[n], growth->values, sizeof values[n]);
        fw_run_destroy(run);
    }
    assert_memory_equal(values[0], values[1], sizeof values[0]);
    assert_memory_equal(values[0], values[2], sizeof values[0]);
    fw_scenario_destroy(s);
}

/* --- the catalogue --- */

static void catalogue_shows_what_it_must(void **state)
{
    (void)state;
    static const char *const names[] = {
        "wave",        "wave-diagonal", "polarisation", "stability-map",     "dispersion-automaton",
        "single-mode", "translate",     "bounce",       "bounce-as-printed", "automaton-damping",
        "lb-equals-ca"};
    int failed = 0;
    for (size_t n = 0; n < sizeof names / sizeof names[0]; ++n) {
        const fw_catalogue_entry *entry;
        fw_scenario *s;
        assert_fine(fw_catalogue_find(&entry, names[n], &error));
        assert_fine(fw_scenario_read(&s, names[n], entry->text, entry->length, NULL, 0, &error));
        assert_true(s->expectation_count > 2 && s->picture_count > 0);
        const fw_run_options options = {.threads = 2, .name = names[n]};
        fw_run *run;
        assert_fine(fw_run_begin(&run, s, &options, &error));
        assert_fine(fw_run_to_end(run, &error));
        for (int k = 0; k < s->expectation_count; ++k) {
            const fw_verdict verdict = fw_verdict_of(s, fw_run_measurement(run), k);
            if (verdict.holds) continue;
            print_error("%s: %s is %.15g, expected %s\n", names[n], verdict.quantity,
                        verdict.measured, verdict.expected);
            ++failed;
        }
        fw_run_destroy(run);
        fw_scenario_destroy(s);
    }
    assert_int_equal(failed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(materials_are_what_was_written),
        cmocka_unit_test(settings_reach_every_key),
        cmocka_unit_test(componentwise_walls_are_warned_of),
        cmocka_unit_test(moving_start_has_the_velocity_and_nothing_else),
        cmocka_unit_test(modes_keep_their_promises),
        cmocka_unit_test(chopards_modes_are_longitudinal_and_transverse),
        cmocka_unit_test(waves_that_cannot_be_told_apart_are_no_numbers),
        cmocka_unit_test(displacement_as_given_moves_the_body),
        cmocka_unit_test(displaced_body_starts_at_rest),
        cmocka_unit_test(torn_bar_counts_its_bonds),
        cmocka_unit_test(tables_read_back_as_they_were_computed),
        cmocka_unit_test(a_mode_has_the_speed_of_the_closed_form),
        cmocka_unit_test(threads_do_not_change_an_analysis),
        cmocka_unit_test(catalogue_shows_what_it_must),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
