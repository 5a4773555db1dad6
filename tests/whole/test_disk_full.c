/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_disk_full.c - a run that finds no room, or a folder that it may not write to, says so in one
 * sentence, harms nothing, and goes on once there is room: on a real file system of a few MiB where
 * this process may mount one, and under a limit on the size of files everywhere. */
#define _GNU_SOURCE /* unshare, prlimit */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "tests/support/program.h"

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>

#define BOUNCE                                                                                     \
    "run wall-bounce --quiet --no-plot --set run.steps=20000 --set run.record-every=400 "          \
    "--set run.measure-every=50 --set run.checkpoint-every=20 --set expect=[] -o "

static void write_text(const char *path, const char *text)
{
    int file = open(path, O_WRONLY);
    if (file < 0) return;
    if (write(file, text, strlen(text)) < 0) print_message("%s: not written\n", path);
    close(file);
}

/* A file system of 4 MiB at `folder`, which only this process and its children see; false where
 * the system forbids it. */
static bool mount_small(const char *folder)
{
    static bool apart = false;
    if (!apart) {
        char map[64];
        uid_t user = getuid();
        gid_t group = getgid();
        if (unshare(user == 0 ? CLONE_NEWNS : CLONE_NEWNS | CLONE_NEWUSER) != 0) return false;
        if (user != 0) {
            snprintf(map, sizeof map, "0 %u 1", (unsigned)user);
            write_text("/proc/self/uid_map", map);
            write_text("/proc/self/setgroups", "deny");
            snprintf(map, sizeof map, "0 %u 1", (unsigned)group);
            write_text("/proc/self/gid_map", map);
        }
        if (mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0) return false;
        apart = true;
    }
    return mount("tmpfs", folder, "tmpfs", 0, "size=4m") == 0;
}

/* One sentence on one line, with these words. */
static void expect_sentence(const outcome *seen, int code, const char *words)
{
    expect_end(seen, code, words);
    const char *line_end = strchr(seen->err, '\n');
    assert_true(strncmp(seen->err, "fretwork: ", 10) == 0);
    assert_true(line_end && line_end[1] == '\0');
}

/* Takes what is free of the small disk; what a checkpoint takes while it is written is free again
 * afterwards, so this is to be repeated. */
static void fill_disk(const char *folder)
{
    char path[128];
    static const char zeroes[1024];
    snprintf(path, sizeof path, "%s/small/filler", folder);
    int filler = open(path, O_WRONLY | O_CREAT | O_APPEND, 0666);
    if (filler < 0) return; /* not even its name has room any more */
    while (write(filler, zeroes, sizeof zeroes) > 0) continue;
    close(filler);
}

static outcome await_end_without_room(const char *folder, running program)
{
    siginfo_t end = {0};
    while (end.si_pid == 0) {
        fill_disk(folder);
        usleep(1000);
        assert_int_equal(waitid(P_PID, (id_t)program.process, &end, WEXITED | WNOHANG | WNOWAIT),
                         0);
    }
    return await_program(program);
}

/* The same everywhere: from some moment on no file may grow beyond some hundred bytes. */
static void files_that_may_not_grow(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, BOUNCE "whole");
    expect_end(&seen, 0, "");
    running run = start_program(folder, BOUNCE "part");
    await_file(folder, "part/checkpoint-B");
    const struct rlimit small = {500, 500};
    assert_int_equal(prlimit(run.process, RLIMIT_FSIZE, &small, NULL), 0);
    seen = await_program(run);
    expect_sentence(&seen, 4, "File too large");
    assert_true(exists(folder, "part/checkpoint-A") && exists(folder, "part/checkpoint-B"));
    seen = run_program(folder, "resume part --quiet --no-plot");
    expect_end(&seen, 0, "");
    expect_same_results(folder, "whole", "part");
    remove_folder(folder);
    skip_unseen();
}

