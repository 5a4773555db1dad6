/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_apart.c - while bodies cannot come to anything, a scene takes many steps at once: the bytes
 * are those of steps one by one. */
#include "tests/support/scenes.h"

/* As a box, or as the polygon of its corners. */
static void add_room(fw_scene *scene, double size, fw_surface surface, fw_wall_shape_kind shape)
{
    fw_wall_def def = fw_wall_def_default();
    const fw_vec2 corners[] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    const fw_vec2 ends[] = {{0, 0}, {size, size}};
    def.shape = shape;
    def.points = shape == FW_BOX ? ends : corners;
    def.point_count = shape == FW_BOX ? 2 : 4;
    def.surface = surface;
    def.name = "box";
    must(fw_scene_add_wall(scene, &def, &error));
}

static fw_scene *in_a_room(fw_surface surface, fw_wall_shape_kind shape)
{
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 20,
                                   .rows = 15,
                                   .origin = {60, 50},
                                   .velocity = {0.05, 0.03},
                                   .rest_mass = 1,
                                   .form = FW_LB_DISPLACEMENTS});
    add_room(scene, 130, surface, shape);
    fw_scene_keep_forces(scene);
    begin(scene);
    return scene;
}

static fw_scene *in_a_box(fw_surface surface)
{
    return in_a_room(surface, FW_BOX);
}

static fw_scene *in_a_smooth_box(void)
{
    return in_a_box((fw_surface){.law = FW_FRICTIONLESS});
}

static fw_scene *in_a_rough_box(void)
{
    return in_a_box((fw_surface){.law = FW_COULOMB, .friction = 0.3, .static_friction = 0.3});
}

static fw_scene *in_a_soft_box(void)
{
    return in_a_box((fw_surface){.law = FW_PENALTY, .stiffness = 0.5});
}

static fw_scene *in_a_soft_polygon(void)
{
    return in_a_room((fw_surface){.law = FW_PENALTY, .stiffness = 0.5}, FW_POLYGON);
}

/* Two bodies that run into each other, and rub. */
static fw_scene *towards_each_other(void)
{
    fw_scene *scene = empty_scene(1e4);
    for (int b = 0; b < 2; ++b)
        add_body(scene, (body_options){.columns = 12,
                                       .rows = 18,
                                       .origin = {100.0 * b, 4.3 * b},
                                       .velocity = {b == 0 ? 0.06 : -0.04, 0.01},
                                       .rest_mass = 1,
                                       .mu = b == 0 ? 1 : 0.999,
                                       .form = FW_LB_DISPLACEMENTS});
    fw_scene_set_friction(scene, 0.2);
    begin(scene);
    return scene;
}

/* Of both scenes, one by as many steps at once as it takes. */
static void assert_same_bytes(fw_scene *(*make)(void), int steps, int every)
{
    fw_scene *quick = make(), *slow = make();
    int calls = 0;
    while (fw_scene_steps(slow) < steps) {
        const int64_t end = fw_scene_steps(slow) + every;
        run(slow, every);
        for (; fw_scene_steps(quick) < end; ++calls)
            must(fw_scene_advance(quick, end - fw_scene_steps(quick), &error));
        must(fw_scene_settle(quick, &error));
        assert_true(hash_of_scene(quick) == hash_of_scene(slow));
    }
    /* It did touch, and most of the time it did not. */
    const fw_scene *touched = quick;
    const double touches =
        fw_scene_contact_ledger(touched)->ticks +
        (fw_scene_wall_count(touched) > 0 ? fw_scene_wall_ledger(touched, 0)->held : 0);
    assert_true(touches > 0);
    assert_true(calls < 0.7 * steps);
    fw_scene_destroy(quick);
    fw_scene_destroy(slow);
}

static void flight_in_a_box_is_the_same_to_the_bit(void **state)
{
    (void)state;
    assert_same_bytes(in_a_smooth_box, 3000, 100);
    assert_same_bytes(in_a_rough_box, 3000, 97);
    assert_same_bytes(in_a_soft_box, 3000, 60);
}

