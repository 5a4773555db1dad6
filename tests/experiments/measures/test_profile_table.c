/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_profile_table.c - a profile on its way to files and people keeps each number in its cell. */
#include "tests/support/laws.h"

#include "experiments/measures/profile_table.h"
#include "experiments/storage/csv.h"
#include "experiments/text/text.h"
#include "tests/support/scratch.h"

enum { BINS = 3 };

/* A number of its own for every cell. */
static double cell(int column, int bin, int part)
{
    return 1000. * (column + 1) + 10 * bin + part + .25;
}

static fw_profile_table *make_table(void)
{
    fw_profile_table *table;
    assert_fine(fw_profile_table_create(&table, BINS, 'y', &error));
    for (int b = 0; b <= BINS; ++b) table->edges[b] = -1.5 + .5 * b;
    for (int c = 0; c < FW_PROFILE_COLUMNS; ++c)
        for (int b = 0; b < BINS; ++b)
            fw_profile_table_column(table, (fw_profile_column)c)[b] =
                (fw_outcome){cell(c, b, 0), cell(c, b, 1), cell(c, b, 2), cell(c, b, 3)};
    return table;
}

static void next_is(char **line, double expected)
{
    char *found;
    assert_non_null(*line);
    *line = fw_csv_cut(*line, &found);
    assert_close(fw_csv_read_number(found), expected, 0);
}

static void every_cell_of_the_csv_is_its_own(void **state)
{
    (void)state;
    static const char *const heads[] = {"", " error", "control ", " error"};
    char folder[64], path[96], text[8192], *rest = text;
    fw_profile_table *table = make_table();
    fw_profile_table_column(table, FW_PROFILE_ORDER)[1].control = NAN;
    make_quick_folder(folder, sizeof folder);
    assert_fine(fw_profile_table_write(table, folder, "profile.csv", &error));
    snprintf(path, sizeof path, "%s/profile.csv", folder);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    char *line = fw_text_line(&rest), *found;
    line = fw_csv_cut(line, &found);
    assert_string_equal(found, "y_from");
    line = fw_csv_cut(line, &found);
    assert_string_equal(found, "y_until");
    for (int c = 0; c < FW_PROFILE_COLUMNS; ++c)
        for (int n = 0; n < 4; ++n) {
            char head[128];
            snprintf(head, sizeof head, "%s%s%s", n < 2 ? "" : heads[2], fw_profile_columns[c].name,
                     n == 2 ? "" : heads[n]);
            assert_non_null(line);
            line = fw_csv_cut(line, &found);
            assert_string_equal(found, head);
        }
    for (int b = 0; b < BINS; ++b) {
        line = fw_text_line(&rest);
        next_is(&line, -1.5 + .5 * b);
        next_is(&line, -1 + .5 * b);
        for (int c = 0; c < FW_PROFILE_COLUMNS; ++c)
            for (int n = 0; n < 4; ++n) {
                if (c == FW_PROFILE_ORDER && b == 1 && n == 2) {
                    line = fw_csv_cut(line, &found);
                    assert_true(isnan(fw_csv_read_number(found)));
                } else {
                    next_is(&line, cell(c, b, n));
                }
            }
    }
    fw_profile_table_destroy(table);
    remove_folder(folder);
}

/* Middle of the bin, experiment with its error, control with its own. */
static void people_read_each_number_beside_its_error(void **state)
{
    (void)state;
    char text[16384];
    fw_profile_table *table = make_table();
    fw_outcome *order = fw_profile_table_column(table, FW_PROFILE_ORDER);
    order[1] = (fw_outcome){1.573, .018, 976, 50};
    table->layer[FW_LAYER_FAR] = (fw_outcome){2.5, .25, 12, 1.5};
    fw_units argon = {
        .length_text = "0.382 nm", .energy_text = "10.32 meV", .mass_text = "39.948 u"};
    const char *key;
    assert_fine(fw_units_complete(&argon, &key, &error));
    FILE *out = tmpfile();
    fw_profile_table_print(table, FW_PROFILE_ORDER, &argon, out);
    rewind(out);
    text[fread(text, 1, sizeof text - 1, out)] = '\0';
    fclose(out);
    assert_non_null(strstr(text, "\n  -0.750  1.573 +- 0.018        976 +- 50 "));
    const char *far = strstr(text, "\nlayer-far ");
    assert_non_null(far);
    assert_non_null(strstr(far, "2.50 +- 0.25"));
    assert_non_null(strstr(far, "force = 4.328 pN"));
    assert_true(strstr(far, "2.50 +- 0.25") < strstr(far, "12.0 +- 1.5"));
    fw_profile_table_destroy(table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_cell_of_the_csv_is_its_own),
        cmocka_unit_test(people_read_each_number_beside_its_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
