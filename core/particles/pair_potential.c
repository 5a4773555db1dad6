/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pair_potential.c - defaults and sanity of pair potentials. Keeps no state. */
#include "core/particles/pair_potential.h"

fw_pair_potential fw_pair_potential_default(void)
{
    return (fw_pair_potential){.kind = FW_LENNARD_JONES,
                               .depth = 1,
                               .distance = 1,
                               .steepness = 6,
                               .cut = fw_smooth_cut_over(1.4, 1.7)};
}

fw_status fw_pair_potential_check(const fw_pair_potential *potential, fw_error *error)
{
    const fw_smooth_cut cut = potential->cut;
    if (!(potential->depth >= 0 && isfinite(potential->depth)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the pair potential has a depth of %g, expected a number >= 0",
                       potential->depth);
    if (!(potential->distance > 0 && isfinite(potential->distance)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the pair potential has its minimum at distance %g, expected a number > 0",
                       potential->distance);
    if (potential->kind == FW_MORSE &&
        !(potential->steepness > 0 && isfinite(potential->steepness)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the Morse potential has a steepness of %g, expected a number > 0",
                       potential->steepness);
    if (!(cut.inner <= cut.outer && isfinite(cut.inner) && isfinite(cut.outer)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the pair potential is cut from %g to %g, expected an end that is not "
                       "before its beginning",
                       cut.inner, cut.outer);
    if (!(potential->distance <= cut.inner && potential->distance < cut.outer))
        return fw_fail(error, FW_BAD_INPUT,
                       "the pair potential has its minimum at %g, outside its cut from %g to %g: "
                       "expected the minimum where the potential still has its full strength",
                       potential->distance, cut.inner, cut.outer);
    return FW_OK;
}

double fw_pair_potential_curvature(const fw_pair_potential *potential, double r)
{
    const fw_smooth_cut cut = potential->cut;
    if (r >= cut.outer) return 0;
    double energy, slope, curvature; /* without the cut */
    if (potential->kind == FW_LENNARD_JONES) {
        const double ratio = potential->distance / r, cube = ratio * ratio * ratio;
        const double sixth = cube * cube;
        energy = sixth * (sixth - 2);
        slope = -12 * sixth * (sixth - 1) / r;
        curvature = 12 * sixth * (13 * sixth - 7) / (r * r);
    } else {
        const double a = potential->steepness, decay = exp(-a * (r - potential->distance));
        energy = decay * (decay - 2);
        slope = -2 * a * decay * (decay - 1);
        curvature = 2 * a * a * decay * (2 * decay - 1);
    }
    const fw_weight weight = fw_smooth_cut_at(cut, r);
    const double x = fmin(1, fmax(0, (r - cut.inner) * cut.scale));
    const double bend = -60 * x * (1 - x) * (1 - 2 * x) * cut.scale * cut.scale;
    return potential->depth * (curvature * weight.value + 2 * slope * weight.slope + energy * bend);
}

double fw_pair_potential_hottest(const fw_pair_potential *potential, double strength, double mass,
                                 double time_step)
{
    enum { COLLISION = 10, HALVINGS = 60 };
    const double depth = strength * potential->depth;
    if (!(depth > 0)) return INFINITY;
    const double stiffest = 2 * mass / (time_step * time_step);
    double hard = 1e-3 * potential->distance, soft = potential->distance;
    if (!(strength * fw_pair_potential_curvature(potential, hard) > stiffest)) return INFINITY;
    for (int n = 0; n < HALVINGS; ++n) {
        const double middle = 0.5 * (hard + soft);
        const bool too_stiff = strength * fw_pair_potential_curvature(potential, middle) > stiffest;
        *(too_stiff ? &hard : &soft) = middle;
    }
    return (strength * fw_pair_at(potential, soft * soft).energy + depth) / COLLISION;
}

/* Each term by itself, without those that are negative where U'' and U'/r are positive. With
 * s = d/r, e = e^{-a (r - d)}, and the weight S from d on, where U >= -depth:
 *     Lennard-Jones  U'' <= 156 depth/d^2 s^14,   U' = 12 depth/d (s^7 - s^13) <= 2.7 depth/d
 *     Morse          U'' <= 4 a^2 depth e^2,      U' = 2 a depth e (1 - e) <= a depth/2
 *     (U S)'' - U'' S <= U S'' <= 5.8 depth/(b - a)^2,   U S' <= 1.9 depth/(b - a)
 * and U'/r <= U'/d, since U' is only positive there. */
double fw_pair_potential_stiffest(const fw_pair_potential *potential, double closest)
{
    const double scale = potential->cut.scale, distance = potential->distance;
    double curvature, slope; /* by the depth */
    if (potential->kind == FW_LENNARD_JONES) {
        curvature = 156 * pow(distance / closest, 14) / (distance * distance);
        slope = 2.7 / distance;
    } else {
        const double a = potential->steepness, decay = exp(-a * (closest - distance));
        curvature = 4 * a * a * decay * decay;
        slope = a / 2;
    }
    return potential->depth *
           fmax(curvature + 5.8 * scale * scale, (slope + 1.9 * scale) / distance);
}

double fw_pair_potential_stiffness(const fw_pair_potential *potential)
{
    if (potential->kind == FW_MORSE)
        return 2 * potential->depth * potential->steepness * potential->steepness;
    return 72 * potential->depth / (potential->distance * potential->distance);
}
