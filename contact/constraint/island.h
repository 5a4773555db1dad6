/* SPDX-License-Identifier: GPL-3.0-or-later */
/* island.h - which rows belong together: those that share an end that can move. (All integrators
 * are explicit, so that bodies couple through shared ends only.) Within an island rows are put in
 * an order in which those that share an end lie near each other (Cuthill and McKee, 1969): along a
 * contact between two faces, each row then meets the two or three before it. */
#ifndef FW_ISLAND_H
#define FW_ISLAND_H

#include "contact/constraint/joint.h"

typedef struct joint_islands {
    int end_capacity, row_capacity;
    int *begin;    /* per end and one more: its rows in `incident` */
    int *incident; /* room for three per row */
    int *order;    /* rows, island after island */
    int *scratch;  /* per row */
    int *seen;     /* per row */
    int count;     /* rows in `order` so far */
} joint_islands;

/* Finds which rows meet at which end. FW_SYSTEM_FAILED without memory. */
fw_status joint_islands_begin(joint_islands *islands, const fw_joint_end *ends, int end_count,
                              const fw_joint_row *rows, int row_count, fw_error *error);
void joint_islands_release(joint_islands *islands);

/* The next island that has a fresh row, as a list of rows; NULL: there is none any more. */
const int *joint_islands_next(joint_islands *islands, const fw_joint_end *ends,
                              const fw_joint_row *rows, int row_count, int *first, int *count);

static inline bool joint_moves(const fw_joint_end *end)
{
    return end->mobility.xx > 0 || end->mobility.yy > 0;
}

#endif
