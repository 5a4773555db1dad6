/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_playback.c - results of which a part is missing, damaged or odd: that part is refused with a
 * sentence and the rest is read. What was damaged with a right seal is made by foreign_files.py. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "tests/support/recorded_run.h"

static char folder[64];

static int begin_folder(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    return 0;
}

static int end_folder(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static void record_run(const fw_trajectory_def *def)
{
    fw_trajectory *trajectory;
    assert_fine(fw_trajectory_create(&trajectory, def, &error));
    assert_fine(run_write_until(trajectory, def->sample_count));
    static const double edges[] = {1, 2, 3, 4};
    for (int n = 0; n < def->array_count; ++n)
        assert_fine(fw_trajectory_write_array(trajectory, &def->arrays[n], edges, &error));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
}

/* The run of recorded_run.h with a profile of four edges and an analysis. */
static void record_whole(void)
{
    static double growth[] = {.5, .25, .125};
    static const fw_trajectory_array arrays[] = {{"profile/edges", "length", "of bins", 4, 1},
                                                 {"profile/sums", "length", "of bins", 2, 2},
                                                 {"profile/worst", "1", "of all", 1, 3}};
    static const fw_table tables[] = {{"growth", "1", "per step", 1, {3, 0}, growth}};
    static const fw_table_group groups[] = {{"map", tables, 1}};
    fw_trajectory_def def = run_def(folder);
    def.arrays = arrays;
    def.array_count = 3;
    def.groups = groups;
    def.group_count = 1;
    record_run(&def);
}

static fw_playback *open_file(const char *name)
{
    fw_playback *playback;
    char path[160];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (fw_playback_open(&playback, path, &error) != FW_OK)
        fail_msg("%s: %s", name, error.sentence);
    return playback;
}

/* --- what is not there --- */

static void arrays_are_read_in_the_shape_that_they_have(void **state)
{
    (void)state;
    double values[8], sums[4];
    fw_table table;
    record_whole();
    fw_playback *playback = open_file("trajectory.h5");
    assert_int_equal(fw_playback_array_rows(playback, "profile/edges", 1), 4);
    assert_int_equal(fw_playback_array_rows(playback, "profile/sums", 2), 2);
    assert_int_equal(fw_playback_array_rows(playback, "profile/worst", 3), 1);
    assert_int_equal(fw_playback_array_rows(playback, "profile/edges", 2), 0);
    assert_int_equal(fw_playback_array_rows(playback, "profile/sums", 3), 0);
    assert_int_equal(fw_playback_array_rows(playback, "profile/none", 1), 0);
    assert_int_equal(fw_playback_array_rows(playback, "profile", 1), 0);
    assert_fine(fw_playback_read_array(playback, "profile/edges", 4, 1, values, &error));
    assert_true(values[0] == 1 && values[3] == 4);
    assert_fine(fw_playback_read_array(playback, "profile/sums", 2, 2, sums, &error));
    assert_true(sums[1] == 2 && sums[3] == 4);
    assert_fine(fw_playback_read_array(playback, "profile/worst", 1, 3, values, &error));
    assert_true(values[2] == 3);
    assert_fine(fw_playback_read_table(playback, "map", "growth", &table, &error));
    assert_true(table.rank == 1 && table.extent[0] == 3 && table.values[2] == .125);
    free(table.values);
    assert_refused(fw_playback_read_table(playback, "map", "speed", &table, &error), FW_BAD_INPUT,
                   "the results hold no speed of an analysis map");
    assert_fine(fw_playback_check(playback, &error));
    assert_null(fw_playback_fact(playback, "weather"));
    fw_playback_close(playback);
}

static void what_a_run_did_not_record_is_refused_by_name(void **state)
{
    (void)state;
    double x[RUN_PARTICLES], y[RUN_PARTICLES];
    fw_trajectory *trajectory;
    static const fw_trajectory_body bodies[] = {{.name = "gas", .count = 5},
                                                {.name = "wall", .count = 3}};
    fw_trajectory_def def = run_def(folder);
    def.bodies = bodies;
    def.velocity = def.force = false;
    def.field_count = def.observable_count = 0;
    def.sample_count = 0;
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_frame(trajectory, 0));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    fw_playback *playback = open_file("trajectory.h5");
    assert_false(playback->mass || playback->velocity || playback->force);
    assert_int_equal(playback->link_count, 0);
    assert_fine(fw_playback_read_positions(playback, 0, x, y, &error));
    assert_true(y[7] == run_value(0, 0, 7, 1));
    assert_refused(fw_playback_read_positions(playback, -1, x, y, &error), FW_BAD_INPUT,
                   "there is no frame -1; the results have 0 to 0");
    assert_refused(fw_playback_read_velocities(playback, 0, x, y, &error), FW_BAD_INPUT,
                   "the frames of these results hold no velocity");
    assert_refused(fw_playback_read_masses(playback, x, &error), FW_BAD_INPUT,
                   "the results hold no masses");
    assert_refused(fw_playback_read_sample_times(playback, NULL, x, &error), FW_BAD_INPUT,
                   "the results hold no observables");
    fw_playback_close(playback);
}

