/* SPDX-License-Identifier: GPL-3.0-or-later */
/* facet.c - gaps and passages. Keeps no state.
 * Invariant: every comparison is such that rounding lets a facet bar too much by its tolerance,
 * never too little. Start reading at fw_facet_is_passed(). */
#include "contact/geometry/facet.h"

#include <math.h>

static const double tolerance_share = 0x1p-40;

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* Largest coordinate of a point without its sign. */
static double magnitude(fw_vec2 point)
{
    return larger(fabs(point.x), fabs(point.y));
}

fw_facet fw_facet_straight(int wall, fw_vec2 a, fw_vec2 b, double swing)
{
    fw_vec2 along = fw_vec2_subtract(b, a);
    /* hypot is exact where one component is zero: the normal is then exactly one of the axes. */
    double length = hypot(along.x, along.y);
    return (fw_facet){.kind = FW_STRAIGHT,
                      .wall = wall,
                      .a = a,
                      .b = b,
                      .normal = {-along.y / length, along.x / length},
                      .length = length,
                      .reach = larger(magnitude(a), magnitude(b)) + swing};
}

fw_facet fw_facet_round(int wall, fw_vec2 centre, double radius, fw_side side, double swing)
{
    return (fw_facet){.kind = FW_ROUND,
                      .wall = wall,
                      .a = centre,
                      .b = centre,
                      .length = radius,
                      .side = side,
                      .reach = magnitude(centre) + radius + swing};
}

double fw_facet_gap(const fw_facet *facet, fw_vec2 point)
{
    fw_vec2 from_a = fw_vec2_subtract(point, facet->a);
    if (facet->kind == FW_STRAIGHT) return fw_vec2_dot(from_a, facet->normal);
    double distance = sqrt(fw_vec2_dot(from_a, from_a));
    return facet->side == FW_INSIDE ? facet->length - distance : distance - facet->length;
}

bool fw_facet_is_curved(const fw_facet *facet)
{
    return facet->kind == FW_ROUND;
}

fw_vec2 fw_facet_normal(const fw_facet *facet, fw_vec2 from)
{
    if (facet->kind == FW_STRAIGHT) return facet->normal;
    const double distance = sqrt(fw_vec2_dot(from, from));
    if (!(distance > 0)) return (fw_vec2){1, 0};
    return fw_vec2_scale((facet->side == FW_INSIDE ? -1 : 1) / distance, from);
}

double fw_facet_tolerance(const fw_facet *facet, double away)
{
    return tolerance_share * (facet->reach + away);
}

static double clamped_to_unit(double share)
{
    return smaller(larger(share, 0), 1);
}

/* Does the part of the path on which |gap| <= tolerance meet the segment, ends included? A part
 * of the path, instead of the one point where it crosses, keeps corners closed however flat the
 * path runs: the crossing point is then as uncertain as that part is long. */
static bool crosses_within_ends(const fw_facet *facet, fw_vec2 start, fw_vec2 end, double gap,
                                double gap_after, double tolerance)
{
    const fw_vec2 tangent = {facet->normal.y, -facet->normal.x};
    double along = fw_vec2_dot(fw_vec2_subtract(start, facet->a), tangent);
    double along_after = fw_vec2_dot(fw_vec2_subtract(end, facet->a), tangent);
    double fall = gap - gap_after;
    double enter = clamped_to_unit((gap - tolerance) / fall);
    double leave = clamped_to_unit((gap + tolerance) / fall);
    double along_enter = along + enter * (along_after - along);
    double along_leave = along + leave * (along_after - along);
    return larger(along_enter, along_leave) >= -tolerance &&
           smaller(along_enter, along_leave) <= facet->length + tolerance;
}

/* A path from outside that ends outside can still cut through a circle: it does if its point
 * nearest to the centre is further inside than the tolerance. */
static bool cuts_through(const fw_facet *facet, fw_vec2 start, fw_vec2 end, double tolerance)
{
    fw_vec2 from_centre = fw_vec2_subtract(start, facet->a);
    fw_vec2 step = fw_vec2_subtract(end, start);
    double inward = -fw_vec2_dot(from_centre, step);
    double step_squared = fw_vec2_dot(step, step);
    if (!(inward > 0 && inward < step_squared)) return false;
    double moment = fw_vec2_cross(from_centre, step);
    double depth = facet->length - tolerance;
    return depth > 0 && moment * moment < depth * depth * step_squared;
}

bool fw_facet_is_passed(const fw_facet *facet, fw_vec2 point, fw_vec2 displacement, double away)
{
    fw_vec2 end = fw_vec2_add(point, displacement);
    double gap = fw_facet_gap(facet, point), gap_after = fw_facet_gap(facet, end);
    double tolerance = larger(fw_facet_tolerance(facet, away),
                              tolerance_share * larger(magnitude(point), magnitude(end)));
    if (gap < -tolerance) return false;
    bool enters = gap_after < 0 && gap_after < gap;
    if (facet->kind == FW_STRAIGHT)
        return enters && crosses_within_ends(facet, point, end, gap, gap_after, tolerance);
    return enters || (facet->side == FW_OUTSIDE && cuts_through(facet, point, end, tolerance));
}

fw_box fw_facet_bounds(const fw_facet *facet)
{
    fw_vec2 a = facet->a, b = facet->b;
    double radius = facet->kind == FW_ROUND ? facet->length : 0;
    return (fw_box){{smaller(a.x, b.x) - radius, smaller(a.y, b.y) - radius},
                    {larger(a.x, b.x) + radius, larger(a.y, b.y) + radius}};
}

bool fw_facet_meets_box(const fw_facet *facet, fw_box box, double away)
{
    const fw_vec2 low = box.low, high = box.high;
    const double room = larger(fw_facet_tolerance(facet, away),
                               tolerance_share * larger(magnitude(low), magnitude(high)));
    const fw_box bounds = fw_facet_bounds(facet);
    if (low.x > bounds.high.x + room || high.x < bounds.low.x - room) return false;
    if (low.y > bounds.high.y + room || high.y < bounds.low.y - room) return false;
    if (facet->kind == FW_STRAIGHT) {
        /* All corners on one side of the line? */
        fw_vec2 half = fw_vec2_scale(0.5, fw_vec2_subtract(high, low));
        double gap = fw_facet_gap(facet, fw_vec2_add(low, half));
        double spread = half.x * fabs(facet->normal.x) + half.y * fabs(facet->normal.y) + room;
        return !(gap > spread || gap < -spread);
    }
    /* Nearest and furthest point of the box, seen from the centre. */
    fw_vec2 below = fw_vec2_subtract(facet->a, low), above = fw_vec2_subtract(high, facet->a);
    fw_vec2 nearest = {larger(0, larger(-below.x, -above.x)),
                       larger(0, larger(-below.y, -above.y))};
    fw_vec2 furthest = {larger(below.x, above.x), larger(below.y, above.y)};
    return !(hypot(nearest.x, nearest.y) > facet->length + room ||
             hypot(furthest.x, furthest.y) < facet->length - room);
}
