/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_killed_writer.c - whenever a run is killed, every frame that counts is there, and the run
 * can go on to the file that it would have left unharmed. slow_killed_writer.c does it ten times
 * more. */
#include "tests/support/laws.h"

#include "tests/support/killed_writer.h"

static bool enough_running(const casualties *count)
{
    return count->running > 5 && count->frames > 50;
}

static bool enough_torn(const casualties *count)
{
    return count->torn > 3;
}

static void killed_run_loses_no_committed_frame(void **state)
{
    (void)state;
    casualties count = kill_writers(write_until_killed, 30, 1, enough_running);
    assert_true(enough_running(&count));
    skip_unseen();
}

static void file_that_is_cut_is_never_misread(void **state)
{
    (void)state;
    casualties count = kill_writers(cut_until_killed, 30, 3, enough_torn);
    assert_true(enough_torn(&count));
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(killed_run_loses_no_committed_frame),
                                       cmocka_unit_test(file_that_is_cut_is_never_misread)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
