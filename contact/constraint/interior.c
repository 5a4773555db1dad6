/* SPDX-License-Identifier: GPL-3.0-or-later */
/* interior.c - Mehrotra's predictor and corrector (SIAM J. Optim. 2 (1992) 575) for
 *     0 <= lambda _|_ s = S lambda - wanted >= 0,   S = C C^T,
 * with S as a band: where two flat faces meet, S has a condition that grows as the fourth power of
 * their particles (and is singular where both bring rows), but each row meets its neighbours only.
 * Lines that hold both ways have s = 0 and a lambda of any sign throughout.
 * Lines are scaled to S_ii = 1 and to wants of at most 1.
 * The set of active lines that comes out is then taken as it is (crossover), where that fits: rows
 * that do not push have no force at all. State: none. Start reading at joint_solve_interior(). */
#include "band.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

/* The part of the way to the next bound that a step takes. */
#define STOP_SHORT 0.995
/* Parts of the energy by which lambda may be wrong (error_of): there nothing is left to gain; there
 * what is left is rounding, if it no longer halves; beyond it the problem is not solved. */
#define EXACT    1e-17
#define ROUNDING 1e-15
#define SOLVED   1e-11
/* Where lambda and s begin at least, after a problem that was nearly the same. */
#define NEAR 1e-4
/* A line that pulls by this part of the largest lambda is not active. */
#define PULLS 1e-3
enum { ROUNDS = 60 };

/* Mean of lambda s after a part of the step. */
static double mean_product(const joint_band *p, double part)
{
    double sum = 0;
    for (int n = 0; n < p->count; ++n)
        if (!p->lines[n].both)
            sum += (p->lambda[n] + part * p->step[n]) * (p->s[n] + part * p->s_step[n]);
    return sum / p->count;
}

/* How much of the step keeps lambda and s positive. */
static double longest_part(const joint_band *p)
{
    double part = 1;
    for (int n = 0; n < p->count; ++n) {
        if (p->lines[n].both) continue;
        if (p->step[n] < 0) part = joint_smaller(-p->lambda[n] / p->step[n], part);
        if (p->s_step[n] < 0) part = joint_smaller(-p->s[n] / p->s_step[n], part);
    }
    return part;
}

/* rest = S lambda - want - s. Returns its largest entry. */
static double find_rest(joint_band *p)
{
    double largest = 0;
    joint_band_multiply(p, p->lambda, p->rest);
    for (int n = 0; n < p->count; ++n) {
        p->rest[n] -= p->want[n] + p->s[n];
        largest = joint_larger(fabs(p->rest[n]), largest);
    }
    return largest;
}

/* (S + s/lambda) step = right, s_step = S step + rest. */
static void find_step(joint_band *p)
{
    joint_band_solve(p, p->right, p->step);
    joint_band_multiply(p, p->step, p->s_step);
    for (int n = 0; n < p->count; ++n) p->s_step[n] += p->rest[n];
}

static void take_step(joint_band *p)
{
    double *ratio = p->s_step; /* free until the step is known */
    for (int n = 0; n < p->count; ++n) ratio[n] = p->lines[n].both ? 0 : p->s[n] / p->lambda[n];
    joint_band_factorise(p, ratio);
    const double mean = mean_product(p, 0);
    for (int n = 0; n < p->count; ++n) p->right[n] = -p->s[n] - p->rest[n];
    find_step(p);
    const double predicted = mean_product(p, longest_part(p)) / mean;
    const double centring = mean * predicted * predicted * predicted;
    for (int n = 0; n < p->count; ++n)
        if (!p->lines[n].both) p->right[n] += (centring - p->step[n] * p->s_step[n]) / p->lambda[n];
    find_step(p);
    const double longest = longest_part(p);
    const double part = longest < 1 ? STOP_SHORT * longest : 1;
    for (int n = 0; n < p->count; ++n) {
        if (p->lines[n].both) {
            p->lambda[n] += part * p->step[n];
            continue;
        }
        p->lambda[n] = joint_larger(p->lambda[n] + part * p->step[n], DBL_MIN);
        p->s[n] = joint_larger(p->s[n] + part * p->s_step[n], DBL_MIN);
    }
}

/* Energy that lambda is in error of, as a part of what lambda does. */
static double error_of(const joint_band *p, double rest)
{
    double size = DBL_MIN, error = 0;
    for (int n = 0; n < p->count; ++n) {
        size += fabs(p->lambda[n] * p->want[n]);
        error += p->lambda[n] * p->s[n];
    }
    return error / size + rest;
}

/* By more than corrections could mend. */
static bool some_pull(const joint_band *p)
{
    double most = 0, least = 0;
    for (int n = 0; n < p->count; ++n) {
        most = joint_larger(fabs(p->lambda[n]), most);
        if (!p->lines[n].both) least = joint_smaller(p->lambda[n], least);
    }
    return least < -PULLS * most;
}

