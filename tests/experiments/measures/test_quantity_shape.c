/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_shape.c - shape, deformation, torque, order and density of bodies whose numbers are
 * known in closed form. */
#include "tests/support/laws.h"

#include "core/particles/langevin.h"
#include "core/particles/particles.h"
#include "experiments/measures/quantity.h"
#include "tests/support/scenarios.h"

static fw_scenario *scenario;
static fw_experiment *experiment;

static void begin(const char *text)
{
    scenario = read_right(text);
    experiment = build_right(scenario);
}

static void end(void)
{
    fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
}

/* body -1: of the scene. */
static double value_of(const char *name, int body, const char *component)
{
    double out[FW_COMPONENTS_MAX];
    const fw_quantity *quantity = fw_quantity_find(name);
    assert_non_null(quantity);
    quantity->measure(experiment, (fw_subject){.body = body, .wall = -1, .particle = -1}, out);
    const int c = component ? fw_quantity_find_component(quantity, component) : 0;
    assert_true(c >= 0);
    return out[c];
}

static fw_langevin *motion(void)
{
    return (fw_langevin *)fw_experiment_solid(experiment, 0);
}

static void move(int particle, double x, double y)
{
    motion()->head.x[particle] += x;
    motion()->head.y[particle] += y;
}

#define CRYSTAL "materials: {m: {movable-particles: {return-force: {amplitude: 2, axes: lab}}}}\n"

/* --- extent --- */

static void extent_is_that_of_bodies_and_of_the_scene(void **state)
{
    (void)state;
    begin("title: two\n" CRYSTAL "bodies:\n"
          "  a: {material: m, shape: {rectangle: [5, 3]}, spacing: 1.1}\n"
          "  b: {material: m, shape: {rectangle: [2, 4]}, origin: [10, -2]}\n"
          "run: {steps: 1}\n");
    assert_close(value_of("extent", 0, "x"), 4.4, 1e-14);
    assert_close(value_of("extent", 0, "y"), 2.2, 1e-14);
    assert_close(value_of("extent", 1, "y"), 3, 1e-14);
    assert_close(value_of("extent", -1, "x"), 11, 1e-14);
    assert_close(value_of("extent", -1, "y"), 4.2, 1e-14);
    end();
}

/* Eq 23: stretched by a factor it is that factor; what has come off does not count. */
static void relative_extent_is_that_of_the_largest_cluster(void **state)
{
    (void)state;
    begin("title: one\n" CRYSTAL
          "bodies: {a: {material: m, shape: {rectangle: [6, 4]}, origin: [3, 1]}}\n"
          "run: {steps: 1}\n");
    assert_close(value_of("relative-extent", 0, "x"), 1, 0);
    fw_solid *solid = &motion()->head;
    for (int i = 0; i < solid->count; ++i) {
        solid->x[i] *= 1.3;
        solid->y[i] *= .9;
    }
    assert_close(value_of("relative-extent", 0, "x"), 1.3, 1e-14);
    assert_close(value_of("relative-extent", 0, "y"), .9, 1e-14);
    assert_close(value_of("largest-cluster", 0, NULL), 24, 0);
    for (int row = 0; row < 4; ++row) move(6 * row + 5, 1, 0); /* the last column: 2.3 away */
    assert_close(value_of("relative-extent", 0, "x"), 1.3 * 4 / 5, 1e-14);
    assert_close(value_of("extent", 0, "x"), 1.3 * 5 + 1, 1e-14);
    assert_close(value_of("largest-cluster", 0, NULL), 20, 0);
    assert_close(value_of("largest-cluster", -1, NULL), 20, 0);
    end();
}

/* The second body is stretched and sheared, the first one rests beside it in the same solid. */
static void each_body_has_its_own_shape(void **state)
{
    (void)state;
    begin("title: two\n" CRYSTAL "bodies:\n"
          "  a: {material: m, shape: {rectangle: [4, 3]}}\n"
          "  b: {material: m, shape: {rectangle: [6, 4]}, origin: [20, 1]}\n"
          "run: {steps: 1}\n");
    fw_solid *solid = &motion()->head;
    for (int i = 12; i < 36; ++i) {
        motion()->velocity_x[i] = .3 * solid->y[i];
        solid->x[i] = 20 + 1.3 * (solid->x[i] - 20);
        solid->y[i] = 1 + .9 * (solid->y[i] - 1);
        motion()->velocity_y[i] = -.2 * solid->y[i];
    }
    const double x[] = {3, 1.3 * 5}, y[] = {2, .9 * 3}, stretch[] = {1.3, .9};
    for (int b = 0; b < 2; ++b) {
        assert_close(value_of("extent", b, "x"), x[b], 1e-13);
        assert_close(value_of("extent", b, "y"), y[b], 1e-13);
        assert_close(value_of("relative-extent", b, "x"), b ? stretch[0] : 1, 1e-13);
        assert_close(value_of("relative-extent", b, "y"), b ? stretch[1] : 1, 1e-13);
        assert_close(value_of("largest-cluster", b, NULL), b ? 24 : 12, 0);
        assert_close(value_of("deformation-rate", b, "xx"), 0, 1e-13);
        assert_close(value_of("deformation-rate", b, "xy"), b ? .3 / .9 : 0, 1e-13);
        assert_close(value_of("deformation-rate", b, "yx"), 0, 1e-13);
        assert_close(value_of("deformation-rate", b, "yy"), b ? -.2 : 0, 1e-13);
    }
    /* Of the 38 bonds of 6 x 4, 20 along x became 1.3 long: lost by (1.3 - 1.25)/.375. */
    assert_close(value_of("lost-bonds", 0, NULL), 0, 0);
    assert_close(value_of("lost-bonds", 1, NULL), 20. / 38 * (.05 / .375), 1e-13);
    end();
}

