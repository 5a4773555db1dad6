/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_neighbour_lists.c - no pair is missed, whatever particles do, and lists are not made anew
 * without need. */
#include "tests/support/laws.h"

#include "core/array.h"
#include "core/noise.h"
#include "core/particles/neighbour_lists.h"

enum { COUNT = 300 };
static const double REACH = 1.7;
static const int BODIES[] = {120, 1, 179};

static int body_of(int particle)
{
    return particle < BODIES[0] ? 0 : particle < BODIES[0] + BODIES[1] ? 1 : 2;
}

/* Neighbours of lower bodies, of the own one, and of higher ones stand in three runs. */
static int run_of(int particle, int neighbour)
{
    const int own = body_of(particle), other = body_of(neighbour);
    return FW_RUN_OWN + (other > own) - (other < own);
}

/* Every walk ascends, from run to run, and misses nobody within reach; the closest are the closest
 * of all walks. */
static void assert_complete(const fw_neighbour_lists *lists, const double *x, const double *y)
{
    double closest = INFINITY;
    for (int i = 0; i < COUNT; ++i) {
        fw_neighbour_walk walk = fw_neighbours_around(lists, i);
        int next = fw_neighbour_next(&walk);
        for (int j = 0; j < COUNT; ++j) {
            const bool listed = j == next;
            if (listed) {
                assert_int_equal(walk.run, run_of(i, j));
                next = fw_neighbour_next(&walk);
                assert_true(next < 0 || next > j);
                assert_true(j != i);
            }
            const double dx = x[i] - x[j], dy = y[i] - y[j];
            if (listed) closest = fmin(closest, dx * dx + dy * dy);
            if (j != i && dx * dx + dy * dy < REACH * REACH && !listed)
                fail_msg("%d lacks %d", i, j);
        }
        assert_true(next < 0);
    }
    const double told = fw_neighbour_lists_closest(lists);
    if (told != closest) fail_msg("the closest are %g apart, not %g", sqrt(closest), sqrt(told));
}

static fw_neighbour_lists *lists_of(double margin, double favour)
{
    fw_neighbour_lists *lists;
    assert_int_equal(fw_neighbour_lists_create(&lists, BODIES, 3, REACH, margin, NULL), FW_OK);
    fw_neighbour_lists_favour(lists, favour);
    return lists;
}

/* A body flows, slides fast as a whole, shears, and some of its particles leave for far away. */
static void flowing_particles_miss_nobody(void **state)
{
    (void)state;
    double x[COUNT + 16] = {0}, y[COUNT + 16] = {0}; /* kernels read a little beyond either end */
    double *const px = x + 8, *const py = y + 8;
    const double offsets[] = {0, 1e4, -3e6}, favours[] = {2.5, 0, INFINITY};
    for (int o = 0; o < 3; ++o) {
        for (int i = 0; i < COUNT; ++i) {
            const fw_vec2 at = fw_noise_uniform(1, (uint32_t)i, 0, 1);
            px[i] = offsets[o] + 8 * at.x;
            py[i] = -offsets[o] + 8 * at.y;
        }
        fw_neighbour_lists *lists = lists_of(0.8, favours[o]);
        for (int step = 0; step < 400; ++step) {
            double travel = 0;
            fw_vec2 moved[COUNT];
            for (int i = 0; i < COUNT; ++i) {
                const fw_vec2 kick = fw_noise_uniform(2, (uint32_t)i, (uint64_t)step, 1);
                moved[i] = (fw_vec2){0.5 + 0.02 * kick.x + 0.003 * (py[i] + offsets[o]),
                                     0.02 * kick.y - 0.3};
                if (i % 37 == 0) moved[i].x += 40. * i, moved[i].y -= 1e3 * step;
                travel = fmax(travel, 2 * hypot(moved[i].x - 0.5, moved[i].y + 0.3));
            }
            /* Now and then nothing is known. */
            if (step % 50 == 0) travel = INFINITY;
            for (int i = 0; i < COUNT && step > 0; ++i) px[i] += moved[i].x, py[i] += moved[i].y;
            assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, travel, NULL), FW_OK);
            assert_complete(lists, px, py);
        }
        fw_neighbour_lists_destroy(lists);
    }
}

/* Two halves slide along each other, cross a gap and meet, and the whole turns slowly; most of this
 * needs no new lists. */
static void bodies_that_meet_miss_nobody(void **state)
{
    (void)state;
    double x[COUNT + 16] = {0}, y[COUNT + 16] = {0};
    double *const px = x + 8, *const py = y + 8;
    fw_neighbour_lists *lists = lists_of(0.6, 2.5);
    const int steps = 600;
    for (int step = 0; step < steps; ++step) {
        const double angle = 2e-4 * step, c = cos(angle), s = sin(angle);
        for (int i = 0; i < COUNT; ++i) {
            double right = i % 20, up = i / 20;
            if (i >= COUNT / 2) right += 0.02 * step, up += fmax(0, 6 - 0.03 * step);
            px[i] = c * right - s * up + 3. * step;
            py[i] = s * right + c * up;
        }
        /* 22 * .03 for the way of the outermost, twice; the common path is left out. */
        const double travel = step > 0 ? 2 * (0.0361 + 2e-4 * 40) : INFINITY;
        assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, travel, NULL), FW_OK);
        assert_complete(lists, px, py);
    }
    assert_true(fw_neighbour_lists_made(lists) < 60);
    fw_neighbour_lists_destroy(lists);
}

