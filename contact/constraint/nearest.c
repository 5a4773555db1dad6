/* SPDX-License-Identifier: GPL-3.0-or-later */
/* nearest.c - non-negative least squares with an active set (Lawson and Hanson, Solving Least
 * Squares Problems, 1974, ch. 23), in the form that holds prescribed motions too: the active lines
 * c_P z = wanted_P have the nearest point z = Q y, R^T y = wanted_P, with C_P^T = Q R. Neither
 * C C^T, whose condition is the square, nor lambda is needed for z.
 * State: the active lines in the order of Q's columns. Invariant: they are independent to rounding;
 * a line that depends on them holds where they hold, and is never activated. Lines that hold both
 * ways are active from the first.
 * Start reading at joint_solve_nearest(). */
#include "joint_system.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* A line that is nearer than this to what the active ones span, as a part of its length, depends on
 * them; a line may be missed by so much, as a part of the largest. */
#define DEPENDENT 1e-11
#define TOLERANCE 1e-14
/* By how much a line that depends on active ones may be missed, as a part of the largest z. */
#define BARRED_MISS 1e-9

typedef struct active_set {
    joint_system *system;
    int size;            /* of a column: two per end */
    int count, capacity; /* columns */
    double *active;      /* numbers of the lines */
    double *q;           /* orthonormal columns of length size */
    double *r;           /* upper triangle, column after column with stride capacity */
    double *y;
    double *next;   /* lambda of the active lines, as they stand */
    double *barred; /* per line: 0, or 1 where it was seen to depend on the active ones */
} active_set;

size_t joint_nearest_room(int line_count, int end_count)
{
    const size_t lines = (size_t)line_count, size = 2 * (size_t)end_count;
    const size_t most = lines < size ? lines : size;
    return most * (size + most + 3) + 2 * lines + size;
}

static active_set open_set(joint_system *system, double *room)
{
    const int size = 2 * system->end_count;
    const int most = system->line_count < size ? system->line_count : size;
    active_set set = {.system = system, .size = size, .capacity = most};
    set.active = room;
    set.y = set.active + most;
    set.next = set.y + most;
    set.barred = set.next + most;
    set.q = set.barred + system->line_count;
    set.r = set.q + (size_t)most * (size_t)size;
    memset(set.barred, 0, (size_t)system->line_count * sizeof *set.barred);
    return set;
}

static bool is_both(const active_set *set, int line)
{
    return set->system->lines[line].both;
}

static double *column_of(const active_set *set, int n)
{
    return set->q + (size_t)n * (size_t)set->size;
}

static double *triangle_of(const active_set *set, int n)
{
    return set->r + (size_t)n * (size_t)set->capacity;
}

static double inner(const double *a, const double *b, int size)
{
    double sum = 0;
    for (int n = 0; n < size; ++n) sum += a[n] * b[n];
    return sum;
}

static void spread(const joint_line *line, double *column, int size)
{
    memset(column, 0, (size_t)size * sizeof *column);
    for (int n = 0; n < line->count; ++n) {
        column[2 * line->end[n]] += line->c[n].x;
        column[2 * line->end[n] + 1] += line->c[n].y;
    }
}

/* Activates a line; false where it depends on those that are active. Gram and Schmidt, twice, which
 * is enough. */
static bool activate(active_set *set, int number)
{
    if (set->count == set->capacity) return false;
    const joint_line *line = &set->system->lines[number];
    const int k = set->count, size = set->size;
    double *column = column_of(set, k), *r = triangle_of(set, k);
    spread(line, column, size);
    for (int j = 0; j < k; ++j) r[j] = 0;
    for (int pass = 0; pass < 2; ++pass)
        for (int j = 0; j < k; ++j) {
            const double *q = column_of(set, j);
            const double part = inner(q, column, size);
            if (part == 0) continue;
            r[j] += part;
            for (int n = 0; n < size; ++n) column[n] -= part * q[n];
        }
    const double left = sqrt(inner(column, column, size));
    if (!(left > DEPENDENT * line->length)) return false;
    for (int n = 0; n < size; ++n) column[n] /= left;
    r[k] = left;
    set->y[k] = (line->wanted - inner(r, set->y, k)) / left;
    set->active[k] = number;
    set->count += 1;
    return true;
}

