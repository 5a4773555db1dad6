/* SPDX-License-Identifier: GPL-3.0-or-later */
/* linear_lattice.h - the linear lattice of Popov & Filippov Eqs 1-12: particles on a hexagonal
 * lattice, tied for ever to their neighbours by
 *     F_i = k1 (u_j - u_i) + k2 e (e . (u_j - u_i))                                          (Eq 2)
 * with the bond's direction e in the undeformed lattice. With spacing c and mass m
 *     c_L^2 = 3/2 c^2 (k1 + 3/4 k2)/m,   c_T^2 = 3/2 c^2 (k1 + 1/4 k2)/m
 *     mu = sqrt3 (k1 + k2/4),   lambda + mu = (sqrt3/2) k2,
 * twice the printed Eq 12, since the area per particle is (sqrt3/2) c^2.
 *
 * k1 ties bonds to the outside space. Inside a body that is no matter, but at its edge it hinders
 * turning, and a specimen with free sides contracts like k2/(3 k2 + 4 k1) instead of Lame's
 * (k2 - 4 k1)/(3 k2 + 4 k1). The compensating surface forces mend this. On a straight side they are
 *     F_p = -(sqrt3/2) k1 z x (u_next - u_prev)         (walking counter-clockwise round the body);
 * at corners it takes, beyond that, bonds on the edge with half their k1: every triangle of the
 * lattice then carries half of its bonds and turns freely by itself, and a bond that belongs to no
 * triangle has no k1. So done here: a body of any shape feels no force from any small rotation.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_LINEAR_LATTICE_H
#define FW_LINEAR_LATTICE_H

#include "core/lattice.h"
#include "core/particles/langevin.h"
#include "core/public.h"

FW_PUBLIC_BEGIN

typedef struct fw_linear_lattice_def {
    fw_lattice lattice;           /* hexagonal */
    const fw_sites *sites;        /* read during creation only, as are the arrays */
    const fw_vec2 *displacements; /* NULL: none */
    const fw_vec2 *velocities;    /* NULL: at rest */
    double mass;                  /* of each particle, > 0 */
    double k1, k2; /* force per length; k1 + 3/4 k2 > 0 and k1 + 1/4 k2 > 0; compensated: k2 >= 0,
                      else k1 >= 0 and k1 + k2 >= 0 */
    bool compensated; /* with surface forces */
    fw_langevin_controls controls;
    uint64_t seed;
} fw_linear_lattice_def;

extern const fw_solid_model fw_linear_lattice_model;

/* Mass 1, k1 = 10, k2 = 50, compensated, time step .005. */
fw_linear_lattice_def fw_linear_lattice_def_default(void);

/* FW_BAD_INPUT with a sentence for: a square lattice, numbers out of range, an unstable material, a
 * time step beyond 2/omega of the lattice's fastest oscillation. Model "linear-lattice". */
fw_status fw_linear_lattice_create(fw_solid **solid, const fw_linear_lattice_def *def,
                                   fw_error *error);

/* k1 and k2 that give these Lame coefficients. */
void fw_linear_lattice_from_lame(double lambda, double mu, double *k1, double *k2);

/* The longest stable time step of Verlet's scheme, 2/omega of the lattice's fastest oscillation. */
double fw_linear_lattice_time_step_limit(double k1, double k2, double mass);

/* Of an endless lattice: omega^2 u = D(q) u for waves u e^{i q . r}. */
fw_sym2 fw_linear_lattice_dynamical_matrix(const fw_linear_lattice_def *def, fw_vec2 wave_vector);

/* Where a particle lies at rest. */
fw_vec2 fw_linear_lattice_home(const fw_solid *solid, int particle);

FW_PUBLIC_END

#endif
