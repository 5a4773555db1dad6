/* SPDX-License-Identifier: GPL-3.0-or-later */
/* interior.c - Mehrotra's predictor and corrector (SIAM J. Optim. 2 (1992) 575) for
 *     0 <= lambda _|_ s = S lambda - wanted >= 0,   S = C C^T,
 * with S as a band: where two flat faces meet, S has a condition that grows as the fourth power of
 * their particles (and is singular where both bring rows), but each row meets its neighbours only.
 * Ends that many lines share, pistons, couple them all: S = B + V V^T with a band B and a column of
 * V for each component of such an end. Systems are solved with the factor of the band alone
 * (Sherman, Morrison and Woodbury).
 * Lines that hold both ways have s = 0 and a lambda of any sign throughout.
 * Lines are scaled to S_ii = 1 and to wants of at most 1.
 * The set of active lines that comes out is then taken as it is (crossover), where that fits: rows
 * that do not push have no force at all. State: none. Start reading at joint_solve_interior(). */
#include "joint_system.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

/* Added to the diagonal of what is factored, so that a singular S has a factor: it changes the
 * direction of a step, not where the steps end. */
#define SHIFT 1e-13
/* Added to the diagonal of lines that are to have no force. */
#define HELD_OFF 1e30
/* The part of the way to the next bound that a step takes. */
#define STOP_SHORT 0.995
/* Parts of the energy by which lambda may be wrong (error_of): there nothing is left to gain; there
 * what is left is rounding, if it no longer halves; beyond it the problem is not solved. */
#define EXACT    1e-17
#define ROUNDING 1e-15
#define SOLVED   1e-11
enum { ROUNDS = 60, CORRECTIONS = 4 };

/* The numbers of one problem, per line, and two bands with the diagonal first. */
typedef struct interior {
    int count, width; /* width: entries per line of a band */
    int columns;      /* of V */
    const joint_line *lines;
    double *scale, *want;
    double *lambda, *s, *rest, *step, *s_step, *right, *best;
    double *band, *factor;
    double *wide;   /* V, column after column */
    double *spread; /* V over the factor */
    double *inner;  /* the factor of 1 + V^T V over the band, row after row; and a column */
} interior;

size_t joint_interior_room(int line_count, int bandwidth, int wide_count)
{
    const size_t columns = 2 * (size_t)wide_count;
    return (size_t)line_count * (9 + 2 * ((size_t)bandwidth + 1) + 2 * columns) +
           columns * (columns + 1);
}

static interior open_interior(const joint_system *system, int bandwidth, double *room)
{
    const size_t count = (size_t)system->line_count;
    interior p = {.count = system->line_count,
                  .width = bandwidth + 1,
                  .columns = 2 * system->wide_count,
                  .lines = system->lines};
    double **arrays[] = {&p.scale, &p.want,   &p.lambda, &p.s,   &p.rest,
                         &p.step,  &p.s_step, &p.right,  &p.best};
    for (size_t n = 0; n < sizeof arrays / sizeof *arrays; ++n) {
        *arrays[n] = room;
        room += count;
    }
    p.band = room;
    p.factor = p.band + count * (size_t)p.width;
    p.wide = p.factor + count * (size_t)p.width;
    p.spread = p.wide + count * (size_t)p.columns;
    p.inner = p.spread + count * (size_t)p.columns;
    return p;
}

int joint_bandwidth(const joint_system *system, int *first_of_end)
{
    int widest = 0;
    for (int e = 0; e < system->end_count; ++e) first_of_end[e] = -1;
    for (int n = 0; n < system->line_count; ++n)
        for (int k = 0; k < system->lines[n].count; ++k) {
            int *first = &first_of_end[system->lines[n].end[k]];
            if (joint_is_wide(system, system->lines[n].end[k])) continue;
            if (*first < 0) *first = n;
            if (n - *first > widest) widest = n - *first;
        }
    return widest;
}

/* Entry (n, n - back). */
static double *entry(const interior *p, double *band, int n, int back)
{
    return &band[(size_t)n * (size_t)p->width + (size_t)back];
}

