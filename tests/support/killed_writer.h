/* SPDX-License-Identifier: GPL-3.0-or-later */
/* killed_writer.h - writers of results files that are killed at random moments, be it in creating,
 * writing, closing or resuming; and what must be true of the file then, whichever it was. */
#ifndef FW_KILLED_WRITER_H
#define FW_KILLED_WRITER_H

#include "experiments/results/playback.h"
#include "tests/support/recorded_run.h"

#include <signal.h>
#include <sys/wait.h>

enum {
    INTERRUPTED_AT = 160,
    RESUMED_FROM = 120,
    CHECKPOINT_EVERY = 40,
    LONGEST_LIFE = 200000, /* microseconds; some cycles of a writer */
    FILES_PER_CHECK = 50
};

static void write_with_checkpoints(fw_trajectory *trajectory, int64_t end)
{
    while (fw_trajectory_sample_count(trajectory) < end) {
        int64_t next = fw_trajectory_sample_count(trajectory) + CHECKPOINT_EVERY;
        if (run_write_until(trajectory, next < end ? next : end) != FW_OK) _exit(1);
        if (fw_trajectory_sync(trajectory, &error) != FW_OK) _exit(2);
    }
}

/* Creates, writes, interrupts, resumes and finishes the run, over and over. */
static void write_until_killed(const char *folder)
{
    fw_trajectory_def def = run_def(folder);
    def.overwrite = true;
    for (;;) {
        fw_trajectory *trajectory;
        if (fw_trajectory_create(&trajectory, &def, &error) != FW_OK) _exit(3);
        write_with_checkpoints(trajectory, INTERRUPTED_AT);
        if (fw_trajectory_finish(trajectory, "interrupted", &error) != FW_OK) _exit(4);
        fw_trajectory_destroy(trajectory);
        if (fw_trajectory_reopen(&trajectory, &def, run_frames_at(RESUMED_FROM), RESUMED_FROM,
                                 &error) != FW_OK)
            _exit(5);
        write_with_checkpoints(trajectory, RUN_SAMPLES);
        if (fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error) != FW_OK) _exit(6);
        fw_trajectory_destroy(trajectory);
    }
}

/* Cuts its file and puts the room for more rows back, over and over: hardly anything else. */
static void cut_until_killed(const char *folder)
{
    fw_trajectory_def def = run_def(folder);
    fw_trajectory *trajectory;
    if (fw_trajectory_create(&trajectory, &def, &error) != FW_OK) _exit(3);
    write_with_checkpoints(trajectory, INTERRUPTED_AT);
    for (;;) {
        if (fw_trajectory_finish(trajectory, "interrupted", &error) != FW_OK) _exit(4);
        fw_trajectory_destroy(trajectory);
        if (fw_trajectory_reopen(&trajectory, &def, run_frames_at(INTERRUPTED_AT), INTERRUPTED_AT,
                                 &error) != FW_OK)
            _exit(5);
    }
}

typedef struct casualties {
    int unborn, torn, running, interrupted, finished; /* in which state the file was found */
    int64_t frames;                                   /* committed in all of them */
} casualties;

/* Samples to go on from, with as many frames as go with them: what the last checkpoint of a run
 * would say that has committed so much. */
static int64_t last_checkpoint(int64_t frames, int64_t samples)
{
    while (run_frames_at(samples) > frames) --samples;
    return samples;
}

