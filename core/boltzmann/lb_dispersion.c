/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lb_dispersion.c - plane waves of the LB solid. Keeps no state.
 *
 * Two steps of the solid make M (u+ - 2 u + u-) = sum over links (u_m - u), Stoermer and Verlet's
 * scheme (Chopard & Marconi Sec. 1.1). A wave u = a e^{i(k.r - omega t)} therefore has
 * 4 sin^2(omega/2) M a = (4 sin^2(kx/2) + 4 sin^2(ky/2)) a: the closed form of the header. */
#include "core/boltzmann/lb_dispersion.h"

#include "core/gsl_errors.h"
#include "core/lattice.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_matrix.h>
#include <math.h>

/* Fields f_0 to f_4, two components each: f_0 at 0, 1, then directions. */
enum { FIELDS = 2 * (FW_DIRECTIONS + 1) };

static fw_sym2 mass_of(fw_sym2 rest_mass)
{
    return fw_sym2_scale(0.5, fw_sym2_add(fw_sym2_square(rest_mass), fw_sym2_scalar(4)));
}

/* The frequency in closed form (see header); `branch` 0 is the slower wave. */
static double closed_form(fw_sym2 rest_mass, fw_vec2 wave_vector, int branch)
{
    fw_sym2 mass = mass_of(rest_mass);
    double half_trace = 0.5 * (mass.xx + mass.yy);
    double half_gap = hypot(0.5 * (mass.xx - mass.yy), mass.xy);
    double eigenvalue = branch == 0 ? half_trace + half_gap : half_trace - half_gap;
    double sx = sin(0.5 * wave_vector.x), sy = sin(0.5 * wave_vector.y);
    return 2 * asin(sqrt((sx * sx + sy * sy) / eigenvalue));
}

static void add(gsl_matrix_complex *matrix, int row, int column, gsl_complex value)
{
    gsl_complex sum = gsl_complex_add(
        gsl_matrix_complex_get(matrix, (size_t)row, (size_t)column), value);
    gsl_matrix_complex_set(matrix, (size_t)row, (size_t)column, sum);
}

static double entry(fw_sym2 m, int row, int column)
{
    return row != column ? m.xy : row == 0 ? m.xx : m.yy;
}

static fw_sym2 product(fw_sym2 a, fw_sym2 b)
{
    /* Of two matrices that commute (M0 and M^-1): symmetric again. */
    return (fw_sym2){a.xx * b.xx + a.xy * b.xy, a.xx * b.xy + a.xy * b.yy,
                     a.xy * b.xy + a.yy * b.yy};
}

/* T: w = M^-1 (M0 f_0 + sum f_i); f_0' = M0 w - f_0; f_i' = exp(-i k.c_i) (w - f_{i+2}). */
static void fill_step(gsl_matrix_complex *step, fw_sym2 rest_mass, fw_vec2 k)
{
    const fw_sym2 inverse = fw_sym2_invert(mass_of(rest_mass));
    const fw_sym2 from_rest = product(inverse, rest_mass);
    gsl_matrix_complex_set_zero(step);
    for (int c = 0; c < 2; ++c) {
        /* What each field contributes to w, taken on to all fields that w makes. */
        for (int source = 0; source <= FW_DIRECTIONS; ++source)
            for (int s = 0; s < 2; ++s) {
                double to_rest =
                    entry(product(rest_mass, source == 0 ? from_rest : inverse), c, s);
                add(step, c, 2 * source + s, gsl_complex_rect(to_rest, 0));
                double to_link = entry(source == 0 ? from_rest : inverse, c, s);
                for (int d = 0; d < FW_DIRECTIONS; ++d) {
                    fw_site beside = fw_site_neighbour((fw_site){0, 0}, d);
                    gsl_complex shift = gsl_complex_polar(1, -(k.x * beside.i + k.y * beside.j));
                    add(step, 2 * (d + 1) + c, 2 * source + s,
                        gsl_complex_mul_real(shift, to_link));
                }
            }
        add(step, c, c, gsl_complex_rect(-1, 0));
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            fw_site beside = fw_site_neighbour((fw_site){0, 0}, d);
            gsl_complex shift = gsl_complex_polar(-1, -(k.x * beside.i + k.y * beside.j));
            add(step, 2 * (d + 1) + c, 2 * (fw_opposite(d) + 1) + c, shift);
        }
    }
}

