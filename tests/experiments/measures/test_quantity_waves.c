/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_waves.c - strain, stress and waves of bodies whose numbers are known in closed
 * form. */
#include "tests/support/laws.h"

#include "core/boltzmann/lb_solid.h"
#include "tests/support/measured.h"

/* --- strain and stress of a lattice Boltzmann sheet --- */

/* u_x = .01 x + .02 y, u_y = .03 x + .04 y: e_xy is how links along x are displaced along y. */
#define STRAINED                                                                                   \
    "title: a sheet\nmaterials: {m: {lattice-boltzmann: {}}}\n"                                    \
    "bodies: {b: {material: m, shape: {rectangle: [5, %d]}, origin: [3, 1],\n"                     \
    "  displacement: [{gradient: [.01, .02, .03, .04]}]}}\nrun: {steps: 1}\n"

static void begin_sheet(int rows)
{
    char text[512];
    snprintf(text, sizeof text, STRAINED, rows);
    begin(text);
}

static void strain_is_the_mean_gradient_along_each_link(void **state)
{
    (void)state;
    const double expected[] = {.01, .03, .02, .04};
    begin_sheet(3);
    for (int c = 0; c < 4; ++c)
        assert_close(value_of("strain", 0, tensor_names[c]), expected[c], 1e-15);
    end();
}

static void a_row_without_links_across_has_no_strain_along_them(void **state)
{
    (void)state;
    begin_sheet(1);
    assert_close(value_of("strain", 0, "xx"), .01, 1e-15);
    assert_close(value_of("strain", 0, "yx"), 0, 0);
    assert_close(value_of("strain", 0, "yy"), 0, 0);
    assert_true(isnan(value_of("stress-over-strain", 0, "yx")));
    assert_true(isnan(value_of("stress-over-strain", 0, "yy")));
    end();
}

/* Column i is pulled by a (i - 2) + c, row j by b (j - 1) + c, in any direction: of both halves of
 * 5 x 3 half the difference is 3 a (1 + 2) and 5 b; c, and what pulls the middle, is no stress. */
static void stress_is_half_the_difference_of_what_pulls_both_halves(void **state)
{
    (void)state;
    const double expected[] = {9 * .1, 9 * .7, 5 * .3, 5 * .5};
    const double strains[] = {.01, .03, .02, .04};
    begin_sheet(3);
    fw_solid *solid = solid_of_body(0);
    for (int l = 0; l < solid->count; ++l) {
        const fw_site site = experiment->bodies[0].sites.site[l];
        solid->external_x[l] = .1 * (site.i - 2) + .3 * (site.j - 1) + 11;
        solid->external_y[l] = .7 * (site.i - 2) + .5 * (site.j - 1) - 7;
    }
    for (int c = 0; c < 4; ++c) {
        assert_close(value_of("stress", 0, tensor_names[c]), expected[c], 1e-13);
        assert_close(value_of("stress-over-strain", 0, tensor_names[c]), expected[c] / strains[c],
                     1e-11);
    }
    end();
}

/* The same of 3 x 2 sites from column 4 and row 1 on: 2 a and 3 b/2. */
static void stress_has_its_halves_wherever_the_sites_begin(void **state)
{
    (void)state;
    const double expected[] = {2 * .1, 2 * .7, 1.5 * .3, 1.5 * .5};
    begin("title: a sheet\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies: {b: {material: m, shape: {sites: [[4, 1], [5, 1], [6, 1], [4, 2], [5, 2], "
          "[6, 2]]}}}\nrun: {steps: 1}\n");
    fw_solid *solid = solid_of_body(0);
    for (int l = 0; l < solid->count; ++l) {
        const fw_site site = experiment->bodies[0].sites.site[l];
        solid->external_x[l] = .1 * (site.i - 5) + .3 * (site.j - 1.5) + 11;
        solid->external_y[l] = .7 * (site.i - 5) + .5 * (site.j - 1.5) - 7;
    }
    for (int c = 0; c < 4; ++c)
        assert_close(value_of("stress", 0, tensor_names[c]), expected[c], 1e-13);
    end();
}

/* Section 9.2: damped to rest under balanced forces, S/e is the number of parallel links. */
static void stress_over_strain_at_rest_counts_the_parallel_links(void **state)
{
    (void)state;
    begin("title: two by two\nmaterials: {rubber: {lattice-boltzmann: {damping: 0.2}}}\n"
          "bodies: {sheet: {material: rubber, shape: {rectangle: [2, 2]}}}\n"
          "forces:\n"
          "  on-A: {body: sheet, sites: [[0, 1]], force: [-0.13, 0.07]}\n"
          "  on-B: {body: sheet, sites: [[1, 1]], force: [0.05, 0.11]}\n"
          "  on-C: {body: sheet, sites: [[0, 0]], force: [0.02, -0.16]}\n"
          "  on-D: {body: sheet, sites: [[1, 0]], force: [0.06, -0.02]}\n"
          "run: {steps: 400}\n");
    run_steps(400);
    /* S_x = F_B + F_D, S_y = F_A + F_B. */
    const double expected[] = {.11, .09, -.08, .18};
    for (int c = 0; c < 4; ++c) {
        assert_close(value_of("stress", 0, tensor_names[c]), expected[c], 1e-15);
        assert_close(value_of("stress-over-strain", 0, tensor_names[c]), 2, 1e-9);
    }
    end();
}

