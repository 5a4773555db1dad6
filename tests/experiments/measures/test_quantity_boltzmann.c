/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_boltzmann.c - links, rest and material of lattice Boltzmann sheets, of the second
 * of two bodies that have nothing in common. */
#include "tests/support/laws.h"

#include "core/boltzmann/lb_dispersion.h"
#include "core/boltzmann/lb_solid.h"
#include "tests/experiments/measures/asked.h"

/* The first body is at rest, large and light; of the second one the start is given. */
static void begin(const char *second)
{
    char text[2048];
    snprintf(text, sizeof text,
             "title: two sheets\n"
             "materials:\n"
             "  light: {lattice-boltzmann: {rest-mass: 0}}\n"
             "  heavy: {lattice-boltzmann: {rest-mass: 3}}\n"
             "  skew: {lattice-boltzmann: {rest-mass: [[2, .5], [.5, 1]]}}\n"
             "bodies:\n"
             "  a: {material: light, shape: {rectangle: [6, 5]}, origin: [40, 3]}\n"
             "  b: {shape: {rectangle: [4, 3]}, spacing: 1.25, origin: [3, 9], %s}\n"
             "run: {steps: 9}\n",
             second);
    observe(text);
}

/* Of the link that begins at site [i, j] of the second body; c: 0 is x, 1 is y. */
static double of_link(const char *name, int i, int j, int c)
{
    double out[FW_COMPONENTS_MAX];
    const fw_sites *sites = &observer->experiment->bodies[1].sites;
    const fw_subject subject = {
        .body = 1, .wall = -1, .particle = fw_sites_find(sites, (fw_site){i, j})};
    fw_quantity_find(name)->measure(observer->experiment, subject, out);
    return out[c];
}

static fw_solid *second_body(void)
{
    return fw_scene_body(observer->experiment->scene, observer->experiment->bodies[1].solid);
}

static void run_steps(int steps)
{
    for (int step = 0; step < steps; ++step) assert_fine(fw_observer_advance(observer, 1, &error));
}

/* --- links --- */

#define UNEVEN                                                                                     \
    "material: skew, velocity: [.02, -.05], displacement:\n"                                       \
    "  [{by: [.1, .2], sites: [[1, 1]]}, {by: [-.03, .05], sites: [[2, 1]]},\n"                    \
    "   {by: [.07, -.02], sites: [[1, 2]]}]"

/* Each link is as long as it is at rest and what it is deformed by, to the east and to the north:
 * at the start and however far the body has moved. */
static void links_are_deformed_by_what_their_ends_are_apart(void **state)
{
    (void)state;
    begin(UNEVEN);
    assert_close(of_link("deformation-east", 1, 1, 0), -.13, 1e-14);
    assert_close(of_link("deformation-east", 1, 1, 1), -.15, 1e-14);
    assert_close(of_link("deformation-north", 1, 1, 0), -.03, 1e-14);
    assert_close(of_link("deformation-north", 1, 1, 1), -.22, 1e-14);
    /* There is nobody in the east of the last column, nor in the north of the last row. */
    assert_close(of_link("deformation-east", 3, 1, 0), 0, 0);
    assert_close(of_link("deformation-north", 1, 2, 1), 0, 0);
    run_steps(7);
    const fw_solid *solid = second_body();
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i) {
            const int here = 4 * j + i, east = here + 1, north = here + 4;
            const double expected[4] = {
                solid->x[east] - solid->x[here] - 1.25, solid->y[east] - solid->y[here],
                solid->x[north] - solid->x[here], solid->y[north] - solid->y[here] - 1.25};
            for (int c = 0; c < 4; ++c)
                assert_close(of_link(c < 2 ? "deformation-east" : "deformation-north", i, j, c % 2),
                             expected[c], 1e-14);
        }
    assert_true(fabs(of_link("deformation-east", 2, 1, 0)) > .01);
    end();
}

/* What is told is the largest that any link is off, along x or along y, to either side. */
static void a_link_error_is_what_places_do_not_fit(void **state)
{
    (void)state;
    begin(UNEVEN);
    run_steps(5);
    assert_below(number("link-error.b"), 1e-14);
    assert_close(number("link-error.a"), 0, 1e-14);
    fw_solid *solid = second_body();
    solid->x[5] += .25;
    assert_close(number("link-error.b"), .25, 1e-13);
    solid->y[8] -= .375; /* a corner: one link in the east, one in the south */
    assert_close(number("link-error.b"), .375, 1e-13);
    solid->x[6] -= .1875; /* beside the first: a link between both is off by the sum */
    assert_close(number("link-error.b"), .4375, 1e-13);
    assert_close(number("link-error.a"), 0, 1e-14);
    end();
}

