/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_grid.c - the sites of a body as rows of blocks. Keeps no state.
 * Start reading at walk(), which counts and, the second time, fills. */
#include "lb_grid.h"

#include <limits.h>

/* The grid may have so many places per particle, and a few more. */
enum { SPARSE = 4, FEW = 4096 };

static int block_of(fw_site site)
{
    return site.i >> 3; /* rounded down, below zero too */
}

/* Behind the last particle of the row, or of the block, that begins with this one. */
static int end_of_row(const fw_sites *sites, int first)
{
    int l = first;
    while (l < sites->count && sites->site[l].j == sites->site[first].j)
        l = fw_sites_run_end(sites, l);
    return l;
}

static int end_of_block(const fw_sites *sites, int first, int row_end)
{
    int l = first;
    const int whole = first + LB_BLOCK;
    if (whole <= row_end && block_of(sites->site[whole - 1]) == block_of(sites->site[first]))
        return whole;
    while (l < row_end && block_of(sites->site[l]) == block_of(sites->site[first])) ++l;
    return l;
}

/* Places of a row: an odd number of blocks, that is of cache lines, so that rows above each other
 * do not meet in one set of a cache. */
static int64_t length_of_row(const fw_sites *sites, int first, int end)
{
    const int64_t blocks =
        (int64_t)block_of(sites->site[end - 1]) - block_of(sites->site[first]) + 1;
    return (blocks | 1) * LB_BLOCK;
}

/* Up to eight bytes, the first one lowest. */
static uint64_t word_of(const uint8_t *bytes, int count)
{
    uint64_t word = 0;
    if (count == LB_BLOCK)
        for (int k = 0; k < LB_BLOCK; ++k) word |= (uint64_t)bytes[k] << 8 * k;
    else
        for (int k = 0; k < count; ++k) word |= (uint64_t)bytes[k] << 8 * k;
    return word;
}

static void add_run(lb_grid *grid, lb_run run, bool fill)
{
    if (run.begin == run.end) return;
    if (fill) grid->runs[grid->run_count] = run;
    grid->run_count += 1;
}

static void add_runs(lb_grid *grid, const lb_grid_def *def, int first, int end, int64_t shift,
                     bool fill)
{
    lb_run run = {0};
    for (int l = first, next; l < end; l = next) {
        next = end_of_block(def->sites, l, end);
        const bool plain =
            next - l == LB_BLOCK && word_of(def->plain + l, LB_BLOCK) == 0x0101010101010101;
        const int begin = (int)(shift + (int64_t)block_of(def->sites->site[l]) * LB_BLOCK);
        if (run.end != begin || run.plain != plain) {
            add_run(grid, run, fill);
            run = (lb_run){.begin = begin, .plain = plain};
        }
        run.end = begin + LB_BLOCK;
    }
    add_run(grid, run, fill);
}

/* Bit d of each byte as bit k of one: that of byte k, at 8 k, comes to 56 + k times 2^(56 - 7 k),
 * and nothing else does. */
static unsigned bits_of(uint64_t word, int d)
{
    return (unsigned)((word >> d & 0x0101010101010101) * 0x0102040810204080 >> 56);
}

static void fill_stretch(lb_grid *grid, const lb_grid_def *def, lb_stretch stretch)
{
    const uint8_t *present = def->present + stretch.particle;
    for (int k = 0; k < stretch.count; ++k) grid->place[stretch.particle + k] = stretch.place + k;
    for (int k = 0, next; k < stretch.count; k = next) {
        const int place = stretch.place + k, lane = place % LB_BLOCK;
        uint8_t *links = grid->links[place / LB_BLOCK];
        next = k + LB_BLOCK - lane < stretch.count ? k + LB_BLOCK - lane : stretch.count;
        const uint64_t word = word_of(present + k, next - k);
        for (int d = 0; d < FW_DIRECTIONS; ++d) links[d] |= (uint8_t)(bits_of(word, d) << lane);
    }
}

