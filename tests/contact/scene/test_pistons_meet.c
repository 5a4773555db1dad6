/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_pistons_meet.c - pistons against pistons and walls: two masses hit each other elastically,
 * whatever their shapes, stay together under load, and never pass; with bodies between them. */
#include "tests/support/pistons.h"

#include "core/noise.h"

static double between(uint64_t seed, int n, double low, double high)
{
    const double x = fw_noise_uniform(seed, (uint32_t)n, 0, FW_NOISE_PLACEMENT).x;
    return low + 0.5 * (x + 1) * (high - low);
}

static fw_vec2 velocity_of_piston(const fw_scene *scene, int wall)
{
    return ledger_of(scene, wall)->velocity;
}

/* A scene needs a body, which here is far from all. */
static fw_scene *scene_of_pistons(void)
{
    fw_scene *scene = empty_scene(1e6);
    add_body(scene, (body_options){.columns = 2, .rows = 1, .origin = {1000, 1000}});
    return scene;
}

/* Two masses on a line swap as the textbook says. */
static void two_pistons_hit_each_other_elastically(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 50; ++seed) {
        fw_scene *scene = scene_of_pistons();
        const double m = exp(between(seed, 1, -3, 5)), M = exp(between(seed, 2, -3, 5)),
                     v = between(seed, 3, 0.01, 0.4), V = between(seed, 4, -0.4, 0);
        const fw_piston_def light = {.mass = m, .velocity = {v, 0.01}},
                            heavy = {.mass = M, .velocity = {V, 0}};
        add_block(scene, "light", (fw_vec2){0, 0}, (fw_vec2){1, 1}, smooth, &light);
        add_block(scene, "heavy", (fw_vec2){3, -2}, (fw_vec2){5, 3}, smooth, &heavy);
        must(fw_scene_let_meet(scene, 0, 1, &error));
        begin(scene);
        run(scene, 60);
        const double together = (m * v + M * V) / (m + M);
        if (v - V > 2.0 / 55) {
            assert_close(velocity_of_piston(scene, 0).x, 2 * together - v, 1e-12);
            assert_close(velocity_of_piston(scene, 1).x, 2 * together - V, 1e-12);
        }
        assert_close(velocity_of_piston(scene, 0).y, 0.01, 1e-15);
        assert_ledger_balances(scene, 1e-12);
        fw_scene_destroy(scene);
    }
}

/* Under forces that press them together their acceleration is (F + f)/(M + m). */
static void pistons_that_press_each_other_move_as_one(void **state)
{
    (void)state;
    fw_scene *scene = scene_of_pistons();
    const fw_piston_def left = {.mass = 3, .drive = {.force = {0.004, 0}}},
                        right = {.mass = 5, .drive = {.force = {-0.001, 0}}};
    add_block(scene, "left", (fw_vec2){0, 0}, (fw_vec2){1, 1}, smooth, &left);
    add_block(scene, "right", (fw_vec2){1, -2}, (fw_vec2){5, 3}, smooth, &right);
    must(fw_scene_let_meet(scene, 1, 0, &error));
    begin(scene);
    run(scene, 400);
    const double acceleration = (0.004 - 0.001) / 8;
    for (int w = 0; w < 2; ++w) {
        assert_close(velocity_of_piston(scene, w).x, 400 * acceleration, 1e-13);
        assert_close(ledger_of(scene, w)->displacement.x, 0.5 * 160000 * acceleration, 1e-10);
    }
    /* Of the left one the right one takes what is beyond its share. */
    assert_close(ledger_of(scene, 0)->met.x, 400 * (3 * acceleration - 0.004), 1e-12);
    assert_ledger_balances(scene, 1e-12);
    fw_scene_destroy(scene);
}

