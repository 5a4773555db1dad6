/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sum_kernels.c - energies, virial, stiffness and return forces of movable lattice particles, eight
 * particles at a time; compiled once for each instruction set. Keeps no state. As in
 * particle_kernels.c every particle adds its neighbours in ascending order. Start reading at
 * add_pair(). */
#include "pair_vectors.h"

#include <stddef.h>

/* What is wanted, of which pairs. Energies alone, which are asked for most often, have loops of
 * their own, and where there is no return force nothing is asked of it. */
typedef struct fw_wanted {
    bool energy, force, virial, lengths, stiffness;
    fw_pair_form form;
    bool bonds;
} fw_wanted;

typedef struct fw_lane_sums {
    fw_vector energy, return_x, return_y, length, bonds, virial[4], stiffness[3];
} fw_lane_sums;

/* The return force of a pair and its energy, with the body's turn. */
typedef struct fw_pull {
    fw_vector_pair force;
    fw_vector energy;
} fw_pull;

FW_INLINE fw_pull pull_of(const fw_return_rule *rule, const fw_pair_lanes *pair, fw_mask inside)
{
    const fw_return_lanes bond = fw_return_of(rule, 0, pair, inside);
    const fw_vector cosine = bond.phase.cosine, sine = bond.phase.sine;
    fw_vector_pair first = {fw_splat(0), fw_splat(0)}, second = first;
    fw_return_add(&bond, cosine, sine, pair, inside, &first);
    fw_vector energy_second = fw_splat(0);
    if (rule->turning == FW_AXES_COROTATING) {
        fw_return_add(&bond, sine, -cosine, pair, inside, &second);
        energy_second = bond.energy * sine;
    } else if (rule->turning == FW_AXES_SURFACE) {
        /* This adds a force that has no potential; what is left is V for fixed axes. */
        second = (fw_vector_pair){bond.tangential * pair->dy, -bond.tangential * pair->dx};
    }
    const double a = rule->turn.first, b = rule->turn.second;
    return (fw_pull){
        {fw_keep(inside, a * first.x + b * second.x), fw_keep(inside, a * first.y + b * second.y)},
        fw_keep(inside, a * (bond.energy * cosine) + b * energy_second)};
}

/* Positive parts of the second derivatives of the potential: U'' along the bond, U'/r across. */
FW_INLINE void add_stiffness(const fw_pair_rule *rule, fw_pair_kind kind, double unit,
                             const fw_pair_lanes *pair, fw_vector push, fw_lane_sums *sums)
{
    const fw_vector none = fw_splat(0);
    const fw_vector curvature = unit * fw_pair_curvature(rule, kind, pair);
    const fw_vector along = fw_larger(curvature, none) * pair->inverse;
    const fw_vector across = fw_larger(-push, none) * pair->inverse;
    const fw_vector dx = fw_keep(pair->held, pair->dx), dy = fw_keep(pair->held, pair->dy);
    sums->stiffness[0] += along * dx * dx + across * dy * dy;
    sums->stiffness[1] += (along - across) * dx * dy;
    sums->stiffness[2] += along * dy * dy + across * dx * dx;
}

/* The larger eigenvalue of a symmetric matrix. */
FW_INLINE fw_vector larger_eigenvalue(const fw_vector m[3])
{
    const fw_vector half = 0.5 * (m[0] - m[2]);
    return 0.5 * (m[0] + m[2]) + fw_root(half * half + m[1] * m[1]);
}

FW_INLINE void add_pair(const fw_pair_task *task, fw_wanted wanted, bool own,
                        const fw_pair_lanes *pair, fw_lane_sums *sums)
{
    const double unit = own ? task->pair.inside : task->pair.across;
    const fw_pair_terms terms = fw_pair_of(&task->pair, wanted.form, wanted.energy, pair);
    const fw_vector push = fw_keep(terms.inside, unit * terms.push);
    fw_pull pull = {{fw_splat(0), fw_splat(0)}, fw_splat(0)};
    if (own && wanted.bonds) {
        const fw_mask inside = fw_less_among(pair->held, pair->r2, fw_splat(task->bond.outer_2));
        if (fw_any(inside)) pull = pull_of(&task->bond, pair, inside);
    }
    if (wanted.energy) sums->energy += fw_keep(terms.inside, unit * terms.energy) + pull.energy;
    if (wanted.force) {
        sums->return_x += pull.force.x;
        sums->return_y += pull.force.y;
    }
    if (wanted.lengths && own) {
        const fw_mask bond = fw_less_among(pair->held, pair->r2, fw_splat(task->bond_2));
        const fw_vector square = pull.force.x * pull.force.x + pull.force.y * pull.force.y;
        sums->length += fw_keep(bond, fw_root(square));
        sums->bonds += fw_keep(bond, fw_splat(1));
    }
    if (wanted.stiffness) add_stiffness(&task->pair, wanted.form.kind, unit, pair, push, sums);
    if (wanted.virial) {
        const fw_vector dx = fw_keep(pair->held, pair->dx), dy = fw_keep(pair->held, pair->dy);
        const fw_vector force_x = push * dx + pull.force.x, force_y = push * dy + pull.force.y;
        sums->virial[0] += 0.5 * dx * force_x;
        sums->virial[1] += 0.5 * dx * force_y;
        sums->virial[2] += 0.5 * dy * force_x;
        sums->virial[3] += 0.5 * dy * force_y;
    }
}

