/* SPDX-License-Identifier: GPL-3.0-or-later */
/* neighbours.h - who is near whom, while particles move, flow and leave.
 *
 * For each particle the list of all others within `radius + skin`, ascending; made anew when two
 * particles may have come closer to each other by more than `skin`. Whoever sums over a list must
 * let what lies beyond `radius` contribute exact zeros: then no result depends on when the list
 * was made. */
#ifndef FW_NEIGHBOURS_H
#define FW_NEIGHBOURS_H

#include "core/particles/cells.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct fw_neighbours {
    /* To be read by everybody: the neighbours of i are list[begin[i]] .. list[begin[i + 1] - 1]. */
    int count;
    size_t *begin;
    int *list;
    double radius, skin;
    int64_t generation; /* how often the list has been made */

    /* Private. */
    bool valid;
    size_t capacity;           /* of list */
    double *built_x, *built_y; /* positions at the last making */
    fw_cells cells;
} fw_neighbours;

/* radius > 0, skin >= 0. FW_SYSTEM_FAILED without memory. */
fw_status fw_neighbours_create(fw_neighbours **neighbours, int count, double radius, double skin,
                               fw_error *error);
void fw_neighbours_destroy(fw_neighbours *neighbours);

/* Makes the list anew if it must be. FW_SYSTEM_FAILED if there is no memory for a longer list; the
 * list is then empty. */
fw_status fw_neighbours_refresh(fw_neighbours *neighbours, const double *x, const double *y,
                                fw_error *error);

#endif
