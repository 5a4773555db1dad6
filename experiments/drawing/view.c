/* SPDX-License-Identifier: GPL-3.0-or-later */
/* view.c - bodies and walls on a panel.
 * Keeps no state. Invariant: drawn in index order, so that the same view is the same picture. Start
 * reading at fw_view_draw_particles(). */
#include "experiments/drawing/view.h"

#include "experiments/drawing/tiles.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

fw_view_bounds fw_view_bounds_empty(void)
{
    return (fw_view_bounds){fw_range_empty(), fw_range_empty()};
}

bool fw_view_bounds_are_unset(fw_view_bounds bounds)
{
    return bounds.x.low == 0 && bounds.x.high == 0 && bounds.y.low == 0 && bounds.y.high == 0;
}

fw_view_bounds fw_view_bounds_or_empty(fw_view_bounds bounds)
{
    return fw_view_bounds_are_unset(bounds) ? fw_view_bounds_empty() : bounds;
}

void fw_view_print_name(const fw_view *view, char *text, size_t size)
{
    char step[32];
    fw_ticks_print_number(step, sizeof step, (double)view->step, 15);
    if (view->name)
        snprintf(text, size, "%s", view->name);
    else
        snprintf(text, size, "step %s", step);
}

double fw_view_spacing(const fw_view_body *body)
{
    if (body->spacing > 0) return body->spacing;
    double sum = 0;
    int summed = 0;
    for (int k = 0; k < body->link_count; ++k) {
        int a = body->links[2 * k], b = body->links[2 * k + 1];
        double length = hypot(body->x[a] - body->x[b], body->y[a] - body->y[b]);
        if (!isfinite(length)) continue;
        sum += length;
        summed += 1;
    }
    return summed > 0 && sum > 0 ? sum / summed : 1;
}

long fw_view_count(const fw_view *view)
{
    long count = 0;
    for (int k = 0; k < view->body_count; ++k) count += view->bodies[k].count;
    return count;
}

void fw_view_bounds_include_bodies(fw_view_bounds *bounds, const fw_view *view)
{
    for (int k = 0; k < view->body_count; ++k) {
        const fw_view_body *body = &view->bodies[k];
        double room = .75 * fw_view_spacing(body);
        fw_range x = fw_range_empty(), y = fw_range_empty();
        fw_range_include(&x, body->x, body->count, false);
        fw_range_include(&y, body->y, body->count, false);
        if (fw_range_is_empty(x) || fw_range_is_empty(y)) continue;
        fw_range_include(&bounds->x, (double[]){x.low - room, x.high + room}, 2, false);
        fw_range_include(&bounds->y, (double[]){y.low - room, y.high + room}, 2, false);
    }
}

/* Widens a range by that of a wall, as long as the whole takes no more than `most`. Of a larger one
 * a fifteenth of that is shown, from where it goes on beyond the bodies, or from its near edge;
 * what is further away is left out. */
static void include_near(fw_range *range, fw_range bodies, fw_range wall, double most)
{
    fw_range both = bodies;
    fw_range_include(&both, (double[]){wall.low, wall.high}, 2, false);
    if (both.high - both.low > most) {
        const fw_range near = {fmin(bodies.low, wall.high), fmax(bodies.high, wall.low)};
        if (near.high - near.low > most) return;
        wall = (fw_range){fmax(wall.low, near.low - most / 15),
                          fmin(wall.high, near.high + most / 15)};
    }
    fw_range_include(range, (double[]){wall.low, wall.high}, 2, false);
}

/* The bodies take at least a third of it, or their particles are well apart. */
static double largest_frame(fw_view_bounds bodies, const fw_view *view)
{
    double most = 3 * fmax(bodies.x.high - bodies.x.low, bodies.y.high - bodies.y.low);
    for (int b = 0; b < view->body_count; ++b)
        most = fmax(most, 30 * fw_view_spacing(&view->bodies[b]));
    return most >= 0 ? most : INFINITY;
}

/* Along x and y by themselves: of a floor without end, the height is worth showing. */
void fw_view_bounds_include_walls(fw_view_bounds *bounds, const fw_view *views, int view_count)
{
    const fw_view_bounds bodies = *bounds;
    for (int v = 0; v < view_count; ++v) {
        const double most = largest_frame(bodies, &views[v]);
        for (int k = 0; k < views[v].wall_count; ++k) {
            fw_view_bounds wall = fw_view_bounds_empty();
            fw_outline_include(&views[v].walls[k], &wall.x, &wall.y);
            include_near(&bounds->x, bodies.x, wall.x, most);
            include_near(&bounds->y, bodies.y, wall.y, most);
        }
    }
}

/* --- walls --- */

void fw_view_draw_walls(const fw_view *view, const fw_panel *panel, bool cells, double opacity)
{
    double width = 2.2; /* mm, or what cells of the boundary take */
    for (int b = 0; b < view->body_count && cells; ++b)
        width = fmax(width, .55 * fw_view_spacing(&view->bodies[b]) * fw_panel_scale(panel));
    for (int k = 0; k < view->wall_count; ++k)
        fw_outline_draw_forbidden(&view->walls[k], panel, opacity, width);
}

void fw_view_draw_surfaces(const fw_view *view, const fw_panel *panel)
{
    const fw_stroke surface = {{.25, .25, .25, 1}, .35, FW_DASH_NONE};
    for (int k = 0; k < view->wall_count; ++k) fw_outline_draw(&view->walls[k], panel, surface);
}

void fw_view_draw_moved(const fw_view *view, const fw_view *last, const fw_panel *panel,
                        fw_stroke stroke)
{
    for (int k = 0; k < view->wall_count; ++k) {
        const fw_vec2 from = view->walls[k].displacement, to = last->walls[k].displacement;
        if (from.x != to.x || from.y != to.y) fw_outline_draw(&view->walls[k], panel, stroke);
    }
}

