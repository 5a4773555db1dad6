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
    fw_automaton *body;
    fw_half_step step[FW_COLOURS]; /* of the colour that moves in even ticks, in odd ones */
    int ticks, strips;
    fw_status status; /* of what breaks; then there is but one strip */
    fw_error *error;
} front;

/* Bonds break at once: a bond of this row joins it to rows that have moved one tick less, and have
 * yet to be moved by what breaks. */
static void move_row(front *f, int tick, int row)
{
    fw_automaton *body = f->body;
    const fw_half_step *step = &f->step[tick & 1];
    fw_automaton_share share;
    fw_half_step_move_row(step, row, &share);
    if (fw_half_step_passes(step)) body->share[tick * body->row_count + row] = share;
    if (share.torn && f->status == FW_OK)
        f->status = fw_automaton_tear_row(body, step->colour, row, tick, f->error);
}

/* The first row of a strip, or one past the last row of all. */
static int begin_of(const front *f, int strip)
{
    return (int)((int64_t)f->body->row_count * strip / f->strips);
}

static void move_strip(front *f, int strip)
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
static void fill_wedge(front *f, int middle)
{
    for (int tick = 1; tick < f->ticks; ++tick)
        for (int row = middle - tick; row < middle + tick; ++row) move_row(f, tick, row);
}

static void run_front(front *f)
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

static int threads_of(const fw_automaton *body)
{
    return body->head.count >= FW_THREADS_FROM ? omp_get_max_threads() : 1;
}

static int strips_of(const fw_automaton *body, int depth)
{
    const int threads = threads_of(body);
    const int room = body->row_count / (2 * depth);
    return threads < room ? threads : room > 1 ? room : 1;
}

/* Takes up to `most` ticks; *taken: how many. */
static fw_status advance_front(fw_automaton *body, int most, int *taken, fw_error *error)
{
    const int moving = fw_automaton_moving(body);
    front f = {.body = body,
               .step = {fw_half_step_of(body, moving), fw_half_step_of(body, !moving)},
               .error = error};
    const bool passes = fw_half_step_passes(&f.step[0]);
    f.ticks = depth_of(body, most, passes);
    f.strips = body->breaks ? 1 : strips_of(body, f.ticks);
    run_front(&f);
    FW_TRY(f.status);
    fw_automaton_sort_tears(body);
    for (int tick = 0; tick < f.ticks; ++tick) {
        if (passes) fw_automaton_book(body, body->share + (size_t)tick * (size_t)body->row_count);
        fw_automaton_book_tears(body, tick);
    }
    fw_automaton_tick(body, f.ticks);
    *taken = f.ticks;
    return FW_OK;
}

fw_status fw_automaton_advance_free(fw_solid *solid, int ticks, fw_error *error)
{
    fw_automaton *body = fw_automaton_of(solid);
    /* Rows in a ring have no first one, and what breaks in one strip reaches into the next. */
    const bool one_by_one = body->ring_of_rows || (body->breaks && threads_of(body) > 1);
    while (ticks > 0) {
        const int left = FW_RECENTRE_EVERY - (int)(solid->ticks % FW_RECENTRE_EVERY);
        int taken = 1;
        if (one_by_one) {
            FW_TRY(fw_automaton_advance(solid, NULL, 0, error));
        } else {
            FW_TRY(advance_front(body, ticks < left ? ticks : left, &taken, error));
        }
        ticks -= taken;
    }
    return FW_OK;
}
