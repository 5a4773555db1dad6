/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_stability.c - growth of a body's own update. Keeps no state.
 *
 * With K_b w = m_b^-1 1/2 sum B w, the place that black is reflected about, and K_w likewise, an
 * eigenvector of a step has K_w K_b w = z w with (lambda + 1)^2 / lambda = 4 z. For `bond` and
 * `trapezoid` K_w K_b is symmetric in the scalar product of the masses, and stable means z <= 1.
 * Start reading at fw_automaton_check_stability(). */
#include "automaton_stability.h"

#include "core/gsl_errors.h"

#include <complex.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

/* z up to here counts as 1: what rounding leaves of the rigid shifts, for which z = 1. */
#define ONE (1 + 1e-11)
enum { LANCZOS_STEPS = 400, TRIAL_STEPS = 400, THREADS_FROM = 16384 };
#define TRIAL_GROWTH 1.02

/* out = K in: the place that each cell of a colour is reflected about, from fields of the other
 * colour; interleaved x, y. */
static void weighted_means(const fw_automaton *body, int colour, const double *in, double *out)
{
#pragma omp parallel for schedule(static) if (body->head.count >= THREADS_FROM)
    for (int n = 0; n < body->colour[colour].count; ++n) {
        fw_vec2 sum = {0, 0};
        for (int d = 0; d < FW_DIRECTIONS; ++d) {
            double weight;
            const int partner = fw_automaton_cell_neighbour(body, colour, n, d, &weight);
            if (partner < 0) continue;
            const fw_vec2 u = {in[2 * partner], in[2 * partner + 1]};
            sum = fw_vec2_add(sum, fw_sym2_apply(fw_automaton_cell_matrix(body, colour, n, d), u));
        }
        const fw_vec2 k =
            fw_sym2_apply(fw_automaton_cell_inverse_mass(body, colour, n), fw_vec2_scale(0.5, sum));
        out[2 * n] = k.x;
        out[2 * n + 1] = k.y;
    }
}

static double growth_of(double complex z)
{
    const double complex half = 2 * z - 1, root = csqrt(half * half - 1);
    return fmax(cabs(half + root), cabs(half - root));
}

/* Columns of K_w K_b; multiplied with the masses of white if `weighted`. */
static void fill_dense(const fw_automaton *body, gsl_matrix *dense, double *unit, double *black,
                       double *white, bool weighted)
{
    const size_t size = dense->size1;
    for (size_t column = 0; column < size; ++column) {
        for (size_t n = 0; n < size; ++n) unit[n] = n == column;
        weighted_means(body, FW_BLACK, unit, black);
        weighted_means(body, FW_WHITE, black, white);
        for (size_t n = 0; n < size / 2; ++n) {
            fw_vec2 value = {white[2 * n], white[2 * n + 1]};
            if (weighted)
                value = fw_sym2_apply(fw_automaton_cell_mass(body, FW_WHITE, (int)n), value);
            gsl_matrix_set(dense, 2 * n, column, value.x);
            gsl_matrix_set(dense, 2 * n + 1, column, value.y);
        }
    }
}

/* The masses of white's cells, along the diagonal. */
static void fill_masses(const fw_automaton *body, gsl_matrix *masses)
{
    for (size_t n = 0; n < masses->size1 / 2; ++n) {
        const fw_sym2 m = fw_automaton_cell_mass(body, FW_WHITE, (int)n);
        gsl_matrix_set(masses, 2 * n, 2 * n, m.xx);
        gsl_matrix_set(masses, 2 * n, 2 * n + 1, m.xy);
        gsl_matrix_set(masses, 2 * n + 1, 2 * n, m.xy);
        gsl_matrix_set(masses, 2 * n + 1, 2 * n + 1, m.yy);
    }
}

