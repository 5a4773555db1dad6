/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_seeds.h - what each seed of each case of a sweep showed: a row per case and seed, beside
 * the means of sweep.csv. As DIR/sweep-seeds.csv, and with these as DIR/sweep.h5. */
#ifndef FW_SWEEP_SEEDS_H
#define FW_SWEEP_SEEDS_H

#include "experiments/study/sweep_table.h"
#include "sweep_case.h"

#define FW_SEEDS_FILE "sweep-seeds.csv"
#define FW_SWEEP_HDF5 "sweep.h5"

/* Numbers of all seeds: columns as those of the table of means, and in their order. */
typedef struct fw_sweep_seeds {
    const fw_sweep_table *table; /* observed */
    int seed_count, row_count;   /* rows: case after case, each with all seeds */
    int64_t first;               /* seed */
    double **columns; /* [table->column_count][row_count], NaN where there is no number */
} fw_sweep_seeds;

/* From the tables in the folders of the cases, which are at their end. To be cleared also after a
 * failure. */
fw_status fw_sweep_seeds_collect(fw_sweep_seeds *seeds, const fw_sweep_table *table,
                                 const fw_scenario *sweep, const fw_sweep_case *cases,
                                 const char *directory, fw_error *error);
void fw_sweep_seeds_clear(fw_sweep_seeds *seeds);

fw_status fw_sweep_seeds_write(const fw_sweep_seeds *seeds, const char *title,
                               const char *directory, fw_error *error);
/* Means and seeds as HDF5. */
fw_status fw_sweep_seeds_write_hdf5(const fw_sweep_seeds *seeds, const char *title,
                                    const char *directory, fw_error *error);

#endif
