/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_profile.c - what a profile and the layer say of two beams that rub, counted again by hand:
 * bin by bin from places, velocities and forces, and cycle by cycle from force and slip. */
#include "tests/support/laws.h"

#include "experiments/measures/layer.h"
#include "experiments/measures/observer.h"
#include "tests/support/beams.h"
#include "tests/support/scratch.h"

#include "core/particles/particle_observables.h"

typedef struct bench {
    fw_scenario *scenario;
    fw_observer *observer;
    const fw_solid *solid;
} bench;

static bench make(const char *const *settings, int count)
{
    bench b;
    assert_fine(fw_scenario_read(&b.scenario, "beams.yaml", small_beams, strlen(small_beams),
                                 settings, count, &error));
    assert_fine(fw_observer_create(&b.observer, b.scenario, &error));
    b.solid = fw_experiment_particles(b.observer->experiment);
    return b;
}

static void release(bench *b)
{
    fw_observer_destroy(b->observer);
    fw_scenario_destroy(b->scenario);
}

/* --- bin by bin --- */

/* What is known of all particles at the only sample. */
static double mass[128], speed_x[128], speed_y[128], pull_x[128], pull_y[128];
static uint8_t held[128];

typedef struct count {
    int all, bound_free;
    double force, order, along, heat;
} count;

/* Of the particles with low <= x < high, in y from low_y to high_y. */
static count count_in(const bench *b, double low, double high, double low_y, double high_y)
{
    count c = {0};
    fw_vec2 mean = {0, 0};
    for (int pass = 0; pass < 2; ++pass)
        for (int i = 0; i < b->solid->count; ++i) {
            const double x = b->solid->x[i], y = b->solid->y[i];
            int bonds;
            if (!(x >= low && x < high && y >= low_y && y <= high_y)) continue;
            if (pass == 0) {
                const fw_phase order = fw_particles_bond_order(b->solid, i, &bonds);
                c.all += 1;
                c.force += hypot(pull_x[i], pull_y[i]);
                c.order += hypot(order.cosine, order.sine);
                c.along += speed_y[i];
                if (held[i]) continue;
                c.bound_free += 1;
                mean.x += speed_x[i];
                mean.y += speed_y[i];
            } else if (!held[i]) {
                const double u = speed_x[i] - mean.x / c.bound_free;
                const double v = speed_y[i] - mean.y / c.bound_free;
                c.heat += mass[i] * (u * u + v * v);
            }
        }
    return c;
}

static void assert_same(const bench *b, int bin, count c, double area)
{
    const fw_profile *p = b->observer->profile;
    assert_close(fw_profile_value(p, bin, FW_PROFILE_DENSITY), c.all / area, 1e-12);
    if (c.all == 0) {
        assert_true(isnan(fw_profile_value(p, bin, FW_PROFILE_RETURN_FORCE)));
        return;
    }
    assert_close(fw_profile_value(p, bin, FW_PROFILE_RETURN_FORCE), c.force / c.all, 1e-12);
    assert_close(fw_profile_value(p, bin, FW_PROFILE_ORDER), c.order / c.all, 1e-12);
    assert_close(fw_profile_value(p, bin, FW_PROFILE_DRIFT), fabs(c.along / c.all), 1e-12);
    /* n particles have 2 (n - 1) degrees of freedom beside their mean motion. */
    const double temperature = fw_profile_value(p, bin, FW_PROFILE_TEMPERATURE);
    if (c.bound_free < 2)
        assert_true(isnan(temperature));
    else
        assert_close(temperature, c.heat / (2 * (c.bound_free - 1)), 1e-12);
}

/* A single sample, with bins of some particles; those of the left beam are thrice as heavy. */
static void a_profile_is_what_is_counted_in_its_bins(void **state)
{
    (void)state;
    static const char *const settings[] = {"profile.every=1000",
                                           "profile.bin=0.7",
                                           "profile.window=[-3,3]",
                                           "materials.crystal.movable-particles.mass=1.5",
                                           "materials.heavy={movable-particles: {mass: 4.5}}",
                                           "bodies.left.material=heavy"};
    bench b = make(settings, 6);
    while (fw_scene_steps(b.observer->experiment->scene) < 2500)
        assert_fine(fw_observer_advance(b.observer, 1, &error));
    assert_true(b.solid->count <= 128);
    b.solid->model->masses(b.solid, mass);
    b.solid->model->velocities(b.solid, speed_x, speed_y);
    fw_particles_return_forces(b.solid, pull_x, pull_y);
    fw_scene_mark_held(b.observer->experiment->scene, 0, held);
    const fw_profile *p = b.observer->profile;
    assert_int_equal(fw_profile_sample_count(p), 1);
    int several = 0, seen = 0;
    for (int bin = 0; bin < fw_profile_bin_count(p); ++bin) {
        const double low = fw_profile_edge(p, bin), high = fw_profile_edge(p, bin + 1);
        assert_close(high - low, .7, 1e-12);
        const count c = count_in(&b, low, high, -3, 3);
        assert_same(&b, bin, c, .7 * 6);
        several += c.bound_free > 1;
        seen += c.all;
    }
    assert_true(several > 3 && seen > 30);
    /* Contact within 1.2 of 0; far from 2.5 to 4 on both sides of it. */
    assert_same(&b, FW_PROFILE_CONTACT, count_in(&b, -1.2, 1.2, -3, 3), 2.4 * 6);
    const count left = count_in(&b, -4, -2.5, -3, 3), right = count_in(&b, 2.5, 4, -3, 3);
    const double far = fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_DENSITY);
    assert_close(far, (left.all + right.all) / (3. * 6), 1e-12);
    assert_close(fw_profile_value(p, FW_PROFILE_FAR, FW_PROFILE_RETURN_FORCE),
                 (left.force + right.force) / (left.all + right.all), 1e-12);
    release(&b);
}

