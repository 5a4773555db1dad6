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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(csv_gives_every_text_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
