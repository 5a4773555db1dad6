/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sum_kernels.c - energies, virial, stiffness and return forces of movable lattice particles, eight
 * particles at a time; compiled once for each instruction set. Keeps no state. As in
 * particle_kernels.c every particle adds its neighbours in ascending order. Start reading at
 * add_pair(). */
#include "pair_vectors.h"

#include <stddef.h>

/* What is wanted; energies alone, which are asked for most often, have a loop of their own. */
typedef struct fw_wanted {
    bool energy, force, virial, lengths, stiffness;
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

FW_INLINE void add_pair(const fw_pair_task *task, fw_pair_kind kind, fw_wanted wanted, bool own,
                        const fw_pair_lanes *pair, fw_lane_sums *sums)
{
    const double unit = own ? task->pair.inside : task->pair.across;
    const fw_pair_terms terms =
        fw_pair_of(&task->pair, (fw_pair_form){kind, true}, wanted.energy, pair);
    const fw_vector push = fw_keep(terms.inside, unit * terms.push);
    fw_pull pull = {{fw_splat(0), fw_splat(0)}, fw_splat(0)};
    if (own) {
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
    if (wanted.stiffness) add_stiffness(&task->pair, kind, unit, pair, push, sums);
    if (wanted.virial) {
        const fw_vector dx = fw_keep(pair->held, pair->dx), dy = fw_keep(pair->held, pair->dy);
        const fw_vector force_x = push * dx + pull.force.x, force_y = push * dy + pull.force.y;
        sums->virial[0] += 0.5 * dx * force_x;
        sums->virial[1] += 0.5 * dx * force_y;
        sums->virial[2] += 0.5 * dy * force_x;
        sums->virial[3] += 0.5 * dy * force_y;
    }
}

FW_INLINE fw_lane_sums sum_lanes(const fw_pair_task *task, fw_pair_kind kind, fw_wanted wanted,
                                 const fw_slots *slots, const fw_slot_head *head,
                                 const fw_own_lanes *lanes)
{
    fw_lane_sums sums = {.energy = fw_splat(0)};
    uint32_t s = head->begin;
    for (int run = 0; run < FW_SLOT_RUNS; ++run) {
        const uint32_t end = s + head->count[run];
        const fw_slot_kind slot_kind = head->gathered[run] ? FW_GATHERED : FW_OFFSETS;
        for (; s < end; ++s) {
            const fw_pair_lanes pair = fw_pair_in_slot(task, slots, s, slot_kind, lanes);
            if (run == FW_RUN_OWN)
                add_pair(task, kind, wanted, true, &pair, &sums);
            else
                add_pair(task, kind, wanted, false, &pair, &sums);
        }
    }
    return sums;
}

static void store(double *to, int first, fw_mask held, fw_vector values)
{
    if (to) fw_store_some(to + first, held, values);
}

FW_INLINE void sum_chunk(const fw_pair_task *task, fw_pair_kind kind, fw_wanted wanted,
                         const fw_chunk *chunk, const fw_sum_arrays *out)
{
    for (int block = 0; block < fw_chunk_blocks(chunk); ++block)
        for (int part = 0; part < FW_PARTS; ++part) {
            const int first = chunk->first + block * FW_BLOCK + part * FW_WIDTH;
            const fw_own_lanes lanes = fw_own_lanes_at(task, first, part);
            const fw_lane_sums sums =
                sum_lanes(task, kind, wanted, &chunk->near, &chunk->near.head[block], &lanes);
            const fw_mask held = fw_mask_of(fw_chunk_lanes(chunk, block), part);
            store(out->energy, first, held, 0.5 * sums.energy);
            store(out->return_x, first, held, sums.return_x);
            store(out->return_y, first, held, sums.return_y);
            store(out->bond_length, first, held, sums.length / sums.bonds);
            store(out->stiffness, first, held, larger_eigenvalue(sums.stiffness));
            for (int v = 0; v < 4; ++v) store(out->virial[v], first, held, sums.virial[v]);
        }
}

FW_INLINE void sum_either(const fw_pair_task *task, fw_wanted wanted, const fw_chunk *chunk,
                          const fw_sum_arrays *out)
{
    if (task->pair.kind == FW_LENNARD_JONES)
        sum_chunk(task, FW_LENNARD_JONES, wanted, chunk, out);
    else
        sum_chunk(task, FW_MORSE, wanted, chunk, out);
}

static void energies(const fw_pair_task *task, const fw_chunk *chunk, double *energy)
{
    sum_either(task, (fw_wanted){.energy = true}, chunk, &(fw_sum_arrays){.energy = energy});
}

static void stiffnesses(const fw_pair_task *task, const fw_chunk *chunk, double *stiffness)
{
    sum_either(task, (fw_wanted){.stiffness = true}, chunk,
               &(fw_sum_arrays){.stiffness = stiffness});
}

static void sums(const fw_pair_task *task, const fw_chunk *chunk, const fw_sum_arrays *out)
{
    if (out->energy) energies(task, chunk, out->energy);
    if (out->stiffness) stiffnesses(task, chunk, out->stiffness);
    if (!out->return_x && !out->bond_length && !out->virial[0]) return;
    fw_sum_arrays rest = *out;
    rest.energy = rest.stiffness = NULL;
    sum_either(task, (fw_wanted){.force = true, .virial = true, .lengths = true}, chunk, &rest);
}

const fw_sum_kernels FW_KERNELS_HERE(fw_particle_sums) = {.sums = sums};