/* The file of a run at work, or killed, has room for frames that were not written. */
static void what_a_run_has_written_so_far_is_read(void **state)
{
    (void)state;
    enum { WRITTEN = 50, FRAMES = (WRITTEN + 6) / 7 };
    const fw_trajectory_def def = run_def(folder);
    fw_trajectory *trajectory;
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, WRITTEN));
    assert_fine(fw_trajectory_sync(trajectory, &error));
    for (int killed = 0; killed < 2; ++killed) {
        double x[RUN_PARTICLES], y[RUN_PARTICLES], strain[RUN_PARTICLES], momentum[2 * WRITTEN];
        fw_playback *playback = open_file("trajectory.h5");
        assert_int_equal(playback->frame_count, FRAMES);
        assert_int_equal(playback->sample_count, WRITTEN);
        assert_fine(fw_playback_read_positions(playback, FRAMES - 1, x, y, &error));
        assert_true(x[6] == run_value(0, FRAMES - 1, 6, 0) &&
                    y[7] == run_value(0, FRAMES - 1, 7, 1));
        assert_fine(fw_playback_read_velocities(playback, FRAMES - 1, x, y, &error));
        assert_true(y[2] == run_value(1, FRAMES - 1, 2, 1));
        assert_fine(fw_playback_read_field(playback, FRAMES - 1, "strain", strain, &error));
        assert_true(strain[5] == run_value(3, FRAMES - 1, 5, 0));
        assert_fine(fw_playback_read_observable(playback, 1, momentum, &error));
        assert_true(momentum[2 * WRITTEN - 1] == run_value(6, WRITTEN - 1, 0, 1));
        fw_playback_close(playback);
        if (!killed) fw_trajectory_destroy(trajectory);
    }
}

/* --- what is damaged --- */

/* Reads everything that was not read when the file was opened. */
static fw_status read_parts(fw_playback *playback)
{
    static double times[RUN_SAMPLES];
    static int64_t steps[RUN_SAMPLES];
    double edges[4], masses[RUN_PARTICLES];
    fw_table table;
    FW_TRY(fw_playback_read_table(playback, "map", "growth", &table, &error));
    free(table.values);
    FW_TRY(fw_playback_read_sample_times(playback, steps, times, &error));
    FW_TRY(fw_playback_read_frame_times(playback, steps, times, &error));
    if (playback->mass) FW_TRY(fw_playback_read_masses(playback, masses, &error));
    const int rows = fw_playback_array_rows(playback, "profile/edges", 1);
    FW_TRY(fw_playback_check(playback, &error));
    FW_TRY(fw_playback_read_array(playback, "profile/edges", 4, 1, edges, &error));
    assert_int_equal(rows, 4);
    return FW_OK;
}

static const struct {
    const char *file, *part;
} parts[] = {
    {"table-of-integers", "growth"},
    {"table-in-words", "growth"},
    {"cubic-table", "growth"},
    {"single-table", "growth"},
    {"hollow-table", "growth"},
    {"long-table", "growth"},
    {"wide-table", "growth"},
    {"list-of-integers", "profile/edges"},
    {"list-in-words", "profile/edges"},
    {"cubic-list", "profile/edges"},
    {"single-list", "profile/edges"},
    {"wide-list", "profile/edges"},
    {"short-list", "profile/edges"},
    {"hollow-list", "profile/edges"},
    {"long-list", "profile/edges"},
    {"no-list", "profile/edges"},
    {"no-sample-steps", "energy/step"},
    {"sample-times-in-words", "energy/time"},
    {"few-frame-times", "position/time"},
};

static bool make_files(const char *kind)
{
    char arguments[256];
    record_whole();
    snprintf(arguments, sizeof arguments, "%s/trajectory.h5 %s %s", folder, folder, kind);
    const int status = run_python("foreign_files.py", arguments);
    if (status > 0) fail_msg("foreign_files.py %s failed", kind);
    return status == 0;
}

static void a_damaged_part_is_refused(void **state)
{
    (void)state;
    if (make_files("parts")) {
        fw_playback *playback = open_file("trajectory.h5");
        assert_fine(read_parts(playback));
        fw_playback_close(playback);
        for (size_t n = 0; n < sizeof parts / sizeof *parts; ++n) {
            char name[64];
            snprintf(name, sizeof name, "%s.h5", parts[n].file);
            playback = open_file(name);
            error = (fw_error){0};
            const fw_status status = read_parts(playback);
            if (status != FW_BAD_INPUT || !strstr(error.sentence, parts[n].part) ||
                !strstr(error.sentence, "missing or not as expected"))
                fail_msg("%s: status %d, '%s'", name, (int)status, error.sentence);
            fw_playback_close(playback);
        }
        /* Masses that are none are not there. */
        playback = open_file("integral-mass.h5");
        assert_false(playback->mass);
        assert_fine(read_parts(playback));
        fw_playback_close(playback);
    }
    skip_unseen();
}

static void what_is_only_odd_is_read(void **state)
{
    (void)state;
    if (make_files("oddities")) {
        fw_playback *playback = open_file("escape-in-field.h5");
        assert_int_equal(playback->field_count, 1);
        assert_string_equal(playback->fields[0].name, "return-force");
        fw_playback_close(playback);
        playback = open_file("other-letters.h5");
        assert_string_equal(playback->fields[0].unit, "µm \xc2\xa0À");
        fw_playback_close(playback);
        playback = open_file("crowd.h5");
        assert_int_equal(playback->field_count, 2);
        fw_playback_close(playback);
    }
    skip_unseen();
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin_folder, end_folder)
    const struct CMUnitTest tests[] = {
        TEST(arrays_are_read_in_the_shape_that_they_have),
        TEST(what_a_run_did_not_record_is_refused_by_name),
        TEST(what_a_run_has_written_so_far_is_read),
        TEST(a_damaged_part_is_refused),
        TEST(what_is_only_odd_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
