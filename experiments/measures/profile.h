/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile.h - what particles do across the scene, bin by bin of one coordinate, averaged over the
 * samples of a phase (Popov & Filippov Eqs 24, 25 and Fig 6): movable particles; where there are
 * none, all other solids, which have no bonds that break and no order.
 *
 * Forces, order, density and velocities are sampled as the scenario says; bonds and motion are
 * followed on a grid in time of their own (bond_history.h), so that they do not depend on it.
 * Beside the bins there are two regions, contact and far, summed over their own particles and not
 * over whole bins. Everything is sums that grow from sample to sample; all of it is state. */
#ifndef FW_PROFILE_H
#define FW_PROFILE_H

#include "experiments/setup/experiment.h"

typedef enum fw_profile_column {
    FW_PROFILE_RETURN_FORCE, /* mean length of a particle's net return force */
    FW_PROFILE_BOND_FORCE,   /* mean length of the return force of a bond */
    FW_PROFILE_ORDER,        /* mean of |psi_n| */
    FW_PROFILE_DENSITY,      /* particles per area */
    FW_PROFILE_TEMPERATURE,  /* m <(v - mean of the bin)^2> / 2, of what no grip holds */
    FW_PROFILE_DRIFT,        /* root mean square over samples of the bin's mean velocity along it */
    FW_PROFILE_BOND_BREAKING,         /* bonds of a particle that break per time */
    FW_PROFILE_RELATIVE_DISPLACEMENT, /* mean square change of r_i - r_j over one lag, over bonds */
    FW_PROFILE_DIFFUSIVITY,           /* across the bins, from later lags */
    FW_PROFILE_COLUMNS
} fw_profile_column;

typedef struct fw_profile_column_row {
    const char *name, *unit, *meaning;
} fw_profile_column_row;
extern const fw_profile_column_row fw_profile_columns[FW_PROFILE_COLUMNS];

typedef struct fw_profile fw_profile;

/* As its scenario says. Bins cover the particles as they are now; later ones beyond them count in
 * no bin. FW_BAD_INPUT at its place in the scenario: no particle lies in the window, in the contact
 * or in the far region. */
fw_status fw_profile_create(fw_profile **profile, const fw_experiment *experiment, fw_error *error);
void fw_profile_destroy(fw_profile *profile);

/* To be called after each step, and at the start: takes a sample when one is due. */
void fw_profile_follow(fw_profile *profile, const fw_experiment *experiment, int64_t step);
void fw_profile_state(fw_profile *profile, fw_state_list *list);
/* After saved values were written back. FW_BAD_INPUT: they hold what no profile writes. */
fw_status fw_profile_restored(const fw_profile *profile, fw_error *error);

/* Mean length of the net return forces in the contact region, now; NaN if nothing is there. */
double fw_profile_contact_now(fw_profile *profile);

int fw_profile_bin_count(const fw_profile *profile);
/* Lower edge of a bin; bin_count gives the upper edge of the last one. */
double fw_profile_edge(const fw_profile *profile, int bin);
int64_t fw_profile_sample_count(const fw_profile *profile);

/* NaN where nothing was seen. The regions are bins of their own: */
enum { FW_PROFILE_CONTACT = -1, FW_PROFILE_FAR = -2 };
double fw_profile_value(const fw_profile *profile, int bin, fw_profile_column column);
/* The rate that a single broken bond would have been. */
double fw_profile_least_breaking(const fw_profile *profile, int bin);

#endif
