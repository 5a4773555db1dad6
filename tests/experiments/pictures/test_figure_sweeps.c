/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_sweeps.c - what pictures of sweeps hand to their figures, looked at on its way there,
 * and held against closed forms; and what they refuse to draw. */
#include "tests/support/laws.h"

#include "experiments/drawing/palette.h"
#include "experiments/pictures/plot_sweep_parts.h"
#include "experiments/study/sweep_table.h"
#include "tests/support/flying_sheets.h"
#include "tests/support/program.h"
#include "tests/support/seen_figures.h"

SEEN_FIGURE(fw_figure_map, fw_figure_map_plan)
SEEN_FIGURE(fw_figure_stack, fw_figure_stack_plan)

static char sweep_folder[64];

static fw_sweep_table table;

static double centre_of(double x0, double v)
{
    return x0 + 1.5 + 40 * v;
}

static void make_sweep(const char *text, const char *options)
{
    char line[512];
    make_quick_folder(sweep_folder, sizeof sweep_folder);
    write_scenario(sweep_folder, "flight.yaml", text);
    snprintf(line, sizeof line, "run flight.yaml -q --no-plot -o . -j 1 %s", options);
    run_program(sweep_folder, line); /* whether it fails is not asked here */
    assert_fine(fw_sweep_table_read(&table, sweep_folder, 2, &error));
}

static void remove_sweep(void)
{
    fw_sweep_table_clear(&table);
    remove_folder(sweep_folder);
}

static const double starts[] = {0, 2}, speeds[] = {.1, .2, .3};

/* Along v, which has more values: a line for each x0, in their order, and what was expected. */
static void look_at_lines(const void *plan)
{
    const fw_figure_stack_plan *sweep = plan;
    static const char *const names[] = {"x0 = 0", "x0 = 2"};
    assert_int_equal(sweep->chart_count, 1);
    assert_string_equal(sweep->label.text, "v");
    assert_string_equal(sweep->charts->label.text, "centre of mass x, at the end (length)");
    assert_int_equal(sweep->charts->curve_count, 4);
    for (int n = 0; n < 2; ++n) {
        const fw_curve *measured = &sweep->charts->curves[n], *expected = measured + 2;
        assert_string_equal(measured->label, names[n]);
        assert_int_equal(measured->count, 3);
        assert_int_equal(measured->colour, expected->colour);
        assert_int_equal(expected->look, FW_CURVE_DASHES);
        for (int k = 0; k < 3; ++k) {
            assert_close(measured->x[k], speeds[k], 0);
            assert_close(measured->y[k], centre_of(starts[n], speeds[k]), 1e-9);
            assert_close(expected->y[k], 1.5 + 40 * speeds[k], 1e-9);
        }
    }
    expect_caption("Drawn: centre-of-mass.sheet x, at the end. ");
    expect_caption("Dashes: what is expected. Reduced units.");
}

/* Numbers in cells, and the line where the centre comes to 10, between cases. */
static void look_at_grid(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    assert_int_equal(map->columns, 3);
    assert_int_equal(map->rows, 2);
    assert_string_equal(map->p_label.text, "v");
    assert_string_equal(map->q_label.text, "x0");
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 2; ++row) {
            char text[32];
            const double centre = centre_of(starts[row], speeds[column]);
            snprintf(text, sizeof text, "%.3g", centre);
            assert_close(map->values[3 * row + column], centre, 1e-9);
            assert_string_equal(map->texts[3 * row + column], text);
        }
    assert_string_equal(map->p_names[1].name, "0.2");
    assert_string_equal(map->q_names[1].name, "2");
    assert_int_equal(map->curve_count, 2);
    const fw_curve *marks = &map->curves[1];
    assert_int_equal(marks->count, 3);
    for (int n = 0; n < 3; ++n) {
        const double v = .1 * (1 + marks->x[n]), x0 = 2 * marks->y[n];
        assert_close(centre_of(x0, v), 10, 1e-9);
    }
    expect_caption("Line: it is 10, by straight lines between cases, with the standard error");
}

/* Over the rows of the table that it is given, x0 is chosen for x. */
static void look_at_turned_map(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    assert_int_equal(map->columns, 2);
    assert_string_equal(map->p_label.text, "x0");
    assert_close(map->values[2 * 2 + 1], centre_of(2, .3), 1e-9);
    assert_close(map->colouring.range.low, 3, 0);
    assert_close(map->colouring.range.high, 4, 0);
    assert_true(map->colouring.logarithmic);
    assert_int_equal(map->colouring.map, FW_PALETTE_WARM);
    expect_caption("Nowhere does it pass 100. ");
}

