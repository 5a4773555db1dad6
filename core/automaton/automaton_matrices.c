/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_matrices.c - B_i from the wave speeds. Keeps no state.
 * Start reading at fw_automaton_matrices_make(). */
#include "core/automaton/automaton_matrices.h"

#include <math.h>

/* Entries are rounded to multiples of 2^-50, so that adding four of them is exact: a sum that is
 * off by one rounding would make every cell gain or lose the same 1e-16 of its energy each time,
 * and 10^4 steps would show it. */
#define GRAIN 0x1p-50

/* sqrt(2) squared is 2 + 4e-16: Chopard's automaton stands on the rim of the disc. */
#define RIM 1e-14

fw_automaton_speeds fw_automaton_chopard(void)
{
    return (fw_automaton_speeds){1.41421356237309504880, 0};
}

fw_status fw_automaton_speeds_from_moduli(fw_automaton_speeds *speeds, double shear_modulus,
                                          double poisson_ratio, fw_error *error)
{
    if (!(shear_modulus > 0 && isfinite(shear_modulus)))
        return fw_fail(error, FW_BAD_INPUT, "shear modulus %g, expected a number above 0",
                       shear_modulus);
    if (!(poisson_ratio >= -1 && poisson_ratio < 1))
        return fw_fail(error, FW_BAD_INPUT,
                       "Poisson's ratio %g, expected -1 to below 1 (that of the plane, "
                       "lambda / (lambda + 2 mu))",
                       poisson_ratio);
    /* lambda = 2 mu nu / (1 - nu), so lambda + mu = mu (1 + nu) / (1 - nu). */
    speeds->transverse = sqrt(shear_modulus);
    speeds->coupling = sqrt(shear_modulus * (1 + poisson_ratio) / (1 - poisson_ratio));
    return FW_OK;
}

fw_status fw_automaton_speeds_check(fw_automaton_speeds speeds, fw_error *error)
{
    const double c1 = speeds.transverse, c2 = speeds.coupling;
    if (!(c1 >= 0 && c2 >= 0 && isfinite(c1) && isfinite(c2)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the automaton's speeds c1 = %g, c2 = %g, expected two numbers >= 0", c1,
                       c2);
    const double square = c1 * c1 + c2 * c2;
    if (square <= 2 * (1 + RIM)) return FW_OK;
    /* The fastest growth belongs to k = (pi/2, pi/2), where 4 sin^2(omega/2) = 2 (c1^2 + c2^2). */
    const double h = sqrt(2 * square), root = (h + sqrt(h * h - 4)) / 2;
    return fw_fail(error, FW_BAD_INPUT,
                   "c1^2 + c2^2 = %g (c1 = %g, c2 = %g), expected at most 2: longitudinal waves "
                   "would outrun the lattice, the coefficient matrices are no longer real, and the "
                   "wave (pi/2, pi/2) grows by %.4g in every step",
                   square, c1, c2, root * root);
}

static double grained(double value)
{
    return rint(value / GRAIN) * GRAIN;
}

/* R m R^T for the rotation R by `angle`. */
static fw_sym2 turned(fw_sym2 m, double angle)
{
    if (angle == 0) return m;
    const double c = cos(angle), s = sin(angle);
    return (fw_sym2){c * c * m.xx - 2 * c * s * m.xy + s * s * m.yy,
                     c * s * (m.xx - m.yy) + (c * c - s * s) * m.xy,
                     s * s * m.xx + 2 * c * s * m.xy + c * c * m.yy};
}

static fw_sym2 quarter_of(fw_sym2 a, double factor, fw_sym2 b)
{
    return fw_sym2_scale(0.25, fw_sym2_add(a, fw_sym2_scale(factor, b)));
}

fw_status fw_automaton_matrices_make(fw_automaton_matrices *matrices, fw_automaton_speeds speeds,
                                     double angle, fw_error *error)
{
    FW_TRY(fw_automaton_speeds_check(speeds, error));
    const double shear = speeds.transverse * speeds.transverse;
    const double coupling = speeds.coupling * speeds.coupling;
    /* Eq 30; on the rim of the disc rounding leaves -2e-16 under the root. */
    const double p0 = sqrt(fmax(0, 1 - shear / 2));
    const double p1 = sqrt(fmax(0, 1 - shear / 2 - coupling / 2));
    /* Eq 24: P = p0 + p1 sigma, Q = q0 + q1 sigma with q0 = p1, q1 = -p0. */
    const fw_sym2 p = {p0, p1, p0}, q = {p1, -p0, p1};
    /* Eq 29 and P^2: what East and West share; 4 - that is what North and South share (Eq 31). */
    const fw_sym2 m = {shear + coupling, 0, shear};
    const fw_sym2 along = fw_sym2_add(m, fw_sym2_square(p));
    const fw_sym2 across = fw_sym2_add(fw_sym2_scalar(4), fw_sym2_scale(-1, along));
    const fw_sym2 exact[FW_DIRECTIONS] = {
        [FW_EAST] = quarter_of(along, 2, p),
        [FW_NORTH] = quarter_of(across, 2, q),
        [FW_WEST] = quarter_of(along, -2, p),
        [FW_SOUTH] = quarter_of(across, -2, q),
    };
    matrices->speeds = speeds;
    fw_sym2 rest = fw_sym2_scalar(2);
    for (int d = FW_EAST; d <= FW_WEST; ++d) {
        const fw_sym2 b = turned(exact[d], angle);
        matrices->bond[d] = (fw_sym2){grained(b.xx), grained(b.xy), grained(b.yy)};
        rest = fw_sym2_add(rest, fw_sym2_scale(-1, matrices->bond[d]));
    }
    matrices->bond[FW_SOUTH] = rest;
    return FW_OK;
}

static double least_eigenvalue(fw_sym2 m)
{
    return (m.xx + m.yy) / 2 - hypot((m.xx - m.yy) / 2, m.xy);
}

double fw_automaton_matrices_least(const fw_automaton_matrices *matrices)
{
    double least = INFINITY;
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        least = fmin(least, least_eigenvalue(matrices->bond[d]));
    return least;
}
