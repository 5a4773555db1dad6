/* SPDX-License-Identifier: GPL-3.0-or-later */
/* couple.c - normal forces and friction at once: a semismooth Newton iteration over what each
 * unknown does. A normal pushes or does not; a tangent sticks, with a slip of its target, or
 * slides, with a traction of its cone, which moves with the normal force. For given states all that
 * is linear; each state that the solution contradicts is changed, and it is solved again. Where
 * that does not end, pivots find the states. State: none. Start reading at couple_find_part(). */
#include "couple.h"

#include <math.h>

/* All states are changed at once as often as that mostly takes (most problems need 2 to 4 times);
 * then one at a time, as often as small islands have unknowns. */
enum { AT_ONCE = 15, STEPS = 30 };
/* Parts of what sticking lets through that are tried, secants need about 8; and how many of them
 * may have no states. */
enum { PARTS = 16, WITHOUT = 3 };
/* What is active moves by this more, for each unit of its own force: rows that say the same twice
 * then have a solution; corrections take it out again, but for how such rows share their force. */
#define SHIFT 1e-12
enum { CORRECTIONS = 4 };
/* Contradictions below this part of the largest numbers are rounding, which the shift magnifies;
 * and in states that pivots have found. */
#define ROUNDING 1e-12
#define NEARLY   1e-11
/* Rounding alone, as a part of the forces: where rows that hold contradict each other, forces grow
 * until the shift makes up for it, and what it takes is more. */
#define BY_FORCES 1e-14
/* Of the part with which friction gives nothing. */
#define SHORT_OF 0.999

size_t couple_room(int count)
{
    const size_t n = (size_t)count;
    /* Whole numbers and states take no more room than doubles. */
    return 2 * n * n + 16 * n;
}

couple couple_open(int normals, int count, double *room)
{
    const size_t n = (size_t)count;
    couple p = {.normals = normals, .count = count};
    double **arrays[] = {&p.right, &p.scale, &p.wanted, &p.target, &p.half,
                         &p.rest,  &p.x,     &p.motion, &p.start};
    p.product = room;
    p.matrix = room += n * n;
    room += n * n;
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; ++k, room += n) *arrays[k] = room;
    p.normal_of = (int *)room;
    p.active = (int *)(room + n);
    p.column = (int *)(room + 2 * n);
    p.state = (couple_state *)(room + 3 * n);
    p.both = (int *)(room + 4 * n);
    p.order = (int *)(room + 5 * n);
    return p;
}

static double *at(const couple *p, int row, int column)
{
    return &p->matrix[(size_t)row * (size_t)p->active_count + (size_t)column];
}

static bool is_active(const couple *p, int n)
{
    return p->state[n] == PUSHES || p->state[n] == STICKS;
}

/* What the k-th unknown that is active moves by, of the forces of all of them. What slides goes
 * with its normal force. */
static void write_row(const couple *p, int k)
{
    const int n = p->active[k];
    double *row = at(p, k, 0);
    for (int j = 0; j < p->active_count; ++j) row[j] = couple_product(p, n, p->active[j]);
    row[k] += SHIFT;
    for (int t = p->normals; t < p->count; ++t) {
        const int normal = p->normal_of[t];
        if (p->state[t] == STICKS || normal < 0 || p->state[normal] != PUSHES) continue;
        row[p->column[normal]] += couple_direction(p, t) * p->half[t] * couple_product(p, n, t);
    }
}

static void swap(double *a, double *b)
{
    const double c = *a;
    *a = *b;
    *b = c;
}

/* L U of the active rows, each of which goes to row order[k]. */
static void factorise(couple *p)
{
    const int count = p->active_count;
    for (int k = 0; k < count; ++k) {
        int row = k;
        for (int i = k + 1; i < count; ++i)
            if (fabs(*at(p, i, k)) > fabs(*at(p, row, k))) row = i;
        p->order[k] = row;
        for (int j = 0; j < count && row != k; ++j) swap(at(p, k, j), at(p, row, j));
        const double *restrict above = at(p, k, 0);
        if (above[k] == 0) continue;
        for (int i = k + 1; i < count; ++i) {
            double *restrict below = at(p, i, 0);
            const double factor = below[k] / above[k];
            below[k] = factor;
            if (factor == 0) continue;
            for (int j = k + 1; j < count; ++j) below[j] -= factor * above[j];
        }
    }
}

