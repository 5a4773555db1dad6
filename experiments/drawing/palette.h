/* SPDX-License-Identifier: GPL-3.0-or-later */
/* palette.h - the colours of all pictures: distinct to people who see fewer of them, and in order
 * of lightness where they stand for numbers. */
#ifndef FW_PALETTE_H
#define FW_PALETTE_H

/* sRGB, each part from 0 to 1; alpha 1 is opaque. */
typedef struct fw_colour {
    double red, green, blue, alpha;
} fw_colour;

static inline fw_colour fw_colour_grey(double lightness)
{
    return (fw_colour){lightness, lightness, lightness, 1};
}

/* Of text, frames and axes. */
static inline fw_colour fw_colour_ink(void)
{
    return fw_colour_grey(.1);
}

/* The same colour, more transparent by a factor. */
static inline fw_colour fw_colour_fade(fw_colour colour, double alpha)
{
    colour.alpha *= alpha;
    return colour;
}

/* Distinct colours for kinds (Okabe & Ito 2008, black last), in order; they repeat after
 * FW_PALETTE_KINDS. */
enum { FW_PALETTE_KINDS = 8 };
fw_colour fw_palette_kind(int number);

typedef enum fw_palette_map {
    FW_PALETTE_AUTO,       /* diverging where values change sign, else sequential */
    FW_PALETTE_SEQUENTIAL, /* dark blue to yellow, lightness linear */
    FW_PALETTE_DIVERGING,  /* blue, nearly white, orange-brown; lightness symmetric */
    FW_PALETTE_WARM,       /* dark red to light yellow, lightness linear */
    FW_PALETTE_GREY,       /* dark to light, for paper without colours */
    FW_PALETTE_MAPS
} fw_palette_map;

/* Names of the maps, AUTO first. */
#define FW_PALETTE_NAMES "auto, sequential, diverging, warm, grey"
/* The map of that name; FW_PALETTE_MAPS: there is none. */
fw_palette_map fw_palette_find(const char *name);

/* Colour at 0 <= part <= 1 of a map (sequential for AUTO); beyond the ends the end's colour. */
fw_colour fw_palette_at(fw_palette_map map, double part);

#endif
