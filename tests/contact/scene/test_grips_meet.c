/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_grips_meet.c - what a grip holds is to what it meets as a moving wall, or as a piston of its
 * mass, and its ledger has the force of the contact. Where neither of two can give way, the run
 * stops before anything passes. */
#include "tests/support/grips.h"
#include "tests/support/pistons.h"

static fw_drive carried(double x, double y)
{
    return (fw_drive){.prescribed_x = true,
                      .prescribed_y = true,
                      .path = {.velocity = {x, y}, .until = INFINITY}};
}

static fw_drive pressed(double x, double y)
{
    return (fw_drive){.force = {x, y}};
}

/* The bodies of two scenes by that number are in one place, but for what rounding left. */
static void assert_in_one_place(const fw_scene *a, const fw_scene *b, int body_a, int body_b,
                                double tolerance)
{
    const fw_solid *one = fw_scene_observe_body(a, body_a),
                   *other = fw_scene_observe_body(b, body_b);
    assert_int_equal(one->count, other->count);
    for (int i = 0; i < one->count; ++i) {
        assert_close(one->x[i], other->x[i], tolerance);
        assert_close(one->y[i], other->y[i], tolerance);
    }
}

/* A column: its lowest particle alone meets the block, at any gap as it would meet a wall. (Faces
 * that are held at a gap keep the area between them, which also depends on how long they are.) */
static const body_options column = {
    .columns = 1, .rows = 6, .origin = {3.3, .21}, .velocity = {.01, 0}, .mu = .98};
/* A face that comes to the block without a gap, 64 steps of 1/256. */
static const body_options face = {.columns = 6, .rows = 4, .origin = {3.3, .25}, .mu = .98};

/* A block that a grip carries into the body above; or a wall on the same path. */
static fw_scene *driven_from_below(const body_options *body, bool grip, double speed)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, *body);
    if (grip) {
        add_body(scene, (body_options){.columns = 16, .rows = 3, .origin = {0, -2}});
        grip_rows(scene, 1, "hand", 16, 0, 3, carried(0, speed));
    } else {
        const fw_vec2 line[] = {{-50, 0}, {50, 0}};
        fw_wall_def def = fw_wall_def_default();
        def.name = "table";
        def.shape = FW_CHAIN;
        def.points = line;
        def.path = (fw_path){.velocity = {0, speed}, .until = INFINITY};
        must(fw_scene_add_wall(scene, &def, &error));
    }
    begin(scene);
    return scene;
}

static void compare_with_wall(const body_options *body, double speed, int steps)
{
    fw_scene *block = driven_from_below(body, true, speed),
             *wall = driven_from_below(body, false, speed);
    run(block, steps);
    run(wall, steps);
    assert_in_one_place(block, wall, 0, 0, 1e-10);
    const double work = fw_scene_wall_ledger(wall, 0)->work;
    assert_true(work > .01 * speed * speed);
    /* The grip also sets its own block in motion. */
    const fw_solid *own = fw_scene_observe_body(block, 1);
    const double mass = own->model->mass(own).yy;
    assert_close(grip_ledger(block, 0)->work, work + mass * speed * speed / 2, 1e-11);
    assert_close(grip_ledger(block, 0)->impulse.y,
                 fw_scene_wall_ledger(wall, 0)->impulse.y + mass * speed, 1e-10);
    assert_ledger_closes(block, 1e-12);
    fw_scene_destroy(block);
    fw_scene_destroy(wall);
}

static void a_carried_block_is_a_moving_wall(void **state)
{
    (void)state;
    for (double speed = .003; speed < .1; speed *= 5) compare_with_wall(&column, speed, 800);
    compare_with_wall(&face, 1. / 256, 100);
}

/* A block that forces drive is a piston of its mass: whatever it meets pushes it back. */
static fw_scene *pressed_from_below(bool grip, double mass)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, column);
    add_block(scene, "ceiling", (fw_vec2){-50, 7}, (fw_vec2){50, 9}, smooth, NULL);
    if (grip) {
        add_body(scene, (body_options){.columns = 16, .rows = 3, .origin = {0, -2}});
        grip_rows(scene, 1, "hand", 16, 0, 3, pressed(0, .05));
    } else {
        const fw_piston_def def = {.mass = mass, .drive = {.force = {0, .05}}};
        add_block(scene, "hand", (fw_vec2){0, -2}, (fw_vec2){15, 0}, smooth, &def);
    }
    begin(scene);
    return scene;
}

