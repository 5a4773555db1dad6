/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_waves.c - matrices, dispersion and waves of the elastic automaton against the
 * closed form and the paper's single mode. */
#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "core/automaton/automaton_dispersion.h"
#include "core/automaton/elastic_automaton.h"

#include <stdlib.h>
#include <string.h>

static double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)(*seed >> 11) / 4503599627370496.0 - 1;
}

static void chopard_has_halves(void **state)
{
    (void)state;
    fw_automaton_matrices matrices;
    assert_int_equal(fw_automaton_matrices_make(&matrices, fw_automaton_chopard(), 0, NULL), FW_OK);
    for (int d = 0; d < FW_DIRECTIONS; ++d)
        assert_true(matrices.bond[d].xx == 0.5 && matrices.bond[d].xy == 0 &&
                    matrices.bond[d].yy == 0.5);
}

static void matrices_meet_the_continuum_conditions(void **state)
{
    (void)state;
    /* Eq 20: sum B = 2, and the second-order conditions of Navier's equation. */
    uint64_t seed = 1;
    for (int n = 0; n < 200; ++n) {
        const double r = sqrt(2) * fabs(random_number(&seed)),
                     t = M_PI / 2 * fabs(random_number(&seed));
        fw_automaton_matrices m;
        assert_int_equal(
            fw_automaton_matrices_make(&m, (fw_automaton_speeds){r * cos(t), r * sin(t)}, 0, NULL),
            FW_OK);
        const double shear = r * r * cos(t) * cos(t), coupling = r * r * sin(t) * sin(t);
        fw_sym2 sum = {0, 0, 0};
        for (int d = 0; d < FW_DIRECTIONS; ++d) sum = fw_sym2_add(sum, m.bond[d]);
        assert_true(sum.xx == 2 && sum.xy == 0 && sum.yy == 2);
        const fw_sym2 p = fw_sym2_add(m.bond[FW_EAST], fw_sym2_scale(-1, m.bond[FW_WEST]));
        const fw_sym2 q = fw_sym2_add(m.bond[FW_NORTH], fw_sym2_scale(-1, m.bond[FW_SOUTH]));
        const fw_sym2 along = fw_sym2_scale(2, fw_sym2_add(m.bond[FW_EAST], m.bond[FW_WEST]));
        const fw_sym2 xx = fw_sym2_add(along, fw_sym2_scale(-1, fw_sym2_square(p)));
        assert_close(xx.xx, shear + coupling, 1e-14);
        assert_close(xx.xy, 0, 1e-14);
        assert_close(xx.yy, shear, 1e-14);
        /* -(P Q + Q P) = c2^2 sigma */
        assert_close(-2 * (p.xx * q.xx + p.xy * q.xy), 0, 1e-14);
        assert_close(-(p.xx * q.xy + p.xy * q.yy + q.xx * p.xy + q.xy * p.yy), coupling, 1e-14);
    }
}

static void moduli_give_the_lame_coefficients(void **state)
{
    (void)state;
    fw_automaton_speeds speeds;
    assert_int_equal(fw_automaton_speeds_from_moduli(&speeds, 0.16, 0.35, NULL), FW_OK);
    const double mu = speeds.transverse * speeds.transverse;
    const double lambda = speeds.coupling * speeds.coupling - mu;
    assert_close(mu, 0.16, 1e-15);
    assert_close(lambda / (lambda + 2 * mu), 0.35, 1e-15);
    fw_error error;
    assert_int_equal(fw_automaton_speeds_from_moduli(&speeds, 0.16, 1, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "Poisson"));
    assert_int_equal(fw_automaton_speeds_from_moduli(&speeds, 0, 0.3, NULL), FW_BAD_INPUT);
}

static void closed_form_is_the_one_step_matrix(void **state)
{
    (void)state;
    uint64_t seed = 2;
    for (int n = 0; n < 4000; ++n) {
        const double r = sqrt(2 * fabs(random_number(&seed))),
                     t = M_PI / 2 * fabs(random_number(&seed));
        const fw_automaton_speeds speeds = {r * cos(t), r * sin(t)};
        const fw_vec2 wave = {M_PI * random_number(&seed), M_PI * random_number(&seed)};
        fw_automaton_matrices matrices;
        fw_automaton_mode mode[FW_MODES];
        double closed[FW_MODES];
        assert_int_equal(fw_automaton_matrices_make(&matrices, speeds, 0, NULL), FW_OK);
        assert_int_equal(fw_automaton_modes(&matrices, wave, mode, NULL), FW_OK);
        fw_automaton_closed_form(speeds, wave, closed);
        /* 4 - 4 cos^2: roundings of a number up to 4, and 1e-15 from the grain of the matrices. */
        for (int m = 0; m < FW_MODES; ++m) assert_close(mode[m].squared, closed[m], 1e-12);
    }
}

