/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_trajectory_refusals.c - what a results file cannot hold, files whose structure was changed,
 * and copies of a structure that belong to another file. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "experiments/results/trajectory_head.h"
#include "experiments/results/trajectory_layout.h"
#include "experiments/storage/sealed_file.h"
#include "tests/support/program.h"
#include "tests/support/recorded_run.h"

enum { STOPPED = 100 };

static char folder[64];
static fw_trajectory *trajectory;

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static const char *path_in(const char *name)
{
    static char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void record_until(int64_t samples, const char *reason)
{
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, samples));
    assert_fine(fw_trajectory_finish(trajectory, reason, &error));
    fw_trajectory_destroy(trajectory);
}

/* --- definitions --- */

static void refuse_definition(const fw_trajectory_def *def, const char *words)
{
    assert_refused(fw_trajectory_create(&trajectory, def, &error), FW_BAD_INPUT, words);
    assert_null(trajectory);
    assert_refused(fw_trajectory_reopen(&trajectory, def, 0, 0, &error), FW_BAD_INPUT, words);
    assert_null(trajectory);
}

static void what_has_no_room_or_name_is_refused(void **state)
{
    (void)state;
    static const char *const names[] = {"", "a/b", "."};
    for (int n = 0; n < 3; ++n) {
        const fw_trajectory_body body = {.name = names[n], .count = 8};
        const fw_observable observable = {names[n], "1", "of all", 1};
        const fw_trajectory_field field = {names[n], "1", "of each"};
        const fw_table_group group = {.name = names[n]};
        fw_trajectory_def def = run_def(folder);
        def.bodies = &body, def.body_count = 1;
        refuse_definition(&def, "needs a name of 1 to");
        def = run_def(folder);
        def.observables = &observable, def.observable_count = 1;
        refuse_definition(&def, "needs a name of 1 to");
        def = run_def(folder);
        def.fields = &field, def.field_count = 1;
        refuse_definition(&def, "needs a name of 1 to");
        def = run_def(folder);
        def.groups = &group, def.group_count = 1;
        refuse_definition(&def, "the analysis '");
    }
    fw_trajectory_def def = run_def(folder);
    const fw_trajectory_field twice[] = {{"strain", "1", "one"}, {"strain", "1", "other"}};
    def.fields = twice;
    refuse_definition(&def, "there are two fields named 'strain'");
    def = run_def(folder);
    const fw_observable nothing = {"energy", "energy", "of all", 0};
    def.observables = &nothing, def.observable_count = 1;
    refuse_definition(&def, "the observable 'energy' has no components");
    def = run_def(folder);
    def.frame_count = -1;
    refuse_definition(&def, "no negative number");
    def = run_def(folder);
    def.sample_count = -1;
    refuse_definition(&def, "no negative number");
    def = run_def(folder);
    def.body_count = 0;
    refuse_definition(&def, "not 0");
    shell(folder, "test -z \"$(ls)\"");
}

/* --- files --- */

static void a_folder_without_results_has_nothing_to_mend(void **state)
{
    (void)state;
    assert_refused(fw_trajectory_mend(folder, &error), FW_BAD_INPUT, "holds no results");
    assert_refused(fw_trajectory_mend("/tmp/fretwork-no-such", &error), FW_BAD_INPUT, "No such");
    fw_trajectory_abandon(NULL);
    fw_trajectory_destroy(NULL);
}

/* The title lies among what is sealed. */
static void a_changed_structure_does_not_fit_its_seal(void **state)
{
    (void)state;
    char path[96];
    fw_hdf5 *file;
    fw_playback *playback;
    fw_trajectory_def def = run_def(folder);
    record_until(STOPPED, "interrupted");
    snprintf(path, sizeof path, "%s/trajectory.h5", folder);
    assert_fine(fw_hdf5_open(&file, path, true, &error));
    fw_hdf5_write_text(file, fw_hdf5_find(file, "parameters/title"), "another");
    assert_fine(fw_hdf5_close(file, &error));
    assert_refused(fw_playback_open(&playback, folder, &error), FW_BAD_INPUT,
                   "is damaged: the checksum of its structure does not match");
    assert_null(playback);
    /* With its copy it goes back to what it was; without, it is damaged for those who write, too.
     */
    shell(folder, "mv trajectory.h5.head head");
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 0, 0, &error), FW_BAD_INPUT,
                   "is damaged");
}

