/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_driven.c - what is measured of grips and pistons: by what drives them, by what they
 * gain, and that each number is its own. */
#include "tests/support/laws.h"

#include "tests/support/measured.h"

static double of_grip(const char *name, int grip, const char *component)
{
    return value_at(name, (fw_subject){.body = -1, .wall = -1, .grip = grip, .particle = -1},
                    component);
}

static double of_piston(const char *name, int wall, const char *component)
{
    return value_at(name, (fw_subject){.body = -1, .wall = wall, .grip = -1, .particle = -1},
                    component);
}

/* --- each number is its own --- */

/* Of the second one: two components each, but for the last two names. */
static void assert_driven(double (*of)(const char *, int, const char *), const char *const names[6],
                          const double want[10])
{
    for (int n = 0; n < 4; ++n) {
        assert_close(of(names[n], 1, "x"), want[2 * n], 0);
        assert_close(of(names[n], 1, "y"), want[2 * n + 1], 0);
    }
    assert_close(of(names[4], 1, NULL), want[8], 0);
    assert_close(of(names[5], 1, NULL), want[9], 0);
}

static void each_number_of_a_grip_is_its_own(void **state)
{
    (void)state;
    begin(
        "title: two grips\nmaterials: {m: {lattice-boltzmann: {}}}\n"
        "bodies: {b: {material: m, shape: {rectangle: [5, 4]}}}\n"
        "grips:\n  one: {body: b, side: left, layer: 1}\n  two: {body: b, side: right, layer: 1}\n"
        "run: {steps: 1}\n");
    fw_grip_ledger *ledger =
        (fw_grip_ledger *)fw_grip_observe_ledger(fw_scene_observe_grip(experiment->scene, 1));
    *ledger = (fw_grip_ledger){.displacement = {1, 2},
                               .force = {3, 4},
                               .reaction = {5, 6},
                               .torque = 7,
                               .impulse = {8, 9},
                               .work = 10,
                               .path_length = {11, 12}};
    static const char *const names[] = {"grip-displacement", "grip-force",  "grip-impulse",
                                        "grip-path-length",  "grip-torque", "grip-work"};
    assert_driven(of_grip, names, (double[]){1, 2, 5, 6, 8, 9, 11, 12, 7, 10});
    ((fw_grip_ledger *)fw_grip_observe_ledger(fw_scene_observe_grip(experiment->scene, 0)))
        ->displacement = (fw_vec2){.25, .5};
    assert_close(value_of("slip", -1, "x"), .25 - 1, 0);
    assert_close(value_of("slip", -1, "y"), .5 - 2, 0);
    end();
}

static void each_number_of_a_piston_is_its_own(void **state)
{
    (void)state;
    begin("title: two pistons\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [5, 4]}}}\n"
          "walls:\n  one: {box: [20, 0, 21, 1], side: outside, piston: {mass: 2}}\n"
          "  two: {box: [30, 0, 31, 1], side: outside, piston: {mass: 3, velocity: [.5, 0]}}\n"
          "run: {steps: 1}\n");
    fw_piston_ledger *ledger =
        (fw_piston_ledger *)fw_piston_observe_ledger(fw_scene_observe_piston(experiment->scene, 1));
    *ledger = (fw_piston_ledger){.displacement = {1, 2},
                                 .velocity = {3, -4},
                                 .force = {5, 6},
                                 .reaction = {7, 8},
                                 .torque = 9,
                                 .impulse = {10, 11},
                                 .work = 12,
                                 .pushed = {100, 200},
                                 .pushed_by = 13,
                                 .unmatched = {1000, 2000},
                                 .unmatched_work = 14,
                                 .drag = {300, 400},
                                 .heat = 15,
                                 .path_length = {16, 17},
                                 .met = {18, 19},
                                 .met_work = 20};
    static const char *const names[] = {"piston-displacement", "piston-force",  "piston-impulse",
                                        "piston-path-length",  "piston-torque", "piston-work"};
    assert_driven(of_piston, names, (double[]){1, 2, 7, 8, 10, 11, 16, 17, 9, 12});
    assert_close(of_piston("piston-velocity", 1, "x"), 3, 0);
    assert_close(of_piston("piston-velocity", 1, "y"), -4, 0);
    assert_close(of_piston("piston-heat", 1, NULL), 15, 0);
    assert_close(of_piston("piston-kinetic-energy", 1, NULL), 3 * 25. / 2, 0);
    assert_close(of_piston("piston-meeting-impulse", 1, "x"), 18, 0);
    assert_close(of_piston("piston-meeting-impulse", 1, "y"), 19, 0);
    assert_close(of_piston("piston-unmatched", 1, NULL), 14, 0);
    end();
}

