/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_storage_files.c - what lies where a file of ours should be: links, pipes, folders, files
 * that killed processes left, lists of files that are none. */
#include "tests/support/laws.h"

#include "experiments/storage/claim.h"
#include "experiments/storage/csv.h"
#include "experiments/storage/folder.h"
#include "experiments/storage/manifest.h"
#include "experiments/storage/regular_file.h"
#include "experiments/storage/sealed_file.h"
#include "experiments/storage/whole_file.h"
#include "tests/support/program.h"

#include <sys/file.h>

static char folder[64];

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

static const char *in(const char *name)
{
    static char path[4][160];
    static int next;
    char *made = path[next++ % 4];
    snprintf(made, sizeof path[0], "%s/%s", folder, name);
    return made;
}

static void expect_content(const char *name, const char *text)
{
    char *bytes;
    size_t size;
    assert_fine(fw_regular_file_read(&bytes, &size, in(name), 1000, &error));
    assert_string_equal(bytes, text);
    free(bytes);
}

/* --- paths --- */

static void paths_that_are_too_long_are_refused(void **state)
{
    (void)state;
    static char name[FW_PATH_SIZE + 9], path[FW_PATH_SIZE];
    fw_folder *made;
    memset(name, 'x', FW_PATH_SIZE - 3);
    assert_fine(fw_path_join(path, "a", name, &error));
    assert_int_equal(strlen(path), FW_PATH_SIZE - 1);
    assert_refused(fw_path_join(path, "aa", name, &error), FW_BAD_INPUT,
                   "is longer than 4095 bytes");
    assert_refused(fw_path_beside(path, name, "-beside", &error), FW_BAD_INPUT, "the name 'xxx");
    assert_false(fw_folder_path_has("aa", name));
    fw_claim_tidy(name);
    assert_refused(fw_folder_create(&made, name, &error), FW_BAD_INPUT, "cannot make the folder");
    memset(name, 'x', sizeof name - 1);
    assert_refused(fw_folder_make(name, &error), FW_BAD_INPUT, "cannot make the folder");
    assert_refused(fw_folder_make("", &error), FW_BAD_INPUT, "the results folder has no name");
}

static void what_stands_beside_a_folder_has_its_real_name(void **state)
{
    (void)state;
    char path[FW_PATH_SIZE], before[FW_PATH_SIZE], wanted[FW_PATH_SIZE];
    shell(folder, "mkdir -p one/two");
    assert_fine(fw_path_beside(path, "results/bounce//", "-again", &error));
    assert_string_equal(path, "results/bounce-again");
    assert_fine(fw_path_beside(path, "/", "-again", &error));
    assert_string_equal(path, "/-again");
    assert_fine(fw_path_beside(path, "ab", "-again", &error));
    assert_string_equal(path, "ab-again");
    assert_non_null(getcwd(before, sizeof before));
    assert_int_equal(chdir(in("one/two")), 0);
    assert_fine(fw_path_beside(path, ".", "-again", &error));
    snprintf(wanted, sizeof wanted, "%s/one/two-again", folder);
    assert_string_equal(path, wanted);
    assert_fine(fw_path_beside(path, "../", "-again", &error));
    snprintf(wanted, sizeof wanted, "%s/one-again", folder);
    assert_string_equal(path, wanted);
    assert_refused(fw_path_beside(path, "nowhere/..", "-again", &error), FW_SYSTEM_FAILED,
                   "cannot find the folder nowhere/..: No such file");
    assert_int_equal(chdir(before), 0);
}

/* --- regular files --- */