static fw_wall_def any_shape(uint64_t seed, int n, fw_vec2 at, fw_vec2 points[5])
{
    const double a = between(seed, n, 0, 6.28), size = between(seed, n + 1, 0.3, 2);
    const int kind = (int)between(seed, n + 2, 0, 4);
    fw_wall_def def = fw_wall_def_default();
    def.side = FW_OUTSIDE;
    def.points = points;
    if (kind == 0) { /* a box */
        points[0] = (fw_vec2){at.x - size, at.y - 0.4};
        points[1] = (fw_vec2){at.x + size, at.y + 0.4};
        return def;
    }
    if (kind == 1) {
        points[0] = at;
        def.shape = FW_CIRCLE;
        def.point_count = 1;
        def.radius = size;
        return def;
    }
    def.shape = FW_POLYGON;
    def.point_count = kind == 2 ? 3 : 5;
    for (int k = 0; k < def.point_count; ++k)
        points[k] = (fw_vec2){at.x + size * cos(a + 6.2831853 * k / def.point_count),
                              at.y + size * sin(a + 6.2831853 * k / def.point_count)};
    return def;
}

/* How deep any corner, or the middle of a circle, lies in another piston. */
static double depth_of(const fw_scene *scene, int count)
{
    double deepest = 0;
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) {
            const fw_wall *own = fw_scene_wall(scene, a), *other = fw_scene_wall(scene, b);
            const fw_vec2 place = fw_scene_wall_displacement(scene, a),
                          there = fw_scene_wall_displacement(scene, b);
            for (int n = 0; a != b && n < fw_wall_facet_count(own); ++n) {
                const fw_facet *facet = fw_wall_facet(own, n);
                const double radius = fw_facet_is_curved(facet) ? facet->length : 0;
                const fw_vec2 at = fw_vec2_add(facet->a, place);
                if (fw_wall_definition(own)->side == FW_INSIDE) continue;
                deepest = fmax(deepest, fw_wall_depth(other, at, there));
                const fw_facet *theirs = fw_wall_facet(other, 0);
                if (!(radius > 0) || !fw_facet_is_curved(theirs)) continue;
                const fw_vec2 apart = fw_vec2_subtract(at, fw_vec2_add(theirs->a, there));
                deepest = fmax(deepest, radius + theirs->length - hypot(apart.x, apart.y));
            }
        }
    return deepest;
}

/* Three of any shape and mass, in a box, with forces or none. */
static fw_scene *crowd(uint64_t seed, bool bodies)
{
    static const char *const names[] = {"one", "two", "three"};
    fw_scene *scene = empty_scene(1e6);
    add_body(scene, (body_options){.columns = 2, .rows = 1, .origin = {-8.5, -6.7}});
    if (bodies)
        add_body(scene, (body_options){.columns = 3,
                                       .rows = 3,
                                       .origin = {-1, 5},
                                       .velocity = {0.03, -0.1},
                                       .rest_mass = 1});
    for (int n = 0; n < 3; ++n) {
        fw_vec2 points[5];
        fw_wall_def def =
            any_shape(seed, 10 * n, (fw_vec2){5 * n - 5, between(seed, 90 + n, -1, 1)}, points);
        def.name = names[n];
        const fw_piston_def piston = {.mass = exp(between(seed, 10 * n + 3, -1, 4)),
                                      .velocity = {between(seed, 10 * n + 4, -0.3, 0.3),
                                                   between(seed, 10 * n + 5, -0.2, 0.2)},
                                      .damping = seed % 3 == 1 ? 0.01 : 0,
                                      .drive.force = {seed % 2 ? 0.01 * (1 - n) : 0, 0}};
        must(fw_scene_add_piston(scene, &def, &piston, &error));
    }
    const fw_vec2 corners[] = {{-9, -7}, {9, 9}};
    fw_wall_def room = fw_wall_def_default();
    room.name = "room";
    room.points = corners;
    must(fw_scene_add_wall(scene, &room, &error));
    for (int a = 0; a < 3; ++a)
        for (int b = a + 1; b < 4; ++b) must(fw_scene_let_meet(scene, a, b, &error));
    begin(scene);
    return scene;
}

