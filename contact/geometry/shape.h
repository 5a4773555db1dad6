/* SPDX-License-Identifier: GPL-3.0-or-later */
/* shape.h - the shapes of walls, one row each in a table: how a scenario names and writes one, what
 * its points must fulfil, which facets it is made of, and how it is drawn. A new shape is a word in
 * fw_wall_shape and a row. */
#ifndef FW_SHAPE_H
#define FW_SHAPE_H

#include "contact/geometry/wall.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { FW_SHAPES = 4, FW_SHAPE_CORNERS = 4 };

/* A line through points, or a circle. */
typedef struct fw_shape_outline {
    const fw_vec2 *points; /* of a circle its centre */
    int count;
    double radius; /* > 0: a circle */
    bool closed;
} fw_shape_outline;

typedef struct fw_shape {
    const char *word;     /* in scenarios and sentences */
    int least, most;      /* points; most 0: any number */
    const char *expected; /* that, in words */
    int numbers;          /* in scenarios: two for each point, one more for a radius; 0: a list of
                             points */
    bool sided; /* has an inside, and the wall's `side` says where it is free; otherwise it
                   is free to the left of the way along its points */
    /* FW_BAD_INPUT for a shape without size or direction. Number and range of the points have been
     * checked. */
    fw_status (*check)(const fw_wall_def *def, fw_error *error);
    int (*facet_count)(const fw_wall_def *def);
    /* Fills facet_count() of them, marked with `wall`; `swing` as in facet.h. */
    void (*build)(const fw_wall_def *def, int wall, double swing, fw_facet *facets);
    /* Observes the definition's points, or `corners`, which it may fill. */
    fw_shape_outline (*outline)(const fw_wall_def *def, fw_vec2 corners[FW_SHAPE_CORNERS]);
} fw_shape;

/* By fw_wall_shape. */
extern const fw_shape fw_shapes[FW_SHAPES];

static inline const fw_shape *fw_shape_of(const fw_wall_def *def)
{
    return &fw_shapes[def->shape];
}

#ifdef __cplusplus
}
#endif
#endif
