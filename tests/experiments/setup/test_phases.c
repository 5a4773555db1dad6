/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_phases.c - what phases of a scenario do to grips and pistons: where the time of a drive
 * begins, what a phase keeps of it, what is refused, and jumps that are warned of. */
#include "tests/support/laws.h"

#include "core/particles/particles.h"
#include "experiments/measures/warning.h"
#include "experiments/setup/experiment.h"
#include "experiments/setup/phase.h"
#include "tests/support/scratch.h"

/* The first phase ends at a quarter of a period, where a time that counts from the start of the run
 * has the force at its largest. */
enum { FIRST = 10, SECOND = 20, LAST = 30 };
static const double step = 0.005, period = 0.2;

static const char driven[] =
    "title: a grip and a piston in three phases\n"
    "materials: {m: {movable-particles: {}}}\n"
    "bodies:\n"
    "  a: {material: m, lattice: hexagonal, shape: {rectangle: [4, 4]}}\n"
    "walls:\n"
    "  stamp: {box: [-50, 90, 50, 99], side: outside, piston: {mass: 9, damping: 0.1,\n"
    "    force: [0, 1], amplitude: [0, 8], period: 0.2}}\n"
    "grips: {hand: {body: a, force: [0.5, 1], amplitude: [0, 8], period: 0.2, tether: [0, 0]}}\n"
    "dynamics: {time-step: 0.005}\n"
    "phases:\n"
    "  first: {until: 10, grips: {hand: {amplitude: [0, 0]}}, pistons: {stamp: {amplitude: [0, "
    "0]}}}\n"
    "  second: {until: 20}\n"
    "  last: {until: 30}\n"
    "run: {steps: 30}\n";

enum { SETTINGS = 4 };

static fw_status create(fw_experiment **experiment, fw_scenario **scenario,
                        const char *const settings[SETTINGS])
{
    int count = 0;
    *experiment = NULL;
    *scenario = NULL;
    while (count < SETTINGS && settings[count]) count += 1;
    FW_TRY(fw_scenario_read(scenario, "t.yaml", driven, strlen(driven), settings, count, &error));
    return fw_experiment_create(experiment, *scenario, &error);
}

static void release(fw_experiment *experiment, fw_scenario *scenario)
{
    fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
}

/* The force of each step, before, at and after the edges of the phases: none in the first phase,
 * then a sine of the time since the beginning of the run, or of the second phase. */
static void time_counts_from_the_run_or_a_phase(void **state)
{
    (void)state;
    static const struct {
        const char *settings[SETTINGS];
        int origin;
    } cases[] = {
        {{NULL}, 0},
        {{"grips.hand.time-from=first", "walls.stamp.piston.time-from=first"}, 0},
        {{"grips.hand.time-from=second", "walls.stamp.piston.time-from=second"}, FIRST},
        {{"phases.second.grips={hand: {time-from: second}}",
          "phases.second.pistons={stamp: {time-from: second}}",
          "phases.last.grips={hand: {time-from: second}}",
          "phases.last.pistons={stamp: {time-from: second}}"},
         FIRST},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_experiment *experiment;
        fw_scenario *scenario;
        assert_fine(create(&experiment, &scenario, cases[n].settings));
        for (int s = 0; s < LAST; ++s) {
            assert_fine(fw_experiment_step(experiment, &error));
            const fw_vec2 hand =
                fw_grip_observe_ledger(fw_scene_observe_grip(experiment->scene, 0))->force;
            const fw_vec2 stamp =
                fw_piston_observe_ledger(fw_scene_observe_piston(experiment->scene, 0))->force;
            const double swing =
                s < FIRST ? 0 : 8 * sin(FW_TWO_PI * (s - cases[n].origin) * step / period);
            assert_close(stamp.x, 0, 0);
            assert_close(stamp.y, 1 + swing, 1e-13);
            assert_close(hand.x, 0.5, 1e-10);
            assert_close(hand.y, 1 + swing, 1e-10);
            /* The first step of the phase has time 0, not a rounding. */
            if (s == FIRST && cases[n].origin == FIRST) assert_close(stamp.y, 1, 0);
        }
        release(experiment, scenario);
    }
}

