/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity_elastic.c - strain, Poisson's ratio and wave speeds of any body on a lattice, from where
 * its particles are. Keeps no state. */
#include "experiments/measures/quantity.h"
#include "experiments/setup/body_range.h"

#include "core/particles/langevin.h"

#include <math.h>

static const fw_lattice *lattice_of(const fw_experiment *experiment, int body)
{
    return &experiment->scenario->bodies[body].lattice;
}

static fw_vec2 position_of(const fw_experiment *experiment, int body, int particle)
{
    return fw_solid_position(fw_experiment_solid(experiment, body),
                             experiment->bodies[body].first + particle);
}

/* Smallest box around the undeformed lattice, without the origin. */
static void find_extent(const fw_experiment *experiment, int body, fw_vec2 *low, fw_vec2 *high)
{
    const fw_sites *sites = &experiment->bodies[body].sites;
    *low = (fw_vec2){INFINITY, INFINITY};
    *high = (fw_vec2){-INFINITY, -INFINITY};
    for (int l = 0; l < sites->count; ++l) {
        const fw_vec2 at = fw_lattice_vector(lattice_of(experiment, body), sites->site[l]);
        *low = (fw_vec2){fmin(low->x, at.x), fmin(low->y, at.y)};
        *high = (fw_vec2){fmax(high->x, at.x), fmax(high->y, at.y)};
    }
}

/* --- strain --- */

/* The gradient G of the affine map u = u0 + G (X - X0) that fits the displacements of the inner
 * particles best (least squares): those within half the body's size about its middle, where its
 * sides and the places where it is pulled are far. Order xx xy yx yy, G_xy = du_x/dy. */
static void affine_strain(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const int body = subject.body;
    const fw_sites *sites = &experiment->bodies[body].sites;
    fw_vec2 low, high;
    find_extent(experiment, body, &low, &high);
    const fw_vec2 middle = fw_vec2_scale(0.5, fw_vec2_add(low, high));
    const fw_vec2 reach = fw_vec2_scale(0.25, fw_vec2_subtract(high, low));
    double count = 0, uX[4] = {0};
    fw_vec2 mean_u = {0, 0}, mean_X = {0, 0};
    fw_sym2 XX = {0, 0, 0};
    for (int pass = 0; pass < 2; ++pass) { /* means, then moments about them */
        for (int l = 0; l < sites->count; ++l) {
            const fw_vec2 place = fw_lattice_vector(lattice_of(experiment, body), sites->site[l]);
            fw_vec2 X = fw_vec2_subtract(place, middle);
            if (fabs(X.x) > reach.x * (1 + 1e-9) || fabs(X.y) > reach.y * (1 + 1e-9)) continue;
            fw_vec2 u = fw_vec2_subtract(fw_vec2_subtract(position_of(experiment, body, l),
                                                          lattice_of(experiment, body)->origin),
                                         place);
            if (pass == 0) {
                count += 1;
                mean_u = fw_vec2_add(mean_u, u);
                mean_X = fw_vec2_add(mean_X, X);
                continue;
            }
            u = fw_vec2_subtract(u, mean_u);
            X = fw_vec2_subtract(X, mean_X);
            XX = fw_sym2_add(XX, (fw_sym2){X.x * X.x, X.x * X.y, X.y * X.y});
            uX[0] += u.x * X.x;
            uX[1] += u.x * X.y;
            uX[2] += u.y * X.x;
            uX[3] += u.y * X.y;
        }
        if (pass == 0) {
            mean_u = fw_vec2_scale(1 / count, mean_u);
            mean_X = fw_vec2_scale(1 / count, mean_X);
        }
    }
    const fw_sym2 inverse = fw_sym2_invert(XX);
    for (int row = 0; row < 2; ++row) {
        const fw_vec2 g = fw_sym2_apply(inverse, (fw_vec2){uX[2 * row], uX[2 * row + 1]});
        out[2 * row] = g.x;
        out[2 * row + 1] = g.y;
    }
}

static void poisson_ratio(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double g[4];
    affine_strain(experiment, subject, g);
    /* What is below is rounding, and no strain. */
    const double least = 1e-13;
    out[0] = fabs(g[0]) > least ? -g[3] / g[0] : NAN;
    out[1] = fabs(g[3]) > least ? -g[0] / g[3] : NAN;
}

/* --- waves --- */

/* Of an oscillator that starts at rest, what is left of its displacement after `time`:
 *     e^{-g t/2} [cos W t + (g/2W) sin W t],   W^2 = omega^2 - g^2/4, */
static double left_after(double omega, double damping, double time)
{
    const double rate = 0.5 * damping, square = omega * omega - rate * rate;
    const double w = sqrt(fabs(square));
    if (square > 0) return exp(-rate * time) * (cos(w * time) + rate / w * sin(w * time));
    return exp(-rate * time) * (1 + rate * time);
}

/* Its frequency, from that. Within the first half oscillation it falls with omega. NaN where no
 * frequency fits. */
