/* SPDX-License-Identifier: GPL-3.0-or-later */
/* band.c - products and factors of a band of lines, and of a few columns on top. State: none. Start
 * reading at joint_band_fill(). */
#include "band.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

/* Added to the diagonal of what is factored, so that a singular S has a factor: it changes the
 * direction of a step, not where the steps end. */
#define SHIFT 1e-13

size_t joint_interior_room(int line_count, int bandwidth, int wide_count)
{
    const size_t columns = 2 * (size_t)wide_count;
    return (size_t)line_count * (9 + 2 * ((size_t)bandwidth + 1) + 2 * columns) +
           columns * (columns + 1);
}

joint_band joint_band_open(const joint_system *system, int bandwidth, double *room)
{
    const size_t count = (size_t)system->line_count;
    joint_band p = {.count = system->line_count,
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
static double *entry(const joint_band *p, double *band, int n, int back)
{
    return &band[(size_t)n * (size_t)p->width + (size_t)back];
}

static double *column_of(const joint_band *p, double *columns, int c)
{
    return columns + (size_t)c * (size_t)p->count;
}

static void fill_wide(joint_band *p, const joint_system *system)
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

void joint_band_fill(joint_band *p, const joint_system *system)
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

static double dot(const joint_band *p, const double *a, const double *b)
{
    double sum = 0;
    for (int n = 0; n < p->count; ++n) sum += a[n] * b[n];
    return sum;
}

void joint_band_multiply(const joint_band *p, const double *x, double *out)
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
static void factorise_band(joint_band *p, const double *diagonal)
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

static void solve_band(const joint_band *p, const double *right, double *x)
{
    for (int n = 0; n < p->count; ++n) {
        const double *restrict row = entry(p, p->factor, n, 0);
        const int most = n < p->width - 1 ? n : p->width - 1;
        double sum = right[n];
        for (int back = 1; back <= most; ++back) sum -= row[back] * x[n - back];
        x[n] = sum / row[0];
    }
    for (int n = p->count - 1; n >= 0; --n) {
        const int left = p->count - 1 - n, most = left < p->width - 1 ? left : p->width - 1;
        double sum = x[n];
        for (int k = most; k > 0; --k) sum -= *entry(p, p->factor, n + k, k) * x[n + k];
        x[n] = sum / *entry(p, p->factor, n, 0);
    }
}

/* Of the band, and of 1 + V^T (B + diagonal)^-1 V, which is at least 1. */
void joint_band_factorise(joint_band *p, const double *diagonal)
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

void joint_band_solve(const joint_band *p, const double *right, double *x)
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
