/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_stack.c - columns of views and charts: time series, profiles under a configuration with
 * the control beside it, single charts.
 * Keeps no state. Invariant: what stands in one row has the same scale. Start reading at
 * fw_figure_columns(). */
#include "experiments/drawing/figure.h"
#include "stack.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double views_max = 125, column_gap = 5; /* mm */

typedef struct columns {
    int count;
    fw_stack *stacks; /* [count] */
    fw_view *views;   /* of all stacks, for their common colours */
    int view_count;
    fw_view_key key;
    fw_colour_bar bar;
    bool has_bar;
    double legend_top;
} columns;

static fw_status check(const fw_page *page, const fw_figure_stack_plan *plans, int count,
                       fw_error *error)
{
    for (int k = 0; k < count; ++k) {
        if (plans[k].view_count + plans[k].chart_count > 0) continue;
        return fw_fail(error, FW_BAD_INPUT, "column %d of the picture '%s' has nothing to show",
                       k + 1, page->file);
    }
    return FW_OK;
}

static fw_status create(columns *all, const fw_figure_stack_plan *plans, int count, fw_error *error)
{
    int views = 0;
    for (int k = 0; k < count; ++k) views += plans[k].view_count;
    all->stacks = calloc((size_t)count, sizeof *all->stacks);
    all->views = calloc((size_t)views + 1, sizeof *all->views);
    if (!all->stacks || !all->views) return fw_fail_memory(error, "the columns of a picture");
    all->count = count;
    for (int k = 0; k < count; ++k) {
        for (int v = 0; v < plans[k].view_count; ++v) {
            all->views[all->view_count++] = plans[k].views[v];
        }
    }
    FW_TRY(fw_view_key_for(&all->key, all->views, all->view_count, plans[0].colouring, error));
    all->has_bar = all->key.by_field;
    for (int k = 0; k < count; ++k) {
        FW_TRY(fw_stack_create(&all->stacks[k], &plans[k], &all->key, error));
    }
    return FW_OK;
}

static void release(columns *all)
{
    for (int k = 0; k < all->count; ++k) fw_stack_release(&all->stacks[k]);
    free(all->stacks);
    free(all->views);
}

/* Panels of one row get one range of y, and their label once. */
static void share_rows(columns *all)
{
    for (int row = 0; row < all->stacks[0].panel_count; ++row) {
        fw_range common = fw_range_empty();
        for (int k = 0; k < all->count; ++k) {
            if (row >= all->stacks[k].panel_count) continue;
            fw_range y = all->stacks[k].panels[row].y.range;
            fw_range_include(&common, (double[]){y.low, y.high}, 2, false);
        }
        const char *label = all->stacks[0].panels[row].y.label.text;
        for (int k = 0; k < all->count; ++k) {
            if (row >= all->stacks[k].panel_count) continue;
            fw_axis *y = &all->stacks[k].panels[row].y;
            y->range = common;
            if (k > 0 && label && y->label.text && strcmp(label, y->label.text) == 0)
                y->label.text = NULL;
        }
    }
}

/* Equal widths of all boxes, such that everything fits on the page and no column's views are too
 * high. Returns the room that stays empty. */
static double size_columns(const fw_page *page, columns *all)
{
    double taken = 20, width = 0, shrink = 1;
    /* Charts of a narrow page are lower, too. */
    const double lower = page->chart_height > 0
                             ? page->chart_height / fw_stack_charts_height(&all->stacks[0])
                             : fmin(1, fmax(.6, page->width / fw_page_default().width));
    for (int round = 0; round < 4; ++round) {
        double room = page->width - 2 * FW_PAGE_MARGIN - taken;
        double highest = 0;
        width = fmax(room / all->count, 20);
        for (int k = 0; k < all->count; ++k) {
            highest = fmax(highest, fw_stack_size(&all->stacks[k], width, lower));
        }
        shrink = highest > views_max ? views_max / highest : 1;
        taken = (all->count - 1) * column_gap;
        for (int k = 0; k < all->count; ++k) {
            double views = fw_stack_size(&all->stacks[k], shrink * width, lower);
            bool last = k + 1 == all->count;
            double right = fw_stack_overhang(&all->stacks[k]);
            if (last && all->has_bar) {
                all->bar = fw_colour_bar_for(all->key.scale, views);
                right = fmax(right, fw_colour_bar_width(&all->bar));
            }
            taken += all->stacks[k].label_place + right;
        }
    }
    return all->count * width * (1 - shrink);
}

/* Panels of one row begin at the same height. */
static void align_rows(columns *all)
{
    for (int row = 0; row < all->stacks[0].panel_count; ++row) {
        double lowest = 0;
        for (int k = 0; k < all->count; ++k) {
            if (row >= all->stacks[k].panel_count) continue;
            lowest = fmax(lowest, all->stacks[k].panels[row].box.top);
        }
        for (int k = 0; k < all->count; ++k) {
            if (row >= all->stacks[k].panel_count) continue;
            fw_stack_lower(&all->stacks[k], row, lowest - all->stacks[k].panels[row].box.top);
        }
    }
}

