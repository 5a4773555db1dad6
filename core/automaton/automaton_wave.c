/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_wave.c - many ticks in one sweep through memory. Keeps no state.
 * Start reading at fw_automaton_advance_free().
 *
 * A row needs its two neighbours one tick earlier, and nobody reads what it overwrites any more
 * once they have moved on. So tick h of row s - h can follow tick h - 1 of row s - h + 1 at once,
 * while both are still in the cache: a front of as many rows as ticks runs through the body.
 *
 * Threads have a strip of rows each. In each tick their fronts leave one row more at either end of
 * a strip behind, since its neighbour there belongs to somebody else; when all strips are done,
 * these wedges are filled, tick by tick. Each row sees the same numbers whoever moves it. */
#include "automaton_sweep.h"

#include <omp.h>

/* Rows of a front should stay in the second cache. */
enum { FRONT_BYTES = 1 << 19 };

typedef struct front {
    fw_half_step step[FW_COLOURS]; /* of the colour that moves in even ticks, in odd ones */
    int ticks, strips;
} front;

static void move_row(const front *f, int tick, int row)
{
    const fw_automaton *body = f->step[0].body;
    fw_automaton_share share;
    fw_half_step_move_row(&f->step[tick & 1], row, &share);
    if (fw_half_step_passes(&f->step[0])) body->share[tick * body->row_count + row] = share;
}

/* The first row of a strip, or one past the last row of all. */
static int begin_of(const front *f, int strip)
{
    return (int)((int64_t)f->step[0].body->row_count * strip / f->strips);
}

static void move_strip(const front *f, int strip)
{
    const int begin = begin_of(f, strip), end = begin_of(f, strip + 1);
    const int left = strip > 0, right = strip < f->strips - 1;
    for (int head = begin; head < end + f->ticks - 1; ++head)
        for (int tick = 0; tick < f->ticks; ++tick) {
            const int row = head - tick;
            if (row >= begin + left * tick && row < end - right * tick) move_row(f, tick, row);
        }
}

/* What the strips on both sides of a row have left. */
static void fill_wedge(const front *f, int middle)
{
    for (int tick = 1; tick < f->ticks; ++tick)
        for (int row = middle - tick; row < middle + tick; ++row) move_row(f, tick, row);
}

static void run_front(const front *f)
{
#pragma omp parallel for schedule(static) num_threads(f->strips) if (f->strips > 1)
    for (int strip = 0; strip < f->strips; ++strip) move_strip(f, strip);
#pragma omp parallel for schedule(static) num_threads(f->strips) if (f->strips > 2)
    for (int strip = 1; strip < f->strips; ++strip) fill_wedge(f, begin_of(f, strip));
}

/* How many ticks a front takes, at most `most`. */
static int depth_of(const fw_automaton *body, int most, bool passes)
{
    const int64_t bytes = (int64_t)sizeof(double[2]) * body->head.count / body->row_count + 1;
    const int64_t fits = FRONT_BYTES / bytes;
    int depth = fits > 2 ? (fits < most ? (int)fits : most) : 2;
    if (passes && depth > FW_SHARED_TICKS) depth = FW_SHARED_TICKS;
    return depth < most ? depth : most;
}

static int strips_of(const fw_automaton *body, int depth)
{
    const int threads = body->head.count >= FW_THREADS_FROM ? omp_get_max_threads() : 1;
    const int room = body->row_count / (2 * depth);
    return threads < room ? threads : room > 1 ? room : 1;
}

/* Takes up to `most` ticks, and returns how many. */
static int advance_front(fw_automaton *body, int most)
{
    const int moving = fw_automaton_moving(body);
    front f = {.step = {fw_half_step_of(body, moving), fw_half_step_of(body, !moving)}};
    const bool passes = fw_half_step_passes(&f.step[0]);
    f.ticks = depth_of(body, most, passes);
    f.strips = strips_of(body, f.ticks);
    run_front(&f);
    for (int tick = 0; passes && tick < f.ticks; ++tick)
        fw_automaton_book(body, body->share + (size_t)tick * (size_t)body->row_count);
    return f.ticks;
}

fw_status fw_automaton_advance_free(fw_solid *solid, int ticks, fw_error *error)
{
    fw_automaton *body = fw_automaton_of(solid);
    /* A breakable body changes from tick to tick, and rows in a ring have no first one. */
    const bool one_by_one = body->breaks || body->ring_of_rows;
    while (ticks > 0) {
        const int left = FW_RECENTRE_EVERY - (int)(solid->ticks % FW_RECENTRE_EVERY);
        int taken = 1;
        if (one_by_one) {
            FW_TRY(fw_automaton_advance(solid, NULL, 0, error));
        } else {
            taken = advance_front(body, ticks < left ? ticks : left);
            fw_automaton_tick(body, taken);
        }
        ticks -= taken;
    }
    return FW_OK;
}
