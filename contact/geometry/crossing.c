/* SPDX-License-Identifier: GPL-3.0-or-later */
/* crossing.c - paths of points through segments. Keeps no state. */
#include "contact/geometry/crossing.h"

#include <math.h>

/* Segments are longer than they are by this part, so that nothing slips between two that meet. */
static const double END_TOLERANCE = 1e-9;

static fw_vec2 place_at(fw_moving_point point, double time)
{
    return fw_vec2_add(point.at, fw_vec2_scale(time, point.motion));
}

/* Points never come nearer to each other than this part of the way that would take them there: from
 * one place nobody could tell on which side each belongs. */
static const double MEETING = 1e-9;

/* Does the point lie beside the segment at that time, neither before its one end nor behind its
 * other? `tolerance`: as a part of the length, at either end. */
static bool lies_beside(fw_moving_point point, fw_moving_point from, fw_moving_point to,
                        double time, double tolerance)
{
    const fw_vec2 start = place_at(from, time);
    const fw_vec2 along = fw_vec2_subtract(place_at(to, time), start);
    const double part = fw_vec2_dot(fw_vec2_subtract(place_at(point, time), start), along);
    const double length_squared = fw_vec2_dot(along, along);
    return part >= -tolerance * length_squared && part <= (1 + tolerance) * length_squared;
}

bool fw_crossing_of_segment(fw_moving_point point, fw_moving_point from, fw_moving_point to,
                            double behind, double *when)
{
    const fw_vec2 edge = fw_vec2_subtract(to.at, from.at);
    const fw_vec2 turn = fw_vec2_subtract(to.motion, from.motion);
    const fw_vec2 apart = fw_vec2_subtract(point.at, from.at);
    const fw_vec2 motion = fw_vec2_subtract(point.motion, from.motion);
    /* Twice the area of the triangle, less what is kept of it: a0 + a1 t + a2 t^2. */
    const double squared = fw_vec2_dot(edge, edge), keep = fmax(-behind, 0) * squared;
    const double a0 = fw_vec2_cross(edge, apart) - keep;
    const double a1 = fw_vec2_cross(edge, motion) + fw_vec2_cross(turn, apart);
    const double a2 = fw_vec2_cross(turn, motion);
    const double end = a0 + (a1 + a2);
    *when = 0;
    if (a0 < 0) {
        const bool elsewhere = keep > 0 ? a0 <= -keep : a0 < -behind * squared;
        if (elsewhere || end >= a0) return false;
        return lies_beside(point, from, to, 0, 0);
    }
    if (a0 > 0) {
        const double discriminant = a1 * a1 - 4 * a0 * a2;
        if (!(discriminant >= 0)) return false;
        const double denominator = sqrt(discriminant) - a1;
        if (!(denominator > 0) || 2 * a0 > denominator) return false;
        *when = 2 * a0 / denominator;
    }
    if (*when >= 1 || a0 == 0) {
        if (!(end < 0)) return false;
    }
    return lies_beside(point, from, to, *when, END_TOLERANCE);
}

bool fw_crossing_round_end(fw_moving_point point, fw_moving_point from, fw_moving_point to,
                           double behind, bool *at_from)
{
    const fw_vec2 edge = fw_vec2_subtract(to.at, from.at);
    const fw_vec2 apart = fw_vec2_subtract(point.at, from.at);
    const double squared = fw_vec2_dot(edge, edge), part = fw_vec2_dot(apart, edge);
    const fw_vec2 later = fw_vec2_subtract(place_at(to, 1), place_at(from, 1));
    const double end =
        fw_vec2_cross(later, fw_vec2_subtract(place_at(point, 1), place_at(from, 1)));
    *at_from = part < 0;
    if (fw_vec2_cross(edge, apart) >= -behind * squared || end >= -behind * squared) return false;
    if ((part >= 0 && part <= squared) || !lies_beside(point, from, to, 1, 0)) return false;
    const fw_moving_point corner = *at_from ? from : to;
    const fw_vec2 motion = fw_vec2_subtract(point.motion, corner.motion);
    const fw_vec2 before = fw_vec2_subtract(point.at, corner.at);
    const fw_vec2 after = fw_vec2_add(before, motion);
    const double way = fw_vec2_dot(motion, motion);
    return fw_vec2_dot(before, before) <= way && fw_vec2_dot(after, after) <= way;
}

