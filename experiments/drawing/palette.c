/* SPDX-License-Identifier: GPL-3.0-or-later */
/* palette.c - the colours themselves.
 * Keeps no state. Invariant: along all maps but one lightness grows in equal steps, along the
 * diverging one it rises to the middle and falls off in the same way. The maps are lines through
 * few points in the colour space Oklab (B. Ottosson, 2020), whose distances are close to perceived
 * ones. Start reading at fw_palette_at(). */
#include "experiments/drawing/palette.h"

#include <math.h>
#include <string.h>

/* Okabe & Ito, "Color universal design", 2008; the yellow is left to the end, it is too faint for
 * thin lines. */
static const unsigned kinds[FW_PALETTE_KINDS] = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7,
                                                 0xe69f00, 0x56b4e9, 0x000000, 0xf0e442};

/* A point of Oklab: lightness, green to red, blue to yellow. */
typedef struct oklab {
    double lightness, a, b;
} oklab;

enum { MAP_POINTS = 5 };
static const oklab sequential[MAP_POINTS] = {{.260, .035, -.115},
                                             {.420, -.010, -.115},
                                             {.580, -.085, -.045},
                                             {.740, -.105, .065},
                                             {.900, -.040, .165}};
static const oklab diverging[MAP_POINTS] = {{.340, -.020, -.130},
                                            {.650, -.035, -.105},
                                            {.955, .000, .000},
                                            {.650, .095, .085},
                                            {.340, .080, .055}};

static const oklab warm[MAP_POINTS] = {{.240, .060, .020},
                                       {.405, .130, .060},
                                       {.570, .140, .110},
                                       {.735, .070, .140},
                                       {.900, .000, .100}};
static const oklab grey[MAP_POINTS] = {
    {.240, 0, 0}, {.415, 0, 0}, {.590, 0, 0}, {.765, 0, 0}, {.940, 0, 0}};
static const struct {
    const char *name;
    const oklab *points;
} maps[FW_PALETTE_MAPS] = {[FW_PALETTE_AUTO] = {"auto", sequential},
                           [FW_PALETTE_SEQUENTIAL] = {"sequential", sequential},
                           [FW_PALETTE_DIVERGING] = {"diverging", diverging},
                           [FW_PALETTE_WARM] = {"warm", warm},
                           [FW_PALETTE_GREY] = {"grey", grey}};

fw_palette_map fw_palette_find(const char *name)
{
    int map = 0;
    while (map < FW_PALETTE_MAPS && strcmp(maps[map].name, name) != 0) ++map;
    return (fw_palette_map)map;
}

fw_colour fw_palette_kind(int number)
{
    unsigned code = kinds[((number % FW_PALETTE_KINDS) + FW_PALETTE_KINDS) % FW_PALETTE_KINDS];
    return (fw_colour){(code >> 16 & 255) / 255., (code >> 8 & 255) / 255., (code & 255) / 255., 1};
}

/* The transfer curve of sRGB (IEC 61966-2-1). */
static double display_value(double linear)
{
    linear = fmin(fmax(linear, 0), 1);
    return linear <= .0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - .055;
}

static fw_colour colour_from_oklab(oklab c)
{
    double l = c.lightness + .3963377774 * c.a + .2158037573 * c.b;
    double m = c.lightness - .1055613458 * c.a - .0638541728 * c.b;
    double s = c.lightness - .0894841775 * c.a - 1.2914855480 * c.b;
    l = l * l * l;
    m = m * m * m;
    s = s * s * s;
    return (fw_colour){display_value(4.0767416621 * l - 3.3077115913 * m + .2309699292 * s),
                       display_value(-1.2684380046 * l + 2.6097574011 * m - .3413193965 * s),
                       display_value(-.0041960863 * l - .7034186147 * m + 1.7076147010 * s), 1};
}

fw_colour fw_palette_at(fw_palette_map map, double part)
{
    const oklab *points = maps[map].points;
    double place = fmin(fmax(part, 0), 1) * (MAP_POINTS - 1);
    int first = (int)fmin(place, MAP_POINTS - 2);
    double weight = place - first;
    const oklab p = points[first], q = points[first + 1];
    return colour_from_oklab((oklab){p.lightness + weight * (q.lightness - p.lightness),
                                     p.a + weight * (q.a - p.a), p.b + weight * (q.b - p.b)});
}
