/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_measurement_plan.c - what is asked to be measured of nothing, of too much or of the wrong
 * thing is refused where it is written. */
#include "tests/support/laws.h"

#include "experiments/measures/measurement.h"
#include "tests/support/scenarios.h"

/* Two sheets between walls, one of which is a piston. */
#define SHEETS                                                                                     \
    "title: two sheets\n"                                                                          \
    "materials: {soft: {lattice-boltzmann: {}}}\n"                                                 \
    "bodies:\n"                                                                                    \
    "  a: {material: soft, shape: {rectangle: [3, 2]}}\n"                                          \
    "  b: {material: soft, shape: {rectangle: [3, 2]}, origin: [0, 9]}\n"                          \
    "walls:\n"                                                                                     \
    "  floor: {chain: [[-9, -2], [9, -2]]}\n"                                                      \
    "  lid: {box: [-9, 20, 9, 22], side: outside, piston: {mass: 3}}\n"                            \
    "run: {steps: 10, measure-every: 4}\n"

#define ONE_SHEET                                                                                  \
    "title: a sheet\n"                                                                             \
    "materials: {soft: {lattice-boltzmann: {}}}\n"                                                 \
    "bodies: {a: {material: soft, shape: {rectangle: [3, 2]}}}\n"                                  \
    "run: {steps: 10, measure-every: 4}\n"

#define ANALYSES                                                                                   \
    "title: analyses\n"                                                                            \
    "materials: {soft: {elastic-automaton: {chopard: true}}}\n"                                    \
    "bodies: {a: {material: soft, shape: {rectangle: [4, 2]}}}\n"                                  \
    "run: {steps: 10}\n"                                                                           \
    "analysis:\n"                                                                                  \
    "  one: {plane-mode: {material: soft, wave-vector: [.5, 0]}}\n"                                \
    "  two: {plane-mode: {material: soft, wave-vector: [.6, 0]}}\n"

#define CRYSTALS                                                                                   \
    "title: two crystals\n"                                                                        \
    "materials: {m: {movable-particles: {}}, l: {linear-lattice: {}}}\n"                           \
    "bodies:\n"                                                                                    \
    "  a: {material: m, lattice: hexagonal, shape: {rectangle: [9, 4]}, origin: [-4, 0]}\n"        \
    "  b: {material: l, lattice: hexagonal, shape: {rectangle: [4, 3]}, origin: [0, 30]}\n"        \
    "grips:\n"                                                                                     \
    "  left: {body: a, sites: [[0, 0]]}\n"                                                         \
    "  right: {body: a, sites: [[8, 0]]}\n"                                                        \
    "run: {steps: 100}\n"

#define PROFILE       "profile: {axis: x, every: 100, bin: 1, contact: 0.5, far: [2.5, 4.5]}\n"
#define EXPECT(words) "expect: [{" words ", above: 0}]\n"

static fw_status plan(const char *text)
{
    fw_scenario *scenario = read_right(text);
    fw_observer *observer;
    fw_measurement *measurement = NULL;
    assert_fine(fw_observer_create(&observer, scenario, &error));
    const fw_status status = fw_measurement_create(&measurement, observer, &error);
    if (status == FW_OK) fw_measurement_destroy(measurement);
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
    return status;
}

typedef struct refusal {
    const char *text, *sentence;
} refusal;

