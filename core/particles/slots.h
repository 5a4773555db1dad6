/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slots.h - neighbours of FW_BLOCK = 8 particles at a time, as kernels want them.
 *
 * Particles of a body are cut into blocks of 8 in the order of their numbers, one for each lane of
 * a vector. A block's neighbours are written down in slots: a slot holds at most one neighbour for
 * each lane, and its mask says for which lanes it holds one.
 *     offset slots   lane k's neighbour is particle first + k + offset: eight neighbours are one
 *                    contiguous load. In a lattice, whose particles are numbered along its rows, a
 *                    block has hardly more such slots than a particle has neighbours.
 *     gather slots   each lane's neighbour has a number of its own, in a row: for what has flowed,
 *                    and for other bodies.
 * A block's slots stand in three runs, neighbours of lower bodies, of its own and of higher ones,
 * each of one kind; along a run, and from run to run, every lane's neighbours ascend. So sums over
 * slots are sums over ascending neighbours, whatever the kinds.
 *
 * Where a body has lost its order its particles are numbered anew for all this, those next to each
 * other in space following each other. What ascends are always the solid's own numbers. */
#ifndef FW_SLOTS_H
#define FW_SLOTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { FW_LANES = 8, FW_SLOT_RUNS = 3, FW_RUN_OWN = 1 };

typedef struct fw_slot_head {
    uint32_t begin;               /* first slot of the block */
    uint32_t count[FW_SLOT_RUNS]; /* slots of each run */
    bool gathered[FW_SLOT_RUNS];
    /* Of near slots: along its own run every lane of every slot finds some particle of its body.
     * Then masks may be left alone: whoever is not in them is out of reach. */
    bool whole;
} fw_slot_head;

/* The slots of some blocks. */
typedef struct fw_slots {
    fw_slot_head *head; /* of each block */
    int32_t *offset;    /* of each slot; of a gather slot, its row */
    uint8_t *mask;      /* bit k: it holds a neighbour for lane k */
    int32_t (*row)[FW_LANES];
    uint32_t count, row_count;
    size_t capacity, row_capacity;
    bool lent; /* head belongs to whoever made the slots; so do offset and mask as long as this */
} fw_slots;

/* Some blocks of one body, for a thread to work on. */
typedef struct fw_chunk {
    int body, first, count;   /* particles first .. first + count - 1, in the lists' order */
    int body_first, body_end; /* of the whole body */
    /* Of each run: may there be offset slots, whose neighbours ascend by themselves? */
    bool in_order[FW_SLOT_RUNS];
    fw_slots far, near; /* see neighbour_lists.h */
} fw_chunk;

/* Room for so many more; false without memory. Nothing that is there is lost. */
bool fw_slots_reserve(fw_slots *slots, size_t more, size_t more_rows);

static inline int fw_chunk_blocks(const fw_chunk *chunk)
{
    return (chunk->count + FW_LANES - 1) / FW_LANES;
}

/* Which lanes of a block hold a particle. */
static inline uint8_t fw_chunk_lanes(const fw_chunk *chunk, int block)
{
    const int left = chunk->count - block * FW_LANES;
    return left >= FW_LANES ? 0xff : (uint8_t)((1 << left) - 1);
}

#endif
