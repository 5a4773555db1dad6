/* SPDX-License-Identifier: GPL-3.0-or-later */
/* neighbour_lists.c - when lists of slots are made and renewed.
 * State: the lists, the positions that the far ones were made for, and how far particles may still
 * move before either is to be looked at. Invariant after a refresh: the near lists hold every pair
 * within reach. Start reading at fw_neighbour_lists_refresh(). */
#include "core/particles/neighbour_lists.h"

#include "list_guard.h"
#include "list_kernels.h"
#include "list_order.h"

#include <assert.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

enum {
    CHUNK = 512,          /* particles */
    PARALLEL_FROM = 1024, /* particles; below it threads cost more than they bring */
    RENUMBER_FROM = 2048, /* particles; smaller bodies lie in the nearest cache anyway */
    NEAR_EACH = 24,       /* slots of a block, to begin with; a dense solid has 12 to 36; */
    FAR_EACH = 36,        /* as far ones are made, some more are reserved than come to be; */
    SLOT_BYTES = 5,       /* an offset and a mask: four times as many keep offsets aligned */
    WEIGH_EVERY = 64,     /* renewals after which the reach of near lists is weighed again */
    WEIGHED = 8           /* chunks that are looked at for it */
};

/* A gather takes so many times as long as a load. */
#define FAVOUR 2.5

struct fw_neighbour_lists {
    int count, chunk_count, body_count;
    fw_chunk *chunks;
    int *first_chunk;        /* of each body, and the end */
    fw_slot_head *heads;     /* of all chunks, */
    char *slots;             /* and what their slots have to begin with */
    double reach, far, near; /* what the lists hold lies within these */
    double favour;           /* of offset slots, see list_kernels.h */
    fw_cells cells;
    double *built_x, *built_y; /* positions that the far lists were made for */
    fw_list_box *boxes;        /* one per cell */
    fw_arena arena;            /* of heads, slots, built_x, built_y, boxes */
    int threads;
    fw_near_words *words; /* of each thread */
    const double *x, *y;  /* positions in the lists' order */
    fw_list_order order;
    /* Particles may come closer by so much before the near, the far lists are looked at. */
    double near_slack, far_slack;
    int64_t renewals;
    /* Since the reach of the near lists was last weighed: by how much particles may have come
     * closer, in how many calls. */
    double travelled;
    int64_t calls;
    int64_t made;
};

/* --- memory --- */

/* Offsets and behind them masks: of slots that are lent, in the same piece of memory for all. */
static bool lengthen(fw_slots *slots, size_t capacity)
{
    int32_t *offset = malloc(capacity * (sizeof *slots->offset + sizeof *slots->mask));
    if (!offset) return false;
    uint8_t *mask = (uint8_t *)(offset + capacity);
    memcpy(offset, slots->offset, slots->count * sizeof *offset);
    memcpy(mask, slots->mask, slots->count * sizeof *mask);
    if (!slots->lent) free(slots->offset);
    slots->offset = offset;
    slots->mask = mask;
    slots->capacity = capacity;
    slots->lent = false;
    return true;
}

bool fw_slots_reserve(fw_slots *slots, size_t more, size_t more_rows)
{
    const size_t wanted = slots->count + more, rows = slots->row_count + more_rows;
    if (wanted > slots->capacity && !lengthen(slots, wanted + wanted / 2)) return false;
    if (rows > slots->row_capacity) {
        const size_t capacity = rows + rows / 2;
        void *longer = realloc(slots->row, capacity * sizeof *slots->row);
        if (!longer) return false;
        slots->row = longer;
        slots->row_capacity = capacity;
    }
    return true;
}

static void release_slots(fw_slots *slots)
{
    if (!slots->lent) free(slots->offset);
    free(slots->row);
}

void fw_near_words_release(fw_near_words *words)
{
    free(words->word);
    free(words->bytes);
    free(words->used);
    free(words->taken);
    free(words->before);
    *words = (fw_near_words){0};
}

