/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_colour_bar.c - a colour bar has the colour of each number beside that number. */
#include "experiments/drawing/colour_bar.h"
#include "tests/support/laws.h"

static void assert_colour(fw_canvas *canvas, fw_vec2 at, fw_colour expected)
{
    const fw_colour found = fw_canvas_colour_at(canvas, at);
    /* Bytes, and half a step of the bar between two rows of pixels. */
    assert_close(found.red, expected.red, .02);
    assert_close(found.green, expected.green, .02);
    assert_close(found.blue, expected.blue, .02);
}

static void a_bar_rises_from_its_low_end_to_its_high_one(void **state)
{
    (void)state;
    const double values[] = {-1, 4};
    const fw_colouring wish = {.label = {"speed", 0}, .map = FW_PALETTE_SEQUENTIAL};
    const fw_colour_scale scale = fw_colour_scale_for(wish, values, 2);
    const fw_colour_bar bar = fw_colour_bar_for(scale, 80);
    fw_canvas *canvas;
    assert_int_equal(fw_canvas_create(&canvas, "bar.png", 60, 100, 200, NULL), FW_OK);
    fw_colour_bar_draw(&bar, canvas, 10, 10, 80);
    /* The middle of the bar: between the gap to the panel and the numbers. */
    double x = 10;
    while (fw_canvas_colour_at(canvas, (fw_vec2){x, 50}).red > .9) x += .2;
    x += 1.5;
    assert_colour(canvas, (fw_vec2){x, 89}, fw_colour_scale_at(&scale, -1 + 5 * 1. / 80));
    assert_colour(canvas, (fw_vec2){x, 50}, fw_colour_scale_at(&scale, 1.5));
    assert_colour(canvas, (fw_vec2){x, 11}, fw_colour_scale_at(&scale, 4 - 5 * 1. / 80));
    fw_canvas_destroy(canvas);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bar_rises_from_its_low_end_to_its_high_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
