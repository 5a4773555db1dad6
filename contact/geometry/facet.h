/* SPDX-License-Identifier: GPL-3.0-or-later */
/* facet.h - one piece of a wall's surface: exact geometry in double precision.
 *
 * A facet is straight (a segment, free to its left) or round (a whole circle, free inside or
 * outside). It bars the way from its free side to the other; from behind it does not bar. Contact
 * decides on facets alone, so that every shape and corner is covered by these two. All points are
 * in the frame of the wall, i.e. minus the wall's displacement.
 *
 * Public, since walls are made of them; may change. */
#ifndef FW_FACET_H
#define FW_FACET_H

#include "core/public.h"
#include "core/vec2.h"

#include <stdbool.h>

FW_PUBLIC_BEGIN

typedef struct fw_box {
    fw_vec2 low, high;
} fw_box;

/* Larger by `margin` on every side. */
static inline fw_box fw_box_grown(fw_box box, double margin)
{
    box.low.x -= margin;
    box.low.y -= margin;
    box.high.x += margin;
    box.high.y += margin;
    return box;
}

/* The smaller, the larger of two numbers; of one that is none and one that is, the other. (fmin and
 * fmax say the same, and are calls.) */
static inline double fw_least(double a, double b)
{
    return a < b || b != b ? a : b;
}

static inline double fw_most(double a, double b)
{
    return a > b || b != b ? a : b;
}

/* Around both boxes, around both points. */
static inline fw_box fw_box_joined(fw_box a, fw_box b)
{
    a.low.x = fw_least(a.low.x, b.low.x);
    a.low.y = fw_least(a.low.y, b.low.y);
    a.high.x = fw_most(a.high.x, b.high.x);
    a.high.y = fw_most(a.high.y, b.high.y);
    return a;
}

static inline fw_box fw_box_around(fw_vec2 p, fw_vec2 q)
{
    fw_box at_p, at_q;
    at_p.low = at_p.high = p;
    at_q.low = at_q.high = q;
    return fw_box_joined(at_p, at_q);
}

/* Does one box lie in the other? A box lies in itself. */
static inline bool fw_box_lies_within(fw_box inner, fw_box outer)
{
    return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y &&
           inner.high.x <= outer.high.x && inner.high.y <= outer.high.y;
}

/* Where particles are free to be. */
typedef enum fw_side { FW_INSIDE, FW_OUTSIDE } fw_side;

typedef enum fw_facet_kind { FW_STRAIGHT, FW_ROUND } fw_facet_kind;

/* Made by fw_facet_straight() and fw_facet_round(), read by everybody. */
typedef struct fw_facet {
    fw_facet_kind kind;
    int wall;       /* index of the wall it belongs to */
    fw_vec2 a, b;   /* straight: ends; round: both are the centre */
    fw_vec2 normal; /* straight: unit vector to the free side, (b - a) turned to the left */
    double length;  /* straight: |b - a|; round: radius */
    fw_side side;   /* round: where particles are free */
    double reach;   /* largest coordinate it comes to, swings included; sizes rounding errors */
} fw_facet;

/* `swing`: how far an oscillation carries the wall from the place of its definition. */
fw_facet fw_facet_straight(int wall, fw_vec2 a, fw_vec2 b, double swing);
fw_facet fw_facet_round(int wall, fw_vec2 centre, double radius, fw_side side, double swing);

/* Signed distance of a point from the facet's line or circle, positive on the free side. For
 * axis-parallel facets a single exact subtraction. */
double fw_facet_gap(const fw_facet *facet, fw_vec2 point);

/* Whether its normal is another one at every place. */
bool fw_facet_is_curved(const fw_facet *facet);

/* Unit vector to the free side, as seen from a point at `from` from the facet's `a` (the centre of
 * a circle, in which every direction is as good). */
fw_vec2 fw_facet_normal(const fw_facet *facet, fw_vec2 from);

/* Does a particle at `point` that moves by `displacement` pass from the free side to the other
 * through this facet, whose wall is `away` from its definition? It ends where the sum, rounded as a
 * solid rounds it, lies: after a step that passes nothing the gap is >= 0 to the last bit. A point
 * behind by no more than the tolerance counts as on the facet, and ends belong to it, so that
 * nothing slips between two facets that meet. From a circle's outside a path that cuts through and
 * comes out again passes, too. */
bool fw_facet_is_passed(const fw_facet *facet, fw_vec2 point, fw_vec2 displacement, double away);

/* 2^-40 of the largest coordinate: some thousand rounding errors. So much a particle that is held
 * on an oblique or moving facet may drift in the course of a run; a true particle is never so
 * near to a facet by chance. `away` is how far the wall is from its definition now, the larger
 * component: where its path will ever lead does not matter. */
double fw_facet_tolerance(const fw_facet *facet, double away);

/* False only if no path inside the box can pass the facet while its wall is no further `away`. */
bool fw_facet_meets_box(const fw_facet *facet, fw_box box, double away);

fw_box fw_facet_bounds(const fw_facet *facet);

FW_PUBLIC_END

#endif
