/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_lb_refusals.c - LB solids that cannot be run are refused with a sentence, and those next to
 * them keep their energy. */
#include "tests/support/laws.h"
#include "tests/support/steps.h"

#include "core/boltzmann/lb_solid.h"
#include "core/noise.h"

#include <string.h>

static void impossible_parameters_are_refused(void **state)
{
    (void)state;
    fw_sites pair, lone;
    const fw_site far_apart[] = {{0, 0}, {5, 5}};
    assert_int_equal(fw_sites_rectangle(&pair, 2, 1, NULL), FW_OK);
    assert_int_equal(fw_sites_list(&lone, far_apart, 2, NULL), FW_OK);
    fw_solid *solid;
    fw_error error;
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &lone;
    assert_int_equal(fw_lb_solid_create(&solid, &def, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "site [0, 0] has no links"));
    def.sites = &pair;
    const double wrong[] = {0.5, 1.01, -1, NAN};
    for (int n = 0; n < 4; ++n) {
        def.mu = wrong[n];
        assert_int_equal(fw_lb_solid_create(&solid, &def, &error), FW_BAD_INPUT);
        assert_non_null(strstr(error.sentence, "damping factor mu"));
    }
    def.mu = 1;
    def.stiffness = fw_sym2_scalar(-1);
    assert_int_equal(fw_lb_solid_create(&solid, &def, &error), FW_BAD_INPUT);
    assert_null(solid);
    fw_sites_clear(&pair);
    fw_sites_clear(&lone);
}

static double total_energy(const fw_solid *solid)
{
    const fw_energies e = fw_solid_energies(solid);
    return e.kinetic + e.elastic;
}

/* Up to the largest condition number of M rounding takes nothing; beyond it the body is refused,
 * whether link stiffness or rest mass makes it so. Its axes may have any scales of their own. */
static void nearly_singular_masses_are_refused(void **state)
{
    (void)state;
    const struct {
        fw_sym2 stiffness, rest_mass;
        bool refused;
    } cases[] = {{{1, 1 - 3.1e-8, 1}, {0, 0, 0}, false}, {{1, 3.1e-8 - 1, 1}, {0, 0, 0}, false},
                 {{1, 1 - 2.8e-8, 1}, {0, 0, 0}, true},  {{1, 2.8e-8 - 1, 1}, {0, 0, 0}, true},
                 {{1e8, 1, 1e-8}, {0, 0, 0}, true},      {{1e8, 0, 1e-8}, {0, 0, 0}, false},
                 {{1, 1 - 1e-13, 1}, {1, 0, 1}, true},   {{1, 0, 1}, {5e3, 5e3, 5e3}, false},
                 {{1, 0, 1}, {1e6, 1e6, 1e6}, true}};
    fw_sites sites;
    assert_int_equal(fw_sites_rectangle(&sites, 6, 6, NULL), FW_OK);
    fw_vec2 velocity[36];
    for (int l = 0; l < 36; ++l) velocity[l] = fw_noise_uniform(3, (uint32_t)l, 0, 0);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_solid *solid;
        fw_error error;
        fw_lb_solid_def def = fw_lb_solid_def_default();
        def.sites = &sites;
        def.stiffness = cases[n].stiffness;
        def.rest_mass = cases[n].rest_mass;
        def.velocity = velocity;
        const fw_status status = fw_lb_solid_create(&solid, &def, &error);
        assert_int_equal(status, cases[n].refused ? FW_BAD_INPUT : FW_OK);
        if (cases[n].refused) {
            assert_non_null(strstr(error.sentence, "condition number"));
            continue;
        }
        const double before = total_energy(solid);
        for (int step = 0; step < 2000; ++step) advance_free(solid);
        assert_below(fabs(total_energy(solid) / before - 1), 1e-12);
        fw_solid_destroy(solid);
    }
    fw_sites_clear(&sites);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impossible_parameters_are_refused),
        cmocka_unit_test(nearly_singular_masses_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
