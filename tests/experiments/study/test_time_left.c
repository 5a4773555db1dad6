/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_time_left.c - the time that is left, in seconds, minutes and hours. */
#include "tests/support/laws.h"

#include "experiments/study/progress.h"
#include "tests/support/program.h"

/* What is said of `left` pieces of work, when 100 were done in 100 s. */
static void say(char *text, size_t size, double left)
{
    FILE *out = tmpfile();
    assert_non_null(out);
    fw_progress p = fw_progress_begin(out, "run");
    p.total = 100 + left;
    p.done = 99;
    p.every = 0;
    p.began = fw_progress_clock() - 100;
    fw_progress_add(&p, 1);
    take_stream(out, text, size);
}

/* A second more may have passed on a busy machine. */
static void time_is_told_in_its_unit(void **state)
{
    (void)state;
    static const struct {
        double left;
        const char *said[2];
    } cases[] = {{12, {"89 %, 12 s left", "89 %, 12 s left"}},
                 {125.01, {"44 %, 2 min 05 s left", "44 %, 2 min 06 s left"}},
                 {3541.01, {"2 %, 59 min 01 s left", "2 %, 59 min 02 s left"}},
                 {7200, {"1 %, 2.0 h left", "1 %, 2.0 h left"}},
                 {180000, {"0 %, 50.0 h left", "0 %, 50.1 h left"}}};
    for (size_t n = 0; n < sizeof cases / sizeof *cases; ++n) {
        char text[256], a[64], b[64];
        say(text, sizeof text, cases[n].left);
        snprintf(a, sizeof a, "run: %s\n", cases[n].said[0]);
        snprintf(b, sizeof b, "run: %s\n", cases[n].said[1]);
        if (strcmp(text, a) != 0 && strcmp(text, b) != 0) fail_msg("%sexpected %s", text, a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(time_is_told_in_its_unit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
