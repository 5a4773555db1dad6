/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_displacement_kernels.c - one step of the LB solid in displacement form, for the blocks of a
 * row; compiled once for each instruction set. Keeps no state. Start reading at advance_part(). */
#include "lb_displacement_kernels.h"

#include "core/vectors.h"

/* What the loop has to do; constant where it is inlined. */
typedef struct kind {
    bool matrix, loaded, damped;
} kind;

/* What passed, lane by lane. */
typedef struct passed {
    fw_vector work[FW_PARTS], impulse_x[FW_PARTS], impulse_y[FW_PARTS];
    fw_vector dissipated[FW_PARTS], drag_x[FW_PARTS], drag_y[FW_PARTS];
} passed;

typedef struct pair {
    fw_vector x, y;
} pair;

FW_INLINE pair load_pair(const double *x, const double *y, int place)
{
    return (pair){fw_load(x + place), fw_load(y + place)};
}

FW_INLINE pair add(pair a, pair b)
{
    return (pair){a.x + b.x, a.y + b.y};
}

FW_INLINE pair subtract(pair a, pair b)
{
    return (pair){a.x - b.x, a.y - b.y};
}

/* A symmetric matrix, of which only xx counts where it is a multiple of one. */
typedef struct symmetric {
    fw_vector xx, xy, yy;
} symmetric;

FW_INLINE symmetric load_symmetric(const double *xx, const double *xy, const double *yy, int place,
                                   bool matrix)
{
    symmetric m = {.xx = fw_load(xx + place)};
    if (matrix) m.xy = fw_load(xy + place), m.yy = fw_load(yy + place);
    return m;
}

FW_INLINE symmetric splat_symmetric(fw_sym2 m)
{
    return (symmetric){fw_splat(m.xx), fw_splat(m.xy), fw_splat(m.yy)};
}

FW_INLINE pair times(symmetric m, pair v, bool matrix)
{
    if (!matrix) return (pair){m.xx * v.x, m.xx * v.y};
    return (pair){m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y};
}

/* x_m - x_l of the neighbours at a distance, 0 where there is no link. */
FW_INLINE pair stretch(const lb_grid_arrays *a, int place, int distance, int direction, pair x,
                       int part, bool plain)
{
    const pair d = subtract(load_pair(a->ahead_x, a->ahead_y, place + distance), x);
    if (plain) return d;
    const fw_mask linked = fw_mask_of(a->links[place / FW_BLOCK][direction], part);
    return (pair){fw_keep(linked, d.x), fw_keep(linked, d.y)};
}

FW_INLINE void advance_part(const lb_grid_arrays *a, int place, int part, int north, int south,
                            kind k, bool plain, passed *sum)
{
    const pair x = load_pair(a->ahead_x, a->ahead_y, place);
    const pair before = load_pair(a->behind_x, a->behind_y, place);
    const symmetric mobility =
        plain ? splat_symmetric(a->plain_mobility)
              : load_symmetric(a->mobility_xx, a->mobility_xy, a->mobility_yy, place, k.matrix);

    /* sum_links (x_m - x_l) + F */
    pair pull = add(add(stretch(a, place, 1, FW_EAST, x, part, plain),
                        stretch(a, place, -1, FW_WEST, x, part, plain)),
                    add(stretch(a, place, north, FW_NORTH, x, part, plain),
                        stretch(a, place, south, FW_SOUTH, x, part, plain)));
    pair force = {0};
    if (k.loaded) {
        force = load_pair(a->force_x, a->force_y, place);
        pull = add(pull, force);
    }

    /* x(t+1) = x + (2 mu - 1)(x - x(t-1)) + mu M^-1 pull */
    const pair velocity = subtract(x, before), change = times(mobility, pull, k.matrix);
    const double kept = 2 * a->mu - 1;
    const pair after = {x.x + (kept * velocity.x + change.x), x.y + (kept * velocity.y + change.y)};
    fw_store(a->behind_x + place, after.x);
    fw_store(a->behind_y + place, after.y);

    /* w = (x(t+1) - x(t-1))/2 */
    const pair w = {0.5 * (after.x - before.x), 0.5 * (after.y - before.y)};
    if (k.loaded) {
        sum->work[part] += force.x * w.x + force.y * w.y;
        sum->impulse_x[part] += force.x;
        sum->impulse_y[part] += force.y;
    }
    if (k.damped) { /* dE = F.w - 2(1/mu - 1) w.Mw,  dPsi = F - 2(1/mu - 1) Mw */
        const double loss = 2 * (1 / a->mu - 1);
        const symmetric mass =
            plain ? splat_symmetric(a->plain_mass)
                  : load_symmetric(a->mass_xx, a->mass_xy, a->mass_yy, place, k.matrix);
        const pair momentum = times(mass, w, k.matrix);
        sum->dissipated[part] += loss * (w.x * momentum.x + w.y * momentum.y);
        sum->drag_x[part] -= loss * momentum.x;
        sum->drag_y[part] -= loss * momentum.y;
    }
}