/* Adds to the forces what takes `right` out. */
static void correct(couple *p)
{
    const int count = p->active_count;
    for (int k = 0; k < count; ++k) {
        const int row = p->order[k];
        if (row != k) swap(&p->right[k], &p->right[row]);
    }
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j) p->right[i] -= *at(p, i, j) * p->right[j];
    for (int i = count - 1; i >= 0; --i) {
        for (int j = i + 1; j < count; ++j) p->right[i] -= *at(p, i, j) * p->right[j];
        p->right[i] = *at(p, i, i) != 0 ? p->right[i] / *at(p, i, i) : 0;
        p->x[p->active[i]] += p->right[i];
    }
}

/* What slides bears its cone; and all motions. */
static void slide_and_move(couple *p)
{
    for (int n = p->normals; n < p->count; ++n) {
        if (p->state[n] == STICKS) continue;
        const int normal = p->normal_of[n];
        p->x[n] =
            couple_direction(p, n) * ((normal < 0 ? 0 : p->half[n] * p->x[normal]) + p->rest[n]);
    }
    for (int n = 0; n < p->count; ++n) {
        p->motion[n] = 0;
        for (int j = 0; j < p->count; ++j) p->motion[n] += couple_product(p, n, j) * p->x[j];
    }
}

static void solve_states(couple *p, double part)
{
    p->active_count = 0;
    for (int n = 0; n < p->count; ++n) {
        p->x[n] = is_active(p, n) ? p->start[n] : 0;
        if (!is_active(p, n)) continue;
        p->column[n] = p->active_count;
        p->active[p->active_count++] = n;
    }
    for (int k = 0; k < p->active_count; ++k) write_row(p, k);
    factorise(p);
    for (int turn = 0; turn < CORRECTIONS; ++turn) {
        slide_and_move(p);
        for (int k = 0; k < p->active_count; ++k) {
            const int n = p->active[k];
            p->right[k] =
                p->wanted[n] + (p->state[n] == STICKS ? part * p->target[n] : 0) - p->motion[n];
        }
        correct(p);
    }
    slide_and_move(p);
}

/* By how much the solution contradicts the state of n, and what it should be. */
static double contradiction(const couple *p, int n, bool both, double part, couple_state *other)
{
    const double off = p->motion[n] - p->wanted[n];
    switch (p->state[n]) {
    case RESTS:
        *other = PUSHES;
        return -off;
    case PUSHES:
        *other = RESTS;
        return both ? fabs(off) : fmax(-p->x[n], fabs(off));
    case STICKS:
        /* What others hold already may not move as it should: then it is pushed to its limit. */
        *other = p->x[n] > 0 ? SLIDES_ON : SLIDES_BACK;
        if (fabs(p->x[n]) > couple_cone(p, n)) return fabs(p->x[n]) - couple_cone(p, n);
        *other = off < part * p->target[n] ? SLIDES_ON : SLIDES_BACK;
        return fabs(off - part * p->target[n]);
    case SLIDES_BACK:
        *other = STICKS;
        return -(off - part * p->target[n]);
    case SLIDES_ON:
        *other = STICKS;
        return off - part * p->target[n];
    }
    return 0;
}

/* How far what is to hold is off. */
static double off_hold(const couple *p, int n, double part)
{
    const double target = p->state[n] == STICKS ? part * p->target[n] : 0;
    return is_active(p, n) ? fabs(p->motion[n] - p->wanted[n] - target) : 0;
}

/* Solves for the present states, and finds the one that is contradicted most. Changes all of those
 * if `all`, or that one. Returns how many are contradicted by more than `tolerance`; -1 where one
 * is that no change of states can mend. */
