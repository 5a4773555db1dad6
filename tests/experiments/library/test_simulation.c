/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_simulation.c - simulations are runs of the program, cut into pieces and looked at. */
#include "tests/support/laws.h"

#include "experiments/library/fretwork.h"

#include "tests/support/program.h"

#include <omp.h>

/* Two bodies that share a solid, noise, a wall, and a row of values every third step. */
static const char gas[] =
    "title: a gas\n"
    "materials: {gas: {movable-particles: {strength: 0.1}}}\n"
    "bodies:\n"
    "  left: {material: gas, lattice: hexagonal, shape: {rectangle: [5, 5]}, temperature: 1}\n"
    "  right: {material: gas, lattice: hexagonal, shape: {rectangle: [4, 4]}, origin: [9, 0]}\n"
    "walls: {box: {box: [-0.05, -0.05, 20, 9]}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "run: {steps: 50, record-every: 4, measure-every: 3, seed: 7}\n"
    "record: {fields: [local-order], force: true}\n"
    "measure: [energy, momentum.left, reaction.box]\n"
    "expect:\n"
    "  - {quantity: energy, above: 0}\n"
    "  - {quantity: energy, above: 1e9}\n";

static fw_simulation_def def_of(const char *text)
{
    fw_simulation_def def = fw_simulation_def_default();
    def.text = text;
    return def;
}

static fw_simulation *simulation_of(const char *text)
{
    fw_simulation *simulation;
    const fw_simulation_def def = def_of(text);
    assert_fine(fw_simulation_create(&simulation, &def, &error));
    return simulation;
}

static void assert_same_state(fw_simulation *a, fw_simulation *b)
{
    for (int body = 0; body < 2; ++body) {
        const fw_body_view of_a = fw_simulation_body(a, body), of_b = fw_simulation_body(b, body);
        const size_t bytes = (size_t)of_a.count * sizeof(double);
        const double *ax, *ay, *bx, *by;
        assert_int_equal(of_a.count, of_b.count);
        assert_memory_equal(of_a.x, of_b.x, bytes);
        assert_memory_equal(of_a.y, of_b.y, bytes);
        assert_fine(fw_simulation_velocities(a, body, &ax, &ay, &error));
        assert_fine(fw_simulation_velocities(b, body, &bx, &by, &error));
        assert_memory_equal(ax, bx, bytes);
        assert_memory_equal(ay, by, bytes);
    }
}

static void pieces_make_the_same_whole(void **state)
{
    (void)state;
    fw_simulation *whole = simulation_of(gas), *pieces = simulation_of(gas);
    assert_fine(fw_simulation_advance(whole, 1000, &error));
    for (int size = 1; !fw_simulation_is_at_end(pieces); ++size)
        assert_fine(fw_simulation_advance(pieces, size, &error));
    assert_int_equal(fw_simulation_step(whole), 50);
    assert_int_equal(fw_simulation_step(pieces), 50);
    assert_same_state(whole, pieces);
    for (int n = 0; n < fw_simulation_series_count(whole); ++n) {
        const fw_series_view a = fw_simulation_series(whole, n);
        const fw_series_view b = fw_simulation_series(pieces, n);
        assert_int_equal(a.count, 18); /* 0, 3, ..., 48, 50 */
        assert_int_equal(b.count, 18);
        assert_int_equal(a.steps[17], 50);
        for (int64_t row = 0; row < a.count; ++row)
            assert_memory_equal(a.values + row * a.stride, b.values + row * b.stride,
                                (size_t)a.components * sizeof(double));
    }
    fw_simulation_destroy(whole);
    fw_simulation_destroy(pieces);
}

/* On which nothing acts: such bodies take many steps at once. */
static void free_bodies_stop_where_they_are_told(void **state)
{
    (void)state;
    fw_simulation *simulation = simulation_of(
        "title: free\n"
        "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
        "bodies: {sheet: {material: rubber, shape: {rectangle: [9, 9]}, velocity: [0.1, 0]}}\n"
        "run: {steps: 100, record-every: 50, measure-every: 50}\n");
    const fw_body_view sheet = fw_simulation_body(simulation, 0);
    assert_fine(fw_simulation_advance(simulation, 7, &error));
    assert_int_equal(fw_simulation_step(simulation), 7);
    assert_close(sheet.x[40], 4 + 0.7, 1e-13);
    fw_simulation_destroy(simulation);
}

