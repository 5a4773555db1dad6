/* SPDX-License-Identifier: GPL-3.0-or-later */
/* stack.h - panels above one x axis: views, then charts (figure.h says what they show). One column
 * of a figure. */
#ifndef FW_STACK_H
#define FW_STACK_H

#include "colour_bar.h"
#include "experiments/drawing/figure.h"
#include "view_key.h"

/* Words above the panels: names of regions and marks. */
enum { FW_STACK_LABELS_MAX = 32 };
typedef struct fw_stack_label {
    const char *words;
    double at, left, right; /* on the paper */
    int row;
} fw_stack_label;

typedef struct fw_stack {
    const fw_figure_stack_plan *plan; /* observed */
    const fw_view_key *key;           /* observed */
    int panel_count;                  /* views first, then charts */
    fw_panel *panels;                 /* owned */
    double *legend_top;               /* [panel_count] owned */
    double label_place;               /* distance of the y labels from the boxes */
    int label_count, label_rows;
    fw_stack_label labels[FW_STACK_LABELS_MAX];
    double labels_top;
} fw_stack;

/* Axes described, nothing placed yet. A stack that is all zero may be released. */
fw_status fw_stack_create(fw_stack *stack, const fw_figure_stack_plan *plan, const fw_view_key *key,
                          fw_error *error);
void fw_stack_release(fw_stack *stack);

/* Boxes of this width, charts by the factor `shrink` lower than usual: their heights, ticks, and
 * room to the left. Returns the height of its views together. */
double fw_stack_size(fw_stack *stack, double width, double shrink);
/* Of all its charts, before anything makes them lower; > 0. */
double fw_stack_charts_height(const fw_stack *stack);
/* Room to the right that numbers take. */
double fw_stack_overhang(const fw_stack *stack);
/* Sets all boxes, the first with its legend below `top`; `head` mm are left above the first box,
 * and labels keep between the edges of the page. */
void fw_stack_place(fw_stack *stack, double left, double top, double head, double page_width);
/* Moves a panel and those below it down. */
void fw_stack_lower(fw_stack *stack, int panel, double by);
double fw_stack_bottom(const fw_stack *stack);

fw_status fw_stack_draw(const fw_stack *stack, fw_canvas *canvas, fw_error *error);

#endif
