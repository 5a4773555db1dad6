/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pair_vectors.h - what pairs of particles do to each other: pair_potential.h and return_force.h,
 * a pair in each lane of a vector; for kernels. Start reading at fw_pair_of(). */
#ifndef FW_PAIR_VECTORS_H
#define FW_PAIR_VECTORS_H

#include "particle_kernels.h"

#include "core/noise_vectors.h"
#include "core/vectors.h"

/* A pair in each lane, j seen from i. */
typedef struct fw_pair_lanes {
    fw_vector dx, dy;      /* r_i - r_j */
    fw_vector r2, inverse; /* r^2, 1/r^2 */
    fw_mask held;          /* there is a pair */
} fw_pair_lanes;

FW_INLINE fw_pair_lanes fw_pair_lanes_at(fw_vector dx, fw_vector dy, fw_mask held)
{
    const fw_vector r2 = fw_fma(dx, dx, dy * dy);
    return (fw_pair_lanes){dx, dy, r2, 1 / r2, held};
}

/* The particles in the lanes of one part of a block. */
typedef struct fw_own_lanes {
    const double *at_x, *at_y; /* of its first lane */
    int part;
    fw_vector x, y;
} fw_own_lanes;

FW_INLINE fw_own_lanes fw_own_lanes_at(const fw_pair_task *task, int first, int part)
{
    return (fw_own_lanes){task->x + first, task->y + first, part, fw_load(task->x + first),
                          fw_load(task->y + first)};
}

/* How the slots of a run are read, see slots.h. */
typedef enum fw_slot_kind { FW_OFFSETS, FW_WHOLE, FW_GATHERED } fw_slot_kind;

FW_INLINE fw_pair_lanes fw_pair_in_slot(const fw_pair_task *task, const fw_slots *slots,
                                        uint32_t slot, fw_slot_kind kind, const fw_own_lanes *lanes)
{
    const fw_mask held =
        kind == FW_WHOLE ? fw_everywhere() : fw_mask_of(slots->mask[slot], lanes->part);
    const int32_t offset = slots->offset[slot];
    if (kind != FW_GATHERED)
        return fw_pair_lanes_at(lanes->x - fw_load(lanes->at_x + offset),
                                lanes->y - fw_load(lanes->at_y + offset), held);
    const int32_t *row = slots->row[offset] + lanes->part * FW_WIDTH;
    return fw_pair_lanes_at(lanes->x - fw_gather(task->x, row), lanes->y - fw_gather(task->y, row),
                            held);
}

/* e^v for v <= 709; 0 below -708. v = n ln 2 + rest with |rest| <= ln 2/2, where Taylor's series to
 * the 13th power leaves 4e-18. ln 2 is taken off in two parts, the first of which has few digits:
 * n times it is exact. */
FW_INLINE fw_vector fw_exponential(fw_vector v)
{
    const fw_vector low = fw_splat(-708), bound = fw_smaller(fw_larger(v, low), fw_splat(709));
    const fw_vector n = fw_floor(bound * 1.4426950408889634 + 0.5);
    const fw_vector rest = (bound - n * 0x1.62e42fefa38p-1) - n * 0x1.ef35793c7673p-45;
    fw_vector series = fw_splat(1. / 6227020800);
    series = series * rest + 1. / 479001600;
    series = series * rest + 1. / 39916800;
    series = series * rest + 1. / 3628800;
    series = series * rest + 1. / 362880;
    series = series * rest + 1. / 40320;
    series = series * rest + 1. / 5040;
    series = series * rest + 1. / 720;
    series = series * rest + 1. / 120;
    series = series * rest + 1. / 24;
    series = series * rest + 1. / 6;
    series = series * rest + 1. / 2;
    series = series * (rest * rest) + rest + 1;
    /* n + 1023 stands in the last bits of 2^52 + (n + 1023). */
    const fw_naturals power = (fw_naturals)(n + (0x1p52 + 1023)) << 52;
    return fw_keep(fw_less(low, v), series * (fw_vector)power);
}

/* S(r) = y^3 (1 + 3 x + 6 x^2) and S' = -30/(b - a) x^2 y^2 for a < r < b, with
 * x = (r - a)/(b - a), y = 1 - x: smooth_cut.h's in other words. */
typedef struct fw_weights {
    fw_vector x, y;
} fw_weights;

FW_INLINE fw_weights fw_weights_at(const fw_smooth_cut *cut, fw_vector r)
{
    const fw_vector x = (r - cut->inner) * cut->scale;
    return (fw_weights){x, 1 - x};
}

/* S by y^2. */
FW_INLINE fw_vector fw_weight_value(fw_weights weights)
{
    const fw_vector one = fw_splat(1), slope = fw_fma(fw_splat(6), weights.x, fw_splat(3));
    return weights.y * fw_fma(weights.x, slope, one);
}

/* --- the potential --- */

