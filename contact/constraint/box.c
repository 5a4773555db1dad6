/* SPDX-License-Identifier: GPL-3.0-or-later */
/* box.c - tractions within their limits: lines that hold exactly, but for those at a limit. State:
 * none. Start reading at joint_solve_box(). */
#include "band.h"

#include <math.h>
#include <stddef.h>

/* Rounds in which all lines may change, and all rounds. Most problems settle in a few. */
enum { ROUNDS_AT_ONCE = 30, ROUNDS = 480 };

/* Added to the diagonal of lines whose every end is shared by many, as of a grip on a piston: their
 * band is empty, and all that they have is in the columns. What a correction leaves of an error is
 * rounding over this, or this over the columns: least where both are the root of rounding. */
#define EMPTY 1e-8

static double shift_of(const joint_band *p, int line)
{
    return p->band[(size_t)line * (size_t)p->width] == 0 ? EMPTY : 0;
}

/* Which lines are at a limit is found by taking all that go beyond it to it, and back all that
 * would leave it; one at a time where that does not end. */
static int change_states(const joint_band *p, const double *limit, double *state,
                         bool one_at_a_time)
{
    int changes = 0, most_at = -1;
    double most = 0, largest = 0;
    for (int n = 0; n < p->count; ++n) largest = fmax(largest, fabs(p->lambda[n]));
    for (int n = 0; n < p->count; ++n) {
        const double bound = limit[n] / p->scale[n];
        const double beyond =
            state[n] == 0 ? fabs(p->lambda[n]) - bound : state[n] * (p->rest[n] - p->want[n]);
        if (!(beyond > 1e-14 * (1 + largest))) continue;
        changes += 1;
        if (beyond > most) most_at = n;
        most = fmax(most, beyond);
        if (!one_at_a_time) state[n] = state[n] == 0 ? (p->lambda[n] > 0 ? 1 : -1) : 0;
    }
    if (one_at_a_time && most_at >= 0)
        state[most_at] = state[most_at] == 0 ? (p->lambda[most_at] > 0 ? 1 : -1) : 0;
    return changes;
}

bool joint_solve_box(joint_system *system, const double *limit, int bandwidth, double *room)
{
    joint_band p = joint_band_open(system, bandwidth, room);
    double *state = p.s, *barrier = p.s_step;
    bool settled = false;
    for (int n = 0; n < p.count; ++n) {
        p.scale[n] = 1 / system->lines[n].length;
        p.want[n] = p.scale[n] * system->lines[n].wanted;
        state[n] = 0;
    }
    joint_band_fill(&p, system);
    for (int round = 0; round < ROUNDS && !settled; ++round) {
        for (int n = 0; n < p.count; ++n) {
            barrier[n] = state[n] == 0 ? shift_of(&p, n) : JOINT_HELD_OFF;
            p.lambda[n] = state[n] * limit[n] / p.scale[n];
        }
        joint_band_factorise(&p, barrier);
        for (int turn = 0; turn < JOINT_CORRECTIONS; ++turn) {
            joint_band_multiply(&p, p.lambda, p.rest);
            for (int n = 0; n < p.count; ++n)
                p.right[n] = state[n] == 0 ? p.want[n] - p.rest[n] : 0;
            joint_band_solve(&p, p.right, p.step);
            for (int n = 0; n < p.count; ++n)
                if (state[n] == 0) p.lambda[n] += p.step[n];
        }
        joint_band_multiply(&p, p.lambda, p.rest);
        settled = change_states(&p, limit, state, round >= ROUNDS_AT_ONCE) == 0;
    }
    /* What is at its limit is so to the last bit: whoever asks takes less for sticking. */
    for (int n = 0; n < p.count; ++n)
        system->lambda[n] = state[n] == 0
                                ? fmin(fmax(p.lambda[n] * p.scale[n], -limit[n]), limit[n])
                                : state[n] * limit[n];
    return settled;
}
