/* SPDX-License-Identifier: GPL-3.0-or-later */
/* range.c - intervals.
 * Keeps no state. Start reading at fw_range_roomy(). */
#include "experiments/text/range.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

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

/* Doubles in the order of their values as whole numbers: those below 0 count downwards. */
static uint64_t order_of(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits >> 63 ? ~bits : bits | UINT64_C(1) << 63;
}

static double value_of(uint64_t order)
{
    const uint64_t bits = order >> 63 ? order ^ UINT64_C(1) << 63 : ~order;
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* The value of those that count with so many of them before it, bit by bit: sorting them would ask
 * for memory. */
static double value_of_rank(const double *values, long count, long rank, bool positive_only)
{
    uint64_t order = 0;
    for (int bit = 63; bit >= 0; --bit) {
        const uint64_t tried = order | UINT64_C(1) << bit;
        long before = 0;
        for (long k = 0; k < count; ++k)
            before += counts(values[k], positive_only) && order_of(values[k]) < tried;
        if (before <= rank) order = tried;
    }
    return value_of(order);
}

fw_range fw_range_of_most(const double *values, long count, double trim, bool positive_only)
{
    long kept = 0;
    for (long k = 0; k < count; ++k) kept += counts(values[k], positive_only);
    if (kept == 0) return fw_range_empty();
    const long beyond = (long)(fmin(trim, .5) * (double)(kept - 1));
    return (fw_range){value_of_rank(values, count, beyond, positive_only),
                      value_of_rank(values, count, kept - 1 - beyond, positive_only)};
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