bool fw_near_words_grow(fw_near_words *words)
{
    enum { LEAST = 128 };
    const int capacity = words->capacity ? 2 * words->capacity : LEAST;
    const size_t size = (size_t)capacity;
    fw_near_words grown = {.capacity = capacity,
                           .word = malloc(size * sizeof *grown.word),
                           .bytes = calloc(size, sizeof *grown.bytes),
                           .used = malloc(size * sizeof *grown.used),
                           .taken = malloc(size * sizeof *grown.taken),
                           .before = malloc(size * sizeof *grown.before),
                           .taken_count = -1,
                           .before_count = -1};
    if (!grown.word || !grown.bytes || !grown.used || !grown.taken || !grown.before) {
        fw_near_words_release(&grown);
        words->failed = true;
        return false;
    }
    for (int k = 0; k < capacity; ++k) grown.word[k] = -1;
    for (int k = 0; k < words->count; ++k) {
        const int used = words->used[k];
        int at = fw_near_words_place(&grown, words->word[used]);
        grown.word[at] = words->word[used];
        grown.bytes[at] = words->bytes[used];
        grown.used[grown.count++] = at;
    }
    fw_near_words_release(words);
    *words = grown;
    return true;
}

void fw_neighbour_lists_destroy(fw_neighbour_lists *lists)
{
    if (!lists) return;
    for (int c = 0; lists->chunks && c < lists->chunk_count; ++c) {
        release_slots(&lists->chunks[c].far);
        release_slots(&lists->chunks[c].near);
    }
    for (int t = 0; lists->words && t < lists->threads; ++t)
        fw_near_words_release(&lists->words[t]);
    free(lists->chunks);
    free(lists->first_chunk);
    fw_cells_release(&lists->cells);
    fw_arena_release(&lists->arena);
    free(lists->words);
    fw_list_order_release(&lists->order);
    free(lists);
}

/* Lends slots what comes next of the heads and of the rest; moves both on. */
static void lend(fw_slots *slots, size_t blocks, size_t each, fw_slot_head **head, char **memory)
{
    const size_t capacity = blocks * each;
    *slots = (fw_slots){.head = *head, .capacity = capacity, .lent = true};
    slots->offset = (int32_t *)(void *)*memory;
    slots->mask = (uint8_t *)(slots->offset + capacity);
    *head += blocks;
    *memory += capacity * (sizeof *slots->offset + sizeof *slots->mask);
}

static void begin_chunks(fw_neighbour_lists *lists, const int *counts)
{
    int first = 0, c = 0;
    fw_slot_head *head = lists->heads;
    char *memory = lists->slots;
    for (int body = 0; body < lists->body_count; ++body) {
        lists->first_chunk[body] = c;
        for (int begin = 0; begin < counts[body]; begin += CHUNK) {
            const int left = counts[body] - begin;
            fw_chunk *chunk = &lists->chunks[c++];
            *chunk = (fw_chunk){.body = body,
                                .first = first + begin,
                                .count = left < CHUNK ? left : CHUNK,
                                .body_first = first,
                                .body_end = first + counts[body],
                                .in_order = {true, true, true}};
            const size_t blocks = (size_t)fw_chunk_blocks(chunk);
            lend(&chunk->far, blocks, FAR_EACH, &head, &memory);
            lend(&chunk->near, blocks, NEAR_EACH, &head, &memory);
        }
        first += counts[body];
    }
    lists->first_chunk[lists->body_count] = c;
}

static fw_status fail_memory(const fw_neighbour_lists *lists, fw_error *error)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory for the neighbours of %d particles",
                   lists->count);
}

/* Slots of all chunks stand in one piece of memory: it comes in large pages. */
static fw_status allocate(fw_neighbour_lists *lists, const int *counts, fw_error *error)
{
    const size_t count = (size_t)lists->count;
    size_t blocks = 0;
    for (int body = 0; body < lists->body_count; ++body)
        blocks += (size_t)(counts[body] + FW_LANES - 1) / FW_LANES;
    lists->chunks = calloc((size_t)lists->chunk_count, sizeof *lists->chunks);
    lists->first_chunk = calloc((size_t)lists->body_count + 1, sizeof *lists->first_chunk);
    lists->words = calloc((size_t)lists->threads, sizeof *lists->words);
    if (!fw_list_order_create(&lists->order, counts, lists->body_count) || !lists->chunks ||
        !lists->first_chunk || !lists->words)
        return fail_memory(lists, error);
    FW_TRY(fw_cells_create(&lists->cells, lists->count, error));
    FW_ARENA_ADD(&lists->arena, lists->heads, 2 * blocks);
    FW_ARENA_ADD(&lists->arena, lists->slots, SLOT_BYTES * blocks * (FAR_EACH + NEAR_EACH));
    FW_ARENA_ADD(&lists->arena, lists->built_x, count);
    FW_ARENA_ADD(&lists->arena, lists->built_y, count);
    FW_ARENA_ADD(&lists->arena, lists->boxes, (size_t)lists->cells.most);
    return fw_arena_allocate(&lists->arena, "the neighbours of particles", error);
}

