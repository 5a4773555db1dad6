/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot_profile.c - what the picture of a profile shows, as numbers before it is drawn. */
#include "tests/support/laws.h"

#include "experiments/pictures/plot_parts.h"
#include "tests/support/scratch.h"

static void each_side_has_its_own_numbers_over_the_middles_of_bins(void **state)
{
    (void)state;
    fw_profile_table *table;
    double x[3], values[3], errors[3];
    assert_fine(fw_profile_table_create(&table, 3, 'x', &error));
    for (int b = 0; b <= 3; ++b) table->edges[b] = 4 + .5 * b;
    fw_outcome *rates = fw_profile_table_column(table, FW_PROFILE_BOND_BREAKING);
    rates[0] = (fw_outcome){1, .1, 10, .7};
    rates[1] = (fw_outcome){2, .2, 20, NAN};
    rates[2] = (fw_outcome){NAN, NAN, 30, .9};
    fw_plot_profile_values(table, FW_PROFILE_BOND_BREAKING, false, x, values, errors);
    for (int b = 0; b < 3; ++b) assert_close(x[b], 4.25 + .5 * b, 0);
    assert_close(values[0], 1, 0);
    assert_close(values[1], 2, 0);
    assert_true(isnan(values[2]));
    assert_close(errors[0], .1, 0);
    assert_close(errors[1], .2, 0);
    assert_close(errors[2], 0, 0);
    fw_plot_profile_values(table, FW_PROFILE_BOND_BREAKING, true, x, values, errors);
    for (int b = 0; b < 3; ++b) assert_close(x[b], 4.25 + .5 * b, 0);
    for (int b = 0; b < 3; ++b) assert_close(values[b], 10 * (b + 1), 0);
    assert_close(errors[0], .7, 0);
    assert_close(errors[1], 0, 0);
    assert_close(errors[2], .9, 0);
    fw_profile_table_destroy(table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_side_has_its_own_numbers_over_the_middles_of_bins)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
