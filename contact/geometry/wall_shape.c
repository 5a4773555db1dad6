/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_shape.c - what the shapes of walls do: of each its check_, count_, build_ and outline_.
 * Keeps no state. Invariant: every straight facet is free to its left. Start reading at
 * fw_wall_shapes. */
#include "contact/geometry/wall.h"

#include <float.h>
#include <math.h>

/* A side shorter than this share of its coordinates has no direction to speak of. */
static const double shortest_share = 1e-9;

static const char *name_of(const fw_wall_def *def)
{
    return def->name ? def->name : "";
}

static double magnitude(fw_vec2 point)
{
    return fmax(fabs(point.x), fabs(point.y));
}

/* Facets along the corners; counter-clockwise they are free inside. */
static void build_loop(const fw_wall_def *def, int wall, double swing, const fw_vec2 *corners,
                       int count, bool counter_clockwise, fw_facet *facets)
{
    const bool forward = counter_clockwise == (def->side == FW_INSIDE);
    for (int i = 0; i < count; ++i) {
        const fw_vec2 p = corners[i], q = corners[(i + 1) % count];
        facets[i] =
            forward ? fw_facet_straight(wall, p, q, swing) : fw_facet_straight(wall, q, p, swing);
    }
}

/* --- box --- */

static fw_status check_box(const fw_wall_def *def, fw_error *error)
{
    fw_vec2 p = def->points[0], q = def->points[1];
    double least = shortest_share * fmax(magnitude(p), magnitude(q));
    if (fabs(p.x - q.x) > least && fabs(p.y - q.y) > least) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "wall '%s': the box from [%.12g, %.12g] to [%.12g, %.12g] is empty, expected "
                   "corners that differ in x and in y",
                   name_of(def), p.x, p.y, q.x, q.y);
}

static int count_box(const fw_wall_def *def)
{
    (void)def;
    return 4;
}

/* Counter-clockwise. */
static fw_wall_line outline_box(const fw_wall_def *def, fw_vec2 corners[FW_WALL_CORNERS_MAX])
{
    const fw_vec2 p = def->points[0], q = def->points[1];
    const fw_vec2 low = {fmin(p.x, q.x), fmin(p.y, q.y)}, high = {fmax(p.x, q.x), fmax(p.y, q.y)};
    corners[0] = low;
    corners[1] = (fw_vec2){high.x, low.y};
    corners[2] = high;
    corners[3] = (fw_vec2){low.x, high.y};
    return (fw_wall_line){.points = corners, .count = 4, .closed = true};
}

static void build_box(const fw_wall_def *def, int wall, double swing, fw_facet *facets)
{
    fw_vec2 corners[FW_WALL_CORNERS_MAX];
    outline_box(def, corners);
    build_loop(def, wall, swing, corners, 4, true, facets);
}

/* --- chain --- */

/* Neighbours in the list, and the last and the first if `closed`, must not coincide. */
static fw_status check_loop(const fw_wall_def *def, bool closed, fw_error *error)
{
    for (int i = 0; i < def->point_count - !closed; ++i) {
        int next = (i + 1) % def->point_count;
        fw_vec2 p = def->points[i], q = def->points[next];
        double distance = hypot(q.x - p.x, q.y - p.y);
        double least = fmax(shortest_share * fmax(magnitude(p), magnitude(q)), DBL_MIN);
        if (distance < least)
            return fw_fail(error, FW_BAD_INPUT,
                           "wall '%s': points %d and %d, [%.17g, %.17g] and [%.17g, %.17g], are "
                           "%g apart, expected at least %g",
                           name_of(def), i + 1, next + 1, p.x, p.y, q.x, q.y, distance, least);
    }
    return FW_OK;
}

static fw_status check_chain(const fw_wall_def *def, fw_error *error)
{
    return check_loop(def, def->closed, error);
}

static int count_chain(const fw_wall_def *def)
{
    return def->point_count - !def->closed;
}

static void build_chain(const fw_wall_def *def, int wall, double swing, fw_facet *facets)
{
    const fw_vec2 *p = def->points;
    for (int i = 0; i < count_chain(def); ++i)
        facets[i] = fw_facet_straight(wall, p[i], p[(i + 1) % def->point_count], swing);
}

static fw_wall_line outline_chain(const fw_wall_def *def, fw_vec2 *corners)
{
    (void)corners;
    return (fw_wall_line){.points = def->points, .count = def->point_count, .closed = def->closed};
}

/* --- polygon --- */

/* Convex: every corner turns the same way, and all turns together make one turn (a pentagram
 * makes two). Corners of 180 degrees are allowed. */
