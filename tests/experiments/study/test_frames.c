/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_frames.c - frames hold the positions and velocities of every step that they are of, and
 * samples what an experiment has that is looked at in every step, to the bit: whoever else looks,
 * for any number of threads, and whether or not several steps are taken at once. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "experiments/study/run.h"
#include "tests/support/scratch.h"

/* One LB solid that nothing meets, of more particles than one thread takes at a time and the
 * nearest caches hold; an automaton; and two that fall upon a floor. */
static const char *const bodies[] = {
    "bodies: {large: {material: rubber, shape: {rectangle: [303, 251]}, velocity: [0.05, 0.02],"
    " velocities: [{random: 0.05}]}}\n",
    "bodies:\n"
    "  block: {material: foam, shape: {rectangle: [12, 9]}, origin: [60, 3], velocity: [0, -0.1]}\n"
    "walls: {floor: {chain: [[-500, 0], [500, 0]]}}\n",
    "bodies:\n"
    "  one: {material: rubber, shape: {disc: 12}, origin: [0, 40], velocity: [0.1, -0.2]}\n"
    "  two: {material: felt, shape: {disc: 11}, origin: [60, 40], velocity: [-0.1, -0.2],"
    " velocities: [{random: 0.02}]}\n"
    "walls: {floor: {chain: [[-500, 0], [500, 0]]}}\n",
};
enum { SCENES = sizeof bodies / sizeof *bodies, STEPS = 43 };

static fw_scenario *scenario_of(int scene, const char *measured, const char *run)
{
    char text[2048];
    fw_scenario *scenario;
    snprintf(text, sizeof text,
             "title: frames\n"
             "materials:\n"
             "  rubber: {lattice-boltzmann: {}}\n"
             "  felt: {lattice-boltzmann: {rest-mass: 0.4, damping: 0.02}}\n"
             "  foam: {elastic-automaton: {c1: 0.9, c2: 0.5}}\n"
             "%smeasure: [%s]\nrun: {steps: %d, seed: 3, %s}\n",
             bodies[scene], measured, STEPS, run);
    assert_fine(fw_scenario_read(&scenario, "test", text, strlen(text), NULL, 0, &error));
    return scenario;
}

typedef struct numbers {
    size_t count;
    double *x, *y, *velocity_x, *velocity_y;
} numbers;

static numbers room_for(size_t count)
{
    double *all = calloc(4 * count, sizeof *all);
    assert_non_null(all);
    return (numbers){count, all, all + count, all + 2 * count, all + 3 * count};
}

/* As the experiment has them, whose positions are right. */
static numbers numbers_of(const fw_experiment *experiment)
{
    size_t count = 0, from = 0;
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s)
        count += (size_t)fw_scene_observe_body(experiment->scene, s)->count;
    const numbers all = room_for(count);
    for (int s = 0; s < fw_scene_body_count(experiment->scene); ++s) {
        const fw_solid *solid = fw_scene_observe_body(experiment->scene, s);
        memcpy(all.x + from, solid->x, (size_t)solid->count * sizeof *all.x);
        memcpy(all.y + from, solid->y, (size_t)solid->count * sizeof *all.y);
        solid->model->velocities(solid, all.velocity_x + from, all.velocity_y + from);
        from += (size_t)solid->count;
    }
    return all;
}

static void assert_frame(fw_playback *playback, int64_t frame, const fw_experiment *experiment)
{
    const numbers expected = numbers_of(experiment), read = room_for(expected.count);
    assert_fine(fw_playback_read_positions(playback, frame, read.x, read.y, &error));
    assert_fine(
        fw_playback_read_velocities(playback, frame, read.velocity_x, read.velocity_y, &error));
    assert_memory_equal(read.x, expected.x, 4 * expected.count * sizeof *read.x);
    free(expected.x);
    free(read.x);
}

/* Against an experiment whose positions are all right after each step. */
static void assert_frames(const char *folder, const fw_scenario *scenario, int64_t every)
{
    fw_playback *playback;
    fw_experiment *experiment;
    assert_fine(fw_playback_open(&playback, folder, &error));
    assert_fine(fw_experiment_create(&experiment, scenario, &error));
    for (int64_t step = 0, frame = 0; step <= STEPS; ++step) {
        if (step > 0) assert_fine(fw_experiment_step(experiment, &error));
        if (step % every == 0 || step == STEPS) assert_frame(playback, frame++, experiment);
    }
    fw_experiment_destroy(experiment);
    fw_playback_close(playback);
}

