/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint_driven.c - friction of rows along which nothing gives way, as of a grip that is carried
 * along a wall: the slip is prescribed, and so the traction is that of sliding, which moves nothing
 * but takes its work. Where there is no slip the traction is not determined, and taken for 0.
 * State: none. */
#include "joint_parts.h"

#include <math.h>

/* Slip below this part of how far ends and wall go is rounding. */
#define SLIPS 1e-12

static double size_of(const fw_joint_end *ends, const fw_joint_row *row)
{
    double size = fabs(row->rub.drift);
    for (int k = 0; k < fw_joint_end_count(row); ++k) {
        const fw_vec2 w = ends[row->end[k]].displacement;
        size += fabs(w.x) + fabs(w.y);
    }
    return size;
}

void joint_rub_driven(const fw_joint *joint, const fw_joint_end *ends, fw_joint_row *rows,
                      const int *list, int count)
{
    for (int n = 0; n < count; ++n) {
        fw_joint_row *row = &rows[list[n]];
        fw_joint_rub *rub = &row->rub;
        joint_line line;
        if (!(rub->coefficient > 0) || rub->barred ||
            joint_make_line(joint, ends, row, rub->weight, &line))
            continue;
        joint_find_slips(ends, rows, &list[n], 1);
        rub->slides = fabs(rub->slip) > SLIPS * size_of(ends, row);
        rub->stuck = !rub->slides;
        rub->limit = fw_joint_cone(row);
        rub->traction = rub->slides ? -copysign(rub->limit, rub->slip) : 0;
    }
}
