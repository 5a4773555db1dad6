/* SPDX-License-Identifier: GPL-3.0-or-later */
/* view.c - bodies and walls on a panel.
 * Keeps no state. Invariant: drawn in index order, so that the same view is the same picture. Start
 * reading at fw_view_draw_particles(). */
#include "experiments/drawing/view.h"

#include "experiments/drawing/tiles.h"

#include <math.h>
#include <stdlib.h>

fw_view_bounds fw_view_bounds_empty(void)
{
    return (fw_view_bounds){fw_range_empty(), fw_range_empty()};
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

static fw_view_bounds bounds_of_wall(const fw_view_wall *wall)
{
    fw_view_bounds bounds = fw_view_bounds_empty();
    const fw_wall_def *def = wall->def;
    double reach = def->shape == FW_CIRCLE ? def->radius : 0;
    for (int k = 0; k < def->point_count; ++k) {
        fw_vec2 p = fw_vec2_add(def->points[k], wall->displacement);
        fw_range_include(&bounds.x, (double[]){p.x - reach, p.x + reach}, 2, false);
        fw_range_include(&bounds.y, (double[]){p.y - reach, p.y + reach}, 2, false);
    }
    return bounds;
}

/* Widens a range by that of a wall, unless the wall and the bodies are more than `most` apart. */
static void include_near(fw_range *range, fw_range bodies, fw_range wall, double most)
{
    const double ends[2] = {wall.low, wall.high};
    fw_range_include(&bodies, ends, 2, false);
    if (bodies.high - bodies.low <= most) fw_range_include(range, ends, 2, false);
}

/* Along x and y by themselves: of a floor without end, the height is worth showing. */
void fw_view_bounds_include_walls(fw_view_bounds *bounds, const fw_view *view, double most)
{
    const fw_view_bounds bodies = *bounds;
    double extent = fmax(bodies.x.high - bodies.x.low, bodies.y.high - bodies.y.low);
    double longest = extent >= 0 ? most * extent : INFINITY;
    for (int k = 0; k < view->wall_count; ++k) {
        fw_view_bounds wall = bounds_of_wall(&view->walls[k]);
        include_near(&bounds->x, bodies.x, wall.x, longest);
        include_near(&bounds->y, bodies.y, wall.y, longest);
    }
}

/* --- walls --- */

static const double band = 2.2; /* mm */
static const fw_colour forbidden = {.86, .86, .86, 1};
static const fw_colour surface = {.25, .25, .25, 1};

static int corner_count(const fw_wall_def *def)
{
    return def->shape == FW_BOX ? 4 : def->point_count;
}

static bool is_closed(const fw_wall_def *def)
{
    return def->shape != FW_CHAIN || def->closed;
}

/* Is all of the inside forbidden? */
static bool is_obstacle(const fw_wall_def *def)
{
    return def->shape != FW_CHAIN && def->side == FW_OUTSIDE;
}

/* Corner k on the paper; boxes go counter-clockwise (in the plane) from their lower left one. */
static fw_vec2 corner_of(const fw_view_wall *wall, const fw_panel *panel, int k)
{
    const fw_wall_def *def = wall->def;
    fw_vec2 p;
    int count = corner_count(def);
    k = (k + count) % count;
    if (def->shape == FW_BOX) {
        fw_vec2 a = def->points[0], b = def->points[1];
        p.x = k == 1 || k == 2 ? fmax(a.x, b.x) : fmin(a.x, b.x);
        p.y = k >= 2 ? fmax(a.y, b.y) : fmin(a.y, b.y);
    } else {
        p = def->points[k];
    }
    return fw_panel_place(panel, p.x + wall->displacement.x, p.y + wall->displacement.y);
}

/* +1 where the forbidden side lies to the right (in the plane) walking along the corners. */
static double forbidden_side(const fw_view_wall *wall)
{
    const fw_wall_def *def = wall->def;
    if (def->shape != FW_POLYGON) return 1;
    double area = 0; /* twice the signed area */
    for (int k = 0; k < def->point_count; ++k) {
        fw_vec2 a = fw_vec2_subtract(def->points[k], def->points[0]);
        fw_vec2 b = fw_vec2_subtract(def->points[(k + 1) % def->point_count], def->points[0]);
        area += fw_vec2_cross(a, b);
    }
    return area > 0 ? 1 : -1;
}

/* Unit vector on the paper from the segment a-b to its right as seen in the plane. On paper y
 * points down: what turns clockwise in the plane turns counter-clockwise in these numbers. */
static fw_vec2 rightward(fw_vec2 a, fw_vec2 b)
{
    fw_vec2 along = fw_vec2_subtract(b, a);
    double length = hypot(along.x, along.y);
    return length > 0 ? fw_vec2_scale(1 / length, fw_vec2_turn(along)) : (fw_vec2){0, 0};
}

/* From corner k to the far rim of the band: mitred, but no longer than three bands. */
static fw_vec2 rim_offset(const fw_view_wall *wall, const fw_panel *panel, int k, double side)
{
    int count = corner_count(wall->def);
    bool closed = is_closed(wall->def);
    fw_vec2 here = corner_of(wall, panel, k);
    fw_vec2 before = {0, 0}, after = {0, 0};
    if (closed || k > 0) before = rightward(corner_of(wall, panel, k - 1), here);
    if (closed || k < count - 1) after = rightward(here, corner_of(wall, panel, k + 1));
    if (!closed && k == 0) before = after;
    if (!closed && k == count - 1) after = before;
    double widening = fmax(1 + fw_vec2_dot(before, after), .2);
    return fw_vec2_scale(side * band / widening, fw_vec2_add(before, after));
}

static void draw_band(const fw_view_wall *wall, const fw_panel *panel)
{
    int count = corner_count(wall->def), edges = is_closed(wall->def) ? count : count - 1;
    double side = forbidden_side(wall);
    for (int k = 0; k < edges; ++k) {
        int next = (k + 1) % count;
        fw_vec2 a = corner_of(wall, panel, k), b = corner_of(wall, panel, next);
        fw_vec2 quad[4] = {a, b, fw_vec2_add(b, rim_offset(wall, panel, next, side)),
                           fw_vec2_add(a, rim_offset(wall, panel, k, side))};
        fw_canvas_polygon(panel->canvas, quad, 4, forbidden, .05);
    }
}

/* All walls with an inside that is forbidden are convex: a fan of triangles fills them. */
static void draw_inside(const fw_view_wall *wall, const fw_panel *panel)
{
    fw_vec2 first = corner_of(wall, panel, 0);
    for (int k = 1; k + 1 < corner_count(wall->def); ++k) {
        fw_vec2 triangle[3] = {first, corner_of(wall, panel, k), corner_of(wall, panel, k + 1)};
        /* The rim closes the seams of the fan; outside it hides below the surface's line. */
        fw_canvas_polygon(panel->canvas, triangle, 3, forbidden, .3);
    }
}

void fw_view_draw_walls(const fw_view *view, const fw_panel *panel)
{
    for (int k = 0; k < view->wall_count; ++k) {
        const fw_view_wall *wall = &view->walls[k];
        if (wall->def->shape == FW_CIRCLE) {
            double radius = wall->def->radius * fw_panel_scale(panel);
            fw_vec2 centre = corner_of(wall, panel, 0);
            if (is_obstacle(wall->def)) {
                fw_canvas_disc(panel->canvas, centre, radius, forbidden);
            } else {
                fw_canvas_annulus(panel->canvas, centre, radius, radius + band, forbidden);
            }
        } else if (is_obstacle(wall->def)) {
            draw_inside(wall, panel);
        } else {
            draw_band(wall, panel);
        }
    }
}

static void draw_outline(const fw_view_wall *wall, const fw_panel *panel, fw_stroke line)
{
    if (wall->def->shape == FW_CIRCLE) {
        fw_canvas_circle(panel->canvas, corner_of(wall, panel, 0),
                         wall->def->radius * fw_panel_scale(panel), line);
        return;
    }
    int count = corner_count(wall->def), edges = is_closed(wall->def) ? count : count - 1;
    for (int edge = 0; edge < edges; ++edge) {
        bool goes_on = is_closed(wall->def) || edge + 1 < edges;
        /* With the next edge, for the sake of the corner between them. */
        fw_vec2 path[3] = {corner_of(wall, panel, edge), corner_of(wall, panel, edge + 1),
                           corner_of(wall, panel, edge + (goes_on ? 2 : 1))};
        fw_canvas_polyline(panel->canvas, path, goes_on ? 3 : 2, false, line);
    }
}

void fw_view_draw_surfaces(const fw_view *view, const fw_panel *panel)
{
    for (int k = 0; k < view->wall_count; ++k)
        draw_outline(&view->walls[k], panel, (fw_stroke){surface, .35, FW_DASH_NONE});
}

void fw_view_draw_moved(const fw_view *view, const fw_view *last, const fw_panel *panel,
                        fw_stroke stroke)
{
    for (int k = 0; k < view->wall_count; ++k) {
        const fw_vec2 from = view->walls[k].displacement, to = last->walls[k].displacement;
        if (from.x != to.x || from.y != to.y) draw_outline(&view->walls[k], panel, stroke);
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

/* All bodies together, so that cells meet where bodies touch. A reach of 1/sqrt 2 spacings just
 * closes the square lattice (the hexagonal one needs 1/sqrt 3). */
static fw_status draw_as_cells(const fw_view *view, const fw_panel *panel,
                               const fw_colour_scale *scale, fw_error *error)
{
    int count = (int)fw_view_count(view), filled = 0;
    double reach = 0;
    fw_vec2 *points = malloc(((size_t)count + 1) * sizeof *points);
    if (!points) return fw_fail_memory(error, "the particles of a picture");
    for (int b = 0; b < view->body_count; ++b) {
        const fw_view_body *body = &view->bodies[b];
        reach = fmax(reach, .72 * fw_view_spacing(body));
        for (int k = 0; k < body->count; ++k) points[filled++] = (fw_vec2){body->x[k], body->y[k]};
    }
    fw_tiles *tiles = NULL;
    fw_status status = fw_tiles_create(&tiles, points, count, fmax(reach, 1e-300), error);
    int number = 0;
    for (int b = 0; b < view->body_count && status == FW_OK; ++b) {
        for (int k = 0; k < view->bodies[b].count; ++k, ++number) {
            fw_vec2 corners[FW_TILE_CORNERS];
            int corner_count = fw_tiles_corners(tiles, number, corners);
            for (int c = 0; c < corner_count; ++c) {
                corners[c] = fw_panel_place(panel, corners[c].x, corners[c].y);
            }
            if (corner_count > 2) {
                fw_canvas_polygon(panel->canvas, corners, corner_count,
                                  colour_of(&view->bodies[b], k, scale), .08);
            }
        }
    }
    fw_tiles_destroy(tiles);
    free(points);
    return status;
}

fw_status fw_view_draw_particles(const fw_view *view, const fw_panel *panel, fw_view_look look,
                                 const fw_colour_scale *scale, fw_error *error)
{
    const long vectors_most = 6000; /* beyond, SVG and PDF files get slow to open */
    fw_status status = FW_OK;
    bool raster = fw_view_count(view) > vectors_most;
    if (raster) fw_canvas_raster_begin(panel->canvas, panel->box);
    if (look == FW_VIEW_CELLS) {
        status = draw_as_cells(view, panel, scale, error);
    } else {
        draw_as_discs(view, panel, scale);
    }
    if (raster) fw_canvas_raster_end(panel->canvas);
    return status;
}
