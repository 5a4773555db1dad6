/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tree of walls: nothing is missed, and the answer depends on nothing but the places. */
#include "tests/support/laws.h"

#include "contact/search/broadphase.h"
#include "tests/support/random_walls.h"

static fw_box random_box(dice *d, fw_vec2 middle, double size)
{
    fw_vec2 low = dice_point(d, middle, size);
    double width = size * dice_scale(d, -5, 0.3), height = size * dice_scale(d, -5, 0.3);
    return (fw_box){low, {low.x + width, low.y + height}};
}

/* Resting walls: the answer is exactly the facets that meet the box, found by looking at all. */
static void query_finds_what_a_look_at_all_facets_finds(void **state)
{
    (void)state;
    dice d = {1};
    long found = 0;
    for (int scene = 0; scene < 2000; ++scene) {
        double size = dice_scale(&d, -1, 3);
        fw_vec2 middle = dice_point(&d, (fw_vec2){0, 0}, 1e4);
        stage s;
        set_stage(&s, &d, middle, size, 0);
        for (int trial = 0; trial < 40; ++trial) {
            fw_box box = random_box(&d, middle, 1.5 * size);
            if (trial % 4 == 0) { /* a box that only touches: within float rounding of a facet */
                const fw_facet *facet =
                    fw_broadphase_facet(s.broadphase, dice_below(&d, s.facet_count));
                fw_vec2 shift = fw_vec2_subtract(fw_facet_bounds(facet).high, box.low);
                box = (fw_box){fw_vec2_add(box.low, shift), fw_vec2_add(box.high, shift)};
            }
            int list[LIST], expected[LIST], expected_count = 0;
            for (int i = 0; i < s.facet_count; ++i)
                if (fw_facet_meets_box(fw_broadphase_facet(s.broadphase, i), box, 0))
                    expected[expected_count++] = i;
            assert_int_equal(fw_broadphase_query(s.broadphase, box, list, LIST), expected_count);
            assert_memory_equal(list, expected, (size_t)expected_count * sizeof *list);
            found += expected_count;
        }
        clear_stage(&s);
    }
    assert_true(found > 50000);
}

/* Moving walls: a path through a facet, wherever the wall is in its step, is never missed. In the
 * wall's frame the path is that of the particle minus that of the wall. */
static void moving_walls_are_never_missed(void **state)
{
    (void)state;
    dice d = {2};
    long passed = 0;
    for (int scene = 0; scene < 300; ++scene) {
        double size = dice_scale(&d, 0, 2), speed = dice_scale(&d, -3, 0.5);
        fw_vec2 middle = dice_point(&d, (fw_vec2){0, 0}, 1e4);
        stage s;
        set_stage(&s, &d, middle, size, speed);
        for (int step = 0; step < 60; ++step) {
            fw_vec2 from[WALLS_MAX], to[WALLS_MAX];
            for (int i = 0; i < s.wall_count; ++i) {
                from[i] = fw_wall_displacement(s.walls[i], step);
                to[i] = fw_wall_displacement(s.walls[i], step + 1);
                if (fw_wall_moves(s.walls[i]))
                    fw_broadphase_move_wall(s.broadphase, i, from[i],
                                            fw_vec2_subtract(to[i], from[i]));
            }
            for (int trial = 0; trial < 40; ++trial) {
                fw_vec2 start = dice_point(&d, middle, 1.5 * size);
                fw_vec2 end = fw_vec2_add(
                    start, dice_point(&d, (fw_vec2){0, 0}, size * dice_scale(&d, -4, 0)));
                fw_box box = {{fmin(start.x, end.x), fmin(start.y, end.y)},
                              {fmax(start.x, end.x), fmax(start.y, end.y)}};
                int list[LIST];
                int count = fw_broadphase_query(s.broadphase, box, list, LIST), next = 0;
                for (int i = 0; i < s.facet_count; ++i) {
                    const fw_facet *facet = fw_broadphase_facet(s.broadphase, i);
                    bool listed = next < count && list[next] == i;
                    next += listed;
                    fw_vec2 begin = fw_vec2_subtract(start, from[facet->wall]);
                    fw_vec2 finish = fw_vec2_subtract(end, to[facet->wall]);
                    const double away = fmax(fabs(from[facet->wall].x), fabs(from[facet->wall].y));
                    if (!fw_facet_is_passed(facet, begin, fw_vec2_subtract(finish, begin), away))
                        continue;
                    assert_true(listed);
                    passed += 1;
                }
                assert_int_equal(next, count); /* ascending, none twice */
            }
        }
        clear_stage(&s);
    }
    assert_true(passed > 20000);
}

