/* SPDX-License-Identifier: GPL-3.0-or-later */
/* certificate.h - what a run kept to, as one line that can be quoted: the worst of penetration,
 * ledgers and friction in all frames and samples. Each number is also a quantity, certificate-NAME.
 */
#ifndef FW_CERTIFICATE_H
#define FW_CERTIFICATE_H

#include "core/array.h"
#include "experiments/results/playback.h"
#include "experiments/setup/experiment.h"

typedef enum fw_certificate_item {
    FW_CERTIFICATE_PENETRATION,
    FW_CERTIFICATE_ENERGY,
    FW_CERTIFICATE_MOMENTUM,
    FW_CERTIFICATE_OVERSTEP,
    FW_CERTIFICATE_CREEP,
    FW_CERTIFICATE_UNCONVERGED,
    FW_CERTIFICATE_UNRESOLVED,
    FW_CERTIFICATE_STEPS, /* in which bodies touched, of which `unconverged` is a part */
    FW_CERTIFICATE_ITEMS
} fw_certificate_item;

/* The worst so far; NaN of what does not apply: friction where nothing rubs, penetration where
 * there is nothing to enter. All of it is state. */
typedef struct fw_certificate {
    double worst[FW_CERTIFICATE_ITEMS];
    /* Of energy and momentum: the most that any ledger lacked, over the largest scale of the run:
     * at a start from nothing there is none yet but rounding. */
    double lacking[2], scale[2];
} fw_certificate;

typedef struct fw_certificate_row {
    const char *name, *unit, *meaning;
} fw_certificate_row;
extern const fw_certificate_row fw_certificate_rows[FW_CERTIFICATE_ITEMS];

/* Nothing was looked at yet. */
fw_certificate fw_certificate_begin(void);
/* Looks at the experiment as it is now, positions included. */
void fw_certificate_look(fw_certificate *certificate, const fw_experiment *experiment);
/* The worst of both. */
void fw_certificate_join(fw_certificate *certificate, const fw_certificate *other);
void fw_certificate_state(fw_certificate *certificate, fw_state_list *list);

/* Where a results file keeps an item, and which item that is; -1: none. */
fw_trajectory_array fw_certificate_array(fw_certificate_item item);
int fw_certificate_find(const char *array_name);
/* As a results file has it; NaN of what it does not have. */
fw_status fw_certificate_read(fw_certificate *certificate, fw_playback *playback, fw_error *error);

enum { FW_CERTIFICATE_SIZE = 512 };
/* "penetration 0, energy to 2e-14, ..."; "" where nothing is known. */
void fw_certificate_print(const fw_certificate *certificate, char line[FW_CERTIFICATE_SIZE]);

#endif
