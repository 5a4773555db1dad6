/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_automaton_refusals.c - what is refused of elastic automata in scenario files, and the
 * sentences that say so. */
#include "tests/support/laws.h"

#include "experiments/study/run.h"
#include "tests/support/both_commands.h"
#include "tests/support/scenarios.h"

#define HEAD "title: t\nmaterials:\n  m: {elastic-automaton: "
#define BODY "}\nbodies:\n  b: {material: m, shape: {rectangle: [6, 6]}"
#define TAIL "}\nrun: {steps: 10}\n"

static const bad_scenario mistakes[] = {
    {HEAD "{c1: 1, c2: 1.1}" BODY TAIL,
     "t.yaml:3:31: c1^2 + c2^2 = 2.21 (c1 = 1, c2 = 1.1), expected at most 2: longitudinal waves "
     "would outrun the lattice, the coefficient matrices are no longer real, and the wave (pi/2, "
     "pi/2) grows by 1.891 in every step"},
    {HEAD "{c1: 1}" BODY TAIL,
     "t.yaml:3:27: elastic-automaton has 'c1' but no 'c2', expected both"},
    {HEAD "{shear-modulus: 0.2}" BODY TAIL,
     "t.yaml:3:27: elastic-automaton has 'shear-modulus' but no 'poisson-ratio', expected both"},
    {HEAD "{shear-modulus: 1, poisson-ratio: 0.4}" BODY TAIL, "t.yaml:3:42: c1^2 + c2^2 = 3.3333"},
    {HEAD "{c1: 1, c2: 0, chopard: true}" BODY TAIL,
     "t.yaml:3:41: materials.m.elastic-automaton has both 'c1' and 'chopard'"},
    {HEAD "{chopard: false}" BODY TAIL,
     "t.yaml:3:36: elastic-automaton.chopard is 'false', expected 'true'"},
    {HEAD "{}" BODY TAIL, "expected one of c1, shear-modulus, chopard"},
    {HEAD "{c1: 0.4, c2: -1}" BODY TAIL, "elastic-automaton.c2 is '-1', expected a number of at "
                                         "least 0"},
    {HEAD "{c1: 0.4, c2: 0.5, boundry: bond}" BODY TAIL, "did you mean 'boundary'?"},
    {HEAD "{c1: 0.4, c2: 0.5, boundary: bnod}" BODY TAIL, "did you mean 'bond'?"},
    {HEAD "{c1: 0.4, c2: 0.5, damping: 1.1}" BODY TAIL,
     "damping is '1.1', expected a number from 0 to "
     "below 1; 0 is none, and what was a is 1 - damping"},
    {HEAD "{c1: 0.4, c2: 0.58}" BODY TAIL,
     "t.yaml:5:3: body b: boundary rule 'bond' with c1 = 0.4, c2 = 0.58 is unstable for this body "
     "of 36 cells: its own update grows by 1.08459 in every step (expected 1)"},
    {HEAD "{c1: 0.4, c2: 0.58, boundary: trapezoid}" BODY TAIL,
     "t.yaml:5:3: body b: boundary rule 'trapezoid' with c1 = 0.4, c2 = 0.58 is unstable for this "
     "body of 36 cells: its own update grows by 1.06432"},
    {HEAD "{c1: 0.4, c2: 0.5, boundary: periodic}}\nbodies:\n  b: {material: m, shape: {rectangle: "
          "[6, 5]}" TAIL,
     "t.yaml:5:20: bodies.b is periodic and has 6 columns and 5 rows, expected even numbers"},
    {HEAD "{c1: 0.4, c2: 0.5}}\nbodies:\n  b: {material: m, shape: {sites: [[0, 0], [1, 0], [3, "
          "3]]}" TAIL,
     "t.yaml:5:3: body b: site [3, 3] has no neighbour, expected at least one"},
    {HEAD "{c1: 0.9, c2: 0.5, break-at: 0.1, boundary: trapezoid}" BODY TAIL,
     "t.yaml:5:3: body b: breaking bonds with another boundary rule than 'bond'"},
    {HEAD "{c1: 0.4, c2: 0.5, break-at: 0.1}" BODY TAIL,
     "t.yaml:3:40: c2 is 0.5, expected 0 to 0.2309 where bonds break and c1 is 0.4"},
    {HEAD "{shear-modulus: 0.16, poisson-ratio: 0.3, break-at: 0.1}" BODY TAIL,
     "t.yaml:3:63: poisson-ratio is 0.3, expected -1 to -0.5 where bonds break"},
    {HEAD "{chopard: true}" BODY ", lattice: hexagonal" TAIL,
     "bodies.b.lattice is 'hexagonal', expected 'square'"},
    {HEAD "{chopard: true}" BODY ", rest-mass: [{sites: all, value: 1}]" TAIL,
     "bodies.b has 'rest-mass', which only lattice Boltzmann bodies have"},
    {HEAD "{chopard: true}" BODY ", displaced-as-given: true" TAIL,
     "bodies.b has 'displaced-as-given' but no 'displacement'"},
    {HEAD "{chopard: true}" BODY ", displacement: [{sites: [[2, 1]], by: [0.1, 0]}]" TAIL,
     "t.yaml:5:3: body b: site [2, 1] is displaced and its neighbours are not, but it is white"},
    {HEAD "{chopard: true}" BODY ", velocities: [{mode: {wave-vector: [1, 0], branch: slow, "
          "amplitude: 1}}]" TAIL,
     "bodies.b.velocities has a 'mode', which only a 'displacement' of an elastic automaton can"},
    {HEAD "{chopard: true}" BODY ", displacement: [{mode: {wave-vector: [0, 0], branch: slow, "
          "amplitude: 1}}]" TAIL,
     "a mode with the wave vector [0, 0], expected a wave"},
    {"title: t\nmaterials:\n  m: {lattice-boltzmann: {}" BODY ", displacement: [{mode: "
     "{wave-vector: [1, 0], branch: slow, amplitude: 1}}]" TAIL,
     "bodies.b.displacement has a 'mode', which only"},
    {"title: t\nmaterials:\n  m: {lattice-boltzmann: {}" BODY ", displacement: [{by: [1, 0]}], "
     "displaced-as-given: true" TAIL,
     "bodies.b has 'displaced-as-given', which only elastic automata have"},
    {HEAD
     "{chopard: true}}\n  n: {lattice-boltzmann: {}}\nbodies:\n  b: {material: m, shape: "
     "{rectangle: [2, 2]}}\n  c: {material: n, shape: {rectangle: [2, 2]}, origin: [9, 0]" TAIL,
     "t.yaml:6:3: body 'b' is an elastic automaton, which moves in half-steps, and 'c' is not, "
     "expected bodies that share one clock"},
    {HEAD "{chopard: true}" BODY "}\nrun: {steps: 10, reverse-at: 5}\n",
     "body b cannot be reversed: the model elastic-automaton does not know how"},
    {HEAD "{chopard: true}" BODY
          "}\nanalysis: {a: {stability-map: {c1: [1, 0], c2: [0, 1]}}}\nrun: "
          "{steps: 1}\n",
     "t.yaml:6:36: c1 is [1, 0] at 65 points, expected the first before the last"},
    {HEAD "{chopard: true}" BODY "}\nanalysis: {a: {body-stability: {c1: 1, c2: 0, boundary: bond, "
          "rectangle: [50, 50]}}}\nrun: {steps: 1}\n",
     "rectangle is [50, 50], expected at most 400 cells"},
    {HEAD "{chopard: true}" BODY "}\nanalysis: {a: {dispersion: {material: m, size: 7}}}\nrun: "
          "{steps: 1}\n",
     "size is 7, expected an even number"},
    {HEAD "{c1: 1, c2: 0.3}" BODY
          "}\nanalysis: {a: {boltzmann-reference: {body: b}}}\nrun: {steps: "
          "1}\n",
     "t.yaml:6:44: body 'b' has no lattice Boltzmann reference, expected one of Chopard's "
     "automaton"},
    {HEAD "{chopard: true}" BODY "}\nforces: {f: {body: b, force: [1, 0]}}\nanalysis: {a: "
          "{boltzmann-reference: {body: b}}}\nrun: {steps: 1}\n",
     "the force 'f' acts on body 'b', expected none"},
    {HEAD "{chopard: true}" BODY "}\nrun: {steps: 1}\npictures: {p: {kind: analysis}}\n",
     "pictures.p draws an analysis, of which the scenario has 0"},
    {HEAD "{chopard: true}" BODY
          "}\nrun: {steps: 1}\nexpect: [{quantity: reference-error, below: 1}]\n",
     "reference-error is measured of an analysis of kind boltzmann-reference, and the scenario has "
     "none"},
    {HEAD "{chopard: true}" BODY
          "}\nrun: {steps: 1}\nanalysis: {a: {boltzmann-reference: {body: b}}, "
          "c: {boltzmann-reference: {body: b}}}\nexpect: [{quantity: reference-error, below: 1}]\n",
     "reference-error is measured of one analysis, expected the key `analysis`"},
    {HEAD "{chopard: true}" BODY
          "}\nrun: {steps: 1}\nanalysis: {a: {boltzmann-reference: {body: b}}}\n"
          "expect: [{quantity: energy, analysis: a, below: 1}]\n",
     "energy is not measured of an analysis, expected no key `analysis`"},
    {HEAD "{chopard: true}" BODY "}\nrun: {steps: 1}\nexpect: [{quantity: wave-front, below: 1}]\n",
     "wave-front is measured of a lattice-boltzmann solid, but no body is one"},
};

