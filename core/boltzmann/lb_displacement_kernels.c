/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_displacement_kernels.c - one step of the LB solid in displacement form, for the blocks of a
 * row; compiled once for each instruction set. Keeps no state. Start reading at advance_part(). */
#include "lb_displacement_kernels.h"

#include "lb_vectors.h"

#include <assert.h>

static_assert((int)LB_BLOCK == (int)FW_BLOCK, "a lane for each place of a block");

/* What the loop has to do; constant where it is inlined. */
typedef struct kind {
    bool matrix, loaded, damped;
} kind;

FW_INLINE fw_vector_pair add(fw_vector_pair a, fw_vector_pair b)
{
    return (fw_vector_pair){a.x + b.x, a.y + b.y};
}

FW_INLINE fw_vector_pair subtract(fw_vector_pair a, fw_vector_pair b)
{
    return (fw_vector_pair){a.x - b.x, a.y - b.y};
}

FW_INLINE symmetric splat_symmetric(fw_sym2 m)
{
    return (symmetric){fw_splat(m.xx), fw_splat(m.xy), fw_splat(m.yy)};
}

/* x_m - x_l of the neighbours at a distance, 0 where there is no link. */
FW_INLINE fw_vector_pair stretch(const lb_grid_arrays *a, int place, int distance, int direction,
                                 fw_vector_pair x, int part, bool plain)
{
    const fw_vector_pair d = subtract(fw_load_pair(a->ahead_x, a->ahead_y, place + distance), x);
    if (plain) return d;
    const fw_mask linked = fw_mask_of(a->links[place / FW_BLOCK][direction], part);
    return (fw_vector_pair){fw_keep(linked, d.x), fw_keep(linked, d.y)};
}

FW_INLINE symmetric mobility_of(const lb_grid_arrays *a, int place, int part, kind k, bool plain)
{
    if (plain) return splat_symmetric(a->plain_mobility);
    if (a->mobility_xx)
        return load_symmetric(a->mobility_xx, a->mobility_xy, a->mobility_yy, place, k.matrix);
    const fw_vector mass = counted_mass(a->rest_square, a->links[place / FW_BLOCK], part);
    return (symmetric){.xx = fw_keep(fw_less(fw_splat(0), mass), a->mu * (1 / mass))};
}

FW_INLINE symmetric mass_of(const lb_grid_arrays *a, int place, int part, kind k, bool plain)
{
    if (plain) return splat_symmetric(a->plain_mass);
    if (a->mobility_xx) return load_symmetric(a->mass_xx, a->mass_xy, a->mass_yy, place, k.matrix);
    return (symmetric){.xx = counted_mass(a->rest_square, a->links[place / FW_BLOCK], part)};
}

FW_INLINE void advance_part(const lb_grid_arrays *a, int place, int part, int north, int south,
                            kind k, bool plain, passed *sum)
{
    const fw_vector_pair x = fw_load_pair(a->ahead_x, a->ahead_y, place);
    const fw_vector_pair before = fw_load_pair(a->behind_x, a->behind_y, place);
    const symmetric mobility = mobility_of(a, place, part, k, plain);

    /* sum_links (x_m - x_l) + F */
    fw_vector_pair pull = add(add(stretch(a, place, 1, FW_EAST, x, part, plain),
                                  stretch(a, place, -1, FW_WEST, x, part, plain)),
                              add(stretch(a, place, north, FW_NORTH, x, part, plain),
                                  stretch(a, place, south, FW_SOUTH, x, part, plain)));
    fw_vector_pair force = {0};
    if (k.loaded) {
        force = fw_load_pair(a->force_x, a->force_y, place);
        pull = add(pull, force);
    }

    /* x(t+1) = x + (2 mu - 1)(x - x(t-1)) + mu M^-1 pull */
    const fw_vector_pair velocity = subtract(x, before), change = times(mobility, pull, k.matrix);
    const double kept = 2 * a->mu - 1;
    const fw_vector_pair after = {x.x + (kept * velocity.x + change.x),
                                  x.y + (kept * velocity.y + change.y)};
    fw_store(a->behind_x + place, after.x);
    fw_store(a->behind_y + place, after.y);

    /* w = (x(t+1) - x(t-1))/2 */
    const fw_vector_pair w = {0.5 * (after.x - before.x), 0.5 * (after.y - before.y)};
    if (k.loaded) pass_force(sum, part, force, w);
    if (k.damped) {
        const symmetric mass = mass_of(a, place, part, k, plain);
        pass_drag(sum, part, a->mu, times(mass, w, k.matrix), w);
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
    add_passed(ledger, &sum, k.loaded, k.damped);
}

FW_INLINE void advance_mass(const lb_grid_arrays *a, const lb_run *runs, int run_count, int north,
                            int south, bool matrix, fw_solid_ledger *ledger)
{
    const bool loaded = a->force_x != NULL, damped = a->mu < 1;
    if (loaded && damped)
        advance_row(a, runs, run_count, north, south, (kind){matrix, true, true}, ledger);
    else if (loaded)
        advance_row(a, runs, run_count, north, south, (kind){matrix, true, false}, ledger);
    else if (damped)
        advance_row(a, runs, run_count, north, south, (kind){matrix, false, true}, ledger);
    else
        advance_row(a, runs, run_count, north, south, (kind){matrix, false, false}, ledger);
}

static void advance(const lb_grid_arrays *a, const lb_run *runs, int run_count, int north,
                    int south, fw_solid_ledger *ledger)
{
    if (a->mobility_xy)
        advance_mass(a, runs, run_count, north, south, true, ledger);
    else
        advance_mass(a, runs, run_count, north, south, false, ledger);
}

FW_INLINE fw_vector square(fw_vector_pair v)
{
    return v.x * v.x + v.y * v.y;
}

static void add_squares(const lb_grid_arrays *arrays, int place, int count, int north, int south,
                        fw_vec2 velocity, double weight, double *sums)
{
    const lb_grid_arrays a = *arrays;
    const int distance[FW_DIRECTIONS] = {1, north, -1, south};
    assert(place % FW_BLOCK == 0 && count % FW_BLOCK == 0);
    for (int k = 0; k < count; k += FW_WIDTH) {
        const int at = place + k, part = k % FW_BLOCK / FW_WIDTH;
        const fw_vector_pair behind = fw_load_pair(a.behind_x, a.behind_y, at);
        const fw_vector_pair from = {behind.x + velocity.x, behind.y + velocity.y};
        fw_vector sum = weight * square(subtract(fw_load_pair(a.ahead_x, a.ahead_y, at), from));
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            const fw_vector_pair beside = fw_load_pair(a.ahead_x, a.ahead_y, at + distance[d]);
            const fw_mask linked = fw_mask_of(a.links[at / FW_BLOCK][d], part);
            sum += fw_keep(linked, square(subtract(beside, from)));
        }
        fw_store(sums + k, fw_load(sums + k) + sum);
    }
}

const lb_displacement_kernels FW_KERNELS_HERE(lb_displacements) = {.advance = advance,
                                                                   .add_squares = add_squares};
