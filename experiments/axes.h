/* SPDX-License-Identifier: GPL-3.0-or-later */
/* axes.h - a panel of a figure: axes round a box, and data in it.
 *
 * Order of use: describe the axes, ask for the room they need (fw_axis_prepare, fw_axis_depth),
 * place the box, draw the grid, the data, and last the axes. */
#ifndef FW_AXES_H
#define FW_AXES_H

#include "experiments/canvas.h"

typedef struct fw_axis_name {
    double at;
    const char *name;
} fw_axis_name;

typedef struct fw_axis {
    fw_range range; /* low < high; logarithmic: low > 0 */
    bool logarithmic;
    const char *label;         /* with unit, "time / steps"; NULL: none */
    const fw_axis_name *names; /* ticks with names in place of numbers */
    int name_count;
    bool bare;      /* ticks only: the panel below carries numbers and label */
    bool hidden;    /* not even ticks */
    fw_ticks ticks; /* from fw_axis_prepare */
} fw_axis;

typedef struct fw_panel {
    fw_canvas *canvas;
    fw_rect box;
    fw_axis x, y;
} fw_panel;

/* All text of figures, in points. */
#define FW_TEXT_SIZE  8.5
#define FW_SMALL_SIZE 7.5
#define FW_TITLE_SIZE 10.5

/* Chooses the ticks for an axis of this length in mm; `across`: the x axis. */
void fw_axis_prepare(fw_axis *axis, double length, bool across);
/* Room in mm that numbers and label take: below the box (across) or to its left. */
double fw_axis_depth(const fw_axis *axis, bool across);
/* Room in mm above the box that a note to the y axis (powers of ten, offset) takes. */
double fw_axis_note_height(const fw_axis *axis);
/* How far the last number of an x axis of this length sticks out to the right of the box. */
double fw_axis_overhang(const fw_axis *axis, double length);

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
                   int count, fw_colour colour);
/* Small discs. */
void fw_panel_markers(const fw_panel *panel, const double *x, const double *y, int count,
                      double radius, fw_colour colour);

#endif
