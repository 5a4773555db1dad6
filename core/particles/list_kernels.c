/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_kernels.c - slots (slots.h) from cells, and near slots from far ones; compiled once for each
 * instruction set. Keeps no state. Start reading at build(). */
#include "list_kernels.h"

#include "core/vectors.h"

#include <assert.h>
#include <string.h>

static_assert((int)FW_LANES == (int)FW_BLOCK, "a lane for each particle of a block");

/* The lanes of a block, and where they lie. */
typedef struct fw_lanes {
    int first;
    uint8_t mask;
    fw_vector x[FW_PARTS], y[FW_PARTS];
} fw_lanes;

FW_INLINE fw_lanes lanes_of(const fw_chunk *chunk, int block, const double *x, const double *y)
{
    fw_lanes lanes = {chunk->first + block * FW_LANES, fw_chunk_lanes(chunk, block), {{0}}, {{0}}};
    for (int part = 0; part < FW_PARTS; ++part) {
        lanes.x[part] = fw_load(x + lanes.first + part * FW_WIDTH);
        lanes.y[part] = fw_load(y + lanes.first + part * FW_WIDTH);
    }
    return lanes;
}

FW_INLINE fw_mask closer(fw_vector dx, fw_vector dy, double square)
{
    return fw_less(dx * dx + dy * dy, fw_splat(square));
}

/* --- who is near --- */

/* Makes the word that of words->last; false without memory. */
__attribute__((noinline)) static bool find_word(fw_near_words *words, int word)
{
    if (2 * words->count >= words->capacity && !fw_near_words_grow(words)) return false;
    words->last = fw_near_words_place(words, word);
    if (words->word[words->last] < 0) {
        words->word[words->last] = word;
        words->used[words->count++] = words->last;
    }
    return true;
}

/* Of particles that follow each other most are of one word. */
FW_INLINE void add_near(fw_near_words *words, int particle, uint64_t lanes)
{
    const int word = particle / FW_LANES;
    if (words->word[words->last] != word && !find_word(words, word)) return;
    words->bytes[words->last] |= lanes << 8 * (particle % FW_LANES);
}

/* Members of cells `from` to `to` of a row. */
FW_INLINE void look_through(const fw_cells *cells, int from, int to, const fw_lanes *lanes,
                            const double *restrict x, const double *restrict y, double square,
                            fw_near_words *words)
{
    for (int m = cells->begin[from]; m < cells->begin[to + 1]; ++m) {
        const int j = cells->member[m];
        const fw_vector xj = fw_splat(x[j]), yj = fw_splat(y[j]);
        unsigned near = 0;
        for (int part = 0; part < FW_PARTS; ++part)
            near |= fw_mask_bits(closer(lanes->x[part] - xj, lanes->y[part] - yj, square), part);
        near &= lanes->mask;
        const unsigned lane = (unsigned)(j - lanes->first);
        if (lane < FW_LANES) near &= ~(1u << lane);
        if (near) add_near(words, j, near);
    }
}

/* Columns from `left` to `right` of one row. */
FW_INLINE void look_along(const fw_cells *cells, int left, int right, int row,
                          const fw_lanes *lanes, const double *x, const double *y, double square,
                          fw_near_words *words)
{
    const int from = fw_cell_at(cells, left, row), to = fw_cell_at(cells, right, row);
    if (from <= to && right - left < cells->columns) {
        look_through(cells, from, to, lanes, x, y, square, words);
    } else { /* over the edge of the torus */
        for (int column = left; column <= right; ++column) {
            const int cell = fw_cell_at(cells, column, row);
            look_through(cells, cell, cell, lanes, x, y, square, words);
        }
    }
}

/* In a lattice the cells of a block are a few in a row; where they are scattered, the surroundings
 * of each are looked through (twice, where they overlap: that changes nothing). */
