/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_free_ticks.c - ticks that are asked for together are those asked for one by one: of every
 * solid, as many as were asked for, under no forces and under steady ones, to the bit. */
#include "tests/support/solids.h"
#include "tests/support/steps.h"

enum { COLUMNS = 9, ROWS = 8 };

static uint64_t hash_of(fw_solid *solid)
{
    fw_state_list list = {0};
    fw_solid_place(solid);
    solid->model->state(solid, &list);
    return fw_state_list_hash(&list);
}

static void ticks_together_are_ticks_one_by_one(void **state)
{
    (void)state;
    static const int together[] = {2, 1, 37, 4, 1, 1, 64, 10};
    for (int k = 0; k < KINDS; ++k)
        for (int loaded = 0; loaded < 2; ++loaded) {
            fw_solid *one = shaken(&kinds[k], COLUMNS, ROWS, 0.02);
            fw_solid *other = shaken(&kinds[k], COLUMNS, ROWS, 0.02);
            int64_t ticks = 0;
            for (size_t n = 0; n < sizeof together / sizeof *together; ++n) {
                fw_error error;
                if (loaded && one->ticks % one->model->ticks_per_step == 0) {
                    push_at_random(one, &kinds[k], 0.02);
                    push_at_random(other, &kinds[k], 0.02);
                }
                assert_moved(fw_solid_move_free(one, together[n], &error), &error);
                for (int tick = 0; tick < together[n]; ++tick)
                    assert_moved(fw_solid_move(other, NULL, 0, &error), &error);
                ticks += together[n];
                assert_int_equal(one->ticks, ticks);
            }
            assert_int_equal(other->ticks, ticks);
            if (hash_of(one) != hash_of(other))
                fail_msg("%s%s: other bytes", kinds[k].name, loaded ? ", loaded" : "");
            fw_solid_destroy(one);
            fw_solid_destroy(other);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ticks_together_are_ticks_one_by_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