fw_status fw_neighbour_lists_create(fw_neighbour_lists **lists, const int *counts, int bodies,
                                    double reach, double margin, fw_error *error)
{
    /* Of the margin, what the near lists get at first, see weigh_near(). */
    const double near_part = 0.2;
    assert(reach > 0 && margin >= 0);
    *lists = NULL;
    fw_neighbour_lists *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "neighbour lists");
    made->reach = reach;
    made->favour = FAVOUR;
    made->near = reach + near_part * margin;
    made->far = reach + margin;
    made->body_count = bodies;
    for (int body = 0; body < bodies; ++body) {
        made->count += counts[body];
        made->chunk_count += (counts[body] + CHUNK - 1) / CHUNK;
    }
    made->threads = omp_get_max_threads();
    const fw_status status = allocate(made, counts, error);
    if (status != FW_OK) {
        fw_neighbour_lists_destroy(made);
        return status;
    }
    begin_chunks(made, counts);
    made->near_slack = made->far_slack = -1;
    *lists = made;
    return FW_OK;
}

void fw_neighbour_lists_favour(fw_neighbour_lists *lists, double favour)
{
    lists->favour = favour;
    lists->near_slack = lists->far_slack = -1;
    lists->made = 0;
}

/* --- making and renewing --- */

static void take_positions(fw_neighbour_lists *lists, const double *x, const double *y)
{
    const fw_list_order *order = &lists->order;
    if (order->number) fw_list_order_place(order, x, y);
    lists->x = order->number ? order->x : x;
    lists->y = order->number ? order->y : y;
}

static bool fill_far(fw_neighbour_lists *lists)
{
    const double *x = lists->x, *y = lists->y;
    const fw_list_kernels *kernels = FW_KERNELS_CHOSEN(fw_lists);
    fw_cells_sort(&lists->cells, lists->far, x, y);
    int failed = 0;
#pragma omp parallel for schedule(dynamic, 8) reduction(+ : failed) num_threads(lists->threads)    \
    if (lists->count > PARALLEL_FROM)
    for (int c = 0; c < lists->chunk_count; ++c) {
        fw_chunk *chunk = &lists->chunks[c];
        fw_near_words *words = &lists->words[omp_get_thread_num()];
        chunk->near.count = chunk->near.row_count = 0;
        failed += !kernels->build(chunk, &lists->cells, lists->order.number, x, y, lists->far,
                                  lists->favour, words) ||
                  !fw_slots_reserve(&chunk->near, chunk->far.count, chunk->far.row_count);
    }
    return failed == 0;
}

static bool make_far(fw_neighbour_lists *lists, const double *x, const double *y)
{
    const int smallest = lists->favour > 0 ? RENUMBER_FROM : 0;
    if (fw_list_order_find_scattered(&lists->order, x, y, lists->far, smallest) &&
        !fw_list_order_begin(&lists->order, lists->chunks, lists->chunk_count))
        return false;
    if (lists->order.number) {
        fw_cells_sort(&lists->cells, lists->far, x, y);
        fw_list_order_renumber(&lists->order, &lists->cells);
        take_positions(lists, x, y);
    }
    if (!fill_far(lists)) return false;
    const size_t bytes = (size_t)lists->count * sizeof *x;
    memcpy(lists->built_x, lists->x, bytes);
    memcpy(lists->built_y, lists->y, bytes);
    lists->made += 1;
    return true;
}

/* What a call costs with near lists that reach so far, in slots that are gone through: its own, and
 * its part of a renewal, which goes through the far ones. Of some chunks, whose near lists are made
 * for it. */
static double cost_of_near(fw_neighbour_lists *lists, double near)
{
    const fw_list_kernels *kernels = FW_KERNELS_CHOSEN(fw_lists);
    const double calls = (near - lists->reach) * (double)lists->calls / lists->travelled;
    const int apart = (lists->chunk_count + WEIGHED - 1) / WEIGHED;
    double slots = 0, looked_at = 0;
    for (int c = 0; c < lists->chunk_count; c += apart) {
        fw_chunk *chunk = &lists->chunks[c];
        kernels->renew(chunk, lists->x, lists->y, near);
        slots += chunk->near.count;
        looked_at += chunk->far.count;
    }
    return slots + looked_at / fmax(calls, 1);
}

/* Near lists are the longer and the rarer, the further they reach. In a solid they may reach into
 * the gap behind a shell of neighbours for nothing. Called before they are renewed. */