static void find_near(const fw_cells *cells, const fw_lanes *lanes, const double *x,
                      const double *y, double square, fw_near_words *words)
{
    enum { SPREAD = 12 };
    int left = cells->columns, right = 0, low = cells->rows, high = 0;
    for (int k = 0; k < FW_LANES; ++k) {
        if (!(lanes->mask >> k & 1)) continue;
        const int cell = cells->cell[lanes->first + k];
        const int row = cell / cells->columns, column = cell % cells->columns;
        left = column < left ? column : left;
        right = column > right ? column : right;
        low = row < low ? row : low;
        high = row > high ? row : high;
    }
    if ((right - left + 3) * (high - low + 3) <= 2 * SPREAD + 6 &&
        right - left + 3 <= cells->columns && high - low + 3 <= cells->rows) {
        for (int row = low - 1; row <= high + 1; ++row)
            look_along(cells, left - 1, right + 1, row, lanes, x, y, square, words);
        return;
    }
    for (int k = 0; k < FW_LANES; ++k) {
        if (!(lanes->mask >> k & 1)) continue;
        const int cell = cells->cell[lanes->first + k];
        bool seen = false;
        for (int l = 0; l < k; ++l) seen = seen || cells->cell[lanes->first + l] == cell;
        if (seen) continue;
        const int row = cell / cells->columns, column = cell % cells->columns;
        for (int dj = -1; dj <= 1; ++dj)
            look_along(cells, column - 1, column + 1, row + dj, lanes, x, y, square, words);
    }
}

/* --- slots --- */

/* Byte k of the window belongs to lane k of the slot: a lane has a neighbour there if its own bit
 * is set in its byte. Writes slot number `count`, and returns how many there are then. */
FW_INLINE uint32_t add_offset(const fw_slots *slots, uint32_t count, uint64_t window, int offset)
{
    const uint64_t own = window & 0x8040201008040201;
    slots->offset[count] = offset;
    slots->mask[count] = (uint8_t)(own * 0x0101010101010101 >> 56);
    return count + (own != 0);
}

/* The bytes of this word that belong to particles begin to end - 1. */
static uint64_t bytes_between(fw_near_word near, int begin, int end)
{
    const int first = near.word * FW_LANES;
    uint64_t bytes = near.bytes;
    if (first < begin) bytes &= first + FW_LANES <= begin ? 0 : ~(uint64_t)0 << 8 * (begin - first);
    if (first + FW_LANES > end) bytes &= first >= end ? 0 : ~(~(uint64_t)0 << 8 * (end - first));
    return bytes;
}

/* Offset slots for neighbours begin to end - 1, ascending. */
static void add_offsets(fw_slots *slots, const fw_near_words *words, int first, int begin, int end)
{
    uint64_t before = 0;
    uint32_t count = slots->count;
    for (int k = 0; k < words->taken_count; ++k) {
        const uint64_t bytes = bytes_between(words->taken[k], begin, end);
        const int word = words->taken[k].word;
        const int offset = word * FW_LANES - first;
        if (bytes || before)
            for (int s = 1; s < FW_LANES; ++s)
                count = add_offset(slots, count, before >> 8 * s | bytes << 8 * (FW_LANES - s),
                                   offset - FW_LANES + s);
        count = add_offset(slots, count, bytes, offset);
        before = bytes;
        if (before && (k + 1 == words->taken_count || words->taken[k + 1].word != word + 1)) {
            for (int s = 1; s < FW_LANES; ++s)
                count = add_offset(slots, count, before >> 8 * s, offset + s);
            before = 0;
        }
    }
    slots->count = count;
}

/* --- gather slots --- */

/* How many neighbours each lane has got, in the rows from `begin` on. */
typedef struct fw_row_fill {
    uint32_t begin;
    uint32_t count[FW_LANES];
    int first;
} fw_row_fill;

