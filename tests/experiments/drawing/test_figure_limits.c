/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_limits.c - figures of data that nobody wishes for: none, far too much, not finite. */
#include "tests/support/drawn_figure.h"

static fw_status draw_motion(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_motion(page, data, error);
}

static fw_status draw_field(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_field(page, data, error);
}

static fw_status draw_stack(const fw_page *page, const void *data, fw_error *error)
{
    return fw_figure_stack(page, data, error);
}

static void walls_of_every_shape_are_drawn(void **state)
{
    (void)state;
    const fw_vec2 slope[3] = {{0, 14}, {12, 4}, {30, 4}};
    const fw_vec2 wedge[3] = {{20, 10}, {26, 10}, {23, 16}};
    const fw_vec2 wedge_turned[3] = {{12, 22}, {15, 26}, {18, 22}};
    const fw_vec2 middle[1] = {{24, 22}}, ring[1] = {{16, 14}};
    const fw_vec2 block[4] = {{3, 20}, {7, 20}, {7, 24}, {3, 24}};
    fw_outline walls[6] = {
        {.points = slope, .count = 3, .forbidden = FW_FORBIDDEN_RIGHT},
        {.points = wedge, .count = 3, .closed = true, .forbidden = FW_FORBIDDEN_INSIDE},
        {.points = wedge_turned, .count = 3, .closed = true, .forbidden = FW_FORBIDDEN_OUTSIDE},
        {.points = middle, .count = 1, .radius = 3, .forbidden = FW_FORBIDDEN_INSIDE},
        {.points = ring, .count = 1, .radius = 18, .forbidden = FW_FORBIDDEN_OUTSIDE},
        {.points = block, .count = 4, .closed = true, .forbidden = FW_FORBIDDEN_INSIDE}};
    walls[5].displacement = (fw_vec2){2, -3};
    const double x[4] = {8, 9, 8, 9}, y[4] = {14, 14, 15, 15}, field[4] = {-1, .5, NAN, 2};
    const fw_view_body body = {.count = 4, .x = x, .y = y, .field = field, .spacing = 1};
    const fw_view view = {.bodies = &body, .body_count = 1, .walls = walls, .wall_count = 6};
    fw_figure_field_plan plan = {.view = &view, .colouring = {.label = {"charge", 0}}};
    /* Too small a body for its walls: they are left out ... */
    draw_everywhere(draw_field, &plan, page_with("A small body in the middle of things", NULL),
                    "walls-left-out");
    /* ... and taken in where the body comes around. */
    const double path_x[3] = {4, 20, 30}, path_y[3] = {30, 16, 0};
    const fw_figure_path path = {path_x, path_y, 3};
    fw_figure_motion_plan motion = {
        .views = &view, .view_count = 1, .paths = &path, .path_count = 1};
    draw_everywhere(draw_motion, &motion, page_with("Walls of every shape", NULL), "walls");
}

static void one_particle_has_a_picture(void **state)
{
    (void)state;
    const double x = 1e4 + .25, y = -3e4, value = 5;
    const fw_view_body body = {.count = 1, .x = &x, .y = &y, .field = &value};
    const fw_view view = {.bodies = &body, .body_count = 1};
    fw_figure_field_plan plan = {.view = &view, .colouring = {.label = {"mass", 0}}};
    draw_everywhere(draw_field, &plan, page_with("One particle", NULL), "one-particle");
    const fw_figure_path path = {&x, &y, 1};
    fw_figure_motion_plan motion = {
        .views = &view, .view_count = 1, .paths = &path, .path_count = 1};
    draw_everywhere(draw_motion, &motion, page_with(NULL, NULL), "one-particle-motion");
}

static void nothing_has_a_picture_that_says_so(void **state)
{
    (void)state;
    const fw_view view = {.step = 7};
    fw_figure_field_plan plan = {.view = &view};
    draw_everywhere(draw_field, &plan, page_with(NULL, NULL), "no-particles");
    fw_figure_motion_plan motion = {.view_count = 0};
    draw_everywhere(draw_motion, &motion, page_with(NULL, NULL), "no-motion");
    const double gap[3] = {NAN, INFINITY, -INFINITY}, time[3] = {0, 1, 2};
    const fw_curve curves[2] = {{"none", 0, NULL, NULL, NULL, NULL, FW_CURVE_LINE, 0, NULL},
                                {"undefined", 3, time, gap, gap, NULL, FW_CURVE_LINE, 0, NULL}};
    const fw_chart charts[2] = {{.label = {"a", 0}, .curves = curves, .curve_count = 1},
                                {.label = {"b", 0}, .curves = curves + 1, .curve_count = 1}};
    fw_figure_stack_plan stack = {.charts = charts, .chart_count = 2, .label = {"time", 0}};
    draw_everywhere(draw_stack, &stack, page_with(NULL, NULL), "no-data");
}

