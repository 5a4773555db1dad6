/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_tiles.c - is the energy of a body a sum over tiles none of which is ever negative?
 * Keeps no state. Start reading at fw_automaton_tiles_are_positive().
 *
 * A bond gives each square of four cells beside it an equal share of its weight, and a tile is so
 * many squares side by side. So bonds within a tile have the weight 1, and those along its sides
 * 1/2, or 1 for `bond` where nothing lies beyond that side. There are few kinds of tiles, whatever
 * the size of the body: of one square each for any shape, larger ones for rectangles. That none is
 * ever negative is sufficient and costs nothing beside the body's own form; it is not necessary:
 * close to the limit of stability, a small tile can be negative in a stable body. */
#include "automaton_stability.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Four tiles may share a cell, whose mass is shifted by 1e-12 in all: as the whole form is. */
#define SHIFT 0.25e-12
enum {
    TILE = 8, /* squares along the side of a tile; the last one has up to 2 TILE - 1 */
    MOST = 2 * (2 * TILE) * (2 * TILE) /* numbers that move such a tile */
};

typedef struct tile {
    int columns, rows;               /* of squares */
    int colour;                      /* of its south-west cell */
    double east, north, west, south; /* weights of the bonds along its sides */
} tile;

/* Rows of the form; entries further than `band` from the diagonal are zero. */
typedef struct form {
    int size, band;
    double *entry;
} form;

static void add_block(form *f, int row, int column, fw_sym2 block)
{
    double *at = f->entry + 2 * row * f->size + 2 * column;
    at[0] += block.xx;
    at[1] += block.xy;
    at[f->size] += block.xy;
    at[f->size + 1] += block.yy;
}

/* Halved, as the form of the body: masses on the diagonal. */
static void add_bond(form *f, int from, int to, fw_sym2 matrix, double weight)
{
    const fw_sym2 half = fw_sym2_scale(0.5 * weight, matrix);
    add_block(f, from, from, half);
    add_block(f, to, to, half);
    add_block(f, from, to, fw_sym2_scale(-1, half));
    add_block(f, to, from, fw_sym2_scale(-1, half));
}

/* 1/2 sum_bonds weight (u_p - u_q) B (u_p - u_q) / 2 of a tile, row by row. */
static void fill(form *f, const fw_automaton *body, const tile *t)
{
    const int across = t->columns + 1, up = t->rows + 1;
    f->size = 2 * across * up;
    f->band = 2 * across + 1;
    memset(f->entry, 0, (size_t)f->size * (size_t)f->size * sizeof *f->entry);
    for (int j = 0; j < up; ++j)
        for (int i = 0; i < across; ++i) {
            const fw_automaton_colour *colour = &body->colour[(t->colour + i + j) % FW_COLOURS];
            const int cell = i + across * j;
            const double along = j == 0 ? t->south : j == t->rows ? t->north : 1;
            const double upward = i == 0 ? t->west : i == t->columns ? t->east : 1;
            if (i < t->columns) add_bond(f, cell, cell + 1, *colour->matrix[FW_EAST], along);
            if (j < t->rows) add_bond(f, cell, cell + across, *colour->matrix[FW_NORTH], upward);
        }
    for (int k = 0; k < f->size; ++k) f->entry[k * f->size + k] += SHIFT;
}

/* Cholesky's factorisation, in place. */
static bool is_positive(form *f)
{
    for (int r = 0; r < f->size; ++r) {
        double *row = f->entry + r * f->size;
        const int first = r > f->band ? r - f->band : 0;
        for (int c = first; c <= r; ++c) {
            const double *other = f->entry + c * f->size;
            double sum = row[c];
            for (int k = first; k < c; ++k) sum -= row[k] * other[k];
            if (c == r && !(sum > 0)) return false;
            row[c] = c == r ? sqrt(sum) : sum / other[c];
        }
    }
    return true;
}

/* In both ways of colouring it. */
static bool tile_is_positive(form *f, const fw_automaton *body, tile t)
{
    for (t.colour = 0; t.colour < FW_COLOURS; ++t.colour) {
        fill(f, body, &t);
        if (!is_positive(f)) return false;
    }
    return true;
}

/* Of a tile's side, where the body ends or not. */
static double side_weight(const fw_automaton *body, bool ends)
{
    return ends && body->boundary == FW_BOUNDARY_BOND ? 1 : 0.5;
}

