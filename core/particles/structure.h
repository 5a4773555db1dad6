/* SPDX-License-Identifier: GPL-3.0-or-later */
/* structure.h - the structure factor of a set of points over a grid of wave vectors. */
#ifndef FW_STRUCTURE_H
#define FW_STRUCTURE_H

#include "core/status.h"

/* |sum e^{i q . r}|^2/N^2 of N >= 1 points (Popov & Filippov Eqs 19-21, with the e^{i q . r} that
 * Eq 19 lacks) on a square grid of q: values[b * points + a] belongs to
 * (first + a step, first + b step). 1 for a perfect crystal at a vector of its reciprocal lattice,
 * 1/N for a gas. Takes a time that grows as N points^2. FW_SYSTEM_FAILED without memory. */
fw_status fw_structure_map(const double *x, const double *y, int count, double first, double step,
                           int points, double *values, fw_error *error);

#endif
