/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_part_refusals.c - what parts of a scenario say against each other is refused, where it is
 * written and with what was expected; what comes near to it is right. */
#include "tests/support/laws.h"

#include "experiments/scenario/catalogue.h"
#include "tests/support/scenarios.h"

typedef struct written {
    const char *text, *sentence; /* NULL: it is right */
} written;

static void expect_each(const written *all, size_t count)
{
    int wrong = 0;
    for (size_t n = 0; n < count; ++n) {
        fw_scenario *scenario = NULL;
        error = (fw_error){0};
        const fw_status status = read_text(&scenario, all[n].text);
        fw_scenario_destroy(scenario);
        const bool as_expected =
            all[n].sentence ? status == FW_BAD_INPUT && strstr(error.sentence, all[n].sentence)
                            : status == FW_OK;
        if (as_expected) continue;
        print_error("%s\nsaid '%s', expected '%s'\n", all[n].text, error.sentence,
                    all[n].sentence ? all[n].sentence : "nothing");
        ++wrong;
    }
    assert_int_equal(wrong, 0);
}
#define EXPECT_EACH(all) expect_each(all, sizeof(all) / sizeof *(all))

/* --- analyses --- */

#define AUTOMATA(more)                                                                             \
    "title: automata\n"                                                                            \
    "materials: {plain: {elastic-automaton: {chopard: true}}, soft: {lattice-boltzmann: {}},\n"    \
    "  brittle: {elastic-automaton: {chopard: true, break-at: .1}},\n"                             \
    "  fast: {elastic-automaton: {c1: .4, c2: .3}},\n"                                             \
    "  mirror: {elastic-automaton: {chopard: true, boundary: mirror}}}\n"                          \
    "bodies: {a: {material: plain, shape: {rectangle: [4, 2]}},\n"                                 \
    "  b: {material: brittle, shape: {rectangle: [4, 2]}, origin: [20, 0]},\n"                     \
    "  c: {material: fast, shape: {rectangle: [4, 2]}, origin: [40, 0]},\n"                        \
    "  d: {material: mirror, shape: {rectangle: [4, 2]}, origin: [60, 0]}}\n"                      \
    "run: {steps: 4}\n" more
#define ANALYSIS(what) AUTOMATA("analysis: {x: {" what "}}\n")

static void analyses_are_of_what_they_can_be(void **state)
{
    (void)state;
    static const written all[] = {
        {ANALYSIS("plane-mode: {material: fast, wave-vector: [.5, 0]}"), NULL},
        {ANALYSIS("plane-mode: {material: soft, wave-vector: [.5, 0]}"),
         "material 'soft' is not an elastic automaton, expected one"},
        {ANALYSIS("plane-mode: {material: none, wave-vector: [.5, 0]}"), "none"},
        {ANALYSIS("plane-mode: {material: fast, wave-vector: [0, .5]}"), NULL},
        {ANALYSIS("plane-mode: {material: fast, wave-vector: [0, 0]}"),
         "wave-vector is [0, 0], expected a wave"},
        {ANALYSIS("dispersion: {material: soft, size: 4, steps: 4}"), "not an elastic automaton"},
        {ANALYSIS("dispersion: {material: fast, size: 5, steps: 4}"),
         "size is 5, expected an even number"},
        {ANALYSIS("body-stability: {c1: .5, c2: .3, boundary: bond, rectangle: [20, 20]}"), NULL},
        {ANALYSIS("body-stability: {c1: .5, c2: .3, boundary: bond, rectangle: [21, 20]}"),
         "rectangle is [21, 20], expected at most 400 cells"},
        {ANALYSIS("body-stability: {c1: .5, c2: .3, boundary: bond, rectangle: [401, 1]}"),
         "rectangle is [401, 1], expected at most 400 cells"},
        {ANALYSIS("body-stability: {c1: .5, c2: .3, boundary: bond, rectangle: [1, 401]}"),
         "rectangle is [1, 401], expected at most 400 cells"},
        {ANALYSIS("stability-map: {c1: [.5, .5], c2: [.2, 1.4], points: [1, 2], waves: 4}"), NULL},
        {ANALYSIS("stability-map: {c1: [.5, .5], c2: [.2, 1.4], points: [2, 2], waves: 4}"),
         "c1 is [0.5, 0.5] at 2 points"},
        {ANALYSIS("stability-map: {c1: [.5, .6], c2: [.2, 1.4], points: [1, 2], waves: 4}"),
         "c1 is [0.5, 0.6] at 1 points"},
        {ANALYSIS("stability-map: {c1: [.5, .6], c2: [1.4, .2], points: [2, 2], waves: 4}"),
         "c2 is [1.4, 0.2] at 2 points"},
        {ANALYSIS("boltzmann-reference: {body: a, half-steps: 8}"), NULL},
        {ANALYSIS("boltzmann-reference: {body: none, half-steps: 8}"), "none"},
        {ANALYSIS("boltzmann-reference: {body: b, half-steps: 8}"),
         "body 'b' has no lattice Boltzmann reference"},
        {ANALYSIS("boltzmann-reference: {body: c, half-steps: 8}"),
         "body 'c' has no lattice Boltzmann reference"},
        {ANALYSIS("boltzmann-reference: {body: d, half-steps: 8}"),
         "body 'd' has no lattice Boltzmann reference"},
        {AUTOMATA("forces: {f: {body: c, force: [.1, 0]}, g: {body: a, force: [.1, 0]}}\n"
                  "analysis: {x: {boltzmann-reference: {body: a, half-steps: 8}}}\n"),
         "the force 'g' acts on body 'a'"},
    };
    EXPECT_EACH(all);
}

