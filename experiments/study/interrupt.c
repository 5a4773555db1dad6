/* SPDX-License-Identifier: GPL-3.0-or-later */
/* interrupt.c - signals that end a run at the next step.
 * State: the only changeable globals of the program, since a signal handler has nowhere else to
 * leave its note. Start reading at note(). */
#include "experiments/study/interrupt.h"

#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#include <time.h>

/* Nanoseconds within which another signal counts as the same. */
static const long long INSTANT = 500000000;

_Static_assert(ATOMIC_INT_LOCK_FREE == 2 && ATOMIC_LLONG_LOCK_FREE == 2,
               "a signal handler may touch atomic numbers only where they take no lock");

static const int watched[] = {SIGINT, SIGTERM, SIGHUP};
enum { WATCHED = sizeof watched / sizeof *watched };

static atomic_int seen;
static atomic_llong seen_at; /* nanoseconds */
static atomic_int held;      /* how many checkpoints are being written */
static atomic_int last;      /* the signal that will end the process, or 0 */
static struct sigaction before[WATCHED];

/* As if it had never been watched. */
static void end_by(int signal_number)
{
    const struct sigaction usual = {.sa_handler = SIG_DFL};
    sigset_t set;
    sigaction(signal_number, &usual, NULL);
    sigemptyset(&set);
    sigaddset(&set, signal_number);
    raise(signal_number);
    sigprocmask(SIG_UNBLOCK, &set, NULL);
}

static void note(int signal_number)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    const long long now = time.tv_sec * 1000000000LL + time.tv_nsec;
    int nothing = 0;
    /* Before `seen`: whoever finds a first signal finds its time, too. Several threads may come
     * here at once; only one of them is the first. */
    long long never = 0;
    atomic_compare_exchange_strong(&seen_at, &never, now);
    if (atomic_compare_exchange_strong(&seen, &nothing, signal_number)) return;
    if (now - atomic_load(&seen_at) < INSTANT) return;
    atomic_store(&last, signal_number);
    if (atomic_load(&held) == 0) end_by(signal_number);
}

void fw_interrupt_watch(void)
{
    struct sigaction action = {.sa_handler = note, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (int n = 0; n < WATCHED; ++n) sigaddset(&action.sa_mask, watched[n]);
    atomic_store(&seen, 0);
    atomic_store(&seen_at, 0);
    atomic_store(&last, 0);
    for (int n = 0; n < WATCHED; ++n) {
        struct sigaction now;
        sigaction(watched[n], NULL, &now);
        if (now.sa_handler != note) before[n] = now;
        if (now.sa_handler != SIG_IGN) sigaction(watched[n], &action, NULL);
    }
}

void fw_interrupt_leave(void)
{
    for (int n = 0; n < WATCHED; ++n) sigaction(watched[n], &before[n], NULL);
}

void fw_interrupt_hold(void)
{
    atomic_fetch_add(&held, 1);
}

void fw_interrupt_release(void)
{
    if (atomic_fetch_sub(&held, 1) == 1 && atomic_load(&last) != 0) end_by(atomic_load(&last));
}

fw_status fw_interrupt_seen(void)
{
    const int number = atomic_load(&seen);
    if (number == SIGINT) return FW_INTERRUPTED;
    if (number == SIGTERM) return FW_TERMINATED;
    if (number == SIGHUP) return FW_HUNG_UP;
    return FW_OK;
}

bool fw_interrupt_is(fw_status status)
{
    return status == FW_INTERRUPTED || status == FW_TERMINATED || status == FW_HUNG_UP;
}
