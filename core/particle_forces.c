/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_forces.c - sums over the bonds of movable lattice particles (Popov & Filippov Eqs 13,
 * 18). Each particle gathers from its neighbours in ascending order and writes only its own
 * entries, and what lies beyond a cut adds an exact zero: the result depends neither on threads nor
 * on when lists were made. Start reading at fw_particles_find_forces(). */
#include "core/particle_forces.h"

#include <assert.h>
#include <math.h>

enum { PARALLEL_FROM = 1024 }; /* particles; below it threads cost more than they bring */

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

/* The force of the potential on particle i from the neighbours at list[from] .. list[to - 1]. */
static inline fw_vec2 pushes(const fw_particles *particles, int i, size_t from, size_t to)
{
    const fw_pair_potential potential = particles->potential;
    const double *restrict x = particles->langevin.head.x, *restrict y = particles->langevin.head.y;
    const int *restrict list = particles->neighbours->list;
    fw_vec2 force = {0, 0};
    for (size_t k = from; k < to; ++k) {
        const double dx = x[i] - x[list[k]], dy = y[i] - y[list[k]];
        const fw_pair pair = fw_pair_at(&potential, dx * dx + dy * dy);
        force.x += pair.push * dx;
        force.y += pair.push * dy;
    }
    return force;
}

static inline fw_vec2 potential_force(const fw_particles *particles, int i)
{
    const size_t *begin = particles->neighbours->begin;
    const double inside = particles->groups[particles->group_of[i]].strength;
    fw_vec2 force = {0, 0};
    if (inside > 0)
        force = fw_vec2_scale(inside,
                              pushes(particles, i, particles->own_begin[i], particles->own_end[i]));
    if (particles->strength_across > 0) {
        const fw_vec2 lower = pushes(particles, i, begin[i], particles->own_begin[i]);
        const fw_vec2 higher = pushes(particles, i, particles->own_end[i], begin[i + 1]);
        force = fw_vec2_add(force,
                            fw_vec2_scale(particles->strength_across, fw_vec2_add(lower, higher)));
    }
    return force;
}

static inline fw_vec2 lab_return_force(const fw_particles *particles, int i)
{
    const fw_particle_group *group = &particles->groups[particles->group_of[i]];
    const fw_return_force rule = group->return_force;
    const fw_phase axes = group->axes;
    const double *restrict x = particles->langevin.head.x, *restrict y = particles->langevin.head.y;
    const int *restrict list = particles->neighbours->list;
    fw_vec2 force = {0, 0};
    for (size_t k = particles->own_begin[i]; k < particles->own_end[i]; ++k) {
        const double dx = x[i] - x[list[k]], dy = y[i] - y[list[k]];
        const fw_vec2 pull = fw_return_lab(&rule, axes, dx, dy, dx * dx + dy * dy);
        force.x += pull.x;
        force.y += pull.y;
    }
    return force;
}

/* Everything that the bonds of i in its own body contribute to its return force. */
static inline fw_return_pair return_sums(const fw_particles *particles, int i)
{
    const fw_particle_group *group = &particles->groups[particles->group_of[i]];
    const fw_return_force rule = group->return_force;
    const fw_phase axes = group->axes;
    const double *restrict x = particles->langevin.head.x, *restrict y = particles->langevin.head.y;
    const int *restrict list = particles->neighbours->list;
    fw_return_pair sums = {.energy = 0};
    for (size_t k = particles->own_begin[i]; k < particles->own_end[i]; ++k) {
        const double dx = x[i] - x[list[k]], dy = y[i] - y[list[k]];
        const fw_return_pair pair = fw_return_pair_at(&rule, axes, dx, dy, dx * dx + dy * dy);
        sums.first = fw_vec2_add(sums.first, pair.first);
        sums.second = fw_vec2_add(sums.second, pair.second);
        sums.energy += pair.energy;
        sums.energy_second += pair.energy_second;
        sums.sum.cosine += pair.sum.cosine;
        sums.sum.sine += pair.sum.sine;
    }
    return sums;
}

static bool turns(const fw_particle_group *group)
{
    return group->return_force.axes != FW_AXES_LAB && group->return_force.amplitude > 0;
}