static void sweep_is_drawn_as_lines_and_as_a_map(void **state)
{
    (void)state;
    static const double ten = 10, hundred = 100;
    static const char *const two[] = {"centre-of-mass", "energy"};
    const struct {
        fw_plot_wish wish;
        const char *words;
    } refused[] = {
        {{.kind = "map", .palette = "rainbow"}, "there is no palette 'rainbow', expected one of "},
        {{.kind = "map", .body = "sheet"}, "a picture of kind map does not draw one body"},
        {{.kind = "map", .x_range = {1, 2}}, "kind map does not draw a chosen part of its axes"},
        {{.kind = "map", .height = 30}, "kind map does not draw charts"},
        {{.level = &ten}, "a picture of kind sweep does not draw a level"},
        {{.range = {1, 2}}, "kind sweep does not draw a range of colours"},
        {{.in_steps = true}, "kind sweep does not draw anything over steps"},
        {{.until = 3}, "does not draw anything from one step until another"},
        {{.steps = (int64_t[]){3}, .step_count = 1}, "does not draw steps"},
        {{.field = "speed"}, "does not draw a field"},
        {{.with = two, .with_count = 1}, "does not draw several results"},
        {{.kind = "field"}, "pictures of kind field are drawn in the folders of its cases, here "},
        {{.kind = "map", .picture = "one"}, "both the picture one and the kind map, expected one"},
        {{.picture = "one"}, "has no picture one"},
        {{.kind = "map", .observables = two, .observable_count = 2},
         "a map shows one observable, but 2 are wished for"},
        {{.observables = two + 1, .observable_count = 1},
         "the sweep has no energy, expected a quantity in sweep.csv"},
    };
    make_sweep(
        FLIGHT("v: {values: [.2, .1, .3]}, x0: {values: [2, 0]}", "value: 1.5 + 40*v, within: 5"),
        "");
    draw_from(sweep_folder, &(fw_plot_wish){.file = NEVER_DRAWN}, look_at_lines);
    draw_from(sweep_folder, &(fw_plot_wish){.file = NEVER_DRAWN, .kind = "map", .level = &ten},
              look_at_grid);
    const fw_plot_wish turned = {.file = NEVER_DRAWN,
                                 .kind = "map",
                                 .along = "x0",
                                 .level = &hundred,
                                 .range = {3, 4},
                                 .logarithmic = true,
                                 .palette = "warm"};
    draw_from(sweep_folder, &turned, look_at_turned_map);
    for (size_t n = 0; n < sizeof refused / sizeof *refused; ++n)
        assert_refused(look_at(sweep_folder, &refused[n].wish, look_at_grid), FW_BAD_INPUT,
                       refused[n].words);
    remove_sweep();
}

/* --- a bisection --- */

static bool by_factors;

/* Each colour is that of the nearest case of its line, and the line passes where the centre comes
 * to 10, within half of what the bisection was told; from -40 it does not, and from 2 it does. */
static void look_at_bisection(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    assert_int_equal(map->columns, 3);
    assert_string_equal(map->p_names[0].name, "-40");
    assert_null(map->texts);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < map->rows; ++row) {
            const double place = map->q_first + row * map->q_step;
            double nearest = INFINITY, wanted = NAN;
            for (int r = 0; r < table.row_count; ++r) {
                const double v = table.values[2 * r], at = by_factors ? log10(v) : v;
                if (table.values[2 * r + 1] != column * 2 - (column == 0 ? 40 : 2)) continue;
                if (fabs(at - place) < nearest) wanted = centre_of(table.values[2 * r + 1], v);
                nearest = fmin(nearest, fabs(at - place));
            }
            assert_close(map->values[row * 3 + column], wanted, 1e-9);
        }
    assert_int_equal(map->q_name_count, 5);
    const double top = by_factors ? log10(.5) : .5;
    assert_close(map->q_first + (map->rows - .5) * map->q_step, top, 1e-12);
    assert_close(map->q_names[4].at, top, 1e-12);
    assert_string_equal(map->q_names[4].name, "0.5");
    const fw_curve *line = &map->curves[0], *marks = &map->curves[1];
    assert_int_equal(line->count, 3);
    assert_true(isnan(line->y[0]));
    assert_int_equal(marks->count, 2);
    for (int n = 0; n < 2; ++n) {
        const double found = by_factors ? pow(10, marks->y[n]) : marks->y[n];
        const double within = by_factors ? marks->error[n] * found * log(10) : marks->error[n];
        assert_close(marks->x[n], n + 1, 0);
        assert_close(line->y[n + 1], marks->y[n], 0);
        assert_close(found, (8.5 - starts[n]) / 40, within);
        assert_true(within > 0 && within <= .005);
    }
    expect_caption("Each colour is that of the nearest of ");
    expect_caption("Line: it crosses 10, found by bisection, with its uncertainty. ");
}

