/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_solid.h - the lattice Boltzmann (LB) solid of Chopard & Marconi (2002).
 *
 * Particles on a square lattice of any shape exchange fields f_i along their links; i = 0 is a rest
 * field with mass M0. With the damping factor mu on Psi and F alike and F/2 throughout (corrected
 * Eqs 18-20),
 *
 *     w      = mu M^-1 (Psi + F/2)           displacement of a particle in one step
 *     f_i   -> w - f_{i+2}                   sent along every existing link
 *     f_0   -> M0 w - f_0
 *     r     -> r + w
 *     Psi    = M0 f_0 + sum kappa f_i,   M = (M0^2 + sum kappa)/2
 *
 * where kappa (`stiffness`) is 1 in the paper. Momentum sum Psi and energy sum f^2 are conserved at
 * mu = 1. Each component is a scalar wave: Poisson ratio 0, and the body cannot rotate.
 * Units: one step of time, spacings of the caller's choice, link stiffness 1 = force per length.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_LB_SOLID_H
#define FW_LB_SOLID_H

#include "core/lattice.h"
#include "core/public.h"
#include "core/solid.h"

FW_PUBLIC_BEGIN

/* Below so many spacings per step particles keep their order when a body hits something: measured
 * with sheets at mu = 1. Above it cells turn inside out; nothing else goes wrong. */
#define FW_LB_FASTEST 0.3

/* M, and each kappa, may have this condition number (fw_sym2_condition). Rounding makes an error of
 * condition * eps in w = M^-1 (Psi + F/2), and the refinement of a step leaves the square of that:
 * below eps, and so lost in the rounding of the fields, up to eps^-1/2. Beyond it the body loses
 * energy in every step: of all it has 1e-12 at 2e10, 6e-9 at 2e12, 2e-6 at 2e13 (measured). */
#define FW_LB_CONDITION_MAX 6.7e7

extern const fw_solid_model fw_lb_solid_model; /* name "lattice-boltzmann" */

/* How the state is kept. Both are the same solid up to rounding: 1e-14 of the displacements in 200
 * steps. Every shape, load, mass and constraint is possible in both, but weighted and breaking
 * links, shapes of which most of the rows is empty, and particles that are carried only as
 * populations. */
typedef enum fw_lb_form {
    FW_LB_POPULATIONS,  /* the fields themselves */
    FW_LB_DISPLACEMENTS /* where possible by displacements: several times as fast */
} fw_lb_form;

/* Plain data; start from fw_lb_solid_def_default(). Arrays are per site, in the order of `sites`,
 * and are only read during creation. */
typedef struct fw_lb_solid_def {
    const fw_sites *sites;
    fw_lattice lattice;             /* kind must be FW_SQUARE */
    double mu;                      /* damping factor, 1/2 < mu <= 1; at 1 nothing is lost */
    fw_sym2 rest_mass;              /* M0 of every particle, symmetric */
    const fw_sym2 *rest_masses;     /* M0 per site instead, or NULL */
    fw_sym2 stiffness;              /* kappa of every link, positive definite */
    const fw_sym2 *stiffness_east;  /* kappa of the link east of each site instead, or NULL */
    const fw_sym2 *stiffness_north; /* the same for the link north of it */
    fw_lb_form form;
    double break_at;             /* a link longer or shorter than this by |d| breaks; INFINITY */
    const fw_vec2 *displacement; /* u at the start, or NULL for rest */
    fw_vec2 drift;               /* V of all sites at the start, length per step */
    const fw_vec2 *velocity;     /* V per site instead, or NULL */
} fw_lb_solid_def;

/* mu = 1, M0 = 0, kappa = 1, unbreakable, at rest, as populations. */
fw_lb_solid_def fw_lb_solid_def_default(void);

/* FW_BAD_INPUT for mu outside (1/2, 1], a lattice that is not square, a particle without links
 * and rest mass (M would be singular), a stiffness that is not positive, M closer to singular than
 * FW_LB_CONDITION_MAX, numbers not finite. */
fw_status fw_lb_solid_create(fw_solid **solid, const fw_lb_solid_def *def, fw_error *error);

/* Everything below takes a solid whose model is fw_lb_solid_model. */

/* Psi of a particle: its momentum. */
fw_vec2 fw_lb_solid_psi(const fw_solid *solid, int particle);
fw_sym2 fw_lb_solid_mass(const fw_solid *solid, int particle);

/* The neighbour over an existing link, or -1. */
int fw_lb_solid_neighbour(const fw_solid *solid, int particle, int direction);

/* Eq 31: r_m - r_l - Delta0 over the link in that direction; zero where there is none. */
fw_vec2 fw_lb_solid_deformation(const fw_solid *solid, int particle, int direction);

/* Energy of a particle, sum of its f^2 (Eq 11, weighted with kappa). */
double fw_lb_solid_energy(const fw_solid *solid, int particle);

/* Largest violation of the invariant Eq 30, r_m - r_l + f_i(m) - f_{i+2}(l) = Delta0. */
double fw_lb_solid_link_error(const fw_solid *solid);

/* Largest of |Psi + F/2|, |f_0| and |f_i(l+c_i) + f_{i+2}(l)|: zero at rest (Eqs 22-24). */
double fw_lb_solid_rest_residual(const fw_solid *solid);

/* Turns the arrow of time: the body runs back the way it came (exactly so at mu = 1). */
void fw_lb_solid_reverse(fw_solid *solid);

/* The form that was chosen. */
fw_lb_form fw_lb_solid_form(const fw_solid *solid);

/* Links broken since creation. */
int fw_lb_solid_broken(const fw_solid *solid);

FW_PUBLIC_END

#endif
