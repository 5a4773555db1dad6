/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_results_short_memory.c - everything that asks for memory while a results file is made, gone
 * on with, read and compared, and while tables and whole files are written, fails once at each
 * place; so does everything that is read of a result. */
#include "tests/support/short_memory.h"

#include "experiments/results/compare.h"
#include "experiments/storage/checksum.h"
#include "experiments/storage/csv.h"
#include "experiments/storage/manifest.h"
#include "experiments/storage/whole_file.h"
#include "tests/experiments/results/failing_reads.h"
#include "tests/support/recorded_run.h"

enum { STOPPED = 100 };

static char folder[64], one[80], other[80], file[80];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(one, sizeof one, "%s/one", folder);
    snprintf(other, sizeof other, "%s/other", folder);
    snprintf(file, sizeof file, "%s/file", folder);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static fw_trajectory_def definition(const char *directory)
{
    static double growth[] = {.5, .25, .125};
    static const fw_trajectory_array arrays[] = {{"profile/edges", "length", "of bins", 4, 1}};
    static const fw_table tables[] = {{"growth", "1", "per step", 1, {3, 0}, growth}};
    static const fw_table_group groups[] = {{"map", tables, 1}};
    fw_trajectory_def def = run_def(directory);
    def.overwrite = true;
    def.arrays = arrays, def.array_count = 1;
    def.groups = groups, def.group_count = 1;
    return def;
}

/* The first samples of the run, as it is where it was interrupted. */
static fw_status record(const char *directory, fw_error *failed)
{
    fw_trajectory *trajectory;
    const fw_trajectory_def def = definition(directory);
    FW_TRY(fw_trajectory_create(&trajectory, &def, failed));
    fw_status status = run_write_until(trajectory, STOPPED);
    if (status == FW_OK)
        status = fw_trajectory_finish(trajectory, "interrupted", failed);
    else
        *failed = error;
    fw_trajectory_destroy(trajectory);
    return status;
}

static fw_status make(const void *unused, uint64_t *result, fw_error *failed)
{
    (void)unused;
    *result = 1;
    return record(one, failed);
}

static fw_status reopen(const void *unused, uint64_t *result, fw_error *failed)
{
    (void)unused;
    fw_trajectory *trajectory;
    char line[256];
    const fw_trajectory_def def = definition(one);
    snprintf(line, sizeof line, "rm -r %s && cp -r %s %s", one, other, one);
    assert_int_equal(system(line), 0);
    FW_TRY(fw_trajectory_reopen(&trajectory, &def, run_frames_at(STOPPED), STOPPED, failed));
    *result = (uint64_t)fw_trajectory_sample_count(trajectory);
    const fw_status status = fw_trajectory_finish(trajectory, "interrupted", failed);
    fw_trajectory_destroy(trajectory);
    return status;
}

/* All that is read of a result. */
static fw_status read_all(const void *unused, uint64_t *result, fw_error *failed)
{
    (void)unused;
    fw_playback *playback;
    fw_table table = {0};
    double edges[4];
    FW_TRY(fw_playback_open(&playback, one, failed));
    fw_status status = fw_playback_read_table(playback, "map", "growth", &table, failed);
    if (status == FW_OK)
        status = fw_playback_read_array(playback, "profile/edges", 4, 1, edges, failed);
    *result = (uint64_t)playback->particle_count + (uint64_t)table.extent[0];
    free(table.values);
    fw_playback_close(playback);
    return status;
}

static fw_status compare(const void *unused, uint64_t *result, fw_error *failed)
{
    (void)unused;
    fw_playback *first, *second;
    int differing = 0;
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    fw_status status = fw_playback_open(&first, one, failed);
    if (status == FW_OK) {
        status = fw_playback_open(&second, other, failed);
        if (status == FW_OK) {
            status = fw_compare(first, second, nowhere, &differing, failed);
            fw_playback_close(second);
        }
        fw_playback_close(first);
    }
    fclose(nowhere);
    *result = (uint64_t)differing;
    return status;
}

static void results_are_whole_or_refused(void **state)
{
    (void)state;
    assert_fine(record(one, &error));
    assert_fine(record(other, &error));
    assert_true(fail_each_place("reading", read_all, NULL) > 5);
    assert_true(fail_each_place("comparing", compare, NULL) > 5);
    assert_true(fail_each_place("going on", reopen, NULL) > 5);
    assert_true(fail_each_place("making", make, NULL) > 5);
}

/* --- files --- */

static void write_word(FILE *out, const void *object)
{
    fw_csv_write_text(out, object);
}

static fw_status write_files(const void *word, uint64_t *result, fw_error *failed)
{
    char *bytes;
    size_t size;
    fw_whole_file *whole;
    FW_TRY(fw_csv_save(file, write_word, word, failed));
    FW_TRY(fw_csv_keep(folder, "table.csv", write_word, word, failed));
    FW_TRY(fw_manifest_read(&bytes, &size, folder, "table.csv", failed));
    *result = fw_checksum_add(FW_CHECKSUM_OF_NOTHING, bytes, size);
    free(bytes);
    FW_TRY(fw_whole_file_begin(&whole, file, failed));
    fputs(word, fw_whole_file_stream(whole));
    return fw_whole_file_commit(whole, failed);
}

static void files_are_written_whole_or_not(void **state)
{
    (void)state;
    assert_true(fail_each_place("files", write_files, "a word") > 8);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)
    const struct CMUnitTest tests[] = {
        TEST(results_are_whole_or_refused),
        TEST(files_are_written_whole_or_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
