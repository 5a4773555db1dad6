/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_outline.h - a wall as the outline that pictures draw. */
#ifndef FW_WALL_OUTLINE_H
#define FW_WALL_OUTLINE_H

#include "contact/geometry/wall.h"
#include "experiments/drawing/outline.h"

/* Observes the definition's points; those of a box are written to `corners` and observed there. */
fw_outline fw_wall_outline(const fw_wall_def *def, fw_vec2 corners[FW_WALL_CORNERS_MAX]);

#endif
