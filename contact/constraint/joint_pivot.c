/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_pivot.c - normal forces and friction as a linear complementarity problem,
 *     0 <= z  _|_  M z + q >= 0,   z = (lambda, tau+, tau-, s),   tau = tau+ - tau-,
 * with s how fast a tangent slides: lambda _|_ gap, tau+- _|_ s +- slip, s _|_ cone - tau+ - tau-.
 * M is copositive, and Lemke's complementary pivots (Management Science 11 (1965) 681) then end at
 * a solution (Stewart and Trinkle, Int. J. Numer. Meth. Eng. 39 (1996) 2673), where what sticks
 * lets nothing through; where it does they mostly do. Equal ratios are told apart by the order of
 * the basis (lexicographically), so that no basis comes twice. State: none. Start reading at
 * joint_pivot(). */
#include "couple.h"

#include <math.h>
#include <string.h>

/* Added to the diagonal of forces, so that rows which say the same twice share what they bear. */
#define SHIFT 1e-9
/* Smaller numbers in a column are rounding; ratios as near to each other as this are equal. */
#define NOTHING 1e-11
#define EQUAL   1e-12
/* Pivots beyond this many for each unknown are a cycle that rounding has made. */
enum { PIVOTS_EACH = 8 };

/* w - M z - z0 = q as rows; columns w, z, z0 and q. */
typedef struct tableau {
    int count, columns;
    int normals, tangents;
    double *entry;
    int *basis; /* per row: the column that it holds */
} tableau;

static int size_of(const couple *p)
{
    /* What holds both ways is pushed by one more force. */
    return p->normals + p->both_count + 3 * (p->count - p->normals);
}

size_t joint_pivot_room(int normals, int both_count, int count)
{
    const size_t n = (size_t)(normals + both_count + 3 * (count - normals));
    return n * (2 * n + 2) + n;
}

static double *row_of(const tableau *t, int row)
{
    return &t->entry[(size_t)row * (size_t)t->columns];
}

/* The columns of M for the force n of the couple, which acts with that sign. */
static void add_force(const tableau *t, const couple *p, double *row, int motion, double sign)
{
    const int n = t->count, tangents = p->count - p->normals;
    int pulls = p->normals;
    for (int b = 0; b < p->normals; ++b) {
        row[n + b] -= sign * couple_product(p, motion, b);
        if (p->both[b]) row[n + pulls++] += sign * couple_product(p, motion, b);
    }
    for (int k = 0; k < tangents; ++k) {
        const double along = sign * couple_product(p, motion, p->normals + k);
        row[n + pulls + k] -= along;
        row[n + pulls + tangents + k] += along;
    }
}

static void fill_tableau(tableau *t, const couple *p, double part)
{
    const int n = t->count, tangents = p->count - p->normals;
    const int first = p->normals + p->both_count; /* of tau+ */
    int pulls = p->normals;
    memset(t->entry, 0, (size_t)n * (size_t)t->columns * sizeof *t->entry);
    for (int k = 0; k < n; ++k) {
        row_of(t, k)[k] = 1;
        row_of(t, k)[n + k] = k < first + 2 * tangents ? -SHIFT : 0;
        row_of(t, k)[2 * n] = -1;
        t->basis[k] = k;
    }
    for (int b = 0; b < p->normals; ++b) {
        add_force(t, p, row_of(t, b), b, 1);
        row_of(t, b)[2 * n + 1] = -p->wanted[b];
        if (!p->both[b]) continue;
        add_force(t, p, row_of(t, pulls), b, -1);
        row_of(t, pulls++)[2 * n + 1] = p->wanted[b];
    }
    for (int k = 0; k < tangents; ++k) {
        const int tangent = p->normals + k, normal = p->normal_of[tangent];
        const double wanted = p->wanted[tangent] + part * p->target[tangent];
        double *on = row_of(t, first + k), *back = row_of(t, first + tangents + k),
               *cone = row_of(t, first + 2 * tangents + k);
        add_force(t, p, on, tangent, 1);
        add_force(t, p, back, tangent, -1);
        on[n + first + 2 * tangents + k] = back[n + first + 2 * tangents + k] = -1;
        on[2 * n + 1] = -wanted;
        back[2 * n + 1] = wanted;
        cone[n + first + k] = cone[n + first + tangents + k] = 1;
        if (normal >= 0) cone[n + normal] = -p->half[tangent];
        cone[2 * n + 1] = p->rest[tangent];
    }
}

