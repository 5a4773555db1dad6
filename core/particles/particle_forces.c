/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_forces.c - the forces of movable lattice particles (Popov & Filippov Eqs 13, 18).
 *
 * Some particles at a time: the pairs that are near enough are written one after the other into
 * short arrays (gather), what they do is computed for all of them alike (a loop without branches,
 * which becomes vector code), and each particle adds up its own, in ascending order of neighbours.
 * A pair's values depend on the pair alone and what lies beyond a cut adds an exact zero, so the
 * result depends neither on threads, nor on when lists were made, nor on how particles are cut into
 * batches. Start reading at fw_particles_find_forces(). */
#include "particle_forces.h"

#include <math.h>

enum {
    PARALLEL_FROM = 1024, /* particles; below it threads cost more than they bring */
    PAIRS = 256,          /* of a batch: its arrays stay in the nearest cache */
    CHUNK = 256           /* particles that a thread takes at a time */
};

/* Pairs of a batch, and what they do to their owner. */
typedef struct fw_batch {
    int count;
    double dx[PAIRS], dy[PAIRS], r2[PAIRS]; /* r_i - r_j */
    double strength[PAIRS];                 /* of the potential */
    double own[PAIRS];                      /* 1 for a pair inside a body, else 0 */
    double force_x[PAIRS], force_y[PAIRS];  /* of the potential, and of fixed axes */
    /* For axes that turn: the parts of the return force, and what the turn is made of. */
    double first_x[PAIRS], first_y[PAIRS], second_x[PAIRS], second_y[PAIRS];
    double sum_cosine[PAIRS], sum_sine[PAIRS];
} fw_batch;

/* Where the pairs of one particle lie in the batch. */
typedef struct fw_share {
    int particle, begin, end;
} fw_share;

/* Neighbours ascend and groups are contiguous: those of the own body are one stretch. */
static void find_own_bodies(fw_particles *particles)
{
    const fw_neighbours *neighbours = particles->neighbours;
    for (int i = 0; i < neighbours->count; ++i) {
        const fw_particle_group *group = &particles->groups[particles->group_of[i]];
        size_t k = neighbours->begin[i];
        const size_t end = neighbours->begin[i + 1];
        while (k < end && neighbours->list[k] < group->first) ++k;
        particles->own_begin[i] = k;
        while (k < end && neighbours->list[k] < group->first + group->count) ++k;
        particles->own_end[i] = k;
    }
    particles->generation = neighbours->generation;
}

/* --- gather --- */

/* Appends the neighbours of i at list[from] .. list[to - 1] that are within reach. */
static inline int gather_stretch(const fw_particles *particles, int i, size_t from, size_t to,
                                 double strength, double own, fw_batch *batch, int begin)
{
    const double *restrict x = particles->langevin.head.x, *restrict y = particles->langevin.head.y;
    const int *restrict list = particles->neighbours->list;
    const double reach = particles->neighbours->radius * particles->neighbours->radius;
    const double at_x = x[i], at_y = y[i];
    int count = begin;
    for (size_t k = from; k < to; ++k) {
        const double dx = at_x - x[list[k]], dy = at_y - y[list[k]];
        const double r2 = dx * dx + dy * dy;
        batch->dx[count] = dx;
        batch->dy[count] = dy;
        batch->r2[count] = r2;
        count += r2 < reach;
    }
    for (int k = begin; k < count; ++k) {
        batch->strength[k] = strength;
        batch->own[k] = own;
    }
    return count;
}

/* Neighbours list[from] .. list[to - 1] of particle i, in ascending order, at most as many as a
 * batch holds. */
