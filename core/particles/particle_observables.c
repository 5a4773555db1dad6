/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_observables.c - sums over the particles and bonds of one instant. Keeps no state. */
#include "core/particles/particle_observables.h"

#include "core/particles/neighbours.h"

#include <math.h>

/* Particles first to end - 1. */
typedef struct fw_stretch {
    int first, end;
} fw_stretch;

static fw_stretch stretch_of(const fw_solid *solid, int group)
{
    if (group < 0) return (fw_stretch){0, solid->count};
    const fw_particle_group *body = fw_particles_group(solid, group);
    return (fw_stretch){body->first, body->first + body->count};
}

static const fw_langevin *motion_of(const fw_solid *solid)
{
    return (const fw_langevin *)solid;
}

/* --- motion --- */

fw_vec2 fw_particle_drift_velocity(const fw_solid *solid, int group)
{
    const fw_stretch of = stretch_of(solid, group);
    const fw_langevin *motion = motion_of(solid);
    fw_vec2 momentum = {0, 0};
    double mass = 0;
    for (int i = of.first; i < of.end; ++i) {
        momentum.x += motion->mass[i] * motion->velocity_x[i];
        momentum.y += motion->mass[i] * motion->velocity_y[i];
        mass += motion->mass[i];
    }
    return fw_vec2_scale(1 / mass, momentum);
}

static fw_tensor momentum_flux(const fw_solid *solid, fw_stretch of, fw_vec2 drift)
{
    const fw_langevin *motion = motion_of(solid);
    fw_tensor flux = {0};
    for (int i = of.first; i < of.end; ++i) {
        const double x = motion->velocity_x[i] - drift.x, y = motion->velocity_y[i] - drift.y;
        flux.xx += motion->mass[i] * x * x;
        flux.xy += motion->mass[i] * x * y;
        flux.yy += motion->mass[i] * y * y;
    }
    flux.yx = flux.xy;
    return flux;
}

double fw_particle_temperature(const fw_solid *solid, int group, fw_vec2 drift)
{
    const fw_stretch of = stretch_of(solid, group);
    const fw_tensor flux = momentum_flux(solid, of, drift);
    return (flux.xx + flux.yy) / (2. * (of.end - of.first));
}

fw_tensor fw_particle_pressure(const fw_solid *solid, int group, double area)
{
    const fw_tensor flux =
        momentum_flux(solid, stretch_of(solid, group), fw_particle_drift_velocity(solid, group));
    const fw_tensor virial = fw_particles_virial(solid, group);
    return (fw_tensor){(flux.xx + virial.xx) / area, (flux.xy + virial.xy) / area,
                       (flux.yx + virial.yx) / area, (flux.yy + virial.yy) / area};
}

/* --- order --- */

fw_particle_order fw_particle_order_of(const fw_solid *solid, int group)
{
    const fw_stretch of = stretch_of(solid, group);
    double lab = 0, local = 0;
    int64_t bonds = 0, bonded = 0;
    for (int i = of.first; i < of.end; ++i) {
        int own;
        const fw_phase psi = fw_particles_bond_order(solid, i, &own);
        const fw_phase axes = fw_particles_group(solid, fw_particles_group_of(solid, i))->axes;
        lab += own * (psi.cosine * axes.cosine + psi.sine * axes.sine);
        local += sqrt(psi.cosine * psi.cosine + psi.sine * psi.sine);
        bonds += own;
        bonded += own > 0;
    }
    return (fw_particle_order){.lab = bonds > 0 ? lab / (double)bonds : 0,
                               .local = bonded > 0 ? local / (double)bonded : 0,
                               .coordination = (double)bonds / (of.end - of.first)};
}

/* --- in wave space --- */

double fw_particle_structure_factor(const fw_solid *solid, int group, fw_vec2 wave_vector)
{
    const fw_stretch of = stretch_of(solid, group);
    double cosine = 0, sine = 0;
    for (int i = of.first; i < of.end; ++i) {
        const double phase = wave_vector.x * solid->x[i] + wave_vector.y * solid->y[i];
        cosine += cos(phase);
        sine += sin(phase);
    }
    const double count = of.end - of.first;
    return (cosine * cosine + sine * sine) / (count * count);
}

