/* SPDX-License-Identifier: GPL-3.0-or-later */
/* neighbours.c - from cells on a torus one ascending list per particle. State: fw_neighbours, the
 * caller's. Start reading at fw_neighbours_create(). */
#include "core/particles/neighbours.h"

#include "core/array.h"

#include <assert.h>
#include <stdlib.h>

enum { PARALLEL_FROM = 4096 /* particles; below it threads cost more than they bring */ };

/* Calls for all members of the 3 x 3 cells around particle i that are near: counts them, and
 * writes them down if there is somewhere to. */
static size_t visit(const fw_neighbours *neighbours, const double *restrict x,
                    const double *restrict y, int i, int *restrict out)
{
    const fw_cells *cells = &neighbours->cells;
    const int row = cells->cell[i] / cells->columns, column = cells->cell[i] % cells->columns;
    const double square = neighbours->radius * neighbours->radius;
    size_t found = 0;
    for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
            const int cell = fw_cell_at(cells, column + di, row + dj);
            for (int k = cells->begin[cell]; k < cells->begin[cell + 1]; ++k) {
                const int j = cells->member[k];
                const double dx = x[i] - x[j], dy = y[i] - y[j];
                const bool near = dx * dx + dy * dy < square && j != i;
                if (out && near) out[found] = j;
                found += near;
            }
        }
    return found;
}

/* Nearly sorted already, as the nine cells are: insertion is the quickest. */
static void sort_ascending(int *values, size_t count)
{
    for (size_t k = 1; k < count; ++k) {
        const int value = values[k];
        size_t place = k;
        for (; place > 0 && values[place - 1] > value; --place) values[place] = values[place - 1];
        values[place] = value;
    }
}

static bool fill(fw_neighbours *made, const double *x, const double *y)
{
    const int count = made->count;
    size_t *begin = made->begin;
    fw_cells_sort(&made->cells, made->radius, x, y);
#pragma omp parallel for schedule(static) if (count > PARALLEL_FROM)
    for (int i = 0; i < count; ++i) begin[i + 1] = visit(made, x, y, i, NULL);
    for (int i = 0; i < count; ++i) begin[i + 1] += begin[i];
    made->list = fw_array_allocate(begin[count], sizeof *made->list);
    if (!made->list) return false;
#pragma omp parallel for schedule(static) if (count > PARALLEL_FROM)
    for (int i = 0; i < count; ++i) {
        visit(made, x, y, i, made->list + begin[i]);
        sort_ascending(made->list + begin[i], begin[i + 1] - begin[i]);
    }
    return true;
}

fw_status fw_neighbours_create(fw_neighbours **neighbours, const double *x, const double *y,
                               int count, double radius, fw_error *error)
{
    assert(count >= 0 && radius > 0);
    *neighbours = NULL;
    fw_neighbours *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "a neighbour list");
    made->count = count;
    made->radius = radius;
    made->begin = fw_array_allocate((size_t)count + 1, sizeof *made->begin);
    fw_status status = fw_cells_create(&made->cells, count, error);
    if (status == FW_OK && (!made->begin || !fill(made, x, y)))
        status = fw_fail(error, FW_SYSTEM_FAILED,
                         "not enough memory for the neighbours of %d particles", count);
    if (status != FW_OK) {
        fw_neighbours_destroy(made);
        return status;
    }
    *neighbours = made;
    return FW_OK;
}

void fw_neighbours_destroy(fw_neighbours *neighbours)
{
    if (!neighbours) return;
    free(neighbours->begin);
    free(neighbours->list);
    fw_cells_release(&neighbours->cells);
    free(neighbours);
}
