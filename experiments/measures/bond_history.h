/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bond_history.h - what becomes of the bonds of movable particles: how many break, and how far
 * bonded particles move away from each other.
 *
 * It looks at its own instants, whatever else is sampled, so that a rate is one. A bond begins when
 * two particles are closer than the bond radius and is broken when they are FW_BOND_BROKEN times
 * further apart: between both it stays what it was. The trajectory is smooth, so the count hardly
 * depends on how often one looks, as long as it is often. Motion is followed from snapshots one lag
 * apart, of which the last FW_HISTORY_LAGS are kept. */
#ifndef FW_BOND_HISTORY_H
#define FW_BOND_HISTORY_H

#include "core/array.h"
#include "core/solid.h"
#include "core/status.h"

#define FW_BOND_BROKEN 1.2

enum { FW_HISTORY_BONDS = 16, FW_HISTORY_LAGS = 4, FW_HISTORY_LOOKS = 20 };

typedef struct fw_bond_history {
    int64_t from, until;                /* steps */
    int64_t look, lag;                  /* steps between two looks, and between two snapshots */
    int count;                          /* particles */
    int32_t (*bonds)[FW_HISTORY_BONDS]; /* of the last look, ended by -1 */
    double *broken;                     /* bonds that each particle lost since the look before */
    /* Snapshot n lies at [n * count]. */
    double *past_x, *past_y;
    int32_t (*past_bonds)[FW_HISTORY_BONDS];
} fw_bond_history;

/* The squares of what the bonds of one particle changed by since a snapshot. */
typedef struct fw_bond_change {
    double bonds;    /* how many they are */
    double square;   /* sum of |change|^2 */
    double along[2]; /* the same of its x and y alone */
} fw_bond_change;

/* Follows the steps from .. until. A lag is that many time units: it looks FW_HISTORY_LOOKS times
 * in one, or in every step. FW_SYSTEM_FAILED without memory. */
fw_status fw_bond_history_create(fw_bond_history **history, const fw_solid *solid, int64_t from,
                                 int64_t until, double time_unit, fw_error *error);
void fw_bond_history_destroy(fw_bond_history *history);
void fw_bond_history_state(fw_bond_history *history, fw_state_list *list);
/* Do its bonds, as they were read from a checkpoint, name particles that exist? */
bool fw_bond_history_is_sound(const fw_bond_history *history);

/* Looks, where a look is due, and fills `broken`; false: none is due, or it is the first. */
bool fw_bond_history_look(fw_bond_history *history, const fw_solid *solid, int64_t step);
/* The snapshot that is so many lags old at this step, or -1. */
int fw_bond_history_snapshot(const fw_bond_history *history, int64_t step, int lags);
fw_bond_change fw_bond_history_change(const fw_bond_history *history, const fw_solid *solid,
                                      int snapshot, int particle);
/* Takes a snapshot where one is due, in place of the oldest. */
void fw_bond_history_remember(fw_bond_history *history, const fw_solid *solid, int64_t step);

#endif
