/* SPDX-License-Identifier: GPL-3.0-or-later */
/* placement.c - random sequential placement on a grid of linked cells.
 * State while it runs: for each cell the last particle in it, for each particle the one before in
 * its cell. Start reading at fw_placement_random(). */
#include "core/placement.h"

#include "core/noise.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

enum { DROPS_EACH = 1000, SIDE_MAX = 16384 };

typedef struct fw_drop_grid {
    fw_vec2 low;
    double inverse_size; /* of a cell, which is at least `distance` wide */
    int columns, rows;
    int *last;   /* of each cell, or -1 */
    int *before; /* of each particle, or -1 */
} fw_drop_grid;

static int clamped(double place, int count)
{
    const int cell = (int)place;
    return cell < count ? cell : count - 1;
}

static bool is_free(const fw_drop_grid *grid, const fw_vec2 *positions, fw_vec2 at, int column,
                    int row, double distance)
{
    for (int j = row - 1; j <= row + 1; ++j)
        for (int i = column - 1; i <= column + 1; ++i) {
            if (i < 0 || j < 0 || i >= grid->columns || j >= grid->rows) continue;
            for (int other = grid->last[j * grid->columns + i]; other >= 0;
                 other = grid->before[other]) {
                const fw_vec2 apart = fw_vec2_subtract(positions[other], at);
                if (fw_vec2_dot(apart, apart) < distance * distance) return false;
            }
        }
    return true;
}

static int drop_all(fw_drop_grid *grid, fw_vec2 *positions, int count, fw_vec2 size,
                    double distance, uint64_t seed)
{
    const int64_t most = (int64_t)count * DROPS_EACH;
    int placed = 0;
    for (int64_t drop = 0; drop < most && placed < count; ++drop) {
        const fw_vec2 drawn =
            fw_noise_uniform(seed, (uint32_t)drop, (uint64_t)drop >> 32, FW_NOISE_PLACEMENT);
        const fw_vec2 place = {size.x * 0.5 * (drawn.x + 1), size.y * 0.5 * (drawn.y + 1)};
        const fw_vec2 at = fw_vec2_add(grid->low, place);
        const int column = clamped(place.x * grid->inverse_size, grid->columns);
        const int row = clamped(place.y * grid->inverse_size, grid->rows);
        if (!is_free(grid, positions, at, column, row, distance)) continue;
        positions[placed] = at;
        grid->before[placed] = grid->last[row * grid->columns + column];
        grid->last[row * grid->columns + column] = placed;
        placed += 1;
    }
    return placed;
}

/* More than there is room for, before a single drop? No arrangement of centres in a rectangle of
 * area A and perimeter P has more than 2 A/(3^(1/2) d^2) + P/(2 d) + 1 of them (Oler 1961). Many
 * that are dropped at random jam where their discs cover .547 of the rectangle that holds them
 * (Feder 1980); a few of them can be luckier. */
static fw_status refuse_crowds(int count, fw_vec2 size, double distance, fw_error *error)
{
    enum { MANY = 1000, WIDE = 20 };
    const double jam = 0.547, certainly = 0.57;
    const double most =
        2 * size.x * size.y / (sqrt(3) * distance * distance) + (size.x + size.y) / distance + 1;
    if (count > most)
        return fw_fail(error, FW_BAD_INPUT,
                       "%d particles at least %g from each other are to be placed in %g x %g, "
                       "expected at most %.0f: more do not fit however they lie",
                       count, distance, size.x, size.y, floor(most));
    const double around = (size.x + distance) * (size.y + distance);
    const double covered = count * FW_PI * distance * distance / (4 * around);
    if (count >= MANY && fmin(size.x, size.y) > WIDE * distance && covered > certainly)
        return fw_fail(error, FW_BAD_INPUT,
                       "%d particles at least %g from each other are to be dropped into %g x %g, "
                       "where they would cover %.3f, expected well below %g, where random "
                       "placement jams",
                       count, distance, size.x, size.y, covered, jam);
    return FW_OK;
}

fw_status fw_placement_random(fw_vec2 *positions, int count, fw_vec2 low, fw_vec2 high,
                              double distance, uint64_t seed, fw_error *error)
{
    const fw_vec2 size = fw_vec2_subtract(high, low);
    if (!(size.x > 0 && size.y > 0 && isfinite(size.x) && isfinite(size.y)))
        return fw_fail(error, FW_BAD_INPUT,
                       "particles are to be placed in [%g, %g] to [%g, %g], expected a rectangle "
                       "with an area",
                       low.x, low.y, high.x, high.y);
    if (!(distance >= 0 && isfinite(distance)))
        return fw_fail(error, FW_BAD_INPUT,
                       "particles are to be placed %g apart, expected a number >= 0", distance);
    if (count < 1)
        return fw_fail(error, FW_BAD_INPUT, "%d particles are to be placed, expected at least one",
                       count);
    if (distance > 0) FW_TRY(refuse_crowds(count, size, distance, error));
    /* About one particle per cell, but none narrower than the distance, so that the eight cells
     * around one hold everybody who may be too near; and not more than SIDE_MAX a side. */
    double cell = fmax(distance, sqrt(size.x / count * size.y));
    cell = fmax(cell, fmax(size.x, size.y) / SIDE_MAX);
    fw_drop_grid grid = {.low = low,
                         .inverse_size = 1 / cell,
                         .columns = (int)(size.x / cell) + 1,
                         .rows = (int)(size.y / cell) + 1};
    const size_t cells = (size_t)grid.columns * (size_t)grid.rows;
    grid.last = malloc(cells * sizeof *grid.last);
    grid.before = malloc((size_t)count * sizeof *grid.before);
    int placed = -1;
    if (grid.last && grid.before) {
        for (size_t c = 0; c < cells; ++c) grid.last[c] = -1;
        placed = drop_all(&grid, positions, count, size, distance, seed);
    }
    free(grid.last);
    free(grid.before);
    if (placed < 0) return fw_fail_memory(error, "the cells of a random placement");
    if (placed < count)
        return fw_fail(error, FW_BAD_INPUT,
                       "only %d of %d particles found a place at least %g from each other in %g x "
                       "%g after %d drops each: expected a coverage well below 0.547, found %.3f",
                       placed, count, distance, size.x, size.y, DROPS_EACH,
                       count * FW_PI * distance * distance / (4 * size.x * size.y));
    return FW_OK;
}