static void look_at_no_crossing(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    assert_int_equal(map->curves[1].count, 0);
    expect_caption("Nowhere does it pass 10. ");
}

static void bisection_is_drawn_with_its_thresholds(void **state)
{
    (void)state;
    static const double three = 3;
    static const char text[] =
        FLIGHT("v: {from: .01, to: .5, tolerance: .01, unit: length/time}, x0: {values: "
               "[-40, 0, 2]}",
               "crosses: 10, value: .2, within: 9");
    const fw_plot_wish map = {.file = NEVER_DRAWN, .kind = "map"};
    for (int k = 0; k < 3; ++k) {
        static const char *const options[] = {"",
                                              "--set study.sweep.parameters.v.spacing=logarithmic",
                                              "--set study.sweep.parameters.x0.values=[-40,-42]"};
        by_factors = k == 1;
        make_sweep(text, options[k]);
        draw_from(sweep_folder, &map, k < 2 ? look_at_bisection : look_at_no_crossing);
        const fw_plot_wish elsewhere = {.kind = "map", .level = &three};
        assert_refused(look_at(sweep_folder, &elsewhere, look_at_no_crossing), FW_BAD_INPUT,
                       "the sweep was not bisected for centre-of-mass.sheet x, at the end of 3, "
                       "and has no line there");
        remove_sweep();
    }
}

/* --- tables by hand --- */

static fw_plot_sweep made;
static fw_page blank;

/* A scenario that is never run, and room for its numbers. */
static void make_table(const char *text, const char *const *columns, int count)
{
    fw_scenario *scenario;
    assert_fine(fw_scenario_read(&scenario, "t.yaml", text, strlen(text), NULL, 0, &error));
    made = (fw_plot_sweep){.directory = "it", .scenario = scenario};
    assert_fine(fw_sweep_table_create(&made.table, &scenario->study.sweep, 3, &error));
    for (int c = 0; c < count; ++c)
        assert_non_null(fw_sweep_table_column(&made.table, columns[c], "energy"));
    blank = fw_page_default();
    blank.file = NEVER_DRAWN;
}

static void clear_table(void)
{
    fw_sweep_table_clear(&made.table);
    fw_scenario_destroy(made.scenario);
}

/* A number, its standard error, and how its cell has both: the error in units of the last digit,
 * with two digits where it begins with 1. */
static const struct {
    double mean, error;
    const char *text; /* NULL: none */
} cells[] = {
    {.83, .02, "0.83(2)"},
    {.831, .012, "0.831(12)"},
    {1.4e-5, 2e-6, "1.4(2)e-5"},
    {123456, 700, "1.235(7)e5"},
    {1234, 30, "1234(30)"},
    {1.5, 1e-9, "1.5"},
    {2, NAN, "2"},
    {2.5, 0, "2.5"},
    {NAN, NAN, NULL},
    {.5, INFINITY, "0.5"},
    {0, 3, "0(3)"},
    {-.25, .01, "-0.250(10)"},
};

static void look_at_cells(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    assert_int_equal(map->columns, 4);
    assert_int_equal(map->rows, 3);
    for (int n = 0; n < 12; ++n) {
        if (!cells[n].text) assert_null(map->texts[n]);
        if (cells[n].text) assert_string_equal(map->texts[n], cells[n].text);
    }
    assert_int_equal(map->curve_count, 0);
    expect_caption("Drawn: energy, at the end. ");
    expect_caption("Means over 3 seeds, with their standard errors. ");
    expect_caption("Grey: no number. ");
    /* Units of nature stand beside the axes. */
    assert_null(strstr(seen_caption, "Reduced units"));
}

