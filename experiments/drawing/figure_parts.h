/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_parts.h - what several figures draw into a panel; for the files figure*.c alone. */
#ifndef FW_FIGURE_PARTS_H
#define FW_FIGURE_PARTS_H

#include "experiments/drawing/figure.h"

/* Room above a view for its name, in mm. */
#define FW_FIGURE_NAME 4.2

/* Walls and particles, clipped to the box. */
fw_status fw_figure_draw_view(const fw_view *view, const fw_panel *panel, fw_view_look look,
                              const fw_colour_scale *scale, fw_error *error);
/* The size of letters, in points, at which each view's name has room (mm). */
double fw_figure_name_size(const fw_view *views, int count, double room);
/* Its name, or else its step, `above` mm over the box. */
void fw_figure_name_view(const fw_view *view, const fw_panel *panel, double above, double size);
/* The cells of a map. */
void fw_figure_draw_cells(const fw_figure_map_plan *plan, const fw_panel *panel,
                          const fw_colour_scale *scale);

#endif
