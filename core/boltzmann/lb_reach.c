/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_reach.c - how far the boundary of an LB solid can go in the next ticks, at most.
 *
 * Let S(l) = |f_0|^2 + sum |f_i|^2 be the squares of what has come to site l. A step sends
 * w - f_i to the neighbours and keeps M0 w - f_0, with w = mu M^-1 Psi, Psi = M0 f_0 + sum f_i and
 * 2 M = M0^2 + (number of links): the sum of what leaves is S - 2 w.(Psi - M w) <= S(l). So within
 * n ticks S(l) grows at most to the sum of S over all sites that are n links away or nearer. And by
 * Cauchy and Schwarz
 *     Psi.M^-1 Psi <= 2 S,   |w|^2 <= 2 S / (least eigenvalue of M),                          (1)
 * where w is by how much the site moves. A body that moves as a whole does not end the matter: the
 * equations are linear and a uniform velocity V (which damping only diminishes) solves them, so (1)
 * holds of what is beyond it, f - V/2 and f_0 - M0 V/2, and the site goes by n |V| further.
 *
 * S is summed by tiles of 16 x 16 sites, of those tiles that the boundary can hear of in time. In
 * ticks 16 (k - 1) to 16 k - 1 a site of a tile can hear of what is at most k tiles away. That also
 * covers a reversal of time on the way.
 *
 * State: none; tiles are only room to work in. Start reading at lb_reach(). */
#include "lb_reach.h"

#include "lb_displacements.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { TILE = 16, RINGS_MAX = 64, BOUNDARY = 2, HEARD = 1 };

/* Blocks of the table that the body may have per block of the grid, and a few more. */
enum { SPARSE = 4, FEW = 1024 };

void lb_reach_allocate(lb_solid *lb)
{
    lb_tiles *tiles = &lb->form.tiles;
    const lb_grid *grid = &lb->form.grid;
    const int64_t rows = grid->row_count / TILE + 1;
    const int64_t columns = ((int64_t)grid->block_end - grid->block_begin) * LB_BLOCK / TILE + 1;
    if (rows * columns > (int64_t)SPARSE * grid->place_count / (TILE * TILE) + FEW) return;
    tiles->rows = (int)rows;
    tiles->columns = (int)columns;
    FW_ARENA_ADD(&lb->form.arena, tiles->squares, (size_t)(rows * columns));
    FW_ARENA_ADD(&lb->form.arena, tiles->wanted, (size_t)(rows * columns));
    FW_ARENA_ADD(&lb->form.arena, tiles->sums, (size_t)columns * TILE);
}

/* No eigenvalue exceeds the largest sum of a row. */
void lb_reach_begin(lb_solid *lb)
{
    double most = 0;
    for (int l = 0; lb->resting && l < lb->head.count; ++l) {
        const fw_sym2 m = lb_get(&lb->rest_mass, l);
        most = fmax(most, fmax(fabs(m.xx), fabs(m.yy)) + fabs(m.xy));
    }
    lb->form.heaviest = most * most;
}

static fw_vec2 velocity_of(const lb_solid *lb, int place)
{
    const displacement_form *form = &lb->form;
    return (fw_vec2){form->x[lb->parity][place] - form->x[!lb->parity][place],
                     form->y[lb->parity][place] - form->y[!lb->parity][place]};
}

/* Of the boundary: its mean velocity, the largest eigenvalue of M^-1 (or more), the largest
 * displacement. */
typedef struct edge_sums {
    fw_vec2 velocity;
    double lightest, farthest;
} edge_sums;

static edge_sums sums_of_boundary(const lb_solid *lb)
{
    const displacement_form *form = &lb->form;
    edge_sums sums = {{0, 0}, 0, 0};
    for (int n = 0; n < lb->head.boundary_count; ++n) {
        const int l = lb->head.boundary[n], place = form->grid.place[l];
        const fw_sym2 inverse = lb_inverse_of(lb, l);
        sums.velocity = fw_vec2_add(sums.velocity, velocity_of(lb, place));
        sums.lightest = fmax(sums.lightest, fmax(inverse.xx, inverse.yy) + fabs(inverse.xy));
        sums.farthest = fmax(sums.farthest, fmax(fabs(form->x[lb->parity][place]),
                                                 fabs(form->y[lb->parity][place])));
    }
    sums.velocity = fw_vec2_scale(1.0 / lb->head.boundary_count, sums.velocity);
    return sums;
}

/* The place in which a row begins. */
static int begin_of(const lb_grid *grid, int row)
{
    return grid->runs[grid->rows[row].run].begin;
}

/* Column of the table at which a row begins. */
static int first_column(const lb_grid *grid, int row)
{
    return (grid->rows[row].block - grid->block_begin) * LB_BLOCK;
}

