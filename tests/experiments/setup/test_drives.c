/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_drives.c - drives and grips as scenario files have them: how short a period may be, what a
 * body does that is let go, and which of its particles have a temperature. */
#include "tests/support/laws.h"

#include "experiments/measures/quantity.h"
#include "experiments/setup/experiment.h"
#include "tests/support/scratch.h"

static fw_status create(fw_experiment **experiment, fw_scenario **scenario, const char *text,
                        const char *setting)
{
    *experiment = NULL;
    *scenario = NULL;
    FW_TRY(fw_scenario_read(scenario, "t.yaml", text, strlen(text), &setting, setting ? 1 : 0,
                            &error));
    return fw_experiment_create(experiment, *scenario, &error);
}

static void release(fw_experiment *experiment, fw_scenario *scenario)
{
    fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
}

static double number(const fw_experiment *experiment, const char *name, fw_subject subject)
{
    double out[FW_COMPONENTS_MAX];
    fw_quantity_find(name)->measure(experiment, subject, out);
    return out[0];
}

static const char shaken[] =
    "title: everything that can oscillate\n"
    "materials: {m: {movable-particles: {}}}\n"
    "bodies:\n"
    "  a: {material: m, lattice: hexagonal, shape: {rectangle: [4, 4]}}\n"
    "  b: {material: m, lattice: hexagonal, shape: {rectangle: [4, 4]}, origin: [20, 0]}\n"
    "walls:\n"
    "  floor: {box: [-50, -9, 50, -5], side: outside, path: {amplitude: [0, 0.1], period: 1}}\n"
    "  stamp: {box: [-50, 9, 50, 12], side: outside,\n"
    "    piston: {mass: 9, force: [0, 0], amplitude: [0, 0.1], period: 1, hold: x,\n"
    "      path: {amplitude: [0.1, 0], period: 1}}}\n"
    "forces: {push: {body: b, force: [0.01, 0], period: 200}}\n"
    "grips: {hand: {body: a, force: [0, 0], amplitude: [0, 0.1], period: 1, hold: x,\n"
    "    path: {amplitude: [0.1, 0], period: 1}}}\n"
    "dynamics: {time-step: 0.005}\n"
    "phases:\n"
    "  first: {until: 10}\n"
    "  second: {until: 20, grips: {hand: {amplitude: [0, 0.1], period: 1, force: [0, 0]}},\n"
    "    pistons: {stamp: {amplitude: [0, 0.1], period: 1, force: [0, 0]}}}\n"
    "run: {steps: 20}\n";

/* Four steps are followed, fewer are refused: 4 x .005 = .02. */
static void period_of_a_few_steps_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *setting, *words;
    } cases[] = {
        {NULL, NULL},
        {"walls.floor.path.period=0.02", NULL},
        {"walls.floor.path.period=0.0199", "wall floor oscillates with a period of 0.0199"},
        {"walls.floor.path.period=0.005", "(steps: 1), expected at least 0.02 (steps: 4)"},
        {"walls.stamp.piston.period=0.01", "piston stamp"},
        {"walls.stamp.piston.path.period=0.01", "piston stamp"},
        {"forces.push.period=4", NULL},
        {"forces.push.period=2", "force push"},
        {"grips.hand.period=0.01", "grip hand"},
        {"grips.hand.path.period=0.01", "grip hand"},
        {"phases.second.grips.hand.period=0.01", "grip hand"},
        {"phases.second.pistons.stamp.period=0.01", "piston stamp"},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_experiment *experiment;
        fw_scenario *scenario;
        const fw_status status = create(&experiment, &scenario, shaken, cases[n].setting);
        if (!cases[n].words) {
            assert_fine(status);
        } else {
            assert_int_equal(status, FW_BAD_INPUT);
            if (!strstr(error.sentence, cases[n].words))
                fail_msg("'%s' is not in: %s", cases[n].words, error.sentence);
        }
        release(experiment, scenario);
    }
}

/* An automaton moves once in a whole step, of two ticks. */
static void step_of_an_automaton_is_two_ticks(void **state)
{
    (void)state;
    static const char text[] = "title: t\n"
                               "materials: {m: {elastic-automaton: {chopard: true}}}\n"
                               "bodies: {a: {material: m, shape: {rectangle: [4, 4]}}}\n"
                               "walls: {floor: {box: [-50, -9, 50, -5], side: outside,\n"
                               "  path: {amplitude: [0, 0.1], period: 4}}}\n"
                               "run: {steps: 20}\n";
    fw_experiment *experiment;
    fw_scenario *scenario;
    assert_fine(create(&experiment, &scenario, text, NULL));
    release(experiment, scenario);
    assert_int_equal(create(&experiment, &scenario, text, "walls.floor.path.period=3"),
                     FW_BAD_INPUT);
    release(experiment, scenario);
}

/* Half of the particles are held by a grip, on a path in x or in both; the others have the
 * temperature that they were given. What is held does not count, neither its energy nor its
 * freedom.
 */
static void temperature_is_that_of_the_free_particles(void **state)
{
    (void)state;
    static const char text[] =
        "title: t\n"
        "materials: {m: {linear-lattice: {}}}\n"
        "bodies: {a: {material: m, lattice: hexagonal, shape: {rectangle: [20, 20]}}}\n"
        "grips: {hand: {body: a, side: bottom, layer: 8, hold: both, path: {velocity: [0.2, "
        "0.1]}}}\n"
        "dynamics: {time-step: 0.005, damping: 20, temperature: 0.3}\n"
        "run: {steps: 800}\n";
    for (int both = 0; both < 2; ++both) {
        fw_experiment *experiment;
        fw_scenario *scenario;
        const fw_subject body = {.body = 0, .wall = -1, .particle = -1};
        assert_fine(create(&experiment, &scenario, text, both ? NULL : "grips.hand.hold=x"));
        double along[2], mean[2] = {0, 0};
        for (int t = 1; t <= 800; ++t) {
            assert_fine(fw_experiment_step(experiment, &error));
            fw_quantity_find("temperature-along")->measure(experiment, body, along);
            for (int c = 0; c < 2; ++c) mean[c] += t > 200 ? along[c] / 600 : 0;
        }
        assert_close(mean[0], 0.3, 0.03);
        assert_close(mean[1], 0.3, 0.03);
        assert_close(number(experiment, "temperature", body), 0.5 * (along[0] + along[1]), 1e-15);
        release(experiment, scenario);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(period_of_a_few_steps_is_refused),
        cmocka_unit_test(step_of_an_automaton_is_two_ticks),
        cmocka_unit_test(temperature_is_that_of_the_free_particles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
