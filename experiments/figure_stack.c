/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_stack.c - views and charts above one x axis: time series, profiles under a configuration,
 * single charts.
 * Keeps no state. Invariant: all panels have the same left and right edge. Start reading at
 * fw_figure_stack(). */
#include "experiments/figure.h"
#include "experiments/view_key.h"

#include <math.h>
#include <stdlib.h>

typedef fw_figure_stack_plan stack_plan;

enum { LABELS_MOST = 32 };

/* Words above the panels: names of regions and marks. */
typedef struct stack_label {
    const char *words;
    double at; /* along x */
    double left, right;
    int row;
} stack_label;

typedef struct stack_layout {
    fw_view_key key;
    fw_colour_bar bar;
    int panel_count; /* views first, then charts */
    fw_panel *panels;
    double *legend_top; /* of each panel */
    double label_place; /* distance of the y labels from the boxes */
    int label_count, label_rows;
    stack_label labels[LABELS_MOST];
    double labels_top;
    double bottom;
} stack_layout;

static const double panel_gap = 2.6, label_height = 3.8, views_most = 125; /* mm */

static bool is_fixed(fw_range range)
{
    return range.high > range.low;
}

static fw_range range_of_x(const stack_plan *plan)
{
    if (is_fixed(plan->range)) return plan->range;
    fw_view_bounds bounds = fw_view_bounds_empty();
    for (int k = 0; k < plan->view_count; ++k) {
        fw_view_bounds_include_bodies(&bounds, &plan->views[k]);
    }
    for (int k = 0; k < plan->chart_count; ++k) {
        fw_chart_include_x(&bounds.x, &plan->charts[k], plan->logarithmic);
    }
    for (int k = 0; k < plan->name_count; ++k) {
        fw_range_include(&bounds.x, &plan->names[k].at, 1, plan->logarithmic);
    }
    return fw_range_roomy(bounds.x, plan->name_count > 0 ? 0 : .02, plan->logarithmic);
}

static fw_range range_of_y(const fw_chart *chart)
{
    if (is_fixed(chart->range)) return fw_range_roomy(chart->range, 0, chart->logarithmic);
    fw_range y = fw_range_empty();
    fw_chart_include_y(&y, chart);
    /* What is positive and not far from zero is seen best against zero. */
    if (!chart->logarithmic && y.low >= 0 && y.low < .25 * y.high) y.low = 0;
    return fw_range_roomy(y, .05, chart->logarithmic);
}

static void describe_axes(const stack_plan *plan, stack_layout *layout)
{
    fw_range x = range_of_x(plan);
    for (int k = 0; k < layout->panel_count; ++k) {
        bool last = k + 1 == layout->panel_count;
        fw_panel *panel = &layout->panels[k];
        panel->x = (fw_axis){.range = x,
                             .logarithmic = plan->logarithmic,
                             .label = plan->label,
                             .names = plan->names,
                             .name_count = plan->name_count,
                             .bare = !last};
        if (k < plan->view_count) {
            fw_view_bounds bounds = fw_view_bounds_empty();
            fw_view_bounds_include_bodies(&bounds, &plan->views[k]);
            panel->y = (fw_axis){.range = fw_range_roomy(bounds.y, .02, false),
                                 .label = plan->y_label ? plan->y_label : "y"};
        } else {
            const fw_chart *chart = &plan->charts[k - plan->view_count];
            panel->y = (fw_axis){.range = range_of_y(chart),
                                 .logarithmic = chart->logarithmic,
                                 .label = chart->label};
        }
    }
}

static double chart_height(const stack_plan *plan, const fw_chart *chart)
{
    if (chart->height > 0) return chart->height;
    if (plan->view_count > 0) return plan->chart_count == 1 ? 48 : 36;
    return plan->chart_count == 1 ? 84 : plan->chart_count == 2 ? 52 : 38;
}

/* Width of all boxes for the given room; a view that would be too high makes all narrower. */
static double common_width(const stack_plan *plan, const stack_layout *layout, double room)
{
    double height = 0;
    for (int k = 0; k < plan->view_count; ++k) {
        const fw_panel *panel = &layout->panels[k];
        height += (panel->y.range.high - panel->y.range.low) /
                  (panel->x.range.high - panel->x.range.low) * room;
    }
    return height > views_most ? room * views_most / height : room;
}

