/* SPDX-License-Identifier: GPL-3.0-or-later */
/* leftovers.h - what an earlier result would leave beside a new one in the same folder: its
 * pictures and tables, its control, the cases of its sweep. They are found before the new result
 * begins, and removed once it has begun. Only files are touched that the program itself has made,
 * by their names and by what is in them; where the new result needs the name of one of the user's
 * own, it is refused. */
#ifndef FW_LEFTOVERS_H
#define FW_LEFTOVERS_H

#include "experiments/scenario/scenario.h"

#include <stdbool.h>

typedef struct fw_leftovers fw_leftovers;

/* Of the result in `directory`, if there is one. FW_BAD_INPUT: there is one, or a file of one, that
 * is not to be overwritten; or a file that is not the program's lies where the result of `fresh`
 * would write one. FW_SYSTEM_FAILED without memory, or where the earlier result cannot be
 * read. */
fw_status fw_leftovers_find(fw_leftovers **leftovers, const char *directory,
                            const fw_scenario *fresh, bool overwrite, fw_error *error);
/* Before a run goes on: FW_BAD_INPUT where it would write a table or a picture over a file that is
 * not the program's. */
fw_status fw_leftovers_check(const char *directory, const fw_scenario *scenario, fw_error *error);
/* A folder that holds other files as well stays, with these. FW_SYSTEM_FAILED where it cannot be
 * told what a folder holds: then the rest stays too. */
fw_status fw_leftovers_remove(const fw_leftovers *leftovers, fw_error *error);
void fw_leftovers_destroy(fw_leftovers *leftovers);

#endif
