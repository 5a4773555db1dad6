/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_killed_run.c - whenever `fretwork run` is killed, h5py finds every committed frame as it
 * should be, and `fretwork resume` ends with the results of the run that was not killed: see
 * killed_runs.py. slow_killed_run.c does it 300 times. */
#include "tests/support/killed_runs.h"

static void killed_run_loses_nothing(void **state)
{
    (void)state;
    kill_runs(40, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(killed_run_loses_nothing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
