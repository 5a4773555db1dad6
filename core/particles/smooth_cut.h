/* SPDX-License-Identifier: GPL-3.0-or-later */
/* smooth_cut.h - a weight that leads a force from full strength to nothing over a range of
 * distances, twice differentiable at both ends:
 *     S(r; a, b) = 1 - x^3 (10 - 15 x + 6 x^2),   x = clamp((r - a)/(b - a), 0, 1).
 * Where the range has no width (a = b) it is a step: 1 for r < b, 0 from there on.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_SMOOTH_CUT_H
#define FW_SMOOTH_CUT_H

#include "core/public.h"

FW_PUBLIC_BEGIN

typedef struct fw_smooth_cut {
    double inner; /* a: full weight up to here */
    double outer; /* b: no weight from here on */
    double scale; /* 1/(b - a); 0 where the range has no width */
} fw_smooth_cut;

/* 0 <= inner <= outer. */
static inline fw_smooth_cut fw_smooth_cut_over(double inner, double outer)
{
    return (fw_smooth_cut){inner, outer, outer > inner ? 1 / (outer - inner) : 0};
}

typedef struct fw_weight {
    double value; /* S */
    double slope; /* dS/dr */
} fw_weight;

/* S and its slope at distance r; 0 from the outer end on, except for a cut without width, where the
 * caller decides. Without branches, so that loops over pairs become vector code. */
static inline fw_weight fw_smooth_cut_at(fw_smooth_cut cut, double r)
{
    double x = (r - cut.inner) * cut.scale;
    x = x > 0 ? x : 0;
    x = x < 1 ? x : 1;
    const double square = x * x;
    const double value = 1 - x * square * (10 - x * (15 - 6 * x));
    const double slope = -30 * square * (1 - x) * (1 - x) * cut.scale;
    return (fw_weight){value, slope};
}

FW_PUBLIC_END

#endif
