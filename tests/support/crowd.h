/* SPDX-License-Identifier: GPL-3.0-or-later */
/* crowd.h - bodies of movable particles for tests: places on a lattice, shaken. */
#ifndef FW_CROWD_H
#define FW_CROWD_H

#include "core/lattice.h"
#include "core/noise.h"
#include "core/particles/particles.h"

#include <stdlib.h>

/* Places of a body; to be freed. */
typedef struct fw_crowd {
    int count;
    fw_vec2 *at;
} fw_crowd;

static inline fw_crowd crowd_of(fw_sites sites, fw_lattice lattice, double shake, uint64_t seed)
{
    fw_crowd crowd = {sites.count, malloc((size_t)sites.count * sizeof *crowd.at)};
    for (int i = 0; i < sites.count; ++i) {
        const fw_vec2 moved = fw_noise_uniform(seed, (uint32_t)i, 0, 99);
        crowd.at[i] =
            fw_vec2_add(fw_lattice_position(&lattice, sites.site[i]), fw_vec2_scale(shake, moved));
    }
    fw_sites_clear(&sites);
    return crowd;
}

static inline fw_crowd crowd_disc(double radius, fw_vec2 origin, double angle, double shake,
                                  uint64_t seed)
{
    fw_sites sites;
    assert_int_equal(fw_sites_disc(&sites, FW_HEXAGONAL, radius, NULL), FW_OK);
    return crowd_of(sites, (fw_lattice){FW_HEXAGONAL, 1, angle, origin}, shake, seed);
}

static inline fw_crowd crowd_rectangle(int columns, int rows, fw_vec2 origin, double spacing,
                                       double shake, uint64_t seed)
{
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, columns, rows, NULL), FW_OK);
    return crowd_of(sites, (fw_lattice){FW_HEXAGONAL, spacing, 0, origin}, shake, seed);
}

/* A solid of one body; the crowd is consumed. */
static inline fw_solid *solid_of(fw_crowd crowd, fw_return_force force,
                                 fw_langevin_controls controls, uint64_t seed)
{
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    group.return_force = force;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.controls = controls;
    def.seed = seed;
    fw_solid *solid;
    fw_error error = {0};
    if (fw_particles_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    free(crowd.at);
    return solid;
}

static inline fw_return_force return_force_of(int fold, double amplitude, fw_return_axes axes,
                                              fw_return_variant variant)
{
    fw_return_force force = fw_return_force_default();
    force.fold = fold;
    force.amplitude = amplitude;
    force.axes = axes;
    force.variant = variant;
    return force;
}

static inline double total_energy(const fw_solid *solid)
{
    const fw_energies energies = fw_solid_energies(solid);
    return energies.kinetic + energies.elastic;
}

static inline double angular_momentum(const fw_solid *solid)
{
    const fw_langevin *langevin = (const fw_langevin *)solid;
    double total = 0;
    for (int i = 0; i < solid->count; ++i)
        total += langevin->mass[i] *
                 (solid->x[i] * langevin->velocity_y[i] - solid->y[i] * langevin->velocity_x[i]);
    return total;
}

/* Hash of everything that changes while the solid runs. */
static inline uint64_t fingerprint(fw_solid *solid)
{
    fw_state_list list = {0};
    solid->model->state(solid, &list);
    return fw_state_list_hash(&list);
}

#endif
