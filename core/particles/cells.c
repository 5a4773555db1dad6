/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cells.c - particles sorted by where they are. Start reading at fw_cells_sort(). */
#include "core/particles/cells.h"

#include <math.h>
#include <string.h>

enum { SIDE_LEAST = 4 /* the 3 x 3 around a cell must be different ones */ };

/* Where cell coordinates end: beyond it, and for what is not a number, all share one cell. */
#define COORDINATE_MAX 1e15

fw_status fw_cells_create(fw_cells *cells, int count, fw_error *error)
{
    *cells = (fw_cells){.count = count, .most = SIDE_LEAST * SIDE_LEAST};
    while (cells->most < 2 * (int64_t)count && cells->most < 1 << 29) cells->most *= 2;
    FW_ARENA_ADD(&cells->arena, cells->cell, (size_t)count);
    FW_ARENA_ADD(&cells->arena, cells->begin, (size_t)cells->most + 1);
    FW_ARENA_ADD(&cells->arena, cells->member, (size_t)count);
    return fw_arena_allocate(&cells->arena, "the cells of particles", error);
}

void fw_cells_release(fw_cells *cells)
{
    fw_arena_release(&cells->arena);
    *cells = (fw_cells){0};
}

static int64_t coordinate(double place)
{
    return fabs(place) <= COORDINATE_MAX ? (int64_t)floor(place) : 0;
}

static double span(const double *values, int count)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < count; ++i) {
        low = values[i] < low ? values[i] : low;
        high = values[i] > high ? values[i] : high;
    }
    return high - low;
}

static int64_t power_of_two_from(double least)
{
    int64_t power = SIDE_LEAST;
    while ((double)power < least && power < (int64_t)1 << 40) power *= 2;
    return power;
}

/* As many cells as the body is wide and high, if there are not too many; else the longer side is
 * wrapped. */
static void choose_torus(fw_cells *cells, const double *x, const double *y)
{
    int64_t columns = power_of_two_from(span(x, cells->count) / cells->size + 2);
    int64_t rows = power_of_two_from(span(y, cells->count) / cells->size + 2);
    while (columns > cells->most / rows) *(columns >= rows ? &columns : &rows) /= 2;
    cells->columns = (int)columns;
    cells->rows = (int)rows;
}

void fw_cells_sort(fw_cells *cells, double size, const double *x, const double *y)
{
    cells->size = size;
    choose_torus(cells, x, y);
    const int count = cells->count, most = cells->columns * cells->rows;
    const double inverse = 1 / size;
    int *begin = cells->begin;
    memset(begin, 0, ((size_t)most + 1) * sizeof *begin);
    for (int i = 0; i < count; ++i) {
        const int64_t column = coordinate(x[i] * inverse) & (cells->columns - 1);
        const int64_t row = coordinate(y[i] * inverse) & (cells->rows - 1);
        cells->cell[i] = (int)(row * cells->columns + column);
        begin[cells->cell[i] + 1] += 1;
    }
    for (int c = 0; c < most; ++c) begin[c + 1] += begin[c];
    /* Downwards, so that each cell's beginning ends where it belongs and its members ascend. */
    for (int i = count - 1; i >= 0; --i) cells->member[--begin[cells->cell[i] + 1]] = i;
    memmove(begin, begin + 1, (size_t)most * sizeof *begin);
    begin[most] = count;
}