static fw_share gather(const fw_particles *particles, const fw_particle_group *group, int i,
                       size_t from, size_t to, fw_batch *batch)
{
    const double inside = group->strength, across = particles->strength_across;
    const size_t own_begin = particles->own_begin[i], own_end = particles->own_end[i];
    const size_t first = own_begin < from ? from : own_begin < to ? own_begin : to;
    const size_t last = own_end < from ? from : own_end < to ? own_end : to;
    const bool bound = inside > 0 || group->return_force.amplitude > 0;
    const int begin = batch->count;
    int count = begin;
    if (across > 0) count = gather_stretch(particles, i, from, first, across, 0, batch, count);
    if (bound) count = gather_stretch(particles, i, first, last, inside, 1, batch, count);
    if (across > 0) count = gather_stretch(particles, i, last, to, across, 0, batch, count);
    batch->count = count;
    return (fw_share){i, begin, count};
}

/* --- compute --- */

/* The constants in the calls of these loops let each become vector code of its own. */
static inline __attribute__((always_inline)) void push_all(const fw_pair_potential *potential,
                                                           fw_pair_kind kind, fw_batch *batch)
{
    fw_pair_potential rule = *potential;
    rule.kind = kind;
    const int count = batch->count;
    for (int k = 0; k < count; ++k) {
        const double push = batch->strength[k] * fw_pair_at(&rule, batch->r2[k]).push;
        batch->force_x[k] = push * batch->dx[k];
        batch->force_y[k] = push * batch->dy[k];
    }
}

static inline __attribute__((always_inline)) void return_all(const fw_return_force *force, int fold,
                                                             fw_phase axes, fw_batch *batch)
{
    fw_return_force rule = *force;
    rule.fold = fold;
    for (int k = 0; k < batch->count; ++k) {
        const fw_vec2 pull = fw_return_lab(&rule, axes, batch->dx[k], batch->dy[k], batch->r2[k]);
        batch->force_x[k] += batch->own[k] * pull.x;
        batch->force_y[k] += batch->own[k] * pull.y;
    }
}

static inline __attribute__((always_inline)) void turn_all(const fw_return_force *force, int fold,
                                                           fw_phase axes, fw_batch *batch)
{
    fw_return_force rule = *force;
    rule.fold = fold;
    for (int k = 0; k < batch->count; ++k) {
        const double own = batch->own[k];
        const fw_return_pair pair =
            fw_return_pair_at(&rule, axes, batch->dx[k], batch->dy[k], batch->r2[k]);
        batch->first_x[k] = own * pair.first.x;
        batch->first_y[k] = own * pair.first.y;
        batch->second_x[k] = own * pair.second.x;
        batch->second_y[k] = own * pair.second.y;
        batch->sum_cosine[k] = own * pair.sum.cosine;
        batch->sum_sine[k] = own * pair.sum.sine;
    }
}

static void compute(const fw_particles *particles, const fw_particle_group *group, bool turning,
                    fw_batch *batch)
{
    const fw_return_force *rule = &group->return_force;
    if (particles->potential.kind == FW_LENNARD_JONES)
        push_all(&particles->potential, FW_LENNARD_JONES, batch);
    else
        push_all(&particles->potential, FW_MORSE, batch);
    if (turning) {
        if (rule->fold == 6)
            turn_all(rule, 6, group->axes, batch);
        else if (rule->fold == 4)
            turn_all(rule, 4, group->axes, batch);
        else
            turn_all(rule, rule->fold, group->axes, batch);
    } else if (rule->amplitude > 0) {
        if (rule->fold == 6)
            return_all(rule, 6, group->axes, batch);
        else if (rule->fold == 4)
            return_all(rule, 4, group->axes, batch);
        else
            return_all(rule, rule->fold, group->axes, batch);
    }
}

/* --- add up --- */

static inline double sum_of(const double *values, fw_share share, double sum)
{
    for (int k = share.begin; k < share.end; ++k) sum += values[k];
    return sum;
}