/* --- deformation --- */

/* Also of a body that lies askew: its x and y go together. */
static void deformation_rate_is_the_gradient_of_the_velocity(void **state)
{
    (void)state;
    const double gradient[] = {.3, -.2, .7, .5};
    static const char *const names[] = {"xx", "xy", "yx", "yy"};
    static const char *const shapes[] = {"{disc: 4}", "{rectangle: [7, 2]}"};
    for (int n = 0; n < 2; ++n) {
        char text[512];
        snprintf(text, sizeof text,
                 "title: one\n" CRYSTAL "bodies: {a: {material: m, shape: %s, lattice: hexagonal, "
                 "angle: 17, origin: [3, 1]}}\nrun: {steps: 1}\n",
                 shapes[n]);
        begin(text);
        const fw_solid *solid = &motion()->head;
        for (int i = 0; i < solid->count; ++i) {
            motion()->velocity_x[i] = 9 + gradient[0] * solid->x[i] + gradient[1] * solid->y[i];
            motion()->velocity_y[i] = 7 + gradient[2] * solid->x[i] + gradient[3] * solid->y[i];
        }
        for (int c = 0; c < 4; ++c)
            assert_close(value_of("deformation-rate", 0, names[c]), gradient[c], 1e-13);
        end();
    }
    begin("title: a line\n" CRYSTAL
          "bodies: {a: {material: m, shape: {rectangle: [4, 1]}, angle: 30}}\n"
          "run: {steps: 1}\n");
    assert_true(isnan(value_of("deformation-rate", 0, "xx")));
    end();
}

/* Displacements from the lattice, as they were given; of the inner half, askew too. */
static void affine_strain_is_the_gradient_of_the_displacements(void **state)
{
    (void)state;
    const double gradient[] = {.01, -.02, .03, .005};
    static const char *const names[] = {"xx", "xy", "yx", "yy"};
    begin("title: one\n" CRYSTAL
          "bodies: {a: {material: m, shape: {rectangle: [9, 6]}, lattice: hexagonal, angle: 17, "
          "origin: [3, 1], displacement: [{gradient: [.01, -.02, .03, .005]}]}}\n"
          "run: {steps: 1}\n");
    for (int c = 0; c < 4; ++c)
        assert_close(value_of("affine-strain", 0, names[c]), gradient[c], 1e-13);
    assert_close(value_of("poisson-ratio", 0, "x"), -.005 / .01, 1e-11);
    assert_close(value_of("poisson-ratio", 0, "y"), -.01 / .005, 1e-11);
    end();
}

/* A 3 x 2 square has 7 bonds. Its right column goes away: two of them are lost by degrees, from
 * 1.25 to 1.625, and the rate is that of the loss. */
static void bonds_are_lost_while_their_length_grows(void **state)
{
    (void)state;
    begin("title: one\n" CRYSTAL
          "bodies: {a: {material: m, shape: {rectangle: [3, 2]}}}\nrun: {steps: 1}\n");
    const double lengths[] = {1.2, 1.25 + .25 * .375, 1.25 + .75 * .375, 1.7, 3};
    const double lost[] = {0, .25, .75, 1, 1};
    for (int row = 0; row < 2; ++row) motion()->velocity_x[3 * row + 2] = .4;
    for (int n = 0; n < 5; ++n) {
        for (int row = 0; row < 2; ++row) motion()->head.x[3 * row + 2] = 1 + lengths[n];
        assert_close(value_of("lost-bonds", 0, NULL), 2 * lost[n] / 7, 1e-14);
        assert_close(value_of("plastic-rate", 0, NULL),
                     lost[n] > 0 && lost[n] < 1 ? 2 * .4 / .375 / 7 : 0, 1e-14);
    }
    end();
    begin("title: one\n" CRYSTAL "bodies: {a: {material: m, shape: {sites: [[0, 0]]}}}\n"
          "run: {steps: 1}\n");
    assert_true(isnan(value_of("lost-bonds", 0, NULL)));
    end();
}

/* --- torque --- */

/* Bonds at an angle a to their axes: each is turned back by f0 r0 sin(6 a), and the potential turns
 * nothing. 7 bonds of the rhombus of 2 x 3, 1 in a row of two. A force at a corner adds its own. */
