/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_pairs.c - bodies, and beside or below each a map or a chart of them.
 * State: the layout of one figure. Invariant: panels of one row are alike but for their data. Start
 * reading at fw_figure_pairs(). */
#include "figure_parts.h"
#include "view_key.h"

#include <math.h>

static const double gap = 7, highest_view = 120, chart_height = 36, spot = .3; /* mm */

typedef struct layout {
    const fw_figure_pairs_plan *plan;
    int count;
    fw_view_key key;         /* of the views */
    fw_colour_scale colours; /* of the maps */
    fw_colour_bar view_bar, map_bar;
    fw_panel view, other; /* as they are in the first pair */
    double step;          /* from one pair to the next, in mm */
    double name_size;     /* of the letters above the views, in points */
} layout;

static bool has_maps(const layout *l)
{
    return l->plan->pairs[0].map != NULL;
}

/* --- ranges --- */

static void find_view_ranges(layout *l, const fw_page *page)
{
    const fw_figure_pairs_plan *plan = l->plan;
    fw_view_bounds bounds = fw_view_bounds_empty();
    for (int k = 0; k < l->count; ++k) fw_view_bounds_include_bodies(&bounds, plan->pairs[k].view);
    for (int k = 0; k < l->count; ++k)
        fw_view_bounds_include_walls(&bounds, plan->pairs[k].view, 1);
    l->view.x = (fw_axis){.range = fw_range_roomy(bounds.x, .03, false), .label = page->x_label};
    l->view.y = (fw_axis){.range = fw_range_roomy(bounds.y, .03, false), .label = page->y_label};
}

static void find_chart_ranges(layout *l)
{
    const fw_chart *first = l->plan->pairs[0].chart;
    fw_range x = fw_range_empty(), y = fw_range_empty();
    for (int k = 0; k < l->count; ++k) {
        fw_chart_include_x(&x, l->plan->pairs[k].chart, false);
        fw_chart_include_y(&y, l->plan->pairs[k].chart);
    }
    l->other.x = (fw_axis){.range = x, .label = l->plan->x_label};
    l->other.y = (fw_axis){.range = first->range.low < first->range.high
                                        ? first->range
                                        : fw_range_roomy(y, .05, first->logarithmic),
                           .logarithmic = first->logarithmic,
                           .label = first->label};
}

static void find_map_ranges(layout *l)
{
    const fw_figure_map_plan *map = l->plan->pairs[0].map;
    const double p = map->p_first - map->p_step / 2, q = map->q_first - map->q_step / 2;
    l->other.x = (fw_axis){.range = {p, p + map->columns * map->p_step}, .label = map->p_label};
    l->other.y = (fw_axis){.range = {q, q + map->rows * map->q_step}, .label = map->q_label};
    l->colours = fw_colour_scale_for(map->colouring, map->values, (long)map->columns * map->rows);
}

/* --- places --- */

/* The same scale along x and y: what is too high for the page gets more of x. */
static void size_view(layout *l, double width)
{
    fw_panel *view = &l->view;
    const double x = view->x.range.high - view->x.range.low;
    const double y = view->y.range.high - view->y.range.low;
    view->box.width = width;
    view->box.height = width * y / x;
    if (view->box.height > highest_view) {
        const double middle = view->x.range.low + x / 2, half = width * y / highest_view / 2;
        view->x.range = (fw_range){middle - half, middle + half};
        view->box.height = highest_view;
    }
    fw_axis_prepare(&view->x, width, true);
    fw_axis_prepare(&view->y, view->box.height, false);
    if (l->key.by_field) l->view_bar = fw_colour_bar_for(l->key.scale, view->box.height);
}

static void size_other(layout *l, double width, double height)
{
    l->other.box.width = width;
    l->other.box.height = height;
    fw_axis_prepare(&l->other.x, width, true);
    fw_axis_prepare(&l->other.y, height, false);
    if (has_maps(l)) l->map_bar = fw_colour_bar_for(l->colours, height);
}

/* Room to the right of a panel. */
static double right_of_view(const layout *l)
{
    return fmax(l->key.by_field ? fw_colour_bar_width(&l->view_bar) : 0,
                fw_axis_overhang(&l->view.x, l->view.box.width));
}

static double right_of_other(const layout *l)
{
    return fmax(has_maps(l) ? fw_colour_bar_width(&l->map_bar) : 0,
                fw_axis_overhang(&l->other.x, l->other.box.width));
}

static double room_above_view(const layout *l)
{
    return FW_FIGURE_NAME + fmax(fw_axis_note_height(&l->view.y),
                                 l->key.by_field ? fw_colour_bar_head(&l->view_bar) : 0);
}

static double room_above_other(const layout *l)
{
    return fmax(fw_axis_note_height(&l->other.y),
                has_maps(l) ? fw_colour_bar_head(&l->map_bar) : 0);
}

/* One pair: side by side. Returns the lower end. */
static double place_beside(layout *l, const fw_page *page, double top)
{
    double taken = 40;
    for (int round = 0; round < 3; ++round) {
        const double width = fmax((page->width - 2 * FW_PAGE_MARGIN - taken) / 2, 20);
        size_view(l, width);
        size_other(l, width, has_maps(l) ? width : l->view.box.height);
        taken = fw_axis_depth(&l->view.y, false) + right_of_view(l) + gap +
                fw_axis_depth(&l->other.y, false) + right_of_other(l);
    }
    l->view.box.left = FW_PAGE_MARGIN + fw_axis_depth(&l->view.y, false);
    l->other.box.left = l->view.box.left + l->view.box.width + right_of_view(l) + gap +
                        fw_axis_depth(&l->other.y, false);
    l->view.box.top = l->other.box.top = top + fmax(room_above_view(l), room_above_other(l));
    return l->view.box.top + fmax(l->view.box.height + fw_axis_depth(&l->view.x, true),
                                  l->other.box.height + fw_axis_depth(&l->other.x, true));
}

