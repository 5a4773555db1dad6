/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cells.h - space cut into square cells that are wrapped onto a torus of bounded size: particles
 * that fly far away cost nothing, and whom they share a cell with, the distance rules out. On the
 * torus no two particles are further apart, in cells, than in the plane. */
#ifndef FW_CELLS_H
#define FW_CELLS_H

#include "core/arena.h"
#include "core/status.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct fw_cells {
    int count;         /* particles */
    double size;       /* of a cell */
    int columns, rows; /* powers of two, at least 4 */
    int *cell;         /* of each particle: row columns + column */
    int *begin;  /* the particles of cell c are member[begin[c]] .. member[begin[c + 1] - 1] */
    int *member; /* ascending within each cell */
    int most;    /* cells that there is memory for */
    fw_arena arena;
} fw_cells;

/* FW_SYSTEM_FAILED without memory; to be released then too. */
fw_status fw_cells_create(fw_cells *cells, int count, fw_error *error);
void fw_cells_release(fw_cells *cells);

/* Sorts particles into cells of that size. */
void fw_cells_sort(fw_cells *cells, double size, const double *x, const double *y);

/* On two's complement the mask is the remainder, for negative numbers too. */
static inline int fw_cell_at(const fw_cells *cells, int column, int row)
{
    return (row & (cells->rows - 1)) * cells->columns + (column & (cells->columns - 1));
}

#endif