static void add_stretches(lb_grid *grid, const lb_grid_def *def, int first, int end, int64_t shift,
                          bool fill)
{
    for (int l = first, next; l < end; l = next) {
        next = fw_sites_run_end(def->sites, l);
        const lb_stretch stretch = {
            .particle = l, .place = (int)(shift + def->sites->site[l].i), .count = next - l};
        if (fill) {
            grid->stretches[grid->stretch_count] = stretch;
            fill_stretch(grid, def, stretch);
        }
        grid->stretch_count += 1;
    }
}

/* Does the row that begins with this particle lie right above the one before it, with columns that
 * both have? */
static bool lies_above(const fw_sites *sites, int first, int first_before, int end)
{
    if (first == 0 || (int64_t)sites->site[first].j - sites->site[first - 1].j != 1) return false;
    return block_of(sites->site[first]) <= block_of(sites->site[first - 1]) &&
           block_of(sites->site[first_before]) <= block_of(sites->site[end - 1]);
}

/* A particle of a row lies at place shift + i. */
static int64_t walk(lb_grid *grid, const lb_grid_def *def, bool fill)
{
    const fw_sites *sites = def->sites;
    int64_t begin = grid->longest, shift_before = 0;
    int first_before = 0;
    grid->row_count = grid->run_count = grid->stretch_count = 0;
    for (int first = 0, end; first < sites->count; first = end) {
        end = end_of_row(sites, first);
        const int64_t shift = begin - (int64_t)block_of(sites->site[first]) * LB_BLOCK;
        if (fill) {
            lb_row *row = &grid->rows[grid->row_count];
            *row = (lb_row){.run = grid->run_count,
                            .stretch = grid->stretch_count,
                            .block = block_of(sites->site[first])};
            if (lies_above(sites, first, first_before, end)) {
                row[-1].north = (int)(shift - shift_before);
                row->south = -row[-1].north;
            }
        }
        add_runs(grid, def, first, end, shift, fill);
        add_stretches(grid, def, first, end, shift, fill);
        grid->row_count += 1;
        begin += length_of_row(sites, first, end);
        shift_before = shift;
        first_before = first;
    }
    return begin + grid->longest;
}

/* Places of all rows, and of the longest. */
static int64_t add_lengths(const fw_sites *sites, int64_t *longest)
{
    int64_t places = 0;
    *longest = 0;
    for (int first = 0, end; first < sites->count; first = end) {
        end = end_of_row(sites, first);
        const int64_t length = length_of_row(sites, first, end);
        *longest = length > *longest ? length : *longest;
        places += length;
    }
    return places;
}

bool lb_grid_pays(const fw_sites *sites)
{
    int64_t longest;
    const int64_t places = add_lengths(sites, &longest);
    return places <= (int64_t)SPARSE * sites->count + FEW && places < INT_MAX / 2;
}

static void find_columns(lb_grid *grid, const fw_sites *sites)
{
    int least = INT_MAX, most = INT_MIN;
    for (int first = 0, end; first < sites->count; first = end) {
        end = end_of_row(sites, first);
        if (block_of(sites->site[first]) < least) least = block_of(sites->site[first]);
        if (block_of(sites->site[end - 1]) > most) most = block_of(sites->site[end - 1]);
    }
    grid->block_begin = least;
    grid->block_end = most + 1;
}

void lb_grid_measure(lb_grid *grid, const lb_grid_def *def)
{
    int64_t longest;
    find_columns(grid, def->sites);
    add_lengths(def->sites, &longest);
    grid->longest = (int)longest;
    grid->place_count = (int)walk(grid, def, false);
}

void lb_grid_fill(lb_grid *grid, const lb_grid_def *def)
{
    walk(grid, def, true);
    grid->rows[grid->row_count] = (lb_row){.run = grid->run_count, .stretch = grid->stretch_count};
}