static void a_pressed_block_is_a_piston_of_its_mass(void **state)
{
    (void)state;
    fw_scene *block = pressed_from_below(true, 1);
    const fw_solid *own = fw_scene_observe_body(block, 1);
    fw_scene *piston = pressed_from_below(false, own->model->mass(own).yy);
    for (int t = 0; t < 6; ++t) {
        run(block, 100);
        run(piston, 100);
        assert_in_one_place(block, piston, 0, 0, 1e-9);
        assert_close(grip_ledger(block, 0)->displacement.y, ledger_of(piston, 1)->displacement.y,
                     1e-9);
        assert_close(grip_ledger(block, 0)->force.y, .05, 1e-12); /* of the drive alone */
        assert_ledger_closes(block, 1e-12);
    }
    assert_true(grip_ledger(block, 0)->displacement.y < 3); /* the ceiling has held them */
    fw_scene_destroy(block);
    fw_scene_destroy(piston);
}

/* Pressed onto a floor, a body whose lowest row is gripped comes to rest on it. */
static void a_wall_bears_what_presses_a_grip(void **state)
{
    (void)state;
    for (int round = 0; round < 2; ++round) {
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 6, .rows = 3, .origin = {0, .13}, .mu = .9});
        fw_drive drive = pressed(0, -.2);
        drive.prescribed_x = true;
        grip_rows(scene, 0, "hand", 6, 0, 1, drive);
        if (round == 0) {
            add_block(scene, "floor", (fw_vec2){-9, -4}, (fw_vec2){19, 0}, smooth, NULL);
        } else {
            const fw_vec2 centre[] = {{2.3, -60}};
            fw_wall_def def = fw_wall_def_default();
            def.name = "floor";
            def.shape = FW_CIRCLE;
            def.points = centre;
            def.point_count = 1;
            def.radius = 60;
            def.side = FW_OUTSIDE;
            must(fw_scene_add_wall(scene, &def, &error));
        }
        begin(scene);
        run(scene, 3000);
        double mean = 0;
        for (int t = 0; t < 200; ++t) {
            run(scene, 1);
            mean += fw_scene_wall_ledger(scene, 0)->reaction.y / 200;
        }
        assert_close(mean, .2, round == 0 ? 1e-6 : 1e-3);
        assert_below(fw_scene_penetration(scene, -1), 1e-12);
        assert_close(grip_ledger(scene, 0)->force.y, -.2, 1e-12);
        assert_ledger_closes(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

/* A held block stops a piston, and bears its force; a carried one pushes it back. */
static void a_grip_holds_a_piston(void **state)
{
    (void)state;
    for (int moves = 0; moves < 2; ++moves) {
        const double speed = moves * 2e-3;
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 6, .rows = 3, .origin = {0, -2}});
        grip_rows(scene, 0, "hand", 6, 0, 3, carried(0, speed));
        const fw_piston_def def = {.mass = 20, .damping = .05, .drive = {.force = {0, -.2}}};
        add_block(scene, "stamp", (fw_vec2){-4, .3}, (fw_vec2){9, 4}, smooth, &def);
        begin(scene);
        run(scene, 2000);
        double mean = 0;
        for (int t = 0; t < 200; ++t) {
            run(scene, 1);
            mean += grip_ledger(scene, 0)->reaction.y / 200;
        }
        /* Damping takes M damping v of what moves. */
        assert_close(mean, .2 + 20 * .05 * speed, 1e-5);
        assert_close(ledger_of(scene, 0)->displacement.y, 2200 * speed - .3, 1e-2);
        assert_below(fw_scene_penetration(scene, -1), 1e-10);
        assert_ledger_balances(scene, 1e-11);
        fw_scene_destroy(scene);
    }
}

