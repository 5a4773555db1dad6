/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot_data.c - what pictures of a result show, as numbers before anything is drawn. */
#include "tests/support/laws.h"

#include "experiments/pictures/plot_choice.h"
#include "experiments/pictures/plot_compare.h"
#include "experiments/pictures/plot_exact.h"
#include "experiments/pictures/plot_extent.h"
#include "experiments/pictures/plot_parts.h"

#include "tests/support/plotted_run.h"

static fw_plot_result result;

static void open_result(void)
{
    assert_fine(fw_plot_result_open(&result, folder, &error));
}

/* At rest the forces of the links balance the external ones at every particle. The residual of the
 * sheet falls by far more than 1e-12 in 800 steps at a damping of 0.2. */
static void forces_on_a_resting_body_add_up_to_zero(void **state)
{
    (void)state;
    open_result();
    int64_t last = result.playback->frame_count - 1;
    const fw_plot_picture picture = {.frame_count = 1, .frames = &last};
    fw_plot_forces forces;
    assert_fine(fw_plot_forces_find(&forces, &result, &picture, &error));
    assert_int_equal(forces.panel_count, 2);
    const fw_figure_forces_panel *sheet = &forces.panels[0];
    assert_int_equal(sheet->count, 9);
    int external = 0;
    for (int n = 0; n < sheet->count; ++n) {
        fw_vec2 sum = {0, 0};
        for (int k = 0; k < sheet->force_count; ++k)
            if (sheet->forces[k].particle == n) sum = fw_vec2_add(sum, sheet->forces[k].force);
        assert_close(sum.x, 0, 1e-12);
        assert_close(sum.y, 0, 1e-12);
    }
    for (int k = 0; k < sheet->force_count; ++k) external += sheet->forces[k].external;
    assert_int_equal(external, 3);
    assert_int_equal(sheet->force_count, 3 + 2 * 12); /* both ends of 12 links */
    fw_plot_forces_clear(&forces);
    fw_plot_result_close(&result);
}

/* The rod has flown several spacings: it is compared with its shape at rest there, not with where
 * it came from. The mean displacement is taken out: 1e-12 is rounding. */
static void originals_travel_with_their_body(void **state)
{
    (void)state;
    open_result();
    int64_t last = result.playback->frame_count - 1;
    const fw_plot_picture picture = {.frame_count = 1, .frames = &last};
    fw_plot_forces forces;
    assert_fine(fw_plot_forces_find(&forces, &result, &picture, &error));
    const fw_figure_forces_panel *rod = &forces.panels[1];
    double way = 0;
    for (int n = 0; n < rod->count; ++n) way += rod->x[n] - rod->original_x[n];
    assert_close(way, 0, 1e-12);
    assert_close(rod->original_x[1] - rod->original_x[0], 1, 1e-12);
    assert_true(fabs(rod->original_x[0] - 10) > 1);
    assert_non_null(strstr(rod->name, "original moved along"));
    assert_close(forces.panels[0].original_x[0], 0, 0); /* the sheet is where it was */
    fw_plot_forces_clear(&forces);
    fw_plot_result_close(&result);
}

/* The path is that of the centre of mass as the solid knows it; unweighted it would miss it by
 * some tenths. The sheet, at rest in the end, moves as well. */
static void paths_are_those_of_the_centres_of_mass(void **state)
{
    (void)state;
    open_result();
    int64_t frames[2] = {3, 20};
    const fw_plot_picture picture = {.frame_count = 2, .frames = frames};
    fw_plot_paths paths;
    assert_fine(fw_plot_paths_find(&paths, &result, &picture, &error));
    const fw_figure_path *rod = &paths.path[paths.count - 1];
    assert_int_equal(rod->count, 18);
    fw_playback *playback = result.playback;
    int number = fw_playback_find_observable(playback, "centre-of-mass.rod");
    assert_true(number >= 0);
    double *centres = calloc((size_t)playback->sample_count * 2, sizeof *centres);
    assert_fine(fw_playback_read_observable(playback, number, centres, &error));
    for (int k = 0; k < rod->count; ++k) {
        int64_t step = result.steps[3 + k];
        /* Measured in every step; both sums round alike to some 1e-15. */
        assert_close(rod->x[k], centres[2 * step], 1e-12);
        assert_close(rod->y[k], centres[2 * step + 1], 1e-12);
    }
    free(centres);
    fw_plot_paths_clear(&paths);
    fw_plot_result_close(&result);
}

