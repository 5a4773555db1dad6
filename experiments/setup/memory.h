/* SPDX-License-Identifier: GPL-3.0-or-later */
/* memory.h - what a scenario takes of memory before anything is built, and what there is: a system
 * that runs out of it kills the process without a word. */
#ifndef FW_MEMORY_H
#define FW_MEMORY_H

#include "experiments/scenario/scenario.h"

/* Bytes that a run takes at its height, writing included, as measured of each solid. */
double fw_memory_needed(const fw_scenario *scenario);

/* Bytes that this process may still take: what is free in the system, in its control groups, and
 * below the limits of its address space. INFINITY where nothing says. *limit, if not NULL, is which
 * of them is the least. */
double fw_memory_available(const char **limit);

/* FW_SYSTEM_FAILED where so many runs of it, side by side, take more than there is. */
fw_status fw_memory_check(const fw_scenario *scenario, int runs, fw_error *error);

#endif
