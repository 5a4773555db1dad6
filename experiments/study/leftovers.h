/* SPDX-License-Identifier: GPL-3.0-or-later */
/* leftovers.h - what an earlier result would leave beside a new one in the same folder: its
 * pictures and tables, its control, the cases of its sweep. They are found before the new result
 * begins, and removed once it has begun. Only what the program itself makes is touched. */
#ifndef FW_LEFTOVERS_H
#define FW_LEFTOVERS_H

#include "experiments/scenario/scenario.h"

typedef struct fw_leftovers fw_leftovers;

/* Of the result in `directory`, if there is one, but for what the result of `fresh` replaces
 * itself. FW_SYSTEM_FAILED without memory. */
fw_status fw_leftovers_find(fw_leftovers **leftovers, const char *directory,
                            const fw_scenario *fresh, fw_error *error);
/* A folder that holds other files as well stays, with these. */
void fw_leftovers_remove(const fw_leftovers *leftovers);
void fw_leftovers_destroy(fw_leftovers *leftovers);

#endif
