/* SPDX-License-Identifier: GPL-3.0-or-later */
/* legend.h - what colours mean: rows above the panel, never on the data. */
#ifndef FW_LEGEND_H
#define FW_LEGEND_H

#include "experiments/drawing/canvas.h"

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
