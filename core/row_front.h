/* SPDX-License-Identifier: GPL-3.0-or-later */
/* row_front.h - many ticks of a lattice in one sweep through memory, for solids whose rows ask for
 * nothing but their two neighbours.
 *
 * In a tick a row needs its neighbours as they were one tick earlier, and nobody reads what it
 * overwrites any more once they have moved on. So tick h of row s - h can follow tick h - 1 of row
 * s - h + 1 at once, while both are still in the cache: a front of as many rows as ticks runs
 * through the body.
 *
 * Threads have a strip of rows each. In each tick their fronts leave one row more at either end of
 * a strip behind, since its neighbour there belongs to somebody else; when all strips are done,
 * these wedges are filled, tick by tick. Each row sees the same numbers whoever moves it. */
#ifndef FW_ROW_FRONT_H
#define FW_ROW_FRONT_H

/* Takes a row through a tick, 0 to ticks - 1. Called from several threads where there are several
 * strips. */
typedef void fw_row_front_move(void *context, int tick, int row);

/* How many strips of so many rows as many threads may have, 1 at least. */
int fw_row_front_strips(int rows, int ticks, int threads);
/* Takes rows 0 to rows - 1 through all ticks. `strips` as above or fewer. */
void fw_row_front_run(int rows, int ticks, int strips, fw_row_front_move *move, void *context);

#endif