typedef struct diary {
    int count;
    int64_t steps[32];
    int enough; /* calls */
} diary;

static bool write_down(fw_simulation *simulation, void *context)
{
    diary *seen = context;
    seen->steps[seen->count++] = fw_simulation_step(simulation);
    return seen->count != seen->enough;
}

static void whoever_looks_is_called_at_multiples_and_at_the_end(void **state)
{
    (void)state;
    fw_simulation *simulation = simulation_of(gas);
    diary seen = {.enough = 3};
    assert_fine(fw_simulation_run(simulation, 15, write_down, &seen, &error));
    assert_int_equal(seen.count, 3);
    assert_false(fw_simulation_is_at_end(simulation));
    assert_fine(fw_simulation_advance(simulation, 1, &error));
    assert_fine(fw_simulation_advance(simulation, 0, &error));
    assert_int_equal(fw_simulation_step(simulation), 31);
    assert_fine(fw_simulation_run(simulation, 15, write_down, &seen, &error));
    static const int64_t wanted[] = {0, 15, 30, 31, 45, 50};
    assert_int_equal(seen.count, 6);
    assert_memory_equal(seen.steps, wanted, sizeof wanted);
    assert_true(fw_simulation_is_at_end(simulation));
    fw_simulation_destroy(simulation);
}

static void what_is_handed_out_shows_the_present(void **state)
{
    (void)state;
    fw_simulation *simulation = simulation_of(gas);
    const fw_body_view right = fw_simulation_body(simulation, 1);
    const double *vx, *vy, *again, *order;
    const double before = right.x[3];
    assert_close(right.x[4], 9.5, 1e-15); /* the second row begins */
    assert_close(right.y[4], sqrt(3) / 2, 1e-15);
    assert_int_equal(fw_simulation_find_body(simulation, "right"), 1);
    assert_int_equal(fw_simulation_find_body(simulation, "wrong"), -1);
    assert_fine(fw_simulation_velocities(simulation, 1, &vx, &vy, &error));
    assert_true(vx[0] == 0); /* at rest */
    assert_fine(fw_simulation_advance(simulation, 10, &error));
    assert_true(right.x[3] != before);
    assert_true(vx[0] == 0); /* computed when asked for */
    assert_fine(fw_simulation_velocities(simulation, 1, &again, &vy, &error));
    assert_ptr_equal(again, vx);
    assert_true(vx[0] != 0);
    assert_fine(fw_simulation_field(simulation, 1, "local-order", &order, &error));
    assert_true(order[0] >= 0 && order[0] <= 1);
    int names = 0;
    bool listed = false;
    for (const char *name; (name = fw_simulation_field_name(simulation, 1, names)); ++names)
        listed = listed || strcmp(name, "local-order") == 0;
    assert_true(listed);
    assert_refused(fw_simulation_field(simulation, 1, "colour", &order, &error), FW_BAD_INPUT,
                   "body right has no field colour, expected one that it has, such as ");
    fw_simulation_destroy(simulation);
}

static double measured(const fw_simulation *simulation, const char *name, int count, int number)
{
    double values[FW_SIMULATION_NUMBERS];
    int found = 0;
    assert_fine(fw_simulation_measure(simulation, name, values, &found, &error));
    assert_int_equal(found, count);
    return values[number];
}