/* Memory of one problem. */
typedef struct workspace {
    gsl_matrix_complex *step, *hermitian;
    gsl_vector *values;
    gsl_eigen_herm_workspace *eigen;
} workspace;

static void release(workspace *w)
{
    if (w->step) gsl_matrix_complex_free(w->step);
    if (w->hermitian) gsl_matrix_complex_free(w->hermitian);
    if (w->values) gsl_vector_free(w->values);
    if (w->eigen) gsl_eigen_herm_free(w->eigen);
}

static bool allocate(workspace *w)
{
    w->step = gsl_matrix_complex_alloc(FIELDS, FIELDS);
    w->hermitian = gsl_matrix_complex_alloc(FIELDS, FIELDS);
    w->values = gsl_vector_alloc(FIELDS);
    w->eigen = gsl_eigen_herm_alloc(FIELDS);
    return w->step && w->hermitian && w->values && w->eigen;
}

static gsl_complex step_entry(const workspace *w, int row, int column)
{
    return gsl_matrix_complex_get(w->step, (size_t)row, (size_t)column);
}

/* (T + T^*)/2 has the eigenvalues cos omega. */
static double frequency_error(workspace *w, fw_sym2 rest_mass, fw_vec2 k)
{
    for (int r = 0; r < FIELDS; ++r)
        for (int c = 0; c < FIELDS; ++c)
            gsl_matrix_complex_set(
                w->hermitian, (size_t)r, (size_t)c,
                gsl_complex_mul_real(gsl_complex_add(step_entry(w, r, c),
                                                     gsl_complex_conjugate(step_entry(w, c, r))),
                                     0.5));
    gsl_eigen_herm(w->hermitian, w->values, w->eigen);
    double worst = 0;
    for (int branch = 0; branch < 2; ++branch) {
        double s = sin(0.5 * closed_form(rest_mass, k, branch)), nearest = INFINITY;
        for (size_t n = 0; n < FIELDS; ++n)
            nearest = fmin(nearest, fabs(0.5 * (1 - gsl_vector_get(w->values, n)) - s * s));
        worst = fmax(worst, nearest);
    }
    return worst;
}

static double radius_error(workspace *w)
{
    for (int r = 0; r < FIELDS; ++r)
        for (int c = 0; c < FIELDS; ++c) {
            gsl_complex sum = gsl_complex_rect(0, 0);
            for (int n = 0; n < FIELDS; ++n)
                sum = gsl_complex_add(
                    sum, gsl_complex_mul(gsl_complex_conjugate(step_entry(w, n, r)),
                                         step_entry(w, n, c)));
            gsl_matrix_complex_set(w->hermitian, (size_t)r, (size_t)c, sum);
        }
    gsl_eigen_herm(w->hermitian, w->values, w->eigen);
    double worst = 0;
    for (size_t n = 0; n < FIELDS; ++n)
        worst = fmax(worst, fabs(gsl_vector_get(w->values, n) - 1));
    return worst;
}

static void measure(workspace *w, fw_sym2 rest_mass, fw_vec2 k, fw_lb_spectrum *spectrum)
{
    fill_step(w->step, rest_mass, k);
    spectrum->frequency_error = frequency_error(w, rest_mass, k);
    spectrum->radius_error = radius_error(w);
}

fw_status fw_lb_spectrum_over_grid(fw_sym2 rest_mass, int side, fw_lb_spectrum *worst,
                                   fw_error *error)
{
    workspace w = {0};
    *worst = (fw_lb_spectrum){0, 0};
    fw_gsl_errors_catch();
    const bool enough = allocate(&w);
    for (int i = 0; enough && i < side; ++i)
        for (int j = 0; j < side; ++j) {
            fw_vec2 k = {FW_PI * (2.0 * i / (side - 1) - 1), FW_PI * (2.0 * j / (side - 1) - 1)};
            fw_lb_spectrum at;
            measure(&w, rest_mass, k, &at);
            worst->frequency_error = fmax(worst->frequency_error, at.frequency_error);
            worst->radius_error = fmax(worst->radius_error, at.radius_error);
        }
    release(&w);
    fw_gsl_errors_release();
    return enough ? FW_OK : fw_fail_memory(error, "the spectrum of an LB solid");
}
