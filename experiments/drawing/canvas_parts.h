/* SPDX-License-Identifier: GPL-3.0-or-later */
/* canvas_parts.h - what the files canvas*.c share: they alone know cairo. */
#ifndef FW_CANVAS_PARTS_H
#define FW_CANVAS_PARTS_H

#include "experiments/drawing/canvas.h"

#include <cairo.h>
#include <stdbool.h>
#include <stddef.h>

#define FW_MM_PER_POINT (25.4 / 72)

/* Cairo counts in 1/256 of a device unit in 32 bits; this is far outside of any page and inside of
 * that at any resolution. */
#define FW_CANVAS_FARTHEST 1e5

typedef enum canvas_format { PNG, SVG, PDF } canvas_format;

typedef struct byte_store {
    unsigned char *bytes; /* owned */
    size_t count, room;
} byte_store;

struct fw_canvas {
    char *name; /* owned */
    canvas_format format;
    double width, height, resolution;
    byte_store store;
    cairo_surface_t *surface;
    cairo_t *context; /* what is drawn on: the page, or a raster on its way there */
    cairo_t *page;    /* the page while a raster is being drawn, else NULL */
    fw_rect raster;
};

/* A context that measures in mm, its text unhinted. */
cairo_t *fw_canvas_context(cairo_surface_t *surface, double units_per_mm);
/* The point, or the nearest one that cairo can count. */
fw_vec2 fw_canvas_within_reach(fw_vec2 point);
/* Says in the bytes of a PNG file how many dots an inch has; false without memory. */
bool fw_canvas_add_dots(byte_store *store, double resolution);
void fw_canvas_set_colour(fw_canvas *canvas, fw_colour colour);

#endif