FW_INLINE void add_to_rows(fw_slots *slots, fw_row_fill *fill, int lane, int neighbour)
{
    const uint32_t at = fill->begin + fill->count[lane]++;
    if (at == slots->row_count) {
        for (int k = 0; k < FW_LANES; ++k) slots->row[at][k] = fill->first;
        slots->row_count += 1;
    }
    slots->row[at][lane] = neighbour;
}

/* A slot for each row. */
FW_INLINE void add_row_slots(fw_slots *slots, const fw_row_fill *fill)
{
    for (uint32_t n = 0; fill->begin + n < slots->row_count; ++n) {
        unsigned mask = 0;
        for (int k = 0; k < FW_LANES; ++k) mask |= (unsigned)(fill->count[k] > n) << k;
        slots->offset[slots->count] = (int32_t)(fill->begin + n);
        slots->mask[slots->count++] = (uint8_t)mask;
    }
}

/* Lets each lane's neighbours ascend by the solid's numbers. */
static void sort_rows(fw_slots *slots, const fw_row_fill *fill, const int *number)
{
    enum { KEPT_MAX = 256 }; /* neighbours whose numbers are kept at hand */
    int32_t(*row)[FW_LANES] = slots->row + fill->begin;
    for (int lane = 0; lane < FW_LANES; ++lane) {
        int kept[KEPT_MAX];
        for (uint32_t n = 0; n < fill->count[lane]; ++n) {
            const int32_t neighbour = row[n][lane];
            const int own = number[neighbour];
            uint32_t place = n;
            for (; place > 0; --place) {
                const int before =
                    place <= KEPT_MAX ? kept[place - 1] : number[row[place - 1][lane]];
                if (before < own) break;
                row[place][lane] = row[place - 1][lane];
                if (place < KEPT_MAX) kept[place] = before;
            }
            row[place][lane] = neighbour;
            if (place < KEPT_MAX) kept[place] = own;
        }
    }
}

/* Turns the offset slots from `begin` on into gather slots, if they are more than `favour` times as
 * many. `number`, unless NULL: by which numbers neighbours are to ascend. */
static bool gather(fw_slots *slots, uint32_t begin, int first, double favour, const int *number,
                   bool *failed)
{
    uint32_t count[FW_LANES] = {0}, most = 0;
    int all = 0;
    for (uint32_t s = begin; s < slots->count; ++s) all += __builtin_popcount(slots->mask[s]);
    if ((slots->count - begin) * FW_LANES <= favour * all) return false;
    for (uint32_t s = begin; s < slots->count; ++s)
        for (int k = 0; k < FW_LANES; ++k) count[k] += slots->mask[s] >> k & 1;
    for (int k = 0; k < FW_LANES; ++k) most = count[k] > most ? count[k] : most;
    if (slots->count - begin <= favour * most) return false;
    if (!fw_slots_reserve(slots, 0, most)) {
        *failed = true;
        return false;
    }
    fw_row_fill fill = {.begin = slots->row_count, .first = first};
    for (uint32_t s = begin; s < slots->count; ++s)
        for (unsigned mask = slots->mask[s]; mask; mask &= mask - 1) {
            const int lane = __builtin_ctz(mask);
            add_to_rows(slots, &fill, lane, first + lane + slots->offset[s]);
        }
    if (number) sort_rows(slots, &fill, number);
    slots->count = begin;
    add_row_slots(slots, &fill);
    return true;
}

/* --- building --- */

/* Has this block the slots of the one before? Mostly so in a lattice, where the same lanes are near
 * to what lies at the same offsets. Neither may see other bodies: words go up, so that lower ones
 * are asked for of the block before, higher ones of this. */
static bool is_like_before(const fw_chunk *chunk, const fw_slot_head *before,
                           const fw_near_words *words)
{
    if (words->taken_count == 0 || !fw_near_words_repeat(words)) return false;
    const int last = words->taken[words->taken_count - 1].word;
    return before->count[0] == 0 && (last + 1) * FW_LANES <= chunk->body_end &&
           !before->gathered[FW_RUN_OWN];
}