static void torque_is_that_of_return_forces_and_loads(void **state)
{
    (void)state;
    begin(
        "title: turned\n"
        "materials: {m: {movable-particles: {return-force: {amplitude: 2, axes: lab, angle: 0}}}}\n"
        "bodies: {a: {material: m, lattice: hexagonal, angle: 4, origin: [50, 9],\n"
        "  shape: {sites: [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1]]}}}\n"
        "run: {steps: 1}\n");
    const double bonds = 7, angle = 4 * acos(-1) / 180;
    assert_close(value_of("torque", 0, NULL), -bonds * 2 * sin(6 * angle), 1e-12);
    end();
    begin("title: loaded\n"
          "materials: {m: {linear-lattice: {}}}\n"
          "bodies: {a: {material: m, lattice: hexagonal, shape: {rectangle: [2, 1]}}}\n"
          "forces: {up: {body: a, sites: [[1, 0]], force: [0.7, 0.3]}}\n"
          "run: {steps: 1}\n");
    assert_fine(fw_experiment_step(experiment, &error));
    assert_close(value_of("torque", 0, NULL), .3 * .5, 1e-4);
    end();
}

/* --- order and density --- */

static void order_of_any_symmetry_in_any_body(void **state)
{
    (void)state;
    begin("title: a square and a row\n"
          "materials: {l: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies:\n"
          "  square: {material: l, shape: {rectangle: [2, 2]}, spacing: 3}\n"
          "  row: {material: l, shape: {rectangle: [3, 1]}, origin: [60, 30]}\n"
          "run: {steps: 1}\n");
    /* Two bonds at a right angle: |1 + i^n|/2. */
    assert_close(value_of("bond-order", 0, "psi2"), 0, 1e-14);
    assert_close(value_of("bond-order", 0, "psi3"), sqrt(.5), 1e-14);
    assert_close(value_of("bond-order", 0, "psi4"), 1, 1e-14);
    assert_close(value_of("bond-order", 0, "psi6"), 0, 1e-14);
    assert_close(value_of("bond-order", 0, "psi12"), 1, 1e-14);
    /* A row: the middle one has opposite bonds, the others one each. */
    assert_close(value_of("bond-order", 1, "psi2"), 1, 1e-14);
    assert_close(value_of("bond-order", 1, "psi3"), 2. / 3, 1e-14);
    assert_close(value_of("bond-order", -1, "psi3"), (4 * sqrt(.5) + 2) / 7, 1e-14);
    end();
    begin("title: turned\n"
          "materials: {m: {movable-particles: {}}}\n"
          "bodies: {a: {material: m, lattice: hexagonal, angle: 11, shape: {disc: 6}}}\n"
          "run: {steps: 1}\n");
    assert_close(value_of("bond-order", 0, "psi6"), 1, 1e-13);
    assert_close(value_of("bond-order", 0, "psi12"), 1, 1e-13);
    assert_below(value_of("bond-order", 0, "psi4"), .5);
    end();
}

/* Two that are 1 apart, and one far away: 1 + 1/e, 1 + 1/e, 1. */
static void density_has_mean_spread_and_maximum(void **state)
{
    (void)state;
    begin("title: three\n"
          "materials: {m: {movable-particles: {}}}\n"
          "bodies:\n"
          "  a: {material: m, shape: {rectangle: [2, 1]}}\n"
          "  b: {material: m, shape: {sites: [[0, 0]]}, origin: [9, 0]}\n"
          "run: {steps: 1}\n");
    const double e = exp(-1);
    assert_close(value_of("gaussian-density", -1, "mean"), 1 + 2 * e / 3, 1e-14);
    assert_close(value_of("gaussian-density", -1, "spread"), e * sqrt(2) / 3, 1e-14);
    assert_close(value_of("gaussian-density", -1, "maximum"), 1 + e, 1e-14);
    assert_close(value_of("gaussian-density", 0, "mean"), 1 + e, 1e-14);
    assert_close(value_of("gaussian-density", 0, "spread"), 0, 1e-14);
    assert_close(value_of("gaussian-density", 1, "maximum"), 1, 1e-14);
    const fw_solid *solid = &motion()->head;
    double values[3];
    fw_solid_find_field(solid, "gaussian-density")->fill(solid, values);
    assert_close(values[1], 1 + e, 1e-14);
    assert_close(values[2], 1, 1e-14);
    fw_solid_find_field(solid, "order-4")->fill(solid, values);
    assert_close(values[0], 1, 1e-14);
    assert_close(values[2], 0, 0);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extent_is_that_of_bodies_and_of_the_scene),
        cmocka_unit_test(relative_extent_is_that_of_the_largest_cluster),
        cmocka_unit_test(each_body_has_its_own_shape),
        cmocka_unit_test(deformation_rate_is_the_gradient_of_the_velocity),
        cmocka_unit_test(affine_strain_is_the_gradient_of_the_displacements),
        cmocka_unit_test(bonds_are_lost_while_their_length_grows),
        cmocka_unit_test(torque_is_that_of_return_forces_and_loads),
        cmocka_unit_test(order_of_any_symmetry_in_any_body),
        cmocka_unit_test(density_has_mean_spread_and_maximum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
