/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_refusals.c - what is wrong with a scenario, and the one sentence that its author gets. */
#include "tests/support/laws.h"

#include "experiments/scenario/scenario.h"
#include "tests/support/both_commands.h"

#include <stdlib.h>
#include <string.h>

static const char right[] =
    "title: A sheet in a box\n"
    "materials:\n"
    "  rubber: {lattice-boltzmann: {rest-mass: 0, damping: 0}}\n"
    "bodies:\n"
    "  sheet:\n"
    "    material: rubber\n"
    "    shape: {rectangle: [20, 10]}\n"
    "    origin: [7.3, 11.7]\n"
    "    displacement:\n"
    "      - {sites: [[3, 4]], by: [0.1, 0]}\n"
    "walls:\n"
    "  container: {box: [0, 0, 60, 60], surface: frictionless}\n"
    "forces:\n"
    "  pull: {body: sheet, sites: right, total: [0.1, 0], from: 10, until: 20}\n"
    "run: {steps: 4000, record-every: 20}\n"
    "expect:\n"
    "  - {quantity: energy-drift, below: 1e-11}\n"
    "pictures:\n"
    "  fig1: {kind: motion, instants: [0, 2000]}\n";

/* In the text above the first `written` becomes `instead`. */
static const struct {
    const char *written, *instead, *sentence; /* after "scenario.yaml:" */
} mistakes[] = {
    {"below: 1e-11", "statistic: rate, from: 4000, below: 1",
     "17:53: the expectation of 'energy-drift' looks at the steps 4000 to 4000, of which 1 are "
     "measured (run.measure-every is 1), expected at least 2 for a rate"},
    {"sites: right, total", "sites: {side: right, layers: 21}, total",
     "14:52: layers is 21, expected at most the 20 columns of body 'sheet'"},
    {"sites: right, total", "sites: {side: top, layers: 11}, total",
     "14:50: layers is 11, expected at most the 10 rows of body 'sheet'"},
    {"from: 10, until: 20", "from: 4000, until: 5000",
     "14:60: forces.pull.from is 4000, expected less than the 4000 steps of the run: it would "
     "never act"},
    {"record-every: 20}\nexpect:\n  - {quantity: energy-drift, below",
     "measure-every: 30}\nexpect:\n  - {quantity: energy-drift, from: 31, until: 59, below",
     "17:47: the expectation of 'energy-drift' looks at the steps 31 to 59, of which 0 are "
     "measured (run.measure-every is 30), expected at least 1"},
    {"record-every: 20}\nexpect:\n  - {quantity: energy-drift, below",
     "measure-every: 30}\nphases: {a: {until: 31}, mid: {until: 59}, z: {until: 4000}}\nexpect:\n"
     "  - {quantity: energy-drift, phase: mid, below",
     "18:37: the expectation of 'energy-drift' looks at the steps 31 to 59, of which 0 are "
     "measured (run.measure-every is 30), expected at least 1"},
    {"quantity: energy-drift, below",
     "quantity: energy-drift, from: 60, until: 60, statistic: rate, below",
     "17:47: the expectation of 'energy-drift' looks at the steps 60 to 60, of which 1 are "
     "measured (run.measure-every is 1), expected at least 2 for a rate"},
    {"record-every: 20}\nexpect:\n  - {quantity: energy-drift, below: 1e-11}\npictures:\n"
     "  fig1: {kind: motion, instants: [0, 2000]}",
     "measure-every: 30}\npictures:\n  fig1: {kind: series, from: 31, until: 59}",
     "17:41: pictures.fig1 shows the steps 31 to 59, in which nothing is measured: "
     "run.measure-every is 30"},
    {"damping: 0}", "dampng: 1}",
     "3:46: unknown key 'dampng' in materials.rubber.lattice-boltzmann; did you mean 'damping'?"},
    {"damping: 0}", "viscosity: 1}",
     "3:46: unknown key 'viscosity' in materials.rubber.lattice-boltzmann, expected a key of a "
     "lattice Boltzmann material: rest-mass, damping, link-stiffness, break-at"},
    {"title:", "titel:", "1:1: unknown key 'titel'; did you mean 'title'?"},
    {"title:", "units: {length: 1 nm, mass: 1 u, time: 1 nm}\ntitle:",
     "1:40: units.time is in 'nm', expected a unit of time: s with any prefix"},
    {"record-every", "record_every",
     "15:20: unknown key 'record_every' in run; did you mean 'record-every'?"},
    {"walls:", "wall:", "11:1: unknown key 'wall'; did you mean 'walls'?"},
    {"title: A sheet in a box\n", "",
     "1:1: the scenario has no 'title', which a scenario must have"},
    {"    shape: {rectangle: [20, 10]}\n", "",
     "5:3: bodies.sheet has no 'shape', which a body must have"},
    {"rectangle: [20, 10]", "disk: 5",
     "7:13: unknown key 'disk' in bodies.sheet.shape; did you mean 'disc'?"},
    {"rectangle: [20, 10]", "rectangle: [20, 10], disc: 5",
     "7:34: bodies.sheet.shape has both 'rectangle' and 'disc', expected one of them"},
    {"shape: {rectangle: [20, 10]}", "shape: {}",
     "7:12: bodies.sheet.shape is incomplete, expected one of rectangle, disc, sites, mask, "
     "placed, points, file"},
    {"total: [0.1, 0]", "total: [0.1, 0], force: [1, 0]",
     "14:54: forces.pull has both 'force' and 'total', expected one of them"},
    {"total: [0.1, 0], ", "",
     "14:9: forces.pull is incomplete, expected one of force, total, acceleration, random"},
    {"until: 20", "until: 20, phase: 90",
     "14:75: forces.pull has 'phase' but no 'period', without which it means nothing"},
    {"damping: 0}", "damping: [1]}",
     "3:55: materials.rubber.lattice-boltzmann.damping is a list of 1, expected a number from 0 to "
     "below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"damping: 0}", "damping: \"1\"}",
     "3:55: materials.rubber.lattice-boltzmann.damping is the text '1', expected a number from 0 "
     "to "
     "below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"damping: 0}", "damping: high}",
     "3:55: materials.rubber.lattice-boltzmann.damping is 'high', expected a number from 0 to "
     "below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"damping: 0}", "damping: }",
     "3:55: materials.rubber.lattice-boltzmann.damping is empty, expected a number from 0 to "
     "below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"steps: 4000", "steps: 4e3",
     "15:14: run.steps is '4e3', expected a whole number of at least 1, written without point, "
     "exponent or leading zeros"},
    {"steps: 4000", "steps: 4000.0",
     "15:14: run.steps is '4000.0', expected a whole number of at least 1, written without point, "
     "exponent or leading zeros"},
    {"steps: 4000", "steps: 010",
     "15:14: run.steps is '010', expected a whole number of at least 1, written without point, "
     "exponent or leading zeros"},
    {"origin: [7.3, 11.7]", "origin: 7.3",
     "8:13: bodies.sheet.origin is '7.3', expected [x, y], each a number"},
    {"origin: [7.3, 11.7]", "origin: [7.3]",
     "8:13: bodies.sheet.origin is a list of 1, expected [x, y], each a number"},
    {"origin: [7.3, 11.7]", "origin: {x: 7.3, y: 11.7}",
     "8:13: bodies.sheet.origin is a mapping of 2, expected [x, y], each a number"},
    {"bodies:\n  sheet:", "bodies:\n - sheet:",
     "5:2: bodies is a list of 1, expected names of your own, each with a mapping with material, "
     "shape"},
    {"title: A sheet in a box", "title: [A, B]", "1:8: title is a list of 2, expected a text"},
    {"kind: motion", "kind: movie",
     "19:16: pictures.fig1.kind is 'movie', expected one of motion, forces, contact, field, strip, "
     "structure, stages, histogram, series, profile, loop, slip, heat, analysis, sweep, map"},
    {"sites: right", "sites: rihgt",
     "14:30: forces.pull.sites is 'rihgt', expected all, a side, [[i, j], ...] or a mapping; did "
     "you mean 'right'?"},
    {"surface: frictionless", "surface: {coulomb: rough}",
     "12:55: walls.container.surface.coulomb is 'rough', expected a number from 0 to 1000 "
     "or a mapping with static, kinetic"},
    {"fig1:", "1st:",
     "19:3: '1st' as a name in pictures, expected a letter and then letters, digits, '-' or '_'"},
    {"7.3", "2.5e", "8:14: bodies.sheet.origin.0 is '2.5e', expected a number"},
    {"7.3", "1.0x", "8:14: bodies.sheet.origin.0 is '1.0x', expected a number"},
    {"7.3", "0x1F", "8:14: bodies.sheet.origin.0 is '0x1F', expected a number"},
    {"7.3", "nan",
     "8:14: bodies.sheet.origin.0 is 'nan', expected a number, finite and at most 1e+15 in size"},
    {"7.3", ".inf",
     "8:14: bodies.sheet.origin.0 is '.inf', expected a number, finite and at most 1e+15 in size"},
    {"7.3", "1e999",
     "8:14: bodies.sheet.origin.0 is '1e999', expected a number, finite and at most 1e+15 in size"},
    {"7.3", "1e16",
     "8:14: bodies.sheet.origin.0 is '1e16', expected a number, finite and at most 1e+15 in size"},
    {"7.3", "1e-999",
     "8:14: bodies.sheet.origin.0 is '1e-999', which is not 0 but too small for a number here"},
    {"7.3", "1:3", "8:14: bodies.sheet.origin.0 is '1:3', expected a number"},
    {"7.3", "1,5", "8:13: bodies.sheet.origin is a list of 3, expected [x, y], each a number"},
    {"7.3", "1_000", "8:14: bodies.sheet.origin.0 is '1_000', expected a number"},
    {"4000", "99999999999999999999",
     "15:14: run.steps is '99999999999999999999', expected a whole number of at least 1, finite "
     "and at most 1000000000000 in size"},
    {"4000", "-4000", "15:14: run.steps is '-4000', expected a whole number of at least 1"},
    {"4000", "0", "15:14: run.steps is '0', expected a whole number of at least 1"},
    {"damping: 0}", "damping: 1}",
     "3:55: materials.rubber.lattice-boltzmann.damping is '1', expected a number from 0 to "
     "below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"damping: 0}", "damping: 0.5}",
     "3:55: materials.rubber.lattice-boltzmann.damping is '0.5', expected a number from 0 to "
     "below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"damping: 0}", "damping: -0.1}",
     "3:55: materials.rubber.lattice-boltzmann.damping is '-0.1', expected a number from 0 to "
     "below 0.5; 0 is none, and what was mu is 1 - damping"},
    {"rest-mass: 0", "rest-mass: [[1, 2], [3, 1]]",
     "3:43: materials.rubber.lattice-boltzmann.rest-mass is a matrix with 2 to the right of 1 on "
     "its diagonal but 3 below it, expected a symmetric one: any other would create energy from "
     "nothing"},
    {"rest-mass: 0", "rest-mass: [1, 2]",
     "3:43: materials.rubber.lattice-boltzmann.rest-mass is a list of 2, expected a number, [xx, "
     "xy, yy] or [[xx, xy], [xy, yy]]"},
    {"damping: 0}", "link-stiffness: 0}",
     "3:62: materials.rubber.lattice-boltzmann.link-stiffness is '0', expected a number above 0"},
    {"damping: 0}", "link-stiffness: [1, 2, 1]}",
     "3:62: materials.rubber.lattice-boltzmann.link-stiffness is [[1, 2], [2, 1]], expected a "
     "positive definite matrix: this one is zero or negative in some direction"},
    {"[20, 10]", "[0, 10]",
     "7:25: bodies.sheet.shape.rectangle.0 is '0', expected a whole number of at least 1"},
    {"[20, 10]", "[16777216, 16777216]",
     "7:5: with bodies.sheet the bodies have 281474976710656 sites, expected at most 268435456"},
    {"rectangle: [20, 10]", "disc: 1e5",
     "7:19: bodies.sheet.shape.disc is '1e5', expected a number from 0 to 8192"},
    {"rectangle: [20, 10]", "sites: []",
     "7:20: bodies.sheet.shape.sites has 0 items, expected 1 to 1048576"},
    {"rectangle: [20, 10]", "sites: [[3, 4], [4, 4], [3, 4]]",
     "7:20: bodies.sheet.shape.sites: site [3, 4] is listed twice"},
    {"shape: {rectangle: [20, 10]}", "shape:\n      mask: |\n        ##.\n        #o#",
     "8:13: bodies.sheet.shape.mask has 'o' in its row 2 from the top, expected '#' for a particle "
     "and '.' for none"},
    {"shape: {rectangle: [20, 10]}", "shape: {mask: '...'}",
     "7:19: bodies.sheet.shape.mask: the shape has no sites, expected at least one"},
    {"material: rubber", "material: ruber",
     "6:15: there is no material 'ruber'; did you mean 'rubber'?"},
    {"material: rubber", "material: steel",
     "6:15: there is no material 'steel', expected one that the scenario names, such as 'rubber'"},
    {"    material: rubber", "    material: rubber\n    lattice: hexagonal",
     "7:14: bodies.sheet.lattice is 'hexagonal', expected 'square': the lattice Boltzmann solid "
     "has four links per site"},
    {"body: sheet", "body: shet", "14:16: there is no body 'shet'; did you mean 'sheet'?"},
    {"[[3, 4]]", "[[3, 4], [20, 4]]",
     "10:26: site [20, 4] is not one of body 'sheet', whose sites lie in columns 0 to 19 and rows "
     "0 to 9"},
    {"[[3, 4]]", "[[3, 4], [3, 4]]", "10:17: site [3, 4] is listed twice"},
    {"[[3, 4]]", "{rows: [0, 10]}",
     "10:24: rows are [0, 10], but those of body 'sheet' are 0 to 9"},
    {"[[3, 4]]", "{rows: [5, 4]}", "10:24: rows are [5, 4], expected the first before the last"},
    {"[[3, 4]]", "{side: left, columns: [5, 8]}",
     "10:17: the selection has none of the sites of body 'sheet', expected at least one"},
    {"[[3, 4]]", "{layers: 2}",
     "10:18: bodies.sheet.displacement.0.sites has 'layers' but no 'side', without which it means "
     "nothing"},
    {"until: 20", "until: 10",
     "14:71: forces.pull.until is 10, expected more than 'from', which is 10"},
    {"box: [0, 0, 60, 60]", "box: [0, 0, 0, 60]",
     "12:20: wall 'container': the box from [0, 0] to [0, 60] is empty, expected corners that "
     "differ in x and in y"},
    {"box: [0, 0, 60, 60]", "circle: [0, 0, -1]",
     "12:23: wall 'container': the radius is -1, expected more than 0"},
    {"box: [0, 0, 60, 60]", "polygon: [[0, 0], [9, 0], [1, 1], [0, 9]]",
     "12:24: wall 'container': the polygon is not convex at corner 3, [1, 1]; a closed chain can "
     "have any corners"},
    {"box: [0, 0, 60, 60]", "polygon: [[0, 0], [9, 0]]",
     "12:24: walls.container.polygon has 2 items, expected 3 to 65536"},
    {"box: [0, 0, 60, 60]", "chain: [[0, 0], [9, 0]], side: inside",
     "12:40: walls.container has both 'chain' and 'side'; a chain is free to the left of the way "
     "along it, so turn its points round instead"},
    {"box: [0, 0, 60, 60]", "box: [0, 0, 60, 60], closed: true",
     "12:36: walls.container has 'closed' but no 'chain', without which it means nothing"},
    {"surface: frictionless", "path: {amplitude: [1, 0]}",
     "12:43: walls.container.path has 'amplitude' but no 'period', without which it means nothing"},
    {"below: 1e-11", "value: 1",
     "17:30: the expectation of 'energy-drift' has a 'value' without 'within' or "
     "'within-relative', expected one of the two"},
    {"below: 1e-11", "value: 1, within: .1, within-relative: .1",
     "17:52: the expectation of 'energy-drift' has both 'within' and 'within-relative', expected "
     "one of the two"},
    {"below: 1e-11", "value: 1, below: 2",
     "17:40: the expectation of 'energy-drift' has both 'value' and 'below', expected a value or "
     "bounds"},
    {", below: 1e-11", "",
     "17:5: the expectation of 'energy-drift' expects nothing: it needs 'value' with 'within', or "
     "'below', or 'above', or 'trend'"},
    {"below: 1e-11", "trend: rises",
     "17:30: the expectation of 'energy-drift' has a 'trend', but the study has no 'sweep' of two "
     "values or more"},
    {"below: 1e-11", "below: 1, when: 2",
     "17:40: 'when' names a value of a sweep, but the study has no 'sweep'"},
    {"kind: motion, instants: [0, 2000]", "kind: sweep",
     "19:16: pictures.fig1 is of kind 'sweep', but the study has no 'sweep'"},
    {"record-every: 20}", "record-every: 20}\nstudy: {sweep: {set: [run.steps=v]}}",
     "16:9: study.sweep has no 'parameters', which a sweep must have"},
    {"below: 1e-11", "below: 1, above: 2",
     "17:47: the expectation of 'energy-drift' is above 2 and below 1, which no number is"},
    {"below: 1e-11", "value: 0, within-relative: .1",
     "17:40: the expectation of 'energy-drift' is 0 within a part of 0, expected 'within' instead "
     "of 'within-relative'"},
    {"below: 1e-11", "below: 1, at: 5000",
     "17:44: the expectation of 'energy-drift' is at step 5000, but the run ends at 4000 and "
     "measures at multiples of 1"},
    {"below: 1e-11", "below: 1, at: 50, statistic: mean",
     "17:48: the expectation of 'energy-drift' has both 'at' and 'statistic', expected one step or "
     "a "
     "series"},
    {"below: 1e-11", "below: 1, from: 5, until: 4",
     "17:56: the expectation of 'energy-drift' ends at step 4, expected 5 to 4000"},
    {"below: 1e-11", "below: 1, body: sheet, site: [20, 0]",
     "17:59: site [20, 0] is not one of body 'sheet'"},
    {"below: 1e-11", "below: 1, site: [2, 0]",
     "17:40: expect.0 has 'site' but no 'body', without which it means nothing"},
    {"below: 1e-11", "below: 1, wall: floor",
     "17:46: there is no wall 'floor', expected one that the scenario names, such as 'container'"},
    {"instants: [0, 2000]", "instants: [0, 5000]",
     "19:38: pictures.fig1 shows step 5000, but the run ends at 4000"},
    {"instants: [0, 2000]", "instants: [200, 100]",
     "19:40: pictures.fig1 shows step 100 after step 200, expected ascending steps"},
    {"instants: [0, 2000]", "observables: [energy]",
     "19:24: pictures.fig1 has 'observables', which a picture of kind 'motion' does not draw"},
    {"record-every: 20", "reverse-at: 4000",
     "15:32: run.reverse-at is 4000, expected less than the 4000 steps of the run"},
    {"record-every: 20}", "record-every: 20}\nmeasure: [energy, momentum, energy]",
     "16:29: measure names 'energy' twice"},
};

