/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_same_waves.c - different solids of the same Lame coefficients and density carry the same
 * long waves, each where it can be such a medium: the LB solid and Chopard's automaton only with
 * lambda = -mu, the elastic automaton and the linear lattice with any that are stable. */
#include "tests/support/laws.h"

#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"
#include "core/particles/linear_lattice.h"
#include "tests/support/standing_wave.h"

#include <stdlib.h>

/* Density 1 per square of the spacing, so that c_T^2 = mu and c_L^2 = lambda + 2 mu. */
typedef struct medium {
    double lambda, mu;
} medium;

typedef struct body {
    fw_sites sites;
    fw_lattice lattice;
    fw_vec2 *displacement;
} body;

/* M = (M0^2 + 4)/2 with links of stiffness 1: c^2 = 1/M in steps of its own; density M. */
static fw_status make_boltzmann(fw_solid **solid, const body *b, medium m, fw_error *error)
{
    fw_lb_solid_def def = fw_lb_solid_def_default();
    def.sites = &b->sites;
    def.lattice = b->lattice;
    def.rest_mass = fw_sym2_scalar(sqrt(2 / m.mu - 4));
    def.displacement = b->displacement;
    return fw_lb_solid_create(solid, &def, error);
}

static fw_status make_automaton(fw_solid **solid, const body *b, medium m, fw_error *error)
{
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &b->sites;
    def.lattice = b->lattice;
    def.speeds = (fw_automaton_speeds){sqrt(m.mu), sqrt(fmax(0, m.lambda + m.mu))};
    def.displacement = b->displacement;
    return fw_elastic_automaton_create(solid, &def, error);
}

/* The area of a particle is 3^(1/2)/2. */
static fw_status make_linear(fw_solid **solid, const body *b, medium m, fw_error *error)
{
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.sites = &b->sites;
    def.lattice = b->lattice;
    def.mass = sqrt(3) / 2;
    fw_linear_lattice_from_lame(m.lambda, m.mu, &def.k1, &def.k2);
    def.controls.time_step = 0.05;
    def.displacements = b->displacement;
    return fw_linear_lattice_create(solid, &def, error);
}

static const struct {
    const char *name;
    fw_lattice_kind lattice;
    fw_status (*make)(fw_solid **solid, const body *b, medium m, fw_error *error);
    bool scalar; /* only lambda = -mu */
} solids[] = {{"lattice Boltzmann", FW_SQUARE, make_boltzmann, true},
              {"elastic automaton", FW_SQUARE, make_automaton, false},
              {"linear lattice", FW_HEXAGONAL, make_linear, false}};

static double speed_in(int s, medium m, bool longitudinal)
{
    const standing_wave wave = {solids[s].lattice, longitudinal};
    body b = {.lattice = {.kind = solids[s].lattice, .spacing = 1}};
    fw_solid *solid;
    fw_error error;
    assert_int_equal(fw_sites_rectangle(&b.sites, STANDING_COLUMNS, STANDING_ROWS, NULL), FW_OK);
    b.displacement = malloc((size_t)b.sites.count * sizeof *b.displacement);
    for (int p = 0; p < b.sites.count; ++p)
        b.displacement[p] = standing_wave_at(&wave, b.sites.site[p]);
    if (solids[s].make(&solid, &b, m, &error) != FW_OK) fail_msg("%s", error.sentence);
    free(b.displacement);
    fw_sites_clear(&b.sites);
    return standing_wave_speed(&wave, solid);
}

static void equal_media_carry_equal_waves(void **state)
{
    (void)state;
    const medium media[] = {{-0.25, 0.25}, {0.11, 0.25}, {0.2, 0.4}, {-0.1, 0.36}};
    for (int n = 0; n < 4; ++n)
        for (int longitudinal = 0; longitudinal < 2; ++longitudinal) {
            const medium m = media[n];
            const double c = sqrt(longitudinal ? m.lambda + 2 * m.mu : m.mu);
            double least = INFINITY, most = 0;
            for (int s = 0; s < 3; ++s) {
                if (solids[s].scalar && m.lambda != -m.mu) continue;
                const double found = speed_in(s, m, longitudinal == 1);
                print_message("lambda %5.2f mu %.2f %-12s %-18s %.5f of %.5f\n", m.lambda, m.mu,
                              longitudinal ? "longitudinal" : "transverse", solids[s].name, found,
                              c);
                assert_close(found / c, 1, STANDING_ERROR);
                least = fmin(least, found);
                most = fmax(most, found);
            }
            assert_below(most / least - 1, STANDING_ERROR);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(equal_media_carry_equal_waves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