bool fw_crossing_of_points(fw_moving_point a, fw_moving_point b, double *when)
{
    const fw_vec2 apart = fw_vec2_subtract(b.at, a.at);
    const fw_vec2 motion = fw_vec2_subtract(b.motion, a.motion);
    const double approach = -fw_vec2_dot(apart, motion), squared = fw_vec2_dot(motion, motion);
    const double miss = fw_vec2_cross(apart, motion), size = fw_vec2_dot(apart, apart);
    *when = 0;
    if (!(size > 0) || !(approach > 0) || approach > squared * (1 + MEETING)) return false;
    *when = fmin(approach / squared, 1);
    /* |miss|/|motion| is how far apart they pass. */
    return miss * miss <= END_TOLERANCE * END_TOLERANCE * squared * size;
}

static fw_vec2 normal_at(fw_moving_point from, fw_moving_point to, double time)
{
    const fw_vec2 edge = fw_vec2_subtract(place_at(to, time), place_at(from, time));
    return fw_vec2_scale(1 / sqrt(fw_vec2_dot(edge, edge)), fw_vec2_turn(edge));
}

/* Nearer by less than this part of the distance is rounding. */
static const double ROUND_TOLERANCE = 1e-9;

/* How far it lies to the left of the segment's line. */
static double side_of(fw_moving_point point, fw_moving_point from, fw_moving_point to, double time)
{
    const fw_vec2 apart = fw_vec2_subtract(place_at(point, time), place_at(from, time));
    return fw_vec2_dot(normal_at(from, to, time), apart);
}

/* As the point would, were it nearer by the distance; exact where the step begins and ends. */
bool fw_crossing_of_distance(fw_moving_point point, fw_moving_point from, fw_moving_point to,
                             double distance, double behind, double *when)
{
    const fw_vec2 start =
        fw_vec2_subtract(point.at, fw_vec2_scale(distance, normal_at(from, to, 0)));
    const fw_vec2 end =
        fw_vec2_subtract(place_at(point, 1), fw_vec2_scale(distance, normal_at(from, to, 1)));
    const fw_moving_point nearer = {start, fw_vec2_subtract(end, start)};
    if (fw_crossing_of_segment(nearer, from, to, behind, when)) return true;
    /* It may come round a corner: from beyond the segment to beside it. */
    *when = 1;
    return !lies_beside(nearer, from, to, 0, 0) && lies_beside(nearer, from, to, 1, 0) &&
           side_of(nearer, from, to, 1) < -ROUND_TOLERANCE * distance &&
           side_of(point, from, to, 0) > -distance && side_of(point, from, to, 1) > -distance;
}

bool fw_crossing_of_circle(fw_moving_point a, fw_moving_point b, double distance, double *when)
{
    const fw_vec2 apart = fw_vec2_subtract(a.at, b.at);
    const fw_vec2 motion = fw_vec2_subtract(a.motion, b.motion);
    const double least = distance * (1 - ROUND_TOLERANCE);
    const double a0 = fw_vec2_dot(apart, apart) - least * least, a1 = fw_vec2_dot(apart, motion);
    const double a2 = fw_vec2_dot(motion, motion), discriminant = a1 * a1 - a2 * a0;
    *when = 0;
    if (!(a1 < 0)) return false;
    if (a0 <= 0) return true;
    if (!(discriminant > 0)) return false;
    *when = a0 / (sqrt(discriminant) - a1);
    return *when < 1;
}

bool fw_crossing_of_still(fw_vec2 a, fw_vec2 b, fw_vec2 c, fw_vec2 d)
{
    const fw_vec2 ab = fw_vec2_subtract(b, a), cd = fw_vec2_subtract(d, c);
    const double least = 1e-9 * (fw_vec2_dot(ab, ab) + fw_vec2_dot(cd, cd));
    const double c_side = fw_vec2_cross(ab, fw_vec2_subtract(c, a));
    const double d_side = fw_vec2_cross(ab, fw_vec2_subtract(d, a));
    const double a_side = fw_vec2_cross(cd, fw_vec2_subtract(a, c));
    const double b_side = fw_vec2_cross(cd, fw_vec2_subtract(b, c));
    return fmin(fabs(c_side), fabs(d_side)) > least && fmin(fabs(a_side), fabs(b_side)) > least &&
           (c_side > 0) != (d_side > 0) && (a_side > 0) != (b_side > 0);
}
