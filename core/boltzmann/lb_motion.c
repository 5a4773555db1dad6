/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_motion.c - positions and velocities out of fields or displacements. State: none but the
 * outermost sites, in lb_sums. Start reading at lb_motions(). */
#include "lb_motion.h"

#include "lb_displacements.h"

#include <float.h>
#include <math.h>
#include <omp.h>

/* Of how many particles one thread takes the motions at a time, and below which it is alone. */
enum { TOGETHER = 1024, ALONE = 16384 };

/* Between arrays that would else begin at the same place of their pages. */
enum { APART = 40 };

/* V = M^-1 sum f */
static fw_vec2 velocity_of(const lb_solid *lb, int l)
{
    return fw_sym2_apply(lb_inverse_of(lb, l), lb_psi(lb, l));
}

static fw_vec2 position_of(const lb_solid *lb, int l)
{
    return lb->displaced ? lb_displacements_position(lb, l) : fw_solid_position(&lb->head, l);
}

static void motions_one_by_one(const lb_solid *lb, int first, int count, const fw_motions *out)
{
    for (int k = 0; k < count; ++k) {
        const fw_vec2 at = position_of(lb, first + k), v = velocity_of(lb, first + k);
        out->x[k] = at.x;
        out->y[k] = at.y;
        out->velocity_x[k] = v.x;
        out->velocity_y[k] = v.y;
    }
}

