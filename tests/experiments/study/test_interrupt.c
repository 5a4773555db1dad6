/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_interrupt.c - what the first and what a second signal does, in a process of its own. */
#include "tests/support/laws.h"

#include "experiments/study/interrupt.h"
#include "tests/support/program.h"

typedef void (*life)(void);

/* How a child ends that lives so: its exit code, or minus the signal. */
static int end_of(life lives)
{
    int status;
    fflush(NULL);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        lives();
        _exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

static void note_one(void)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    static const fw_status wanted[] = {FW_INTERRUPTED, FW_TERMINATED, FW_HUNG_UP};
    for (int n = 0; n < 3; ++n) {
        fw_interrupt_watch();
        if (fw_interrupt_seen() != FW_OK) _exit(1);
        raise(signals[n]);
        if (fw_interrupt_seen() != wanted[n] || !fw_interrupt_is(wanted[n])) _exit(2);
    }
}

/* A shell that goes may send the same again at once. */
static void note_twice_at_once(void)
{
    fw_interrupt_watch();
    raise(SIGHUP);
    raise(SIGHUP);
    raise(SIGTERM);
    if (fw_interrupt_seen() != FW_HUNG_UP) _exit(1);
}

static void note_twice(void)
{
    fw_interrupt_watch();
    raise(SIGINT);
    usleep(700000);
    raise(SIGTERM);
}

static void note_twice_in_a_checkpoint(void)
{
    fw_interrupt_watch();
    raise(SIGINT);
    usleep(700000);
    fw_interrupt_hold();
    raise(SIGINT);
    if (write(STDERR_FILENO, "", 0) != 0) _exit(1); /* still here */
    fw_interrupt_release();
    _exit(3);
}

static void leave(void)
{
    fw_interrupt_watch();
    fw_interrupt_watch();
    fw_interrupt_leave();
    raise(SIGINT);
}

static void keep_ignoring(void)
{
    signal(SIGHUP, SIG_IGN);
    fw_interrupt_watch();
    raise(SIGHUP);
    if (fw_interrupt_seen() != FW_OK) _exit(1);
    fw_interrupt_leave();
    raise(SIGHUP);
}

static void first_signal_is_noted_and_a_second_ends(void **state)
{
    (void)state;
    assert_int_equal(end_of(note_one), 0);
    assert_int_equal(end_of(note_twice_at_once), 0);
    assert_int_equal(end_of(note_twice), -SIGTERM);
    assert_int_equal(end_of(note_twice_in_a_checkpoint), -SIGINT);
    assert_int_equal(end_of(leave), -SIGINT);
    assert_int_equal(end_of(keep_ignoring), 0);
}

/* As nohup and shells in the background start it. */
static void ignored_signals_stay_ignored(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    shell(folder,
          "trap '' HUP INT; '" FW_PROGRAM "' run wall-bounce -q --no-plot --set run.steps=8000 "
          "--set run.checkpoint-every=20 --set expect=[] -o it > out 2> err & "
          "n=0; while [ ! -e it/checkpoint-B ] && [ $n -lt 600 ]; do sleep 0.05; n=$((n+1)); done; "
          "kill -HUP $!; kill -INT $!; wait $! && test ! -s err && grep -q results: out");
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(first_signal_is_noted_and_a_second_ends),
        cmocka_unit_test(ignored_signals_stay_ignored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
