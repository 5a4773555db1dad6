/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_results_refused_calls.c - a results file is made, cut where its run was interrupted, and
 * opened again, while the system refuses one call after the other, or does it by half: that is said
 * or done again, and the run can go on to the same file. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "tests/support/recorded_run.h"
#include "tests/support/refused_calls.h"

#include <errno.h>
#include <sys/wait.h>

enum { STOPPED = 100 }; /* samples of the run that is interrupted */

static char folder[64], result[80];
static fw_trajectory_def def;

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(result, sizeof result, "%s/run", folder);
    def = run_def(result);
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static const struct {
    refused_call kind;
    int reason;
    bool goes_on; /* such a call is done again */
} refusals[] = {
    {REFUSED_OPEN, EMFILE, false},   {REFUSED_FSTAT, EIO, false},
    {REFUSED_FSYNC, EIO, false},     {REFUSED_PREAD, EIO, false},
    {REFUSED_PREAD, EINTR, true},    {REFUSED_PREAD, BY_HALF, true},
    {REFUSED_PWRITE, ENOSPC, false}, {REFUSED_PWRITE, EINTR, true},
    {REFUSED_PWRITE, BY_HALF, true}, {REFUSED_PWRITE, NOTHING_MOVES, false},
    {REFUSED_FREAD, BY_HALF, false}, {REFUSED_FCLOSE, ENOSPC, false},
};
enum { REFUSALS = sizeof refusals / sizeof *refusals };

static fw_trajectory *trajectory;

static fw_status create(void)
{
    return fw_trajectory_create(&trajectory, &def, &error);
}

static fw_status interrupt(void)
{
    return fw_trajectory_finish(trajectory, "interrupted", &error);
}

static fw_status mend(void)
{
    return fw_trajectory_mend(result, &error);
}

static fw_status reopen(void)
{
    return fw_trajectory_reopen(&trajectory, &def, run_frames_at(STOPPED), STOPPED, &error);
}

/* What an attempt came to, as the exit code of its process. */
enum { REACHED = 1, REFUSED = 2, WRONG = 4 };

static int try_it(fw_status (*what)(void), int kind, int which)
{
    refuse_call(refusals[kind].kind, which, refusals[kind].reason);
    const fw_status status = what();
    const bool reached = call_was_refused();
    const bool said = status == error.status && strchr(error.sentence, ' ');
    if (status == FW_OK) return reached ? REACHED : 0;
    if (reached && !refusals[kind].goes_on && said) return REACHED | REFUSED;
    print_error("refusal %d, call %d: status %d: '%s'\n", kind, which, (int)status, error.sentence);
    return WRONG;
}

/* exit() writes counters of coverage; where leaks are looked for it would do that in each process,
 * and find those of threads that the process does not have. */
static _Noreturn void leave(int code)
{
#ifdef __has_feature
#if __has_feature(address_sanitizer)
    _exit(code);
#endif
#endif
    exit(code);
}

/* Lets call number `which` fail, in a process of its own: HDF5 keeps a file open that it could not
 * write, and the same process must not open it again. `before` is done first, with all calls as
 * they are; `after`, which may be NULL, where the attempt succeeds. Returns whether it was refused;
 * *reached: there was such a call. */
static bool attempt(fw_status (*before)(void), fw_status (*what)(void),
                    void (*after)(fw_trajectory *), int kind, int which, bool *reached)
{
    int code;
    error = (fw_error){0};
    fflush(NULL);
    const pid_t process = fork();
    assert_true(process >= 0);
    if (process == 0) {
        if (before && before() != FW_OK) leave(WRONG);
        const int came_to = try_it(what, kind, which);
        if (after && !(came_to & (REFUSED | WRONG))) after(trajectory);
        leave(came_to);
    }
    assert_int_equal(waitpid(process, &code, 0), process);
    if (!WIFEXITED(code) || WEXITSTATUS(code) & WRONG)
        fail_msg("refusal %d, call %d: ends with %#x", kind, which, code);
    *reached = WEXITSTATUS(code) & REACHED;
    return WEXITSTATUS(code) & REFUSED;
}

