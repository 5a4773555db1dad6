/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_population_kernels.h - the loop of lb_step.c over particles that have all four links. */
#ifndef FW_LB_POPULATION_KERNELS_H
#define FW_LB_POPULATION_KERNELS_H

#include "core/instruction_set.h"
#include "core/lattice.h"
#include "core/solid.h"

/* What the particles of one loop read and write; index 0 is the first of them. Matrices without xy
 * and yy are multiples of one; what is not used is NULL. */
typedef struct lb_population_arrays {
    double *field_x[FW_DIRECTIONS], *field_y[FW_DIRECTIONS];  /* that arrived */
    double *rest_x, *rest_y;                                  /* f_0; NULL: all M0 are 0 */
    double *x, *y;                                            /* r */
    const double *force_x, *force_y;                          /* F; NULL: no loads */
    const double *inverse_xx, *inverse_xy, *inverse_yy;       /* M^-1 */
    const double *rest_mass_xx, *rest_mass_xy, *rest_mass_yy; /* M0 */
    const double *mass_xx, *mass_xy, *mass_yy;                /* M */
} lb_population_arrays;

typedef struct lb_population_kernels {
    /* One step of `count` particles with kappa = 1; what passed is added to the ledger. */
    void (*relax)(const lb_population_arrays *arrays, int count, double mu,
                  fw_solid_ledger *ledger);
} lb_population_kernels;

FW_KERNELS(lb_population_kernels, lb_populations);

#endif