FW_INLINE void add_run(const fw_pair_task *task, fw_wanted wanted, bool own, fw_slot_kind kind,
                       const fw_slots *slots, uint32_t begin, uint32_t count,
                       const fw_own_lanes *lanes, fw_lane_sums *sums)
{
    for (uint32_t s = begin; s < begin + count; ++s) {
        const fw_pair_lanes pair = fw_pair_in_slot(task, slots, s, kind, lanes);
        add_pair(task, wanted, own, &pair, sums);
    }
}

FW_INLINE fw_lane_sums sum_lanes(const fw_pair_task *task, fw_wanted wanted, const fw_slots *slots,
                                 const fw_slot_head *head, const fw_own_lanes *lanes)
{
    fw_lane_sums sums = {.energy = fw_splat(0)};
    uint32_t begin = head->begin;
    for (int run = 0; run < FW_SLOT_RUNS; ++run) {
        const uint32_t count = head->count[run];
        const bool own = run == FW_RUN_OWN;
        if (own && head->whole)
            add_run(task, wanted, true, FW_WHOLE, slots, begin, count, lanes, &sums);
        else if (own)
            add_run(task, wanted, true, head->gathered[run] ? FW_GATHERED : FW_OFFSETS, slots,
                    begin, count, lanes, &sums);
        else
            add_run(task, wanted, false, head->gathered[run] ? FW_GATHERED : FW_OFFSETS, slots,
                    begin, count, lanes, &sums);
        begin += count;
    }
    return sums;
}

static void store(double *to, int first, fw_mask held, fw_vector values)
{
    if (to) fw_store_some(to + first, held, values);
}

FW_INLINE void sum_chunk(const fw_pair_task *task, fw_wanted wanted, const fw_chunk *chunk,
                         const fw_sum_arrays *out)
{
    for (int block = 0; block < fw_chunk_blocks(chunk); ++block)
        for (int part = 0; part < FW_PARTS; ++part) {
            const int first = chunk->first + block * FW_BLOCK + part * FW_WIDTH;
            const fw_own_lanes lanes = fw_own_lanes_at(task, first, part);
            const fw_lane_sums sums =
                sum_lanes(task, wanted, &chunk->near, &chunk->near.head[block], &lanes);
            const fw_mask held = fw_mask_of(fw_chunk_lanes(chunk, block), part);
            if (wanted.energy) store(out->energy, first, held, 0.5 * sums.energy);
            if (wanted.stiffness)
                store(out->stiffness, first, held, larger_eigenvalue(sums.stiffness));
            if (wanted.force) store(out->return_x, first, held, sums.return_x);
            if (wanted.force) store(out->return_y, first, held, sums.return_y);
            if (wanted.lengths) store(out->bond_length, first, held, sums.length / sums.bonds);
            for (int v = 0; wanted.virial && v < 4; ++v)
                store(out->virial[v], first, held, sums.virial[v]);
        }
}

#define LOOP(name, kind, fades, bond, ...)                                                         \
    static void name(const fw_pair_task *task, const fw_chunk *chunk, const fw_sum_arrays *out)    \
    {                                                                                              \
        sum_chunk(task, (fw_wanted){.form = {kind, fades}, .bonds = bond, __VA_ARGS__}, chunk,     \
                  out);                                                                            \
    }
LOOP(energies, FW_LENNARD_JONES, true, true, .energy = true)
LOOP(energies_plain, FW_LENNARD_JONES, true, false, .energy = true)
LOOP(energies_end, FW_LENNARD_JONES, false, false, .energy = true)
LOOP(energies_morse, FW_MORSE, true, true, .energy = true)
LOOP(stiffnesses, FW_LENNARD_JONES, true, true, .stiffness = true)
LOOP(stiffnesses_morse, FW_MORSE, true, true, .stiffness = true)
LOOP(others, FW_LENNARD_JONES, true, true, .force = true, .virial = true, .lengths = true)
LOOP(others_morse, FW_MORSE, true, true, .force = true, .virial = true, .lengths = true)

static void sums(const fw_pair_task *task, const fw_chunk *chunk, const fw_sum_arrays *out)
{
    const bool jones = task->pair.kind == FW_LENNARD_JONES;
    const bool fades = task->pair.cut.inner < task->pair.cut.outer;
    const bool bonds = task->bond.amplitude > 0;
    if (out->energy)
        (!jones  ? energies_morse
         : bonds ? energies
         : fades ? energies_plain
                 : energies_end)(task, chunk, &(fw_sum_arrays){.energy = out->energy});
    if (out->stiffness)
        (jones ? stiffnesses : stiffnesses_morse)(task, chunk,
                                                  &(fw_sum_arrays){.stiffness = out->stiffness});
    if (!out->return_x && !out->bond_length && !out->virial[0]) return;
    fw_sum_arrays rest = *out;
    rest.energy = rest.stiffness = NULL;
    (jones ? others : others_morse)(task, chunk, &rest);
}

const fw_sum_kernels FW_KERNELS_HERE(fw_particle_sums) = {.sums = sums};
