/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_stability.h - whether a body with free boundaries is stable, decided from its own
 * update. For the automaton's own files only.
 *
 * For `bond` and `trapezoid` the energy is a form Q = [[m_b, -C], [-C^T, m_w]] that both half-steps
 * keep. In coordinates where the masses are 1, Q has the eigenvalues 1 +- sigma with the singular
 * values sigma of C, and each pair is a step of its own with trace 4 sigma^2 - 2 and determinant
 * a^2: it is stable exactly for sigma <= 1. So a body is stable exactly if Q is not negative
 * anywhere, and the test of a huge matrix's spectral radius becomes a Cholesky factorisation. */
#ifndef FW_AUTOMATON_STABILITY_H
#define FW_AUTOMATON_STABILITY_H

#include "automaton_body.h"

/* FW_BAD_INPUT with the reason and the growth for an unstable body. Exact where every bond's matrix
 * is positive, where every tile of it is, for small bodies and for those whose
 * factorisation takes less than a second or so (about 200 x 200 cells, long strips of any length);
 * beyond that by Lanczos iteration, which finds every growth that is not slower than what the
 * iteration can resolve. `mirror` has no energy: its spectral radius is computed for small bodies
 * (up to 400 cells), larger ones run for 400 steps and are refused for growth above 2 % a step. */
fw_status fw_automaton_check_stability(const fw_automaton *body, fw_error *error);

/* The largest |lambda| of a step at a = 1, by dense eigenvalues; for at most 400 cells. Where it is
 * 1, rounding leaves up to 1 + 1e-6: lambda = 1 is defective. */
enum { FW_AUTOMATON_DENSE_MAX = 400 };
fw_status fw_automaton_spectral_radius(const fw_automaton *body, double *radius, fw_error *error);

/* *are true: the body's energy is nowhere below that of masses of -1e-12, since that of none of its
 * tiles is; takes time for the rim only. false: this does not tell. Not for `mirror`.
 * automaton_tiles.c */
fw_status fw_automaton_tiles_are_positive(const fw_automaton *body, bool *are, fw_error *error);

/* Cholesky factorisation of the energy form, shifted by 1e-12: automaton_energy_form.c. */
typedef enum fw_form_sign { FW_FORM_POSITIVE, FW_FORM_NEGATIVE, FW_FORM_TOO_LARGE } fw_form_sign;
fw_status fw_automaton_form_sign(const fw_automaton *body, fw_form_sign *sign, fw_error *error);

#endif