static void slow_mode_is_transverse(void **state)
{
    (void)state;
    const fw_automaton_speeds speeds = {0.4, 0.58};
    const fw_vec2 wave = {0.3, 0.3};
    assert_close(fw_automaton_phase_speed(speeds, wave, FW_SLOW), 0.394487, 5e-7);
    assert_close(fw_automaton_phase_speed(speeds, wave, FW_FAST), 0.696568, 5e-7);
    fw_automaton_matrices matrices;
    fw_automaton_mode mode[FW_MODES];
    assert_int_equal(fw_automaton_matrices_make(&matrices, speeds, 0, NULL), FW_OK);
    assert_int_equal(fw_automaton_modes(&matrices, wave, mode, NULL), FW_OK);
    assert_close(cabs(mode[FW_SLOW].white[0] + mode[FW_SLOW].white[1]), 0, 1e-12);
    assert_close(cabs(mode[FW_FAST].white[0] - mode[FW_FAST].white[1]), 0, 1e-12);
    assert_close(cabs(mode[FW_SLOW].black[0] + mode[FW_SLOW].black[1]), 0, 1e-12);
}

static void disc_is_the_region_of_stability(void **state)
{
    (void)state;
    for (int row = 0; row <= 16; ++row)
        for (int column = 0; column <= 16; ++column) {
            const fw_automaton_speeds speeds = {column * sqrt(2) / 16, row * sqrt(2) / 16};
            const double square =
                speeds.transverse * speeds.transverse + speeds.coupling * speeds.coupling;
            fw_automaton_growth growth;
            assert_int_equal(fw_automaton_growth_map(speeds, 32, &growth, NULL), FW_OK);
            if (square <= 2 + 1e-12) {
                assert_true(growth.largest <= 2 + 1e-12);
                continue;
            }
            /* The worst wave is (pi/2, pi/2): h^2 = 4 sin^2(omega/2) = 2 (c1^2 + c2^2). */
            const double h = sqrt(2 * square), root = (h + sqrt(h * h - 4)) / 2;
            assert_close(growth.factor, root * root, 1e-9);
            assert_close(growth.largest, h, 1e-12);
        }
    fw_automaton_growth growth;
    assert_int_equal(fw_automaton_growth_map((fw_automaton_speeds){1, 1.1}, 64, &growth, NULL),
                     FW_OK);
    assert_close(growth.factor, 1.891, 5e-4);
    assert_int_equal(fw_automaton_growth_map((fw_automaton_speeds){1.2, 0.8}, 64, &growth, NULL),
                     FW_OK);
    assert_close(growth.factor, 1.488, 5e-4);
}

/* A periodic lattice that carries amplitude Re(a exp(i k.r)) at the start. */
static fw_solid *carrier(int columns, int rows, fw_automaton_speeds speeds, fw_vec2 wave,
                         const double complex black[2], const double complex white[2],
                         double reflection)
{
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, columns, rows, NULL), FW_OK);
    fw_vec2 *u = malloc((size_t)sites.count * sizeof *u);
    fw_automaton_mode_fill(black, white, wave, 1, &sites, false, u);
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.speeds = speeds;
    def.period_columns = columns;
    def.period_rows = rows;
    def.displacement = u;
    def.displaced_as_given = true;
    def.reflection = reflection;
    fw_error error;
    fw_solid *solid;
    if (fw_elastic_automaton_create(&solid, &def, &error) != FW_OK) fail_msg("%s", error.sentence);
    free(u);
    fw_sites_clear(&sites);
    return solid;
}

static void paper_mode_runs_exactly(void **state)
{
    (void)state;
    /* Fig 5: Eqs 37-40 on 8 x 8; k = (-pi/2, -pi/2) with black first is the only one it fits. */
    const double complex lambda = (3 + I * sqrt(7)) / 4, a = (1 + I * sqrt(7)) * sqrt(2) / 8;
    const double complex black[2] = {a, -a}, white[2] = {-0.5, 0.5};
    const fw_vec2 wave = {-M_PI / 2, -M_PI / 2};
    assert_close(2 * M_PI / carg(lambda), 8.6936316, 5e-8);
    fw_solid *solid = carrier(8, 8, (fw_automaton_speeds){0.5, 1}, wave, black, white, 1);
    double worst = 0;
    for (int t = 1; t <= 1000; ++t) {
        advance_free(solid);
        advance_free(solid);
        const double complex turn = cexp(I * carg(lambda) * t);
        for (int p = 0; p < solid->count; ++p) {
            const double complex phase = turn * cexp(I * (wave.x * (p % 8) + wave.y * (p / 8)));
            const double complex *amplitude =
                fw_elastic_automaton_is_black(solid, p) ? black : white;
            const fw_vec2 u = fw_elastic_automaton_displacement(solid, p);
            worst = fmax(worst, fabs(u.x - creal(amplitude[0] * phase)));
            worst = fmax(worst, fabs(u.y - creal(amplitude[1] * phase)));
        }
    }
    assert_below(worst, 1e-11);
    fw_solid_destroy(solid);
}

