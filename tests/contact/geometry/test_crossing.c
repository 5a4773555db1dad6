/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_crossing.c - paths of points through moving segments, against many small steps. */
#include "tests/support/laws.h"

#include "contact/geometry/crossing.h"

static double random_between(uint64_t *seed, double low, double high)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

static fw_moving_point random_point(uint64_t *seed, double size, double speed)
{
    fw_moving_point p;
    p.at.x = random_between(seed, -size, size);
    p.at.y = random_between(seed, -size, size);
    p.motion.x = random_between(seed, -speed, speed);
    p.motion.y = random_between(seed, -speed, speed);
    return p;
}

static fw_vec2 at(fw_moving_point p, double time)
{
    return fw_vec2_add(p.at, fw_vec2_scale(time, p.motion));
}

/* Twice the area, and where along the segment. */
static double area(fw_moving_point p, fw_moving_point a, fw_moving_point b, double time,
                   double *part)
{
    const fw_vec2 edge = fw_vec2_subtract(at(b, time), at(a, time));
    const fw_vec2 apart = fw_vec2_subtract(at(p, time), at(a, time));
    *part = fw_vec2_dot(edge, apart) / fw_vec2_dot(edge, edge);
    return fw_vec2_cross(edge, apart);
}

/* The first time at which the area turns negative, by small steps; 2: it does not. */
static double first_passage(fw_moving_point p, fw_moving_point a, fw_moving_point b, double *part)
{
    enum { STEPS = 2000 };
    double before = area(p, a, b, 0, part);
    for (int n = 1; n <= STEPS; ++n) {
        const double now = area(p, a, b, (double)n / STEPS, part);
        if (before >= 0 && now < 0) return (double)n / STEPS;
        if (before < 0) return 2;
        before = now;
    }
    return 2;
}

static void points_pass_when_small_steps_say_so(void **state)
{
    (void)state;
    uint64_t seed = 3;
    int passed = 0;
    for (int n = 0; n < 20000; ++n) {
        const fw_moving_point a = random_point(&seed, 1, 0.5), b = random_point(&seed, 1, 0.5),
                              p = random_point(&seed, 1, 1.5);
        double when, part, start;
        const bool does = fw_crossing_of_segment(p, a, b, 0, &when);
        const double seen = first_passage(p, a, b, &part);
        area(p, a, b, 0, &start);
        if (fabs(part) < 0.05 || fabs(part - 1) < 0.05) continue; /* too near to an end to tell */
        if (does) assert_true(fabs(seen - when) < 2e-3 || seen == 2);
        if (seen < 0.999) assert_int_equal(does, part > 0 && part < 1);
        passed += does;
    }
    assert_true(passed > 1000);
}

static fw_moving_point still(double x, double y)
{
    return (fw_moving_point){{x, y}, {0, 0}};
}

static void what_is_behind_does_not_pass_but_for_rounding(void **state)
{
    (void)state;
    double when;
    fw_moving_point p = {{0.5, -1e-8}, {0, -0.1}};
    assert_false(fw_crossing_of_segment(p, still(0, 0), still(1, 0), 0, &when));
    assert_true(fw_crossing_of_segment(p, still(0, 0), still(1, 0), 1e-6, &when));
    p.motion.y = 0.1; /* it comes out */
    assert_false(fw_crossing_of_segment(p, still(0, 0), still(1, 0), 1e-6, &when));
    p.at.y = -1e-3; /* that is no rounding */
    p.motion.y = -0.1;
    assert_false(fw_crossing_of_segment(p, still(0, 0), still(1, 0), 1e-6, &when));
}

static void ends_belong_to_both_segments_that_meet_there(void **state)
{
    (void)state;
    double when;
    const fw_moving_point p = {{1, 0.1}, {0, -0.2}};
    assert_true(fw_crossing_of_segment(p, still(0, 0), still(1, 0), 0, &when));
    assert_close(when, 0.5, 1e-15);
    assert_true(fw_crossing_of_segment(p, still(1, 0), still(2, 0), 0, &when));
    assert_false(fw_crossing_of_segment(p, still(1.001, 0), still(2, 0), 0, &when));
    /* To land on it is not to pass. */
    const fw_moving_point lands = {{0.5, 0.25}, {0, -0.25}};
    assert_false(fw_crossing_of_segment(lands, still(0, 0), still(1, 0), 0, &when));
}

static void tips_meet_only_in_one_line(void **state)
{
    (void)state;
    double when;
    const fw_moving_point a = {{0, 0}, {0.1, 0}};
    assert_true(fw_crossing_of_points(a, still(0.05, 0), &when));
    assert_close(when, 0.5, 1e-15);
    assert_false(fw_crossing_of_points(a, still(0.2, 0), &when));
    assert_false(fw_crossing_of_points(a, still(-0.05, 0), &when));
    assert_false(fw_crossing_of_points(a, still(0.05, 1e-6), &when));
}

/* What bars the way from both sides must not let rounding choose the side: a point that is held on
 * it is held a little before it, and stays on its side where rounding carries it in steps. */