/* --- expectations --- */

#define SHEET(more)                                                                                \
    "title: a sheet\nmaterials: {soft: {lattice-boltzmann: {}}}\n"                                 \
    "bodies: {a: {material: soft, shape: {rectangle: [3, 2]}}}\n" more
#define RUN            "run: {steps: 20, measure-every: 5}\n"
#define EXPECTED(what) SHEET(RUN "expect: [{quantity: energy, " what "}]\n")
#define PHASED(what)                                                                               \
    SHEET(RUN "phases: {one: {until: 10}, two: {until: 20}}\n"                                     \
              "expect: [{quantity: energy, above: 0, statistic: mean, " what "}]\n")

static void expectations_say_one_thing(void **state)
{
    (void)state;
    static const written all[] = {
        {PHASED("phase: two"), NULL},
        {PHASED("phase: two, from: 5"), "has both 'phase' and 'from'"},
        {PHASED("phase: two, until: 5"), "has both 'phase' and 'until'"},
        {PHASED("phase: three"), "three"},
        {PHASED("from: 20"), NULL},
        {PHASED("from: 21"), "begins at step 21, after the 20 steps of the run"},
        {PHASED("from: 5, until: 20"), NULL},
        {PHASED("from: 15, until: 10"), "ends at step 10, expected 15 to 20"},
        {PHASED("from: 5, until: 21"), "ends at step 21, expected 5 to 20"},
        {EXPECTED("value: 1, within: .1, below: 2"), "has both 'value' and 'below'"},
        {EXPECTED("value: 1, within: .1, above: 0"), "has both 'value' and 'above'"},
        {EXPECTED("value: 1"), "without 'within' or 'within-relative'"},
        {EXPECTED("value: 1, within: .1, within-relative: .1"), "both 'within' and"},
        {EXPECTED("value: 0, within-relative: .1"), "is 0 within a part of 0"},
        {EXPECTED("below: 1, above: 1"), "is above 1 and below 1, which no number is"},
        {EXPECTED("source: nobody"), "expects nothing"},
        {EXPECTED("above: 0, along: x"), "has 'along', but neither 'trend' nor 'crosses'"},
        {EXPECTED("above: 0, at: 7"), "is at step 7"},
        {EXPECTED("above: 0, at: 25"), "is at step 25"},
        {EXPECTED("above: 0, at: 5, statistic: mean"), "has both 'at' and 'statistic'"},
        {SHEET("run: {steps: 7, measure-every: 5}\n"
               "expect: [{quantity: energy, above: 0, at: 7}]\n"),
         NULL},
        {SHEET(RUN "phases: {one: {until: 20, damping: 1}}\n"),
         "phase 'one' has 'damping', which is for movable particles and linear lattices"},
        {SHEET(RUN "phases: {one: {until: 20, temperature: 1}}\n"),
         "phase 'one' has 'temperature', which is for movable particles and linear lattices"},
        {SHEET(RUN "study: {control: [run.seed=2]}\n"), "there is no 'profile'"},
    };
    EXPECT_EACH(all);
}

