/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What it costs that bodies keep out of each other: microseconds per step of two bodies apart from
 * each other, beside the same bodies in scenes of their own, one and one in turn; of two whose
 * faces are pressed together; and of a crowd. Prints a table. */
#include "core/automaton/elastic_automaton.h"
#include "tests/bench/timing.h"
#include "tests/support/scenes.h"

#include <stdio.h>
#include <time.h>

static double microseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e6 * (double)now.tv_sec + 1e-3 * (double)now.tv_nsec;
}

static int compare_doubles(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

static double one_step(fw_scene *scene)
{
    const double begin_time = microseconds();
    run(scene, 1);
    return microseconds() - begin_time;
}

static void add_square(fw_scene *scene, int side, double x)
{
    add_body(scene, (body_options){.columns = side,
                                   .rows = side,
                                   .origin = {x, 0},
                                   .velocity = {0.01, 0.02},
                                   .rest_mass = 1});
}

/* Medians of 61 steps each. */
static void apart(int side)
{
    enum { STEPS = 61 };
    double together[STEPS], alone[STEPS], ratio[STEPS];
    fw_scene *both = empty_scene(1e9), *left = empty_scene(1e9), *right = empty_scene(1e9);
    add_square(both, side, 0);
    add_square(both, side, 1.5 * side);
    add_square(left, side, 0);
    add_square(right, side, 1.5 * side);
    begin(both);
    begin(left);
    begin(right);
    for (int n = 0; n < STEPS; ++n) {
        together[n] = one_step(both);
        alone[n] = one_step(left) + one_step(right);
        ratio[n] = together[n] / alone[n];
    }
    qsort(together, STEPS, sizeof *together, compare_doubles);
    qsort(alone, STEPS, sizeof *alone, compare_doubles);
    qsort(ratio, STEPS, sizeof *ratio, compare_doubles);
    printf("apart, 2 bodies of %4d x %4d, %5d boundary particles each: %8.0f us, alone %8.0f, "
           "ratio of medians %.3f, median of ratios %.3f\n",
           side, side, 4 * side - 4, together[STEPS / 2], alone[STEPS / 2],
           together[STEPS / 2] / alone[STEPS / 2], ratio[STEPS / 2]);
    fw_scene_destroy(both);
    fw_scene_destroy(left);
    fw_scene_destroy(right);
}

/* Two bodies of 1000 x 20, one upon the other: processor time of whole steps. */
static void faces(double offset)
{
    fw_scene *scene = empty_scene(1e9);
    add_body(scene, (body_options){.columns = 1000, .rows = 20});
    add_body(scene,
             (body_options){
                 .columns = 1000, .rows = 20, .origin = {offset, 19.001}, .velocity = {0, -0.02}});
    begin(scene);
    double slowest = 0, sum = 0;
    enum { STEPS = 60 };
    for (int n = 0; n < STEPS; ++n) {
        const double begin_time = processor_seconds();
        run(scene, 1);
        const double took = processor_seconds() - begin_time;
        slowest = fmax(slowest, took);
        sum += took;
    }
    const fw_contact_ledger *ledger = fw_scene_contact_ledger(scene);
    printf("faces of 1000, offset %g: mean %.1f ms, slowest %.1f ms, %g steps in contact, %.1f "
           "iterations each, %g not converged\n",
           offset, 1e3 * sum / STEPS, 1e3 * slowest, ledger->ticks,
           ledger->iterations / fmax(ledger->ticks, 1), ledger->unconverged);
    fw_scene_destroy(scene);
}

/* Bodies of 6 x 6 on a grid, that fly in all directions. */
static void crowd(int side)
{
    fw_scene *scene = empty_scene(1e9);
    for (int b = 0; b < side * side; ++b)
        add_body(scene, (body_options){.columns = 6,
                                       .rows = 6,
                                       .angle = 0.1 * b,
                                       .origin = {16.0 * (b % side), 16.0 * (b / side)},
                                       .velocity = {0.05 * sin(2.3 * b), 0.05 * cos(3.1 * b)}});
    begin(scene);
    run(scene, 100);
    const double begin_time = microseconds();
    run(scene, 200);
    const double each = (microseconds() - begin_time) / 200;
    const fw_contact_ledger *ledger = fw_scene_contact_ledger(scene);
    printf("crowd of %d bodies of 6 x 6: %.0f us a step, %g iterations a step\n", side * side, each,
           ledger->iterations / 300);
    fw_scene_destroy(scene);
}

/* A crack runs through a body, one bond a step; another body is far from it, or there is none. */
static double crack(int side, bool meets, bool runs)
{
    enum { STEPS = 61 };
    double took[STEPS];
    fw_scene *scene = empty_scene(1e9);
    fw_sites sites;
    must(fw_sites_rectangle(&sites, side, side, &error));
    fw_elastic_automaton_def def = fw_elastic_automaton_def_default();
    def.sites = &sites;
    def.break_at = 1;
    fw_solid *solid[2];
    for (int b = 0; b < 1 + meets; ++b) {
        int body;
        must(fw_elastic_automaton_create(&solid[b], &def, &error));
        must(fw_scene_adopt_body(scene, "slab", solid[b], &body, &error));
        if (b > 0) break;
        fw_sites_clear(&sites);
        must(fw_sites_rectangle(&sites, 4, 4, &error));
        def.lattice.origin.x = 3.0 * side;
    }
    begin(scene);
    for (int n = 0; n < STEPS; ++n) {
        const int at = side / 2 * side + n;
        if (runs) (void)fw_elastic_automaton_break(solid[0], at, FW_NORTH);
        took[n] = one_step(scene);
    }
    qsort(took, STEPS, sizeof *took, compare_doubles);
    fw_scene_destroy(scene);
    fw_sites_clear(&sites);
    return took[STEPS / 2];
}

static void cracks(int side)
{
    printf("a body of %d x %d: alone %.0f us a step, beside another one %.0f; while a crack runs "
           "%.0f and %.0f\n",
           side, side, crack(side, false, false), crack(side, true, false),
           crack(side, false, true), crack(side, true, true));
}

int main(void)
{
    apart(200);
    apart(1000);
    faces(0);
    faces(1e-9);
    faces(0.37);
    faces(0.999);
    crowd(10);
    crowd(32);
    cracks(200);
    cracks(700);
    return 0;
}
