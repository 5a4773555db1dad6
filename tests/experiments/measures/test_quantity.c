/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity.c - what is measured of scenes whose numbers are known, or are none. */
#include "tests/support/laws.h"

#include "core/particles/langevin.h"
#include "core/particles/particles.h"
#include "experiments/measures/layer.h"
#include "experiments/measures/measurement.h"

#include <string.h>

static fw_error error;
static fw_scenario *scenario;
static fw_observer *observer;
static fw_measurement *measurement;

#define assert_fine(call)                                                                          \
    do {                                                                                           \
        if ((call) != FW_OK) fail_msg("%s", error.sentence);                                       \
    } while (0)

static void begin(const char *text)
{
    assert_fine(fw_scenario_read(&scenario, "s.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_observer_create(&observer, scenario, &error));
    assert_fine(fw_measurement_create(&measurement, observer, &error));
}

static void end(void)
{
    fw_measurement_destroy(measurement);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

/* Component c of the probe of that label, in the last row. */
static double now(const char *label, int c)
{
    for (int n = 0; n < measurement->probe_count; ++n)
        if (strcmp(measurement->probes[n].label, label) == 0)
            return measurement->values[(measurement->count - 1) * measurement->width +
                                       measurement->probes[n].first + c];
    fail_msg("nothing is called %s", label);
    return NAN;
}

static bool is_plain_nan(double x)
{
    const double plain = NAN;
    return memcmp(&x, &plain, sizeof x) == 0;
}

/* A ball falls from rest, and is at rest with no energy whenever it is back at the top. */
static void errors_of_energy_have_the_scale_of_what_went_through(void **state)
{
    (void)state;
    begin(
        "title: a ball is dropped\n"
        "materials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
        "bodies: {b: {material: m, shape: {sites: [[0, 0]]}, origin: [0, 3.137]}}\n"
        "walls: {floor: {chain: [[-10, 0], [10, 0]]}}\n"
        "forces: {weight: {body: b, acceleration: [0, -0.0137]}}\n"
        "run: {steps: 400}\n"
        "measure: [energy-error, energy-drift, momentum-ratio, kinetic-fraction, friction-ratio,\n"
        "  energy]\n");
    double highest = 0;
    for (int step = 0; step <= 400; ++step) {
        if (step > 0) assert_fine(fw_observer_advance(observer, 1, &error));
        fw_measurement_take(measurement, observer->experiment);
        assert_close(now("energy-error", 0), 0, 1e-12);
        highest = fmax(highest, now("energy", 0));
        if (highest > 0) assert_close(now("energy-drift", 0), now("energy", 0) / highest, .3);
        assert_true(is_plain_nan(now("momentum-ratio", 0)));
        if (step == 0) assert_true(is_plain_nan(now("kinetic-fraction.b", 0)));
        if (step == 0) assert_true(is_plain_nan(now("friction-ratio.floor", 0)));
    }
    assert_close(fw_scene_energy_scale(observer->experiment->scene), highest, .3 * highest);
    assert_close(observer->energy_scale[0], highest, .3 * highest);
    assert_close(now("friction-ratio.floor", 0), 0, 1e-12);
    end();
}

/* --- temperature --- */

static void set_velocity(int particle, double x, double y)
{
    fw_solid *solid = (fw_solid *)fw_experiment_particles(observer->experiment);
    fw_langevin_set_velocity(solid, particle, (fw_vec2){x, y});
}

/* Two rows of three, of which the lower one is a grip. */
static void temperature_counts_what_is_free(void **state)
{
    (void)state;
    begin("title: half held\n"
          "materials: {m: {movable-particles: {}}}\n"
          "bodies: {c: {material: m, lattice: hexagonal, shape: {rectangle: [3, 2]}}}\n"
          "grips: {g: {body: c, sites: {rows: [0, 0]}, hold: x, path: {velocity: [0.5, 0]}}}\n"
          "run: {steps: 1}\n"
          "measure: [temperature, temperature-along]\n");
    for (int i = 0; i < 3; ++i) set_velocity(i, .5, .3);
    set_velocity(3, 1, .1);
    set_velocity(4, 2, .2);
    set_velocity(5, 6, -1.2);
    fw_measurement_take(measurement, observer->experiment);
    /* The upper row is free: its mean is 3 along x, (4 + 1 + 9)/2, and -.3 along y. */
    assert_close(now("temperature-along", 0), 7, 1e-12);
    assert_close(now("temperature-along", 1), (.16 + .25 + .81) / 2, 1e-12);
    end();
}

/* A particle by itself, and a pair 1 apart from its mean in x and 2 in y: m v^2 of two with two
 * degrees of freedom. */
static void one_that_is_alone_leaves_the_temperature_to_the_others(void **state)
{
    (void)state;
    begin("title: one and two\n"
          "materials: {m: {movable-particles: {mass: 3}}}\n"
          "bodies:\n"
          "  one: {material: m, shape: {points: [[0, 0]]}}\n"
          "  two: {material: m, shape: {points: [[9, 0], [11, 0]]}}\n"
          "run: {steps: 1}\n"
          "measure: [temperature, temperature.two, temperature.one]\n");
    set_velocity(0, 7, 7);
    set_velocity(1, 4, 5);
    set_velocity(2, 6, 1);
    fw_measurement_take(measurement, observer->experiment);
    const double wanted = 3 * (2 * 1 + 2 * 4) / 2.;
    assert_close(now("temperature", 0), wanted, 1e-12);
    assert_close(now("temperature.two", 0), wanted, 1e-12);
    assert_true(is_plain_nan(now("temperature.one", 0)));
    end();
}

static void what_is_held_or_alone_has_no_temperature(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "title: held\n"
        "materials: {m: {movable-particles: {}}}\n"
        "bodies: {c: {material: m, lattice: hexagonal, shape: {rectangle: [3, 2]}}}\n"
        "grips: {g: {body: c, hold: both, path: {velocity: [0.5, 0]}}}\n"
        "run: {steps: 1}\nmeasure: [temperature]\n",
        "title: alone\n"
        "materials: {m: {movable-particles: {}}}\n"
        "bodies: {c: {material: m, shape: {sites: [[0, 0]]}, velocity: [1, 0]}}\n"
        "run: {steps: 1}\nmeasure: [temperature]\n"};
    for (int n = 0; n < 2; ++n) {
        begin(texts[n]);
        fw_measurement_take(measurement, observer->experiment);
        assert_true(is_plain_nan(now("temperature", 0)));
        end();
    }
}

/* .1 + .2 - .3 is not 0, and no momentum either. */
static void rounding_is_no_momentum_to_start_from(void **state)
{
    (void)state;
    begin("title: three of them\n"
          "materials: {m: {movable-particles: {}}}\n"
          "bodies:\n"
          "  a: {material: m, shape: {sites: [[0, 0]]}, velocity: [0.1, 0]}\n"
          "  b: {material: m, shape: {sites: [[0, 0]]}, velocity: [0.2, 0], origin: [0, 50]}\n"
          "  c: {material: m, shape: {sites: [[0, 0]]}, velocity: [-0.3, 0], origin: [50, 0]}\n"
          "run: {steps: 1}\nmeasure: [momentum, momentum-ratio, momentum-ratio.a]\n");
    fw_measurement_take(measurement, observer->experiment);
    assert_true(now("momentum", 0) != 0);
    assert_true(is_plain_nan(now("momentum-ratio", 0)));
    assert_close(now("momentum-ratio.a", 0), 1, 0);
    end();
}

/* A bin of n particles has 2 (n - 1) degrees of freedom beside its mean motion. */
static void the_temperature_of_a_bin_counts_its_own_mean(void **state)
{
    (void)state;
    begin(
        "title: two in a bin\n"
        "materials: {m: {movable-particles: {mass: 3}}}\n"
        "bodies: {c: {material: m, lattice: square, shape: {rectangle: [9, 2]}, origin: [-4, 0]}}\n"
        "run: {steps: 100}\n"
        "profile: {axis: x, every: 100, bin: 1, contact: 0.5, far: [2.5, 4.5]}\n");
    for (int i = 0; i < 9; ++i) {
        set_velocity(i, 5 + .1 * i, 7);
        set_velocity(9 + i, 5 - .1 * i, 7);
    }
    fw_profile_follow(observer->profile, observer->experiment, 100);
    for (int bin = 0; bin < 9; ++bin)
        assert_close(fw_profile_value(observer->profile, bin, FW_PROFILE_TEMPERATURE),
                     3 * (2 * .01 * bin * bin) / 2, 1e-12);
    end();
}

/* What a grip holds moves as one: it is no part of a bin's heat, nor of its degrees of freedom. */
static void the_temperature_of_a_bin_leaves_out_what_is_held(void **state)
{
    (void)state;
    begin(
        "title: three in a bin, one of them held\n"
        "materials: {m: {movable-particles: {mass: 3}}}\n"
        "bodies: {c: {material: m, lattice: square, shape: {rectangle: [9, 3]}, origin: [-4, 0]}}\n"
        "grips:\n"
        "  lower: {body: c, sites: [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0], [6, 0], [7, "
        "0],\n"
        "    [8, 0], [0, 1]]}\n"
        "run: {steps: 100}\n"
        "profile: {axis: x, every: 100, bin: 1, contact: 0.5, far: [2.5, 4.5]}\n");
    for (int i = 0; i < 9; ++i) {
        set_velocity(i, 0, 0);
        set_velocity(9 + i, 5 + .1 * i, 7);
        set_velocity(18 + i, 5 - .1 * i, 7);
    }
    fw_profile_follow(observer->profile, observer->experiment, 100);
    assert_true(is_plain_nan(fw_profile_value(observer->profile, 0, FW_PROFILE_TEMPERATURE)));
    for (int bin = 1; bin < 9; ++bin)
        assert_close(fw_profile_value(observer->profile, bin, FW_PROFILE_TEMPERATURE),
                     3 * (2 * .01 * bin * bin) / 2, 1e-12);
    end();
}

/* A control that shows nothing, or rounding, is nothing to be a multiple of. */
static void a_layer_has_no_ratio_to_nothing(void **state)
{
    (void)state;
    static const double controls[] = {0, 1e-17, .5};
    begin(
        "title: nothing moves\n"
        "materials: {m: {movable-particles: {}}}\n"
        "bodies: {c: {material: m, lattice: square, shape: {rectangle: [9, 2]}, origin: [-4, 0]}}\n"
        "run: {steps: 100}\n"
        "profile: {axis: x, every: 100, bin: 1, contact: 0.5, far: [2.5, 4.5]}\n");
    for (size_t n = 0; n < 3; ++n) {
        double values[FW_LAYER_MEASURES], control[FW_LAYER_MEASURES];
        for (int k = 0; k < FW_LAYER_MEASURES; ++k) values[k] = 1, control[k] = controls[n];
        fw_layer_compare(values, control, observer->profile);
        static const fw_layer_measure measures[] = {FW_LAYER_CONTACT_OVER_CONTROL,
                                                    FW_LAYER_RELATIVE_DISPLACEMENT_OVER_CONTROL};
        for (int k = 0; k < 2; ++k) {
            assert_true(fw_layer_quantities[measures[k]].absent != NULL);
            if (n < 2)
                assert_true(is_plain_nan(values[measures[k]]));
            else
                assert_close(values[measures[k]], 2, 0);
        }
    }
    end();
}

static void a_body_at_rest_has_no_poisson_ratio(void **state)
{
    (void)state;
    begin("title: at rest\n"
          "materials: {l: {linear-lattice: {}}}\n"
          "bodies: {c: {material: l, lattice: hexagonal, shape: {rectangle: [12, 12]},\n"
          "  origin: [0.1, 0.7]}}\n"
          "run: {steps: 1}\nmeasure: [poisson-ratio]\n");
    fw_measurement_take(measurement, observer->experiment);
    assert_true(is_plain_nan(now("poisson-ratio.c", 0)));
    assert_true(is_plain_nan(now("poisson-ratio.c", 1)));
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_energy_have_the_scale_of_what_went_through),
        cmocka_unit_test(temperature_counts_what_is_free),
        cmocka_unit_test(one_that_is_alone_leaves_the_temperature_to_the_others),
        cmocka_unit_test(what_is_held_or_alone_has_no_temperature),
        cmocka_unit_test(rounding_is_no_momentum_to_start_from),
        cmocka_unit_test(a_layer_has_no_ratio_to_nothing),
        cmocka_unit_test(the_temperature_of_a_bin_counts_its_own_mean),
        cmocka_unit_test(the_temperature_of_a_bin_leaves_out_what_is_held),
        cmocka_unit_test(a_body_at_rest_has_no_poisson_ratio),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
