/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall_shape.h - the shapes of walls, one row each: how a scenario writes one, what its points must
 * fulfil, which facets it is made of, and how it is drawn.
 *
 * To add a shape: a row here, and its functions in wall_shape.c, without which that does not
 * compile. The enum, the key of a scenario with its part of the reference, the checks and the
 * pictures follow from the row.
 *
 * Public: the kinds of shapes are meant to stay, their table is not. */
#ifndef FW_WALL_SHAPE_H
#define FW_WALL_SHAPE_H

#include "contact/geometry/facet.h"
#include "core/public.h"
#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>

FW_PUBLIC_BEGIN

/* Columns:
 * - name in the enum;
 * - word in scenarios and sentences, and end of the names of its functions in wall_shape.c;
 * - the least and the most points, most 0: any number; and that in words;
 * - numbers that a scenario gives: two for each point, one more for a radius; 0: a list of points;
 * - layout of these numbers, or of an item of the list; and what they mean;
 * - has it an inside? Then the wall's `side` says where it is free; otherwise it is free to the
 *   left, walking along its points;
 * - corners that its outline computes, beside the points that it has. */
#define FW_WALL_SHAPE_ROWS(ROW)                                                                    \
    ROW(BOX, box, 2, 2, "two opposite corners", 4, "[x0, y0, x1, y1]", "two opposite corners",     \
        true, 4)                                                                                   \
    ROW(POLYGON, polygon, 3, 0, "at least 3", 0, "[x, y]", "corners in order; must be convex",     \
        true, 0)                                                                                   \
    ROW(CIRCLE, circle, 1, 1, "one, its centre", 3, "[x, y, radius]", "centre and radius", true,   \
        0)                                                                                         \
    ROW(CHAIN, chain, 2, 0, "at least 2", 0, "[x, y]",                                             \
        "straight pieces from point to point; particles are free to the left of the way along "    \
        "it, and pass from behind",                                                                \
        false, 0)

#define FW_WALL_SHAPE_ENUM(id, ...) FW_##id,
#define FW_WALL_SHAPE_ONE(id, ...)  +1
#define FW_WALL_SHAPE_ROOM(id, word, least, most, expected, numbers, layout, meaning, sided,       \
                           corners)                                                                \
    char word[(corners) + 1];
typedef enum fw_wall_shape_kind { FW_WALL_SHAPE_ROWS(FW_WALL_SHAPE_ENUM) } fw_wall_shape_kind;
union fw_wall_shape_room { /* as large as the largest number of corners, and one more */
    FW_WALL_SHAPE_ROWS(FW_WALL_SHAPE_ROOM)
};

enum {
    FW_WALL_SHAPES = 0 FW_WALL_SHAPE_ROWS(FW_WALL_SHAPE_ONE),
    FW_WALL_CORNERS_MAX = sizeof(union fw_wall_shape_room) - 1
};

/* A line through points, or a circle. */
typedef struct fw_wall_line {
    const fw_vec2 *points; /* of a circle its centre */
    int count;
    double radius; /* > 0: a circle */
    bool closed;
} fw_wall_line;

typedef struct fw_wall_def fw_wall_def;

/* A row, and its functions. */
typedef struct fw_wall_shape {
    const char *word;
    int least, most;
    const char *expected; /* least and most in words */
    int numbers;
    bool sided; /* has an inside */
    /* FW_BAD_INPUT for a shape without size or direction. Number and range of the points have been
     * checked. */
    fw_status (*check)(const fw_wall_def *def, fw_error *error);
    int (*facet_count)(const fw_wall_def *def);
    /* Fills facet_count() of them, marked with `wall`; `swing` as in facet.h. */
    void (*build)(const fw_wall_def *def, int wall, double swing, fw_facet *facets);
    /* Observes the definition's points, or `corners`, which it may fill. */
    fw_wall_line (*outline)(const fw_wall_def *def, fw_vec2 corners[FW_WALL_CORNERS_MAX]);
} fw_wall_shape;

/* By fw_wall_shape_kind. */
extern const fw_wall_shape fw_wall_shapes[FW_WALL_SHAPES];

FW_PUBLIC_END

#endif
