/* SPDX-License-Identifier: GPL-3.0-or-later */
/* langevin_kernels.h - the loops of langevin.c. */
#ifndef FW_LANGEVIN_KERNELS_H
#define FW_LANGEVIN_KERNELS_H

#include "core/instruction_set.h"
#include "core/vec2.h"

#include <stdbool.h>
#include <stdint.h>

/* The numbers of one step, see langevin.h. */
typedef struct fw_baoab {
    double half;     /* dt/2 */
    double keep;     /* c = e^{-damping dt} */
    double lose;     /* 1 - c^2, exact for small damping */
    double shake;    /* s sqrt(m) */
    bool thermostat; /* damping acts */
} fw_baoab;

typedef struct fw_move_task {
    fw_baoab baoab;
    uint64_t seed, ticks;
    double *x, *y, *velocity_x, *velocity_y;
    const double *force_x, *force_y;
    const double *external_x, *external_y;     /* NULL: none */
    const double *constraint_x, *constraint_y; /* NULL: none */
    const double *mass, *inverse_mass, *root_inverse_mass;
    fw_vec2 common; /* path that `stray` is measured from */
} fw_move_task;

/* What passed through the bounds of some particles. */
typedef struct fw_move_sums {
    double work, dissipated, heat;
    fw_vec2 external, drag;
    fw_vec2 path; /* sum of the displacements of particles */
    double stray; /* the most that one of them differs from `common`, squared */
} fw_move_sums;

typedef struct fw_langevin_kernels {
    /* Kick, drift, mix, drift of particles begin to end - 1; begin is a multiple of eight. */
    void (*move)(const fw_move_task *task, int begin, int end, fw_move_sums *sums);
    /* The second kick. */
    void (*kick)(const fw_move_task *task, int begin, int end);
} fw_langevin_kernels;

FW_KERNELS(fw_langevin_kernels, fw_langevin_loops);

#endif
