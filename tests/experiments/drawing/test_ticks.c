/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_ticks.c - ranges, the round numbers in them, and numbers in print. */
#include "tests/support/laws.h"

#include "experiments/drawing/axis.h"
#include "experiments/text/range.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

static fw_ticks ticks_of(double low, double high, bool logarithmic, int wanted)
{
    fw_ticks ticks;
    fw_ticks_find(&ticks, (fw_range){low, high}, logarithmic, wanted);
    return ticks;
}

static void assert_labels(const fw_ticks *ticks, int count, const char *const *labels)
{
    for (int k = 0; k < ticks->count && k < count; ++k) {
        assert_string_equal(ticks->label[k], labels[k]);
    }
    assert_int_equal(ticks->count, count);
}

static void round_numbers_get_plain_labels(void **state)
{
    (void)state;
    fw_ticks ticks = ticks_of(-1.02, 1.02, false, 4);
    assert_labels(&ticks, 5, (const char *const[]){"\u22121.0", "\u22120.5", "0.0", "0.5", "1.0"});
    assert_string_equal(ticks.note, "");
    ticks = ticks_of(0, 20500, false, 4);
    assert_labels(&ticks, 5,
                  (const char *const[]){"0", "5000", "10\u2009000", "15\u2009000", "20\u2009000"});
    assert_true(ticks.minor_count > 10);
}

static void large_and_small_numbers_share_a_power_of_ten(void **state)
{
    (void)state;
    fw_ticks ticks = ticks_of(0, 3.1e-5, false, 3);
    assert_labels(&ticks, 4, (const char *const[]){"0", "1", "2", "3"});
    assert_string_equal(ticks.note, "\u00d710^{\u22125}");
    ticks = ticks_of(-2e22, 2e22, false, 4);
    assert_labels(&ticks, 5, (const char *const[]){"\u22122", "\u22121", "0", "1", "2"});
    assert_string_equal(ticks.note, "\u00d710^{22}");
}

static void a_tiny_range_is_counted_from_a_round_number(void **state)
{
    (void)state;
    fw_ticks ticks = ticks_of(1 - 1.1e-13, 1 + 1.1e-13, false, 4);
    assert_labels(&ticks, 5, (const char *const[]){"\u22121.0", "\u22120.5", "0.0", "0.5", "1.0"});
    assert_string_equal(ticks.note, "\u00d710^{\u221213} + 1");
    ticks = ticks_of(-30000.4, -30000.395, false, 4);
    assert_non_null(strstr(ticks.note, "\u2212 30\u2009000.4"));
}

static void ticks_lie_inside_any_range(void **state)
{
    (void)state;
    const double middles[] = {0, 1, -1, 1e4, 3.7e-9, -2.5e17, 0.1234567890123, 1e-300, 1e300};
    const double extents[] = {1e-12, 1e-6, 1e-3, .37, 1, 7.3, 1e5};
    for (size_t m = 0; m < sizeof middles / sizeof *middles; ++m) {
        for (size_t e = 0; e < sizeof extents / sizeof *extents; ++e) {
            double half = extents[e] * (middles[m] == 0 ? 1 : fabs(middles[m]));
            fw_range range = {middles[m] - half, middles[m] + half};
            for (int wanted = 2; wanted <= 10; ++wanted) {
                fw_ticks ticks;
                fw_ticks_find(&ticks, range, false, wanted);
                /* The nearest round step is at most 1.58 (sqrt 2.5) times off. */
                assert_in_range(ticks.count, wanted / 2, 2 * wanted + 1);
                for (int k = 0; k < ticks.count; ++k) {
                    double slack = 1e-6 * half + 4 * DBL_EPSILON * fabs(ticks.at[k]);
                    assert_true(ticks.at[k] >= range.low - slack);
                    assert_true(ticks.at[k] <= range.high + slack);
                    assert_true(k == 0 || ticks.at[k] > ticks.at[k - 1]);
                    assert_null(strchr(ticks.label[k], 'e'));
                    assert_null(strchr(ticks.label[k], '-'));
                    assert_true(strlen(ticks.label[k]) < 24);
                }
            }
        }
    }
}

static void logarithmic_axes_count_in_decades(void **state)
{
    (void)state;
    fw_ticks ticks = ticks_of(1e-16, 2e-12, true, 5);
    assert_labels(&ticks, 5,
                  (const char *const[]){"10^{\u221216}", "10^{\u221215}", "10^{\u221214}",
                                        "10^{\u221213}", "10^{\u221212}"});
    ticks = ticks_of(.05, 200, true, 5);
    assert_labels(&ticks, 4, (const char *const[]){"0.1", "1", "10", "100"});
    assert_close(ticks.minor[0], .05, 1e-12);
    ticks = ticks_of(1.5, 60, true, 5);
    assert_labels(&ticks, 5, (const char *const[]){"2", "5", "10", "20", "50"});
    ticks = ticks_of(1e-300, 1e300, true, 6);
    assert_in_range(ticks.count, 4, 8);
    ticks = ticks_of(1.01, 1.04, true, 4);
    assert_in_range(ticks.count, 3, 6);
}

