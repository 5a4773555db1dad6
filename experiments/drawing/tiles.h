/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tiles.h - the places of the plane that are nearest to each point of a set (Voronoi cells), cut
 * off at a reach: what a particle fills in a picture. */
#ifndef FW_TILES_H
#define FW_TILES_H

#include "core/status.h"
#include "core/vec2.h"

typedef struct fw_tiles fw_tiles;

/* `points` is observed, not copied. `reach` > 0: how far a tile goes where no neighbour limits it;
 * a neighbour limits it on the other side too, where there is none.
 * Points that are not finite have no tile and limit nobody's. */
fw_status fw_tiles_create(fw_tiles **tiles, const fw_vec2 *points, int count, double reach,
                          fw_error *error);
void fw_tiles_destroy(fw_tiles *tiles);

/* Corners of the tile of a point, counter-clockwise; returns how many (0: no tile). */
enum { FW_TILE_CORNERS = 64 };
int fw_tiles_corners(const fw_tiles *tiles, int point, fw_vec2 corners[FW_TILE_CORNERS]);
/* The same of a point whose tile reaches less far than those of others. */
int fw_tiles_corners_within(const fw_tiles *tiles, int point, double reach,
                            fw_vec2 corners[FW_TILE_CORNERS]);

#endif