/* Returns the lower end of everything. */
static double place_columns(const fw_page *page, columns *all, double spare)
{
    double left = FW_PAGE_MARGIN + spare / 2, bottom = 0;
    all->legend_top = fw_page_top(page);
    double top = all->legend_top + fw_legend_height(all->key.entries, all->key.entry_count,
                                                    page->width - 2 * FW_PAGE_MARGIN);
    double head = all->has_bar ? fw_colour_bar_head(&all->bar) : 0;
    for (int k = 0; k < all->count; ++k) {
        fw_stack *stack = &all->stacks[k];
        left += stack->label_place;
        fw_stack_place(stack, left, top, head, page->width);
        left += stack->panels[0].box.width + fw_stack_overhang(stack) + column_gap;
    }
    align_rows(all);
    for (int k = 0; k < all->count; ++k) bottom = fmax(bottom, fw_stack_bottom(&all->stacks[k]));
    return bottom;
}

static fw_status draw(const fw_page *page, const columns *all, fw_canvas *canvas, fw_error *error)
{
    for (int k = 0; k < all->count; ++k) FW_TRY(fw_stack_draw(&all->stacks[k], canvas, error));
    fw_legend_draw(all->key.entries, all->key.entry_count, canvas,
                   (fw_vec2){FW_PAGE_MARGIN, all->legend_top}, page->width - 2 * FW_PAGE_MARGIN);
    if (!all->has_bar) return FW_OK;
    const fw_stack *stack = &all->stacks[all->count - 1];
    int views = stack->plan->view_count;
    const fw_rect *first = &stack->panels[0].box,
                  *last = &stack->panels[views > 0 ? views - 1 : 0].box;
    fw_colour_bar_draw(&all->bar, canvas, first->left + first->width, first->top,
                       last->top + last->height - first->top);
    return FW_OK;
}

/* On a logarithmic axis there is no place for what is not above 0. */
static fw_status check_logarithmic(const fw_axis *axis, char name, fw_range asked, fw_error *error)
{
    if (!axis->logarithmic || axis->range.low > 0) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "the %c axis is logarithmic and cannot go from %g to %g, expected both above 0",
                   name, asked.low, asked.high);
}

/* What is asked for goes before what fits. */
static fw_status crop(const fw_page *page, columns *all, fw_error *error)
{
    for (int k = 0; k < all->count; ++k)
        for (int p = 0; p < all->stacks[k].panel_count; ++p) {
            fw_panel *panel = &all->stacks[k].panels[p];
            const fw_label label = all->stacks[k].plan->label;
            const fw_range own = panel->x.range;
            panel->x.range = fw_page_range(page->x_range, own, label);
            panel->y.range = fw_page_range(page->y_range, panel->y.range, panel->y.label);
            FW_TRY(check_logarithmic(&panel->x, 'x', page->x_range, error));
            FW_TRY(check_logarithmic(&panel->y, 'y', page->y_range, error));
            if (panel->x.range.high < own.low || panel->x.range.low > own.high)
                return fw_fail(error, FW_BAD_INPUT,
                               "nothing lies between %g and %g along x, where the picture goes "
                               "from %.4g to %.4g",
                               page->x_range.low, page->x_range.high,
                               fw_label_shown(label, own.low), fw_label_shown(label, own.high));
        }
    return FW_OK;
}

fw_status fw_figure_columns(const fw_page *page, const fw_figure_stack_plan *plans, int count,
                            fw_error *error)
{
    columns all = {.count = 0};
    fw_canvas *canvas;
    if (count < 1) {
        return fw_fail(error, FW_BAD_INPUT, "the picture '%s' has nothing to show", page->file);
    }
    FW_TRY(check(page, plans, count, error));
    fw_status status = create(&all, plans, count, error);
    if (status == FW_OK) {
        share_rows(&all);
        status = crop(page, &all, error);
    }
    if (status == FW_OK) {
        double spare = size_columns(page, &all);
        double bottom = place_columns(page, &all, spare);
        status = fw_page_open(page, bottom, &canvas, error);
    }
    if (status == FW_OK) {
        status = draw(page, &all, canvas, error);
        status = fw_page_close(canvas, status, error);
    }
    release(&all);
    return status;
}

fw_status fw_figure_stack(const fw_page *page, const fw_figure_stack_plan *plan, fw_error *error)
{
    return fw_figure_columns(page, plan, 1, error);
}

fw_status fw_figure_series(const fw_page *page, const fw_chart *charts, int chart_count,
                           fw_label time, const fw_figure_mark *marks, int mark_count,
                           fw_error *error)
{
    fw_figure_stack_plan plan = {.charts = charts,
                                 .chart_count = chart_count,
                                 .label = time,
                                 .marks = marks,
                                 .mark_count = mark_count};
    return fw_figure_stack(page, &plan, error);
}

fw_status fw_figure_curves(const fw_page *page, const fw_chart *chart, fw_label x,
                           const fw_axis_name *names, int name_count, fw_error *error)
{
    fw_figure_stack_plan plan = {
        .charts = chart, .chart_count = 1, .label = x, .names = names, .name_count = name_count};
    return fw_figure_stack(page, &plan, error);
}
