/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_palette.c - colours keep the order of the numbers they stand for. */
#include "tests/support/laws.h"

#include "experiments/drawing/colour_scale.h"

#include <string.h>

/* CIE lightness L* of an sRGB colour (CIE 15, white D65): an independent measure of lightness. */
static double lightness_of(fw_colour colour)
{
    const double parts[3] = {colour.red, colour.green, colour.blue};
    const double weights[3] = {.2126, .7152, .0722};
    double luminance = 0;
    for (int k = 0; k < 3; ++k) {
        double v = parts[k];
        luminance += weights[k] * (v <= .04045 ? v / 12.92 : pow((v + .055) / 1.055, 2.4));
    }
    return luminance > .008856 ? 116 * cbrt(luminance) - 16 : 903.3 * luminance;
}

static double lightness_at(fw_palette_map map, double part)
{
    return lightness_of(fw_palette_at(map, part));
}

static void all_maps_but_one_get_lighter_in_even_steps(void **state)
{
    (void)state;
    enum { STEPS = 20 };
    static const fw_palette_map maps[] = {FW_PALETTE_SEQUENTIAL, FW_PALETTE_WARM, FW_PALETTE_GREY};
    for (int m = 0; m < 3; ++m) {
        double low = lightness_at(maps[m], 0), high = lightness_at(maps[m], 1);
        assert_true(high - low > 60);
        for (int k = 0; k < STEPS; ++k) {
            double step =
                lightness_at(maps[m], (k + 1.) / STEPS) - lightness_at(maps[m], k / (double)STEPS);
            /* L* and the lightness of Oklab differ by some percent for strong colours. */
            assert_close(step * STEPS / (high - low), 1, .35);
        }
    }
    const fw_colour middle = fw_palette_at(FW_PALETTE_GREY, .3);
    assert_close(middle.red, middle.blue, 1e-3);
    assert_close(middle.red, middle.green, 1e-3);
}

static void maps_are_found_by_their_names(void **state)
{
    (void)state;
    char names[] = FW_PALETTE_NAMES, *next = NULL;
    int map = 0;
    for (char *name = strtok_r(names, ", ", &next); name; name = strtok_r(NULL, ", ", &next))
        assert_int_equal(fw_palette_find(name), map++);
    assert_int_equal(map, FW_PALETTE_MAPS);
    assert_int_equal(fw_palette_find("rainbow"), FW_PALETTE_MAPS);
}

static void the_diverging_map_is_lightest_in_the_middle_and_symmetric(void **state)
{
    (void)state;
    assert_true(lightness_at(FW_PALETTE_DIVERGING, .5) > 93);
    for (int k = 1; k <= 10; ++k) {
        double below = lightness_at(FW_PALETTE_DIVERGING, .5 - .05 * k);
        double above = lightness_at(FW_PALETTE_DIVERGING, .5 + .05 * k);
        assert_close(below, above, 5);
        assert_true(below < lightness_at(FW_PALETTE_DIVERGING, .5 - .05 * (k - 1)));
        assert_true(above < lightness_at(FW_PALETTE_DIVERGING, .5 + .05 * (k - 1)));
    }
}

/* Who sees no red or green still sees blue against yellow: the ends of the diverging map differ
 * along that axis. */
static void the_ends_of_the_diverging_map_differ_in_blue(void **state)
{
    (void)state;
    fw_colour cold = fw_palette_at(FW_PALETTE_DIVERGING, .15);
    fw_colour warm = fw_palette_at(FW_PALETTE_DIVERGING, .85);
    assert_true(cold.blue - cold.red > .4);
    assert_true(warm.red - warm.blue > .4);
}

