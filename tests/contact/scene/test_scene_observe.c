/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_scene_observe.c - free flights in one go, and what is asked of a scene apart from its steps:
 * who is lost, held, stuck, folded, behind a wall. */
#include "core/automaton/elastic_automaton.h"
#include "tests/support/pistons.h"
#include "tests/support/scratch.h"

/* --- free flights --- */

static void add_displaced(fw_scene *scene, fw_vec2 origin, fw_vec2 velocity)
{
    add_body(scene, (body_options){.columns = 6,
                                   .rows = 5,
                                   .origin = origin,
                                   .velocity = velocity,
                                   .form = FW_LB_DISPLACEMENTS});
}

/* Many steps in one go bring the same bytes as one by one, and end where all is looked at. */
static void a_free_flight_is_its_steps(void **state)
{
    (void)state;
    fw_scene *scenes[2];
    for (int n = 0; n < 2; ++n) {
        scenes[n] = empty_scene(1e3);
        add_displaced(scenes[n], (fw_vec2){0, 0}, (fw_vec2){0.02, 0.01});
        begin(scenes[n]);
    }
    run(scenes[0], 100);
    int calls = 0;
    while (fw_scene_steps(scenes[1]) < 100) {
        must(fw_scene_advance(scenes[1], 100 - fw_scene_steps(scenes[1]), &error));
        ++calls;
    }
    must(fw_scene_settle(scenes[1], &error));
    assert_int_equal(calls, 7); /* 6 x 16 + 4 */
    assert_true(hash_of_scene(scenes[0]) == hash_of_scene(scenes[1]));
    for (int n = 0; n < 2; ++n) fw_scene_destroy(scenes[n]);
}

/* What anything acts on goes step by step. */
static void what_is_not_free_goes_step_by_step(void **state)
{
    (void)state;
    static const int one[] = {0};
    for (int k = 0; k < 4; ++k) {
        fw_scene *scene = empty_scene(1e3);
        add_displaced(scene, (fw_vec2){0, 0}, (fw_vec2){0.02, 0.01});
        if (k == 0) add_block(scene, "far", (fw_vec2){50, 50}, (fw_vec2){60, 60}, smooth, NULL);
        const fw_load_def load = {.kind = FW_LOAD_EACH, .particles = one, .particle_count = 1};
        if (k == 1) must(fw_scene_add_load(scene, 0, &load, &error));
        const fw_grip_def grip = {.name = "hand", .particles = one, .particle_count = 1};
        if (k == 2) must(fw_scene_add_grip(scene, 0, &grip, &error));
        if (k == 3) add_displaced(scene, (fw_vec2){40, 0}, (fw_vec2){0, 0});
        begin(scene);
        must(fw_scene_advance(scene, 10, &error));
        assert_int_equal(fw_scene_steps(scene), 1);
        fw_scene_destroy(scene);
    }
}

/* Particles inside are looked for where all are put in place, and the body is named. */
static void what_is_lost_in_flight_is_found(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(20);
    add_displaced(scene, (fw_vec2){10, 0}, (fw_vec2){0.1, 0});
    begin(scene);
    fw_status status = FW_OK;
    for (int n = 0; n < 10 && status == FW_OK; ++n) {
        must(fw_scene_advance(scene, 16, &error));
        status = fw_scene_settle(scene, &error);
    }
    assert_int_equal(status, FW_DIVERGED);
    if (!strstr(error.sentence, "step 64: particle 4 of body sheet is at (20.4"))
        fail_msg("%s", error.sentence);
    fw_scene_destroy(scene);
}

/* --- who is where --- */

static void what_is_held_is_marked(void **state)
{
    (void)state;
    static const int some[] = {3, 4};
    fw_scene *scene = empty_scene(100);
    add_sheet(scene, 3, 3, (fw_vec2){0, 0}, 1, 1);
    add_body(scene, (body_options){.columns = 3, .rows = 3, .origin = {20, 0}, .mu = 1});
    const fw_grip_def grip = {.name = "hand", .particles = some, .particle_count = 2};
    must(fw_scene_add_grip(scene, 0, &grip, &error));
    begin(scene);
    uint8_t held[9] = {1}; /* known from before */
    const uint8_t expected[9] = {1, 0, 0, 1, 1}, none[9] = {0};
    fw_scene_mark_held(scene, 0, held);
    assert_memory_equal(held, expected, sizeof held);
    memset(held, 0, sizeof held);
    fw_scene_mark_held(scene, 1, held);
    assert_memory_equal(held, none, sizeof held);
    fw_scene_destroy(scene);
}

static void each_body_has_its_own_penetration(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(100);
    for (int n = 0; n < 2; ++n)
        add_body(scene, (body_options){.columns = 3, .rows = 3, .origin = {20 * n, 0}, .mu = 1});
    add_block(scene, "floor", (fw_vec2){-50, -10}, (fw_vec2){50, -1}, smooth, NULL);
    begin(scene);
    assert_close(fw_scene_penetration(scene, -1), 0, 0);
    fw_scene_body(scene, 0)->y[1] = -1.25;
    fw_scene_body(scene, 1)->y[0] = -1.5;
    assert_close(fw_scene_penetration(scene, 0), 0.25, 1e-15);
    assert_close(fw_scene_penetration(scene, 1), 0.5, 1e-15);
    assert_close(fw_scene_penetration(scene, -1), 0.5, 1e-15);
    fw_scene_destroy(scene);
}

/* The corner of a sheet is laid over its inside: found, whether the body is alone or meets others,
 * and near where it crosses. Of particles that flow nobody asks. */