/* Several: the views above, the rest below. Returns the lower end. */
static double place_below(layout *l, const fw_page *page, double top)
{
    double taken = 40, depth = 15;
    for (int round = 0; round < 3; ++round) {
        const double room = page->width - 2 * FW_PAGE_MARGIN - taken - (l->count - 1) * gap;
        const double width = fmax(room / l->count, 12);
        size_view(l, width);
        size_other(l, width, has_maps(l) ? width : chart_height);
        depth = fmax(fw_axis_depth(&l->view.y, false), fw_axis_depth(&l->other.y, false));
        taken = depth + fmax(right_of_view(l), right_of_other(l));
    }
    l->step = l->view.box.width + gap;
    l->view.box.left = l->other.box.left = FW_PAGE_MARGIN + depth;
    l->view.box.top = top + room_above_view(l);
    l->other.box.top = l->view.box.top + l->view.box.height + fw_axis_depth(&l->view.x, true) + 2 +
                       room_above_other(l);
    return l->other.box.top + l->other.box.height + fw_axis_depth(&l->other.x, true);
}

/* --- drawing --- */

/* That panel in pair k: only the first one's y axis has numbers. */
static fw_panel panel_at(const layout *l, const fw_panel *first, int k, fw_canvas *canvas)
{
    fw_panel panel = *first;
    panel.canvas = canvas;
    panel.box.left += k * l->step;
    panel.y.bare = k > 0;
    return panel;
}

static fw_status draw_view(const layout *l, int k, fw_canvas *canvas, fw_error *error)
{
    const fw_view *view = l->plan->pairs[k].view;
    const fw_panel panel = panel_at(l, &l->view, k, canvas);
    FW_TRY(fw_figure_draw_view(view, &panel, l->plan->look, fw_view_key_scale(&l->key), error));
    fw_canvas_clip(canvas, panel.box);
    for (int b = 0; l->plan->spots && b < view->body_count; ++b)
        fw_view_draw_discs(&view->bodies[b], &panel, spot, fw_colour_grey(1));
    fw_canvas_unclip(canvas);
    fw_panel_draw_axes(&panel, 0);
    fw_figure_name_view(view, &panel, k == 0 ? fw_axis_note_height(&panel.y) : 0, l->name_size);
    return FW_OK;
}

static void draw_other(const layout *l, int k, fw_canvas *canvas)
{
    const fw_panel panel = panel_at(l, &l->other, k, canvas);
    if (has_maps(l)) {
        fw_canvas_raster_begin(canvas, panel.box);
        fw_figure_draw_cells(l->plan->pairs[k].map, &panel, &l->colours);
        fw_canvas_raster_end(canvas);
    } else {
        fw_panel_draw_grid(&panel);
        fw_chart_draw(l->plan->pairs[k].chart, &panel);
    }
    fw_panel_draw_axes(&panel, 0);
}

static void draw_bars(const layout *l, fw_canvas *canvas)
{
    const fw_rect view = panel_at(l, &l->view, l->count - 1, canvas).box;
    const fw_rect other = panel_at(l, &l->other, l->count - 1, canvas).box;
    if (l->key.by_field)
        fw_colour_bar_draw(&l->view_bar, canvas, view.left + view.width, view.top, view.height);
    if (has_maps(l))
        fw_colour_bar_draw(&l->map_bar, canvas, other.left + other.width, other.top, other.height);
}

fw_status fw_figure_pairs(const fw_page *page, const fw_figure_pairs_plan *plan, fw_error *error)
{
    layout l = {.plan = plan, .count = plan->pair_count};
    fw_view views[FW_FIGURE_PAIRS_MAX];
    fw_canvas *canvas;
    if (plan->pair_count < 1 || plan->pair_count > FW_FIGURE_PAIRS_MAX)
        return fw_fail(error, FW_BAD_INPUT, "the picture '%s' shows %d instants, expected 1 to %d",
                       page->file, plan->pair_count, FW_FIGURE_PAIRS_MAX);
    for (int k = 0; k < l.count; ++k) views[k] = *plan->pairs[k].view;
    FW_TRY(fw_view_key_for(&l.key, views, l.count, plan->colouring, error));
    find_view_ranges(&l, page);
    if (has_maps(&l))
        find_map_ranges(&l);
    else
        find_chart_ranges(&l);
    const double width = page->width - 2 * FW_PAGE_MARGIN, legend_top = fw_page_top(page);
    const double top = legend_top + fw_legend_height(l.key.entries, l.key.entry_count, width);
    const double bottom = l.count == 1 ? place_beside(&l, page, top) : place_below(&l, page, top);
    l.name_size = l.count == 1 ? FW_SMALL_SIZE
                               : fw_figure_name_size(views, l.count, l.view.box.width + gap - 3);
    FW_TRY(fw_page_open(page, bottom, &canvas, error));
    fw_status status = FW_OK;
    for (int k = 0; k < l.count && status == FW_OK; ++k) {
        status = draw_view(&l, k, canvas, error);
        draw_other(&l, k, canvas);
    }
    draw_bars(&l, canvas);
    fw_legend_draw(l.key.entries, l.key.entry_count, canvas, (fw_vec2){FW_PAGE_MARGIN, legend_top},
                   width);
    return fw_page_close(canvas, status, error);
}
