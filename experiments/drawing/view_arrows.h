/* SPDX-License-Identifier: GPL-3.0-or-later */
/* view_arrows.h - forces on the particles of views as arrows, all at one scale. */
#ifndef FW_VIEW_ARROWS_H
#define FW_VIEW_ARROWS_H

#include "experiments/drawing/legend.h"
#include "experiments/drawing/view.h"

typedef struct fw_view_arrows {
    double largest; /* force; 0: there is none */
    double scale;   /* mm per force */
    char label[48];
    fw_legend_entry entry; /* how long an arrow is; label NULL: there is none */
} fw_view_arrows;

/* "force of 2 nN": what is shown of the force of 1, 2, 5 times a power of ten that is not above the
 * value, which is > 0. Returns that force. */
double fw_view_arrows_print(char *text, size_t size, double value, fw_label unit);

/* Of all views; the largest force has `length` mm. It must stay where it is: its entry points into
 * it. */
void fw_view_arrows_for(fw_view_arrows *arrows, const fw_view *views, int view_count, double length,
                        fw_label unit);
/* Each begins at its particle. */
void fw_view_arrows_draw(const fw_view_arrows *arrows, const fw_view *view, const fw_panel *panel);

#endif