/* Particles that feel nothing but their bath wander with D = T/(m damping), each alone: two move
 * apart twice as fast. Some thousand independent ways tell it to some per cent. */
static void walkers_diffuse_as_einstein_says(void **state)
{
    (void)state;
    static const char walkers[] =
        "title: walkers\n"
        "materials: {gas: {movable-particles: {strength: 0, mass: 2}}}\n"
        "bodies: {cloud: {material: gas, lattice: hexagonal, shape: {rectangle: [20, 20]}}}\n"
        "dynamics: {time-step: 0.02, damping: 10, temperature: 0.01}\n"
        "run: {steps: 3000, measure-every: 1000}\n"
        "profile: {axis: x, every: 1000, bin: 2, middle: 10, contact: 5, far: [6, 9]}\n";
    bench b;
    assert_fine(
        fw_scenario_read(&b.scenario, "walkers.yaml", walkers, strlen(walkers), NULL, 0, &error));
    assert_fine(fw_observer_create(&b.observer, b.scenario, &error));
    while (fw_scene_steps(b.observer->experiment->scene) < 3000)
        assert_fine(fw_observer_advance(b.observer, 1, &error));
    const double expected = 0.01 / (2 * 10);
    assert_close(fw_profile_value(b.observer->profile, FW_PROFILE_CONTACT, FW_PROFILE_DIFFUSIVITY) /
                     expected,
                 1, .12);
    assert_close(fw_profile_value(b.observer->profile, FW_PROFILE_CONTACT, FW_PROFILE_TEMPERATURE),
                 .01, .002);
    release(&b);
}

/* --- cycle by cycle --- */

/* The drive swings 1000 steps of .005 with a period of 4: 1.25 cycles. */
static void the_numbers_of_friction_are_those_of_the_loop(void **state)
{
    (void)state;
    bench b = make(NULL, 0);
    fw_measurement *measurement;
    assert_fine(fw_measurement_create(&measurement, b.observer, &error));
    double work = 0, path = 0, before = 0, rub = 0, press = 0, slip = 0;
    double last_slip = 0, last_force = 0;
    for (int step = 1; step <= 2500; ++step) {
        assert_fine(fw_observer_advance(b.observer, 1, &error));
        const double now = fw_rubbing_slip(b.observer->experiment).y;
        const fw_vec2 force = fw_rubbing_force(b.observer->experiment);
        if (step > 500 && step <= 1500) before += fabs(now - last_slip);
        if (step > 1500) {
            path += fabs(now - last_slip);
            work += -.5 * (force.y + last_force) * (now - last_slip);
        }
        if (step >= 1500) {
            rub += fabs(force.y) / 1001;
            press += fabs(force.x) / 1001;
            slip += now / 1001;
        }
        last_slip = now;
        last_force = force.y;
        if (fw_measurement_is_due(b.scenario, step))
            fw_measurement_take(measurement, b.observer->experiment);
    }
    double layer[FW_LAYER_MEASURES];
    assert_fine(fw_layer_of(layer, b.observer, measurement, &error));
    assert_true(work > 0 && path > 1 && before > 1 && fabs(path - before) > .1);
    assert_true(fabs(rub - press) > .1 * press);
    assert_close(layer[FW_LAYER_LOOP_ENERGY], work / 1.25, 1e-10 * work);
    assert_close(layer[FW_LAYER_FRICTION_FORCE], rub, 1e-10 * rub);
    assert_close(layer[FW_LAYER_NORMAL_FORCE], press, 1e-10 * press);
    assert_close(layer[FW_LAYER_SLIP_PATH], before, 1e-10 * before);
    assert_close(layer[FW_LAYER_OFFSET], fabs(slip), 1e-10);
    assert_close(layer[FW_LAYER_FRICTION_COEFFICIENT], work / (path * press), 1e-10);
    fw_measurement_destroy(measurement);
    release(&b);
}