/* The complex amplitude of a wave along a direction, from black cells. */
static double complex amplitude_of(const fw_solid *solid, int columns, fw_vec2 wave, fw_vec2 along)
{
    double complex sum = 0;
    for (int p = 0; p < solid->count; ++p) {
        if (!fw_elastic_automaton_is_black(solid, p)) continue;
        const double value = fw_vec2_dot(fw_elastic_automaton_displacement(solid, p), along);
        sum += value * cexp(-I * (wave.x * (p % columns) + wave.y * (p / columns)));
    }
    return sum / solid->count;
}

static void long_waves_run_at_the_speeds_of_navier(void **state)
{
    (void)state;
    /* Started as a user would, from a polarisation and a speed c (u, V = -c u'); measured as the
     * turn of the amplitude. The wave of the other direction that a start of finite wavelength
     * also excites makes the error, O(k^2) = 6e-4 in amplitude; turning through whole periods takes
     * most of it out. */
    enum { L = 256 };
    const fw_automaton_speeds speeds[] = {{0.4, 0.58}, {0.5, 1}, {1.41421356237309515, 0}};
    for (int s = 0; s < 3; ++s)
        for (int direction = 0; direction < 3; ++direction)
            for (int m = 0; m < FW_MODES; ++m) {
                const double k = 2 * M_PI / L;
                const fw_vec2 waves[] = {{k, 0}, {0, k}, {k, k}};
                const fw_vec2 wave = waves[direction];
                const int columns = wave.x != 0 ? L : 2, rows = wave.y != 0 ? L : 2;
                const double size = hypot(wave.x, wave.y);
                const fw_vec2 ahead = fw_vec2_scale(1 / size, wave);
                const fw_vec2 along = m == FW_FAST ? ahead : fw_vec2_turn(ahead);
                fw_automaton_matrices matrices;
                fw_automaton_mode mode[FW_MODES];
                assert_int_equal(fw_automaton_matrices_make(&matrices, speeds[s], 0, NULL), FW_OK);
                assert_int_equal(fw_automaton_modes(&matrices, wave, mode, NULL), FW_OK);
                fw_solid *solid =
                    carrier(columns, rows, speeds[s], wave, mode[m].black, mode[m].white, 1);
                /* Chopard's modes may be polarised anyhow: look along x + y/2 there. */
                const fw_vec2 look = speeds[s].coupling > 0 ? along : (fw_vec2){1, 0.5};
                const double complex begin = amplitude_of(solid, columns, wave, look);
                enum { STEPS = 60 };
                for (int tick = 0; tick < 2 * STEPS; ++tick) advance_free(solid);
                const double complex end = amplitude_of(solid, columns, wave, look);
                const double measured = carg(end / begin) / STEPS / size;
                const double c = m == FW_SLOW ? speeds[s].transverse
                                              : hypot(speeds[s].transverse, speeds[s].coupling);
                assert_close(measured / fw_automaton_phase_speed(speeds[s], wave, m), 1, 1e-10);
                assert_close(measured / c, 1, 3e-4);
                if (s == 0 && direction == 0)
                    assert_close(measured, m == FW_SLOW ? 0.4 : 0.70453, 3e-5);
                fw_solid_destroy(solid);
            }
}

