/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_csv.c - comma-separated values are read as they were written. */
#include "tests/support/laws.h"

#include "experiments/storage/csv.h"

#include <stdlib.h>

static void csv_gives_every_text_back(void **state)
{
    static const char *const texts[] = {"plain", "with, comma", "a \"quoted\" word", "", "\"", ","};
    enum { COUNT = sizeof texts / sizeof texts[0] };
    char *line = NULL, *cell;
    size_t size = 0;
    (void)state;
    FILE *out = open_memstream(&line, &size);
    assert_non_null(out);
    for (int n = 0; n < COUNT; ++n) {
        if (n > 0) fputc(',', out);
        fw_csv_write_text(out, texts[n]);
    }
    fputc('\n', out);
    fclose(out);
    char *at = line;
    for (int n = 0; n < COUNT; ++n) {
        assert_non_null(at);
        at = fw_csv_cut(at, &cell);
        assert_string_equal(cell, texts[n]);
    }
    assert_null(at);
    free(line);
}

static void csv_gives_every_number_back(void **state)
{
    static const double numbers[] = {0, 1. / 3, -2e300, 4.9e-324, 0.1, 1e22 / 7, INFINITY};
    (void)state;
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; ++n) {
        char *text = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&text, &size);
        assert_non_null(out);
        fw_csv_write_number(out, numbers[n]);
        fclose(out);
        assert_true(fw_csv_read_number(text) == numbers[n]);
        free(text);
    }
    assert_true(isnan(fw_csv_read_number("")));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(csv_gives_every_text_back),
                                       cmocka_unit_test(csv_gives_every_number_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