static void quantities_are_measured_by_name(void **state)
{
    (void)state;
    fw_simulation *simulation = simulation_of(gas);
    assert_fine(fw_simulation_advance(simulation, 12, &error));
    const fw_series_view momentum = fw_simulation_series(simulation, 1);
    assert_string_equal(momentum.name, "momentum.left");
    assert_int_equal(momentum.components, 2);
    const double *row = momentum.values + (momentum.count - 1) * momentum.stride;
    assert_true(measured(simulation, "momentum.left", 2, 1) == row[1]);
    assert_true(measured(simulation, "momentum.left.y", 1, 0) == row[1]);
    assert_true(measured(simulation, "reaction.box.x", 1, 0) ==
                measured(simulation, "reaction", 2, 0));
    /* Of bodies: all together. */
    const double together = measured(simulation, "momentum.x", 1, 0);
    assert_close(together, row[0] + measured(simulation, "momentum.right.x", 1, 0), 1e-14);
    double values[FW_SIMULATION_NUMBERS];
    int count;
    assert_refused(fw_simulation_measure(simulation, "enrgy", values, &count, &error), FW_BAD_INPUT,
                   "quantity enrgy is not known; did you mean energy?");
    assert_int_equal(strncmp(error.sentence, "quantity", 8), 0); /* nothing that was written */
    assert_refused(fw_simulation_measure(simulation, "momentum.top", values, &count, &error),
                   FW_BAD_INPUT, "momentum is not measured of top");
    assert_refused(fw_simulation_measure(simulation, "centre-of-mass", values, &count, &error),
                   FW_BAD_INPUT,
                   "centre-of-mass is measured of 2 things, expected one of them by name, such as "
                   "centre-of-mass.left");
    assert_refused(fw_simulation_measure(simulation, "grip-work", values, &count, &error),
                   FW_BAD_INPUT, "there is nothing to measure grip-work of");
    fw_simulation_destroy(simulation);
}

static fw_vec2 sum_of(const double *x, const double *y, int count)
{
    fw_vec2 sum = {0, 0};
    for (int i = 0; i < count; ++i) sum = fw_vec2_add(sum, (fw_vec2){x[i], y[i]});
    return sum;
}

/* Particles of mass 1, and a force at rest on all of them. */
static void velocities_and_forces_are_those_of_mechanics(void **state)
{
    (void)state;
    const char *const settings[] = {"forces.pull={body: right, force: [0.25, 0.5]}"};
    fw_simulation_def def = def_of(gas);
    fw_simulation *simulation;
    fw_vec2 force = {0, 0}, push = {0, 0};
    const double *x, *y, *speed;
    bool pushed = false;
    def.settings = settings;
    def.setting_count = 1;
    assert_fine(fw_simulation_create(&simulation, &def, &error));
    while (!fw_simulation_is_at_end(simulation)) {
        assert_fine(fw_simulation_advance(simulation, 1, &error));
        assert_fine(fw_simulation_velocities(simulation, 0, &x, &y, &error));
        const fw_vec2 momentum = sum_of(x, y, 25);
        assert_close(momentum.x, measured(simulation, "momentum.left.x", 1, 0), 1e-12);
        assert_close(momentum.y, measured(simulation, "momentum.left.y", 1, 0), 1e-12);
        assert_fine(fw_simulation_forces(simulation, 0, &x, &y, &error));
        force = sum_of(x, y, 25);
        assert_fine(fw_simulation_forces(simulation, 1, &x, &y, &error));
        force = fw_vec2_add(force, sum_of(x, y, 16));
        push = (fw_vec2){measured(simulation, "reaction.box.x", 1, 0),
                         measured(simulation, "reaction.box.y", 1, 0)};
        assert_close(force.x, push.x + 16 * 0.25, 1e-10);
        assert_close(force.y, push.y + 16 * 0.5, 1e-10);
        pushed = pushed || push.x != 0;
    }
    assert_true(pushed);
    assert_fine(fw_simulation_velocities(simulation, 1, &x, &y, &error));
    assert_fine(fw_simulation_field(simulation, 1, "speed", &speed, &error));
    for (int i = 0; i < 16; ++i) assert_close(speed[i], hypot(x[i], y[i]), 1e-14);
    fw_simulation_destroy(simulation);
}

static void expectations_are_judged_at_the_end(void **state)
{
    (void)state;
    int expected, failed;
    fw_simulation *simulation = simulation_of(gas);
    assert_fine(fw_simulation_judge(simulation, &expected, &failed, &error));
    assert_int_equal(expected, 0);
    assert_fine(fw_simulation_advance(simulation, 50, &error));
    assert_fine(fw_simulation_judge(simulation, &expected, &failed, &error));
    assert_int_equal(expected, 2);
    assert_int_equal(failed, 1);
    fw_simulation_destroy(simulation);
}

