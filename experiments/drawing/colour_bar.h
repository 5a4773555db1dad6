/* SPDX-License-Identifier: GPL-3.0-or-later */
/* colour_bar.h - what the colours of numbers mean: a bar to the right of the panels. */
#ifndef FW_COLOUR_BAR_H
#define FW_COLOUR_BAR_H

#include "experiments/drawing/colour_scale.h"
#include "experiments/drawing/panel.h"

/* A colour bar: box of the colours; ticks, numbers and label to its right. */
typedef struct fw_colour_bar {
    fw_colour_scale scale;
    fw_axis axis;
} fw_colour_bar;

fw_colour_bar fw_colour_bar_for(fw_colour_scale scale, double height);
/* Room to the right of the panels, gap included. */
double fw_colour_bar_width(const fw_colour_bar *bar);
/* Room that its note and the sign for values beyond the end take above it. */
double fw_colour_bar_head(const fw_colour_bar *bar);
/* Room below it that the sign for values beyond the low end takes. */
double fw_colour_bar_foot(const fw_colour_bar *bar);
/* `left`: right edge of the panels. */
void fw_colour_bar_draw(const fw_colour_bar *bar, fw_canvas *canvas, double left, double top,
                        double height);

#endif
