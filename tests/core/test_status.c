/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_status.c - sentences of failures: what is too long loses its middle and no letter's half. */
#include "core/status.h"
#include "tests/support/laws.h"

#include <string.h>

static fw_error error;

static void a_short_sentence_is_as_it_was(void **state)
{
    (void)state;
    assert_int_equal(fw_fail(&error, FW_BAD_INPUT, "%s is %d", "n", 3), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "n is 3");
    assert_int_equal(fw_fail_within(&error, "file %s", "f"), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "file f: n is 3");
    assert_int_equal(fw_fail(NULL, FW_DIVERGED, "nobody listens"), FW_DIVERGED);
    assert_int_equal(fw_fail_within(NULL, "file %s", "f"), FW_SYSTEM_FAILED);
}

/* Letters of two and of three bytes, which the cuts meet in every place. */
static void a_long_sentence_keeps_whole_letters_at_both_ends(void **state)
{
    (void)state;
    static const char *const letters[] = {"a", "\xc3\xa9", "\xe2\x82\xac"};
    static char text[3 * 4096 + 64];
    for (int k = 0; k < 3; ++k)
        for (int shift = 0; shift < 3; ++shift) {
            const size_t size = strlen(letters[k]);
            size_t length = (size_t)shift;
            memset(text, '.', length);
            for (; length < 3 * 4096; length += size) memcpy(text + length, letters[k], size + 1);
            strcpy(text + length, "end");
            fw_fail(&error, FW_BAD_INPUT, "%s", text);
            const char *gap = strstr(error.sentence, "[...]");
            assert_non_null(gap);
            const size_t head = (size_t)(gap - error.sentence), tail = strlen(gap + 5);
            assert_memory_equal(error.sentence, text, head);
            assert_string_equal(gap + 5, text + length + 3 - tail);
            assert_true((head - (size_t)shift) % size == 0 && (tail - 3) % size == 0);
            const size_t whole = head + 5 + tail;
            assert_true(whole < FW_SENTENCE_SIZE && whole + 2 * size >= FW_SENTENCE_SIZE);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_short_sentence_is_as_it_was),
        cmocka_unit_test(a_long_sentence_keeps_whole_letters_at_both_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
