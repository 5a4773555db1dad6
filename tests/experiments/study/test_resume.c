/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_resume.c - a run that was interrupted, after whichever step and however often, ends with the
 * datasets of the run that was not: with noise, friction, damping, fracture, moving walls and a
 * reversed arrow of time, in half-steps, for any number of threads before and after. */
#include "tests/support/laws.h"

#include "experiments/study/interrupt.h"
#include "experiments/study/run.h"
#include "tests/support/scratch.h"

#include <signal.h>

/* Recorded and measured at odds with each other, so that interruptions fall between everything. */
#define RUN "run: {steps: 24, record-every: 5, measure-every: 2, seed: 11"
#define ALL "record: {velocity: true, force: true, fields: [energy, links]}\n"

static const char rubs[] =
    "title: a sheet rubs on two floors under random forces\n"
    "materials: {felt: {lattice-boltzmann: {rest-mass: 0.4, damping: 0.02}}}\n"
    "bodies: {sheet: {material: felt, shape: {rectangle: [5, 4]}, origin: [0, 0.13],"
    " velocity: [0.11, -0.05], velocities: [{random: 0.15}]}}\n"
    "walls:\n"
    "  floor: {chain: [[-50, 0], [50, 0]], surface: {coulomb: 0.3}}\n"
    "  ceiling: {chain: [[50, 3.15], [-50, 3.15]], surface: {coulomb: 0.1}}\n"
    "forces: {shaking: {body: sheet, random: 0.02}}\n"
    "measure: [energy, momentum, reaction, friction-heat, dissipated, contacts-so-far,"
    " certificate-creep, body-stuck]\n"
    "record: {velocity: true, force: true, fields: [energy, friction-heat, rubbing, sliding]}\n" RUN
    "}\n";

static const char breaks[] =
    "title: a bar is torn\n"
    "materials: {glass: {lattice-boltzmann: {rest-mass: [0.5, 0.2, 0.7], break-at: 0.3}}}\n"
    "bodies: {bar: {material: glass, shape: {rectangle: [9, 4]},"
    " link-stiffness: [{sites: [[4, 0], [4, 1]], links: touching, value: 0.5}]}}\n"
    "forces:\n"
    "  left: {body: bar, sites: left, force: [-0.4, 0]}\n"
    "  right: {body: bar, sites: right, force: [0.4, 0], ramp: 5}\n"
    "measure: [energy, energy-error, momentum, broken-links, fracture-energy]\n" ALL RUN "}\n";

static const char shoved[] =
    "title: two bodies in a ring that shakes\n"
    "materials:\n"
    "  light: {lattice-boltzmann: {}}\n"
    "  heavy: {lattice-boltzmann: {rest-mass: 1.2, damping: 0.03}}\n"
    "bodies:\n"
    "  one: {material: light, shape: {disc: 2}, origin: [-3, 0.2], velocity: [-0.1, 0.05]}\n"
    "  two: {material: heavy, shape: {rectangle: [3, 3]}, origin: [2.1, -1], velocity: [0.2, 0]}\n"
    "walls:\n"
    "  ring: {circle: [0, 0, 5.5], path: {amplitude: [0.4, 0.1], period: 13, phase: 30}}\n"
    "  floor: {box: [-20, -2.2, 20, 40], surface: stick, path: {velocity: [0.01, 0.1]}}\n"
    "measure: [energy, momentum, wall-work, reaction, contacts-so-far]\n" ALL RUN "}\n";

static const char turns_back[] =
    "title: a sheet hits a corner and returns\n"
    "materials: {rubber: {lattice-boltzmann: {}}}\n"
    "bodies: {sheet: {material: rubber, shape: {rectangle: [4, 4]}, origin: [0.31, 0.47],"
    " velocity: [-0.1, -0.12]}}\n"
    "walls: {container: {box: [0, 0, 20, 20]}}\n"
    "measure: [energy, momentum, reaction, return-error, contacts-so-far]\n" ALL RUN
    ", reverse-at: 13}\n";

