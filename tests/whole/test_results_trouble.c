/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_results_trouble.c - what can be wrong with disks, folders and files: one sentence each, and
 * nothing damaged. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "experiments/storage/hdf5_file.h"
#include "tests/support/recorded_run.h"

#include <dirent.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

static void record(const char *folder, int64_t samples, const char *reason)
{
    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, samples));
    assert_fine(fw_trajectory_finish(trajectory, reason, &error));
    fw_trajectory_destroy(trajectory);
}

/* Fails unless the folder has so many entries. */
static void assert_entries(const char *folder, int wanted)
{
    int found = 0;
    DIR *entries = opendir(folder);
    assert_non_null(entries);
    for (struct dirent *entry = readdir(entries); entry; entry = readdir(entries))
        found += entry->d_name[0] != '.';
    closedir(entries);
    assert_int_equal(found, wanted);
}

static void assert_frames(const char *folder, int64_t frames, const char *exit_reason)
{
    fw_playback *playback;
    double x[RUN_PARTICLES], y[RUN_PARTICLES];
    assert_fine(fw_playback_open(&playback, folder, &error));
    assert_int_equal(playback->frame_count, frames);
    assert_string_equal(playback->exit_reason, exit_reason);
    for (int64_t frame = 0; frame < frames; ++frame) {
        assert_fine(fw_playback_read_positions(playback, frame, x, y, &error));
        for (int i = 0; i < RUN_PARTICLES; ++i)
            assert_true(x[i] == run_value(0, frame, i, 0) && y[i] == run_value(0, frame, i, 1));
    }
    fw_playback_close(playback);
}

/* Stands for a full disk: no file may be longer, and writing beyond says "File too large". */
static struct rlimit unlimited;

static void limit_files(rlim_t bytes)
{
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &unlimited), 0);
    struct rlimit small = {bytes, unlimited.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
}

static void lift_limit(void)
{
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &unlimited), 0);
    signal(SIGXFSZ, SIG_DFL);
}

static void earlier_result_is_only_replaced_when_asked_for(void **state)
{
    (void)state;
    char folder[64], command[256];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    record(folder, 100, "interrupted");
    snprintf(command, sizeof command, "touch %s/checkpoint-A %s/picture.png", folder, folder);
    assert_int_equal(system(command), 0);
    fw_trajectory_def def = run_def(folder);
    assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_BAD_INPUT,
                   "holds a result already");
    assert_entries(folder, 4);
    /* A replacement that fails leaves everything. */
    def.overwrite = true;
    limit_files(100000);
    fw_status status = fw_trajectory_create(&trajectory, &def, &error);
    lift_limit();
    assert_int_equal(status, FW_SYSTEM_FAILED);
    assert_entries(folder, 4);
    assert_frames(folder, 15, "interrupted");
    /* One that succeeds takes the old checkpoint away, which would belong to another run. */
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_entries(folder, 2);
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    assert_frames(folder, 0, FW_RUN_FINISHED);
    remove_folder(folder);
}

static void folders_are_made_and_unmade(void **state)
{
    (void)state;
    char folder[64], inner[128];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    snprintf(inner, sizeof inner, "%s/a/b", folder);
    record(inner, 7, FW_RUN_FINISHED);
    assert_frames(inner, 1, FW_RUN_FINISHED);

    snprintf(inner, sizeof inner, "%s/fresh", folder);
    fw_trajectory_def def = run_def(inner);
    limit_files(100000);
    fw_status status = fw_trajectory_create(&trajectory, &def, &error);
    lift_limit();
    assert_int_equal(status, FW_SYSTEM_FAILED);
    assert_int_equal(access(inner, F_OK), -1);

    snprintf(inner, sizeof inner, "%s/a/b/trajectory.h5/c", folder);
    def.directory = inner;
    assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_BAD_INPUT,
                   "Not a directory");
    snprintf(inner, sizeof inner, "%s/a/b/trajectory.h5", folder);
    assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_BAD_INPUT,
                   "Not a directory");
    def.directory = "";
    assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_BAD_INPUT, "no name");
    remove_folder(folder);
}

