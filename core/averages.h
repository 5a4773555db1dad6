/* SPDX-License-Identifier: GPL-3.0-or-later */
/* averages.h - means with standard errors that know about correlation in time, by blocking
 * (Flyvbjerg & Petersen, J. Chem. Phys. 91, 461 (1989)): neighbours in time are averaged in pairs
 * again and again, until blocks are long enough to be independent; the spread of the blocks is then
 * the error of the mean. The block length is chosen as the smallest B with
 * B^3 > 2 N (error_B/error_1)^4 (Lee et al., Phys. Rev. E 83, 066706 (2011)). */
#ifndef FW_AVERAGES_H
#define FW_AVERAGES_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct fw_average {
    double mean;
    double error;       /* standard error of the mean */
    double deviation;   /* standard deviation of the single values */
    double correlation; /* statistical inefficiency: so many values count as one, >= 1 if
                           independent */
    size_t count;
    bool
        converged; /* false: the series is too short for its correlation, the error a lower bound */
} fw_average;

/* Of values equally spaced in time; count >= 1. The error of a single value is infinite.
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_average_of_series(fw_average *average, const double *values, size_t count,
                               fw_error *error);

/* Of independent values (seeds, replicas). */
fw_average fw_average_of_replicas(const double *values, size_t count);
/* The same of those that are finite, which are moved to the front; `count` says how many they are.
 * The mean is NaN where there is none, the error where there are fewer than two. */
fw_average fw_average_of_known(double *values, size_t count);

/* How many standard errors the means of the first and the second half of a series are apart: a
 * steady state stays below 3. */
fw_status fw_average_drift(double *drift, const double *values, size_t count, fw_error *error);

#endif
