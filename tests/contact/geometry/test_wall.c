/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls: either sense of a polygon, paths in time, honest refusals. */
#include "tests/support/laws.h"

#include "contact/geometry/wall.h"
#include "tests/support/random_walls.h"

static fw_wall *made(const fw_wall_def *def)
{
    fw_wall *wall;
    fw_error error;
    if (fw_wall_create(&wall, 0, def, &error) != FW_OK) fail_msg("%s", error.sentence);
    return wall;
}

static void polygon_is_the_same_in_either_sense(void **state)
{
    (void)state;
    dice d = {6};
    int free_count = 0, trials = 0;
    for (int shape = 0; shape < 200; ++shape) {
        wall_recipe recipe = {.def = fw_wall_def_default()};
        random_polygon(&recipe, &d, (fw_vec2){100, 100}, 10);
        recipe.def.shape = FW_POLYGON;
        recipe.def.points = recipe.points;
        recipe.def.side = (fw_side)(shape % 2);
        fw_wall *wall = made(&recipe.def);
        const int count = recipe.def.point_count;
        fw_vec2 backwards[WALL_POINTS_MAX];
        for (int i = 0; i < count; ++i) backwards[i] = recipe.points[count - 1 - i];
        recipe.def.points = backwards;
        fw_wall *mirror = made(&recipe.def);
        for (int trial = 0; trial < 100; ++trial) {
            fw_vec2 p = dice_point(&d, (fw_vec2){100, 100}, 15);
            double depth = fw_wall_depth(wall, p, (fw_vec2){0, 0});
            /* Another end of a side is its origin: a few roundings of 100. */
            assert_close(fw_wall_depth(mirror, p, (fw_vec2){0, 0}), depth, 1e-12);
            free_count += depth == 0;
            trials += 1;
        }
        /* The mean of the corners is inside, far away is outside. */
        fw_vec2 mean = {0, 0};
        for (int i = 0; i < count; ++i)
            mean = fw_vec2_add(mean, fw_vec2_scale(1.0 / count, backwards[i]));
        assert_int_equal(fw_wall_depth(wall, mean, (fw_vec2){0, 0}) == 0,
                         recipe.def.side == FW_INSIDE);
        assert_int_equal(fw_wall_depth(wall, (fw_vec2){200, 0}, (fw_vec2){0, 0}) == 0,
                         recipe.def.side == FW_OUTSIDE);
        fw_wall_destroy(wall);
        fw_wall_destroy(mirror);
    }
    assert_true(free_count > trials / 10 && free_count < trials * 9 / 10);
}

static void resting_wall_has_no_displacement_at_all(void **state)
{
    (void)state;
    fw_wall_def def = fw_wall_def_default();
    def.path = (fw_path){.velocity = {0, 0}, .until = INFINITY, .period = 7, .phase = 1};
    fw_wall *wall = made(&def);
    assert_false(fw_wall_moves(wall));
    for (double time = -5; time < 1e6; time += 999.7) {
        fw_vec2 displacement = fw_wall_displacement(wall, time);
        assert_true(displacement.x == 0 && displacement.y == 0);
    }
    fw_wall_destroy(wall);
}

static void wall_follows_its_path(void **state)
{
    (void)state;
    fw_wall_def def = fw_wall_def_default();
    def.path = (fw_path){.velocity = {0.5, -0.25}, .from = 10, .until = 30};
    fw_wall *wall = made(&def);
    assert_true(fw_wall_moves(wall));
    const struct {
        double time, x, y;
    } ramp[] = {{0, 0, 0}, {10, 0, 0}, {12, 1, -0.5}, {30, 10, -5}, {1e6, 10, -5}};
    for (size_t i = 0; i < sizeof ramp / sizeof *ramp; ++i) {
        assert_close(fw_wall_displacement(wall, ramp[i].time).x, ramp[i].x, 0);
        assert_close(fw_wall_displacement(wall, ramp[i].time).y, ramp[i].y, 0);
    }
    fw_wall_destroy(wall);

    def.path = (fw_path){.until = INFINITY, .amplitude = {0.1, 0}, .period = 4000, .phase = 0.5};
    wall = made(&def);
    for (int n = 0; n < 4000; n += 123) {
        double expected = 0.1 * sin(FW_TWO_PI * n / 4000.0 + 0.5);
        assert_close(fw_wall_displacement(wall, n).x, expected, 1e-16);
        assert_close(fw_wall_displacement(wall, n).y, 0, 0);
        /* A million periods later it is at the same place, to the last bit. */
        assert_close(fw_wall_displacement(wall, n + 4e9).x, fw_wall_displacement(wall, n).x, 0);
    }
    fw_wall_destroy(wall);
}