static void repeat_slots(fw_slots *slots, const fw_slot_head *before, fw_slot_head *head)
{
    const uint32_t count = before->count[FW_RUN_OWN];
    *head = *before;
    head->begin = slots->count;
    memcpy(slots->offset + head->begin, slots->offset + before->begin,
           count * sizeof *slots->offset);
    memcpy(slots->mask + head->begin, slots->mask + before->begin, count * sizeof *slots->mask);
    slots->count += count;
}

static bool build(fw_chunk *chunk, const fw_cells *cells, const int *number, const double *x,
                  const double *y, double reach, double favour, fw_near_words *words)
{
    fw_slots *slots = &chunk->far;
    slots->count = slots->row_count = 0;
    if (!words->capacity && !fw_near_words_grow(words)) return false;
    fw_near_words_forget(words);
    const int bounds[FW_SLOT_RUNS + 1] = {0, chunk->body_first, chunk->body_end, cells->count};
    bool failed = false;
    for (int block = 0; block < fw_chunk_blocks(chunk); ++block) {
        const fw_lanes lanes = lanes_of(chunk, block, x, y);
        find_near(cells, &lanes, x, y, reach * reach, words);
        fw_near_words_take(words);
        /* A word touches at most 15 offsets, of which one is written and then taken back. */
        failed = failed || words->failed ||
                 !fw_slots_reserve(slots, (size_t)words->taken_count * 15 * FW_SLOT_RUNS + 1, 0);
        if (failed) break;
        fw_slot_head *head = &slots->head[block];
        if (block > 0 && is_like_before(chunk, head - 1, words)) {
            repeat_slots(slots, head - 1, head);
            continue;
        }
        head->begin = slots->count;
        for (int run = 0; run < FW_SLOT_RUNS; ++run) {
            const uint32_t begin = slots->count;
            add_offsets(slots, words, lanes.first, bounds[run], bounds[run + 1]);
            const bool in_order = chunk->in_order[run];
            head->gathered[run] = gather(slots, begin, lanes.first, in_order ? favour : 0,
                                         in_order ? NULL : number, &failed);
            head->count[run] = slots->count - begin;
        }
    }
    return !failed;
}

/* --- renewing --- */

FW_INLINE uint8_t near_offset(const fw_lanes *lanes, int offset, uint8_t mask, const double *x,
                              const double *y, double square)
{
    unsigned near = 0;
    for (int part = 0; part < FW_PARTS; ++part) {
        const int at = lanes->first + offset + part * FW_WIDTH;
        near |= fw_mask_bits(
            closer(lanes->x[part] - fw_load(x + at), lanes->y[part] - fw_load(y + at), square),
            part);
    }
    return (uint8_t)(near & mask);
}

FW_INLINE uint8_t near_row(const fw_lanes *lanes, const int32_t *row, uint8_t mask, const double *x,
                           const double *y, double square)
{
    unsigned near = 0;
    for (int part = 0; part < FW_PARTS; ++part) {
        const fw_vector xj = fw_gather(x, row + part * FW_WIDTH);
        const fw_vector yj = fw_gather(y, row + part * FW_WIDTH);
        near |= fw_mask_bits(closer(lanes->x[part] - xj, lanes->y[part] - yj, square), part);
    }
    return (uint8_t)(near & mask);
}

FW_INLINE void renew_offsets(const fw_slots *far, uint32_t begin, uint32_t count, fw_slots *near,
                             const fw_lanes *lanes, const double *x, const double *y, double square)
{
    uint32_t kept = near->count;
    for (uint32_t s = begin; s < begin + count; ++s) {
        const uint8_t mask = near_offset(lanes, far->offset[s], far->mask[s], x, y, square);
        near->offset[kept] = far->offset[s];
        near->mask[kept] = mask;
        kept += mask != 0;
    }
    near->count = kept;
}

