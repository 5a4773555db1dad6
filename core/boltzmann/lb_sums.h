/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_sums.h - energies, momentum and mass of an LB solid. For its own files only. */
#ifndef FW_LB_SUMS_H
#define FW_LB_SUMS_H

#include "core/solid.h"

/* Made once for the fields they belong to: several quantities ask for them in each step. */
typedef struct lb_sums {
    bool known; /* for the tick of that number */
    int64_t ticks;
    fw_energies energies;
    fw_vec2 momentum;
    bool mass_known; /* of a body that cannot break */
    fw_sym2 mass;
    bool sites_known;
    fw_vec2 lowest_site, highest_site;
} lb_sums;

fw_energies lb_energies(const fw_solid *solid);
fw_vec2 lb_momentum(const fw_solid *solid);
fw_sym2 lb_mass(const fw_solid *solid);

#endif
