/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_particle_scenes.c - movable particles and linear lattices in scenario files: what is read,
 * how bodies share a solid, what is measured of them, and means over seeds. */
#include "tests/support/laws.h"

#include "core/particles/particles.h"
#include "experiments/measures/verdict.h"
#include "experiments/setup/body_range.h"
#include "experiments/setup/solids.h"
#include "experiments/study/run.h"
#include "experiments/study/study.h"
#include "tests/support/scenarios.h"

#define PLAIN "movable-particles: {}"

/* The body's number of a quantity, -1: of the scene. */
static void measure(const fw_experiment *experiment, const char *name, int body, double *out)
{
    const fw_quantity *quantity = fw_quantity_find(name);
    assert_non_null(quantity);
    quantity->measure(experiment, (fw_subject){.body = body, .wall = -1, .particle = -1}, out);
}

static double number(const fw_experiment *experiment, const char *name, int body)
{
    double out[FW_COMPONENTS_MAX];
    measure(experiment, name, body, out);
    return out[0];
}

/* --- what is read --- */

static void materials_are_what_was_written(void **state)
{
    (void)state;
    fw_scenario *s = read_right(
        "title: t\n"
        "materials:\n"
        "  plain: {movable-particles: {}}\n"
        "  rich: {movable-particles: {potential: {morse: {depth: 2, distance: 1.1, steepness: 5,"
        " cut: [1.5, 2]}}, mass: 3, strength: 0.7, return-force: {symmetry: 4, amplitude: 0.6,"
        " variant: constant, axes: surface, angle: 90, reach: [1.3, 1.5]}}}\n"
        "  net: {linear-lattice: {k1: 7, k2: 30, compensated: false, mass: 2}}\n"
        "bodies:\n"
        "  one: {material: rich, shape: {rectangle: [2, 2]}, spacing: 1.1, spin: 0.5,"
        " temperature: 0.25}\n"
        "dynamics: {time-step: 0.01, damping: 2, temperature: 0.3, strength-across: 0.4,"
        " bond-radius: 1.4, overlap-energy: 50}\n"
        "run: {steps: 1}\n");
    const fw_scenario_particles *plain = &s->materials[0].particles;
    assert_int_equal(s->materials[0].kind, FW_MOVABLE_PARTICLES);
    assert_int_equal(plain->potential.kind, FW_LENNARD_JONES);
    assert_true(plain->potential.depth == 1 && plain->potential.distance == 1);
    assert_true(plain->potential.cut.inner == 1.4 && plain->potential.cut.outer == 1.7);
    assert_true(plain->return_force.amplitude == 0 && plain->mass == 1 && plain->strength == 1);
    const fw_scenario_particles *rich = &s->materials[1].particles;
    assert_int_equal(rich->potential.kind, FW_MORSE);
    assert_true(rich->potential.depth == 2 && rich->potential.steepness == 5);
    assert_close(rich->potential.cut.scale, 2, 1e-15);
    assert_int_equal(rich->return_force.fold, 4);
    assert_int_equal(rich->return_force.variant, FW_RETURN_CONSTANT);
    assert_int_equal(rich->return_force.axes, FW_AXES_SURFACE);
    assert_true(rich->return_force.amplitude == 0.6 && rich->return_force.distance == 1.1);
    assert_close(rich->return_force.angle, FW_PI / 2, 1e-15);
    assert_close(rich->return_force.cut.scale, 5, 1e-14);
    assert_true(rich->mass == 3 && rich->strength == 0.7);
    const fw_scenario_linear *net = &s->materials[2].linear;
    assert_int_equal(s->materials[2].kind, FW_LINEAR_LATTICE);
    assert_true(net->k1 == 7 && net->k2 == 30 && net->mass == 2 && !net->compensated);
    assert_true(s->bodies[0].spin == 0.5 && s->bodies[0].temperature == 0.25);
    const fw_scenario_dynamics *d = &s->dynamics;
    assert_true(d->time_step == 0.01 && d->damping == 2 && d->temperature == 0.3);
    assert_true(d->strength_across == 0.4 && d->bond_radius == 1.4 && d->overlap_energy == 50);
    fw_scenario_destroy(s);
}

