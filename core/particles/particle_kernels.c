/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_kernels.c - the forces of movable lattice particles (Popov & Filippov Eqs 13, 18), eight
 * particles at a time; compiled once for each instruction set. Keeps no state.
 *
 * A pair's values depend on the pair alone, lanes without a pair and pairs beyond a cut add +0, and
 * every particle adds its neighbours in ascending order: the same bytes whatever the lists hold
 * beyond the cut, whatever their slots are, and for any width of vectors. Start reading at
 * add_pair(). */
#include "particle_kernels.h"

#include "kick_vectors.h"
#include "pair_vectors.h"

/* What the pairs of the lanes add up to. */
typedef struct fw_lane_sums {
    fw_vector_pair push; /* of the potential, along one run, in its unit of energy */
    fw_vector_pair force, first, second;
    fw_vector sum_cosine, sum_sine;
} fw_lane_sums;

/* What a loop is compiled for. fold 6 and 4 are, others (0) are read from the rule. */
typedef enum fw_return_use { FW_NO_RETURN, FW_RETURN_FIXED, FW_RETURN_TURNING } fw_return_use;
typedef struct fw_pair_use {
    fw_pair_form form;
    fw_return_use bond;
    int fold;
    int together; /* parts of a block that go through its slots together */
} fw_pair_use;

/* Where a register holds half a block, the sums of one half wait for each other, those of both do
 * not. Pairs with a return force are long enough to overlap anyhow, and want all registers. */
enum { TOGETHER_MAX = 2, TOGETHER_PLAIN = FW_WIDTH == 4 ? TOGETHER_MAX : 1 };

FW_INLINE fw_pair_use use_of(fw_pair_form form, fw_return_use bond, int fold)
{
    return (fw_pair_use){form, bond, fold, bond == FW_NO_RETURN ? TOGETHER_PLAIN : 1};
}

FW_INLINE void add_turning(const fw_return_rule *rule, const fw_pair_lanes *pair,
                           const fw_return_lanes *bond, fw_mask inside, fw_lane_sums *sums)
{
    const fw_vector cosine = bond->phase.cosine, sine = bond->phase.sine;
    fw_return_add(bond, cosine, sine, pair, inside, &sums->first);
    if (rule->turning == FW_AXES_COROTATING) {
        /* sin(a - t) = sin a cos t - cos a sin t, cos(a - t) = cos a cos t + sin a sin t */
        fw_return_add(bond, sine, -cosine, pair, inside, &sums->second);
        sums->sum_cosine += fw_keep(inside, bond->weight * cosine);
        sums->sum_sine += fw_keep(inside, bond->weight * sine);
    } else {
        sums->second.x += fw_keep(inside, bond->tangential * pair->dy);
        sums->second.y += fw_keep(inside, -bond->tangential * pair->dx);
        sums->sum_cosine += fw_keep(inside, bond->weight);
        sums->sum_sine += fw_keep(inside, bond->weight * sine);
    }
}

FW_INLINE void add_pair(const fw_pair_task *task, fw_pair_use use, const fw_pair_lanes *pair,
                        fw_lane_sums *sums)
{
    const fw_pair_terms terms = fw_pair_of(&task->pair, use.form, false, pair);
    sums->push.x = fw_add_product(terms.inside, terms.push, pair->dx, sums->push.x);
    sums->push.y = fw_add_product(terms.inside, terms.push, pair->dy, sums->push.y);
    if (use.bond == FW_NO_RETURN) return;
    const fw_mask inside = fw_less_among(pair->held, pair->r2, fw_splat(task->bond.outer_2));
    if (!fw_any(inside)) return;
    const fw_return_lanes bond = fw_return_of(&task->bond, use.fold, pair, inside);
    if (use.bond == FW_RETURN_TURNING)
        add_turning(&task->bond, pair, &bond, inside, sums);
    else
        fw_return_add(&bond, bond.phase.cosine, bond.phase.sine, pair, inside, &sums->force);
}

/* Do particles of the body act upon each other? */
FW_INLINE bool acts_inside(const fw_pair_task *task, fw_pair_use use)
{
    return use.bond != FW_NO_RETURN || task->pair.inside > 0;
}