/* With these lines active, that is holding exactly, and the others without force. False where some
 * would pull, or others are passed. */
static bool hold_active(joint_band *p, const double *barrier)
{
    double largest = 0;
    joint_band_factorise(p, barrier);
    for (int round = 0; round < JOINT_CORRECTIONS; ++round) {
        joint_band_multiply(p, p->lambda, p->rest);
        for (int n = 0; n < p->count; ++n)
            p->right[n] = barrier[n] > 0 ? 0 : p->want[n] - p->rest[n];
        joint_band_solve(p, p->right, p->step);
        for (int n = 0; n < p->count; ++n)
            if (barrier[n] == 0) p->lambda[n] += p->step[n];
        if (round == 0 && some_pull(p)) return false;
    }
    joint_band_multiply(p, p->lambda, p->rest);
    for (int n = 0; n < p->count; ++n) largest = fmax(largest, fabs(p->lambda[n]));
    for (int n = 0; n < p->count; ++n) {
        const double off = p->rest[n] - p->want[n], tolerance = 4e-15 * (1 + largest);
        const bool holds = off >= -tolerance && (barrier[n] > 0 || off <= tolerance);
        if (!holds || !(p->lambda[n] >= 0 || p->lines[n].both)) return false;
    }
    return true;
}

/* Lines that push more than they stand off are active. Where that does not fit, lambda is left as
 * it was, every line with some force. */
static void cross_over(joint_band *p)
{
    double *barrier = p->s_step;
    memcpy(p->best, p->lambda, (size_t)p->count * sizeof *p->best);
    for (int n = 0; n < p->count; ++n) {
        barrier[n] = p->lambda[n] > p->s[n] || p->lines[n].both ? 0 : JOINT_HELD_OFF;
        if (barrier[n] > 0) p->lambda[n] = 0;
    }
    if (!hold_active(p, barrier)) memcpy(p->lambda, p->best, (size_t)p->count * sizeof *p->best);
}

/* The active lines of a problem that was nearly the same are often those of this one; where none is
 * known, a piston often pushes all that it comes to. */
static bool try_known(joint_band *p, const double *lambda, double largest)
{
    double *barrier = p->s_step;
    bool any = false;
    for (int n = 0; n < p->count; ++n) any |= lambda[n] != 0;
    if (!any && p->columns == 0) return false;
    for (int n = 0; n < p->count; ++n) {
        p->lambda[n] = lambda[n] / (p->scale[n] * largest);
        barrier[n] = lambda[n] > 0 || p->lines[n].both || !any ? 0 : JOINT_HELD_OFF;
    }
    return hold_active(p, barrier);
}

/* From where a problem that was nearly the same ended, but not too near to any bound. */
static void start_near(joint_band *p, const double *lambda, double largest)
{
    for (int n = 0; n < p->count; ++n) p->lambda[n] = lambda[n] / (p->scale[n] * largest);
    joint_band_multiply(p, p->lambda, p->rest);
    for (int n = 0; n < p->count; ++n) {
        p->s[n] = p->lines[n].both ? 0 : fmax(p->rest[n] - p->want[n], NEAR);
        if (!p->lines[n].both) p->lambda[n] = fmax(p->lambda[n], NEAR);
    }
}

static bool walk_inside(joint_band *p, const double *lambda, double largest)
{
    bool all = true;
    for (int n = 0; n < p->count; ++n) {
        p->lambda[n] = p->s[n] = p->lines[n].both ? 0 : 1;
        p->step[n] = p->s_step[n] = 0;
        all &= lambda[n] > 0 || p->lines[n].both;
    }
    if (all) start_near(p, lambda, largest);
    double error = error_of(p, find_rest(p));
    for (int round = 0; round < ROUNDS && error > EXACT; ++round) {
        const double before = error;
        take_step(p);
        error = error_of(p, find_rest(p));
        if (error <= ROUNDING && error >= 0.5 * before) break;
    }
    cross_over(p);
    return error <= SOLVED;
}

bool joint_solve_interior(joint_system *system, int bandwidth, double *room)
{
    joint_band p = joint_band_open(system, bandwidth, room);
    double largest = 0;
    for (int n = 0; n < p.count; ++n) {
        p.scale[n] = 1 / system->lines[n].length;
        largest = fmax(largest, fabs(p.scale[n] * system->lines[n].wanted));
    }
    for (int n = 0; n < p.count; ++n)
        p.want[n] = largest > 0 ? p.scale[n] * system->lines[n].wanted / largest : 0;
    joint_band_fill(&p, system);
    const bool solved =
        try_known(&p, system->lambda, largest) || walk_inside(&p, system->lambda, largest);
    for (int n = 0; n < p.count; ++n) system->lambda[n] = p.lambda[n] * p.scale[n] * largest;
    joint_add_up(system);
    return solved;
}
