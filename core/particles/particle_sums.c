/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_sums.c - what else is summed over the bonds of movable lattice particles: energies, net
 * return forces, the virial, bond order. Keeps no state. As in particle_forces.c each particle
 * gathers from its neighbours in ascending order. */
#include "particle_forces.h"

#include <math.h>

enum { PARALLEL_FROM = 1024 }; /* particles; below it threads cost more than they bring */

/* Everything that the bonds of i in its own body contribute to its return force. */
static inline fw_return_pair return_sums(const fw_particles *particles, int i)
{
    const fw_particle_group *group = &particles->groups[particles->group_of[i]];
    const fw_return_force rule = group->return_force;
    const fw_phase axes = group->axes;
    const double *restrict x = particles->langevin.head.x, *restrict y = particles->langevin.head.y;
    fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
    fw_return_pair sums = {.energy = 0};
    for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
        if (particles->group_of[j] != particles->group_of[i]) continue;
        const double dx = x[i] - x[j], dy = y[i] - y[j];
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

void fw_particles_bond_return_forces(const fw_solid *solid, double *lengths)
{
    const fw_particles *particles = (const fw_particles *)solid;
    const double radius = particles->bond_radius;
#pragma omp parallel for schedule(static) if (solid->count > PARALLEL_FROM)
    for (int i = 0; i < solid->count; ++i) {
        const fw_particle_group *group = &particles->groups[particles->group_of[i]];
        double sum = 0;
        int bonds = 0;
        fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
        for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
            if (particles->group_of[j] != particles->group_of[i]) continue;
            const double dx = solid->x[i] - solid->x[j], dy = solid->y[i] - solid->y[j];
            const double r2 = dx * dx + dy * dy;
            if (!(r2 < radius * radius)) continue;
            const fw_return_pair pair =
                fw_return_pair_at(&group->return_force, group->axes, dx, dy, r2);
            const fw_vec2 force = turned(group->turn, pair.first, pair.second);
            sum += sqrt(force.x * force.x + force.y * force.y);
            bonds += 1;
        }
        lengths[i] = bonds > 0 ? sum / bonds : NAN;
    }
}

fw_vec2 fw_particles_force_on(const fw_solid *solid, int group, int by_group)
{
    const fw_particles *particles = (const fw_particles *)solid;
    const fw_particle_group *body = &particles->groups[group];
    fw_vec2 sum = {0, 0};
    for (int i = body->first; i < body->first + body->count; ++i) {
        fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
        for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
            if (particles->group_of[j] != by_group) continue;
            const double dx = solid->x[i] - solid->x[j], dy = solid->y[i] - solid->y[j];
            const double push = particles->strength_across *
                                fw_pair_at(&particles->potential, dx * dx + dy * dy).push;
            sum = fw_vec2_add(sum, (fw_vec2){push * dx, push * dy});
        }
    }
    return sum;
}

/* Calls for each neighbour of i whether it is in the same body, and how strong the potential is. */
static double strength_of(const fw_particles *particles, int i, int j)
{
    const bool own = particles->group_of[i] == particles->group_of[j];
    return own ? particles->groups[particles->group_of[i]].strength : particles->strength_across;
}

void fw_particles_pair_energies(const fw_solid *solid, double *energies)
{
    const fw_particles *particles = (const fw_particles *)solid;
#pragma omp parallel for schedule(static) if (solid->count > PARALLEL_FROM)
    for (int i = 0; i < solid->count; ++i) {
        const fw_turn turn = particles->groups[particles->group_of[i]].turn;
        const fw_return_pair sums = return_sums(particles, i);
        /* Surface axes add a force that has no potential; what is left is V for fixed axes. */
        double energy = turn.first * sums.energy + turn.second * sums.energy_second;
        fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
        for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
            const double dx = solid->x[i] - solid->x[j], dy = solid->y[i] - solid->y[j];
            const fw_pair pair = fw_pair_at(&particles->potential, dx * dx + dy * dy);
            energy += strength_of(particles, i, j) * pair.energy;
        }
        energies[i] = 0.5 * energy;
    }
}

/* Sum over the neighbours of i of (r_i - r_j) (x) F_ij / 2. */
static fw_tensor virial_of(const fw_particles *particles, int i)
{
    const fw_solid *head = &particles->langevin.head;
    const fw_particle_group *group = &particles->groups[particles->group_of[i]];
    fw_tensor sum = {0};
    fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
    for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
        const double dx = head->x[i] - head->x[j], dy = head->y[i] - head->y[j];
        const double r2 = dx * dx + dy * dy;
        const double push =
            strength_of(particles, i, j) * fw_pair_at(&particles->potential, r2).push;
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
    const int fold = particles->groups[particles->group_of[particle]].return_force.fold;
    fw_phase sum = {0, 0};
    *bonds = 0;
    fw_neighbour_walk walk = fw_neighbours_around(particles->lists, particle);
    for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
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
