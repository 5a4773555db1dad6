/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_panel_texts.c - where words of figures stand that have to make room: labels of marks and
 * regions, of axes, cells and panels; lines of long titles; and what is left out. */
#include "tests/support/drawn_figure.h"
#include "tests/support/seen_texts.h"

static fw_error error;

static const seen_text *expect_text(const char *begin)
{
    const seen_text *found = find_seen_text(begin, 0);
    if (!found) fail_msg("'%s' is not written", begin);
    return found;
}

static fw_page seen_page(const char *title)
{
    fw_page page = page_with(title, NULL);
    page.file = picture_name("panel-texts", ".svg");
    seen_text_count = 0;
    return page;
}

/* What lies beside the paper has no label; two that would touch stand in two rows. */
static void labels_stand_over_what_they_name(void **state)
{
    (void)state;
    const double x[] = {0, 10}, y[] = {0, 1};
    const fw_curve curve = {.label = "curve", .count = 2, .x = x, .y = y};
    const fw_chart chart = {.curves = &curve, .curve_count = 1};
    const fw_figure_region regions[] = {{2, 4, "settle", 1}, {20, 30, "beyond", 1}, {4, 4, "", 1}};
    const fw_figure_mark marks[] = {
        {-5, "before"}, {4.1, "begin of it"}, {4.4, "end of it"}, {6, NULL}};
    const fw_figure_stack_plan plan = {.charts = &chart,
                                       .chart_count = 1,
                                       .label = {"time", 0},
                                       .regions = regions,
                                       .region_count = 3,
                                       .marks = marks,
                                       .mark_count = 4};
    const fw_page page = seen_page(NULL);
    assert_int_equal(fw_figure_stack(&page, &plan, &error), FW_OK);
    assert_null(find_seen_text("beyond", 0));
    assert_null(find_seen_text("before", 0));
    const seen_text *settle = expect_text("settle"), *end = expect_text("end of it");
    const double from = expect_text("2")->at.x, until = expect_text("4")->at.x;
    const double width = fw_canvas_text_width("settle", settle->size, false);
    assert_true(settle->at.x + width > from && settle->at.x < until);
    assert_true(fabs(expect_text("begin of it")->at.y - end->at.y) > 1);
}

/* Beside the power of ten of its numbers, and not upon it. */
static void a_label_makes_room_for_the_power_of_ten(void **state)
{
    (void)state;
    static const char label[] = "a quantity whose name and unit are about as wide as its axis";
    const double x[] = {0, 5e22}, y[] = {0, 1};
    const fw_curve curve = {.count = 2, .x = x, .y = y};
    const fw_chart chart = {.curves = &curve, .curve_count = 1};
    const fw_figure_stack_plan plan = {.charts = &chart, .chart_count = 1, .label = {label, 0}};
    fw_page page = seen_page(NULL);
    page.width = 100;
    assert_int_equal(fw_figure_stack(&page, &plan, &error), FW_OK);
    const seen_text *note = expect_text("\u00d710"), *below = expect_text(label);
    const double right = below->at.x + fw_canvas_text_width(label, below->size, false) / 2;
    assert_true(right < note->at.x - fw_canvas_text_width(note->text, note->size, false));
}

/* No number in a cell without one, none where they would be too small; below a marker it stands
 * high in its cell. */
static void numbers_of_cells_make_room(void **state)
{
    (void)state;
    const double values[] = {1, 2, 3}, at[] = {0, 1}, low[] = {-.36, NAN};
    const char *const texts[] = {"one", NULL, "three"};
    const fw_axis_name rows[] = {{0, "first"}, {2, "last"}};
    const fw_curve markers = {.count = 2, .x = at, .y = low, .look = FW_CURVE_MARKERS};
    fw_figure_map_plan plan = {.columns = 1,
                               .rows = 3,
                               .values = values,
                               .p_step = 1,
                               .q_step = 1,
                               .q_names = rows,
                               .q_name_count = 2,
                               .texts = texts,
                               .curves = &markers,
                               .curve_count = 1};
    fw_page page = seen_page(NULL);
    assert_int_equal(fw_figure_map(&page, &plan, &error), FW_OK);
    assert_true(expect_text("one")->at.y < expect_text("first")->at.y - 2);
    assert_true(expect_text("three")->at.y > expect_text("last")->at.y + 2);
    enum { MANY = 90 };
    double many[MANY];
    const char *same[MANY];
    for (int n = 0; n < MANY; ++n) {
        many[n] = n;
        same[n] = "0.123(4)";
    }
    plan.columns = MANY;
    plan.rows = 1;
    plan.values = many;
    plan.texts = same;
    page = seen_page(NULL);
    assert_int_equal(fw_figure_map(&page, &plan, &error), FW_OK);
    assert_null(find_seen_text("0.123(4)", 0));
}

/* Two bodies beside each other, an odd one below them, chains over the whole width, each in a row
 * of its own. */
