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

fw_vec2 joint_middle_of(const fw_joint *joint, const fw_joint_end *ends, int end)
{
    return fw_vec2_add(ends[end].position, fw_vec2_scale(0.5, displacement_of(joint, ends, end)));
}

static fw_vec2 scaled_to(fw_vec2 v, double length)
{
    return length > 0 ? fw_vec2_scale(1 / length, v) : v;
}

static double length_of(fw_vec2 v)
{
    return sqrt(fw_vec2_dot(v, v));
}

/* Area (k - j) x (i - j), whose gradient at the middle gives its change over the step exactly;
 * divided by the length at the start. */
static void weigh_segment(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *row)
{
    const fw_vec2 i = joint_middle_of(joint, ends, row->end[0]),
                  j = joint_middle_of(joint, ends, row->end[1]),
                  k = joint_middle_of(joint, ends, row->end[2]);
    const double length =
        length_of(fw_vec2_subtract(ends[row->end[2]].position, ends[row->end[1]].position));
    row->weight[0] = scaled_to(fw_vec2_turn(fw_vec2_subtract(k, j)), length);
    row->weight[2] = scaled_to(fw_vec2_turn(fw_vec2_subtract(j, i)), length);
    row->weight[1] = fw_vec2_scale(-1, fw_vec2_add(row->weight[0], row->weight[2]));
    row->bound = 0;
}

/* Along i - j at the start: distances grow from there, whatever the ends do across it. (The middle
 * would leave another way out: i and j exchange their places.) */
static void weigh_point(const fw_joint_end *ends, fw_joint_row *row)
{
    const fw_vec2 apart = fw_vec2_subtract(ends[row->end[0]].position, ends[row->end[1]].position);
    row->weight[0] = scaled_to(apart, length_of(apart));
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
        const fw_vec2 from = fw_vec2_subtract(joint_middle_of(joint, ends, row->end[0]), centre);
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
        weigh_segment(joint, ends, row);
        return;
    case FW_JOINT_POINT:
        weigh_point(ends, row);
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

bool joint_make_line(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_row *row,
                     const fw_vec2 *weight, joint_line *line)
{
    double squared = 0;
    *line = (joint_line){0};
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_joint_end *end = &ends[row->end[k]];
        if (!joint_moves(end)) continue;
        const fw_vec2 c = joint_apply_transposed(joint_root_of(end->mobility), weight[k]);
        if (c.x == 0 && c.y == 0) continue;
        line->end[line->count] = joint->local[row->end[k]];
        line->c[line->count++] = c;
        squared += fw_vec2_dot(c, c);
    }
    line->length = sqrt(squared);
    return squared > 0;
}