/* The superuser may write anywhere, so the test becomes nobody for a while. */
static void folder_without_permission_is_refused(void **state)
{
    (void)state;
    char folder[64];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    record(folder, 100, "interrupted");
    fw_trajectory_def def = run_def(folder);
    def.overwrite = true;
    assert_int_equal(chmod(folder, 0555), 0);
    pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && setuid(65534) != 0) _exit(1);
        if (fw_trajectory_create(&trajectory, &def, &error) != FW_SYSTEM_FAILED) _exit(2);
        if (!strstr(error.sentence, "Permission denied")) _exit(3);
        fw_playback *playback;
        if (fw_playback_open(&playback, folder, &error) != FW_OK) _exit(4);
        fw_playback_close(playback);
        _exit(0);
    }
    int status;
    waitpid(child, &status, 0);
    assert_int_equal(chmod(folder, 0755), 0);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
    assert_entries(folder, 2);
    remove_folder(folder);
}

static void second_writer_is_refused_and_readers_are_not(void **state)
{
    (void)state;
    char folder[64];
    fw_trajectory *trajectory, *second;
    make_folder(folder, sizeof folder);
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, 50));
    assert_frames(folder, 8, FW_RUN_RUNNING);
    def.overwrite = true;
    assert_refused(fw_trajectory_create(&second, &def, &error), FW_BAD_INPUT, "another run");
    assert_refused(fw_trajectory_reopen(&second, &def, 0, 0, &error), FW_BAD_INPUT, "another run");
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    fw_trajectory_destroy(trajectory);
    assert_frames(folder, RUN_FRAMES, FW_RUN_RUNNING);
    remove_folder(folder);
}

/* HDF5 tends to fail again, or never to return, when a file is closed that could not be written:
 * the process that met the full disk has to come to its end. 0: it did, after the right sentences.
 */
static int write_on_a_full_disk(const char *folder)
{
    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(folder);
    if (fw_trajectory_create(&trajectory, &def, &error) != FW_OK) return 1;
    if (run_write_until(trajectory, 71) != FW_OK) return 2;
    if (fw_trajectory_sync(trajectory, &error) != FW_OK) return 3;
    limit_files(1000);
    if (run_write_until(trajectory, RUN_SAMPLES) != FW_SYSTEM_FAILED) return 4;
    if (!strstr(error.sentence, "File too large")) return 5;
    if (fw_trajectory_sync(trajectory, &error) != FW_SYSTEM_FAILED) return 6;
    if (fw_trajectory_finish(trajectory, "failed", &error) != FW_SYSTEM_FAILED) return 7;
    if (!strstr(error.sentence, "File too large")) return 8;
    fw_trajectory_destroy(trajectory);
    return 0;
}

static void full_disk_while_writing_keeps_what_was_committed(void **state)
{
    (void)state;
    char folder[64];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    fw_trajectory_def def = run_def(folder);
    int status;
    pid_t writer = fork();
    if (writer == 0) _exit(write_on_a_full_disk(folder));
    waitpid(writer, &status, 0);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
    assert_frames(folder, 11, FW_RUN_RUNNING);
    /* With room again the run goes on. */
    assert_fine(fw_trajectory_reopen(&trajectory, &def, 11, 71, &error));
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    assert_frames(folder, RUN_FRAMES, FW_RUN_FINISHED);
    remove_folder(folder);
}

