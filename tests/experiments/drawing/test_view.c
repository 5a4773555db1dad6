/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_view.c - how much of the walls a frame shows beside the bodies. */
#include "tests/support/laws.h"

#include "experiments/drawing/view.h"

/* A body of 20 x 10 with its lower left corner at (0, 0), in a box. */
static fw_view_bounds frame_of(fw_vec2 low, fw_vec2 high)
{
    const double x[] = {0, 20}, y[] = {0, 10};
    const fw_vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    const fw_outline box = {.points = corners, .count = 4, .closed = true};
    const fw_view_body body = {.count = 2, .x = x, .y = y, .spacing = 1};
    const fw_view views[] = {{.bodies = &body, .body_count = 1, .walls = &box, .wall_count = 1},
                             {.bodies = &body, .body_count = 1, .walls = &box, .wall_count = 1}};
    fw_view_bounds bounds = fw_view_bounds_empty();
    fw_view_bounds_include_bodies(&bounds, views);
    fw_view_bounds_include_walls(&bounds, views, 2);
    return bounds;
}

static void expect_frame(fw_view_bounds frame, fw_vec2 low, fw_vec2 high)
{
    assert_close(frame.x.low, low.x, 1e-12);
    assert_close(frame.x.high, high.x, 1e-12);
    assert_close(frame.y.low, low.y, 1e-12);
    assert_close(frame.y.high, high.y, 1e-12);
}

static void a_box_up_to_three_bodies_long_is_shown_in_full(void **state)
{
    (void)state;
    expect_frame(frame_of((fw_vec2){-4, -5}, (fw_vec2){60, 50}), (fw_vec2){-4, -5},
                 (fw_vec2){60, 50});
}

/* The bodies end at -.75 and 20.75, 10.75: the frame goes a fifth of 21.5 beyond. */
static void a_far_larger_box_is_cut_and_its_near_edges_show(void **state)
{
    (void)state;
    expect_frame(frame_of((fw_vec2){-100, -2}, (fw_vec2){200, 500}), (fw_vec2){-5.05, -2},
                 (fw_vec2){25.05, 15.05});
}

/* A floor under the body, far wider and deeper than it. */
static void of_what_lies_beside_the_bodies_the_near_edge_shows(void **state)
{
    (void)state;
    expect_frame(frame_of((fw_vec2){-100, -300}, (fw_vec2){200, -7}), (fw_vec2){-5.05, -11.3},
                 (fw_vec2){25.05, 10.75});
    /* And nothing where even that is too far away. */
    expect_frame(frame_of((fw_vec2){-1, -300}, (fw_vec2){21, -70}), (fw_vec2){-1, -.75},
                 (fw_vec2){21, 10.75});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_up_to_three_bodies_long_is_shown_in_full),
        cmocka_unit_test(a_far_larger_box_is_cut_and_its_near_edges_show),
        cmocka_unit_test(of_what_lies_beside_the_bodies_the_near_edge_shows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