/* Two blocks that forces press together in the air, one driven on: as a whole they are free. */
static void two_pressed_grips_bear_each_other(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 9, .rows = 3, .mu = .95});
    add_body(scene, (body_options){.columns = 6, .rows = 3, .origin = {1.4, 2.2}, .mu = .95});
    grip_rows(scene, 0, "below", 9, 0, 3, pressed(.01, .2));
    grip_rows(scene, 1, "above", 6, 0, 3, pressed(0, -.2));
    begin(scene);
    run(scene, 1000);
    const fw_vec2 impulse = fw_scene_ledger(scene).grip_impulse;
    assert_close(impulse.x, 10, 1e-9);
    assert_close(impulse.y, 0, 1e-9);
    assert_close(fw_scene_body_ledger(scene, 0, 0)->impulse.y,
                 -fw_scene_body_ledger(scene, 1, 0)->impulse.y, 1e-9);
    assert_true(fw_scene_body_ledger(scene, 1, 0)->impulse.y > 100);
    assert_true(fw_scene_body_penetration(scene) < 1e-9);
    assert_ledger_closes(scene, 1e-12);
    fw_scene_destroy(scene);
}

/* A block that a grip presses on what is rough, and carries along it. What is rough is a floor, or
 * a body that a grip holds. */
static fw_scene *dragged(bool floor, double friction, fw_drive drive, fw_vec2 velocity)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene,
             (body_options){.columns = 6, .rows = 3, .origin = {0, .001}, .velocity = velocity});
    grip_rows(scene, 0, "hand", 6, 0, 3, drive);
    if (floor) {
        add_block(scene, "floor", (fw_vec2){-90, -4}, (fw_vec2){190, 0},
                  (fw_surface){.law = FW_COULOMB, .friction = friction}, NULL);
    } else {
        add_body(scene, (body_options){.columns = 60, .rows = 2, .origin = {-20.3, -1}});
        grip_rows(scene, 1, "held", 60, 0, 2, carried(0, 0));
        fw_scene_set_friction(scene, friction);
    }
    begin(scene);
    return scene;
}

