/* SPDX-License-Identifier: GPL-3.0-or-later */
/* column.h - one number of a results file over time: a component of an observable, by name.
 * Pictures and tables choose what they show by it. */
#ifndef FW_COLUMN_H
#define FW_COLUMN_H

#include "experiments/results/playback.h"

enum { FW_COLUMN_PART = 16, FW_COLUMN_NAME = FW_NAME_SIZE + FW_COLUMN_PART };

typedef struct fw_column {
    int observable, component; /* in the playback */
    char part[FW_COLUMN_PART]; /* name of the component, "x"; "" where there is only one */
} fw_column;

/* The columns that names mean, in their order and each once: "momentum" is every component of every
 * momentum that was measured, "momentum.sheet" those of sheet, either with ".x" behind it that
 * component; NULL means all there are. *columns is malloc'ed, also where it fails: FW_BAD_INPUT for
 * a name that means nothing, with the one that may have been meant. `directory` is what the
 * sentence calls the results. */
fw_status fw_columns_find(const fw_playback *playback, const char *directory,
                          const char *const *names, int name_count, fw_column **columns, int *count,
                          fw_error *error);

/* "energy", "momentum.sheet.x" */
void fw_column_name(const fw_playback *playback, const fw_column *column,
                    char name[FW_COLUMN_NAME]);

/* The names in a list with commas between them, as --observable has them; a comma within brackets,
 * as in "position.sheet[0,3]", belongs to the name. *text is malloc'ed and holds the names, *names
 * is malloc'ed too, both also where it fails. A list that is NULL has none. */
fw_status fw_column_names_read(const char *list, char **text, const char ***names, int *count,
                               fw_error *error);

#endif
