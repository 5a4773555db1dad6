/* SPDX-License-Identifier: GPL-3.0-or-later */
/* neighbours.c - from cells on a torus one ascending list per particle.
 * State: the list and the positions it was made for. Invariant: as long as `valid`, every pair
 * closer than `radius` is in the list of both. Start reading at fw_neighbours_refresh(). */
#include "core/particles/neighbours.h"

#include "core/array.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    PARALLEL_FROM = 4096, /* particles; below it threads cost more than they bring */
    ROOM_EACH = 20        /* neighbours per particle to begin with; a dense solid has 16 */
};

fw_status fw_neighbours_create(fw_neighbours **neighbours, int count, double radius, double skin,
                               fw_error *error)
{
    assert(count >= 0 && radius > 0 && skin >= 0);
    *neighbours = NULL;
    fw_neighbours *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "a neighbour list");
    size_t size = (size_t)count;
    made->count = count;
    made->radius = radius;
    made->skin = skin;
    made->capacity = size * ROOM_EACH;
    made->begin = fw_array_allocate(size + 1, sizeof *made->begin);
    made->list = fw_array_allocate(made->capacity, sizeof *made->list);
    made->built_x = fw_array_of_doubles(size);
    made->built_y = fw_array_of_doubles(size);
    const bool sortable = fw_cells_create(&made->cells, count, error) == FW_OK;
    if (!sortable || !made->begin || !made->list || !made->built_x || !made->built_y) {
        fw_neighbours_destroy(made);
        return fw_fail(error, FW_SYSTEM_FAILED,
                       "not enough memory for the neighbours of %d particles", count);
    }
    *neighbours = made;
    return FW_OK;
}

void fw_neighbours_destroy(fw_neighbours *neighbours)
{
    if (!neighbours) return;
    free(neighbours->begin);
    free(neighbours->list);
    free(neighbours->built_x);
    free(neighbours->built_y);
    fw_cells_release(&neighbours->cells);
    free(neighbours);
}

/* Two particles have come closer by at most the difference of their displacements, and that is at
 * most the diagonal of the box of all displacements: a solid that moves as a whole keeps its list.
 */
static bool may_have_met(const fw_neighbours *neighbours, const double *restrict x,
                         const double *restrict y)
{
    const double *restrict built_x = neighbours->built_x, *restrict built_y = neighbours->built_y;
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
#pragma omp parallel for schedule(static) reduction(min                                            \
                                                    : left, low)                                   \
    reduction(max                                                                                  \
              : right, high) if (neighbours->count > PARALLEL_FROM)
    for (int i = 0; i < neighbours->count; ++i) {
        const double dx = x[i] - built_x[i], dy = y[i] - built_y[i];
        left = dx < left ? dx : left;
        right = dx > right ? dx : right;
        low = dy < low ? dy : low;
        high = dy > high ? dy : high;
    }
    /* A hair less than the skin, for the rounding of displacements and distances. */
    return !(hypot(right - left, high - low) <= neighbours->skin * (1 - 1e-9));
}

/* Calls for all members of the 3 x 3 cells around particle i that are near: counts them, and
 * writes them down if there is somewhere to. */
static size_t visit(const fw_neighbours *neighbours, const double *restrict x,
                    const double *restrict y, int i, int *restrict out)
{
    const double reach = neighbours->radius + neighbours->skin;
    const fw_cells *cells = &neighbours->cells;
    const int row = cells->cell[i] / cells->columns, column = cells->cell[i] % cells->columns;
    size_t found = 0;
    for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
            const int cell = fw_cell_at(cells, column + di, row + dj);
            for (int k = cells->begin[cell]; k < cells->begin[cell + 1]; ++k) {
                const int j = cells->member[k];
                const double dx = x[i] - x[j], dy = y[i] - y[j];
                const bool near = dx * dx + dy * dy < reach * reach && j != i;
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

static bool make_room(fw_neighbours *neighbours, size_t needed)
{
    if (needed <= neighbours->capacity) return true;
    /* A quarter more, so that a body that slowly thickens does not allocate again and again. */
    const size_t wanted = needed + needed / 4;
    int *longer = fw_array_allocate(wanted, sizeof *longer);
    if (!longer) return false;
    free(neighbours->list);
    neighbours->list = longer;
    neighbours->capacity = wanted;
    return true;
}

static bool make_list(fw_neighbours *neighbours, const double *x, const double *y)
{
    const int count = neighbours->count;
    fw_cells_sort(&neighbours->cells, neighbours->radius + neighbours->skin, x, y);
    size_t *begin = neighbours->begin;
#pragma omp parallel for schedule(static) if (count > PARALLEL_FROM)
    for (int i = 0; i < count; ++i) begin[i + 1] = visit(neighbours, x, y, i, NULL);
    for (int i = 0; i < count; ++i) begin[i + 1] += begin[i];
    if (!make_room(neighbours, begin[count])) {
        memset(begin, 0, ((size_t)count + 1) * sizeof *begin);
        return false;
    }
#pragma omp parallel for schedule(static) if (count > PARALLEL_FROM)
    for (int i = 0; i < count; ++i) {
        visit(neighbours, x, y, i, neighbours->list + begin[i]);
        sort_ascending(neighbours->list + begin[i], begin[i + 1] - begin[i]);
    }
    return true;
}

fw_status fw_neighbours_refresh(fw_neighbours *neighbours, const double *x, const double *y,
                                fw_error *error)
{
    if (neighbours->valid && !may_have_met(neighbours, x, y)) return FW_OK;
    neighbours->valid = make_list(neighbours, x, y);
    if (!neighbours->valid)
        return fw_fail(error, FW_SYSTEM_FAILED,
                       "not enough memory for the neighbours of %d particles", neighbours->count);
    const size_t bytes = (size_t)neighbours->count * sizeof *x;
    memcpy(neighbours->built_x, x, bytes);
    memcpy(neighbours->built_y, y, bytes);
    neighbours->generation += 1;
    return FW_OK;
}
