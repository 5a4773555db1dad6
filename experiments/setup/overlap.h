/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlap.h - does a body that shares its solid with others start in a wall? */
#ifndef FW_OVERLAP_H
#define FW_OVERLAP_H

#include "experiments/setup/body_range.h"

/* The first particle of the body, numbered within it, that lies behind the wall at the start; -1:
 * none. *depth: by how much. Rounding of a place on the surface does not count. */
int fw_overlap_find_behind(const fw_scene *scene, const fw_body_range *range, int wall,
                           double *depth);

#endif
