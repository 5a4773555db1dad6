/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_cell_presses.c - some of the random presses of automata, whose colours move in turn: energy
 * and momentum of bodies and pistons hold to rounding, nothing passes anything, friction only
 * takes, and every step is resolved. (slow_cell_presses.c has 400.) */
#include "tests/support/presses.h"

static void random_presses_keep_their_books_and_their_room(void **state)
{
    (void)state;
    assert_random_presses(CELLS, 7);
}

static void presses_that_go_on_elsewhere_have_the_same_bytes(void **state)
{
    (void)state;
    assert_presses_go_on_elsewhere(CELLS, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_presses_keep_their_books_and_their_room),
        cmocka_unit_test(presses_that_go_on_elsewhere_have_the_same_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
