/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_field.c - a quantity as colour on the particles: one view, or a strip of them.
 * Keeps no state. Start reading at fw_figure_field() and fw_figure_strip(). */
#include "figure_parts.h"
#include "view_arrows.h"
#include "view_key.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

fw_status fw_figure_draw_view(const fw_view *view, const fw_panel *panel, fw_view_look look,
                              const fw_colour_scale *scale, fw_error *error)
{
    fw_canvas_clip(panel->canvas, panel->box);
    fw_view_draw_walls(view, panel, true, 1);
    fw_status status = fw_view_draw_particles(view, panel, look, scale, error);
    fw_view_draw_walls(view, panel, true, FW_VIEW_VEIL);
    fw_view_draw_surfaces(view, panel);
    fw_canvas_unclip(panel->canvas);
    if (fw_view_count(view) == 0) fw_panel_say(panel, "no particles");
    return status;
}

static const double strip_gap = 3, name_height = FW_FIGURE_NAME; /* mm */

double fw_figure_name_size(const fw_view *views, int count, double room)
{
    double size = FW_SMALL_SIZE;
    for (int k = 0; k < count; ++k) {
        char name[64];
        fw_view_print_name(&views[k], name, sizeof name);
        size = fmin(size, fw_canvas_fitting_size(name, FW_SMALL_SIZE, room));
    }
    return size;
}

void fw_figure_name_view(const fw_view *view, const fw_panel *panel, double above, double size)
{
    char name[64];
    fw_view_print_name(view, name, sizeof name);
    fw_canvas_text(
        panel->canvas, (fw_vec2){panel->box.left, panel->box.top - 1.2 - above}, name,
        (fw_text_look){size, fw_colour_grey(.1), FW_TEXT_LEFT, FW_TEXT_BASELINE, 0, false});
}

/* --- one view --- */

fw_status fw_figure_field(const fw_page *page, const fw_figure_field_plan *plan, fw_error *error)
{
    fw_view_key key;
    fw_panel panel = {.canvas = NULL};
    fw_colour_bar bar = {.axis = {.label = {NULL, 0}}};
    FW_TRY(fw_view_key_for(&key, plan->view, 1, plan->colouring, error));
    fw_view_bounds bounds = fw_view_bounds_or_empty(plan->bounds);
    fw_view_bounds_include_bodies(&bounds, plan->view);
    if (fw_view_bounds_are_unset(plan->bounds))
        fw_view_bounds_include_walls(&bounds, plan->view, 1);
    panel.x = fw_page_axis(page->x_range, fw_range_roomy(bounds.x, .03, false), page->x_label);
    panel.y = fw_page_axis(page->y_range, fw_range_roomy(bounds.y, .03, false), page->y_label);
    double right = 3;
    for (int round = 0; round < 2; ++round) {
        fw_page_fit_equal(page, &panel, right, 18, 1.05 * page->width);
        right = fw_axis_overhang(&panel.x, panel.box.width);
        if (!key.by_field) continue;
        bar = fw_colour_bar_for(key.scale, panel.box.height);
        right = fmax(right, fw_colour_bar_width(&bar));
    }
    double top = fw_page_top(page), width = page->width - 2 * FW_PAGE_MARGIN;
    double notes = fmax(fw_axis_note_height(&panel.y), key.by_field ? fw_colour_bar_head(&bar) : 0);
    panel.box.top =
        top + fw_legend_height(key.entries, key.entry_count, width) + name_height + notes;
    double bottom = panel.box.top + panel.box.height + fw_axis_depth(&panel.x, true);
    FW_TRY(fw_page_open(page, bottom, &panel.canvas, error));
    fw_status status =
        fw_figure_draw_view(plan->view, &panel, plan->look, fw_view_key_scale(&key), error);
    fw_panel_draw_axes(&panel, 0);
    fw_figure_name_view(plan->view, &panel, notes, FW_SMALL_SIZE);
    fw_legend_draw(key.entries, key.entry_count, panel.canvas, (fw_vec2){FW_PAGE_MARGIN, top},
                   width);
    if (key.by_field) {
        fw_colour_bar_draw(&bar, panel.canvas, panel.box.left + panel.box.width, panel.box.top,
                           panel.box.height);
    }
    return fw_page_close(panel.canvas, status, error);
}

/* --- a strip of views --- */

typedef struct strip_layout {
    fw_view_key key;
    fw_view_arrows arrows;
    int entry_count; /* of the legend: those of the key, and the arrow's */
    fw_legend_entry entries[FW_PALETTE_KINDS + 1];
    fw_colour_bar bar;
    fw_view_bounds bounds; /* common to all views */
    int columns, rows;
    double top, legend_width;
    fw_rect first; /* box of the first view */
} strip_layout;

static fw_rect strip_box(const strip_layout *layout, int number)
{
    fw_rect box = layout->first;
    box.left += (number % layout->columns) * (box.width + strip_gap);
    box.top += (number / layout->columns) * (box.height + strip_gap + name_height);
    return box;
}

/* The longest arrow reaches over so many spacings, within these lengths in mm. */
static const double arrow_spacings = 2.2, arrow_shortest = 5, arrow_longest = 12;

static double narrowest_spacing(const fw_figure_strip_plan *plan)
{
    double least = INFINITY;
    for (int k = 0; k < plan->view_count; ++k)
        for (int b = 0; b < plan->views[k].body_count; ++b)
            least = fmin(least, fw_view_spacing(&plan->views[k].bodies[b]));
    return least;
}

