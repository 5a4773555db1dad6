/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_grid.h - the sites of a body as rows of blocks, for the displacement form.
 *
 * A place of the grid is an element of its arrays. A row of the lattice takes consecutive places
 * from a multiple of 8 in i on, with holes where there is no particle: so the neighbours of a whole
 * row lie at constant distances in memory, and blocks of 8 lie above each other. The arrays reach
 * a row further at both ends, so that what a masked lane reads is there. */
#ifndef FW_LB_GRID_H
#define FW_LB_GRID_H

#include "lb_displacement_kernels.h"

/* A row of the grid. Its runs and stretches end where those of the next one begin. */
typedef struct lb_row {
    int run, stretch; /* its first ones */
    int north, south; /* distances to the places of the neighbours; 0 where there is no such row */
    int block;        /* its first one: blocks are numbered from column 0 on */
} lb_row;

/* Consecutive particles at consecutive places. */
typedef struct lb_stretch {
    int particle, place, count;
} lb_stretch;

typedef struct lb_grid {
    int row_count, run_count, stretch_count, place_count;
    int longest;                /* places of the longest row */
    int block_begin, block_end; /* of all rows */
    lb_row *rows;               /* row_count + 1 */
    lb_run *runs;
    lb_stretch *stretches;
    int *place;                      /* of each particle */
    uint8_t (*links)[FW_DIRECTIONS]; /* of each block, a bit per place */
} lb_grid;

/* What the grid is made from; by particle. */
typedef struct lb_grid_def {
    const fw_sites *sites;
    const uint8_t *present; /* bit d: the link in direction d exists */
    const uint8_t *plain; /* 1: it has four links and the mass that most of the body has; else 0 */
} lb_grid_def;

/* False: the grid would be so empty, or so large, that it is of no use. */
bool lb_grid_pays(const fw_sites *sites);
/* Counts, so that the arrays can be allocated. */
void lb_grid_measure(lb_grid *grid, const lb_grid_def *def);
/* Fills the arrays, which the caller has allocated and zeroed. */
void lb_grid_fill(lb_grid *grid, const lb_grid_def *def);

#endif