/* --- sweeps --- */

#define SWEPT(what)                                                                                \
    SHEET(RUN "parameters: {v: 1, w: 1}\n"                                                         \
              "forces: {f: {body: a, force: [.001*v, .001*w]}}\nstudy: {sweep: {" what "}}\n"      \
              "expect: [{quantity: energy, above: 0}]\n")
#define LONG "a-name-that-is-as-long-as-a-name-may-be-and-still-is-one-name-"

static void parameters_of_a_sweep_are_whole(void **state)
{
    (void)state;
    static const written all[] = {
        {SWEPT("parameters: {v: {values: [1, 2], unit: m}}"), NULL},
        {SWEPT("parameters: {v: {values: [1, 2], unit: \"a\\nb\"}}"),
         "expected at most 63 bytes in one line"},
        {SWEPT("parameters: {v: {values: [1, 2], unit: " LONG LONG "}}"),
         "expected at most 63 bytes in one line"},
        {SWEPT("parameters: {v: {from: 1, to: 2}}"), "expected 'count' too, or 'tolerance'"},
        {SWEPT("parameters: {v: {from: 1, to: 2, count: 3, tolerance: .1}}"),
         "has both 'count' and 'tolerance'"},
        {SWEPT("parameters: {v: {from: 1, to: 2, tolerance: 1}}"),
         "v is bisected from 1 to 2 with the tolerance 1"},
        {SWEPT("parameters: {v: {from: 1, to: 2, tolerance: 1e-10}}"),
         "v is bisected from 1 to 2 with the tolerance 1e-10"},
        {SWEPT("parameters: {v: {from: 1, to: 2, tolerance: .1}, w: {from: 1, to: 2, tolerance: "
               ".1}}"),
         "w has a 'tolerance' as v has"},
        {SWEPT("parameters: {v: {values: [1, 2]}, w: {}}"), "w"},
        {SWEPT("parameters: {v: {}, w: {}}, points: [{v: 1, w: 2}]"), NULL},
        {SWEPT("parameters: {v: {}, w: {}}, points: [{v: 1}]"), "has no value of w"},
        {SWEPT("parameters: {v: {}, w: {}}, points: [{v: 1, x: 2}]"),
         "'x' is no parameter of study.sweep"},
    };
    EXPECT_EACH(all);
}

#define CASES(more)                                                                                \
    SHEET(RUN "parameters: {speed: 1, weight: 1}\n"                                                \
              "forces: {f: {body: a, force: [.001*speed, .001*weight]}}\n"                         \
              "study: {sweep: {parameters: {speed: {values: [1, 2]}, weight: {values: [1, "        \
              "2]}}}}\n" more)

static void points_of_a_sweep_are_named(void **state)
{
    (void)state;
    static const written all[] = {
        {CASES("expect: [{quantity: energy, above: 0, when: {speed: 1}}]\n"), NULL},
        {CASES("expect: [{quantity: energy, above: 0, when: {sped: 1}}]\n"),
         "'sped' is no parameter of study.sweep; did you mean 'speed'?"},
        {CASES("expect: [{quantity: energy, above: 0, when: {mass: 1}}]\n"),
         "'mass' is no parameter of study.sweep, expected one of speed, weight"},
        {CASES("expect: [{quantity: energy, above: 0, when: 1}]\n"),
         "study.sweep has 2 parameters: expected their names"},
        {CASES("expect: [{quantity: energy, above: 0, when: {weight: 3}}]\n"),
         "'when' is weight=3, where study.sweep has no case"},
        {SHEET(RUN "expect: [{quantity: energy, above: 0, when: {weight: 3}}]\n"),
         "the study has no 'sweep'"},
    };
    EXPECT_EACH(all);
}