static void kinds_repeat_and_differ(void **state)
{
    (void)state;
    for (int k = 0; k < FW_PALETTE_KINDS; ++k) {
        fw_colour one = fw_palette_kind(k), again = fw_palette_kind(k + FW_PALETTE_KINDS);
        assert_memory_equal(&one, &again, sizeof one);
        for (int other = 0; other < k; ++other) {
            fw_colour two = fw_palette_kind(other);
            double apart =
                fabs(one.red - two.red) + fabs(one.green - two.green) + fabs(one.blue - two.blue);
            assert_true(apart > .25);
        }
    }
}

static void values_that_change_sign_get_a_diverging_scale(void **state)
{
    (void)state;
    const double signs[] = {-1, NAN, .5, 3}, positive[] = {2, 5, -1e-18, INFINITY};
    fw_colour_scale scale = fw_colour_scale_for((fw_colouring){.trim = 0}, signs, 4);
    assert_int_equal(scale.map, FW_PALETTE_DIVERGING);
    assert_close(scale.range.low, -3, 0);
    assert_close(scale.range.high, 3, 0);
    assert_close(lightness_of(fw_colour_scale_at(&scale, 0)),
                 lightness_at(FW_PALETTE_DIVERGING, .5), 1e-9);
    scale = fw_colour_scale_for((fw_colouring){.trim = 0}, positive, 4);
    assert_int_equal(scale.map, FW_PALETTE_SEQUENTIAL);
}

static void a_scale_says_what_lies_beyond_it(void **state)
{
    (void)state;
    double values[200];
    for (int k = 0; k < 200; ++k) values[k] = k;
    values[7] = 1e12;
    fw_colour_scale scale = fw_colour_scale_for((fw_colouring){.trim = .02}, values, 200);
    assert_true(scale.range.high < 200);
    assert_true(scale.exceeds_high && scale.exceeds_low);
    scale = fw_colour_scale_for((fw_colouring){.range = {0, 2e12}}, values, 200);
    assert_false(scale.exceeds_high || scale.exceeds_low);
    fw_colour end = fw_colour_scale_at(&scale, 5e12), last = fw_palette_at(scale.map, 1);
    assert_memory_equal(&end, &last, sizeof end);
}

static void rounding_gets_no_colours(void **state)
{
    (void)state;
    const double values[] = {.07, .07 + 3e-15, .07 - 2e-15};
    fw_colour_scale scale = fw_colour_scale_for((fw_colouring){.trim = 0}, values, 3);
    double first = lightness_of(fw_colour_scale_at(&scale, values[0]));
    assert_close(lightness_of(fw_colour_scale_at(&scale, values[1])), first, 1e-6);
    assert_close(lightness_of(fw_colour_scale_at(&scale, values[2])), first, 1e-6);
}

static void what_has_no_colour_is_grey(void **state)
{
    (void)state;
    const double values[] = {1, 10, 100};
    fw_colour_scale scale = fw_colour_scale_for((fw_colouring){.logarithmic = true}, values, 3);
    fw_colour undefined = fw_colour_scale_at(&scale, NAN), zero = fw_colour_scale_at(&scale, 0);
    assert_true(undefined.red == undefined.green && undefined.green == undefined.blue);
    assert_memory_equal(&undefined, &zero, sizeof zero);
    /* The middle of the decades is the middle of the map. */
    fw_colour middle = fw_colour_scale_at(&scale, 10);
    assert_close(lightness_of(middle), lightness_at(FW_PALETTE_SEQUENTIAL, .5), 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_maps_but_one_get_lighter_in_even_steps),
        cmocka_unit_test(maps_are_found_by_their_names),
        cmocka_unit_test(the_diverging_map_is_lightest_in_the_middle_and_symmetric),
        cmocka_unit_test(the_ends_of_the_diverging_map_differ_in_blue),
        cmocka_unit_test(kinds_repeat_and_differ),
        cmocka_unit_test(values_that_change_sign_get_a_diverging_scale),
        cmocka_unit_test(a_scale_says_what_lies_beyond_it),
        cmocka_unit_test(rounding_gets_no_colours),
        cmocka_unit_test(what_has_no_colour_is_grey),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
