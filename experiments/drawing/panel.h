/* SPDX-License-Identifier: GPL-3.0-or-later */
/* panel.h - a box with axes round it and data in it. Draw the grid, the data, the axes. */
#ifndef FW_PANEL_H
#define FW_PANEL_H

#include "experiments/drawing/axis.h"
#include "experiments/drawing/canvas.h"

typedef struct fw_panel {
    fw_canvas *canvas;
    fw_rect box;
    fw_axis x, y;
} fw_panel;

/* Where numbers lie on the canvas. */
double fw_panel_x(const fw_panel *panel, double x);
double fw_panel_y(const fw_panel *panel, double y);
fw_vec2 fw_panel_place(const fw_panel *panel, double x, double y);
/* mm per unit of x. */
double fw_panel_scale(const fw_panel *panel);

void fw_panel_draw_grid(const fw_panel *panel);
/* Frame, ticks, numbers and labels. `label_place`: distance in mm of the y label from the box, the
 * same for all panels of a column; 0: as close as it gets. */
void fw_panel_draw_axes(const fw_panel *panel, double label_place);
/* Grey words in the middle of an empty panel. */
void fw_panel_say(const fw_panel *panel, const char *words);

/* A line through the points; interrupted where one is not finite (or <= 0 on a logarithmic axis).
 * Where more points than the paper can show ascend in x, the least and greatest of each hair's
 * breadth stand for all. */
void fw_panel_line(const fw_panel *panel, const double *x, const double *y, int count,
                   fw_stroke stroke);
/* The area from y - error to y + error. */
void fw_panel_band(const fw_panel *panel, const double *x, const double *y, const double *error,
                   int count, fw_colour colour);
/* Error bars. Bars and markers are drawn for the points inside the box, unclipped: one that lies on
 * the frame stays whole. */
void fw_panel_bars(const fw_panel *panel, const double *x, const double *y, const double *error,
                   const double *open, int count, fw_colour colour);
/* The same along x. */
void fw_panel_bars_across(const fw_panel *panel, const double *x, const double *y,
                          const double *error, int count, fw_colour colour);
/* Small discs. */
void fw_panel_markers(const fw_panel *panel, const double *x, const double *y, int count,
                      double radius, fw_colour colour);

#endif
