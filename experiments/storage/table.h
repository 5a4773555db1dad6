/* SPDX-License-Identifier: GPL-3.0-or-later */
/* table.h - a named array of numbers that does not change in time, as results files keep it. */
#ifndef FW_TABLE_H
#define FW_TABLE_H

typedef struct fw_table {
    const char *name; /* "growth" */
    const char *unit;
    const char *meaning; /* one line */
    int rank;            /* 1, or 2 */
    int extent[2];       /* of a rank of 2: rows, columns */
    double *values;      /* row by row */
} fw_table;

static inline long fw_table_size(const fw_table *table)
{
    return table->rank == 2 ? (long)table->extent[0] * table->extent[1] : table->extent[0];
}

#endif