/* --- what drives them --- */

/* Both are driven by the same force and drift against it at first: momentum and work follow. */
static void a_force_gives_impulse_work_and_a_way_to_and_fro(void **state)
{
    (void)state;
    begin("title: pushed\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [3, 2]}, velocity: [-.02, .01]}}\n"
          "walls:\n"
          "  rest: {box: [20, 0, 21, 1], side: outside, piston: {mass: 2}}\n"
          "  p: {box: [30, 0, 31, 1], side: outside, piston: {mass: 4, velocity: [-.02, .01],\n"
          "    force: [.004, -.003]}}\n"
          "run: {steps: 40}\n");
    double way_x = 0, way_y = 0, x = 0, y = 0;
    for (int step = 1; step <= 40; ++step) {
        run_steps(1);
        way_x += fabs(of_piston("piston-displacement", 1, "x") - x);
        way_y += fabs(of_piston("piston-displacement", 1, "y") - y);
        x = of_piston("piston-displacement", 1, "x");
        y = of_piston("piston-displacement", 1, "y");
        assert_close(of_piston("piston-velocity", 1, "x"), -.02 + step * .001, 1e-15);
        assert_close(of_piston("piston-velocity", 1, "y"), .01 - step * .00075, 1e-15);
        assert_close(x, -.02 * step + .0005 * step * step, 1e-14);
        assert_close(y, .01 * step - .000375 * step * step, 1e-14);
    }
    assert_close(of_piston("piston-impulse", 1, "x"), .16, 1e-14);
    assert_close(of_piston("piston-impulse", 1, "y"), -.12, 1e-14);
    assert_close(of_piston("piston-force", 1, "x"), .004, 1e-16);
    assert_close(of_piston("piston-force", 1, "y"), -.003, 1e-16);
    assert_close(of_piston("piston-work", 1, NULL), .004 * x - .003 * y, 1e-14);
    assert_close(of_piston("piston-kinetic-energy", 1, NULL), 2 * (4e-4 + 4e-4), 1e-14);
    assert_close(of_piston("piston-path-length", 1, "x"), way_x, 1e-14);
    assert_close(of_piston("piston-path-length", 1, "y"), way_y, 1e-14);
    assert_true(way_x > fabs(x) + .1 && way_y > fabs(y) + .05);
    assert_close(of_piston("piston-energy-error", 1, NULL), 0, 1e-15);
    assert_close(of_piston("piston-momentum-error", 1, "x"), 0, 1e-15);
    assert_close(of_piston("piston-momentum-error", 1, "y"), 0, 1e-15);
    assert_close(of_piston("piston-displacement", 0, "x"), 0, 0);
    end();
}

/* What damping takes is what is lost of M v^2/2. */
static void damping_takes_what_a_piston_loses(void **state)
{
    (void)state;
    begin("title: damped\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [3, 2]}}}\n"
          "walls:\n  p: {box: [30, 0, 31, 1], side: outside, piston: {mass: 5, damping: .1,\n"
          "    velocity: [.03, -.04]}}\n"
          "run: {steps: 10}\n");
    run_steps(10);
    const double x = of_piston("piston-velocity", 0, "x"), y = of_piston("piston-velocity", 0, "y");
    assert_close(x / .03, y / -.04, 1e-14);
    assert_true(x > 0 && x < .02);
    assert_close(of_piston("piston-kinetic-energy", 0, NULL), 2.5 * (x * x + y * y), 1e-16);
    assert_close(of_piston("piston-heat", 0, NULL), 2.5 * (.0025 - x * x - y * y), 1e-15);
    assert_close(of_piston("piston-energy-error", 0, NULL), 0, 1e-15);
    assert_close(of_piston("piston-momentum-error", 0, "x"), 0, 1e-15);
    end();
}

