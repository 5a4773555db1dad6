/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lattice.h - the shape of a body: which sites of a lattice it occupies, and where they lie.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_LATTICE_H
#define FW_LATTICE_H

#include "core/public.h"
#include "core/status.h"
#include "core/vec2.h"

#include <stdbool.h>

FW_PUBLIC_BEGIN

/* FW_SQUARE: site (i, j) at (i, j) spacing.
 * FW_HEXAGONAL: close-packed rows along x; site (i, j) at (i + (j odd)/2, j sqrt(3)/2) spacing. */
typedef enum fw_lattice_kind { FW_SQUARE, FW_HEXAGONAL } fw_lattice_kind;

/* Where site (i, j) lies: origin + turned by angle (radians, counter-clockwise). */
typedef struct fw_lattice {
    fw_lattice_kind kind;
    double spacing;
    double angle;
    fw_vec2 origin; /* position of site (0, 0) */
} fw_lattice;

typedef struct fw_site {
    int i, j;
} fw_site;

/* A set of sites: row by row (j, then i ascending), each once. This is the order of the particles
 * of a body made from it. */
typedef struct fw_sites {
    int count;
    fw_site *site; /* owned */
} fw_sites;

/* Directions of the links of the square lattice; the opposite of d is (d + 2) % 4. */
enum { FW_EAST, FW_NORTH, FW_WEST, FW_SOUTH, FW_DIRECTIONS };
static inline int fw_opposite(int direction)
{
    return (direction + 2) % FW_DIRECTIONS;
}

/* The makers of shapes. On failure *sites is left empty. Limits: 1 <= sites <= FW_SITES_MAX. */
enum { FW_SITES_MAX = 1 << 28 };
/* columns x rows, lower left corner at site (0, 0). */
fw_status fw_sites_rectangle(fw_sites *sites, int columns, int rows, fw_error *error);
/* Sites whose lattice position is within `radius` (in spacings) of site (0, 0). */
fw_status fw_sites_disc(fw_sites *sites, fw_lattice_kind kind, double radius, fw_error *error);
/* Any sites in any order; a site named twice is refused. */
fw_status fw_sites_list(fw_sites *sites, const fw_site *list, int count, fw_error *error);
/* Lines of text, the first the topmost row: '#' is a particle, '.' or a blank is none. The last
 * line is row 0, its first character column 0. */
fw_status fw_sites_mask(fw_sites *sites, const char *text, fw_error *error);
void fw_sites_clear(fw_sites *sites);

/* Index of a site in the set, or -1. */
int fw_sites_find(const fw_sites *sites, fw_site site);
/* One past the last site of the run, sites side by side in a row, that a site is in. */
int fw_sites_run_end(const fw_sites *sites, int site);
/* The same as fw_sites_find(), walking from *at (0 at first), where it leaves off: for sites that
 * are asked for in ascending order, all answers together take as long as one walk through the set.
 */
int fw_sites_walk(const fw_sites *sites, fw_site site, int *at);
static inline int fw_sites_find_next(const fw_sites *sites, fw_site site, int *at)
{
    const int next = *at + 1; /* mostly it is that */
    if (next >= sites->count || sites->site[next].i != site.i || sites->site[next].j != site.j)
        return fw_sites_walk(sites, site, at);
    return *at = next;
}
/* The neighbour of a site of the square lattice. */
fw_site fw_site_neighbour(fw_site site, int direction);

fw_vec2 fw_lattice_position(const fw_lattice *lattice, fw_site site);
/* The same of `count` sites, sooner. */
void fw_lattice_place(const fw_lattice *lattice, const fw_site *sites, int count,
                      fw_vec2 *positions);
/* The same without the origin: exact differences even where the origin is large. */
fw_vec2 fw_lattice_vector(const fw_lattice *lattice, fw_site site);
/* Lattice vector of direction d of the square lattice. */
fw_vec2 fw_lattice_step(const fw_lattice *lattice, int direction);

FW_PUBLIC_END

#endif