/* The forces of a body without return force, or with fixed axes. */
static void find_fixed(fw_particles *particles, const fw_particle_group *group)
{
    fw_langevin *solid = &particles->langevin;
    const bool returning = group->return_force.amplitude > 0;
#pragma omp parallel for schedule(static) if (group->count > PARALLEL_FROM)
    for (int i = group->first; i < group->first + group->count; ++i) {
        fw_vec2 force = potential_force(particles, i);
        if (returning) force = fw_vec2_add(force, lab_return_force(particles, i));
        solid->force_x[i] = force.x;
        solid->force_y[i] = force.y;
    }
}

/* The forces of a body whose axes follow from all its bonds: the two parts of each return force
 * first, then the turn that puts them together. */
static void find_turning(fw_particles *particles, fw_particle_group *group)
{
    fw_langevin *solid = &particles->langevin;
    const int first = group->first, end = group->first + group->count;
#pragma omp parallel for schedule(static) if (group->count > PARALLEL_FROM)
    for (int i = first; i < end; ++i) {
        const fw_vec2 force = potential_force(particles, i);
        const fw_return_pair sums = return_sums(particles, i);
        solid->force_x[i] = force.x;
        solid->force_y[i] = force.y;
        particles->first_x[i] = sums.first.x;
        particles->first_y[i] = sums.first.y;
        particles->second_x[i] = sums.second.x;
        particles->second_y[i] = sums.second.y;
        particles->sum_cosine[i] = sums.sum.cosine;
        particles->sum_sine[i] = sums.sum.sine;
    }
    const fw_phase sum = {fw_array_sum(particles->sum_cosine + first, (size_t)group->count),
                          fw_array_sum(particles->sum_sine + first, (size_t)group->count)};
    const fw_turn turn = fw_return_turn(group->return_force.axes, sum);
    group->turn = turn;
    for (int i = first; i < end; ++i) {
        solid->force_x[i] +=
            turn.first * particles->first_x[i] + turn.second * particles->second_x[i];
        solid->force_y[i] +=
            turn.first * particles->first_y[i] + turn.second * particles->second_y[i];
    }
}

void fw_particles_find_forces(fw_langevin *solid)
{
    fw_particles *particles = (fw_particles *)solid;
    if (!fw_neighbours_refresh(particles->neighbours, solid->head.x, solid->head.y))
        solid->head.trouble = "not enough memory for the neighbour lists of the particles";
    if (particles->generation != particles->neighbours->generation) find_own_bodies(particles);
    for (int g = 0; g < particles->group_count; ++g) {
        fw_particle_group *group = &particles->groups[g];
        if (turns(group))
            find_turning(particles, group);
        else
            find_fixed(particles, group);
    }
}

static fw_vec2 turned(fw_turn turn, fw_vec2 first, fw_vec2 second)
{
    return fw_vec2_add(fw_vec2_scale(turn.first, first), fw_vec2_scale(turn.second, second));
}

void fw_particles_return_forces(const fw_solid *solid, double *x, double *y)
{
    const fw_particles *particles = (const fw_particles *)solid;
#pragma omp parallel for schedule(static) if (solid->count > PARALLEL_FROM)
    for (int i = 0; i < solid->count; ++i) {
        const fw_particle_group *group = &particles->groups[particles->group_of[i]];
        const fw_return_pair sums = return_sums(particles, i);
        const fw_vec2 force = turned(group->turn, sums.first, sums.second);
        x[i] = force.x;
        y[i] = force.y;
    }
}

/* Calls for each neighbour of i whether it is in the same body, and how strong the potential is. */
static double strength_of(const fw_particles *particles, int i, size_t k)
{
    const bool own = k >= particles->own_begin[i] && k < particles->own_end[i];
    return own ? particles->groups[particles->group_of[i]].strength : particles->strength_across;
}