static void size_panels(const fw_page *page, const stack_plan *plan, stack_layout *layout)
{
    double left = 12, right = 3;
    for (int round = 0; round < 3; ++round) {
        double room = fmax(page->width - 2 * FW_PAGE_MARGIN - left - right, 20);
        double width = common_width(plan, layout, room), depth = 0, views_height = 0;
        for (int k = 0; k < layout->panel_count; ++k) {
            fw_panel *panel = &layout->panels[k];
            double scale = width / (panel->x.range.high - panel->x.range.low);
            panel->box.left = FW_PAGE_MARGIN + left + (room - width) / 2;
            panel->box.width = width;
            panel->box.height = k < plan->view_count
                                    ? scale * (panel->y.range.high - panel->y.range.low)
                                    : chart_height(plan, &plan->charts[k - plan->view_count]);
            if (k < plan->view_count) views_height += panel->box.height + (k > 0 ? panel_gap : 0);
            fw_axis_prepare(&panel->x, width, true);
            fw_axis_prepare(&panel->y, panel->box.height, false);
            depth = fmax(depth, fw_axis_depth(&panel->y, false));
        }
        left = layout->label_place = depth;
        right = fw_axis_overhang(&layout->panels[layout->panel_count - 1].x, width);
        if (!layout->key.by_field || plan->view_count == 0) continue;
        layout->bar = fw_colour_bar_for(layout->key.scale, views_height);
        right = fmax(right, fw_colour_bar_width(&layout->bar));
    }
}

static void add_label(const fw_page *page, stack_layout *layout, const char *words, double at)
{
    const fw_panel *panel = &layout->panels[0];
    if (!words || layout->label_count == LABELS_MOST) return;
    if (!(at >= panel->x.range.low && at <= panel->x.range.high)) return;
    double width = fw_canvas_text_width(words, FW_SMALL_SIZE, false);
    double left = fmin(fmax(fw_panel_x(panel, at) - width / 2, FW_PAGE_MARGIN),
                       page->width - FW_PAGE_MARGIN - width);
    stack_label *label = &layout->labels[layout->label_count++];
    *label = (stack_label){words, at, left, left + width, 0};
    /* The lowest row where it touches no other. */
    for (int k = 0; k < layout->label_count - 1; ++k) {
        const stack_label *other = &layout->labels[k];
        if (other->row != label->row || other->left > label->right + 2 ||
            other->right + 2 < label->left) {
            continue;
        }
        label->row += 1;
        k = -1;
    }
    if (label->row >= layout->label_rows) layout->label_rows = label->row + 1;
}

/* Middle of the part of a region that is on the paper. */
static double middle_of(const fw_figure_region *region, const fw_axis *axis)
{
    double from = fmax(region->from, axis->range.low),
           until = fmin(region->until, axis->range.high);
    return from <= until ? from + (until - from) / 2 : NAN;
}

static void place_panels(const fw_page *page, const stack_plan *plan, stack_layout *layout)
{
    double top = fw_page_top(page);
    for (int k = 0; k < plan->region_count; ++k) {
        add_label(page, layout, plan->regions[k].label,
                  middle_of(&plan->regions[k], &layout->panels[0].x));
    }
    for (int k = 0; k < plan->mark_count; ++k) {
        add_label(page, layout, plan->marks[k].label, plan->marks[k].at);
    }
    for (int k = 0; k < layout->panel_count; ++k) {
        fw_panel *panel = &layout->panels[k];
        fw_legend_entry entries[FW_CHART_LEGEND_MOST];
        layout->legend_top[k] = top;
        if (k >= plan->view_count) {
            int count = fw_chart_legend(&plan->charts[k - plan->view_count], entries);
            top += fw_legend_height(entries, count, panel->box.width);
        } else if (k == 0) {
            top += fw_legend_height(layout->key.entries, layout->key.entry_count, panel->box.width);
        }
        if (k < plan->view_count && plan->views[k].name) top += label_height;
        if (k == 0) {
            layout->labels_top = top;
            top += layout->label_rows * label_height;
            if (layout->key.by_field && plan->view_count > 0) {
                top += fw_colour_bar_head(&layout->bar);
            }
        }
        top += fw_axis_note_height(&panel->y);
        panel->box.top = top;
        layout->bottom = top + panel->box.height + fw_axis_depth(&panel->x, true);
        top = layout->bottom + panel_gap - (panel->x.bare ? fw_axis_depth(&panel->x, true) : 0);
    }
}

