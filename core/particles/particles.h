/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particles.h - movable lattice particles (Popov & Filippov 2006): a solid that can flow.
 *
 * Particles attract and repel by a pair potential, and within a body bonds are turned towards the
 * body's axes by return forces. One fw_solid ("movable-particles") holds all such bodies of a
 * scene, as groups: the potential acts across bodies too, with a strength of its own, the return
 * force only inside a body. Particles are numbered through, group after group.
 *
 * Forces are made once per step, for each particle from its neighbours in ascending order: the same
 * bytes for any number of threads, whenever neighbour lists were made, and after a restore.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_PARTICLES_H
#define FW_PARTICLES_H

#include "core/particles/langevin.h"
#include "core/particles/pair_potential.h"
#include "core/particles/return_force.h"
#include "core/public.h"

FW_PUBLIC_BEGIN

/* One body. Positions and velocities are copied. */
typedef struct fw_particle_group_def {
    const char *name; /* unique; copied */
    int count;        /* >= 1 */
    const fw_vec2 *positions;
    const fw_vec2 *velocities; /* NULL: at rest */
    double mass;               /* of each particle, > 0 */
    double strength;           /* of the potential inside the body, >= 0 */
    fw_return_force return_force;
} fw_particle_group_def;

typedef struct fw_particles_def {
    const fw_particle_group_def *groups;
    int group_count; /* >= 1 */
    fw_pair_potential potential;
    double strength_across; /* of the potential between particles of different bodies, >= 0 */
    fw_langevin_controls controls;
    uint64_t seed;
    double overlap_energy; /* a pair whose energy is above that at the start is refused */
    double bond_radius;    /* what counts as a bond for order and coordination */
    double margin;         /* of the neighbour lists; results do not depend on it */
} fw_particles_def;

extern const fw_solid_model fw_particles_model;

/* Mass 1, strength 1, no return force. */
fw_particle_group_def fw_particle_group_def_default(void);
/* Default potential, strength across 1, time step .005, no damping, temperature 0, overlap energy
 * 100, bonds up to 1.25, margin .75. */
fw_particles_def fw_particles_def_default(void);

/* FW_BAD_INPUT with a sentence for whatever the parts refuse (pair_potential.h, return_force.h,
 * langevin.h), and for: no particles, names used twice, positions or velocities that are not
 * finite, masses or strengths out of range, pairs above the overlap energy, a time step beyond the
 * stiffest bond's limit or beyond that of the start, a bath too hot for the time step. */
fw_status fw_particles_create(fw_solid **solid, const fw_particles_def *def, fw_error *error);

/* The longest stable time step of Verlet's scheme, 2/omega of a hexagonal crystal's fastest
 * oscillation, all bonds as stiff as at their rest length. */
double fw_particles_time_step_limit(const fw_particles_def *def);

/* The same of a solid as it lies now: 2/omega of what its pairs, with the curvature that each has
 * at its own distance, may do at most. An overlap can be far stiffer than a bond at rest. (With
 * K_ij the positive parts of the pairs' second derivatives, omega^2 <= 2 max_i lambda(sum_j
 * K_ij)/m_i, which for a crystal at rest is exact.) INFINITY without pairs. *particle, unless NULL:
 * the stiffest. */
double fw_particles_start_limit(const fw_solid *solid, int *particle);
/* The hottest bath that the time step follows: the least of fw_pair_potential_hottest. */
double fw_particles_hottest(const fw_solid *solid);

typedef struct fw_particles fw_particles;
typedef struct fw_neighbour_lists fw_neighbour_lists; /* neighbour_lists.h */
bool fw_solid_is_particles(const fw_solid *solid);

/* --- what may change between steps --- */

/* FW_BAD_INPUT as fw_particles_create; on failure nothing is altered. */
fw_status fw_particles_set_controls(fw_solid *solid, const fw_langevin_controls *controls,
                                    fw_error *error);
fw_status fw_particles_set_damping(fw_solid *solid, double damping, fw_error *error);
fw_status fw_particles_set_temperature(fw_solid *solid, double temperature, fw_error *error);
/* f0 of one body. */
fw_status fw_particles_set_amplitude(fw_solid *solid, int group, double amplitude, fw_error *error);
/* Maxwell's distribution at that temperature for a body, or for all with group < 0; total momentum
 * zero. */
void fw_particles_draw_velocities(fw_solid *solid, int group, double temperature);

/* --- what can be read --- */

typedef struct fw_particle_group {
    const char *name;
    int first, count; /* particles first .. first + count - 1 */
    double strength;
    fw_return_force return_force;
    fw_phase axes; /* e^{i n angle}; (1, 0) for corotating axes */
    fw_turn turn;  /* of the present positions; corotating: e^{i n theta} */
} fw_particle_group;

int fw_particles_group_count(const fw_solid *solid);
const fw_particle_group *fw_particles_group(const fw_solid *solid, int group);
/* Index of the group of that name, or -1. */
int fw_particles_find_group(const fw_solid *solid, const char *name);
/* Index of the group that the particle belongs to. */
int fw_particles_group_of(const fw_solid *solid, int particle);
/* Neighbours within at least the reach of all forces and the bond radius, for the present
 * positions; valid until the next step. */
const fw_neighbour_lists *fw_particles_neighbours(const fw_solid *solid);
const fw_langevin_controls *fw_particles_controls(const fw_solid *solid);
double fw_particles_bond_radius(const fw_solid *solid);

/* Sums over the bonds of each particle; every array has one entry per particle. */
/* Net return force on each particle: the vector whose length Eq 24 averages. */
void fw_particles_return_forces(const fw_solid *solid, double *x, double *y);
/* Mean length of the return forces of a particle's single bonds, those closer than the bond radius
 * in its own body; NaN for a particle without any. */
void fw_particles_bond_return_forces(const fw_solid *solid, double *lengths);
/* Sum of the pair forces that the particles of one body exert on those of another. */
fw_vec2 fw_particles_force_on(const fw_solid *solid, int group, int by_group);
/* Half of the energy of each particle's pairs (potential and conservative return force). */
void fw_particles_pair_energies(const fw_solid *solid, double *energies);

/* psi_n: the mean of e^{i n phi} over the particle's bonds (0 without any), with n of its own body;
 * *bonds: how many it has. Bonds are all pairs closer than the bond radius, across bodies too. */
fw_phase fw_particles_bond_order(const fw_solid *solid, int particle, int *bonds);

/* The virial part of the pressure, sum over pairs of (r_i - r_j) (x) F_ij, not divided by the area.
 * Not symmetric where return forces exert a torque. group < 0: all particles; otherwise half of
 * each pair belongs to either particle's body. */
typedef struct fw_tensor {
    double xx, xy, yx, yy;
} fw_tensor;
fw_tensor fw_particles_virial(const fw_solid *solid, int group);

FW_PUBLIC_END

#endif
