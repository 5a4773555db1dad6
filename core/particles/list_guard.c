/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_guard.c - displacements of neighbouring cells against each other. Keeps no state. */
#include "list_guard.h"

#include <math.h>

enum {
    RING_MAX = 6,         /* cells that are compared lie at most so many apart */
    PARALLEL_FROM = 16384 /* particles */
};

/* A hair less, for the rounding of displacements and distances. */
#define SURE (1 - 1e-9)

static fw_list_box empty(void)
{
    return (fw_list_box){INFINITY, -INFINITY, INFINITY, -INFINITY};
}

static inline fw_list_box both(fw_list_box a, fw_list_box b)
{
    return (fw_list_box){a.left < b.left ? a.left : b.left, a.right > b.right ? a.right : b.right,
                         a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}

/* 0 for an empty box. */
static inline double square_diagonal(fw_list_box box)
{
    const double width = box.right - box.left, height = box.high - box.low;
    return width >= 0 ? width * width + height * height : 0;
}

static void fill_boxes(const fw_cells *cells, const double *restrict built_x,
                       const double *restrict built_y, const double *restrict x,
                       const double *restrict y, fw_list_box *boxes)
{
#pragma omp parallel for schedule(static) if (cells->count > PARALLEL_FROM)
    for (int c = 0; c < cells->columns * cells->rows; ++c) {
        fw_list_box box = empty();
        for (int m = cells->begin[c]; m < cells->begin[c + 1]; ++m) {
            const int i = cells->member[m];
            const double dx = x[i] - built_x[i], dy = y[i] - built_y[i];
            box = both(box, (fw_list_box){dx, dx, dy, dy});
        }
        boxes[c] = box;
    }
}

/* The most that two particles of cells which lie (di, dj) apart have come closer, squared. */
static double most_between(const fw_cells *cells, const fw_list_box *boxes, int di, int dj)
{
    double most = 0;
#pragma omp parallel for schedule(static) reduction(max : most) if (cells->count > PARALLEL_FROM)
    for (int row = 0; row < cells->rows; ++row) {
        const fw_list_box *here = boxes + row * cells->columns;
        const fw_list_box *there = boxes + fw_cell_at(cells, 0, row + dj);
        for (int column = 0; column < cells->columns; ++column) {
            const double square =
                square_diagonal(both(here[column], there[(column + di) & (cells->columns - 1)]));
            most = square > most ? square : most;
        }
    }
    return most;
}

double fw_list_guard_slack(const fw_cells *cells, const double *built_x, const double *built_y,
                           const double *x, const double *y, double listed, double reach,
                           fw_list_box *boxes)
{
    fill_boxes(cells, built_x, built_y, x, y, boxes);
    fw_list_box all = empty();
    for (int c = 0; c < cells->columns * cells->rows; ++c) all = both(all, boxes[c]);
    const double most = sqrt(square_diagonal(all));
    if (!(most < INFINITY)) return -1;
    /* Particles whose cells lie more than `ring` apart were ring * size from each other. */
    int ring = 1;
    while (ring < RING_MAX && ring * cells->size - reach - most < 0.5 * (listed - reach)) ++ring;
    double slack = ring * cells->size * SURE - reach - most;
    for (int dj = 0; dj <= ring && slack >= 0; ++dj)
        for (int di = -ring; di <= ring; ++di) {
            if (dj == 0 && di < 0) continue;
            const double apart = ((di < 0 ? -di : di) > dj ? (di < 0 ? -di : di) : dj) - 1;
            const double distance = fmax(listed, apart * cells->size) * SURE;
            slack = fmin(slack, distance - reach - sqrt(most_between(cells, boxes, di, dj)));
        }
    return slack;
}