/* The stretch that holds a particle. */
static int stretch_of(const lb_grid *grid, int particle)
{
    int low = 0, high = grid->stretch_count;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (grid->stretches[middle].particle <= particle)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The row of the grid that holds a stretch. */
static int row_of(const lb_grid *grid, int stretch)
{
    int low = 0, high = grid->row_count;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (grid->rows[middle].stretch <= stretch)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static fw_motions motions_from(const fw_motions *out, int k)
{
    return (fw_motions){out->x + k, out->y + k, out->velocity_x + k, out->velocity_y + k};
}

static void motions_by_stretches(const lb_solid *lb, int first, int count, const fw_motions *out)
{
    const lb_grid *grid = &lb->form.grid;
    const lb_grid_arrays arrays = lb_displacements_arrays(lb);
    const lb_particle_arrays particles = lb_displacements_particles(lb);
    int n = stretch_of(grid, first), row = row_of(grid, n);
    for (int k = 0, here; k < count; k += here, ++n) {
        const lb_stretch whole = grid->stretches[n];
        const int skipped = first + k - whole.particle, left = count - k;
        here = whole.count - skipped < left ? whole.count - skipped : left;
        while (grid->rows[row + 1].stretch <= n) ++row;
        const fw_motions to = motions_from(out, k);
        FW_KERNELS_CHOSEN(lb_looks)->motions(
            &arrays, &particles,
            (lb_stretch){whole.particle + skipped, whole.place + skipped, here},
            grid->rows[row].north, grid->rows[row].south, &to);
    }
}

void lb_motions(const fw_solid *solid, int first, int count, const fw_motions *out)
{
    const lb_solid *lb = (const lb_solid *)solid;
    if (!lb->displaced || lb->resting || lb->matrix)
        motions_one_by_one(lb, first, count, out);
    else
        motions_by_stretches(lb, first, count, out);
}

void lb_velocities(const fw_solid *solid, double *x, double *y)
{
#pragma omp parallel for schedule(static) if (solid->count > ALONE)
    for (int first = 0; first < solid->count; first += TOGETHER) {
        double places[2][TOGETHER + APART];
        const int left = solid->count - first;
        lb_motions(solid, first, left < TOGETHER ? left : TOGETHER,
                   &(fw_motions){places[0], places[1], x + first, y + first});
    }
}

/* --- the middle --- */

/* sum M (r - base) */
static fw_vec2 moment_one_by_one(const lb_solid *lb, fw_vec2 base)
{
    fw_vec2 sum = {0, 0};
    for (int l = 0; l < lb->head.count; ++l) {
        const fw_vec2 from = fw_vec2_subtract(position_of(lb, l), base);
        sum = fw_vec2_add(sum, fw_sym2_apply(lb_mass_of(lb, l), from));
    }
    return sum;
}

/* The same sums, one after the other; a pair of numbers that is not a struct stays in registers. */
static fw_vec2 moment_by_stretches(const lb_solid *lb, fw_vec2 base)
{
    const lb_grid *grid = &lb->form.grid;
    const lb_grid_arrays arrays = lb_displacements_arrays(lb);
    const lb_particle_arrays particles = lb_displacements_particles(lb);
    double x[TOGETHER + APART], y[TOGETHER + APART], sum_x = 0, sum_y = 0;
    for (int n = 0; n < grid->stretch_count; ++n) {
        lb_stretch s = grid->stretches[n];
        for (int left = s.count; left > 0; left -= s.count) {
            s.count = left < TOGETHER ? left : TOGETHER;
            FW_KERNELS_CHOSEN(lb_looks)->moments(&arrays, &particles, s, base, x, y);
            for (int k = 0; k < s.count; ++k) {
                sum_x += x[k];
                sum_y += y[k];
            }
            s.particle += s.count;
            s.place += s.count;
        }
    }
    return (fw_vec2){sum_x, sum_y};
}

/* Relative to the first particle, so that a far origin costs no digits. */
fw_vec2 lb_centre_of_mass(const fw_solid *solid)
{
    const lb_solid *lb = (const lb_solid *)solid;
    const fw_vec2 base = position_of(lb, 0);
    const bool plain = lb->displaced && !lb->matrix;
    const fw_vec2 sum = plain ? moment_by_stretches(lb, base) : moment_one_by_one(lb, base);
    return fw_vec2_add(base, fw_sym2_apply(fw_sym2_invert(lb_mass(solid)), sum));
}

/* --- is anything far away? --- */

static void note_sites(const lb_solid *lb)
{
    lb_sums *sums = lb->sums;
    fw_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int l = 0; l < lb->head.count; ++l) {
        const double x = lb->form.site_x[l], y = lb->form.site_y[l];
        low = (fw_vec2){fmin(low.x, x), fmin(low.y, y)};
        high = (fw_vec2){fmax(high.x, x), fmax(high.y, y)};
    }
    sums->lowest_site = low;
    sums->highest_site = high;
    sums->sites_known = true;
}

/* How far from the outermost sites something is away, in x or y. */
static double farthest(double low, double high, double centre)
{
    return fmax(fabs(low - centre), fabs(high - centre));
}

/* A displacement u is the mean of x(t) and x(t-1), and no further away than both. */
bool lb_stays_within(const fw_solid *solid, fw_vec2 centre, double limit)
{
    const lb_solid *lb = (const lb_solid *)solid;
    if (!lb->displaced) return false;
    if (!lb->sums->sites_known) note_sites(lb);
    const fw_vec2 low = lb->sums->lowest_site, high = lb->sums->highest_site;
    const fw_vec2 from = fw_vec2_subtract(centre, lb->form.common);
    const double away = fmax(farthest(low.x, high.x, from.x), farthest(low.y, high.y, from.y));
    /* Less what sums of such numbers may be rounded by. */
    const double size = fmin(limit, DBL_MAX) * (1 - 1e-12) - away * (1 + 1e-12) -
                        1e-12 * (fabs(centre.x) + fabs(centre.y));
    if (!(size > 0)) return false;
    const lb_grid *grid = &lb->form.grid;
    const lb_grid_arrays arrays = lb_displacements_arrays(lb);
    bool all = true;
#pragma omp parallel for schedule(static) reduction(&& : all) if (solid->count > ALONE)
    for (int row = 0; row < grid->row_count; ++row)
        for (int n = grid->rows[row].run; n < grid->rows[row + 1].run; ++n)
            all = all && FW_KERNELS_CHOSEN(lb_looks)->within(&arrays, grid->runs[n].begin,
                                                             grid->runs[n].end, size);
    return all;
}