static void a_hundred_thousand_particles_have_a_picture(void **state)
{
    (void)state;
    enum { ROW = 400, ROWS = 250, MANY = ROW * ROWS };
    double *numbers = malloc(3 * MANY * sizeof *numbers);
    assert_non_null(numbers);
    double *x = numbers, *y = numbers + MANY, *value = numbers + 2 * MANY;
    for (int k = 0; k < MANY; ++k) {
        int i = k % ROW, j = k / ROW;
        x[k] = i + .5 * (j % 2) + .1 * scatter((unsigned)k);
        y[k] = .866 * j + .1 * scatter((unsigned)k + 7);
        value[k] = sin(.05 * i) * cos(.03 * j) + .2 * scatter((unsigned)k);
    }
    value[5] = 1e9; /* one wild value must not wash out the rest */
    const fw_view_body body = {.count = MANY, .x = x, .y = y, .field = value, .spacing = 1};
    const fw_view view = {.bodies = &body, .body_count = 1};
    fw_figure_field_plan plan = {.view = &view,
                                 .colouring = {.label = {"pressure", 0}, .trim = .001}};
    fw_page page = page_with("A hundred thousand particles", NULL);
    draw_into(draw_field, &plan, page, "many", ".png");
    draw_into(draw_field, &plan, page, "many", ".pdf");
    draw_into(draw_field, &plan, page, "many", ".svg");
    file_bytes svg = read_file(picture_name("many", ".svg"));
    assert_whole_svg(&svg);
    assert_true(svg.count < 4000000);
    free(svg.bytes);
    free(numbers);
}

static void long_noisy_series_stay_small(void **state)
{
    (void)state;
    enum { LONG = 300000 };
    double *numbers = malloc(3 * LONG * sizeof *numbers);
    assert_non_null(numbers);
    double *time = numbers, *value = numbers + LONG, *error = numbers + 2 * LONG;
    for (int k = 0; k < LONG; ++k) {
        time[k] = k;
        value[k] = 1e22 * (3 + sin(2e-5 * k) + .3 * scatter((unsigned)k));
        error[k] = 2e21;
    }
    value[LONG / 2] = 6e22; /* a single spike is seen */
    const fw_curve curve = {"force", LONG, time, value, error, NULL, FW_CURVE_LINE, 0, NULL};
    const fw_chart charts[2] = {
        {.label = {"force", 0}, .curves = &curve, .curve_count = 1},
        {.label = {"force", 0}, .curves = &curve, .curve_count = 1, .logarithmic = true}};
    fw_figure_stack_plan stack = {.charts = charts, .chart_count = 2, .label = {"time / steps", 0}};
    draw_everywhere(draw_stack, &stack, page_with("Long", NULL), "long");
    file_bytes svg = read_file(picture_name("long", ".svg"));
    assert_true(svg.count < 4000000);
    free(svg.bytes);
    free(numbers);
}

static void many_instants_get_a_colour_bar(void **state)
{
    (void)state;
    enum { MANY = 24 };
    static double x[MANY][9], y[MANY][9], path_x[MANY], path_y[MANY];
    fw_view_body bodies[MANY];
    fw_view views[MANY];
    for (int k = 0; k < MANY; ++k) {
        for (int p = 0; p < 9; ++p) {
            x[k][p] = 1e4 + 3 * k + p % 3;
            y[k][p] = 1e4 + 8 * fabs(sin(.4 * k)) + p / 3;
        }
        path_x[k] = x[k][4];
        path_y[k] = y[k][4];
        bodies[k] = (fw_view_body){.count = 9, .x = x[k], .y = y[k], .spacing = 1};
        views[k] = (fw_view){.step = 1000 * k, .bodies = &bodies[k], .body_count = 1};
    }
    const fw_figure_path path = {path_x, path_y, MANY};
    fw_figure_motion_plan plan = {
        .views = views, .view_count = MANY, .paths = &path, .path_count = 1};
    draw_everywhere(
        draw_motion, &plan,
        page_with("A title that is much too long for one line of the page, and so has "
                  "to be broken into two of them",
                  "A caption with bytes that are no text: \xff\xfe, and with a raised "
                  "10^{−3} and a lowered c_{1} in it, which goes on and on until it has "
                  "to be broken."),
        "many-instants");
}

static void what_cannot_be_drawn_is_said(void **state)
{
    (void)state;
    fw_error error = {FW_OK, ""};
    fw_page page = fw_page_default();
    page.file = "picture.bmp";
    fw_figure_motion_plan nothing = {.view_count = 0};
    assert_int_equal(fw_figure_motion(&page, &nothing, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "'picture.bmp'"));
    page.file = PICTURES "no-such-folder/a.png";
    assert_int_equal(fw_figure_motion(&page, &nothing, &error), FW_SYSTEM_FAILED);
    assert_non_null(strstr(error.sentence, "no-such-folder/a.png"));
    page.file = "a.png";
    assert_int_equal(fw_figure_strip(&page, &(fw_figure_strip_plan){.columns = 1}, &error),
                     FW_BAD_INPUT);
    assert_int_equal(fw_figure_map(&page, &(fw_figure_map_plan){.columns = 1}, &error),
                     FW_BAD_INPUT);
    assert_int_equal(fw_figure_forces(&page, &(fw_figure_forces_plan){.panel_count = 0}, &error),
                     FW_BAD_INPUT);
    assert_int_equal(fw_figure_stack(&page, &(fw_figure_stack_plan){.label = {"x", 0}}, &error),
                     FW_BAD_INPUT);
    page.resolution = 1e6;
    assert_int_equal(fw_figure_motion(&page, &nothing, &error), FW_BAD_INPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_of_every_shape_are_drawn),
        cmocka_unit_test(one_particle_has_a_picture),
        cmocka_unit_test(nothing_has_a_picture_that_says_so),
        cmocka_unit_test(a_hundred_thousand_particles_have_a_picture),
        cmocka_unit_test(long_noisy_series_stay_small),
        cmocka_unit_test(many_instants_get_a_colour_bar),
        cmocka_unit_test(what_cannot_be_drawn_is_said),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
