/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tiles.c - Voronoi cells by cutting.
 * State: a grid of bins with the points in each, in index order. Invariant: two points less than
 * twice the reach apart lie in the same bin or in neighbouring ones. Start reading at
 * fw_tiles_corners(). */
#include "experiments/drawing/tiles.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* Points that are piled up at one place limit each other's tiles no more after so many. */
enum { NEIGHBOURS_MAX = 400, ROUND_CORNERS = 36, BINS_ALONG_MAX = 1024 };

struct fw_tiles {
    const fw_vec2 *points;
    double reach;
    fw_vec2 low;
    double bin_size;
    int columns, rows;
    int *first;  /* [columns rows + 1] where each bin begins in `member` */
    int *member; /* points, bin by bin */
};

static bool is_finite(fw_vec2 point)
{
    return isfinite(point.x) && isfinite(point.y);
}

static int bin_column(const fw_tiles *tiles, double x)
{
    return (int)fmin(fmax(floor((x - tiles->low.x) / tiles->bin_size), 0), tiles->columns - 1);
}

static int bin_row(const fw_tiles *tiles, double y)
{
    return (int)fmin(fmax(floor((y - tiles->low.y) / tiles->bin_size), 0), tiles->rows - 1);
}

static int bin_of(const fw_tiles *tiles, fw_vec2 point)
{
    return bin_row(tiles, point.y) * tiles->columns + bin_column(tiles, point.x);
}

/* A bin is at least as wide as two points that share a border can be apart. */
static void lay_grid(fw_tiles *tiles, int count)
{
    fw_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int k = 0; k < count; ++k) {
        if (!is_finite(tiles->points[k])) continue;
        low = (fw_vec2){fmin(low.x, tiles->points[k].x), fmin(low.y, tiles->points[k].y)};
        high = (fw_vec2){fmax(high.x, tiles->points[k].x), fmax(high.y, tiles->points[k].y)};
    }
    tiles->low = low.x <= high.x ? low : (fw_vec2){0, 0};
    double width = low.x <= high.x ? high.x - low.x : 0;
    double height = low.x <= high.x ? high.y - low.y : 0;
    tiles->bin_size = fmax(2 * tiles->reach, fmax(width, height) / BINS_ALONG_MAX);
    tiles->columns = 1 + (int)fmin(width / tiles->bin_size, BINS_ALONG_MAX);
    tiles->rows = 1 + (int)fmin(height / tiles->bin_size, BINS_ALONG_MAX);
}

/* Counting sort: points stay in index order within their bin. */
static void fill_bins(fw_tiles *tiles, int count)
{
    int bins = tiles->columns * tiles->rows;
    for (int k = 0; k < count; ++k) {
        if (is_finite(tiles->points[k])) tiles->first[bin_of(tiles, tiles->points[k]) + 1] += 1;
    }
    for (int bin = 0; bin < bins; ++bin) tiles->first[bin + 1] += tiles->first[bin];
    int total = tiles->first[bins];
    /* Filling from the back moves the end of each bin to its beginning ... */
    for (int k = count - 1; k >= 0; --k) {
        if (!is_finite(tiles->points[k])) continue;
        tiles->member[--tiles->first[bin_of(tiles, tiles->points[k]) + 1]] = k;
    }
    /* ... so that each bin's beginning now stands one place too far on. */
    for (int bin = 0; bin < bins; ++bin) tiles->first[bin] = tiles->first[bin + 1];
    tiles->first[bins] = total;
}

fw_status fw_tiles_create(fw_tiles **tiles, const fw_vec2 *points, int count, double reach,
                          fw_error *error)
{
    *tiles = NULL;
    fw_tiles *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "the tiles of a picture");
    made->points = points;
    made->reach = reach;
    lay_grid(made, count);
    made->first = calloc((size_t)made->columns * (size_t)made->rows + 1, sizeof *made->first);
    made->member = calloc((size_t)count + 1, sizeof *made->member);
    if (!made->first || !made->member) {
        fw_tiles_destroy(made);
        return fw_fail_memory(error, "the tiles of a picture");
    }
    fill_bins(made, count);
    *tiles = made;
    return FW_OK;
}

