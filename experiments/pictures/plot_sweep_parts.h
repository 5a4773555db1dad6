/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep_parts.h - what the pictures of a sweep share. */
#ifndef FW_PLOT_SWEEP_PARTS_H
#define FW_PLOT_SWEEP_PARTS_H

#include "experiments/drawing/page.h"
#include "experiments/pictures/plot.h"
#include "experiments/scenario/scenario.h"
#include "experiments/study/sweep.h"

/* A sweep that is drawn. */
typedef struct fw_plot_sweep {
    const char *directory;
    fw_scenario *scenario;
    fw_sweep_table table;
} fw_plot_sweep;

enum { FW_SWEEP_PANELS_MAX = 32 };

/* Numbers of columns of the table. */
typedef struct fw_sweep_choice {
    int count;
    int columns[FW_SWEEP_PANELS_MAX];
} fw_sweep_choice;

/* Columns of the quantities that are wished for, else of the picture, else of what is expected,
 * else all; own: NULL: no picture of the scenario. */
fw_status fw_plot_sweep_choose(fw_sweep_choice *choice, const fw_plot_sweep *sweep,
                               const fw_plot_wish *wish, const fw_scenario_picture *own,
                               fw_error *error);
/* "kinetic fraction", "layer contact (force)": words in place of the name, and the unit where that
 * says more. Returns what of the quantity it is, "sheet, minimum", or "": `whole`, its end is said
 * as well, "wave front, rate (length/time)". */
const char *fw_plot_sweep_label(const fw_sweep_column *column, bool whole, char *label,
                                size_t size);
/* Adds to a caption what the column's quantity means, where it says so by itself. */
void fw_plot_sweep_explain(const fw_sweep_column *column, char *caption, size_t size);

/* Panels above the axis of one parameter, a line for every value of the others. */
fw_status fw_plot_sweep_curves(const fw_plot_sweep *sweep, const fw_plot_wish *wish,
                               const fw_scenario_picture *own, fw_page *page, fw_error *error);
/* One quantity as colour over two parameters. */
fw_status fw_plot_sweep_map(const fw_plot_sweep *sweep, const fw_plot_wish *wish,
                            const fw_scenario_picture *own, fw_page *page, fw_error *error);

#endif
