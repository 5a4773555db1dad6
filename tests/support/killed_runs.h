/* SPDX-License-Identifier: GPL-3.0-or-later */
/* killed_runs.h - runs of the program that are killed at random moments: see killed_runs.py. */
#ifndef FW_KILLED_RUNS_H
#define FW_KILLED_RUNS_H

#include "tests/support/laws.h"
#include "tests/support/scratch.h"

/* So many runs; moments are drawn from the seed. */
static inline void kill_runs(int count, int seed)
{
    char folder[64], arguments[256];
    make_quick_folder(folder, sizeof folder);
    snprintf(arguments, sizeof arguments, "%s %s %d %d", FW_PROGRAM, folder, count, seed);
    const int status = run_python("killed_runs.py", arguments);
    if (status > 0) fail_msg("failed: killed_runs.py %s", arguments);
    remove_folder(folder);
    skip_unseen();
}

#endif