/* The errors are what the books lack: none of theirs is left out, and each has its sign. */
static void errors_of_a_piston_are_what_its_books_lack(void **state)
{
    (void)state;
    begin("title: books\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [3, 2]}}}\n"
          "walls:\n  p: {box: [30, 0, 31, 1], side: outside, piston: {mass: 2,\n"
          "    velocity: [.5, .25]}}\n"
          "run: {steps: 1}\n");
    fw_piston_ledger *ledger =
        (fw_piston_ledger *)fw_piston_observe_ledger(fw_scene_observe_piston(experiment->scene, 0));
    ledger->velocity = (fw_vec2){1, 2};
    const double gained = 5 - (.25 + .0625);
    assert_close(of_piston("piston-energy-error", 0, NULL), gained, 1e-15);
    ledger->work = 1;
    assert_close(of_piston("piston-energy-error", 0, NULL), gained - 1, 1e-15);
    ledger->pushed_by = .125;
    const double by_bodies = of_piston("piston-energy-error", 0, NULL) - (gained - 1);
    assert_close(fabs(by_bodies), .125, 1e-15);
    ledger->heat = .5;
    assert_close(of_piston("piston-energy-error", 0, NULL), gained - 1 + by_bodies + .5, 1e-15);
    assert_close(of_piston("piston-momentum-error", 0, "x"), 2 * .5, 1e-15);
    assert_close(of_piston("piston-momentum-error", 0, "y"), 2 * 1.75, 1e-15);
    ledger->impulse = (fw_vec2){.5, .25};
    assert_close(of_piston("piston-momentum-error", 0, "x"), .5, 1e-15);
    assert_close(of_piston("piston-momentum-error", 0, "y"), 3.25, 1e-15);
    end();
}

/* A grip that holds all of a body drives its mass alone. */
static void a_grip_gives_its_body_what_it_gives_away(void **state)
{
    (void)state;
    begin("title: gripped\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies:\n"
          "  other: {material: m, shape: {rectangle: [2, 2]}, origin: [40, 0]}\n"
          "  b: {material: m, shape: {rectangle: [3, 2]}}\n"
          "grips:\n  still: {body: other, hold: both}\n"
          "  pull: {body: b, force: [.06, -.03]}\n"
          "run: {steps: 20}\n");
    run_steps(20);
    const double x = of_grip("grip-displacement", 1, "x"), y = of_grip("grip-displacement", 1, "y");
    assert_close(y, -x / 2, 1e-14);
    assert_close(of_grip("grip-impulse", 1, "x"), value_of("momentum", 1, "x"), 1e-13);
    assert_close(of_grip("grip-impulse", 1, "y"), value_of("momentum", 1, "y"), 1e-13);
    assert_close(of_grip("grip-impulse", 1, "x"), 20 * .06, 1e-13);
    assert_close(of_grip("grip-force", 1, "x"), .06, 1e-14);
    assert_close(of_grip("grip-force", 1, "y"), -.03, 1e-14);
    assert_close(of_grip("grip-work", 1, NULL), .06 * x - .03 * y, 1e-13);
    assert_close(of_grip("grip-work", 1, NULL), value_of("energy", 1, NULL), 1e-13);
    assert_close(of_grip("grip-path-length", 1, "x"), x, 1e-14);
    assert_close(of_grip("grip-path-length", 1, "y"), -y, 1e-14);
    assert_close(of_grip("grip-torque", 1, NULL), 0, 1e-14);
    assert_close(of_grip("grip-displacement", 0, "x"), 0, 0);
    assert_close(value_of("slip", -1, "x"), -x, 1e-15);
    assert_close(value_of("slip", -1, "y"), -y, 1e-15);
    end();
}

/* --- what meets them --- */

/* A ball of momentum p hits the face of a piston h above its middle: the torque, added up over the
 * steps, is -h p' of what it gives. */