/* Boundary and stretches of the grid both ascend by particle. */
static void mark_boundary(lb_solid *lb)
{
    const lb_grid *grid = &lb->form.grid;
    const lb_tiles *tiles = &lb->form.tiles;
    memset(tiles->wanted, 0, (size_t)tiles->rows * (size_t)tiles->columns);
    int n = 0;
    for (int row = 0; row < grid->row_count; ++row) {
        const lb_stretch last = grid->stretches[grid->rows[row + 1].stretch - 1];
        for (; n < lb->head.boundary_count; ++n) {
            const int l = lb->head.boundary[n];
            if (l >= last.particle + last.count) break;
            const int column = grid->place[l] - begin_of(grid, row) + first_column(grid, row);
            tiles->wanted[row / TILE * tiles->columns + column / TILE] = BOUNDARY;
        }
    }
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int most(int a, int b)
{
    return a > b ? a : b;
}

static void mark_heard(const lb_tiles *tiles, int rings)
{
    for (int row = 0; row < tiles->rows; ++row)
        for (int column = 0; column < tiles->columns; ++column) {
            if (!(tiles->wanted[row * tiles->columns + column] & BOUNDARY)) continue;
            const int left = most(column - rings, 0);
            const int right = least(column + rings, tiles->columns - 1);
            for (int r = most(row - rings, 0); r <= least(row + rings, tiles->rows - 1); ++r)
                for (int c = left; c <= right; ++c) tiles->wanted[r * tiles->columns + c] |= HEARD;
        }
}

/* Of a row of places, in those tiles of the row that are wanted. */
static void add_row(const lb_solid *lb, int row, fw_vec2 velocity)
{
    const lb_grid *grid = &lb->form.grid;
    const lb_tiles *tiles = &lb->form.tiles;
    const uint8_t *wanted = tiles->wanted + row / TILE * tiles->columns;
    const int begin = first_column(grid, row), next = grid->rows[row + 1].run;
    const int end = begin + grid->runs[next - 1].end - begin_of(grid, row);
    for (int first = 0, last; first < tiles->columns; first = last) {
        last = first + 1;
        if (!wanted[first]) continue;
        while (last < tiles->columns && wanted[last]) ++last;
        const int from = most(first * TILE, begin), to = least(last * TILE, end);
        if (from < to)
            lb_displacements_add_squares(lb, row, begin_of(grid, row) + from - begin, to - from,
                                         velocity, lb->form.heaviest, tiles->sums + from);
    }
}

/* Squares of all tiles that are wanted, and 0 of the others. Returns their sum. */
static double sum_tiles(const lb_solid *lb, fw_vec2 velocity)
{
    const lb_tiles *tiles = &lb->form.tiles;
    double total = 0;
    for (int row = 0; row < tiles->rows; ++row) {
        memset(tiles->sums, 0, (size_t)tiles->columns * TILE * sizeof *tiles->sums);
        const int end = least((row + 1) * TILE, lb->form.grid.row_count);
        for (int r = row * TILE; r < end; ++r) add_row(lb, r, velocity);
        for (int column = 0; column < tiles->columns; ++column) {
            double sum = 0;
            for (int k = 0; k < TILE; ++k) sum += tiles->sums[column * TILE + k];
            tiles->squares[row * tiles->columns + column] = 0.25 * sum;
            total += 0.25 * sum;
        }
    }
    return total;
}

/* The tiles that lie `ring` away from one. */
static double sum_ring(const lb_tiles *tiles, int row, int column, int ring)
{
    const int left = most(column - ring, 0), right = least(column + ring, tiles->columns - 1);
    double sum = 0;
    for (int r = most(row - ring, 0); r <= least(row + ring, tiles->rows - 1); ++r) {
        const double *squares = tiles->squares + r * tiles->columns;
        if (r == row - ring || r == row + ring) {
            for (int c = left; c <= right; ++c) sum += squares[c];
            continue;
        }
        if (column - ring >= 0) sum += squares[column - ring];
        if (column + ring < tiles->columns) sum += squares[column + ring];
    }
    return sum;
}

/* most_heard[k]: of any tile with boundary, the sum over what is k tiles away or nearer. */
static void find_most_heard(const lb_tiles *tiles, int rings, double *most_heard)
{
    for (int ring = 0; ring <= rings; ++ring) most_heard[ring] = 0;
    for (int row = 0; row < tiles->rows; ++row)
        for (int column = 0; column < tiles->columns; ++column) {
            if (!(tiles->wanted[row * tiles->columns + column] & BOUNDARY)) continue;
            double sum = tiles->squares[row * tiles->columns + column];
            for (int ring = 1; ring <= rings; ++ring) {
                sum += sum_ring(tiles, row, column, ring);
                most_heard[ring] = fmax(most_heard[ring], sum);
            }
        }
}

/* What rounding can add. A tick rounds x by a few last bits, and what that adds to sqrt(S) is heard
 * from (2 n + 1)^2 sites at most, in n ticks each. */
static double rounding(int ticks, double farthest)
{
    const double n = ticks;
    return 8 * DBL_EPSILON * n * n * (2 * n + 1) * farthest;
}

double lb_reach(const fw_solid *solid, int ticks)
{
    lb_solid *lb = (lb_solid *)solid;
    const lb_tiles *tiles = &lb->form.tiles;
    const int rings = (ticks + TILE - 1) / TILE;
    double most_heard[RINGS_MAX + 1];
    if (!lb->displaced || solid->loaded || tiles->columns == 0 || rings > RINGS_MAX)
        return INFINITY;
    if (solid->boundary_count == 0) return 0;
    const edge_sums edge = sums_of_boundary(lb);
    const double speed = sqrt(fw_vec2_dot(edge.velocity, edge.velocity));
    mark_boundary(lb);
    mark_heard(tiles, rings);
    const double total = sum_tiles(lb, edge.velocity);
    if (!isfinite(total)) return INFINITY;
    find_most_heard(tiles, rings, most_heard);
    double reach = ticks * speed;
    for (int ring = 1; ring <= rings; ++ring)
        reach += least(TILE, ticks - (ring - 1) * TILE) *
                 sqrt(2 * most_heard[ring] * edge.lightest); /* (1) */
    const double farthest = edge.farthest + ticks * (speed + 2 * sqrt(total));
    return (1 + 1e-9) * reach + rounding(ticks, farthest);
}
