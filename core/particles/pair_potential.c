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

double fw_pair_potential_stiffness(const fw_pair_potential *potential)
{
    if (potential->kind == FW_MORSE)
        return 2 * potential->depth * potential->steepness * potential->steepness;
    return 72 * potential->depth / (potential->distance * potential->distance);
}