/* Two broadphases, one with a past: the walls were all over the place before. */
static void answer_does_not_depend_on_the_past(void **state)
{
    (void)state;
    dice d = {3};
    for (int scene = 0; scene < 200; ++scene) {
        double size = dice_scale(&d, 0, 2);
        fw_vec2 middle = dice_point(&d, (fw_vec2){0, 0}, 1e4), none = {0, 0};
        stage s;
        set_stage(&s, &d, middle, size, 0.1);
        fw_broadphase *fresh = broadphase_of(&s);
        for (int move = 0; move < 100; ++move)
            fw_broadphase_move_wall(s.broadphase, dice_below(&d, s.wall_count),
                                    dice_point(&d, none, 3 * size), dice_point(&d, none, size));
        /* Far away and to the same place: both remake their boxes there. */
        for (int i = 0; i < s.wall_count; ++i) {
            fw_vec2 far = {1e3 * size, 0}, place = dice_point(&d, none, size);
            fw_broadphase_move_wall(s.broadphase, i, far, none);
            fw_broadphase_move_wall(s.broadphase, i, place, none);
            fw_broadphase_move_wall(fresh, i, far, none);
            fw_broadphase_move_wall(fresh, i, place, none);
        }
        for (int trial = 0; trial < 50; ++trial) {
            fw_box box = random_box(&d, middle, 2 * size);
            int list[LIST], other[LIST];
            int count = fw_broadphase_query(s.broadphase, box, list, LIST);
            assert_int_equal(fw_broadphase_query(fresh, box, other, LIST), count);
            assert_memory_equal(list, other, (size_t)count * sizeof *list);
        }
        fw_broadphase_destroy(fresh);
        clear_stage(&s);
    }
}

static fw_wall *piston(void)
{
    const fw_vec2 corners[] = {{1e4, 1e4}, {1e4 + 60, 1e4 + 60}};
    fw_wall_def def = fw_wall_def_default();
    def.points = corners;
    def.path.velocity = (fw_vec2){0.05, 0};
    fw_wall *wall;
    assert_int_equal(fw_wall_create(&wall, 0, &def, NULL), FW_OK);
    return wall;
}

static void steady_wall_has_its_boxes_remade_now_and_then_only(void **state)
{
    (void)state;
    fw_wall *wall = piston();
    fw_broadphase *broadphase = fw_broadphase_create(fw_wall_bounds(wall));
    fw_broadphase_add_wall(broadphase, wall);
    const long before = fw_broadphase_generation(broadphase);
    const fw_vec2 none = {0, 0}, sweep = {0.05, 0};
    for (int step = 0; step < 1000; ++step) fw_broadphase_move_wall(broadphase, 0, none, none);
    assert_int_equal(fw_broadphase_generation(broadphase), before);
    assert_close(fw_broadphase_largest_sweep(broadphase), 0, 0);
    for (int step = 0; step < 1600; ++step)
        fw_broadphase_move_wall(broadphase, 0, fw_wall_displacement(wall, step), sweep);
    assert_in_range(fw_broadphase_generation(broadphase) - before, 1, 100);
    assert_close(fw_broadphase_largest_sweep(broadphase), 0.05, 0);
    fw_broadphase_destroy(broadphase);
    fw_wall_destroy(wall);
}

static void short_list_is_told_how_long_it_should_be(void **state)
{
    (void)state;
    fw_wall *wall = piston();
    fw_broadphase *broadphase = fw_broadphase_create(fw_wall_bounds(wall));
    fw_broadphase_add_wall(broadphase, wall);
    const fw_box all = {{-1e300, -INFINITY}, {1e300, INFINITY}};
    int list[4] = {-1, -1, -1, -1};
    assert_int_equal(fw_broadphase_query(broadphase, all, list, 2), 4);
    assert_int_equal(list[2], -1);
    assert_int_equal(fw_broadphase_query(broadphase, all, list, 4), 4);
    for (int i = 0; i < 4; ++i) assert_int_equal(list[i], i);
    assert_int_equal(fw_broadphase_query(broadphase, all, NULL, 0), 4);
    /* The middle of the box is nowhere near a side of it. */
    const fw_box middle = {{1e4 + 1, 1e4 + 1}, {1e4 + 59, 1e4 + 59}};
    assert_int_equal(fw_broadphase_query(broadphase, middle, list, 4), 0);
    fw_broadphase_destroy(broadphase);
    fw_broadphase_destroy(NULL);
    fw_wall_destroy(wall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(query_finds_what_a_look_at_all_facets_finds),
        cmocka_unit_test(moving_walls_are_never_missed),
        cmocka_unit_test(answer_does_not_depend_on_the_past),
        cmocka_unit_test(steady_wall_has_its_boxes_remade_now_and_then_only),
        cmocka_unit_test(short_list_is_told_how_long_it_should_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