static void find_series(fw_plot_series *series, const char **names, int count, int64_t from,
                        int64_t until)
{
    const fw_plot_picture picture = {
        .asked = {.kind = FW_PICTURE_SERIES, .from = from, .until = until},
        .observables = names,
        .observable_count = count};
    assert_fine(fw_plot_series_find(series, &result, &picture, &error));
}

/* What curves have in common stands beside the axis, the rest in the legend. */
static void curves_are_named_by_what_tells_them_apart(void **state)
{
    (void)state;
    const char *names[] = {"elongation.x", "momentum.rod", "energy", "reaction.floor.y",
                           "momentum.rod.x"};
    fw_plot_series series;
    open_result();
    find_series(&series, names, 5, 0, INT64_MAX);
    assert_int_equal(series.panel_count, 4);
    assert_string_equal(series.charts[0].label.text, "elongation x (length)");
    assert_int_equal(series.charts[0].curve_count, 2);
    assert_string_equal(series.charts[0].curves[0].label, "sheet");
    assert_string_equal(series.charts[0].curves[1].label, "rod");
    assert_string_equal(series.charts[1].label.text, "momentum of rod");
    assert_int_equal(series.charts[1].curve_count, 2); /* x is not drawn twice */
    assert_string_equal(series.charts[1].curves[0].label, "x");
    assert_string_equal(series.charts[1].curves[1].label, "y");
    assert_string_equal(series.charts[2].label.text, "energy");
    assert_null(series.charts[2].curves[0].label);
    assert_string_equal(series.charts[3].label.text, "reaction y (force)"); /* there is one wall */
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
}

static void quantities_of_one_unit_share_a_panel(void **state)
{
    (void)state;
    const char *names[] = {"elongation.sheet", "centre-of-mass.sheet"};
    fw_plot_series series;
    open_result();
    find_series(&series, names, 2, 0, INT64_MAX);
    assert_int_equal(series.panel_count, 1);
    assert_string_equal(series.charts[0].label.text, "length of sheet");
    assert_string_equal(series.charts[0].curves[0].label, "elongation x");
    assert_string_equal(series.charts[0].curves[3].label, "centre of mass y");
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
}

/* The free rod's momentum is constant: its curve from step 100 to 120 has 21 equal values. */
static void a_series_shows_the_steps_between_its_ends(void **state)
{
    (void)state;
    const char *names[] = {"momentum.rod.x"};
    fw_plot_series series;
    open_result();
    find_series(&series, names, 1, 100, 120);
    const fw_curve *curve = &series.charts[0].curves[0];
    assert_int_equal(curve->count, 21);
    assert_close(curve->x[0], 100, 0);
    assert_close(curve->x[20], 120, 0);
    for (int k = 1; k < 21; ++k) assert_close(curve->y[k], curve->y[0], 1e-12);
    assert_true(fabs(curve->y[0]) > 1e-3);
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
}

/* Two curves in one place: the later one is dashed, or nobody would know of the first. */
static void a_curve_that_lies_on_another_is_dashed(void **state)
{
    (void)state;
    const char *names[] = {"reaction"}; /* nothing touches the floor: both components are zero */
    fw_plot_series series;
    open_result();
    find_series(&series, names, 1, 0, INT64_MAX);
    assert_int_equal(series.charts[0].curve_count, 2);
    assert_int_equal(series.charts[0].curves[0].look, FW_CURVE_LINE);
    assert_int_equal(series.charts[0].curves[1].look, FW_CURVE_DASHES);
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
}

/* The field at any step is drawn with the colours and the axes of the whole result, or those that
 * are asked for. */
