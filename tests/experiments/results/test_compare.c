/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_compare.c - two results are the same, or what differs is named with where and by how much.
 */
#include "tests/support/laws.h"

#include "experiments/results/compare.h"
#include "experiments/results/trajectory_layout.h"
#include "tests/support/recorded_run.h"

/* A result of two frames and three samples, with what is asked to be otherwise. */
typedef struct result {
    double moved;    /* of the first particle along x in the last frame */
    double lifted;   /* of the last one along y */
    double rising;   /* of its velocity */
    double pulled;   /* of its first field */
    double measured; /* of the last component in the last sample */
    bool no_velocity, no_fields, other_field, other_observable, scalar, no_observables, one_frame;
} result;

static char folder[64];

static fw_playback *make(const char *name, const result *as)
{
    static const fw_trajectory_body bodies[] = {{.name = "gas", .count = 2}};
    const fw_trajectory_field fields[] = {{as->other_field ? "stress" : "strain", "1", "of it"}};
    const fw_observable observables[] = {
        {"energy", "energy", "of all", 1},
        {as->other_observable ? "impulse" : "momentum", "momentum", "of all", as->scalar ? 1 : 2}};
    char path[160];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    fw_trajectory_def def = fw_trajectory_def_default();
    def.directory = path;
    def.title = "a result";
    def.scenario = "title: a result\n";
    def.bodies = bodies;
    def.body_count = 1;
    def.velocity = !as->no_velocity;
    def.fields = fields;
    def.field_count = as->no_fields ? 0 : 1;
    def.observables = observables;
    def.observable_count = as->no_observables ? 0 : 2;
    def.frame_count = as->one_frame ? 1 : 2;
    def.sample_count = as->no_observables ? 0 : 3;
    fw_trajectory *trajectory;
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    for (int frame = 0; frame < def.frame_count; ++frame) {
        const double x[] = {1 + (frame == 1 ? as->moved : 0), 2},
                     y[] = {3, 4 + (frame == 1 ? as->lifted : 0)};
        const double rate[] = {6, 8 + as->rising};
        const double strain[] = {5 + as->pulled, NAN};
        const double *const given[] = {strain};
        const fw_frame_body body = {
            .x = x, .y = y, .velocity_x = x, .velocity_y = rate, .fields = given};
        assert_fine(fw_trajectory_write_frame(trajectory, 10 * frame, frame, &body, &error));
    }
    for (int sample = 0; sample < def.sample_count; ++sample) {
        double values[] = {7, 8, 9};
        values[as->scalar ? 1 : 2] += sample == 2 ? as->measured : 0;
        assert_fine(fw_trajectory_write_sample(trajectory, 5 * sample, sample, values, &error));
    }
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    fw_playback *playback;
    assert_fine(fw_playback_open(&playback, path, &error));
    return playback;
}

/* Compares a plain result, or `with`, with another one: so many differences, told in these words.
 */
static void expect_between(const result *with, const result *other, int expected, const char *words)
{
    static const result plain = {0};
    char text[1024] = "";
    int differing = -1;
    make_quick_folder(folder, sizeof folder);
    FILE *out = fmemopen(text, sizeof text, "w");
    assert_non_null(out);
    fw_playback *one = make("one", with ? with : &plain), *two = make("two", other);
    assert_fine(fw_compare(one, two, out, &differing, &error));
    assert_int_equal(fw_compare_provenance(one, two, out), 0);
    fclose(out);
    if (differing != expected || strcmp(text, words) != 0)
        fail_msg("%d differences: '%s', expected %d: '%s'", differing, text, expected, words);
    fw_playback_close(one);
    fw_playback_close(two);
    remove_folder(folder);
}

static void equal_results_are_the_same(void **state)
{
    (void)state;
    expect_between(NULL, &(result){0}, 0, "");
    const result bare = {.no_observables = true, .no_fields = true, .no_velocity = true};
    expect_between(&bare, &bare, 0, "");
}

