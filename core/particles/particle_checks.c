/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_checks.c - which solids of movable lattice particles are refused, and with what
 * sentence. Keeps no state. Start reading at fw_particles_check(). */
#include "linear_lattice.h"
#include "particle_forces.h"

#include <math.h>
#include <string.h>

static fw_status check_group(const fw_particle_group_def *group, fw_error *error)
{
    if (group->count < 1)
        return fw_fail(error, FW_BAD_INPUT, "it has %d particles, expected at least one",
                       group->count);
    if (!(group->mass > 0 && isfinite(group->mass)))
        return fw_fail(error, FW_BAD_INPUT, "its particles have mass %g, expected a number > 0",
                       group->mass);
    if (!(group->strength >= 0 && isfinite(group->strength)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the potential has strength %g in it, expected a number >= 0",
                       group->strength);
    for (int i = 0; i < group->count; ++i) {
        const fw_vec2 at = group->positions[i];
        if (!isfinite(at.x) || !isfinite(at.y))
            return fw_fail(error, FW_BAD_INPUT,
                           "particle %d lies at [%g, %g], expected finite numbers", i, at.x, at.y);
        if (!group->velocities) continue;
        const fw_vec2 velocity = group->velocities[i];
        if (!isfinite(velocity.x) || !isfinite(velocity.y))
            return fw_fail(error, FW_BAD_INPUT,
                           "particle %d has velocity [%g, %g], expected finite numbers", i,
                           velocity.x, velocity.y);
    }
    return fw_return_force_check(&group->return_force, error);
}

static fw_status check_groups(const fw_particles_def *def, fw_error *error)
{
    if (def->group_count < 1)
        return fw_fail(error, FW_BAD_INPUT, "there are no bodies of movable particles");
    int64_t count = 0;
    for (int g = 0; g < def->group_count; ++g) {
        const fw_particle_group_def *group = &def->groups[g];
        const fw_status status = check_group(group, error);
        if (status != FW_OK) {
            fw_fail_within(error, "body '%s'", group->name);
            return status;
        }
        for (int h = 0; h < g; ++h)
            if (strcmp(def->groups[h].name, group->name) == 0)
                return fw_fail(error, FW_BAD_INPUT, "two bodies are called '%s'", group->name);
        count += group->count;
    }
    if (count > INT32_MAX / 2)
        return fw_fail(error, FW_BAD_INPUT, "%lld particles, expected at most %d", (long long)count,
                       INT32_MAX / 2);
    return FW_OK;
}

/* 2/omega for the highest frequency of a hexagonal crystal of such bonds: that of the linear
 * lattice (Popov & Filippov Eq 2) with k1 = n f0/r0 and k2 = U'' - k1. */
double fw_particles_longest_time_step(const fw_pair_potential *potential, double strength,
                                      const fw_return_force *force, double mass)
{
    const double radial = strength * fw_pair_potential_stiffness(potential);
    const double transverse = force->fold * force->amplitude / force->distance;
    return fw_linear_lattice_time_step_limit(transverse, radial - transverse, mass);
}

double fw_particles_time_step_limit(const fw_particles_def *def)
{
    double limit = INFINITY;
    for (int g = 0; g < def->group_count; ++g) {
        const fw_particle_group_def *group = &def->groups[g];
        const double strength =
            def->group_count > 1 ? fmax(group->strength, def->strength_across) : group->strength;
        limit = fmin(limit, fw_particles_longest_time_step(&def->potential, strength,
                                                           &group->return_force, group->mass));
    }
    return limit;
}

fw_status fw_particles_check_time_step(double time_step, double limit, fw_error *error)
{
    if (time_step < limit) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "the time step is %g, expected less than %.4g: beyond it the stiffest bond's "
                   "oscillation grows",
                   time_step, limit);
}