static void what_is_no_file_is_not_opened(void **state)
{
    (void)state;
    int descriptor;
    char *bytes;
    size_t size;
    shell(folder, "echo word > file; ln -s file link; ln -s round round; mkdir inner; mkfifo pipe");
    assert_refused(fw_regular_file_open(&descriptor, in("link"), true, &error), FW_BAD_INPUT,
                   "link is a link, which is not written through");
    assert_fine(fw_regular_file_open(&descriptor, in("link"), false, &error));
    close(descriptor);
    assert_refused(fw_regular_file_open(&descriptor, in("inner"), true, &error), FW_BAD_INPUT,
                   "inner is not a file");
    assert_refused(fw_regular_file_open(&descriptor, in("inner"), false, &error), FW_BAD_INPUT,
                   "inner is not a file");
    assert_int_equal(descriptor, -1);
    assert_refused(fw_regular_file_open(&descriptor, in("pipe"), false, &error), FW_BAD_INPUT,
                   "pipe is not a file");
    assert_refused(fw_regular_file_open(&descriptor, in("round"), false, &error), FW_BAD_INPUT,
                   "cannot open");
    assert_refused(fw_regular_file_open(&descriptor, in("file/file"), false, &error), FW_BAD_INPUT,
                   "cannot open");
    assert_refused(fw_regular_file_create(&descriptor, in("inner"), &error), FW_SYSTEM_FAILED,
                   "cannot write");
    assert_refused(fw_regular_file_read(&bytes, &size, in("file"), 4, &error), FW_BAD_INPUT,
                   "file has 5 bytes, expected at most 4");
    assert_null(bytes);
    assert_fine(fw_regular_file_read(&bytes, &size, in("file"), 5, &error));
    assert_string_equal(bytes, "word\n");
    free(bytes);
    assert_refused(fw_path_check_inner(in("link"), &error), FW_BAD_INPUT,
                   "link is a link, expected a folder of results or nothing");
    assert_refused(fw_path_check_inner(in("file"), &error), FW_BAD_INPUT,
                   "file is no folder, expected a folder of results or nothing");
    assert_fine(fw_path_check_inner(in("inner"), &error));
    assert_fine(fw_path_check_inner(in("nothing"), &error));
}

/* A file of two names keeps its bytes under the other one; alone its space is given back at once,
 * even while somebody has it open. */
static void a_discarded_file_goes_with_its_space(void **state)
{
    (void)state;
    fw_folder *held;
    struct stat facts;
    shell(folder, "echo word > file; ln file twin; echo word > alone; mkdir inner");
    assert_fine(fw_folder_visit(&held, folder, &error));
    const int open_still = open(in("alone"), O_RDONLY | O_CLOEXEC);
    fw_folder_discard(held, "alone");
    assert_int_equal(fstat(open_still, &facts), 0);
    assert_int_equal(facts.st_size, 0);
    close(open_still);
    fw_folder_discard(held, "file");
    fw_folder_discard(held, "inner");
    fw_folder_discard(held, "nothing");
    assert_false(fw_folder_has(held, "alone") || fw_folder_has(held, "file"));
    assert_true(fw_folder_has(held, "inner"));
    expect_content("twin", "word\n");
    assert_refused(fw_folder_remove(held, "inner", &error), FW_SYSTEM_FAILED, "cannot remove");
    assert_fine(fw_folder_remove(held, "nothing", &error));
    assert_refused(fw_folder_replace(held, "nothing", "twin", &error), FW_SYSTEM_FAILED,
                   "twin: No such file");
    expect_content("twin", "word\n");
    fw_folder_close(held);
}

/* --- whole files --- */

/* The number of a process that is no more. */
static pid_t ended_process(void)
{
    const pid_t process = fork();
    if (process == 0) _exit(0);
    assert_int_equal(waitpid(process, NULL, 0), process);
    return process;
}

static void make_temporary(const char *number)
{
    char name[80];
    snprintf(name, sizeof name, "table.part-%s", number);
    FILE *out = fopen(in(name), "w");
    assert_non_null(out);
    fclose(out);
}

static bool has_temporary(const char *number)
{
    char name[80];
    snprintf(name, sizeof name, "table.part-%s", number);
    return exists(folder, name);
}

/* Only where nobody writes them any more: of a process that is gone, and unlocked. */
static void what_killed_writers_left_goes(void **state)
{
    (void)state;
    char dead[32], locked[32], inner[32], link[32], name[80], line[160];
    char odd[32];
    const char *const others[] = {"", "x", odd, "0", "-3", "1"};
    snprintf(odd, sizeof odd, "%ldx", (long)ended_process());
    snprintf(dead, sizeof dead, "%ld", (long)ended_process());
    snprintf(locked, sizeof locked, "%ld", (long)ended_process());
    snprintf(inner, sizeof inner, "%ld", (long)ended_process());
    snprintf(link, sizeof link, "%ld", (long)ended_process());
    for (size_t n = 0; n < sizeof others / sizeof *others; ++n) make_temporary(others[n]);
    make_temporary(dead);
    make_temporary(locked);
    snprintf(name, sizeof name, "table.part-%s", locked);
    const int lock = open(in(name), O_RDONLY | O_CLOEXEC);
    assert_int_equal(flock(lock, LOCK_EX | LOCK_NB), 0);
    snprintf(line, sizeof line, "mkdir table.part-%s; ln -s twin table.part-%s; echo 1 > tablet",
             inner, link);
    shell(folder, line);
    assert_fine(fw_whole_file_write(in("table"), "word", 4, &error));
    expect_content("table", "word");
    for (size_t n = 0; n < sizeof others / sizeof *others; ++n)
        if (!has_temporary(others[n])) fail_msg("table.part-%s is gone", others[n]);
    assert_false(has_temporary(dead));
    assert_true(has_temporary(locked));
    assert_true(has_temporary(inner));
    snprintf(line, sizeof line, "test -L table.part-%s", link);
    shell(folder, line);
    close(lock);
    /* Where nothing is in the way but an earlier one of this very process. */
    snprintf(dead, sizeof dead, "%ld", (long)getpid());
    make_temporary(dead);
    assert_fine(fw_whole_file_write(in("table"), "other", 5, &error));
    expect_content("table", "other");
    assert_false(has_temporary(dead) || has_temporary(locked));
}

