/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_moving_wall.c - walls on paths: what is far from them feels nothing, wherever and however
 * late the path ends. */
#include "tests/support/scenes.h"

/* Five shapes around a body of 4 x 4 at [0, 3] x [0, 3], all some lengths away. */
static const fw_vec2 box_corners[] = {{-30, -10}, {-20, 20}};
static const fw_vec2 room_corners[] = {{-40, -40}, {50, 50}};
static const fw_vec2 chain_points[] = {{-20, 30}, {-20, -20}}; /* free right */
static const fw_vec2 triangle[] = {{-30, -10}, {-20, 0}, {-30, 20}};
static const fw_vec2 middle[] = {{-30, 5}};

typedef struct shape {
    fw_wall_shape_kind shape;
    fw_side side;
    const fw_vec2 *points;
    int point_count;
} shape;

static const shape shapes[] = {{FW_BOX, FW_OUTSIDE, box_corners, 2},
                               {FW_BOX, FW_INSIDE, room_corners, 2},
                               {FW_CHAIN, FW_OUTSIDE, chain_points, 2},
                               {FW_POLYGON, FW_OUTSIDE, triangle, 3},
                               {FW_CIRCLE, FW_OUTSIDE, middle, 1}};
enum { SHAPES = sizeof shapes / sizeof *shapes };

static void add_moving(fw_scene *scene, const shape *s, fw_surface surface, fw_path path)
{
    fw_wall_def def = fw_wall_def_default();
    def.name = "ram";
    def.shape = s->shape;
    def.side = s->side;
    def.points = s->points;
    def.point_count = s->point_count;
    def.radius = 10;
    def.surface = surface;
    def.path = path;
    must(fw_scene_add_wall(scene, &def, &error));
}

static const fw_surface surfaces[] = {{.law = FW_FRICTIONLESS},
                                      {.law = FW_STICK},
                                      {.law = FW_COULOMB, .friction = 0.3},
                                      {.law = FW_COMPONENTWISE}};

/* Right: no contact, momentum 0, whether the path ends soon, late, or never. */
static void wall_on_a_path_does_not_touch_what_is_far(void **state)
{
    (void)state;
    const fw_path paths[] = {
        {.velocity = {0, 0.1}, .until = 1000},
        {.velocity = {0, 0.1}, .until = 1e12},
        {.velocity = {0, 0.1}, .until = 1e15},
        {.velocity = {-0.1, 0.1}, .until = INFINITY},
        {.velocity = {0, 0.1}, .until = 1e15, .amplitude = {0.1, 0}, .period = 50},
        {.until = 1e15, .amplitude = {0, 1e9}, .period = 1e12}};
    for (int s = 0; s < SHAPES; ++s)
        for (size_t k = 0; k < sizeof surfaces / sizeof *surfaces; ++k)
            for (size_t p = 0; p < sizeof paths / sizeof *paths; ++p) {
                fw_scene *scene = empty_scene(1e6);
                add_body(scene, (body_options){.columns = 4, .rows = 4, .velocity = {0, -0.01}});
                add_moving(scene, &shapes[s], surfaces[k], paths[p]);
                begin(scene);
                const double energy = energy_of(scene);
                run(scene, 20);
                assert_true(fw_scene_wall_ledger(scene, 0)->held == 0);
                assert_int_equal(fw_scene_unresolved(scene), 0);
                assert_close(energy_of(scene), energy, 1e-15);
                assert_close(fw_scene_momentum(scene).x, 0, 1e-15);
                fw_scene_destroy(scene);
            }
}

/* The body lies half in the wall: no path makes that a wall_contact. */
static void start_behind_a_moving_wall_is_refused(void **state)
{
    (void)state;
    const double ends[] = {1000, 1e12, 1e15, INFINITY};
    for (int s = 0; s < SHAPES; ++s)
        for (size_t n = 0; n < sizeof ends / sizeof *ends; ++n) {
            const fw_vec2 origin = shapes[s].side == FW_INSIDE     ? (fw_vec2){48.5, 0}
                                   : shapes[s].shape == FW_POLYGON ? (fw_vec2){-23.5, 0}
                                                                   : (fw_vec2){-21.5, 5};
            fw_scene *scene = empty_scene(1e6);
            add_body(scene, (body_options){.columns = 4, .rows = 4, .origin = origin});
            add_moving(scene, &shapes[s], surfaces[0],
                       (fw_path){.velocity = {0.1, 0.1}, .until = ends[n]});
            assert_int_equal(fw_scene_begin(scene, &error), FW_BAD_INPUT);
            assert_non_null(strstr(error.sentence, "starts in wall ram"));
            fw_scene_destroy(scene);
        }
}

/* A particle just beside the end of a blade, or behind it, is left alone. */
static void tolerance_follows_where_a_wall_is(void **state)
{
    (void)state;
    fw_facet blade = fw_facet_straight(0, (fw_vec2){0, 0}, (fw_vec2){-10, 0}, 0);
    assert_below(fw_facet_tolerance(&blade, 0), 1e-11);
    assert_close(fw_facet_tolerance(&blade, 1e6), 1e6 * 0x1p-40, 1e-10);
    /* Free below. From behind by 1e-7, and past the end by 1e-7: */
    assert_false(fw_facet_is_passed(&blade, (fw_vec2){-5, 1e-7}, (fw_vec2){0, 1}, 0));
    assert_false(fw_facet_is_passed(&blade, (fw_vec2){1e-7, -1}, (fw_vec2){0, 2}, 0));
    /* As near to a wall that has come a million lengths, that is rounding. */
    assert_true(fw_facet_is_passed(&blade, (fw_vec2){-5, 1e-7}, (fw_vec2){0, 1}, 1e6));
    assert_true(fw_facet_is_passed(&blade, (fw_vec2){1e-7, -1}, (fw_vec2){0, 2}, 1e6));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wall_on_a_path_does_not_touch_what_is_far),
        cmocka_unit_test(start_behind_a_moving_wall_is_refused),
        cmocka_unit_test(tolerance_follows_where_a_wall_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