/* Looks at what a killed writer has left, and brings its run to its end. */
static void bury(const char *folder, const char *graves, int number, casualties *count)
{
    char command[512];
    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(folder);
    int64_t samples = RESUMED_FROM;
    snprintf(command, sizeof command, "%s/trajectory.h5", folder);
    bool born = access(command, F_OK) == 0;
    snprintf(command, sizeof command, "%s/trajectory.h5.cutting", folder);
    bool torn = access(command, F_OK) == 0;
    bool finished = false;
    if (born) {
        snprintf(command, sizeof command, "cp %s/trajectory.h5 %s/%s-%d.h5", folder, graves,
                 torn ? "torn" : "killed", number);
        assert_int_equal(system(command), 0);
    }
    if (born && !torn) {
        fw_playback *playback;
        assert_fine(fw_playback_open(&playback, folder, &error));
        finished = strcmp(playback->exit_reason, FW_RUN_FINISHED) == 0;
        count->finished += finished;
        count->interrupted += strcmp(playback->exit_reason, "interrupted") == 0;
        count->running += strcmp(playback->exit_reason, FW_RUN_RUNNING) == 0;
        count->frames += playback->frame_count;
        samples = last_checkpoint(playback->frame_count, playback->sample_count);
        fw_playback_close(playback);
    }
    count->unborn += !born;
    count->torn += torn;
    if (finished) {
        assert_refused(fw_trajectory_reopen(&trajectory, &def, 0, 0, &error), FW_BAD_INPUT,
                       "finished");
    } else {
        if (born)
            assert_fine(
                fw_trajectory_reopen(&trajectory, &def, run_frames_at(samples), samples, &error));
        else
            assert_fine(fw_trajectory_create(&trajectory, &def, &error));
        assert_fine(run_write_until(trajectory, RUN_SAMPLES));
        assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
        fw_trajectory_destroy(trajectory);
    }
    snprintf(command, sizeof command, "mv %s/trajectory.h5 %s/resumed-%d.h5", folder, graves,
             number);
    assert_int_equal(system(command), 0);
}

/* Committed rows of killed files are right, those of torn ones right or refused, and resumed runs
 * are the run that was never killed. */
static void check_graves(const char *graves)
{
    char arguments[256];
    snprintf(arguments, sizeof arguments, "rows %s/killed-*.h5", graves);
    int status = run_python("trajectory.py", arguments);
    if (status > 0) fail_msg("a committed row is wrong: trajectory.py %s", arguments);
    snprintf(arguments, sizeof arguments, "guarded %s/torn-*.h5", graves);
    if (status == 0) status = run_python("trajectory.py", arguments);
    if (status > 0) fail_msg("a torn file is misread: trajectory.py %s", arguments);
    snprintf(arguments, sizeof arguments, "same %s/whole/trajectory.h5 %s/resumed-*.h5", graves,
             graves);
    if (status == 0) status = run_python("trajectory.py", arguments);
    if (status > 0) fail_msg("a resumed run differs: trajectory.py %s", arguments);
    snprintf(arguments, sizeof arguments, "rm %s/*.h5", graves);
    assert_int_equal(system(arguments), 0);
}

/* Kills so many writers of a kind, and more, ten times as many at most, until there are enough of
 * those that were meant: how often a moment is hit depends on the disk. `seed` chooses the moments.
 */
static casualties kill_writers(void (*write)(const char *folder), int writers, uint64_t seed,
                               bool (*enough)(const casualties *count))
{
    casualties count = {0};
    char graves[64], whole[128];
    make_folder(graves, sizeof graves);
    snprintf(whole, sizeof whole, "%s/whole", graves);
    fw_trajectory *trajectory;
    fw_trajectory_def def = run_def(whole);
    assert_fine(fw_trajectory_create(&trajectory, &def, &error));
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    int number = 0;
    for (; number < writers || (number < 10 * writers && !enough(&count)); ++number) {
        char folder[64];
        int status;
        make_folder(folder, sizeof folder);
        pid_t writer = fork();
        assert_true(writer >= 0);
        if (writer == 0) write(folder);
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        usleep((useconds_t)((seed >> 33) % LONGEST_LIFE));
        kill(writer, SIGKILL);
        waitpid(writer, &status, 0);
        if (!WIFSIGNALED(status)) fail_msg("the writer failed in phase %d", WEXITSTATUS(status));
        bury(folder, graves, number, &count);
        remove_folder(folder);
        if (number % FILES_PER_CHECK == FILES_PER_CHECK - 1) check_graves(graves);
    }
    if (number % FILES_PER_CHECK != 0) check_graves(graves);
    remove_folder(graves);
    print_message("%d killed: %d before there was a file, %d while it was cut, %d running, "
                  "%d interrupted, %d finished; %lld frames\n",
                  number, count.unborn, count.torn, count.running, count.interrupted,
                  count.finished, (long long)count.frames);
    return count;
}

#endif
