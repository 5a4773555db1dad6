/* SPDX-License-Identifier: GPL-3.0-or-later */
/* elastic_automaton.h - the elastic automaton (Dong, Zhang, Xu & Gan): black and white cells of the
 * square lattice move in turn, each reflected about the weighted mean of its neighbours.
 *
 * One unit of time is a black and a white half-step; one tick of the solid is one half-step, black
 * first. With B the matrix of a bond, m = 1/2 sum B of a cell's bonds and b, w the displacements:
 *     b+ = b + (1 + a)/2 m^-1 [sum B (w - b) + F]                                   (Dong Eq 3)
 * and the same for white with the new black. a = 1 is the elastic solid; F is an outside force.
 *
 * Units. A cell weighs m/4 (1/4 inside), and then everything is Newton's:
 *   energy    E = 1/2 sum_bonds (w - b).B (w - b), which is P^2 / 2M for a rigid motion;
 *   momentum  p = sum m w - sum m b when black moves next, the negative when white does; p = M V;
 *   a force F on a cell acts through its own move, which covers one whole unit of time (two ticks):
 *   it does the work F.(displacement), gives the momentum F, and all of it is exact:
 *     dE = F.d - k d.m d,   dp = F - k m d,   k = (1 - a)/(1 + a).
 * So the impulse of a force on the moving colour is F times ONE, not F times the tick of 1/2.
 *
 * Public, and meant to stay: see fretwork.h. */
#ifndef FW_ELASTIC_AUTOMATON_H
#define FW_ELASTIC_AUTOMATON_H

#include "core/automaton/automaton_matrices.h"
#include "core/public.h"
#include "core/solid.h"

FW_PUBLIC_BEGIN

/* What a missing neighbour contributes. `bond`: nothing. `trapezoid`: nothing, and bonds with
 * only one full square of cells beside them (or none) count half: an edge free of traction.
 * `mirror`: a ghost that moves as the opposite neighbour does; keeps neither energy nor momentum,
 * and needs that opposite neighbour. */
typedef enum fw_boundary_rule {
    FW_BOUNDARY_BOND,
    FW_BOUNDARY_TRAPEZOID,
    FW_BOUNDARY_MIRROR
} fw_boundary_rule;

typedef struct fw_elastic_automaton_def {
    const fw_sites *sites; /* not owned, needed during create only */
    fw_lattice lattice;    /* FW_SQUARE; may be turned */
    fw_automaton_speeds speeds;
    fw_boundary_rule boundary;
    /* Above 0: the lattice closes upon itself after so many columns (rows), an even number that
     * the shape must fit in. Positions are not wrapped. */
    int period_columns, period_rows;
    bool black_is_odd; /* black, which moves first, are the sites with i + j odd, else even */
    double
        reflection; /* a, 0 < a <= 1; in terms of the LB solid's damping factor, mu = (1 + a)/2 */
    /* A bond breaks when its ends are displaced against each other by more than this (length; mean
     * over the half-step); INFINITY: never. Needs `bond` and matrices that are positive definite.
     */
    double break_at;
    /* The start, per site or NULL for zero: displaced by u and moving at V. */
    const fw_vec2 *displacement, *velocity;
    fw_vec2 drift; /* V of all sites where `velocity` is NULL */
    /* false: black is displaced by u, and white lies at the weighted mean of its black neighbours,
     *     w = m^-1 1/2 sum B b + V/2    (V half its own velocity, half that of its neighbours),
     * so that a body without V is exactly at rest and one with V has the momentum sum m V / 4. (In
     * a smooth field that is w = b + V/2 - (P d/dx + Q d/dy) b / 2.) u of white cells is not looked
     * at. true: both colours are displaced by u just as it is given, as in the paper's Figs 3 and
     * 5; that also gives the body momentum. */
    bool displaced_as_given;
} fw_elastic_automaton_def;

/* Spacing 1, Chopard's speeds, `bond`, nothing periodic, a = 1, unbreakable, at rest; no sites. */
fw_elastic_automaton_def fw_elastic_automaton_def_default(void);

/* FW_BAD_INPUT with the reason: speeds outside the disc, an odd period, a site without a bond, a
 * boundary rule under which this very body is unstable, numbers not finite. */
fw_status fw_elastic_automaton_create(fw_solid **solid, const fw_elastic_automaton_def *def,
                                      fw_error *error);

/* The largest |lambda| of one step (a = 1) of the body of this definition, stable or not; at most
 * 400 cells. 1 shows as up to 1 + 1e-6, for there lambda is defective. */
fw_status fw_elastic_automaton_spectral_radius(const fw_elastic_automaton_def *def, double *radius,
                                               fw_error *error);

/* Everything below takes a solid whose model is fw_elastic_automaton_model. */

/* Displacement from the lattice site. */
fw_vec2 fw_elastic_automaton_displacement(const fw_solid *solid, int particle);
bool fw_elastic_automaton_is_black(const fw_solid *solid, int particle);
/* Breaks the bond of a particle in a direction of the lattice, if there is one; the body must be
 * breakable. Its energy and momentum go into the ledger. Returns whether it broke: there was a
 * bond (and memory). */
bool fw_elastic_automaton_break(fw_solid *solid, int particle, int direction);
/* Particles that have lost their last bond: they have neither mass nor velocity left and stay
 * where they are. */
int fw_elastic_automaton_frozen(const fw_solid *solid);
int fw_elastic_automaton_broken(const fw_solid *solid); /* bonds broken so far */

extern const fw_solid_model fw_elastic_automaton_model;

FW_PUBLIC_END

#endif