/* The bath of a phase is its own also where it has none, and only there. */
static void a_phase_may_have_a_bath_of_temperature_none(void **state)
{
    (void)state;
    static const char *const settings[SETTINGS] = {
        "dynamics={time-step: 0.005, damping: 2, temperature: 0.001}",
        "phases.second.temperature=0", "phases.last.damping=0", NULL};
    fw_experiment *experiment;
    fw_scenario *scenario;
    assert_fine(create(&experiment, &scenario, settings));
    for (int s = 0; s < LAST; ++s) {
        assert_fine(fw_experiment_step(experiment, &error));
        const fw_langevin_controls *controls =
            fw_particles_controls(fw_experiment_particles(experiment));
        assert_close(controls->temperature, s >= FIRST && s < SECOND ? 0 : .001, 0);
        assert_close(controls->damping, s < SECOND ? 2 : 0, 0);
    }
    release(experiment, scenario);
}

/* A path begins where its time does, and what it holds goes on with its velocity. */
static void path_counts_from_a_phase(void **state)
{
    (void)state;
    static const char *const settings[SETTINGS] = {
        "grips.hand={body: a, hold: both, time-from: second, path: {velocity: [2, 0], until: 0.02, "
        "amplitude: [0, 0.1], period: 0.2}}",
        "phases.first.grips={hand: {tether: [0, 0]}}", NULL};
    fw_experiment *experiment;
    fw_scenario *scenario;
    assert_fine(create(&experiment, &scenario, settings));
    const double rate = FW_TWO_PI / period;
    for (int s = 1; s <= LAST; ++s) {
        assert_fine(fw_experiment_step(experiment, &error));
        const fw_vec2 way =
            fw_grip_observe_ledger(fw_scene_observe_grip(experiment->scene, 0))->displacement;
        const double t = (s - FIRST) * step;
        assert_close(way.x, 2 * fmin(fmax(t, 0), 0.02), 1e-14);
        /* From -1/4 of a period, where the sine is -1. */
        assert_close(way.y, 0.1 * (sin(rate * t) + 1), 1e-14);
        const fw_solid *solid = fw_experiment_solid(experiment, 0); /* of particles of mass 1 */
        const fw_vec2 velocity = fw_vec2_scale(1.0 / solid->count, fw_solid_momentum(solid));
        assert_close(velocity.x, s > FIRST && s <= FIRST + 4 ? 2 : 0, 1e-12);
        assert_close(velocity.y, 0.1 * rate * cos(rate * t), 1e-12);
    }
    release(experiment, scenario);
}

/* The second phase changes one thing of a drive. The rest is the grip's own, whatever the phase
 * before said, and so is all of it in the third. */
static void phase_changes_single_numbers(void **state)
{
    (void)state;
    static const struct {
        const char *change;
        fw_drive wanted;
    } cases[] = {
        {"{tether: [0, 3]}",
         {.force = {0.5, 1}, .amplitude = {0, 8}, .period = .2, .tether = {0, 3}}},
        {"{force: [7, 0]}", {.force = {7, 0}, .amplitude = {0, 8}, .period = 0.2}},
        {"{amplitude: [2, 3]}", {.force = {0.5, 1}, .amplitude = {2, 3}, .period = 0.2}},
        {"{period: 0.5}", {.force = {0.5, 1}, .amplitude = {0, 8}, .period = 0.5}},
        {"{phase: 90}",
         {.force = {0.5, 1}, .amplitude = {0, 8}, .period = 0.2, .phase = FW_PI / 2}},
        {"{time-from: last}",
         {.force = {0.5, 1}, .amplitude = {0, 8}, .period = 0.2, .origin = 0.1}},
        {"{hold: x}",
         {.force = {0.5, 1}, .amplitude = {0, 8}, .period = 0.2, .prescribed_x = true}},
        {"{}", {.force = {0.5, 1}, .amplitude = {0, 8}, .period = 0.2}},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n)
        for (int phase = 1; phase < 3; ++phase) {
            char grip[128], piston[128];
            snprintf(grip, sizeof grip, "phases.second.grips={hand: %s}", cases[n].change);
            snprintf(piston, sizeof piston, "phases.second.pistons={stamp: %s}", cases[n].change);
            const char *const settings[SETTINGS] = {grip, piston,
                                                    "walls.stamp.piston.force=[0.5, 1]", NULL};
            const fw_drive own = cases[sizeof cases / sizeof *cases - 1].wanted;
            const fw_drive *wanted = phase == 1 ? &cases[n].wanted : &own;
            fw_experiment *experiment;
            fw_scenario *scenario;
            assert_fine(create(&experiment, &scenario, settings));
            const fw_drive found[] = {fw_phase_grip(scenario, experiment->scene, phase, 0),
                                      fw_phase_piston_drive(scenario, experiment->scene, phase, 0)};
            for (int k = 0; k < 2; ++k) {
                assert_close(found[k].force.x, wanted->force.x, 0);
                assert_close(found[k].force.y, wanted->force.y, 0);
                assert_close(found[k].amplitude.x, wanted->amplitude.x, 0);
                assert_close(found[k].amplitude.y, wanted->amplitude.y, 0);
                assert_close(found[k].period, wanted->period, 0);
                assert_close(found[k].phase, wanted->phase, 1e-15);
                assert_close(found[k].origin, wanted->origin, 0);
                assert_close(found[k].tether.y, wanted->tether.y, 0);
                assert_int_equal(found[k].prescribed_x, wanted->prescribed_x);
                assert_int_equal(found[k].prescribed_y, wanted->prescribed_y);
            }
            release(experiment, scenario);
        }
}

