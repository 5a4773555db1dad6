/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_kernels.c - the half-step of cells (Dong Eq 3); compiled
 * once for each instruction set. Keeps no state. Start reading at move_part(). */
#include "automaton_kernels.h"

#include "automaton_rim.h"

#include "core/vectors.h"

/* What the loop has to do; constant where it is inlined, so that each combination is a loop of its
 * own without branches. */
typedef struct kind {
    bool loaded, damped, breakable;
} kind;

/* What passed, lane by lane. */
typedef struct passed {
    fw_vector work[FW_PARTS], impulse_x[FW_PARTS], impulse_y[FW_PARTS];
    fw_vector dissipated[FW_PARTS], drag_x[FW_PARTS], drag_y[FW_PARTS];
    bool torn;
} passed;

/* The arrays of a move from the span's first cell on. */
typedef struct stream {
    double *x, *y;
    const double *neighbour_x[FW_DIRECTIONS], *neighbour_y[FW_DIRECTIONS];
    const double *force_x, *force_y; /* of every second particle */
    uint8_t *torn;
} stream;

/* All lanes of a register, or some. */
typedef struct lanes {
    bool all;
    fw_mask mask;
} lanes;

FW_INLINE fw_vector_pair load(const double *x, const double *y, int k, lanes l)
{
    if (l.all) return (fw_vector_pair){fw_load(x + k), fw_load(y + k)};
    return (fw_vector_pair){fw_load_some(x + k, l.mask), fw_load_some(y + k, l.mask)};
}

FW_INLINE void store(double *x, double *y, int k, lanes l, fw_vector_pair v)
{
    if (l.all) {
        fw_store(x + k, v.x);
        fw_store(y + k, v.y);
    } else {
        fw_store_some(x + k, l.mask, v.x);
        fw_store_some(y + k, l.mask, v.y);
    }
}

/* B (neighbour - self) */
FW_INLINE fw_vector_pair pull_of(fw_sym2 b, fw_vector_pair neighbour, fw_vector_pair self)
{
    const fw_vector x = neighbour.x - self.x, y = neighbour.y - self.y;
    return (fw_vector_pair){b.xx * x + b.xy * y, b.xy * x + b.yy * y};
}

/* Of `count` cells from k on. */
FW_INLINE fw_vector_pair load_force(const stream *s, int k, int count)
{
    double x[FW_WIDTH] = {0}, y[FW_WIDTH] = {0};
    for (int lane = 0; lane < FW_WIDTH && lane < count; ++lane) {
        x[lane] = s->force_x[2 * (k + lane)];
        y[lane] = s->force_y[2 * (k + lane)];
    }
    return (fw_vector_pair){fw_load(x), fw_load(y)};
}

/* Notes the bonds of cells that are too long; kept apart from the loop, which seldom comes here. */
__attribute__((noinline, cold)) static void tear(const double *neighbour_x,
                                                 const double *neighbour_y, const double *middle_x,
                                                 const double *middle_y, int count, double break_at,
                                                 uint8_t bit, uint8_t *torn, bool *any)
{
    for (int lane = 0; lane < FW_WIDTH && lane < count; ++lane) {
        const double x = neighbour_x[lane] - middle_x[lane];
        const double y = neighbour_y[lane] - middle_y[lane];
        if (!(hypot(x, y) > break_at)) continue;
        torn[lane] |= bit;
        *any = true;
    }
}

/* A little less than the square of break_at, for hypot() rounds otherwise. */
FW_INLINE double least_to_tear(const fw_automaton_move *move)
{
    return move->break_at * move->break_at * (1 - 1e-12);
}

/* Bonds of the cells from k on, from the middle of the cells' displacements to their neighbours. */
FW_INLINE void look_for_tears(const fw_automaton_move *move, const stream *s, int k, int count,
                              const fw_vector_pair neighbour[FW_DIRECTIONS], fw_vector_pair middle,
                              bool *any)
{
    fw_vector square[FW_DIRECTIONS];
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const fw_vector x = neighbour[d].x - middle.x, y = neighbour[d].y - middle.y;
        square[d] = x * x + y * y;
    }
    const fw_vector largest = fw_larger(fw_larger(square[FW_EAST], square[FW_NORTH]),
                                        fw_larger(square[FW_WEST], square[FW_SOUTH]));
    if (__builtin_expect(!fw_any(fw_less(fw_splat(least_to_tear(move)), largest)), 1)) return;
    double middle_x[FW_WIDTH], middle_y[FW_WIDTH];
    fw_store(middle_x, middle.x);
    fw_store(middle_y, middle.y);
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        tear(s->neighbour_x[d] + k, s->neighbour_y[d] + k, middle_x, middle_y, count,
             move->break_at, (uint8_t)(1 << d), s->torn + k, any);
}