static void colours_and_axes_are_those_of_the_whole_result(void **state)
{
    (void)state;
    fw_plot_picture picture = {.asked = {.kind = FW_PICTURE_FIELD, .field = {.text = "speed"}},
                               .frame_count = 1};
    fw_colouring first, last, asked;
    fw_view_bounds bounds;
    int64_t frames[2] = {0, 40};
    open_result();
    picture.frames = &frames[0];
    assert_fine(fw_plot_colours_find(&first, &result, &picture, &error));
    picture.frames = &frames[1];
    assert_fine(fw_plot_colours_find(&last, &result, &picture, &error));
    assert_true(first.range.low < first.range.high);
    assert_close(first.range.low, last.range.low, 0);
    assert_close(first.range.high, last.range.high, 0);
    assert_int_equal(first.map, last.map);
    picture.asked.range[0] = -1;
    picture.asked.range[1] = 3;
    assert_fine(fw_plot_colours_find(&asked, &result, &picture, &error));
    assert_close(asked.range.low, -1, 0);
    assert_close(asked.range.high, 3, 0);
    assert_fine(fw_plot_bounds_find(&bounds, &result, &error));
    double x[13], y[13];
    for (int k = 0; k < 2; ++k) {
        assert_fine(fw_playback_read_positions(result.playback, frames[k], x, y, &error));
        for (int n = 0; n < 13; ++n) {
            assert_true(bounds.x.low <= x[n] - .75 && x[n] + .75 <= bounds.x.high);
            assert_true(bounds.y.low <= y[n] - .75 && y[n] + .75 <= bounds.y.high);
        }
    }
    fw_plot_result_close(&result);
}

/* A heat bath is a dashed line beside the temperature, in each phase at its own. */
static void a_temperature_is_drawn_beside_what_is_set(void **state)
{
    (void)state;
    char directory[64];
    const char *names[] = {"temperature"};
    const fw_plot_picture picture = {.asked = {.kind = FW_PICTURE_SERIES, .until = INT64_MAX},
                                     .observables = names,
                                     .observable_count = 1};
    fw_plot_series series;
    make_folder(directory, sizeof directory);
    run_scenario("title: A bath\n"
                 "materials: {gas: {movable-particles: {}}}\n"
                 "bodies: {gas: {material: gas, lattice: hexagonal, shape: {rectangle: [3, 3]}, "
                 "temperature: 0.1}}\n"
                 "dynamics: {time-step: 0.005, damping: 1, temperature: 0.1}\n"
                 "phases: {cold: {until: 10}, hot: {until: 20, temperature: 0.3}}\n"
                 "measure: [temperature]\n"
                 "run: {steps: 20}\n",
                 directory);
    assert_fine(fw_plot_result_open(&result, directory, &error));
    assert_fine(fw_plot_series_find(&series, &result, &picture, &error));
    assert_int_equal(series.charts[0].curve_count, 2);
    const fw_curve *set = &series.charts[0].curves[1];
    assert_string_equal(set->label, "set by the heat bath");
    assert_close(set->y[5], .1, 0);
    assert_close(set->y[15], .3, 0);
    assert_close(set->y[20], .3, 0);
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
    remove_folder(directory);
}

/* The values stay reduced; what is shown beside the axis is .4 nm, .5 meV, and so on. */
static void axes_tell_the_units_of_nature(void **state)
{
    (void)state;
    char directory[64];
    const char *names[] = {"kinetic-energy", "extent.x"};
    const fw_plot_picture picture = {.asked = {.kind = FW_PICTURE_SERIES, .until = INT64_MAX},
                                     .observables = names,
                                     .observable_count = 2};
    const fw_plot_wish wish = {.kind = "field", .field = "speed"};
    fw_plot_series series;
    fw_plot_choice choice;
    make_folder(directory, sizeof directory);
    run_scenario("title: A gas\n"
                 "units: {length: 0.4 nm, time: 2 ps, mass: 1 u}\n"
                 "materials: {gas: {movable-particles: {}}}\n"
                 "bodies: {gas: {material: gas, lattice: hexagonal, shape: {rectangle: [3, 3]}, "
                 "velocity: [1, 0]}}\n"
                 "dynamics: {time-step: 0.005}\n"
                 "measure: [kinetic-energy, extent]\n"
                 "record: {fields: [speed]}\n"
                 "run: {steps: 20}\n",
                 directory);
    assert_fine(fw_plot_result_open(&result, directory, &error));
    assert_fine(fw_plot_series_find(&series, &result, &picture, &error));
    /* 1 u (.4 nm/2 ps)^2 = 1.66054e-27 kg (200 m/s)^2 = 6.64216e-23 J = .41457 meV. */
    assert_string_equal(series.charts[0].label.text, "kinetic energy (meV)");
    assert_close(series.charts[0].label.factor, .41457, 1e-5);
    assert_string_equal(series.charts[1].label.text, "extent x (nm)");
    assert_close(series.charts[1].label.factor, .4, 1e-15);
    assert_close(series.charts[1].curves[0].y[0], 2.5, 1e-12);
    fw_plot_series_clear(&series);
    assert_fine(fw_plot_choose(&choice, &result, &wish, &error));
    assert_string_equal(choice.picture.field.text, "speed (km/s)");
    assert_close(choice.picture.field.factor, .2, 1e-15);
    assert_string_equal(choice.picture.page.x_label.text, "x (nm)");
    assert_close(choice.picture.page.y_label.factor, .4, 1e-15);
    assert_string_equal(choice.picture.page.force.text, "pN");
    fw_plot_choice_clear(&choice);
    fw_plot_result_close(&result);
    remove_folder(directory);
}

