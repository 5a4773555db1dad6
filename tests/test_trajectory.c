/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_trajectory.c - what a run writes is what a reader finds, in our own reader and in h5py. */
#include "tests/laws.h"

#include "experiments/playback.h"
#include "tests/recorded_run.h"

#include <sys/stat.h>

static fw_error error;

#define assert_fine(call)                                                                          \
    do {                                                                                           \
        if ((call) != FW_OK) fail_msg("%s: %s", #call, error.sentence);                            \
    } while (0)

#define assert_refused(call, wanted, words)                                                        \
    do {                                                                                           \
        error = (fw_error){0};                                                                     \
        assert_int_equal((call), (wanted));                                                        \
        assert_int_equal(error.status, (wanted));                                                  \
        if (!strstr(error.sentence, (words)))                                                      \
            fail_msg("'%s' does not speak of '%s'", error.sentence, (words));                      \
    } while (0)

/* The whole run, or its first `samples` samples and the frames among them. */
static void record(const char *folder, int64_t samples, const char *reason)
{
    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    for (int64_t sample = 0; sample < samples; ++sample) {
        assert_fine(run_write_sample(trajectory, sample, &error));
        if (sample % 7 == 0 && sample / 7 < RUN_FRAMES)
            assert_fine(run_write_frame(trajectory, sample / 7, &error));
    }
    if (reason) assert_fine(fw_trajectory_finish(trajectory, reason, &error));
    fw_trajectory_destroy(trajectory);
}

static void check_with_h5py(const char *job, const char *folder, const char *more)
{
    char arguments[512];
    snprintf(arguments, sizeof arguments, "%s %s/trajectory.h5 %s", job, folder, more);
    int status = run_python("trajectory.py", arguments);
    if (status == -1) print_message("no h5py here: %s not checked by it\n", job);
    if (status > 0) fail_msg("trajectory.py %s failed", arguments);
}

static void whole_run_reads_back_in_our_own_reader(void **state)
{
    (void)state;
    char folder[64];
    make_folder(folder, sizeof folder);
    record(folder, RUN_SAMPLES, FW_RUN_FINISHED);
    fw_playback *playback;
    assert_fine(fw_playback_open(&playback, folder, &error));
    assert_int_equal(playback->particle_count, RUN_PARTICLES);
    assert_int_equal(playback->frame_count, RUN_FRAMES);
    assert_int_equal(playback->sample_count, RUN_SAMPLES);
    assert_int_equal(playback->body_count, 2);
    assert_string_equal(playback->bodies[1].name, "Körper");
    assert_int_equal(playback->bodies[1].first, 5);
    assert_int_equal(playback->bodies[1].count, 3);
    assert_int_equal(playback->link_count, 5);
    assert_int_equal(playback->links[4][1], 7);
    assert_true(playback->velocity && playback->force && playback->mass);
    assert_int_equal(playback->field_count, 2);
    assert_string_equal(playback->fields[1].name, "return-force");
    assert_string_equal(playback->fields[0].meaning, "elongation of the links");
    assert_int_equal(playback->observable_count, 2);
    assert_string_equal(playback->observables[0].name, "energy");
    assert_string_equal(playback->observables[1].unit, "mass length / time");
    assert_int_equal(playback->observables[1].components, 2);
    assert_string_equal(playback->title, "a run");
    assert_string_equal(playback->scenario, "title: a run\n");
    assert_int_equal(playback->seed, 77);
    assert_string_equal(playback->exit_reason, FW_RUN_FINISHED);

    double x[RUN_PARTICLES], y[RUN_PARTICLES], times[RUN_SAMPLES], momentum[RUN_SAMPLES][2];
    int64_t steps[RUN_SAMPLES];
    for (int frame = 0; frame < RUN_FRAMES; ++frame) {
        assert_fine(fw_playback_read_positions(playback, frame, x, y, &error));
        for (int i = 0; i < RUN_PARTICLES; ++i) {
            assert_true(x[i] == run_value(0, frame, i, 0));
            assert_true(y[i] == run_value(0, frame, i, 1));
        }
    }
    assert_fine(fw_playback_read_velocities(playback, 3, x, y, &error));
    assert_true(y[7] == run_value(1, 3, 7, 1));
    assert_fine(fw_playback_read_forces(playback, 4, x, y, &error));
    assert_true(x[6] == run_value(2, 4, 6, 0));
    assert_fine(fw_playback_read_field(playback, 39, "return-force", x, &error));
    assert_true(x[4] == run_value(4, 39, 4, 0) && isnan(x[5]));
    assert_fine(fw_playback_read_masses(playback, x, &error));
    assert_true(x[7] == 0.25);
    assert_fine(fw_playback_read_frame_times(playback, steps, times, &error));
    assert_true(steps[39] == 390 && times[39] == 195);
    assert_fine(fw_playback_read_sample_times(playback, steps, times, &error));
    assert_true(steps[299] == 299 && times[299] == 149.5);
    int number = fw_playback_find_observable(playback, "momentum");
    assert_fine(fw_playback_read_observable(playback, number, momentum[0], &error));
    assert_true(momentum[299][1] == run_value(6, 299, 0, 1));

    assert_int_equal(fw_playback_find_observable(playback, "temperature"), -1);
    assert_refused(fw_playback_read_field(playback, 0, "stress", x, &error), FW_BAD_INPUT,
                   "no stress");
    assert_refused(fw_playback_read_positions(playback, RUN_FRAMES, x, y, &error), FW_BAD_INPUT,
                   "no frame 40");
    fw_playback_close(playback);
    remove_folder(folder);
}

static void whole_run_is_h5md(void **state)
{
    (void)state;
    char folder[64];
    make_folder(folder, sizeof folder);
    record(folder, RUN_SAMPLES, FW_RUN_FINISHED);
    check_with_h5py("h5md", folder, "40 300");
    remove_folder(folder);
}

static void run_that_ends_early_is_cut_to_what_it_wrote(void **state)
{
    (void)state;
    char folder[64];
    make_folder(folder, sizeof folder);
    record(folder, 100, "interrupted");
    check_with_h5py("h5md", folder, "15 100");
    remove_folder(folder);
}

static void writing_rows_changes_no_structure(void **state)
{
    (void)state;
    char folder[64], command[256];
    make_folder(folder, sizeof folder);
    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    snprintf(command, sizeof command, "cp %s/trajectory.h5 %s/before.h5", folder, folder);
    assert_int_equal(system(command), 0);
    assert_fine(run_write_rest(trajectory, &error));
    assert_fine(fw_trajectory_sync(trajectory, &error));
    snprintf(command, sizeof command, "%s/before.h5", folder);
    check_with_h5py("structure", folder, command);
    fw_trajectory_destroy(trajectory);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_run_reads_back_in_our_own_reader),
        cmocka_unit_test(whole_run_is_h5md),
        cmocka_unit_test(run_that_ends_early_is_cut_to_what_it_wrote),
        cmocka_unit_test(writing_rows_changes_no_structure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