/* False without memory, as general_growth(). */
static bool symmetric_growth(const fw_automaton *body, gsl_matrix *dense, double *growth)
{
    const size_t size = dense->size1;
    gsl_matrix *masses = gsl_matrix_calloc(size, size);
    gsl_vector *values = gsl_vector_alloc(size);
    gsl_eigen_gensymm_workspace *workspace = gsl_eigen_gensymm_alloc(size);
    const bool enough = masses && values && workspace;
    if (enough) {
        fill_masses(body, masses);
        gsl_eigen_gensymm(dense, masses, values, workspace);
        double largest = 0;
        for (size_t n = 0; n < size; ++n) largest = fmax(largest, gsl_vector_get(values, n));
        *growth = growth_of(largest);
    }
    gsl_matrix_free(masses);
    gsl_vector_free(values);
    gsl_eigen_gensymm_free(workspace);
    return enough;
}

static bool general_growth(gsl_matrix *dense, double *growth)
{
    const size_t size = dense->size1;
    gsl_vector_complex *values = gsl_vector_complex_alloc(size);
    gsl_eigen_nonsymm_workspace *workspace = gsl_eigen_nonsymm_alloc(size);
    const bool enough = values && workspace;
    *growth = 0;
    /* Who knows what an eigenvalue is that was not found. */
    if (enough && gsl_eigen_nonsymm(dense, values, workspace) != GSL_SUCCESS) *growth = INFINITY;
    for (size_t n = 0; enough && n < size; ++n) {
        const gsl_complex z = gsl_vector_complex_get(values, n);
        *growth = fmax(*growth, growth_of(GSL_REAL(z) + I * GSL_IMAG(z)));
    }
    gsl_vector_complex_free(values);
    gsl_eigen_nonsymm_free(workspace);
    return enough;
}

fw_status fw_automaton_spectral_radius(const fw_automaton *body, double *radius, fw_error *error)
{
    if (body->head.count > FW_AUTOMATON_DENSE_MAX)
        return fw_fail(error, FW_BAD_INPUT,
                       "the spectral radius of a body of %d cells, expected at most %d",
                       body->head.count, FW_AUTOMATON_DENSE_MAX);
    const size_t white = 2 * (size_t)body->colour[FW_WHITE].count;
    const size_t black = 2 * (size_t)body->colour[FW_BLACK].count;
    double *room = fw_array_of_doubles(2 * white + black);
    fw_gsl_errors_catch();
    gsl_matrix *dense = gsl_matrix_alloc(white, white);
    bool enough = room && dense;
    if (enough) {
        const bool symmetric = body->boundary != FW_BOUNDARY_MIRROR;
        fill_dense(body, dense, room, room + 2 * white, room + white, symmetric);
        enough = symmetric ? symmetric_growth(body, dense, radius) : general_growth(dense, radius);
    }
    gsl_matrix_free(dense);
    fw_gsl_errors_release();
    free(room);
    return enough ? FW_OK : fw_fail_memory(error, "the update of an automaton as a matrix");
}

/* Lanczos iteration for the largest z, in the scalar product of white's masses. */
typedef struct lanczos {
    const fw_automaton *body;
    size_t size;
    double *now, *before, *next, *black;
    double diagonal[LANCZOS_STEPS], beside[LANCZOS_STEPS];
} lanczos;

static double product(const lanczos *l, const double *a, const double *b)
{
    double sum = 0;
    for (size_t n = 0; n < l->size / 2; ++n) {
        const fw_sym2 m = fw_automaton_cell_mass(l->body, FW_WHITE, (int)n);
        sum +=
            fw_sym2_form((fw_vec2){a[2 * n], a[2 * n + 1]}, m, (fw_vec2){b[2 * n], b[2 * n + 1]});
    }
    return sum;
}

static void subtract(const lanczos *l, double *from, double factor, const double *other)
{
    for (size_t n = 0; n < l->size; ++n) from[n] -= factor * other[n];
}

