/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_langevin.h - what the builders of point masses share: how the bodies of a scenario move. */
#ifndef FW_BUILD_LANGEVIN_H
#define FW_BUILD_LANGEVIN_H

#include "core/particles/langevin.h"
#include "experiments/setup/solids.h"

/* For random places and velocities of a body: far from every seed that anybody gives. */
uint64_t fw_build_seed(const fw_scenario *scenario, int body);
fw_langevin_controls fw_build_controls(const fw_scenario *scenario);
/* As fw_build_fail, but a time step beyond the limit is at fault itself, where it was written. */
fw_status fw_build_fail_step(const fw_scenario *scenario, int body, double limit, fw_status status,
                             fw_error *error);
/* Gives the particles of the solid from `first` on the body's thermal velocities, and adds its
 * velocity, spin and patterns. `room` holds two vectors per site. */
fw_status fw_build_motion(const fw_scenario *scenario, int body, const fw_sites *sites,
                          fw_solid *solid, int first, fw_vec2 *room, fw_error *error);
/* The line of `check` about the time step, which must stay below the limit. */
void fw_build_print_time_step(FILE *out, const fw_start *start, double limit);

#endif
