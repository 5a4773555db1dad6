/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_contact_short_memory.c - every allocation of scenes fails once, while they are made and
 * while bodies touch: the scene says so or comes to the same bytes without, and nothing is left
 * behind. Start reading at the scenarios. */
#include "tests/support/short_memory.h"

#include "tests/support/scenarios.h"
#include "tests/support/scene_hash.h"

#include <omp.h>

/* Walls of all surfaces, one that moves, drives of all kinds, and links that break. */
static const char walls[] =
    "title: t\n"
    "materials: {brittle: {lattice-boltzmann: {rest-mass: 0, damping: .02, break-at: .2}}}\n"
    "bodies:\n"
    "  sheet: {material: brittle, shape: {rectangle: [8, 4]}, velocity: [.1, -.12]}\n"
    "  held: {material: brittle, shape: {rectangle: [4, 3]}, origin: [0, 9]}\n"
    "walls:\n"
    "  floor: {chain: [[-5, -.2], [20, -.2]], surface: {coulomb: .3}}\n"
    "  step: {polygon: [[8.5, -.1], [12, -.1], [10, 5]], side: outside, surface: stick}\n"
    "  pillow: {circle: [-1.2, 2, .8], side: outside, surface: {penalty: .2}}\n"
    "  lid: {box: [-5, 4, 5, 6], side: outside, surface: {coulomb: .1},\n"
    "    path: {velocity: [0, -.02]}}\n"
    "  ram: {box: [10, 8, 12, 12], side: outside, piston: {mass: 3, force: [-.1, 0]}}\n"
    "grips: {hand: {body: held, side: left, layer: .5, force: [.02, 0], tether: [.1, .1]}}\n"
    "forces: {weight: {body: sheet, acceleration: [0, -.002]}}\n"
    "run: {steps: 30}\n"
    "record: {force: true}\n";

/* Bodies that meet and rub, by pairs of surfaces, at a distance; a piston presses on them. */
static const char bodies[] =
    "title: t\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0, damping: .05}},\n"
    "  brittle: {lattice-boltzmann: {rest-mass: 0, damping: .05, break-at: .1}}}\n"
    "bodies:\n"
    "  upper: {material: brittle, surface: fur, shape: {rectangle: [6, 3]}, origin: [.3, 3.25],\n"
    "    velocity: [.1, -.1]}\n"
    "  lower: {material: soft, shape: {rectangle: [7, 3]}}\n"
    "  far: {material: soft, shape: {rectangle: [2, 2]}, origin: [30, 30]}\n"
    "contact: {friction: .3, distance: .2,\n"
    "  pairs: [{between: [fur, fur], friction: .1, distance: .3}]}\n"
    "walls:\n"
    "  floor: {chain: [[-5, -.3], [20, -.3]], surface: {named: ground}}\n"
    "  ram: {box: [-5, 5.6, 12, 7], side: outside, surface: {coulomb: .2},\n"
    "    piston: {mass: 3, force: [0, -.3], hold: x}}\n"
    "run: {steps: 30}\n"
    "record: {fields: [friction-heat]}\n";

/* A grip presses a body on another one, which pistons hold, hard and soft ones. */
static const char press[] =
    "title: t\n"
    "materials: {soft: {lattice-boltzmann: {rest-mass: 0, damping: .05}}}\n"
    "bodies:\n"
    "  upper: {material: soft, shape: {rectangle: [5, 3]}, origin: [1, 3.1]}\n"
    "  lower: {material: soft, shape: {rectangle: [7, 3]}}\n"
    "contact: {friction: .3}\n"
    "walls:\n"
    "  floor: {box: [-5, -3, 12, -.05], side: outside, surface: {coulomb: .3},\n"
    "    piston: {mass: 3, force: [0, .2], hold: x}}\n"
    "  side: {box: [6.05, -5, 8, 9], side: outside, surface: {coulomb: .2},\n"
    "    piston: {mass: 2, force: [-.1, 0]}}\n"
    "  pillow: {box: [-3, -5, -.02, 9], side: outside, surface: {penalty: .1},\n"
    "    piston: {mass: 2, force: [.1, 0]}}\n"
    "grips: {hand: {body: upper, side: top, layer: .5, force: [.05, -.2], tether: [.1, 0]}}\n"
    "run: {steps: 30}\n"
    "record: {force: true}\n";

