/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_failing_disk.c - some calls to the disk fail once, with an error or since it is full, in
 * what people do most: the program says so, and leaves nothing that is half and looks whole. All
 * calls of all commands are in slow_failing_disk.c. */
#include "tests/support/laws.h"

#include "tests/support/failed_calls.h"

static char folder[64];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", two_blocks);
    const outcome seen = run_program(folder, "run file.yaml -o good --quiet --no-plot");
    expect_end(&seen, 0, "");
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

/* Under a sanitizer, and where branches are counted, the program asks the disk at fewer places. */
#if defined(FW_ASSERTS_EXPECTED) || defined(FW_COVERAGE)
#define LEAST(plain, sanitized) (sanitized)
#else
#define LEAST(plain, sanitized) (plain)
#endif

static void a_run_says_what_fails_and_can_go_on(void **state)
{
    (void)state;
    const failing_line run = {"run file.yaml -o out --quiet", "out", NULL, look_at_run, false};
    assert_true(fail_calls(folder, &run, EIO, 2, 16) >= 6);
    assert_true(fail_calls(folder, &run, ENOSPC, 3, 24) >= LEAST(3, 2));
}

static void a_picture_is_whole_or_not_there(void **state)
{
    (void)state;
    const failing_line plot = {"plot whole", "whole", "cp -r good whole", look_at_plot, false};
    assert_true(fail_calls(folder, &plot, EIO, 1, 6) >= 7);
    assert_true(fail_calls(folder, &plot, ENOSPC, 1, 3) >= 2);
}

/* Not a result without what could not be read, and not one that is called damaged. */
static void results_that_cannot_be_read_are_not_blamed(void **state)
{
    (void)state;
    const failing_line table = {"table good -o table.csv", "table.csv", NULL, NULL, false};
    assert_true(fail_calls(folder, &table, EIO, 2, 5) >= LEAST(6, 5));
    const failing_line list = {"list good --json", "", NULL, NULL, false};
    assert_true(fail_calls(folder, &list, EIO, 3, 6) >= LEAST(6, 4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_run_says_what_fails_and_can_go_on, begin, end),
        cmocka_unit_test_setup_teardown(a_picture_is_whole_or_not_there, begin, end),
        cmocka_unit_test_setup_teardown(results_that_cannot_be_read_are_not_blamed, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
