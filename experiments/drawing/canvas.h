/* SPDX-License-Identifier: GPL-3.0-or-later */
/* canvas.h - a sheet of paper to draw on, kept as PNG, SVG or PDF.
 *
 * Lengths are millimetres from the upper left corner, y downwards; sizes of text are points.
 * Points that are not finite are passed over. The only door to cairo. */
#ifndef FW_CANVAS_H
#define FW_CANVAS_H

#include "core/status.h"
#include "core/vec2.h"
#include "experiments/drawing/palette.h"

#include <stdbool.h>

typedef struct fw_canvas fw_canvas;

typedef struct fw_rect {
    double left, top, width, height;
} fw_rect;

/* `name` ends in .png, .svg or .pdf, which says what it becomes; nothing is written before
 * fw_canvas_save. `resolution` in dots per inch is that of PNG and of rastered parts.
 * FW_BAD_INPUT: another ending, or a size that cannot be drawn. */
fw_status fw_canvas_create(fw_canvas **canvas, const char *name, double width, double height,
                           double resolution, fw_error *error);
/* What is drawn from now on is larger by a factor; its mm are no longer those of the paper. */
void fw_canvas_enlarge(fw_canvas *canvas, double factor);
/* Completes the picture and writes it under its name in one go (whole_file.h). To be called once,
 * right before fw_canvas_destroy. */
fw_status fw_canvas_save(fw_canvas *canvas, fw_error *error);
void fw_canvas_destroy(fw_canvas *canvas);

typedef enum fw_dash { FW_DASH_NONE, FW_DASH_LONG, FW_DASH_DOTS } fw_dash;

typedef struct fw_stroke {
    fw_colour colour;
    double width; /* mm */
    fw_dash dash;
} fw_stroke;

void fw_canvas_line(fw_canvas *canvas, fw_vec2 from, fw_vec2 to, fw_stroke stroke);
/* A point that is not finite interrupts the line. */
void fw_canvas_polyline(fw_canvas *canvas, const fw_vec2 *points, int count, bool closed,
                        fw_stroke stroke);
/* Many separate lines: from points[2i] to points[2i + 1]. */
void fw_canvas_segments(fw_canvas *canvas, const fw_vec2 *points, int count, fw_stroke stroke);
/* With its rim in the same colour, `rim` mm wide: 0 for none; neighbours that share an edge need a
 * hair's breadth, or the paper shows through. */
void fw_canvas_polygon(fw_canvas *canvas, const fw_vec2 *points, int count, fw_colour fill,
                       double rim);
/* With sharp edges: neighbours that share one join without a gap. */
void fw_canvas_rectangle(fw_canvas *canvas, fw_rect rect, fw_colour fill);
void fw_canvas_frame(fw_canvas *canvas, fw_rect rect, fw_stroke stroke);
void fw_canvas_disc(fw_canvas *canvas, fw_vec2 centre, double radius, fw_colour fill);
void fw_canvas_circle(fw_canvas *canvas, fw_vec2 centre, double radius, fw_stroke stroke);
/* A closed area between two circles about the same centre. */
void fw_canvas_annulus(fw_canvas *canvas, fw_vec2 centre, double inner, double outer,
                       fw_colour fill);
/* Ends exactly at `to`; the head is `head` mm long, or less on a short arrow. */
void fw_canvas_arrow(fw_canvas *canvas, fw_vec2 from, fw_vec2 to, fw_stroke stroke, double head);

/* The sizes of text in figures, in points. */
#define FW_TEXT_SIZE  8.5
#define FW_SMALL_SIZE 7.5
#define FW_TITLE_SIZE 10.5

/* Which point of the text lies at the given place. */
typedef enum fw_text_across { FW_TEXT_LEFT, FW_TEXT_CENTRE, FW_TEXT_RIGHT } fw_text_across;
typedef enum fw_text_along { FW_TEXT_BASELINE, FW_TEXT_MIDDLE, FW_TEXT_TOP } fw_text_along;

typedef struct fw_text_look {
    double size; /* points */
    fw_colour colour;
    fw_text_across across;
    fw_text_along along;
    double angle; /* degrees, counter-clockwise about the given place */
    bool bold;
} fw_text_look;

/* One line of UTF-8; "^{...}" is raised and "_{...}" lowered. Bytes that are no UTF-8 become '?'.
 */
void fw_canvas_text(fw_canvas *canvas, fw_vec2 at, const char *text, fw_text_look look);
/* Width in mm, the same on every canvas. */
double fw_canvas_text_width(const char *text, double size, bool bold);
/* The given size, or a smaller one (down to half of it) at which the text is no wider than `width`.
 */
double fw_canvas_fitting_size(const char *text, double size, double width);
/* Height of a line of text in mm. */
double fw_canvas_line_height(double size);

/* Only what lies in the rectangle is drawn until unclip; no nesting. */
void fw_canvas_clip(fw_canvas *canvas, fw_rect rect);
void fw_canvas_unclip(fw_canvas *canvas);

/* What is drawn until raster_end becomes one image of the canvas' resolution in SVG and PDF files,
 * which stay small with a hundred thousand particles. No effect in a PNG; no nesting. */
void fw_canvas_raster_begin(fw_canvas *canvas, fw_rect rect);
void fw_canvas_raster_end(fw_canvas *canvas);

/* What a PNG shows so far at a place; alpha 0 for other formats. */
fw_colour fw_canvas_colour_at(fw_canvas *canvas, fw_vec2 at);

#endif
