/* SPDX-License-Identifier: GPL-3.0-or-later */
/* key.c - colour bars and legends.
 * Keeps no state. Invariant: a legend takes exactly the height that fw_legend_height promised for
 * the same width. Start reading at flow(), which both share. */
#include "experiments/key.h"

#include <math.h>
#include <stddef.h>

static const fw_colour ink = {.1, .1, .1, 1};

/* --- colour bars --- */

static const double bar_gap = 4, bar_breadth = 3.4, bar_tick = 1.1, number_gap = .9; /* mm */

fw_colour_bar fw_colour_bar_for(fw_colour_scale scale, double height)
{
    fw_colour_bar bar = {
        .scale = scale,
        .axis = {.range = scale.range, .logarithmic = scale.logarithmic, .label = scale.label}};
    fw_axis_prepare(&bar.axis, height, false);
    return bar;
}

static double widest_number(const fw_ticks *ticks)
{
    double widest = 0;
    for (int k = 0; k < ticks->count; ++k) {
        widest = fmax(widest, fw_canvas_text_width(ticks->label[k], FW_SMALL_SIZE, false));
    }
    return widest;
}

/* Where the label's line begins, to the right of the bar. */
static double label_offset(const fw_colour_bar *bar)
{
    return bar_tick + number_gap + widest_number(&bar->axis.ticks) + 1.8;
}

double fw_colour_bar_width(const fw_colour_bar *bar)
{
    double label = bar->axis.label ? fw_canvas_line_height(FW_TEXT_SIZE) : 0;
    return bar_gap + bar_breadth + label_offset(bar) + label;
}

double fw_colour_bar_head(const fw_colour_bar *bar)
{
    double excess = bar->scale.exceeds_high ? 2.6 : 0;
    return excess + fw_axis_note_height(&bar->axis);
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
    const fw_stroke line = {ink, .22, FW_DASH_NONE};
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
        fw_canvas_text(canvas, (fw_vec2){right + bar_tick + number_gap, y},
                       bar->axis.ticks.label[k],
                       (fw_text_look){FW_SMALL_SIZE, ink, FW_TEXT_LEFT, FW_TEXT_MIDDLE, 0, false});
    }
    /* A long note reaches to the left, where there is room above the panel. */
    fw_canvas_text(
        canvas,
        (fw_vec2){left + fw_colour_bar_width(bar), top - (bar->scale.exceeds_high ? 3.4 : 1.1)},
        bar->axis.ticks.note,
        (fw_text_look){FW_SMALL_SIZE, ink, FW_TEXT_RIGHT, FW_TEXT_BASELINE, 0, false});
    if (!bar->axis.label) return;
    fw_canvas_text(canvas, (fw_vec2){right + label_offset(bar), top + height / 2}, bar->axis.label,
                   (fw_text_look){FW_TEXT_SIZE, ink, FW_TEXT_CENTRE, FW_TEXT_TOP, 90, false});
}

/* --- legends --- */

static const double usual_length = 6, word_gap = 1.4, entry_gap = 5; /* mm */

static double row_height(void)
{
    return fw_canvas_line_height(FW_SMALL_SIZE) + .7;
}

static double sample_length(const fw_legend_entry *entry)
{
    if (entry->length > 0) return entry->length;
    return entry->look == FW_LEGEND_DISC || entry->look == FW_LEGEND_RING ? 2.2 : usual_length;
}

static void draw_sample(const fw_legend_entry *entry, fw_canvas *canvas, fw_vec2 at)
{
    fw_vec2 end = {at.x + sample_length(entry), at.y};
    fw_vec2 middle = {(at.x + end.x) / 2, at.y};
    const fw_stroke line = {entry->colour, .45, FW_DASH_NONE};
    switch (entry->look) {
    case FW_LEGEND_LINE_AND_DISC:
        fw_canvas_line(canvas, at, end, line);
        fw_canvas_disc(canvas, middle, .9, entry->colour);
        break;
    case FW_LEGEND_LINE:
        fw_canvas_line(canvas, at, end, line);
        break;
    case FW_LEGEND_DASHES:
        fw_canvas_line(canvas, at, end, (fw_stroke){entry->colour, .45, FW_DASH_LONG});
        break;
    case FW_LEGEND_DISC:
        fw_canvas_disc(canvas, middle, .95, entry->colour);
        break;
    case FW_LEGEND_RING:
        fw_canvas_circle(canvas, middle, .95, (fw_stroke){entry->colour, .3, FW_DASH_NONE});
        break;
    case FW_LEGEND_ARROW:
        fw_canvas_arrow(canvas, at, end, (fw_stroke){entry->colour, .38, FW_DASH_NONE}, 1.9);
        break;
    case FW_LEGEND_FAT_ARROW:
        fw_canvas_arrow(canvas, at, end, (fw_stroke){entry->colour, 1.15, FW_DASH_NONE}, 3.4);
        break;
    }
}

static void draw_entry(const fw_legend_entry *entry, fw_canvas *canvas, fw_vec2 at)
{
    draw_sample(entry, canvas, at);
    fw_canvas_text(canvas, (fw_vec2){at.x + sample_length(entry) + word_gap, at.y}, entry->label,
                   (fw_text_look){FW_SMALL_SIZE, ink, FW_TEXT_LEFT, FW_TEXT_MIDDLE, 0, false});
}

/* Sets the entries one after the other into rows; draws them if there is a canvas; returns the
 * number of rows. */
static int flow(const fw_legend_entry *entries, int count, fw_canvas *canvas, fw_vec2 corner,
                double width)
{
    int rows = 0;
    double place = width;
    for (int k = 0; k < count; ++k) {
        if (!entries[k].label) continue;
        double taken = sample_length(&entries[k]) + word_gap +
                       fw_canvas_text_width(entries[k].label, FW_SMALL_SIZE, false);
        if (rows == 0 || place + taken > width) {
            rows += 1;
            place = 0;
        }
        if (canvas) {
            draw_entry(&entries[k], canvas,
                       (fw_vec2){corner.x + place, corner.y + (rows - .5) * row_height()});
        }
        place += taken + entry_gap;
    }
    return rows;
}

double fw_legend_height(const fw_legend_entry *entries, int count, double width)
{
    int rows = flow(entries, count, NULL, (fw_vec2){0, 0}, width);
    return rows > 0 ? rows * row_height() + .8 : 0;
}

void fw_legend_draw(const fw_legend_entry *entries, int count, fw_canvas *canvas, fw_vec2 corner,
                    double width)
{
    flow(entries, count, canvas, corner, width);
}