/* Rigid shifts have z = 1 and do not count. */
static void take_out_shifts(const lanczos *l, double *values)
{
    fw_sym2 mass = {0, 0, 0};
    fw_vec2 moment = {0, 0};
    for (size_t n = 0; n < l->size / 2; ++n) {
        const fw_sym2 m = fw_automaton_cell_mass(l->body, FW_WHITE, (int)n);
        mass = fw_sym2_add(mass, m);
        moment = fw_vec2_add(moment, fw_sym2_apply(m, (fw_vec2){values[2 * n], values[2 * n + 1]}));
    }
    const fw_vec2 mean = fw_sym2_apply(fw_sym2_invert(mass), moment);
    for (size_t n = 0; n < l->size / 2; ++n) {
        values[2 * n] -= mean.x;
        values[2 * n + 1] -= mean.y;
    }
}

/* Has the tridiagonal matrix of the first `steps` steps an eigenvalue above x (Sturm)? */
static bool reaches(const lanczos *l, int steps, double x)
{
    double pivot = -1;
    for (int k = 0; k < steps; ++k) {
        const double off = k > 0 ? l->beside[k - 1] * l->beside[k - 1] / pivot : 0;
        pivot = l->diagonal[k] - x - off;
        if (!(pivot < 0)) return true;
    }
    return false;
}

/* The largest z that the iteration finds from the start in l->now; stops once it is above 1. */
static double iterate(lanczos *l)
{
    int steps = 0;
    double norm = sqrt(product(l, l->now, l->now));
    for (size_t n = 0; n < l->size; ++n) l->before[n] = 0;
    for (; steps < LANCZOS_STEPS && norm > 1e-8; ++steps) {
        for (size_t n = 0; n < l->size; ++n) l->now[n] /= norm;
        weighted_means(l->body, FW_BLACK, l->now, l->black);
        weighted_means(l->body, FW_WHITE, l->black, l->next);
        take_out_shifts(l, l->next);
        if (steps > 0) subtract(l, l->next, norm, l->before);
        l->diagonal[steps] = product(l, l->now, l->next);
        subtract(l, l->next, l->diagonal[steps], l->now);
        norm = sqrt(fmax(0, product(l, l->next, l->next)));
        l->beside[steps] = norm;
        double *spent = l->before;
        l->before = l->now;
        l->now = l->next;
        l->next = spent;
        /* Once it is beyond doubt, some more steps sharpen the number. */
        if (steps > 100 && reaches(l, steps - 60, 1 + 1e-9)) break;
    }
    double low = 0, high = 16;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        *(reaches(l, steps, middle) ? &low : &high) = middle;
    }
    return high;
}

/* From a rotation, whose energy the trapezoid rule can make negative, and from noise. */
static fw_status largest_by_lanczos(const fw_automaton *body, double *largest, fw_error *error)
{
    const fw_automaton_colour *white = &body->colour[FW_WHITE];
    lanczos *l = calloc(1, sizeof *l);
    const size_t size = 2 * (size_t)white->count;
    double *room = fw_array_of_doubles(3 * size + 2 * (size_t)body->colour[FW_BLACK].count);
    if (!l || !room) {
        free(l);
        free(room);
        return fw_fail_memory(error, "the stability test of an automaton");
    }
    *l = (lanczos){.body = body,
                   .size = size,
                   .now = room,
                   .before = room + size,
                   .next = room + 2 * size,
                   .black = room + 3 * size};
    uint64_t noise = 1;
    *largest = 0;
    for (int start = 0; start < 2 && *largest <= ONE; ++start) {
        for (int n = 0; n < white->count; ++n)
            for (int axis = 0; axis < 2; ++axis) {
                const fw_vec2 home = fw_solid_position(&body->head, white->particle[n]);
                noise = noise * 6364136223846793005u + 1442695040888963407u;
                l->now[2 * n + axis] = start == 0 ? (axis == 0 ? -home.y : home.x)
                                                  : (double)(noise >> 11) / 0x1p53 - 0.5;
            }
        take_out_shifts(l, l->now);
        *largest = fmax(*largest, iterate(l));
    }
    free(room);
    free(l);
    return FW_OK;
}

