/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_population_kernels.c - one step of particles that have all four links (Chopard & Marconi Eqs
 * 18-20, corrected; see lb_solid.h); compiled once for each instruction set. Keeps no state.
 * Start reading at relax_part(). */
#include "lb_population_kernels.h"

#include "lb_vectors.h"

#include <assert.h>
#include <stddef.h>
#include <string.h>

/* What the loop has to do; constant where it is inlined, so each combination is a loop of its own
 * without branches. */
typedef struct kind {
    bool resting, matrix, loaded, damped;
} kind;

/* M^-1 push. Where M is a matrix, with one step of iterative refinement in which M w is taken
 * through M0 as the update takes it: the rounding of M and M^-1 is the same in every step, and
 * would let the energy creep by some 1e-16 each. */
FW_INLINE fw_vector_pair divide(fw_vector_pair push, symmetric inverse, symmetric rest_mass,
                                bool matrix)
{
    fw_vector_pair w = times(inverse, push, matrix);
    if (!matrix) return w;
    const fw_vector_pair rest = times(rest_mass, times(rest_mass, w, true), true);
    const fw_vector_pair left = {push.x - (0.5 * rest.x + 2 * w.x),
                                 push.y - (0.5 * rest.y + 2 * w.y)};
    const fw_vector_pair more = times(inverse, left, true);
    return (fw_vector_pair){w.x + more.x, w.y + more.y};
}

/* Those of part `part` of the block that begins at l - part FW_WIDTH. */
FW_INLINE void relax_part(const lb_population_arrays *a, int l, int part, double mu, kind k,
                          passed *sum)
{
    fw_vector_pair f[FW_DIRECTIONS], rest = {0}, force = {0};
    symmetric rest_mass = {0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) f[d] = fw_load_pair(a->field_x[d], a->field_y[d], l);
    const symmetric inverse =
        load_symmetric(a->inverse_xx, a->inverse_xy, a->inverse_yy, l, k.matrix);

    /* Psi + F/2 = M0 f_0 + sum f_i + F/2 */
    fw_vector_pair push = {(f[FW_EAST].x + f[FW_WEST].x) + (f[FW_NORTH].x + f[FW_SOUTH].x),
                           (f[FW_EAST].y + f[FW_WEST].y) + (f[FW_NORTH].y + f[FW_SOUTH].y)};
    if (k.resting) {
        rest = fw_load_pair(a->rest_x, a->rest_y, l);
        rest_mass = load_symmetric(a->rest_mass_xx, a->rest_mass_xy, a->rest_mass_yy, l, k.matrix);
        const fw_vector_pair own = times(rest_mass, rest, k.matrix);
        push.x += own.x;
        push.y += own.y;
    }
    if (k.loaded) {
        force = fw_load_pair(a->force_x, a->force_y, l);
        push.x += 0.5 * force.x;
        push.y += 0.5 * force.y;
    }

    /* w = mu M^-1 (Psi + F/2) */
    fw_vector_pair w = divide(push, inverse, rest_mass, k.matrix);
    w.x *= mu;
    w.y *= mu;

    /* f_i -> w - f_{i+2},  f_0 -> M0 w - f_0,  r -> r + w */
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        fw_store_pair(a->field_x[d], a->field_y[d], l,
                      (fw_vector_pair){w.x - f[d].x, w.y - f[d].y});
    if (k.resting) {
        const fw_vector_pair own = times(rest_mass, w, k.matrix);
        fw_store_pair(a->rest_x, a->rest_y, l, (fw_vector_pair){own.x - rest.x, own.y - rest.y});
    }
    const fw_vector_pair r = fw_load_pair(a->x, a->y, l);
    fw_store_pair(a->x, a->y, l, (fw_vector_pair){r.x + w.x, r.y + w.y});

    if (k.loaded) pass_force(sum, part, force, w);
    if (k.damped) {
        const symmetric mass = load_symmetric(a->mass_xx, a->mass_xy, a->mass_yy, l, k.matrix);
        pass_drag(sum, part, mu, times(mass, w, k.matrix), w);
    }
}

FW_INLINE void relax_blocks(const lb_population_arrays *a, int count, double mu, kind k,
                            passed *sum)
{
    for (int l = 0; l + FW_BLOCK <= count; l += FW_BLOCK)
        for (int part = 0; part < FW_PARTS; ++part)
            relax_part(a, l + part * FW_WIDTH, part, mu, k, sum);
}

/* --- the last particles, fewer than a block --- */

/* The struct has nothing but pointers to arrays, those that are written first. */
enum { ARRAYS = sizeof(lb_population_arrays) / sizeof(double *), WRITTEN = 2 * FW_DIRECTIONS + 4 };
static_assert(offsetof(lb_population_arrays, force_x) == WRITTEN * sizeof(double *),
              "arrays that are written come first");

static void copy(double *to, const double *from, int count)
{
    for (int l = 0; l < count; ++l) to[l] = from[l];
}

/* They are taken to a block of their own, filled up with particles that are all zeros. */
FW_INLINE void relax_rest(const lb_population_arrays *a, int first, int count, double mu, kind k,
                          passed *sum)
{
    double block[ARRAYS][FW_BLOCK] = {{0}};
    double *own[ARRAYS], *given[ARRAYS];
    lb_population_arrays there;
    memcpy(given, a, sizeof given);
    for (int n = 0; n < ARRAYS; ++n) {
        own[n] = given[n] ? block[n] : NULL;
        if (given[n]) copy(block[n], given[n] + first, count);
    }
    memcpy(&there, own, sizeof there);
    relax_blocks(&there, FW_BLOCK, mu, k, sum);
    for (int n = 0; n < WRITTEN; ++n)
        if (given[n]) copy(given[n] + first, block[n], count);
}

FW_INLINE void relax_all(const lb_population_arrays *a, int count, double mu, kind k,
                         fw_solid_ledger *ledger)
{
    passed sum = {0};
    relax_blocks(a, count, mu, k, &sum);
    const int first = count - count % FW_BLOCK;
    if (first < count) relax_rest(a, first, count - first, mu, k, &sum);
    add_passed(ledger, &sum, k.loaded, k.damped);
}

FW_INLINE void relax_mass(const lb_population_arrays *a, int count, double mu, bool resting,
                          bool matrix, fw_solid_ledger *ledger)
{
    const bool loaded = a->force_x != NULL, damped = mu < 1;
    if (loaded && damped)
        relax_all(a, count, mu, (kind){resting, matrix, true, true}, ledger);
    else if (loaded)
        relax_all(a, count, mu, (kind){resting, matrix, true, false}, ledger);
    else if (damped)
        relax_all(a, count, mu, (kind){resting, matrix, false, true}, ledger);
    else
        relax_all(a, count, mu, (kind){resting, matrix, false, false}, ledger);
}

/* A matrix is there only with rest fields: kappa is 1 here. */
static void relax(const lb_population_arrays *a, int count, double mu, fw_solid_ledger *ledger)
{
    if (a->inverse_xy)
        relax_mass(a, count, mu, true, true, ledger);
    else if (a->rest_x)
        relax_mass(a, count, mu, true, false, ledger);
    else
        relax_mass(a, count, mu, false, false, ledger);
}

const lb_population_kernels FW_KERNELS_HERE(lb_populations) = {.relax = relax};
