/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile_table.h - what came out of a study: profiles and measures of the layer, means and
 * standard errors over its seeds, of the experiment and of its control. In memory, in the results
 * file (parameters/profile and parameters/layer), as CSV, and as a printed table. */
#ifndef FW_PROFILE_TABLE_H
#define FW_PROFILE_TABLE_H

#include "experiments/measures/layer.h"
#include "experiments/results/playback.h"
#include "experiments/units/units.h"

typedef struct fw_profile_table {
    char axis; /* 'x' or 'y' */
    int bin_count;
    double *edges;       /* bin_count + 1 */
    fw_outcome *columns; /* [FW_PROFILE_COLUMNS][bin_count] */
    fw_outcome layer[FW_LAYER_MEASURES];
} fw_profile_table;

/* All numbers NaN. */
fw_status fw_profile_table_create(fw_profile_table **table, int bin_count, char axis,
                                  fw_error *error);
void fw_profile_table_destroy(fw_profile_table *table);

static inline fw_outcome *fw_profile_table_column(const fw_profile_table *table,
                                                  fw_profile_column column)
{
    return table->columns + (size_t)column * (size_t)table->bin_count;
}

/* From a results file. FW_BAD_INPUT: it has no profile. */
fw_status fw_profile_table_read(fw_profile_table **table, fw_playback *playback, char axis,
                                fw_error *error);

/* The arrays of a results file that hold it, without its numbers: malloc'ed, *count of them. */
fw_status fw_profile_table_arrays(fw_trajectory_array **arrays, int *count, int bin_count,
                                  fw_error *error);
/* The numbers of the n-th of these. */
const double *fw_profile_table_values(const fw_profile_table *table, int n);

/* Comma-separated: the profile, one line per bin. */
fw_status fw_profile_table_write(const fw_profile_table *table, const char *directory,
                                 const char *name, fw_error *error);
/* For people: one column of the profile beside its control's (FW_PROFILE_COLUMNS: the main ones
 * without control), then the measures of the layer. */
void fw_profile_table_print(const fw_profile_table *table, fw_profile_column column,
                            const fw_units *units, FILE *out);

#endif