static void bodies_stand_in_pairs_and_chains_in_rows(void **state)
{
    (void)state;
    const double square_x[] = {0, 1, 0, 1}, square_y[] = {0, 0, 1, 1};
    const double line_x[] = {0, 1, 2, 3}, line_y[] = {0, 0, 0, 0};
    const int links[] = {0, 1, 1, 1};
    const fw_figure_force forces[] = {
        {0, {1, 0}, true}, {1, {NAN, 0}, true}, {2, {1e-9, 0}, false}, {3, {2, 0}, false}};
    static const char *const names[] = {"one", "two", "three", "chain", "thread"};
    fw_figure_forces_panel panels[5];
    for (int n = 0; n < 5; ++n) {
        const double *x = n < 3 ? square_x : line_x, *y = n < 3 ? square_y : line_y;
        panels[n] = (fw_figure_forces_panel){.name = names[n],
                                             .count = 4,
                                             .original_x = x,
                                             .original_y = y,
                                             .x = x,
                                             .y = y,
                                             .links = links,
                                             .link_count = 2,
                                             .forces = forces,
                                             .force_count = n == 4 ? 0 : 4};
    }
    const fw_figure_forces_plan plan = {.panels = panels, .panel_count = 5};
    fw_page page = seen_page(NULL);
    assert_int_equal(fw_figure_forces(&page, &plan, &error), FW_OK);
    const seen_text *found[5];
    for (int n = 0; n < 5; ++n) found[n] = expect_text(names[n]);
    assert_close(found[0]->at.y, found[1]->at.y, 1e-9);
    assert_true(found[1]->at.x > found[0]->at.x + 40);
    for (int n = 2; n < 5; ++n) {
        assert_true(found[n]->at.y > found[n - 1]->at.y + 5);
        assert_true(found[n]->at.x < found[1]->at.x - 40);
    }
    /* Nothing pulls: no arrow explains a scale. One body alone has the whole page. */
    const fw_figure_forces_plan calm = {.panels = panels + 4, .panel_count = 1};
    page = seen_page(NULL);
    assert_int_equal(fw_figure_forces(&page, &calm, &error), FW_OK);
    assert_null(find_seen_text("force of", 0));
}

/* The largest of 1, 2 and 5 times a power of ten that is not above the largest force. */
static void arrows_say_what_they_are_long_for(void **state)
{
    (void)state;
    static const struct {
        double largest;
        fw_label unit;
        const char *words;
    } rows[] = {{1.99, {NULL, 0}, "force of 1"},
                {4.99, {NULL, 0}, "force of 2"},
                {51, {NULL, 0}, "force of 50"},
                {1.99, {"pN", 3}, "force of 5 pN"}};
    const double x[] = {0, 1}, y[] = {0, 1}, none[] = {0, 0};
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        const double force[] = {NAN, rows[n].largest};
        const fw_view_body body = {
            .count = 2, .x = x, .y = y, .force_x = force, .force_y = none, .spacing = 1};
        const fw_view view = {.bodies = &body, .body_count = 1};
        const fw_figure_strip_plan plan = {.views = &view, .view_count = 1};
        fw_page page = seen_page(NULL);
        page.force = rows[n].unit;
        assert_int_equal(fw_figure_strip(&page, &plan, &error), FW_OK);
        assert_string_equal(expect_text("force of")->text, rows[n].words);
    }
}

/* A word that no line can hold goes on in the next one. */
static void endless_words_are_cut(void **state)
{
    (void)state;
    char word[800];
    memset(word, 'w', sizeof word - 1);
    word[sizeof word - 1] = '\0';
    const fw_page page = seen_page(word);
    assert_int_equal(fw_figure_motion(&page, &(fw_figure_motion_plan){.view_count = 0}, &error),
                     FW_OK);
    const seen_text *second = find_seen_text("www", 1);
    assert_non_null(second);
    assert_true(second->at.y > expect_text("www")->at.y);
    assert_int_equal(strlen(second->text), 255); /* as much as is noted of it */
    assert_null(find_seen_text("www", 2));
}

static void figures_of_nothing_are_refused(void **state)
{
    (void)state;
    const fw_page page = seen_page(NULL);
    assert_int_equal(fw_figure_columns(&page, NULL, 0, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "has nothing to show"));
    for (int count = 0; count <= FW_FIGURE_PAIRS_MAX + 1; count += FW_FIGURE_PAIRS_MAX + 1)
        assert_int_equal(
            fw_figure_pairs(&page, &(fw_figure_pairs_plan){.pair_count = count}, &error),
            FW_BAD_INPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(labels_stand_over_what_they_name),
        cmocka_unit_test(a_label_makes_room_for_the_power_of_ten),
        cmocka_unit_test(numbers_of_cells_make_room),
        cmocka_unit_test(bodies_stand_in_pairs_and_chains_in_rows),
        cmocka_unit_test(arrows_say_what_they_are_long_for),
        cmocka_unit_test(endless_words_are_cut),
        cmocka_unit_test(figures_of_nothing_are_refused),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