/* Seven particles in a row move alike: each has its own and its links' share of the mass, 2 at both
 * ends, 3 between them. */
static void a_wave_front_is_where_the_energy_is(void **state)
{
    (void)state;
    begin("title: a row\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [7, 1]}, spacing: 1.5,\n"
          "  velocity: [.02, .01]}}\nrun: {steps: 1}\n");
    assert_close(value_of("wave-front", 0, NULL),
                 1.5 * (2 * 2 * 3 + 2 * 3 * (1 + 2)) / (2 * 2 + 5 * 3), 1e-13);
    end();
    begin("title: a row at rest\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [7, 1]}}}\nrun: {steps: 1}\n");
    assert_close(value_of("wave-front", 0, NULL), 0, 0);
    end();
}

/* The middle is that between the outermost columns, in whichever row they are: four in a row and
 * one above the first. All move alike, M = (1 + links)/2. */
static void a_wave_front_is_seen_from_the_middle_of_any_shape(void **state)
{
    (void)state;
    begin("title: an L\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies: {b: {material: m, shape: {sites: [[5, 0], [6, 0], [7, 0], [8, 0], [5, 1]]},\n"
          "  velocity: [.02, .01]}}\nrun: {steps: 1}\n");
    const double mass[] = {1.5, 1.5, 1.5, 1, 1}, distance[] = {1.5, .5, .5, 1.5, 1.5};
    double sum = 0, weight = 0;
    for (int l = 0; l < 5; ++l) {
        sum += mass[l] * distance[l];
        weight += mass[l];
    }
    assert_close(value_of("wave-front", 0, NULL), sum / weight, 1e-13);
    end();
}

/* --- plane waves --- */

#define K1   10.
#define K2   50.
#define MASS 3.
#define C    1.25 /* spacing */
#define Q    .3

/* Of the linear lattice (Eq 2), summed over its three pairs of bonds c e:
 *     m omega^2 = sum 2 (1 - cos q . c e) (k1 + k2 (e . p)^2),   p along q or across it. */
static double lattice_frequency(double angle_of_wave, bool along)
{
    const double polarisation = angle_of_wave + (along ? 0 : FW_PI / 2);
    double sum = 0;
    for (int bond = 0; bond < 3; ++bond) {
        const double angle = bond * FW_PI / 3;
        const double share = cos(angle - polarisation);
        sum += 2 * (1 - cos(Q * C * cos(angle - angle_of_wave))) * (K1 + K2 * share * share);
    }
    return sqrt(sum / MASS);
}

/* Verlet's scheme with step h turns it into sin(w h/2) = omega h/2. */
static double verlet_frequency(double omega, double step)
{
    return 2 / step * asin(omega * step / 2);
}

/* Waves along a bond and half-way between two bonds. Verlet's influence goes one bond a step: in
 * the middle of discs of radius 13 nothing is known of their edges after 10 of them. */
#define DISCS                                                                                      \
    "title: waves\nmaterials: {m: {linear-lattice: {k1: 10, k2: 50, mass: 3}}}\n"                  \
    "bodies:\n"                                                                                    \
    "  a: {material: m, lattice: hexagonal, shape: {disc: 13}, spacing: 1.25, origin: [7, 2],\n"   \
    "    displacement: [{by: [0, 0]}, {plane-wave: {amplitude: [.01, 0], wave-vector: [.3, "       \
    "0]}},\n"                                                                                      \
    "      {plane-wave: {amplitude: [.01, .004], wave-vector: [.3, 0]}}]}\n"                       \
    "  b: {material: m, lattice: hexagonal, shape: {disc: 13}, spacing: 1.25, origin: [90, 0],\n"  \
    "    displacement: [{plane-wave: {amplitude: [.003, .01], wave-vector: [0, .3]}}]}\n"