static const char thermal[] =
    "title: two crystals and a net in a heat bath over a rough floor\n"
    "materials:\n"
    "  grain: {movable-particles: {return-force: {amplitude: 0.4}}}\n"
    "  other: {movable-particles: {mass: 1.5, return-force: {amplitude: 0.5, axes: lab}}}\n"
    "  net: {linear-lattice: {k1: 5, k2: 20}}\n"
    "dynamics: {time-step: 0.02, damping: 0.5, temperature: 0.1}\n"
    "bodies:\n"
    "  low: {material: grain, lattice: hexagonal, shape: {rectangle: [5, 3]}, origin: [0, 0.05],"
    " velocity: [0.8, -0.8]}\n"
    "  high: {material: other, lattice: hexagonal, angle: 20, shape: {rectangle: [4, 2]},"
    " origin: [1, 2.9]}\n"
    "  sieve: {material: net, lattice: hexagonal, shape: {disc: 2}, origin: [12, 2.02],"
    " velocity: [0, -1]}\n"
    "walls: {floor: {chain: [[-50, 0], [50, 0]], surface: {coulomb: 0.3}}}\n"
    "measure: [energy, momentum, reaction, friction-heat, dissipated, contacts-so-far]\n"
    "record: {velocity: true, force: true, fields: [bond-force]}\n" RUN "}\n";

static const char soft[] =
    "title: a hot gas is squeezed by soft walls that breathe\n"
    "materials: {gas: {movable-particles: {return-force: {amplitude: 0.5, axes: surface}}}}\n"
    "dynamics: {time-step: 0.01, damping: 0.8, temperature: 0.6}\n"
    "bodies: {gas: {material: gas, shape: {placed: {count: 40, box: [0.02, 0.02, 9.98, 9.98],"
    " min-distance: 0.9}}, temperature: 2}}\n"
    "walls:\n"
    "  box: {box: [0, 0, 10, 10], surface: {penalty: 40},"
    " path: {amplitude: [0.4, 0.3], period: 0.2}}\n"
    "  ball: {circle: [5, 5, 0.2], side: outside, surface: {penalty: 60}}\n"
    "measure: [energy, momentum, wall-energy, wall-work, thermostat-heat, local-order, "
    "contacts-so-far]\n"
    "record: {velocity: true, force: true, fields: [local-order]}\n" RUN "}\n";

static const char phased[] =
    "title: grips rub two crystals in three phases\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "dynamics: {time-step: 0.01, damping: 0.4, temperature: 0.01}\n"
    "bodies:\n"
    "  left: {material: grain, lattice: hexagonal, shape: {rectangle: [4, 6]}, origin: [-4, 0]}\n"
    "  right: {material: grain, lattice: hexagonal, shape: {rectangle: [4, 6]}, origin: [0.5, "
    "0.3]}\n"
    "grips:\n"
    "  left: {body: left, side: left, layer: 1.2, force: [9, 0], tether: [0, 2]}\n"
    "  right: {body: right, side: right, layer: 1.2, hold: x, path: {velocity: [-0.5, 0]}}\n"
    "phases:\n"
    "  settle: {until: 6, damping: 1}\n"
    "  drive: {until: 14, temperature: 0.2, grips: {left: {force: [9, 3], amplitude: [0, 9],"
    " period: 0.05, time-from: drive}}}\n"
    "  sample: {until: 24, grips: {left: {tether: [0, 1]}, right: {hold: both, time-from: sample,"
    " path: {velocity: [0, -0.5], until: 0.06}}}}\n"
    "profile: {axis: x, phase: sample, every: 3, bin: 0.9, far: [2, 4]}\n"
    "measure: [energy, momentum, slip, grip-work, grip-path-length, thermostat-heat, "
    "contact-return-force]\n"
    "record: {velocity: true, force: true, fields: [return-force]}\n" RUN "}\n";

