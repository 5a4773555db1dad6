/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_leads.c - ends of solids whose colours move in turn. A step is solved as a whole: with d
 * the displacements of the colour that moves first, those of the other one are w = w_p + K (d -
 * d_p) + A F. Forces do the work F.d + F.w, so that complementarity with the displacement keeps
 * energy, and weights that add up to zero keep momentum, as where all particles move at once. K is
 * taken at the last iterate, together with the normals. State: none. Start reading at
 * joint_led_by(). */
#include "joint_parts.h"

bool joint_follows(const fw_joint *joint, const fw_joint_end *ends, int moving)
{
    for (int e = 0; e < moving; ++e)
        if (ends[joint->global[e]].lead_count > 0) return true;
    return false;
}

fw_vec2 joint_led_by(const fw_joint *joint, const fw_joint_end *ends, const fw_joint_end *end)
{
    fw_vec2 sum = {0, 0};
    for (int k = 0; k < end->lead_count; ++k) {
        const fw_joint_lead *lead = &end->lead[k];
        const int local = joint->local[lead->end];
        const fw_vec2 w = local >= 0 ? joint->w[local] : ends[lead->end].displacement;
        const fw_vec2 more = fw_vec2_subtract(w, lead->expected);
        sum = fw_vec2_add(sum, (fw_vec2){fw_vec2_dot(lead->x, more), fw_vec2_dot(lead->y, more)});
    }
    return sum;
}

void joint_move_followers(fw_joint *joint, fw_joint_end *ends, int end_count,
                          const fw_joint_row *rows, int row_count)
{
    const fw_joint_springs *springs = joint->springs;
    for (int e = 0; e < end_count; ++e) joint->first[e] = 0;
    for (int n = 0; n < row_count; ++n)
        for (int k = 0; k < fw_joint_end_count(&rows[n]); ++k) joint->first[rows[n].end[k]] = -1;
    for (int e = 0; e < end_count; ++e) {
        fw_joint_end *end = &ends[e];
        if (end->lead_count == 0 || joint->first[e] < 0) continue;
        end->free = springs ? springs->free(springs->context, e, end->displacement) : end->unled;
        end->free = fw_vec2_add(end->free, joint_led_by(joint, ends, end));
        end->displacement = end->free;
    }
}
