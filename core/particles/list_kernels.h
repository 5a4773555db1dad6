/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_kernels.h - the loops of neighbour_lists.c. */
#ifndef FW_LIST_KERNELS_H
#define FW_LIST_KERNELS_H

#include "core/particles/cells.h"
#include "core/particles/slots.h"

#include "core/instruction_set.h"

/* Which particles are near a block: for each word of eight particles, a byte per particle with a
 * bit for each lane that it is near to. A hash table; zeroed memory is an empty one. */
typedef struct fw_near_words {
    int *word;       /* number of particle / 8; -1: free */
    uint64_t *bytes; /* of each */
    int *used;       /* places in the table, `count` of them */
    int count, capacity;
    int last;    /* place of the word that was written last */
    bool failed; /* without memory */
} fw_near_words;

/* Where that word is or may be put: there is always a free place. Knuth's multiplicative hash (The
 * Art of Computer Programming 3, 6.4): 2^32 over the golden ratio. */
static inline int fw_near_words_place(const fw_near_words *words, int word)
{
    const unsigned last = (unsigned)words->capacity - 1;
    unsigned at = (unsigned)word * 0x9e3779b1u >> 8 & last;
    while (words->word[at] >= 0 && words->word[at] != word) at = (at + 1) & last;
    return (int)at;
}

void fw_near_words_release(fw_near_words *words);
/* Doubles the table, or begins one; false without memory. */
bool fw_near_words_grow(fw_near_words *words);

typedef struct fw_list_kernels {
    /* Fills chunk->far with all neighbours closer than `reach`, by cells of at least that size.
     * Runs have offset slots as long as these are no more than `favour` times as many as gather
     * slots, and only in runs that are in order. The solid's numbers are `number` of the lists';
     * NULL: the same. False without memory. */
    bool (*build)(fw_chunk *chunk, const fw_cells *cells, const int *number, const double *x,
                  const double *y, double reach, double favour, fw_near_words *words);
    /* Fills chunk->near, which has room for all of chunk->far, with those that are closer. */
    void (*renew)(fw_chunk *chunk, const double *x, const double *y, double reach);
    /* The least squared distance of near neighbours; INFINITY where there are none. */
    double (*closest)(const fw_chunk *chunk, const double *x, const double *y);
} fw_list_kernels;

FW_KERNELS(fw_list_kernels, fw_lists);

#endif
