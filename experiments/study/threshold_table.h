/* SPDX-License-Identifier: GPL-3.0-or-later */
/* threshold_table.h - DIR/thresholds.csv of a sweep, read again. */
#ifndef FW_THRESHOLD_TABLE_H
#define FW_THRESHOLD_TABLE_H

#include "experiments/study/sweep_table.h"

typedef struct fw_threshold_row {
    char quantity[FW_VERDICT_TEXT]; /* the number that crosses ... */
    double level;                   /* ... this */
    double values[FW_PARAMETERS_MAX];
    double error; /* of the parameter along which it does; both NaN where it does not */
    int seeds;
} fw_threshold_row;

/* Of a sweep over so many parameters; *rows is malloc'ed. FW_BAD_INPUT: there is no such file, or
 * it is not as it was written. */
fw_status fw_threshold_table_read(fw_threshold_row **rows, int *count, const char *directory,
                                  int axis_count, fw_error *error);

#endif
