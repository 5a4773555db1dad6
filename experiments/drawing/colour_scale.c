/* SPDX-License-Identifier: GPL-3.0-or-later */
/* colour_scale.c - from the range of the values to their colours.
 * Keeps no state. Start reading at fw_colour_scale_for(). */
#include "experiments/drawing/colour_scale.h"

#include <math.h>

fw_colour_scale fw_colour_scale_for(fw_colouring wish, const double *values, long count)
{
    fw_colour_scale scale = {.label = wish.label, .logarithmic = wish.logarithmic, .map = wish.map};
    fw_range all = fw_range_empty();
    fw_range_include(&all, values, count, wish.logarithmic);
    bool fixed = wish.range.high > wish.range.low;
    scale.range = fixed           ? wish.range
                  : wish.trim > 0 ? fw_range_of_most(values, count, wish.trim, wish.logarithmic)
                                  : all;
    if (scale.map == FW_PALETTE_AUTO) {
        /* A sign from rounding alone is no change of sign. */
        double low = -scale.range.low, high = scale.range.high;
        bool both_signs = fmin(low, high) > 1e-3 * fmax(low, high) && !wish.logarithmic;
        scale.map = both_signs ? FW_PALETTE_DIVERGING : FW_PALETTE_SEQUENTIAL;
    }
    if (!fixed && scale.map == FW_PALETTE_DIVERGING && !fw_range_is_empty(scale.range)) {
        double end = fmax(fabs(scale.range.low), fabs(scale.range.high));
        scale.range = (fw_range){-end, end};
    }
    if (!fixed && !wish.logarithmic) scale.range = fw_range_without_rounding(scale.range);
    if (!wish.logarithmic) scale.range = fw_range_up_from_zero(scale.range);
    scale.range = fw_range_roomy(scale.range, 0, wish.logarithmic);
    scale.fixed = fixed;
    scale.exceeds_low = all.low < scale.range.low;
    scale.exceeds_high = all.high > scale.range.high;
    return scale;
}

fw_colour fw_colour_scale_at(const fw_colour_scale *scale, double value)
{
    if (!isfinite(value) || (scale->logarithmic && !(value > 0))) return fw_colour_grey(.7);
    double low = scale->range.low, high = scale->range.high;
    double part =
        scale->logarithmic ? log(value / low) / log(high / low) : (value - low) / (high - low);
    return fw_palette_at(scale->map, part);
}