void fw_particles_pair_energies(const fw_solid *solid, double *energies)
{
    const fw_particles *particles = (const fw_particles *)solid;
    const fw_neighbours *neighbours = particles->neighbours;
#pragma omp parallel for schedule(static) if (solid->count > PARALLEL_FROM)
    for (int i = 0; i < solid->count; ++i) {
        const fw_turn turn = particles->groups[particles->group_of[i]].turn;
        const fw_return_pair sums = return_sums(particles, i);
        /* Surface axes add a force that has no potential; what is left is V for fixed axes. */
        double energy = turn.first * sums.energy + turn.second * sums.energy_second;
        for (size_t k = neighbours->begin[i]; k < neighbours->begin[i + 1]; ++k) {
            const int j = neighbours->list[k];
            const double dx = solid->x[i] - solid->x[j], dy = solid->y[i] - solid->y[j];
            const fw_pair pair = fw_pair_at(&particles->potential, dx * dx + dy * dy);
            energy += strength_of(particles, i, k) * pair.energy;
        }
        energies[i] = 0.5 * energy;
    }
}

/* Sum over the neighbours of i of (r_i - r_j) (x) F_ij / 2. */
static fw_tensor virial_of(const fw_particles *particles, int i)
{
    const fw_solid *head = &particles->langevin.head;
    const fw_neighbours *neighbours = particles->neighbours;
    const fw_particle_group *group = &particles->groups[particles->group_of[i]];
    fw_tensor sum = {0};
    for (size_t k = neighbours->begin[i]; k < neighbours->begin[i + 1]; ++k) {
        const int j = neighbours->list[k];
        const double dx = head->x[i] - head->x[j], dy = head->y[i] - head->y[j];
        const double r2 = dx * dx + dy * dy;
        const double push =
            strength_of(particles, i, k) * fw_pair_at(&particles->potential, r2).push;
        fw_vec2 force = {push * dx, push * dy};
        if (particles->group_of[j] == particles->group_of[i]) {
            const fw_return_pair pair =
                fw_return_pair_at(&group->return_force, group->axes, dx, dy, r2);
            force = fw_vec2_add(force, turned(group->turn, pair.first, pair.second));
        }
        sum.xx += 0.5 * dx * force.x;
        sum.xy += 0.5 * dx * force.y;
        sum.yx += 0.5 * dy * force.x;
        sum.yy += 0.5 * dy * force.y;
    }
    return sum;
}

fw_tensor fw_particles_virial(const fw_solid *solid, int group)
{
    const fw_particles *particles = (const fw_particles *)solid;
    const int first = group < 0 ? 0 : particles->groups[group].first;
    const int count = group < 0 ? solid->count : particles->groups[group].count;
    double *const *virial = particles->virial;
#pragma omp parallel for schedule(static) if (count > PARALLEL_FROM)
    for (int i = first; i < first + count; ++i) {
        const fw_tensor own = virial_of(particles, i);
        virial[0][i] = own.xx;
        virial[1][i] = own.xy;
        virial[2][i] = own.yx;
        virial[3][i] = own.yy;
    }
    const size_t size = (size_t)count;
    return (fw_tensor){fw_array_sum(virial[0] + first, size), fw_array_sum(virial[1] + first, size),
                       fw_array_sum(virial[2] + first, size),
                       fw_array_sum(virial[3] + first, size)};
}

fw_phase fw_particles_bond_order(const fw_solid *solid, int particle, int *bonds)
{
    const fw_particles *particles = (const fw_particles *)solid;
    const fw_neighbours *neighbours = particles->neighbours;
    const int fold = particles->groups[particles->group_of[particle]].return_force.fold;
    fw_phase sum = {0, 0};
    *bonds = 0;
    for (size_t k = neighbours->begin[particle]; k < neighbours->begin[particle + 1]; ++k) {
        const int j = neighbours->list[k];
        const double dx = solid->x[particle] - solid->x[j], dy = solid->y[particle] - solid->y[j];
        const double r2 = dx * dx + dy * dy;
        if (!(r2 < particles->bond_radius * particles->bond_radius)) continue;
        const fw_phase phase = fw_phase_of_bond(fold, dx, dy, 1 / r2);
        sum.cosine += phase.cosine;
        sum.sine += phase.sine;
        *bonds += 1;
    }
    if (*bonds > 0) sum = (fw_phase){sum.cosine / *bonds, sum.sine / *bonds};
    return sum;
}