/* --- pictures --- */

#define PICTURE(what) SHEET(RUN "pictures: {p: {" what "}}\n")

static void pictures_show_what_there_is(void **state)
{
    (void)state;
    static const written all[] = {
        {PICTURE("kind: series, observables: [energy], from: 5, until: 20"), NULL},
        {PICTURE("kind: series, observables: [energy], from: 20"),
         "pictures.p begins at step 20, but the run ends at 20"},
        {PICTURE("kind: series, observables: [energy], from: 10, until: 10"),
         "pictures.p ends at step 10, expected 11 to 20"},
        {PICTURE("kind: series, observables: [energy], until: 21"),
         "pictures.p ends at step 21, expected 1 to 20"},
        {PICTURE("kind: sweep, observables: [energy]"), "but the study has no 'sweep'"},
        {PICTURE("kind: map, observables: [energy]"), "but the study has no 'sweep'"},
        {PICTURE("kind: profile"), "but the scenario has no 'profile'"},
        {PICTURE("kind: analysis"),
         "pictures.p draws an analysis, of which the scenario has 0, expected the key 'analysis'"},
        {CASES("expect: [{quantity: energy, above: 0}]\n"
               "pictures: {p: {kind: map, observables: [energy]}}\n"),
         NULL},
        {CASES("expect: [{quantity: energy, above: 0}]\n"
               "pictures: {p: {kind: map, observables: [energy, momentum]}}\n"),
         "pictures.p shows 2 observables, expected one"},
        {CASES("expect: [{quantity: energy, above: 0}]\n"
               "pictures: {p: {kind: sweep, observables: [energy], along: speed}}\n"),
         NULL},
        {CASES("expect: [{quantity: energy, above: 0}]\n"
               "pictures: {p: {kind: sweep, observables: [energy], along: energy}}\n"),
         NULL},
        {CASES("expect: [{quantity: energy, above: 0}]\n"
               "pictures: {p: {kind: sweep, observables: [energy], along: layer-contact}}\n"),
         "'layer-contact' is no parameter of study.sweep"},
    };
    EXPECT_EACH(all);
}

/* --- shapes and walls --- */

#define BODY(what)                                                                                 \
    "title: a sheet\nmaterials: {soft: {lattice-boltzmann: {}}}\n"                                 \
    "bodies: {a: {material: soft, " what "}}\n" RUN

