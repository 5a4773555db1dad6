/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_killed_run.c - 300 runs of the program killed at random moments: see test_killed_run.c. */
#include "tests/support/laws.h"

#include "tests/support/scratch.h"

static void killed_run_loses_nothing(void **state)
{
    char folder[64], arguments[256];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(arguments, sizeof arguments, "%s %s 300 2", FW_PROGRAM, folder);
    int status = run_python("killed_runs.py", arguments);
    if (status > 0) fail_msg("failed: killed_runs.py %s", arguments);
    remove_folder(folder);
    if (status == -1) {
        print_message("no h5py here: not tested\n");
        skip();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(killed_run_loses_nothing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
