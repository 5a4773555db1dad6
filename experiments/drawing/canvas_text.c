/* SPDX-License-Identifier: GPL-3.0-or-later */
/* canvas_text.c - text on a canvas. Keeps no state. Invariant: a text is as wide as it was
 * measured, whatever it is drawn on. Start reading at walk_text(). */
#include "canvas_parts.h"

#include "experiments/text/markup.h"

#include <math.h>

/* Walks along a text from the context's origin, drawing it or not; returns its width. */
static double walk_text(cairo_t *context, const char *text, double size, bool bold, bool draw)
{
    double place = 0;
    int level = 0;
    char run[FW_MARKUP_RUN];
    cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    while (*text) {
        fw_markup_take(&text, &level, run);
        if (run[0] == '\0') continue;
        double run_size = (level == 0 ? 1 : .72) * size * FW_MM_PER_POINT;
        double rise = (level == 0 ? 0 : level > 0 ? .36 : -.16) * size * FW_MM_PER_POINT;
        cairo_text_extents_t extents;
        cairo_set_font_size(context, run_size);
        cairo_text_extents(context, run, &extents);
        if (draw) {
            cairo_move_to(context, place, -rise);
            cairo_show_text(context, run);
        }
        place += extents.x_advance;
    }
    return place;
}

double fw_canvas_text_width(const char *text, double size, bool bold)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    /* A fine scale: advances are rounded to 1/64 of a unit somewhere below. */
    cairo_t *context = fw_canvas_context(surface, 32);
    double width = walk_text(context, text, size, bold, false);
    cairo_destroy(context);
    cairo_surface_destroy(surface);
    return width;
}

double fw_canvas_fitting_size(const char *text, double size, double width)
{
    double taken = fw_canvas_text_width(text, size, false);
    return taken > width ? fmax(size * width / taken, size / 2) : size;
}

double fw_canvas_line_height(double size)
{
    return 1.25 * size * FW_MM_PER_POINT;
}

void fw_canvas_text(fw_canvas *canvas, fw_vec2 at, const char *text, fw_text_look look)
{
    if (!isfinite(at.x) || !isfinite(at.y)) return;
    cairo_t *context = canvas->context;
    double width =
        look.across == FW_TEXT_LEFT ? 0 : fw_canvas_text_width(text, look.size, look.bold);
    double capital = .73 * look.size * FW_MM_PER_POINT; /* height of a capital letter */
    at = fw_canvas_within_reach(at);
    cairo_save(context);
    cairo_translate(context, at.x, at.y);
    cairo_rotate(context, -look.angle * M_PI / 180);
    cairo_translate(context,
                    look.across == FW_TEXT_RIGHT    ? -width
                    : look.across == FW_TEXT_CENTRE ? -width / 2
                                                    : 0,
                    look.along == FW_TEXT_TOP      ? capital
                    : look.along == FW_TEXT_MIDDLE ? capital / 2
                                                   : 0);
    fw_canvas_set_colour(canvas, look.colour);
    walk_text(context, text, look.size, look.bold, true);
    cairo_restore(context);
    cairo_new_path(context);
}
