/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure.h - the figures that Fretwork draws, from plain arrays: a running scene and a results file
 * can feed them alike. Each makes one file and fails with a sentence:
 * FW_BAD_INPUT (name or size of the picture), FW_SYSTEM_FAILED (memory, disk).
 *
 * All pointers are observed and nothing is owned. Values that are not finite are passed over. In
 * all texts "^{...}" is raised and "_{...}" lowered. */
#ifndef FW_FIGURE_H
#define FW_FIGURE_H

#include "experiments/drawing/chart.h"
#include "experiments/drawing/page.h"
#include "experiments/drawing/view.h"

/* --- bodies --- */

/* The path of a centre of mass. */
typedef struct fw_figure_path {
    const double *x, *y;
    int count;
} fw_figure_path;

/* Bodies at several instants in their walls, graded in colour by time, with the paths of their
 * centres of mass (Chopard & Marconi Fig 1). Walls are those of the last view. */
typedef struct fw_figure_motion_plan {
    const fw_view *views; /* in the order of time */
    int view_count;
    const fw_figure_path *paths;
    int path_count;
    fw_view_bounds bounds; /* of all frames, with walls; all zero: of the views and paths */
} fw_figure_motion_plan;
fw_status fw_figure_motion(const fw_page *page, const fw_figure_motion_plan *plan, fw_error *error);

/* A force that is drawn as an arrow beginning at a particle. */
typedef struct fw_figure_force {
    int particle;
    fw_vec2 force;
    bool external; /* drawn fat */
} fw_figure_force;

/* One deformed body: where its particles were and where they are. */
typedef struct fw_figure_forces_panel {
    const char *name; /* above the panel, with the values it shows; may be NULL */
    int count;
    const double *original_x, *original_y, *x, *y; /* [count] */
    const int *links;                              /* [2 link_count] pairs of particles */
    int link_count;
    const fw_figure_force *forces;
    int force_count;
} fw_figure_forces_panel;

/* Original and present places, internal forces as thin and external ones as fat arrows, all panels
 * at the same scale of forces (Chopard & Marconi Figs 4 and 5). The panel of a straight horizontal
 * chain shows the original above the present places. */
typedef struct fw_figure_forces_plan {
    const fw_figure_forces_panel *panels;
    int panel_count;
} fw_figure_forces_plan;
fw_status fw_figure_forces(const fw_page *page, const fw_figure_forces_plan *plan, fw_error *error);

/* A field as colour on the particles; without a field in any body: by species. */
typedef struct fw_figure_field_plan {
    const fw_view *view;
    fw_view_look look;
    fw_colouring colouring;
    fw_view_bounds bounds; /* of all frames, with walls; all zero: of the view */
} fw_figure_field_plan;
fw_status fw_figure_field(const fw_page *page, const fw_figure_field_plan *plan, fw_error *error);

/* The same bodies at several instants side by side, all at one scale of colours. */
typedef struct fw_figure_strip_plan {
    const fw_view *views;
    int view_count;
    int columns; /* 0: chosen */
    fw_view_look look;
    fw_colouring colouring;
} fw_figure_strip_plan;
fw_status fw_figure_strip(const fw_page *page, const fw_figure_strip_plan *plan, fw_error *error);

/* --- curves --- */

/* A vertical line, such as the beginning of a phase. */
typedef struct fw_figure_mark {
    double at;
    const char *label; /* above the panels; may be NULL */
} fw_figure_mark;

/* A shaded part of the x axis. */
typedef struct fw_figure_region {
    double from, until;
    const char *label;
    double strength; /* of the shade: 0 none (its borders are drawn always), 1 full */
} fw_figure_region;

/* Everything that stands above one x axis: views (equal aspect, coloured by field or species), then
 * charts. */
typedef struct fw_figure_stack_plan {
    const fw_view *views;
    int view_count;
    fw_view_look look;
    fw_colouring colouring;
    fw_label y_label; /* of the views; none: "y" */
    fw_range y_range; /* of the views; where high <= low it comes from their bodies */
    const fw_chart *charts;
    int chart_count;
    fw_label label; /* what x is */
    bool logarithmic;
    fw_range range;            /* of x; where high <= low it comes from the data */
    const fw_axis_name *names; /* ticks with names in place of numbers, each with a line */
    int name_count;
    const fw_figure_mark *marks;
    int mark_count;
    const fw_figure_region *regions;
    int region_count;
} fw_figure_stack_plan;
fw_status fw_figure_stack(const fw_page *page, const fw_figure_stack_plan *plan, fw_error *error);

/* Several such columns side by side, as an experiment and its control: rows of panels at one scale,
 * one scale of colours (that of the first plan). */
fw_status fw_figure_columns(const fw_page *page, const fw_figure_stack_plan *plans, int count,
                            fw_error *error);

/* Observables over time. */
fw_status fw_figure_series(const fw_page *page, const fw_chart *charts, int chart_count,
                           fw_label time, const fw_figure_mark *marks, int mark_count,
                           fw_error *error);

/* One panel of curves and markers over any x, such as a dispersion along a path with named ticks.
 */
fw_status fw_figure_curves(const fw_page *page, const fw_chart *chart, fw_label x,
                           const fw_axis_name *names, int name_count, fw_error *error);

/* A number at every place of a rectangular grid: value[row * columns + column] at
 * p = p_first + column p_step, q = q_first + row q_step, each filling the cell round its place. */
typedef struct fw_figure_map_plan {
    int columns, rows;
    const double *values;
    double p_first, p_step, q_first, q_step; /* steps > 0 */
    fw_label p_label, q_label;
    const fw_axis_name *p_names, *q_names; /* ticks with names in place of numbers */
    int p_name_count, q_name_count;
    bool equal_aspect; /* p and q are of one kind */
    fw_colouring colouring;
    const char *const *texts; /* [rows * columns] in the cells, where all fit; NULL: none */
    const fw_curve *curves;   /* drawn over the map; a NaN ends a piece of a line */
    int curve_count;
} fw_figure_map_plan;
fw_status fw_figure_map(const fw_page *page, const fw_figure_map_plan *plan, fw_error *error);

/* --- bodies and what follows from them --- */

/* Bodies at one instant, and a map (both of its axes of one kind) or else a chart of them. */
typedef struct fw_figure_pair {
    const fw_view *view;
    const fw_figure_map_plan *map; /* NULL: the chart */
    const fw_chart *chart;
} fw_figure_pair;

/* One pair beside each other, or several: the views in a row at one scale, what follows from them
 * below. Either all have maps, at the scale of colours of the first, or all have charts, at one
 * scale. */
enum { FW_FIGURE_PAIRS_MAX = 6 }; /* that a page is wide enough for */
typedef struct fw_figure_pairs_plan {
    const fw_figure_pair *pairs;
    int pair_count;
    fw_view_look look;
    fw_colouring colouring; /* of the views */
    bool spots;             /* the particles are seen as white spots */
    fw_label x_label;       /* of the charts */
} fw_figure_pairs_plan;
/* FW_BAD_INPUT for no pair or more than that. */
fw_status fw_figure_pairs(const fw_page *page, const fw_figure_pairs_plan *plan, fw_error *error);

#endif
