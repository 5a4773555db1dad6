/* SPDX-License-Identifier: GPL-3.0-or-later */
/* return_force.h - the forces that turn a bond towards the axes of its body (Popov & Filippov
 * Eq 18).
 *
 * phi is the direction of r_i - r_j, e_phi = (-sin phi, cos phi), n the fold, f0 the amplitude.
 * Eq 18 as printed drives bonds away from the axes; restoring at phi = 2 pi k/n, as Fig 1 shows, is
 *     constant      F = -f0 S sin(n phi) e_phi
 *     conservative  V = -(f0 r0/n) S cos(n phi):
 *                   F = -f0 (r0/r) S sin(n phi) e_phi + (f0 r0/n) S' cos(n phi) e_r
 * on i, and -F on j: exactly so, since n is even and every term changes sign with r_i - r_j.
 *
 * Axes other than the fixed ones turn the force of a pair, or add to it, by two numbers per body
 * (fw_turn) that follow from sums over all its bonds. So a pair has two parts, `first` with
 * (cos n phi, sin n phi) and `second`, and its force is turn.first * first + turn.second * second:
 *     lab         (1, 0)
 *     corotating  (cos n theta, sin n theta): the angle is n phi - n theta, where
 *                 n theta = arg sum w e^{i n phi}. For the conservative force w = S, hence
 *                 V = -(f0 r0/n) |sum S e^{i n phi}|: n theta makes V stationary, and the force at
 *                 fixed theta is V's whole gradient. V does not change when the body turns, so
 *                 angular momentum is constant. For the constant force w = r S, which makes the
 *                 torque vanish.
 *     surface     (1, mean of sin n phi with the same weights): takes the mean torque off every
 *                 bond; inside a body this adds nothing, so it acts at the surface only.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_RETURN_FORCE_H
#define FW_RETURN_FORCE_H

#include "core/particles/smooth_cut.h"
#include "core/public.h"
#include "core/status.h"
#include "core/vec2.h"

#include <math.h>
#include <stdbool.h>

FW_PUBLIC_BEGIN

typedef enum fw_return_variant { FW_RETURN_CONSERVATIVE, FW_RETURN_CONSTANT } fw_return_variant;

typedef enum fw_return_axes { FW_AXES_LAB, FW_AXES_COROTATING, FW_AXES_SURFACE } fw_return_axes;

typedef struct fw_return_force {
    int fold;         /* n, even: 6 hexagonal, 4 square */
    double amplitude; /* f0 >= 0; 0: none */
    double distance;  /* r0 */
    fw_smooth_cut cut;
    fw_return_variant variant;
    fw_return_axes axes;
    double
        angle; /* of the lab axes and of the surface rule, radians; a corotating body needs none */
} fw_return_force;

/* No force: n = 6, f0 = 0, r0 = 1, cut from 1.2 to 1.4, conservative, lab axes at angle 0. */
fw_return_force fw_return_force_default(void);

/* FW_BAD_INPUT with a sentence for: an odd fold, or one outside 2 to 24; an amplitude < 0; a cut
 * that takes in diagonals (outer >= sqrt 2 r0) or ends before it begins; non-finite numbers. */
fw_status fw_return_force_check(const fw_return_force *force, fw_error *error);

/* A complex number. */
typedef struct fw_phase {
    double cosine, sine;
} fw_phase;

static inline fw_phase fw_phase_product(fw_phase a, fw_phase b)
{
    return (fw_phase){a.cosine * b.cosine - a.sine * b.sine, a.cosine * b.sine + a.sine * b.cosine};
}

/* e^{i n phi} for even n, without trigonometry: the square ((dx + i dy)/r)^2 needs no root, and
 * its power n/2 is made by repeated squaring. */
static inline fw_phase fw_phase_of_bond(int fold, double dx, double dy, double inverse_r2)
{
    fw_phase square = {(dx * dx - dy * dy) * inverse_r2, 2 * dx * dy * inverse_r2};
    if (fold == 6) return fw_phase_product(square, fw_phase_product(square, square));
    if (fold == 4) return fw_phase_product(square, square);
    fw_phase power = {1, 0};
    for (int rest = fold / 2; rest; rest >>= 1) {
        if (rest & 1) power = fw_phase_product(power, square);
        square = fw_phase_product(square, square);
    }
    return power;
}

/* What one pair contributes, i seen from j. */
typedef struct fw_return_pair {
    fw_vec2 first, second; /* forces on i */
    double energy;         /* of `first`: V with the angle n phi; 0 for the constant force */
    double energy_second;  /* V with the angle n phi - n theta is turn.first * energy +
                              turn.second * energy_second for corotating axes */
    fw_phase sum;          /* corotating: w e^{i n phi}; surface: (w, w sin n phi) */
} fw_return_pair;

