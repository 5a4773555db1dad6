/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_walls.c - what walls cost: nanoseconds of processor time per particle and step, for a gas
 * and a crystal of movable particles in a box of each surface, and for an LB sheet, none of it but
 * boundary. By hand:
 *     bench_walls [columns] [steps] */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"
#include "tests/support/scenes.h"

#include <time.h>

/* Processor time: on one thread the same as time on a machine that does nothing else. */
static double nanoseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static void add_crowd(fw_scene *scene, int columns, double spacing)
{
    fw_crowd crowd = crowd_rectangle(columns, columns, (fw_vec2){0, 0}, spacing, 0, 1);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    fw_solid *solid;
    int body;
    must(fw_particles_create(&solid, &def, &error));
    fw_particles_draw_velocities(solid, -1, 0.1);
    must(fw_scene_adopt_body(scene, "crowd", solid, &body, &error));
    free(crowd.at);
}

static double cost_of(int columns, int steps, double spacing, const fw_surface *surface)
{
    fw_scene *scene = empty_scene(INFINITY);
    if (spacing > 0)
        add_crowd(scene, columns, spacing);
    else
        add_body(scene, (body_options){.columns = columns, .rows = 1, .velocity = {0.01, -0.005}});
    const double size = columns * fmax(spacing, 1);
    const fw_vec2 corners[] = {{-0.5, -0.5}, {size + 0.5, size + 0.5}};
    fw_wall_def def = fw_wall_def_default();
    def.points = corners;
    if (surface) {
        def.surface = *surface;
        must(fw_scene_add_wall(scene, &def, &error));
    }
    begin(scene);
    run(scene, steps / 5);
    const double from = nanoseconds();
    run(scene, steps);
    const double taken = nanoseconds() - from;
    const double per = taken / steps / fw_scene_observe_body(scene, 0)->count;
    fw_scene_destroy(scene);
    return per;
}

int main(int count, char **arguments)
{
    const int columns = count > 1 ? atoi(arguments[1]) : 60;
    const int steps = count > 2 ? atoi(arguments[2]) : 500;
    static const struct {
        const char *name;
        fw_surface surface;
    } walls[] = {{"none", {.law = FW_FRICTIONLESS}},
                 {"frictionless", {.law = FW_FRICTIONLESS}},
                 {"coulomb", {.law = FW_COULOMB, .friction = 0.3}},
                 {"penalty", {.law = FW_PENALTY, .stiffness = 0.2}}};
    printf("%-14s %10s %10s %10s   ns per particle and step\n", "surface", "crystal", "gas",
           "LB row");
    for (int w = 0; w < 4; ++w) {
        const fw_surface *surface = w == 0 ? NULL : &walls[w].surface;
        printf("%-14s %10.0f %10.0f %10.0f\n", walls[w].name, cost_of(columns, steps, 1, surface),
               cost_of(columns, steps, 3, surface), cost_of(columns * columns, steps, 0, surface));
    }
    return 0;
}