/* A piston on which only its damping acts keeps exp(-damping t) of its velocity. A phase says
 * another number, 0 too, or nothing: then it is the piston's own. */
static void phase_changes_the_damping_of_a_piston(void **state)
{
    (void)state;
    static const char *const settings[SETTINGS] = {
        "walls.stamp.piston={mass: 9, damping: 0.1, velocity: [0, 2]}",
        "phases.first.pistons={stamp: {damping: 0}}", "phases.last.pistons={stamp: {damping: 3}}"};
    static const double damping[] = {0, 0.1, 3};
    fw_experiment *experiment;
    fw_scenario *scenario;
    double expected = 2;
    assert_fine(create(&experiment, &scenario, settings));
    for (int s = 0; s < LAST; ++s) {
        assert_fine(fw_experiment_step(experiment, &error));
        const fw_piston_ledger *ledger =
            fw_piston_observe_ledger(fw_scene_observe_piston(experiment->scene, 0));
        expected *= exp(-damping[s / FIRST] * step);
        assert_close(ledger->velocity.y, expected, 1e-13);
        assert_close(ledger->heat, 0.5 * 9 * (4 - expected * expected), 1e-12);
    }
    release(experiment, scenario);
}

/* A path is one thing: that of the phase takes the place of the own one, window and all. A phase
 * may let go what has a path, and hold what has forces, without taking back what is not its own. */
static void phase_changes_a_path_as_a_whole(void **state)
{
    (void)state;
    static const char *const settings[SETTINGS] = {
        "grips.hand={body: a, hold: x, path: {velocity: [2, 0], until: 0.02}, force: [0, 1]}",
        "phases.first.grips={hand: {path: {velocity: [3, 0]}}}",
        "phases.second.grips={hand: {hold: none}}", "phases.last.grips={hand: {hold: both}}"};
    fw_experiment *experiment;
    fw_scenario *scenario;
    assert_fine(create(&experiment, &scenario, settings));
    fw_drive drive = fw_phase_grip(scenario, experiment->scene, 0, 0);
    assert_true(drive.prescribed_x && !drive.prescribed_y);
    assert_close(drive.path.velocity.x, 3, 0);
    assert_true(drive.path.until > 1e9);
    drive = fw_phase_grip(scenario, experiment->scene, 1, 0);
    assert_true(!drive.prescribed_x && !drive.prescribed_y);
    drive = fw_phase_grip(scenario, experiment->scene, 2, 0);
    assert_true(drive.prescribed_x && drive.prescribed_y);
    assert_close(drive.path.until, 0.02, 0);
    release(experiment, scenario);
}

