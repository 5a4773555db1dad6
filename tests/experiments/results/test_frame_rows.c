/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_frame_rows.c - coordinates laid side by side, for every length, place and instruction set.
 */
#include "experiments/results/frame_kernels.h"
#include "tests/support/laws.h"

#include <stdlib.h>

enum { SPARE = 8, ROOM = 3 * FW_FRAME_BLOCK + 3 * SPARE };

static void assert_rows(int count, int shift, bool past_cache)
{
    double x[FW_FRAME_BLOCK], y[FW_FRAME_BLOCK];
    double *room = aligned_alloc(64, ROOM * sizeof *room), *rows = room + SPARE + shift;
    assert_non_null(room);
    for (int i = 0; i < count; ++i) {
        x[i] = i + 1;
        y[i] = -0.5 * i;
    }
    for (int n = 0; n < ROOM; ++n) room[n] = 77;
    FW_KERNELS_CHOSEN(fw_frames)->rows(x, y, count, past_cache, rows);
    for (int i = 0; i < count; ++i) {
        assert_true(rows[3 * i] == x[i] && rows[3 * i + 1] == y[i]);
        assert_true(rows[3 * i + 2] == 0 && !signbit(rows[3 * i + 2]));
    }
    for (int n = 0; n < ROOM; ++n)
        if (room + n < rows || room + n >= rows + 3 * count) assert_true(room[n] == 77);
    free(room);
}

static void rows_have_x_y_and_zero(void **state)
{
    (void)state;
    const int best = fw_instruction_set();
    for (int set = 0; set <= best; ++set) {
        assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(set), NULL), FW_OK);
        for (int past_cache = 0; past_cache < 2; ++past_cache)
            for (int shift = 0; shift < SPARE; ++shift) {
                for (int count = 0; count < 40; ++count) assert_rows(count, shift, past_cache);
                for (int less = 0; less < 9; ++less)
                    assert_rows(FW_FRAME_BLOCK - less, shift, past_cache);
            }
    }
    assert_int_equal(fw_instruction_set_use(fw_instruction_set_name(best), NULL), FW_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(rows_have_x_y_and_zero)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