static void defaults_are_those_of_the_papers_figures(void **state)
{
    (void)state;
    fw_scenario *s =
        read_right("title: t\n"
                   "materials: {m: {movable-particles: {return-force: {amplitude: 1}}}}\n"
                   "bodies: {b: {material: m, shape: {rectangle: [2, 2]}}}\n"
                   "run: {steps: 1}\n");
    assert_true(s->dynamics.time_step == 0.005 && s->dynamics.damping == 0);
    assert_true(s->dynamics.strength_across == 1 && s->dynamics.bond_radius == 1.25);
    const fw_return_force *force = &s->materials[0].particles.return_force;
    assert_int_equal(force->fold, 6);
    assert_int_equal(force->variant, FW_RETURN_CONSERVATIVE);
    assert_int_equal(force->axes, FW_AXES_COROTATING);
    assert_true(force->cut.inner == 1.2 && force->cut.outer == 1.4);
    fw_scenario_destroy(s);
}

/* --- bodies in one solid --- */

static const char three[] =
    "title: t\n"
    "materials:\n"
    "  light: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}\n"
    "  heavy: {movable-particles: {mass: 2.5}}\n"
    "  net: {linear-lattice: {}}\n"
    "bodies:\n"
    "  a: {material: light, lattice: hexagonal, shape: {rectangle: [4, 3]}, velocity: [0.3, 0.1]}\n"
    "  n: {material: net, lattice: hexagonal, shape: {disc: 2}, origin: [-20, 0]}\n"
    "  b: {material: heavy, lattice: hexagonal, angle: 30, shape: {rectangle: [3, 3]},"
    " origin: [5, 0.3], velocity: [-0.2, 0]}\n"
    "  gas: {material: heavy, shape: {placed: {count: 40, box: [0, 0, 20, 20]}}, origin: [20, 20],"
    " temperature: 0.5}\n"
    "run: {steps: 200, seed: 5}\n";

