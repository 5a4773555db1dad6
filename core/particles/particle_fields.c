/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_fields.c - quantities per particle of movable lattice particles, for pictures and files.
 * Keeps no state. */
#include "particle_forces.h"

#include "core/particles/surroundings.h"

#include <math.h>

static const fw_particles *particles_of(const fw_solid *solid)
{
    return (const fw_particles *)solid;
}

static void fill_return_force(const fw_solid *solid, double *values)
{
    double *x = particles_of(solid)->langevin.scratch;
    fw_particles_return_forces(solid, x, values);
    for (int i = 0; i < solid->count; ++i) values[i] = sqrt(x[i] * x[i] + values[i] * values[i]);
}

static void fill_speed(const fw_solid *solid, double *values)
{
    const fw_langevin *langevin = &particles_of(solid)->langevin;
    for (int i = 0; i < solid->count; ++i)
        values[i] = sqrt(langevin->velocity_x[i] * langevin->velocity_x[i] +
                         langevin->velocity_y[i] * langevin->velocity_y[i]);
}

static void fill_kinetic_energy(const fw_solid *solid, double *values)
{
    const fw_langevin *langevin = &particles_of(solid)->langevin;
    fill_speed(solid, values);
    for (int i = 0; i < solid->count; ++i) values[i] *= 0.5 * langevin->mass[i] * values[i];
}

static void fill_local_order(const fw_solid *solid, double *values)
{
    int bonds;
    for (int i = 0; i < solid->count; ++i) {
        const fw_phase order = fw_particles_bond_order(solid, i, &bonds);
        values[i] = sqrt(order.cosine * order.cosine + order.sine * order.sine);
    }
}

static void fill_lab_order(const fw_solid *solid, double *values)
{
    int bonds;
    for (int i = 0; i < solid->count; ++i) {
        const fw_particles *particles = particles_of(solid);
        const fw_phase order = fw_particles_bond_order(solid, i, &bonds);
        const fw_phase axes = particles->groups[particles->group_of[i]].axes;
        values[i] = order.cosine * axes.cosine + order.sine * axes.sine;
    }
}

static void fill_coordination(const fw_solid *solid, double *values)
{
    int bonds;
    for (int i = 0; i < solid->count; ++i) {
        fw_particles_bond_order(solid, i, &bonds);
        values[i] = bonds;
    }
}

/* Order of a symmetry, whatever the body's own; 0 without bonds, NaN without memory. */
static void fill_order(const fw_solid *solid, int fold, double *values)
{
    const double radius = fw_particles_bond_radius(solid);
    const bool found = fw_surroundings_order(solid->x, solid->y, solid->count, radius, &fold, 1,
                                             values, NULL) == FW_OK;
    for (int i = 0; i < solid->count; ++i)
        values[i] = found ? (isfinite(values[i]) ? values[i] : 0) : NAN;
}

static void fill_order_of_four(const fw_solid *solid, double *values)
{
    fill_order(solid, 4, values);
}

static void fill_order_of_six(const fw_solid *solid, double *values)
{
    fill_order(solid, 6, values);
}

static void fill_density(const fw_solid *solid, double *values)
{
    if (fw_surroundings_density(solid->x, solid->y, solid->count, 1, values, NULL) != FW_OK)
        for (int i = 0; i < solid->count; ++i) values[i] = NAN;
}

static void fill_group(const fw_solid *solid, double *values)
{
    for (int i = 0; i < solid->count; ++i) values[i] = particles_of(solid)->group_of[i];
}

static void fill_force(const fw_solid *solid, double *values)
{
    const fw_langevin *langevin = &particles_of(solid)->langevin;
    for (int i = 0; i < solid->count; ++i)
        values[i] = sqrt(langevin->force_x[i] * langevin->force_x[i] +
                         langevin->force_y[i] * langevin->force_y[i]);
}

const fw_field fw_particle_fields[] = {
    {"return-force", "force", "length of the net return force on the particle (Eqs 24, 25)",
     fill_return_force},
    {"bond-force", "force", "length of the net force of all bonds", fill_force},
    {"speed", "length/time", "length of the velocity", fill_speed},
    {"kinetic-energy", "energy", "m v^2/2", fill_kinetic_energy},
    {"potential-energy", "energy", "half of the energy of the particle's bonds",
     fw_particles_pair_energies},
    {"local-order", "1", "|mean of e^{i n phi}| over the particle's bonds, n of its own body",
     fill_local_order},
    {"lab-order", "1", "real part of the mean of e^{i n (phi - axes)} over the particle's bonds",
     fill_lab_order},
    {"coordination", "1", "how many bonds the particle has", fill_coordination},
    {"order-4", "1", "|mean of e^{4 i phi}| over the particle's bonds", fill_order_of_four},
    {"order-6", "1", "|mean of e^{6 i phi}| over the particle's bonds", fill_order_of_six},
    {"gaussian-density", "1", "sum over all particles of exp(-distance^2) (Eq 22, lambda 1)",
     fill_density},
    {"group", "1", "number of the body among those of movable particles", fill_group},
    {NULL, NULL, NULL, NULL},
};