static void crowds_of_pistons_keep_everything_and_stay_out(void **state)
{
    (void)state;
    int hits = 0;
    for (uint64_t seed = 0; seed < 400; ++seed) {
        fw_scene *scene = crowd(seed, seed % 4 == 3);
        double depth = 0;
        for (int t = 0; t < 200; ++t) {
            if (fw_scene_step(scene, &error) != FW_OK)
                fail_msg("seed %d: %s", (int)seed, error.sentence);
            depth = fmax(depth, depth_of(scene, 4));
        }
        assert_true(depth < 1e-11);
        assert_ledger_balances(scene, 1e-11);
        assert_int_equal(fw_scene_unresolved(scene), 0);
        assert_true(fw_scene_penetration(scene, -1) < 1e-11);
        for (int w = 0; w < 3; ++w) {
            assert_true(motion_fits(scene, w));
            hits += ledger_of(scene, w)->met.x != 0;
        }
        fw_scene_destroy(scene);
    }
    assert_true(hits > 600);
}

static void crowds_that_go_on_elsewhere_have_the_same_bytes(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 20; ++seed) {
        fw_scene *scene = crowd(seed, true), *elsewhere = crowd(seed, true);
        run(scene, 90);
        copy_state(scene, elsewhere);
        run(scene, 90);
        run(elsewhere, 90);
        assert_true(hash_of_scene(scene) == hash_of_scene(elsewhere));
        fw_scene_destroy(scene);
        fw_scene_destroy(elsewhere);
    }
}

/* Of any shape, with what moves it or at rest. */
typedef struct shape {
    fw_wall_shape_kind kind;
    fw_side side;
    int point_count;
    fw_vec2 points[4];
    double radius;
} shape;

static void add_shape(fw_scene *scene, const char *name, const shape *s,
                      const fw_piston_def *piston)
{
    fw_wall_def def = fw_wall_def_default();
    def.name = name;
    def.shape = s->kind;
    def.side = s->side;
    def.points = s->points;
    def.point_count = s->point_count;
    def.radius = s->radius;
    must(piston ? fw_scene_add_piston(scene, &def, piston, &error)
                : fw_scene_add_wall(scene, &def, &error));
}

static const shape tip = {FW_POLYGON, FW_OUTSIDE, 3, {{-1, -2}, {1, -2}, {0, 0}}, 0},
                   ring = {FW_CIRCLE, FW_INSIDE, 1, {{0, 2998}}, 3000},
                   disc = {FW_CIRCLE, FW_OUTSIDE, 1, {{0, 0.04}}, 1},
                   ball = {FW_CIRCLE, FW_OUTSIDE, 1, {{0, 2.04}}, 1},
                   plate = {FW_CHAIN, FW_INSIDE, 2, {{3, 1.04}, {-3, 1.04}}, 0},
                   block = {FW_BOX, FW_OUTSIDE, 2, {{-2, 0}, {2, 1}}, 0},
                   tall = {FW_BOX, FW_OUTSIDE, 2, {{0, -2}, {1, 3}}, 0},
                   small = {FW_BOX, FW_OUTSIDE, 2, {{0, 0.2}, {0.5, 0.5}}, 0},
                   beside = {FW_BOX, FW_OUTSIDE, 2, {{2, 0}, {3, 1}}, 0},
                   line_in = {FW_CHAIN, FW_INSIDE, 2, {{5, 0.5}, {1, 0.5}}, 0},
                   line_out = {FW_CHAIN, FW_INSIDE, 2, {{1, 0.5}, {5, 0.5}}, 0},
                   disc_beside = {FW_CIRCLE, FW_OUTSIDE, 1, {{2.5, 0.5}}, 1},
                   wide = {FW_CIRCLE, FW_OUTSIDE, 1, {{0, 0}}, 4};

/* Whoever has the corner, and whether a circle is hollow: what stands turns back what falls on it,
 * once, however often and from whichever side the pair is told. */
