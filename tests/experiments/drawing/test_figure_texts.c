/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_texts.c - texts of a figure stand where they belong, and none upon another. */
#include "tests/support/drawn_figure.h"
#include "tests/support/seen_texts.h"

#include <float.h>

static const seen_text *expect_text(const char *begin, int n)
{
    const seen_text *found = find_seen_text(begin, n);
    if (!found) fail_msg("'%s' is not written %d times", begin, n + 1);
    return found;
}

static void draw_map(const fw_figure_map_plan *plan)
{
    fw_error error;
    fw_page page = page_with(NULL, NULL);
    page.file = picture_name("map-texts", ".png");
    seen_text_count = 0;
    assert_int_equal(fw_figure_map(&page, plan, &error), FW_OK);
}

/* In the middle of its cell, beside the name of its row; lower where a curve passes. */
static void a_number_stands_in_the_middle_of_its_cell(void **state)
{
    (void)state;
    const double values[] = {1, 2}, line_x[] = {-.5, .5}, line_y[] = {0, 1};
    const char *const texts[] = {"one", "two"};
    const fw_axis_name rows[] = {{0, "first"}, {1, "second"}};
    const fw_curve line = {.count = 2, .x = line_x, .y = line_y, .look = FW_CURVE_LINE};
    fw_figure_map_plan plan = {.columns = 1,
                               .rows = 2,
                               .values = values,
                               .p_step = 1,
                               .q_step = 1,
                               .q_names = rows,
                               .q_name_count = 2,
                               .texts = texts};
    draw_map(&plan);
    assert_close(expect_text("one", 0)->at.y, expect_text("first", 0)->at.y, 1e-9);
    assert_close(expect_text("two", 0)->at.y, expect_text("second", 0)->at.y, 1e-9);
    plan.curves = &line;
    plan.curve_count = 1;
    draw_map(&plan);
    assert_true(expect_text("one", 0)->at.y > expect_text("first", 0)->at.y + 5);
}

/* On a column of a journal. */
static void names_of_panels_side_by_side_have_room(void **state)
{
    (void)state;
    enum { PANELS = 3 };
    const char *const label = "a quantity with a long name (unit)";
    const double x[] = {0, 1, 0, 1}, y[] = {0, 0, 1, 1}, of_particles[] = {0, .5, 1};
    const fw_view_body body = {.count = 4, .x = x, .y = y, .spacing = 1};
    const fw_view view = {.bodies = &body, .body_count = 1, .name = "step 123456, time 7890.12 ps"};
    const fw_curve curve = {.count = 3, .x = of_particles, .y = of_particles};
    const fw_chart chart = {.curves = &curve, .curve_count = 1};
    const fw_figure_pair pair = {.view = &view, .chart = &chart};
    const fw_figure_pair pairs[PANELS] = {pair, pair, pair};
    const fw_figure_pairs_plan plan = {.pairs = pairs, .pair_count = PANELS, .x_label = {label, 0}};
    fw_error error;
    fw_page page = page_with(NULL, NULL);
    page.file = picture_name("pairs-texts", ".png");
    page.width = 120;
    seen_text_count = 0;
    assert_int_equal(fw_figure_pairs(&page, &plan, &error), FW_OK);
    for (int k = 0; k + 1 < PANELS; ++k) {
        const seen_text *name = expect_text(view.name, k), *below = expect_text(label, k);
        assert_true(fw_canvas_text_width(name->text, name->size, false) <
                    expect_text(view.name, k + 1)->at.x - name->at.x);
        assert_true(fw_canvas_text_width(label, below->size, false) <
                    expect_text(label, k + 1)->at.x - below->at.x);
    }
}

/* Room around a body is that of a spacing, whether or not there are links. */
static void particles_without_links_fill_their_panel(void **state)
{
    (void)state;
    enum { SIDE = 9, COUNT = SIDE * SIDE };
    double x[COUNT], y[COUNT];
    for (int k = 0; k < COUNT; ++k) {
        x[k] = k % SIDE;
        y[k] = k / SIDE;
    }
    const fw_figure_force push = {0, {1, 0}, true};
    const fw_figure_forces_panel panel = {.name = "crystal",
                                          .count = COUNT,
                                          .original_x = x,
                                          .original_y = y,
                                          .x = x,
                                          .y = y,
                                          .forces = &push,
                                          .force_count = 1};
    const fw_figure_forces_plan plan = {.panels = &panel, .panel_count = 1};
    fw_error error;
    fw_page page = page_with(NULL, NULL);
    page.file = picture_name("forces-texts", ".png");
    seen_text_count = 0;
    assert_int_equal(fw_figure_forces(&page, &plan, &error), FW_OK);
    assert_non_null(find_seen_text("8", 0));
    assert_null(find_seen_text("10", 0));
    assert_null(find_seen_text("\u22122", 0));
}

/* What cannot be negative is not shown as if it could. */
static void a_count_that_stays_zero_is_shown_from_zero_up(void **state)
{
    (void)state;
    const double x[] = {0, 1, 2}, none[] = {0, 0, 0}, some[] = {0, 0, 3};
    fw_curve curve = {.count = 3, .x = x, .y = none};
    const fw_chart chart = {.curves = &curve, .curve_count = 1};
    assert_close(fw_chart_range_of_y(&chart).low, -.05, DBL_EPSILON);
    assert_close(fw_chart_range_of_y(&chart).high, 1.05, DBL_EPSILON);
    curve.y = some;
    assert_close(fw_chart_range_of_y(&chart).low, -.15, DBL_EPSILON);
    const fw_colour_scale scale = fw_colour_scale_for((fw_colouring){.label = {NULL, 0}}, none, 3);
    assert_close(scale.range.low, 0, 0);
    assert_close(scale.range.high, 1, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_stands_in_the_middle_of_its_cell),
        cmocka_unit_test(names_of_panels_side_by_side_have_room),
        cmocka_unit_test(particles_without_links_fill_their_panel),
        cmocka_unit_test(a_count_that_stays_zero_is_shown_from_zero_up),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
