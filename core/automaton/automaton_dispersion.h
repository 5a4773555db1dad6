/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_dispersion.h - plane waves of the elastic automaton on the endless lattice: frequency,
 * polarisation, stability. Wave vectors in radians per spacing, frequencies in radians per step (a
 * black and a white half-step). The lattice is not turned. */
#ifndef FW_AUTOMATON_DISPERSION_H
#define FW_AUTOMATON_DISPERSION_H

#include "core/automaton/automaton_matrices.h"

#include <complex.h>

enum { FW_SLOW, FW_FAST, FW_MODES };

/* 4 sin^2(omega / 2) of both modes in closed form (derived from
 * Dong Eq 33 with its signs corrected). For speeds inside the disc. */
void fw_automaton_closed_form(fw_automaton_speeds speeds, fw_vec2 wave, double squared[FW_MODES]);

/* omega / |k| of the closed form; `wave` must not be zero. */
double fw_automaton_phase_speed(fw_automaton_speeds speeds, fw_vec2 wave, int mode);

/* A running wave: at whole step t the cells at r are displaced by
 *     Re(black exp(i (k.r + omega t))), Re(white exp(i (k.r + omega t))),
 * at t = 0 with black to move next. |white| = 1. At omega = pi nothing ties black to white; black
 * is then zero. */
typedef struct fw_automaton_mode {
    double squared;   /* 4 sin^2(omega / 2) */
    double frequency; /* omega, 0 to pi */
    double complex black[2], white[2];
} fw_automaton_mode;

/* Both modes, slow first, from the one-step matrix of these matrices by GSL (Hermitian problem
 * H^+ H w = 4 cos^2(omega / 2) w with H = sum B_i exp(i k.Delta_i)). */
fw_status fw_automaton_modes(const fw_automaton_matrices *matrices, fw_vec2 wave,
                             fw_automaton_mode mode[FW_MODES], fw_error *error);

/* Displacements Re(amplitude a exp(i k.s)) of sites s = (i, j), a being `black` or `white`: to be
 * started `displaced_as_given`. */
void fw_automaton_mode_fill(const double complex black[2], const double complex white[2],
                            fw_vec2 wave, double complex amplitude, const fw_sites *sites,
                            bool black_is_odd, fw_vec2 *displacement);

/* The worst that a step does to plane waves with k on a grid of grid x grid over the Brillouin
 * zone (rows and columns at multiples of 2 pi / grid). Any speeds >= 0, also outside the disc,
 * where the matrices of Eq 30 turn complex. */
typedef struct fw_automaton_growth {
    double largest; /* h: inside the disc the largest singular value of H, never above 2; outside
                     * the h with |lambda| = ((h + sqrt(h^2 - 4)) / 2)^2 */
    double factor;  /* the largest |lambda| of the one-step matrix */
    fw_vec2 wave;   /* where */
} fw_automaton_growth;

fw_status fw_automaton_growth_map(fw_automaton_speeds speeds, int grid, fw_automaton_growth *growth,
                                  fw_error *error);

#endif