static void results_are_those_of_the_program(void **state)
{
    (void)state;
    char folder[64], out[96];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "gas.yaml", gas);
    outcome seen = run_program(folder, "run gas.yaml -o program --no-plot --quiet");
    expect_end(&seen, 1, "");
    fw_simulation_def def = def_of(gas);
    fw_simulation *simulation;
    snprintf(out, sizeof out, "%s/whole", folder);
    def.directory = out;
    assert_fine(fw_simulation_create(&simulation, &def, &error));
    while (!fw_simulation_is_at_end(simulation))
        assert_fine(fw_simulation_advance(simulation, 7, &error));
    fw_simulation_destroy(simulation);
    expect_same_results(folder, "program", "whole");
    /* Not over what is there. */
    assert_refused(fw_simulation_create(&simulation, &def, &error), FW_BAD_INPUT, out);
    assert_null(simulation);
    /* One that was left goes on in the program. */
    snprintf(out, sizeof out, "%s/left", folder);
    assert_fine(fw_simulation_create(&simulation, &def, &error));
    assert_fine(fw_simulation_advance(simulation, 21, &error));
    assert_fine(fw_simulation_stop(simulation, &error));
    assert_refused(fw_simulation_advance(simulation, 1, &error), FW_INTERRUPTED,
                   "interrupted after 21 of 50 steps");
    assert_true(measured(simulation, "energy", 1, 0) > 0);
    seen = run_program(folder, "resume left --no-plot --quiet");
    expect_end(&seen, 1, "");
    fw_simulation_destroy(simulation);
    expect_same_results(folder, "program", "left");
    remove_folder(folder);
}

/* A body that is pulled out of all bounds. */
static const char torn[] = "title: torn\n"
                           "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
                           "bodies: {one: {material: dust, shape: {rectangle: [1, 1]}}}\n"
                           "forces: {pull: {body: one, force: [1e6, 0]}}\n"
                           "run: {steps: 1000, record-every: 10}\n";

static void a_run_that_diverges_can_be_looked_at(void **state)
{
    (void)state;
    char sentence[FW_SENTENCE_SIZE];
    fw_simulation *simulation = simulation_of(torn);
    assert_refused(fw_simulation_advance(simulation, 1000, &error), FW_DIVERGED, "one");
    strcpy(sentence, error.sentence);
    assert_true(fw_simulation_body(simulation, 0).x[0] > 1e6);
    assert_refused(fw_simulation_advance(simulation, 1, &error), FW_DIVERGED, sentence);
    assert_false(fw_simulation_is_at_end(simulation));
    assert_int_equal(fw_simulation_advance(simulation, 1, NULL), FW_DIVERGED);
    fw_simulation_destroy(simulation);
}

static void expect_refusal(fw_simulation_def def, const char *words)
{
    fw_simulation *simulation;
    assert_refused(fw_simulation_create(&simulation, &def, &error), FW_BAD_INPUT, words);
    assert_null(simulation);
    assert_int_equal(fw_simulation_create(&simulation, &def, NULL), FW_BAD_INPUT);
}

static void what_cannot_be_run_is_refused_in_a_sentence(void **state)
{
    (void)state;
    const char *const settings[] = {"run.stepz=3"};
    fw_simulation_def def = fw_simulation_def_default();
    expect_refusal(def, "a simulation without a scenario");
    def.scenario = "wall-bonce";
    expect_refusal(def, "did you mean 'wall-bounce'?");
    def.scenario = "/nowhere/x.yaml";
    expect_refusal(def, "/nowhere/x.yaml");
    def = def_of("title: x\nbodis: {}\n");
    expect_refusal(def, "scenario:2:1: unknown key 'bodis'; did you mean 'bodies'?");
    def.scenario = "my.yaml";
    expect_refusal(def, "my.yaml:2:1: unknown key");
    def = def_of(gas);
    def.settings = settings;
    def.setting_count = 1;
    expect_refusal(def, "--set run.stepz=3: ");
    def = def_of(gas);
    def.sweep_case = "A=2";
    expect_refusal(def, "scenario is no sweep: it has no case A=2");
    def = fw_simulation_def_default();
    def.scenario = "friction-sweep";
    expect_refusal(def, "friction-sweep is a sweep, expected one of its 7 cases, such as A=0");
    def.sweep_case = "A=9";
    expect_refusal(def, "friction-sweep is a sweep without the case A=9, expected");
    fw_simulation_destroy(NULL);
}

