/* SPDX-License-Identifier: GPL-3.0-or-later */
/* linear_bonds.h - the bonds of the linear lattice for eight particles at a time, and its loops.
 *
 * The bonds of a block of 8 particles stand in slots, direction after direction. A slot holds those
 * of one direction whose neighbour's number is `offset` more than the particle's own: in a lattice
 * numbered along its rows that is one slot for each direction, and its eight neighbours are one
 * contiguous load. Bonds never change. */
#ifndef FW_LINEAR_BONDS_H
#define FW_LINEAR_BONDS_H

#include "core/instruction_set.h"
#include "core/particles/slots.h"
#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>
#include <stdint.h>

enum { FW_BOND_DIRECTIONS = 6 };

/* The neighbour of a particle in each direction, or -1. What the bond with it contributes to the
 * force on the particle, for stretch d = u_j - u_i, is
 *     axial e (e . d) + plain d + turning z x d. */
typedef int32_t fw_linear_neighbours[FW_BOND_DIRECTIONS];

/* plain and turning of the eight bonds of a slot. */
typedef struct fw_bond_weights {
    double plain[FW_LANES], turning[FW_LANES];
} fw_bond_weights;

typedef struct fw_bond_slot {
    int32_t offset;
    int32_t weights; /* -1: k1 and 0 for all */
    uint8_t direction;
    uint8_t mask; /* bit k: lane k has such a bond */
} fw_bond_slot;

typedef struct fw_linear_bonds {
    int count;       /* particles */
    uint32_t *begin; /* block b has the slots begin[b] .. begin[b + 1] - 1 */
    fw_bond_slot *slots;
    fw_bond_weights *weights;
    uint32_t weight_count;
} fw_linear_bonds;

/* `compensated`: with surface forces. FW_SYSTEM_FAILED without memory; to be released then too. */
fw_status fw_linear_bonds_create(fw_linear_bonds *bonds, int count, double k1, bool compensated,
                                 const fw_linear_neighbours *of, fw_error *error);
void fw_linear_bonds_release(fw_linear_bonds *bonds);

/* Everything that forces and energies are made of. Eight numbers before and behind each array may
 * be read. */
typedef struct fw_linear_task {
    const fw_linear_bonds *bonds;
    double k1, k2;
    fw_vec2 direction[FW_BOND_DIRECTIONS];
    const double *x, *y, *home_x, *home_y;
} fw_linear_task;

/* The loops of linear_lattice.c. */
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
