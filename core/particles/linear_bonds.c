/* SPDX-License-Identifier: GPL-3.0-or-later */
/* linear_bonds.c - bonds sorted into slots. State: fw_linear_bonds, the caller's. Start reading at
 * fill(). */
#include "linear_bonds.h"

#include "core/array.h"

#include <stdlib.h>

typedef const fw_linear_bond (*fw_bond_table)[FW_BOND_DIRECTIONS];

/* Has this block a slot for that bond, from `begin` on? */
static uint32_t place_of(const fw_linear_bonds *bonds, uint32_t begin, uint32_t end, int32_t offset)
{
    uint32_t s = begin;
    while (s < end && bonds->slots[s].offset != offset) ++s;
    return s;
}

/* Writes slots, where there is room for them, and counts them and their weights. */
static uint32_t fill(fw_linear_bonds *bonds, double k1, fw_bond_table of)
{
    uint32_t slot_count = 0;
    bonds->weight_count = 0;
    for (int first = 0; first < bonds->count; first += FW_LANES) {
        const int end = first + FW_LANES < bonds->count ? first + FW_LANES : bonds->count;
        bonds->begin[first / FW_LANES] = slot_count;
        for (int alpha = 0; alpha < FW_BOND_DIRECTIONS; ++alpha) {
            const uint32_t begin = slot_count;
            for (int i = first; i < end; ++i) {
                const fw_linear_bond *bond = &of[i][alpha];
                if (bond->neighbour < 0) continue;
                const int32_t offset = bond->neighbour - i;
                const uint32_t s = place_of(bonds, begin, slot_count, offset);
                fw_bond_slot *slot = &bonds->slots[s];
                if (s == slot_count) {
                    *slot = (fw_bond_slot){
                        .offset = offset, .weights = -1, .direction = (uint8_t)alpha};
                    slot_count += 1;
                }
                slot->mask |= (uint8_t)(1 << (i - first));
                if (slot->weights < 0 && (bond->plain != k1 || bond->turning != 0))
                    slot->weights = (int32_t)bonds->weight_count++;
            }
        }
    }
    bonds->begin[(bonds->count + FW_LANES - 1) / FW_LANES] = slot_count;
    return slot_count;
}

static void fill_weights(fw_linear_bonds *bonds, fw_bond_table of)
{
    for (int block = 0; block * FW_LANES < bonds->count; ++block)
        for (uint32_t s = bonds->begin[block]; s < bonds->begin[block + 1]; ++s) {
            const fw_bond_slot *slot = &bonds->slots[s];
            for (int k = 0; k < FW_LANES && slot->weights >= 0; ++k) {
                if (!(slot->mask >> k & 1)) continue;
                const fw_linear_bond *bond = &of[block * FW_LANES + k][slot->direction];
                bonds->weights[slot->weights].plain[k] = bond->plain;
                bonds->weights[slot->weights].turning[k] = bond->turning;
            }
        }
}

static fw_status no_memory(const fw_linear_bonds *bonds, fw_error *error)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory for the bonds of %d particles",
                   bonds->count);
}

fw_status fw_linear_bonds_create(fw_linear_bonds *bonds, int count, double k1, fw_bond_table of,
                                 fw_error *error)
{
    const size_t most = (size_t)count * FW_BOND_DIRECTIONS;
    *bonds = (fw_linear_bonds){.count = count};
    bonds->begin = fw_array_allocate((size_t)count / FW_LANES + 2, sizeof *bonds->begin);
    bonds->slots = fw_array_allocate(most + 1, sizeof *bonds->slots);
    if (!bonds->begin || !bonds->slots) return no_memory(bonds, error);
    const uint32_t slot_count = fill(bonds, k1, of);
    /* In a lattice they are an eighth of what there might have been. */
    fw_bond_slot *shorter = realloc(bonds->slots, (slot_count + 1) * sizeof *bonds->slots);
    if (shorter) bonds->slots = shorter;
    bonds->weights = fw_array_allocate(bonds->weight_count, sizeof *bonds->weights);
    if (!bonds->weights) return no_memory(bonds, error);
    fill_weights(bonds, of);
    return FW_OK;
}

void fw_linear_bonds_release(fw_linear_bonds *bonds)
{
    free(bonds->begin);
    free(bonds->slots);
    free(bonds->weights);
    *bonds = (fw_linear_bonds){0};
}
