/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_contact_distance.c - bodies that keep a distance: they never come nearer, whatever strikes
 * what, and neither energy nor momentum is lost. */
#include "tests/support/scenes.h"

#include "contact/geometry/wall_offset.h"
#include "core/noise.h"

/* Faces, corners on faces, corners on corners, and what slides round a corner. */
static void nothing_comes_nearer_and_nothing_is_lost(void **state)
{
    (void)state;
    double ticks = 0, unconverged = 0;
    for (uint32_t n = 0; n < 60; ++n) {
        const fw_vec2 a = fw_noise_uniform(3, n, 0, 0), b = fw_noise_uniform(3, n, 1, 0);
        const double distance = 0.25 + 0.2 * a.x;
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 5,
                                       .rows = 5,
                                       .angle = 3 * b.x,
                                       .velocity = {0.15 + 0.1 * b.y, 0.1 * a.x}});
        add_body(scene, (body_options){
                            .columns = 6, .rows = 6, .origin = {11, -3 + 4 * a.y}, .angle = a.x});
        fw_scene_set_distance(scene, distance);
        begin(scene);
        const fw_vec2 momentum = fw_scene_momentum(scene);
        const double energy = energy_of(scene);
        for (int t = 0; t < 160; ++t) {
            run(scene, 1);
            assert_close(fw_scene_body_penetration(scene), 0, 1e-12);
        }
        const fw_vec2 after = fw_scene_momentum(scene);
        assert_close(energy_of(scene), energy, 1e-12 * energy);
        assert_close(after.x, momentum.x, 1e-12);
        assert_close(after.y, momentum.y, 1e-12);
        ticks += fw_scene_contact_ledger(scene)->ticks;
        unconverged += fw_scene_contact_ledger(scene)->unconverged;
        fw_scene_destroy(scene);
    }
    print_message("%g of %g ticks not converged\n", unconverged, ticks);
    assert_true(ticks > 200);
    assert_true(unconverged <= 0.01 * ticks);
}

/* One that hits a face from the side does so .4 before it, up to a step's way; without a distance,
 * at it; of a pair of surfaces, at theirs. */
static void bodies_meet_at_the_distance(void **state)
{
    (void)state;
    for (int kept = 0; kept < 3; ++kept) {
        const double distance = .4 * kept, pairs[] = {.1, .8, .8, .1}; /* of two surfaces */
        const fw_friction none[4] = {{0}};
        fw_scene *scene = empty_scene(1e4);
        add_body(scene, (body_options){.columns = 4, .rows = 4, .velocity = {.05, 0}});
        add_body(scene, (body_options){.columns = 4, .rows = 4, .origin = {5.013, .3}});
        fw_scene_set_distance(scene, distance);
        if (kept == 2) {
            must(fw_scene_set_surfaces(scene, 2, none, (int[]){0, 1}, &error));
            must(fw_scene_set_distances(scene, pairs, &error));
        }
        begin(scene);
        int steps = 0;
        for (; fw_scene_contact_ledger(scene)->ticks == 0 && steps < 100; ++steps) run(scene, 1);
        const double before = 5.013 - 3 - .05 * (steps - 1);
        assert_true(before >= distance && before < distance + .05);
        fw_scene_destroy(scene);
    }
}

static void bodies_that_start_nearer_are_refused(void **state)
{
    (void)state;
    fw_scene *scene = empty_scene(1e4);
    add_body(scene, (body_options){.columns = 4, .rows = 4});
    add_body(scene, (body_options){.columns = 4, .rows = 4, .origin = {3.25, 1.5}});
    fw_scene_set_distance(scene, .5);
    assert_int_equal(fw_scene_begin(scene, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "starts 0.25 from body"));
    fw_scene_destroy(scene);
}

/* --- walls --- */

static double gap_before(const fw_wall_def *def, fw_vec2 at)
{
    fw_wall *wall;
    must(fw_wall_create(&wall, 0, def, &error));
    const double depth = fw_wall_depth(wall, at, (fw_vec2){0, 0});
    fw_wall_destroy(wall);
    return depth;
}

static void walls_move_to_their_free_side(void **state)
{
    (void)state;
    const fw_vec2 box[] = {{0, 0}, {10, 6}}, circle[] = {{5, 5}};
    const fw_vec2 chain[] = {{0, 0}, {4, 0}, {4, 4}}, roof[] = {{0, 0}, {4, 0}, {2, 3}};
    const struct {
        fw_wall_shape_kind shape;
        fw_side side;
        const fw_vec2 *points;
        int count;
        fw_vec2 before; /* nearer to the surface than .5, by .1 */
    } cases[] = {
        {FW_BOX, FW_INSIDE, box, 2, {5, .4}},        {FW_BOX, FW_OUTSIDE, box, 2, {5, -.4}},
        {FW_CIRCLE, FW_INSIDE, circle, 1, {5, 2.4}}, {FW_CIRCLE, FW_OUTSIDE, circle, 1, {5, 1.6}},
        {FW_CHAIN, FW_INSIDE, chain, 3, {2, .4}},    {FW_CHAIN, FW_INSIDE, chain, 3, {3.6, 2}},
        {FW_POLYGON, FW_OUTSIDE, roof, 3, {2, -.4}}, {FW_POLYGON, FW_INSIDE, roof, 3, {2, .4}},
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        fw_vec2 points[4];
        fw_wall_def def = fw_wall_def_default(), moved;
        def.name = "wall";
        def.shape = cases[n].shape;
        def.side = cases[n].side;
        def.points = cases[n].points;
        def.point_count = cases[n].count;
        def.radius = 3;
        assert_close(gap_before(&def, cases[n].before), 0, 0);
        must(fw_wall_offset(&def, .5, points, &moved, &error));
        assert_close(gap_before(&moved, cases[n].before), .1, 1e-12);
        must(fw_wall_offset(&def, 0, points, &moved, &error));
        assert_memory_equal(points, def.points, (size_t)def.point_count * sizeof *points);
    }
}