static void a_folded_body_is_found(void **state)
{
    (void)state;
    for (int bodies = 1; bodies <= 2; ++bodies) {
        fw_scene *scene = empty_scene(100);
        fw_vec2 home[16], where = {0, 0};
        bool found = true;
        for (int n = 0; n < bodies; ++n)
            add_body(scene,
                     (body_options){.columns = 4, .rows = 4, .origin = {20 * n, 0}, .mu = 1});
        begin(scene);
        fw_solid *solid = fw_scene_body(scene, 0);
        for (int p = 0; p < 16; ++p) home[p] = fw_solid_position(solid, p);
        must(fw_scene_find_fold(scene, 0, home, &found, &where, &error));
        assert_false(found);
        solid->x[0] = 2.5; /* beyond its neighbours, through the edge above it */
        solid->y[0] = 3.5;
        must(fw_scene_find_fold(scene, 0, home, &found, &where, &error));
        assert_true(found);
        assert_true(where.x >= 0 && where.x <= 3 && where.y >= 0 && where.y <= 3.5);
        fw_scene_destroy(scene);
    }
}

/* A block is pressed on a floor with friction: its lowest row counts as stuck once it has been for
 * 50 steps on end, and no longer when it slides. */
static void what_sticks_long_is_counted(void **state)
{
    (void)state;
    enum { COLUMNS = 6, ROWS = 3, ALL = COLUMNS * ROWS };
    static const fw_vec2 ground[] = {{-50, 0}, {50, 0}};
    for (int slides = 0; slides < 2; ++slides) {
        fw_scene *scene = empty_scene(1e3);
        add_body(scene, (body_options){.columns = COLUMNS, .rows = ROWS, .mu = 0.9});
        fw_wall_def floor = fw_wall_def_default();
        floor.name = "floor";
        floor.shape = FW_CHAIN;
        floor.points = ground;
        floor.point_count = 2;
        floor.surface = (fw_surface){.law = FW_COULOMB, .friction = slides ? 0.1 : 0.5};
        must(fw_scene_add_wall(scene, &floor, &error));
        int all[ALL];
        for (int p = 0; p < ALL; ++p) all[p] = p;
        const fw_load_def load = {.kind = FW_LOAD_TOTAL,
                                  .particles = all,
                                  .particle_count = ALL,
                                  .vector = {0.04, -0.1},
                                  .until = INT64_MAX};
        must(fw_scene_add_load(scene, 0, &load, &error));
        begin(scene);
        run(scene, FW_SCENE_STUCK_STEPS - 1);
        assert_int_equal(fw_scene_count_stuck(scene, 0, 0, ALL), 0);
        run(scene, 400);
        assert_int_equal(fw_scene_count_stuck(scene, 0, 0, ALL), slides ? 0 : COLUMNS);
        assert_int_equal(fw_scene_count_stuck(scene, 0, 2, 2), slides ? 0 : 2);
        assert_int_equal(fw_scene_count_stuck(scene, 0, COLUMNS, COLUMNS), 0);
        fw_scene_destroy(scene);
    }
}

/* A block that stuck is pulled off: once the floor neither pushes nor rubs it none of it counts any
 * more, from that step on. */
static void what_has_come_off_sticks_no_longer(void **state)
{
    (void)state;
    enum { COLUMNS = 6, ROWS = 3, ALL = COLUMNS * ROWS, PULLED = 450 };
    static const fw_vec2 ground[] = {{-50, 0}, {50, 0}};
    fw_scene *scene = empty_scene(1e3);
    add_body(scene, (body_options){.columns = COLUMNS, .rows = ROWS, .mu = 0.9});
    fw_wall_def floor = fw_wall_def_default();
    floor.name = "floor";
    floor.shape = FW_CHAIN;
    floor.points = ground;
    floor.point_count = 2;
    floor.surface = (fw_surface){.law = FW_COULOMB, .friction = 0.5};
    must(fw_scene_add_wall(scene, &floor, &error));
    int all[ALL];
    for (int p = 0; p < ALL; ++p) all[p] = p;
    fw_load_def load = {.kind = FW_LOAD_TOTAL,
                        .particles = all,
                        .particle_count = ALL,
                        .vector = {0.01, -0.1},
                        .until = PULLED};
    must(fw_scene_add_load(scene, 0, &load, &error));
    load.vector = (fw_vec2){0, 5};
    load.from = PULLED;
    load.until = INT64_MAX;
    must(fw_scene_add_load(scene, 0, &load, &error));
    begin(scene);
    run(scene, PULLED);
    assert_int_equal(fw_scene_count_stuck(scene, 0, 0, ALL), COLUMNS);
    for (int step = 0; step < 4 && fw_scene_wall_ledger(scene, 0)->contacts > 0; ++step)
        run(scene, 1);
    assert_int_equal(fw_scene_wall_ledger(scene, 0)->contacts, 0);
    assert_int_equal(fw_scene_count_stuck(scene, 0, 0, ALL), 0);
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_free_flight_is_its_steps),
        cmocka_unit_test(what_is_not_free_goes_step_by_step),
        cmocka_unit_test(what_is_lost_in_flight_is_found),
        cmocka_unit_test(what_is_held_is_marked),
        cmocka_unit_test(each_body_has_its_own_penetration),
        cmocka_unit_test(a_folded_body_is_found),
        cmocka_unit_test(what_sticks_long_is_counted),
        cmocka_unit_test(what_has_come_off_sticks_no_longer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
