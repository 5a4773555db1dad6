/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_forces.c - the forces of movable lattice particles (Popov & Filippov Eqs 13, 18): body
 * after body, chunk after chunk; the sums over neighbours are in particle_kernels.c. Start reading
 * at fw_particles_find_forces(). */
#include "particle_forces.h"

#include "core/threads.h"

#include <math.h>

enum { PARALLEL_FROM = 1024 }; /* particles; below it threads cost more than they bring */

/* What is greater, is a^2 or more. */
static double square_below(double a)
{
    return nextafter(a * a, -1);
}

static fw_pair_rule pair_rule(const fw_particles *particles, const fw_particle_group *group)
{
    const fw_pair_potential *potential = &particles->potential;
    const double square = potential->distance * potential->distance;
    const double sixth = square * square * square;
    const bool jones = potential->kind == FW_LENNARD_JONES;
    const double parts = jones ? 12 : 2 * potential->steepness;
    const double unit = parts * potential->depth * (jones ? sixth * sixth : 1);
    return (fw_pair_rule){.kind = potential->kind,
                          .inside = group->strength * unit,
                          .across = particles->strength_across * unit,
                          .energy = 1 / parts,
                          .fade = 30 * potential->cut.scale / parts,
                          .q = 1 / sixth,
                          .distance = potential->distance,
                          .steepness = potential->steepness,
                          .cut = potential->cut,
                          .inner_2 = square_below(potential->cut.inner),
                          .outer_2 = potential->cut.outer * potential->cut.outer};
}

static fw_return_rule return_rule(const fw_particle_group *group)
{
    const fw_return_force *force = &group->return_force;
    return (fw_return_rule){.fold = force->fold,
                            .amplitude = force->amplitude,
                            .distance = force->distance,
                            .depth = force->amplitude * force->distance / force->fold,
                            .constant = force->variant == FW_RETURN_CONSTANT,
                            .turning = force->axes,
                            .axes = group->axes,
                            .turn = group->turn,
                            .cut = force->cut,
                            .inner_2 = square_below(force->cut.inner),
                            .outer_2 = force->cut.outer * force->cut.outer};
}

fw_pair_task fw_particles_task(const fw_particles *particles, int g)
{
    const fw_particle_group *group = &particles->groups[g];
    return (fw_pair_task){fw_neighbour_lists_x(particles->lists),
                          fw_neighbour_lists_y(particles->lists), pair_rule(particles, group),
                          return_rule(group), particles->bond_radius * particles->bond_radius};
}

static bool turns(const fw_particle_group *group)
{
    return group->return_force.axes != FW_AXES_LAB && group->return_force.amplitude > 0;
}

/* --- bodies that have lost their order --- */

static bool begin_order(fw_particles *particles)
{
    const size_t count = (size_t)particles->langevin.head.count;
    bool any = false;
    for (int g = 0; g < particles->group_count; ++g)
        any = any || fw_neighbour_lists_renumbered(particles->lists, g);
    for (int a = 0; a < FW_SUMS_MAX && any; ++a) {
        double **array = &particles->in_lists_order[a];
        if (!*array) *array = fw_array_of_doubles(count);
        if (!*array) return false;
    }
    return true;
}

void fw_particles_divert(const fw_particles *particles, int group, int count, double *const *arrays,
                         double **diverted)
{
    const bool renumbered = fw_neighbour_lists_renumbered(particles->lists, group);
    for (int a = 0; a < count; ++a)
        diverted[a] = renumbered && arrays[a] ? particles->in_lists_order[a] : arrays[a];
}

void fw_particles_bring_back(const fw_particles *particles, int g, int count,
                             double *const *diverted, double *const *arrays)
{
    if (!fw_neighbour_lists_renumbered(particles->lists, g)) return;
    const fw_particle_group *group = &particles->groups[g];
#pragma omp parallel for schedule(static) if (group->count > PARALLEL_FROM)
    for (int k = group->first; k < group->first + group->count; ++k) {
        const int i = fw_neighbour_lists_number(particles->lists, k);
        for (int a = 0; a < count; ++a)
            if (arrays[a]) arrays[a][i] = diverted[a][k];
    }
}

/* --- forces --- */

static void find_all(fw_particles *particles, int g, const struct fw_move_task *kick)
{
    const fw_pair_task task = fw_particles_task(particles, g);
    double *const arrays[] = {particles->langevin.force_x, particles->langevin.force_y,
                              particles->first_x,          particles->first_y,
                              particles->second_x,         particles->second_y,
                              particles->sum_cosine,       particles->sum_sine};
    double *to[FW_SUMS_MAX];
    const int used = turns(&particles->groups[g]) ? (int)(sizeof arrays / sizeof *arrays) : 2;
    fw_particles_divert(particles, g, used, arrays, to);
    fw_force_arrays out = {.force_x = to[0], .force_y = to[1]};
    if (used > 2) out = (fw_force_arrays){to[0], to[1], to[2], to[3], to[4], to[5], to[6], to[7]};
    const fw_particle_kernels *kernels = FW_KERNELS_CHOSEN(fw_particles_kernels);
    const int end = fw_neighbour_lists_first(particles->lists, g + 1);
    FW_SHARED_LOOP(
        particles->groups[g].count > PARALLEL_FROM,
        for (int c = fw_neighbour_lists_first(particles->lists, g); c < end; ++c)
            kernels->forces(&task, fw_neighbour_lists_chunk(particles->lists, c), &out, kick););
    fw_particles_bring_back(particles, g, used, to, arrays);
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

fw_status fw_particles_find_forces(fw_langevin *solid, double travel,
                                   const struct fw_move_task *kick, fw_error *error)
{
    fw_particles *particles = (fw_particles *)solid;
    particles->energies->known = false;
    FW_TRY(
        fw_neighbour_lists_refresh(particles->lists, solid->head.x, solid->head.y, travel, error));
    if (!begin_order(particles)) return fw_fail_memory(error, "forces");
    for (int g = 0; g < particles->group_count; ++g) {
        fw_particle_group *group = &particles->groups[g];
        const bool turning = turns(group);
        /* A force that is whole where it is made kicks at once. */
        const bool whole = !turning && !fw_neighbour_lists_renumbered(particles->lists, g);
        find_all(particles, g, whole ? kick : NULL);
        if (turning) turn_together(particles, group);
        if (!whole) fw_langevin_kick(kick, group->first, group->count);
    }
    return FW_OK;
}
