/* SPDX-License-Identifier: GPL-3.0-or-later */
/* return_force.c - defaults and sanity of return forces. Keeps no state. */
#include "core/particles/return_force.h"

enum { FOLD_MAX = 24 };

fw_return_force fw_return_force_default(void)
{
    return (fw_return_force){.fold = 6, .distance = 1, .cut = fw_smooth_cut_over(1.2, 1.4)};
}

fw_status fw_return_force_check(const fw_return_force *force, fw_error *error)
{
    const fw_smooth_cut cut = force->cut;
    if (force->fold % 2 != 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "the return force has the odd fold %d, expected an even one (4 or 6): with "
                       "an odd one the two particles of a bond would not pull equally",
                       force->fold);
    if (force->fold < 2 || force->fold > FOLD_MAX)
        return fw_fail(error, FW_BAD_INPUT,
                       "the return force has the fold %d, expected an even number from 2 to %d",
                       force->fold, FOLD_MAX);
    if (!(force->amplitude >= 0 && isfinite(force->amplitude)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the return force has an amplitude of %g, expected a number >= 0",
                       force->amplitude);
    if (!(force->distance > 0 && isfinite(force->distance)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the return force has a bond length of %g, expected a number > 0",
                       force->distance);
    if (!(cut.inner >= 0 && cut.inner <= cut.outer && cut.outer > 0 && isfinite(cut.outer)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the return force is cut from %g to %g, expected an end that is not before "
                       "its beginning",
                       cut.inner, cut.outer);
    if (!(cut.outer < sqrt(2) * force->distance))
        return fw_fail(error, FW_BAD_INPUT,
                       "the return force reaches to a proximity radius of %g, expected less than "
                       "sqrt(2) r0 = %.6g: beyond it takes in the diagonals of a square",
                       cut.outer, sqrt(2) * force->distance);
    if (!isfinite(force->angle))
        return fw_fail(error, FW_BAD_INPUT,
                       "the axes of the return force have the angle %g, expected a finite number",
                       force->angle);
    return FW_OK;
}
