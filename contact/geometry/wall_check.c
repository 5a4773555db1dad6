/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_check.c - what a wall's definition must fulfil before anything is built from it: Box2D would
 * abort on some of it, and a facet without a direction could bar nothing. The rules of each shape
 * are in wall_shape.c. Keeps no state. Start reading at fw_wall_def_check(). */
#include "contact/geometry/wall.h"

#include <math.h>

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
    const fw_wall_shape *shape = fw_wall_shape_of(def);
    if (def->point_count < shape->least || (shape->most > 0 && def->point_count > shape->most))
        return fw_fail(error, FW_BAD_INPUT, "wall '%s': a %s of %d point%s, expected %s",
                       name_of(def), shape->word, def->point_count,
                       def->point_count == 1 ? "" : "s", shape->expected);
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

static fw_status check_surface(const fw_wall_def *def, fw_error *error)
{
    const fw_surface *surface = &def->surface;
    if (!(surface->friction >= 0) || isinf(surface->friction))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the friction coefficient is %g, expected a finite number >= 0",
                       name_of(def), surface->friction);
    if (!(surface->static_friction >= 0) || isinf(surface->static_friction))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the static friction coefficient is %g, expected a finite number "
                       ">= 0",
                       name_of(def), surface->static_friction);
    if (surface->law == FW_PENALTY && (!(surface->stiffness > 0) || isinf(surface->stiffness)))
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s': the stiffness of a penalty wall is %g, expected a finite "
                       "number > 0",
                       name_of(def), surface->stiffness);
    if (surface->law == FW_PENALTY && !fw_wall_shape_of(def)->sided)
        return fw_fail(error, FW_BAD_INPUT,
                       "wall '%s' is a %s and has a penalty, expected a box, polygon or circle: "
                       "behind a %s there is no inside where its spring could act",
                       name_of(def), fw_wall_shape_of(def)->word, fw_wall_shape_of(def)->word);
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

fw_status fw_wall_def_check(const fw_wall_def *def, fw_error *error)
{
    FW_TRY(check_points(def, error));
    FW_TRY(fw_wall_shape_of(def)->check(def, error));
    FW_TRY(check_surface(def, error));
    return check_path(def, error);
}