/* As far as a run goes that never takes a step. */
static fw_status try_to_begin(const char *text)
{
    fw_scenario *scenario;
    FW_TRY(read_text(&scenario, text));
    const fw_run_options options = {.threads = 1};
    fw_run *run;
    const fw_status status = fw_run_begin(&run, scenario, &options, &error);
    if (status == FW_OK) fw_run_destroy(run);
    fw_scenario_destroy(scenario);
    return status;
}

static void mistakes_get_their_sentences(void **state)
{
    (void)state;
    int wrong = 0;
    for (size_t n = 0; n < sizeof mistakes / sizeof mistakes[0]; ++n) {
        error = (fw_error){0};
        const fw_status status = try_to_begin(mistakes[n].text);
        if (status == FW_BAD_INPUT && strstr(error.sentence, mistakes[n].sentence)) continue;
        print_error("%s\n  found    %d %s\n  expected %s\n", mistakes[n].text, (int)status,
                    error.sentence, mistakes[n].sentence);
        ++wrong;
    }
    assert_int_equal(wrong, 0);
}

static void check_refuses_what_run_refuses(void **state)
{
    (void)state;
    expect_both_refuse(mistakes, sizeof mistakes / sizeof *mistakes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_get_their_sentences),
        cmocka_unit_test(check_refuses_what_run_refuses),
    };
    return cmocka_run_group_tests_name("automaton refusals", tests, NULL, NULL);
}
