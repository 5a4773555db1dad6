/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_apart.c - what contact costs where nothing touches:
 *     bench_apart NAME [TRIALS]
 * prints for each trial the steps a second of a scene, and of the same bodies alone. `walls`: an LB
 * solid of 1001 x 1001 with 4000 boundary particles, apart from 84 walls; `bodies`: two of 501 x
 * 501 with 4000 boundary particles together, apart from each other. Both take turns, step by step,
 * and the medians of many steps are compared. tests/bench/run knows the names. */
#include "tests/support/scenes.h"

#include "tests/bench/timing.h"
#include "tests/support/random_walls.h"

#include <stdio.h>

enum { WALLS = 84, STEPS = 201 };

static int compare_doubles(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

static double one_step(fw_scene *scene)
{
    const double begun = processor_seconds();
    must(fw_scene_advance(scene, 1, &error));
    return processor_seconds() - begun;
}

static void add_square(fw_scene *scene, int side, double x)
{
    add_body(scene, (body_options){.columns = side,
                                   .rows = side,
                                   .origin = {x, 0},
                                   .velocity = {0.01, 0.02},
                                   .rest_mass = 1,
                                   .form = FW_LB_DISPLACEMENTS});
}

/* Is the body's square on the free side? */
static bool lets_be(const fw_wall_def *def, int side)
{
    fw_wall *wall;
    bool lies_free = true;
    must(fw_wall_create(&wall, 0, def, &error));
    for (int k = 0; k <= 8; ++k)
        for (int l = 0; l <= 8; ++l)
            lies_free &= !(fw_wall_depth(wall, (fw_vec2){0.125 * k * side, 0.125 * l * side},
                                         (fw_vec2){0, 0}) > 0);
    fw_wall_destroy(wall);
    return lies_free;
}

/* A room, and all kinds of walls in it beside the body. */
static void add_walls(fw_scene *scene, int side)
{
    const fw_vec2 room[] = {{-2000, -2000}, {3000, 3000}};
    dice d = {1};
    for (int i = 0; i < WALLS; ++i) {
        wall_recipe recipe;
        char name[16];
        do random_wall(&recipe, &d, dice_point(&d, (fw_vec2){-800, 500}, 550), 40, 0);
        while (recipe.def.shape == FW_CHAIN || !lets_be(&recipe.def, side));
        if (i == 0) {
            recipe.def = fw_wall_def_default();
            recipe.def.points = room;
        }
        snprintf(name, sizeof name, "w%d", i);
        recipe.def.name = name;
        must(fw_scene_add_wall(scene, &recipe.def, &error));
    }
}

static fw_scene *scene_of(int bodies, int side, bool alone, int number)
{
    fw_scene *scene = empty_scene(1e9);
    for (int b = 0; b < bodies; ++b)
        if (!alone || b == number) add_square(scene, side, 1.5 * side * b);
    if (bodies == 1 && !alone) add_walls(scene, side);
    begin(scene);
    return scene;
}

static double median_of(double *values)
{
    qsort(values, STEPS, sizeof *values, compare_doubles);
    return values[STEPS / 2];
}

static void measure(int bodies, int side, int trials)
{
    fw_scene *scene = scene_of(bodies, side, false, 0), *alone[2] = {NULL, NULL};
    for (int b = 0; b < bodies; ++b) alone[b] = scene_of(bodies, side, true, b);
    for (int trial = 0; trial < trials; ++trial) {
        double ours[STEPS], theirs[STEPS];
        for (int step = 0; step < STEPS; ++step) {
            ours[step] = one_step(scene);
            theirs[step] = 0;
            for (int b = 0; b < bodies; ++b) theirs[step] += one_step(alone[b]);
        }
        printf("%.5g %.5g\n", 1 / median_of(ours), 1 / median_of(theirs));
        fflush(stdout);
    }
    fw_scene_destroy(scene);
    for (int b = 0; b < bodies; ++b) fw_scene_destroy(alone[b]);
}

int main(int count, char **words)
{
    const int trials = count > 2 ? atoi(words[2]) : 3;
    if (count > 1 && strcmp(words[1], "walls-apart") == 0)
        measure(1, 1001, trials);
    else if (count > 1 && strcmp(words[1], "bodies-apart") == 0)
        measure(2, 501, trials);
    else
        puts("walls-apart\nbodies-apart");
    return 0;
}