static const struct {
    const char *setting, *sentence; /* after "--set " */
} wrong_settings[] = {
    {"bodies.shet.velocity=[.1,0]",
     "bodies.shet.velocity=[.1,0]: there is no 'shet' in bodies; did you mean 'sheet'?"},
    {"bodies.sheet.velocty=[.1,0]", "bodies.sheet.velocty=[.1,0]: unknown key 'velocty' in "
                                    "bodies.sheet; did you mean 'velocity'?"},
    {"bodies.sheet.velocity=3",
     "bodies.sheet.velocity=3: bodies.sheet.velocity is '3', expected [x, y], each a number"},
    {"run.steps", "run.steps: expected KEY=VALUE, such as run.steps=1000"},
    {"run.steps=", "run.steps=: nothing is written there, expected a value after '='"},
    {"run.steps=[", "run.steps=[: a value is missing"},
    {"run.steps=4e3", "run.steps=4e3: run.steps is '4e3', expected a whole number of at least 1, "
                      "written without point, exponent or leading zeros"},
    {"steps=3",
     "steps=3: unknown key 'steps', expected a key of a scenario: title, source, "
     "figure, group, takes, small, "
     "about, parameters, units, materials, bodies, walls, forces, grips, phases, profile, "
     "study, dynamics, "
     "contact, run, record, "
     "measure, expect, pictures, analysis"},
    {"walls.floor.box=[0,0,1,1]", "walls.floor.box=[0,0,1,1]: there is no 'floor' in walls"},
    {"walls.floor={box: [0,0,1,1], surface: {coulomb: -1}}",
     "walls.floor={box: [0,0,1,1], surface: {coulomb: -1}}: walls.floor.surface.coulomb is '-1', "
     "expected a number from 0 to 1000 or a mapping with static, kinetic"},
    {"expect.1.below=3",
     "expect.1.below=3: expect is a list of 1 items, which count from 0; there is no '1'"},
    {"expect.first.below=3",
     "expect.first.below=3: expect is a list of 1 items, which count from 0; there is no 'first'"},
    {"expect.0.below=x", "expect.0.below=x: expect.0.below is 'x', expected a number"},
    {"title.text=3", "title.text=3: title has no 'text', because it is a single value"},
    {"run..steps=3", "run..steps=3: a key of 0 characters, expected 1 to 63"},
    {"bodies.sheet.displacement.0.sites.0=[20,0]",
     "bodies.sheet.displacement.0.sites.0=[20,0]: site [20, 0] is not one of body 'sheet', whose "
     "sites lie in columns 0 to 19 and rows 0 to 9"},
    {"walls.container.surface.coulomb=.3",
     "walls.container.surface.coulomb=.3: walls.container.surface has no 'coulomb', because it is "
     "a single value"},
    {"run.seed=*a",
     "run.seed=*a: an alias '*a'; a scenario is written out in full, without anchors and aliases"},
    {"walls.container.box=[0,0,0,1]",
     "walls.container.box=[0,0,0,1]: wall 'container': the box from [0, 0] to [0, 1] is empty, "
     "expected corners that differ in x and in y"},
    {"forces.pull.until=5",
     "forces.pull.until=5: forces.pull.until is 5, expected more than 'from', which is 10"},
    {"a=b=c",
     "a=b=c: unknown key 'a', expected a key of a scenario: title, source, figure, group, "
     "takes, small, "
     "about, parameters, units, materials, bodies, walls, forces, grips, phases, profile, study, "
     "dynamics, "
     "contact, run, record, "
     "measure, expect, pictures, analysis"},
};

