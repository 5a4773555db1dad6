/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_row_front.c - whoever moves a row finds its neighbours where it needs them. */
#include "tests/support/laws.h"

#include "core/row_front.h"

#include <stdbool.h>

enum { ROWS_MAX = 64 };

/* Ticks that each row has made, and whether all went well. */
typedef struct rows {
    int count;
    int made[ROWS_MAX];
    int faults;
} rows;

static int made_by(rows *r, int row)
{
    int made;
#pragma omp atomic read
    made = r->made[row];
    return made;
}

/* A neighbour has made the tick before, and not overwritten what that left: it may be one ahead. */
static bool is_in_time(rows *r, int tick, int row)
{
    if (row < 0 || row >= r->count) return true;
    const int made = made_by(r, row);
    return made == tick || made == tick + 1;
}

static void move(void *context, int tick, int row)
{
    rows *r = context;
    const bool fine = row >= 0 && row < r->count && made_by(r, row) == tick &&
                      is_in_time(r, tick, row - 1) && is_in_time(r, tick, row + 1);
    if (fine) {
#pragma omp atomic
        r->made[row] += 1;
    } else {
#pragma omp atomic
        r->faults += 1;
    }
}

static void every_row_makes_every_tick_in_time(void **state)
{
    (void)state;
    for (int count = 1; count <= ROWS_MAX; ++count)
        for (int ticks = 1; ticks <= 16; ++ticks)
            for (int threads = 1; threads <= 4; ++threads) {
                rows r = {.count = count};
                const int strips = fw_row_front_strips(count, ticks, threads);
                assert_true(strips >= 1 && strips <= threads);
                fw_row_front_run(count, ticks, strips, move, &r);
                assert_int_equal(r.faults, 0);
                for (int row = 0; row < count; ++row) assert_int_equal(r.made[row], ticks);
            }
}

static void strips_are_as_many_as_have_room(void **state)
{
    (void)state;
    assert_int_equal(fw_row_front_strips(64, 8, 4), 4);
    assert_int_equal(fw_row_front_strips(63, 8, 4), 3);
    assert_int_equal(fw_row_front_strips(64, 8, 2), 2);
    assert_int_equal(fw_row_front_strips(15, 8, 4), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_makes_every_tick_in_time),
        cmocka_unit_test(strips_are_as_many_as_have_room),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
