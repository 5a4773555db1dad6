/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Facets: exact gaps, and no way through, least of all at corners. */
#include "tests/support/laws.h"

#include "contact/geometry/wall.h"
#include "tests/support/random_walls.h"

#include <float.h>

static fw_wall *made(const fw_wall_def *def)
{
    fw_wall *wall;
    fw_error error;
    if (fw_wall_create(&wall, 0, def, &error) != FW_OK) fail_msg("%s", error.sentence);
    return wall;
}

static bool is_barred(const fw_wall *wall, fw_vec2 point, fw_vec2 displacement)
{
    for (int i = 0; i < fw_wall_facet_count(wall); ++i)
        if (fw_facet_is_passed(fw_wall_facet(wall, i), point, displacement, 0)) return true;
    return false;
}

static fw_wall *box_between(fw_vec2 low, fw_vec2 high, fw_side side)
{
    const fw_vec2 corners[] = {low, high};
    fw_wall_def def = fw_wall_def_default();
    def.points = corners;
    def.side = side;
    return made(&def);
}

static fw_wall *circle_at(fw_vec2 centre, double radius, fw_side side)
{
    fw_wall_def def = fw_wall_def_default();
    def.shape = FW_CIRCLE;
    def.points = &centre;
    def.point_count = 1;
    def.radius = radius;
    def.side = side;
    return made(&def);
}

static fw_wall *chain_of(const fw_vec2 *points, int count)
{
    fw_wall_def def = fw_wall_def_default();
    def.shape = FW_CHAIN;
    def.points = points;
    def.point_count = count;
    return made(&def);
}

static void gap_to_a_box_is_one_subtraction(void **state)
{
    (void)state;
    dice d = {1};
    for (int trial = 0; trial < 20000; ++trial) {
        double offset = trial % 2 ? 1e4 : 0;
        fw_vec2 low = dice_point(&d, (fw_vec2){offset, -offset}, 10);
        fw_vec2 high = {low.x + dice_between(&d, 1, 60), low.y + dice_between(&d, 1, 60)};
        fw_wall *in = box_between(low, high, FW_INSIDE), *out = box_between(high, low, FW_OUTSIDE);
        fw_vec2 p = dice_point(&d, low, 70);
        const double expected[] = {p.y - low.y, high.x - p.x, high.y - p.y, p.x - low.x};
        for (int i = 0; i < 4; ++i) {
            assert_close(fw_facet_gap(fw_wall_facet(in, i), p), expected[i], 0);
            assert_close(fw_facet_gap(fw_wall_facet(out, i), p), -expected[i], 0);
        }
        fw_wall_destroy(in);
        fw_wall_destroy(out);
    }
}

/* The least step across a side is seen, and one that ends exactly on it is not barred. */
static void box_bars_from_the_last_bit_on(void **state)
{
    (void)state;
    fw_wall *box = box_between((fw_vec2){1e4, 1e4}, (fw_vec2){1e4 + 60, 1e4 + 60}, FW_INSIDE);
    const double just_below = nextafter(1e4, 0);
    fw_vec2 start = {1e4 + 0.375, 1e4 + 7};
    assert_false(is_barred(box, start, (fw_vec2){-0.375, 0.1}));
    assert_true(is_barred(box, start, (fw_vec2){just_below - start.x, 0.1}));
    /* On the side already: any way in is barred, along it or back is not. */
    start.x = 1e4;
    assert_true(is_barred(box, start, (fw_vec2){just_below - 1e4, 1}));
    assert_false(is_barred(box, start, (fw_vec2){0, 1}));
    assert_false(is_barred(box, start, (fw_vec2){1e-3, 1}));
    fw_wall_destroy(box);
}

/* Any direction leads out of a circle from its centre: one is chosen. */
static void normals_of_a_circle_are_of_unit_length(void **state)
{
    (void)state;
    for (int side = 0; side < 2; ++side) {
        fw_wall *wall = circle_at((fw_vec2){7, 8}, 5, (fw_side)side);
        const fw_facet *facet = fw_wall_facet(wall, 0);
        const double out = side == FW_INSIDE ? -1 : 1;
        const fw_vec2 normal = fw_facet_normal(facet, (fw_vec2){-3, 4}),
                      middle = fw_facet_normal(facet, (fw_vec2){0, 0});
        assert_close(normal.x, -0.6 * out, 1e-15);
        assert_close(normal.y, 0.8 * out, 1e-15);
        assert_close(middle.x, 1, 0);
        assert_close(middle.y, 0, 0);
        fw_wall_destroy(wall);
    }
}