static double *column_of(const interior *p, double *columns, int c)
{
    return columns + (size_t)c * (size_t)p->count;
}

static void fill_wide(interior *p, const joint_system *system)
{
    memset(p->wide, 0, (size_t)p->count * (size_t)p->columns * sizeof *p->wide);
    for (int n = 0; n < p->count; ++n)
        for (int k = 0; k < system->lines[n].count; ++k) {
            const int end = system->lines[n].end[k], c = 2 * (end - system->first_wide);
            if (!joint_is_wide(system, end)) continue;
            column_of(p, p->wide, c)[n] += p->scale[n] * system->lines[n].c[k].x;
            column_of(p, p->wide, c + 1)[n] += p->scale[n] * system->lines[n].c[k].y;
        }
}

static void fill_band(interior *p, const joint_system *system)
{
    fill_wide(p, system);
    for (int n = 0; n < p->count; ++n) {
        for (int back = 0; back < p->width; ++back)
            *entry(p, p->band, n, back) =
                back > n ? 0
                         : p->scale[n] * p->scale[n - back] *
                               joint_product(system, &system->lines[n], &system->lines[n - back]);
        if (p->columns == 0) *entry(p, p->band, n, 0) = 1;
    }
}

static double dot(const interior *p, const double *a, const double *b)
{
    double sum = 0;
    for (int n = 0; n < p->count; ++n) sum += a[n] * b[n];
    return sum;
}

/* out = S x */
static void multiply(const interior *p, const double *x, double *out)
{
    memset(out, 0, (size_t)p->count * sizeof *out);
    for (int n = 0; n < p->count; ++n) {
        const double *restrict row = entry(p, p->band, n, 0);
        const int most = n < p->width - 1 ? n : p->width - 1;
        out[n] += row[0] * x[n];
        for (int back = 1; back <= most; ++back) {
            out[n] += row[back] * x[n - back];
            out[n - back] += row[back] * x[n];
        }
    }
    for (int c = 0; c < p->columns; ++c) {
        const double *column = column_of(p, p->wide, c);
        const double along = dot(p, column, x);
        for (int n = 0; n < p->count; ++n) out[n] += along * column[n];
    }
}

/* L L^T of B + diagonal + SHIFT. A pivot below the shift is rounding. */
static void factorise_band(interior *p, const double *diagonal)
{
    for (int n = 0; n < p->count; ++n) {
        double *restrict row = entry(p, p->factor, n, 0);
        const double *restrict from = entry(p, p->band, n, 0);
        const int most = n < p->width - 1 ? n : p->width - 1;
        for (int back = most; back >= 0; --back) {
            const double *above = entry(p, p->factor, n - back, 0);
            double sum = from[back];
            for (int k = most; k > back; --k) sum -= row[k] * above[k - back];
            row[back] = back > 0 ? sum / above[0] : sqrt(fmax(sum + diagonal[n] + SHIFT, SHIFT));
        }
    }
}

static void solve_band(const interior *p, const double *right, double *x)
{
    for (int n = 0; n < p->count; ++n) {
        const double *restrict row = entry(p, p->factor, n, 0);
        const int most = n < p->width - 1 ? n : p->width - 1;
        double sum = right[n];
        for (int back = 1; back <= most; ++back) sum -= row[back] * x[n - back];
        x[n] = sum / row[0];
    }
    for (int n = p->count - 1; n >= 0; --n) {
        const double *restrict row = entry(p, p->factor, n, 0);
        const int most = n < p->width - 1 ? n : p->width - 1;
        x[n] /= row[0];
        for (int back = 1; back <= most; ++back) x[n - back] -= row[back] * x[n];
    }
}