FW_INLINE void add_slots(const fw_pair_task *task, fw_pair_use use, const fw_slots *slots,
                         uint32_t begin, uint32_t count, fw_slot_kind kind,
                         const fw_own_lanes *lanes, fw_lane_sums *sums)
{
    for (uint32_t s = begin; s < begin + count; ++s)
        for (int n = 0; n < use.together; ++n) {
            const fw_pair_lanes pair = fw_pair_in_slot(task, slots, s, kind, &lanes[n]);
            add_pair(task, use, &pair, &sums[n]);
        }
}

/* Along a run. `unit` is that of the potential. */
FW_INLINE void add_run(const fw_pair_task *task, fw_pair_use use, double unit,
                       const fw_slots *slots, uint32_t begin, uint32_t count, fw_slot_kind kind,
                       const fw_own_lanes *lanes, fw_lane_sums *sums)
{
    for (int n = 0; n < use.together; ++n)
        sums[n].push = (fw_vector_pair){fw_splat(0), fw_splat(0)};
    if (kind == FW_WHOLE)
        add_slots(task, use, slots, begin, count, FW_WHOLE, lanes, sums);
    else if (kind == FW_OFFSETS)
        add_slots(task, use, slots, begin, count, FW_OFFSETS, lanes, sums);
    else
        add_slots(task, use, slots, begin, count, FW_GATHERED, lanes, sums);
    for (int n = 0; n < use.together; ++n) {
        sums[n].force.x = fw_fma(fw_splat(unit), sums[n].push.x, sums[n].force.x);
        sums[n].force.y = fw_fma(fw_splat(unit), sums[n].push.y, sums[n].force.y);
    }
}

/* All neighbours, body after body. */
FW_INLINE void add_runs(const fw_pair_task *task, fw_pair_use use, const fw_slots *slots,
                        const fw_slot_head *head, const fw_own_lanes *lanes, fw_lane_sums *sums)
{
    const fw_pair_use across = {use.form, FW_NO_RETURN, 0, use.together};
    uint32_t begin = head->begin;
    for (int run = 0; run < FW_SLOT_RUNS; ++run) {
        const uint32_t count = head->count[run];
        const bool whole = run == FW_RUN_OWN && head->whole;
        const fw_slot_kind kind = head->gathered[run] ? FW_GATHERED : whole ? FW_WHOLE : FW_OFFSETS;
        if (run == FW_RUN_OWN && acts_inside(task, use))
            add_run(task, use, task->pair.inside, slots, begin, count, kind, lanes, sums);
        if (run != FW_RUN_OWN && task->pair.across > 0)
            add_run(task, across, task->pair.across, slots, begin, count, kind, lanes, sums);
        begin += count;
    }
}

/* Most blocks lie inside their body: they have one run, and its slots are whole. */
FW_INLINE bool is_plain(const fw_pair_task *task, fw_pair_use use, const fw_slot_head *head)
{
    return head->whole && head->count[0] == 0 && head->count[FW_RUN_OWN + 1] == 0 &&
           acts_inside(task, use);
}

FW_INLINE void store_sums(fw_pair_use use, int first, fw_mask held, const fw_lane_sums *sums,
                          const fw_force_arrays *out, const fw_move_task *kick)
{
    fw_store_some(out->force_x + first, held, sums->force.x);
    fw_store_some(out->force_y + first, held, sums->force.y);
    if (kick) fw_kick(kick, kick->external_x != NULL, first, held, sums->force);
    if (use.bond != FW_RETURN_TURNING) return;
    fw_store_some(out->first_x + first, held, sums->first.x);
    fw_store_some(out->first_y + first, held, sums->first.y);
    fw_store_some(out->second_x + first, held, sums->second.x);
    fw_store_some(out->second_y + first, held, sums->second.y);
    fw_store_some(out->sum_cosine + first, held, sums->sum_cosine);
    fw_store_some(out->sum_sine + first, held, sums->sum_sine);
}

