/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_killed_run.c - 300 runs of the program killed at random moments: see test_killed_run.c. */
#include "tests/support/killed_runs.h"

static void killed_run_loses_nothing(void **state)
{
    (void)state;
    kill_runs(300, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(killed_run_loses_nothing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
