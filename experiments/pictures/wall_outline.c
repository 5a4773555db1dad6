/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_outline.c - shapes of walls as outlines. Keeps no state. */
#include "experiments/pictures/wall_outline.h"

fw_outline fw_wall_outline(const fw_wall_def *def, fw_vec2 corners[FW_WALL_CORNERS_MAX])
{
    const fw_wall_shape *shape = fw_wall_shape_of(def);
    const fw_wall_line line = shape->outline(def, corners);
    const fw_forbidden sided = def->side == FW_OUTSIDE ? FW_FORBIDDEN_INSIDE : FW_FORBIDDEN_OUTSIDE;
    return (fw_outline){.points = line.points,
                        .count = line.count,
                        .radius = line.radius,
                        .closed = line.closed,
                        .forbidden = shape->sided ? sided : FW_FORBIDDEN_RIGHT};
}