static const char pressed[] =
    "title: pistons press a hot crystal and a sheet in two phases\n"
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "dynamics: {time-step: 0.01, damping: 0.4, temperature: 0.1}\n"
    "bodies:\n"
    "  slab: {material: grain, lattice: hexagonal, shape: {rectangle: [6, 5]}}\n"
    "walls:\n"
    "  left: {box: [-9, -9, -0.01, 20], side: outside, surface: {coulomb: 0.3},"
    " piston: {mass: 4, damping: 0.3, force: [30, 1], tether: [0, 2]}}\n"
    "  right: {box: [5.52, -9, 20, 20], side: outside, surface: {penalty: 80},"
    " piston: {mass: 3, velocity: [-1, 0], hold: y}}\n"
    "phases:\n"
    "  press: {until: 9}\n"
    "  swing: {until: 24, pistons: {left: {force: [20, 0], amplitude: [0, 30], period: 0.04,"
    " time-from: swing, damping: 0}, right: {hold: both, path: {velocity: [-0.5, 0.1]}}}}\n"
    "measure: [energy, momentum, wall-work, friction-heat, wall-energy, piston-velocity, "
    "piston-work, piston-heat,"
    " piston-path-length, piston-torque, contacts-so-far]\n"
    "record: {velocity: true, force: true}\n" RUN "}\n";

/* More particles than one thread takes at a time. */
static const char large[] =
    "title: a large sheet rubs\n"
    "materials: {felt: {lattice-boltzmann: {rest-mass: 0.4, damping: 0.03, break-at: 0.3}}}\n"
    "bodies: {sheet: {material: felt, shape: {rectangle: [96, 90]}, origin: [0, 0.07],"
    " velocity: [0.1, -0.08], velocities: [{random: 0.2}]}}\n"
    "walls: {floor: {chain: [[-500, 0], [500, 0]], surface: {coulomb: 0.3}}}\n"
    "forces: {shaking: {body: sheet, random: 0.1, balanced: true}}\n"
    "measure: [energy, momentum, reaction, friction-heat, broken-links, contacts-so-far]\n"
    "run: {steps: 9, record-every: 4, seed: 5}\n";

static const char ticks[] =
    "title: an automaton is torn on a floor that swings\n"
    "materials: {foam: {elastic-automaton: {c1: 0.8, c2: 0.4, damping: 0.02, black: odd,"
    " break-at: 0.45}}}\n"
    "bodies: {block: {material: foam, shape: {rectangle: [9, 5]}, origin: [0, 0.7],"
    " velocity: [0.1, -0.1], velocities: [{random: 0.2}]}}\n"
    "walls:\n"
    "  floor: {chain: [[-50, -2], [50, 2]], surface: {coulomb: 0.3},"
    " path: {amplitude: [0, 0.2], period: 9}}\n"
    "forces:\n"
    "  shaking: {body: block, random: 0.05}\n"
    "  left: {body: block, sites: left, force: [-0.1, 0]}\n"
    "  right: {body: block, sites: right, force: [0.1, 0], ramp: 5}\n"
    "measure: [energy, momentum, wall-work, friction-heat, dissipated, broken-bonds,"
    " contacts-so-far]\n"
    "record: {velocity: true, force: true, fields: [energy, displacement-x]}\n" RUN "}\n";

/* Colours of more cells than one thread takes. */
static const char large_ticks[] =
    "title: a large automaton rubs\n"
    "materials: {foam: {elastic-automaton: {c1: 1, c2: 0.6, damping: 0.03}}}\n"
    "bodies: {block: {material: foam, shape: {rectangle: [190, 180]}, origin: [0, 0.16],"
    " velocity: [0.1, -0.08], velocities: [{random: 0.2}]}}\n"
    "walls: {floor: {chain: [[-500, 0], [500, 0]], surface: {coulomb: 0.3}}}\n"
    "forces: {shaking: {body: block, random: 0.1, balanced: true}}\n"
    "measure: [energy, momentum, reaction, friction-heat, dissipated, contacts-so-far]\n"
    "run: {steps: 6, record-every: 4, seed: 5}\n";

static fw_scenario *read_scenario(const char *text)
{
    fw_scenario *scenario;
    assert_fine(fw_scenario_read(&scenario, "test", text, strlen(text), NULL, 0, &error));
    return scenario;
}

static fw_run_options options_for(const char *folder, int threads)
{
    return (fw_run_options){.directory = folder, .threads = threads, .name = "test"};
}

