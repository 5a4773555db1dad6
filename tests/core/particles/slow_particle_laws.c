/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_particle_laws.c - laws of movable particles that only show after long runs: heat baths,
 * drift, Poisson's ratio, order out of disorder. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"
#include "tests/support/steps.h"

#include "core/averages.h"
#include "core/particles/particle_observables.h"
#include "core/placement.h"

#include <stdlib.h>

/* A frictionless box by the hold rule: who would leave it stays where it is in that component. */
typedef struct fw_box_walls {
    fw_vec2 low, high;
    int *all;
    fw_prediction *predicted;
    fw_constraint *constraints;
} fw_box_walls;

static fw_box_walls box_for(const fw_solid *solid, fw_vec2 low, fw_vec2 high)
{
    const size_t count = (size_t)solid->count;
    fw_box_walls box = {low, high, malloc(count * sizeof(int)),
                        malloc(count * sizeof(fw_prediction)),
                        malloc(count * sizeof(fw_constraint))};
    for (int i = 0; i < solid->count; ++i) box.all[i] = i;
    return box;
}

static void free_box(fw_box_walls *box)
{
    free(box->all);
    free(box->predicted);
    free(box->constraints);
}

static bool passes(double at, double displacement, double low, double high)
{
    return (at + displacement < low && displacement < 0) ||
           (at + displacement > high && displacement > 0);
}

static void step_in_box(fw_solid *solid, fw_box_walls *box)
{
    fw_solid_predict(solid, box->all, solid->count, box->predicted);
    int held = 0;
    for (int i = 0; i < solid->count; ++i) {
        const fw_vec2 free = box->predicted[i].displacement;
        const double mobility = box->predicted[i].mobility.xx;
        fw_constraint kept = {i, free, {0, 0}};
        if (passes(solid->x[i], free.x, box->low.x, box->high.x))
            kept.displacement.x = 0, kept.force.x = -free.x / mobility;
        if (passes(solid->y[i], free.y, box->low.y, box->high.y))
            kept.displacement.y = 0, kept.force.y = -free.y / mobility;
        if (kept.force.x != 0 || kept.force.y != 0) box->constraints[held++] = kept;
    }
    advance_held(solid, box->constraints, held);
}

static fw_solid *fluid(double temperature, double time_step, fw_return_variant variant,
                       uint64_t seed)
{
    return solid_of(crowd_rectangle(16, 16, (fw_vec2){0, 0}, 1, 0, 1),
                    return_force_of(6, 1, FW_AXES_LAB, variant),
                    (fw_langevin_controls){time_step, 1, temperature}, seed);
}

/* Equipartition (Popov & Filippov Eqs 15 to 17): a crystal at .05 and a dense liquid at .5, 4
 * seeds: T_kin/T = 1 +- .01. */
static void bath_sets_the_temperature(void **state)
{
    (void)state;
    const double temperatures[] = {0.05, 0.5};
    enum { SEEDS = 4, SAMPLES = 1000 };
    for (int t = 0; t < 2; ++t) {
        double ratios[SEEDS];
        for (int seed = 0; seed < SEEDS; ++seed) {
            fw_solid *solid = fluid(temperatures[t], 0.005, FW_RETURN_CONSERVATIVE, (uint64_t)seed);
            fw_box_walls box = box_for(solid, (fw_vec2){-2, -2}, (fw_vec2){18, 16});
            for (int step = 0; step < 4000; ++step) step_in_box(solid, &box);
            double values[SAMPLES];
            for (int sample = 0; sample < SAMPLES; ++sample) {
                for (int step = 0; step < 10; ++step) step_in_box(solid, &box);
                values[sample] =
                    fw_particle_temperature(solid, -1, (fw_vec2){0, 0}) / temperatures[t];
            }
            ratios[seed] = fw_average_of_replicas(values, SAMPLES).mean;
            free_box(&box);
            fw_solid_destroy(solid);
        }
        const fw_average ratio = fw_average_of_replicas(ratios, SEEDS);
        print_message("T = %g: T_kin/T = %.4f +- %.4f\n", temperatures[t], ratio.mean, ratio.error);
        assert_close(ratio.mean, 1, 0.01);
    }
}

/* Holding a particle for a step must not favour any place or velocity. Particles that do not feel
 * each other fall on a wall through a bath, m = g = T = 1: the barometric law e^{-m g z/T} and
 * Maxwell's distribution say <z> = 1, <v^2> = 1, nobody below the wall. 20000 particles, 30 times:
 * .003. */
static void hold_rule_keeps_detailed_balance(void **state)
{
    (void)state;
    enum { COUNT = 20000 };
    fw_crowd crowd = crowd_rectangle(COUNT, 1, (fw_vec2){0, 0.5}, 10, 0, 1);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = COUNT;
    group.positions = crowd.at;
    group.strength = 0;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.controls = (fw_langevin_controls){0.02, 1, 1};
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    const fw_langevin *langevin = (const fw_langevin *)solid;
    solid->loaded = true;
    for (int i = 0; i < COUNT; ++i) solid->external_y[i] = -1;
    fw_box_walls box = box_for(solid, (fw_vec2){-1e9, 0}, (fw_vec2){1e9, 1e9});
    double height = 0, square = 0, lowest = 1;
    enum { SAMPLES = 30 };
    for (int sample = -SAMPLES; sample < SAMPLES; ++sample) {
        for (int step = 0; step < 50; ++step) step_in_box(solid, &box);
        for (int i = 0; i < COUNT; ++i) {
            lowest = fmin(lowest, solid->y[i]);
            if (sample < 0) continue;
            height += solid->y[i] / (COUNT * SAMPLES);
            square += langevin->velocity_y[i] * langevin->velocity_y[i] / (COUNT * SAMPLES);
        }
    }
    print_message("<z> = %.4f, <v^2> = %.4f, lowest %.2g\n", height, square, lowest);
    assert_close(height, 1, 0.01);
    assert_close(square, 1, 0.01);
    assert_true(lowest >= 0);
    free_box(&box);
    fw_solid_destroy(solid);
    free(crowd.at);
}