/* n . (r - a) with a unit normal rounded to eps: a few eps of the distance and the coordinates. */
static void gap_to_a_slanting_side_is_its_distance(void **state)
{
    (void)state;
    dice d = {2};
    for (int trial = 0; trial < 20000; ++trial) {
        fw_vec2 centre = dice_point(&d, (fw_vec2){0, 0}, 1e4);
        fw_vec2 ends[] = {dice_point(&d, centre, 50), dice_point(&d, centre, 50)};
        fw_wall *wall = chain_of(ends, 2);
        const fw_facet *facet = fw_wall_facet(wall, 0);
        double along = dice_between(&d, -1, 2), away = dice_between(&d, -20, 20);
        fw_vec2 p = fw_vec2_add(ends[0], fw_vec2_scale(along, fw_vec2_subtract(ends[1], ends[0])));
        p = fw_vec2_add(p, fw_vec2_scale(away, facet->normal));
        assert_close(fw_facet_gap(facet, p), away, 8 * DBL_EPSILON * 1e4);
        /* Free to the left, walking from the first point to the last. */
        assert_true(fw_vec2_cross(fw_vec2_subtract(ends[1], ends[0]), facet->normal) > 0);
        fw_wall_destroy(wall);
    }
}

static void gap_to_a_circle_is_measured_along_the_radius(void **state)
{
    (void)state;
    fw_vec2 centre = {1e4, -1e4};
    fw_wall *in = circle_at(centre, 5, FW_INSIDE), *out = circle_at(centre, 5, FW_OUTSIDE);
    fw_vec2 p = {centre.x + 3 * 0.75, centre.y + 4 * 0.75};
    assert_close(fw_facet_gap(fw_wall_facet(in, 0), p), 1.25, 0);
    assert_close(fw_facet_gap(fw_wall_facet(out, 0), p), -1.25, 0);
    assert_close(fw_wall_depth(in, p, (fw_vec2){0, 0}), 0, 0);
    assert_close(fw_wall_depth(out, p, (fw_vec2){0, 0}), 1.25, 0);
    fw_wall_destroy(in);
    fw_wall_destroy(out);
}

static void chain_bars_from_its_left_only(void **state)
{
    (void)state;
    const fw_vec2 points[] = {{0, 0}, {10, 0}, {10, 10}};
    fw_wall *chain = chain_of(points, 3);
    assert_true(is_barred(chain, (fw_vec2){4, 1}, (fw_vec2){0, -2}));
    assert_false(is_barred(chain, (fw_vec2){4, -1}, (fw_vec2){0, 2}));
    /* From behind, deeper: not held either. */
    assert_false(is_barred(chain, (fw_vec2){4, -1}, (fw_vec2){0, -2}));
    /* Past either end. */
    assert_false(is_barred(chain, (fw_vec2){-1e-6, 1}, (fw_vec2){0, -2}));
    assert_false(is_barred(chain, (fw_vec2){9, 10 + 1e-6}, (fw_vec2){5, 0}));
    /* The ends belong to it. */
    assert_true(is_barred(chain, (fw_vec2){0, 1}, (fw_vec2){0, -2}));
    assert_true(is_barred(chain, (fw_vec2){9, 10}, (fw_vec2){5, 0}));
    fw_wall_destroy(chain);
}

static void closed_chain_of_two_points_bars_from_both_sides(void **state)
{
    (void)state;
    const fw_vec2 points[] = {{0, 0}, {10, 3}};
    fw_wall_def def = fw_wall_def_default();
    def.shape = FW_CHAIN;
    def.points = points;
    def.point_count = 2;
    def.closed = true;
    fw_wall *blade = made(&def);
    assert_int_equal(fw_wall_facet_count(blade), 2);
    assert_true(is_barred(blade, (fw_vec2){5, 3}, (fw_vec2){0, -4}));
    assert_true(is_barred(blade, (fw_vec2){5, -1}, (fw_vec2){0, 4}));
    fw_wall_destroy(blade);
}