/* The copy of the head needs room; where there is none the file is not cut, and stays whole. */
static void full_disk_while_closing_keeps_the_file(void **state)
{
    (void)state;
    char folder[64];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    fw_trajectory_def def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, 71));
    assert_fine(fw_trajectory_sync(trajectory, &error));
    char copy[128];
    snprintf(copy, sizeof copy, "%s/trajectory.h5.cutting.new", folder);
    assert_int_equal(mkdir(copy, 0777), 0);
    assert_refused(fw_trajectory_finish(trajectory, "interrupted", &error), FW_SYSTEM_FAILED,
                   "cannot write");
    fw_trajectory_destroy(trajectory);
    assert_frames(folder, 11, "interrupted");
    assert_int_equal(rmdir(copy), 0);
    assert_fine(fw_trajectory_reopen(&trajectory, &def, 11, 71, &error));
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    assert_frames(folder, RUN_FRAMES, FW_RUN_FINISHED);
    remove_folder(folder);
}

/* A disk of 1 MiB: a run that would not fit does not start; one that is cut and cannot have its
 * room back is left as it was until there is room. */
static void small_disk_fills_before_the_run_and_not_in_it(void **state)
{
    (void)state;
    char folder[64], filler[128], command[256];
    fw_trajectory *trajectory;
    make_folder(folder, sizeof folder);
    if (mount("none", folder, "tmpfs", 0, "size=1m") != 0) {
        remove_folder(folder);
        skip();
    }
    fw_trajectory_def def = run_def(folder);
    def.frame_count = 4000;
    assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_SYSTEM_FAILED,
                   "no room for");
    assert_entries(folder, 0);
    def = run_def(folder);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    snprintf(filler, sizeof filler, "%s/filler", folder);
    snprintf(command, sizeof command, "cat /dev/zero > %s 2>/dev/null", filler);
    assert_int_not_equal(system(command), 0);
    assert_fine(run_write_until(trajectory, 71)); /* its room was taken in advance */
    assert_refused(fw_trajectory_finish(trajectory, "failed", &error), FW_SYSTEM_FAILED,
                   "No space left");
    fw_trajectory_destroy(trajectory);
    assert_frames(folder, 11, "failed");

    assert_int_equal(unlink(filler), 0);
    assert_fine(fw_trajectory_reopen(&trajectory, &def, 11, 71, &error));
    assert_fine(fw_trajectory_finish(trajectory, "interrupted", &error));
    fw_trajectory_destroy(trajectory);
    assert_int_not_equal(system(command), 0);
    for (int attempt = 0; attempt < 2; ++attempt) {
        assert_refused(fw_trajectory_reopen(&trajectory, &def, 11, 71, &error), FW_SYSTEM_FAILED,
                       "No space left");
        assert_frames(folder, 11, "interrupted");
    }
    assert_int_equal(unlink(filler), 0);
    assert_fine(fw_trajectory_reopen(&trajectory, &def, 11, 71, &error));
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    assert_frames(folder, RUN_FRAMES, FW_RUN_FINISHED);
    assert_int_equal(umount2(folder, MNT_DETACH), 0); /* the file that found no room is open */
    remove_folder(folder);
}

static void names_that_cannot_be_stored_are_refused(void **state)
{
    (void)state;
    fw_trajectory *trajectory;
    static const struct {
        const char *field, *observable, *words;
    } names[] = {
        {"a/b", "energy", "field 'a/b'"},  {"", "energy", "field ''"},
        {"strain", ".", "observable '.'"}, {"velocity", "energy", "named 'velocity'"},
        {"strain", "", "observable ''"},   {"strain", "left/right", "observable 'left/right'"},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        fw_trajectory_def def = run_def("/tmp/fretwork-never-made");
        fw_trajectory_field field = {names[i].field, "1", "a field"};
        fw_observable observable = {names[i].observable, "1", "an observable", 1};
        def.fields = &field;
        def.observables = &observable;
        def.field_count = def.observable_count = 1;
        assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_BAD_INPUT,
                       names[i].words);
    }
    fw_trajectory_def def = run_def("/tmp/fretwork-never-made");
    fw_observable twice[] = {{"energy", "1", "one", 1}, {"energy", "1", "another", 1}};
    def.observables = twice;
    assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_BAD_INPUT,
                   "two observables");
    fw_trajectory_body many = {"dust", 200000000, NULL, NULL, 0};
    def = run_def("/tmp/fretwork-never-made");
    def.bodies = &many;
    def.body_count = 1;
    assert_refused(fw_trajectory_create(&trajectory, &def, &error), FW_BAD_INPUT, "200000000");
    assert_int_equal(access(def.directory, F_OK), -1);
}

