/* SPDX-License-Identifier: GPL-3.0-or-later */
/* range.h - the interval that numbers span.
 */
#ifndef FW_RANGE_H
#define FW_RANGE_H

#include <stdbool.h>

/* Empty while high < low; all zero counts as unset (no extent). */
typedef struct fw_range {
    double low, high;
} fw_range;

fw_range fw_range_empty(void);
static inline bool fw_range_is_empty(fw_range range)
{
    return !(range.low <= range.high);
}

/* Widens the range by the finite ones of `count` values (only positive ones, if `positive_only`).
 */
void fw_range_include(fw_range *range, const double *values, long count, bool positive_only);

/* The interval [low, high] that leaves at most the part `trim` of the finite values beyond each
 * end. */
fw_range fw_range_of_most(const double *values, long count, double trim, bool positive_only);

/* The middle alone of a range that is narrower than a 1e-10th of its values: differences that come
 * from rounding are no structure. */
fw_range fw_range_without_rounding(fw_range range);

/* Zero alone becomes [0, 1]: what cannot be negative is not shown as if it could. */
fw_range fw_range_up_from_zero(fw_range range);

/* A range one can draw: an empty one becomes [0, 1], a single value gets room on both sides, a
 * range of rounding errors is widened to several of them, and `part` of the extent (of the ratio,
 * on a logarithmic axis) is added at both ends. */
fw_range fw_range_roomy(fw_range range, double part, bool logarithmic);

#endif