/* x is the other number in each sample, with its own label. */
static void a_series_is_drawn_along_another_number(void **state)
{
    (void)state;
    const char *names[] = {"momentum.rod.x"};
    const fw_plot_picture picture = {.asked = {.kind = FW_PICTURE_SERIES, .until = INT64_MAX},
                                     .observables = names,
                                     .observable_count = 1,
                                     .along = "centre-of-mass.rod.x"};
    const char *both[] = {"momentum.rod.x", "centre-of-mass.rod.x"};
    fw_plot_series series, plain;
    open_result();
    assert_fine(fw_plot_series_find(&series, &result, &picture, &error));
    find_series(&plain, both, 2, 0, INT64_MAX);
    const fw_curve *drawn = &series.charts[0].curves[0];
    assert_true(drawn->count > 10);
    assert_memory_equal(drawn->y, plain.charts[0].curves[0].y,
                        (size_t)drawn->count * sizeof(double));
    assert_memory_equal(drawn->x, plain.charts[1].curves[0].y,
                        (size_t)drawn->count * sizeof(double));
    assert_string_equal(series.along_label.text, plain.charts[1].label.text);
    fw_plot_series over;
    const fw_plot_picture steps = {
        .asked = picture.asked, .observables = names, .observable_count = 1, .in_steps = true};
    assert_fine(fw_plot_series_find(&over, &result, &steps, &error));
    for (int k = 0; k < over.charts[0].curves[0].count; ++k)
        assert_close(over.charts[0].curves[0].x[k], (double)over.steps[k], 0);
    fw_plot_series_clear(&over);
    fw_plot_series_clear(&plain);
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
}

/* Each curve is called by its folder; what does not go together is refused. */
static void results_are_compared_in_one_frame(void **state)
{
    (void)state;
    char other[64], third[64];
    const char *names[] = {"kinetic-energy"}, *with[1];
    static const char text[] = "title: A gas\n%s"
                               "materials: {gas: {movable-particles: {}}}\n"
                               "bodies: {gas: {material: gas, lattice: hexagonal, shape: "
                               "{rectangle: [3, 3]}, velocity: [%d, 0]}}\n"
                               "measure: [kinetic-energy]\nrun: {steps: 20}\n";
    char scenario[512];
    fw_plot_picture picture = {.asked = {.kind = FW_PICTURE_SERIES, .until = INT64_MAX},
                               .observables = names,
                               .observable_count = 1,
                               .with = with,
                               .with_count = 1};
    fw_plot_series series;
    fw_plot_compared all;
    make_folder(other, sizeof other);
    make_folder(third, sizeof third);
    char own[64];
    make_folder(own, sizeof own);
    snprintf(scenario, sizeof scenario, text, "", 1);
    run_scenario(scenario, own);
    snprintf(scenario, sizeof scenario, text, "", 2);
    run_scenario(scenario, other);
    snprintf(scenario, sizeof scenario, text, "units: {length: 1 nm, time: 1 ps, mass: 1 u}\n", 2);
    run_scenario(scenario, third);
    assert_fine(fw_plot_result_open(&result, own, &error));
    assert_fine(fw_plot_series_find(&series, &result, &picture, &error));
    with[0] = other;
    assert_fine(fw_plot_compared_find(&all, &series, &picture, &error));
    assert_int_equal(all.charts[0].curve_count, 2);
    assert_string_equal(all.charts[0].curves[0].label, strrchr(own, '/') + 1);
    assert_string_equal(all.charts[0].curves[1].label, strrchr(other, '/') + 1);
    assert_close(all.charts[0].curves[0].y[0], 4.5, 1e-12);
    assert_close(all.charts[0].curves[1].y[0], 18, 1e-12);
    fw_plot_compared_clear(&all);
    with[0] = third;
    assert_refused(fw_plot_compared_find(&all, &series, &picture, &error), FW_BAD_INPUT,
                   "do not go into one frame");
    fw_plot_compared_clear(&all);
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
    remove_folder(own);
    remove_folder(other);
    remove_folder(third);
}