static const char automata[] =
    "title: t\n"
    "materials: {sheet: {elastic-automaton: {c1: .4, c2: .2, break-at: .3}}}\n"
    "bodies:\n"
    "  left: {material: sheet, shape: {rectangle: [5, 5]}, velocity: [.1, 0]}\n"
    "  right: {material: sheet, shape: {rectangle: [5, 4]}, origin: [5.1, .3],\n"
    "    velocity: [-.1, .05]}\n"
    "walls: {floor: {chain: [[-5, -.1], [20, -.1]], surface: componentwise}}\n"
    "run: {steps: 20}\n";

/* Movable particles have no links of their own: contact looks for them where bodies meet. */
static const char crystals[] =
    "title: t\n"
    "materials: {crystal: {movable-particles: {}}, plate: {linear-lattice: {}}}\n"
    "bodies:\n"
    "  block: {material: crystal, lattice: hexagonal, shape: {rectangle: [5, 4]},\n"
    "    velocity: [0, -.5]}\n"
    "  plate: {material: plate, lattice: hexagonal, shape: {rectangle: [6, 3]},\n"
    "    origin: [-.2, -1.8], velocity: [0, .5]}\n"
    "dynamics: {time-step: .005}\n"
    "run: {steps: 60}\n";

static fw_status run_scene(fw_experiment *experiment, uint64_t *result, fw_error *failed)
{
    fw_scene *scene = experiment->scene;
    for (int64_t step = 0; step < experiment->scenario->run.steps; ++step)
        FW_TRY(fw_experiment_step(experiment, failed));
    for (int body = 0; body < fw_scene_body_count(scene); ++body) {
        bool found;
        fw_vec2 where;
        if (fw_scene_bodies_meet(scene, body, body)) continue;
        FW_TRY(fw_scene_find_fold(scene, body, experiment->start[body], &found, &where, failed));
    }
    FW_TRY(fw_scene_restored(scene, failed));
    FW_TRY(fw_experiment_step(experiment, failed));
    *result = hash_of_scene(scene);
    return FW_OK;
}

static fw_status run_scenario(const void *scenario, uint64_t *result, fw_error *failed)
{
    fw_experiment *experiment;
    FW_TRY(fw_experiment_create(&experiment, scenario, failed));
    const fw_status status = run_scene(experiment, result, failed);
    fw_experiment_destroy(experiment);
    return status;
}

static void refuse_all(const char *name, const char *text, int least)
{
    fw_scenario *scenario = read_right(text);
    assert_true(fail_each_allocation(name, run_scenario, scenario) >= least);
    fw_scenario_destroy(scenario);
}

static void bodies_at_walls_say_that_memory_is_missing(void **state)
{
    (void)state;
    refuse_all("walls", walls, 100);
}

static void bodies_that_meet_say_that_memory_is_missing(void **state)
{
    (void)state;
    refuse_all("bodies", bodies, 100);
}

static void bodies_in_a_press_say_that_memory_is_missing(void **state)
{
    (void)state;
    refuse_all("press", press, 100);
}

static void automata_that_meet_say_that_memory_is_missing(void **state)
{
    (void)state;
    refuse_all("automata", automata, 100);
}

static void crystals_that_meet_say_that_memory_is_missing(void **state)
{
    (void)state;
    refuse_all("crystals", crystals, 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_at_walls_say_that_memory_is_missing),
        cmocka_unit_test(bodies_that_meet_say_that_memory_is_missing),
        cmocka_unit_test(bodies_in_a_press_say_that_memory_is_missing),
        cmocka_unit_test(automata_that_meet_say_that_memory_is_missing),
        cmocka_unit_test(crystals_that_meet_say_that_memory_is_missing),
    };
    omp_set_num_threads(1); /* allocations come in one order */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