static const refusal refusals[] = {
    /* of bodies */
    {SHEETS EXPECT("quantity: strain, component: xx"),
     "t.yaml:10:10: strain is measured of one body, expected the key `body`"},
    {CRYSTALS EXPECT("quantity: pressure, component: xx, body: b"),
     "pressure is measured of bodies of model movable-particles, but body b is of model "
     "linear-lattice"},
    {ONE_SHEET EXPECT("quantity: temperature"),
     "temperature is measured of a movable-particles linear-lattice solid, but no body is one"},
    {ONE_SHEET "measure: [temperature]\n",
     "temperature is measured of a movable-particles linear-lattice solid, but no body is one"},
    {ONE_SHEET EXPECT("quantity: slip, body: a"),
     "t.yaml:5:33: slip is not measured of a body, expected no key `body`"},
    /* of sites */
    {ONE_SHEET EXPECT("quantity: position, component: x"),
     "position is measured of a single site, expected the key `site`"},
    {ONE_SHEET "measure: [position]\n",
     "position is measured of a single site; expected it in `expect`, with body and site"},
    /* of walls and pistons */
    {SHEETS EXPECT("quantity: contacts"),
     "contacts is measured of one wall, expected the key `wall`"},
    {SHEETS EXPECT("quantity: energy, wall: floor"),
     "energy is not measured of a wall, expected no key `wall`"},
    {SHEETS EXPECT("quantity: piston-displacement, component: y, wall: floor"),
     "piston-displacement is measured of pistons, and the wall floor is none"},
    {ONE_SHEET EXPECT("quantity: piston-displacement, component: y"),
     "piston-displacement is measured of one piston, expected a wall with the key `piston`"},
    /* of grips */
    {CRYSTALS EXPECT("quantity: grip-force, component: x"),
     "grip-force is measured of one grip, expected the key `grip`"},
    {CRYSTALS EXPECT("quantity: energy, grip: left"),
     "energy is not measured of a grip, expected no key `grip`"},
    {ONE_SHEET EXPECT("quantity: slip"), "there is nothing to measure slip of"},
    {ONE_SHEET "measure: [slip]\n", "there is nothing to measure slip of"},
    {ONE_SHEET "measure: [grip-force]\n", "there is nothing to measure grip-force of"},
    /* of analyses */
    {ANALYSES EXPECT("quantity: phase-speed, component: slow"),
     "phase-speed is measured of one analysis, expected the key `analysis`"},
    {ANALYSES EXPECT("quantity: spectral-radius"),
     "spectral-radius is measured of an analysis of kind body-stability, and the scenario has "
     "none"},
    {ANALYSES EXPECT("quantity: spectral-radius, analysis: one"),
     "spectral-radius is measured of an analysis of kind body-stability, which one is not"},
    {ANALYSES EXPECT("quantity: energy, analysis: one"),
     "energy is not measured of an analysis, expected no key `analysis`"},
    /* components */
    {ONE_SHEET EXPECT("quantity: momentum"),
     "momentum has the components x y, expected one of them in the key `component`"},
    {ONE_SHEET EXPECT("quantity: energy, component: x"),
     "energy is one number, expected no key `component`"},
    {ONE_SHEET EXPECT("quantity: momentum, component: z"),
     "component z of momentum, expected one of x y"},
    /* names */
    {ONE_SHEET EXPECT("quantity: energie"), "quantity energie is not known; did you mean energy?"},
    {ONE_SHEET EXPECT("quantity: xyzzyx"),
     "quantity xyzzyx is not known, expected one of `fretwork quantities`"},
    {ONE_SHEET EXPECT("quantity: unrest"), "quantity unrest is not known; it is now called "
                                           "rest-residual"},
    {SHEETS "measure: [energy.c]\n",
     "energy is not measured of c, expected energy with the name of a body"},
    {SHEETS "measure: [momentum.c]\n", "expected momentum with the name of a body or with one of "
                                       "the components x y"},
    {SHEETS "measure: [contacts.a]\n", "expected contacts with the name of a wall"},
    {SHEETS "measure: [piston-displacement.floor]\n",
     "expected piston-displacement with the name of a piston"},
    {CRYSTALS "measure: [grip-force.a]\n", "expected grip-force with the name of a grip"},
    {ANALYSES "measure: [phase-speed.a]\n",
     "expected phase-speed with the name of an analysis of its kind"},
    {ONE_SHEET "measure: [position.c]\n", "expected position in `expect`, with body and site,"},
    {ONE_SHEET "measure: [energy-drift.a]\n", "expected energy-drift alone"},
    /* what comes out of a study */
    {CRYSTALS EXPECT("quantity: layer-contact"),
     "layer-contact comes out of a profile, and the scenario has none"},
    {CRYSTALS PROFILE EXPECT("quantity: layer-contact-over-control"),
     "layer-contact-over-control is measured against a control, and the study has none"},
    {CRYSTALS PROFILE "measure: [layer-contact]\n",
     "layer-contact comes out of all runs together; expected it in `expect`"},
};

