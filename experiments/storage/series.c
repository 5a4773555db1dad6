/* SPDX-License-Identifier: GPL-3.0-or-later */
/* series.c - rows that are gathered, written and then committed.
 * State: datasets of step, time and each quantity, a block of rows in memory, and the writer of
 * long rows. Invariant: rows [0, committed) are in the file; rows [committed, ended) are in the
 * block. While the writer has a row, `committed` and what commits are its own: everybody else waits
 * for it first. Start reading at commit_rows(). */
#include "experiments/storage/series.h"

#include "experiments/storage/row_writer.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { CHUNK_BYTES = 65536, CHUNK_ROWS = 1024, LEAST_ROWS = 16, LONGEST_PATH = 512, FEW = 4 };

typedef struct quantity {
    fw_dataset value;
    size_t width; /* doubles in a row */
    void *memory;
    double *block;    /* in that memory: rows not yet written */
    bool is_long;     /* of one row, for the writer */
    uint64_t address; /* of that row in the file */
} quantity;

struct fw_series {
    fw_hdf5 *file;
    fw_dataset counter, step, time;
    bool fresh;
    int block;
    double longest, last_commit; /* seconds */
    int64_t room, committed, ended;
    int64_t *steps;
    double *times;
    quantity *quantities;
    int count;
    fw_row_writer *writer;      /* NULL: no row is long */
    fw_row_piece *pieces;       /* of its row */
    char moments[LONGEST_PATH]; /* the element that first had step and time */
};

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Until the writer has no row any more. */
static void await(fw_series *series)
{
    if (series->writer) fw_row_writer_wait(series->writer);
}

fw_series *fw_series_create(fw_hdf5 *file, const char *counter, bool fresh, int block,
                            double longest)
{
    fw_series *series = calloc(1, sizeof *series);
    if (!series) return NULL;
    series->file = file;
    series->fresh = fresh;
    series->block = block;
    series->longest = longest;
    series->last_commit = seconds_now();
    series->steps = fw_array_allocate((size_t)block, sizeof *series->steps);
    series->times = fw_array_of_doubles((size_t)block);
    if (!series->steps || !series->times) {
        fw_series_destroy(series);
        return NULL;
    }
    if (fresh) {
        series->counter = fw_hdf5_make_array(file, counter, FW_I64, 0, NULL);
        fw_hdf5_write(file, series->counter, FW_I64, 0, 1, &series->committed);
    } else {
        series->counter = fw_hdf5_find(file, counter);
        fw_hdf5_read(file, series->counter, FW_I64, 0, 1, &series->committed);
    }
    series->ended = series->committed;
    return series;
}

void fw_series_destroy(fw_series *series)
{
    if (!series) return;
    fw_row_writer_destroy(series->writer);
    for (int i = 0; i < series->count; ++i) free(series->quantities[i].memory);
    free(series->quantities);
    free(series->pieces);
    free(series->steps);
    free(series->times);
    free(series);
}

uint64_t fw_series_chunk(size_t width)
{
    uint64_t rows = CHUNK_BYTES / (sizeof(double) * width);
    return rows < LEAST_ROWS ? LEAST_ROWS : rows < CHUNK_ROWS ? rows : CHUNK_ROWS;
}

/* Rows of many numbers that are written at once have a chunk of their own each. */
static uint64_t chunk_of(const fw_series *series, size_t width)
{
    return series->block == 1 && width > FEW ? 1 : fw_series_chunk(width);
}