/* The cells of part `part` of a block, from k on; of them `count` are there. */
FW_INLINE void move_part(const fw_automaton_move *move, const stream *s, int k, int part, int count,
                         lanes l, kind has, passed *sum)
{
    const fw_vector_pair self = load(s->x, s->y, k, l);
    fw_vector_pair neighbour[FW_DIRECTIONS], pull[FW_DIRECTIONS], force = {0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        neighbour[d] = load(s->neighbour_x[d], s->neighbour_y[d], k, l);
        pull[d] = pull_of(move->matrix[d], neighbour[d], self);
    }
    const fw_vector_pair all = {
        (pull[FW_EAST].x + pull[FW_NORTH].x) + (pull[FW_WEST].x + pull[FW_SOUTH].x),
        (pull[FW_EAST].y + pull[FW_NORTH].y) + (pull[FW_WEST].y + pull[FW_SOUTH].y)};

    /* d = (1 + a)/2 (s + F) */
    fw_vector_pair d = {move->share_of_pull * all.x, move->share_of_pull * all.y};
    if (has.loaded) {
        force = load_force(s, k, count);
        d.x += move->share_of_pull * force.x;
        d.y += move->share_of_pull * force.y;
    }
    store(s->x, s->y, k, l, (fw_vector_pair){self.x + d.x, self.y + d.y});
    if (has.breakable) {
        const fw_vector_pair middle = {self.x + 0.5 * d.x, self.y + 0.5 * d.y};
        look_for_tears(move, s, k, count, neighbour, middle, &sum->torn);
    }

    /* dE = F.d - k d.d, dp = F - k d */
    if (has.loaded) {
        sum->work[part] += force.x * d.x + force.y * d.y;
        sum->impulse_x[part] += force.x;
        sum->impulse_y[part] += force.y;
    }
    if (has.damped) {
        const fw_vector_pair drag = {-move->loss * d.x, -move->loss * d.y};
        sum->dissipated[part] -= drag.x * d.x + drag.y * d.y;
        sum->drag_x[part] += drag.x;
        sum->drag_y[part] += drag.y;
    }
}

/* Fewer cells than a block has. */
FW_INLINE void move_some(const fw_automaton_move *move, const stream *s, int k, int count, kind has,
                         passed *sum)
{
    const uint8_t bits = fw_first_lanes(count);
    for (int part = 0; part * FW_WIDTH < count; ++part)
        move_part(move, s, k + part * FW_WIDTH, part, count - part * FW_WIDTH,
                  (lanes){.mask = fw_mask_of(bits, part)}, has, sum);
}

/* So many cells come before the first block that fills a line of the cache. Long spans only; not
 * where lanes are summed, which must be the same wherever memory lies. */
FW_INLINE int lead_of(const double *x, int count)
{
    const int past = (int)((uintptr_t)x / sizeof *x % FW_BLOCK);
    return past > 0 && count >= 8 * FW_BLOCK ? FW_BLOCK - past : 0;
}

/* What nobody has read yet: the cells' own displacements, and those to their north. The processor
 * alone looks less far ahead, and memory then gives half of what it can. */
FW_INLINE void fetch_ahead(const stream *s, int k)
{
    enum { AHEAD = 256 };
    __builtin_prefetch(s->x + k + AHEAD, 1);
    __builtin_prefetch(s->y + k + AHEAD, 1);
    __builtin_prefetch(s->neighbour_x[FW_NORTH] + k + AHEAD, 0);
    __builtin_prefetch(s->neighbour_y[FW_NORTH] + k + AHEAD, 0);
}

FW_INLINE void move_span(const fw_automaton_move *moved, const fw_automaton_span *span,
                         fw_automaton_share *share, kind has)
{
    /* A copy, which no store into the arrays can change. */
    const fw_automaton_move here = *moved, *move = &here;
    passed sum = {0};
    stream s = {.x = move->x + span->begin, .y = move->y + span->begin};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        s.neighbour_x[d] = move->other_x + span->begin + span->offset[d];
        s.neighbour_y[d] = move->other_y + span->begin + span->offset[d];
    }
    if (has.loaded) {
        s.force_x = move->force_x + span->particle;
        s.force_y = move->force_y + span->particle;
    }
    if (has.breakable) s.torn = move->torn + span->begin;
    const int lead = has.loaded || has.damped ? 0 : lead_of(s.x, span->count);
    if (lead > 0) move_some(move, &s, 0, lead, has, &sum);
    int k = lead;
    for (; k + FW_BLOCK <= span->count; k += FW_BLOCK) {
        if (move->fetches) fetch_ahead(&s, k);
        for (int part = 0; part < FW_PARTS; ++part)
            move_part(move, &s, k + part * FW_WIDTH, part, FW_WIDTH, (lanes){.all = true}, has,
                      &sum);
    }
    move_some(move, &s, k, span->count - k, has, &sum);
    share->torn |= sum.torn;
    if (has.loaded) {
        share->work += fw_sum_block(sum.work);
        share->impulse.x += fw_sum_block(sum.impulse_x);
        share->impulse.y += fw_sum_block(sum.impulse_y);
    }
    if (has.damped) {
        share->dissipated += fw_sum_block(sum.dissipated);
        share->drag.x += fw_sum_block(sum.drag_x);
        share->drag.y += fw_sum_block(sum.drag_y);
    }
}