static void the_torque_of_a_piston_is_that_of_the_push(void **state)
{
    (void)state;
    begin("title: off the middle\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies: {b: {material: m, shape: {sites: [[0, 0]]}, velocity: [.05, 0]}}\n"
          "walls:\n  p: {box: [.5, -1.25, 2, .75], side: outside, piston: {mass: 2}}\n"
          "run: {steps: 30}\n");
    const double before = value_of("momentum", 0, "x");
    double torque = 0, contacts = 0;
    for (int step = 0; step < 30; ++step) {
        run_steps(1);
        torque += of_piston("piston-torque", 0, NULL);
        contacts += of_piston("contacts", 0, NULL);
    }
    const double given = before - value_of("momentum", 0, "x");
    assert_true(given > .01 && contacts >= 1);
    assert_close(of_piston("contacts-so-far", 0, NULL), contacts, 0);
    assert_close(torque, -.25 * given, 1e-14);
    assert_close(2 * of_piston("piston-velocity", 0, "x"), given, 1e-14);
    assert_close(of_piston("wall-impulse", 0, "x"), -given, 1e-14);
    assert_close(of_piston("piston-impulse", 0, "x"), 0, 0);
    assert_close(of_piston("piston-energy-error", 0, NULL), 0, 1e-15);
    end();
}

/* The same of a piston that goes down meanwhile: its middle is where it was at the step's begin. */
static void the_torque_is_about_the_middle_where_it_is(void **state)
{
    (void)state;
    begin("title: sinking\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies: {b: {material: m, shape: {sites: [[0, 0]]}, velocity: [.05, 0]}}\n"
          "walls:\n  p: {box: [.5, -3.25, 2, 1.75], side: outside, piston: {mass: 2,\n"
          "    velocity: [0, -.03]}}\n"
          "run: {steps: 30}\n");
    double torque = 0, arm = 0, given = 0;
    for (int step = 0; step < 30; ++step) {
        const double before = of_piston("piston-velocity", 0, "x");
        const double middle = -.75 + of_piston("piston-displacement", 0, "y");
        run_steps(1);
        const double now = 2 * (of_piston("piston-velocity", 0, "x") - before);
        torque += of_piston("piston-torque", 0, NULL);
        arm += middle * now;
        given += now;
    }
    assert_true(given > .01 && fabs(arm + .75 * given) > .1 * given);
    assert_close(torque, arm, 1e-14);
    end();
}

/* Two pistons of 2 and 6 that meet head on swap what the textbook says. */
static void pistons_that_meet_give_each_other_their_impulse(void **state)
{
    (void)state;
    begin("title: meeting\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [3, 2]}, origin: [0, 50]}}\n"
          "walls:\n"
          "  light: {box: [0, 0, 1, 2], side: outside, piston: {mass: 2, velocity: [.05, .01],\n"
          "    meets: [heavy]}}\n"
          "  heavy: {box: [2, -1, 6, 3], side: outside, piston: {mass: 6}}\n"
          "run: {steps: 40}\n");
    run_steps(40);
    assert_close(of_piston("piston-velocity", 0, "x"), -.025, 1e-15);
    assert_close(of_piston("piston-velocity", 1, "x"), .025, 1e-15);
    assert_close(of_piston("piston-meeting-impulse", 0, "x"), -.15, 1e-14);
    assert_close(of_piston("piston-meeting-impulse", 1, "x"), .15, 1e-14);
    assert_close(of_piston("piston-meeting-impulse", 0, "y"), 0, 1e-16);
    assert_close(of_piston("piston-velocity", 0, "y"), .01, 1e-16);
    assert_close(of_piston("piston-momentum-error", 0, "x"), 0, 1e-15);
    assert_close(of_piston("piston-energy-error", 1, NULL), 0, 1e-15);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_of_a_grip_is_its_own),
        cmocka_unit_test(each_number_of_a_piston_is_its_own),
        cmocka_unit_test(a_force_gives_impulse_work_and_a_way_to_and_fro),
        cmocka_unit_test(damping_takes_what_a_piston_loses),
        cmocka_unit_test(errors_of_a_piston_are_what_its_books_lack),
        cmocka_unit_test(a_grip_gives_its_body_what_it_gives_away),
        cmocka_unit_test(the_torque_of_a_piston_is_that_of_the_push),
        cmocka_unit_test(the_torque_is_about_the_middle_where_it_is),
        cmocka_unit_test(pistons_that_meet_give_each_other_their_impulse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
