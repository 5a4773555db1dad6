/* SPDX-License-Identifier: GPL-3.0-or-later */
/* series.h - rows of quantities that are taken at the same moments of a run.
 *
 * A series is one step, one time and one value of each quantity per row; in the file every quantity
 * is an H5MD element {value, step, time}, whose step and time all quantities share. All rows have
 * their room from the start. Rows count once they are committed: first the data, then the number of
 * committed rows, so that a reader, also of a file whose writer was killed, finds each of them
 * whole. Failures stick to the file (hdf5_file.h). */
#ifndef FW_SERIES_H
#define FW_SERIES_H

#include "experiments/storage/hdf5_file.h"

typedef struct fw_series fw_series;

/* An empty series, or with `fresh` false the one whose number of committed rows is at `counter`.
 * Up to `block` rows are gathered in memory before they are written; `longest` seconds after the
 * last commit the next row is committed at once. NULL: no memory. */
fw_series *fw_series_create(fw_hdf5 *file, const char *counter, bool fresh, int block,
                            double longest);
void fw_series_destroy(fw_series *series);

/* Rows of `width` doubles that share a chunk of the file in a series with blocks; where a block is
 * one row, a chunk is one row. */
uint64_t fw_series_chunk(size_t width);

/* Makes (or finds) the element at `path`; a row of it is an array of doubles of these extents
 * (rank 0: one double). Returns the number of the quantity, counted from 0, or -1 without memory;
 * quantities are to be added before there are rows. An element that is not in the file, or not of
 * this shape, is a failure of the file. */
int fw_series_add(fw_series *series, const char *path, int rank, const uint64_t *extent);

/* Makes room for this many rows in all; rows beyond them are cut off. Row by row, the quantities'
 * data lie next to each other. */
void fw_series_reserve(fw_series *series, int64_t rows);
int64_t fw_series_room(const fw_series *series);

/* The value of a quantity in the row that is being written; all are to be given, in any order. */
void fw_series_write(fw_series *series, int quantity, const double *values);
/* The same without a copy: memory for that value, with whatever is in it, to be filled before the
 * row ends. Failures of the file give it as well. */
double *fw_series_fill(fw_series *series, int quantity);
/* Ends the row. Long values are written, and the row then committed, while the caller goes on:
 * what fails then is known at the next call that writes or commits. */
void fw_series_end_row(fw_series *series, int64_t step, double time);
/* Makes all ended rows count. */
void fw_series_commit(fw_series *series);

/* Rows ended, committed or not. */
int64_t fw_series_count(const fw_series *series);
/* Only the first `rows` count from now on; there must be as many committed. */
void fw_series_rewind(fw_series *series, int64_t rows);

#endif
