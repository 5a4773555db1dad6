/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_asserts.c - the builds that look for faults run with asserts, and an assert ends the
 * program. Other builds have none: there the test is skipped. */
#include "core/array.h"
#include "tests/support/laws.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef NDEBUG
static void an_assert_ends_the_program(void **state)
{
    (void)state;
#ifdef FW_ASSERTS_EXPECTED
    fail_msg("NDEBUG is defined: this build runs without asserts");
#else
    skip();
#endif
}
#else
static void an_assert_ends_the_program(void **state)
{
    (void)state;
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        fw_state_list full = {.count = FW_STATE_CAPACITY};
        signal(SIGABRT, SIG_DFL);
        if (!freopen("/dev/null", "w", stderr)) _exit(1);
        fw_state_list_add(&full, "one too many", FW_F64, 0, NULL);
        _exit(0);
    }
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(an_assert_ends_the_program)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