static void nothing_is_too_fast_for_a_thin_body(void **state)
{
    (void)state;
    fw_wall *sheet = box_between((fw_vec2){0, 0}, (fw_vec2){1e-3, 10}, FW_OUTSIDE);
    fw_wall *needle = circle_at((fw_vec2){0, 5}, 1e-3, FW_OUTSIDE);
    dice d = {3};
    for (int trial = 0; trial < 100000; ++trial) {
        fw_vec2 target = {0, 5}, way = dice_direction(&d);
        fw_vec2 start = fw_vec2_add(target, fw_vec2_scale(dice_scale(&d, -2, 3), way));
        fw_vec2 step = fw_vec2_scale(-dice_scale(&d, 0.1, 3), fw_vec2_subtract(start, target));
        assert_true(is_barred(needle, start, step));
        if (start.x < 0 || start.x > 1e-3) assert_true(is_barred(sheet, start, step));
    }
    /* Close misses are free. */
    assert_false(is_barred(needle, (fw_vec2){-100, 5.00101}, (fw_vec2){200, 0}));
    assert_false(is_barred(sheet, (fw_vec2){-100, 10.00001}, (fw_vec2){200, 0}));
    fw_wall_destroy(sheet);
    fw_wall_destroy(needle);
}

/* One path near a corner or anywhere. A particle that starts free and ends barred must have been
 * stopped by a facet, else it leaks. Returns whether it was such a path. */
static bool path_is_watched(const fw_wall *wall, fw_vec2 start, fw_vec2 step)
{
    if (fw_wall_depth(wall, start, (fw_vec2){0, 0}) > 0) return false;
    fw_vec2 end = fw_vec2_add(start, step);
    if (fw_wall_depth(wall, end, (fw_vec2){0, 0}) == 0) return false;
    if (!is_barred(wall, start, step))
        fail_msg("leak from [%.17g, %.17g] by [%.17g, %.17g]", start.x, start.y, step.x, step.y);
    return true;
}

/* Convex corners (outside) and reflex ones (inside) at all angles and sizes, and paths that aim at
 * them from 1e-13 to 10 away, so that start, crossing and end come within rounding of the corner.
 */
static void corners_do_not_leak(void **state)
{
    (void)state;
    dice d = {4};
    long watched = 0;
    for (int shape = 0; shape < 1500; ++shape) {
        wall_recipe recipe;
        fw_vec2 centre = dice_point(&d, (fw_vec2){0, 0}, shape % 3 ? 1e4 : 10);
        random_wall(&recipe, &d, centre, 10, 0);
        if (recipe.def.shape == FW_CHAIN) continue;
        fw_wall *wall = made(&recipe.def);
        for (int trial = 0; trial < 3000; ++trial) {
            const fw_facet *facet = fw_wall_facet(wall, dice_below(&d, fw_wall_facet_count(wall)));
            fw_vec2 target = facet->a;
            if (facet->kind == FW_ROUND)
                target = fw_vec2_add(target, fw_vec2_scale(facet->length, dice_direction(&d)));
            fw_vec2 start =
                fw_vec2_add(target, fw_vec2_scale(dice_scale(&d, -13, 1), dice_direction(&d)));
            fw_vec2 end =
                fw_vec2_add(target, fw_vec2_scale(dice_scale(&d, -13, 1), dice_direction(&d)));
            if (trial % 8 == 0) start = target;
            if (trial % 8 == 1) /* straight at the corner */
                end = fw_vec2_add(
                    target, fw_vec2_scale(dice_between(&d, 0, 2), fw_vec2_subtract(target, start)));
            watched += path_is_watched(wall, start, fw_vec2_subtract(end, start));
        }
        fw_wall_destroy(wall);
    }
    assert_true(watched > 500000);
}

/* Is a point inside a closed curve? By the number of sides to its right, in long double:
 * nothing in common with facets. */
