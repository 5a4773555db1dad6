/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_random_scenarios.c - random scenarios within the schema, for longer. */
#include "tests/support/random_scenarios.h"

static void what_check_accepts_runs_and_reads_back(void **state)
{
    (void)state;
    try_random_scenarios(90, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_check_accepts_runs_and_reads_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