/* A common motion, however fast, and a shaking that brings nobody near, make no new lists; a single
 * particle that leaves its place does. */
static void sliding_solid_keeps_its_lists(void **state)
{
    (void)state;
    double x[COUNT + 16] = {0}, y[COUNT + 16] = {0};
    double *const px = x + 8, *const py = y + 8;
    fw_neighbour_lists *lists = lists_of(0.5, 2.5);
    for (int step = 0; step < 100; ++step) {
        for (int i = 0; i < COUNT; ++i) {
            const fw_vec2 off = fw_noise_uniform(2, (uint32_t)i, (uint64_t)step, 1);
            px[i] = i % 20 + step + 0.05 * off.x;
            py[i] = i / 20 - 0.5 * step + 0.05 * off.y;
        }
        assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, 0.3, NULL), FW_OK);
        assert_complete(lists, px, py);
    }
    assert_int_equal(fw_neighbour_lists_made(lists), 1);
    px[17] += 0.8;
    assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, 0.8, NULL), FW_OK);
    assert_int_equal(fw_neighbour_lists_made(lists), 2);
    assert_complete(lists, px, py);
    fw_neighbour_lists_destroy(lists);
}

/* In long rows most blocks of eight see what the one before saw, one block further; but not beside
 * a hole, at the ends of rows, and where a row belongs to another body from some particle on, or
 * has one above it all along. */
static void rows_that_repeat_miss_nobody(void **state)
{
    (void)state;
    double x[COUNT + 16] = {0}, y[COUNT + 16] = {0};
    double *const px = x + 8, *const py = y + 8;
    const double favours[] = {2.5, 0, INFINITY};
    const int columns[] = {20, 60, 100, 150};
    for (int n = 0; n < 12; ++n) {
        fw_neighbour_lists *lists = lists_of(0.5, favours[n % 3]);
        for (int i = 0; i < COUNT; ++i) {
            px[i] = i % columns[n / 3];
            py[i] = i / columns[n / 3];
        }
        assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, INFINITY, NULL), FW_OK);
        assert_complete(lists, px, py);
        for (int i = 47; i < COUNT; i += 83) px[i] += 1e3 * i;
        assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, INFINITY, NULL), FW_OK);
        assert_complete(lists, px, py);
        fw_neighbour_lists_destroy(lists);
    }
}

/* Rows of eight, each alone with another one: the first with the last, the second with the last but
 * one. All see alike, but nobody sees one row further than the one before. */
static void rows_in_pairs_miss_nobody(void **state)
{
    (void)state;
    enum { ROWS = 12 };
    double x[COUNT + 16] = {0}, y[COUNT + 16] = {0};
    double *const px = x + 8, *const py = y + 8;
    fw_neighbour_lists *lists = lists_of(0.5, 2.5);
    for (int i = 0; i < COUNT; ++i) {
        const int row = i / 8, other = ROWS - 1 - row;
        px[i] = i % 8;
        py[i] = row < ROWS ? 10. * (row < other ? row : other) + (row > other) : 10. * row;
    }
    assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, INFINITY, NULL), FW_OK);
    assert_complete(lists, px, py);
    fw_neighbour_lists_destroy(lists);
}

/* Crowded into one point, spread over 1e9, or not numbers at all: lists stay right for the others.
 */
static void strange_places_are_survived(void **state)
{
    (void)state;
    double x[COUNT + 16] = {0}, y[COUNT + 16] = {0};
    double *const px = x + 8, *const py = y + 8;
    for (int i = 0; i < COUNT; ++i) px[i] = 1e9 * i, py[i] = i % 2 ? 1e300 : 0;
    px[5] = NAN;
    py[6] = INFINITY;
    for (int i = 100; i < 160; ++i) px[i] = 4, py[i] = 4 + 1e-3 * i;
    fw_neighbour_lists *lists = lists_of(0.5, 2.5);
    assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, INFINITY, NULL), FW_OK);
    assert_complete(lists, px, py);
    for (int i = 0; i < COUNT; ++i) px[i] = 1e-6 * i, py[i] = 0;
    assert_int_equal(fw_neighbour_lists_refresh(lists, px, py, INFINITY, NULL), FW_OK);
    assert_complete(lists, px, py);
    fw_neighbour_walk walk = fw_neighbours_around(lists, 150);
    int count = 0;
    while (fw_neighbour_next(&walk) >= 0) ++count;
    assert_int_equal(count, COUNT - 1);
    fw_neighbour_lists_destroy(lists);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flowing_particles_miss_nobody),
        cmocka_unit_test(bodies_that_meet_miss_nobody),
        cmocka_unit_test(sliding_solid_keeps_its_lists),
        cmocka_unit_test(rows_that_repeat_miss_nobody),
        cmocka_unit_test(rows_in_pairs_miss_nobody),
        cmocka_unit_test(strange_places_are_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