static bool is_enclosed(const fw_vec2 *corners, int count, fw_vec2 point)
{
    bool enclosed = false;
    for (int i = 0; i < count; ++i) {
        fw_vec2 p = corners[i], q = corners[(i + 1) % count];
        if ((p.y > point.y) == (q.y > point.y)) continue;
        long double height = ((long double)point.y - p.y) / ((long double)q.y - p.y);
        enclosed ^= p.x + height * ((long double)q.x - p.x) > point.x;
    }
    return enclosed;
}

/* A star has convex and reflex corners in turn. A path from inside to outside must be stopped, all
 * the more where it runs through a corner. Which side a point within rounding of the curve is on
 * nobody knows, so ends keep a distance of 1e-11 (6 roundings of 1e4) from the corner aimed at. */
static void stars_do_not_leak(void **state)
{
    (void)state;
    dice d = {9};
    long watched = 0;
    for (int shape = 0; shape < 500; ++shape) {
        enum { CORNERS = 10 };
        fw_vec2 corners[CORNERS], centre = dice_point(&d, (fw_vec2){0, 0}, 1e4);
        bool outward = shape % 2;
        for (int i = 0; i < CORNERS; ++i) {
            double angle = 0.6283185307179586 * (i + dice_between(&d, 0, 0.9));
            double radius = i % 2 ? dice_between(&d, 0.5, 3) : dice_between(&d, 3, 9);
            corners[outward ? CORNERS - 1 - i : i] =
                (fw_vec2){centre.x + radius * cos(angle), centre.y + radius * sin(angle)};
        }
        fw_wall_def def = fw_wall_def_default();
        def.shape = FW_CHAIN;
        def.points = corners;
        def.point_count = CORNERS;
        def.closed = true;
        fw_wall *wall = made(&def);
        for (int trial = 0; trial < 2000; ++trial) {
            fw_vec2 target = corners[dice_below(&d, CORNERS)], way = dice_direction(&d);
            double before = -dice_scale(&d, -11, 0.5), after = dice_scale(&d, -11, 0.5);
            fw_vec2 start = fw_vec2_add(target, fw_vec2_scale(before, way));
            if (trial % 2) way = dice_direction(&d);
            fw_vec2 end = fw_vec2_add(target, fw_vec2_scale(after, way));
            if (is_enclosed(corners, CORNERS, start) == outward ||
                is_enclosed(corners, CORNERS, end) != outward)
                continue;
            watched += 1;
            if (!is_barred(wall, start, fw_vec2_subtract(end, start)))
                fail_msg("leak from [%.17g, %.17g] to [%.17g, %.17g]", start.x, start.y, end.x,
                         end.y);
        }
        fw_wall_destroy(wall);
    }
    assert_true(watched > 100000);
}

/* What contact does with one particle: what a facet bars is taken away along its normal; where that
 * passes another facet, too, it rests. A facet that holds already is not asked again. */
static fw_vec2 held(const fw_wall *wall, fw_vec2 point, fw_vec2 step)
{
    int holder = -1;
    for (int i = 0; i < fw_wall_facet_count(wall); ++i) {
        const fw_facet *facet = fw_wall_facet(wall, i);
        if (i == holder || !fw_facet_is_passed(facet, point, step, 0)) continue;
        if (holder >= 0) return (fw_vec2){0, 0};
        step =
            fw_vec2_subtract(step, fw_vec2_scale(fw_vec2_dot(step, facet->normal), facet->normal));
        holder = i;
        i = -1;
    }
    return step;
}

/* Sliding along a slanting wall moves a particle by rounding errors to either side of it. It must
 * stay barred however long that goes on: depths stay below the tolerance, far from a real one. */