/* --- solids whose particles do not flow --- */

#define SHEARED(material, lattice, dynamics, bins)                                                 \
    "title: a slab that is sheared slowly\n"                                                       \
    "materials: {m: " material "}\n"                                                               \
    "bodies: {slab: {material: m, lattice: " lattice ", shape: {rectangle: [8, 6]}}}\n" dynamics   \
    "grips:\n"                                                                                     \
    "  below: {body: slab, side: bottom, layer: 0.5, hold: both}\n"                                \
    "  above: {body: slab, side: top, layer: 0.5, hold: both, path: {velocity: [1e-5, 0]}}\n"      \
    "phases: {settle: {until: 4000}, sample: {until: 5000}}\n"                                     \
    "run: {steps: 5000}\n"                                                                         \
    "profile: {axis: y, phase: sample, every: 500, window: [-1, 9], far: [1.5, 4], " bins "}\n"

static bench shear(const char *text)
{
    bench b;
    assert_fine(fw_scenario_read(&b.scenario, "sheared.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_observer_create(&b.observer, b.scenario, &error));
    while (fw_scene_steps(b.observer->experiment->scene) < 5000)
        assert_fine(fw_observer_advance(b.observer, 1, &error));
    assert_int_equal(fw_profile_bin_count(b.observer->profile), 6);
    assert_int_equal(fw_profile_sample_count(b.observer->profile), 2);
    return b;
}

/* Rows move by even steps between the speeds of the grips, inside nothing pulls, and what pulls the
 * outer rows is what the grip pulls with: of both samples, 4500 and 5000, .95 of the last. */
static void a_sheared_slab_moves_row_by_row(void **state)
{
    (void)state;
    bench b = shear(SHEARED("{lattice-boltzmann: {rest-mass: 0, damping: 0.05}}", "square", "",
                            "middle: 2, contact: 0.6"));
    const fw_profile *p = b.observer->profile;
    const fw_scene *scene = b.observer->experiment->scene;
    const double pull = fw_grip_observe_ledger(fw_scene_observe_grip(scene, 1))->reaction.x;
    assert_true(pull > 1e-3);
    for (int row = 0; row < 6; ++row) {
        assert_close(fw_profile_value(p, row, FW_PROFILE_DRIFT), row / 5. * 1e-5, 1e-8);
        assert_close(fw_profile_value(p, row, FW_PROFILE_DENSITY), 8 / 10., 1e-12);
        assert_true(isnan(fw_profile_value(p, row, FW_PROFILE_ORDER)));
        assert_true(isnan(fw_profile_value(p, row, FW_PROFILE_BOND_BREAKING)));
        assert_true(isnan(fw_profile_value(p, row, FW_PROFILE_DIFFUSIVITY)));
        const double force = 8 * fw_profile_value(p, row, FW_PROFILE_RETURN_FORCE);
        if (row > 0 && row < 5)
            assert_below(force, .01 * pull);
        else
            assert_close(force, .95 * pull, .02 * pull);
    }
    release(&b);
}

/* Its rows are bent at their ends: the steps are not even there. */
static void a_linear_lattice_has_a_profile(void **state)
{
    (void)state;
    bench b = shear(SHEARED("{linear-lattice: {}}", "hexagonal",
                            "dynamics: {time-step: 0.05, damping: 0.5}\n",
                            "bin: 0.8660254, middle: 1.7320508, contact: 0.6"));
    const fw_profile *p = b.observer->profile;
    const double outer = fw_profile_value(p, 5, FW_PROFILE_RETURN_FORCE);
    assert_close(fw_profile_value(p, 0, FW_PROFILE_DRIFT), 0, 0);
    assert_close(fw_profile_value(p, 5, FW_PROFILE_DRIFT), 1e-5, 1e-12);
    for (int row = 1; row < 5; ++row) {
        assert_close(fw_profile_value(p, row, FW_PROFILE_DRIFT), row / 5. * 1e-5, 1e-6);
        assert_below(fw_profile_value(p, row, FW_PROFILE_RETURN_FORCE), .02 * outer);
    }
    release(&b);
}

/* An automaton knows of no forces; its rows have places and velocities all the same. */
static void an_automaton_has_a_profile_without_forces(void **state)
{
    (void)state;
    static const char text[] =
        "title: flies\n"
        "materials: {m: {elastic-automaton: {c1: 1, c2: 0}}}\n"
        "bodies: {slab: {material: m, shape: {rectangle: [8, 6]}, velocity: [0.01, 0.002]}}\n"
        "run: {steps: 40}\n"
        "profile: {axis: y, every: 40, middle: 2, contact: 0.6, far: [1.5, 4]}\n";
    bench b;
    assert_fine(fw_scenario_read(&b.scenario, "flies.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_observer_create(&b.observer, b.scenario, &error));
    assert_fine(fw_observer_advance(b.observer, 1, &error));
    while (fw_scene_steps(b.observer->experiment->scene) < 40)
        assert_fine(fw_observer_advance(b.observer, 1, &error));
    const fw_profile *p = b.observer->profile;
    for (int row = 0; row < 6; ++row) {
        assert_close(fw_profile_value(p, row, FW_PROFILE_DRIFT), .01, 1e-14);
        assert_true(isnan(fw_profile_value(p, row, FW_PROFILE_RETURN_FORCE)));
    }
    release(&b);
}

/* From step 3 on every fifth: 8, 13, 18, 23, each with the places of the step before. */
static void samples_count_from_the_beginning_of_their_phase(void **state)
{
    (void)state;
    static const char text[] =
        "title: flies\n"
        "materials: {m: {elastic-automaton: {c1: 1, c2: 0}}}\n"
        "bodies: {slab: {material: m, shape: {rectangle: [8, 6]}, velocity: [0.01, 0.002]}}\n"
        "phases: {settle: {until: 3}, sample: {until: 24}}\n"
        "run: {steps: 24}\n"
        "profile: {axis: y, phase: sample, every: 5, middle: 2, contact: 0.6, far: [1.5, 4]}\n";
    bench b;
    assert_fine(fw_scenario_read(&b.scenario, "flies.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_observer_create(&b.observer, b.scenario, &error));
    const fw_profile *p = b.observer->profile;
    for (int step = 1; step <= 24; ++step) {
        assert_fine(fw_observer_advance(b.observer, 1, &error));
        assert_int_equal(fw_profile_sample_count(p), step < 8 ? 0 : (step - 3) / 5);
        if (step >= 8) assert_close(fw_profile_value(p, 0, FW_PROFILE_DRIFT), .01, 1e-14);
    }
    release(&b);
}

/* Two sheets of 4 x 3, bent anyhow, at rest: the links pull a particle by the sum of what each of
 * them is longer than 1. Only the middle rows lie in the contact. */
static void what_pulls_at_the_contact_is_of_all_bodies(void **state)
{
    (void)state;
    enum { COLUMNS = 4, ROWS = 3 };
    static const char text[] =
        "title: two sheets\n"
        "materials: {m: {lattice-boltzmann: {rest-mass: 0}}}\n"
        "bodies:\n"
        "  a: {material: m, shape: {rectangle: [4, 3]}, displacement: [{random: 0.1}]}\n"
        "  b: {material: m, shape: {rectangle: [4, 3]}, origin: [9, 0],\n"
        "    displacement: [{gradient: [0.02, 0.1, -0.07, 0.03]}, {random: 0.2}]}\n"
        "run: {steps: 10}\n"
        "profile: {axis: y, every: 5, middle: 1, contact: 0.6, far: [0.6, 3]}\n";
    bench b;
    assert_fine(fw_scenario_read(&b.scenario, "sheets.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_observer_create(&b.observer, b.scenario, &error));
    double sum = 0;
    for (int body = 0; body < 2; ++body) {
        const fw_solid *solid = fw_experiment_solid(b.observer->experiment, body);
        for (int i = 0; i < COLUMNS; ++i) {
            const int l = COLUMNS + i;
            const int beside[] = {l + 1, l + COLUMNS, l - 1, l - COLUMNS};
            fw_vec2 pull = {0, 0};
            for (int d = 0; d < 4; ++d) {
                if ((d == 0 && i == COLUMNS - 1) || (d == 2 && i == 0)) continue;
                const fw_vec2 link = fw_vec2_subtract(fw_solid_position(solid, beside[d]),
                                                      fw_solid_position(solid, l));
                const fw_site step = fw_site_neighbour((fw_site){0, 0}, d);
                pull = fw_vec2_add(pull, fw_vec2_subtract(link, (fw_vec2){step.i, step.j}));
            }
            sum += hypot(pull.x, pull.y);
        }
    }
    assert_close(fw_profile_contact_now(b.observer->profile), sum / (2 * COLUMNS), 1e-13);
    release(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_profile_is_what_is_counted_in_its_bins),
        cmocka_unit_test(walkers_diffuse_as_einstein_says),
        cmocka_unit_test(the_numbers_of_friction_are_those_of_the_loop),
        cmocka_unit_test(a_sheared_slab_moves_row_by_row),
        cmocka_unit_test(a_linear_lattice_has_a_profile),
        cmocka_unit_test(an_automaton_has_a_profile_without_forces),
        cmocka_unit_test(samples_count_from_the_beginning_of_their_phase),
        cmocka_unit_test(what_pulls_at_the_contact_is_of_all_bodies),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