/* Growth per step over the second half of a trial run from noise. */
static fw_status trial_growth(const fw_automaton *body, double *growth, fw_error *error)
{
    const size_t white = 2 * (size_t)body->colour[FW_WHITE].count;
    const size_t black = 2 * (size_t)body->colour[FW_BLACK].count;
    double *room = fw_array_of_doubles(2 * (white + black));
    if (!room) return fw_fail_memory(error, "the stability test of an automaton");
    double *b = room, *w = b + black, *means = w + white;
    uint64_t noise = 1;
    for (size_t n = 0; n < white; ++n) {
        noise = noise * 6364136223846793005u + 1442695040888963407u;
        w[n] = (double)(noise >> 11) / 0x1p53 - 0.5;
    }
    double middle = 0, end = 0;
    for (int step = 1; step <= TRIAL_STEPS; ++step) {
        weighted_means(body, FW_BLACK, w, means);
        for (size_t n = 0; n < black; ++n) b[n] = 2 * means[n] - b[n];
        weighted_means(body, FW_WHITE, b, means);
        for (size_t n = 0; n < white; ++n) w[n] = 2 * means[n] - w[n];
        if (step != TRIAL_STEPS / 2 && step != TRIAL_STEPS) continue;
        end = 0;
        for (size_t n = 0; n < white; ++n) end += w[n] * w[n];
        if (step == TRIAL_STEPS / 2) middle = end;
    }
    free(room);
    *growth = pow(end / middle, 1.0 / TRIAL_STEPS);
    return FW_OK;
}

static fw_status refuse(const fw_automaton *body, double growth, fw_error *error)
{
    static const char *const name[] = {"bond", "trapezoid", "mirror"};
    return fw_fail(error, FW_BAD_INPUT,
                   "boundary rule '%s' with c1 = %g, c2 = %g is unstable for this body of %d "
                   "cells: its own update grows by %.6g in every step (expected 1); another rule, "
                   "or a smaller c2, may be stable",
                   name[body->boundary], body->matrices.speeds.transverse,
                   body->matrices.speeds.coupling, body->head.count, growth);
}

static fw_status check_mirror(const fw_automaton *body, fw_error *error)
{
    double growth = 0;
    if (body->head.count <= FW_AUTOMATON_DENSE_MAX) {
        FW_TRY(fw_automaton_spectral_radius(body, &growth, error));
        /* lambda = 1 is defective: an error of 1e-12 in z shows as 1e-6. */
        return growth > 1 + 1e-5 ? refuse(body, growth, error) : FW_OK;
    }
    FW_TRY(trial_growth(body, &growth, error));
    return growth > TRIAL_GROWTH ? refuse(body, growth, error) : FW_OK;
}

fw_status fw_automaton_check_stability(const fw_automaton *body, fw_error *error)
{
    if (body->colour[FW_BLACK].rim_count + body->colour[FW_WHITE].rim_count == 0) return FW_OK;
    if (body->boundary == FW_BOUNDARY_MIRROR) return check_mirror(body, error);
    if (fw_automaton_matrices_least(&body->matrices) >= 0) return FW_OK;
    bool positive;
    FW_TRY(fw_automaton_tiles_are_positive(body, &positive, error));
    if (positive) return FW_OK;
    fw_form_sign sign;
    FW_TRY(fw_automaton_form_sign(body, &sign, error));
    if (sign == FW_FORM_POSITIVE) return FW_OK;
    double largest = 0;
    FW_TRY(largest_by_lanczos(body, &largest, error));
    if (sign == FW_FORM_TOO_LARGE && largest <= ONE) return FW_OK;
    return refuse(body, growth_of(fmax(largest, 1)), error);
}
