/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_room.c - what is refused or stops a run, and says where: starts in a wall, rigid things that
 * leave a particle no room, numbers that explode. */
#include "tests/support/scenes.h"

static const fw_surface surfaces[] = {{.law = FW_FRICTIONLESS},
                                      {.law = FW_STICK},
                                      {.law = FW_COULOMB, .friction = 0.3},
                                      {.law = FW_COMPONENTWISE}};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

static void add_box(fw_scene *scene, const char *name, fw_vec2 low, fw_vec2 high,
                    fw_surface surface, fw_path path)
{
    const fw_vec2 corners[] = {low, high};
    fw_wall_def def = fw_wall_def_default();
    def.name = name;
    def.points = corners;
    def.side = FW_OUTSIDE;
    def.surface = surface;
    def.path = path;
    must(fw_scene_add_wall(scene, &def, &error));
}

static fw_path moving(double x, double y)
{
    return (fw_path){.velocity = {x, y}, .until = INFINITY};
}

/* Steps until the run stops; until then nothing lies behind a wall. */
static int steps_to_the_stop(fw_scene *scene, int most)
{
    begin(scene);
    for (int step = 0; step < most; ++step) {
        const fw_status status = fw_scene_step(scene, &error);
        if (status == FW_OK) {
            assert_below(fw_scene_penetration(scene, -1), 1e-10);
            continue;
        }
        assert_int_equal(status, FW_DIVERGED);
        return step;
    }
    fail_msg("walls have closed, and nothing says so");
    return most;
}

static void assert_told(const char *words)
{
    if (!strstr(error.sentence, words)) fail_msg("'%s' is not in: %s", words, error.sentence);
}

/* From 5.7 apart, .1 in each step: the body of 3.3 to 8.3 is pressed until no room is left. */
static void walls_that_close_stop_the_run(void **state)
{
    (void)state;
    for (int k = 0; k < SURFACES; ++k)
        for (int one = 0; one < 2; ++one) {
            fw_scene *scene = empty_scene(1e6);
            add_body(scene,
                     (body_options){
                         .columns = 6, .rows = 6, .origin = {3.3, 4.7}, .velocity = {0.05, 0.031}});
            add_box(scene, "a", (fw_vec2){-20, -20}, (fw_vec2){3, 40}, surfaces[k],
                    moving(one ? 0.2 : 0.1, 0));
            add_box(scene, "b", (fw_vec2){9, -20}, (fw_vec2){40, 40}, surfaces[k],
                    one ? (fw_path){.until = INFINITY} : moving(-0.1, 0));
            const int step = steps_to_the_stop(scene, 500);
            assert_true(step >= 28 && step <= 30);
            assert_told("the room between walls");
            assert_told("body sheet");
            fw_scene_destroy(scene);
        }
}

/* A ring carries its body against a block that does not give way. */
static void ring_against_a_block_stops_the_run(void **state)
{
    (void)state;
    for (int k = 0; k < SURFACES - 1; ++k) {
        fw_scene *scene = empty_scene(1e6);
        add_body(scene, (body_options){.columns = 3, .rows = 3, .origin = {-1, -1}});
        const fw_vec2 middle = {0, 0};
        fw_wall_def def = fw_wall_def_default();
        def.name = "ring";
        def.shape = FW_CIRCLE;
        def.points = &middle;
        def.point_count = 1;
        def.radius = 4;
        def.surface = surfaces[k];
        def.path = moving(0.05, 0);
        must(fw_scene_add_wall(scene, &def, &error));
        add_box(scene, "block", (fw_vec2){5, -9}, (fw_vec2){9, 9}, surfaces[k],
                (fw_path){.until = INFINITY});
        const int step = steps_to_the_stop(scene, 400);
        assert_true(step > 100);
        assert_told("the room between walls");
        fw_scene_destroy(scene);
    }
}

static void piston_that_must_move_stops_the_run(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    add_body(scene, (body_options){.columns = 4, .rows = 4});
    add_box(scene, "floor", (fw_vec2){-20, -5}, (fw_vec2){20, 0}, surfaces[0],
            (fw_path){.until = INFINITY});
    const fw_vec2 corners[] = {{-20, 4}, {20, 9}};
    fw_wall_def def = fw_wall_def_default();
    def.name = "stamp";
    def.points = corners;
    def.side = FW_OUTSIDE;
    const fw_piston_def piston = {
        .mass = 1, .drive = {.prescribed_x = true, .prescribed_y = true, .path = moving(0, -0.1)}};
    must(fw_scene_add_piston(scene, &def, &piston, &error));
    const int step = steps_to_the_stop(scene, 400);
    assert_true(step >= 38 && step <= 42);
    assert_told("the room between walls floor and stamp");
    fw_scene_destroy(scene);
}

