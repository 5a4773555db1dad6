/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_outline.c - shapes of walls as outlines. Keeps no state. */
#include "experiments/pictures/wall_outline.h"

#include <math.h>

fw_outline fw_wall_outline(const fw_wall_def *def, fw_vec2 corners[FW_BOX_CORNERS])
{
    fw_outline outline = {.points = def->points,
                          .count = def->point_count,
                          .closed = true,
                          .forbidden =
                              def->side == FW_OUTSIDE ? FW_FORBIDDEN_INSIDE : FW_FORBIDDEN_OUTSIDE};
    switch (def->shape) {
    case FW_CHAIN: /* free to its left */
        outline.closed = def->closed;
        outline.forbidden = FW_FORBIDDEN_RIGHT;
        break;
    case FW_CIRCLE:
        outline.radius = def->radius;
        break;
    case FW_BOX: {
        const fw_vec2 a = def->points[0], b = def->points[1];
        const fw_vec2 low = {fmin(a.x, b.x), fmin(a.y, b.y)};
        const fw_vec2 high = {fmax(a.x, b.x), fmax(a.y, b.y)};
        corners[0] = low;
        corners[1] = (fw_vec2){high.x, low.y};
        corners[2] = high;
        corners[3] = (fw_vec2){low.x, high.y};
        outline.points = corners;
        outline.count = FW_BOX_CORNERS;
        break;
    }
    case FW_POLYGON:
        break;
    }
    return outline;
}
