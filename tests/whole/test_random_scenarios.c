/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_random_scenarios.c - for some seconds: random scenarios within the schema, and what must
 * hold of each; see random_scenarios.py. */
#include "tests/support/laws.h"
#include "tests/support/scratch.h"

static void what_check_accepts_runs_and_reads_back(void **state)
{
    char folder[64], arguments[256];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(arguments, sizeof arguments, "%s %s 8 1", FW_PROGRAM, folder);
    const int status = run_python("random_scenarios.py", arguments);
    if (status > 0) fail_msg("failed: random_scenarios.py %s", arguments);
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_check_accepts_runs_and_reads_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
