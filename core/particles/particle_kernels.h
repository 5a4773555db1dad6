/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_kernels.h - the loops of particle_forces.c and particle_sums.c. */
#ifndef FW_PARTICLE_KERNELS_H
#define FW_PARTICLE_KERNELS_H

#include "core/instruction_set.h"
#include "core/particles/pair_potential.h"
#include "core/particles/return_force.h"
#include "core/particles/slots.h"

/* The potential, as kernels want it. */
typedef struct fw_pair_rule {
    fw_pair_kind kind;
    /* Of forces in the particle's own body and between bodies: 12 depth d^12 for Lennard-Jones,
     * 2 steepness depth for Morse; and of energies in that unit, 1/12 and 1/2a. */
    double inside, across, energy;
    double fade;                /* of S', 30/(b - a), in that unit */
    double q;                   /* d^-6 */
    double distance, steepness; /* of Morse */
    fw_smooth_cut cut;
    double inner_2, outer_2; /* fading where inner_2 < r^2 < outer_2, nothing from there on */
} fw_pair_rule;

/* The return force inside a body. */
typedef struct fw_return_rule {
    int fold;
    double amplitude, distance, depth; /* depth: f0 r0/n */
    bool constant;
    fw_return_axes turning;
    fw_phase axes;
    fw_turn turn; /* only for what is measured */
    fw_smooth_cut cut;
    double inner_2, outer_2;
} fw_return_rule;

typedef struct fw_pair_task {
    const double *x, *y;
    fw_pair_rule pair;
    fw_return_rule bond;
    double bond_2; /* square of the bond radius */
} fw_pair_task;

/* Entries of the particles of the chunk are written; NULL: not wanted. */
typedef struct fw_force_arrays {
    double *force_x, *force_y;
    /* For axes that turn: the parts of the return force, and what the turn is made of. Else they
     * are not written. */
    double *first_x, *first_y, *second_x, *second_y, *sum_cosine, *sum_sine;
} fw_force_arrays;

/* What else is summed over the pairs of each particle; NULL: not wanted. */
typedef struct fw_sum_arrays {
    double *energy;              /* half of the energy of its pairs */
    double *return_x, *return_y; /* net return force */
    double *bond_length;         /* mean length of the return forces of its bonds; NaN: no bonds */
    double *stiffness;           /* see fw_particles_start_limit() */
    double *virial[4];           /* xx, xy, yx, yy of (r_i - r_j) (x) F_ij/2 */
} fw_sum_arrays;

struct fw_move_task;

typedef struct fw_particle_kernels {
    /* Sums over the near slots of a chunk. Return forces of fixed axes are part of the force. The
     * force of each particle kicks it at once (langevin_kernels.h); NULL: not. */
    void (*forces)(const fw_pair_task *task, const fw_chunk *chunk, const fw_force_arrays *out,
                   const struct fw_move_task *kick);
} fw_particle_kernels;

FW_KERNELS(fw_particle_kernels, fw_particles_kernels);

typedef struct fw_sum_kernels {
    void (*sums)(const fw_pair_task *task, const fw_chunk *chunk, const fw_sum_arrays *out);
} fw_sum_kernels;

FW_KERNELS(fw_sum_kernels, fw_particle_sums);

#endif