static void numbers_are_printed_as_people_do(void **state)
{
    (void)state;
    const struct {
        double value;
        int digits;
        const char *text;
    } cases[] = {
        {0, 3, "0"},
        {-0.0, 3, "0"},
        {1.5, 3, "1.5"},
        {-12345.678, 7, "\u221212\u2009345.68"},
        {2000, 4, "2000"},
        {1e-5, 2, "10^{\u22125}"},
        {-1e6, 3, "\u221210^{6}"},
        {6.02214e23, 3, "6.02\u00d710^{23}"},
        {.001, 2, "0.001"},
        {9.9999e5, 2, "10^{6}"},
        {999999, 6, "999\u2009999"},
        {INFINITY, 3, "\u221e"},
        {-INFINITY, 3, "\u2212\u221e"},
        {NAN, 3, "undefined"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        char text[64];
        fw_ticks_print_number(text, sizeof text, cases[k].value, cases[k].digits);
        assert_string_equal(text, cases[k].text);
    }
}

static void ranges_pass_over_what_is_not_finite(void **state)
{
    (void)state;
    const double values[] = {3, NAN, -2, INFINITY, 0, -INFINITY};
    fw_range range = fw_range_empty();
    assert_true(fw_range_is_empty(range));
    fw_range_include(&range, values, 6, false);
    assert_close(range.low, -2, 0);
    assert_close(range.high, 3, 0);
    range = fw_range_empty();
    fw_range_include(&range, values, 6, true);
    assert_close(range.low, 3, 0);
}

static void a_trimmed_range_leaves_out_the_wild_ones(void **state)
{
    (void)state;
    double values[1001];
    for (int k = 0; k < 1000; ++k) values[k] = (k * 7) % 1000;
    values[1000] = 1e9;
    fw_range range = fw_range_of_most(values, 1001, .01, false);
    assert_close(range.low, 10, 0);
    assert_close(range.high, 990, 0);
    /* On both sides of 0, equal ones, and what is no number: by hand. */
    const double signs[] = {-3, NAN, 0, -1e-300, 5, -3, INFINITY, 1e-3, -7, 5};
    range = fw_range_of_most(signs, 10, .2, false);
    assert_close(range.low, -3, 0);
    assert_close(range.high, 5, 0);
    range = fw_range_of_most(signs, 10, .5, true);
    assert_close(range.low, 5, 0);
    range = fw_range_of_most(signs, 10, 0, false);
    assert_close(range.low, -7, 0);
    range = fw_range_of_most(signs, 10, .45, false);
    assert_close(range.low, -1e-300, 0);
    assert_close(range.high, 0, 0);
    assert_true(fw_range_is_empty(fw_range_of_most(signs + 8, 1, 0, true)));
}

static void every_range_has_room_to_draw(void **state)
{
    (void)state;
    const fw_range wishes[] = {
        {INFINITY, -INFINITY}, {0, 0},           {1, 1},      {-1e4, -1e4}, {1, 1 + 2.3e-16},
        {-DBL_MAX, DBL_MAX},   {1e-320, 1e-320}, {0, 1e-310}, {-3, 5},      {1e-200, 1e200}};
    for (size_t k = 0; k < sizeof wishes / sizeof *wishes; ++k) {
        for (int logarithmic = 0; logarithmic < 2; ++logarithmic) {
            fw_range range = fw_range_roomy(wishes[k], .05, logarithmic);
            assert_true(isfinite(range.low) && isfinite(range.high));
            assert_true(range.low < range.high);
            assert_true(isfinite(range.high - range.low));
            assert_true(!logarithmic || range.low > 0);
            fw_ticks ticks;
            fw_ticks_find(&ticks, range, logarithmic, 5);
            assert_in_range(ticks.count, 1, 12);
        }
    }
}

/* Four hundred powers of ten need no room beside them. */
static void a_range_of_all_powers_is_drawn_as_it_is(void **state)
{
    (void)state;
    const fw_range range = fw_range_roomy((fw_range){1e-200, 1e200}, .05, true);
    assert_true(range.low == 1e-200 && range.high == 1e200);
}

/* What stands at a tick is its value times the factor of the label, and is round. */
static void an_axis_shows_its_values_times_a_factor(void **state)
{
    (void)state;
    for (int logarithmic = 0; logarithmic < 2; ++logarithmic) {
        fw_axis axis = {.range = {.3, 21}, .logarithmic = logarithmic, .label = {"x (nm)", .4}};
        fw_axis_prepare(&axis, 100, true);
        assert_true(axis.ticks.count >= 2);
        for (int k = 0; k < axis.ticks.count; ++k) {
            assert_close(axis.ticks.at[k] * .4, atof(axis.ticks.label[k]), 1e-12);
            assert_true(axis.ticks.at[k] >= .3 && axis.ticks.at[k] <= 21);
        }
        assert_true(axis.ticks.minor_count > 0);
        for (int k = 0; k < axis.ticks.minor_count; ++k)
            assert_true(axis.ticks.minor[k] >= .3 - 1e-9 && axis.ticks.minor[k] <= 21 + 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(round_numbers_get_plain_labels),
        cmocka_unit_test(large_and_small_numbers_share_a_power_of_ten),
        cmocka_unit_test(a_tiny_range_is_counted_from_a_round_number),
        cmocka_unit_test(ticks_lie_inside_any_range),
        cmocka_unit_test(logarithmic_axes_count_in_decades),
        cmocka_unit_test(numbers_are_printed_as_people_do),
        cmocka_unit_test(ranges_pass_over_what_is_not_finite),
        cmocka_unit_test(a_trimmed_range_leaves_out_the_wild_ones),
        cmocka_unit_test(every_range_has_room_to_draw),
        cmocka_unit_test(a_range_of_all_powers_is_drawn_as_it_is),
        cmocka_unit_test(an_axis_shows_its_values_times_a_factor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