static void values_have_their_form(void **state)
{
    (void)state;
    static const written all[] = {
        {BODY("shape: {mask: \"#.\\n##\"}"), NULL},
        {BODY("shape: {mask: \"#.\\n#x\"}"), "has 'x' in its row 2 from the top"},
        {BODY("shape: {mask: \"#\\u00fc\"}"), "has '\xc3\xbc' in its row 1 from the top"},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: [1, 0, 1]}]"), NULL},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: [[1, 0], [0, 1]]}]"),
         NULL},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: [[1, 2], [0, 1]]}]"),
         "expected a symmetric one"},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: [1, 0, 1, 0]}]"),
         "value"},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: [1, [0, 1]]}]"),
         "value"},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: [[1, 0], [1]]}]"),
         "value"},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: {x: 1}}]"), "value"},
        {BODY("shape: {rectangle: [2, 2]}, rest-mass: [{sites: all, value: [1, x, 1]}]"), "value"},
        {BODY("shape: {rectangle: [2, 2]}, link-stiffness: [{sites: all, value: [1, 2, 1]}]"),
         "expected a positive definite matrix"},
        {BODY("shape: {rectangle: [2, 2]}, link-stiffness: [{sites: all, value: [-1, 0, 1]}]"),
         "expected a positive definite matrix"},
        {BODY("shape: {rectangle: [2, 2]}, link-stiffness: [{sites: all, value: [1, 0, -1]}]"),
         "expected a positive definite matrix"},
        {BODY("shape: {rectangle: [2, 2]}, velocity: [1, 2, 3]"), "velocity"},
        {BODY("shape: {rectangle: [2, 2]}, velocity: 1"), "velocity"},
        {BODY("shape: {rectangle: [2, 2]}, displaced-as-given: \"true\""), "displaced-as-given"},
        {BODY("shape: {rectangle: [2, 2]}, displaced-as-given: yes"), "displaced-as-given"},
        {BODY("shape: {sites: []}"), "sites"},
        {BODY("shape: {rectangle: [2, 2]}}, 2b: {material: soft, shape: {rectangle: [2, 2]}"),
         "'2b' as a name in bodies"},
        {BODY("shape: {rectangle: [2, 2]}}, b_2-c: {material: soft, shape: {rectangle: [2, 2]}"),
         NULL},
        {"title: none\nmaterials: {soft: {lattice-boltzmann: {}}}\nbodies: {}\n" RUN,
         "bodies has 0 names, expected 1 to"},
        {SHEET(RUN "measure: []\n"), NULL},
        {SHEET(RUN "measure: [energy.]\n"), "measure.0"},
        {SHEET(RUN "measure: [energy..a]\n"), "measure.0"},
        {SHEET(RUN "walls: {lid: {box: [-9, 20, 9, 22], side: outside, piston: {mass: 3, hold: x,\n"
                   "  velocity: [1, 2]}}}\n"),
         "piston 'lid' has the velocity [1, 2], expected 0 in the component that 'hold' names"},
        {SHEET(RUN "walls: {lid: {box: [-9, 20, 9, 22], side: outside, piston: {mass: 3, hold: y,\n"
                   "  velocity: [1, 2]}}}\n"),
         "piston 'lid' has the velocity [1, 2], expected 0 in the component that 'hold' names"},
        {SHEET(RUN "walls: {lid: {box: [-9, 20, 9, 22], side: outside, piston: {mass: 3, hold: x,\n"
                   "  velocity: [0, 2]}}}\n"),
         NULL},
        {SHEET(RUN "walls: {lid: {box: [-9, 20, 9, 22], side: outside, piston: {mass: 3},\n"
                   "  path: {velocity: [0, 1]}}}\n"),
         "walls.lid has both 'piston' and 'path'"},
    };
    EXPECT_EACH(all);
}

/* --- names of experiments and files --- */

static void a_file_gives_its_name_to_the_experiment(void **state)
{
    (void)state;
    static const char *const words[][2] = {
        {"/no/such/one.yml", "one"},
        {"no.such.YAML", "no.such"},
        {"./.yaml", ".yaml"},
        {"no/such", "such"},
        {"x/" LONG "x" LONG ".yaml", LONG "x"},
    };
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1];
    for (size_t n = 0; n < sizeof words / sizeof *words; ++n) {
        assert_refused(fw_catalogue_load(&scenario, words[n][0], NULL, 0, name, &error),
                       FW_BAD_INPUT, "No such file");
        if (strncmp(name, words[n][1], strlen(words[n][1])) != 0 || strlen(name) > 64)
            fail_msg("%s is called %s", words[n][0], name);
    }
    assert_refused(fw_catalogue_load(&scenario, "friction.yaml", NULL, 0, name, &error),
                   FW_BAD_INPUT, "the experiment friction is called without .yaml");
    assert_refused(fw_catalogue_load(&scenario, "frction.yaml", NULL, 0, name, &error),
                   FW_BAD_INPUT, "No such file");
    assert_refused(fw_catalogue_load(&scenario, "frction", NULL, 0, name, &error), FW_BAD_INPUT,
                   "did you mean 'friction'?");
    assert_refused(fw_catalogue_load(&scenario, "yml", NULL, 0, name, &error), FW_BAD_INPUT,
                   "there is no experiment 'yml'");
    assert_fine(fw_catalogue_load(&scenario, "friction", NULL, 0, name, &error));
    assert_string_equal(name, "friction");
    fw_scenario_destroy(scenario);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(analyses_are_of_what_they_can_be),
        cmocka_unit_test(expectations_say_one_thing),
        cmocka_unit_test(parameters_of_a_sweep_are_whole),
        cmocka_unit_test(points_of_a_sweep_are_named),
        cmocka_unit_test(pictures_show_what_there_is),
        cmocka_unit_test(values_have_their_form),
        cmocka_unit_test(a_file_gives_its_name_to_the_experiment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
