/* SPDX-License-Identifier: GPL-3.0-or-later */
/* canvas.c - lines and areas on a cairo surface, and the file that it becomes.
 * State: a cairo surface and its context; for SVG and PDF the bytes written so far. Invariant: the
 * context measures in millimetres from the upper left corner, whatever it draws on; nothing reaches
 * the disk before fw_canvas_save. Start reading at fw_canvas_create() and fw_canvas_save(). */
#include "canvas_parts.h"

#include "experiments/storage/whole_file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const double mm_per_inch = 25.4;

#ifdef __SANITIZE_ADDRESS__
#define WITH_LEAK_CHECKER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WITH_LEAK_CHECKER
#endif
#endif
#ifdef WITH_LEAK_CHECKER
/* Fontconfig keeps the patterns of the fonts in use until the end of the process; the leak checker,
 * which finds these functions by their names, takes them for lost. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_options(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libfontconfig";
}
const char *__lsan_default_options(void)
{
    return "print_suppressions=0"; /* nothing that a user's program would not print */
}
#endif

static cairo_status_t keep_bytes(void *closure, const unsigned char *bytes, unsigned int count)
{
    byte_store *store = closure;
    if (store->room - store->count < count) {
        size_t room = 2 * store->room + count + 65536;
        unsigned char *larger = realloc(store->bytes, room);
        if (!larger) return CAIRO_STATUS_NO_MEMORY;
        store->bytes = larger;
        store->room = room;
    }
    memcpy(store->bytes + store->count, bytes, count);
    store->count += count;
    return CAIRO_STATUS_SUCCESS;
}

static bool find_format(const char *name, canvas_format *format)
{
    static const char *const endings[] = {".png", ".svg", ".pdf"};
    const char *ending = strrchr(name, '.');
    for (int k = 0; ending && k < 3; ++k) {
        if (strcasecmp(ending, endings[k]) == 0) {
            *format = (canvas_format)k;
            return true;
        }
    }
    return false;
}

/* Text is measured without hinting: a picture has the same layout in every format. */
static void set_up_text(cairo_t *context)
{
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

cairo_t *fw_canvas_context(cairo_surface_t *surface, double units_per_mm)
{
    cairo_t *context = cairo_create(surface);
    cairo_scale(context, units_per_mm, units_per_mm);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    set_up_text(context);
    return context;
}

static int pixels(double length, double resolution)
{
    return (int)fmax(1, ceil(length / mm_per_inch * resolution - 1e-6));
}

static cairo_surface_t *surface_for(fw_canvas *canvas)
{
    double width = canvas->width / FW_MM_PER_POINT, height = canvas->height / FW_MM_PER_POINT;
    switch (canvas->format) {
    case SVG:
        return cairo_svg_surface_create_for_stream(keep_bytes, &canvas->store, width, height);
    case PDF: {
        cairo_surface_t *surface =
            cairo_pdf_surface_create_for_stream(keep_bytes, &canvas->store, width, height);
        /* The same figure is the same bytes on every day. */
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                       "1970-01-01T00:00:00Z");
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "fretwork");
        return surface;
    }
    default:
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                          pixels(canvas->width, canvas->resolution),
                                          pixels(canvas->height, canvas->resolution));
    }
}

static fw_status check_size(const char *name, double width, double height, double resolution,
                            fw_error *error)
{
    const double most_pixels = 32767; /* cairo's limit */
    if (!(width > 0 && width <= 2000 && height > 0 && height <= 2000)) {
        return fw_fail(error, FW_BAD_INPUT,
                       "the picture '%s' would be %g mm wide and %g mm high; each has to lie "
                       "between 0 and 2000 mm",
                       name, width, height);
    }
    if (!(resolution >= 20 && resolution * fmax(width, height) / mm_per_inch < most_pixels)) {
        return fw_fail(error, FW_BAD_INPUT,
                       "the picture '%s' of %.0f mm x %.0f mm cannot have %g dots per inch; it "
                       "takes from 20 to %.0f",
                       name, width, height, resolution,
                       floor(most_pixels * mm_per_inch / fmax(width, height)));
    }
    return FW_OK;
}

