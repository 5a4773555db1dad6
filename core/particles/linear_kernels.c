/* SPDX-License-Identifier: GPL-3.0-or-later */
/* linear_kernels.c - forces and energies of the linear lattice (Popov & Filippov Eq 2), eight
 * particles at a time; compiled once for each instruction set. Keeps no state. Each particle adds
 * its bonds in the order of directions, and lanes without a bond add +0. Start reading at
 * bond_at(). */
#include "linear_bonds.h"

#include "core/noise_vectors.h"
#include "core/vectors.h"

#include <assert.h>

static_assert(sizeof((fw_bond_weights *)0)->plain / sizeof(double) == FW_BLOCK,
              "a weight for each particle of a block");

/* A bond in each lane. */
typedef struct fw_bond_lanes {
    fw_vector_pair stretch; /* u_j - u_i */
    fw_vector axial;        /* e . stretch */
    fw_vec2 e;
    fw_vector plain, turning;
    fw_mask held;
} fw_bond_lanes;

FW_INLINE fw_vector stretch_of(const double *at, const double *home, int i, int offset)
{
    return (fw_load(at + i + offset) - fw_load(at + i)) -
           (fw_load(home + i + offset) - fw_load(home + i));
}

FW_INLINE fw_bond_lanes bond_at(const fw_linear_task *task, const fw_bond_slot *slot, int i,
                                int part)
{
    fw_bond_lanes bond = {.stretch = {stretch_of(task->x, task->home_x, i, slot->offset),
                                      stretch_of(task->y, task->home_y, i, slot->offset)},
                          .e = task->direction[slot->direction],
                          .plain = fw_splat(task->k1),
                          .turning = fw_splat(0),
                          .held = fw_mask_of(slot->mask, part)};
    bond.axial = bond.e.x * bond.stretch.x + bond.e.y * bond.stretch.y;
    if (slot->weights >= 0) {
        const fw_bond_weights *weights = &task->bonds->weights[slot->weights];
        bond.plain = fw_load(weights->plain + part * FW_WIDTH);
        bond.turning = fw_load(weights->turning + part * FW_WIDTH);
    }
    return bond;
}

static uint8_t lanes_of(const fw_linear_bonds *bonds, int block)
{
    return fw_first_lanes(bonds->count - block * FW_BLOCK);
}

static void forces(const fw_linear_task *task, int begin, int end, double *x, double *y)
{
    const fw_linear_bonds *bonds = task->bonds;
    for (int block = begin; block < end; ++block)
        for (int part = 0; part < FW_PARTS; ++part) {
            const int i = block * FW_BLOCK + part * FW_WIDTH;
            fw_vector force_x = fw_splat(0), force_y = fw_splat(0);
            for (uint32_t s = bonds->begin[block]; s < bonds->begin[block + 1]; ++s) {
                const fw_bond_lanes bond = bond_at(task, &bonds->slots[s], i, part);
                const fw_vector axial = task->k2 * bond.axial;
                const fw_vector along_x = axial * bond.e.x + bond.plain * bond.stretch.x;
                const fw_vector along_y = axial * bond.e.y + bond.plain * bond.stretch.y;
                force_x += fw_keep(bond.held, along_x - bond.turning * bond.stretch.y);
                force_y += fw_keep(bond.held, along_y + bond.turning * bond.stretch.x);
            }
            const fw_mask held = fw_mask_of(lanes_of(bonds, block), part);
            fw_store_some(x + i, held, force_x);
            fw_store_some(y + i, held, force_y);
        }
}

static void energies(const fw_linear_task *task, fw_vec2 middle, int begin, int end, double *energy)
{
    const fw_linear_bonds *bonds = task->bonds;
    for (int block = begin; block < end; ++block)
        for (int part = 0; part < FW_PARTS; ++part) {
            const int i = block * FW_BLOCK + part * FW_WIDTH;
            const fw_vector moved_x = fw_load(task->x + i) - fw_load(task->home_x + i) - middle.x;
            const fw_vector moved_y = fw_load(task->y + i) - fw_load(task->home_y + i) - middle.y;
            fw_vector sum = fw_splat(0);
            for (uint32_t s = bonds->begin[block]; s < bonds->begin[block + 1]; ++s) {
                const fw_bond_lanes bond = bond_at(task, &bonds->slots[s], i, part);
                const fw_vector_pair d = bond.stretch;
                const fw_vector square = d.x * d.x + d.y * d.y;
                const fw_vector turned = moved_y * d.x - moved_x * d.y; /* moved . (z x d) */
                sum += fw_keep(bond.held,
                               0.25 * (task->k2 * bond.axial * bond.axial + bond.plain * square) -
                                   0.5 * bond.turning * turned);
            }
            fw_store_some(energy + i, fw_mask_of(lanes_of(bonds, block), part), sum);
        }
}

const fw_linear_kernels FW_KERNELS_HERE(fw_linear_loops) = {.forces = forces, .energies = energies};
