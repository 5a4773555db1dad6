/* SPDX-License-Identifier: GPL-3.0-or-later */
/* column.h - one number of a results file over time: a component of an observable, by name. */
#ifndef FW_COLUMN_H
#define FW_COLUMN_H

#include "experiments/playback.h"

typedef struct fw_column {
    int observable, component;    /* in the playback */
    char name[FW_NAME_SIZE + 16]; /* "energy", "momentum.sheet.x" */
} fw_column;

/* The columns that a list of names means, in its order and each once: "momentum" is every component
 * of every momentum that was measured, "momentum.sheet" those of sheet, either with ".x" behind it
 * that component; names are parted by commas, and NULL means all. *columns is malloc'ed, also by a
 * failure: FW_BAD_INPUT for a name that means nothing, with the one that may have been meant;
 * `directory` is what the sentence calls the results. */
fw_status fw_columns_find(const fw_playback *playback, const char *directory, const char *names,
                          fw_column **columns, int *count, fw_error *error);

#endif