static void a_whole_file_is_there_after_its_commit(void **state)
{
    (void)state;
    fw_whole_file *file;
    char *bytes;
    size_t size;
    for (int commit = 0; commit < 2; ++commit) {
        assert_fine(fw_whole_file_begin(&file, in("table"), &error));
        fputs("by and by", fw_whole_file_stream(file));
        fflush(fw_whole_file_stream(file));
        assert_false(exists(folder, "table"));
        assert_fine(fw_regular_file_read(&bytes, &size, fw_whole_file_place(file), 99, &error));
        assert_string_equal(bytes, "by and by");
        free(bytes);
        if (commit)
            assert_fine(fw_whole_file_commit(file, &error));
        else
            fw_whole_file_abandon(file);
        assert_int_equal(exists(folder, "table"), commit);
        shell(folder, "test -z \"$(ls | grep part)\"");
    }
    fw_whole_file_abandon(NULL);
    assert_refused(fw_whole_file_begin(&file, in("no/table"), &error), FW_SYSTEM_FAILED,
                   "No such file");
    assert_null(file);
    shell(folder, "mkdir inner");
    assert_refused(fw_whole_file_begin(&file, in("inner"), &error), FW_SYSTEM_FAILED,
                   "Is a directory");
}

/* A device that is always full, and a pipe that nobody reads. */
static void what_cannot_be_written_is_said(void **state)
{
    (void)state;
    fw_whole_file *file;
    shell(folder, "mkfifo pipe");
    assert_refused(fw_whole_file_write("/dev/full", "word", 4, &error), FW_SYSTEM_FAILED,
                   "cannot write '/dev/full' (4 bytes): No space left on device");
    assert_fine(fw_whole_file_begin(&file, "/dev/full", &error));
    assert_string_equal(fw_whole_file_place(file), "/dev/full");
    fputs("word", fw_whole_file_stream(file));
    assert_refused(fw_whole_file_commit(file, &error), FW_SYSTEM_FAILED,
                   "cannot write '/dev/full': No space left on device");
    assert_fine(fw_whole_file_begin(&file, "/dev/full", &error));
    fputs("word", fw_whole_file_stream(file));
    assert_int_equal(fflush(fw_whole_file_stream(file)), EOF); /* noticed before its end */
    assert_refused(fw_whole_file_commit(file, &error), FW_SYSTEM_FAILED, "cannot write");
    assert_fine(fw_whole_file_write("/dev/null", "word", 4, &error));
    assert_fine(fw_whole_file_begin(&file, "/dev/null", &error));
    fputs("word", fw_whole_file_stream(file));
    assert_fine(fw_whole_file_commit(file, &error));
    assert_refused(fw_whole_file_write(in("pipe"), "word", 4, &error), FW_SYSTEM_FAILED,
                   "No such device");
    /* Something else took the name meanwhile. */
    assert_fine(fw_whole_file_begin(&file, in("table"), &error));
    shell(folder, "mkdir -p table/inner");
    assert_refused(fw_whole_file_commit(file, &error), FW_SYSTEM_FAILED, "table'");
    shell(folder, "test -z \"$(ls | grep part)\"");
}

/* --- claims --- */

