/* SPDX-License-Identifier: GPL-3.0-or-later */
/* palette.h - the colours of all pictures: told apart by people who see fewer of them, and in order
 * of lightness where they stand for numbers. */
#ifndef FW_PALETTE_H
#define FW_PALETTE_H

#include "experiments/range.h"

#include <stdbool.h>

/* sRGB, each part from 0 to 1; alpha 1 is opaque. */
typedef struct fw_colour {
    double red, green, blue, alpha;
} fw_colour;

static inline fw_colour fw_colour_grey(double lightness)
{
    return (fw_colour){lightness, lightness, lightness, 1};
}

/* The same colour, more transparent by a factor. */
static inline fw_colour fw_colour_fade(fw_colour colour, double alpha)
{
    colour.alpha *= alpha;
    return colour;
}

/* Distinct colours for kinds of things (Okabe & Ito 2008, black last), in order; they repeat after
 * FW_PALETTE_KINDS. */
enum { FW_PALETTE_KINDS = 8 };
fw_colour fw_palette_kind(int number);

typedef enum fw_palette_map {
    FW_PALETTE_AUTO,       /* diverging where values change sign, else sequential */
    FW_PALETTE_SEQUENTIAL, /* dark blue to yellow, lightness linear */
    FW_PALETTE_DIVERGING   /* blue, nearly white, orange-brown; lightness symmetric */
} fw_palette_map;

/* Colour at 0 <= part <= 1 of a map (sequential for AUTO); beyond the ends the end's colour. */
fw_colour fw_palette_at(fw_palette_map map, double part);

/* The wish how numbers become colours; all zero is a good start. */
typedef struct fw_colouring {
    const char *label; /* what the numbers are, with unit: title of the colour bar */
    fw_range range;    /* fixed ends; where high <= low they come from the values */
    double trim;       /* part of the values that may lie beyond each end: 0 (all within), .01 */
    bool logarithmic;  /* values <= 0 have no colour then */
    fw_palette_map map;
} fw_colouring;

/* How numbers do become colours. */
typedef struct fw_colour_scale {
    const char *label;
    fw_range range; /* low < high */
    bool logarithmic;
    fw_palette_map map;             /* not AUTO */
    bool exceeds_low, exceeds_high; /* some values lie beyond the ends */
} fw_colour_scale;

/* Scale for `count` values; those that are not finite are passed over. A diverging map gets ends
 * symmetric about zero. */
fw_colour_scale fw_colour_scale_for(fw_colouring wish, const double *values, long count);

/* Colour of a value: grey where it is not finite (or <= 0 on a logarithmic scale). */
fw_colour fw_colour_scale_at(const fw_colour_scale *scale, double value);

#endif
