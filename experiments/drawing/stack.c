/* SPDX-License-Identifier: GPL-3.0-or-later */
/* stack.c - one column of panels.
 * State: the boxes and axes of the panels (see the header). Invariant: all boxes have the same left
 * and right edge. Start reading at fw_stack_size() and fw_stack_draw(). */
#include "stack.h"

#include <math.h>
#include <stdlib.h>

typedef fw_figure_stack_plan stack_plan;

static const double panel_gap = 2.6, label_height = 3.8; /* mm */

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

static void describe_axes(fw_stack *stack)
{
    const stack_plan *plan = stack->plan;
    fw_range x = range_of_x(plan);
    for (int k = 0; k < stack->panel_count; ++k) {
        bool last = k + 1 == stack->panel_count;
        fw_panel *panel = &stack->panels[k];
        panel->x = (fw_axis){.range = x,
                             .logarithmic = plan->logarithmic,
                             .label = plan->label,
                             .names = plan->names,
                             .name_count = plan->name_count,
                             .bare = !last};
        if (k < plan->view_count) {
            fw_view_bounds bounds = fw_view_bounds_empty();
            fw_view_bounds_include_bodies(&bounds, &plan->views[k]);
            if (is_fixed(plan->y_range)) bounds.y = plan->y_range;
            panel->y = (fw_axis){.range = fw_range_roomy(bounds.y, .02, false),
                                 .label = plan->y_label.text ? plan->y_label : (fw_label){"y", 0}};
        } else {
            const fw_chart *chart = &plan->charts[k - plan->view_count];
            panel->y = (fw_axis){.range = fw_chart_range_of_y(chart),
                                 .logarithmic = chart->logarithmic,
                                 .label = chart->label};
        }
    }
}

fw_status fw_stack_create(fw_stack *stack, const fw_figure_stack_plan *plan, const fw_view_key *key,
                          fw_error *error)
{
    *stack =
        (fw_stack){.plan = plan, .key = key, .panel_count = plan->view_count + plan->chart_count};
    stack->panels = calloc((size_t)stack->panel_count + 1, sizeof *stack->panels);
    stack->legend_top = calloc((size_t)stack->panel_count + 1, sizeof *stack->legend_top);
    if (!stack->panels || !stack->legend_top) {
        fw_stack_release(stack);
        return fw_fail_memory(error, "the panels of a picture");
    }
    describe_axes(stack);
    return FW_OK;
}

void fw_stack_release(fw_stack *stack)
{
    free(stack->panels);
    free(stack->legend_top);
    stack->panels = NULL;
    stack->legend_top = NULL;
}

static double chart_height(const stack_plan *plan, const fw_chart *chart)
{
    if (chart->height > 0) return chart->height;
    if (plan->view_count > 0) return plan->chart_count == 1 ? 48 : 36;
    return plan->chart_count == 1 ? 84 : plan->chart_count == 2 ? 52 : 38;
}

double fw_stack_charts_height(const fw_stack *stack)
{
    double height = 0;
    for (int k = 0; k < stack->plan->chart_count; ++k)
        height += chart_height(stack->plan, &stack->plan->charts[k]);
    return height > 0 ? height : 1;
}

double fw_stack_size(fw_stack *stack, double width, double shrink)
{
    const stack_plan *plan = stack->plan;
    double views_height = 0;
    stack->label_place = 0;
    for (int k = 0; k < stack->panel_count; ++k) {
        fw_panel *panel = &stack->panels[k];
        double scale = width / (panel->x.range.high - panel->x.range.low);
        panel->box.width = width;
        panel->box.height = k < plan->view_count
                                ? scale * (panel->y.range.high - panel->y.range.low)
                                : shrink * chart_height(plan, &plan->charts[k - plan->view_count]);
        if (k < plan->view_count) views_height += panel->box.height + (k > 0 ? panel_gap : 0);
        fw_axis_prepare(&panel->x, width, true);
        fw_axis_prepare(&panel->y, panel->box.height, false);
        stack->label_place = fmax(stack->label_place, fw_axis_depth(&panel->y, false));
    }
    return views_height;
}

double fw_stack_overhang(const fw_stack *stack)
{
    const fw_panel *last = &stack->panels[stack->panel_count - 1];
    return fw_axis_overhang(&last->x, last->box.width);
}

static void add_label(fw_stack *stack, const char *words, double at, double page_width)
{
    const fw_panel *panel = &stack->panels[0];
    if (!words || stack->label_count == FW_STACK_LABELS_MAX) return;
    if (!(at >= panel->x.range.low && at <= panel->x.range.high)) return;
    double width = fw_canvas_text_width(words, FW_SMALL_SIZE, false);
    double left = fmin(fmax(fw_panel_x(panel, at) - width / 2, FW_PAGE_MARGIN),
                       page_width - FW_PAGE_MARGIN - width);
    fw_stack_label *label = &stack->labels[stack->label_count++];
    *label = (fw_stack_label){words, fw_panel_x(panel, at), left, left + width, 0};
    /* The lowest row where it touches no other. */
    for (int k = 0; k < stack->label_count - 1; ++k) {
        const fw_stack_label *other = &stack->labels[k];
        if (other->row != label->row || other->left > label->right + 2 ||
            other->right + 2 < label->left) {
            continue;
        }
        label->row += 1;
        k = -1;
    }
    if (label->row >= stack->label_rows) stack->label_rows = label->row + 1;
}

/* Middle of the part of a region that is on the paper. */
static double middle_of(const fw_figure_region *region, const fw_axis *axis)
{
    double from = fmax(region->from, axis->range.low),
           until = fmin(region->until, axis->range.high);
    return from <= until ? from + (until - from) / 2 : NAN;
}