static void waves_of_a_linear_lattice_have_the_speed_of_its_bonds(void **state)
{
    (void)state;
    static const char *const parts[] = {"along", "across"};
    const double step = .06, cell = sqrt(.75) * C * C;
    double speed[2][2];
    begin(DISCS "dynamics: {time-step: .06}\nrun: {steps: 10}\n");
    assert_true(isnan(value_of("wave-speed", 0, "along")));
    run_steps(10);
    for (int body = 0; body < 2; ++body)
        for (int c = 0; c < 2; ++c) {
            const double angle = body == 0 ? 0 : FW_PI / 2;
            const double wanted = verlet_frequency(lattice_frequency(angle, c == 0), step) / Q;
            speed[body][c] = wanted;
            assert_close(value_of("wave-speed", body, parts[c]), wanted, 1e-8);
            assert_close(value_of("wave-modulus", body, parts[c]), MASS / cell * wanted * wanted,
                         1e-6);
        }
    for (int c = 0; c < 2; ++c) {
        const double apart = fabs(speed[0][c] - speed[1][c]);
        assert_true(apart > 1e-4);
        assert_close(value_of("anisotropy", -1, parts[c]), 2 * apart / (speed[0][c] + speed[1][c]),
                     1e-8);
    }
    /* Long waves: mu = sqrt3 (k1 + k2/4) and lambda + 2 mu, but for (q c)^2/24 of dispersion and
     * (w h)^2/12 of Verlet's scheme. */
    assert_close(value_of("wave-modulus", 0, "across"), 38.97114, .03 * 38.97114);
    assert_close(value_of("wave-modulus", 0, "along"), 82.27241, .03 * 82.27241);
    end();
}

/* An oscillator with damping g keeps its omega; the scheme's error is (omega h)^2/24. */
static void damping_does_not_change_the_speed_that_is_told(void **state)
{
    (void)state;
    static const char *const parts[] = {"along", "across"};
    begin(DISCS "dynamics: {time-step: .01, damping: 1.5}\nrun: {steps: 200}\n");
    run_steps(50);
    for (int c = 0; c < 2; ++c) {
        const double wanted = lattice_frequency(0, c == 0) / Q;
        assert_close(value_of("wave-speed", 0, parts[c]), wanted, 1e-3 * wanted);
    }
    assert_true(value_of("anisotropy", -1, "along") > 0);
    /* Nothing is told of a wave beyond the other crest, or higher than it began; nor of all bodies
     * where one of them has no speed. */
    fw_solid *solid = solid_of_body(0);
    const int middle = fw_sites_find(&experiment->bodies[0].sites, (fw_site){0, 0});
    solid->x[middle] = 7 - .02;
    assert_true(isnan(value_of("wave-speed", 0, "along")));
    solid->x[middle] = 7 + .0201;
    assert_true(isnan(value_of("wave-speed", 0, "along")));
    assert_true(isnan(value_of("anisotropy", -1, "along")));
    end();
}

static void a_body_without_a_plane_wave_or_a_middle_has_no_speed(void **state)
{
    (void)state;
    begin("title: none\nmaterials: {m: {linear-lattice: {}}}\n"
          "bodies:\n"
          "  a: {material: m, lattice: hexagonal, shape: {rectangle: [3, 3]},\n"
          "    displacement: [{by: [.1, 0]}]}\n"
          "  b: {material: m, lattice: hexagonal, shape: {sites: [[1, 0], [2, 0], [1, 1]]},\n"
          "    origin: [50, 0],\n"
          "    displacement: [{plane-wave: {amplitude: [.01, 0], wave-vector: [.3, 0]}}]}\n"
          "run: {steps: 1}\n");
    run_steps(1);
    for (int body = 0; body < 2; ++body) {
        assert_true(isnan(value_of("wave-speed", body, "along")));
        assert_true(isnan(value_of("wave-modulus", body, "across")));
    }
    end();
}

/* sin^2(omega/2) = sin^2(k/2)/M with M = 2 where there is no rest mass. */
static void waves_of_a_boltzmann_solid_have_its_closed_form(void **state)
{
    (void)state;
    begin("title: waves\nmaterials: {m: {lattice-boltzmann: {rest-mass: 0}}}\n"
          "bodies: {a: {material: m, shape: {disc: 12}, origin: [7, 2],\n"
          "    displacement: [{plane-wave: {amplitude: [.01, .02], wave-vector: [.3, 0]}}]}}\n"
          "run: {steps: 10}\n");
    run_steps(8);
    const double wanted = 2 * asin(sin(.15) / sqrt(2)) / .3;
    assert_close(value_of("wave-speed", 0, "along"), wanted, 1e-3);
    assert_close(value_of("wave-speed", 0, "across"), wanted, 1e-3);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strain_is_the_mean_gradient_along_each_link),
        cmocka_unit_test(a_row_without_links_across_has_no_strain_along_them),
        cmocka_unit_test(stress_is_half_the_difference_of_what_pulls_both_halves),
        cmocka_unit_test(stress_has_its_halves_wherever_the_sites_begin),
        cmocka_unit_test(stress_over_strain_at_rest_counts_the_parallel_links),
        cmocka_unit_test(a_wave_front_is_where_the_energy_is),
        cmocka_unit_test(a_wave_front_is_seen_from_the_middle_of_any_shape),
        cmocka_unit_test(waves_of_a_linear_lattice_have_the_speed_of_its_bonds),
        cmocka_unit_test(damping_does_not_change_the_speed_that_is_told),
        cmocka_unit_test(a_body_without_a_plane_wave_or_a_middle_has_no_speed),
        cmocka_unit_test(waves_of_a_boltzmann_solid_have_its_closed_form),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
