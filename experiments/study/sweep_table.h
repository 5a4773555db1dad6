/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_table.h - what came out of a sweep: numbers with their errors against the parameters, and
 * what was expected of them. In memory and as DIR/sweep.csv. */
#ifndef FW_SWEEP_TABLE_H
#define FW_SWEEP_TABLE_H

#include "experiments/measures/verdict.h"
#include "experiments/units/units.h"

enum { FW_SWEEP_NAME = FW_VERDICT_TEXT + FW_NAME_BYTES + 64 };

/* One number, as it is called in the table of verdicts; [row_count] each, NaN where not known. */
typedef struct fw_sweep_column {
    char name[FW_SWEEP_NAME], unit[64];
    double *mean, *error;
    double *at_least; /* 1: the series was too short, and the error is a lower bound; else 0 */
    double *expected, *within;
} fw_sweep_column;

/* What is varied, a column before all others. */
typedef struct fw_sweep_axis {
    char name[FW_NAME_BYTES], unit[64];
} fw_sweep_axis;

typedef struct fw_sweep_table {
    const fw_units *units; /* of whoever writes it; NULL where it was read */
    int axis_count;
    fw_sweep_axis axes[FW_PARAMETERS_MAX];
    int row_count;  /* one per case */
    int seed_count; /* of each case; 0: not known */
    double *values; /* [row_count][axis_count] of the parameters */
    int column_count, column_room;
    fw_sweep_column *columns;
    char **failures; /* why a case has no numbers; NULL of one that has */
} fw_sweep_table;

/* Parameters with their values in all cases, and no columns yet. A table that is all zero may be
 * cleared. */
fw_status fw_sweep_table_create(fw_sweep_table *table, const fw_scenario_sweep *sweep,
                                int seed_count, fw_error *error);
void fw_sweep_table_clear(fw_sweep_table *table);

/* A column by its name, made where there is none yet; NULL without memory. Adding another one may
 * move it. */
fw_sweep_column *fw_sweep_table_column(fw_sweep_table *table, const char *name, const char *unit);

/* A unit for the head of a table, and what one of it is in nature. */
void fw_sweep_table_write_unit(FILE *out, const fw_sweep_table *table, const char *unit);

/* The case of this row has failed; false without memory. */
bool fw_sweep_table_fail(fw_sweep_table *table, int row, const char *reason);

/* DIRECTORY/sweep.csv: two lines that begin with # (title and units), one of names, then one per
 * case, the parameters first. Where a case has failed a last column, `failure`, says why. */
fw_status fw_sweep_table_write(const fw_sweep_table *table, const char *title,
                               const char *directory, fw_error *error);
/* That of a sweep over so many parameters. FW_BAD_INPUT: there is no such file, or it is not as it
 * was written. */
fw_status fw_sweep_table_read(fw_sweep_table *table, const char *directory, int axis_count,
                              fw_error *error);

#endif
