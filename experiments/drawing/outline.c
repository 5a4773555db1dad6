/* SPDX-License-Identifier: GPL-3.0-or-later */
/* outline.c - outlines and their forbidden sides.
 * Keeps no state. Start reading at fw_outline_draw_forbidden(). */
#include "experiments/drawing/outline.h"

#include <math.h>

static int edge_count(const fw_outline *outline)
{
    return outline->closed ? outline->count : outline->count - 1;
}

void fw_outline_include(const fw_outline *outline, fw_range *x, fw_range *y)
{
    const double reach = outline->radius;
    for (int k = 0; k < outline->count; ++k) {
        fw_vec2 p = fw_vec2_add(outline->points[k], outline->displacement);
        fw_range_include(x, (double[]){p.x - reach, p.x + reach}, 2, false);
        fw_range_include(y, (double[]){p.y - reach, p.y + reach}, 2, false);
    }
}

/* Point k, counted round, on the paper. */
static fw_vec2 place_of(const fw_outline *outline, const fw_panel *panel, int k)
{
    const int number = (k + outline->count) % outline->count;
    const fw_vec2 p = fw_vec2_add(outline->points[number], outline->displacement);
    return fw_panel_place(panel, p.x, p.y);
}

/* +1 where the forbidden side lies to the right (in the plane) walking along the points. */
static double forbidden_side(const fw_outline *outline)
{
    if (outline->forbidden == FW_FORBIDDEN_RIGHT) return 1;
    double area = 0; /* twice the signed area */
    for (int k = 0; k < outline->count; ++k) {
        fw_vec2 a = fw_vec2_subtract(outline->points[k], outline->points[0]);
        fw_vec2 b = fw_vec2_subtract(outline->points[(k + 1) % outline->count], outline->points[0]);
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

/* From point k to the far rim of a band that is |side| wide: mitred, but not longer than five
 * times that. */
static fw_vec2 rim_offset(const fw_outline *outline, const fw_panel *panel, int k, double side)
{
    const bool closed = outline->closed;
    fw_vec2 here = place_of(outline, panel, k);
    fw_vec2 before = {0, 0}, after = {0, 0};
    if (closed || k > 0) before = rightward(place_of(outline, panel, k - 1), here);
    if (closed || k < outline->count - 1) after = rightward(here, place_of(outline, panel, k + 1));
    if (!closed && k == 0) before = after;
    if (!closed && k == outline->count - 1) after = before;
    double widening = fmax(1 + fw_vec2_dot(before, after), .2);
    return fw_vec2_scale(side / widening, fw_vec2_add(before, after));
}

static void draw_band(const fw_outline *outline, const fw_panel *panel, fw_colour grey,
                      double width)
{
    double side = width * forbidden_side(outline);
    for (int k = 0; k < edge_count(outline); ++k) {
        int next = (k + 1) % outline->count;
        fw_vec2 a = place_of(outline, panel, k), b = place_of(outline, panel, next);
        fw_vec2 quad[4] = {a, b, fw_vec2_add(b, rim_offset(outline, panel, next, side)),
                           fw_vec2_add(a, rim_offset(outline, panel, k, side))};
        /* A rim closes the seams between opaque quads; between others it would show. */
        fw_canvas_polygon(panel->canvas, quad, 4, grey, grey.alpha < 1 ? 0 : .05);
    }
}

/* A fan of triangles fills a convex inside. */
static void draw_inside(const fw_outline *outline, const fw_panel *panel, fw_colour grey)
{
    fw_vec2 first = place_of(outline, panel, 0);
    for (int k = 1; k + 1 < outline->count; ++k) {
        fw_vec2 triangle[3] = {first, place_of(outline, panel, k), place_of(outline, panel, k + 1)};
        fw_canvas_polygon(panel->canvas, triangle, 3, grey, grey.alpha < 1 ? 0 : .3);
    }
}

void fw_outline_draw_forbidden(const fw_outline *outline, const fw_panel *panel, double opacity,
                               double width)
{
    const fw_colour grey = {.86, .86, .86, opacity};
    if (outline->radius > 0) {
        double radius = outline->radius * fw_panel_scale(panel);
        fw_vec2 centre = place_of(outline, panel, 0);
        if (outline->forbidden == FW_FORBIDDEN_INSIDE)
            fw_canvas_disc(panel->canvas, centre, radius, grey);
        else
            fw_canvas_annulus(panel->canvas, centre, radius, radius + width, grey);
    } else if (outline->forbidden == FW_FORBIDDEN_INSIDE) {
        draw_inside(outline, panel, grey);
    } else {
        draw_band(outline, panel, grey, width);
    }
}

void fw_outline_draw(const fw_outline *outline, const fw_panel *panel, fw_stroke line)
{
    if (outline->radius > 0) {
        fw_canvas_circle(panel->canvas, place_of(outline, panel, 0),
                         outline->radius * fw_panel_scale(panel), line);
        return;
    }
    const int edges = edge_count(outline);
    for (int edge = 0; edge < edges; ++edge) {
        bool goes_on = outline->closed || edge + 1 < edges;
        /* With the next edge, for the sake of the corner between them. */
        fw_vec2 path[3] = {place_of(outline, panel, edge), place_of(outline, panel, edge + 1),
                           place_of(outline, panel, edge + (goes_on ? 2 : 1))};
        fw_canvas_polyline(panel->canvas, path, goes_on ? 3 : 2, false, line);
    }
}