static void a_claim_of_a_killed_process_goes(void **state)
{
    (void)state;
    fw_claim *claim, *other;
    fw_claim_tidy(in("case"));
    assert_false(exists(folder, "case"));
    shell(folder, "mkdir case; echo left > case/" FW_CLAIM_FILE "; echo word > case/kept");
    fw_claim_tidy(in("case"));
    assert_false(exists(folder, "case/" FW_CLAIM_FILE));
    assert_true(exists(folder, "case/kept"));
    assert_fine(fw_claim_take(&claim, in("case"), &error));
    assert_non_null(claim);
    fw_claim_tidy(in("case"));
    assert_true(exists(folder, "case/" FW_CLAIM_FILE));
    assert_fine(fw_claim_take(&other, in("case"), &error));
    assert_null(other);
    fw_claim_release(claim);
    fw_claim_release(NULL);
    assert_false(exists(folder, "case/" FW_CLAIM_FILE));
    /* Who holds the folder needs no claim. */
    fw_folder *held;
    assert_fine(fw_folder_open(&held, in("case"), &error));
    assert_fine(fw_claim_take(&claim, in("case"), &error));
    assert_null(claim);
    fw_folder_close(held);
    shell(folder, "echo word > file");
    assert_refused(fw_claim_take(&claim, in("file"), &error), FW_SYSTEM_FAILED, "cannot make");
}

/* --- lists of files --- */

static void write_list(const char *kind, const void *bytes, size_t count)
{
    fw_folder *held;
    fw_sealed_file *file;
    assert_fine(fw_folder_visit(&held, folder, &error));
    assert_fine(fw_sealed_file_create(&file, held, "manifest", kind, count, &error));
    fw_sealed_file_write(file, bytes, count);
    assert_fine(fw_sealed_file_commit(file, &error));
    fw_folder_close(held);
}

static void files_are_known_by_their_bytes_and_name(void **state)
{
    (void)state;
    char *bytes;
    size_t size;
    assert_fine(fw_manifest_write(folder, "one", "word", 4, &error));
    assert_fine(fw_manifest_write(folder, "two", "world", 5, &error));
    assert_fine(fw_manifest_write(folder, "two", "world", 5, &error)); /* known by now */
    assert_fine(fw_manifest_check(folder, "one", &error));
    assert_fine(fw_manifest_read(&bytes, &size, folder, "two", &error));
    assert_string_equal(bytes, "world");
    free(bytes);
    shell(folder, "cp one three; printf wort > one");
    assert_refused(fw_manifest_check(folder, "one", &error), FW_BAD_INPUT,
                   "one is damaged or was changed");
    assert_refused(fw_manifest_check(folder, "three", &error), FW_BAD_INPUT,
                   "three is damaged or was changed");
    assert_fine(fw_manifest_enter(folder, "three", &error));
    assert_fine(fw_manifest_check(folder, "three", &error));
    assert_refused(fw_manifest_check(folder, "four", &error), FW_BAD_INPUT, "cannot open");
    shell(folder, "mkdir inner");
    assert_refused(fw_manifest_write(folder, "inner", "word", 4, &error), FW_BAD_INPUT,
                   "inner is not a file");
    assert_refused(fw_manifest_enter(folder, "inner", &error), FW_BAD_INPUT, "inner is not a file");
}

static void a_list_that_is_none_is_refused(void **state)
{
    (void)state;
    static const char bytes[512];
    assert_fine(fw_manifest_write(folder, "one", "word", 4, &error));
    write_list(FW_MANIFEST_KIND, bytes, 255);
    assert_refused(fw_manifest_check(folder, "one", &error), FW_BAD_INPUT, "is no list of files");
    assert_refused(fw_manifest_write(folder, "two", "word", 4, &error), FW_BAD_INPUT,
                   "is no list of files");
    assert_false(exists(folder, "two"));
    shell(folder, "head -c 20 manifest > short; mv short manifest");
    assert_refused(fw_manifest_check(folder, "one", &error), FW_BAD_INPUT, "manifest");
}

/* --- tables --- */

static void a_value_without_its_last_quote_is_read_to_the_end(void **state)
{
    (void)state;
    char line[] = "\"open,\"\"1", *value;
    assert_null(fw_csv_cut(line, &value));
    assert_string_equal(value, "open,\"1");
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)
    const struct CMUnitTest tests[] = {
        TEST(paths_that_are_too_long_are_refused),
        TEST(what_stands_beside_a_folder_has_its_real_name),
        TEST(what_is_no_file_is_not_opened),
        TEST(a_discarded_file_goes_with_its_space),
        TEST(what_killed_writers_left_goes),
        TEST(a_whole_file_is_there_after_its_commit),
        TEST(what_cannot_be_written_is_said),
        TEST(a_claim_of_a_killed_process_goes),
        TEST(files_are_known_by_their_bytes_and_name),
        TEST(a_list_that_is_none_is_refused),
        TEST(a_value_without_its_last_quote_is_read_to_the_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