static void draw_regions(const stack_plan *plan, const fw_panel *panel, bool shaded)
{
    const fw_stroke border = {fw_colour_grey(.35), .22, FW_DASH_LONG};
    double top = panel->box.top, bottom = top + panel->box.height;
    for (int k = 0; k < plan->region_count; ++k) {
        const fw_figure_region *region = &plan->regions[k];
        double from = fmax(region->from, panel->x.range.low);
        double until = fmin(region->until, panel->x.range.high);
        if (!(from < until)) continue;
        double left = fw_panel_x(panel, from), right = fw_panel_x(panel, until);
        if (shaded) {
            fw_canvas_rectangle(panel->canvas, (fw_rect){left, top, right - left, bottom - top},
                                fw_colour_fade(fw_colour_grey(0), .13 * region->strength));
        } else {
            fw_canvas_line(panel->canvas, (fw_vec2){left, top}, (fw_vec2){left, bottom}, border);
            fw_canvas_line(panel->canvas, (fw_vec2){right, top}, (fw_vec2){right, bottom}, border);
        }
    }
}

static void draw_marks(const stack_plan *plan, const fw_panel *panel)
{
    const fw_stroke line = {fw_colour_grey(.3), .25, FW_DASH_LONG};
    const fw_stroke name_line = {fw_colour_grey(.7), .2, FW_DASH_NONE};
    double top = panel->box.top, bottom = top + panel->box.height;
    for (int k = 0; k < plan->name_count; ++k) {
        double x = fw_panel_x(panel, plan->names[k].at);
        fw_canvas_line(panel->canvas, (fw_vec2){x, top}, (fw_vec2){x, bottom}, name_line);
    }
    for (int k = 0; k < plan->mark_count; ++k) {
        double x = fw_panel_x(panel, plan->marks[k].at);
        fw_canvas_line(panel->canvas, (fw_vec2){x, top}, (fw_vec2){x, bottom}, line);
    }
}

static void draw_chart_panel(const stack_plan *plan, const stack_layout *layout, int number)
{
    const fw_panel *panel = &layout->panels[number];
    const fw_chart *chart = &plan->charts[number - plan->view_count];
    fw_legend_entry entries[FW_CHART_LEGEND_MOST];
    fw_range values = fw_range_empty();
    fw_chart_include_y(&values, chart);
    draw_regions(plan, panel, true);
    fw_panel_draw_grid(panel);
    fw_canvas_clip(panel->canvas, panel->box);
    draw_regions(plan, panel, false);
    draw_marks(plan, panel);
    fw_canvas_unclip(panel->canvas);
    fw_panel_draw_axes(panel, layout->label_place);
    fw_chart_draw(chart, panel);
    if (fw_range_is_empty(values)) fw_panel_say(panel, "no data");
    fw_legend_draw(entries, fw_chart_legend(chart, entries), panel->canvas,
                   (fw_vec2){panel->box.left, layout->legend_top[number]}, panel->box.width);
}

static fw_status draw_view_panel(const stack_plan *plan, const stack_layout *layout, int number,
                                 fw_error *error)
{
    const fw_panel *panel = &layout->panels[number];
    const fw_view *view = &plan->views[number];
    fw_canvas_clip(panel->canvas, panel->box);
    fw_view_draw_walls(view, panel);
    fw_status status =
        fw_view_draw_particles(view, panel, plan->look, fw_view_key_scale(&layout->key), error);
    fw_view_draw_surfaces(view, panel);
    draw_regions(plan, panel, false);
    draw_marks(plan, panel);
    fw_canvas_unclip(panel->canvas);
    fw_panel_draw_axes(panel, layout->label_place);
    if (view->name) {
        fw_canvas_text(panel->canvas,
                       (fw_vec2){panel->box.left, layout->legend_top[number] + label_height - 1},
                       view->name,
                       (fw_text_look){FW_SMALL_SIZE, fw_colour_grey(.1), FW_TEXT_LEFT,
                                      FW_TEXT_BASELINE, 0, false});
    }
    return status;
}