static void weigh_near(fw_neighbour_lists *lists)
{
    static const double parts[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    double best = lists->near, least = INFINITY;
    if (!(lists->travelled > 0)) return;
    for (size_t n = 0; n < sizeof parts / sizeof *parts; ++n) {
        const double near = lists->reach + parts[n] * (lists->far - lists->reach);
        const double cost = cost_of_near(lists, near);
        if (cost >= least) continue;
        least = cost;
        best = near;
    }
    lists->far_slack -= best - lists->near;
    lists->near = best;
    lists->travelled = 0;
    lists->calls = 0;
}

static void renew_near(fw_neighbour_lists *lists)
{
    const fw_list_kernels *kernels = FW_KERNELS_CHOSEN(fw_lists);
#pragma omp parallel for schedule(static) if (lists->count > PARALLEL_FROM)
    for (int c = 0; c < lists->chunk_count; ++c)
        kernels->renew(&lists->chunks[c], lists->x, lists->y, lists->near);
}

fw_status fw_neighbour_lists_refresh(fw_neighbour_lists *lists, const double *x, const double *y,
                                     double travel, fw_error *error)
{
    take_positions(lists, x, y);
    lists->near_slack -= travel;
    lists->far_slack -= travel;
    lists->travelled += travel < INFINITY ? travel : 0;
    lists->calls += 1;
    if (lists->near_slack >= 0) return FW_OK;
    if (lists->renewals++ % WEIGH_EVERY == 1 && lists->made > 0) weigh_near(lists);
    /* What is renewed now must find in the far lists all that the near ones shall hold. */
    if (!(lists->far_slack >= 0) && lists->made > 0)
        lists->far_slack =
            fw_list_guard_slack(&lists->cells, lists->built_x, lists->built_y, lists->x, lists->y,
                                lists->far, lists->near, lists->boxes);
    if (!(lists->far_slack >= 0)) {
        if (!make_far(lists, x, y)) {
            lists->made = 0;
            return fail_memory(lists, error);
        }
        lists->far_slack = lists->far - lists->near;
    }
    renew_near(lists);
    /* A hair less, for the rounding of positions and distances. */
    lists->near_slack = (lists->near - lists->reach) * (1 - 1e-9);
    return FW_OK;
}

/* --- reading --- */

const fw_chunk *fw_neighbour_lists_chunk(const fw_neighbour_lists *lists, int chunk)
{
    return &lists->chunks[chunk];
}

int fw_neighbour_lists_first(const fw_neighbour_lists *lists, int body)
{
    return lists->first_chunk[body];
}

int64_t fw_neighbour_lists_made(const fw_neighbour_lists *lists)
{
    return lists->made;
}

double fw_neighbour_lists_closest(const fw_neighbour_lists *lists)
{
    const fw_list_kernels *kernels = FW_KERNELS_CHOSEN(fw_lists);
    double least = INFINITY;
#pragma omp parallel for schedule(static) reduction(min : least) if (lists->count > PARALLEL_FROM)
    for (int c = 0; c < lists->chunk_count; ++c)
        least = fmin(least, kernels->closest(&lists->chunks[c], lists->x, lists->y));
    return least;
}

const double *fw_neighbour_lists_x(const fw_neighbour_lists *lists)
{
    return lists->x;
}

const double *fw_neighbour_lists_y(const fw_neighbour_lists *lists)
{
    return lists->y;
}

bool fw_neighbour_lists_renumbered(const fw_neighbour_lists *lists, int body)
{
    return lists->order.number && lists->order.scattered[body];
}

int fw_neighbour_lists_number(const fw_neighbour_lists *lists, int k)
{
    return lists->order.number ? lists->order.number[k] : k;
}

fw_neighbour_walk fw_neighbours_around(const fw_neighbour_lists *lists, int particle)
{
    const int k = lists->order.place ? lists->order.place[particle] : particle;
    const int first = lists->first_chunk[fw_list_order_body(&lists->order, particle)];
    const int within = k - lists->chunks[first].body_first;
    const fw_chunk *chunk = &lists->chunks[first + within / CHUNK];
    const fw_slot_head *head = &chunk->near.head[within % CHUNK / FW_LANES];
    return (fw_neighbour_walk){.slots = &chunk->near,
                               .head = head,
                               .number = lists->order.number,
                               .slot = head->begin,
                               .run_end = head->begin + head->count[0],
                               .particle = k,
                               .lane = within % FW_LANES};
}
