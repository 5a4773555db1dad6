/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_solids.c - what a step costs per particle, for every model: processor time of free bodies
 * of 200 x 200 particles in motion, on one thread; the best of several trials. */
#include "experiments/setup/experiment.h"
#include "tests/support/steps.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

enum { SIDE = 200, STEPS = 40, TRIALS = 9 };

static const struct {
    const char *material, *lattice;
} bodies[] = {
    {"lattice-boltzmann: {}", "square"},
    {"lattice-boltzmann: {rest-mass: 0.8, damping: 0.01}", "square"},
    {"elastic-automaton: {c1: 0.9, c2: 0.5}", "square"},
    {"elastic-automaton: {c1: 0.9, c2: 0.5, damping: 0.01}", "square"},
    {"elastic-automaton: {c1: 0.9, c2: 0.5, break-at: 1}", "square"},
    {"linear-lattice: {}", "hexagonal"},
    {"movable-particles: {}", "hexagonal"},
    {"movable-particles: {return-force: {amplitude: 1}}", "hexagonal"},
};

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Nanoseconds per particle and step; negative: the sentence has been printed. */
static double cost_of(const char *material, const char *lattice)
{
    char text[512];
    fw_scenario *scenario;
    fw_experiment *experiment;
    fw_error error;
    snprintf(text, sizeof text,
             "title: cost\nmaterials: {m: {%s}}\nbodies: {b: {material: m, lattice: %s, shape: "
             "{rectangle: [%d, %d]}, velocity: [0.01, 0.02]}}\nrun: {steps: 1}\n",
             material, lattice, SIDE, SIDE);
    if (fw_scenario_read(&scenario, "bench", text, strlen(text), NULL, 0, &error) != FW_OK) {
        puts(error.sentence);
        return -1;
    }
    if (fw_experiment_create(&experiment, scenario, &error) != FW_OK) {
        puts(error.sentence);
        fw_scenario_destroy(scenario);
        return -1;
    }
    fw_solid *solid = fw_scene_body(experiment->scene, 0);
    double best = 1e9;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const double begun = seconds();
        for (int tick = 0; tick < STEPS * solid->model->ticks_per_step; ++tick) advance_free(solid);
        const double taken = seconds() - begun;
        if (taken < best) best = taken;
    }
    const double cost = 1e9 * best / STEPS / solid->count;
    fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
    return cost;
}

int main(void)
{
    printf("%-52s ns per particle and step\n", "");
    for (size_t n = 0; n < sizeof bodies / sizeof bodies[0]; ++n) {
        const double cost = cost_of(bodies[n].material, bodies[n].lattice);
        if (cost < 0) return 1;
        printf("%-52s %.1f\n", bodies[n].material, cost);
    }
    return 0;
}