static void move_cells(const fw_automaton_move *move, const fw_automaton_span *span,
                       fw_automaton_share *share)
{
    const bool loaded = move->force_x != NULL, damped = move->loss > 0;
    if (move->torn) {
        if (!loaded && !damped)
            move_span(move, span, share, (kind){.breakable = true});
        else
            move_span(move, span, share, (kind){loaded, damped, true});
    } else if (!loaded && !damped) {
        move_span(move, span, share, (kind){0});
    } else if (!damped) {
        move_span(move, span, share, (kind){.loaded = true});
    } else if (!loaded) {
        move_span(move, span, share, (kind){.damped = true});
    } else {
        move_span(move, span, share, (kind){.loaded = true, .damped = true});
    }
}

/* Notes the bonds of a cell at a rim that are too long. */
__attribute__((noinline, cold)) static void
tear_rim(const fw_automaton_move *move, const fw_automaton_rim *rim, fw_vec2 middle, bool *any)
{
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int neighbour = rim->neighbour[d];
        if (neighbour >= 0)
            tear(move->other_x + neighbour, move->other_y + neighbour, &middle.x, &middle.y, 1,
                 move->break_at, (uint8_t)(1 << d), move->torn + rim->cell, any);
    }
}

/* Is a bond longer than may be, or nearly so? */
static bool is_stretched(const fw_automaton_move *move, const fw_automaton_rim *rim, fw_vec2 middle)
{
    double largest = 0;
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const int neighbour = rim->neighbour[d];
        if (neighbour < 0) continue;
        const double x = move->other_x[neighbour] - middle.x;
        const double y = move->other_y[neighbour] - middle.y;
        largest = fmax(largest, x * x + y * y);
    }
    return largest > least_to_tear(move);
}

static void move_rim(const fw_automaton_move *move, const fw_automaton_rim *rim, int count,
                     fw_automaton_share *share)
{
    for (int n = 0; n < count; ++n) {
        const int cell = rim[n].cell;
        const fw_vec2 self = {move->x[cell], move->y[cell]};
        const fw_vec2 pull = fw_automaton_rim_pull(&rim[n], self, move->other_x, move->other_y);
        const fw_vec2 d =
            fw_automaton_rim_displacement(&rim[n], pull, move->share_of_pull, move->mirror);
        move->x[cell] = self.x + d.x;
        move->y[cell] = self.y + d.y;
        if (!move->torn) continue;
        const fw_vec2 middle = fw_vec2_add(self, fw_vec2_scale(0.5, d));
        if (is_stretched(move, &rim[n], middle)) tear_rim(move, &rim[n], middle, &share->torn);
    }
}

/* As fw_automaton_bond_energy(), fw_automaton_bond_momentum() and fw_automaton_cell_pull(), each in
 * its own order. */
FW_INLINE void terms_of_part(const fw_automaton_move *move, const stream *s, int k, lanes l, int at,
                             fw_automaton_terms *terms)
{
    const fw_vector_pair self = load(s->x, s->y, k, l);
    fw_vector_pair pull[FW_DIRECTIONS], sum = {0};
    fw_vector energy = {0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        const fw_vector_pair neighbour = load(s->neighbour_x[d], s->neighbour_y[d], k, l);
        pull[d] = pull_of(move->matrix[d], neighbour, self);
        energy += (neighbour.x - self.x) * pull[d].x + (neighbour.y - self.y) * pull[d].y;
        sum.x += pull[d].x;
        sum.y += pull[d].y;
    }
    const fw_vector_pair all = {
        (pull[FW_EAST].x + pull[FW_NORTH].x) + (pull[FW_WEST].x + pull[FW_SOUTH].x),
        (pull[FW_EAST].y + pull[FW_NORTH].y) + (pull[FW_WEST].y + pull[FW_SOUTH].y)};
    store(terms->momentum_x + at, terms->momentum_y + at, k, l,
          (fw_vector_pair){0.5 * sum.x, 0.5 * sum.y});
    store(terms->energy + at, terms->kinetic + at, k, l,
          (fw_vector_pair){0.5 * energy, 0.25 * (all.x * all.x + all.y * all.y)});
}

static void terms_of(const fw_automaton_move *move, const int offset[FW_DIRECTIONS], int cell,
                     int count, int at, fw_automaton_terms *terms)
{
    stream s = {.x = move->x + cell, .y = move->y + cell};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        s.neighbour_x[d] = move->other_x + cell + offset[d];
        s.neighbour_y[d] = move->other_y + cell + offset[d];
    }
    for (int k = 0; k < count; k += FW_BLOCK)
        for (int part = 0; part < FW_PARTS; ++part) {
            const uint8_t bits = fw_first_lanes(count - k);
            const lanes l = {.mask = fw_mask_of(bits, part)};
            terms_of_part(move, &s, k + part * FW_WIDTH, l, at, terms);
        }
}

const fw_automaton_kernels FW_KERNELS_HERE(fw_automaton_kernels) = {
    .move = move_cells, .move_rim = move_rim, .terms = terms_of};