FW_INLINE void sum_block(const fw_pair_task *task, fw_pair_use use, bool plain,
                         const fw_chunk *chunk, int block, const fw_force_arrays *out,
                         const fw_move_task *kick)
{
    const fw_slots *slots = &chunk->near;
    const fw_slot_head *head = &slots->head[block];
    const uint8_t mask = fw_chunk_lanes(chunk, block);
    const int first = chunk->first + block * FW_BLOCK;
    for (int part = 0; part < FW_PARTS; part += use.together) {
        fw_own_lanes lanes[TOGETHER_MAX];
        fw_lane_sums sums[TOGETHER_MAX] = {{.force = {fw_splat(0), fw_splat(0)}}};
        for (int n = 0; n < use.together; ++n)
            lanes[n] = fw_own_lanes_at(task, first + (part + n) * FW_WIDTH, part + n);
        if (plain)
            add_run(task, use, task->pair.inside, slots, head->begin, head->count[FW_RUN_OWN],
                    FW_WHOLE, lanes, sums);
        else
            add_runs(task, use, slots, head, lanes, sums);
        for (int n = 0; n < use.together; ++n)
            store_sums(use, first + (part + n) * FW_WIDTH, fw_mask_of(mask, part + n), &sums[n],
                       out, kick);
    }
}

/* Blocks that are not plain have a function of their own: it leaves the registers to the others. */
#define LOOP(name, kind, fades, bond, fold)                                                        \
    static __attribute__((noinline)) void name##_block(                                            \
        const fw_pair_task *task, const fw_chunk *chunk, int block, const fw_force_arrays *out,    \
        const fw_move_task *kick)                                                                  \
    {                                                                                              \
        const fw_pair_use use = use_of((fw_pair_form){kind, fades}, bond, fold);                   \
        sum_block(task, use, false, chunk, block, out, kick);                                      \
    }                                                                                              \
    static void name(const fw_pair_task *task, const fw_chunk *chunk, const fw_force_arrays *out,  \
                     const fw_move_task *kick)                                                     \
    {                                                                                              \
        const fw_pair_use use = use_of((fw_pair_form){kind, fades}, bond, fold);                   \
        for (int block = 0; block < fw_chunk_blocks(chunk); ++block)                               \
            if (is_plain(task, use, &chunk->near.head[block]))                                     \
                sum_block(task, use, true, chunk, block, out, kick);                               \
            else                                                                                   \
                name##_block(task, chunk, block, out, kick);                                       \
    }
LOOP(lennard_jones, FW_LENNARD_JONES, true, FW_NO_RETURN, 0)
LOOP(lennard_jones_ends, FW_LENNARD_JONES, false, FW_NO_RETURN, 0)
LOOP(lennard_jones_fixed_6, FW_LENNARD_JONES, true, FW_RETURN_FIXED, 6)
LOOP(lennard_jones_fixed_4, FW_LENNARD_JONES, true, FW_RETURN_FIXED, 4)
LOOP(lennard_jones_fixed, FW_LENNARD_JONES, true, FW_RETURN_FIXED, 0)
LOOP(lennard_jones_turning_6, FW_LENNARD_JONES, true, FW_RETURN_TURNING, 6)
LOOP(lennard_jones_turning, FW_LENNARD_JONES, true, FW_RETURN_TURNING, 0)
LOOP(morse, FW_MORSE, true, FW_NO_RETURN, 0)
LOOP(morse_fixed_6, FW_MORSE, true, FW_RETURN_FIXED, 6)
LOOP(morse_fixed, FW_MORSE, true, FW_RETURN_FIXED, 0)
LOOP(morse_turning, FW_MORSE, true, FW_RETURN_TURNING, 0)

/* A loop that fades also does for cuts that have no width; only where nothing else is to do is one
 * that need not ask for it sooner done. */
static void forces(const fw_pair_task *task, const fw_chunk *chunk, const fw_force_arrays *out,
                   const fw_move_task *kick)
{
    const bool jones = task->pair.kind == FW_LENNARD_JONES;
    const bool fades = task->pair.cut.inner < task->pair.cut.outer;
    const bool turning = task->bond.turning != FW_AXES_LAB;
    const int fold = task->bond.fold;
    if (!(task->bond.amplitude > 0))
        (!jones ? morse : fades ? lennard_jones : lennard_jones_ends)(task, chunk, out, kick);
    else if (turning)
        (!jones      ? morse_turning
         : fold == 6 ? lennard_jones_turning_6
                     : lennard_jones_turning)(task, chunk, out, kick);
    else if (jones)
        (fold == 6   ? lennard_jones_fixed_6
         : fold == 4 ? lennard_jones_fixed_4
                     : lennard_jones_fixed)(task, chunk, out, kick);
    else
        (fold == 6 ? morse_fixed_6 : morse_fixed)(task, chunk, out, kick);
}

const fw_particle_kernels FW_KERNELS_HERE(fw_particles_kernels) = {.forces = forces};