static void lines_keep_points_on_their_side(void **state)
{
    (void)state;
    const fw_moving_point from = {{0, 0}, {0, 0}}, to = {{2, 0}, {0, 0}};
    const double keep = 1e-9; /* of the length: 2e-9 */
    double when;
    fw_moving_point p = {{1, 0.1}, {0, -0.1}};
    assert_true(fw_crossing_of_segment(p, from, to, -keep, &when));
    assert_true(when < 1 && when > 0.999999);
    assert_false(fw_crossing_of_segment(p, from, to, 0, &when)); /* it ends on the line */
    p = (fw_moving_point){{1, 1e-10}, {0, -1e-17}};
    assert_true(fw_crossing_of_segment(p, from, to, -keep, &when));
    p.motion.y = 1e-17;
    assert_false(fw_crossing_of_segment(p, from, to, -keep, &when));
    p = (fw_moving_point){{1, -1e-10}, {0, -0.1}}; /* the other side's */
    assert_false(fw_crossing_of_segment(p, from, to, -keep, &when));
    assert_false(fw_crossing_of_segment(p, to, from, -keep, &when));
    p.motion.y = 0.1;
    assert_true(fw_crossing_of_segment(p, to, from, -keep, &when));
}

/* The run ends after the step in which numbers explode: until then nothing meets them. */
static void a_way_that_is_no_number_crosses_nothing(void **state)
{
    (void)state;
    const fw_moving_point still[] = {{{0.5, 0.1}, {0, -0.3}}, {{0, 0}, {0, 0}}, {{1, 0}, {0, 0}}};
    double when = 0;
    assert_true(fw_crossing_of_segment(still[0], still[1], still[2], 0, &when));
    for (int n = 0; n < 3; ++n)
        for (int part = 0; part < 4; ++part) {
            fw_moving_point p[] = {still[0], still[1], still[2]};
            double *numbers[] = {&p[n].at.x, &p[n].at.y, &p[n].motion.x, &p[n].motion.y};
            *numbers[part] = NAN;
            assert_false(fw_crossing_of_segment(p[0], p[1], p[2], 0, &when));
            assert_false(fw_crossing_of_segment(p[0], p[1], p[2], 1e-6, &when));
            assert_false(fw_crossing_of_points(p[0], p[1], &when) && n < 2);
        }
}

/* A point slides along a face whose corner bends out at first and in at last: it is behind the
 * extension of the next segment before it comes beside it. (From a collision at .5 a step, in which
 * it got .1 deep.) */
static void face_that_bends_over_lets_no_point_round_its_corner(void **state)
{
    (void)state;
    fw_moving_point p = {{4.614622, -7.633552}, {0.122165, -0.34193}};
    const fw_moving_point below = {{4.545179, -8.758047}, {0.038242, -0.002923}};
    fw_moving_point corner = {{4.602542, -7.762431}, {0.157564, -0.010264}};
    double when;
    bool at_from;
    assert_false(fw_crossing_of_segment(p, below, corner, 1e-6, &when));
    assert_true(fw_crossing_round_end(p, below, corner, 1e-6, &at_from));
    assert_false(at_from);
    p.motion.x = 0; /* it moves away from the face, out of which the corner comes no further */
    assert_false(fw_crossing_round_end(p, below, corner, 1e-6, &at_from));
    p.motion = (fw_vec2){0.122165, 0.1}; /* it goes the other way */
    assert_false(fw_crossing_round_end(p, below, corner, 1e-6, &at_from));
}

/* Closed form: they start 3 apart, come by 4 in the step and touch at 1; within that from the start
 * they pass at once, but for rounding, and only where they come closer. */
static void points_pass_within_a_distance(void **state)
{
    (void)state;
    const struct {
        double x, y, motion;
        bool passes;
        double when;
    } rows[] = {{3, 0, -4, true, 0.5},    {3, 0, -1.9, false, 0},  {3, 1.001, -4, false, 0},
                {0.9, 0, -0.1, true, 0},  {0.9, 0, 0.1, false, 0}, {0.9, 0, 0, false, 0},
                {-0.9, 0, 0.1, true, 0},  {3, 0, 4, false, 0},     {3, 0.6, -4, true, 0.55},
                {3, 1.001, -40, false, 0}};
    for (size_t n = 0; n < sizeof rows / sizeof rows[0]; ++n) {
        const fw_moving_point moving = {{10 + rows[n].x, rows[n].y}, {rows[n].motion + 0.3, 0.2}},
                              there = {{10, 0}, {0.3, 0.2}};
        double when = 2;
        assert_int_equal(fw_crossing_of_circle(moving, there, 1, &when), rows[n].passes);
        if (rows[n].passes) assert_close(when, rows[n].when, 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_way_that_is_no_number_crosses_nothing),
        cmocka_unit_test(points_pass_when_small_steps_say_so),
        cmocka_unit_test(what_is_behind_does_not_pass_but_for_rounding),
        cmocka_unit_test(ends_belong_to_both_segments_that_meet_there),
        cmocka_unit_test(tips_meet_only_in_one_line),
        cmocka_unit_test(lines_keep_points_on_their_side),
        cmocka_unit_test(points_pass_within_a_distance),
        cmocka_unit_test(face_that_bends_over_lets_no_point_round_its_corner),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
