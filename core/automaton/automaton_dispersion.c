/* SPDX-License-Identifier: GPL-3.0-or-later */
/* automaton_dispersion.c - the one-step matrix of plane waves. Keeps no state.
 *
 * With H = sum B_i exp(i k.Delta_i) a step takes (b, w) to b+ = -b + H w, w+ = -w + H^+ b+ (Dong
 * Eq 33, whose lower-left block is printed with the wrong sign). An eigenvector with eigenvalue
 * lambda has (lambda + 1) b = H w and (lambda + 1) w = lambda H^+ b, hence
 *     H^+ H w = z w,   z = (lambda + 1)^2 / lambda = 4 cos^2(omega / 2):
 * a Hermitian problem, which is well conditioned also where lambda = 1 is defective. */
#include "core/automaton/automaton_dispersion.h"

#include "core/gsl_errors.h"

#include <gsl/gsl_eigen.h>
#include <math.h>

static double square(double x)
{
    return x * x;
}

void fw_automaton_closed_form(fw_automaton_speeds speeds, fw_vec2 wave, double squared[FW_MODES])
{
    const double shear = square(speeds.transverse), coupling = square(speeds.coupling);
    const double p0 = sqrt(fmax(0, 1 - shear / 2));
    const double p1 = sqrt(fmax(0, 1 - shear / 2 - coupling / 2));
    const double sx = sin(wave.x), sy = sin(wave.y);
    /* 4 - H^+ H, with the matrices of Eqs 29 to 31, is `mean` times 1 and `split` times a
     * reflection. Both vanish for long waves, and are written so that nothing cancels there. */
    const double minus = shear + coupling / 2, plus = 4 - minus;
    const double s = sx * sx + sy * sy;
    /* v = cos kx - cos ky, kept exact for long waves. */
    const double v = 2 * (square(sin(wave.y / 2)) - square(sin(wave.x / 2)));
    const double mean = minus * (s + plus * v * v / 4);
    const double split = coupling / 2 * hypot(s, v * (p1 * sx - p0 * sy));
    squared[FW_SLOW] = mean - split;
    squared[FW_FAST] = mean + split;
}

static double frequency_of(double squared)
{
    return 2 * asin(fmin(1, sqrt(fmax(0, squared)) / 2));
}

double fw_automaton_phase_speed(fw_automaton_speeds speeds, fw_vec2 wave, int mode)
{
    double squared[FW_MODES];
    fw_automaton_closed_form(speeds, wave, squared);
    return frequency_of(squared[mode]) / hypot(wave.x, wave.y);
}

/* Symmetric, for P and Q are: entries 00, 01, 11. Complex also where the matrices are. */
typedef struct symbol {
    double complex xx, xy, yy;
} symbol;

static symbol symbol_of(const fw_automaton_matrices *matrices, fw_vec2 wave)
{
    const double complex phase[FW_DIRECTIONS] = {cexp(I * wave.x), cexp(I * wave.y),
                                                 cexp(-I * wave.x), cexp(-I * wave.y)};
    symbol h = {0, 0, 0};
    for (int d = 0; d < FW_DIRECTIONS; ++d) {
        h.xx += matrices->bond[d].xx * phase[d];
        h.xy += matrices->bond[d].xy * phase[d];
        h.yy += matrices->bond[d].yy * phase[d];
    }
    return h;
}

static void apply(symbol h, const double complex in[2], double complex out[2])
{
    out[0] = h.xx * in[0] + h.xy * in[1];
    out[1] = h.xy * in[0] + h.yy * in[1];
}

/* H^+ H, Hermitian. */
typedef struct hermitian {
    double xx, yy;
    double complex xy;
} hermitian;

static hermitian product_of(symbol h)
{
    return (hermitian){creal(conj(h.xx) * h.xx + conj(h.xy) * h.xy),
                       creal(conj(h.xy) * h.xy + conj(h.yy) * h.yy),
                       conj(h.xx) * h.xy + conj(h.xy) * h.yy};
}

/* Eigenvalues, the largest first, and eigenvectors as columns of complex numbers. False without
 * memory. */
static bool diagonalise(hermitian z, double values[2], double vectors[8])
{
    gsl_eigen_hermv_workspace *workspace = gsl_eigen_hermv_alloc(2);
    if (!workspace) return false;
    double entries[8];
    gsl_matrix_complex_view product = gsl_matrix_complex_view_array(entries, 2, 2);
    gsl_matrix_complex_view vector = gsl_matrix_complex_view_array(vectors, 2, 2);
    gsl_vector_view value = gsl_vector_view_array(values, 2);
    const double complex row[4] = {z.xx, z.xy, conj(z.xy), z.yy};
    for (int e = 0; e < 4; ++e) {
        entries[2 * e] = creal(row[e]);
        entries[2 * e + 1] = cimag(row[e]);
    }
    gsl_eigen_hermv(&product.matrix, &value.vector, &vector.matrix, workspace);
    gsl_eigen_hermv_sort(&value.vector, &vector.matrix, GSL_EIGEN_SORT_VAL_DESC);
    gsl_eigen_hermv_free(workspace);
    return true;
}