/* The whole run is there. */
static void expect_whole(void)
{
    fw_playback *playback;
    double x[RUN_PARTICLES], y[RUN_PARTICLES], energy[RUN_SAMPLES];
    assert_fine(fw_playback_open(&playback, result, &error));
    assert_int_equal(playback->frame_count, RUN_FRAMES);
    assert_int_equal(playback->sample_count, RUN_SAMPLES);
    assert_string_equal(playback->exit_reason, FW_RUN_FINISHED);
    for (int frame = 0; frame < RUN_FRAMES; ++frame) {
        assert_fine(fw_playback_read_positions(playback, frame, x, y, &error));
        assert_true(x[3] == run_value(0, frame, 3, 0) && y[7] == run_value(0, frame, 7, 1));
    }
    assert_fine(fw_playback_read_observable(playback, 0, energy, &error));
    for (int k = 0; k < RUN_SAMPLES; ++k) assert_true(energy[k] == run_value(5, k, 0, 0));
    fw_playback_close(playback);
}

/* From an interrupted run, or one that counts as killed, to its end. */
static void go_on(void)
{
    assert_fine(mend());
    assert_fine(reopen());
    assert_fine(run_write_until(trajectory, RUN_SAMPLES));
    assert_fine(fw_trajectory_finish(trajectory, FW_RUN_FINISHED, &error));
    fw_trajectory_destroy(trajectory);
    expect_whole();
}

static fw_status record_part(void)
{
    def.overwrite = true;
    FW_TRY(create());
    return run_write_until(trajectory, STOPPED);
}

static void leave_interrupted(void)
{
    assert_fine(record_part());
    assert_fine(interrupt());
    fw_trajectory_destroy(trajectory);
}

static void a_file_is_made_whole_or_not_at_all(void **state)
{
    (void)state;
    int refused = 0;
    bool reached = true;
    for (int kind = 0; kind < REFUSALS; ++kind)
        for (int which = 1; which == 1 || reached; ++which) {
            refused += attempt(NULL, create, fw_trajectory_abandon, kind, which, &reached);
            if (access(result, F_OK) == 0)
                fail_msg("refusal %d, call %d: something is left", kind, which);
        }
    print_message("%d calls refused\n", refused);
    assert_true(refused >= 5);
}

static void a_file_that_is_cut_can_be_gone_on_with(void **state)
{
    (void)state;
    int refused = 0;
    bool reached = true;
    for (int kind = 0; kind < REFUSALS; ++kind)
        for (int which = 1; which == 1 || reached; ++which) {
            refused +=
                attempt(record_part, interrupt, fw_trajectory_destroy, kind, which, &reached);
            go_on();
        }
    print_message("%d calls refused\n", refused);
    assert_true(refused >= 5);
}

/* Of a run that was killed in the midst of cutting: its copy is there under its first name. */
static void tear(void)
{
    char command[256];
    snprintf(command, sizeof command,
             "cd %s && mv trajectory.h5.head trajectory.h5.cutting && printf torn | dd "
             "of=trajectory.h5 conv=notrunc 2>/dev/null",
             result);
    assert_int_equal(system(command), 0);
}

static void a_file_is_put_right_or_stays_torn(void **state)
{
    (void)state;
    int refused = 0;
    bool reached = true;
    for (int kind = 0; kind < REFUSALS; ++kind)
        for (int which = 1; which == 1 || reached; ++which) {
            leave_interrupted();
            tear();
            refused += attempt(NULL, mend, NULL, kind, which, &reached);
            go_on();
        }
    print_message("%d calls refused\n", refused);
    assert_true(refused >= 5);
}

static void a_file_is_opened_again_or_stays_as_it_was(void **state)
{
    (void)state;
    int refused = 0;
    bool reached = true;
    for (int kind = 0; kind < REFUSALS; ++kind)
        for (int which = 1; which == 1 || reached; ++which) {
            leave_interrupted();
            refused += attempt(NULL, reopen, fw_trajectory_destroy, kind, which, &reached);
            go_on();
        }
    print_message("%d calls refused\n", refused);
    assert_true(refused >= 5);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)
    const struct CMUnitTest tests[] = {
        TEST(a_file_is_made_whole_or_not_at_all),
        TEST(a_file_that_is_cut_can_be_gone_on_with),
        TEST(a_file_is_put_right_or_stays_torn),
        TEST(a_file_is_opened_again_or_stays_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
