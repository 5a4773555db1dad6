/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_map.c - a number at every place of a grid as colour, with curves over it.
 * Keeps no state. Start reading at fw_figure_map(). */
#include "colour_bar.h"
#include "figure_parts.h"

#include <math.h>
#include <stddef.h>

static const double hair = 1e-4; /* mm */

void fw_figure_draw_cells(const fw_figure_map_plan *plan, const fw_panel *panel,
                          const fw_colour_scale *scale)
{
    for (int row = 0; row < plan->rows; ++row) {
        for (int column = 0; column < plan->columns; ++column) {
            double p = plan->p_first + (column - .5) * plan->p_step;
            double q = plan->q_first + (row + .5) * plan->q_step;
            fw_vec2 corner = fw_panel_place(panel, p, q);
            fw_vec2 opposite = fw_panel_place(panel, p + plan->p_step, q - plan->q_step);
            double value = plan->values[(long)row * plan->columns + column];
            /* A hair over its neighbours: rounding leaves no gap between them. */
            fw_rect cell = {corner.x, corner.y, opposite.x - corner.x + hair,
                            opposite.y - corner.y + hair};
            fw_canvas_rectangle(panel->canvas, cell, fw_colour_scale_at(scale, value));
        }
    }
}

/* A size of letters at which each text is within its cell; 0: they would be too small. */
static double size_of_texts(const fw_figure_map_plan *plan, const fw_panel *panel)
{
    const double width = .86 * panel->box.width / plan->columns;
    const double height = .45 * panel->box.height / plan->rows;
    double size = FW_SMALL_SIZE;
    for (long n = 0; n < (long)plan->rows * plan->columns; ++n) {
        if (!plan->texts[n]) continue;
        const double own = fw_canvas_text_width(plan->texts[n], FW_SMALL_SIZE, false);
        size = fmin(size, FW_SMALL_SIZE * width / own);
    }
    size = fmin(size, FW_SMALL_SIZE * height / fw_canvas_line_height(FW_SMALL_SIZE));
    return size < .55 * FW_SMALL_SIZE ? 0 : size;
}

static bool has_marker_in(const fw_figure_map_plan *plan, const fw_panel *panel, fw_rect room)
{
    const double reach = 1.1; /* mm */
    for (int k = 0; k < plan->curve_count; ++k) {
        const fw_curve *curve = &plan->curves[k];
        for (int n = 0; n < curve->count && curve->look == FW_CURVE_MARKERS; ++n) {
            const fw_vec2 at = fw_panel_place(panel, curve->x[n], curve->y[n]);
            if (fabs(at.x - room.left - room.width / 2) < room.width / 2 + reach &&
                fabs(at.y - room.top - room.height / 2) < room.height / 2 + reach)
                return true;
        }
    }
    return false;
}

/* Room for a text, so much above the middle of its cell. */
static fw_rect room_of_text(const fw_figure_map_plan *plan, const fw_panel *panel, long n,
                            double size, double above)
{
    const double p = plan->p_first + (double)(n % plan->columns) * plan->p_step;
    const double q = plan->q_first + ((double)(n / plan->columns) + above) * plan->q_step;
    const fw_vec2 at = fw_panel_place(panel, p, q);
    const double width = fw_canvas_text_width(plan->texts[n], size, false) + 1;
    const double height = fw_canvas_line_height(size);
    return (fw_rect){at.x - width / 2, at.y - height / 2, width, height};
}

/* Black on what is light, white on what is dark; in the middle of its cell. Where there are curves,
 * which pass the middle, low in it, or high where a marker lies below; a curve that comes so low is
 * interrupted. */
static void draw_texts(const fw_figure_map_plan *plan, const fw_panel *panel,
                       const fw_colour_scale *scale)
{
    const double size = plan->texts ? size_of_texts(plan, panel) : 0;
    const double above = plan->curve_count > 0 ? -.36 : 0;
    for (long n = 0; size > 0 && n < (long)plan->rows * plan->columns; ++n) {
        if (!plan->texts[n]) continue;
        const fw_colour below = fw_colour_scale_at(scale, plan->values[n]);
        const double light = .3 * below.red + .59 * below.green + .11 * below.blue;
        const fw_text_look look = {.size = size,
                                   .colour = fw_colour_grey(light > .5 ? 0 : 1),
                                   .across = FW_TEXT_CENTRE,
                                   .along = FW_TEXT_MIDDLE};
        fw_rect room = room_of_text(plan, panel, n, size, above);
        if (has_marker_in(plan, panel, room)) room = room_of_text(plan, panel, n, size, .36);
        const fw_vec2 at = {room.left + room.width / 2, room.top + room.height / 2};
        fw_canvas_rectangle(panel->canvas, room, below);
        fw_canvas_text(panel->canvas, at, plan->texts[n], look);
    }
}