static fw_status draw(const stack_plan *plan, const stack_layout *layout, fw_canvas *canvas,
                      fw_error *error)
{
    const fw_panel *first = &layout->panels[0];
    for (int k = 0; k < layout->panel_count; ++k) {
        layout->panels[k].canvas = canvas;
        if (k >= plan->view_count) {
            draw_chart_panel(plan, layout, k);
        } else {
            FW_TRY(draw_view_panel(plan, layout, k, error));
        }
    }
    for (int k = 0; k < layout->label_count; ++k) {
        const stack_label *label = &layout->labels[k];
        double row = layout->labels_top + (layout->label_rows - label->row) * label_height - 1.1;
        fw_canvas_text(canvas, (fw_vec2){label->left, row}, label->words,
                       (fw_text_look){FW_SMALL_SIZE, fw_colour_grey(.1), FW_TEXT_LEFT,
                                      FW_TEXT_BASELINE, 0, false});
    }
    if (plan->view_count == 0) return FW_OK;
    fw_legend_draw(layout->key.entries, layout->key.entry_count, canvas,
                   (fw_vec2){first->box.left, layout->legend_top[0]}, first->box.width);
    if (layout->key.by_field) {
        const fw_panel *last = &layout->panels[plan->view_count - 1];
        fw_colour_bar_draw(&layout->bar, canvas, first->box.left + first->box.width, first->box.top,
                           last->box.top + last->box.height - first->box.top);
    }
    return FW_OK;
}

fw_status fw_figure_stack(const fw_page *page, const fw_figure_stack_plan *plan, fw_error *error)
{
    stack_layout layout = {.panel_count = plan->view_count + plan->chart_count};
    fw_canvas *canvas;
    if (layout.panel_count < 1) {
        return fw_fail(error, FW_BAD_INPUT, "the picture '%s' has nothing to show", page->file);
    }
    FW_TRY(fw_view_key_for(&layout.key, plan->views, plan->view_count, plan->colouring, error));
    layout.panels = calloc((size_t)layout.panel_count, sizeof *layout.panels);
    layout.legend_top = calloc((size_t)layout.panel_count, sizeof *layout.legend_top);
    fw_status status = FW_OK;
    if (!layout.panels || !layout.legend_top) {
        status = fw_fail_memory(error, "the panels of a picture");
    } else {
        describe_axes(plan, &layout);
        size_panels(page, plan, &layout);
        place_panels(page, plan, &layout);
        status = fw_page_open(page, layout.bottom, &canvas, error);
    }
    if (status == FW_OK) {
        status = draw(plan, &layout, canvas, error);
        status = fw_page_close(canvas, status, error);
    }
    free(layout.panels);
    free(layout.legend_top);
    return status;
}

fw_status fw_figure_series(const fw_page *page, const fw_chart *charts, int chart_count,
                           const char *time_label, const fw_figure_mark *marks, int mark_count,
                           fw_error *error)
{
    fw_figure_stack_plan plan = {.charts = charts,
                                 .chart_count = chart_count,
                                 .label = time_label,
                                 .marks = marks,
                                 .mark_count = mark_count};
    return fw_figure_stack(page, &plan, error);
}

fw_status fw_figure_curves(const fw_page *page, const fw_chart *chart, const char *x_label,
                           const fw_axis_name *names, int name_count, fw_error *error)
{
    fw_figure_stack_plan plan = {.charts = chart,
                                 .chart_count = 1,
                                 .label = x_label,
                                 .names = names,
                                 .name_count = name_count};
    return fw_figure_stack(page, &plan, error);
}