/* A square window of wave vectors: middle + a along + b across. */
typedef struct fw_window {
    fw_vec2 middle, along, across;
    double half; /* |a|, |b| <= half */
} fw_window;

static double factor_in(const fw_solid *solid, int group, const fw_window *w, double a, double b)
{
    const fw_vec2 off = fw_vec2_add(fw_vec2_scale(a, w->along), fw_vec2_scale(b, w->across));
    return fw_particle_structure_factor(solid, group, fw_vec2_add(w->middle, off));
}

/* The highest of a square grid about the middle, then uphill with ever smaller steps. A peak of a
 * crystal of diameter L is 4 pi/L wide: `step` must be a small part of that. */
static double highest_in(const fw_solid *solid, int group, const fw_window *w, double step)
{
    enum { ROUNDS = 24 };
    const int reach = (int)ceil(w->half / step);
    const double grid = w->half / reach;
    double best = factor_in(solid, group, w, 0, 0), a = 0, b = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            const double value = factor_in(solid, group, w, i * grid, j * grid);
            if (value > best) best = value, a = i * grid, b = j * grid;
        }
    for (double size = grid / 2; size > grid * ldexp(1, -ROUNDS); size /= 2) {
        const double from_a = a, from_b = b;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j) {
                const double at_a = fmax(fmin(from_a + i * size, w->half), -w->half);
                const double at_b = fmax(fmin(from_b + j * size, w->half), -w->half);
                const double value = factor_in(solid, group, w, at_a, at_b);
                if (value > best) best = value, a = at_a, b = at_b;
            }
    }
    return best;
}

static double diameter_of(const fw_solid *solid, fw_stretch of)
{
    fw_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int i = of.first; i < of.end; ++i) {
        low = (fw_vec2){fmin(low.x, solid->x[i]), fmin(low.y, solid->y[i])};
        high = (fw_vec2){fmax(high.x, solid->x[i]), fmax(high.y, solid->y[i])};
    }
    return hypot(high.x - low.x, high.y - low.y);
}

double fw_particle_bragg_peak(const fw_solid *solid, int group, int fold, double angle,
                              double spacing, double tolerance)
{
    const double pi = acos(-1);
    /* Rows of bonds lie `spacing` apart on the square lattice, sqrt(3)/2 of it on the hexagonal
     * one; the shortest reciprocal vectors stand upright on them. */
    const double length = 2 * pi / (fold == 6 ? spacing * sqrt(3) / 2 : spacing);
    const double half = tolerance * length;
    const double diameter = diameter_of(solid, stretch_of(solid, group));
    const double step = diameter > 0 ? fmin(half, pi / (2 * diameter)) : half;
    double total = 0;
    for (int d = 0; d < fold / 2; ++d) {
        const double direction = angle + pi / 2 + 2 * pi * d / fold;
        const fw_vec2 along = {cos(direction), sin(direction)};
        const fw_window window = {fw_vec2_scale(length, along), along, fw_vec2_turn(along), half};
        total += highest_in(solid, group, &window, step);
    }
    return total / (fold / 2);
}

/* --- who is how far from whom --- */

fw_status fw_particle_pair_correlation(const fw_solid *solid, int group, double density,
                                       double step, int bins, double *g, fw_error *error)
{
    const fw_stretch of = stretch_of(solid, group);
    const int count = of.end - of.first;
    fw_neighbours *near;
    const double *x = solid->x + of.first, *y = solid->y + of.first;
    FW_TRY(fw_neighbours_create(&near, x, y, count, step * bins, error));
    for (int k = 0; k < bins; ++k) g[k] = 0;
    for (int i = 0; i < count; ++i)
        for (size_t k = near->begin[i]; k < near->begin[i + 1]; ++k) {
            const int j = near->list[k];
            const int bin = (int)(hypot(x[i] - x[j], y[i] - y[j]) / step);
            if (bin < bins) g[bin] += 1;
        }
    for (int k = 0; k < bins; ++k) {
        const double ring = FW_PI * step * step * (2. * k + 1);
        g[k] /= count * density * ring;
    }
    fw_neighbours_destroy(near);
    return FW_OK;
}
