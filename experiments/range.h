/* SPDX-License-Identifier: GPL-3.0-or-later */
/* range.h - the interval that numbers span, and round numbers inside it for the ticks of an axis.
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

/* Widens the range by the finite ones of `count` values (positive ones only, if asked). */
void fw_range_include(fw_range *range, const double *values, long count, bool positive_only);

/* The interval [low, high] that leaves at most the part `trim` of the finite values beyond each
 * end. Falls back on all of them without memory to sort. */
fw_range fw_range_of_most(const double *values, long count, double trim, bool positive_only);

/* A range one can draw: an empty one becomes [0, 1], a single value gets room on both sides, a
 * range of rounding errors is widened to several of them, and `part` of the extent (of the ratio,
 * on a logarithmic axis) is added at both ends. */
fw_range fw_range_roomy(fw_range range, double part, bool logarithmic);

/* Round numbers inside a range. */
enum { FW_TICKS_MOST = 32, FW_TICKS_MINOR_MOST = 200, FW_TICK_LABEL_SIZE = 40 };
typedef struct fw_ticks {
    int count;
    double at[FW_TICKS_MOST];
    char label[FW_TICKS_MOST][FW_TICK_LABEL_SIZE]; /* text for fw_canvas_text */
    int minor_count;
    double minor[FW_TICKS_MINOR_MOST];
    /* What the numbers are to be multiplied by and added to, "x10^{-14} + 1"; "" for nothing. */
    char note[64];
} fw_ticks;

/* At most about `wanted` labelled ticks (at least two where the range allows). */
void fw_ticks_find(fw_ticks *ticks, fw_range range, bool logarithmic, int wanted);

/* A number as one would print it, with `digits` significant digits: true minus sign, thin spaces
 * between thousands, powers of ten raised (as markup of fw_canvas_text). */
void fw_number_print(char *text, int size, double value, int digits);

#endif
