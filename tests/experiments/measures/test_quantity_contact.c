/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_quantity_contact.c - what is measured of walls and of bodies that touch, and of the books of
 * the scene: by what those who touch gain and lose, and that each number is its own. */
#include "tests/support/laws.h"

#include "tests/support/measured.h"

static double of_wall(const char *name, int wall, const char *component)
{
    return value_at(name, (fw_subject){.body = -1, .wall = wall, .grip = -1, .particle = -1},
                    component);
}

/* --- each number is its own --- */

static void each_number_of_contact_is_its_own(void **state)
{
    (void)state;
    begin("title: two\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies:\n  a: {material: m, shape: {rectangle: [3, 2]}}\n"
          "  b: {material: m, shape: {rectangle: [3, 2]}, origin: [50, 0]}\n"
          "run: {steps: 1}\n");
    *(fw_contact_ledger *)fw_scene_contact_ledger(experiment->scene) =
        (fw_contact_ledger){.ticks = 1,
                            .iterations = 2,
                            .unconverged = 3,
                            .heat = 4,
                            .overstep = 5,
                            .residual = 6,
                            .creep = 7};
    static const char *const names[] = {"contact-steps",    "contact-unconverged", "contact-heat",
                                        "contact-overstep", "contact-residual",    "contact-creep"};
    static const double values[] = {1, 3, 4, 5, 6, 7};
    for (int n = 0; n < 6; ++n) assert_close(value_of(names[n], -1, NULL), values[n], 0);
    *(fw_body_ledger *)fw_scene_body_ledger(experiment->scene, 1, 0) =
        (fw_body_ledger){.force = {1, 2}, .reaction = {3, 4}, .impulse = {5, 6}, .contacts = 7};
    assert_close(value_of("body-force", 1, "x"), 3, 0);
    assert_close(value_of("body-force", 1, "y"), 4, 0);
    assert_close(value_of("body-impulse", 1, "x"), 5, 0);
    assert_close(value_of("body-impulse", 1, "y"), 6, 0);
    assert_close(value_of("body-contacts", 1, NULL), 7, 0);
    end();
}

static void each_number_of_a_wall_is_its_own(void **state)
{
    (void)state;
    begin("title: walls\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies: {b: {material: m, shape: {rectangle: [3, 2]}, origin: [0, 5]}}\n"
          "walls:\n  one: {chain: [[-9, 0], [9, 0]]}\n  two: {chain: [[-9, -5], [9, -9]]}\n"
          "run: {steps: 1}\n");
    *(fw_wall_ledger *)fw_scene_wall_ledger(experiment->scene, 1) =
        (fw_wall_ledger){.force = {1, 2},
                         .reaction = {3, 4},
                         .impulse = {5, 6},
                         .work = 7,
                         .dissipated = 8,
                         .stored = 9,
                         .contacts = 10,
                         .held = 11};
    assert_close(of_wall("reaction", 1, "x"), 3, 0);
    assert_close(of_wall("reaction", 1, "y"), 4, 0);
    assert_close(of_wall("wall-impulse", 1, "x"), 5, 0);
    assert_close(of_wall("wall-impulse", 1, "y"), 6, 0);
    assert_close(of_wall("contacts", 1, NULL), 10, 0);
    assert_close(of_wall("contacts-so-far", 1, NULL), 11, 0);
    /* Along (18, -4) over across it, of (5, 6). */
    assert_close(of_wall("friction-ratio", 1, NULL), (5. * 18 - 6 * 4) / (5 * 4 + 6 * 18), 1e-15);
    assert_close(value_of("wall-work", -1, NULL), 7, 0);
    assert_close(value_of("friction-heat", -1, NULL), 8, 0);
    assert_close(value_of("wall-energy", -1, NULL), 9, 0);
    end();
}