static void foreign_files_are_refused(void **state)
{
    (void)state;
    char folder[64], command[512], path[128];
    fw_playback *playback;
    make_folder(folder, sizeof folder);
    assert_refused(fw_playback_open(&playback, "/tmp/fretwork-no-such", &error), FW_BAD_INPUT,
                   "No such file");
    assert_refused(fw_playback_open(&playback, folder, &error), FW_BAD_INPUT, "No such file");
    record(folder, RUN_SAMPLES, FW_RUN_FINISHED);
    snprintf(path, sizeof path, "%s/text", folder);
    snprintf(command, sizeof command, "echo position 1 2 > %s", path);
    assert_int_equal(system(command), 0);
    assert_refused(fw_playback_open(&playback, path, &error), FW_BAD_INPUT, "not a whole HDF5");
    snprintf(command, sizeof command, ": > %s", path);
    assert_int_equal(system(command), 0);
    assert_refused(fw_playback_open(&playback, path, &error), FW_BAD_INPUT, "not a whole HDF5");
    for (int length = 1; length < 300000; length = 2 * length + 7) {
        snprintf(command, sizeof command, "head -c %d %s/trajectory.h5 > %s", length, folder, path);
        assert_int_equal(system(command), 0);
        assert_refused(fw_playback_open(&playback, path, &error), FW_BAD_INPUT, "not a whole HDF5");
    }
    fw_hdf5 *hdf5;
    assert_fine(fw_hdf5_create(&hdf5, path, 4096, &error));
    assert_fine(fw_hdf5_close(hdf5, &error));
    assert_refused(fw_playback_open(&playback, path, &error), FW_BAD_INPUT, "h5md/creator");

    snprintf(command, sizeof command, "%s/trajectory.h5 %s", folder, folder);
    if (run_python("foreign_files.py", command) != 0) {
        remove_folder(folder);
        skip();
    }
    int count = 0;
    DIR *entries = opendir(folder);
    assert_non_null(entries);
    for (struct dirent *entry = readdir(entries); entry; entry = readdir(entries)) {
        size_t length = strlen(entry->d_name);
        if (length < 4 || strcmp(entry->d_name + length - 3, ".h5") != 0 ||
            strcmp(entry->d_name, "trajectory.h5") == 0)
            continue;
        snprintf(path, sizeof path, "%s/%.60s", folder, entry->d_name);
        error = (fw_error){0};
        fw_status status = fw_playback_open(&playback, path, &error);
        const char *words =
            strstr(entry->d_name, "no-seal") ? "has no seal" : "missing or not as expected";
        if (status != FW_BAD_INPUT || !strstr(error.sentence, words))
            fail_msg("%s: status %d, '%s'", entry->d_name, status, error.sentence);
        ++count;
    }
    closedir(entries);
    assert_true(count > 30);
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(earlier_result_is_only_replaced_when_asked_for),
        cmocka_unit_test(folders_are_made_and_unmade),
        cmocka_unit_test(folder_without_permission_is_refused),
        cmocka_unit_test(second_writer_is_refused_and_readers_are_not),
        cmocka_unit_test(full_disk_while_writing_keeps_what_was_committed),
        cmocka_unit_test(full_disk_while_closing_keeps_the_file),
        cmocka_unit_test(small_disk_fills_before_the_run_and_not_in_it),
        cmocka_unit_test(names_that_cannot_be_stored_are_refused),
        cmocka_unit_test(foreign_files_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