void fw_tiles_destroy(fw_tiles *tiles)
{
    if (!tiles) return;
    free(tiles->first);
    free(tiles->member);
    free(tiles);
}

/* Keeps the part of a convex polygon that is nearer to the origin than to `other`:
 * corner . other <= |other|^2 / 2. Returns the new number of corners. */
static int cut(fw_vec2 *corners, int count, fw_vec2 other)
{
    fw_vec2 kept[FW_TILE_CORNERS + 1];
    double limit = fw_vec2_dot(other, other) / 2;
    int kept_count = 0;
    for (int k = 0; k < count && kept_count < FW_TILE_CORNERS; ++k) {
        fw_vec2 a = corners[k], b = corners[(k + 1) % count];
        double beyond_a = fw_vec2_dot(a, other) - limit, beyond_b = fw_vec2_dot(b, other) - limit;
        if (beyond_a <= 0) kept[kept_count++] = a;
        if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0)) {
            double part = beyond_a / (beyond_a - beyond_b);
            kept[kept_count++] = fw_vec2_add(a, fw_vec2_scale(part, fw_vec2_subtract(b, a)));
        }
    }
    if (kept_count > FW_TILE_CORNERS) return count;
    for (int k = 0; k < kept_count; ++k) corners[k] = kept[k];
    return kept_count;
}

/* The points that may limit a tile, seen from its own; returns how many. */
static int find_neighbours(const fw_tiles *tiles, fw_vec2 centre, double reach,
                           fw_vec2 found[NEIGHBOURS_MAX])
{
    int count = 0;
    int column = bin_column(tiles, centre.x), row = bin_row(tiles, centre.y);
    for (int r = row > 0 ? row - 1 : 0; r <= row + 1 && r < tiles->rows; ++r) {
        for (int c = column > 0 ? column - 1 : 0; c <= column + 1 && c < tiles->columns; ++c) {
            int bin = r * tiles->columns + c;
            for (int k = tiles->first[bin]; k < tiles->first[bin + 1]; ++k) {
                fw_vec2 other = fw_vec2_subtract(tiles->points[tiles->member[k]], centre);
                double distance = hypot(other.x, other.y);
                if (!(distance > 0) || distance >= 2 * reach) continue;
                if (count < NEIGHBOURS_MAX) found[count++] = other;
            }
        }
    }
    return count;
}

/* Where a tile has a neighbour on one side and none within 50 degrees of the other, it ends there
 * as far away as it does here: cells along the boundary of a lattice have the shape of those
 * inside. */
static bool has_opposite(const fw_vec2 *neighbours, int count, fw_vec2 neighbour)
{
    const double least = -.643 * hypot(neighbour.x, neighbour.y);
    for (int k = 0; k < count; ++k)
        if (fw_vec2_dot(neighbours[k], neighbour) < least * hypot(neighbours[k].x, neighbours[k].y))
            return true;
    return false;
}

int fw_tiles_corners(const fw_tiles *tiles, int point, fw_vec2 corners[FW_TILE_CORNERS])
{
    return fw_tiles_corners_within(tiles, point, tiles->reach, corners);
}

int fw_tiles_corners_within(const fw_tiles *tiles, int point, double reach,
                            fw_vec2 corners[FW_TILE_CORNERS])
{
    assert(reach <= tiles->reach);
    fw_vec2 centre = tiles->points[point], neighbours[NEIGHBOURS_MAX];
    if (!is_finite(centre)) return 0;
    int count = ROUND_CORNERS;
    for (int k = 0; k < count; ++k) {
        double angle = 2 * M_PI * (k + .5) / count;
        corners[k] = (fw_vec2){reach * cos(angle), reach * sin(angle)};
    }
    const int limits = find_neighbours(tiles, centre, reach, neighbours);
    for (int k = 0; k < limits; ++k) {
        count = cut(corners, count, neighbours[k]);
        if (!has_opposite(neighbours, limits, neighbours[k]))
            count = cut(corners, count, fw_vec2_scale(-1, neighbours[k]));
    }
    for (int k = 0; k < count; ++k) corners[k] = fw_vec2_add(centre, corners[k]);
    return count;
}
