/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_return_force.c - forces of pairs and of turning axes. */
#include "tests/support/laws.h"

#include "tests/support/crowd.h"
#include "tests/support/steps.h"

#include <string.h>

static const fw_langevin_controls still = {.time_step = 0.005};

/* -dE/dx of one coordinate by a fourth-order difference: at h = 1e-4 rounding leaves about 1e-10
 * for energies of some 100, the next term of the series less. */
static double minus_slope(fw_solid *solid, double *coordinate)
{
    const double h = 1e-4, at = *coordinate;
    double energy[5];
    for (int k = -2; k <= 2; ++k) {
        *coordinate = at + k * h;
        restore(solid);
        energy[k + 2] = fw_solid_energies(solid).elastic;
    }
    *coordinate = at;
    restore(solid);
    return -(energy[0] - 8 * energy[1] + 8 * energy[3] - energy[4]) / (12 * h);
}

static void assert_forces_are_gradients(fw_solid *solid)
{
    const fw_langevin *langevin = (const fw_langevin *)solid;
    for (int i = 0; i < solid->count; ++i) {
        assert_close(langevin->force_x[i], minus_slope(solid, &solid->x[i]), 1e-7);
        assert_close(langevin->force_y[i], minus_slope(solid, &solid->y[i]), 1e-7);
    }
}

static void potential_forces_are_gradients(void **state)
{
    (void)state;
    fw_solid *solid = solid_of(crowd_disc(3, (fw_vec2){2, -1}, 0.2, 0.12, 5),
                               fw_return_force_default(), still, 1);
    assert_forces_are_gradients(solid);
    fw_solid_destroy(solid);
}

static void morse_forces_are_gradients(void **state)
{
    (void)state;
    fw_crowd crowd = crowd_disc(3, (fw_vec2){0, 0}, 0, 0.15, 6);
    fw_particle_group_def group = fw_particle_group_def_default();
    group.count = crowd.count;
    group.positions = crowd.at;
    fw_particles_def def = fw_particles_def_default();
    def.groups = &group;
    def.group_count = 1;
    def.potential.kind = FW_MORSE;
    def.potential.depth = 1.3;
    def.potential.steepness = 5;
    def.potential.distance = 1.05;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    assert_forces_are_gradients(solid);
    fw_solid_destroy(solid);
    free(crowd.at);
}

static void conservative_return_forces_are_gradients(void **state)
{
    (void)state;
    const int folds[] = {2, 4, 6, 8};
    for (int f = 0; f < 4; ++f) {
        fw_return_force force = return_force_of(folds[f], 1.7, FW_AXES_LAB, FW_RETURN_CONSERVATIVE);
        force.angle = 0.4;
        fw_solid *solid = solid_of(crowd_disc(2, (fw_vec2){2, -1}, 0.2, 0.15, 7), force, still, 1);
        assert_forces_are_gradients(solid);
        fw_solid_destroy(solid);
    }
}

/* Through theta, too, which depends on every bond of the body. */
static void corotating_forces_are_gradients(void **state)
{
    (void)state;
    for (int fold = 4; fold <= 6; fold += 2) {
        fw_solid *solid = solid_of(
            crowd_disc(3, (fw_vec2){2, -1}, 0.3, 0.15, 8),
            return_force_of(fold, 1.7, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE), still, 1);
        assert_forces_are_gradients(solid);
        fw_solid_destroy(solid);
    }
}

/* Two bodies whose particles feel each other, with axes of their own. */
static void forces_across_bodies_are_gradients(void **state)
{
    (void)state;
    fw_crowd left = crowd_rectangle(3, 4, (fw_vec2){0, 0}, 1, 0.1, 9);
    fw_crowd right = crowd_rectangle(3, 4, (fw_vec2){3.9, 0.3}, 1, 0.1, 10);
    fw_particle_group_def groups[2] = {fw_particle_group_def_default(),
                                       fw_particle_group_def_default()};
    groups[0].name = "left";
    groups[0].count = left.count;
    groups[0].positions = left.at;
    groups[0].strength = 1.5;
    groups[0].return_force = return_force_of(6, 1.2, FW_AXES_COROTATING, FW_RETURN_CONSERVATIVE);
    groups[1].name = "right";
    groups[1].count = right.count;
    groups[1].positions = right.at;
    groups[1].return_force = return_force_of(4, 0.8, FW_AXES_LAB, FW_RETURN_CONSERVATIVE);
    fw_particles_def def = fw_particles_def_default();
    def.groups = groups;
    def.group_count = 2;
    def.strength_across = 0.7;
    fw_solid *solid;
    assert_int_equal(fw_particles_create(&solid, &def, NULL), FW_OK);
    assert_forces_are_gradients(solid);
    fw_solid_destroy(solid);
    free(left.at);
    free(right.at);
}

/* Two particles at any place: what one feels is exactly what the other feels, with the other sign.
 */