static char *change(const char *written, const char *instead)
{
    const char *at = strstr(right, written);
    assert_non_null(at);
    char *text = malloc(sizeof right + strlen(instead));
    assert_non_null(text);
    size_t before = (size_t)(at - right);
    memcpy(text, right, before);
    strcpy(text + before, instead);
    strcat(text, at + strlen(written));
    return text;
}

static void a_right_scenario_is_read(void **state)
{
    (void)state;
    fw_scenario *scenario;
    fw_status status =
        fw_scenario_read(&scenario, "scenario.yaml", right, strlen(right), NULL, 0, &error);
    if (status != FW_OK) fail_msg("%s", error.sentence);
    fw_scenario_destroy(scenario);
}

static void every_mistake_gets_its_sentence(void **state)
{
    (void)state;
    int wrong = 0;
    for (size_t n = 0; n < sizeof mistakes / sizeof mistakes[0]; ++n) {
        char *text = change(mistakes[n].written, mistakes[n].instead);
        char expected[FW_SENTENCE_SIZE];
        snprintf(expected, sizeof expected, "scenario.yaml:%s", mistakes[n].sentence);
        fw_scenario *scenario;
        error = (fw_error){FW_OK, "accepted"};
        fw_status status =
            fw_scenario_read(&scenario, "scenario.yaml", text, strlen(text), NULL, 0, &error);
        if (status != FW_BAD_INPUT || strcmp(error.sentence, expected) != 0) {
            print_error("'%s' instead of '%s':\n  found    %s\n  expected %s\n",
                        mistakes[n].instead, mistakes[n].written, error.sentence, expected);
            wrong += 1;
        }
        if (status != FW_OK) assert_null(scenario);
        fw_scenario_destroy(scenario);
        free(text);
    }
    assert_int_equal(wrong, 0);
}

