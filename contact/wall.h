/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall.h - rigid walls: exact geometry in double precision.
 *
 * A wall is made of facets: straight ones (a segment with a free side) and one kind of round one
 * (a whole circle). A box or polygon seen from inside or outside, and a chain, are all straight
 * facets; so is any convex or reflex corner. A facet bars the way from its free side to the other;
 * from behind it does not bar. Contact decides on facets alone. */
#ifndef FW_WALL_H
#define FW_WALL_H

#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>

/* What the surface of a wall does along its tangent. */
typedef enum fw_surface_law {
    FW_FRICTIONLESS,  /* normal force only */
    FW_STICK,         /* a particle that would pass is held in all components */
    FW_COULOMB,       /* tangential force up to friction times the reaction */
    FW_COMPONENTWISE, /* each coordinate that would pass is frozen by itself (Dong et al.) */
    FW_PENALTY        /* soft: a spring of `stiffness` per overlap along the normal */
} fw_surface_law;

typedef struct fw_surface {
    fw_surface_law law;
    double friction;  /* Coulomb coefficient, >= 0 */
    double stiffness; /* of a penalty wall, force per length, > 0 */
} fw_surface;

typedef enum fw_wall_shape { FW_BOX, FW_CHAIN, FW_POLYGON, FW_CIRCLE } fw_wall_shape;

/* Where particles are free to be. */
typedef enum fw_side { FW_INSIDE, FW_OUTSIDE } fw_side;

/* The prescribed path of a wall: displacement from its place in the definition,
 * velocity (t - from) for from <= t <= until, plus amplitude sin(2 pi t / period + phase). */
typedef struct fw_path {
    fw_vec2 velocity;
    double from, until; /* time window of the velocity */
    fw_vec2 amplitude;
    double period; /* 0: no oscillation */
    double phase;  /* radians */
} fw_path;

/* Plain data that describes a wall; start from fw_wall_def_default(). */
typedef struct fw_wall_def {
    const char *name; /* copied */
    fw_wall_shape shape;
    fw_side side;          /* of boxes, polygons and circles; a chain is free to its left, walking
                              from its first point to its last */
    const fw_vec2 *points; /* box: two opposite corners; chain: its points; polygon: its corners,
                              convex, in either sense; circle: its centre */
    int point_count;
    bool closed;   /* a chain that ends where it began */
    double radius; /* of a circle */
    fw_surface surface;
    fw_path path;
} fw_wall_def;

/* A frictionless, resting box [0,0]-[1,1], free inside. */
fw_wall_def fw_wall_def_default(void);

typedef enum fw_facet_kind { FW_STRAIGHT, FW_ROUND } fw_facet_kind;

/* One barrier, at the place of the wall's definition. */
typedef struct fw_facet {
    fw_facet_kind kind;
    int wall;       /* index of the wall it belongs to */
    fw_vec2 a, b;   /* straight: ends; round: a is the centre */
    fw_vec2 normal; /* straight: unit vector to the free side */
    double length;  /* straight: |b - a|; round: radius */
    fw_side side;   /* round: where particles are free */
} fw_facet;

typedef struct fw_wall fw_wall;

/* Checks and copies the definition. FW_BAD_INPUT with a sentence for: non-finite numbers, an empty
 * box, radius <= 0, fewer than 3 corners, a repeated point, a polygon that is not convex or has no
 * area, a chain of one point or with a segment of no length, friction < 0, period < 0. */
fw_status fw_wall_create(fw_wall **wall, int index, const fw_wall_def *def, fw_error *error);
void fw_wall_destroy(fw_wall *wall);

const char *fw_wall_name(const fw_wall *wall);
fw_surface fw_wall_surface(const fw_wall *wall);
const fw_wall_def *fw_wall_definition(const fw_wall *wall); /* points valid as long as the wall */
bool fw_wall_moves(const fw_wall *wall);
/* Displacement from the place of the definition at time t; exactly zero for a resting wall. */
fw_vec2 fw_wall_displacement(const fw_wall *wall, double time);

int fw_wall_facet_count(const fw_wall *wall);
const fw_facet *fw_wall_facet(const fw_wall *wall, int number);

/* Signed distance of a point (in the wall's frame: minus its displacement) from the facet's line
 * or circle, positive on the free side. For axis-parallel facets a single exact subtraction. */
double fw_facet_gap(const fw_facet *facet, fw_vec2 point);

/* Does a particle at `point` that moves by `displacement` (both in the wall's frame) pass from the
 * free side to the other through this facet? A point up to a few rounding errors behind counts as
 * on the facet; ends belong to it, so that nothing slips between two facets that meet. */
bool fw_facet_is_passed(const fw_facet *facet, fw_vec2 point, fw_vec2 displacement);

/* How far `point` is from where it may be, looking at the whole wall: 0 if it is free, else the
 * depth > 0 by which it lies behind the nearest facet. Chains have no inside: always 0. */
double fw_wall_depth(const fw_wall *wall, fw_vec2 point);

#endif