/* What a body makes of the two parts. */
typedef struct fw_turn {
    double first, second;
} fw_turn;

typedef struct fw_return_factors {
    double tangential, radial, energy; /* of sin n phi e_phi, of cos n phi e_r, of cos n phi */
    double weight;
} fw_return_factors;

/* Factors that make forces out of (-dy, dx) and (dx, dy). */
static inline fw_return_factors fw_return_factors_at(const fw_return_force *force, double r,
                                                     double inverse_r2)
{
    const fw_weight cut = fw_smooth_cut_at(force->cut, r);
    if (force->variant == FW_RETURN_CONSTANT)
        return (fw_return_factors){.tangential = -force->amplitude * cut.value * inverse_r2 * r,
                                   .radial = 0,
                                   .energy = 0,
                                   .weight = cut.value * r};
    const double depth = force->amplitude * force->distance / force->fold;
    return (fw_return_factors){.tangential =
                                   -force->amplitude * force->distance * cut.value * inverse_r2,
                               .radial = depth * cut.slope * inverse_r2 * r,
                               .energy = -depth * cut.value,
                               .weight = cut.value};
}

static inline fw_vec2 fw_return_part(fw_return_factors factors, fw_phase phase, double dx,
                                     double dy)
{
    const double tangential = factors.tangential * phase.sine;
    const double radial = factors.radial * phase.cosine;
    return (fw_vec2){radial * dx - tangential * dy, radial * dy + tangential * dx};
}

/* e^{i n (phi - angle)} with `axes` = e^{i n angle}. */
static inline fw_phase fw_return_phase(const fw_return_force *force, fw_phase axes, double dx,
                                       double dy, double inverse_r2)
{
    return fw_phase_product(fw_phase_of_bond(force->fold, dx, dy, inverse_r2),
                            (fw_phase){axes.cosine, -axes.sine});
}

/* The force on i alone, for lab axes. Nothing from the cut on. */
static inline fw_vec2 fw_return_lab(const fw_return_force *force, fw_phase axes, double dx,
                                    double dy, double r2)
{
    const bool inside = r2 < force->cut.outer * force->cut.outer;
    const double inverse_r2 = 1 / r2;
    const fw_phase phase = fw_return_phase(force, axes, dx, dy, inverse_r2);
    const fw_vec2 pull =
        fw_return_part(fw_return_factors_at(force, sqrt(r2), inverse_r2), phase, dx, dy);
    return (fw_vec2){inside ? pull.x : 0, inside ? pull.y : 0};
}

/* Everything about a pair, for any axes. Nothing from the cut on. */
static inline fw_return_pair fw_return_pair_at(const fw_return_force *force, fw_phase axes,
                                               double dx, double dy, double r2)
{
    const bool inside = r2 < force->cut.outer * force->cut.outer;
    const double inverse_r2 = 1 / r2;
    fw_return_factors factors = fw_return_factors_at(force, sqrt(r2), inverse_r2);
    factors.tangential = inside ? factors.tangential : 0;
    factors.radial = inside ? factors.radial : 0;
    factors.energy = inside ? factors.energy : 0;
    factors.weight = inside ? factors.weight : 0;
    const fw_phase phase = fw_return_phase(force, axes, dx, dy, inverse_r2);
    fw_return_pair pair = {.first = fw_return_part(factors, phase, dx, dy),
                           .second = {0, 0},
                           .energy = factors.energy * phase.cosine,
                           .energy_second = 0,
                           .sum = {0, 0}};
    if (force->axes == FW_AXES_COROTATING) {
        /* sin(a - t) = sin a cos t - cos a sin t, cos(a - t) = cos a cos t + sin a sin t */
        const fw_phase quarter = {phase.sine, -phase.cosine};
        pair.second = fw_return_part(factors, quarter, dx, dy);
        pair.energy_second = factors.energy * phase.sine;
        pair.sum = (fw_phase){factors.weight * phase.cosine, factors.weight * phase.sine};
    } else if (force->axes == FW_AXES_SURFACE) {
        pair.second = (fw_vec2){factors.tangential * dy, -factors.tangential * dx};
        pair.sum = (fw_phase){factors.weight, factors.weight * phase.sine};
    }
    return pair;
}

/* From the sums over all bonds of a body. Without any bond the axes are the lab's. */
static inline fw_turn fw_return_turn(fw_return_axes axes, fw_phase sum)
{
    if (axes == FW_AXES_COROTATING) {
        const double length = sqrt(sum.cosine * sum.cosine + sum.sine * sum.sine);
        if (length > 0) return (fw_turn){sum.cosine / length, sum.sine / length};
    } else if (axes == FW_AXES_SURFACE && sum.cosine > 0) {
        return (fw_turn){1, sum.sine / sum.cosine};
    }
    return (fw_turn){1, 0};
}

FW_PUBLIC_END

#endif
