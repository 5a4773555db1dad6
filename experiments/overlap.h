/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlap.h - do two bodies share a place? Bodies of different solids do not see each other, so
 * nothing but a look at their particles tells. */
#ifndef FW_OVERLAP_H
#define FW_OVERLAP_H

#include "experiments/experiment.h"

/* Finds particles of bodies a and b that are closer than half a spacing: *where is between them.
 * The time goes with n log n of the particles in both bodies' frames. FW_SYSTEM_FAILED without
 * memory. */
fw_status fw_overlap_find(const fw_experiment *experiment, int a, int b, bool *found,
                          fw_vec2 *where, fw_error *error);

#endif
