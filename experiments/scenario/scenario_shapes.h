/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_shapes.h - which sites a body occupies, as plain data. */
#ifndef FW_SCENARIO_SHAPES_H
#define FW_SCENARIO_SHAPES_H

#include "core/lattice.h"
#include "core/vec2.h"

#include <stdbool.h>

typedef enum fw_shape_kind {
    FW_SHAPE_RECTANGLE,
    FW_SHAPE_DISC,
    FW_SHAPE_SITES,
    FW_SHAPE_MASK,
    FW_SHAPE_PLACED,
    FW_SHAPE_POINTS
} fw_shape_kind;

/* Do the particles stand anywhere, not on sites of a lattice? */
static inline bool fw_shape_is_free(fw_shape_kind kind)
{
    return kind == FW_SHAPE_PLACED || kind == FW_SHAPE_POINTS;
}

typedef struct fw_scenario_shape {
    fw_shape_kind kind;
    int columns, rows; /* rectangle */
    double radius;     /* disc, in spacings */
    /* placed and points: all are in here, relative to the origin; sites [0, 0], [1, 0] ... */
    fw_vec2 low, high;
    fw_vec2 *points; /* [count] relative to the origin; the document's; else NULL */
    double apart;    /* placed: at least */
    fw_sites sites;  /* sites and mask: sorted, owned by the scenario; else empty */
    int64_t count;   /* how many sites, whatever the kind */
    int first_row, last_row, first_column, last_column; /* the smallest frame around them */
} fw_scenario_shape;

#endif