FW_INLINE void renew_rows(const fw_slots *far, uint32_t begin, uint32_t count, fw_slots *near,
                          const fw_lanes *lanes, const double *x, const double *y, double square)
{
    fw_row_fill fill = {.begin = near->row_count, .first = lanes->first};
    for (uint32_t s = begin; s < begin + count; ++s) {
        const int32_t *row = far->row[far->offset[s]];
        for (unsigned mask = near_row(lanes, row, far->mask[s], x, y, square); mask;
             mask &= mask - 1) {
            const int lane = __builtin_ctz(mask);
            add_to_rows(near, &fill, lane, row[lane]);
        }
    }
    add_row_slots(near, &fill);
}

/* Offsets ascend. */
static bool is_whole(const fw_chunk *chunk, const fw_slots *slots, int first, uint32_t begin)
{
    return slots->count > begin && first + slots->offset[begin] >= chunk->body_first &&
           first + slots->offset[slots->count - 1] + FW_LANES <= chunk->body_end;
}

static void renew(fw_chunk *chunk, const double *x, const double *y, double reach)
{
    const fw_slots *far = &chunk->far;
    fw_slots *near = &chunk->near;
    near->count = near->row_count = 0;
    for (int block = 0; block < fw_chunk_blocks(chunk); ++block) {
        const fw_lanes lanes = lanes_of(chunk, block, x, y);
        const fw_slot_head *old = &far->head[block];
        fw_slot_head *head = &near->head[block];
        *head = *old;
        head->begin = near->count;
        uint32_t from = old->begin;
        for (int run = 0; run < FW_SLOT_RUNS; ++run) {
            const uint32_t begin = near->count;
            if (old->gathered[run])
                renew_rows(far, from, old->count[run], near, &lanes, x, y, reach * reach);
            else
                renew_offsets(far, from, old->count[run], near, &lanes, x, y, reach * reach);
            if (run == FW_RUN_OWN)
                head->whole = !old->gathered[run] && is_whole(chunk, near, lanes.first, begin);
            head->count[run] = near->count - begin;
            from += old->count[run];
        }
    }
}

/* --- distances --- */

/* Of the lanes that have a neighbour in this slot. */
FW_INLINE void take_closer(const fw_lanes *lanes, const fw_slots *slots, uint32_t slot,
                           bool gathered, const double *x, const double *y, fw_vector *least)
{
    const int32_t offset = slots->offset[slot];
    for (int part = 0; part < FW_PARTS; ++part) {
        const int first = part * FW_WIDTH, at = lanes->first + offset + first;
        const fw_vector xj = gathered ? fw_gather(x, slots->row[offset] + first) : fw_load(x + at);
        const fw_vector yj = gathered ? fw_gather(y, slots->row[offset] + first) : fw_load(y + at);
        const fw_vector dx = lanes->x[part] - xj, dy = lanes->y[part] - yj;
        const fw_mask mask = fw_mask_of(slots->mask[slot], part);
        *least = fw_select(mask, fw_smaller(dx * dx + dy * dy, *least), *least);
    }
}

static double closest(const fw_chunk *chunk, const double *x, const double *y)
{
    const fw_slots *near = &chunk->near;
    fw_vector least = fw_splat(INFINITY);
    for (int block = 0; block < fw_chunk_blocks(chunk); ++block) {
        const fw_lanes lanes = lanes_of(chunk, block, x, y);
        const fw_slot_head *head = &near->head[block];
        uint32_t slot = head->begin;
        for (int run = 0; run < FW_SLOT_RUNS; ++run)
            for (uint32_t end = slot + head->count[run]; slot < end; ++slot)
                take_closer(&lanes, near, slot, head->gathered[run], x, y, &least);
    }
    double smallest = INFINITY;
    for (int lane = 0; lane < FW_WIDTH; ++lane)
        smallest = least[lane] < smallest ? least[lane] : smallest;
    return smallest;
}

const fw_list_kernels FW_KERNELS_HERE(fw_lists) = {
    .build = build, .renew = renew, .closest = closest};
