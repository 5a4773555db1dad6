/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_killed_writer.c - 300 runs killed at random moments, see test_killed_writer.c. */
#include "tests/support/laws.h"

#include "tests/support/killed_writer.h"

static bool enough_running(const casualties *count)
{
    return count->running > 50 && count->frames > 500;
}

static bool enough_torn(const casualties *count)
{
    return count->torn > 30;
}

static void killed_run_loses_no_committed_frame(void **state)
{
    (void)state;
    casualties count = kill_writers(write_until_killed, 300, 2, enough_running);
    assert_true(enough_running(&count));
    skip_unseen();
}

static void file_that_is_cut_is_never_misread(void **state)
{
    (void)state;
    casualties count = kill_writers(cut_until_killed, 300, 3, enough_torn);
    assert_true(enough_torn(&count));
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(killed_run_loses_no_committed_frame),
                                       cmocka_unit_test(file_that_is_cut_is_never_misread)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
