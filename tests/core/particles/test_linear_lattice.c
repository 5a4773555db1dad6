/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_linear_lattice.c - the linear lattice is an isotropic elastic medium, and turns freely. */
#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "core/noise.h"
#include "core/particles/linear_lattice.h"

#include <stdlib.h>
#include <string.h>

#define ROOT_3 1.73205080756887729353

static fw_solid *made(const fw_linear_lattice_def *def)
{
    fw_solid *solid;
    fw_error error = {0};
    if (fw_linear_lattice_create(&solid, def, &error) != FW_OK) fail_msg("%s", error.sentence);
    return solid;
}

static fw_sites rectangle(int columns, int rows)
{
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, columns, rows, NULL), FW_OK);
    return sites;
}

static fw_vec2 force_on(const fw_solid *solid, int i)
{
    const fw_langevin *langevin = (const fw_langevin *)solid;
    return (fw_vec2){langevin->force_x[i], langevin->force_y[i]};
}

/* A ragged shape with a hole, thin necks and a corner of one triangle. */
static const char *const ragged = "..##...##.\n"
                                  ".####.####\n"
                                  "##..######\n"
                                  "##..#####.\n"
                                  ".########.\n"
                                  "..###..#..\n";

static void any_small_rotation_is_free(void **state)
{
    (void)state;
    for (int compensated = 0; compensated < 2; ++compensated) {
        fw_sites sites;
        assert_int_equal(fw_sites_mask(&sites, ragged, NULL), FW_OK);
        fw_linear_lattice_def def = fw_linear_lattice_def_default();
        def.sites = &sites;
        def.compensated = compensated;
        def.lattice = (fw_lattice){FW_HEXAGONAL, 1.3, 0.7, {5, -3}};
        fw_vec2 *turned = malloc((size_t)sites.count * sizeof *turned);
        for (int i = 0; i < sites.count; ++i)
            turned[i] = fw_vec2_add(
                fw_vec2_scale(0.1, fw_vec2_turn(fw_lattice_position(&def.lattice, sites.site[i]))),
                (fw_vec2){7, 8});
        def.displacements = turned;
        fw_solid *solid = made(&def);
        double largest = 0;
        for (int i = 0; i < sites.count; ++i)
            largest = fmax(largest, fabs(force_on(solid, i).x) + fabs(force_on(solid, i).y));
        if (compensated) {
            assert_below(largest, 1e-12);
            assert_close(fw_solid_energies(solid).elastic, 0, 1e-11);
        } else {
            assert_true(largest > 1);
        }
        fw_solid_destroy(solid);
        free(turned);
        fw_sites_clear(&sites);
    }
}

/* Energies are quadratic: a central difference of any width is exact but for rounding. */
static void forces_are_gradients(void **state)
{
    (void)state;
    for (int compensated = 0; compensated < 2; ++compensated) {
        fw_sites sites;
        assert_int_equal(fw_sites_mask(&sites, ragged, NULL), FW_OK);
        fw_linear_lattice_def def = fw_linear_lattice_def_default();
        def.sites = &sites;
        def.compensated = compensated;
        def.lattice.angle = 0.2;
        fw_solid *solid = made(&def);
        for (int i = 0; i < solid->count; ++i) {
            const fw_vec2 moved = fw_noise_uniform(1, (uint32_t)i, 0, 0);
            solid->x[i] += 0.1 * moved.x;
            solid->y[i] += 0.1 * moved.y;
        }
        restore(solid);
        for (int i = 0; i < solid->count; ++i)
            for (int axis = 0; axis < 2; ++axis) {
                double *at = axis ? &solid->y[i] : &solid->x[i];
                const double kept = *at, h = 0.01;
                *at = kept + h;
                restore(solid);
                const double above = fw_solid_energies(solid).elastic;
                *at = kept - h;
                restore(solid);
                const double below = fw_solid_energies(solid).elastic;
                *at = kept;
                restore(solid);
                const fw_vec2 force = force_on(solid, i);
                assert_close(axis ? force.y : force.x, (below - above) / (2 * h), 1e-10);
            }
        fw_solid_destroy(solid);
        fw_sites_clear(&sites);
    }
}

/* A hexagonal lattice is isotropic: plane waves in 7 directions. The force inside a body is that of
 * the dynamical matrix, and for small q the speeds are those of an isotropic medium. */