static void explain(const fw_page *page, const fw_figure_strip_plan *plan, double mm_per_length,
                    strip_layout *layout)
{
    const double wanted = arrow_spacings * mm_per_length * narrowest_spacing(plan);
    fw_view_arrows_for(&layout->arrows, plan->views, plan->view_count,
                       fmin(fmax(wanted, arrow_shortest), arrow_longest), page->force);
    layout->entry_count = layout->key.entry_count;
    memcpy(layout->entries, layout->key.entries, sizeof layout->key.entries);
    if (layout->arrows.entry.label) layout->entries[layout->entry_count++] = layout->arrows.entry;
}

static int chosen_columns(const fw_figure_strip_plan *plan, double aspect)
{
    if (plan->columns > 0)
        return plan->columns < plan->view_count ? plan->columns : plan->view_count;
    int most = aspect > 2 ? 2 : aspect > 1.2 ? 3 : 4;
    int rows = (plan->view_count + most - 1) / most;
    return (plan->view_count + rows - 1) / rows;
}

static void lay_out_strip(const fw_page *page, const fw_figure_strip_plan *plan,
                          strip_layout *layout)
{
    layout->bounds = fw_view_bounds_empty();
    for (int k = 0; k < plan->view_count; ++k) {
        fw_view_bounds_include_bodies(&layout->bounds, &plan->views[k]);
    }
    fw_view_bounds_include_walls(&layout->bounds, plan->views, plan->view_count);
    layout->bounds.x =
        fw_page_range(page->x_range, fw_range_roomy(layout->bounds.x, .03, false), page->x_label);
    layout->bounds.y =
        fw_page_range(page->y_range, fw_range_roomy(layout->bounds.y, .03, false), page->y_label);
    double x_extent = layout->bounds.x.high - layout->bounds.x.low;
    double y_extent = layout->bounds.y.high - layout->bounds.y.low;
    layout->columns = chosen_columns(plan, x_extent / y_extent);
    layout->rows = (plan->view_count + layout->columns - 1) / layout->columns;
    layout->top = fw_page_top(page);
    layout->legend_width = page->width - 2 * FW_PAGE_MARGIN;
    layout->first.left = FW_PAGE_MARGIN;
    layout->first.width =
        (layout->legend_width - (layout->columns - 1) * strip_gap) / layout->columns;
    explain(page, plan, layout->first.width / x_extent, layout);
    layout->first.top =
        layout->top + name_height +
        fw_legend_height(layout->entries, layout->entry_count, layout->legend_width);
    double right = 0;
    for (int round = 0; round < 3; ++round) {
        double room = page->width - 2 * FW_PAGE_MARGIN - right;
        layout->first.width = (room - (layout->columns - 1) * strip_gap) / layout->columns;
        layout->first.height =
            fmin(fmax(layout->first.width * y_extent / x_extent, 12), page->width);
        if (!layout->key.by_field) continue;
        fw_rect last = strip_box(layout, plan->view_count - 1);
        layout->bar =
            fw_colour_bar_for(layout->key.scale, last.top + last.height - layout->first.top);
        right = fw_colour_bar_width(&layout->bar);
    }
    /* The same scale along x and y, whatever the box became. */
    double x_scale = layout->first.width / x_extent, y_scale = layout->first.height / y_extent;
    if (x_scale > y_scale) {
        double middle = layout->bounds.x.low + x_extent / 2;
        double half = layout->first.width / y_scale / 2;
        layout->bounds.x = (fw_range){middle - half, middle + half};
    } else {
        double middle = layout->bounds.y.low + y_extent / 2;
        double half = layout->first.height / x_scale / 2;
        layout->bounds.y = (fw_range){middle - half, middle + half};
    }
}

fw_status fw_figure_strip(const fw_page *page, const fw_figure_strip_plan *plan, fw_error *error)
{
    strip_layout layout = {.rows = 0};
    fw_canvas *canvas;
    if (plan->view_count < 1) {
        return fw_fail(error, FW_BAD_INPUT, "the picture '%s' has no frame to show", page->file);
    }
    FW_TRY(fw_view_key_for(&layout.key, plan->views, plan->view_count, plan->colouring, error));
    lay_out_strip(page, plan, &layout);
    fw_rect last = strip_box(&layout, plan->view_count - 1);
    const double foot = layout.key.by_field ? fw_colour_bar_foot(&layout.bar) : 0;
    FW_TRY(fw_page_open(page, last.top + last.height + .5 + foot, &canvas, error));
    fw_status status = FW_OK;
    const double name_size =
        fw_figure_name_size(plan->views, plan->view_count, layout.first.width + strip_gap - 1);
    for (int k = 0; k < plan->view_count && status == FW_OK; ++k) {
        fw_panel panel = {.canvas = canvas,
                          .box = strip_box(&layout, k),
                          .x = {.range = layout.bounds.x},
                          .y = {.range = layout.bounds.y}};
        status = fw_figure_draw_view(&plan->views[k], &panel, plan->look,
                                     fw_view_key_scale(&layout.key), error);
        fw_canvas_clip(canvas, panel.box);
        fw_view_arrows_draw(&layout.arrows, &plan->views[k], &panel);
        fw_canvas_unclip(canvas);
        fw_canvas_frame(canvas, panel.box, (fw_stroke){fw_colour_grey(.55), .18, FW_DASH_NONE});
        fw_figure_name_view(&plan->views[k], &panel, 0, name_size);
    }
    fw_legend_draw(layout.entries, layout.entry_count, canvas,
                   (fw_vec2){FW_PAGE_MARGIN, layout.top}, layout.legend_width);
    if (layout.key.by_field) {
        double right = layout.first.left + layout.columns * layout.first.width +
                       (layout.columns - 1) * strip_gap;
        fw_colour_bar_draw(&layout.bar, canvas, right, layout.first.top,
                           last.top + last.height - layout.first.top);
    }
    return fw_page_close(canvas, status, error);
}
