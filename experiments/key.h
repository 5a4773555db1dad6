/* SPDX-License-Identifier: GPL-3.0-or-later */
/* key.h - what the colours of a figure mean: colour bars beside it, legends above it. */
#ifndef FW_KEY_H
#define FW_KEY_H

#include "experiments/axes.h"

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
/* `left`: right edge of the panels. */
void fw_colour_bar_draw(const fw_colour_bar *bar, fw_canvas *canvas, double left, double top,
                        double height);

/* Legends stand in rows above the panel, never on the data. */
typedef enum fw_legend_look {
    FW_LEGEND_LINE,
    FW_LEGEND_DASHES,
    FW_LEGEND_DISC,
    FW_LEGEND_LINE_AND_DISC,
    FW_LEGEND_RING,
    FW_LEGEND_ARROW,
    FW_LEGEND_FAT_ARROW
} fw_legend_look;

typedef struct fw_legend_entry {
    const char *label; /* NULL: not shown */
    fw_colour colour;
    fw_legend_look look;
    double length; /* of the sample in mm; 0: the usual one */
} fw_legend_entry;

double fw_legend_height(const fw_legend_entry *entries, int count, double width);
void fw_legend_draw(const fw_legend_entry *entries, int count, fw_canvas *canvas, fw_vec2 corner,
                    double width);

#endif
