/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_measures_short_memory.c - every allocation of what is measured, and of what is built to be
 * measured, fails once. Numbers that could not be measured are NaN: never others. */
#include "tests/support/short_memory.h"

#include "experiments/measures/certificate.h"
#include "experiments/measures/measurement.h"
#include "experiments/storage/checksum.h"
#include "tests/support/scenarios.h"
#include "tests/support/small_scenarios.h"

/* --- single quantities --- */

static const char two_crystals[] =
    "title: two crystals, one of them held by a side\n"
    "materials: {m: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"
    "bodies:\n"
    "  a: {material: m, lattice: hexagonal, shape: {rectangle: [4, 3]}, temperature: 1}\n"
    "  b: {material: m, lattice: hexagonal, shape: {rectangle: [3, 3]}, origin: [30, 0],\n"
    "    temperature: 1}\n"
    "grips: {g: {body: a, side: left, layer: .5}}\n"
    "dynamics: {time-step: 0.005}\n"
    "run: {steps: 1}\n";

static const char sheet[] = "title: a sheet\n"
                            "materials: {soft: {lattice-boltzmann: {rest-mass: 1}}}\n"
                            "bodies: {a: {material: soft, shape: {rectangle: [4, 3]}}}\n"
                            "run: {steps: 1}\n";

static const struct {
    const char *text, *name;
    int body;
} quantities[] = {
    {two_crystals, "temperature", 0},      {two_crystals, "temperature", -1},
    {two_crystals, "largest-cluster", 1},  {two_crystals, "largest-cluster", -1},
    {two_crystals, "return-force", 0},     {two_crystals, "return-force", -1},
    {two_crystals, "relative-extent", 0},  {two_crystals, "deformation-rate", 0},
    {two_crystals, "lost-bonds", 0},       {two_crystals, "plastic-rate", 0},
    {two_crystals, "bond-order", 0},       {two_crystals, "bond-order", -1},
    {two_crystals, "gaussian-density", 0}, {two_crystals, "gaussian-density", -1},
    {sheet, "dispersion-error", 0},
};

typedef struct asked {
    const fw_experiment *experiment;
    const fw_quantity *quantity;
    int body;
} asked;

static fw_status measure(const void *input, uint64_t *result, fw_error *failed)
{
    const asked *what = input;
    double out[FW_COMPONENTS_MAX];
    const int count = fw_quantity_component_count(what->quantity);
    what->quantity->measure(what->experiment, (fw_subject){.body = what->body, .wall = -1}, out);
    for (int c = 0; c < count; ++c)
        if (isnan(out[c])) return fw_fail_memory(failed, what->quantity->name);
    *result = fw_checksum_add(FW_CHECKSUM_OF_NOTHING, out, (size_t)count * sizeof *out);
    return FW_OK;
}

static void what_could_not_be_measured_is_no_number(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof quantities / sizeof *quantities; ++n) {
        fw_scenario *scenario = read_right(quantities[n].text);
        fw_experiment *experiment = build_right(scenario);
        const asked what = {experiment, fw_quantity_find(quantities[n].name), quantities[n].body};
        assert_non_null(what.quantity);
        assert_true(fail_each_allocation(quantities[n].name, measure, &what) > 0);
        fw_experiment_destroy(experiment);
        fw_scenario_destroy(scenario);
    }
}

/* --- everything that is built --- */

static const char patterned[] =
    "title: all that a body can start with\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0.5}}}\n"
    "bodies:\n"
    "  a: {material: soft, shape: {rectangle: [4, 3]}, displacement: [{gaussian: {amplitude:\n"
    "    [.1, 0], centre: [1, 1], width: 1}}], velocities: [{sites: left, by: [.01, 0]}],\n"
    "    rest-mass: [{sites: right, value: 1}],\n"
    "    link-stiffness: [{sites: {rows: [0, 1]}, links: across, value: 2}]}\n"
    "walls: {floor: {chain: [[-9, -9], [99, -9]]},\n"
    "  lid: {box: [-9, 20, 99, 22], side: outside, piston: {mass: 3}}}\n"
    "forces: {f: {body: a, sites: right, force: [.01, 0]}}\n"
    "run: {steps: 2, measure-every: 1}\n"
    "expect: [{quantity: momentum, component: x, body: a, above: 0}]\n";

