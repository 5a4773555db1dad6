/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_matrices.h - the coefficient matrices of the elastic automaton (Dong et al.).
 *
 * A black cell is coupled to its neighbour in direction i by B_i, a white one by D_i = B_(i+2):
 * both ends of a bond have the same matrix, so four matrices say everything.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_AUTOMATON_MATRICES_H
#define FW_AUTOMATON_MATRICES_H

#include "core/lattice.h"
#include "core/public.h"

FW_PUBLIC_BEGIN

/* c1 and c2 of the paper, in spacings per unit of time (one black and one white half-step):
 * transverse waves run at c1, longitudinal ones at sqrt(c1^2 + c2^2). */
typedef struct fw_automaton_speeds {
    double transverse; /* c1, c1^2 = shear modulus */
    double coupling; /* c2, c2^2 = lambda + shear modulus; 0: x and y know nothing of each other */
} fw_automaton_speeds;

/* bond[d] belongs to the bond that leads from a black cell in direction d. Their sum is twice the
 * unit matrix without rounding. */
typedef struct fw_automaton_matrices {
    fw_automaton_speeds speeds;
    fw_sym2 bond[FW_DIRECTIONS];
} fw_automaton_matrices;

/* Chopard's automaton (Dong Eq 1): every matrix is 1/2. */
fw_automaton_speeds fw_automaton_chopard(void);

/* For density 1 and Poisson's ratio of the plane, lambda / (lambda + 2 shear): a strip that is
 * pulled gets thinner by `poisson_ratio` times its strain. FW_BAD_INPUT unless shear_modulus > 0
 * and -1 <= poisson_ratio < 1. */
fw_status fw_automaton_speeds_from_moduli(fw_automaton_speeds *speeds, double shear_modulus,
                                          double poisson_ratio, fw_error *error);

/* FW_BAD_INPUT with the reason unless c1, c2 >= 0 and c1^2 + c2^2 <= 2: exactly there the matrices
 * are real and no wave grows. */
fw_status fw_automaton_speeds_check(fw_automaton_speeds speeds, fw_error *error);

/* Eqs 24 and 29-31, for a lattice turned by `angle` (radians): the matrices act on displacements
 * along x and y. Fails as fw_automaton_speeds_check. */
fw_status fw_automaton_matrices_make(fw_automaton_matrices *matrices, fw_automaton_speeds speeds,
                                     double angle, fw_error *error);

/* The smallest eigenvalue of the four: negative where a single bond can have negative energy. */
double fw_automaton_matrices_least(const fw_automaton_matrices *matrices);

FW_PUBLIC_END

#endif