/* An oscillation has the slope of its displacement, at any phase; on top of a constant velocity. */
static void velocity_is_the_slope_of_the_path(void **state)
{
    (void)state;
    const double h = 1e-4;
    const fw_path path = {.velocity = {.25, -.5},
                          .until = INFINITY,
                          .amplitude = {.3, -.2},
                          .period = 7,
                          .phase = .6};
    for (double time = 1; time < 9; time += .37) {
        const fw_vec2 before = fw_path_displacement(&path, time - h),
                      after = fw_path_displacement(&path, time + h),
                      velocity = fw_path_velocity(&path, time, 1);
        assert_close(velocity.x, (after.x - before.x) / (2 * h), 1e-8);
        assert_close(velocity.y, (after.y - before.y) / (2 * h), 1e-8);
    }
}

static void assert_refused(const fw_wall_def *def, const char *sentence)
{
    fw_wall *wall = (fw_wall *)1;
    fw_error error = {FW_OK, ""};
    assert_int_equal(fw_wall_create(&wall, 0, def, &error), FW_BAD_INPUT);
    assert_null(wall);
    assert_int_equal(error.status, FW_BAD_INPUT);
    assert_string_equal(error.sentence, sentence);
}

static void senseless_shapes_are_refused_with_a_sentence(void **state)
{
    (void)state;
    const struct {
        fw_wall_shape_kind shape;
        int count;
        fw_vec2 points[6];
        bool closed;
        const char *sentence;
    } cases[] = {
        {FW_BOX,
         2,
         {{0, 0}, {NAN, 1}},
         false,
         "wall 'w': point 2 is [nan, 1], expected finite coordinates of at most 1e+09 in size"},
        {FW_BOX,
         2,
         {{0, -INFINITY}, {1, 1}},
         false,
         "wall 'w': point 1 is [0, -inf], expected finite coordinates of at most 1e+09 in size"},
        {FW_BOX,
         2,
         {{0, 0}, {1, 2e9}},
         false,
         "wall 'w': point 2 is [1, 2e+09], expected finite coordinates of at most 1e+09 in size"},
        {FW_BOX,
         2,
         {{3, 0}, {3, 5}},
         false,
         "wall 'w': the box from [3, 0] to [3, 5] is empty, expected corners that differ in x and "
         "in y"},
        {FW_BOX,
         2,
         {{0, 0}, {0, 0}},
         false,
         "wall 'w': the box from [0, 0] to [0, 0] is empty, expected corners that differ in x and "
         "in y"},
        {FW_BOX,
         3,
         {{0, 0}, {1, 1}, {2, 2}},
         false,
         "wall 'w': a box of 3 points, expected two opposite corners"},
        {FW_CHAIN, 1, {{0, 0}}, false, "wall 'w': a chain of 1 point, expected at least 2"},
        {FW_CHAIN,
         3,
         {{0, 0}, {1, 1}, {1, 1}},
         false,
         "wall 'w': points 2 and 3, [1, 1] and [1, 1], are 0 apart, expected at least 1e-09"},
        {FW_CHAIN,
         3,
         {{0, 0}, {1, 1}, {0, 0}},
         true,
         "wall 'w': points 3 and 1, [0, 0] and [0, 0], are 0 apart, expected at least "
         "2.22507e-308"},
        {FW_CHAIN,
         2,
         {{1e4, 0}, {1e4 + 1e-6, 0}},
         false,
         "wall 'w': points 1 and 2, [10000, 0] and [10000.000001, 0], are 1e-06 apart, "
         "expected at least 1e-05"},
        {FW_POLYGON,
         2,
         {{0, 0}, {1, 1}},
         false,
         "wall 'w': a polygon of 2 points, expected at least 3"},
        {FW_POLYGON,
         3,
         {{0, 0}, {1, 1}, {2, 2}},
         false,
         "wall 'w': the polygon of 3 corners has an area of 0 at a circumference of 5.65685, "
         "expected corners that do not lie on a line"},
        {FW_POLYGON,
         4,
         {{0, 0}, {4, 0}, {4, 0}, {0, 4}},
         false,
         "wall 'w': points 2 and 3, [4, 0] and [4, 0], are 0 apart, expected at least 4e-09"},
        {FW_POLYGON,
         4,
         {{0, 0}, {4, 0}, {1, 1}, {0, 4}},
         false,
         "wall 'w': the polygon is not convex at corner 3, [1, 1]; a closed chain can have any "
         "corners"},
        {FW_POLYGON,
         4,
         {{0, 4}, {1, 1}, {4, 0}, {0, 0}},
         false,
         "wall 'w': the polygon is not convex at corner 2, [1, 1]; a closed chain can have any "
         "corners"},
        {FW_POLYGON,
         4,
         {{0, 0}, {2, 0}, {1, 0}, {1, 1}},
         false,
         "wall 'w': the polygon is not convex at corner 2, [2, 0]; a closed chain can have any "
         "corners"},
        {FW_POLYGON,
         5,
         {{0, 1}, {-0.588, -0.809}, {0.951, 0.309}, {-0.951, 0.309}, {0.588, -0.809}},
         false,
         "wall 'w': the polygon of 5 corners winds around itself 2 times, expected once"},
        {FW_CIRCLE,
         2,
         {{0, 0}, {1, 1}},
         false,
         "wall 'w': a circle of 2 points, expected one, its centre"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        fw_wall_def def = fw_wall_def_default();
        def.name = "w";
        def.shape = cases[i].shape;
        def.points = cases[i].points;
        def.point_count = cases[i].count;
        def.closed = cases[i].closed;
        def.radius = 1;
        assert_refused(&def, cases[i].sentence);
    }
}

static void senseless_numbers_are_refused_with_a_sentence(void **state)
{
    (void)state;
    fw_wall_def sound = fw_wall_def_default(), def;
    const fw_vec2 centre = {1e4, 0};
    sound.name = "w";
    sound.shape = FW_CIRCLE;
    sound.points = &centre;
    sound.point_count = 1;
    sound.radius = 3;
    fw_wall_destroy(made(&sound));
#define REFUSED(field, value, sentence)                                                            \
    def = sound;                                                                                   \
    def.field = value;                                                                             \
    assert_refused(&def, "wall 'w': " sentence)
    REFUSED(radius, 0, "the radius is 0, expected more than 0");
    REFUSED(radius, -2, "the radius is -2, expected more than 0");
    REFUSED(radius, NAN, "the radius is nan, expected a finite number of at most 1e+09 in size");
    REFUSED(radius, 1e-7,
            "the radius 1e-07 is lost in the rounding of the centre [10000, 0], expected more than "
            "1e-09 of its coordinates");
    REFUSED(surface.friction, -0.1,
            "the friction coefficient is -0.1, expected a finite number >= 0");
    REFUSED(surface.friction, INFINITY,
            "the friction coefficient is inf, expected a finite number >= 0");
    REFUSED(surface.static_friction, NAN,
            "the static friction coefficient is nan, expected a finite number >= 0");
    REFUSED(surface.static_friction, INFINITY,
            "the static friction coefficient is inf, expected a finite number >= 0");
    REFUSED(surface.law, FW_PENALTY,
            "the stiffness of a penalty wall is 0, expected a finite number > 0");
    REFUSED(path.velocity.x, NAN,
            "the velocity in x is nan, expected a finite number of at most 1e+09 in size");
    REFUSED(path.velocity.y, -2e9,
            "the velocity in y is -2e+09, expected a finite number of at most 1e+09 in size");
    REFUSED(path.amplitude.x, INFINITY,
            "the amplitude in x is inf, expected a finite number of at most 1e+09 in size");
    REFUSED(path.amplitude.y, 2e9,
            "the amplitude in y is 2e+09, expected a finite number of at most 1e+09 in size");
    REFUSED(path.phase, INFINITY,
            "the phase is inf, expected a finite number of at most 1e+09 in size");
    REFUSED(path.from, NAN, "it moves from time nan until inf, expected numbers");
    REFUSED(path.from, -INFINITY, "it moves from time -inf until inf, expected numbers");
    REFUSED(path.until, NAN, "it moves from time 0 until nan, expected numbers");
    REFUSED(path.until, -1, "it moves from time 0 until -1, expected an end after the beginning");
    REFUSED(path.period, -5, "the period is -5, expected a finite number >= 0");
    REFUSED(path.period, INFINITY, "the period is inf, expected a finite number >= 0");
    REFUSED(path.amplitude.x, 0.5, "it oscillates with amplitude [0.5, 0] but has no period");
    REFUSED(path.amplitude.y, 0.5, "it oscillates with amplitude [0, 0.5] but has no period");
    sound.surface.law = FW_PENALTY;
    REFUSED(surface.stiffness, INFINITY,
            "the stiffness of a penalty wall is inf, expected a finite number > 0");
#undef REFUSED
}

static void random_walls_are_accepted(void **state)
{
    (void)state;
    dice d = {8};
    for (int trial = 0; trial < 5000; ++trial) {
        wall_recipe recipe;
        random_wall(&recipe, &d, dice_point(&d, (fw_vec2){0, 0}, 1e4), dice_scale(&d, -1, 3), 1);
        fw_wall_destroy(made(&recipe.def));
    }
    /* A corner of 180 degrees, here one that rounding cannot represent, is none. */
    const fw_vec2 flat[] = {{0, 0}, {0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}, {-1, 1}};
    fw_wall_def def = fw_wall_def_default();
    def.shape = FW_POLYGON;
    def.points = flat;
    def.point_count = 5;
    fw_wall_destroy(made(&def));
    fw_wall_destroy(NULL);
}

static void wall_keeps_a_copy_of_its_definition(void **state)
{
    (void)state;
    char name[] = "piston";
    fw_vec2 points[] = {{5, 6}, {1, 2}};
    fw_wall_def def = fw_wall_def_default();
    def.name = name;
    def.points = points;
    def.surface = (fw_surface){.law = FW_COULOMB, .friction = 0.3};
    fw_wall *wall = made(&def);
    memset(name, 'x', 3);
    points[0] = points[1] = (fw_vec2){9, 9};
    assert_string_equal(fw_wall_name(wall), "piston");
    assert_close(fw_wall_definition(wall)->points[1].y, 2, 0);
    assert_close(fw_wall_surface(wall).friction, 0.3, 0);
    fw_box bounds = fw_wall_bounds(wall);
    assert_close(bounds.low.x, 1, 0);
    assert_close(bounds.low.y, 2, 0);
    assert_close(bounds.high.x, 5, 0);
    assert_close(bounds.high.y, 6, 0);
    fw_wall_destroy(wall);
}

/* In front of and behind a spike, a pit, and both faces of a blade at many angles. */
static void chains_have_a_back(void **state)
{
    (void)state;
    const fw_vec2 spike[] = {{-1, 0}, {0, 2}, {1, 0}}, pit[] = {{-1, 2}, {0, 0}, {1, 2}};
    fw_wall_def def = fw_wall_def_default();
    fw_wall *wall;
    def.name = "chain";
    def.shape = FW_CHAIN;
    def.points = spike;
    def.point_count = 3;
    assert_int_equal(fw_wall_create(&wall, 0, &def, NULL), FW_OK);
    assert_true(fw_wall_depth(wall, (fw_vec2){0, 2.5}, (fw_vec2){0, 0}) == 0);
    assert_true(fw_wall_depth(wall, (fw_vec2){1.5, 2.1}, (fw_vec2){0, 0}) == 0);
    assert_close(fw_wall_depth(wall, (fw_vec2){0, 1}, (fw_vec2){0, 0}), 1 / sqrt(5), 1e-15);
    assert_true(fw_wall_depth(wall, (fw_vec2){3, -1}, (fw_vec2){0, 0}) == 0);
    /* Behind the line of the last or first piece, but beyond its open end. */
    assert_true(fw_wall_depth(wall, (fw_vec2){1.2, -1}, (fw_vec2){0, 0}) == 0);
    assert_true(fw_wall_depth(wall, (fw_vec2){-1.2, -1}, (fw_vec2){0, 0}) == 0);
    assert_close(fw_wall_depth(wall, (fw_vec2){.8, .1}, (fw_vec2){0, 0}), .3 / sqrt(5), 1e-15);
    fw_wall_destroy(wall);
    def.points = pit;
    assert_int_equal(fw_wall_create(&wall, 0, &def, NULL), FW_OK);
    assert_true(fw_wall_depth(wall, (fw_vec2){0, 1}, (fw_vec2){0, 0}) == 0);
    assert_close(fw_wall_depth(wall, (fw_vec2){0, -0.5}, (fw_vec2){0, 0}), 0.5, 1e-15);
    assert_close(fw_wall_depth(wall, (fw_vec2){0.2, -0.5}, (fw_vec2){0, 0}), hypot(0.2, 0.5),
                 1e-15);
    fw_wall_destroy(wall);
    for (int n = 0; n < 100; ++n) {
        double angle = 0.063 * n, c = cos(angle), s = sin(angle);
        const fw_vec2 blade[] = {{7, 3}, {7 + 5 * c, 3 + 5 * s}};
        def.points = blade;
        def.point_count = 2;
        def.closed = true;
        assert_int_equal(fw_wall_create(&wall, 0, &def, NULL), FW_OK);
        for (int side = -1; side <= 1; side += 2) {
            fw_vec2 beside = {7 + 2 * c - 0.1 * side * s, 3 + 2 * s + 0.1 * side * c};
            assert_true(fw_wall_depth(wall, beside, (fw_vec2){0, 0}) == 0);
            assert_true(fw_wall_depth(wall, (fw_vec2){7 - c, 3 - s}, (fw_vec2){0, 0}) == 0);
        }
        fw_wall_destroy(wall);
    }
}

/* What has no name is told without one, and has an empty one. */
static void walls_need_no_name(void **state)
{
    (void)state;
    const fw_vec2 points[] = {{0, 0}, {3, 0}};
    fw_wall_def def = fw_wall_def_default();
    def.name = NULL;
    fw_wall *wall = made(&def);
    assert_string_equal(fw_wall_name(wall), "");
    fw_wall_destroy(wall);
    def.points = points;
    assert_refused(&def, "wall '': the box from [0, 0] to [3, 0] is empty, expected corners that "
                         "differ in x and in y");
    def.point_count = 1;
    assert_refused(&def, "wall '': a box of 1 point, expected two opposite corners");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_need_no_name),
        cmocka_unit_test(polygon_is_the_same_in_either_sense),
        cmocka_unit_test(resting_wall_has_no_displacement_at_all),
        cmocka_unit_test(wall_follows_its_path),
        cmocka_unit_test(velocity_is_the_slope_of_the_path),
        cmocka_unit_test(senseless_shapes_are_refused_with_a_sentence),
        cmocka_unit_test(senseless_numbers_are_refused_with_a_sentence),
        cmocka_unit_test(random_walls_are_accepted),
        cmocka_unit_test(wall_keeps_a_copy_of_its_definition),
        cmocka_unit_test(chains_have_a_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