/* A liquid at T = 1 without bath. The walls' constraints let Verlet's energy
 * wander by some 1e-4 per particle at this time step (each adds an error of order dt^2 of either
 * sign); the constant force heats at 1e-2 per time. */
static void only_the_constant_force_heats(void **state)
{
    (void)state;
    const double durations[] = {300, 60}, dt = 0.0025;
    double rate[2];
    for (int variant = 0; variant < 2; ++variant) {
        fw_solid *solid = fluid(1, dt, (fw_return_variant)variant, 3);
        fw_box_walls box = box_for(solid, (fw_vec2){-2, -2}, (fw_vec2){18, 16});
        for (int step = 0; step < 4000; ++step) step_in_box(solid, &box);
        assert_int_equal(fw_particles_set_damping(solid, 0, NULL), FW_OK);
        const double energy = total_energy(solid);
        const int steps = (int)(durations[variant] / dt + 0.5);
        for (int step = 0; step < steps; ++step) step_in_box(solid, &box);
        rate[variant] = (total_energy(solid) - energy) / (durations[variant] * solid->count);
        free_box(&box);
        fw_solid_destroy(solid);
    }
    print_message("dE/dt/N: conservative %.2g, constant %.2g\n", rate[0], rate[1]);
    assert_close(rate[0], 0, 1e-6);
    assert_below(1e-3, rate[1]);
}

/* Contraction of a bar with free sides that is pulled: k2/(3 k2 + 4 k1) with k1 = n f0/r0 and
 * k2 = U'' - k1: near its rest length a bond is that of Eq 2. Surface forces of its axes make no
 * difference while it does not turn.
 */
static double contraction(double amplitude)
{
    enum { COLUMNS = 40, ROWS = 17 };
    fw_solid *solid = solid_of(crowd_rectangle(COLUMNS, ROWS, (fw_vec2){0, 0}, 1, 0, 1),
                               return_force_of(6, amplitude, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
                               (fw_langevin_controls){0.02, 0.3, 0}, 1);
    double length[2], height[2];
    const int middle = ROWS / 2 * COLUMNS + COLUMNS / 2;
    solid->loaded = true;
    for (int pulled = 0; pulled < 2; ++pulled) {
        for (int row = 0; row < ROWS; ++row) {
            solid->external_x[row * COLUMNS] = pulled ? -0.05 : 0;
            solid->external_x[row * COLUMNS + COLUMNS - 1] = pulled ? 0.05 : 0;
        }
        for (int step = 0; step < 6000; ++step) advance_free(solid);
        length[pulled] = solid->x[middle + 6] - solid->x[middle - 6];
        height[pulled] = solid->y[middle + 4 * COLUMNS] - solid->y[middle - 4 * COLUMNS];
    }
    fw_solid_destroy(solid);
    return -(height[1] / height[0] - 1) / (length[1] / length[0] - 1);
}

static void return_force_sets_poissons_ratio(void **state)
{
    (void)state;
    const double amplitudes[] = {0, 1, 2}, expected[] = {1. / 3, 0.2973, 0.2632};
    for (int a = 0; a < 3; ++a) assert_close(contraction(amplitudes[a]), expected[a], 0.001);
}

/* Fig 2, shortened: 256 particles dropped at random find the axes they are given. */
static void disorder_turns_into_order(void **state)
{
    (void)state;
    enum { COUNT = 256 };
    const int folds[] = {6, 4};
    for (int f = 0; f < 2; ++f) {
        const double side = sqrt(1.3 * COUNT * (folds[f] == 6 ? sqrt(3) / 2 : 1));
        fw_crowd crowd = {COUNT, malloc(COUNT * sizeof *crowd.at)};
        assert_int_equal(fw_placement_random(crowd.at, COUNT, (fw_vec2){0, 0},
                                             (fw_vec2){side, side}, 0.75, 1, NULL),
                         FW_OK);
        fw_solid *solid = solid_of(
            crowd, return_force_of(folds[f], f ? 2 : 1, FW_AXES_LAB, FW_RETURN_CONSERVATIVE),
            (fw_langevin_controls){0.001, 5, 0.05}, 1);
        assert_below(fw_particle_order_of(solid, 0).lab, 0.2);
        for (int step = 0; step < 5000; ++step) advance_free(solid);
        assert_int_equal(
            fw_particles_set_controls(solid, &(fw_langevin_controls){0.005, 1, 0.05}, NULL), FW_OK);
        for (int step = 0; step < 60000; ++step) advance_free(solid);
        const double lab = fw_particle_order_of(solid, 0).lab;
        print_message("fold %d: lab order %.3f\n", folds[f], lab);
        assert_below(0.95, lab);
        fw_solid_destroy(solid);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bath_sets_the_temperature),
        cmocka_unit_test(hold_rule_keeps_detailed_balance),
        cmocka_unit_test(only_the_constant_force_heats),
        cmocka_unit_test(return_force_sets_poissons_ratio),
        cmocka_unit_test(disorder_turns_into_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