static void pairs_pull_equally(void **state)
{
    (void)state;
    const fw_return_variant variants[] = {FW_RETURN_CONSERVATIVE, FW_RETURN_CONSTANT};
    int felt = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const fw_vec2 a = fw_noise_uniform(3, (uint32_t)trial, 0, 0);
        const fw_vec2 b = fw_noise_uniform(3, (uint32_t)trial, 1, 0);
        const double dx = a.x - b.x, dy = a.y - b.y, r2 = dx * dx + dy * dy;
        if (r2 < 0.4) continue;
        const fw_pair_potential potential = fw_pair_potential_default();
        const fw_pair there = fw_pair_at(&potential, r2);
        for (int fold = 2; fold <= 8; fold += 2)
            for (int v = 0; v < 2; ++v) {
                const fw_return_force force =
                    return_force_of(fold, 1, FW_AXES_COROTATING, variants[v]);
                const fw_phase axes = {cos(0.3), sin(0.3)};
                const fw_return_pair one = fw_return_pair_at(&force, axes, dx, dy, r2);
                const fw_return_pair other = fw_return_pair_at(&force, axes, -dx, -dy, r2);
                assert_true(one.first.x == -other.first.x && one.first.y == -other.first.y);
                assert_true(one.second.x == -other.second.x && one.second.y == -other.second.y);
                assert_true(there.push * dx == -(there.push * -dx));
                felt += one.first.x != 0;
            }
    }
    assert_true(felt > 1000);
}

/* Fig 1: a bond a little off an axis is turned back, from either side, for any axis. (As printed,
 * Eq 18 would turn it away.) */
static void bonds_return_to_their_axes(void **state)
{
    (void)state;
    for (int fold = 4; fold <= 6; fold += 2)
        for (int k = 0; k < fold; ++k)
            for (int side = -1; side <= 1; side += 2) {
                const double off = side * FW_PI / 30, phi = 2 * FW_PI * k / fold + off;
                const fw_return_force force =
                    return_force_of(fold, 2, FW_AXES_LAB, FW_RETURN_CONSTANT);
                const fw_vec2 pull = fw_return_lab(&force, (fw_phase){1, 0}, cos(phi), sin(phi), 1);
                const double tangential = -sin(phi) * pull.x + cos(phi) * pull.y;
                assert_close(tangential, -2 * sin(fold * off), 1e-13);
                assert_close(cos(phi) * pull.x + sin(phi) * pull.y, 0, 1e-13);
            }
}

/* Torque of a body in any state about any point: nothing for both ways to compensate it, with both
 * variants; and the fixed axes do exert one. */
static void free_bodies_feel_no_torque(void **state)
{
    (void)state;
    const fw_return_axes axes[] = {FW_AXES_LAB, FW_AXES_COROTATING, FW_AXES_SURFACE};
    for (int a = 0; a < 3; ++a)
        for (int variant = 0; variant < 2; ++variant) {
            fw_return_force force = return_force_of(6, 1, axes[a], (fw_return_variant)variant);
            force.angle = 0.1;
            fw_solid *solid =
                solid_of(crowd_disc(5, (fw_vec2){3, 8}, 0.5, 0.15, 11), force, still, 1);
            const fw_langevin *langevin = (const fw_langevin *)solid;
            double torque = 0;
            fw_vec2 net = {0, 0};
            for (int i = 0; i < solid->count; ++i) {
                torque += solid->x[i] * langevin->force_y[i] - solid->y[i] * langevin->force_x[i];
                net = fw_vec2_add(net, (fw_vec2){langevin->force_x[i], langevin->force_y[i]});
            }
            /* Forces are some 10, arms some 10, bonds some 300: rounding is a few 1e-13. */
            if (axes[a] == FW_AXES_LAB)
                assert_true(fabs(torque) > 1);
            else
                assert_close(torque, 0, 1e-11);
            assert_close(net.x, 0, 1e-12);
            assert_close(net.y, 0, 1e-12);
            fw_solid_destroy(solid);
        }
}

static void impossible_forces_are_refused(void **state)
{
    (void)state;
    fw_error error;
    fw_return_force force = fw_return_force_default();
    force.fold = 5;
    assert_int_equal(fw_return_force_check(&force, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "odd fold 5"));
    force = fw_return_force_default();
    force.cut = fw_smooth_cut_over(1.2, 1.4143);
    assert_int_equal(fw_return_force_check(&force, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "1.4143"));
    force = fw_return_force_default();
    force.amplitude = -1;
    assert_int_equal(fw_return_force_check(&force, &error), FW_BAD_INPUT);
    fw_pair_potential potential = fw_pair_potential_default();
    potential.distance = 1.6;
    assert_int_equal(fw_pair_potential_check(&potential, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "1.6, outside its cut from 1.4 to 1.7"));
    potential = fw_pair_potential_default();
    potential.depth = NAN;
    assert_int_equal(fw_pair_potential_check(&potential, &error), FW_BAD_INPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(potential_forces_are_gradients),
        cmocka_unit_test(morse_forces_are_gradients),
        cmocka_unit_test(conservative_return_forces_are_gradients),
        cmocka_unit_test(corotating_forces_are_gradients),
        cmocka_unit_test(forces_across_bodies_are_gradients),
        cmocka_unit_test(pairs_pull_equally),
        cmocka_unit_test(bonds_return_to_their_axes),
        cmocka_unit_test(free_bodies_feel_no_torque),
        cmocka_unit_test(impossible_forces_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
