/* SPDX-License-Identifier: GPL-3.0-or-later */
/* view_key.h - what the colours of particles mean in one view, or in several at a common scale. */
#ifndef FW_VIEW_KEY_H
#define FW_VIEW_KEY_H

#include "colour_bar.h"
#include "experiments/drawing/legend.h"
#include "experiments/drawing/view.h"

typedef struct fw_view_key {
    bool by_field; /* else by species */
    fw_colour_scale scale;
    bool named[FW_PALETTE_KINDS];
    int entry_count; /* of the legend of species; 0 where all are of one kind */
    fw_legend_entry entries[FW_PALETTE_KINDS];
    char labels[FW_PALETTE_KINDS][32];
} fw_view_key;

/* By field where any body has one. The key must stay where it is: its entries point into it.
 * FW_SYSTEM_FAILED without memory. */
fw_status fw_view_key_for(fw_view_key *key, const fw_view *views, int view_count, fw_colouring wish,
                          fw_error *error);

/* The scale to draw with: NULL for species. */
const fw_colour_scale *fw_view_key_scale(const fw_view_key *key);

#endif
