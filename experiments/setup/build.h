/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build.h - from the bodies of a scenario to solids, one file per model: build_NAME.c. Shared by
 * those and experiment.c. */
#ifndef FW_BUILD_H
#define FW_BUILD_H

#include "experiments/scenario/scenario.h"

/* Adds all patterns of a list to `values`, one per site of that lattice. Each pattern draws its
 * random numbers from a stream of its own, from `first_stream` on. */
fw_status fw_build_patterns(const fw_patterns *patterns, const fw_sites *sites,
                            const fw_lattice *lattice, uint64_t seed, uint32_t first_stream,
                            fw_vec2 *values, fw_error *error);
/* Streams of random starts: body by body, displacements before velocities. */
uint32_t fw_build_displacement_stream(int body);
uint32_t fw_build_velocity_stream(int body);

/* The sentence of a failed solid after the place of its body; other failures are handed on. */
fw_status fw_build_fail(const fw_scenario *scenario, int body, fw_status status, fw_error *error);

#endif
