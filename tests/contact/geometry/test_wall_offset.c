/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_wall_offset.c - walls that keep a distance: each corner where both of its faces, moved along
 * their normals, cross; by hand. */
#include "tests/support/laws.h"

#include "contact/geometry/wall_offset.h"

#include <string.h>

enum { MOST = 5 };

typedef struct shape {
    fw_wall_shape_kind kind;
    fw_side side;
    bool closed;
    double distance;
    int count;
    fw_vec2 points[MOST], expected[MOST];
} shape;

static fw_wall_def def_of(const shape *s)
{
    fw_wall_def def = fw_wall_def_default();
    def.name = "w";
    def.shape = s->kind;
    def.side = s->side;
    def.closed = s->closed;
    def.points = s->points;
    def.point_count = s->count;
    return def;
}

static void corners_lie_where_moved_faces_cross(void **state)
{
    (void)state;
    static const shape shapes[] = {
        {FW_BOX, FW_OUTSIDE, false, .5, 2, {{0, 1}, {4, 3}}, {{-.5, .5}, {4.5, 3.5}}},
        {FW_BOX, FW_INSIDE, false, .5, 2, {{0, 1}, {4, 3}}, {{.5, 1.5}, {3.5, 2.5}}},
        {FW_BOX, FW_OUTSIDE, false, .5, 2, {{4, 1}, {0, 3}}, {{4.5, .5}, {-.5, 3.5}}},
        {FW_BOX, FW_INSIDE, false, .5, 2, {{4, 3}, {0, 1}}, {{3.5, 2.5}, {.5, 1.5}}},
        /* The slanted side is 3x + 4y = 12, and moves to 17 or to 9.5. */
        {FW_POLYGON,
         FW_OUTSIDE,
         false,
         1,
         3,
         {{0, 0}, {4, 0}, {0, 3}},
         {{-1, -1}, {7, -1}, {-1, 5}}},
        {FW_POLYGON,
         FW_OUTSIDE,
         false,
         1,
         3,
         {{0, 3}, {4, 0}, {0, 0}},
         {{-1, 5}, {7, -1}, {-1, -1}}},
        {FW_POLYGON,
         FW_INSIDE,
         false,
         .5,
         3,
         {{0, 0}, {4, 0}, {0, 3}},
         {{.5, .5}, {2.5, .5}, {.5, 2}}},
        {FW_POLYGON,
         FW_INSIDE,
         false,
         .5,
         3,
         {{0, 3}, {4, 0}, {0, 0}},
         {{.5, 2}, {2.5, .5}, {.5, .5}}},
        /* Free to the left: into a corner and out of one; ends go straight. */
        {FW_CHAIN,
         FW_INSIDE,
         false,
         1,
         4,
         {{0, 0}, {4, 0}, {4, 3}, {9, 3}},
         {{0, 1}, {3, 1}, {3, 4}, {9, 4}}},
        {FW_CHAIN, FW_INSIDE, false, 1, 3, {{4, 3}, {4, 0}, {0, 0}}, {{5, 3}, {5, -1}, {0, -1}}},
        {FW_CHAIN, FW_INSIDE, true, 1, 3, {{0, 0}, {0, 3}, {4, 0}}, {{-1, -1}, {-1, 5}, {7, -1}}},
    };
    /* In every quarter of the plane. */
    static const fw_vec2 places[] = {{0, 0}, {30, 50}, {-30, 50}, {30, -50}, {-30, -50}};
    for (size_t n = 0; n < sizeof shapes / sizeof *shapes; ++n)
        for (size_t p = 0; p < sizeof places / sizeof *places; ++p) {
            shape there = shapes[n];
            for (int k = 0; k < there.count; ++k)
                there.points[k] = fw_vec2_add(there.points[k], places[p]);
            const fw_wall_def def = def_of(&there);
            fw_wall_def moved;
            fw_vec2 points[MOST];
            fw_error error;
            assert_int_equal(fw_wall_offset(&def, there.distance, points, &moved, &error), FW_OK);
            assert_ptr_equal(moved.points, points);
            for (int k = 0; k < there.count; ++k) {
                assert_close(points[k].x, places[p].x + there.expected[k].x, 3e-14);
                assert_close(points[k].y, places[p].y + there.expected[k].y, 3e-14);
            }
        }
}

static void circles_grow_outside_and_shrink_inside(void **state)
{
    (void)state;
    for (int outside = 0; outside < 2; ++outside) {
        const shape circle = {FW_CIRCLE, outside ? FW_OUTSIDE : FW_INSIDE, false, 1, 1, {{5, 6}},
                              {{5, 6}}};
        fw_wall_def def = def_of(&circle), moved;
        fw_vec2 points[MOST];
        fw_error error;
        def.radius = 3;
        assert_int_equal(fw_wall_offset(&def, 1, points, &moved, &error), FW_OK);
        assert_close(moved.radius, outside ? 4 : 2, 0);
        assert_close(points[0].x, 5, 0);
        assert_close(points[0].y, 6, 0);
        assert_int_equal(fw_wall_offset(&def, 3, points, &moved, &error),
                         outside ? FW_OK : FW_BAD_INPUT);
    }
}

/* Half the width is as far as it goes; and a chain that turns back has no side to go to. */
static void walls_of_which_nothing_is_left_are_refused(void **state)
{
    (void)state;
    static const shape shapes[] = {
        {FW_BOX, FW_INSIDE, false, 1, 2, {{0, 1}, {4, 3}}, {{0, 0}}},
        {FW_POLYGON, FW_INSIDE, false, 1, 3, {{0, 0}, {4, 0}, {0, 3}}, {{0, 0}}},
        {FW_CHAIN, FW_INSIDE, false, 2, 4, {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {{0, 0}}},
        {FW_CHAIN, FW_INSIDE, false, .1, 3, {{0, 0}, {4, 0}, {1, 0}}, {{0, 0}}},
    };
    for (size_t n = 0; n < sizeof shapes / sizeof *shapes; ++n) {
        const fw_wall_def def = def_of(&shapes[n]);
        fw_wall_def moved;
        fw_vec2 points[MOST];
        fw_error error;
        assert_int_equal(fw_wall_offset(&def, shapes[n].distance, points, &moved, &error),
                         FW_BAD_INPUT);
        assert_non_null(strstr(error.sentence, "wall w is too small for a contact distance of "));
        if (n == 3) continue;
        assert_int_equal(fw_wall_offset(&def, 0.9 * shapes[n].distance, points, &moved, &error),
                         n == 2 ? FW_BAD_INPUT : FW_OK);
        assert_int_equal(fw_wall_offset(&def, 0.7 * shapes[n].distance, points, &moved, &error),
                         FW_OK);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_lie_where_moved_faces_cross),
        cmocka_unit_test(circles_grow_outside_and_shrink_inside),
        cmocka_unit_test(walls_of_which_nothing_is_left_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
