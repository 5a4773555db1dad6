/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlap.h - do two bodies share a place, or is one in a wall? Bodies of different solids do not
 * detect each other, so their particles have to be compared. */
#ifndef FW_OVERLAP_H
#define FW_OVERLAP_H

#include "experiments/setup/body_range.h"

/* Finds particles of bodies a and b that are closer than half a spacing: *where is between them.
 * The time goes with n log n of the particles in both bodies' frames. FW_SYSTEM_FAILED without
 * memory. */
fw_status fw_overlap_find(const fw_scene *scene, const fw_body_range *a, const fw_body_range *b,
                          bool *found, fw_vec2 *where, fw_error *error);

/* The first particle of the body, numbered within it, that lies behind the wall at the start; -1:
 * none. *depth: by how much. Rounding of a place on the surface does not count. */
int fw_overlap_find_behind(const fw_scene *scene, const fw_body_range *range, int wall,
                           double *depth);

#endif
