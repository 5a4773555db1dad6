/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_neighbours.c - no pair is missed, wherever particles are. */
#include "tests/support/laws.h"

#include "core/noise.h"
#include "core/particles/neighbours.h"

enum { COUNT = 300 };

/* Every list ascends, holds nobody beyond the radius, and misses nobody within it. */
static void assert_complete(const fw_neighbours *neighbours, const double *x, const double *y)
{
    const double square = neighbours->radius * neighbours->radius;
    for (int i = 0; i < COUNT; ++i) {
        size_t k = neighbours->begin[i];
        const size_t end = neighbours->begin[i + 1];
        for (size_t l = k; l + 1 < end; ++l)
            assert_true(neighbours->list[l] < neighbours->list[l + 1]);
        for (int j = 0; j < COUNT; ++j) {
            if (j == i) continue;
            const double dx = x[i] - x[j], dy = y[i] - y[j];
            while (k < end && neighbours->list[k] < j) ++k;
            const bool listed = k < end && neighbours->list[k] == j;
            if (listed != (dx * dx + dy * dy < square)) fail_msg("%d and %d", i, j);
        }
    }
}

static fw_neighbours *neighbours_of(const double *x, const double *y)
{
    fw_neighbours *neighbours;
    assert_int_equal(fw_neighbours_create(&neighbours, x, y, COUNT, 1.7, NULL), FW_OK);
    return neighbours;
}

/* A body flows, slides fast as a whole, shears, and some of its particles leave for far away. */
static void flowing_particles_miss_nobody(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    const double offsets[] = {0, 1e4, -3e6};
    for (int o = 0; o < 3; ++o) {
        for (int i = 0; i < COUNT; ++i) {
            const fw_vec2 at = fw_noise_uniform(1, (uint32_t)i, 0, 1);
            x[i] = offsets[o] + 8 * at.x;
            y[i] = -offsets[o] + 8 * at.y;
        }
        for (int step = 0; step < 400; ++step) {
            fw_neighbours *neighbours = neighbours_of(x, y);
            assert_complete(neighbours, x, y);
            fw_neighbours_destroy(neighbours);
            for (int i = 0; i < COUNT; ++i) {
                const fw_vec2 kick = fw_noise_uniform(2, (uint32_t)i, (uint64_t)step, 1);
                x[i] += 0.5 + 0.02 * kick.x + 0.003 * (y[i] + offsets[o]);
                y[i] += 0.02 * kick.y - 0.3;
                if (i % 37 == 0) x[i] += 40. * i, y[i] -= 1e3 * step;
            }
        }
    }
}

/* Crowded into one point, spread over 1e9, or not numbers at all: lists stay right for the others.
 */
static void strange_places_are_survived(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    for (int i = 0; i < COUNT; ++i) x[i] = 1e9 * i, y[i] = i % 2 ? 1e300 : 0;
    x[5] = NAN;
    y[6] = INFINITY;
    for (int i = 100; i < 160; ++i) x[i] = 4, y[i] = 4 + 1e-3 * i;
    fw_neighbours *neighbours = neighbours_of(x, y);
    assert_complete(neighbours, x, y);
    assert_int_equal(neighbours->begin[101] - neighbours->begin[100], 59);
    fw_neighbours_destroy(neighbours);
    for (int i = 0; i < COUNT; ++i) x[i] = 1e-6 * i, y[i] = 0;
    neighbours = neighbours_of(x, y);
    assert_int_equal(neighbours->begin[COUNT], COUNT * (COUNT - 1));
    fw_neighbours_destroy(neighbours);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flowing_particles_miss_nobody),
        cmocka_unit_test(strange_places_are_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