/* A path may be known to keep away from a soft box by its corners, of a polygon each is asked. */
static void a_soft_polygon_acts_as_the_box_of_its_corners(void **state)
{
    (void)state;
    assert_same_bytes(in_a_soft_polygon, 1500, 60);
    fw_scene *box = in_a_soft_box(), *polygon = in_a_soft_polygon();
    run(box, 1500);
    run(polygon, 1500);
    const fw_wall_ledger *one = fw_scene_wall_ledger(box, 0),
                         *other = fw_scene_wall_ledger(polygon, 0);
    assert_true(one->impulse.x < -1);
    assert_close(other->impulse.x, one->impulse.x, 0);
    assert_close(other->work, one->work, 0);
    assert_true(hash_of_scene(box) == hash_of_scene(polygon));
    fw_scene_destroy(box);
    fw_scene_destroy(polygon);
}

static void bodies_that_meet_are_the_same_to_the_bit(void **state)
{
    (void)state;
    assert_same_bytes(towards_each_other, 2000, 100);
}

/* Steps that are looked at one by one, among others. */
static void steps_of_both_kinds_mix(void **state)
{
    (void)state;
    fw_scene *mixed = towards_each_other(), *slow = towards_each_other();
    for (int round = 0; round < 150; ++round) {
        const int64_t end = fw_scene_steps(mixed) + round % 20 + 1;
        while (fw_scene_steps(mixed) < end)
            must(fw_scene_advance(mixed, end - fw_scene_steps(mixed), &error));
        if (round % 3 == 0) run(mixed, 1 + round % 2);
        run(slow, (int)(fw_scene_steps(mixed) - fw_scene_steps(slow)));
        must(fw_scene_settle(mixed, &error));
        assert_true(hash_of_scene(mixed) == hash_of_scene(slow));
    }
    fw_scene_destroy(mixed);
    fw_scene_destroy(slow);
}

static void state_from_a_flight_goes_on_elsewhere(void **state)
{
    (void)state;
    fw_scene *whole = in_a_rough_box(), *first = in_a_rough_box(), *second = in_a_rough_box();
    run(whole, 1500);
    while (fw_scene_steps(first) < 333)
        must(fw_scene_advance(first, 333 - fw_scene_steps(first), &error));
    must(fw_scene_settle(first, &error));
    run(second, 900); /* the state replaces another one */
    copy_state(first, second);
    while (fw_scene_steps(second) < 1500)
        must(fw_scene_advance(second, 1500 - fw_scene_steps(second), &error));
    must(fw_scene_settle(second, &error));
    assert_true(hash_of_scene(second) == hash_of_scene(whole));
    fw_scene_destroy(whole);
    fw_scene_destroy(first);
    fw_scene_destroy(second);
}

/* A body that leaves is missed at the same step. */
static void what_leaves_is_found(void **state)
{
    (void)state;
    int64_t lost[2];
    for (int kind = 0; kind < 2; ++kind) {
        fw_scene *scene = empty_scene(200);
        add_body(scene, (body_options){.columns = 10,
                                       .rows = 10,
                                       .velocity = {0.4, 0},
                                       .rest_mass = 1,
                                       .form = FW_LB_DISPLACEMENTS});
        add_body(scene, (body_options){.columns = 5,
                                       .rows = 5,
                                       .origin = {0, 60},
                                       .rest_mass = 1,
                                       .form = FW_LB_DISPLACEMENTS});
        begin(scene);
        fw_status status = FW_OK;
        while (status == FW_OK && fw_scene_steps(scene) < 2000)
            status =
                kind == 0 ? fw_scene_step(scene, &error) : fw_scene_advance(scene, 1000, &error);
        assert_int_equal(status, FW_DIVERGED);
        lost[kind] = fw_scene_steps(scene);
        fw_scene_destroy(scene);
    }
    assert_int_equal(lost[0], lost[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flight_in_a_box_is_the_same_to_the_bit),
        cmocka_unit_test(a_soft_polygon_acts_as_the_box_of_its_corners),
        cmocka_unit_test(bodies_that_meet_are_the_same_to_the_bit),
        cmocka_unit_test(steps_of_both_kinds_mix),
        cmocka_unit_test(state_from_a_flight_goes_on_elsewhere),
        cmocka_unit_test(what_leaves_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
