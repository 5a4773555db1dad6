/* SPDX-License-Identifier: GPL-3.0-or-later */
/* colour_scale.h - how numbers become colours. */
#ifndef FW_COLOUR_SCALE_H
#define FW_COLOUR_SCALE_H

#include "experiments/drawing/label.h"
#include "experiments/drawing/palette.h"
#include "experiments/text/range.h"

/* The wish how numbers become colours; all zero is a good start. */
typedef struct fw_colouring {
    fw_label label;   /* what the numbers are: title of the colour bar */
    fw_range range;   /* fixed ends; where high <= low they come from the values */
    double trim;      /* part of the values that may lie beyond each end: 0 (all within), .01 */
    bool logarithmic; /* values <= 0 have no colour then */
    fw_palette_map map;
} fw_colouring;

/* How numbers do become colours. */
typedef struct fw_colour_scale {
    fw_label label;
    fw_range range; /* low < high */
    bool logarithmic;
    fw_palette_map map;             /* not AUTO */
    bool exceeds_low, exceeds_high; /* some values lie beyond the ends */
    bool fixed; /* the ends were given: all pictures that share them have the same layout */
} fw_colour_scale;

/* Scale for `count` values; those that are not finite are passed over. A diverging map gets ends
 * symmetric about zero. */
fw_colour_scale fw_colour_scale_for(fw_colouring wish, const double *values, long count);

/* Colour of a value: grey where it is not finite (or <= 0 on a logarithmic scale). */
fw_colour fw_colour_scale_at(const fw_colour_scale *scale, double value);

#endif
