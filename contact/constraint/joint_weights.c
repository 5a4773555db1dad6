/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_weights.c - what a row weighs: the gradient of its gap at the middle of the step, and the
 * line of numbers that becomes of it. State: none. Start reading at joint_weigh(). */
#include "joint_parts.h"

#include <math.h>

/* What is known of the displacement of an end. */
static fw_vec2 displacement_of(const fw_joint *joint, const fw_joint_end *ends, int end)
{
    const int local = joint->local[end];
    return local >= 0 ? joint->w[local] : ends[end].displacement;
}

/* Where the row touches its end k at the start of the step. */
static fw_vec2 position_of(const fw_joint_end *ends, const fw_joint_row *row, int k)
{
    return fw_vec2_add(ends[row->end[k]].position, row->offset[k]);
}

fw_vec2 joint_middle_of(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *row,
                        int k)
{
    return fw_vec2_add(position_of(ends, row, k),
                       fw_vec2_scale(0.5, displacement_of(joint, ends, row->end[k])));
}

static fw_vec2 scaled_to(fw_vec2 v, double length)
{
    return length > 0 ? fw_vec2_scale(1 / length, v) : v;
}

static double length_of(fw_vec2 v)
{
    return sqrt(fw_vec2_dot(v, v));
}

/* |v| changes from the start to the end of a step, the middle of which is known, by exactly this
 * times the change of v. */
static fw_vec2 gradient_of_length(fw_vec2 start, fw_vec2 middle)
{
    const fw_vec2 end = fw_vec2_subtract(fw_vec2_scale(2, middle), start);
    return scaled_to(fw_vec2_scale(2, middle), length_of(start) + length_of(end));
}

/* Area (k - j) x (i - j), whose gradient at the middle gives its change over the step exactly;
 * divided by the length at the start. With a distance d it is the area less d |k - j|. */
static void weigh_segment(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row)
{
    const fw_vec2 i = joint_middle_of(joint, ends, row, 0),
                  j = joint_middle_of(joint, ends, row, 1),
                  k = joint_middle_of(joint, ends, row, 2);
    const fw_vec2 edge = fw_vec2_subtract(position_of(ends, row, 2), position_of(ends, row, 1));
    const double length = length_of(edge);
    row->weight[0] = scaled_to(fw_vec2_turn(fw_vec2_subtract(k, j)), length);
    row->weight[2] = scaled_to(fw_vec2_turn(fw_vec2_subtract(j, i)), length);
    if (row->distance > 0)
        row->weight[2] = fw_vec2_subtract(
            row->weight[2], fw_vec2_scale(row->distance / length,
                                          gradient_of_length(edge, fw_vec2_subtract(k, j))));
    row->weight[1] = fw_vec2_scale(-1, fw_vec2_add(row->weight[0], row->weight[2]));
    row->bound = 0;
}

/* The ends of a row on their paths through the step. */
typedef struct paths {
    fw_vec2 at[3], w[3];
} paths;

static fw_vec2 place_of(const paths *q, int k, double time)
{
    return fw_vec2_add(q->at[k], fw_vec2_scale(time, q->w[k]));
}

static fw_vec2 between(const paths *q, int from, int to, double time)
{
    return fw_vec2_subtract(place_of(q, to, time), place_of(q, from, time));
}

/* How far end 0 lies beyond the corner along the segment, times its length. */
static double beyond(const paths *q, int corner, double time)
{
    return fw_vec2_dot(between(q, corner, 0, time), between(q, 1, 2, time));
}

/* Where end 0 begins beyond a corner of the segment and ends beside it: the corner, and when it
 * passes it (a quadratic function of time, by secants). 0: it does not. */
static int corner_passed(const paths *q, double *when)
{
    const int corner = beyond(q, 1, 0) < 0 ? 1 : beyond(q, 2, 0) > 0 ? 2 : 0;
    if (corner == 0 || beyond(q, 1, 1) < 0 || beyond(q, 2, 1) > 0) return 0;
    double low = 0, high = 1, at_low = beyond(q, corner, 0), at_high = beyond(q, corner, 1);
    for (int round = 0; round < 60 && at_high != at_low; ++round) {
        *when = fmin(fmax(high - at_high * (high - low) / (at_high - at_low), 0), 1);
        low = high;
        at_low = at_high;
        high = *when;
        at_high = beyond(q, corner, high);
        if (fabs(high - low) < 1e-15) break;
    }
    return corner;
}

/* Round a corner c at the time t a distance from it becomes one from the segment: L_t times the
 * change of |i - c| until then, and that of the area less d |k - j| afterwards. */
