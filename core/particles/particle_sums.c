/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_sums.c - what else is summed over the bonds of movable lattice particles: energies, net
 * return forces, the virial, bond order; the loops are in sum_kernels.c. Keeps no state, but for
 * energies, which are made once for the positions that they belong to. Start reading at
 * sum_all(). */
#include "particle_forces.h"

#include <math.h>
#include <string.h>

enum { PARALLEL_FROM = 1024 }; /* particles; below it threads cost more than they bring */

static void sum_bodies(const fw_particles *particles, int first, int end, const fw_sum_arrays *out)
{
    const fw_sum_kernels *kernels = FW_KERNELS_CHOSEN(fw_particle_sums);
    double *const arrays[FW_SUMS_MAX] = {out->energy,      out->return_x,  out->return_y,
                                         out->bond_length, out->stiffness, out->virial[0],
                                         out->virial[1],   out->virial[2], out->virial[3]};
    for (int g = first; g < end; ++g) {
        const fw_pair_task task = fw_particles_task(particles, g);
        double *to[FW_SUMS_MAX];
        fw_particles_divert(particles, g, FW_SUMS_MAX, arrays, to);
        const fw_sum_arrays sums = {to[0], to[1], to[2],
                                    to[3], to[4], {to[5], to[6], to[7], to[8]}};
        const int last = fw_neighbour_lists_first(particles->lists, g + 1);
#pragma omp parallel for schedule(static) if (particles->groups[g].count > PARALLEL_FROM)
        for (int c = fw_neighbour_lists_first(particles->lists, g); c < last; ++c)
            kernels->sums(&task, fw_neighbour_lists_chunk(particles->lists, c), &sums);
        fw_particles_bring_back(particles, g, FW_SUMS_MAX, to, arrays);
    }
}

static void sum_all(const fw_solid *solid, fw_sum_arrays out)
{
    const fw_particles *particles = (const fw_particles *)solid;
    sum_bodies(particles, 0, particles->group_count, &out);
}

void fw_particles_return_forces(const fw_solid *solid, double *x, double *y)
{
    sum_all(solid, (fw_sum_arrays){.return_x = x, .return_y = y});
}

void fw_particles_bond_return_forces(const fw_solid *solid, double *lengths)
{
    sum_all(solid, (fw_sum_arrays){.bond_length = lengths});
}

void fw_particles_stiffness(const fw_particles *particles, double *stiffness)
{
    sum_all(&particles->langevin.head, (fw_sum_arrays){.stiffness = stiffness});
}

const double *fw_particles_own_energies(const fw_particles *particles)
{
    fw_particle_energies *energies = particles->energies;
    if (!energies->known)
        sum_all(&particles->langevin.head, (fw_sum_arrays){.energy = energies->values});
    energies->known = true;
    return energies->values;
}

void fw_particles_pair_energies(const fw_solid *solid, double *energies)
{
    memcpy(energies, fw_particles_own_energies((const fw_particles *)solid),
           (size_t)solid->count * sizeof *energies);
}

fw_tensor fw_particles_virial(const fw_solid *solid, int group)
{
    const fw_particles *particles = (const fw_particles *)solid;
    const int first = group < 0 ? 0 : particles->groups[group].first;
    const int count = group < 0 ? solid->count : particles->groups[group].count;
    double *const *v = particles->virial;
    const fw_sum_arrays out = {.virial = {v[0], v[1], v[2], v[3]}};
    sum_bodies(particles, group < 0 ? 0 : group, group < 0 ? particles->group_count : group + 1,
               &out);
    const size_t size = (size_t)count;
    return (fw_tensor){fw_array_sum(v[0] + first, size), fw_array_sum(v[1] + first, size),
                       fw_array_sum(v[2] + first, size), fw_array_sum(v[3] + first, size)};
}

/* Are there particles of other bodies near to those eight? */
static bool touches(const fw_chunk *chunk, int block)
{
    const fw_slot_head *head = &chunk->near.head[block];
    return head->count[0] > 0 || head->count[FW_RUN_OWN + 1] > 0;
}

/* On one particle. */
static fw_vec2 force_across(const fw_particles *particles, int i, int by_group)
{
    const fw_solid *head = &particles->langevin.head;
    fw_vec2 sum = {0, 0};
    fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
    for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
        if (particles->group_of[j] != by_group) continue;
        const double dx = head->x[i] - head->x[j], dy = head->y[i] - head->y[j];
        const double push =
            particles->strength_across * fw_pair_at(&particles->potential, dx * dx + dy * dy).push;
        sum = fw_vec2_add(sum, (fw_vec2){push * dx, push * dy});
    }
    return sum;
}

fw_vec2 fw_particles_force_on(const fw_solid *solid, int group, int by_group)
{
    const fw_particles *particles = (const fw_particles *)solid;
    fw_vec2 sum = {0, 0};
    const int end = fw_neighbour_lists_first(particles->lists, group + 1);
    for (int c = fw_neighbour_lists_first(particles->lists, group); c < end; ++c) {
        const fw_chunk *chunk = fw_neighbour_lists_chunk(particles->lists, c);
        for (int k = 0; k < chunk->count; ++k)
            if (touches(chunk, k / FW_LANES))
                sum = fw_vec2_add(
                    sum, force_across(particles,
                                      fw_neighbour_lists_number(particles->lists, chunk->first + k),
                                      by_group));
    }
    return sum;
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