static void slanting_walls_hold_for_ever(void **state)
{
    (void)state;
    dice d = {5};
    double deepest = 0;
    for (int shape = 0; shape < 12; ++shape) {
        wall_recipe recipe = {.def = fw_wall_def_default()};
        fw_vec2 centre = dice_point(&d, (fw_vec2){0, 0}, 1e4);
        random_polygon(&recipe, &d, centre, 3);
        recipe.def.shape = FW_POLYGON;
        recipe.def.points = recipe.points;
        recipe.def.side = shape % 2 ? FW_OUTSIDE : FW_INSIDE;
        fw_wall *wall = made(&recipe.def);
        /* From the middle of a side, as near to it as rounding allows. */
        const fw_facet *first = fw_wall_facet(wall, 0);
        fw_vec2 point = fw_vec2_scale(0.5, fw_vec2_add(first->a, first->b));
        double tolerance = fw_facet_tolerance(fw_wall_facet(wall, 0), 0);
        for (int step = 0; step < 100000; ++step) {
            /* Pressed towards the wall, and jostled along it. */
            fw_vec2 pull = fw_vec2_subtract(centre, point);
            double sign = recipe.def.side == FW_OUTSIDE ? 0.05 : -0.05;
            fw_vec2 wish = dice_point(&d, fw_vec2_scale(sign, pull), 0.1);
            point = fw_vec2_add(point, held(wall, point, wish));
            double depth = fw_wall_depth(wall, point, (fw_vec2){0, 0});
            assert_below(depth, tolerance);
            deepest = fmax(deepest, depth);
        }
        fw_wall_destroy(wall);
    }

    assert_true(deepest > 0); /* rounding was at work */
}

static void box_without_a_facet_is_never_passed_in(void **state)
{
    (void)state;
    dice d = {7};
    int passed = 0, spared = 0;
    for (int trial = 0; trial < 200000; ++trial) {
        wall_recipe recipe;
        fw_vec2 centre = dice_point(&d, (fw_vec2){0, 0}, trial % 2 ? 1e4 : 10);
        random_wall(&recipe, &d, centre, 5, 0);
        fw_wall *wall = made(&recipe.def);
        fw_vec2 start = dice_point(&d, centre, 6);
        fw_vec2 step = dice_point(&d, (fw_vec2){0, 0}, dice_scale(&d, -3, 1));
        fw_vec2 end = fw_vec2_add(start, step);
        fw_box box = {{fmin(start.x, end.x), fmin(start.y, end.y)},
                      {fmax(start.x, end.x), fmax(start.y, end.y)}};
        for (int i = 0; i < fw_wall_facet_count(wall); ++i) {
            const fw_facet *facet = fw_wall_facet(wall, i);
            bool met = fw_facet_meets_box(facet, box, 0);
            if (fw_facet_is_passed(facet, start, step, 0)) {
                assert_true(met);
                passed += 1;
            }
            spared += !met;
        }
        fw_wall_destroy(wall);
    }
    assert_true(passed > 5000 && spared > 100000);
}

/* Wherever a number that is none stands, the box is that of the others. */
static void boxes_leave_out_what_is_no_number(void **state)
{
    (void)state;
    const fw_box box = {{-1, 2}, {3, 4}};
    const fw_vec2 none[] = {{NAN, 3}, {0, NAN}, {NAN, NAN}};
    for (int n = 0; n < 3; ++n) {
        const fw_box at = {none[n], none[n]};
        const fw_box first = fw_box_joined(at, box), last = fw_box_joined(box, at);
        assert_memory_equal(&first, &box, sizeof box);
        assert_memory_equal(&last, &box, sizeof box);
    }
    const fw_box around = fw_box_around((fw_vec2){3, 2}, (fw_vec2){-1, 4});
    assert_memory_equal(&around, &box, sizeof box);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_of_a_circle_are_of_unit_length),
        cmocka_unit_test(gap_to_a_box_is_one_subtraction),
        cmocka_unit_test(box_bars_from_the_last_bit_on),
        cmocka_unit_test(gap_to_a_slanting_side_is_its_distance),
        cmocka_unit_test(gap_to_a_circle_is_measured_along_the_radius),
        cmocka_unit_test(chain_bars_from_its_left_only),
        cmocka_unit_test(closed_chain_of_two_points_bars_from_both_sides),
        cmocka_unit_test(nothing_is_too_fast_for_a_thin_body),
        cmocka_unit_test(corners_do_not_leak),
        cmocka_unit_test(stars_do_not_leak),
        cmocka_unit_test(slanting_walls_hold_for_ever),
        cmocka_unit_test(box_without_a_facet_is_never_passed_in),
        cmocka_unit_test(boxes_leave_out_what_is_no_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
