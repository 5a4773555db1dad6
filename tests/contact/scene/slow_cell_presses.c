/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_cell_presses.c - 400 random presses of automata, whose colours move in turn: energy and
 * momentum of bodies and pistons hold to rounding, nothing passes anything, friction only takes,
 * and every step is resolved. */
#include "tests/support/presses.h"

static void random_presses_keep_their_books_and_their_room(void **state)
{
    (void)state;
    assert_random_presses(CELLS, 100);
}

static void presses_that_go_on_elsewhere_have_the_same_bytes(void **state)
{
    (void)state;
    assert_presses_go_on_elsewhere(CELLS, 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_presses_keep_their_books_and_their_room),
        cmocka_unit_test(presses_that_go_on_elsewhere_have_the_same_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
