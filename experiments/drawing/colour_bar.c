/* SPDX-License-Identifier: GPL-3.0-or-later */
/* colour_bar.c - a bar of colours with its axis.
 * Keeps no state. Start reading at fw_colour_bar_draw(). */
#include "colour_bar.h"

#include <math.h>

static const double bar_gap = 4, bar_breadth = 3.4, bar_tick = 1.1; /* mm */

fw_colour_bar fw_colour_bar_for(fw_colour_scale scale, double height)
{
    fw_colour_bar bar = {
        .scale = scale,
        .axis = {.range = scale.range, .logarithmic = scale.logarithmic, .label = scale.label}};
    fw_axis_prepare(&bar.axis, height, false);
    return bar;
}

/* Where the label's line begins, to the right of the bar. */
static double label_offset(const fw_colour_bar *bar)
{
    return bar_tick + FW_AXIS_NUMBER_GAP + fw_axis_widest_number(&bar->axis) + 1.8;
}

double fw_colour_bar_width(const fw_colour_bar *bar)
{
    double label = bar->axis.label.text ? fw_canvas_line_height(FW_TEXT_SIZE) : 0;
    return bar_gap + bar_breadth + label_offset(bar) + label;
}

double fw_colour_bar_head(const fw_colour_bar *bar)
{
    double excess = bar->scale.exceeds_high || bar->scale.fixed ? 2.6 : 0;
    return excess + fw_axis_note_height(&bar->axis);
}

double fw_colour_bar_foot(const fw_colour_bar *bar)
{
    return bar->scale.exceeds_low || bar->scale.fixed ? 2.6 : 0;
}

/* Arrow heads at the ends say that some values lie beyond. */
static void draw_excess(const fw_colour_bar *bar, fw_canvas *canvas, fw_rect box)
{
    double middle = box.left + box.width / 2, half = .5 * box.width;
    if (bar->scale.exceeds_high) {
        fw_vec2 tip[3] = {{middle - half, box.top - .5},
                          {middle + half, box.top - .5},
                          {middle, box.top - .5 - 1.2 * half}};
        fw_canvas_polygon(canvas, tip, 3, fw_palette_at(bar->scale.map, 1), 0);
    }
    if (bar->scale.exceeds_low) {
        double bottom = box.top + box.height + .5;
        fw_vec2 tip[3] = {
            {middle - half, bottom}, {middle + half, bottom}, {middle, bottom + 1.2 * half}};
        fw_canvas_polygon(canvas, tip, 3, fw_palette_at(bar->scale.map, 0), 0);
    }
}

void fw_colour_bar_draw(const fw_colour_bar *bar, fw_canvas *canvas, double left, double top,
                        double height)
{
    enum { SHADES = 256 };
    const fw_rect box = {left + bar_gap, top, bar_breadth, height};
    const fw_stroke line = {fw_colour_ink(), .22, FW_DASH_NONE};
    for (int k = 0; k < SHADES; ++k) {
        /* Each strip reaches down to the end of the bar: no paper shines through between them. */
        double from = height * k / SHADES;
        fw_canvas_rectangle(canvas, (fw_rect){box.left, top + from, bar_breadth, height - from},
                            fw_palette_at(bar->scale.map, 1 - (k + .5) / SHADES));
    }
    draw_excess(bar, canvas, box);
    fw_canvas_frame(canvas, box, line);
    fw_panel panel = {.canvas = canvas, .box = box, .y = bar->axis};
    double right = box.left + box.width;
    for (int k = 0; k < bar->axis.ticks.count; ++k) {
        double y = fw_panel_y(&panel, bar->axis.ticks.at[k]);
        fw_canvas_line(canvas, (fw_vec2){right, y}, (fw_vec2){right + bar_tick, y}, line);
        fw_canvas_text(
            canvas, (fw_vec2){right + bar_tick + FW_AXIS_NUMBER_GAP, y}, bar->axis.ticks.label[k],
            (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_LEFT, FW_TEXT_MIDDLE, 0, false});
    }
    /* A long note reaches to the left, where there is room above the panel. */
    fw_canvas_text(
        canvas,
        (fw_vec2){left + fw_colour_bar_width(bar), top - (bar->scale.exceeds_high ? 3.4 : 1.1)},
        bar->axis.ticks.note,
        (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_RIGHT, FW_TEXT_BASELINE, 0, false});
    if (!bar->axis.label.text) return;
    double size = fw_canvas_fitting_size(bar->axis.label.text, FW_TEXT_SIZE, height + 6);
    fw_canvas_text(canvas, (fw_vec2){right + label_offset(bar), top + height / 2},
                   bar->axis.label.text,
                   (fw_text_look){size, fw_colour_ink(), FW_TEXT_CENTRE, FW_TEXT_TOP, 90, false});
}
