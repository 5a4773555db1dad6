/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_rubbing.c - which force and which slip are those of the interface, and which steps
 * of them are summed: from ledgers that are written by hand. */
#include "tests/support/laws.h"

#include "core/particles/langevin.h"
#include "experiments/measures/rubbing.h"
#include "tests/support/measured.h"

/* Phases end after 3, 5 and 9 steps; the profile's is the last one, and along the interface is x.
 */
static const char sheets[] =
    "title: two sheets\n"
    "materials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
    "bodies:\n"
    "  lower: {material: m, shape: {rectangle: [4, 3]}}\n"
    "  upper: {material: m, shape: {rectangle: [3, 3]}, origin: [.5, 3.5]}\n"
    "grips:\n"
    "  driven: {body: upper, side: top, layer: .5}\n"
    "  held: {body: lower, side: bottom, layer: .5, hold: both}\n"
    "phases: {rest: {until: 3}, settle: {until: 5}, sample: {until: 9}}\n"
    "run: {steps: 9}\n"
    "profile: {axis: y, phase: sample, every: 2, middle: 2.75, contact: 1, far: [1.5, 3]}\n";

static fw_grip_ledger *grip(int g)
{
    return (fw_grip_ledger *)fw_grip_observe_ledger(fw_scene_observe_grip(experiment->scene, g));
}

static fw_body_ledger *body(int b)
{
    return (fw_body_ledger *)fw_scene_body_ledger(experiment->scene, b, 0);
}

static void expect_vector(fw_vec2 v, double x, double y, double within)
{
    assert_close(v.x, x, within);
    assert_close(v.y, y, within);
}

/* Of the first grip less the second; the force is the reaction of the first body. */
static void slip_and_force_are_those_of_the_first(void **state)
{
    (void)state;
    begin(sheets);
    grip(0)->displacement = (fw_vec2){.5, .25};
    grip(1)->displacement = (fw_vec2){.125, -.75};
    *body(0) = (fw_body_ledger){.force = {7, 8}, .reaction = {3, -4}, .impulse = {9, 10}};
    *body(1) = (fw_body_ledger){.force = {11, 12}, .reaction = {5, 6}, .impulse = {13, 14}};
    expect_vector(fw_rubbing_slip(experiment), .375, 1, 0);
    expect_vector(fw_rubbing_force(experiment), 3, -4, 0);
    end();
}

/* Of movable particles it is what the second body does to the first: its potential's slope. */
static double energy_with(fw_solid *solid, double x, double y)
{
    const fw_energies now = fw_scene_energies(experiment->scene);
    for (int i = 0; i < 2; ++i) solid->x[i] += x, solid->y[i] += y;
    assert_fine(fw_langevin_refresh(solid, &error));
    const fw_energies there = fw_scene_energies(experiment->scene);
    for (int i = 0; i < 2; ++i) solid->x[i] -= x, solid->y[i] -= y;
    assert_fine(fw_langevin_refresh(solid, &error));
    return there.elastic - now.elastic;
}

static void particles_rub_with_the_slope_of_their_potential(void **state)
{
    (void)state;
    begin("title: five particles\n"
          "materials: {m: {movable-particles: {mass: 3}}}\n"
          "bodies:\n"
          "  a: {material: m, shape: {points: [[0, 0], [1.1, .1]]}}\n"
          "  b: {material: m, shape: {points: [[.3, .95], [1.5, 1.2], [2.1, .2]]}}\n"
          "run: {steps: 1}\n");
    fw_solid *solid = solid_of_body(0);
    const double h = 1e-5;
    const double x = -(energy_with(solid, h, 0) - energy_with(solid, -h, 0)) / (2 * h);
    const double y = -(energy_with(solid, 0, h) - energy_with(solid, 0, -h)) / (2 * h);
    assert_true(fabs(x) > .1 && fabs(y) > .1 && fabs(x - y) > .1);
    expect_vector(fw_rubbing_force(experiment), x, y, 1e-6);
    const fw_vec2 slip = fw_rubbing_slip(experiment);
    assert_true(isnan(slip.x) && isnan(slip.y));
    end();
}

/* Three bodies have no interface, nor has one. */
static void who_rubs_whom_must_be_plain(void **state)
{
    (void)state;
    static const char *const more[] = {
        "", "  b: {material: m, shape: {rectangle: [2, 2]}, origin: [9, 0]}\n"
            "  c: {material: m, shape: {rectangle: [2, 2]}, origin: [19, 0]}\n"};
    static const char *const models[] = {"lattice-boltzmann", "movable-particles"};
    for (int n = 0; n < 3; ++n) {
        char text[512];
        snprintf(text, sizeof text,
                 "title: t\nmaterials: {m: {%s: {}}}\nbodies:\n"
                 "  a: {material: m, shape: {rectangle: [2, 2]}}\n%srun: {steps: 1}\n",
                 models[n == 2], more[n == 1]);
        begin(text);
        const fw_vec2 force = fw_rubbing_force(experiment);
        assert_true(isnan(force.x) && isnan(force.y));
        end();
    }
}

/* --- sums --- */

/* In each step: slip along and across, force along and across. */
static const double steps[][4] = {{5, 90, 3, 70},       {7, 80, -8, 60},   {-2, 70, 9, 50},
                                  {1, 60, -7, 40},      {1.5, 50, 6, -30}, {.5, 40, 2, -20},
                                  {.75, 30, -1, 10},    {-.5, 20, -3, 8},  {-1.75, 10, 4, -6},
                                  {-1.25, 9, -.5, 4.5}, {8, 7, 100, 200}};

/* Path lengths are summed from the end of the first phase on, first those of the phase before the
 * samples; everything else from its end on, that step included, to that of the last one. What is
 * done is by trapezoids. */
static void sums_take_their_own_steps(void **state)
{
    (void)state;
    begin(sheets);
    fw_rubbing r = fw_rubbing_begin(scenario);
    assert_int_equal(r.before, 3);
    assert_int_equal(r.from, 5);
    assert_int_equal(r.until, 9);
    for (int step = 0; step <= 10; ++step) {
        const double *now = steps[step];
        grip(0)->displacement = (fw_vec2){now[0] + 11, now[1] - 13};
        grip(1)->displacement = (fw_vec2){11, -13};
        body(0)->reaction = (fw_vec2){now[2], now[3]};
        fw_rubbing_follow(&r, experiment, step);
    }
    double path = 0, work = 0, slip = 0, force = 0, pressing = 0;
    for (int step = 5; step <= 9; ++step) {
        const double way = steps[step][0] - steps[step - 1][0];
        slip += steps[step][0];
        force += fabs(steps[step][2]);
        pressing += fabs(steps[step][3]);
        if (step == 5) continue;
        path += fabs(way);
        work -= (steps[step][2] + steps[step - 1][2]) / 2 * way;
    }
    assert_close(r.sums.path_before, .5 + 1, 0);
    assert_close(r.sums.path, path, 1e-14);
    assert_close(r.sums.work, work, 1e-14);
    assert_close(r.sums.steps, 5, 0);
    assert_close(r.sums.slip, slip, 1e-14);
    assert_close(r.sums.force, force, 1e-14);
    assert_close(r.sums.pressing, pressing, 1e-14);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slip_and_force_are_those_of_the_first),
        cmocka_unit_test(particles_rub_with_the_slope_of_their_potential),
        cmocka_unit_test(who_rubs_whom_must_be_plain),
        cmocka_unit_test(sums_take_their_own_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