static void what_cannot_be_measured_is_refused(void **state)
{
    (void)state;
    int wrong = 0;
    for (size_t n = 0; n < sizeof refusals / sizeof *refusals; ++n) {
        const fw_status status = plan(refusals[n].text);
        const char *said = status == FW_OK ? "nothing" : error.sentence;
        if (status == FW_BAD_INPUT && strstr(said, refusals[n].sentence)) continue;
        print_error("'%s' does not speak of '%s'\n", said, refusals[n].sentence);
        ++wrong;
    }
    assert_int_equal(wrong, 0);
}

/* The same with what is right: the key names the one that is meant, or there is but one. */
static const char *const right[] = {
    SHEETS EXPECT("quantity: strain, component: xx, body: b"),
    ONE_SHEET EXPECT("quantity: strain, component: xx"),
    ONE_SHEET EXPECT("quantity: position, component: x, body: a, site: [1, 1]"),
    SHEETS EXPECT("quantity: contacts, wall: lid"),
    SHEETS EXPECT("quantity: piston-displacement, component: y"),
    CRYSTALS EXPECT("quantity: grip-force, component: x, grip: right"),
    CRYSTALS EXPECT("quantity: slip, component: x"),
    ANALYSES EXPECT("quantity: phase-speed, component: slow, analysis: two"),
    ONE_SHEET EXPECT("quantity: energy, at: 8"),
    SHEETS "measure: [energy.a, momentum.b.x, contacts.floor, piston-displacement.lid]\n",
    CRYSTALS PROFILE EXPECT("quantity: layer-contact"),
};

static void what_can_be_measured_is_accepted(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof right / sizeof *right; ++n)
        if (plan(right[n]) != FW_OK) fail_msg("%s: %s", right[n], error.sentence);
}

/* --- one quantity at a time --- */

static void a_look_names_one_of_several(void **state)
{
    (void)state;
    double out[FW_COMPONENTS_MAX];
    int count;
    fw_scenario *scenario = read_right(SHEETS);
    fw_observer *observer;
    assert_fine(fw_observer_create(&observer, scenario, &error));
    assert_fine(fw_measurement_look(observer, "centre-of-mass.b", out, &count, &error));
    assert_int_equal(count, 2);
    assert_close(out[0], 1, 1e-14);
    assert_close(out[1], 9.5, 1e-14);
    assert_fine(fw_measurement_look(observer, "centre-of-mass.b.y", out, &count, &error));
    assert_int_equal(count, 1);
    assert_close(out[0], 9.5, 1e-14);
    /* No force has acted yet. */
    assert_fine(fw_measurement_look(observer, "friction-ratio.floor", out, &count, &error));
    assert_true(isnan(out[0]));
    assert_refused(fw_measurement_look(observer, "centre-of-mass", out, &count, &error),
                   FW_BAD_INPUT,
                   "centre-of-mass is measured of 2 things, expected one of them by name, such as "
                   "centre-of-mass.a");
    assert_refused(fw_measurement_look(observer, "broken-bonds", out, &count, &error), FW_BAD_INPUT,
                   "there is nothing to measure broken-bonds of");
    assert_refused(fw_measurement_look(observer, "slip", out, &count, &error), FW_BAD_INPUT,
                   "there is nothing to measure slip of");
    fw_observer_destroy(observer);
    fw_scenario_destroy(scenario);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_cannot_be_measured_is_refused),
        cmocka_unit_test(what_can_be_measured_is_accepted),
        cmocka_unit_test(a_look_names_one_of_several),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