/* --- single squares, for all shapes --- */

static bool squares_are_positive(form *f, const fw_automaton *body)
{
    for (int ends = 0; ends < 1 << FW_DIRECTIONS; ++ends) {
        const tile square = {.columns = 1,
                             .rows = 1,
                             .east = side_weight(body, ends & 1),
                             .north = side_weight(body, ends & 2),
                             .west = side_weight(body, ends & 4),
                             .south = side_weight(body, ends & 8)};
        if (!tile_is_positive(f, body, square)) return false;
    }
    return true;
}

static int beyond(const fw_automaton *body, int colour, int cell, int direction)
{
    double weight;
    return cell < 0 ? -1 : fw_automaton_cell_neighbour(body, colour, cell, direction, &weight);
}

/* Is there a square on one side or the other of a bond? */
static bool borders_square(const fw_automaton *body, int colour, int cell, int direction)
{
    const int partner = beyond(body, colour, cell, direction);
    for (int turn = 1; turn <= 3; turn += 2) {
        const int sideways = (direction + turn) % FW_DIRECTIONS;
        const int near = beyond(body, colour, cell, sideways);
        if (beyond(body, !colour, partner, sideways) >= 0 &&
            beyond(body, !colour, near, direction) >= 0)
            return true;
    }
    return false;
}

/* Bonds between cells that are not at a rim have squares on both sides. */
static bool all_bonds_border_squares(const fw_automaton *body)
{
    for (int colour = 0; colour < FW_COLOURS; ++colour)
        for (int n = 0; n < body->colour[colour].rim_count; ++n) {
            const fw_automaton_rim *rim = &body->colour[colour].rim[n];
            for (int d = 0; d < FW_DIRECTIONS; ++d)
                if (rim->neighbour[d] >= 0 && !borders_square(body, colour, rim->cell, d))
                    return false;
        }
    return true;
}

/* --- larger tiles, for rectangles --- */

/* Tiles along one side of a rectangle: the first, one between others, the last. */
typedef struct cut {
    int count;
    int length[3];
    bool begins[3], ends[3]; /* where the body does */
} cut;

static cut cut_side(int squares)
{
    const int tiles = squares / TILE > 1 ? squares / TILE : 1;
    const int last = squares - TILE * (tiles - 1);
    if (tiles == 1) return (cut){1, {last}, {true}, {true}};
    if (tiles == 2) return (cut){2, {TILE, last}, {true, false}, {false, true}};
    return (cut){3, {TILE, TILE, last}, {true, false, false}, {false, false, true}};
}

/* All rows alike, without seams. */
static bool is_rectangle(const fw_automaton *body)
{
    const fw_automaton_run *first = &body->run[0];
    if (body->run_count != body->row_count) return false;
    for (int r = 0; r < body->run_count; ++r) {
        const fw_automaton_run *run = &body->run[r];
        if (run->site.i != first->site.i || run->count != first->count ||
            run->site.j != first->site.j + r)
            return false;
    }
    const int colour = body->white[0];
    return first->count > 1 && body->run_count > 1 &&
           beyond(body, colour, body->cell[0], FW_WEST) < 0 &&
           beyond(body, colour, body->cell[0], FW_SOUTH) < 0;
}

static bool tiles_of_rectangle_are_positive(form *f, const fw_automaton *body)
{
    const cut x = cut_side(body->run[0].count - 1), y = cut_side(body->row_count - 1);
    for (int j = 0; j < y.count; ++j)
        for (int i = 0; i < x.count; ++i) {
            const tile t = {.columns = x.length[i],
                            .rows = y.length[j],
                            .east = side_weight(body, x.ends[i]),
                            .north = side_weight(body, y.ends[j]),
                            .west = side_weight(body, x.begins[i]),
                            .south = side_weight(body, y.begins[j])};
            if (!tile_is_positive(f, body, t)) return false;
        }
    return true;
}

fw_status fw_automaton_tiles_are_positive(const fw_automaton *body, bool *are, fw_error *error)
{
    form f = {.entry = fw_array_of_doubles((size_t)MOST * MOST)};
    if (!f.entry) return fw_fail_memory(error, "the stability test of an automaton");
    *are = (squares_are_positive(&f, body) && all_bonds_border_squares(body)) ||
           (is_rectangle(body) && tiles_of_rectangle_are_positive(&f, body));
    free(f.entry);
    return FW_OK;
}