static double frequency_of(double left, double damping, double time)
{
    const double most = FW_PI / time;
    double low = 0.5 * damping, high = sqrt(most * most + low * low);
    if (damping == 0) return acos(left) / time;
    if (!(left < left_after(low, damping, time) && left > left_after(high, damping, time)))
        return NAN;
    for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        if (left_after(middle, damping, time) > left)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* A body that starts at rest with a plane wave u = A cos(q . r) oscillates in its middle like that,
 * each part of u with its own frequency, until news of its sides arrives. Here at site [0, 0],
 * where r = 0. NaN without such a start, or after half an oscillation. */
static void wave_speed(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_scenario_body *body = &experiment->scenario->bodies[subject.body];
    const fw_sites *sites = &experiment->bodies[subject.body].sites;
    const double time = fw_scene_time(experiment->scene);
    fw_vec2 q = {0, 0}, amplitude = {0, 0};
    for (int n = 0; n < body->displacement.count; ++n) {
        const fw_pattern *pattern = &body->displacement.item[n];
        if (pattern->kind != FW_PATTERN_PLANE) continue;
        q = pattern->wave_vector;
        amplitude = fw_vec2_add(amplitude, pattern->amplitude);
    }
    const double length = sqrt(fw_vec2_dot(q, q));
    const int middle = fw_sites_find(sites, (fw_site){0, 0});
    out[0] = out[1] = NAN;
    if (!(length > 0 && time > 0) || middle < 0) return;
    const fw_vec2 u =
        fw_vec2_subtract(position_of(experiment, subject.body, middle), body->lattice.origin);
    const fw_vec2 along = fw_vec2_scale(1 / length, q), across = fw_vec2_turn(along);
    const fw_solid *solid = fw_experiment_solid(experiment, subject.body);
    const double damping = fw_solid_is_langevin(solid) ? experiment->scenario->dynamics.damping : 0;
    const fw_vec2 parts[2] = {along, across};
    for (int c = 0; c < 2; ++c)
        out[c] = frequency_of(fw_vec2_dot(u, parts[c]) / fw_vec2_dot(amplitude, parts[c]), damping,
                              time) /
                 length;
}

/* Density times speed squared: lambda + 2 mu along, mu across. */
static void wave_modulus(const fw_experiment *experiment, fw_subject subject, double *out)
{
    const fw_lattice *lattice = lattice_of(experiment, subject.body);
    const double square = lattice->spacing * lattice->spacing;
    const double cell = lattice->kind == FW_HEXAGONAL ? sqrt(0.75) * square : square;
    const fw_sym2 total = fw_body_range_mass(experiment->scene, &experiment->bodies[subject.body]);
    const double mass = 0.5 * (total.xx + total.yy) / experiment->bodies[subject.body].count;
    wave_speed(experiment, subject, out);
    for (int c = 0; c < 2; ++c) out[c] *= mass / cell * out[c];
}

/* Of all bodies or of none: it is NaN where one of them has no speed. */
static void anisotropy(const fw_experiment *experiment, fw_subject subject, double *out)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, sum[2] = {0, 0};
    (void)subject;
    for (int b = 0; b < experiment->body_count; ++b) {
        double speed[2];
        wave_speed(experiment, (fw_subject){.body = b}, speed);
        for (int c = 0; c < 2; ++c) {
            low[c] = fmin(low[c], speed[c]);
            high[c] = fmax(high[c], speed[c]);
            sum[c] += speed[c];
        }
    }
    for (int c = 0; c < 2; ++c)
        out[c] = isnan(sum[c]) ? NAN : 2 * (high[c] - low[c]) / (high[c] + low[c]);
}

/* clang-format off */
const fw_quantity fw_elastic_quantities[] = {
    {"affine-strain", FW_SCOPE_BODY, "xx xy yx yy", "1", "gradient of the displacements, fitted to the inner half of the body; xy: of u_x along y", NULL, affine_strain, "its inner half has fewer than two rows or columns", FW_NEEDS_NOTHING},
    {"poisson-ratio", FW_SCOPE_BODY, "x y", "1", "of the affine strain: how much thinner over how much longer, of a body pulled along x, or along y", NULL, poisson_ratio, "the body is not strained along that axis", FW_NEEDS_NOTHING},
    {"wave-speed", FW_SCOPE_BODY, "along across", "length/time", "of the plane wave that the body started with, from the motion of site [0, 0]: of its part along the wave vector, and across", NULL, wave_speed, "the body started without a plane wave, or was not seen within its first half oscillation", FW_NEEDS_NOTHING},
    {"wave-modulus", FW_SCOPE_BODY, "along across", "force/length", "density times wave speed squared: lambda + 2 mu along, the shear modulus mu across", NULL, wave_modulus, "its wave has no speed", FW_NEEDS_NOTHING},
    {"anisotropy", FW_SCOPE_SCENE, "along across", "1", "difference of the highest and lowest wave speed of all bodies, over their mean", NULL, anisotropy, "a wave has no speed", FW_NEEDS_NOTHING},
    {NULL, FW_SCOPE_SCENE, NULL, NULL, NULL, NULL, NULL, NULL, FW_NEEDS_NOTHING},
};
/* clang-format on */
