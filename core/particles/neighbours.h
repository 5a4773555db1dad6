/* SPDX-License-Identifier: GPL-3.0-or-later */
/* neighbours.h - who is near whom at one instant, by any radius: for each particle the list of all
 * others within it, ascending. While particles move there is neighbour_lists.h. */
#ifndef FW_NEIGHBOURS_H
#define FW_NEIGHBOURS_H

#include "core/particles/cells.h"

#include <stddef.h>

typedef struct fw_neighbours {
    /* The neighbours of i are list[begin[i]] .. list[begin[i + 1] - 1]. */
    int count;
    size_t *begin;
    int *list;
    double radius;
    fw_cells cells; /* private */
} fw_neighbours;

/* radius > 0. FW_SYSTEM_FAILED without memory. */
fw_status fw_neighbours_create(fw_neighbours **neighbours, const double *x, const double *y,
                               int count, double radius, fw_error *error);
void fw_neighbours_destroy(fw_neighbours *neighbours);

#endif
