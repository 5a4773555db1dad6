/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_label.c - quantities and their units beside an axis. */
#include "experiments/drawing/label.h"
#include "tests/support/laws.h"

static void assert_label(const char *quantity, const char *unit, const char *expected)
{
    char label[64];
    fw_label_print(label, sizeof label, quantity, unit);
    assert_string_equal(label, expected);
}

static void a_unit_stands_in_brackets_with_its_powers_raised(void **state)
{
    (void)state;
    assert_label("wave-speed", "length/time", "wave speed (length/time)");
    assert_label("mean-square-displacement", "length^2", "mean square displacement (length^{2})");
    assert_label("rate", "length^2/time^-1", "rate (length^{2}/time^{-1})");
    assert_label("odd", "a^b", "odd (a^b)");
}

static void what_has_no_unit_of_its_own_shows_none(void **state)
{
    (void)state;
    assert_label("kinetic-fraction", "1", "kinetic fraction");
    assert_label("kinetic-fraction", "", "kinetic fraction");
    assert_label("kinetic-fraction", NULL, "kinetic fraction");
    assert_label("energy", "energy", "energy");
}

static void a_label_that_is_too_long_is_cut(void **state)
{
    (void)state;
    char label[8];
    fw_label_print(label, sizeof label, "elongation", "length^2");
    assert_string_equal(label, "elongat");
    fw_label_print(label, sizeof label, "wave", "length^2");
    assert_string_equal(label, "wave (l");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_unit_stands_in_brackets_with_its_powers_raised),
        cmocka_unit_test(what_has_no_unit_of_its_own_shows_none),
        cmocka_unit_test(a_label_that_is_too_long_is_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
