/* SPDX-License-Identifier: GPL-3.0-or-later */
/* legend.c - samples and words in rows.
 * Keeps no state. Invariant: a legend takes exactly the height that fw_legend_height promised for
 * the same width. Start reading at flow(). */
#include "experiments/drawing/legend.h"

#include <stddef.h>

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
    fw_canvas_text(
        canvas, (fw_vec2){at.x + sample_length(entry) + word_gap, at.y}, entry->label,
        (fw_text_look){FW_SMALL_SIZE, fw_colour_ink(), FW_TEXT_LEFT, FW_TEXT_MIDDLE, 0, false});
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
    return rows > 0 ? rows * row_height() + 1.6 : 0;
}

void fw_legend_draw(const fw_legend_entry *entries, int count, fw_canvas *canvas, fw_vec2 corner,
                    double width)
{
    flow(entries, count, canvas, corner, width);
}
