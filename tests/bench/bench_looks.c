/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_looks.c - what it costs to look at a body of a million: nanoseconds a particle of processor
 * time on one thread, the least of several trials, each after a step. Below, what no program does
 * without that makes a frame of an LB solid: four arrays are read, and 48 bytes a particle written
 * past the cache. */
#include "experiments/results/frame_kernels.h"
#include "experiments/setup/experiment.h"
#include "tests/bench/timing.h"
#include "tests/support/laws.h"

#include <stdio.h>
#include <string.h>

enum { SIDE = 1000, TRIALS = 15, APART = 40 };

static const struct {
    const char *material, *lattice;
} bodies[] = {
    {"lattice-boltzmann: {}", "square"},
    {"elastic-automaton: {c1: 0.9, c2: 0.5}", "square"},
    {"linear-lattice: {}", "hexagonal"},
    {"movable-particles: {}", "hexagonal"},
};

typedef struct memory {
    double *position, *velocity, *x, *y;
} memory;

static void fail_with(const fw_error *error)
{
    puts(error->sentence);
    exit(1);
}

static void energies(fw_solid *solid, memory *m)
{
    m->x[0] = fw_solid_energies(solid).kinetic + fw_solid_momentum(solid).x;
}

static void middle(fw_solid *solid, memory *m)
{
    m->x[0] = solid->model->centre_of_mass(solid).x;
}

static void place(fw_solid *solid, memory *m)
{
    fw_solid_place(solid);
    m->x[0] = fw_solid_find_lost(solid, (fw_vec2){0, 0}, 1e9);
}

static void bound(fw_solid *solid, memory *m)
{
    const fw_solid_model *model = solid->model;
    m->x[0] = model->stays_within && model->stays_within(solid, (fw_vec2){0, 0}, 1e9);
}

static void velocities(fw_solid *solid, memory *m)
{
    solid->model->velocities(solid, m->x, m->y);
}

static void put(const memory *m, int first, int count, const fw_motions *from)
{
    FW_KERNELS_CHOSEN(fw_frames)->rows(from->x, from->y, count, true, m->position + 3 * first);
    FW_KERNELS_CHOSEN(fw_frames)->rows(from->velocity_x, from->velocity_y, count, true,
                                       m->velocity + 3 * first);
}

/* The rows of a frame. */
static void frame(fw_solid *solid, memory *m)
{
    double made[4][FW_FRAME_BLOCK + APART];
    const fw_motions motions = {made[0], made[1], made[2], made[3]};
    if (!solid->model->motions) {
        fw_solid_place(solid);
        velocities(solid, m);
    }
    for (int first = 0; first < solid->count; first += FW_FRAME_BLOCK) {
        const int left = solid->count - first,
                  count = left < FW_FRAME_BLOCK ? left : FW_FRAME_BLOCK;
        if (!solid->model->motions) {
            put(m, first, count,
                &(fw_motions){solid->x + first, solid->y + first, m->x + first, m->y + first});
            continue;
        }
        solid->model->motions(solid, first, count, &motions);
        put(m, first, count, &motions);
    }
}

static const struct {
    const char *name;
    void (*look)(fw_solid *solid, memory *m);
} looks[] = {
    {"energies", energies}, {"middle", middle},         {"positions", place},
    {"bound", bound},       {"velocities", velocities}, {"frame", frame},
};
enum { LOOKS = sizeof looks / sizeof *looks };

static double cost_of(fw_solid *solid, int look, memory *m)
{
    double least = INFINITY;
    fw_error error;
    for (int trial = 0; trial < TRIALS; ++trial) {
        if (fw_solid_advance_free(solid, &error) != FW_OK) fail_with(&error);
        const double begun = processor_seconds();
        looks[look].look(solid, m);
        least = fmin(least, processor_seconds() - begun);
    }
    return 1e9 * least / solid->count;
}

static void print_body(size_t n, memory *m)
{
    char text[512];
    fw_scenario *scenario;
    fw_experiment *experiment;
    fw_error error;
    snprintf(text, sizeof text,
             "title: cost\nmaterials: {m: {%s}}\nbodies: {b: {material: m, lattice: %s, shape: "
             "{rectangle: [%d, %d]}, velocity: [0.01, 0.02]}}\nrun: {steps: 1}\n",
             bodies[n].material, bodies[n].lattice, SIDE, SIDE);
    if (fw_scenario_read(&scenario, "bench", text, strlen(text), NULL, 0, &error) != FW_OK ||
        fw_experiment_create(&experiment, scenario, &error) != FW_OK)
        fail_with(&error);
    printf("%-40s", bodies[n].material);
    for (int look = 0; look < LOOKS; ++look)
        printf("%11.2f", cost_of(fw_scene_body(experiment->scene, 0), look, m));
    puts("");
    fflush(stdout);
    fw_experiment_destroy(experiment);
    fw_scenario_destroy(scenario);
}

/* a to d stand for x(t) and x(t-1). */
static void bare_pass(const double *a, const double *b, const double *c, const double *d, int count,
                      const memory *m)
{
    double made[4][FW_FRAME_BLOCK + APART];
    const fw_motions motions = {made[0], made[1], made[2], made[3]};
    for (int first = 0; first + FW_FRAME_BLOCK <= count; first += FW_FRAME_BLOCK) {
        for (int k = 0; k < FW_FRAME_BLOCK; ++k) {
            const int l = first + k;
            __builtin_prefetch(a + l + 256);
            __builtin_prefetch(b + l + 256);
            __builtin_prefetch(c + l + 256);
            __builtin_prefetch(d + l + 256);
            made[0][k] = a[l] + c[l];
            made[1][k] = b[l] + d[l];
            made[2][k] = a[l] - c[l];
            made[3][k] = b[l] - d[l];
        }
        put(m, first, FW_FRAME_BLOCK, &motions);
    }
}

static void print_bound(const memory *m)
{
    enum { COUNT = SIDE * SIDE };
    double *all = fw_array_of_doubles(4 * (COUNT + 512)), least = INFINITY;
    if (!all) abort();
    /* Starts that the first cache does not map upon each other. */
    const size_t next = COUNT + 40;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const double begun = processor_seconds();
        bare_pass(all, all + next, all + 2 * next, all + 3 * next, COUNT, m);
        least = fmin(least, processor_seconds() - begun);
    }
    printf("%-40s%66.2f\n", "32 bytes read, 48 written, all in", 1e9 * least / COUNT);
    free(all);
}

int main(void)
{
    const size_t room = (size_t)SIDE * SIDE + 2 * FW_FRAME_BLOCK;
    memory m = {fw_array_of_doubles(3 * room), fw_array_of_doubles(3 * room),
                fw_array_of_doubles(room), fw_array_of_doubles(room)};
    if (!m.position || !m.velocity || !m.x || !m.y) abort();
    printf("%-40s", "ns a particle");
    for (int look = 0; look < LOOKS; ++look) printf("%11s", looks[look].name);
    puts("");
    for (size_t n = 0; n < sizeof bodies / sizeof *bodies; ++n) print_body(n, &m);
    print_bound(&m);
    free(m.position);
    free(m.velocity);
    free(m.x);
    free(m.y);
    return 0;
}