/* -U'/r and U without the cut, each in its own unit. With c = r^-6 and q = d^-6
 *     Lennard-Jones  -U'/r = (c - q)/r^8, in 12 depth d^12;   U = c (c - 2 q), in depth d^12
 *     Morse          -U'/r = e (e - 1)/r, in 2 a depth;         U = e (e - 2), in depth,
 * e = e^{-a (r - d)}. */
FW_INLINE fw_vector fw_pair_push(const fw_pair_rule *rule, fw_pair_kind kind,
                                 const fw_pair_lanes *pair)
{
    if (kind == FW_LENNARD_JONES) {
        const fw_vector square = pair->inverse * pair->inverse, c = square * pair->inverse;
        return (c - rule->q) * (square * square);
    }
    const fw_vector r = fw_root(pair->r2);
    const fw_vector e = fw_exponential(-rule->steepness * (r - rule->distance));
    return e * (e - 1) * (pair->inverse * r);
}

FW_INLINE fw_vector fw_pair_energy(const fw_pair_rule *rule, fw_pair_kind kind,
                                   const fw_pair_lanes *pair)
{
    if (kind == FW_LENNARD_JONES) {
        const fw_vector c = pair->inverse * pair->inverse * pair->inverse;
        return c * (c - 2 * rule->q);
    }
    const fw_vector r = fw_root(pair->r2);
    const fw_vector e = fw_exponential(-rule->steepness * (r - rule->distance));
    return e * (e - 2);
}

/* The terms of a pair with the cut, both in the unit of forces, and where there are any. */
typedef struct fw_pair_terms {
    fw_vector energy, push;
    fw_mask inside;
} fw_pair_terms;

/* What a loop is compiled for: which potential, and whether it fades before the cut or just ends.
 */
typedef struct fw_pair_form {
    fw_pair_kind kind;
    bool fades;
} fw_pair_form;

/* The energy is only made where it is asked for. */
FW_INLINE fw_pair_terms fw_pair_of(const fw_pair_rule *rule, fw_pair_form form, bool energies,
                                   const fw_pair_lanes *pair)
{
    const fw_pair_kind kind = form.kind;
    fw_pair_terms terms = {fw_splat(0), fw_pair_push(rule, kind, pair), pair->held};
    if (energies) terms.energy = rule->energy * fw_pair_energy(rule, kind, pair);
    if (!form.fades) {
        terms.inside = fw_less_among(pair->held, pair->r2, fw_splat(rule->outer_2));
        return terms;
    }
    const fw_mask beyond = fw_less_among(pair->held, fw_splat(rule->inner_2), pair->r2);
    if (!fw_any(beyond)) return terms;
    terms.inside = fw_less_among(pair->held, pair->r2, fw_splat(rule->outer_2));
    const fw_mask fading = fw_and(beyond, terms.inside);
    if (fw_any(fading)) {
        const fw_vector r = fw_root(fw_only_here(pair->r2));
        const fw_weights at = fw_weights_at(&rule->cut, r);
        const fw_vector value = fw_weight_value(at), square = at.y * at.y;
        const fw_vector energy = fw_pair_energy(rule, kind, pair);
        /* (-U'/r) S - U S'/r, S' = -30/(b - a) x^2 y^2 */
        const fw_vector slope = rule->fade * energy * (at.x * at.x) * (pair->inverse * r);
        terms.push = fw_select(fading, fw_fma(terms.push, value, slope) * square, terms.push);
        if (energies)
            terms.energy =
                fw_select(fading, rule->energy * energy * (value * square), terms.energy);
    }
    return terms;
}

/* U'' with the cut, 0 from there on, in the unit of forces. */
FW_INLINE fw_vector fw_pair_curvature(const fw_pair_rule *rule, fw_pair_kind kind,
                                      const fw_pair_lanes *pair)
{
    const fw_vector r = fw_root(pair->r2);
    fw_vector bare;
    if (kind == FW_LENNARD_JONES) {
        const fw_vector c = pair->inverse * pair->inverse * pair->inverse;
        bare = c * (13 * c - 7 * rule->q) * pair->inverse;
    } else {
        const fw_vector e = fw_exponential(-rule->steepness * (r - rule->distance));
        bare = rule->steepness * e * (2 * e - 1);
    }
    /* U'' S + 2 U' S' + U S'' */
    const fw_weights at = fw_weights_at(&rule->cut, r);
    const double scale = rule->cut.scale;
    const fw_vector both = at.x * at.y, square = at.y * at.y;
    const fw_vector slope = -fw_pair_push(rule, kind, pair) * r;
    const fw_vector energy = rule->energy * fw_pair_energy(rule, kind, pair);
    const fw_vector faded = bare * (fw_weight_value(at) * square) -
                            60 * scale * slope * (both * both) -
                            60 * scale * scale * energy * (both * (1 - 2 * at.x));
    const fw_mask fading = fw_less(fw_splat(rule->inner_2), pair->r2);
    const fw_mask inside = fw_less_among(pair->held, pair->r2, fw_splat(rule->outer_2));
    return fw_keep(inside, fw_select(fading, faded, bare));
}

