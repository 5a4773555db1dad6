/* SPDX-License-Identifier: GPL-3.0-or-later */
/* slow_killed_writer.c - 300 runs killed at random moments, see test_killed_writer.c. */
#include "tests/laws.h"

#include "tests/killed_writer.h"

static void killed_run_loses_no_committed_frame(void **state)
{
    (void)state;
    casualties count = kill_writers(300, 2);
    assert_true(count.running > 50 && count.frames > 500);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(killed_run_loses_no_committed_frame)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
