/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall.h - rigid walls: a shape made of facets, a surface, and a prescribed path.
 *
 * A box or polygon seen from inside or outside, and a chain, are all straight facets; a circle is
 * one round facet. How a facet bars the way stands in facet.h.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_WALL_H
#define FW_WALL_H

#include "contact/geometry/facet.h"
#include "contact/geometry/path.h"
#include "contact/geometry/wall_shape.h"
#include "core/public.h"
#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>

FW_PUBLIC_BEGIN

/* What the surface of a wall does along its tangent. */
typedef enum fw_surface_law {
    FW_FRICTIONLESS,  /* normal force only */
    FW_STICK,         /* a particle that would pass is held in all components: at a wall without a
                         path its momentum turns over, on one with a path it takes the wall's
                         velocity, and what that costs is heat */
    FW_COULOMB,       /* tangential force up to friction times the reaction */
    FW_COMPONENTWISE, /* each coordinate that would pass is frozen by itself (Dong et al.) */
    FW_PENALTY        /* soft: a spring of `stiffness` per overlap along the normal */
} fw_surface_law;

typedef struct fw_surface {
    fw_surface_law law;
    double friction;        /* Coulomb coefficient of what slides, >= 0 */
    double stiffness;       /* of a penalty wall, force per length, > 0 */
    double static_friction; /* of what sticks; below `friction`: that */
    int number;             /* of a Coulomb wall, 1 + its surface: coefficients are those of the
                               pair with the body's; 0: they stand here */
} fw_surface;

/* Plain data that describes a wall; start from fw_wall_def_default(). */
struct fw_wall_def {
    const char *name; /* copied */
    fw_wall_shape_kind shape;
    fw_side side; /* of a shape that has an inside; any other, a chain, is free to its left,
                     walking from its first point to its last */
    const fw_vec2 *points; /* as the row of the shape says; a polygon's corners in either sense */
    int point_count;
    bool closed;   /* a chain with one more segment, from its last point to its first */
    double radius; /* of a circle */
    fw_surface surface;
    fw_path path;
    bool driven; /* somebody else says where it is: see piston.h; without a path */
};

static inline const fw_wall_shape *fw_wall_shape_of(const fw_wall_def *def)
{
    return &fw_wall_shapes[def->shape];
}

/* A frictionless, resting box [0,0]-[1,1], free inside. */
fw_wall_def fw_wall_def_default(void);

/* No coordinate, velocity or amplitude may be larger: the broadphase works in single precision. */
#define FW_WALL_LIMIT 1e9

typedef struct fw_wall fw_wall;

/* Checks and copies the definition; `index` is what its facets are marked with. FW_BAD_INPUT with
 * a sentence that names the wall for: numbers that are not finite or beyond FW_WALL_LIMIT, a wrong
 * number of points, an empty box, radius <= 0, two points in a row that coincide (or are too near
 * to each other for a direction in double precision), a polygon that is not convex or has no area,
 * friction < 0, static friction < 0, stiffness <= 0 of a penalty wall, period < 0, an oscillation
 * without a period, a time window that ends before it begins. */
fw_status fw_wall_create(fw_wall **wall, int index, const fw_wall_def *def, fw_error *error);
void fw_wall_destroy(fw_wall *wall);

const char *fw_wall_name(const fw_wall *wall);
fw_surface fw_wall_surface(const fw_wall *wall);
const fw_wall_def *fw_wall_definition(const fw_wall *wall); /* points valid as long as the wall */
bool fw_wall_moves(const fw_wall *wall);
/* Displacement from the place of the definition at time t by its path; exactly zero without one. */
fw_vec2 fw_wall_displacement(const fw_wall *wall, double time);

int fw_wall_facet_count(const fw_wall *wall);
const fw_facet *fw_wall_facet(const fw_wall *wall, int number);

/* Smallest box around the wall, at the place of its definition. */
fw_box fw_wall_bounds(const fw_wall *wall);

/* How far a point is from where it may be, looking at the whole wall, displaced by `place`: 0 if
 * it is free, else the depth > 0 by which it lies behind the facet that bars it: inside, the one
 * it is furthest behind of; outside, the nearest. Of a chain it is the nearest piece that the point
 * lies beside. */
double fw_wall_depth(const fw_wall *wall, fw_vec2 point, fw_vec2 place);

/* The checks of fw_wall_create() alone. */
fw_status fw_wall_def_check(const fw_wall_def *def, fw_error *error);

FW_PUBLIC_END

#endif