static void run_in(const char *folder, const fw_scenario *scenario, int threads)
{
    fw_run *run;
    const fw_run_options options = {
        .directory = folder, .overwrite = true, .threads = threads, .name = "test"};
    assert_fine(fw_run_begin(&run, scenario, &options, &error));
    assert_fine(fw_run_to_end(run, &error));
    fw_run_destroy(run);
}

static void frames_hold_what_every_step_has(void **state)
{
    (void)state;
    static const char *const runs[] = {
        "record-every: 5, measure-every: 100",
        "record-every: 5, measure-every: 3",
        "record-every: 5",
    };
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    for (int scene = 0; scene < SCENES; ++scene)
        for (int n = 0; n < 3; ++n)
            for (int threads = 1; threads <= 2; ++threads) {
                fw_scenario *scenario = scenario_of(scene, "energy, centre-of-mass", runs[n]);
                run_in(folder, scenario, threads);
                assert_frames(folder, scenario, 5);
                fw_scenario_destroy(scenario);
            }
    remove_folder(folder);
}

/* Rows of a run in which `rotation` has all positions made right, beside those of one without. */
static void samples_are_the_same_whoever_looks(void **state)
{
    (void)state;
    for (int scene = 0; scene < SCENES; ++scene) {
        fw_scenario *scenarios[2] = {
            scenario_of(scene, "energy, momentum, centre-of-mass", "measure-every: 3"),
            scenario_of(scene, "energy, momentum, centre-of-mass, rotation", "measure-every: 3")};
        fw_run *runs[2];
        const fw_run_options options = {.threads = 1, .name = "test"};
        for (int n = 0; n < 2; ++n) {
            assert_fine(fw_run_begin(&runs[n], scenarios[n], &options, &error));
            assert_fine(fw_run_to_end(runs[n], &error));
        }
        const fw_measurement *few = fw_run_measurement(runs[0]), *all = fw_run_measurement(runs[1]);
        assert_false(fw_measurement_needs_positions(few));
        assert_true(fw_measurement_needs_positions(all));
        assert_int_equal(few->count, all->count);
        for (int64_t row = 0; row < few->count; ++row)
            assert_memory_equal(few->values + row * few->width, all->values + row * all->width,
                                (size_t)few->width * sizeof *few->values);
        for (int n = 0; n < 2; ++n) {
            fw_run_destroy(runs[n]);
            fw_scenario_destroy(scenarios[n]);
        }
    }
}

/* A program of one's own looks after any number of steps. */
static void positions_are_right_wherever_an_advance_ends(void **state)
{
    (void)state;
    for (int scene = 0; scene < SCENES; ++scene) {
        fw_scenario *scenario = scenario_of(scene, "energy", "measure-every: 100");
        fw_run *run;
        fw_experiment *experiment;
        const fw_run_options options = {.threads = 1, .name = "test"};
        assert_fine(fw_run_begin(&run, scenario, &options, &error));
        assert_fine(fw_experiment_create(&experiment, scenario, &error));
        for (int64_t step = 0; step < STEPS;) {
            const int64_t more = step + 7 < STEPS ? 7 : STEPS - step;
            assert_fine(fw_run_advance(run, more, &error));
            for (int64_t n = 0; n < more; ++n) assert_fine(fw_experiment_step(experiment, &error));
            step += more;
            const numbers found = numbers_of(fw_run_experiment(run)),
                          wanted = numbers_of(experiment);
            assert_memory_equal(found.x, wanted.x, 4 * wanted.count * sizeof *wanted.x);
            free(found.x);
            free(wanted.x);
        }
        fw_run_destroy(run);
        fw_experiment_destroy(experiment);
        fw_scenario_destroy(scenario);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_hold_what_every_step_has),
        cmocka_unit_test(samples_are_the_same_whoever_looks),
        cmocka_unit_test(positions_are_right_wherever_an_advance_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