static void what_does_not_go_together_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *settings[SETTINGS];
        const char *words;
    } cases[] = {
        {{"grips.hand={body: a}", "phases.first.grips={}", "phases.last.grips={hand: {phase: 30}}"},
         "grip 'hand' has 'phase' but no 'period', without which it means nothing"},
        {{"grips.hand={body: a}", "phases.first.grips={}",
          "phases.last.grips={hand: {amplitude: [0, 1]}}"},
         "grip 'hand' has 'amplitude' but no 'period', without which it means nothing"},
        {{"grips.hand={body: a}", "phases.first.grips={}", "phases.last.grips={hand: {period: 1}}"},
         "grip 'hand' has 'period' but no 'amplitude', without which it means nothing"},
        {{"grips.hand={body: a, time-from: last}", "phases.first.grips={}"},
         "grip 'hand' has 'time-from' but neither 'period' nor 'path', without which it means "
         "nothing"},
        {{"walls.stamp.piston={mass: 1}", "phases.first.pistons={}",
          "phases.last.pistons={stamp: {time-from: last}}"},
         "piston 'stamp' has 'time-from' but neither 'period' nor 'path', without which it means "
         "nothing"},
        {{"grips.hand.time-from=lst"}, "there is no phase 'lst'; did you mean 'last'?"},
        {{"phases.last.grips={hand: {time-from: secnd}}"},
         "there is no phase 'secnd'; did you mean 'second'?"},
        {{"phases.last.grips={hand: {path: {velocity: [1, 0]}}}"},
         "grip 'hand' has a path that no component follows"},
        {{"phases.last.grips={hand: {hold: y, force: [0, 2]}}"},
         "grip 'hand' has the force [0, 2], but 'hold: y' moves that component"},
        {{"grips.hand={body: a, hold: y}", "phases.first.grips={}",
          "phases.last.grips={hand: {force: [0, 2]}}"},
         "grip 'hand' has the force [0, 2], but 'hold: y' moves that component"},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_experiment *experiment;
        fw_scenario *scenario;
        assert_refused(create(&experiment, &scenario, cases[n].settings), FW_BAD_INPUT,
                       cases[n].words);
        release(experiment, scenario);
    }
}

/* The first phase ends at a quarter of a period, the second at a half. */
static void jump_of_a_force_is_warned_of(void **state)
{
    (void)state;
    static const struct {
        const char *settings[SETTINGS];
        int count;
        const char *words;
    } cases[] = {
        {{NULL},
         2,
         "phase second: the oscillating force on grip hand begins with a jump of 8, 1 of its "
         "amplitude, since its time is not counted from here; 'time-from: second' lets it begin at "
         "0\n"},
        {{"grips.hand.phase=30", "walls.stamp.piston.time-from=second"},
         1,
         "of 6.93, 0.87 of its amplitude, since its time is not counted from here; 'time-from: "
         "second' without 'phase' lets it begin at 0\n"},
        {{"grips.hand.time-from=second"}, 1, "piston stamp begins"},
        {{"grips.hand.time-from=second", "walls.stamp.piston.time-from=second"}, 0, NULL},
        /* A phase that begins where the force is largest, as its own 'phase' says. */
        {{"grips.hand.time-from=second", "grips.hand.phase=90",
          "walls.stamp.piston.time-from=second"},
         0,
         NULL},
        {{"grips.hand.time-from=second", "walls.stamp.piston.time-from=second",
          "phases.last.grips={hand: {period: 0.5}}"},
         1,
         "phase last: the oscillating force on grip hand goes on with a jump of -3.3, 0.41 of its"},
        {{"grips.hand.time-from=second", "walls.stamp.piston.time-from=second",
          "phases.second.until=15", "phases.last.grips={hand: {amplitude: [0, 4]}}"},
         1,
         "phase last: the oscillating force on grip hand goes on with a jump of -2.83, 0.71 of its "
         "amplitude; 'time-from', 'period' and 'phase' as in the phase before continue it, and an "
         "'until' at which it is 0 lets the amplitude change\n"},
        /* What is held follows its path, whatever the force does. */
        {{"phases.second.grips={hand: {hold: both}}", "phases.last.grips={hand: {hold: both}}",
          "walls.stamp.piston.time-from=second"},
         0,
         NULL},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_experiment *experiment;
        fw_scenario *scenario;
        char *said;
        size_t length;
        fw_warning warning = {.out = open_memstream(&said, &length)};
        assert_fine(create(&experiment, &scenario, cases[n].settings));
        assert_fine(fw_warning_look(&warning, experiment, &error));
        assert_fine(fw_warning_look(&warning, experiment, &error)); /* says nothing twice */
        fclose(warning.out);
        if (warning.count != cases[n].count) fail_msg("case %d: %s", (int)n, said);
        if (cases[n].words && !strstr(warning.text, cases[n].words))
            fail_msg("'%s' is not in: %s", cases[n].words, warning.text);
        free(said);
        fw_warning_clear(&warning);
        release(experiment, scenario);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(time_counts_from_the_run_or_a_phase),
        cmocka_unit_test(a_phase_may_have_a_bath_of_temperature_none),
        cmocka_unit_test(path_counts_from_a_phase),
        cmocka_unit_test(phase_changes_single_numbers),
        cmocka_unit_test(phase_changes_the_damping_of_a_piston),
        cmocka_unit_test(phase_changes_a_path_as_a_whole),
        cmocka_unit_test(what_does_not_go_together_is_refused),
        cmocka_unit_test(jump_of_a_force_is_warned_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
