/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plotted_run.h - a short run in a folder of its own, for the tests of pictures. */
#ifndef FW_PLOTTED_RUN_H
#define FW_PLOTTED_RUN_H

#include "experiments/study/run.h"
#include "tests/support/laws.h"

#include "tests/support/recorded_run.h"

/* A sheet that comes to rest under forces, with stiff links and a heavy particle, and an uneven rod
 * that flies freely. */
static const char scenario_text[] =
    "title: A short run\n"
    "materials:\n"
    "  felt: {lattice-boltzmann: {damping: 0.2}}\n"
    "  steel: {lattice-boltzmann: {rest-mass: 0.5}}\n"
    "bodies:\n"
    "  sheet:\n"
    "    material: felt\n"
    "    shape: {rectangle: [3, 3]}\n"
    "    rest-mass: [{sites: [[2, 2]], value: 2}]\n"
    "    link-stiffness: [{sites: bottom, links: inside, value: [3, 0.5, 2]}]\n"
    "  rod:\n"
    "    material: steel\n"
    "    shape: {rectangle: [4, 1]}\n"
    "    origin: [10, 0]\n"
    "    velocity: [0.01, 0.02]\n"
    "    rest-mass: [{sites: right, value: 3}]\n"
    "    velocities: [{random: 0.05}]\n"
    "walls:\n"
    "  floor: {chain: [[-100, -90], [100, -90]]}\n"
    "forces:\n"
    "  pull: {body: sheet, sites: [[2, 2]], force: [0.07, 0.04]}\n"
    "  twist: {body: sheet, sites: [[1, 0]], force: [-0.02, -0.05]}\n"
    "  hold: {body: sheet, sites: [[0, 0]], force: [-0.05, 0.01]}\n"
    "run: {steps: 800, record-every: 20}\n"
    "record: {force: true, fields: [energy]}\n"
    "measure: [energy, momentum, elongation, centre-of-mass, reaction]\n"
    "pictures:\n"
    "  motion: {kind: motion, instants: [0, 390, 800]}\n"
    "  forces: {kind: forces}\n"
    "  speeds: {kind: field, field: speed}\n"
    "  strip: {kind: field, instants: [0, 800]}\n"
    "  series: {kind: series, observables: [energy, elongation.sheet.x, momentum.rod, reaction]}\n";

static char folder[64];

static inline void run_scenario(const char *text, const char *directory)
{
    fw_scenario *scenario;
    fw_run *run;
    const fw_run_options options = {.directory = directory, .threads = 1, .name = "test"};
    assert_fine(fw_scenario_read(&scenario, "test.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_run_begin(&run, scenario, &options, &error));
    assert_fine(fw_run_to_end(run, &error));
    fw_run_destroy(run);
    fw_scenario_destroy(scenario);
}

static inline int make_run(void **state)
{
    (void)state;
    make_folder(folder, sizeof folder);
    run_scenario(scenario_text, folder);
    return 0;
}

static inline int remove_run(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

#endif
