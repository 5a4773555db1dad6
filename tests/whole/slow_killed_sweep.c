/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_killed_sweep.c - sweeps of 40 cases, run by several engines and killed ten times, master and
 * workers: see killed_sweeps.py. Slurm is tried by hand: tests/manual/slurm-cluster. */
#include "tests/support/laws.h"
#include "tests/support/scratch.h"

static void kill_sweeps(const char *engine, int seed)
{
    char folder[64], arguments[256];
    make_quick_folder(folder, sizeof folder);
    snprintf(arguments, sizeof arguments, "%s %s %s 10 %d", FW_PROGRAM, folder, engine, seed);
    const int status = run_python("killed_sweeps.py", arguments);
    if (status > 0) fail_msg("failed: killed_sweeps.py %s", arguments);
    remove_folder(folder);
    skip_unseen();
}

static void one_job_killed_ten_times_changes_nothing(void **state)
{
    (void)state;
    kill_sweeps("jobs-1", 1);
}

static void two_jobs_killed_ten_times_change_nothing(void **state)
{
    (void)state;
    kill_sweeps("jobs-2", 2);
}

static void gnu_parallel_killed_ten_times_changes_nothing(void **state)
{
    (void)state;
    if (system("command -v parallel >/dev/null") != 0) skip();
    kill_sweeps("parallel", 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_job_killed_ten_times_changes_nothing),
        cmocka_unit_test(two_jobs_killed_ten_times_change_nothing),
        cmocka_unit_test(gnu_parallel_killed_ten_times_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
