/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_stability.c - which bodies of the elastic automaton are stable, by their squares,
 * by their whole form, by the eigenvalues of their update. */
#include "tests/support/automata.h"

#include "core/automaton/automaton_stability.h"

static double energy(const fw_solid *solid)
{
    const fw_energies e = fw_solid_energies(solid);
    return e.kinetic + e.elastic;
}

static bool accepted(const fw_elastic_automaton_def *def)
{
    fw_solid *solid;
    const bool is = fw_elastic_automaton_create(&solid, def, NULL) == FW_OK;
    fw_solid_destroy(solid);
    return is;
}

static void acceptance_is_the_spectral_radius(void **state)
{
    (void)state;
    /* The sign of the energy form decides; the eigenvalues of the body's own update must agree. */
    const fw_sites shapes[] = {rectangle(6, 6), rectangle(12, 3), rectangle(5, 1),
                               mask("###...\n###...\n######\n######\n"), rectangle(8, 8)};
    int stable = 0, unstable = 0;
    for (int s = 0; s < 5; ++s)
        for (int rule = FW_BOUNDARY_BOND; rule <= FW_BOUNDARY_TRAPEZOID; ++rule)
            for (int row = 0; row < 8; ++row)
                for (int column = 1; column < 8; ++column) {
                    fw_elastic_automaton_def def = def_of(&shapes[s], 0.17 * column, 0.163 * row);
                    def.boundary = (fw_boundary_rule)rule;
                    double radius;
                    if (fw_elastic_automaton_spectral_radius(&def, &radius, NULL) != FW_OK) {
                        assert_false(accepted(&def));
                        continue;
                    }
                    /* lambda = 1 is defective: rounding of z shows as its root. */
                    const bool expected = radius < 1 + 5e-6;
                    assert_int_equal(accepted(&def), expected);
                    *(expected ? &stable : &unstable) += 1;
                }
    assert_true(stable > 200 && unstable > 50);
    for (int s = 0; s < 5; ++s) fw_sites_clear((fw_sites *)&shapes[s]);
}

static bool tiles_are_positive(const fw_elastic_automaton_def *def)
{
    fw_solid *solid;
    bool are;
    if (fw_elastic_automaton_create(&solid, def, NULL) != FW_OK) return false;
    assert_int_equal(fw_automaton_tiles_are_positive(fw_automaton_of(solid), &are, NULL), FW_OK);
    fw_solid_destroy(solid);
    return are;
}

static void tiles_that_are_positive_make_stable_bodies(void **state)
{
    (void)state;
    /* Bodies are accepted as their tiles say; the whole form must say the same of them. */
    const fw_sites shapes[] = {rectangle(6, 6),
                               rectangle(9, 2),
                               rectangle(19, 26),
                               rectangle(40, 18),
                               mask("###...\n###...\n######\n######\n"),
                               mask("..##..\n.####.\n######\n.####.\n..##..\n")};
    enum { SHAPES = sizeof shapes / sizeof shapes[0] };
    int told = 0, untold = 0;
    for (int s = 0; s < SHAPES; ++s)
        for (int rule = FW_BOUNDARY_BOND; rule <= FW_BOUNDARY_TRAPEZOID; ++rule)
            for (int row = 0; row < 40; ++row) {
                const double c1 = 0.2 + 0.2 * (row % 4), ratio = 1.1 + 0.01 * row;
                fw_elastic_automaton_def def = def_of(&shapes[s], c1, ratio * c1);
                fw_solid *solid;
                def.boundary = (fw_boundary_rule)rule;
                if (fw_elastic_automaton_create(&solid, &def, NULL) != FW_OK) continue;
                const fw_automaton *body = fw_automaton_of(solid);
                bool tells;
                fw_form_sign sign;
                assert_int_equal(fw_automaton_tiles_are_positive(body, &tells, NULL), FW_OK);
                assert_int_equal(fw_automaton_form_sign(body, &sign, NULL), FW_OK);
                if (tells) assert_int_equal(sign, FW_FORM_POSITIVE);
                *(tells ? &told : &untold) += 1;
                fw_solid_destroy(solid);
            }
    assert_true(told > 200 && untold > 10);
    for (int s = 0; s < SHAPES; ++s) fw_sites_clear((fw_sites *)&shapes[s]);
}