fw_status fw_canvas_create(fw_canvas **canvas, const char *name, double width, double height,
                           double resolution, fw_error *error)
{
    *canvas = NULL;
    canvas_format format = PNG;
    if (!find_format(name, &format)) {
        return fw_fail(error, FW_BAD_INPUT,
                       "the picture '%s' cannot be drawn: its name has to end in .png, .svg or "
                       ".pdf",
                       name);
    }
    FW_TRY(check_size(name, width, height, resolution, error));
    fw_canvas *made = calloc(1, sizeof *made);
    if (!made || !(made->name = strdup(name))) {
        free(made);
        return fw_fail_memory(error, "a picture");
    }
    made->format = format;
    made->width = width;
    made->height = height;
    made->resolution = resolution;
    made->surface = surface_for(made);
    made->context = fw_canvas_context(made->surface, format == PNG ? resolution / mm_per_inch
                                                                   : 1 / FW_MM_PER_POINT);
    if (cairo_status(made->context) != CAIRO_STATUS_SUCCESS) {
        fw_status status = fw_fail(error, FW_SYSTEM_FAILED, "cannot draw '%s': %s", name,
                                   cairo_status_to_string(cairo_status(made->context)));
        fw_canvas_destroy(made);
        return status;
    }
    cairo_set_source_rgb(made->context, 1, 1, 1);
    cairo_paint(made->context);
    *canvas = made;
    return FW_OK;
}

void fw_canvas_enlarge(fw_canvas *canvas, double factor)
{
    cairo_scale(canvas->context, factor, factor);
}

fw_status fw_canvas_save(fw_canvas *canvas, fw_error *error)
{
    cairo_status_t status = cairo_status(canvas->context);
    if (!status && canvas->format == PNG) {
        status = cairo_surface_write_to_png_stream(canvas->surface, keep_bytes, &canvas->store);
        if (!status && !fw_canvas_add_dots(&canvas->store, canvas->resolution))
            status = CAIRO_STATUS_NO_MEMORY;
    } else if (!status) {
        cairo_surface_finish(canvas->surface);
        status = cairo_surface_status(canvas->surface);
    }
    if (status == CAIRO_STATUS_NO_MEMORY) return fw_fail_memory(error, "a picture");
    if (status) {
        return fw_fail(error, FW_SYSTEM_FAILED, "cannot draw '%s': %s", canvas->name,
                       cairo_status_to_string(status));
    }
    return fw_whole_file_write(canvas->name, canvas->store.bytes, canvas->store.count, error);
}

void fw_canvas_destroy(fw_canvas *canvas)
{
    if (!canvas) return;
    if (canvas->page) fw_canvas_raster_end(canvas);
    cairo_destroy(canvas->context);
    cairo_surface_destroy(canvas->surface);
    free(canvas->store.bytes);
    free(canvas->name);
    free(canvas);
}

static bool is_finite(fw_vec2 point)
{
    return isfinite(point.x) && isfinite(point.y);
}

fw_vec2 fw_canvas_within_reach(fw_vec2 point)
{
    return (fw_vec2){fmin(fmax(point.x, -FW_CANVAS_FARTHEST), FW_CANVAS_FARTHEST),
                     fmin(fmax(point.y, -FW_CANVAS_FARTHEST), FW_CANVAS_FARTHEST)};
}

void fw_canvas_set_colour(fw_canvas *canvas, fw_colour colour)
{
    cairo_set_source_rgba(canvas->context, colour.red, colour.green, colour.blue, colour.alpha);
}

static void move_to(fw_canvas *canvas, fw_vec2 point)
{
    point = fw_canvas_within_reach(point);
    cairo_move_to(canvas->context, point.x, point.y);
}

static void line_to(fw_canvas *canvas, fw_vec2 point)
{
    point = fw_canvas_within_reach(point);
    cairo_line_to(canvas->context, point.x, point.y);
}

