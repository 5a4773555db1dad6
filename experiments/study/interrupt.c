/* SPDX-License-Identifier: GPL-3.0-or-later */
/* interrupt.c - the only changeable global of the program: a signal handler has nowhere else to
 * leave its note. */
#include "experiments/study/interrupt.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t seen;

static void note(int signal_number)
{
    seen = signal_number;
}

void fw_interrupt_watch(void)
{
    struct sigaction action = {.sa_handler = note, .sa_flags = (int)SA_RESETHAND};
    sigemptyset(&action.sa_mask);
    seen = 0;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

fw_status fw_interrupt_seen(void)
{
    if (seen == SIGINT) return FW_INTERRUPTED;
    if (seen == SIGTERM) return FW_TERMINATED;
    return FW_OK;
}