static const char swept[] = "title: swept\n"
                            "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
                            "bodies: {one: {material: dust, shape: {rectangle: [1, 1]}}}\n"
                            "forces: {pull: {body: one, force: [0, 0]}}\n"
                            "run: {steps: 10, record-every: 10}\n"
                            "expect: [{quantity: energy, above: 0}]\n"
                            "study:\n"
                            "  sweep:\n"
                            "    parameters: {A: {values: [1, 2]}}\n"
                            "    set: ['forces.pull.force=[A, 0]']\n";

static void a_case_of_a_sweep_is_a_run(void **state)
{
    (void)state;
    double work[2];
    for (int n = 0; n < 2; ++n) {
        fw_simulation_def def = def_of(swept);
        fw_simulation *simulation;
        def.sweep_case = n == 0 ? "A=1" : "A=2";
        assert_fine(fw_simulation_create(&simulation, &def, &error));
        assert_fine(fw_simulation_advance(simulation, 10, &error));
        work[n] = measured(simulation, "energy", 1, 0);
        fw_simulation_destroy(simulation);
    }
    assert_close(work[1], 4 * work[0], 1e-9);
}

static void several_run_at_a_time_as_alone(void **state)
{
    (void)state;
    enum { SEVERAL = 6 };
    fw_simulation *alone = simulation_of(gas), *made[SEVERAL];
    int fine = 0;
    assert_fine(fw_simulation_advance(alone, 50, &error));
#pragma omp parallel for num_threads(3) reduction(+ : fine)
    for (int n = 0; n < SEVERAL; ++n) {
        fw_simulation_def def = def_of(gas);
        def.threads = 1 + n % 2;
        fine += fw_simulation_create(&made[n], &def, NULL) == FW_OK &&
                fw_simulation_advance(made[n], 50, NULL) == FW_OK;
    }
    assert_int_equal(fine, SEVERAL);
    for (int n = 0; n < SEVERAL; ++n) {
        assert_same_state(alone, made[n]);
        fw_simulation_destroy(made[n]);
    }
    fw_simulation_destroy(alone);
}

static void threads_of_the_caller_are_left_alone(void **state)
{
    (void)state;
    omp_set_num_threads(3);
    fw_simulation *simulation = simulation_of(gas);
    assert_int_equal(omp_get_max_threads(), 3);
    assert_fine(fw_simulation_advance(simulation, 50, &error));
    assert_int_equal(omp_get_max_threads(), 3);
    fw_simulation_destroy(simulation);
}

static void warnings_are_kept_not_printed(void **state)
{
    (void)state;
    fw_simulation_def def = fw_simulation_def_default();
    const char *const settings[] = {"bodies.sheet.velocity=[0.5, 0]"};
    fw_simulation *simulation;
    def.scenario = "wall-bounce";
    def.settings = settings;
    def.setting_count = 1;
    assert_fine(fw_simulation_create(&simulation, &def, &error));
    assert_int_equal(strncmp(fw_simulation_warnings(simulation), "warning: ", 9), 0);
    fw_simulation_destroy(simulation);
    simulation = simulation_of(gas);
    assert_string_equal(fw_simulation_warnings(simulation), "");
    assert_string_equal(fw_simulation_name(simulation), "scenario");
    assert_string_equal(fw_simulation_title(simulation), "a gas");
    fw_simulation_destroy(simulation);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_make_the_same_whole),
        cmocka_unit_test(free_bodies_stop_where_they_are_told),
        cmocka_unit_test(whoever_looks_is_called_at_multiples_and_at_the_end),
        cmocka_unit_test(what_is_handed_out_shows_the_present),
        cmocka_unit_test(quantities_are_measured_by_name),
        cmocka_unit_test(velocities_and_forces_are_those_of_mechanics),
        cmocka_unit_test(expectations_are_judged_at_the_end),
        cmocka_unit_test(results_are_those_of_the_program),
        cmocka_unit_test(a_run_that_diverges_can_be_looked_at),
        cmocka_unit_test(what_cannot_be_run_is_refused_in_a_sentence),
        cmocka_unit_test(a_case_of_a_sweep_is_a_run),
        cmocka_unit_test(several_run_at_a_time_as_alone),
        cmocka_unit_test(threads_of_the_caller_are_left_alone),
        cmocka_unit_test(warnings_are_kept_not_printed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