static void stroke_path(fw_canvas *canvas, fw_stroke stroke)
{
    double dashes[2] = {1.8, 1.1}, dots[2] = {.35, .75};
    fw_canvas_set_colour(canvas, stroke.colour);
    cairo_set_line_width(canvas->context, stroke.width);
    if (stroke.dash == FW_DASH_NONE) {
        cairo_set_dash(canvas->context, NULL, 0, 0);
    } else {
        cairo_set_dash(canvas->context, stroke.dash == FW_DASH_LONG ? dashes : dots, 2, 0);
    }
    cairo_stroke(canvas->context);
}

void fw_canvas_line(fw_canvas *canvas, fw_vec2 from, fw_vec2 to, fw_stroke stroke)
{
    fw_canvas_segments(canvas, (fw_vec2[]){from, to}, 1, stroke);
}

void fw_canvas_polyline(fw_canvas *canvas, const fw_vec2 *points, int count, bool closed,
                        fw_stroke stroke)
{
    bool down = false;
    for (int k = 0; k < count; ++k) {
        if (!is_finite(points[k])) {
            down = closed = false;
        } else if (down) {
            line_to(canvas, points[k]);
        } else {
            move_to(canvas, points[k]);
            down = true;
        }
    }
    if (closed) cairo_close_path(canvas->context);
    stroke_path(canvas, stroke);
}

void fw_canvas_segments(fw_canvas *canvas, const fw_vec2 *points, int count, fw_stroke stroke)
{
    /* Cairo's time to stroke a path grows faster than its length. */
    const int together = 128;
    for (int k = 0; k < count; ++k) {
        if (is_finite(points[2 * k]) && is_finite(points[2 * k + 1])) {
            move_to(canvas, points[2 * k]);
            line_to(canvas, points[2 * k + 1]);
        }
        if (k % together == together - 1) stroke_path(canvas, stroke);
    }
    stroke_path(canvas, stroke);
}

void fw_canvas_polygon(fw_canvas *canvas, const fw_vec2 *points, int count, fw_colour fill,
                       double rim)
{
    for (int k = 0; k < count; ++k) {
        if (!is_finite(points[k])) return;
    }
    for (int k = 0; k < count; ++k) {
        if (k == 0) {
            move_to(canvas, points[k]);
        } else {
            line_to(canvas, points[k]);
        }
    }
    cairo_close_path(canvas->context);
    fw_canvas_set_colour(canvas, fill);
    if (rim > 0) {
        cairo_fill_preserve(canvas->context);
        stroke_path(canvas, (fw_stroke){fill, rim, FW_DASH_NONE});
    } else {
        cairo_fill(canvas->context);
    }
}

void fw_canvas_rectangle(fw_canvas *canvas, fw_rect rect, fw_colour fill)
{
    cairo_rectangle(canvas->context, rect.left, rect.top, rect.width, rect.height);
    fw_canvas_set_colour(canvas, fill);
    cairo_set_antialias(canvas->context, CAIRO_ANTIALIAS_NONE);
    cairo_fill(canvas->context);
    cairo_set_antialias(canvas->context, CAIRO_ANTIALIAS_DEFAULT);
}

void fw_canvas_frame(fw_canvas *canvas, fw_rect rect, fw_stroke stroke)
{
    cairo_rectangle(canvas->context, rect.left, rect.top, rect.width, rect.height);
    stroke_path(canvas, stroke);
}

static bool trace_circle(fw_canvas *canvas, fw_vec2 centre, double radius)
{
    if (!is_finite(centre) || !(radius > 0 && radius <= FW_CANVAS_FARTHEST)) return false;
    centre = fw_canvas_within_reach(centre);
    cairo_new_sub_path(canvas->context);
    cairo_arc(canvas->context, centre.x, centre.y, radius, 0, 2 * M_PI);
    cairo_close_path(canvas->context);
    return true;
}

void fw_canvas_disc(fw_canvas *canvas, fw_vec2 centre, double radius, fw_colour fill)
{
    if (!trace_circle(canvas, centre, radius)) return;
    fw_canvas_set_colour(canvas, fill);
    cairo_fill(canvas->context);
}

void fw_canvas_circle(fw_canvas *canvas, fw_vec2 centre, double radius, fw_stroke stroke)
{
    if (trace_circle(canvas, centre, radius)) stroke_path(canvas, stroke);
}