/* The first element has step and time of its own, all others share them. */
static void make_moments(fw_series *series, const char *path)
{
    char own[LONGEST_PATH + 8], shared[LONGEST_PATH + 8];
    bool first = series->count == 0;
    if (first) snprintf(series->moments, sizeof series->moments, "%s", path);
    for (int time = 0; time < 2; ++time) {
        snprintf(own, sizeof own, "%s/%s", path, time ? "time" : "step");
        snprintf(shared, sizeof shared, "%s/%s", series->moments, time ? "time" : "step");
        fw_dataset *dataset = time ? &series->time : &series->step;
        if (!series->fresh) {
            if (first) *dataset = fw_hdf5_find(series->file, own);
        } else if (first) {
            *dataset =
                fw_hdf5_make_rows(series->file, own, time ? FW_F64 : FW_I64, 0, NULL, CHUNK_ROWS);
        } else {
            fw_hdf5_link(series->file, shared, own);
        }
    }
}

static bool has_shape(fw_series *series, fw_dataset dataset, int rank, const uint64_t *extent)
{
    fw_shape shape;
    if (!fw_hdf5_shape(series->file, dataset, &shape) || shape.text || shape.rank != rank + 1)
        return false;
    for (int i = 0; i < rank; ++i)
        if (shape.extent[i + 1] != extent[i]) return false;
    if (series->count == 0) series->room = (int64_t)shape.extent[0];
    return shape.element == FW_F64 && (int64_t)shape.extent[0] == series->room;
}

/* Whether a dataset found in the file has one element for each row that has room. */
static bool is_line(fw_series *series, fw_dataset dataset, fw_element element)
{
    fw_shape shape;
    return fw_hdf5_shape(series->file, dataset, &shape) && !shape.text &&
           shape.element == element && shape.rank == 1 && (int64_t)shape.extent[0] == series->room;
}

/* For one more quantity. */
static bool make_memory(fw_series *series, int rank, const uint64_t *extent)
{
    quantity *added = &series->quantities[series->count];
    *added = (quantity){.width = 1};
    for (int i = 0; i < rank; ++i) added->width *= extent[i];
    const size_t bytes = (size_t)series->block * added->width * sizeof(double);
    added->is_long = series->block == 1 && bytes >= FW_LONG_ROW_BYTES;
    added->memory = added->is_long ? fw_row_memory(bytes) : fw_array_allocate(bytes, 1);
    added->block = added->memory;
    return added->memory;
}

int fw_series_add(fw_series *series, const char *path, int rank, const uint64_t *extent)
{
    assert(strlen(path) < LONGEST_PATH && rank < FW_DATASET_RANK);
    quantity *more =
        realloc(series->quantities, (size_t)(series->count + 1) * sizeof *series->quantities);
    if (!more) return -1;
    series->quantities = more;
    if (!make_memory(series, rank, extent)) return -1;
    quantity *added = &series->quantities[series->count];
    char value[LONGEST_PATH + 8];
    snprintf(value, sizeof value, "%s/value", path);
    if (series->fresh) {
        fw_hdf5_make_group(series->file, path);
        added->value = fw_hdf5_make_rows(series->file, value, FW_F64, rank, extent,
                                         chunk_of(series, added->width));
    } else {
        added->value = fw_hdf5_find(series->file, value);
        if (!has_shape(series, added->value, rank, extent)) fw_hdf5_refuse(series->file, path);
    }
    make_moments(series, path);
    if (!series->fresh && series->count == 0 &&
        (!is_line(series, series->step, FW_I64) || !is_line(series, series->time, FW_F64)))
        fw_hdf5_refuse(series->file, path);
    return series->count++;
}

void fw_series_reserve(fw_series *series, int64_t rows)
{
    if (series->count == 0) return;
    await(series);
    fw_hdf5_resize(series->file, series->step, (uint64_t)rows);
    fw_hdf5_resize(series->file, series->time, (uint64_t)rows);
    /* Chunks lie in the order in which they get their room; cutting off rows then frees the end of
     * the file. Rows that share chunks gain nothing from it. */
    int64_t stride = series->block == 1 && rows > series->room ? 1 : rows - series->room;
    for (int64_t row = series->room; row != rows;) {
        row += stride;
        for (int i = 0; i < series->count; ++i)
            fw_hdf5_resize(series->file, series->quantities[i].value, (uint64_t)row);
    }
    series->room = rows;
}