static void waves_run_alike_in_all_directions(void **state)
{
    (void)state;
    fw_sites sites = rectangle(9, 9);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &sites;
    def.mass = 1.7;
    def.lattice.spacing = 1.1;
    const double scale = 1.5 * def.lattice.spacing * def.lattice.spacing / def.mass;
    const double longitudinal = sqrt(scale * (def.k1 + 0.75 * def.k2));
    const double transverse = sqrt(scale * (def.k1 + 0.25 * def.k2));
    const int middle = fw_sites_find(&sites, (fw_site){4, 4});
    for (int direction = 0; direction < 7; ++direction)
        for (int across = 0; across < 2; ++across) {
            const double angle = direction * FW_PI / 13, q = 0.02;
            const fw_vec2 along = {cos(angle), sin(angle)}, wave = fw_vec2_scale(q, along);
            const fw_vec2 u = across ? fw_vec2_turn(along) : along;
            fw_solid *solid = made(&def);
            const fw_vec2 home = fw_linear_lattice_home(solid, middle);
            for (int i = 0; i < solid->count; ++i) {
                const fw_vec2 apart = fw_vec2_subtract(fw_linear_lattice_home(solid, i), home);
                const double phase = cos(fw_vec2_dot(wave, apart));
                solid->x[i] += phase * u.x;
                solid->y[i] += phase * u.y;
            }
            restore(solid);
            const fw_vec2 force = force_on(solid, middle);
            const fw_sym2 matrix = fw_linear_lattice_dynamical_matrix(&def, wave);
            const fw_vec2 expected = fw_vec2_scale(-def.mass, fw_sym2_apply(matrix, u));
            assert_close(force.x, expected.x, 1e-12);
            assert_close(force.y, expected.y, 1e-12);
            const double speed = sqrt(fw_sym2_form(u, matrix, u)) / q;
            assert_close(speed / (across ? transverse : longitudinal), 1, 1e-4);
            fw_solid_destroy(solid);
        }
    fw_sites_clear(&sites);
}

/* Between rigid rows: mu = sqrt3 (k1 + k2/4) = 38.97114 for k1 = 10, k2 = 50 (printed: half). */
static void rows_shear_with_the_corrected_modulus(void **state)
{
    (void)state;
    fw_sites sites = rectangle(12, 6);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &sites;
    def.compensated = false;
    const double shear = 0.01;
    fw_solid *solid = made(&def);
    for (int i = 0; i < solid->count; ++i)
        solid->x[i] += shear * fw_linear_lattice_home(solid, i).y;
    restore(solid);
    const int inner = fw_sites_find(&sites, (fw_site){6, 5});
    assert_close(-force_on(solid, inner).x / (shear * def.lattice.spacing), 38.97114317, 1e-8);
    double k1, k2;
    fw_linear_lattice_from_lame(-12, 38.97114317, &k1, &k2);
    assert_close(ROOT_3 * (k1 + k2 / 4), 38.97114317, 1e-12);
    assert_close(ROOT_3 / 2 * k2, 38.97114317 - 12, 1e-12);
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
}

/* Contraction of the middle of a bar that is pulled at its ends. */
static double poisson_ratio(bool compensated)
{
    enum { COLUMNS = 60, ROWS = 25 };
    fw_sites sites = rectangle(COLUMNS, ROWS);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &sites;
    def.compensated = compensated;
    def.controls = (fw_langevin_controls){.time_step = 0.05, .damping = 0.3};
    fw_solid *solid = made(&def);
    solid->loaded = true;
    for (int i = 0; i < solid->count; ++i) {
        if (sites.site[i].i == 0) solid->external_x[i] = -0.1;
        if (sites.site[i].i == COLUMNS - 1) solid->external_x[i] = 0.1;
    }
    for (int step = 0; step < 3000; ++step) advance_free(solid);
    const int left = fw_sites_find(&sites, (fw_site){COLUMNS / 2 - 8, ROWS / 2});
    const int right = fw_sites_find(&sites, (fw_site){COLUMNS / 2 + 8, ROWS / 2});
    const int low = fw_sites_find(&sites, (fw_site){COLUMNS / 2, ROWS / 2 - 6});
    const int high = fw_sites_find(&sites, (fw_site){COLUMNS / 2, ROWS / 2 + 6});
    const double along = (solid->x[right] - solid->x[left]) / 16 - 1;
    const double across = (solid->y[high] - solid->y[low]) / (12 * ROOT_3 / 2) - 1;
    /* No twist: the two halves of the load are opposite and the bar lies along them. */
    fw_solid_destroy(solid);
    fw_sites_clear(&sites);
    return -across / along;
}

/* Poisson's ratio of a bar in the plane is lambda/(lambda + 2 mu), with the Lame coefficients of
 * linear_lattice.h (k2 - 4 k1)/(3 k2 + 4 k1) = .0526: with surface forces. Without them the bonds'
 * own energy, k1 d^2 + k2 (e . d)^2 each, is least for a contraction by
 * k2/(3 k2 + 4 k1) = .263. The edge's own
 * stiffness leaves some per mille in a bar of 25 rows. */
static void free_sides_contract_by_lame_only_if_compensated(void **state)
{
    (void)state;
    const double free = poisson_ratio(false), lame = poisson_ratio(true);
    print_message("Poisson ratio: %.4f without, %.4f with surface forces\n", free, lame);
    assert_close(free, 50. / 190, 0.005);
    assert_close(lame, 10. / 190, 0.005);
}