static void add_up(fw_particles *particles, bool turning, const fw_batch *batch, fw_share share)
{
    fw_langevin *solid = &particles->langevin;
    const int i = share.particle;
    solid->force_x[i] = sum_of(batch->force_x, share, solid->force_x[i]);
    solid->force_y[i] = sum_of(batch->force_y, share, solid->force_y[i]);
    if (!turning) return;
    particles->first_x[i] = sum_of(batch->first_x, share, particles->first_x[i]);
    particles->first_y[i] = sum_of(batch->first_y, share, particles->first_y[i]);
    particles->second_x[i] = sum_of(batch->second_x, share, particles->second_x[i]);
    particles->second_y[i] = sum_of(batch->second_y, share, particles->second_y[i]);
    particles->sum_cosine[i] = sum_of(batch->sum_cosine, share, particles->sum_cosine[i]);
    particles->sum_sine[i] = sum_of(batch->sum_sine, share, particles->sum_sine[i]);
}

static void clear(fw_particles *particles, bool turning, int i)
{
    particles->langevin.force_x[i] = particles->langevin.force_y[i] = 0;
    if (!turning) return;
    particles->first_x[i] = particles->first_y[i] = 0;
    particles->second_x[i] = particles->second_y[i] = 0;
    particles->sum_cosine[i] = particles->sum_sine[i] = 0;
}

/* --- bodies --- */

static bool turns(const fw_particle_group *group)
{
    return group->return_force.axes != FW_AXES_LAB && group->return_force.amplitude > 0;
}

/* Particles first to end - 1 of a body. A particle whose neighbours do not fit into what is left
 * of a batch goes on in the next one. */
static void find_chunk(fw_particles *particles, const fw_particle_group *group, int first, int end)
{
    const size_t *begin = particles->neighbours->begin;
    const bool turning = turns(group);
    fw_batch batch;
    fw_share shares[PAIRS];
    batch.count = 0;
    int share_count = 0;
    for (int i = first; i < end; ++i) {
        clear(particles, turning, i);
        for (size_t k = begin[i]; k < begin[i + 1];) {
            const size_t room = (size_t)(PAIRS - batch.count);
            const size_t to = begin[i + 1] - k <= room ? begin[i + 1] : k + room;
            shares[share_count++] = gather(particles, group, i, k, to, &batch);
            k = to;
            if (k < begin[i + 1] || share_count == PAIRS) {
                compute(particles, group, turning, &batch);
                for (int s = 0; s < share_count; ++s) add_up(particles, turning, &batch, shares[s]);
                batch.count = share_count = 0;
            }
        }
    }
    compute(particles, group, turning, &batch);
    for (int s = 0; s < share_count; ++s) add_up(particles, turning, &batch, shares[s]);
}

static void find_all(fw_particles *particles, const fw_particle_group *group)
{
    const int end = group->first + group->count;
#pragma omp parallel for schedule(static) if (group->count > PARALLEL_FROM)
    for (int begin = group->first; begin < end; begin += CHUNK)
        find_chunk(particles, group, begin, begin + CHUNK < end ? begin + CHUNK : end);
}

/* Puts the two parts of the return forces of a body together, once all its bonds are known. */
static void turn_together(fw_particles *particles, fw_particle_group *group)
{
    fw_langevin *solid = &particles->langevin;
    const int first = group->first;
    const fw_phase sum = {fw_array_sum(particles->sum_cosine + first, (size_t)group->count),
                          fw_array_sum(particles->sum_sine + first, (size_t)group->count)};
    const fw_turn turn = fw_return_turn(group->return_force.axes, sum);
    group->turn = turn;
    for (int i = first; i < first + group->count; ++i) {
        solid->force_x[i] +=
            turn.first * particles->first_x[i] + turn.second * particles->second_x[i];
        solid->force_y[i] +=
            turn.first * particles->first_y[i] + turn.second * particles->second_y[i];
    }
}

fw_status fw_particles_find_forces(fw_langevin *solid, fw_error *error)
{
    fw_particles *particles = (fw_particles *)solid;
    FW_TRY(fw_neighbours_refresh(particles->neighbours, solid->head.x, solid->head.y, error));
    if (particles->generation != particles->neighbours->generation) find_own_bodies(particles);
    for (int g = 0; g < particles->group_count; ++g) {
        fw_particle_group *group = &particles->groups[g];
        find_all(particles, group);
        if (turns(group)) turn_together(particles, group);
    }
    return FW_OK;
}