int64_t fw_series_room(const fw_series *series)
{
    return series->room;
}

/* Where the value of the row at hand is kept: of a long one, so that the writer can take it. */
static double *place_of(fw_series *series, quantity *filled)
{
    if (filled->is_long) {
        const uint64_t row = (uint64_t)series->ended;
        filled->address = fw_hdf5_row_address(series->file, filled->value, row);
        filled->block = fw_row_place(filled->memory, filled->address);
        return filled->block;
    }
    return filled->block + (size_t)(series->ended - series->committed) * filled->width;
}

double *fw_series_fill(fw_series *series, int number)
{
    await(series);
    return place_of(series, &series->quantities[number]);
}

void fw_series_write(fw_series *series, int number, const double *values)
{
    const size_t width = series->quantities[number].width;
    memcpy(fw_series_fill(series, number), values, width * sizeof *values);
}

/* First the data, then how many of them count. */
static void commit_rows(fw_series *series)
{
    uint64_t first = (uint64_t)series->committed;
    uint64_t count = (uint64_t)(series->ended - series->committed);
    for (int i = 0; i < series->count; ++i) {
        quantity *written = &series->quantities[i];
        if (!written->is_long)
            fw_hdf5_write(series->file, written->value, FW_F64, first, count, written->block);
    }
    if (series->count > 0) {
        fw_hdf5_write(series->file, series->step, FW_I64, first, count, series->steps);
        fw_hdf5_write(series->file, series->time, FW_F64, first, count, series->times);
    }
    fw_hdf5_flush(series->file);
    fw_hdf5_write(series->file, series->counter, FW_I64, 0, 1, &series->ended);
    fw_hdf5_flush(series->file);
    series->committed = series->ended;
    series->last_commit = seconds_now();
}

static void commit_long_row(void *owner, int reason)
{
    fw_series *series = owner;
    if (reason != 0) fw_hdf5_fail_system(series->file, reason);
    commit_rows(series);
}

/* The long values of the row at hand go to the writer; false: there are none, or they cannot. */
static bool hand_over(fw_series *series)
{
    int count = 0;
    for (int i = 0; i < series->count; ++i) count += series->quantities[i].is_long;
    if (count == 0 || fw_hdf5_check(series->file, NULL) != FW_OK) return false;
    if (!series->writer) {
        series->pieces = calloc((size_t)count, sizeof *series->pieces);
        series->writer =
            fw_row_writer_create(fw_hdf5_descriptor(series->file), commit_long_row, series);
    }
    if (!series->writer || !series->pieces) {
        fw_hdf5_give_up(series->file, "a row of results");
        return false;
    }
    count = 0;
    for (int i = 0; i < series->count; ++i) {
        const quantity *written = &series->quantities[i];
        if (!written->is_long) continue;
        series->pieces[count++] =
            (fw_row_piece){written->block, written->width * sizeof(double), written->address};
    }
    fw_row_writer_start(series->writer, series->pieces, count);
    return true;
}

void fw_series_end_row(fw_series *series, int64_t step, double time)
{
    await(series);
    series->steps[series->ended - series->committed] = step;
    series->times[series->ended - series->committed] = time;
    series->ended += 1;
    if (hand_over(series)) return;
    if (series->ended - series->committed == series->block ||
        seconds_now() - series->last_commit >= series->longest)
        commit_rows(series);
}

void fw_series_commit(fw_series *series)
{
    await(series);
    if (series->ended > series->committed) commit_rows(series);
}

int64_t fw_series_count(const fw_series *series)
{
    return series->ended;
}

void fw_series_rewind(fw_series *series, int64_t rows)
{
    await(series);
    assert(rows <= series->committed);
    series->committed = series->ended = rows;
    fw_hdf5_write(series->file, series->counter, FW_I64, 0, 1, &rows);
    fw_hdf5_flush(series->file);
}