static int improve(couple *p, double part, double tolerance, bool all)
{
    double way = 0, size = 0, worst = 0;
    int changes = 0, which = -1;
    couple_state what = RESTS;
    solve_states(p, part);
    for (int n = 0; n < p->count; ++n) {
        way = fmax(way, fabs(p->wanted[n]));
        size = fmax(size, fmax(fabs(p->x[n]), way));
    }
    for (int n = 0; n < p->count; ++n) {
        couple_state other = RESTS;
        const bool both = !couple_is_tangent(p, n) && p->both[n];
        const double beyond = contradiction(p, n, both, part, &other);
        if (!(beyond > tolerance * size) &&
            !(off_hold(p, n, part) > tolerance * way + BY_FORCES * size))
            continue;
        changes += 1;
        if (both) return -1;
        if (beyond > worst) {
            worst = beyond;
            which = n;
            what = other;
        }
        if (all) p->state[n] = other;
    }
    if (changes > 0 && !all) p->state[which] = what;
    return changes;
}

static bool find_states(couple *p, double part, double *room)
{
    int changes = 1;
    for (int step = 0; step < STEPS && changes > 0; ++step)
        changes = improve(p, part, ROUNDING, step < AT_ONCE);
    if (changes == 0) return true;
    if (!joint_pivot(p, part, room)) return false;
    changes = 1;
    for (int step = 0; step < STEPS && changes > 0; ++step)
        changes = improve(p, part, NEARLY, false);
    return changes == 0;
}

/* Of friction: of what sticks it is the part of what sticking lets through, times a linear function
 * of that as long as no state changes, which is `sticking`; of what slides it is a loss. */
static double power_of(const couple *p, double part, double *sticking)
{
    double sliding = 0;
    *sticking = 0;
    for (int n = p->normals; n < p->count; ++n) {
        if (p->state[n] == STICKS)
            *sticking += p->x[n] * p->target[n];
        else
            sliding += p->x[n] * (p->motion[n] - p->wanted[n]);
    }
    return part * *sticking + sliding;
}

/* The largest part of what sticking lets through with which friction takes energy as a whole, or a
 * little less, so that rounding does not make it give any: by secants, the older end of which
 * counts half once it has stayed (the Illinois rule). Without states it counts as giving. */
bool couple_find_part(couple *p, double *part, double *room)
{
    double low = 0, high = 1, at_low, at_high = INFINITY, sticking;
    *part = 1;
    if (find_states(p, 1, room)) at_high = power_of(p, 1, &sticking);
    if (at_high <= 0) return true;
    *part = 0;
    if (!find_states(p, 0, room)) return false;
    at_low = power_of(p, 0, &sticking);
    if (at_high == INFINITY && find_states(p, 1, room)) {
        at_high = power_of(p, 1, &sticking);
        *part = at_high <= 0 ? 1 : 0;
        if (at_high <= 0) return true;
    }
    /* Where nothing slides, power is zero without any part, and its slope decides. */
    const bool slopes = at_low == 0;
    if (slopes) at_low = sticking;
    const double small = 1e-13 * fabs(at_low);
    int side = 0, without = 0;
    for (int n = 0; n < PARTS && without < WITHOUT && at_low < 0 && high - low > 1e-14; ++n) {
        const double middle = at_high == INFINITY
                                  ? 0.5 * (low + high)
                                  : (low * at_high - high * at_low) / (at_high - at_low);
        double power = INFINITY;
        if (find_states(p, middle, room)) {
            power = power_of(p, middle, &sticking);
            if (slopes) power /= middle;
        } else {
            without += 1;
        }
        if (fabs(power) <= small) {
            low = middle;
            break;
        }
        if (power < 0) {
            low = middle;
            at_low = power;
            if (side == -1 && at_high < INFINITY) at_high *= 0.5;
            side = -1;
        } else {
            high = middle;
            at_high = power;
            if (side == 1) at_low *= 0.5;
            side = 1;
        }
    }
    *part = SHORT_OF * low;
    if (find_states(p, *part, room)) return true;
    *part = 0;
    return find_states(p, 0, room);
}