/* Corners of a shape, and where they go, or that they have no room; a circle's radius. */
static void every_shape_moves_to_its_free_side(void **state)
{
    (void)state;
    const double corner = 0.5 / tan(FW_PI / 8);
    const struct {
        fw_wall_shape_kind shape;
        fw_side side;
        double distance;
        int count;
        bool closed, no_room;
        fw_vec2 points[4], moved[4];
    } shapes[] = {
        {FW_BOX, FW_INSIDE, 0.5, 2, false, false, {{0, 6}, {10, 0}}, {{0.5, 5.5}, {9.5, 0.5}}},
        {FW_BOX, FW_OUTSIDE, 0.5, 2, false, false, {{10, 0}, {0, 6}}, {{10.5, -0.5}, {-0.5, 6.5}}},
        {FW_BOX, FW_INSIDE, 3.5, 2, false, true, {{0, 0}, {10, 6}}, {{0, 0}}},
        {FW_BOX, FW_INSIDE, 3.5, 2, false, true, {{0, 0}, {6, 10}}, {{0, 0}}},
        /* Corners in either sense. */
        {FW_POLYGON,
         FW_INSIDE,
         0.5,
         3,
         false,
         false,
         {{0, 0}, {4, 0}, {0, 4}},
         {{0.5, 0.5}, {4 - corner, 0.5}, {0.5, 4 - corner}}},
        {FW_POLYGON,
         FW_OUTSIDE,
         0.5,
         4,
         false,
         false,
         {{0, 0}, {0, 4}, {4, 4}, {4, 0}},
         {{-0.5, -0.5}, {-0.5, 4.5}, {4.5, 4.5}, {4.5, -0.5}}},
        {FW_POLYGON, FW_INSIDE, 2.5, 4, false, true, {{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {{0, 0}}},
        /* Free to the left of the way along it. */
        {FW_CHAIN,
         FW_OUTSIDE,
         0.5,
         3,
         false,
         false,
         {{0, 0}, {4, 0}, {4, 4}},
         {{0, 0.5}, {3.5, 0.5}, {3.5, 4}}},
        {FW_CHAIN,
         FW_OUTSIDE,
         0.5,
         4,
         true,
         false,
         {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
         {{0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}}},
        {FW_CHAIN, FW_OUTSIDE, 0.5, 3, false, true, {{0, 0}, {4, 0}, {1, 0}}, {{0, 0}}},
    };
    for (size_t n = 0; n < sizeof shapes / sizeof shapes[0]; ++n) {
        fw_wall_def def = fw_wall_def_default(), moved;
        fw_vec2 points[4];
        def.name = "cell";
        def.shape = shapes[n].shape;
        def.side = shapes[n].side;
        def.points = shapes[n].points;
        def.point_count = shapes[n].count;
        def.closed = shapes[n].closed;
        const fw_status status = fw_wall_offset(&def, shapes[n].distance, points, &moved, &error);
        if (status != (shapes[n].no_room ? FW_BAD_INPUT : FW_OK))
            fail_msg("shape %zu: status %d", n, (int)status);
        if (shapes[n].no_room) assert_non_null(strstr(error.sentence, "wall cell is too small"));
        for (int k = 0; !shapes[n].no_room && k < shapes[n].count; ++k)
            if (!(hypot(points[k].x - shapes[n].moved[k].x, points[k].y - shapes[n].moved[k].y) <
                  1e-14))
                fail_msg("shape %zu: point %d at [%g, %g]", n, k, points[k].x, points[k].y);
    }
    fw_wall_def circle = fw_wall_def_default(), moved;
    fw_vec2 centre = {1, 2}, points[1];
    circle.name = "cell";
    circle.shape = FW_CIRCLE;
    circle.points = &centre;
    circle.point_count = 1;
    circle.radius = 3;
    circle.side = FW_OUTSIDE;
    must(fw_wall_offset(&circle, 2.5, points, &moved, &error));
    assert_close(moved.radius, 5.5, 1e-15);
    circle.side = FW_INSIDE;
    must(fw_wall_offset(&circle, 2.5, points, &moved, &error));
    assert_close(moved.radius, 0.5, 1e-15);
    assert_int_equal(fw_wall_offset(&circle, 3, points, &moved, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "wall cell is too small for a contact distance of 3"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_comes_nearer_and_nothing_is_lost),
        cmocka_unit_test(bodies_meet_at_the_distance),
        cmocka_unit_test(bodies_that_start_nearer_are_refused),
        cmocka_unit_test(walls_move_to_their_free_side),
        cmocka_unit_test(every_shape_moves_to_its_free_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