static void some_bodies_have_more_than_tiles(void **state)
{
    (void)state;
    fw_sites block = rectangle(5, 2), bridge = mask("##.##\n#####\n"); /* bonds without squares */
    fw_sites large = rectangle(2000, 500);
    fw_elastic_automaton_def def = def_of(&block, 0.4, 0.45);
    assert_true(tiles_are_positive(&def));
    def.sites = &bridge;
    assert_false(tiles_are_positive(&def));
    /* No factorisation would do for this one. */
    def = def_of(&large, 0.4, 0.54);
    assert_true(tiles_are_positive(&def));
    fw_sites_clear(&block);
    fw_sites_clear(&bridge);
    fw_sites_clear(&large);
}

static void rotation_decides_for_the_trapezoid(void **state)
{
    (void)state;
    /* Turned by theta the square has the energy theta^2 (2 c1^2 - c2^2)(n - 1)^2 / 8: where that is
     * negative it is refused. */
    fw_sites sites = rectangle(6, 6);
    const double c1 = 0.6;
    fw_vec2 u[36];
    const double theta = 0.01;
    for (int side = -1; side <= 1; side += 2) {
        fw_elastic_automaton_def def = def_of(&sites, c1, sqrt(2) * c1 * (1 + 0.02 * side));
        def.boundary = FW_BOUNDARY_TRAPEZOID;
        assert_int_equal(accepted(&def), side < 0);
        if (side > 0) continue;
        /* White lies where it does in a uniform strain: -(P d/dx + Q d/dy) u / 2. */
        fw_automaton_matrices m;
        assert_int_equal(fw_automaton_matrices_make(&m, def.speeds, 0, NULL), FW_OK);
        const fw_sym2 east = fw_sym2_add(m.bond[FW_EAST], fw_sym2_scale(-1, m.bond[FW_WEST]));
        const fw_sym2 north = fw_sym2_add(m.bond[FW_NORTH], fw_sym2_scale(-1, m.bond[FW_SOUTH]));
        const fw_vec2 offset = fw_vec2_add(fw_sym2_apply(east, (fw_vec2){0, -theta / 2}),
                                           fw_sym2_apply(north, (fw_vec2){theta / 2, 0}));
        for (int p = 0; p < 36; ++p) {
            const fw_site site = sites.site[p];
            u[p] = (fw_vec2){-theta * site.j, theta * site.i};
            if ((site.i + site.j) & 1) u[p] = fw_vec2_add(u[p], offset);
        }
        def.displacement = u;
        def.displaced_as_given = true;
        fw_solid *solid;
        assert_int_equal(fw_elastic_automaton_create(&solid, &def, NULL), FW_OK);
        const double c2 = def.speeds.coupling;
        assert_close(energy(solid) / (theta * theta * (2 * c1 * c1 - c2 * c2) * 25 / 8), 1, 1e-11);
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

static void large_bodies_are_judged_alike(void **state)
{
    (void)state;
    /* By factorisation (90 x 90), by a trial run (mirror, 30 x 30) and by iteration (220 x 220). */
    fw_sites sites = rectangle(90, 90);
    fw_elastic_automaton_def def = def_of(&sites, 0.4, 0.5);
    assert_true(accepted(&def));
    def.speeds.coupling = 0.567;
    assert_false(accepted(&def));
    fw_sites_clear(&sites);
    sites = rectangle(30, 30);
    def = def_of(&sites, 0.4, 0.58);
    def.boundary = FW_BOUNDARY_MIRROR;
    assert_true(accepted(&def));
    fw_sites_clear(&sites);
    sites = rectangle(220, 220);
    def = def_of(&sites, 0.4, 0.57);
    assert_false(accepted(&def));
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(acceptance_is_the_spectral_radius),
        cmocka_unit_test(tiles_that_are_positive_make_stable_bodies),
        cmocka_unit_test(some_bodies_have_more_than_tiles),
        cmocka_unit_test(rotation_decides_for_the_trapezoid),
        cmocka_unit_test(large_bodies_are_judged_alike),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
