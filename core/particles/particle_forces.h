/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_forces.h - how the solid of particles.h is built inside, for the files that share it:
 * particles.c (life), particle_checks.c (what is refused), particle_forces.c (forces),
 * particle_sums.c (other sums over bonds), particle_fields.c (fields). */
#ifndef FW_PARTICLE_FORCES_H
#define FW_PARTICLE_FORCES_H

#include "core/particles/neighbour_lists.h"
#include "core/particles/particles.h"

#include "particle_kernels.h"

enum { FW_SUMS_MAX = 9 }; /* arrays that a kernel fills at most */

/* Half of the energy of each particle's pairs, made when somebody asks. */
typedef struct fw_particle_energies {
    bool known; /* for the present positions */
    double *values;
} fw_particle_energies;

struct fw_particles {
    fw_langevin langevin; /* first: an fw_particles is an fw_langevin is an fw_solid */
    int group_count;
    fw_particle_group *groups; /* names owned */
    double *amplitudes;        /* f0 of each group; part of the state, copied into the groups */
    int *group_of;
    fw_pair_potential potential;
    double strength_across;
    double bond_radius;

    fw_neighbour_lists *lists;
    /* Results in the lists' order, for bodies that have lost theirs; NULL until there is one. */
    double *in_lists_order[FW_SUMS_MAX];

    /* Return forces of bodies whose axes turn, before the turn is known; NULL if there are none. */
    double *first_x, *first_y, *second_x, *second_y, *sum_cosine, *sum_sine;
    double *virial[4]; /* of each particle: scratch */
    fw_particle_energies *energies;
    int (*other_links)[2]; /* scratch */
};

/* What the kernels are told about the particles of a body. */
fw_pair_task fw_particles_task(const fw_particles *particles, int group);

/* Where a kernel is to write the particles of that body instead of arrays[0] to arrays[count - 1],
 * of which NULL stays NULL: there, or in the lists' order, to be brought back afterwards. */
void fw_particles_divert(const fw_particles *particles, int group, int count, double *const *arrays,
                         double **diverted);
void fw_particles_bring_back(const fw_particles *particles, int group, int count,
                             double *const *diverted, double *const *arrays);

/* Half of the energy of each particle's pairs; valid until the next step. */
const double *fw_particles_own_energies(const fw_particles *particles);

/* What each particle feels of its neighbours, each fixed: the larger eigenvalue of the sum of the
 * positive parts of the second derivatives. */
void fw_particles_stiffness(const fw_particles *particles, double *stiffness);

/* As fw_langevin.find_forces. */
fw_status fw_particles_find_forces(fw_langevin *solid, double travel,
                                   const struct fw_move_task *kick, fw_error *error);

/* Whatever fw_particles_create refuses before it builds. */
fw_status fw_particles_check(const fw_particles_def *def, fw_error *error);
/* The first pair whose energy is above the limit, if there is one; no pair is nearer to each other
 * than `closest`. */
fw_status fw_particles_check_overlaps(const fw_particles *particles, double closest, double limit,
                                      fw_error *error);
fw_status fw_particles_check_time_step(double time_step, double limit, fw_error *error);
/* The time step at the positions of the start, where no pair is nearer than `closest`. */
fw_status fw_particles_check_start(const fw_particles *particles, double closest, fw_error *error);
/* As fw_langevin.hottest. */
double fw_particles_hottest_at(const fw_langevin *solid, double time_step);
/* Stable for bodies of such particles. */
double fw_particles_longest_time_step(const fw_pair_potential *potential, double strength,
                                      const fw_return_force *force, double mass);

/* As fw_solid_model.parts and .list_links: particle_links.c. */
int fw_particles_parts(const fw_solid *solid, int number, fw_part *part);
fw_status fw_particles_list_links(fw_solid *solid, bool *changed, fw_error *error);

extern const fw_field fw_particle_fields[];

#endif
