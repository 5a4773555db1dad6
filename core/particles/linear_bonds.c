/* SPDX-License-Identifier: GPL-3.0-or-later */
/* linear_bonds.c - bonds sorted into slots. State: fw_linear_bonds, the caller's. Start reading at
 * fill(). */
#include "linear_bonds.h"

#include "core/array.h"

#include <stdlib.h>
#include <string.h>

#define ROOT_3 1.73205080756887729353

/* Where bonds differ from each other; of all of them. */
typedef struct bond_table {
    const fw_linear_neighbours *of;
    double k1;
    bool compensated;
} bond_table;

typedef struct bond_weight {
    double plain, turning;
} bond_weight;

/* A bond is the edge of the triangle to its left, with the neighbour 60 degrees on, and of the one
 * to its right. A triangle (a, b, c), counter-clockwise, adds the potential
 * -(sqrt3/2) k1 (u_a x u_b + u_b x u_c + u_c x u_a); edges between two triangles cancel. */
static bond_weight weight_of(const bond_table *table, int i, int alpha)
{
    const int32_t *around = table->of[i];
    const int left = around[(alpha + 1) % FW_BOND_DIRECTIONS] >= 0;
    const int right = around[(alpha + FW_BOND_DIRECTIONS - 1) % FW_BOND_DIRECTIONS] >= 0;
    if (!table->compensated) return (bond_weight){table->k1, 0};
    return (bond_weight){0.5 * (left + right) * table->k1,
                         -0.5 * ROOT_3 * table->k1 * (left - right)};
}

/* The slots of a block for one direction. */
typedef struct slot_group {
    uint32_t count;
    fw_bond_slot slot[FW_LANES];
} slot_group;

/* The slot of that bond, which is made where there is none. */
static fw_bond_slot *slot_of(slot_group *group, int32_t offset, int direction)
{
    uint32_t s = 0;
    while (s < group->count && group->slot[s].offset != offset) ++s;
    if (s == group->count)
        group->slot[group->count++] =
            (fw_bond_slot){.offset = offset, .weights = -1, .direction = (uint8_t)direction};
    return &group->slot[s];
}

/* Makes room for another group. */
static bool reserve(fw_linear_bonds *bonds, uint32_t slot_count, uint32_t *capacity)
{
    if (slot_count + FW_LANES <= *capacity) return true;
    *capacity += *capacity / 2 + FW_LANES;
    fw_bond_slot *more = realloc(bonds->slots, *capacity * sizeof *more);
    if (more) bonds->slots = more;
    return more;
}

/* Writes slots and counts their weights. False: no memory. */
static bool fill(fw_linear_bonds *bonds, const bond_table *table)
{
    uint32_t slot_count = 0;
    /* Of whole rows there is one for each direction of a block. */
    uint32_t capacity = (uint32_t)(bonds->count / FW_LANES + 1) * FW_BOND_DIRECTIONS;
    capacity += capacity / 8 + FW_LANES;
    bonds->slots = malloc(capacity * sizeof *bonds->slots);
    if (!bonds->slots) return false;
    bonds->weight_count = 0;
    for (int first = 0; first < bonds->count; first += FW_LANES) {
        const int end = first + FW_LANES < bonds->count ? first + FW_LANES : bonds->count;
        bonds->begin[first / FW_LANES] = slot_count;
        for (int alpha = 0; alpha < FW_BOND_DIRECTIONS; ++alpha) {
            slot_group group = {.count = 0};
            for (int i = first; i < end; ++i) {
                const int32_t neighbour = table->of[i][alpha];
                if (neighbour < 0) continue;
                fw_bond_slot *slot = slot_of(&group, neighbour - i, alpha);
                slot->mask |= (uint8_t)(1 << (i - first));
                if (slot->weights >= 0) continue;
                const bond_weight weight = weight_of(table, i, alpha);
                if (weight.plain != table->k1 || weight.turning != 0)
                    slot->weights = (int32_t)bonds->weight_count++;
            }
            if (!reserve(bonds, slot_count, &capacity)) return false;
            memcpy(bonds->slots + slot_count, group.slot, group.count * sizeof *group.slot);
            slot_count += group.count;
        }
    }
    bonds->begin[(bonds->count + FW_LANES - 1) / FW_LANES] = slot_count;
    return true;
}

static void fill_weights(fw_linear_bonds *bonds, const bond_table *table)
{
    for (int block = 0; block * FW_LANES < bonds->count; ++block)
        for (uint32_t s = bonds->begin[block]; s < bonds->begin[block + 1]; ++s) {
            const fw_bond_slot *slot = &bonds->slots[s];
            for (int k = 0; k < FW_LANES && slot->weights >= 0; ++k) {
                if (!(slot->mask >> k & 1)) continue;
                const bond_weight weight = weight_of(table, block * FW_LANES + k, slot->direction);
                bonds->weights[slot->weights].plain[k] = weight.plain;
                bonds->weights[slot->weights].turning[k] = weight.turning;
            }
        }
}

static fw_status no_memory(const fw_linear_bonds *bonds, fw_error *error)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory for the bonds of %d particles",
                   bonds->count);
}

fw_status fw_linear_bonds_create(fw_linear_bonds *bonds, int count, double k1, bool compensated,
                                 const fw_linear_neighbours *of, fw_error *error)
{
    const bond_table table = {of, k1, compensated};
    *bonds = (fw_linear_bonds){.count = count};
    bonds->begin = fw_array_allocate((size_t)count / FW_LANES + 2, sizeof *bonds->begin);
    if (!bonds->begin) return no_memory(bonds, error);
    if (!fill(bonds, &table)) return no_memory(bonds, error);
    bonds->weights = fw_array_allocate(bonds->weight_count, sizeof *bonds->weights);
    if (!bonds->weights) return no_memory(bonds, error);
    fill_weights(bonds, &table);
    return FW_OK;
}

void fw_linear_bonds_release(fw_linear_bonds *bonds)
{
    free(bonds->begin);
    free(bonds->slots);
    free(bonds->weights);
    *bonds = (fw_linear_bonds){0};
}