static bool weigh_round_corner(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row)
{
    paths q;
    double t = 0;
    for (int k = 0; k < 3; ++k) {
        q.at[k] = position_of(ends, row, k);
        q.w[k] = displacement_of(joint, ends, row->end[k]);
    }
    const int corner = corner_passed(&q, &t);
    if (corner == 0) return false;
    const double length = length_of(between(&q, 1, 2, 0)), later = 1 - t, middle = (1 + t) / 2;
    const fw_vec2 edge = between(&q, 1, 2, t);
    const fw_vec2 stretch = fw_vec2_scale(
        later * row->distance / length,
        gradient_of_length(edge, fw_vec2_scale(0.5, fw_vec2_add(edge, between(&q, 1, 2, 1)))));
    const fw_vec2 apart = between(&q, corner, 0, 0);
    const fw_vec2 away = fw_vec2_scale(
        t * length_of(edge) / length,
        gradient_of_length(apart,
                           fw_vec2_scale(0.5, fw_vec2_add(apart, between(&q, corner, 0, t)))));
    row->weight[0] = fw_vec2_scale(later / length, fw_vec2_turn(between(&q, 1, 2, middle)));
    row->weight[2] = fw_vec2_scale(later / length, fw_vec2_turn(between(&q, 0, 1, middle)));
    row->weight[1] = fw_vec2_scale(-1, fw_vec2_add(row->weight[0], row->weight[2]));
    row->weight[1] = fw_vec2_add(row->weight[1], stretch);
    row->weight[2] = fw_vec2_subtract(row->weight[2], stretch);
    row->weight[0] = fw_vec2_add(row->weight[0], away);
    row->weight[corner] = fw_vec2_subtract(row->weight[corner], away);
    row->bound = 0;
    return true;
}

/* Along i - j at the start: distances grow from there, whatever the ends do across it. (The middle
 * would leave another way out: i and j exchange their places. At a distance there is none.) */
static void weigh_point(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row)
{
    const fw_vec2 apart = fw_vec2_subtract(position_of(ends, row, 0), position_of(ends, row, 1));
    row->weight[0] = scaled_to(apart, length_of(apart));
    if (row->distance > 0)
        row->weight[0] =
            gradient_of_length(apart, fw_vec2_subtract(joint_middle_of(joint, ends, row, 0),
                                                       joint_middle_of(joint, ends, row, 1)));
    row->weight[1] = fw_vec2_scale(-1, row->weight[0]);
    row->bound = 0;
}

/* A plane or circle that an end carries weighs how the two move relative to each other. */
static void weigh_wall(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row)
{
    const fw_vec2 motion = row->borne ? displacement_of(joint, ends, row->end[1]) : row->motion;
    row->weight[0] = row->normal;
    if (row->kind == FW_JOINT_ROUND) {
        const fw_vec2 centre = fw_vec2_add(row->centre, fw_vec2_scale(0.5, motion));
        const fw_vec2 from = fw_vec2_subtract(joint_middle_of(joint, ends, row, 0), centre);
        const fw_vec2 outward = scaled_to(from, length_of(from));
        row->weight[0] = row->inside ? fw_vec2_scale(-1, outward) : outward;
    }
    if (row->borne) row->weight[1] = fw_vec2_scale(-1, row->weight[0]);
    row->bound = (row->borne ? 0 : fw_vec2_dot(row->weight[0], motion)) + row->behind;
}

/* Around the present displacements, lambda = |F| - slope (G w - G w_now): the force itself once
 * they stay. */
static void weigh_spring(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row, int n)
{
    const fw_vec2 relative = fw_vec2_subtract(displacement_of(joint, ends, row->end[0]),
                                              displacement_of(joint, ends, row->end[1]));
    double slope = 0;
    const fw_vec2 force = joint->springs->push(joint->springs->context, n, relative, &slope);
    const double size = length_of(force);
    row->weight[0] = scaled_to(force, size);
    row->weight[1] = fw_vec2_scale(-1, row->weight[0]);
    row->compliance = size > 0 ? 1 / slope : 0;
    row->bound = fw_vec2_dot(row->weight[0], relative) + row->compliance * size;
}

void joint_weigh(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row, int n)
{
    switch (row->kind) {
    case FW_JOINT_SEGMENT:
        if (!(row->distance > 0) || !weigh_round_corner(joint, ends, row))
            weigh_segment(joint, ends, row);
        return;
    case FW_JOINT_POINT:
        weigh_point(joint, ends, row);
        return;
    case FW_JOINT_SPRING:
        weigh_spring(joint, ends, row, n);
        return;
    case FW_JOINT_PLANE:
    case FW_JOINT_ROUND:
        weigh_wall(joint, ends, row);
        return;
    }
}

/* Adds what an end weighs; two of a row may be the same end. */
static void weigh_end(joint_line *line, int end, fw_vec2 c)
{
    for (int n = 0; n < line->count; ++n)
        if (line->end[n] == end) {
            line->c[n] = fw_vec2_add(line->c[n], c);
            return;
        }
    line->end[line->count] = end;
    line->c[line->count++] = c;
}

bool joint_make_line(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *row,
                     const fw_vec2 *weight, joint_line *line)
{
    double squared = 0;
    *line = (joint_line){0};
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_joint_end *end = &ends[row->end[k]];
        if (!joint_moves(end)) continue;
        const fw_vec2 c = joint_apply_transposed(joint_root_of(end->mobility), weight[k]);
        if (c.x != 0 || c.y != 0) weigh_end(line, joint->local[row->end[k]], c);
    }
    for (int n = 0; n < line->count; ++n) squared += fw_vec2_dot(line->c[n], line->c[n]);
    line->length = sqrt(squared);
    return squared > 0;
}