static fw_run *begin(const fw_scenario *scenario, const char *folder, int threads)
{
    fw_run *run;
    fw_run_options options = options_for(folder, threads);
    assert_fine(fw_run_begin(&run, scenario, &options, &error));
    return run;
}

static fw_run *resume(const fw_scenario *scenario, const char *folder, int threads)
{
    fw_run *run;
    char note[FW_SENTENCE_SIZE];
    fw_run_options options = options_for(folder, threads);
    assert_fine(fw_run_resume(&run, scenario, &options, note, &error));
    assert_string_equal(note, "");
    return run;
}

/* A signal before the first step lets exactly one step happen. */
static void step_once_and_stop(fw_run *run, int signal_number, fw_status wanted)
{
    fw_interrupt_watch();
    assert_int_equal(raise(signal_number), 0);
    assert_refused(fw_run_to_end(run, &error), wanted, "interrupted after");
    fw_run_destroy(run);
    fw_interrupt_watch();
}

/* What is measured in memory is judged at the end; it must not show the interruption either. */
static void assert_same_rows(const fw_measurement *found, const fw_measurement *wanted)
{
    size_t rows = (size_t)wanted->count;
    assert_int_equal(found->count, wanted->count);
    assert_memory_equal(found->steps, wanted->steps, rows * sizeof *found->steps);
    assert_memory_equal(found->times, wanted->times, rows * sizeof *found->times);
    assert_memory_equal(found->values, wanted->values,
                        rows * (size_t)wanted->width * sizeof *found->values);
}

static void finish(fw_run *run, const fw_measurement *wanted)
{
    assert_fine(fw_run_to_end(run, &error));
    assert_same_rows(fw_run_measurement(run), wanted);
    fw_run_destroy(run);
}

static double last_value(const fw_measurement *m, const char *label)
{
    for (int n = 0; n < m->probe_count; ++n)
        if (strcmp(m->probes[n].label, label) == 0)
            return m->values[(m->count - 1) * m->width + m->probes[n].first];
    fail_msg("%s was not measured", label);
    return NAN;
}

/* Interrupts the run after each of its steps; each time a copy goes on to the end, and the run
 * itself goes on to its next step. All end like `whole`. */
static void interrupt_everywhere(const fw_scenario *scenario, const fw_measurement *wanted,
                                 const char *folder, int before, int after)
{
    char chain[128], copy[128], command[1024];
    int64_t steps = scenario->run.steps;
    snprintf(chain, sizeof chain, "%s/chain-%d-%d", folder, before, after);
    fw_run *run = begin(scenario, chain, before);
    for (int64_t step = 1; step < steps; ++step) {
        if (step % 2)
            step_once_and_stop(run, SIGTERM, FW_TERMINATED);
        else
            step_once_and_stop(run, SIGINT, FW_INTERRUPTED);
        snprintf(copy, sizeof copy, "%s/copy-%d-%d-%d", folder, before, after, (int)step);
        snprintf(command, sizeof command, "cp -r %s %s", chain, copy);
        assert_int_equal(system(command), 0);
        finish(resume(scenario, copy, after), wanted);
        run = resume(scenario, chain, before);
        assert_int_equal(fw_scene_steps(fw_run_experiment(run)->scene), step);
    }
    finish(run, wanted);
}

static void compare_datasets(const char *folder)
{
    char arguments[512];
    snprintf(arguments, sizeof arguments,
             "same %s/whole/trajectory.h5 %s/chain-*/trajectory.h5 %s/copy-*/trajectory.h5", folder,
             folder, folder);
    int status = run_python("trajectory.py", arguments);
    if (status > 0) fail_msg("a resumed run differs: trajectory.py %s", arguments);
}

/* All `labels` must have become larger than nothing: what the scenario is about did happen. */
static void check_scenario(const char *text, const char *const labels[], const int threads[][2])
{
    char folder[64], whole[128];
    make_quick_folder(folder, sizeof folder);
    snprintf(whole, sizeof whole, "%s/whole", folder);
    fw_scenario *scenario = read_scenario(text);
    fw_run *reference = begin(scenario, whole, 1);
    const fw_measurement *wanted = fw_run_measurement(reference);
    assert_fine(fw_run_to_end(reference, &error));
    for (int n = 0; labels[n]; ++n) assert_true(last_value(wanted, labels[n]) > 0);
    for (int n = 0; threads[n][0] > 0; ++n)
        interrupt_everywhere(scenario, wanted, folder, threads[n][0], threads[n][1]);
    fw_run_destroy(reference);
    fw_scenario_destroy(scenario);
    compare_datasets(folder);
    remove_folder(folder);
}

