/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_piston_scenes.c - pistons as scenario files have them: with movable particles, in phases,
 * measured and refused. Their laws on LB solids stand in test_piston.c. */
#include "tests/support/laws.h"

#include "experiments/measures/measurement.h"
#include "tests/support/scratch.h"

static const char press[] =
    "title: a crystal between two pistons\n"
    "materials: {crystal: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "bodies:\n"
    "  slab: {material: crystal, lattice: hexagonal, angle: 90, shape: {rectangle: [8, 8]}}\n"
    "walls:\n"
    "  left:\n"
    "    box: [-16.1, -20, -6.1, 30]\n"
    "    side: outside\n"
    "    piston: {mass: 8, damping: 0.2, hold: both}\n"
    "  right:\n"
    "    box: [0.05, -20, 10, 30]\n"
    "    side: outside\n"
    "    piston: {mass: 8, damping: 0.2, hold: both}\n"
    "dynamics: {time-step: 0.005, damping: 0.2, temperature: 0.02}\n"
    "phases:\n"
    "  relax: {until: 500, damping: 1}\n"
    "  load:\n"
    "    until: 6000\n"
    "    pistons:\n"
    "      left: {force: [20, 0], hold: y}\n"
    "      right: {force: [-20, 0], hold: y, damping: 0.5}\n"
    "run: {steps: 6000}\n";

static fw_status try_with(const char *const *settings, int count, fw_observer **observer,
                          fw_scenario **scenario, fw_measurement **measurement)
{
    *observer = NULL;
    *measurement = NULL;
    FW_TRY(fw_scenario_read(scenario, "press.yaml", press, strlen(press), settings, count, &error));
    FW_TRY(fw_observer_create(observer, *scenario, &error));
    return fw_measurement_create(measurement, *observer, &error);
}

static void release(fw_observer *observer, fw_scenario *scenario, fw_measurement *measurement)
{
    fw_measurement_destroy(measurement);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

static const fw_piston_ledger *ledger_of(const fw_observer *observer, int wall)
{
    return fw_piston_observe_ledger(fw_scene_observe_piston(observer->experiment->scene, wall));
}

/* The bodies' energy follows the ledger to Verlet's own error, the pistons' to rounding. */
static void pressed_crystal(const char *const *settings, int count, double deepest)
{
    fw_observer *observer;
    fw_scenario *scenario;
    fw_measurement *measurement;
    assert_fine(try_with(settings, count, &observer, &scenario, &measurement));
    double push = 0, depth = 0;
    for (int t = 0; t < 6000; ++t) {
        assert_fine(fw_observer_advance(observer, 1, &error));
        const fw_ledger ledger = fw_scene_ledger(observer->experiment->scene);
        const fw_energies e = fw_scene_energies(observer->experiment->scene);
        const fw_vec2 p = fw_vec2_subtract(fw_scene_momentum(observer->experiment->scene),
                                           fw_ledger_momentum(&ledger));
        /* Verlet's own error at this time step. */
        assert_close(e.kinetic + e.elastic, fw_ledger_energy(&ledger),
                     1e-4 * fabs(ledger.energy_at_start));
        assert_close(hypot(p.x, p.y), 0, 1e-10);
        for (int w = 0; w < 2; ++w) {
            const fw_piston *piston = fw_scene_observe_piston(observer->experiment->scene, w);
            const fw_vec2 lost = fw_piston_momentum_error(piston);
            assert_close(fw_piston_energy_error(piston), 0, 1e-11);
            assert_close(hypot(lost.x, lost.y), 0, 1e-10);
        }
        depth = fmax(depth, fw_scene_penetration(observer->experiment->scene, -1));
        if (t == 499) assert_true(ledger_of(observer, 0)->displacement.x == 0);
        if (t >= 4000)
            push += fw_scene_wall_ledger(observer->experiment->scene, 1)->reaction.x / 2000;
    }
    assert_true(ledger_of(observer, 0)->displacement.x > 0);
    assert_true(ledger_of(observer, 1)->displacement.x < 0);
    /* Over 10 units of time the piston's own acceleration is all that mean and load can differ by.
     */
    const double change = 8 * fabs(ledger_of(observer, 1)->velocity.x);
    assert_close(push, -20, 1 + change);
    assert_below(depth, deepest);
    assert_int_equal(fw_scene_unresolved(observer->experiment->scene), 0);
    release(observer, scenario, measurement);
}

static void hard_pistons_press_a_crystal(void **state)
{
    (void)state;
    pressed_crystal(NULL, 0, 1e-11);
}

static void soft_pistons_press_a_crystal(void **state)
{
    (void)state;
    const char *settings[] = {"walls.left.surface={penalty: 100}",
                              "walls.right.surface={penalty: 100}"};
    pressed_crystal(settings, 2, 0.2);
}

static void where_pistons_are_is_always_measured(void **state)
{
    (void)state;
    const char *settings[] = {"measure=[energy]"};
    fw_observer *observer;
    fw_scenario *scenario;
    fw_measurement *measurement;
    assert_fine(try_with(settings, 1, &observer, &scenario, &measurement));
    int found = 0;
    for (int n = 0; n < measurement->probe_count; ++n)
        found += strcmp(measurement->probes[n].label, "piston-displacement.left") == 0 ||
                 strcmp(measurement->probes[n].label, "piston-displacement.right") == 0;
    assert_int_equal(found, 2);
    release(observer, scenario, measurement);
}

static void mistakes_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *setting, *words;
    } wrong[] = {
        {"walls.left.piston.mass=0", "walls.left.piston.mass is '0', expected a number above 0"},
        {"walls.left.piston={damping: 1}", "has no 'mass', which a piston must have"},
        {"walls.left.piston.damping=-1", "expected a number of at least 0"},
        {"walls.left.piston.forc=[1, 0]", "did you mean 'force'?"},
        {"walls.left.piston.velocity=[1, 0]",
         "piston 'left' has the velocity [1, 0], expected 0 in the component that 'hold' names"},
        {"walls.left.piston.force=[1, 0]", "piston 'left' has the force [1, 0], but 'hold: both'"},
        {"walls.left.piston={mass: 1, path: {velocity: [1, 0]}}",
         "piston 'left' has a path that no component follows"},
        {"walls.left.path={velocity: [1, 0]}", "walls.left has both 'piston' and 'path'"},
        {"phases.load.pistons.middle={force: [1, 0]}", "there is no wall 'middle'"},
        {"walls.right={box: [0.05, -20, 10, 30], side: outside}",
         "wall 'right' is no piston, expected one with the key 'piston'"},
        {"phases.load.pistons.left.mass=3", "unknown key 'mass'"},
        {"expect=[{quantity: piston-work, below: 1}]",
         "piston-work is measured of one piston, expected the key `wall`"},
        {"expect=[{quantity: piston-work, wall: up, below: 1}]", "there is no wall 'up'"},
        {"measure=[piston-wrk]", "did you mean piston-work?"},
    };
    for (size_t n = 0; n < sizeof wrong / sizeof wrong[0]; ++n) {
        fw_observer *observer = NULL;
        fw_scenario *scenario = NULL;
        fw_measurement *measurement = NULL;
        error = (fw_error){0};
        const fw_status status = try_with(&wrong[n].setting, 1, &observer, &scenario, &measurement);
        if (status != FW_BAD_INPUT || !strstr(error.sentence, wrong[n].words))
            fail_msg("%s: '%s' does not speak of '%s'", wrong[n].setting, error.sentence,
                     wrong[n].words);
        release(observer, scenario, measurement);
    }
}

