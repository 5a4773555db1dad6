/* SPDX-License-Identifier: GPL-3.0-or-later */
/* random_walls.h - walls of all kinds at random, the same ones in every run. */
#ifndef FW_RANDOM_WALLS_H
#define FW_RANDOM_WALLS_H

#include "contact/search/broadphase.h"
#include "tests/support/laws.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* State of a splitmix64 generator (Steele, Lea & Flood 2014). */
typedef struct dice {
    uint64_t state;
} dice;

static inline uint64_t dice_bits(dice *d)
{
    uint64_t z = d->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline double dice_between(dice *d, double low, double high)
{
    return low + (high - low) * (double)(dice_bits(d) >> 11) * 0x1p-53;
}

/* 0 ... count - 1 */
static inline int dice_below(dice *d, int count)
{
    return (int)(dice_bits(d) % (uint64_t)count);
}

static inline fw_vec2 dice_point(dice *d, fw_vec2 centre, double spread)
{
    return (fw_vec2){centre.x + dice_between(d, -spread, spread),
                     centre.y + dice_between(d, -spread, spread)};
}

static inline fw_vec2 dice_direction(dice *d)
{
    double angle = dice_between(d, 0, FW_TWO_PI);
    return (fw_vec2){cos(angle), sin(angle)};
}

/* Between 10^low and 10^high, all powers alike. */
static inline double dice_scale(dice *d, double low, double high)
{
    return pow(10, dice_between(d, low, high));
}

enum { WALL_POINTS_MAX = 9 };

/* A definition with its points; not to be copied after random_wall(). */
typedef struct wall_recipe {
    fw_wall_def def;
    fw_vec2 points[WALL_POINTS_MAX];
} wall_recipe;

/* Corners on an ellipse that is turned anyhow: always convex. */
static inline void random_polygon(wall_recipe *recipe, dice *d, fw_vec2 centre, double size)
{
    const int count = 3 + dice_below(d, WALL_POINTS_MAX - 2);
    fw_vec2 axis = dice_direction(d);
    double flatness = dice_between(d, 0.1, 1), start = dice_between(d, 0, 6);
    int sense = dice_below(d, 2) ? 1 : -1;
    for (int i = 0; i < count; ++i) {
        double angle = start + sense * FW_TWO_PI * (i + dice_between(d, -0.3, 0.3)) / count;
        double along = size * cos(angle), across = size * flatness * sin(angle);
        recipe->points[i] = (fw_vec2){centre.x + along * axis.x - across * axis.y,
                                      centre.y + along * axis.y + across * axis.x};
    }
    recipe->def.point_count = count;
}

/* Any kind; resting, or moving by up to about 2 `speed` per unit of time. */
static inline void random_wall(wall_recipe *recipe, dice *d, fw_vec2 centre, double size,
                               double speed)
{
    fw_wall_def *def = &recipe->def;
    *def = fw_wall_def_default();
    def->points = recipe->points;
    def->shape = (fw_wall_shape_kind)dice_below(d, FW_WALL_SHAPES);
    def->side = (fw_side)dice_below(d, 2);
    switch (def->shape) {
    case FW_BOX: {
        fw_vec2 half = {size * dice_between(d, 0.1, 1), size * dice_between(d, 0.1, 1)};
        recipe->points[0] = fw_vec2_subtract(centre, half);
        recipe->points[1] = fw_vec2_add(centre, half);
        def->point_count = 2;
        break;
    }
    case FW_CHAIN:
        def->point_count = 2 + dice_below(d, WALL_POINTS_MAX - 1);
        for (int i = 0; i < def->point_count; ++i) recipe->points[i] = dice_point(d, centre, size);
        def->closed = dice_below(d, 2);
        break;
    case FW_POLYGON:
        random_polygon(recipe, d, centre, size);
        break;
    case FW_CIRCLE:
        recipe->points[0] = centre;
        def->point_count = 1;
        def->radius = size * dice_between(d, 0.1, 1);
        break;
    }
    if (!(speed > 0) || dice_below(d, 2)) return;
    if (dice_below(d, 2)) {
        def->path.velocity = fw_vec2_scale(speed, dice_direction(d));
        def->path.from = dice_between(d, 0, 10);
        def->path.until = dice_below(d, 2) ? INFINITY : def->path.from + dice_between(d, 0, 20);
    }
    if (dice_below(d, 2)) {
        def->path.period = dice_scale(d, 0.5, 2.5);
        double amplitude = speed * def->path.period / FW_TWO_PI;
        def->path.amplitude = fw_vec2_scale(amplitude, dice_direction(d));
        def->path.phase = dice_between(d, -4, 4);
    }
}

enum { WALLS_MAX = 24, LIST = WALLS_MAX * WALL_POINTS_MAX };

/* Random walls with their broadphase. */
typedef struct stage {
    int wall_count, facet_count;
    fw_wall *walls[WALLS_MAX];
    fw_box extent;
    fw_broadphase *broadphase;
} stage;

static inline fw_broadphase *broadphase_of(const stage *s)
{
    fw_broadphase *broadphase = fw_broadphase_create(s->extent);
    assert_non_null(broadphase);
    int facet_count = 0;
    for (int i = 0; i < s->wall_count; ++i) {
        assert_int_equal(fw_broadphase_add_wall(broadphase, s->walls[i]), facet_count);
        facet_count += fw_wall_facet_count(s->walls[i]);
    }
    assert_int_equal(fw_broadphase_facet_count(broadphase), facet_count);
    return broadphase;
}

static inline void set_stage(stage *s, dice *d, fw_vec2 middle, double size, double speed)
{
    memset(s, 0, sizeof *s);
    s->wall_count = 1 + dice_below(d, WALLS_MAX);
    s->extent = (fw_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int i = 0; i < s->wall_count; ++i) {
        wall_recipe recipe;
        random_wall(&recipe, d, dice_point(d, middle, size), size * dice_scale(d, -1.5, 0), speed);
        fw_error reason;
        if (fw_wall_create(&s->walls[i], i, &recipe.def, &reason) != FW_OK)
            fail_msg("%s", reason.sentence);
        fw_box bounds = fw_wall_bounds(s->walls[i]);
        s->extent.low.x = fmin(s->extent.low.x, bounds.low.x);
        s->extent.low.y = fmin(s->extent.low.y, bounds.low.y);
        s->extent.high.x = fmax(s->extent.high.x, bounds.high.x);
        s->extent.high.y = fmax(s->extent.high.y, bounds.high.y);
        s->facet_count += fw_wall_facet_count(s->walls[i]);
    }
    s->broadphase = broadphase_of(s);
}

static inline void clear_stage(stage *s)
{
    fw_broadphase_destroy(s->broadphase);
    for (int i = 0; i < s->wall_count; ++i) fw_wall_destroy(s->walls[i]);
}

#endif