/* Of the band, and of 1 + V^T (B + diagonal)^-1 V, which is at least 1. */
static void factorise(interior *p, const double *diagonal)
{
    factorise_band(p, diagonal);
    for (int c = 0; c < p->columns; ++c)
        solve_band(p, column_of(p, p->wide, c), column_of(p, p->spread, c));
    for (int c = 0; c < p->columns; ++c)
        for (int d = 0; d <= c; ++d) {
            double sum = dot(p, column_of(p, p->wide, c), column_of(p, p->spread, d)) + (c == d);
            for (int k = 0; k < d; ++k)
                sum -= p->inner[c * p->columns + k] * p->inner[d * p->columns + k];
            p->inner[c * p->columns + d] =
                d < c ? sum / p->inner[d * p->columns + d] : sqrt(fmax(sum, DBL_EPSILON));
        }
}

static void solve_factor(const interior *p, const double *right, double *x)
{
    const int columns = p->columns;
    double *along = p->inner + columns * columns;
    solve_band(p, right, x);
    for (int c = 0; c < columns; ++c) {
        along[c] = dot(p, column_of(p, p->wide, c), x);
        for (int d = 0; d < c; ++d) along[c] -= p->inner[c * columns + d] * along[d];
        along[c] /= p->inner[c * columns + c];
    }
    for (int c = columns - 1; c >= 0; --c) {
        for (int d = c + 1; d < columns; ++d) along[c] -= p->inner[d * columns + c] * along[d];
        along[c] /= p->inner[c * columns + c];
    }
    for (int c = 0; c < columns; ++c) {
        const double *spread = column_of(p, p->spread, c);
        for (int n = 0; n < p->count; ++n) x[n] -= along[c] * spread[n];
    }
}

/* Mean of lambda s after a part of the step. */
static double mean_product(const interior *p, double part)
{
    double sum = 0;
    for (int n = 0; n < p->count; ++n)
        if (!p->lines[n].both)
            sum += (p->lambda[n] + part * p->step[n]) * (p->s[n] + part * p->s_step[n]);
    return sum / p->count;
}

/* How much of the step keeps lambda and s positive. */
static double longest_part(const interior *p)
{
    double part = 1;
    for (int n = 0; n < p->count; ++n) {
        if (p->lines[n].both) continue;
        if (p->step[n] < 0) part = fmin(part, -p->lambda[n] / p->step[n]);
        if (p->s_step[n] < 0) part = fmin(part, -p->s[n] / p->s_step[n]);
    }
    return part;
}

/* rest = S lambda - want - s. Returns its largest entry. */
static double find_rest(interior *p)
{
    double largest = 0;
    multiply(p, p->lambda, p->rest);
    for (int n = 0; n < p->count; ++n) {
        p->rest[n] -= p->want[n] + p->s[n];
        largest = fmax(largest, fabs(p->rest[n]));
    }
    return largest;
}

/* (S + s/lambda) step = right, s_step = S step + rest. */
static void find_step(interior *p)
{
    solve_factor(p, p->right, p->step);
    multiply(p, p->step, p->s_step);
    for (int n = 0; n < p->count; ++n) p->s_step[n] += p->rest[n];
}

static void take_step(interior *p)
{
    double *ratio = p->s_step; /* free until the step is known */
    for (int n = 0; n < p->count; ++n) ratio[n] = p->lines[n].both ? 0 : p->s[n] / p->lambda[n];
    factorise(p, ratio);
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
        p->lambda[n] = fmax(p->lambda[n] + part * p->step[n], DBL_MIN);
        p->s[n] = fmax(p->s[n] + part * p->s_step[n], DBL_MIN);
    }
}

/* Energy that lambda is in error of, as a part of what lambda does. */
static double error_of(const interior *p, double rest)
{
    double size = DBL_MIN, error = 0;
    for (int n = 0; n < p->count; ++n) {
        size += fabs(p->lambda[n] * p->want[n]);
        error += p->lambda[n] * p->s[n];
    }
    return error / size + rest;
}

/* With these lines active, that is holding exactly, and the others without force. False where some
 * would pull, or others are passed. */
