/* SPDX-License-Identifier: GPL-3.0-or-later */
/* range.c - intervals.
 * Keeps no state. Start reading at fw_range_roomy(). */
#include "experiments/text/range.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

fw_range fw_range_empty(void)
{
    return (fw_range){INFINITY, -INFINITY};
}

static bool counts(double value, bool positive_only)
{
    return isfinite(value) && (value > 0 || !positive_only);
}

void fw_range_include(fw_range *range, const double *values, long count, bool positive_only)
{
    for (long k = 0; k < count; ++k) {
        if (!counts(values[k], positive_only)) continue;
        range->low = fmin(range->low, values[k]);
        range->high = fmax(range->high, values[k]);
    }
}

static int by_value(const void *a, const void *b)
{
    double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

fw_range fw_range_of_most(const double *values, long count, double trim, bool positive_only)
{
    fw_range range = fw_range_empty();
    double *sorted = count > 0 ? malloc((size_t)count * sizeof *sorted) : NULL;
    if (!sorted) {
        fw_range_include(&range, values, count, positive_only);
        return range;
    }
    long kept = 0;
    for (long k = 0; k < count; ++k) {
        if (counts(values[k], positive_only)) sorted[kept++] = values[k];
    }
    if (kept > 0) {
        qsort(sorted, (size_t)kept, sizeof *sorted, by_value);
        long beyond = (long)(fmin(trim, .5) * (double)(kept - 1));
        range = (fw_range){sorted[beyond], sorted[kept - 1 - beyond]};
    }
    free(sorted);
    return range;
}

fw_range fw_range_without_rounding(fw_range range)
{
    double largest = fmax(fabs(range.low), fabs(range.high));
    if (fw_range_is_empty(range) || range.high - range.low > 1e-10 * largest) return range;
    double middle = range.low + (range.high - range.low) / 2;
    return (fw_range){middle, middle};
}

fw_range fw_range_up_from_zero(fw_range range)
{
    return range.low == 0 && range.high == 0 ? (fw_range){0, 1} : range;
}

/* Nobody plots less; what is closer to zero has lost digits, and powers of ten with it. */
static const double smallest = 1e-290;

static fw_range roomy_logarithmic(fw_range range, double part)
{
    if (fw_range_is_empty(range) || !(range.high > 0)) return (fw_range){1, 10};
    range.high = fmax(range.high, smallest);
    range.low = fmax(range.low > 0 ? range.low : range.high * 1e-6, smallest);
    double ratio = range.high / range.low;
    double room = ratio < 1.05 ? 2 : isfinite(ratio) ? pow(ratio, part) : 1;
    return (fw_range){fmax(range.low / room, DBL_MIN), fmin(range.high * room, DBL_MAX / 16)};
}

fw_range fw_range_roomy(fw_range range, double part, bool logarithmic)
{
    if (logarithmic) return roomy_logarithmic(range, part);
    if (fw_range_is_empty(range)) return (fw_range){0, 1};
    /* So that high - low is a number. */
    range.low = fmax(range.low, -DBL_MAX / 16);
    range.high = fmin(range.high, DBL_MAX / 16);
    double largest = fmax(fabs(range.low), fabs(range.high));
    double extent = range.high - range.low;
    if (!(extent > smallest)) {
        double room = largest > smallest ? .1 * largest : 1;
        return (fw_range){range.low - room, range.high + room};
    }
    double lacking = fmax(0, 16 * DBL_EPSILON * largest - extent);
    double room = part * extent + lacking / 2;
    return (fw_range){range.low - room, range.high + room};
}
