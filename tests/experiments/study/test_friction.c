/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_friction.c - two small beams in grips: phases, profile and study. */
#include "tests/support/laws.h"

#include "core/particles/particles.h"
#include "experiments/storage/csv.h"
#include "experiments/study/study.h"
#include "tests/support/beams.h"
#include "tests/support/scratch.h"

static fw_scenario *read_with(const char *const *settings, int count)
{
    fw_scenario *scenario;
    assert_fine(fw_scenario_read(&scenario, "beams.yaml", small_beams, strlen(small_beams),
                                 settings, count, &error));
    return scenario;
}

static fw_observer *make(const fw_scenario *scenario)
{
    fw_observer *observer;
    assert_fine(fw_observer_create(&observer, scenario, &error));
    return observer;
}

static void step_until(fw_observer *observer, int64_t step)
{
    while (fw_scene_steps(observer->experiment->scene) < step)
        assert_fine(fw_observer_advance(observer, 1, &error));
}

/* --- phases --- */

static void a_phase_has_its_own_bath_and_gives_it_back(void **state)
{
    (void)state;
    fw_scenario *scenario = read_with(NULL, 0);
    fw_observer *observer = make(scenario);
    const fw_solid *particles = fw_experiment_particles(observer->experiment);
    step_until(observer, 500);
    assert_close(fw_particles_controls(particles)->damping, 1, 0);
    assert_close(fw_particles_controls(particles)->temperature, .0005, 0);
    step_until(observer, 501);
    assert_close(fw_particles_controls(particles)->damping, .3, 0);
    assert_close(fw_particles_controls(particles)->temperature, .001, 0);
    step_until(observer, 1501);
    assert_close(fw_particles_controls(particles)->temperature, .0005, 0);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

static void a_grip_swings_only_in_the_phases_that_say_so(void **state)
{
    (void)state;
    fw_scenario *scenario = read_with(NULL, 0);
    fw_observer *observer = make(scenario);
    const fw_grip_ledger *left =
        fw_grip_observe_ledger(fw_scene_observe_grip(observer->experiment->scene, 0));
    step_until(observer, 500);
    assert_close(left->force.x, 16, 1e-9);
    assert_close(left->force.y, -left->displacement.y, 1e-3);
    /* A quarter of a period after t = 4 the drive is at its height. */
    step_until(observer, 1001);
    assert_close(left->force.x, 16, 1e-9);
    assert_close(left->force.y, 30 * sin(2 * M_PI * 5 / 4) - left->displacement.y, .05);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

static void layers_hold_what_is_near_the_outer_face(void **state)
{
    (void)state;
    fw_scenario *scenario = read_with(NULL, 0);
    fw_observer *observer = make(scenario);
    /* Two columns of 8; in rows of 5 the last particle, and in every other row also the one before
     * it would lie 1.5 from the face: so 1 and 2 in turn. */
    assert_int_equal(fw_grip_particle_count(fw_scene_observe_grip(observer->experiment->scene, 0)),
                     16);
    assert_int_equal(fw_grip_particle_count(fw_scene_observe_grip(observer->experiment->scene, 1)),
                     15);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

/* --- the ledger --- */

static double ledger_open_by(const char *time_step)
{
    char dt[64];
    snprintf(dt, sizeof dt, "dynamics.time-step=%s", time_step);
    const char *settings[] = {dt};
    fw_scenario *scenario = read_with(settings, 1);
    fw_observer *observer = make(scenario);
    double worst = 0;
    while (fw_scene_time(observer->experiment->scene) < 2500 * .0025) {
        assert_fine(fw_observer_advance(observer, 1, &error));
        const fw_ledger ledger = fw_scene_ledger(observer->experiment->scene);
        const fw_vec2 p = fw_vec2_subtract(fw_scene_momentum(observer->experiment->scene),
                                           fw_ledger_momentum(&ledger));
        const fw_energies now = fw_scene_energies(observer->experiment->scene);
        assert_close(p.x, 0, 1e-10);
        assert_close(p.y, 0, 1e-10);
        worst = fmax(worst, fabs(now.kinetic + now.elastic - fw_ledger_energy(&ledger)));
    }
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
    return worst;
}

/* Grips' work is change of energy and heat; what is left falls with the square of the time step, as
 * Verlet's own error does. */
static void work_of_grips_is_in_the_ledger(void **state)
{
    (void)state;
    const double coarse = ledger_open_by("0.005"), fine = ledger_open_by("0.0025");
    assert_below(coarse, .1);
    assert_below(fine, .4 * coarse);
}

/* --- state --- */

typedef struct copy {
    int sections;
    fw_state_list list[8];
    void *saved[8][FW_STATE_CAPACITY];
} copy;

static void list_state(fw_observer *observer, copy *c)
{
    memset(c, 0, sizeof *c);
    c->sections = fw_scene_section_count(observer->experiment->scene);
    for (int n = 0; n < c->sections; ++n)
        fw_scene_section(observer->experiment->scene, n, &c->list[n]);
    fw_observer_state(observer, &c->list[c->sections++]);
}

static uint64_t hash_of(fw_observer *observer)
{
    copy c;
    uint64_t hash = 0;
    list_state(observer, &c);
    for (int n = 0; n < c.sections; ++n) hash = hash * 31 + fw_state_list_hash(&c.list[n]);
    return hash;
}

static void save(fw_observer *observer, copy *c)
{
    list_state(observer, c);
    for (int n = 0; n < c->sections; ++n)
        for (int a = 0; a < c->list[n].count; ++a) {
            const fw_array *array = &c->list[n].array[a];
            const size_t bytes = array->count * fw_element_size(array->element);
            c->saved[n][a] = malloc(bytes + 1);
            assert_non_null(c->saved[n][a]);
            if (bytes > 0) memcpy(c->saved[n][a], array->data, bytes);
        }
}

static void load(fw_observer *observer, copy *c)
{
    copy to;
    list_state(observer, &to);
    for (int n = 0; n < to.sections; ++n)
        for (int a = 0; a < to.list[n].count; ++a) {
            const fw_array *array = &to.list[n].array[a];
            if (array->count > 0)
                memcpy(array->data, c->saved[n][a], array->count * fw_element_size(array->element));
            free(c->saved[n][a]);
        }
    assert_fine(fw_scene_restored(observer->experiment->scene, &error));
}

static void a_run_goes_on_exactly_from_the_middle_of_any_phase(void **state)
{
    (void)state;
    static const int64_t stops[] = {1, 250, 499, 500, 501, 1000, 1500, 1501, 1750, 1800, 2499};
    fw_scenario *scenario = read_with(NULL, 0);
    fw_observer *whole = make(scenario);
    step_until(whole, 2500);
    const uint64_t wanted = hash_of(whole);
    fw_observer *runner = make(scenario);
    for (size_t n = 0; n < sizeof stops / sizeof stops[0]; ++n) {
        copy c;
        step_until(runner, stops[n]);
        save(runner, &c);
        fw_observer_destroy(runner);
        runner = make(scenario);
        load(runner, &c);
    }
    step_until(runner, 2500);
    assert_true(hash_of(runner) == wanted);
    fw_observer_destroy(runner);
    fw_observer_destroy(whole);
    fw_scenario_destroy(scenario);
}

/* --- profile --- */

static void a_crystal_that_moves_as_one_has_a_plain_profile(void **state)
{
    (void)state;
    static const char text[] =
        "title: a crystal\n"
        "materials: {crystal: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
        "bodies: {b: {material: crystal, lattice: hexagonal, shape: {rectangle: [20, 21]},\n"
        "  velocity: [0, 0.01]}}\n"
        "run: {steps: 200}\n"
        "profile: {axis: x, every: 100, bin: 1, middle: 9.75, window: [4, 14], far: [3, 6]}\n";
    fw_scenario *scenario;
    assert_fine(fw_scenario_read(&scenario, "c.yaml", text, strlen(text), NULL, 0, &error));
    fw_observer *observer = make(scenario);
    step_until(observer, 200);
    const fw_profile *p = observer->profile;
    assert_int_equal(fw_profile_sample_count(p), 2);
    /* 4.33 to 13.86: 12 rows of the window's height of 10, and one particle per bin and row. */
    for (int bin = 6; bin < 14; ++bin) {
        assert_close(fw_profile_value(p, bin, FW_PROFILE_DENSITY), 1.2, .11);
        assert_close(fw_profile_value(p, bin, FW_PROFILE_ORDER), 1, 1e-3);
        assert_close(fw_profile_value(p, bin, FW_PROFILE_DRIFT), .01, 1e-3);
        assert_close(fw_profile_value(p, bin, FW_PROFILE_TEMPERATURE), 0, 1e-4);
        assert_close(fw_profile_value(p, bin, FW_PROFILE_BOND_BREAKING), 0, 0);
        assert_below(fw_profile_value(p, bin, FW_PROFILE_RELATIVE_DISPLACEMENT), 1e-3);
    }
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

/* How often forces are sampled says nothing about how often bonds break, or how far they stretch.
 */
static void rates_do_not_depend_on_how_often_is_sampled(void **state)
{
    (void)state;
    static const fw_profile_column columns[] = {
        FW_PROFILE_BOND_BREAKING, FW_PROFILE_RELATIVE_DISPLACEMENT, FW_PROFILE_DIFFUSIVITY};
    static const char *const every[] = {"profile.every=50", "profile.every=400"};
    double found[2][3];
    for (int n = 0; n < 2; ++n) {
        fw_scenario *scenario = read_with(&every[n], 1);
        fw_observer *observer = make(scenario);
        step_until(observer, 2500);
        assert_int_equal(fw_profile_sample_count(observer->profile), n == 0 ? 20 : 2);
        for (int c = 0; c < 3; ++c)
            found[n][c] = fw_profile_value(observer->profile, FW_PROFILE_CONTACT, columns[c]);
        fw_observer_destroy(observer);
        fw_scenario_destroy(scenario);
    }
    for (int c = 0; c < 3; ++c) {
        assert_true(isfinite(found[0][c]) && found[0][c] != 0);
        assert_close(found[1][c], found[0][c], 0);
    }
}

/* Ways, works and mean forces are summed in every step, however seldom rows are measured. */
static void rubbing_does_not_depend_on_how_often_is_measured(void **state)
{
    (void)state;
    static const char *const every[] = {"run.measure-every=10", "run.measure-every=250"};
    static const fw_layer_measure measures[] = {
        FW_LAYER_SLIP_PATH,    FW_LAYER_OFFSET,      FW_LAYER_FRICTION_FORCE,
        FW_LAYER_NORMAL_FORCE, FW_LAYER_LOOP_ENERGY, FW_LAYER_FRICTION_COEFFICIENT};
    double layers[2][FW_LAYER_MEASURES];
    for (int n = 0; n < 2; ++n) {
        fw_scenario *scenario = read_with(&every[n], 1);
        fw_observer *observer = make(scenario);
        fw_measurement *measurement;
        double path = 0, last = 0;
        assert_fine(fw_measurement_create(&measurement, observer, &error));
        for (int step = 1; step <= 2500; ++step) {
            assert_fine(fw_observer_advance(observer, 1, &error));
            const double slip = fw_rubbing_slip(observer->experiment).y;
            if (step > observer->rubbing.before && step <= observer->rubbing.from)
                path += fabs(slip - last);
            last = slip;
            if (fw_measurement_is_due(scenario, step))
                fw_measurement_take(measurement, observer->experiment);
        }
        assert_fine(fw_layer_of(layers[n], observer, measurement, &error));
        assert_true(path > 0);
        assert_close(layers[n][FW_LAYER_SLIP_PATH], path, 1e-14);
        fw_measurement_destroy(measurement);
        fw_observer_destroy(observer);
        fw_scenario_destroy(scenario);
    }
    for (size_t k = 0; k < sizeof measures / sizeof measures[0]; ++k) {
        assert_true(isfinite(layers[0][measures[k]]) && layers[0][measures[k]] != 0);
        assert_close(layers[1][measures[k]], layers[0][measures[k]], 0);
    }
}

/* --- study --- */

static void run_study(fw_scenario *scenario, const char *folder, int threads,
                      void (*look)(const fw_study *, void *), void *data)
{
    fw_study *study;
    const fw_run_options options = {.directory = folder, .threads = 1, .at_once = threads};
    assert_fine(fw_study_begin(&study, scenario, &options, &error));
    assert_fine(fw_study_to_end(study, &error));
    look(study, data);
    fw_study_destroy(study);
}

typedef struct outcome {
    fw_outcome layer[FW_LAYER_MEASURES], force[64];
    int bins;
} outcome;

static void note(const fw_study *study, void *data)
{
    outcome *o = data;
    const fw_profile_table *table = fw_study_table(study);
    memcpy(o->layer, table->layer, sizeof o->layer);
    o->bins = table->bin_count;
    assert_true(o->bins <= 64);
    memcpy(o->force, fw_profile_table_column(table, FW_PROFILE_RETURN_FORCE),
           (size_t)o->bins * sizeof *o->force);
}

static void replicas_do_not_depend_on_how_many_run_at_a_time(void **state)
{
    (void)state;
    static outcome one, two;
    fw_scenario *scenario = read_with(NULL, 0);
    run_study(scenario, NULL, 1, note, &one);
    run_study(scenario, NULL, 2, note, &two);
    assert_memory_equal(&one, &two, sizeof one);
    fw_scenario_destroy(scenario);
}

static void rubbing_shows_beside_the_control(void **state)
{
    (void)state;
    static outcome o;
    fw_scenario *scenario = read_with(NULL, 0);
    run_study(scenario, NULL, 2, note, &o);
    const fw_outcome *slip = &o.layer[FW_LAYER_SLIP_PATH];
    assert_true(slip->mean > 4 * slip->control && slip->control > 0);
    assert_true(o.layer[FW_LAYER_LOOP_ENERGY].mean >
                5 * fabs(o.layer[FW_LAYER_LOOP_ENERGY].control));
    assert_true(o.layer[FW_LAYER_RELATIVE_DISPLACEMENT_OVER_CONTROL].mean > 2);
    assert_true(isfinite(o.layer[FW_LAYER_CONTACT].error));
    /* The force across the contact is what the grips press with. */
    assert_close(o.layer[FW_LAYER_NORMAL_FORCE].control, 16, .2);
    fw_scenario_destroy(scenario);
}

static void compare_with_file(const fw_study *study, void *folder)
{
    fw_playback *playback;
    fw_profile_table *table;
    assert_fine(fw_playback_open(&playback, folder, &error));
    assert_string_equal(playback->exit_reason, FW_RUN_FINISHED);
    assert_fine(fw_profile_table_read(&table, playback, 'x', &error));
    const fw_profile_table *wanted = fw_study_table(study);
    assert_int_equal(table->bin_count, wanted->bin_count);
    assert_memory_equal(table->edges, wanted->edges,
                        ((size_t)table->bin_count + 1) * sizeof *table->edges);
    assert_memory_equal(table->columns, wanted->columns,
                        (size_t)table->bin_count * FW_PROFILE_COLUMNS * sizeof *table->columns);
    assert_memory_equal(table->layer, wanted->layer, sizeof table->layer);
    fw_profile_table_destroy(table);
    fw_playback_close(playback);
}

static void the_results_file_holds_profile_and_layer(void **state)
{
    (void)state;
    char folder[64], control[96];
    make_quick_folder(folder, sizeof folder);
    fw_scenario *scenario = read_with(NULL, 0);
    run_study(scenario, folder, 2, compare_with_file, folder);
    fw_playback *playback;
    snprintf(control, sizeof control, "%s/" FW_CONTROL_FOLDER, folder);
    assert_fine(fw_playback_open(&playback, control, &error));
    assert_string_equal(playback->exit_reason, FW_RUN_FINISHED);
    fw_playback_close(playback);
    fw_scenario_destroy(scenario);
    remove_folder(folder);
}

/* layer.csv has a row per run; of these are the table's means and errors. */
static void compare_with_rows(const fw_study *study, void *folder)
{
    char path[96], line[8192], *cell;
    double values[4][FW_LAYER_MEASURES];
    snprintf(path, sizeof path, "%s/" FW_LAYER_FILE, (const char *)folder);
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    assert_non_null(fgets(line, sizeof line, in));
    assert_int_equal(strncmp(line, "seed,run,layer-contact,layer-far,", 33), 0);
    for (int n = 0; n < 4; ++n) {
        assert_non_null(fgets(line, sizeof line, in));
        char *at = fw_csv_cut(line, &cell);
        assert_int_equal(atoi(cell), 1 + n % 2);
        at = fw_csv_cut(at, &cell);
        assert_string_equal(cell, n < 2 ? "experiment" : "control");
        for (int m = 0; m < FW_LAYER_MEASURES; ++m) {
            assert_non_null(at);
            at = fw_csv_cut(at, &cell);
            values[n][m] = fw_csv_read_number(cell);
        }
        assert_null(at);
    }
    assert_null(fgets(line, sizeof line, in));
    fclose(in);
    const fw_outcome *layer = fw_study_table(study)->layer;
    for (int m = 0; m < FW_LAYER_MEASURES; ++m) {
        if (isnan(layer[m].mean)) continue;
        const double one = values[0][m], other = values[1][m];
        assert_close(layer[m].mean, (one + other) / 2, 1e-12 * fabs(one));
        assert_close(layer[m].error, fabs(one - other) / 2, 1e-12 * fabs(one));
        if (isnan(layer[m].control)) continue;
        assert_close(layer[m].control, (values[2][m] + values[3][m]) / 2,
                     1e-12 * fabs(values[2][m]));
    }
    const int over = FW_LAYER_CONTACT_OVER_CONTROL, contact = FW_LAYER_CONTACT;
    for (int n = 0; n < 2; ++n)
        assert_close(values[n][over], values[n][contact] / values[n + 2][contact], 1e-12);
    assert_true(values[0][contact] != values[1][contact] && isnan(values[2][over]));
}

static void the_layer_of_every_run_is_kept(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    fw_scenario *scenario = read_with(NULL, 0);
    run_study(scenario, folder, 2, compare_with_rows, folder);
    fw_scenario_destroy(scenario);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_phase_has_its_own_bath_and_gives_it_back),
        cmocka_unit_test(a_grip_swings_only_in_the_phases_that_say_so),
        cmocka_unit_test(layers_hold_what_is_near_the_outer_face),
        cmocka_unit_test(work_of_grips_is_in_the_ledger),
        cmocka_unit_test(a_run_goes_on_exactly_from_the_middle_of_any_phase),
        cmocka_unit_test(a_crystal_that_moves_as_one_has_a_plain_profile),
        cmocka_unit_test(rates_do_not_depend_on_how_often_is_sampled),
        cmocka_unit_test(rubbing_does_not_depend_on_how_often_is_measured),
        cmocka_unit_test(replicas_do_not_depend_on_how_many_run_at_a_time),
        cmocka_unit_test(rubbing_shows_beside_the_control),
        cmocka_unit_test(the_results_file_holds_profile_and_layer),
        cmocka_unit_test(the_layer_of_every_run_is_kept),
    };
    return cmocka_run_group_tests_name("friction", tests, NULL, NULL);
}
