/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_dispersion.h - plane waves in an endless LB solid: the closed form, and the eigenvalues of the
 * one-step matrix as its independent check. Wave vectors in radians per site; mu = 1, kappa = 1. */
#ifndef FW_LB_DISPERSION_H
#define FW_LB_DISPERSION_H

#include "core/status.h"
#include "core/vec2.h"

/* The closed form is
 *     sin^2(omega/2) = (sin^2(kx/2) + sin^2(ky/2)) / M,   M = (M0^2 + 4)/2,
 * for each of the two directions of polarisation, the eigenvectors of M0. */
typedef struct fw_lb_spectrum {
    double frequency_error; /* |sin^2(omega/2) - closed form| of the nearest eigenvalue */
    double radius_error;    /* largest | |lambda|^2 - 1 | of the one-step matrix */
} fw_lb_spectrum;

/* Of the 10 x 10 one-step matrix T(k) of the fields f_0 ... f_4, the worst of a grid of side x side
 * wave vectors from -pi to pi. T is unitary in the energy norm, so both questions are Hermitian
 * problems: T + T^* has the eigenvalues 2 cos omega, T^* T those of |lambda|^2. FW_SYSTEM_FAILED
 * without memory. */
fw_status fw_lb_spectrum_over_grid(fw_sym2 rest_mass, int side, fw_lb_spectrum *worst,
                                   fw_error *error);

#endif
