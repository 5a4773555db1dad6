/* SPDX-License-Identifier: GPL-3.0-or-later */
/* crossing.h - does a moving point pass through a moving segment in the course of a step? In double
 * precision and in continuous time: all three move evenly, so that the area between them is a
 * quadratic function of time. */
#ifndef FW_CROSSING_H
#define FW_CROSSING_H

#include "core/vec2.h"

#include <stdbool.h>

/* A point that moves evenly by `motion` in the step. */
typedef struct fw_moving_point {
    fw_vec2 at, motion;
} fw_moving_point;

/* Does the point pass from the left of the segment from -> to to its right? Both ends belong to the
 * segment. A point behind it by no more than `behind` times its length, which rounding or an
 * iteration may have put there, passes where it would go deeper; a negative `behind`: it passes
 * where it comes nearer than that, and where it does not lie to the left it belongs to the other
 * side. *when is the part of the step after which it passes, 0 to 1. */
bool fw_crossing_of_segment(fw_moving_point point, fw_moving_point from, fw_moving_point to,
                            double behind, double *when);

/* Does the point come behind the segment round one of its ends? It lies behind the segment's
 * extension and beyond that end, as before a face that bends away there, and in the end it lies
 * behind the segment itself, where the face has bent the other way; both near the end, by no more
 * than they move apart. By more than `behind` of the length. */
bool fw_crossing_round_end(fw_moving_point point, fw_moving_point from, fw_moving_point to,
                           double behind, bool *at_from);

/* Do two points meet, as the ends of chains do that lie in one line? They pass each other no
 * further apart than rounding explains, or nearly come to one place. Points that start at one place
 * do not meet. */
bool fw_crossing_of_points(fw_moving_point a, fw_moving_point b, double *when);

/* Does the point come nearer to the left side of the segment than `distance` > 0, whatever becomes
 * of the segment's direction? `behind` as above. */
bool fw_crossing_of_distance(fw_moving_point point, fw_moving_point from, fw_moving_point to,
                             double distance, double behind, double *when);
/* Do two points come nearer to each other than that? */
bool fw_crossing_of_circle(fw_moving_point a, fw_moving_point b, double distance, double *when);

/* Do the segments a -> b and c -> d cross as they lie, well between their ends: by more than
 * rounding? */
bool fw_crossing_of_still(fw_vec2 a, fw_vec2 b, fw_vec2 c, fw_vec2 d);

#endif