static void a_carried_grip_rubs_what_it_is_pressed_on(void **state)
{
    (void)state;
    for (int floor = 0; floor < 2; ++floor) {
        fw_drive drive = pressed(0, -.2);
        drive.prescribed_x = true;
        drive.path = (fw_path){.velocity = {.004, 0}, .until = INFINITY};
        fw_scene *scene = dragged(floor, .3, drive, (fw_vec2){0, 0});
        run(scene, 1000);
        const double before = grip_ledger(scene, 0)->impulse.x;
        const double heat =
            fw_scene_ledger(scene).friction_heat + fw_scene_ledger(scene).dissipated;
        run(scene, 1000);
        /* mu N against it, and mu N v of heat. A point that passes from one segment to the next
         * lies on both, and rubs on one. */
        const double part = floor ? 1e-11 : 3e-3;
        const double after =
            fw_scene_ledger(scene).friction_heat + fw_scene_ledger(scene).dissipated;
        assert_close(grip_ledger(scene, 0)->impulse.x - before, 60, 60 * part);
        assert_close(after - heat, .24, .24 * part);
        assert_ledger_closes(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

/* Thrown, and pressed by M g: it stops after v^2/(2 mu g). */
static void a_thrown_grip_stops_after_its_way(void **state)
{
    (void)state;
    for (int floor = 0; floor < 2; ++floor) {
        fw_scene *scene = dragged(floor, .3, pressed(0, -.2), (fw_vec2){.02, 0});
        const fw_solid *solid = fw_scene_observe_body(scene, 0);
        const double mass = solid->model->mass(solid).xx;
        run(scene, 4000);
        const double way = grip_ledger(scene, 0)->displacement.x;
        assert_close(way, .02 * .02 * mass / (2 * .3 * .2), .03);
        run(scene, 1000);
        assert_close(grip_ledger(scene, 0)->displacement.x, way, 1e-12);
        assert_ledger_closes(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

/* Pulled by T inside the cone of mu N, on a wall and on a body, it stays where it is. As it lands
 * half of the load is its reaction, and friction bears mu N/2: it goes by A (T - mu N/2), and as
 * far again until it rests, less what it would still swing by where sticking lets through less than
 * 1e-4 of A T, the first term of a sum in which each is 1 - e of the one before, e = .343. Then
 * rounding: of A T in each step, 2e-19; and of the work of the load, that of A N. */
static void a_grip_pulled_inside_the_cone_does_not_creep(void **state)
{
    (void)state;
    for (int trial = 0; trial < 4; ++trial) {
        const bool floor = trial % 2 == 0;
        const double pull = trial < 2 ? .02 : .04, load = .2, friction = .3;
        fw_scene *scene = dragged(floor, friction, pressed(pull, -load), (fw_vec2){0, 0});
        const fw_solid *solid = fw_scene_observe_body(scene, 0);
        const double mobility = .5 / solid->model->mass(solid).xx;
        const double way = 2 * mobility * fmax(0, pull - friction * load / 2);
        run(scene, 1000);
        const double place = grip_ledger(scene, 0)->displacement.x;
        assert_close(place, way, way > 0 ? 1e-4 * mobility * pull / .343 : 1e-14);
        run(scene, 2000);
        assert_close(grip_ledger(scene, 0)->displacement.x, place, 1e-14);
        assert_int_equal(fw_scene_contact_ledger(scene)->unconverged, 0);
        const fw_ledger ledger = fw_scene_ledger(scene);
        assert_close(energy_of(scene), fw_ledger_energy(&ledger),
                     3000 * load * load * mobility * 1e-15);
        if (floor && way > 0) assert_ledger_closes(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

static void assert_stops_before(fw_scene *scene, const char *sentence)
{
    begin(scene);
    fw_status status = FW_OK;
    double before[2] = {0, 0};
    for (int t = 0; t < 200 && status == FW_OK; ++t) {
        for (int b = 0; b < fw_scene_body_count(scene); ++b)
            before[b] = fw_scene_observe_body(scene, b)->y[0];
        status = fw_scene_step(scene, &error);
    }
    assert_int_equal(status, FW_DIVERGED);
    if (!strstr(error.sentence, sentence)) fail_msg("'%s' is not in: %s", sentence, error.sentence);
    for (int b = 0; b < fw_scene_body_count(scene); ++b)
        assert_close(fw_scene_observe_body(scene, b)->y[0], before[b], 0);
    fw_scene_destroy(scene);
}

static void what_cannot_give_way_stops_the_run_before_it_passes(void **state)
{
    (void)state;
    for (int drives = 0; drives < 3; ++drives) {
        /* Along y both are prescribed; along x the second may be driven by a force. */
        fw_drive drive = carried(0, -.01);
        drive.prescribed_x = drives < 2;
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 5, .rows = 3, .origin = {0, .125}});
        grip_rows(scene, 0, "hand", 5, drives == 0 ? 0 : 1, drives == 0 ? 1 : 2, drive);
        if (drives == 0) {
            add_block(scene, "floor", (fw_vec2){-9, -4}, (fw_vec2){19, 0}, smooth, NULL);
            assert_stops_before(scene,
                                "step 12: grip hand carries particle 0 of body sheet through "
                                "wall floor: at (0, -0.005) it would lie 0.005 behind");
            continue;
        }
        add_body(scene, (body_options){.columns = 9, .rows = 3, .origin = {-1.7, 1.2}});
        fw_scene_destroy(scene);
        scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 5, .rows = 3, .origin = {0, .125}});
        grip_rows(scene, 0, "hand", 5, 0, 3, drive);
        add_body(scene, (body_options){.columns = 9, .rows = 3, .origin = {-1.7, -2}});
        grip_rows(scene, 1, "held", 9, 0, 3, carried(0, 0));
        assert_stops_before(scene, "step 12: grips carry particle");
    }
}

/* Whatever part of a long edge comes to a wall first: the wall is at each end of a strip. */
static void every_part_of_a_carried_edge_is_looked_at(void **state)
{
    (void)state;
    static const fw_vec2 ways[] = {{.01, 0}, {-.01, 0}, {0, .01}, {0, -.01}};
    for (int lies = 0; lies < 2; ++lies)
        for (int way = 0; way < 4; ++way) {
            const int columns = lies ? 40 : 3, rows = lies ? 3 : 40;
            const double right = columns - 1 + .125, top = rows - 1 + .125;
            fw_scene *scene = empty_scene(1e4);
            add_body(scene, (body_options){.columns = columns, .rows = rows});
            grip_rows(scene, 0, "hand", columns, 0, rows, carried(ways[way].x, ways[way].y));
            add_block(scene, "right", (fw_vec2){right, -9}, (fw_vec2){right + 5, 90}, smooth, NULL);
            add_block(scene, "left", (fw_vec2){-9, -9}, (fw_vec2){-.125, 90}, smooth, NULL);
            add_block(scene, "top", (fw_vec2){-9, top}, (fw_vec2){90, top + 5}, smooth, NULL);
            add_block(scene, "bottom", (fw_vec2){-9, -9}, (fw_vec2){90, -.125}, smooth, NULL);
            begin(scene);
            for (int t = 0; t < 12; ++t) assert_int_equal(fw_scene_step(scene, &error), FW_OK);
            assert_int_equal(fw_scene_step(scene, &error), FW_DIVERGED);
            assert_true(fw_scene_penetration(scene, -1) == 0);
            fw_scene_destroy(scene);
        }
}

/* Pulled by less than its static friction bears as it lands, mu_s N/2, and by more than the kinetic
 * one: it stays; by more than either it goes. */
static void a_grip_sticks_by_static_friction(void **state)
{
    (void)state;
    static const fw_surface rough = {.law = FW_COULOMB, .friction = .2, .static_friction = .5};
    for (int goes = 0; goes < 2; ++goes) {
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 6, .rows = 3, .origin = {0, .001}});
        grip_rows(scene, 0, "hand", 6, 0, 3, pressed(goes ? .11 : .045, -.2));
        add_block(scene, "floor", (fw_vec2){-90, -4}, (fw_vec2){190, 0}, rough, NULL);
        begin(scene);
        run(scene, 1000);
        const double way = grip_ledger(scene, 0)->displacement.x;
        if (goes)
            assert_true(way > 100);
        else
            assert_close(way, 0, 1e-13);
        fw_scene_destroy(scene);
    }
}

/* From any tick on, in any scene that was made in the same way. */
static fw_scene *busy(void)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene,
             (body_options){
                 .columns = 6, .rows = 4, .origin = {3.3, .21}, .velocity = {.01, 0}, .mu = .98});
    add_body(scene, (body_options){.columns = 16, .rows = 3, .origin = {0, -2}, .mu = .97});
    fw_drive drive = pressed(0, .2);
    drive.prescribed_x = true;
    drive.path = (fw_path){.amplitude = {.3, 0}, .period = 150};
    grip_rows(scene, 1, "hand", 16, 0, 3, drive);
    add_block(scene, "ceiling", (fw_vec2){-50, 4}, (fw_vec2){50, 9},
              (fw_surface){.law = FW_COULOMB, .friction = .4}, NULL);
    fw_scene_set_friction(scene, .3);
    begin(scene);
    return scene;
}

static void it_goes_on_elsewhere(void **state)
{
    (void)state;
    assert_goes_on_elsewhere(busy, 300, 40, 70);
    fw_scene *scene = busy();
    run(scene, 2000);
    assert_ledger_closes(scene, 1e-12);
    assert_true(fw_scene_contact_ledger(scene)->heat > 1e-3);
    assert_below(fw_scene_body_penetration(scene), 1e-9);
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_carried_block_is_a_moving_wall),
        cmocka_unit_test(a_pressed_block_is_a_piston_of_its_mass),
        cmocka_unit_test(a_wall_bears_what_presses_a_grip),
        cmocka_unit_test(a_grip_holds_a_piston),
        cmocka_unit_test(two_pressed_grips_bear_each_other),
        cmocka_unit_test(a_carried_grip_rubs_what_it_is_pressed_on),
        cmocka_unit_test(a_thrown_grip_stops_after_its_way),
        cmocka_unit_test(a_grip_pulled_inside_the_cone_does_not_creep),
        cmocka_unit_test(what_cannot_give_way_stops_the_run_before_it_passes),
        cmocka_unit_test(every_part_of_a_carried_edge_is_looked_at),
        cmocka_unit_test(a_grip_sticks_by_static_friction),
        cmocka_unit_test(it_goes_on_elsewhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
