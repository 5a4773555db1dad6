/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_check.c - what a wall's definition must fulfil before anything is built from it: Box2D would
 * abort on some of it, and a facet without a direction could bar nothing. Keeps no state.
 * Start reading at fw_wall_def_check(). */
#include "contact/geometry/wall.h"

#include <float.h>
#include <math.h>

/* A side shorter than this share of its coordinates has no direction to speak of. */
static const double shortest_share = 1e-9;

static const char *name_of(const fw_wall_def *def)
{
    return def->name ? def->name : "";
}

static bool in_range(double value)
{
    return fabs(value) <= FW_WALL_LIMIT; /* false for NaN */
}

static fw_status check_number(const fw_wall_def *def, const char *what, double value,
                              fw_error *error)
{
    if (in_range(value)) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "wall '%s': %s is %g, expected a finite number of at most %g in size",
                   name_of(def), what, value, FW_WALL_LIMIT);
}

static fw_status check_points(const fw_wall_def *def, fw_error *error)
{
    static const struct {
        const char *shape, *expected;
        int least, most;
    } counts[] = {[FW_BOX] = {"box", "two opposite corners", 2, 2},
                  [FW_CHAIN] = {"chain", "at least 2", 2, 0},
                  [FW_POLYGON] = {"polygon", "at least 3", 3, 0},
                  [FW_CIRCLE] = {"circle", "one, its centre", 1, 1}};
    const int least = counts[def->shape].least, most = counts[def->shape].most;
    if (def->point_count < least || (most > 0 && def->point_count > most))
        return fw_fail(error, FW_BAD_INPUT, "wall '%s': a %s of %d point%s, expected %s",
                       name_of(def), counts[def->shape].shape, def->point_count,
                       def->point_count == 1 ? "" : "s", counts[def->shape].expected);
    for (int i = 0; i < def->point_count; ++i) {
        fw_vec2 point = def->points[i];
        if (!in_range(point.x) || !in_range(point.y))
            return fw_fail(error, FW_BAD_INPUT,
                           "wall '%s': point %d is [%g, %g], expected finite coordinates of at "
                           "most %g in size",
                           name_of(def), i + 1, point.x, point.y, FW_WALL_LIMIT);
    }
    return FW_OK;
}

static double magnitude(fw_vec2 point)
{
    return fmax(fabs(point.x), fabs(point.y));
}

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

static fw_status check_circle(const fw_wall_def *def, fw_error *error)
{
    FW_TRY(check_number(def, "the radius", def->radius, error));
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

/* Neighbours in the list, and the last and the first if `closed`, must not coincide. */
static fw_status check_sides(const fw_wall_def *def, bool closed, fw_error *error)
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

/* Convex: every corner turns the same way, and all turns together make one turn (a pentagram
 * makes two). Corners of 180 degrees are allowed. */
static fw_status check_polygon(const fw_wall_def *def, fw_error *error)
{
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

static fw_status check_surface(const fw_wall_def *def, fw_error *error)
{
    const fw_surface *surface = &def->surface;
    if (!(surface->friction >= 0) || isinf(surface->friction))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the friction coefficient is %g, expected a finite number >= 0",
                       name_of(def), surface->friction);
    if (surface->law == FW_PENALTY && (!(surface->stiffness > 0) || isinf(surface->stiffness)))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the stiffness of a penalty wall is %g, expected a finite "
                       "number > 0",
                       name_of(def), surface->stiffness);
    if (surface->law == FW_PENALTY && def->shape == FW_CHAIN)
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s' is a chain and has a penalty, expected a box, polygon or circle: "
                       "behind a chain there is no inside where its spring could act",
                       name_of(def));
    return FW_OK;
}

static fw_status check_path(const fw_wall_def *def, fw_error *error)
{
    const fw_path *path = &def->path;
    FW_TRY(check_number(def, "the velocity in x", path->velocity.x, error));
    FW_TRY(check_number(def, "the velocity in y", path->velocity.y, error));
    FW_TRY(check_number(def, "the amplitude in x", path->amplitude.x, error));
    FW_TRY(check_number(def, "the amplitude in y", path->amplitude.y, error));
    FW_TRY(check_number(def, "the phase", path->phase, error));
    if (!isfinite(path->from) || isnan(path->until))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': it moves from time %g until %g, expected numbers", name_of(def),
                       path->from, path->until);
    if (path->until < path->from)
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': it moves from time %g until %g, expected an end after the "
                       "beginning",
                       name_of(def), path->from, path->until);
    if (!(path->period >= 0) || isinf(path->period))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the period is %g, expected a finite number >= 0", name_of(def),
                       path->period);
    if (path->period == 0 && (path->amplitude.x != 0 || path->amplitude.y != 0))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': it oscillates with amplitude [%g, %g] but has no period",
                       name_of(def), path->amplitude.x, path->amplitude.y);
    return FW_OK;
}

static fw_status check_shape(const fw_wall_def *def, fw_error *error)
{
    switch (def->shape) {
    case FW_BOX:
        return check_box(def, error);
    case FW_CIRCLE:
        return check_circle(def, error);
    case FW_CHAIN:
        return check_sides(def, def->closed, error);
    case FW_POLYGON:
        FW_TRY(check_sides(def, true, error));
        return check_polygon(def, error);
    }
    return fw_fail_impossible(error, "a wall of an unknown shape");
}

fw_status fw_wall_def_check(const fw_wall_def *def, fw_error *error)
{
    FW_TRY(check_points(def, error));
    FW_TRY(check_shape(def, error));
    FW_TRY(check_surface(def, error));
    return check_path(def, error);
}
