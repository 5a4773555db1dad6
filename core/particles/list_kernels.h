/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_kernels.h - the loops of neighbour_lists.c. */
#ifndef FW_LIST_KERNELS_H
#define FW_LIST_KERNELS_H

#include "core/particles/cells.h"
#include "core/particles/slots.h"
#include "near_words.h"

#include "core/instruction_set.h"

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
