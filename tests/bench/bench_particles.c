/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_particles.c - what a step of movable particles costs: million particle-steps per second of
 * processor time, for a hexagonal crystal with and without return force and thermostat. By hand:
 *     bench_particles [columns] [steps]                       (columns^2 particles, by default 320)
 */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"
#include "tests/support/steps.h"

#include <stdlib.h>
#include <time.h>

/* Processor time: on one thread the same as time on a machine that does nothing else. */
static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void measure(int columns, int steps, double cut, bool thermostat, double amplitude,
                    fw_return_axes axes)
{
    fw_crowd crowd = crowd_rectangle(columns, columns, (fw_vec2){0, 0}, 1, 0, 1);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    group.return_force = return_force_of(6, amplitude, axes, FW_RETURN_CONSERVATIVE);
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.potential.cut = fw_smooth_cut_over(cut - 0.3, cut);
    if (thermostat) def.controls.damping = 1, def.controls.temperature = 0.1;
    fw_solid *solid;
    if (fw_particles_create(&solid, &def, NULL) != FW_OK) abort();
    fw_particles_draw_velocities(solid, -1, 0.1);
    for (int step = 0; step < steps / 5; ++step) advance_free(solid);
    const int64_t lists = fw_particles_neighbours(solid)->generation;
    const double begin = seconds();
    for (int step = 0; step < steps; ++step) advance_free(solid);
    const double taken = seconds() - begin;
    static const char *const axes_names[] = {"lab", "corotating", "surface"};
    printf("cut %.2f  %-8s  return force %-10s  %7.2f M/s   a list every %.0f steps\n", cut,
           thermostat ? "Langevin" : "Verlet", amplitude > 0 ? axes_names[axes] : "none",
           1e-6 * solid->count * steps / taken,
           (double)steps / (double)(fw_particles_neighbours(solid)->generation - lists));
    fw_solid_destroy(solid);
    free(crowd.at);
}

int main(int count, char **arguments)
{
    const int columns = count > 1 ? atoi(arguments[1]) : 320;
    const int steps = count > 2 ? atoi(arguments[2]) : 100;
    const double cuts[] = {1.7, 2.5 / 1.122462048309373};
    for (int c = 0; c < 2; ++c)
        for (int thermostat = 0; thermostat < 2; ++thermostat) {
            measure(columns, steps, cuts[c], thermostat, 0, FW_AXES_LAB);
            measure(columns, steps, cuts[c], thermostat, 1, FW_AXES_LAB);
            measure(columns, steps, cuts[c], thermostat, 1, FW_AXES_COROTATING);
        }
    return 0;
}