static void folder_that_may_not_be_written_to(void **state)
{
    enum { NOBODY = 65534 };
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    uid_t user = getuid() == 0 ? NOBODY : 0;
    running run = start_program(folder, BOUNCE "part");
    await_file(folder, "part/checkpoint-B");
    kill(run.process, SIGTERM);
    outcome seen = await_program(run);
    expect_end(&seen, 143, "interrupted");
    shell(folder, "mkdir locked && chmod 555 . locked part && chmod 444 part/*");
    static const struct {
        const char *line, *words;
    } cases[] = {
        {BOUNCE "locked", "cannot write into the folder locked: Permission denied"},
        {BOUNCE "locked/inner", "cannot make the folder locked/inner: Permission denied"},
        {BOUNCE "part --overwrite", "cannot write into the folder part: Permission denied"},
        {"resume part --quiet", "cannot open part/trajectory.h5: Permission denied"},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        seen = await_program(start_program_as(folder, cases[n].line, user));
        expect_sentence(&seen, 4, cases[n].words);
    }
    shell(folder, "chmod 000 part/checkpoint-?");
    seen = await_program(start_program_as(folder, "resume part --quiet", user));
    expect_sentence(&seen, 4, "cannot open part/checkpoint-A: Permission denied");
    /* None of this has changed anything. */
    shell(folder, "chmod 755 . part && chmod 644 part/*");
    seen = run_program(folder, "resume part --quiet --no-plot");
    expect_end(&seen, 0, "");
    seen = run_program(folder, BOUNCE "whole");
    expect_end(&seen, 0, "");
    expect_same_results(folder, "whole", "part");
    remove_folder(folder);
    skip_unseen();
}

static void disk_filled_while_a_run_writes(void **state)
{
    char folder[64], small[128];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(small, sizeof small, "%s/small", folder);
    assert_int_equal(mkdir(small, 0777), 0);
    if (!mount_small(small)) {
        remove_folder(folder);
        print_message("no file system may be mounted here: not tested\n");
        skip();
    }
    running run = start_program(folder, BOUNCE "small/part");
    await_file(folder, "small/part/checkpoint-B");
    outcome seen = await_end_without_room(folder, run);
    expect_sentence(&seen, 4, "No space left on device");
    assert_non_null(strstr(seen.err, "cannot write small/part/checkpoint-"));
    /* Both checkpoints are whole, and no attempt is left over. */
    shell(folder, "test \"$(ls small/part)\" = \"$(printf 'checkpoint-A\\ncheckpoint-B\\n"
                  "trajectory.h5')\"");
    fw_playback *playback;
    snprintf(small, sizeof small, "%s/small/part", folder);
    assert_fine(fw_playback_open(&playback, small, &error));
    assert_true(playback->frame_count >= 1);
    assert_non_null(strstr(playback->exit_reason, "No space left on device"));
    fw_playback_close(playback);
    /* As long as there is no room, nothing gets worse. */
    seen = run_program(folder, "resume small/part --quiet --no-plot");
    expect_sentence(&seen, 4, "No space left on device");
    shell(folder, "rm small/filler");
    seen = run_program(folder, "resume small/part --quiet --no-plot");
    expect_end(&seen, 0, "");
    seen = run_program(folder, BOUNCE "whole");
    expect_end(&seen, 0, "");
    expect_same_results(folder, "whole", "small/part");

    /* Without room for the results from the start nothing is left behind. */
    shell(folder, "rm -r small/part");
    fill_disk(folder);
    seen = run_program(folder, BOUNCE "small/part");
    expect_sentence(&seen, 4, "no room for small/part/trajectory.h5, which takes ");
    assert_non_null(strstr(seen.err, " MB: 0 MB are free"));
    assert_false(exists(folder, "small/part"));
    shell(folder, "rm small/filler");
    seen = run_program(folder, BOUNCE "small/part --set run.steps=1000000000");
    expect_sentence(&seen, 4, "no room for small/part/trajectory.h5");
    assert_false(exists(folder, "small/part"));
    snprintf(small, sizeof small, "%s/small", folder);
    assert_int_equal(umount(small), 0);
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    /* The last one leaves this process in a place of its own. */
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_that_may_not_grow),
        cmocka_unit_test(folder_that_may_not_be_written_to),
        cmocka_unit_test(disk_filled_while_a_run_writes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
