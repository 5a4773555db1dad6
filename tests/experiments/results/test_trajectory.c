/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_trajectory.c - what a run writes is what a reader finds, in our own reader and in h5py. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "tests/support/recorded_run.h"

#include <sys/stat.h>

/* The first `samples` samples of the run and the frames among them. */
static void record(const char *folder, int64_t samples, const char *reason)
{
    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, samples));
    if (reason) assert_fine(fw_trajectory_finish(trajectory, reason, &error));
    fw_trajectory_destroy(trajectory);
}

static void check_with_h5py(const char *job, const char *folder, const char *more)
{
    char arguments[512];
    snprintf(arguments, sizeof arguments, "%s %s/trajectory.h5 %s", job, folder, more);
    int status = run_python("trajectory.py", arguments);
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
    check_with_h5py("reader", folder, "2>/dev/null");
    remove_folder(folder);
    skip_unseen();
}

static void run_that_ends_early_is_cut_to_what_it_wrote(void **state)
{
    (void)state;
    char folder[64];
    make_folder(folder, sizeof folder);
    record(folder, 100, "interrupted");
    check_with_h5py("h5md", folder, "15 100");
    remove_folder(folder);
    skip_unseen();
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
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_sync(trajectory, &error));
    snprintf(command, sizeof command, "%s/before.h5", folder);
    check_with_h5py("structure", folder, command);
    fw_trajectory_destroy(trajectory);
    remove_folder(folder);
    skip_unseen();
}

/* However a run is cut into pieces, the file ends up with the same numbers: stopped in order and
 * resumed twice, or gone without a word after its last checkpoint. */
static void resumed_run_leaves_the_same_file(void **state)
{
    (void)state;
    static const struct {
        int64_t stop, keep; /* samples written; samples at the checkpoint */
        const char *reason;
    } pieces[] = {{100, 100, "interrupted"}, {180, 130, "interrupted"}, {250, 240, NULL}};
    char whole[64], parts[64], arguments[256];
    make_folder(whole, sizeof whole);
    make_folder(parts, sizeof parts);
    record(whole, RUN_SAMPLES, FW_RUN_FINISHED);

    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(parts);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    for (size_t i = 0; i < sizeof pieces / sizeof *pieces; ++i) {
        assert_fine(run_write_until(trajectory, pieces[i].stop));
        assert_fine(fw_trajectory_sync(trajectory, &error));
        if (pieces[i].reason)
            assert_fine(fw_trajectory_finish(trajectory, pieces[i].reason, &error));
        fw_trajectory_destroy(trajectory);
        assert_fine(fw_trajectory_reopen(&trajectory, &def, run_frames_at(pieces[i].keep),
                                         pieces[i].keep, &error));
    }
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    snprintf(arguments, sizeof arguments, "%s/trajectory.h5", parts);
    check_with_h5py("same", whole, arguments);

    /* Cutting and giving back leaves nothing behind: the files are of the same length. */
    struct stat of_whole, of_parts;
    snprintf(arguments, sizeof arguments, "%s/trajectory.h5", whole);
    assert_int_equal(stat(arguments, &of_whole), 0);
    snprintf(arguments, sizeof arguments, "%s/trajectory.h5", parts);
    assert_int_equal(stat(arguments, &of_parts), 0);
    assert_int_equal(of_whole.st_size, of_parts.st_size);
    snprintf(arguments, sizeof arguments, "test $(ls %s | wc -l) = 1", parts);
    assert_int_equal(system(arguments), 0);
    remove_folder(whole);
    remove_folder(parts);
    skip_unseen();
}

static void finished_run_is_not_resumed(void **state)
{
    (void)state;
    char folder[64];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    fw_trajectory_def def = run_def(folder);
    record(folder, 200, FW_RUN_FINISHED);
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 10, 70, &error), FW_BAD_INPUT,
                   "is finished");
    assert_null(trajectory);
    check_with_h5py("h5md", folder, "29 200");
    remove_folder(folder);
    skip_unseen();
}

