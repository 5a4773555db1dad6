/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_colour_bar.c - a colour bar has the colour of each number beside that number, and a map has
 * it in that number's cell. */
#include "experiments/drawing/colour_bar.h"
#include "experiments/drawing/figure_parts.h"
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

/* Rows from below, columns from the left. */
static void a_cell_of_a_map_has_the_colour_of_its_number(void **state)
{
    (void)state;
    enum { COLUMNS = 3, ROWS = 2 };
    const double values[ROWS * COLUMNS] = {0, 5, 1, 4, 2, 3};
    const fw_figure_map_plan plan = {.columns = COLUMNS,
                                     .rows = ROWS,
                                     .values = values,
                                     .p_first = -2,
                                     .p_step = 0.5,
                                     .q_first = 7,
                                     .q_step = 3,
                                     .colouring = {.map = FW_PALETTE_SEQUENTIAL}};
    const fw_colour_scale scale = fw_colour_scale_for(plan.colouring, values, ROWS * COLUMNS);
    fw_panel panel = {
        .box = {10, 10, 60, 40}, .x = {.range = {-2.25, -0.75}}, .y = {.range = {5.5, 11.5}}};
    assert_int_equal(fw_canvas_create(&panel.canvas, "map.png", 80, 60, 200, NULL), FW_OK);
    fw_figure_draw_cells(&plan, &panel, &scale);
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column) {
            /* The middle, and near two corners. */
            const fw_colour expected = fw_colour_scale_at(&scale, values[row * COLUMNS + column]);
            const fw_vec2 at = {10 + 20 * column + 10, 50 - 20 * row - 10};
            assert_colour(panel.canvas, at, expected);
            assert_colour(panel.canvas, (fw_vec2){at.x - 9, at.y - 9}, expected);
            assert_colour(panel.canvas, (fw_vec2){at.x + 9, at.y + 9}, expected);
        }
    fw_canvas_destroy(panel.canvas);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bar_rises_from_its_low_end_to_its_high_one),
        cmocka_unit_test(a_cell_of_a_map_has_the_colour_of_its_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