/* --- bodies --- */

void fw_view_draw_links(const fw_view_body *body, const fw_panel *panel, fw_stroke stroke)
{
    enum { TOGETHER = 128 };
    fw_vec2 ends[2 * TOGETHER];
    int filled = 0;
    for (int k = 0; k < body->link_count; ++k) {
        int a = body->links[2 * k], b = body->links[2 * k + 1];
        ends[2 * filled] = fw_panel_place(panel, body->x[a], body->y[a]);
        ends[2 * filled + 1] = fw_panel_place(panel, body->x[b], body->y[b]);
        if (++filled < TOGETHER && k + 1 < body->link_count) continue;
        fw_canvas_segments(panel->canvas, ends, filled, stroke);
        filled = 0;
    }
}

void fw_view_draw_discs(const fw_view_body *body, const fw_panel *panel, double radius,
                        fw_colour colour)
{
    for (int k = 0; k < body->count; ++k) {
        fw_canvas_disc(panel->canvas, fw_panel_place(panel, body->x[k], body->y[k]), radius,
                       colour);
    }
}

static fw_colour colour_of(const fw_view_body *body, int particle, const fw_colour_scale *scale)
{
    if (scale) return fw_colour_scale_at(scale, body->field ? body->field[particle] : NAN);
    return fw_palette_kind(body->species ? body->species[particle] : body->kind);
}

static void draw_as_discs(const fw_view *view, const fw_panel *panel, const fw_colour_scale *scale)
{
    for (int b = 0; b < view->body_count; ++b) {
        const fw_view_body *body = &view->bodies[b];
        double radius = fmax(.5 * fw_view_spacing(body) * fw_panel_scale(panel), .12);
        for (int k = 0; k < body->count; ++k) {
            fw_canvas_disc(panel->canvas, fw_panel_place(panel, body->x[k], body->y[k]), radius,
                           colour_of(body, k, scale));
        }
    }
}

/* A reach of 1/sqrt 2 spacings just closes the square lattice (the hexagonal one needs 1/sqrt 3).
 */
static const double cell_reach = .72;

static void draw_cell(const fw_tiles *tiles, int number, double reach, const fw_panel *panel,
                      fw_colour colour)
{
    fw_vec2 corners[FW_TILE_CORNERS];
    const int count = fw_tiles_corners_within(tiles, number, reach, corners);
    for (int c = 0; c < count; ++c) corners[c] = fw_panel_place(panel, corners[c].x, corners[c].y);
    /* A rim closes the seams between opaque cells; between others it would show. */
    if (count > 2)
        fw_canvas_polygon(panel->canvas, corners, count, colour, colour.alpha < 1 ? 0 : .08);
}

/* All bodies together, so that cells meet where bodies touch. */
static fw_status draw_as_cells(const fw_view *view, const fw_panel *panel,
                               const fw_colour_scale *scale, fw_error *error)
{
    int count = (int)fw_view_count(view), filled = 0;
    double reach = 0;
    fw_vec2 *points = malloc(((size_t)count + 1) * sizeof *points);
    if (!points) return fw_fail_memory(error, "the particles of a picture");
    for (int b = 0; b < view->body_count; ++b) {
        const fw_view_body *body = &view->bodies[b];
        reach = fmax(reach, cell_reach * fw_view_spacing(body));
        for (int k = 0; k < body->count; ++k) points[filled++] = (fw_vec2){body->x[k], body->y[k]};
    }
    fw_tiles *tiles = NULL;
    fw_status status = fw_tiles_create(&tiles, points, count, fmax(reach, 1e-300), error);
    int number = 0;
    for (int b = 0; b < view->body_count && status == FW_OK; ++b) {
        const double own = cell_reach * fw_view_spacing(&view->bodies[b]);
        for (int k = 0; k < view->bodies[b].count; ++k, ++number)
            draw_cell(tiles, number, own, panel, colour_of(&view->bodies[b], k, scale));
    }
    fw_tiles_destroy(tiles);
    free(points);
    return status;
}

fw_status fw_view_draw_silhouette(const fw_view_body *body, const fw_panel *panel, fw_colour colour,
                                  fw_error *error)
{
    fw_vec2 *points = malloc(((size_t)body->count + 1) * sizeof *points);
    if (!points) return fw_fail_memory(error, "the particles of a picture");
    for (int k = 0; k < body->count; ++k) points[k] = (fw_vec2){body->x[k], body->y[k]};
    fw_tiles *tiles = NULL;
    const double reach = cell_reach * fw_view_spacing(body);
    fw_status status = fw_tiles_create(&tiles, points, body->count, reach, error);
    for (int k = 0; k < body->count && status == FW_OK; ++k)
        draw_cell(tiles, k, reach, panel, colour);
    fw_tiles_destroy(tiles);
    free(points);
    return status;
}

fw_status fw_view_draw_particles(const fw_view *view, const fw_panel *panel, fw_view_look look,
                                 const fw_colour_scale *scale, fw_error *error)
{
    const long vectors_max = 6000; /* beyond, SVG and PDF files get slow to open */
    fw_status status = FW_OK;
    bool raster = fw_view_count(view) > vectors_max;
    if (raster) fw_canvas_raster_begin(panel->canvas, panel->box);
    if (look == FW_VIEW_CELLS) {
        status = draw_as_cells(view, panel, scale, error);
    } else {
        draw_as_discs(view, panel, scale);
    }
    if (raster) fw_canvas_raster_end(panel->canvas);
    return status;
}