/* Killed, so that the file has room for all rows. */
static void a_file_with_other_rows_is_not_gone_on_with(void **state)
{
    (void)state;
    char command[400], arguments[256];
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, STOPPED));
    assert_fine(fw_trajectory_sync(trajectory, &error));
    fw_trajectory_destroy(trajectory);
    shell(folder, "mkdir files");
    snprintf(arguments, sizeof arguments, "%s/trajectory.h5 %s/files rows", folder, folder);
    const int status = run_python("foreign_files.py", arguments);
    if (status > 0) fail_msg("foreign_files.py failed");
    shell(folder, "cp trajectory.h5 files/right.h5; ls files > names");
    FILE *names = fopen(path_in("names"), "r");
    int count = 0;
    for (char name[64]; fscanf(names, "%63s", name) == 1; ++count) {
        snprintf(command, sizeof command, "cp files/%s trajectory.h5", name);
        shell(folder, command);
        error = (fw_error){0};
        const fw_status opened =
            fw_trajectory_reopen(&trajectory, &def, run_frames_at(STOPPED), STOPPED, &error);
        if (opened != (strcmp(name, "right.h5") == 0 ? FW_OK : FW_BAD_INPUT))
            fail_msg("%s: status %d, '%s'", name, (int)opened, error.sentence);
        if (opened == FW_OK) fw_trajectory_destroy(trajectory);
    }
    fclose(names);
    assert_true(count == 1 || count > 10);
    skip_unseen();
}

/* --- the copy of the structure of a file that was cut --- */

typedef struct copy_start {
    uint64_t whole, seal_at, seal;
} copy_start;

/* Writes a copy that begins so, with as many of the right one's bytes behind. */
static void write_copy(const copy_start *start, const unsigned char *bytes, uint64_t count)
{
    fw_folder *held;
    fw_sealed_file *file;
    const uint64_t size = start ? sizeof *start + count : count;
    assert_fine(fw_folder_visit(&held, folder, &error));
    assert_fine(
        fw_sealed_file_create(&file, held, FW_HEAD_AFTER_CUTTING, FW_HEAD_KIND, size, &error));
    if (start) fw_sealed_file_write(file, start, sizeof *start);
    if (count > 0) fw_sealed_file_write(file, bytes, count);
    assert_fine(fw_sealed_file_commit(file, &error));
    fw_folder_close(held);
}

static void a_copy_of_another_file_is_refused(void **state)
{
    (void)state;
    fw_folder *held;
    unsigned char *payload;
    uint64_t size;
    copy_start right;
    fw_trajectory_def def = run_def(folder);
    record_until(STOPPED, "interrupted");
    shell(folder, "cp trajectory.h5 before");
    assert_fine(fw_folder_visit(&held, folder, &error));
    assert_fine(
        fw_sealed_file_read(held, FW_HEAD_AFTER_CUTTING, FW_HEAD_KIND, &payload, &size, &error));
    fw_folder_close(held);
    memcpy(&right, payload, sizeof right);
    const unsigned char *bytes = payload + sizeof right;
    const uint64_t count = size - sizeof right;
    const struct {
        copy_start start;
        uint64_t count;
    } wrong[] = {
        {{right.whole, right.seal_at, right.seal + 1}, count},
        {{right.whole, right.seal_at + 8, right.seal}, count},
        {{right.whole, right.whole, right.seal}, count},         /* a seal beyond the file */
        {{right.seal_at + 8, right.seal_at, right.seal}, count}, /* of a shorter file */
        {{right.whole, count - 1, right.seal}, count},           /* a seal within the structure */
        {right, 47},
        {right, 0},
    };
    for (size_t n = 0; n < sizeof wrong / sizeof *wrong; ++n) {
        write_copy(&wrong[n].start, bytes, wrong[n].count);
        assert_refused(fw_trajectory_reopen(&trajectory, &def, 0, 0, &error), FW_BAD_INPUT,
                       "belongs to another results file");
        shell(folder, "cmp trajectory.h5 before");
    }
    write_copy(NULL, bytes, 5);
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 0, 0, &error), FW_BAD_INPUT, "is empty");
    shell(folder, "printf none > trajectory.h5.head");
    assert_refused(fw_trajectory_reopen(&trajectory, &def, 0, 0, &error), FW_BAD_INPUT,
                   "trajectory.h5.head");
    write_copy(&right, bytes, count);
    assert_fine(fw_trajectory_reopen(&trajectory, &def, run_frames_at(STOPPED), STOPPED, &error));
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    free(payload);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)
    const struct CMUnitTest tests[] = {
        TEST(what_has_no_room_or_name_is_refused),
        TEST(a_folder_without_results_has_nothing_to_mend),
        TEST(a_changed_structure_does_not_fit_its_seal),
        TEST(a_file_with_other_rows_is_not_gone_on_with),
        TEST(a_copy_of_another_file_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