static void start_from_strain_brings_no_spurious_velocity(void **state)
{
    (void)state;
    /* A long standing wave started at rest: uncorrected, black and white in the same place is a
     * velocity of (P u' + ...), first order in k; corrected it is second order. */
    enum { L = 64 };
    const double k = 2 * M_PI / L;
    double speed[2];
    for (int as_given = 0; as_given < 2; ++as_given) {
        fw_sites sites;
        assert_int_equal(fw_sites_rectangle(&sites, L, 2, NULL), FW_OK);
        fw_vec2 u[2 * L];
        for (int p = 0; p < 2 * L; ++p) u[p] = (fw_vec2){sin(k * sites.site[p].i), 0};
        fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
        def.sites = &sites;
        def.speeds = (fw_automaton_speeds){0.4, 0.5};
        def.period_columns = L;
        def.period_rows = 2;
        def.displacement = u;
        def.displaced_as_given = as_given;
        fw_solid *solid;
        assert_int_equal(fw_elastic_automaton_create(&solid, &def, NULL), FW_OK);
        double vx[2 * L], vy[2 * L];
        solid->model->velocities(solid, vx, vy);
        speed[as_given] = 0;
        for (int p = 0; p < 2 * L; ++p)
            speed[as_given] = fmax(speed[as_given], hypot(vx[p], vy[p]));
        assert_below(fabs(fw_solid_momentum(solid).x), 1e-13);
        fw_solid_destroy(solid);
        fw_sites_clear(&sites);
    }
    assert_true(speed[1] > k);
    assert_true(speed[0] < 4 * k * k);
}

static void damped_wave_shrinks_by_a(void **state)
{
    (void)state;
    const fw_vec2 wave = {M_PI / 4, M_PI / 4};
    const fw_automaton_speeds speeds = {0.5, 1};
    fw_automaton_matrices matrices;
    fw_automaton_mode mode[FW_MODES];
    assert_int_equal(fw_automaton_matrices_make(&matrices, speeds, 0, NULL), FW_OK);
    assert_int_equal(fw_automaton_modes(&matrices, wave, mode, NULL), FW_OK);
    fw_solid *solid = carrier(8, 8, speeds, wave, mode[FW_SLOW].black, mode[FW_SLOW].white, 0.98);
    /* Two amplitudes a step apart obey A(t+1) = T A(t) - a^2 A(t-1) with a real T: solve for the
     * determinant a^2 = |lambda|^2 from four. */
    double complex a[4];
    for (int t = 0; t < 4; ++t) {
        a[t] = amplitude_of(solid, 8, wave, (fw_vec2){1, -1});
        advance_free(solid);
        advance_free(solid);
    }
    const double complex determinant = (a[2] * a[2] - a[1] * a[3]) / (a[1] * a[1] - a[0] * a[2]);
    assert_close(sqrt(cabs(determinant)), 0.98, 1e-9);
    fw_solid_destroy(solid);
}

static void turned_lattice_moves_as_the_straight_one(void **state)
{
    (void)state;
    const double angle = 0.7, c = cos(angle), s = sin(angle);
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 9, 6, NULL), FW_OK);
    fw_solid *solid[2];
    fw_vec2 u[2][54];
    uint64_t seed = 9;
    for (int p = 0; p < 54; ++p) {
        u[0][p] = (fw_vec2){random_number(&seed), random_number(&seed)};
        u[1][p] = (fw_vec2){c * u[0][p].x - s * u[0][p].y, s * u[0][p].x + c * u[0][p].y};
    }
    for (int turned = 0; turned < 2; ++turned) {
        fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
        def.sites = &sites;
        def.speeds = (fw_automaton_speeds){0.4, 0.5};
        def.lattice.angle = turned ? angle : 0;
        def.displacement = u[turned];
        assert_int_equal(fw_elastic_automaton_create(&solid[turned], &def, NULL), FW_OK);
    }
    for (int tick = 0; tick < 400; ++tick)
        for (int turned = 0; turned < 2; ++turned) advance_free(solid[turned]);
    for (int p = 0; p < 54; ++p) {
        const fw_vec2 r = fw_solid_position(solid[0], p), q = fw_solid_position(solid[1], p);
        /* The turned matrices are rounded to 1e-15, which 200 steps of drift multiply by t^2. */
        assert_close(q.x, c * r.x - s * r.y, 1e-9);
        assert_close(q.y, s * r.x + c * r.y, 1e-9);
    }
    fw_solid_destroy(solid[0]);
    fw_solid_destroy(solid[1]);
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chopard_has_halves),
        cmocka_unit_test(matrices_meet_the_continuum_conditions),
        cmocka_unit_test(moduli_give_the_lame_coefficients),
        cmocka_unit_test(closed_form_is_the_one_step_matrix),
        cmocka_unit_test(slow_mode_is_transverse),
        cmocka_unit_test(disc_is_the_region_of_stability),
        cmocka_unit_test(paper_mode_runs_exactly),
        cmocka_unit_test(long_waves_run_at_the_speeds_of_navier),
        cmocka_unit_test(start_from_strain_brings_no_spurious_velocity),
        cmocka_unit_test(damped_wave_shrinks_by_a),
        cmocka_unit_test(turned_lattice_moves_as_the_straight_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
