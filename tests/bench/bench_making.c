/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_making.c - what making a body costs, in steps: processor time of one thread, for bodies of
 * 10^4, 10^5 and 10^6 particles of every material. The cost per particle is to stay the same. */
#include "experiments/setup/experiment.h"
#include "tests/bench/timing.h"
#include "tests/support/laws.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *material, *lattice;
} bodies[] = {
    {"lattice-boltzmann: {}", "square"},
    {"lattice-boltzmann: {rest-mass: 0.8, damping: 0.01}", "square"},
    {"elastic-automaton: {c1: 0.9, c2: 0.5}", "square"},
    {"elastic-automaton: {c1: 0.9, c2: 0.5, break-at: 1}", "square"},
    {"elastic-automaton: {c1: 0.4, c2: 0.5}", "square"},
    {"linear-lattice: {}", "hexagonal"},
    {"movable-particles: {}", "hexagonal"},
    {"movable-particles: {return-force: {amplitude: 1}}", "hexagonal"},
};

typedef struct cost {
    double making, step; /* seconds */
} cost;

static void fail_with(const fw_error *error)
{
    puts(error->sentence);
    exit(1);
}

/* Of a square body; the best of several trials. */
static cost cost_of(const char *material, const char *lattice, int side)
{
    enum { TRIALS = 3, STEPS = 16 };
    char text[512];
    cost best = {INFINITY, INFINITY};
    snprintf(text, sizeof text,
             "title: cost\nmaterials: {m: {%s}}\nbodies: {b: {material: m, lattice: %s, shape: "
             "{rectangle: [%d, %d]}, velocity: [0.01, 0.02]}}\nrun: {steps: 1}\n",
             material, lattice, side, side);
    for (int trial = 0; trial < TRIALS; ++trial) {
        fw_scenario *scenario;
        fw_experiment *experiment;
        fw_error error;
        if (fw_scenario_read(&scenario, "bench", text, strlen(text), NULL, 0, &error) != FW_OK)
            fail_with(&error);
        const double begun = processor_seconds();
        if (fw_experiment_create(&experiment, scenario, &error) != FW_OK) fail_with(&error);
        const double made = processor_seconds();
        fw_solid *solid = fw_scene_body(experiment->scene, 0);
        if (fw_solid_move_free(solid, STEPS * solid->model->ticks_per_step, &error) != FW_OK)
            fail_with(&error);
        const double stepped = processor_seconds();
        best.making = fmin(best.making, made - begun);
        best.step = fmin(best.step, (stepped - made) / STEPS);
        fw_experiment_destroy(experiment);
        fw_scenario_destroy(scenario);
    }
    return best;
}

int main(void)
{
    static const int sides[] = {100, 316, 1000};
    printf("%-52s particles   ns a particle   a step   in steps\n", "");
    for (size_t n = 0; n < sizeof bodies / sizeof bodies[0]; ++n)
        for (size_t s = 0; s < sizeof sides / sizeof sides[0]; ++s) {
            const double count = (double)sides[s] * sides[s];
            const cost c = cost_of(bodies[n].material, bodies[n].lattice, sides[s]);
            printf("%-52s %9.0f   %13.1f   %6.2f   %8.0f\n", bodies[n].material, count,
                   1e9 * c.making / count, 1e9 * c.step / count, c.making / c.step);
            fflush(stdout);
        }
    return 0;
}
