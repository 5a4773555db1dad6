/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep_parts.h - what the pictures of a sweep share. */
#ifndef FW_PLOT_SWEEP_PARTS_H
#define FW_PLOT_SWEEP_PARTS_H

#include "experiments/drawing/page.h"
#include "experiments/pictures/plot.h"
#include "experiments/scenario/scenario.h"
#include "experiments/study/sweep.h"
#include "plot_label.h"

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
 * says more. Returns what of the quantity it is, "sheet, minimum", or "": `whole`, its component
 * and end are said as well, "centre of mass x, rate (length/time)", and where the table has it of
 * several bodies, of which. */
const char *fw_plot_sweep_label(const fw_sweep_column *column, const fw_sweep_table *table,
                                const fw_units *units, bool whole, char *text, size_t size,
                                fw_label *label);
/* Adds to a caption what the column's quantity means, where it says so by itself. */
void fw_plot_sweep_explain(const fw_sweep_column *column, char *caption, size_t size);

/* Adds to a caption over how many seeds the numbers are means, and what their bars are. */
void fw_plot_sweep_say_seeds(int64_t seeds, char *caption, size_t size);

/* What a picture is drawn along: one of the sweep's parameters, or one of its numbers. Negative:
 * that is not it. */
typedef struct fw_sweep_along {
    int axis, column;
} fw_sweep_along;
/* As wished for, else as the picture has it; both negative where neither says so. */
fw_status fw_plot_sweep_along(fw_sweep_along *along, const fw_plot_sweep *sweep,
                              const fw_plot_wish *wish, const fw_scenario_picture *own,
                              fw_error *error);

/* Where the number on a map has a level, in places of its cells. */
typedef struct fw_sweep_level {
    double level;
    int count;
    double *x, *y; /* pieces of a line, a NaN between each two */
    int mark_count;
    /* Where it passes from one case to the next, and the standard error along y or x; NaN: none. */
    double *mark_x, *mark_y, *mark_error, *mark_spread;
} fw_sweep_level;

/* Of values[rows][columns] with their standard errors, NaN where not known: straight lines between
 * neighbours. To be cleared also after a failure. */
fw_status fw_plot_sweep_level_of_grid(fw_sweep_level *line, double level, int columns, int rows,
                                      const double *values, const double *errors, fw_error *error);
/* As thresholds.csv has it: x counts the values of the other parameter, y is that of the bisected
 * one, its logarithm to base 10 where it is bisected so; NaN and no mark where it does not pass the
 * level. No points: it was not bisected for that level. */
fw_status fw_plot_sweep_level_of_bisection(fw_sweep_level *line, double level,
                                           const fw_plot_sweep *sweep,
                                           const fw_sweep_column *column, const double *others,
                                           int other_count, fw_error *error);
void fw_plot_sweep_level_clear(fw_sweep_level *line);

/* Panels above the axis of one parameter, a line for every value of the others. */
fw_status fw_plot_sweep_curves(const fw_plot_sweep *sweep, const fw_plot_wish *wish,
                               const fw_scenario_picture *own, fw_page *page, fw_error *error);
/* One quantity as colour over two parameters. */
fw_status fw_plot_sweep_map(const fw_plot_sweep *sweep, const fw_plot_wish *wish,
                            const fw_scenario_picture *own, fw_page *page, fw_error *error);

#endif
