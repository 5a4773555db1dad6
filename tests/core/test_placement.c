/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_placement.c - random places keep their distance, and are the same for the same seed. */
#include "tests/support/laws.h"

#include "core/placement.h"

#include <string.h>

enum { COUNT = 256 };

/* The start of Fig 2: square of area 1.3 N sqrt(3)/2, distance .75. */
static void places_keep_their_distance(void **state)
{
    (void)state;
    const double side = sqrt(1.3 * COUNT * sqrt(3) / 2);
    for (uint64_t seed = 1; seed < 20; ++seed) {
        fw_vec2 at[COUNT], again[COUNT];
        const fw_vec2 low = {100, -7}, high = {100 + side, -7 + side};
        assert_int_equal(fw_placement_random(at, COUNT, low, high, 0.75, seed, NULL), FW_OK);
        assert_int_equal(fw_placement_random(again, COUNT, low, high, 0.75, seed, NULL), FW_OK);
        assert_memory_equal(at, again, sizeof at);
        fw_vec2 mean = {0, 0};
        for (int i = 0; i < COUNT; ++i) {
            assert_true(at[i].x >= low.x && at[i].x < high.x);
            assert_true(at[i].y >= low.y && at[i].y < high.y);
            mean = fw_vec2_add(mean, fw_vec2_scale(1. / COUNT, at[i]));
            for (int j = 0; j < i; ++j)
                assert_true(hypot(at[i].x - at[j].x, at[i].y - at[j].y) >= 0.75);
        }
        /* Less than 4 errors of independent places; with a distance they are more even. */
        assert_close(mean.x, 100 + side / 2, 4 * side / sqrt(12. * COUNT));
        assert_close(mean.y, -7 + side / 2, 4 * side / sqrt(12. * COUNT));
        assert_int_equal(fw_placement_random(again, COUNT, low, high, 0.75, seed + 1, NULL), FW_OK);
        assert_memory_not_equal(at, again, sizeof at);
    }
}

static void what_has_no_room_is_refused(void **state)
{
    (void)state;
    fw_vec2 at[COUNT];
    fw_error error;
    const fw_vec2 low = {0, 0};
    assert_int_equal(fw_placement_random(at, COUNT, low, (fw_vec2){12, 12}, 0.8, 1, &error),
                     FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "of 256 particles found a place at least 0.8"));
    assert_int_equal(fw_placement_random(at, COUNT, low, (fw_vec2){-1, 12}, 0.8, 1, &error),
                     FW_BAD_INPUT);
    assert_int_equal(fw_placement_random(at, COUNT, low, (fw_vec2){9, 12}, NAN, 1, &error),
                     FW_BAD_INPUT);
    /* A strip a million times as long as wide needs no giant grid. */
    assert_int_equal(fw_placement_random(at, COUNT, low, (fw_vec2){1e6, 1}, 0.8, 1, &error), FW_OK);
}

/* Without a drop: a thousand million of them would take minutes. */
static void crowds_are_refused_at_once(void **state)
{
    (void)state;
    fw_error error;
    const fw_vec2 low = {0, 0}, high = {1000, 1000};
    assert_int_equal(fw_placement_random(NULL, 2000000, low, high, 0.8, 1, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "expected at most 1806720"));
    assert_int_equal(fw_placement_random(NULL, 1200000, low, high, 0.8, 1, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "they would cover 0.602, expected well below 0.547"));
    /* Two on a line find the ends, whatever they would cover. */
    fw_vec2 pair[2];
    assert_int_equal(fw_placement_random(pair, 2, low, (fw_vec2){1, 1e-3}, 0.5, 3, &error), FW_OK);
    /* Just what fits is not refused at once, and not found by chance. */
    fw_vec2 row[4];
    assert_int_equal(fw_placement_random(row, 4, low, (fw_vec2){3, 1e-9}, 1, 1, &error),
                     FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "of 4 particles found a place"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places_keep_their_distance),
        cmocka_unit_test(what_has_no_room_is_refused),
        cmocka_unit_test(crowds_are_refused_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
