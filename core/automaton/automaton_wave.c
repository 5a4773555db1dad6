/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_wave.c - many ticks in one sweep through memory (core/row_front.h). Keeps no state.
 * Start reading at fw_automaton_advance_free(). */
#include "automaton_sweep.h"

#include "core/row_front.h"

#include <omp.h>

/* Rows of a front should stay in the second cache. */
enum { FRONT_BYTES = 1 << 19 };

typedef struct front {
    fw_automaton *body;
    fw_half_step step[FW_COLOURS]; /* of the colour that moves in even ticks, in odd ones; rows
                                    * are in the cache already */
    fw_half_step first;            /* of tick 0, which fetches them */
    fw_status status;              /* of what breaks; then there is but one strip */
    fw_error *error;
} front;

/* Bonds break at once: a bond of this row joins it to rows that have moved one tick less, and have
 * yet to be moved by what breaks. */
static void move_row(void *context, int tick, int row)
{
    front *f = context;
    fw_automaton *body = f->body;
    const fw_half_step *step = tick == 0 ? &f->first : &f->step[tick & 1];
    fw_automaton_share share;
    fw_half_step_move_row(step, row, &share);
    if (fw_half_step_passes(step)) body->share[tick * body->row_count + row] = share;
    if (share.torn && f->status == FW_OK)
        f->status = fw_automaton_tear_row(body, step->colour, row, tick, f->error);
}

/* How many ticks a front takes, at most `most`: few enough for the cache, and if that takes several
 * sweeps, then equally many in each. */
static int depth_of(const fw_automaton *body, int most, bool passes)
{
    const int64_t bytes = (int64_t)sizeof(double[2]) * body->head.count / body->row_count;
    const int64_t fits = FRONT_BYTES / bytes;
    int depth = fits > 2 ? (fits < most ? (int)fits : most) : 2;
    if (passes && depth > FW_SHARED_TICKS) depth = FW_SHARED_TICKS;
    if (depth >= most) return most;
    const int sweeps = (most + depth - 1) / depth;
    return (most + sweeps - 1) / sweeps;
}

static int threads_of(const fw_automaton *body)
{
    return body->head.count >= FW_THREADS_FROM ? omp_get_max_threads() : 1;
}

/* Takes up to `most` ticks; *taken: how many. */
static fw_status advance_front(fw_automaton *body, int most, int *taken, fw_error *error)
{
    const int moving = fw_automaton_moving(body);
    front f = {.body = body,
               .step = {fw_half_step_of(body, moving), fw_half_step_of(body, !moving)},
               .error = error};
    f.first = f.step[0];
    f.step[0].move.fetches = f.step[1].move.fetches = false;
    const bool passes = fw_half_step_passes(&f.step[0]);
    const int ticks = depth_of(body, most, passes);
    const int strips =
        body->breaks ? 1 : fw_row_front_strips(body->row_count, ticks, threads_of(body));
    fw_row_front_run(body->row_count, ticks, strips, move_row, &f);
    FW_TRY(f.status);
    fw_automaton_sort_tears(body);
    for (int tick = 0; tick < ticks; ++tick) {
        if (passes) fw_automaton_book(body, body->share + (size_t)tick * (size_t)body->row_count);
        fw_automaton_book_tears(body, tick);
    }
    fw_automaton_tick(body, ticks);
    *taken = ticks;
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