/* White below black: to be seen on any colour. */
static void draw_curves(const fw_figure_map_plan *plan, const fw_panel *panel, bool markers)
{
    for (int k = 0; k < plan->curve_count; ++k) {
        const fw_curve *curve = &plan->curves[k];
        if ((curve->look == FW_CURVE_MARKERS) != markers) continue;
        if (curve->look == FW_CURVE_MARKERS) {
            if (curve->error)
                fw_panel_bars(panel, curve->x, curve->y, curve->error, curve->open, curve->count,
                              fw_colour_grey(0));
            if (curve->spread)
                fw_panel_bars_across(panel, curve->x, curve->y, curve->spread, curve->count,
                                     fw_colour_grey(0));
            fw_panel_markers(panel, curve->x, curve->y, curve->count, 1.1, fw_colour_grey(1));
            fw_panel_markers(panel, curve->x, curve->y, curve->count, .75, fw_colour_grey(0));
            continue;
        }
        fw_dash dash = curve->look == FW_CURVE_DASHES ? FW_DASH_LONG : FW_DASH_NONE;
        fw_panel_line(panel, curve->x, curve->y, curve->count,
                      (fw_stroke){fw_colour_grey(1), 1, FW_DASH_NONE});
        fw_panel_line(panel, curve->x, curve->y, curve->count,
                      (fw_stroke){fw_colour_grey(0), .45, dash});
    }
}

fw_status fw_figure_map(const fw_page *page, const fw_figure_map_plan *plan, fw_error *error)
{
    long count = (long)plan->columns * plan->rows;
    if (count < 1) {
        return fw_fail(error, FW_BAD_INPUT,
                       "the map '%s' has %d columns and %d rows; it needs at "
                       "least one of each",
                       page->file, plan->columns, plan->rows);
    }
    fw_colour_scale scale = fw_colour_scale_for(plan->colouring, plan->values, count);
    fw_panel panel = {.canvas = NULL};
    double p = plan->p_first - plan->p_step / 2, q = plan->q_first - plan->q_step / 2;
    panel.x = (fw_axis){.range = {p, p + plan->columns * plan->p_step},
                        .label = plan->p_label,
                        .names = plan->p_names,
                        .name_count = plan->p_name_count};
    panel.y = (fw_axis){.range = {q, q + plan->rows * plan->q_step},
                        .label = plan->q_label,
                        .names = plan->q_names,
                        .name_count = plan->q_name_count};
    const fw_chart overlay = {.curves = plan->curves, .curve_count = plan->curve_count};
    fw_legend_entry entries[FW_CHART_LEGEND_MAX];
    int entry_count = fw_chart_legend(&overlay, entries);
    for (int k = 0; k < entry_count; ++k) entries[k].colour = fw_colour_grey(0);

    fw_colour_bar bar = fw_colour_bar_for(scale, 90);
    for (int round = 0; round < 2; ++round) {
        double right = fmax(fw_colour_bar_width(&bar), fw_axis_overhang(&panel.x, 100));
        if (plan->equal_aspect) {
            fw_page_fit_equal(page, &panel, right, 30, .8 * page->width);
        } else {
            fw_page_fit(page, &panel, right, 90);
        }
        bar = fw_colour_bar_for(scale, panel.box.height);
    }
    double top = fw_page_top(page);
    panel.box.top = top + fw_legend_height(entries, entry_count, panel.box.width) +
                    fmax(fw_axis_note_height(&panel.y), fw_colour_bar_head(&bar));
    double bottom = panel.box.top + panel.box.height + fw_axis_depth(&panel.x, true);
    FW_TRY(fw_page_open(page, bottom, &panel.canvas, error));
    fw_canvas_raster_begin(panel.canvas, panel.box);
    fw_figure_draw_cells(plan, &panel, &scale);
    fw_canvas_raster_end(panel.canvas);
    fw_canvas_clip(panel.canvas, panel.box);
    draw_curves(plan, &panel, false);
    draw_texts(plan, &panel, &scale);
    draw_curves(plan, &panel, true);
    fw_canvas_unclip(panel.canvas);
    fw_panel_draw_axes(&panel, 0);
    fw_legend_draw(entries, entry_count, panel.canvas, (fw_vec2){panel.box.left, top},
                   panel.box.width);
    fw_colour_bar_draw(&bar, panel.canvas, panel.box.left + panel.box.width, panel.box.top,
                       panel.box.height);
    return fw_page_close(panel.canvas, FW_OK, error);
}
