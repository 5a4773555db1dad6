/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_displacement_kernels.h - the loop of lb_displacements.c over the blocks of a row. */
#ifndef FW_LB_DISPLACEMENT_KERNELS_H
#define FW_LB_DISPLACEMENT_KERNELS_H

#include "core/instruction_set.h"
#include "core/lattice.h"
#include "core/solid.h"

enum { LB_BLOCK = 8 /* places that the kernels take at a time */ };

/* Places begin..end of the grid, both multiples of LB_BLOCK. `plain`: a particle in every place,
 * all with four links and the mass that most of the body has. */
typedef struct lb_run {
    int begin, end;
    bool plain;
} lb_run;

/* All by place. Matrices without xy and yy are multiples of one; where there is no particle no
 * link is set, and the mobility is 0 or there is nothing to move. */
typedef struct lb_grid_arrays {
    const double *ahead_x, *ahead_y;                       /* x(t) */
    double *behind_x, *behind_y;                           /* x(t-1), overwritten by x(t+1) */
    const double *force_x, *force_y;                       /* F(t); NULL: no loads */
    const double *mobility_xx, *mobility_xy, *mobility_yy; /* mu M^-1; NULL: by counting links */
    const double *mass_xx, *mass_xy, *mass_yy;             /* M; only where mu < 1 */
    const uint8_t (*links)[FW_DIRECTIONS];                 /* of each block, a bit per place */
    fw_sym2 plain_mobility, plain_mass;                    /* of plain runs */
    double rest_square; /* M0^2 of all, where masses follow from the number of links */
    double mu;
} lb_grid_arrays;

typedef struct lb_displacement_kernels {
    /* One step of a row whose neighbours to the north and south lie at those distances; what passed
     * is put in the ledger. */
    void (*advance)(const lb_grid_arrays *arrays, const lb_run *runs, int run_count, int north,
                    int south, fw_solid_ledger *passed);
    /* Adds to sums[k], for each of `count` places from one on that is a multiple of LB_BLOCK,
     *     sum_links |2 f - V|^2 + weight |2 f_0/M0 - V|^2,
     * which is four times the sum of squares of what a body has beyond a motion with velocity V. */
    void (*add_squares)(const lb_grid_arrays *arrays, int place, int count, int north, int south,
                        fw_vec2 velocity, double weight, double *sums);
} lb_displacement_kernels;

FW_KERNELS(lb_displacement_kernels, lb_displacements);

#endif