static const int one_thread[][2] = {{1, 1}, {0, 0}};
static const int any_threads[][2] = {{1, 1}, {2, 2}, {1, 2}, {2, 1}, {0, 0}};

static void rubbing_under_random_forces(void **state)
{
    (void)state;
    static const char *const labels[] = {"friction-heat", "dissipated", "contacts-so-far.floor",
                                         "contacts-so-far.ceiling", NULL};
    check_scenario(rubs, labels, any_threads);
    skip_unseen();
}

static void breaking_links(void **state)
{
    (void)state;
    static const char *const labels[] = {"broken-links.bar", "fracture-energy.bar", NULL};
    check_scenario(breaks, labels, one_thread);
    skip_unseen();
}

static void moving_walls(void **state)
{
    (void)state;
    static const char *const labels[] = {"wall-work", "contacts-so-far.floor",
                                         "contacts-so-far.ring", NULL};
    check_scenario(shoved, labels, one_thread);
    skip_unseen();
}

static void reversed_time(void **state)
{
    (void)state;
    static const char *const labels[] = {"contacts-so-far.container", NULL};
    check_scenario(turns_back, labels, one_thread);
    skip_unseen();
}

static void particles_in_a_heat_bath(void **state)
{
    (void)state;
    static const char *const labels[] = {"friction-heat", "dissipated", "contacts-so-far.floor",
                                         NULL};
    check_scenario(thermal, labels, any_threads);
    skip_unseen();
}

static void phases_of_grips_and_their_profile(void **state)
{
    (void)state;
    static const char *const labels[] = {"grip-work.left", "grip-path-length.right",
                                         "thermostat-heat", "contact-return-force", NULL};
    check_scenario(phased, labels, any_threads);
    skip_unseen();
}

static void pistons_in_phases(void **state)
{
    (void)state;
    static const char *const labels[] = {"friction-heat",        "wall-energy",
                                         "piston-heat.left",     "piston-path-length.right",
                                         "contacts-so-far.left", NULL};
    check_scenario(pressed, labels, any_threads);
    skip_unseen();
}

static void soft_walls_and_noise(void **state)
{
    (void)state;
    static const char *const labels[] = {"wall-energy", "thermostat-heat", "contacts-so-far.box",
                                         NULL};
    check_scenario(soft, labels, any_threads);
    skip_unseen();
}

static void large_bodies_with_threads_switched(void **state)
{
    (void)state;
    static const char *const labels[] = {"friction-heat", "broken-links.sheet",
                                         "contacts-so-far.floor", NULL};
    check_scenario(large, labels, any_threads);
    skip_unseen();
}

static void half_steps(void **state)
{
    (void)state;
    static const char *const labels[] = {"friction-heat", "dissipated", "broken-bonds.block",
                                         "contacts-so-far.floor", NULL};
    check_scenario(ticks, labels, one_thread);
    skip_unseen();
}

static void large_automata_with_threads_switched(void **state)
{
    (void)state;
    static const char *const labels[] = {"friction-heat", "dissipated", "contacts-so-far.floor",
                                         NULL};
    check_scenario(large_ticks, labels, any_threads);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rubbing_under_random_forces),
        cmocka_unit_test(breaking_links),
        cmocka_unit_test(moving_walls),
        cmocka_unit_test(reversed_time),
        cmocka_unit_test(particles_in_a_heat_bath),
        cmocka_unit_test(phases_of_grips_and_their_profile),
        cmocka_unit_test(pistons_in_phases),
        cmocka_unit_test(soft_walls_and_noise),
        cmocka_unit_test(large_bodies_with_threads_switched),
        cmocka_unit_test(half_steps),
        cmocka_unit_test(large_automata_with_threads_switched),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