/* On a path it gives way to nothing: 1 above the floor, .1 in each step. */
static void grip_driven_into_a_wall_stops_the_run(void **state)
{
    (void)state;
    for (double speed = 0.1; speed > 1e-13; speed *= 1e-6) {
        fw_scene *scene = empty_scene(1e6);
        const double height = 10 * speed;
        add_body(scene, (body_options){.columns = 4, .rows = 4, .origin = {0, height}});
        add_box(scene, "floor", (fw_vec2){-20, -5}, (fw_vec2){20, 0}, surfaces[0],
                (fw_path){.until = INFINITY});
        const int bottom[] = {0, 1, 2, 3};
        const fw_grip_def def = {
            .name = "hand",
            .particles = bottom,
            .particle_count = 4,
            .drive = {.prescribed_x = true, .prescribed_y = true, .path = moving(0, -speed)}};
        must(fw_scene_add_grip(scene, 0, &def, &error));
        const int step = steps_to_the_stop(scene, 10000);
        assert_true(speed < 1e-9 || (step >= 9 && step <= 11));
        assert_told("grip hand carries particle 0 of body sheet through wall floor");
        fw_scene_destroy(scene);
    }
}

/* A grip that slides along the surface, or comes to rest on it, goes through nothing. */
static void grip_on_the_surface_is_no_fault(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e6);
    add_body(scene, (body_options){.columns = 4, .rows = 4, .angle = 0.3, .origin = {0, 1}});
    const fw_vec2 line[] = {{-30 * cos(0.3), 1 - 30 * sin(0.3)},
                            {30 * cos(0.3), 1 + 30 * sin(0.3)}};
    fw_wall_def def = fw_wall_def_default();
    def.name = "slope";
    def.shape = FW_CHAIN;
    def.points = line;
    must(fw_scene_add_wall(scene, &def, &error));
    const int bottom[] = {0, 1, 2, 3};
    const fw_grip_def grip = {
        .name = "hand",
        .particles = bottom,
        .particle_count = 4,
        .drive = {.prescribed_x = true,
                  .prescribed_y = true,
                  .path = {.amplitude = {5 * cos(0.3), 5 * sin(0.3)}, .period = 100}}};
    must(fw_scene_add_grip(scene, 0, &grip, &error));
    begin(scene);
    run(scene, 5000);
    fw_scene_destroy(scene);
}

static void body_that_starts_in_a_wall_is_refused(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(INFINITY);
    add_body(scene, (body_options){.columns = 3, .rows = 3, .origin = {58.5, 1}});
    const fw_vec2 corners[] = {{0, 0}, {60, 60}};
    fw_wall_def def = fw_wall_def_default();
    def.points = corners;
    must(fw_scene_add_wall(scene, &def, &error));
    assert_int_equal(fw_scene_begin(scene, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "starts in wall"));
    fw_scene_destroy(scene);
}

static void exploding_numbers_stop_the_run(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(INFINITY);
    add_body(scene, (body_options){.columns = 3, .rows = 3});
    int third = 3;
    fw_load_def load = {.kind = FW_LOAD_EACH,
                        .particles = &third,
                        .particle_count = 1,
                        .vector = {1e308, 0},
                        .until = INT64_MAX};
    assert_int_equal(fw_scene_add_load(scene, 0, &load, NULL), FW_OK);
    begin(scene);
    fw_status status = FW_OK;
    for (int t = 0; t < 1000 && status == FW_OK; ++t) status = fw_scene_step(scene, &error);
    assert_int_equal(status, FW_DIVERGED);
    assert_non_null(strstr(error.sentence, "body sheet"));
    fw_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_that_close_stop_the_run),
        cmocka_unit_test(ring_against_a_block_stops_the_run),
        cmocka_unit_test(piston_that_must_move_stops_the_run),
        cmocka_unit_test(grip_driven_into_a_wall_stops_the_run),
        cmocka_unit_test(grip_on_the_surface_is_no_fault),
        cmocka_unit_test(body_that_starts_in_a_wall_is_refused),
        cmocka_unit_test(exploding_numbers_stop_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