static fw_status check_polygon(const fw_wall_def *def, fw_error *error)
{
    FW_TRY(check_loop(def, true, error));
    const int count = def->point_count;
    const fw_vec2 *p = def->points;
    double area = 0, circumference = 0, turned = 0;
    for (int i = 0; i < count; ++i) {
        fw_vec2 from_first = fw_vec2_subtract(p[i], p[0]);
        fw_vec2 side = fw_vec2_subtract(p[(i + 1) % count], p[i]);
        area += fw_vec2_cross(from_first, side) / 2;
        circumference += hypot(side.x, side.y);
    }
    if (fabs(area) <= shortest_share * circumference * circumference)
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the polygon of %d corners has an area of %g at a circumference "
                       "of %g, expected corners that do not lie on a line",
                       name_of(def), count, fabs(area), circumference);
    for (int i = 0; i < count; ++i) {
        fw_vec2 corner = p[(i + 1) % count];
        fw_vec2 before = fw_vec2_subtract(corner, p[i]);
        fw_vec2 after = fw_vec2_subtract(p[(i + 2) % count], corner);
        double turn =
            atan2(copysign(1, area) * fw_vec2_cross(before, after), fw_vec2_dot(before, after));
        /* What rounding makes of 180 degrees, seen from either side, is a straight corner. */
        if (turn < -shortest_share || turn > 3.14159265)
            return fw_fail(error, FW_BAD_INPUT,
                           "wall '%s': the polygon is not convex at corner %d, [%.12g, %.12g]; a "
                           "closed chain can have any corners",
                           name_of(def), (i + 1) % count + 1, corner.x, corner.y);
        turned += turn;
    }
    if (turned > 7) /* one turn is 6.28, two are 12.57 */
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the polygon of %d corners winds around itself %.0f times, "
                       "expected once",
                       name_of(def), count, turned / FW_TWO_PI);
    return FW_OK;
}

static bool is_counter_clockwise(const fw_vec2 *corners, int count)
{
    double twice_area = 0;
    for (int i = 1; i < count - 1; ++i)
        twice_area += fw_vec2_cross(fw_vec2_subtract(corners[i], corners[0]),
                                    fw_vec2_subtract(corners[i + 1], corners[0]));
    return twice_area > 0;
}

static int count_polygon(const fw_wall_def *def)
{
    return def->point_count;
}

static void build_polygon(const fw_wall_def *def, int wall, double swing, fw_facet *facets)
{
    build_loop(def, wall, swing, def->points, def->point_count,
               is_counter_clockwise(def->points, def->point_count), facets);
}

static fw_wall_line outline_polygon(const fw_wall_def *def, fw_vec2 *corners)
{
    (void)corners;
    return (fw_wall_line){.points = def->points, .count = def->point_count, .closed = true};
}

/* --- circle --- */

static fw_status check_circle(const fw_wall_def *def, fw_error *error)
{
    if (!(fabs(def->radius) <= FW_WALL_LIMIT))
        return fw_fail(
            error, FW_BAD_INPUT,
            "wall '%s': the radius is %g, expected a finite number of at most %g in size",
            name_of(def), def->radius, FW_WALL_LIMIT);
    if (def->radius <= 0)
        return fw_fail(error, FW_BAD_INPUT, "wall '%s': the radius is %g, expected more than 0",
                       name_of(def), def->radius);
    if (def->radius <= shortest_share * magnitude(def->points[0]))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the radius %g is lost in the rounding of the centre "
                       "[%.12g, %.12g], expected more than %g of its coordinates",
                       name_of(def), def->radius, def->points[0].x, def->points[0].y,
                       shortest_share);
    return FW_OK;
}

static int count_circle(const fw_wall_def *def)
{
    (void)def;
    return 1;
}

static void build_circle(const fw_wall_def *def, int wall, double swing, fw_facet *facets)
{
    facets[0] = fw_facet_round(wall, def->points[0], def->radius, def->side, swing);
}

static fw_wall_line outline_circle(const fw_wall_def *def, fw_vec2 *corners)
{
    (void)corners;
    return (fw_wall_line){.points = def->points, .count = 1, .radius = def->radius, .closed = true};
}

#define WALL_SHAPE(id, word, least, most, expected, numbers, layout, meaning, sided, corners)      \
    [FW_##id] = {#word, least,        most,         expected,     numbers,                         \
                 sided, check_##word, count_##word, build_##word, outline_##word},
const fw_wall_shape fw_wall_shapes[FW_WALL_SHAPES] = {FW_WALL_SHAPE_ROWS(WALL_SHAPE)};