/* Of the second of two bodies; the scene has both. */
static void each_number_of_the_books_is_its_own(void **state)
{
    (void)state;
    begin("title: books\nmaterials: {m: {lattice-boltzmann: {}}}\n"
          "bodies:\n  a: {material: m, shape: {rectangle: [3, 2]}}\n"
          "  b: {material: m, shape: {rectangle: [3, 2]}, origin: [50, 0]}\n"
          "run: {steps: 1}\n");
    solid_of_body(0)->ledger = (fw_solid_ledger){.work = 100, .dissipated = 200, .heat = 300};
    solid_of_body(1)->ledger = (fw_solid_ledger){
        .work = 1, .dissipated = 2, .heat = 3, .fracture = 4, .impulse = {5, 6}, .drag = {70, 80}};
    assert_close(value_of("external-work", -1, NULL), 101, 0);
    assert_close(value_of("dissipated", -1, NULL), 202, 0);
    assert_close(value_of("thermostat-heat", -1, NULL), 303, 0);
    assert_close(value_of("fracture-energy", 1, NULL), 4, 0);
    assert_close(value_of("momentum-error", 1, "x"), -75, 0);
    assert_close(value_of("momentum-error", 1, "y"), -86, 0);
    assert_close(value_of("momentum-error", 0, "x"), 0, 0);
    assert_close(value_of("momentum-error", -1, "x"), -75, 0);
    end();
}

/* --- walls --- */

/* The floor turns the momentum of a ball that falls on it, the ceiling nothing. */
static void a_wall_gives_what_a_ball_gains(void **state)
{
    (void)state;
    begin("title: a ball\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies: {b: {material: m, shape: {sites: [[0, 0]]}, origin: [0, 1.03],\n"
          "  velocity: [.03, -.07]}}\n"
          "walls:\n  ceiling: {chain: [[9, 7], [-9, 7]]}\n  floor: {chain: [[-9, 0], [9, 0]]}\n"
          "run: {steps: 40}\n");
    const double x = value_of("momentum", 0, "x"), y = value_of("momentum", 0, "y");
    double sum = 0, contacts = 0;
    for (int step = 0; step < 40; ++step) {
        run_steps(1);
        sum += of_wall("reaction", 1, "y");
        contacts += of_wall("contacts", 1, NULL);
        assert_close(of_wall("contacts-so-far", 1, NULL), contacts, 0);
    }
    assert_close(value_of("momentum", 0, "y"), -y, 1e-15);
    assert_close(value_of("momentum", 0, "x"), x, 1e-16);
    assert_close(of_wall("wall-impulse", 1, "y"), -2 * y, 1e-15);
    assert_close(of_wall("wall-impulse", 1, "x"), 0, 1e-16);
    assert_close(sum, -2 * y, 1e-15);
    assert_close(of_wall("wall-impulse", 0, "y"), 0, 0);
    assert_close(of_wall("contacts-so-far", 0, NULL), 0, 0);
    assert_true(contacts >= 1);
    assert_close(value_of("wall-work", -1, NULL), 0, 1e-17);
    end();
}

/* m a s, and no more than the ball gains. */
static void a_weight_works_along_its_way(void **state)
{
    (void)state;
    begin("title: falling\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies:\n  other: {material: m, shape: {rectangle: [3, 2]}, origin: [90, 0]}\n"
          "  b: {material: m, shape: {rectangle: [3, 2]}, velocity: [.01, .02]}\n"
          "forces: {weight: {body: b, acceleration: [.002, -.003]}}\n"
          "run: {steps: 30}\n");
    const double energy = value_of("energy", 1, NULL);
    const double x = value_of("centre-of-mass", 1, "x"), y = value_of("centre-of-mass", 1, "y");
    const double mass = value_of("momentum", 1, "x") / .01;
    run_steps(30);
    const double way_x = value_of("centre-of-mass", 1, "x") - x;
    const double way_y = value_of("centre-of-mass", 1, "y") - y;
    assert_close(value_of("external-work", -1, NULL), mass * (.002 * way_x - .003 * way_y), 1e-13);
    assert_close(value_of("external-work", -1, NULL), value_of("energy", 1, NULL) - energy, 1e-13);
    assert_close(value_of("momentum", 1, "x"), mass * (.01 + 30 * .002), 1e-13);
    assert_close(value_of("mean-velocity", 1, "x"), .07, 1e-14);
    assert_close(value_of("mean-velocity", 1, "y"), -.07, 1e-14);
    assert_close(value_of("kinetic-fraction", 1, NULL), 1, 1e-12);
    assert_close(value_of("momentum-ratio", 1, NULL), sqrt(2 * .07 * .07 / 5e-4), 1e-12);
    end();
}

/* --- bodies --- */