/* What is read for the first time, so many places before it is needed: a quarter to a half as fast
 * again on the machine where it was measured, and a tenth where the rows lie in the cache. */
FW_INLINE void fetch_ahead(const lb_grid_arrays *a, int place, int north)
{
    enum { AHEAD = 256 };
    __builtin_prefetch(a->ahead_x + place + north + AHEAD, 0);
    __builtin_prefetch(a->ahead_y + place + north + AHEAD, 0);
    __builtin_prefetch(a->behind_x + place + AHEAD, 1);
    __builtin_prefetch(a->behind_y + place + AHEAD, 1);
}

FW_INLINE void advance_run(const lb_grid_arrays *a, lb_run run, int north, int south, kind k,
                           bool plain, passed *sum)
{
    for (int place = run.begin; place < run.end; place += FW_BLOCK) {
        fetch_ahead(a, place, north);
        for (int part = 0; part < FW_PARTS; ++part)
            advance_part(a, place + part * FW_WIDTH, part, north, south, k, plain, sum);
    }
}

/* The arrays are copied, so that no store can be thought to change where they are. */
FW_INLINE void advance_row(const lb_grid_arrays *arrays, const lb_run *runs, int run_count,
                           int north, int south, kind k, fw_solid_ledger *ledger)
{
    const lb_grid_arrays a = *arrays;
    passed sum = {0};
    for (int n = 0; n < run_count; ++n)
        if (runs[n].plain)
            advance_run(&a, runs[n], north, south, k, true, &sum);
        else
            advance_run(&a, runs[n], north, south, k, false, &sum);
    *ledger = (fw_solid_ledger){0};
    if (k.loaded) {
        ledger->work = fw_sum_block(sum.work);
        ledger->impulse = (fw_vec2){fw_sum_block(sum.impulse_x), fw_sum_block(sum.impulse_y)};
    }
    if (k.damped) {
        ledger->dissipated = fw_sum_block(sum.dissipated);
        ledger->drag = (fw_vec2){fw_sum_block(sum.drag_x), fw_sum_block(sum.drag_y)};
    }
}

static void advance(const lb_grid_arrays *a, const lb_run *runs, int run_count, int north,
                    int south, fw_solid_ledger *ledger)
{
#define ADVANCE(M, L, D) advance_row(a, runs, run_count, north, south, (kind){M, L, D}, ledger)
    const bool loaded = a->force_x != NULL, damped = a->mu < 1;
    if (a->mobility_xy)
        loaded   ? damped ? ADVANCE(true, true, true) : ADVANCE(true, true, false)
          : damped ? ADVANCE(true, false, true)
                 : ADVANCE(true, false, false);
    else
        loaded   ? damped ? ADVANCE(false, true, true) : ADVANCE(false, true, false)
          : damped ? ADVANCE(false, false, true)
                 : ADVANCE(false, false, false);
#undef ADVANCE
}

const lb_displacement_kernels FW_KERNELS_HERE(lb_displacements) = {.advance = advance};