static const char automaton[] = "title: an automaton before a piston\n"
                                "materials: {foam: {elastic-automaton: {c1: 0.8, c2: 0.4}}}\n"
                                "bodies: {block: {material: foam, shape: {rectangle: [4, 4]}}}\n"
                                "walls:\n"
                                "  floor: {chain: [[-9, -1], [9, -1]]}\n"
                                "  press: {box: [-9, 4, 9, 6], side: outside, piston: {mass: 3}}\n"
                                "measure: [piston-work]\n"
                                "run: {steps: 4}\n";

static void a_piston_may_stand_before_an_automaton(void **state)
{
    (void)state;
    fw_scenario *scenario;
    fw_observer *observer;
    assert_fine(fw_scenario_read(&scenario, "automaton.yaml", automaton, strlen(automaton), NULL, 0,
                                 &error));
    assert_fine(fw_observer_create(&observer, scenario, &error));
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

static fw_status read_meeting(fw_scenario **scenario, const char *setting)
{
    return fw_scenario_read(scenario, "meets.yaml", automaton, strlen(automaton), &setting, 1,
                            &error);
}

static void whom_a_piston_meets_must_be_there_and_another(void **state)
{
    (void)state;
    fw_scenario *scenario;
    assert_refused(read_meeting(&scenario, "walls.press.piston.meets=[flor]"), FW_BAD_INPUT,
                   "there is no wall 'flor'");
    assert_refused(read_meeting(&scenario, "walls.press.piston.meets=[press]"), FW_BAD_INPUT,
                   "piston 'press' meets itself, expected other walls");
    assert_refused(read_meeting(&scenario, "walls.press.piston.meets=[floor, floor]"), FW_BAD_INPUT,
                   "piston 'press' meets 'floor' a second time, expected each once");
    assert_fine(read_meeting(&scenario, "walls.press.piston.meets=[floor]"));
    fw_scenario_destroy(scenario);
}

/* A wall that is no piston has no work of its own. */
static void quantities_of_pistons_are_asked_of_pistons(void **state)
{
    (void)state;
    const char *settings[] = {"bodies.block.material=foam",
                              "materials.foam={lattice-boltzmann: {rest-mass: 0}}",
                              "expect=[{quantity: piston-work, wall: floor, below: 1}]"};
    fw_scenario *scenario;
    fw_observer *observer;
    fw_measurement *measurement;
    assert_fine(fw_scenario_read(&scenario, "block.yaml", automaton, strlen(automaton), settings, 3,
                                 &error));
    assert_fine(fw_observer_create(&observer, scenario, &error));
    assert_refused(fw_measurement_create(&measurement, observer, &error), FW_BAD_INPUT,
                   "piston-work is measured of pistons, and the wall floor is none");
    release(observer, scenario, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hard_pistons_press_a_crystal),
        cmocka_unit_test(soft_pistons_press_a_crystal),
        cmocka_unit_test(where_pistons_are_is_always_measured),
        cmocka_unit_test(mistakes_are_refused),
        cmocka_unit_test(a_piston_may_stand_before_an_automaton),
        cmocka_unit_test(whom_a_piston_meets_must_be_there_and_another),
        cmocka_unit_test(quantities_of_pistons_are_asked_of_pistons),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