/* Is the row of a smaller than that of b, each over its entry in the column? */
static bool comes_first(const tableau *t, int a, int b, int column)
{
    const double *left = row_of(t, a), *right = row_of(t, b);
    for (int k = 0; k < t->count; ++k) {
        const double difference = left[k] / left[column] - right[k] / right[column];
        if (fabs(difference) > EQUAL) return difference < 0;
    }
    return a < b;
}

/* The row that bounds how far the column may enter; one that holds z0, if it can. -1: none. */
static int find_leaving(const tableau *t, int column)
{
    const int last = 2 * t->count + 1;
    int leaving = -1;
    double least = INFINITY;
    for (int k = 0; k < t->count; ++k) {
        const double *row = row_of(t, k);
        if (!(row[column] > NOTHING)) continue;
        const double ratio = row[last] / row[column];
        const double near = EQUAL * (1 + fabs(ratio));
        if (leaving >= 0 && ratio > least + near) continue;
        const bool less = leaving < 0 || ratio < least - near;
        if (!less && t->basis[leaving] == 2 * t->count) continue;
        if (!less && t->basis[k] != 2 * t->count && !comes_first(t, k, leaving, column)) continue;
        leaving = k;
        least = less ? ratio : fmin(least, ratio);
    }
    return leaving;
}

static void pivot(tableau *t, int leaving, int column)
{
    double *restrict from = row_of(t, leaving);
    const double scale = 1 / from[column];
    for (int j = 0; j < t->columns; ++j) from[j] *= scale;
    from[column] = 1;
    for (int k = 0; k < t->count; ++k) {
        double *restrict row = row_of(t, k);
        const double factor = row[column];
        if (k == leaving || factor == 0) continue;
        for (int j = 0; j < t->columns; ++j) row[j] -= factor * from[j];
        row[column] = 0;
    }
    t->basis[leaving] = column;
}

static bool walk(tableau *t)
{
    const int n = t->count, last = 2 * n + 1;
    int leaving = -1;
    for (int k = 0; k < n; ++k)
        if (leaving < 0 || row_of(t, k)[last] < row_of(t, leaving)[last]) leaving = k;
    if (leaving < 0 || row_of(t, leaving)[last] >= 0) return true;
    int left = t->basis[leaving];
    pivot(t, leaving, 2 * n);
    for (int round = 0; round < PIVOTS_EACH * n; ++round) {
        const int entering = left < n ? left + n : left - n;
        leaving = find_leaving(t, entering);
        if (leaving < 0) return false;
        left = t->basis[leaving];
        pivot(t, leaving, entering);
        if (left == 2 * n) return true;
    }
    return false;
}

/* What is in the basis pushes, or slides. */
static void take_states(const tableau *t, couple *p, double *is_basic)
{
    const int n = t->count, tangents = p->count - p->normals;
    const int first = p->normals + p->both_count;
    for (int k = 0; k < n; ++k) is_basic[k] = 0;
    for (int k = 0; k < n; ++k)
        if (t->basis[k] >= n && t->basis[k] < 2 * n) is_basic[t->basis[k] - n] = 1;
    for (int b = 0; b < p->normals; ++b)
        p->state[b] = is_basic[b] > 0 || p->both[b] ? PUSHES : RESTS;
    for (int k = 0; k < tangents; ++k) {
        const bool on = is_basic[first + k] > 0, back = is_basic[first + tangents + k] > 0;
        const bool slides = is_basic[first + 2 * tangents + k] > 0 && on != back;
        p->state[p->normals + k] = !slides ? STICKS : on ? SLIDES_ON : SLIDES_BACK;
    }
}

bool joint_pivot(couple *p, double part, double *room)
{
    const int n = size_of(p);
    tableau t = {.count = n, .columns = 2 * n + 2, .entry = room};
    t.basis = (int *)(room + (size_t)n * (size_t)t.columns);
    fill_tableau(&t, p, part);
    if (!walk(&t)) return false;
    take_states(&t, p, t.entry);
    return true;
}
