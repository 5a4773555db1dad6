/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surroundings.h - what lies around each point of a set at one instant: the order of its bonds of
 * any symmetry, the smoothed density, the largest cluster. Plain arrays of points, of whatever
 * solid; they are only read. All fail with FW_SYSTEM_FAILED without memory. */
#ifndef FW_SURROUNDINGS_H
#define FW_SURROUNDINGS_H

#include "core/status.h"

#include <stdint.h>

/* |psi_n| = |mean of e^{i n phi}| over the bonds of each point, all pairs closer than `radius`: 1
 * where they lie on n axes, whatever the angle of these. NaN for a point without bonds.
 * values[f * count + i] is that of point i for n = folds[f] >= 1. */
fw_status fw_surroundings_order(const double *x, const double *y, int count, double radius,
                                const int *folds, int fold_count, double *values, fw_error *error);

/* rho(r_i) = sum over all k, i among them, of exp(-(r_i - r_k)^2/lambda) at each point (Popov &
 * Filippov Eq 22), lambda > 0 an area. Terms below e^{-36} are left out. Deep in a crystal with the
 * area a per particle it is pi lambda/a, but for a ripple: with lambda the spacing's square, 1e-5
 * of it on the particles of a hexagonal crystal, and 2e-4 on those of a square one. */
fw_status fw_surroundings_density(const double *x, const double *y, int count, double lambda,
                                  double *values, fw_error *error);

/* Points linked by less than `link`, directly or through others: members[i] is 1 for those of the
 * largest cluster (of the one with the lowest point, if two are equal) and 0 for others; *found:
 * how many they are. */
fw_status fw_surroundings_cluster(const double *x, const double *y, int count, double link,
                                  uint8_t *members, int *found, fw_error *error);

#endif