fw_status fw_automaton_modes(const fw_automaton_matrices *matrices, fw_vec2 wave,
                             fw_automaton_mode mode[FW_MODES], fw_error *error)
{
    const symbol h = symbol_of(matrices, wave);
    double values[2], vectors[8];
    fw_gsl_errors_catch();
    const bool enough = diagonalise(product_of(h), values, vectors);
    fw_gsl_errors_release();
    if (!enough) return fw_fail_memory(error, "the one-step matrix of a plane wave");
    for (int m = 0; m < FW_MODES; ++m) {
        mode[m].squared = 4 - values[m];
        mode[m].frequency = frequency_of(mode[m].squared);
        for (int c = 0; c < 2; ++c)
            mode[m].white[c] = vectors[4 * c + 2 * m] + I * vectors[4 * c + 2 * m + 1];
        const double complex factor = cexp(I * mode[m].frequency) + 1;
        apply(h, mode[m].white, mode[m].black);
        for (int c = 0; c < 2; ++c)
            mode[m].black[c] = cabs(factor) > 1e-8 ? mode[m].black[c] / factor : 0;
    }
    return FW_OK;
}

void fw_automaton_mode_fill(const double complex black[2], const double complex white[2],
                            fw_vec2 wave, double complex amplitude, const fw_sites *sites,
                            bool black_is_odd, fw_vec2 *displacement)
{
    for (int p = 0; p < sites->count; ++p) {
        const fw_site site = sites->site[p];
        const bool is_black = ((site.i + site.j) & 1) == (int)black_is_odd;
        const double complex *a = is_black ? black : white;
        const double complex here = amplitude * cexp(I * (wave.x * site.i + wave.y * site.j));
        displacement[p] = (fw_vec2){creal(a[0] * here), creal(a[1] * here)};
    }
}

/* |lambda| of lambda + 1/lambda + 2 = z, the larger one. */
static double growth_of(double complex z)
{
    const double complex half = z / 2 - 1, root = csqrt(half * half - 1);
    return fmax(cabs(half + root), cabs(half - root));
}

/* Outside the disc P and Q of Eq 30 are complex and H(k), H'(k) = sum D_i exp(i k.Delta_i) are no
 * longer each other's adjoint: the largest singular value of H is then only a bound (1.933 at
 * c = (1, 1.1), where |lambda| = 1.891), so that z is taken from H' H itself. */
static double outside_growth(double shear, double coupling, fw_vec2 wave)
{
    const double complex p0 = csqrt(1 - shear / 2), p1 = csqrt(1 - shear / 2 - coupling / 2);
    const double complex cx = cos(wave.x), cy = cos(wave.y), sx = sin(wave.x), sy = sin(wave.y);
    /* sum B_i exp(..) = [(M + P^2) cos kx + (4 - M - P^2) cos ky]/2 + i [P sin kx + Q sin ky]; D_i
     * turns the sign of the second part. */
    const double complex diagonal = p0 * p0 + p1 * p1;
    const symbol even = {((shear + coupling + diagonal) * (cx - cy) + 4 * cy) / 2,
                         p0 * p1 * (cx - cy), ((shear + diagonal) * (cx - cy) + 4 * cy) / 2};
    const symbol odd = {I * (p0 * sx + p1 * sy), I * (p1 * sx - p0 * sy), I * (p0 * sx + p1 * sy)};
    const symbol h = {even.xx + odd.xx, even.xy + odd.xy, even.yy + odd.yy};
    const symbol back = {even.xx - odd.xx, even.xy - odd.xy, even.yy - odd.yy};
    const double complex xx = back.xx * h.xx + back.xy * h.xy, xy = back.xx * h.xy + back.xy * h.yy;
    const double complex yx = back.xy * h.xx + back.yy * h.xy, yy = back.xy * h.xy + back.yy * h.yy;
    const double complex mean = (xx + yy) / 2, split = csqrt(mean * mean - (xx * yy - xy * yx));
    return fmax(growth_of(mean + split), growth_of(mean - split));
}

fw_status fw_automaton_growth_map(fw_automaton_speeds speeds, int grid, fw_automaton_growth *growth,
                                  fw_error *error)
{
    const double shear = square(speeds.transverse), coupling = square(speeds.coupling);
    const bool inside = fw_automaton_speeds_check(speeds, NULL) == FW_OK;
    fw_automaton_matrices matrices;
    if (inside) FW_TRY(fw_automaton_matrices_make(&matrices, speeds, 0, error));
    *growth = (fw_automaton_growth){0, 0, {0, 0}};
    for (int row = 0; row < grid; ++row)
        for (int column = 0; column < grid; ++column) {
            const fw_vec2 wave = {FW_TWO_PI * column / grid, FW_TWO_PI * row / grid};
            double factor = 1, h = 0;
            if (inside) {
                const hermitian z = product_of(symbol_of(&matrices, wave));
                h = sqrt((z.xx + z.yy) / 2 + hypot((z.xx - z.yy) / 2, cabs(z.xy)));
                if (h > 2) factor = square((h + sqrt(h * h - 4)) / 2);
            } else {
                factor = outside_growth(shear, coupling, wave);
                h = sqrt(factor) + 1 / sqrt(factor);
            }
            if (h <= growth->largest) continue;
            *growth = (fw_automaton_growth){h, factor, wave};
        }
    return FW_OK;
}