/* A site inside has four links, a corner two; those of the first body are not stretched enough. */
static void broken_links_are_those_that_were_stretched_too_far(void **state)
{
    (void)state;
    const char *text =
        "title: a sheet breaks\n"
        "materials: {m: {lattice-boltzmann: {rest-mass: 6, break-at: .3}}}\n"
        "bodies:\n"
        "  a: {material: m, shape: {rectangle: [3, 3]},\n"
        "    displacement: [{by: [.2, 0], sites: [[1, 1]]}]}\n"
        "  b: {material: m, shape: {rectangle: [4, 3]}, origin: [20, 1], displacement:\n"
        "    [{by: [.45, 0], sites: [[1, 1]]}, {by: [0, -.5], sites: [[3, 2]]}]}\n"
        "run: {steps: 3}\n";
    observe(text);
    assert_close(number("broken-links.b"), 0, 0);
    run_steps(1);
    assert_close(number("broken-links.b"), 4 + 2, 0);
    assert_close(number("broken-links.a"), 0, 0);
    end();
}

/* --- rest --- */

static void stop_with_forces(bool along_y_too)
{
    fw_solid *solid = second_body();
    for (int p = 0; p < solid->count; ++p) {
        const fw_vec2 psi = fw_lb_solid_psi(solid, p);
        solid->external_x[p] = -2 * psi.x;
        solid->external_y[p] = along_y_too ? -2 * psi.y : 0;
    }
}

/* A body that moves with V has f_0 = M0 V/2, all other f = V/2 and, where n links meet, the
 * momentum M V, M = (M0^2 + n)/2. Forces of -2 M V leave what is in the fields. */
static void what_moves_is_not_at_rest(void **state)
{
    (void)state;
    begin("material: heavy, velocity: [.02, -.05]");
    assert_close(number("rest-residual.a"), 0, 0);
    assert_close(number("rest-residual.b"), (9 + 4) / 2. * .05, 1e-14);
    stop_with_forces(true);
    assert_close(number("rest-residual.b"), 1.5 * .05, 1e-14);
    end();
    begin("material: light, velocity: [-.07, .03]");
    assert_close(number("rest-residual.b"), 4 / 2. * .07, 1e-14);
    stop_with_forces(false);
    assert_close(number("rest-residual.b"), .07, 1e-14); /* both fields of a link */
    second_body()->external_x[7] += .6;
    assert_close(number("rest-residual.b"), .3, 1e-14);
    end();
}

/* A link that is stretched at rest has opposite fields at its ends: they add up to nothing, while
 * they pull its ends with what is the outer force at rest. */
static void what_is_pulled_and_damped_comes_to_rest(void **state)
{
    (void)state;
    const char *text = "title: a chain\n"
                       "materials: {m: {lattice-boltzmann: {rest-mass: .5, damping: .2}}}\n"
                       "bodies:\n"
                       "  a: {material: m, shape: {rectangle: [2, 1]}, velocity: [.3, .1]}\n"
                       "  b: {material: m, shape: {rectangle: [3, 1]}, origin: [20, 1]}\n"
                       "forces:\n"
                       "  west: {body: b, sites: left, force: [-.1, .03]}\n"
                       "  east: {body: b, sites: right, force: [.1, -.03]}\n"
                       "run: {steps: 300}\n";
    observe(text);
    run_steps(3);
    assert_true(number("rest-residual.b") > 1e-3);
    run_steps(297);
    assert_below(number("rest-residual.b"), 1e-12);
    for (int i = 0; i < 2; ++i) {
        assert_close(of_link("deformation-east", i, 0, 0), .1, 1e-12);
        assert_close(of_link("deformation-east", i, 0, 1), -.03, 1e-12);
    }
    end();
}

/* --- material --- */

/* Both are rounding, and those of the body's own material. */
static void a_spectrum_is_that_of_the_material(void **state)
{
    (void)state;
    begin("material: skew");
    fw_lb_spectrum skew, light;
    assert_fine(fw_lb_spectrum_over_grid((fw_sym2){2, .5, 1}, 33, &skew, &error));
    assert_fine(fw_lb_spectrum_over_grid((fw_sym2){0, 0, 0}, 33, &light, &error));
    assert_below(skew.frequency_error, 1e-13);
    assert_below(skew.radius_error, 1e-13);
    assert_close(number("dispersion-error.b"), skew.frequency_error, 0);
    assert_close(number("spectral-radius-error.b"), skew.radius_error, 0);
    assert_close(number("dispersion-error.a"), light.frequency_error, 0);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(links_are_deformed_by_what_their_ends_are_apart),
        cmocka_unit_test(a_link_error_is_what_places_do_not_fit),
        cmocka_unit_test(broken_links_are_those_that_were_stretched_too_far),
        cmocka_unit_test(what_moves_is_not_at_rest),
        cmocka_unit_test(what_is_pulled_and_damped_comes_to_rest),
        cmocka_unit_test(a_spectrum_is_that_of_the_material),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