static void movable_bodies_share_one_solid(void **state)
{
    (void)state;
    fw_scenario *s = read_right(three);
    fw_experiment *e = build_right(s);
    const fw_body_range *m = e->bodies;
    assert_int_equal(fw_scene_body_count(e->scene), 2);
    assert_int_equal(m[0].solid, m[2].solid);
    assert_int_equal(m[0].solid, m[3].solid);
    assert_true(m[1].solid != m[0].solid);
    assert_int_equal(m[0].first, 0);
    assert_int_equal(m[2].first, 12);
    assert_int_equal(m[3].first, 21);
    assert_int_equal(m[3].count, 40);
    const fw_solid *solid = fw_experiment_solid(e, 0);
    assert_int_equal(solid->count, 61);
    assert_int_equal(solid->boundary_count, 61);
    /* Axes of a body follow its lattice by default. */
    assert_close(fw_particles_group(solid, 1)->return_force.angle, FW_PI / 6, 1e-15);
    /* Of each body what its own particles have; of all together what the solid has. */
    assert_close(fw_body_range_mass(e->scene, &e->bodies[2]).xx, 9 * 2.5, 1e-12);
    assert_close(fw_body_range_momentum(e->scene, &e->bodies[0]).x, 12 * 0.3, 1e-12);
    assert_close(fw_body_range_momentum(e->scene, &e->bodies[2]).x, -9 * 2.5 * 0.2, 1e-12);
    assert_close(fw_body_range_momentum(e->scene, &e->bodies[3]).x, 0, 1e-12);
    assert_close(fw_body_range_centre_of_mass(e->scene, &e->bodies[0]).y, 0.5 * sqrt(3), 1e-12);
    double kinetic = 0, elastic = 0;
    for (int b = 0; b < 4; ++b)
        if (b != 1) {
            kinetic += fw_body_range_energies(e->scene, &e->bodies[b]).kinetic;
            elastic += fw_body_range_energies(e->scene, &e->bodies[b]).elastic;
        }
    assert_close(kinetic, fw_solid_energies(solid).kinetic, 1e-12 * kinetic);
    assert_close(elastic, fw_solid_energies(solid).elastic, 1e-12 * fabs(elastic));
    /* They do feel each other: nobody acts on them from outside, yet momentum passes over. */
    const fw_vec2 before = fw_body_range_momentum(e->scene, &e->bodies[0]);
    for (int t = 0; t < 200; ++t) assert_fine(fw_experiment_step(e, &error));
    assert_true(fabs(fw_body_range_momentum(e->scene, &e->bodies[0]).x - before.x) > 0.01);
    assert_close(number(e, "momentum-error", 0), 0, 1e-11);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

/* Dropped uniformly in the box seen from the origin, none too near; other seeds, other places. */
static void placed_particles_keep_their_distance(void **state)
{
    (void)state;
    fw_scenario *s = read_right(three);
    fw_experiment *e = build_right(s);
    const fw_solid *solid = fw_experiment_solid(e, 3);
    for (int i = 21; i < 61; ++i) {
        assert_true(solid->x[i] >= 20 && solid->x[i] < 40 && solid->y[i] >= 20 && solid->y[i] < 40);
        for (int j = 21; j < i; ++j)
            assert_true(hypot(solid->x[i] - solid->x[j], solid->y[i] - solid->y[j]) >= 0.75);
    }
    const char *const other[] = {"run.seed=6"};
    fw_scenario *s2;
    assert_fine(fw_scenario_read(&s2, "t.yaml", three, strlen(three), other, 1, &error));
    fw_experiment *e2 = build_right(s2);
    assert_true(fw_experiment_solid(e2, 3)->x[21] != solid->x[21]);
    fw_experiment_destroy(e2);
    fw_scenario_destroy(s2);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

static void bodies_start_as_told(void **state)
{
    (void)state;
    fw_scenario *s = read_right(
        "title: t\n"
        "materials: {m: {movable-particles: {mass: 2}}, l: {linear-lattice: {}}}\n"
        "bodies:\n"
        "  hot: {material: m, shape: {rectangle: [40, 40]}, spacing: 2, temperature: 0.7,"
        " velocity: [1, -2]}\n"
        "  wheel: {material: l, lattice: hexagonal, shape: {disc: 4}, origin: [-30, 5], spin: 0.2,"
        " velocity: [0, 1]}\n"
        "  strained: {material: l, lattice: hexagonal, shape: {rectangle: [12, 13]},"
        " origin: [-90, 0], displacement: [{gradient: [0.01, 0.02, -0.03, 0.04]}]}\n"
        "run: {steps: 1}\n");
    fw_experiment *e = build_right(s);
    /* 1600 particles: the temperature of a sample is off by 1/40 in the mean. */
    assert_close(number(e, "temperature", 0), 0.7, 0.7 * 4 / 40.);
    assert_close(number(e, "momentum", 0), 2 * 1600, 1e-9);
    double out[4];
    measure(e, "temperature-along", 0, out);
    assert_close(0.5 * (out[0] + out[1]), number(e, "temperature", 0), 1e-14);
    measure(e, "affine-strain", 2, out);
    assert_close(out[0], 0.01, 1e-12);
    assert_close(out[1], 0.02, 1e-12);
    assert_close(out[2], -0.03, 1e-12);
    assert_close(out[3], 0.04, 1e-12);
    measure(e, "poisson-ratio", 2, out);
    assert_close(out[0], -4, 1e-9);
    assert_close(out[1], -0.25, 1e-10);
    /* Spin about its own middle: L about the origin has the orbit's part too. */
    const fw_solid *wheel = fw_experiment_solid(e, 1);
    double inertia = 0;
    for (int i = 0; i < wheel->count; ++i)
        inertia += pow(wheel->x[i] + 30, 2) + pow(wheel->y[i] - 5, 2);
    assert_close(number(e, "angular-momentum", 1), 0.2 * inertia - 30 * wheel->count, 1e-9);
    assert_close(number(e, "rotation", 1), 0, 1e-12);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

/* Turned by hand, a body is measured as turned; spread by hand, as spread. */
static void motion_is_measured_from_the_start(void **state)
{
    (void)state;
    fw_scenario *s = read_right("title: t\n"
                                "materials: {m: {movable-particles: {}}}\n"
                                "bodies: {b: {material: m, lattice: hexagonal, shape: {disc: 3},"
                                " origin: [7, -4]}}\n"
                                "run: {steps: 1}\n");
    fw_experiment *e = build_right(s);
    fw_solid *solid = fw_scene_body(e->scene, 0);
    const double degree = FW_PI / 180, c = cos(130 * degree), sn = sin(130 * degree);
    double square = 0;
    for (int i = 0; i < solid->count; ++i) {
        const double x = solid->x[i] - 7, y = solid->y[i] + 4;
        solid->x[i] = 1 + c * x - sn * y;
        solid->y[i] = 2 + sn * x + c * y;
        square += pow(solid->x[i] - x - 7, 2) + pow(solid->y[i] - y + 4, 2);
    }
    assert_close(number(e, "rotation", 0), 130, 1e-10);
    assert_close(number(e, "mean-square-displacement", 0), square / solid->count, 1e-10);
    assert_close(number(e, "largest-cluster", -1), solid->count, 0);
    solid->x[0] += 50;
    assert_close(number(e, "largest-cluster", -1), solid->count - 1, 0);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

/* Order of a perfect crystal is 1 by every measure, and the return force vanishes inside. */
static void order_of_a_crystal_is_perfect(void **state)
{
    (void)state;
    fw_scenario *s =
        read_right("title: t\n"
                   "materials: {m: {movable-particles: {return-force: {symmetry: 6, amplitude: 2,"
                   " axes: lab}}}}\n"
                   "bodies: {b: {material: m, lattice: hexagonal, shape: {disc: 5}, angle: 17}}\n"
                   "run: {steps: 1}\n");
    fw_experiment *e = build_right(s);
    assert_close(number(e, "lab-order", 0), 1, 1e-12);
    assert_close(number(e, "local-order", -1), 1, 1e-12);
    assert_close(number(e, "bragg-peak", 0), 1, 1e-9);
    assert_close(number(e, "return-force", 0), 0, 1e-12);
    assert_true(number(e, "coordination", 0) > 4 && number(e, "coordination", 0) < 6);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

/* Without damping every particle runs back the way it came (rounding grows, so not for long). */
static void particles_run_back(void **state)
{
    (void)state;
    fw_scenario *s =
        read_right("title: t\n"
                   "materials: {m: {movable-particles: {return-force: {amplitude: 1}}}}\n"
                   "bodies: {b: {material: m, lattice: hexagonal, shape: {disc: 3},"
                   " temperature: 0.05, velocity: [0.4, 0.3]}}\n"
                   "walls: {box: {box: [-6, -6, 6, 6]}}\n"
                   "run: {steps: 2000, reverse-at: 1000}\n");
    fw_experiment *e = build_right(s);
    for (int t = 0; t < 1000; ++t) assert_fine(fw_experiment_step(e, &error));
    assert_true(number(e, "return-error", 0) > 1);
    for (int t = 0; t < 1000; ++t) assert_fine(fw_experiment_step(e, &error));
    assert_below(number(e, "return-error", 0), 1e-9);
    fw_experiment_destroy(e);
    fw_scenario_destroy(s);
}

/* --- means and their errors --- */

static const char noisy[] =
    "title: t\n"
    "materials: {m: {movable-particles: {strength: 0}}}\n"
    "bodies: {b: {material: m, shape: {rectangle: [5, 5]}, spacing: 3, temperature: 1}}\n"
    "dynamics: {time-step: 0.02, damping: 1, temperature: 1}\n"
    "run: {steps: 500, measure-every: 5, seed: 7}\n"
    "measure: [temperature]\n"
    "expect:\n"
    "  - {quantity: temperature, statistic: mean, value: 1, within: 0.2}\n"
    "  - {quantity: temperature, at: 500, value: 1, within: 0.5}\n";

static fw_study *run_study(const fw_scenario *scenario, const char *folder, int at_once)
{
    fw_study *study;
    const fw_run_options options = {
        .directory = folder, .threads = 1, .at_once = at_once, .name = "test"};
    assert_fine(fw_study_begin(&study, scenario, &options, &error));
    assert_fine(fw_study_to_end(study, &error));
    return study;
}

/* Judged is the mean of what single runs with these seeds show, to the last bit, however many run
 * at a time; its error is their spread over the root of their number. */
static void study_judges_the_mean_of_its_seeds(void **state)
{
    (void)state;
    double single[3][2];
    for (int n = 0; n < 3; ++n) {
        char seed[32];
        snprintf(seed, sizeof seed, "run.seed=%d", 7 + n);
        const char *const settings[] = {seed};
        fw_scenario *s;
        assert_fine(fw_scenario_read(&s, "t.yaml", noisy, strlen(noisy), settings, 1, &error));
        fw_study *alone = run_study(s, NULL, 1);
        for (int k = 0; k < 2; ++k) {
            const fw_verdict v = fw_verdict_of(s, fw_study_measurement(alone), k);
            single[n][k] = v.measured;
            assert_int_equal(v.seeds, 1);
            /* A mean over time knows its error by its samples' correlation: 25 particles, time 10,
             * velocities that last 1, their squares 1/2: 1/sqrt(25 * 10) or so. */
            if (k == 0) assert_true(v.error > 0.02 && v.error < 0.2);
            if (k == 1) assert_true(isnan(v.error));
        }
        fw_study_destroy(alone);
        fw_scenario_destroy(s);
    }
    char folder[64], path[96], line[512] = "";
    make_folder(folder, sizeof folder);
    for (int at_once = 1; at_once <= 2; ++at_once) {
        const char *const settings[] = {"study={seeds: 3}"};
        fw_scenario *s;
        snprintf(path, sizeof path, "%s/at-once-%d", folder, at_once);
        assert_fine(fw_scenario_read(&s, "t.yaml", noisy, strlen(noisy), settings, 1, &error));
        fw_study *study = run_study(s, path, at_once);
        for (int k = 0; k < 2; ++k) {
            const fw_verdict v = fw_verdict_of(s, fw_study_measurement(study), k);
            const double a = single[0][k], b = single[1][k], c = single[2][k];
            const double mean = (a + b + c) / 3;
            const double spread =
                (a - mean) * (a - mean) + (b - mean) * (b - mean) + (c - mean) * (c - mean);
            assert_int_equal(v.seeds, 3);
            assert_true(v.measured == mean);
            assert_close(v.error, sqrt(spread / 6), 1e-15);
            assert_non_null(strstr(v.found, "(3 seeds)"));
            for (int n = 0; n < 3; ++n)
                assert_true(fw_verdict_of_seed(s, fw_study_measurement(study), k, n) ==
                            single[n][k]);
        }
        fw_study_destroy(study);
        fw_scenario_destroy(s);
    }
    snprintf(path, sizeof path, "%s/at-once-2/summary.csv", folder);
    FILE *summary = fopen(path, "r");
    assert_non_null(summary);
    assert_non_null(fgets(line, sizeof line, summary));
    assert_string_equal(line, "quantity,expected,mean,standard error,verdict,error is lower bound,"
                              "no number since,seed 7,seed 8,seed 9\n");
    fclose(summary);
    remove_folder(folder);
}

/* A bond of Lennard-Jones, k = 72 s, on a hexagonal lattice: m omega^2 is at most 6 k, with the
 * strength s of a body's own pairs or of those with another body, whichever is larger. */
static void the_limit_of_the_time_step_is_that_of_the_stiffest_pairs(void **state)
{
    (void)state;
    static const struct {
        double own, across, stiffest;
    } strengths[] = {{1, .25, 1}, {1, 4, 4}, {0, 2, 2}};
    for (size_t n = 0; n < sizeof strengths / sizeof *strengths; ++n) {
        char text[512], wanted[64], *said = NULL;
        size_t size = 0;
        int warnings = 0;
        snprintf(text, sizeof text,
                 "title: two apart\nmaterials: {m: {movable-particles: {strength: %g, mass: 3}}}\n"
                 "bodies:\n"
                 "  a: {material: m, shape: {rectangle: [2, 1]}}\n"
                 "  b: {material: m, shape: {rectangle: [2, 1]}, origin: [50, 0]}\n"
                 "dynamics: {time-step: 0.01, strength-across: %g}\nrun: {steps: 1}\n",
                 strengths[n].own, strengths[n].across);
        fw_scenario *s = read_right(text);
        fw_experiment *e = build_right(s);
        const fw_start start = {
            .scenario = s, .body = 1, .solid = fw_experiment_solid(e, 1), .range = &e->bodies[1]};
        FILE *out = open_memstream(&said, &size);
        assert_fine(fw_solid_kind_of(s, 1)->print_limits(out, &start, &warnings, &error));
        fclose(out);
        snprintf(wanted, sizeof wanted, "time step 0.01, expected below %.3g\n",
                 2 / sqrt(6 * 72 * strengths[n].stiffest / 3));
        if (!strstr(said, wanted)) fail_msg("'%s', expected '%s'", said, wanted);
        free(said);
        fw_experiment_destroy(e);
        fw_scenario_destroy(s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(materials_are_what_was_written),
        cmocka_unit_test(defaults_are_those_of_the_papers_figures),
        cmocka_unit_test(movable_bodies_share_one_solid),
        cmocka_unit_test(placed_particles_keep_their_distance),
        cmocka_unit_test(bodies_start_as_told),
        cmocka_unit_test(motion_is_measured_from_the_start),
        cmocka_unit_test(order_of_a_crystal_is_perfect),
        cmocka_unit_test(particles_run_back),
        cmocka_unit_test(the_limit_of_the_time_step_is_that_of_the_stiffest_pairs),
        cmocka_unit_test(study_judges_the_mean_of_its_seeds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