static void resume_refuses_what_does_not_fit(void **state)
{
    (void)state;
    char folder[64];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    fw_trajectory_def def = run_def(folder);
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 0, 0, &error), FW_BAD_INPUT,
                   "No such file");
    record(folder, 100, "interrupted");
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 16, 100, &error), FW_BAD_INPUT,
                   "holds 15 frames and 100 samples");
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 15, 101, &error), FW_BAD_INPUT,
                   "holds 15 frames and 100 samples");
    def.frame_count += 1;
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error), FW_BAD_INPUT,
                   "no room");
    def = run_def(folder);
    def.body_count = 1;
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error), FW_BAD_INPUT,
                   "not of 5 particles");
    def = run_def(folder);
    fw_trajectory_body bodies[] = {{"sheet", 4, NULL, NULL, 0}, {"Körper", 4, NULL, NULL, 0}};
    def.bodies = bodies;
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error), FW_BAD_INPUT,
                   "'Körper' has not as many");
    bodies[0] = (fw_trajectory_body){"slab", 5, NULL, NULL, 0};
    bodies[1].count = 3;
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error), FW_BAD_INPUT,
                   "'sheet' in place of 'slab'");
    def = run_def(folder);
    fw_trajectory_field field = {"stress", "force", "not recorded"};
    def.fields = &field;
    def.field_count = 1;
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error), FW_BAD_INPUT,
                   "particles/trajectory/stress");
    def = run_def(folder);
    fw_observable observable = {"momentum", "1", "three components", 3};
    def.observables = &observable;
    def.observable_count = 1;
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error), FW_BAD_INPUT,
                   "parameters/series/momentum");
    /* None of this has hurt the file. */
    def = run_def(folder);
    assert_fine(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error));
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    check_with_h5py("rows", folder, "");
    remove_folder(folder);
    skip_unseen();
}

/* A process that dies while the file is being cut: every state that its writes can leave behind. */
static void file_killed_while_cut_is_put_right(void **state)
{
    (void)state;
    char folder[64], command[512];
    make_folder(folder, sizeof folder);
    record(folder, 100, "interrupted");
    /* The length goes first, then the head is rewritten; 48 bytes in front of the copy are its own.
     */
    static const char *const damages[] = {
        "true",
        "dd if=trajectory.h5.cutting of=trajectory.h5 iflag=skip_bytes skip=48 bs=64k count=1 "
        "conv=notrunc status=none",
        "dd if=trajectory.h5.cutting of=trajectory.h5 iflag=skip_bytes skip=48 bs=5000 count=1 "
        "conv=notrunc status=none",
        "dd if=/dev/zero of=trajectory.h5 bs=1k count=20 conv=notrunc status=none",
    };
    for (size_t i = 0; i < sizeof damages / sizeof *damages; ++i) {
        fw_playback *playback;
        fw_trajectory *trajectory;
        fw_trajectory_def def = run_def(folder);
        snprintf(command, sizeof command,
                 "cd %s && mv trajectory.h5.head trajectory.h5.cutting && %s", folder, damages[i]);
        assert_int_equal(system(command), 0);
        assert_refused(fw_playback_open(&playback, folder, &error), FW_BAD_INPUT, "resume");
        assert_fine(fw_trajectory_reopen(&trajectory, &def, 15, 100, &error));
        assert_fine(fw_trajectory_finish(trajectory, "interrupted", &error));
        fw_trajectory_destroy(trajectory);
        check_with_h5py("rows", folder, "");
        assert_fine(fw_playback_open(&playback, folder, &error));
        fw_playback_close(playback);
    }
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_run_reads_back_in_our_own_reader),
        cmocka_unit_test(whole_run_is_h5md),
        cmocka_unit_test(run_that_ends_early_is_cut_to_what_it_wrote),
        cmocka_unit_test(writing_rows_changes_no_structure),
        cmocka_unit_test(resumed_run_leaves_the_same_file),
        cmocka_unit_test(finished_run_is_not_resumed),
        cmocka_unit_test(resume_refuses_what_does_not_fit),
        cmocka_unit_test(file_killed_while_cut_is_put_right),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