static bool hold_active(interior *p, const double *barrier)
{
    double largest = 0;
    factorise(p, barrier);
    for (int round = 0; round < CORRECTIONS; ++round) {
        multiply(p, p->lambda, p->rest);
        for (int n = 0; n < p->count; ++n)
            p->right[n] = barrier[n] > 0 ? 0 : p->want[n] - p->rest[n];
        solve_factor(p, p->right, p->step);
        for (int n = 0; n < p->count; ++n)
            if (barrier[n] == 0) p->lambda[n] += p->step[n];
    }
    multiply(p, p->lambda, p->rest);
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
static void cross_over(interior *p)
{
    double *barrier = p->s_step;
    memcpy(p->best, p->lambda, (size_t)p->count * sizeof *p->best);
    for (int n = 0; n < p->count; ++n) {
        barrier[n] = p->lambda[n] > p->s[n] || p->lines[n].both ? 0 : HELD_OFF;
        if (barrier[n] > 0) p->lambda[n] = 0;
    }
    if (!hold_active(p, barrier)) memcpy(p->lambda, p->best, (size_t)p->count * sizeof *p->best);
}

/* The active lines of a problem that was nearly the same are often those of this one; where none is
 * known, a piston often pushes all that it comes to. */
static bool try_known(interior *p, const double *lambda, double largest)
{
    double *barrier = p->s_step;
    bool any = false;
    for (int n = 0; n < p->count; ++n) any |= lambda[n] != 0;
    if (!any && p->columns == 0) return false;
    for (int n = 0; n < p->count; ++n) {
        p->lambda[n] = lambda[n] / (p->scale[n] * largest);
        barrier[n] = lambda[n] > 0 || p->lines[n].both || !any ? 0 : HELD_OFF;
    }
    return hold_active(p, barrier);
}

static bool walk_inside(interior *p)
{
    for (int n = 0; n < p->count; ++n) {
        p->lambda[n] = p->s[n] = p->lines[n].both ? 0 : 1;
        p->step[n] = p->s_step[n] = 0;
    }
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
    interior p = open_interior(system, bandwidth, room);
    double largest = 0;
    for (int n = 0; n < p.count; ++n) {
        p.scale[n] = 1 / system->lines[n].length;
        largest = fmax(largest, fabs(p.scale[n] * system->lines[n].wanted));
    }
    for (int n = 0; n < p.count; ++n)
        p.want[n] = largest > 0 ? p.scale[n] * system->lines[n].wanted / largest : 0;
    fill_band(&p, system);
    const bool solved = try_known(&p, system->lambda, largest) || walk_inside(&p);
    for (int n = 0; n < p.count; ++n) system->lambda[n] = p.lambda[n] * p.scale[n] * largest;
    joint_add_up(system);
    return solved;
}

/* Which lines are at a limit is found by taking all that go beyond it to it, and back all that
 * would leave it; one at a time where that does not end. */
static int change_states(const interior *p, const double *limit, double *state, bool one_at_a_time)
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
    interior p = open_interior(system, bandwidth, room);
    double *state = p.s, *barrier = p.s_step;
    bool settled = false;
    for (int n = 0; n < p.count; ++n) {
        p.scale[n] = 1 / system->lines[n].length;
        p.want[n] = p.scale[n] * system->lines[n].wanted;
        state[n] = 0;
    }
    fill_band(&p, system);
    for (int round = 0; round < 8 * ROUNDS && !settled; ++round) {
        for (int n = 0; n < p.count; ++n) {
            barrier[n] = state[n] == 0 ? 0 : HELD_OFF;
            p.lambda[n] = state[n] * limit[n] / p.scale[n];
        }
        factorise(&p, barrier);
        for (int turn = 0; turn < CORRECTIONS; ++turn) {
            multiply(&p, p.lambda, p.rest);
            for (int n = 0; n < p.count; ++n)
                p.right[n] = state[n] == 0 ? p.want[n] - p.rest[n] : 0;
            solve_factor(&p, p.right, p.step);
            for (int n = 0; n < p.count; ++n)
                if (state[n] == 0) p.lambda[n] += p.step[n];
        }
        multiply(&p, p.lambda, p.rest);
        settled = change_states(&p, limit, state, round >= ROUNDS / 2) == 0;
    }
    for (int n = 0; n < p.count; ++n)
        system->lambda[n] = fmin(fmax(p.lambda[n] * p.scale[n], -limit[n]), limit[n]);
    return settled;
}
