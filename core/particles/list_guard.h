/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_guard.h - how much longer a list of neighbours that was made for other positions holds.
 *
 * The list has all pairs that were closer than `listed`; wanted are all that are now closer than
 * `reach`. A pair that was at distance r > listed must come closer by r - reach to be missed. The
 * displacements of the particles of each cell lie in a box; how much two particles of two cells may
 * have come closer is at most the diagonal of what holds both boxes. Cells so far apart that even
 * the box of all displacements does not bring them together need not be compared. */
#ifndef FW_LIST_GUARD_H
#define FW_LIST_GUARD_H

#include "core/particles/cells.h"

/* Of displacements. */
typedef struct fw_list_box {
    double left, right, low, high;
} fw_list_box;

/* No pair is missed as long as no two particles come closer by more than this; negative: one may
 * be missed already. `cells`, of size `listed` at least, still hold the particles as they lay at
 * built_x/y; `boxes`: room for one per cell. */
double fw_list_guard_slack(const fw_cells *cells, const double *built_x, const double *built_y,
                           const double *x, const double *y, double listed, double reach,
                           fw_list_box *boxes);

#endif