static void add_labels(fw_stack *stack, double page_width)
{
    const stack_plan *plan = stack->plan;
    stack->label_count = stack->label_rows = 0;
    for (int k = 0; k < plan->region_count; ++k) {
        add_label(stack, plan->regions[k].label, middle_of(&plan->regions[k], &stack->panels[0].x),
                  page_width);
    }
    for (int k = 0; k < plan->mark_count; ++k) {
        add_label(stack, plan->marks[k].label, plan->marks[k].at, page_width);
    }
}

void fw_stack_place(fw_stack *stack, double left, double top, double head, double page_width)
{
    const stack_plan *plan = stack->plan;
    for (int k = 0; k < stack->panel_count; ++k) stack->panels[k].box.left = left;
    add_labels(stack, page_width);
    for (int k = 0; k < stack->panel_count; ++k) {
        fw_panel *panel = &stack->panels[k];
        fw_legend_entry entries[FW_CHART_LEGEND_MAX];
        stack->legend_top[k] = top;
        if (k >= plan->view_count) {
            int count = fw_chart_legend(&plan->charts[k - plan->view_count], entries);
            top += fw_legend_height(entries, count, panel->box.width);
        } else if (plan->views[k].name) {
            top += label_height;
        }
        if (k == 0) {
            stack->labels_top = top;
            top += stack->label_rows * label_height + head;
        }
        panel->box.top = top + fw_axis_note_height(&panel->y);
        top = panel->box.top + panel->box.height + panel_gap +
              (panel->x.bare ? 0 : fw_axis_depth(&panel->x, true));
    }
}

void fw_stack_lower(fw_stack *stack, int panel, double by)
{
    if (panel == 0) stack->labels_top += by;
    for (int k = panel; k < stack->panel_count; ++k) {
        stack->panels[k].box.top += by;
        stack->legend_top[k] += by;
    }
}

double fw_stack_bottom(const fw_stack *stack)
{
    const fw_panel *last = &stack->panels[stack->panel_count - 1];
    return last->box.top + last->box.height + fw_axis_depth(&last->x, true);
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

static void draw_chart_panel(const fw_stack *stack, int number)
{
    const stack_plan *plan = stack->plan;
    const fw_panel *panel = &stack->panels[number];
    const fw_chart *chart = &plan->charts[number - plan->view_count];
    fw_legend_entry entries[FW_CHART_LEGEND_MAX];
    fw_range values = fw_range_empty();
    fw_chart_include_y(&values, chart);
    draw_regions(plan, panel, true);
    fw_panel_draw_grid(panel);
    fw_canvas_clip(panel->canvas, panel->box);
    draw_regions(plan, panel, false);
    draw_marks(plan, panel);
    fw_canvas_unclip(panel->canvas);
    fw_panel_draw_axes(panel, stack->label_place);
    fw_chart_draw(chart, panel);
    if (fw_range_is_empty(values)) fw_panel_say(panel, "no data");
    fw_legend_draw(entries, fw_chart_legend(chart, entries), panel->canvas,
                   (fw_vec2){panel->box.left, stack->legend_top[number]}, panel->box.width);
}

static fw_status draw_view_panel(const fw_stack *stack, int number, fw_error *error)
{
    const stack_plan *plan = stack->plan;
    const fw_panel *panel = &stack->panels[number];
    const fw_view *view = &plan->views[number];
    fw_canvas_clip(panel->canvas, panel->box);
    fw_view_draw_walls(view, panel, true, 1);
    fw_status status =
        fw_view_draw_particles(view, panel, plan->look, fw_view_key_scale(stack->key), error);
    fw_view_draw_walls(view, panel, true, FW_VIEW_VEIL);
    fw_view_draw_surfaces(view, panel);
    draw_regions(plan, panel, false);
    draw_marks(plan, panel);
    fw_canvas_unclip(panel->canvas);
    fw_panel_draw_axes(panel, stack->label_place);
    if (view->name) {
        fw_canvas_text(panel->canvas,
                       (fw_vec2){panel->box.left, stack->legend_top[number] + label_height - 1},
                       view->name,
                       (fw_text_look){FW_SMALL_SIZE, fw_colour_grey(.1), FW_TEXT_LEFT,
                                      FW_TEXT_BASELINE, 0, false});
    }
    return status;
}

/* From a label in a higher row down to the box, unless that would cross another label. */
static void draw_leader(const fw_stack *stack, const fw_stack_label *label, double from)
{
    const fw_stroke line = {fw_colour_grey(.6), .18, FW_DASH_NONE};
    const fw_panel *panel = &stack->panels[0];
    for (int k = 0; k < stack->label_count; ++k) {
        const fw_stack_label *other = &stack->labels[k];
        bool lower = other->row < label->row;
        if (lower && label->at > other->left - .3 && label->at < other->right + .3) return;
    }
    fw_canvas_line(panel->canvas, (fw_vec2){label->at, from}, (fw_vec2){label->at, panel->box.top},
                   line);
}

fw_status fw_stack_draw(const fw_stack *stack, fw_canvas *canvas, fw_error *error)
{
    for (int k = 0; k < stack->panel_count; ++k) {
        stack->panels[k].canvas = canvas;
        if (k >= stack->plan->view_count) {
            draw_chart_panel(stack, k);
        } else {
            FW_TRY(draw_view_panel(stack, k, error));
        }
    }
    for (int k = 0; k < stack->label_count; ++k) {
        const fw_stack_label *label = &stack->labels[k];
        double row = stack->labels_top + (stack->label_rows - label->row) * label_height - 1.1;
        fw_canvas_text(canvas, (fw_vec2){label->left, row}, label->words,
                       (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_LEFT,
                                      FW_TEXT_BASELINE, 0, false});
        if (label->row > 0) draw_leader(stack, label, row + .9);
    }
    return FW_OK;
}