static void what_falls_on_what_stands_comes_back(void **state)
{
    (void)state;
    const shape *const pairs[][2] = {{&plate, &tip}, {&disc, &ring}, {&ball, &tip}};
    for (size_t n = 0; n < sizeof pairs / sizeof pairs[0]; ++n)
        for (int told = 1; told <= 3; ++told) {
            fw_scene *scene = scene_of_pistons();
            const fw_piston_def falls = {.mass = 3, .velocity = {0, -0.1}};
            add_shape(scene, "falls", pairs[n][0], &falls);
            add_shape(scene, "stands", pairs[n][1], NULL);
            add_shape(scene, "far", &(shape){FW_CIRCLE, FW_OUTSIDE, 1, {{50, 50}}, 1}, &falls);
            must(fw_scene_let_meet(scene, 0, 1, &error));
            must(fw_scene_let_meet(scene, 0, 2, &error));
            if (told > 1) must(fw_scene_let_meet(scene, 0, 1, &error));
            if (told > 2) must(fw_scene_let_meet(scene, 2, 0, &error));
            begin(scene);
            run(scene, 7);
            assert_close(velocity_of_piston(scene, 0).y, -0.1, 1e-15);
            run(scene, 20);
            assert_close(velocity_of_piston(scene, 0).x, 0, 1e-12);
            assert_close(velocity_of_piston(scene, 0).y, 0.1, 1e-12);
            assert_close(ledger_of(scene, 0)->met.y, 2 * 3 * 0.1, 1e-12);
            assert_close(velocity_of_piston(scene, 2).y, -0.1, 1e-15);
            assert_ledger_balances(scene, 1e-12);
            fw_scene_destroy(scene);
        }
}

/* Nothing can turn back what is held on its path: two that are go through each other. */
static void pistons_on_paths_do_not_feel_each_other(void **state)
{
    (void)state;
    fw_scene *scene = scene_of_pistons();
    fw_piston_def held = {.mass = 3, .drive = {.prescribed_x = true, .prescribed_y = true}};
    add_shape(scene, "stays", &block, &held);
    held.drive.path = (fw_path){.velocity = {-0.1, 0}, .until = INFINITY};
    add_shape(scene, "comes", &beside, &held);
    must(fw_scene_let_meet(scene, 0, 1, &error));
    begin(scene);
    run(scene, 10);
    assert_close(ledger_of(scene, 1)->displacement.x, -1, 1e-12);
    for (int w = 0; w < 2; ++w) {
        assert_close(ledger_of(scene, w)->met.x, 0, 0);
        assert_close(ledger_of(scene, w)->displacement.y, 0, 0);
    }
    fw_scene_destroy(scene);
}

/* A corner, an end, a circle's edge in the other, or edges that cross: each from both sides. */
static void pistons_that_start_in_each_other_are_refused(void **state)
{
    (void)state;
    const struct {
        const shape *one, *other;
        bool overlap;
    } rows[] = {{&block, &tall, true},        {&block, &small, true},   {&block, &line_in, true},
                {&block, &line_out, true},    {&block, &beside, false}, {&ring, &disc, false},
                {&block, &disc_beside, true}, {&ring, &wide, true}};
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n)
        for (int turned = 0; turned < 2; ++turned) {
            fw_scene *scene = scene_of_pistons();
            const fw_piston_def piston = {.mass = 3};
            add_shape(scene, "one", rows[n].one, &piston);
            add_shape(scene, "other", rows[n].other, &piston);
            must(fw_scene_let_meet(scene, turned, 1 - turned, &error));
            if (!rows[n].overlap) {
                begin(scene);
            } else {
                assert_int_equal(fw_scene_begin(scene, &error), FW_BAD_INPUT);
                assert_string_equal(error.sentence,
                                    turned ? "piston other starts in wall one, which it meets; "
                                             "expected shapes that do not overlap"
                                           : "piston one starts in wall other, which it meets; "
                                             "expected shapes that do not overlap");
            }
            fw_scene_destroy(scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_pistons_hit_each_other_elastically),
        cmocka_unit_test(pistons_that_press_each_other_move_as_one),
        cmocka_unit_test(crowds_of_pistons_keep_everything_and_stay_out),
        cmocka_unit_test(crowds_that_go_on_elsewhere_have_the_same_bytes),
        cmocka_unit_test(what_falls_on_what_stands_comes_back),
        cmocka_unit_test(pistons_on_paths_do_not_feel_each_other),
        cmocka_unit_test(pistons_that_start_in_each_other_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