static const char linear[] =
    "title: a linear lattice\n"
    "materials: {linear: {linear-lattice: {}}}\n"
    "bodies: {d: {material: linear, lattice: hexagonal, shape: {disc: 2}, origin: [60, 0],\n"
    "    displacement: [{random: .01}], velocities: [{random: .01}]}}\n"
    "run: {steps: 2, measure-every: 1}\n";

static const char automata[] =
    "title: automata\n"
    "materials:\n"
    "  foam: {elastic-automaton: {c1: .4, c2: .3, boundary: trapezoid}}\n"
    "  round: {elastic-automaton: {c1: .4, c2: .3, boundary: periodic}}\n"
    "bodies:\n"
    "  b: {material: foam, shape: {rectangle: [4, 4]}, origin: [20, 0],\n"
    "    displacement: [{gradient: [.01, 0, 0, .02]}], velocities: [{random: .01}]}\n"
    "  c: {material: round, shape: {rectangle: [4, 4]}, origin: [40, 0], displacement:\n"
    "    [{mode: {wave-vector: [1.5707963267948966, 0], branch: slow, amplitude: .1}}]}\n"
    "run: {steps: 2, measure-every: 1}\n";

static const char profiled[] =
    "title: a profile, and phases\n"
    "materials: {m: {movable-particles: {}}}\n"
    "bodies:\n"
    "  a: {material: m, lattice: square, shape: {rectangle: [9, 4]}, origin: [-4, 0]}\n"
    "  b: {material: m, shape: {points: [[0, 20], [1, 20]]}}\n"
    "  c: {material: m, shape: {placed: {count: 3, box: [0, 30, 9, 39]}}}\n"
    "grips:\n"
    "  left: {body: a, side: left, layer: .5, hold: both, path: {velocity: [.1, 0]}}\n"
    "  right: {body: a, side: right, layer: .5}\n"
    "dynamics: {time-step: 0.005, damping: 1, temperature: .01}\n"
    "phases: {first: {until: 1}, second: {until: 2, temperature: .02, grips: {right: {force: [1, "
    "0]}}}}\n"
    "run: {steps: 2, measure-every: 1}\n"
    "profile: {axis: x, every: 1, bin: 1, contact: 0.5, far: [2.5, 4.5]}\n";

/* Everything that there is to measure beside the built; positions after two steps. */
static fw_status build(const void *input, uint64_t *result, fw_error *failed)
{
    const fw_scenario *scenario = input;
    fw_observer *observer;
    fw_measurement *measurement = NULL;
    FW_TRY(fw_observer_create(&observer, scenario, failed));
    fw_status status = fw_measurement_create(&measurement, observer, failed);
    for (int step = 0; status == FW_OK && step < 2; ++step)
        status = fw_observer_advance(observer, 1, failed);
    *result = FW_CHECKSUM_OF_NOTHING;
    for (int b = 0; status == FW_OK && b < observer->experiment->body_count; ++b) {
        const fw_solid *solid = fw_experiment_solid(observer->experiment, b);
        const size_t bytes = (size_t)solid->count * sizeof *solid->x;
        *result = fw_checksum_add(*result, solid->x, bytes);
        *result = fw_checksum_add(*result, solid->y, bytes);
    }
    fw_measurement_destroy(measurement);
    fw_observer_destroy(observer);
    return status;
}

static void what_is_built_is_whole_or_refused(void **state)
{
    (void)state;
    static const char *const texts[] = {patterned, linear,     automata,
                                        profiled,  two_blocks, held_crystal};
    for (size_t n = 0; n < sizeof texts / sizeof *texts; ++n) {
        fw_scenario *scenario = read_right(texts[n]);
        fail_each_place(scenario->title, build, scenario);
        fw_scenario_destroy(scenario);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_could_not_be_measured_is_no_number),
        cmocka_unit_test(what_is_built_is_whole_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