#define BY_HAND(parameters)                                                                        \
    "units: {length: 1 nm, energy: 1 eV, mass: 1 u}\n" FLIGHT(parameters, "above: 0")

static void cells_have_as_many_digits_as_their_errors(void **state)
{
    (void)state;
    static const char *const columns[] = {"energy, at the end"};
    make_table(BY_HAND("v: {values: [1, 2, 3, 4]}, x0: {values: [0, 1, 2]}"), columns, 1);
    made.scenario->study.seeds = 3;
    for (int r = 0; r < 12; ++r) {
        const int n = 4 * (int)made.table.values[2 * r + 1] + (int)made.table.values[2 * r] - 1;
        made.table.columns[0].mean[r] = cells[n].mean;
        made.table.columns[0].error[r] = cells[n].error;
    }
    look = look_at_cells;
    looks = 0;
    static const char *const energy[] = {"energy"};
    const fw_plot_wish wish = {.kind = "map", .observables = energy, .observable_count = 1};
    assert_fine(fw_plot_sweep_map(&made, &wish, NULL, &blank, &error));
    assert_int_equal(looks, 1);
    const fw_plot_wish along = {
        .kind = "map", .observables = energy, .observable_count = 1, .along = "energy"};
    assert_refused(fw_plot_sweep_map(&made, &along, NULL, &blank, &error), FW_BAD_INPUT,
                   "a map lies over two parameters, and energy is a number of the sweep");
    const fw_plot_wish unlike = {.kind = "map"};
    assert_refused(fw_plot_sweep_map(&made, &unlike, NULL, &blank, &error), FW_BAD_INPUT,
                   "it: the sweep has no number to draw");
    clear_table();
    make_table(BY_HAND("v: {values: [1, 2]}"), columns, 1);
    assert_refused(fw_plot_sweep_map(&made, &wish, NULL, &blank, &error), FW_BAD_INPUT,
                   "it: a map needs two parameters, but the sweep has 1");
    clear_table();
}

/* More lines than there are colours: the first, the last and some between; two numbers of two
 * bodies, each called by its own. */
static void look_at_many_lines(const void *plan)
{
    const fw_figure_stack_plan *sweep = plan;
    const int drawn = sweep->charts[0].curve_count;
    char words[64];
    assert_int_equal(sweep->chart_count, 2);
    assert_int_equal(drawn, FW_PALETTE_KINDS - 1);
    assert_string_equal(sweep->charts[0].label.text, "energy of one, at the end (eV)");
    assert_string_equal(sweep->charts[1].label.text, "energy of two, at the end (eV)");
    assert_string_equal(sweep->charts[0].curves[0].label, "x0 = 0");
    assert_string_equal(sweep->charts[0].curves[drawn - 1].label, "x0 = 11");
    assert_null(sweep->charts[1].curves[0].label);
    assert_close(sweep->charts[0].curves[drawn - 1].y[1], 11 + 100 * 3, 0);
    assert_close(sweep->charts[1].curves[0].y[0], -1, 0);
    snprintf(words, sizeof words, "%d of 12 lines. ", drawn);
    expect_caption(words);
    expect_caption("Drawn: energy.one, at the end; energy.two, at the end. ");
}

static void lines_beyond_all_colours_are_left_out(void **state)
{
    (void)state;
    static const char *const columns[] = {"energy.one, at the end", "energy.two, at the end"};
    static const char *const energy[] = {"energy"};
    make_table(BY_HAND("v: {values: [1, 3]}, x0: {from: 0, to: 11, count: 12}"), columns, 2);
    for (int r = 0; r < made.table.row_count; ++r) {
        const double v = made.table.values[2 * r], x0 = made.table.values[2 * r + 1];
        made.table.columns[0].mean[r] = x0 + 100 * v;
        made.table.columns[1].mean[r] = -v;
    }
    look = look_at_many_lines;
    looks = 0;
    const fw_plot_wish wish = {.observables = energy, .observable_count = 1, .along = "v"};
    assert_fine(fw_plot_sweep_curves(&made, &wish, NULL, &blank, &error));
    assert_int_equal(looks, 1);
    clear_table();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sweep_is_drawn_as_lines_and_as_a_map),
        cmocka_unit_test(bisection_is_drawn_with_its_thresholds),
        cmocka_unit_test(cells_have_as_many_digits_as_their_errors),
        cmocka_unit_test(lines_beyond_all_colours_are_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