/* The dynamical matrix of an endless lattice knows the fastest wave. With a = 4 k1 + 2 k2 and b =
 * 2 |k2| it has m omega^2 = 2 a + b at the middle of the zone's edge, or 9/4 a + 9/16 b^2/(a - b)
 * near the zone's corner, where 5 b < 2 a. */
static void time_step_ends_at_the_fastest_wave(void **state)
{
    (void)state;
    enum { PARTS = 300 };
    const struct {
        double k1, k2, fastest;
    } cases[] = {{10, 50, 380}, {10, 0, 90},      {10, 1, 94.55625}, {10, -2, 81.28125},
                 {10, -8, 64},  {1.5, 1, 18.375}, {3, 4, 48}};
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.mass = 1.7;
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        double fastest = 0;
        def.k1 = cases[n].k1;
        def.k2 = cases[n].k2;
        for (int i = 0; i <= PARTS; ++i)
            for (int j = 0; j <= PARTS; ++j) {
                const fw_vec2 wave = {4 * FW_PI / 3 * i / PARTS, 2 * FW_PI / ROOT_3 * j / PARTS};
                const fw_sym2 d = fw_linear_lattice_dynamical_matrix(&def, wave);
                fastest = fmax(fastest, (d.xx + d.yy) / 2 + hypot((d.xx - d.yy) / 2, d.xy));
            }
        /* The grid has the middle and the corner, and is coarse by (1/300)^2 beside them. */
        assert_close(1.7 * fastest / cases[n].fastest, 1, 2e-5);
        assert_true(1.7 * fastest <= cases[n].fastest * (1 + 1e-14));
        assert_close(fw_linear_lattice_time_step_limit(def.k1, def.k2, 1.7),
                     2 / sqrt(cases[n].fastest / 1.7), 1e-14);
    }
}

static void impossible_lattices_are_refused(void **state)
{
    (void)state;
    fw_sites sites = rectangle(3, 3);
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &sites;
    fw_solid *solid;
    fw_error error;
    def.lattice.kind = FW_SQUARE;
    assert_int_equal(fw_linear_lattice_create(&solid, &def, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "square"));
    def.lattice.kind = FW_HEXAGONAL;
    def.k1 = -13;
    assert_int_equal(fw_linear_lattice_create(&solid, &def, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "k1 = -13 and k2 = 50"));
    def.k1 = 10;
    def.controls.time_step = 0.11;
    assert_int_equal(fw_linear_lattice_create(&solid, &def, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "less than 0.1026"));
    fw_sites_clear(&sites);
}

/* Next to the bounds a shaken free body stays as it is; beyond them it would collapse or turn
 * without end, at k2 = -5 with surface forces within 2000 steps. */
static void free_bodies_of_allowed_lattices_last(void **state)
{
    (void)state;
    const struct {
        double k1, k2;
        bool compensated, refused;
    } cases[] = {{10, 0.01, true, false},  {10, -5, true, true},  {-12.4, 50, true, false},
                 {0.01, 50, false, false}, {-1, 50, false, true}, {10, -9.99, false, false},
                 {10, -11, false, true}};
    fw_sites sites = rectangle(5, 5);
    fw_vec2 shaken[25];
    for (int i = 0; i < 25; ++i)
        shaken[i] = fw_vec2_scale(0.01, fw_noise_uniform(4, (uint32_t)i, 0, 0));
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_linear_lattice_def def = fw_linear_lattice_def_default();
        def.sites = &sites;
        def.displacements = shaken;
        def.k1 = cases[n].k1;
        def.k2 = cases[n].k2;
        def.compensated = cases[n].compensated;
        fw_solid *solid;
        fw_error error;
        const fw_status status = fw_linear_lattice_create(&solid, &def, &error);
        assert_int_equal(status, cases[n].refused ? FW_BAD_INPUT : FW_OK);
        if (cases[n].refused) {
            assert_non_null(strstr(error.sentence, "a body with free sides"));
            continue;
        }
        for (int step = 0; step < 10000; ++step) advance_free(solid);
        for (int i = 0; i < 25; ++i) {
            const fw_vec2 home = fw_linear_lattice_home(solid, i);
            assert_below(hypot(solid->x[i] - home.x, solid->y[i] - home.y), 1);
        }
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_small_rotation_is_free),
        cmocka_unit_test(forces_are_gradients),
        cmocka_unit_test(waves_run_alike_in_all_directions),
        cmocka_unit_test(rows_shear_with_the_corrected_modulus),
        cmocka_unit_test(free_sides_contract_by_lame_only_if_compensated),
        cmocka_unit_test(time_step_ends_at_the_fastest_wave),
        cmocka_unit_test(impossible_lattices_are_refused),
        cmocka_unit_test(free_bodies_of_allowed_lattices_last),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