void fw_canvas_annulus(fw_canvas *canvas, fw_vec2 centre, double inner, double outer,
                       fw_colour fill)
{
    cairo_set_fill_rule(canvas->context, CAIRO_FILL_RULE_EVEN_ODD);
    trace_circle(canvas, centre, inner);
    trace_circle(canvas, centre, outer);
    fw_canvas_set_colour(canvas, fill);
    cairo_fill(canvas->context);
    cairo_set_fill_rule(canvas->context, CAIRO_FILL_RULE_WINDING);
}

void fw_canvas_arrow(fw_canvas *canvas, fw_vec2 from, fw_vec2 to, fw_stroke stroke, double head)
{
    fw_vec2 along = fw_vec2_subtract(to, from);
    double length = hypot(along.x, along.y);
    if (!isfinite(length) || length <= 0) return;
    head = fmin(head, .7 * length);
    along = fw_vec2_scale(1 / length, along);
    fw_vec2 across = fw_vec2_scale(.38 * head, fw_vec2_turn(along));
    fw_vec2 back = fw_vec2_subtract(to, fw_vec2_scale(head, along));
    fw_vec2 neck = fw_vec2_subtract(to, fw_vec2_scale(.8 * head, along));
    fw_canvas_line(canvas, from, neck, stroke);
    fw_vec2 tip[4] = {to, fw_vec2_add(back, across), neck, fw_vec2_subtract(back, across)};
    fw_canvas_polygon(canvas, tip, 4, stroke.colour, 0);
}

void fw_canvas_clip(fw_canvas *canvas, fw_rect rect)
{
    cairo_rectangle(canvas->context, rect.left, rect.top, rect.width, rect.height);
    cairo_clip(canvas->context);
}

void fw_canvas_unclip(fw_canvas *canvas)
{
    cairo_reset_clip(canvas->context);
}

void fw_canvas_raster_begin(fw_canvas *canvas, fw_rect rect)
{
    if (canvas->format == PNG || canvas->page) return;
    cairo_surface_t *image =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels(rect.width, canvas->resolution),
                                   pixels(rect.height, canvas->resolution));
    canvas->page = canvas->context;
    canvas->raster = rect;
    canvas->context = fw_canvas_context(image, canvas->resolution / mm_per_inch);
    cairo_translate(canvas->context, -rect.left, -rect.top);
    cairo_surface_destroy(image);
}

void fw_canvas_raster_end(fw_canvas *canvas)
{
    if (!canvas->page) return;
    cairo_surface_t *image = cairo_surface_reference(cairo_get_target(canvas->context));
    cairo_destroy(canvas->context);
    canvas->context = canvas->page;
    canvas->page = NULL;
    double mm_per_pixel = mm_per_inch / canvas->resolution;
    cairo_save(canvas->context);
    cairo_translate(canvas->context, canvas->raster.left, canvas->raster.top);
    cairo_scale(canvas->context, mm_per_pixel, mm_per_pixel);
    cairo_set_source_surface(canvas->context, image, 0, 0);
    cairo_paint(canvas->context);
    cairo_restore(canvas->context);
    cairo_surface_destroy(image);
}

fw_colour fw_canvas_colour_at(fw_canvas *canvas, fw_vec2 at)
{
    if (canvas->format != PNG) return (fw_colour){0, 0, 0, 0};
    cairo_surface_flush(canvas->surface);
    int column = (int)(at.x / mm_per_inch * canvas->resolution);
    int row = (int)(at.y / mm_per_inch * canvas->resolution);
    if (column < 0 || row < 0 || column >= cairo_image_surface_get_width(canvas->surface) ||
        row >= cairo_image_surface_get_height(canvas->surface)) {
        return (fw_colour){0, 0, 0, 0};
    }
    const unsigned char *line = cairo_image_surface_get_data(canvas->surface) +
                                (ptrdiff_t)row * cairo_image_surface_get_stride(canvas->surface);
    uint32_t pixel;
    memcpy(&pixel, line + 4 * column, sizeof pixel);
    return (fw_colour){(pixel >> 16 & 255) / 255., (pixel >> 8 & 255) / 255., (pixel & 255) / 255.,
                       1};
}
