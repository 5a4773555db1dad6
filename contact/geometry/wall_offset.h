/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_offset.h - a wall that keeps particles at a distance: the same shape, further out. */
#ifndef FW_WALL_OFFSET_H
#define FW_WALL_OFFSET_H

#include "contact/geometry/wall.h"

/* The definition with its surface moved by `distance` >= 0 to the side where particles are free.
 * Corners stay corners: there the distance is larger. Its points are written into `points`, room
 * for those of the wall. FW_BAD_INPUT: nothing is left of a shape that is free inside, or of a
 * piece of a chain. */
fw_status fw_wall_offset(const fw_wall_def *def, double distance, fw_vec2 *points,
                         fw_wall_def *moved, fw_error *error);

#endif