/* What would be flattened beside a quantity of the same unit gets a panel of its own. */
static void a_quantity_that_another_would_flatten_stands_alone(void **state)
{
    (void)state;
    /* The centre of the rod moves by 8 along x, its length by some hundredths. */
    const char *names[] = {"centre-of-mass.rod.x", "elongation.rod.x"};
    fw_plot_series series;
    open_result();
    find_series(&series, names, 2, 0, INT64_MAX);
    assert_int_equal(series.panel_count, 2);
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
}

/* The exact solution of a running wave is what the automaton does, to rounding: 1e-12 of some 1 in
 * 7 steps. */
static void the_exact_solution_is_where_the_automaton_is(void **state)
{
    (void)state;
    char directory[64];
    make_folder(directory, sizeof directory);
    run_scenario("title: A mode\n"
                 "materials: {foam: {elastic-automaton: {c1: 0.5, c2: 1, boundary: periodic}}}\n"
                 "bodies: {square: {material: foam, shape: {rectangle: [8, 8]}, displacement: "
                 "[{mode: {wave-vector: [0.7853981633974483, 1.5707963267948966], branch: fast, "
                 "amplitude: 0.3, phase: 40}}]}}\n"
                 "run: {steps: 7, record-every: 1}\n"
                 "record: {fields: [displacement-x, displacement-y]}\n"
                 "measure: [energy]\n",
                 directory);
    assert_fine(fw_plot_result_open(&result, directory, &error));
    assert_true(fw_plot_exact_exists(&result, "displacement-y"));
    assert_false(fw_plot_exact_exists(&result, "energy"));
    for (int64_t frame = 0; frame <= 7; frame += 7) {
        fw_plot_view simulated, exact;
        assert_fine(fw_plot_view_load(&simulated, &result, frame, "displacement-y", &error));
        assert_fine(fw_plot_exact_load(&exact, &result, frame, "displacement-y", &error));
        for (int n = 0; n < 64; ++n) {
            assert_close(exact.field[n], simulated.field[n], 1e-12);
            assert_close(exact.x[n], simulated.x[n], 1e-12);
        }
        fw_plot_view_clear(&simulated);
        fw_plot_view_clear(&exact);
    }
    fw_plot_result_close(&result);
    remove_folder(directory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_on_a_resting_body_add_up_to_zero),
        cmocka_unit_test(originals_travel_with_their_body),
        cmocka_unit_test(paths_are_those_of_the_centres_of_mass),
        cmocka_unit_test(curves_are_named_by_what_tells_them_apart),
        cmocka_unit_test(quantities_of_one_unit_share_a_panel),
        cmocka_unit_test(a_series_shows_the_steps_between_its_ends),
        cmocka_unit_test(a_curve_that_lies_on_another_is_dashed),
        cmocka_unit_test(colours_and_axes_are_those_of_the_whole_result),
        cmocka_unit_test(a_temperature_is_drawn_beside_what_is_set),
        cmocka_unit_test(axes_tell_the_units_of_nature),
        cmocka_unit_test(a_series_is_drawn_along_another_number),
        cmocka_unit_test(results_are_compared_in_one_frame),
        cmocka_unit_test(a_quantity_that_another_would_flatten_stands_alone),
        cmocka_unit_test(the_exact_solution_is_where_the_automaton_is),
    };
    return cmocka_run_group_tests(tests, make_run, remove_run);
}
