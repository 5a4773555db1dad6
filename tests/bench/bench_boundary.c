/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What it costs to know which walls are near: microseconds per step, with a query of the tree per
 * particle and with runs of 32 and their cached boxes. 84 wall shapes in a box, a slow body that is
 * made of nothing but boundary, apart from the walls and in the middle of them. Prints a table. */
#include "contact/search/boundary.h"
#include "tests/support/random_walls.h"

#include <stdlib.h>
#include <time.h>

enum { WALLS = 84 };

static const fw_solid_model ballistic = {.name = "ballistic", .ticks_per_step = 1};

static double microseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e6 * (double)now.tv_sec + 1e-3 * (double)now.tv_nsec;
}

static int compare_doubles(const void *a, const void *b)
{
    double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

static void fly(fw_solid *solid, fw_vec2 velocity)
{
    for (int i = 0; i < solid->count; ++i) {
        solid->x[i] += velocity.x;
        solid->y[i] += velocity.y;
    }
}

static double query_per_particle(const fw_solid *solid, const fw_broadphase *broadphase,
                                 fw_vec2 velocity)
{
    double begin = microseconds();
    long found = 0;
    for (int i = 0; i < solid->count; ++i) {
        fw_vec2 r = fw_solid_position(solid, i), end = fw_vec2_add(r, velocity);
        fw_box box = {{fmin(r.x, end.x), fmin(r.y, end.y)}, {fmax(r.x, end.x), fmax(r.y, end.y)}};
        int list[64];
        found += fw_broadphase_query(broadphase, box, list, 64);
    }
    double took = microseconds() - begin;
    if (found < 0) abort();
    return took;
}

static void measure(fw_broadphase *broadphase, int moving_wall, int count, fw_vec2 corner,
                    const char *where)
{
    enum { STEPS = 400 };
    const fw_vec2 velocity = {0.02, 0.013};
    const int columns = (int)sqrt(count);
    fw_solid solid = {0};
    fw_solid_head_begin(&solid, &ballistic, count);
    if (fw_solid_allocate(&solid, NULL) != FW_OK) abort();
    solid.count = solid.boundary_count = count;
    for (int i = 0; i < count; ++i) {
        solid.boundary[i] = i;
        solid.x[i] = corner.x + i % columns;
        solid.y[i] = corner.y + i / columns;
    }
    double begin = microseconds();
    fw_boundary *boundary;
    if (fw_boundary_create(&boundary, &solid, NULL) != FW_OK) abort();
    double creation = microseconds() - begin;
    for (int k = 0; k < count; ++k) fw_boundary_predictions(boundary)[k].displacement = velocity;
    static double took[STEPS];
    double mean = 0;
    for (int step = 0; step < STEPS; ++step) {
        begin = microseconds();
        if (moving_wall >= 0)
            fw_broadphase_move_wall(broadphase, moving_wall, (fw_vec2){0.02 * step, 0},
                                    (fw_vec2){0.02, 0});
        if (fw_boundary_refresh(boundary, &solid, broadphase, NULL) != FW_OK) abort();
        took[step] = microseconds() - begin;
        if (step > 0) mean += took[step] / (STEPS - 1); /* the first asks for every run */
        fly(&solid, velocity);
    }
    qsort(took, STEPS, sizeof *took, compare_doubles);
    double near = 0;
    for (int run = 0; run < fw_boundary_run_count(boundary); ++run)
        near += fw_boundary_observe_run(boundary, run).facet_count > 0;
    printf("%8d  %-22s %10.1f %10.1f %10.1f %12.2f %10.2f %10.0f\n", count, where,
           query_per_particle(&solid, broadphase, velocity), mean, took[STEPS / 2],
           (double)fw_boundary_query_count(boundary) / STEPS,
           near / fw_boundary_run_count(boundary), creation);
    fw_boundary_destroy(boundary);
    fw_solid_head_release(&solid);
}

int main(void)
{
    fw_wall *walls[WALLS];
    const fw_vec2 room[] = {{0, 0}, {2000, 2000}};
    fw_wall_def def = fw_wall_def_default();
    def.points = room;
    if (fw_wall_create(&walls[0], 0, &def, NULL) != FW_OK) abort();
    fw_broadphase *broadphase = fw_broadphase_create(fw_wall_bounds(walls[0]));
    dice d = {1};
    for (int i = 0; i < WALLS; ++i) {
        wall_recipe recipe;
        random_wall(&recipe, &d, dice_point(&d, (fw_vec2){600, 1000}, 550), 40, 0);
        if (i > 0 && fw_wall_create(&walls[i], i, &recipe.def, NULL) != FW_OK) abort();
        if (fw_broadphase_add_wall(broadphase, walls[i]) < 0) abort();
    }
    printf("microseconds per step, slow motion, %d walls with %d facets\n", WALLS,
           fw_broadphase_facet_count(broadphase));
    printf("    boundary  where                  per query  runs: mean     median queries/step"
           "  runs near  to create\n");
    const int counts[] = {4000, 100000};
    for (int i = 0; i < 2; ++i) {
        measure(broadphase, -1, counts[i], (fw_vec2){1300, 1300}, "apart");
        measure(broadphase, -1, counts[i], (fw_vec2){400, 900}, "among the walls");
        measure(broadphase, 1, counts[i], (fw_vec2){1300, 1300}, "apart, one wall moves");
    }
    fw_broadphase_destroy(broadphase);
    for (int i = 0; i < WALLS; ++i) fw_wall_destroy(walls[i]);
    return 0;
}