fw_status fw_particles_check(const fw_particles_def *def, fw_error *error)
{
    FW_TRY(check_groups(def, error));
    FW_TRY(fw_pair_potential_check(&def->potential, error));
    FW_TRY(fw_langevin_check(&def->controls, error));
    if (!(def->strength_across >= 0 && isfinite(def->strength_across)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the potential has strength %g between bodies, expected a number >= 0",
                       def->strength_across);
    if (!(def->bond_radius > 0 && isfinite(def->bond_radius)))
        return fw_fail(error, FW_BAD_INPUT, "bonds reach up to %g, expected a number > 0",
                       def->bond_radius);
    if (!(def->margin >= 0 && isfinite(def->margin)))
        return fw_fail(error, FW_BAD_INPUT,
                       "the neighbour lists reach %g further than the forces, expected a number "
                       ">= 0",
                       def->margin);
    if (!(def->overlap_energy >= 0))
        return fw_fail(error, FW_BAD_INPUT, "the overlap energy is %g, expected a number >= 0",
                       def->overlap_energy);
    return fw_particles_check_time_step(def->controls.time_step, fw_particles_time_step_limit(def),
                                        error);
}

/* --- the start --- */

static double strength_of(const fw_particles *particles, int i, int j)
{
    const int g = particles->group_of[i];
    return g == particles->group_of[j] ? particles->groups[g].strength : particles->strength_across;
}

double fw_particles_start_limit(const fw_solid *solid, int *particle)
{
    const fw_particles *particles = (const fw_particles *)solid;
    double highest = 0;
    fw_particles_stiffness(particles, particles->langevin.scratch);
    for (int i = 0; i < solid->count; ++i) {
        const double square =
            2 * particles->langevin.scratch[i] * particles->langevin.inverse_mass[i];
        if (!(square > highest)) continue;
        highest = square;
        if (particle) *particle = i;
    }
    return 2 / sqrt(highest);
}

/* A time step that the start allows for sure: as if each particle had as many neighbours as find
 * room (circles as wide as the closest pair is apart), each as stiff as may be. */
static double sure_limit(const fw_particles *particles, double closest)
{
    const fw_pair_potential *potential = &particles->potential;
    const double across = 2 * potential->cut.outer / closest + 1;
    const double stiffest = fw_pair_potential_stiffest(potential, closest);
    double limit = INFINITY;
    for (int g = 0; g < particles->group_count; ++g) {
        const fw_particle_group *group = &particles->groups[g];
        const double strength = fmax(group->strength, particles->strength_across);
        const double mass = particles->langevin.mass[group->first];
        limit = fmin(limit, sqrt(2 * mass / (across * across * strength * stiffest)));
    }
    return limit;
}

fw_status fw_particles_check_start(const fw_particles *particles, double closest, fw_error *error)
{
    int i = 0;
    const double time_step = particles->langevin.controls.time_step;
    if (time_step < sure_limit(particles, closest)) return FW_OK;
    const double limit = fw_particles_start_limit(&particles->langevin.head, &i);
    /* A crystal at rest has the limit of its bonds, up to rounding. */
    if (time_step < limit * (1 + 1e-9)) return FW_OK;
    const fw_particle_group *group = &particles->groups[particles->group_of[i]];
    return fw_fail(error, FW_BAD_INPUT,
                   "the time step is %g, expected less than %.4g: particle %d of body '%s' starts "
                   "so near to its neighbours that a longer step throws it out",
                   time_step, limit, i - group->first, group->name);
}

double fw_particles_hottest_at(const fw_langevin *solid, double time_step)
{
    const fw_particles *particles = (const fw_particles *)solid;
    double hottest = INFINITY;
    for (int g = 0; g < particles->group_count; ++g) {
        const fw_particle_group *group = &particles->groups[g];
        hottest = fmin(hottest,
                       fw_pair_potential_hottest(&particles->potential,
                                                 fmax(group->strength, particles->strength_across),
                                                 solid->mass[group->first], time_step));
    }
    return hottest;
}

double fw_particles_hottest(const fw_solid *solid)
{
    const fw_langevin *langevin = (const fw_langevin *)solid;
    return fw_particles_hottest_at(langevin, langevin->controls.time_step);
}

/* Pairs further from each other than this, squared, have no energy above the limit: it falls with
 * the distance up to the minimum, and is below 0 beyond. */
static double square_of_overlaps(const fw_particles *particles, double limit)
{
    enum { HALVINGS = 60 };
    const fw_pair_potential *potential = &particles->potential;
    double strength = particles->strength_across;
    for (int g = 0; g < particles->group_count; ++g)
        strength = fmax(strength, particles->groups[g].strength);
    double near = 1e-3 * potential->distance, far = potential->distance;
    if (!(strength * fw_pair_at(potential, near * near).energy > limit)) return near * near;
    for (int n = 0; n < HALVINGS; ++n) {
        const double middle = 0.5 * (near + far);
        *(strength * fw_pair_at(potential, middle * middle).energy > limit ? &near : &far) = middle;
    }
    /* A hair more, for the rounding of energies and distances. */
    return far * far * (1 + 1e-9);
}

/* The first pair whose energy is above the limit, if there is one. */
fw_status fw_particles_check_overlaps(const fw_particles *particles, double closest, double limit,
                                      fw_error *error)
{
    const fw_solid *head = &particles->langevin.head;
    const double minimum = particles->potential.distance * particles->potential.distance;
    if (closest * closest > square_of_overlaps(particles, limit)) return FW_OK;
    for (int i = 0; i < head->count; ++i) {
        fw_neighbour_walk walk = fw_neighbours_around(particles->lists, i);
        for (int j; (j = fw_neighbour_next(&walk)) >= 0;) {
            const double dx = head->x[i] - head->x[j], dy = head->y[i] - head->y[j];
            const double r2 = dx * dx + dy * dy;
            if (j < i || r2 > minimum) continue; /* U <= 0 from the minimum on */
            const fw_particle_group *a = &particles->groups[particles->group_of[i]];
            const fw_particle_group *b = &particles->groups[particles->group_of[j]];
            const double strength = strength_of(particles, i, j);
            if (!(strength * particles->potential.depth > 0)) continue;
            const double energy = strength * fw_pair_at(&particles->potential, r2).energy;
            if (energy <= limit) continue;
            return fw_fail(error, FW_BAD_INPUT,
                           "particle %d of body '%s' and particle %d of body '%s' overlap: at "
                           "distance %.4g their energy is %.4g, expected at most %g",
                           i - a->first, a->name, j - b->first, b->name, sqrt(r2), energy, limit);
        }
    }
    return FW_OK;
}