/* z = Q y, and R lambda = y. */
static void find_point(active_set *set)
{
    joint_system *system = set->system;
    for (int e = 0; e < system->end_count; ++e) system->z[e] = (fw_vec2){0, 0};
    for (int j = 0; j < set->count; ++j) {
        const double *q = column_of(set, j);
        for (int e = 0; e < system->end_count; ++e) {
            system->z[e].x += set->y[j] * q[2 * e];
            system->z[e].y += set->y[j] * q[2 * e + 1];
        }
    }
    for (int j = set->count - 1; j >= 0; --j) {
        double sum = set->y[j];
        for (int k = j + 1; k < set->count; ++k) sum -= triangle_of(set, k)[j] * set->next[k];
        set->next[j] = sum / triangle_of(set, j)[j];
    }
}

/* Releases active lines without force, and makes Q and R anew from the others. */
static void release(active_set *set)
{
    const int count = set->count;
    set->count = 0;
    for (int j = 0; j < count; ++j) {
        const int number = (int)set->active[j];
        double *lambda = &set->system->lambda[number];
        if ((*lambda > 0 || is_both(set, number)) && activate(set, number)) continue;
        *lambda = 0;
    }
    memset(set->barred, 0, (size_t)set->system->line_count * sizeof *set->barred);
}

/* From lambda, which is not negative, towards `next` until all of that is not negative either. */
static void settle(active_set *set)
{
    double *lambda = set->system->lambda;
    for (;;) {
        double part = 1;
        int last = -1;
        find_point(set);
        for (int j = 0; j < set->count; ++j) {
            const double now = lambda[(int)set->active[j]];
            if (set->next[j] > 0 || is_both(set, (int)set->active[j])) continue;
            const double reach = now > 0 ? now / (now - set->next[j]) : 0;
            if (last >= 0 && reach >= part) continue;
            part = reach;
            last = j;
        }
        if (last < 0) break;
        for (int j = 0; j < set->count; ++j) {
            double *now = &lambda[(int)set->active[j]];
            const double then = *now + part * (set->next[j] - *now);
            *now = j == last ? 0 : is_both(set, (int)set->active[j]) ? then : fmax(0, then);
        }
        release(set);
    }
    for (int j = 0; j < set->count; ++j) lambda[(int)set->active[j]] = set->next[j];
}

/* The line that is missed most, or -1. */
static int find_missed(const active_set *set)
{
    const joint_system *system = set->system;
    double scale = 0;
    for (int n = 0; n < system->line_count; ++n)
        scale = fmax(scale, fabs(system->lines[n].wanted) / system->lines[n].length);
    for (int e = 0; e < system->end_count; ++e)
        scale = fmax(scale, fabs(system->z[e].x) + fabs(system->z[e].y));
    double most = TOLERANCE * scale;
    int missed = -1;
    for (int n = 0; n < system->line_count; ++n) {
        const joint_line *line = &system->lines[n];
        if (system->lambda[n] > 0 || set->barred[n] > 0 || line->both) continue;
        const double by = (line->wanted - joint_dot(line, system->z)) / line->length;
        if (by <= most) continue;
        most = by;
        missed = n;
    }
    return missed;
}

/* Whether a line that was left out since it depends on active ones is met all the same. */
static bool keeps_barred(const active_set *set)
{
    const joint_system *system = set->system;
    double scale = 0;
    for (int e = 0; e < system->end_count; ++e)
        scale = fmax(scale, fabs(system->z[e].x) + fabs(system->z[e].y));
    for (int n = 0; n < system->line_count; ++n) {
        const joint_line *line = &system->lines[n];
        if (set->barred[n] == 0 && !line->both) continue;
        double missed = line->wanted - joint_dot(line, system->z);
        if (line->both) missed = fabs(missed);
        if (missed > BARRED_MISS * scale * line->length) return false;
    }
    return true;
}

static bool find_nearest(joint_system *system, double *room)
{
    active_set set = open_set(system, room);
    for (int n = 0; n < system->line_count; ++n)
        if (system->lines[n].both && !activate(&set, n)) system->lambda[n] = 0;
    for (int n = 0; n < system->line_count; ++n)
        if (!system->lines[n].both && system->lambda[n] > 0 && !activate(&set, n))
            system->lambda[n] = 0;
    settle(&set);
    for (int tries = 0; tries < 4 * system->line_count + 40; ++tries) {
        const int missed = find_missed(&set);
        if (missed < 0) return keeps_barred(&set);
        const int before = set.count;
        if (!activate(&set, missed)) {
            set.barred[missed] = 1;
            continue;
        }
        find_point(&set);
        if (set.next[before] > 0) {
            settle(&set);
            continue;
        }
        set.count = before; /* rounding only made it seem missed */
        set.barred[missed] = 1;
        find_point(&set);
    }
    return false;
}

bool joint_solve_nearest(joint_system *system, double *room)
{
    const bool found = find_nearest(system, room);
    joint_add_up(system);
    return found;
}