static void numbers_that_differ_are_told_with_their_row_and_size(void **state)
{
    (void)state;
    expect_between(NULL, &(result){.lifted = -.25}, 1,
                   "  position differs from frame 1 (step 10) on, by up to 0.25\n");
    expect_between(NULL, &(result){.rising = 3}, 1,
                   "  velocity differs from frame 0 (step 0) on, by up to 3\n");
    expect_between(NULL, &(result){.moved = -.25}, 2,
                   "  position differs from frame 1 (step 10) on, by up to 0.25\n"
                   "  velocity differs from frame 1 (step 10) on, by up to 0.25\n");
    expect_between(NULL, &(result){.pulled = .5}, 1,
                   "  strain differs from frame 0 (step 0) on, by up to 0.5\n");
    expect_between(NULL, &(result){.measured = 2}, 1,
                   "  momentum differs from sample 2 (step 10) on, by up to 2\n");
    expect_between(NULL, &(result){.measured = NAN, .moved = 1e-9}, 3,
                   "  position differs from frame 1 (step 10) on, by up to 1e-09\n"
                   "  velocity differs from frame 1 (step 10) on, by up to 1e-09\n"
                   "  momentum differs from sample 2 (step 10) on, by up to nan\n");
    expect_between(&(result){.pulled = NAN}, &(result){.pulled = 1}, 1,
                   "  strain differs from frame 0 (step 0) on, by up to nan\n");
}

static void what_only_one_has_is_named(void **state)
{
    (void)state;
    expect_between(NULL, &(result){.no_velocity = true}, 1, "  velocity is only in one of them\n");
    expect_between(&(result){.no_velocity = true}, &(result){0}, 1,
                   "  velocity is only in one of them\n");
    expect_between(NULL, &(result){.other_field = true}, 1, "  strain is only in one of them\n");
    expect_between(NULL, &(result){.other_observable = true}, 1,
                   "  momentum is only in one of them\n");
    expect_between(NULL, &(result){.scalar = true}, 1, "  momentum is only in one of them\n");
    expect_between(NULL, &(result){.no_fields = true}, 1, "  fields: 1 and 0\n");
    expect_between(NULL, &(result){.one_frame = true, .no_observables = true}, 3,
                   "  frames: 2 and 1\n  samples: 3 and 0\n  observables: 2 and 0\n");
}

/* Makes the result one of another version of the program. */
static void change_version(const char *name)
{
    char path[160];
    fw_hdf5 *file;
    snprintf(path, sizeof path, "%s/%s/trajectory.h5", folder, name);
    assert_fine(fw_hdf5_open(&file, path, true, &error));
    fw_layout_note(file, "version", "9.8");
    fw_hdf5_flush(file);
    fw_layout_seal(file);
    assert_fine(fw_hdf5_close(file, &error));
}

static void programs_that_differ_are_named(void **state)
{
    (void)state;
    char text[256] = "", path[160];
    make_quick_folder(folder, sizeof folder);
    fw_playback *one = make("one", &(result){0}), *two = make("two", &(result){0});
    fw_playback_close(two);
    change_version("two");
    snprintf(path, sizeof path, "%s/two", folder);
    assert_fine(fw_playback_open(&two, path, &error));
    FILE *out = fmemopen(text, sizeof text, "w");
    assert_non_null(out);
    assert_int_equal(fw_compare_provenance(one, two, out), 1);
    fclose(out);
    assert_non_null(strstr(text, "  version: '"));
    assert_non_null(strstr(text, "' then, '9.8' now\n"));
    fw_playback_close(one);
    fw_playback_close(two);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_results_are_the_same),
        cmocka_unit_test(numbers_that_differ_are_told_with_their_row_and_size),
        cmocka_unit_test(what_only_one_has_is_named),
        cmocka_unit_test(programs_that_differ_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
