/* SPDX-License-Identifier: GPL-3.0-or-later */
/* random_scenarios.h - random scenarios within the schema, and what must hold of each: see
 * random_scenarios.py. */
#ifndef FW_RANDOM_SCENARIOS_H
#define FW_RANDOM_SCENARIOS_H

#include "tests/support/laws.h"
#include "tests/support/scratch.h"

/* For so many seconds, from that seed on. */
static inline void try_random_scenarios(int seconds, int seed)
{
    char folder[64], arguments[256];
    make_quick_folder(folder, sizeof folder);
    snprintf(arguments, sizeof arguments, "%s %s %d %d", FW_PROGRAM, folder, seconds, seed);
    const int status = run_python("random_scenarios.py", arguments);
    if (status > 0) fail_msg("failed: random_scenarios.py %s", arguments);
    remove_folder(folder);
    skip_unseen();
}

#endif
