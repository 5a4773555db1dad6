/* SPDX-License-Identifier: GPL-3.0-or-later */
/* linear_kernels.h - the loops of linear_lattice.c. */
#ifndef FW_LINEAR_KERNELS_H
#define FW_LINEAR_KERNELS_H

#include "core/instruction_set.h"
#include "linear_bonds.h"

typedef struct fw_linear_kernels {
    /* Of the particles of blocks begin to end - 1. */
    void (*forces)(const fw_linear_task *task, int begin, int end, double *x, double *y);
    /* Half of each bond's energy, and of u_i . (turning force) with displacements counted from
     * `middle`. */
    void (*energies)(const fw_linear_task *task, fw_vec2 middle, int begin, int end,
                     double *energy);
} fw_linear_kernels;

FW_KERNELS(fw_linear_kernels, fw_linear_loops);

#endif
