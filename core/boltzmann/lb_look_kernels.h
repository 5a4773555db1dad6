/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_look_kernels.h - what is read out of the displacements of a row: energies, momentum, positions
 * and velocities. Nothing of the body changes. */
#ifndef FW_LB_LOOK_KERNELS_H
#define FW_LB_LOOK_KERNELS_H

#include "lb_grid.h"

enum { LB_TERMS_MAX = 528 /* places whose terms have room together */ };

/* Of places one after the other: what their links to the east and north add to the energies, and
 * sum f (Eq 2), without rest fields. */
typedef struct lb_field_terms {
    double elastic[2][LB_TERMS_MAX], kinetic[2][LB_TERMS_MAX];
    double psi_x[LB_TERMS_MAX], psi_y[LB_TERMS_MAX];
} lb_field_terms;

/* By particle: sites, and masses that are multiples of one. */
typedef struct lb_particle_arrays {
    const double *site_x, *site_y; /* r = site + (common + u) */
    const double *mass, *inverse;  /* M, M^-1; NULL: by counting links */
    bool plain;                    /* particles with four links all have these: */
    double plain_mass, plain_inverse;
    fw_vec2 common;
} lb_particle_arrays;

typedef struct lb_look_kernels {
    /* Of at least `count` places from one on that is a multiple of LB_BLOCK, in a row whose
     * neighbours to the north and south lie at those distances. */
    void (*terms)(const lb_grid_arrays *arrays, int place, int count, int north, int south,
                  lb_field_terms *terms);
    /* Positions and velocities M^-1 sum f of a stretch, from its first particle on. */
    void (*motions)(const lb_grid_arrays *arrays, const lb_particle_arrays *particles,
                    lb_stretch stretch, int north, int south, const fw_motions *out);
    /* Positions alone. */
    void (*positions)(const lb_grid_arrays *arrays, const lb_particle_arrays *particles,
                      lb_stretch stretch, double *x, double *y);
    /* M (r - base) of masses that are multiples of one. */
    void (*moments)(const lb_grid_arrays *arrays, const lb_particle_arrays *particles,
                    lb_stretch stretch, fw_vec2 base, double *x, double *y);
    /* Is every displacement in places begin .. end, multiples of LB_BLOCK, a number of less than
     * that size? */
    bool (*within)(const lb_grid_arrays *arrays, int begin, int end, double size);
} lb_look_kernels;

FW_KERNELS(lb_look_kernels, lb_looks);

#endif