/* The second of three chains is struck by the first; the third is out of the way. */
static void bodies_give_each_other_what_they_gain(void **state)
{
    (void)state;
    begin("title: chains\nmaterials: {m: {lattice-boltzmann: {rest-mass: 0}}}\n"
          "bodies:\n"
          "  a: {material: m, shape: {rectangle: [6, 1]}, velocity: [.1, 0]}\n"
          "  b: {material: m, shape: {rectangle: [9, 1]}, origin: [6.23, 0]}\n"
          "  c: {material: m, shape: {rectangle: [6, 1]}, origin: [0, 9]}\n"
          "run: {steps: 60}\n");
    const double before = value_of("momentum", 0, "x");
    double sum = 0, steps = 0;
    for (int step = 0; step < 60; ++step) {
        run_steps(1);
        sum += value_of("body-force", 1, "x");
        steps += value_of("body-contacts", 1, NULL) > 0;
        assert_close(value_of("body-force", 0, "x"), -value_of("body-force", 1, "x"), 1e-16);
        assert_close(value_of("contact-steps", -1, NULL), steps, 0);
    }
    const double gained = value_of("momentum", 1, "x");
    assert_true(gained > .1 && steps > 0);
    assert_close(value_of("body-impulse", 1, "x"), gained, 1e-14);
    assert_close(value_of("body-impulse", 0, "x"), value_of("momentum", 0, "x") - before, 1e-14);
    assert_close(sum, gained, 1e-14);
    assert_close(value_of("body-impulse", 2, "x"), 0, 0);
    assert_close(value_of("body-contacts", 2, NULL), 0, 0);
    assert_close(value_of("body-penetration", -1, NULL), 0, 0);
    assert_close(value_of("contact-heat", -1, NULL), 0, 0);
    assert_close(value_of("contact-unconverged", -1, NULL), 0, 0);
    end();
}

/* A sheet that is pressed on another one and slides: what is lost of energy is heat. */
static void heat_of_friction_is_what_sliding_takes(void **state)
{
    (void)state;
    begin("title: sliding\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies:\n"
          "  a: {material: m, shape: {rectangle: [20, 3]}}\n"
          "  b: {material: m, shape: {rectangle: [5, 2]}, origin: [4.3, 2.05],\n"
          "    velocity: [.02, -.01]}\n"
          "contact: {friction: .3}\nrun: {steps: 60}\n");
    const double before = value_of("energy", -1, NULL);
    run_steps(60);
    const double lost = before - value_of("energy", -1, NULL);
    assert_true(lost > 1e-6);
    assert_close(value_of("contact-heat", -1, NULL), lost, 1e-14);
    assert_close(value_of("friction-heat", -1, NULL), lost, 1e-14);
    assert_close(value_of("body-impulse", 0, "x"), value_of("momentum", 0, "x"), 1e-14);
    assert_close(value_of("body-impulse", 0, "y"), -value_of("body-impulse", 1, "y"), 1e-14);
    assert_true(value_of("body-impulse", 0, "x") > 0 && value_of("body-impulse", 0, "y") < 0);
    end();
}

/* A point that was put into another body lies as deep as the nearest edge is far. */
static void depth_in_a_body_is_that_of_the_nearest_edge(void **state)
{
    (void)state;
    begin("title: inside\nmaterials: {m: {lattice-boltzmann: {rest-mass: 1}}}\n"
          "bodies:\n"
          "  a: {material: m, shape: {rectangle: [8, 6]}}\n"
          "  b: {material: m, shape: {sites: [[0, 0]]}, origin: [3.5, 5.25], velocity: [0, 0]}\n"
          "run: {steps: 1}\n");
    assert_close(value_of("body-penetration", -1, NULL), 0, 0);
    fw_solid *solid = solid_of_body(1);
    solid->x[0] = 3.25;
    solid->y[0] = 4.625;
    assert_close(value_of("body-penetration", -1, NULL), .375, 1e-14);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_of_contact_is_its_own),
        cmocka_unit_test(each_number_of_a_wall_is_its_own),
        cmocka_unit_test(each_number_of_the_books_is_its_own),
        cmocka_unit_test(a_wall_gives_what_a_ball_gains),
        cmocka_unit_test(a_weight_works_along_its_way),
        cmocka_unit_test(bodies_give_each_other_what_they_gain),
        cmocka_unit_test(heat_of_friction_is_what_sliding_takes),
        cmocka_unit_test(depth_in_a_body_is_that_of_the_nearest_edge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