/* --- the return force --- */

/* A complex number in each lane. */
typedef struct fw_phases {
    fw_vector cosine, sine;
} fw_phases;

FW_INLINE fw_phases fw_phases_product(fw_phases a, fw_phases b)
{
    return (fw_phases){fw_fma(a.cosine, b.cosine, -(a.sine * b.sine)),
                       fw_fma(a.cosine, b.sine, a.sine * b.cosine)};
}

/* e^{i n phi}, for even n: by powers of (dx + i dy)/r, or for n = 6 from the cube of dx + i dy,
 * c3 + i s3: its square is (c3^2 - s3^2) + 2 i c3 s3. `fold` 0: that of the rule. */
FW_INLINE fw_phases fw_phases_of(const fw_return_rule *rule, int fold, const fw_pair_lanes *pair)
{
    const fw_vector xx = pair->dx * pair->dx, yy = pair->dy * pair->dy;
    if (fold == 6 || (fold == 0 && rule->fold == 6)) {
        const fw_vector three = fw_splat(3);
        const fw_vector c3 = pair->dx * fw_fma(-three, yy, xx);
        const fw_vector s3 = pair->dy * fw_fma(three, xx, -yy);
        const fw_vector cube = pair->inverse * pair->inverse * pair->inverse;
        return (fw_phases){fw_fma(c3, c3, -(s3 * s3)) * cube, 2 * c3 * s3 * cube};
    }
    fw_phases square = {(xx - yy) * pair->inverse, 2 * pair->dx * pair->dy * pair->inverse};
    if (fold == 4) return fw_phases_product(square, square);
    fw_phases power = {fw_splat(1), fw_splat(0)};
    for (int rest = rule->fold / 2; rest; rest >>= 1) {
        if (rest & 1) power = fw_phases_product(power, square);
        square = fw_phases_product(square, square);
    }
    return power;
}

/* Factors of sin n phi e_phi, of cos n phi e_r, both by r, and of cos n phi in the energy. */
typedef struct fw_return_lanes {
    fw_vector tangential, radial, energy, weight;
    bool fades;      /* in some lane; else `radial` is zero */
    fw_phases phase; /* e^{i n (phi - axes)} */
} fw_return_lanes;

FW_INLINE fw_return_lanes fw_return_of(const fw_return_rule *rule, int fold,
                                       const fw_pair_lanes *pair, fw_mask inside)
{
    const fw_vector one = fw_splat(1), none = fw_splat(0);
    fw_return_lanes lanes = {-rule->amplitude * rule->distance * pair->inverse,
                             none,
                             fw_splat(-rule->depth),
                             one,
                             false,
                             fw_phases_of(rule, fold, pair)};
    lanes.phase = fw_phases_product(
        lanes.phase, (fw_phases){fw_splat(rule->axes.cosine), fw_splat(-rule->axes.sine)});
    const fw_mask fading = fw_less_among(inside, fw_splat(rule->inner_2), pair->r2);
    if (rule->constant) {
        const fw_vector r = fw_root(pair->r2);
        const fw_weights at = fw_weights_at(&rule->cut, r);
        const fw_vector value = fw_select(fading, fw_weight_value(at) * (at.y * at.y), one);
        lanes.tangential = -rule->amplitude * value * (pair->inverse * r);
        lanes.energy = none;
        lanes.weight = value * r;
    } else if (fw_any(fading)) {
        const fw_vector r = fw_root(pair->r2);
        const fw_weights at = fw_weights_at(&rule->cut, r);
        const fw_vector square = at.y * at.y;
        const fw_vector value = fw_select(fading, fw_weight_value(at) * square, one);
        const fw_vector slope = -30 * rule->cut.scale * (at.x * at.x * square);
        lanes.tangential = lanes.tangential * value;
        lanes.radial = fw_keep(fading, rule->depth * slope * (pair->inverse * r));
        lanes.energy = lanes.energy * value;
        lanes.weight = value;
        lanes.fades = true;
    }
    return lanes;
}

/* Adds the force along e_phi and e_r that this phase makes. */
FW_INLINE void fw_return_add(const fw_return_lanes *lanes, fw_vector cosine, fw_vector sine,
                             const fw_pair_lanes *pair, fw_mask inside, fw_vector_pair *sum)
{
    const fw_vector tangential = lanes->tangential * sine;
    sum->x = fw_add_chosen(inside, -tangential, pair->dy, sum->x);
    sum->y = fw_add_chosen(inside, tangential, pair->dx, sum->y);
    if (!lanes->fades) return;
    const fw_vector radial = lanes->radial * cosine;
    sum->x = fw_add_chosen(inside, radial, pair->dx, sum->x);
    sum->y = fw_add_chosen(inside, radial, pair->dy, sum->y);
}

#endif
