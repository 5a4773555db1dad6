/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_linear.h - a linear lattice as plain data. */
#ifndef FW_SCENARIO_LINEAR_H
#define FW_SCENARIO_LINEAR_H

#include <stdbool.h>

typedef struct fw_scenario_linear {
    double k1, k2, mass;
    bool compensated;
} fw_scenario_linear;

#endif
