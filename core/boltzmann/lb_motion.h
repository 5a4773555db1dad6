/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_motion.h - where the particles of an LB solid are, and how they move. For its own files only;
 * what they mean stands at the operations of those names (solid.h). */
#ifndef FW_LB_MOTION_H
#define FW_LB_MOTION_H

#include "core/solid.h"

void lb_velocities(const fw_solid *solid, double *x, double *y);
void lb_motions(const fw_solid *solid, int first, int count, const fw_motions *out);
fw_vec2 lb_centre_of_mass(const fw_solid *solid);
bool lb_stays_within(const fw_solid *solid, fw_vec2 centre, double limit);

#endif