static void check_refuses_what_run_refuses(void **state)
{
    (void)state;
    char folder[64];
    int wrong = 0;
    make_quick_folder(folder, sizeof folder);
    for (size_t n = 0; n < sizeof mistakes / sizeof mistakes[0]; ++n) {
        char *text = change(mistakes[n].written, mistakes[n].instead);
        wrong += both_refuse(folder, text, mistakes[n].sentence);
        free(text);
    }
    remove_folder(folder);
    assert_int_equal(wrong, 0);
}

static void every_wrong_setting_names_its_option(void **state)
{
    (void)state;
    int wrong = 0;
    for (size_t n = 0; n < sizeof wrong_settings / sizeof wrong_settings[0]; ++n) {
        char expected[FW_SENTENCE_SIZE];
        snprintf(expected, sizeof expected, "--set %s", wrong_settings[n].sentence);
        fw_scenario *scenario;
        error = (fw_error){FW_OK, "accepted"};
        fw_status status = fw_scenario_read(&scenario, "scenario.yaml", right, strlen(right),
                                            &wrong_settings[n].setting, 1, &error);
        if (status != FW_BAD_INPUT || strcmp(error.sentence, expected) != 0) {
            print_error("  found    %s\n  expected %s\n", error.sentence, expected);
            wrong += 1;
        }
        fw_scenario_destroy(scenario);
    }
    assert_int_equal(wrong, 0);
}

/* Whatever part of the file did not arrive: a sentence, never a crash and never a surprise. */
static void a_file_cut_anywhere_is_refused_or_whole(void **state)
{
    (void)state;
    for (size_t length = 0; length < strlen(right); ++length) {
        fw_scenario *scenario;
        error = (fw_error){FW_OK, ""};
        fw_status status =
            fw_scenario_read(&scenario, "scenario.yaml", right, length, NULL, 0, &error);
        if (status == FW_OK) {
            assert_true(scenario->run.steps >= 1); /* cut after a whole line */
            fw_scenario_destroy(scenario);
            continue;
        }
        assert_int_equal(status, FW_BAD_INPUT);
        assert_int_equal(strncmp(error.sentence, "scenario.yaml:", 14), 0);
        assert_null(strchr(error.sentence, '\n'));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_right_scenario_is_read),
        cmocka_unit_test(every_mistake_gets_its_sentence),
        cmocka_unit_test(check_refuses_what_run_refuses),
        cmocka_unit_test(every_wrong_setting_names_its_option),
        cmocka_unit_test(a_file_cut_anywhere_is_refused_or_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
