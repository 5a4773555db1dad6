/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_plans.c - what each kind of picture hands to its figure, looked at on its way there:
 * views, histograms, profiles and films; the others are in test_figure_numbers.c. What is drawn is
 * what the results hold, of the right frame, body and particle. */
#include "tests/support/laws.h"

#include "experiments/pictures/film.h"
#include "experiments/pictures/plot.h"
#include "experiments/pictures/plot_parts.h"
#include "tests/support/beams.h"
#include "tests/support/program.h"
#include "tests/support/seen_figures.h"

#include "tests/support/plotted_run.h"

enum { SHEET = 9, ROD = 4, ALL = SHEET + ROD };

static fw_playback *playback;
static int64_t film_steps[64];

SEEN_FIGURE(fw_figure_field, fw_figure_field_plan)
SEEN_FIGURE(fw_figure_strip, fw_figure_strip_plan)
SEEN_FIGURE(fw_figure_map, fw_figure_map_plan)
SEEN_FIGURE(fw_figure_pairs, fw_figure_pairs_plan)

/* Of a film, which is drawn. */
fw_status __real_fw_figure_motion(const fw_page *page, const fw_figure_motion_plan *plan,
                                  fw_error *e);
fw_status __wrap_fw_figure_motion(const fw_page *page, const fw_figure_motion_plan *plan,
                                  fw_error *e);
fw_status __wrap_fw_figure_motion(const fw_page *page, const fw_figure_motion_plan *plan,
                                  fw_error *e)
{
    if (looks < 64) film_steps[looks] = plan->views[plan->view_count - 1].step;
    see_figure(page, plan);
    return look ? FW_OK : __real_fw_figure_motion(page, plan, e);
}

static void draw(const char *kind, const char *field, const int64_t *steps, int count,
                 void (*asked)(const void *))
{
    const fw_plot_wish wish = {
        .file = NEVER_DRAWN, .kind = kind, .field = field, .steps = steps, .step_count = count};
    assert_fine(fw_playback_open(&playback, folder, &error));
    draw_from(folder, &wish, asked);
    fw_playback_close(playback);
}

/* The frame of a step: one is recorded every 20. */
static int64_t frame_of(const fw_view *view)
{
    assert_int_equal(view->step % 20, 0);
    return view->step / 20;
}

/* Bodies, places and the field of a view are those of its frame. */
static void expect_view(const fw_view *view, int64_t step, const char *field)
{
    double x[ALL], y[ALL], values[ALL];
    assert_int_equal(view->step, step);
    assert_fine(fw_playback_read_positions(playback, frame_of(view), x, y, &error));
    if (field) assert_fine(fw_playback_read_field(playback, frame_of(view), field, values, &error));
    assert_int_equal(view->body_count, 2);
    for (int b = 0, at = 0; b < 2; at += view->bodies[b++].count) {
        const fw_view_body *body = &view->bodies[b];
        assert_int_equal(body->count, b == 0 ? SHEET : ROD);
        assert_memory_equal(body->x, x + at, (size_t)body->count * sizeof *x);
        assert_memory_equal(body->y, y + at, (size_t)body->count * sizeof *y);
        assert_true((body->field != NULL) == (field != NULL));
        if (field) assert_memory_equal(body->field, values + at, (size_t)body->count * sizeof *x);
    }
}

static const int64_t three[] = {0, 400, 800};

static void look_at_motion(const void *plan)
{
    const fw_figure_motion_plan *motion = plan;
    assert_int_equal(motion->view_count, 3);
    for (int k = 0; k < 3; ++k) expect_view(&motion->views[k], three[k], NULL);
}

static void motion_shows_its_instants_in_order(void **state)
{
    (void)state;
    draw("motion", NULL, three, 3, look_at_motion);
}

/* The ends of the colours are the least and the greatest value of the whole result. */
static void expect_whole_range(fw_range found, const char *field)
{
    fw_range range = fw_range_empty();
    double values[ALL];
    for (int64_t frame = 0; frame < playback->frame_count; ++frame) {
        assert_fine(fw_playback_read_field(playback, frame, field, values, &error));
        fw_range_include(&range, values, ALL, false);
    }
    assert_close(found.low, range.low, 0);
    assert_close(found.high, range.high, 0);
}

static void look_at_field(const void *plan)
{
    const fw_figure_field_plan *field = plan;
    double u[ALL], v[ALL];
    expect_view(field->view, 400, "speed");
    expect_whole_range(field->colouring.range, "speed");
    assert_fine(fw_playback_read_velocities(playback, 20, u, v, &error));
    for (int n = 0; n < ROD; ++n)
        assert_close(field->view->bodies[1].field[n], hypot(u[SHEET + n], v[SHEET + n]), 1e-12);
}

static void field_shows_its_own_at_its_instant(void **state)
{
    (void)state;
    draw("field", "speed", three + 1, 1, look_at_field);
}

static void look_at_strip(const void *plan)
{
    const fw_figure_strip_plan *strip = plan;
    assert_int_equal(strip->view_count, 3);
    for (int k = 0; k < 3; ++k) expect_view(&strip->views[k], three[k], "energy");
    expect_whole_range(strip->colouring.range, "energy");
}

static void strip_shows_its_instants_at_one_scale(void **state)
{
    (void)state;
    draw("strip", "energy", three, 3, look_at_strip);
}

static void look_at_contact(const void *plan)
{
    const fw_figure_strip_plan *contact = plan;
    double x[ALL], y[ALL];
    assert_int_equal(contact->view_count, 3);
    for (int k = 0; k < 3; ++k) {
        const fw_view *view = &contact->views[k];
        expect_view(view, three[k], NULL);
        assert_fine(fw_playback_read_forces(playback, frame_of(view), x, y, &error));
        for (int b = 0, at = 0; b < 2; at += view->bodies[b++].count) {
            const size_t size = (size_t)view->bodies[b].count * sizeof *x;
            assert_memory_equal(view->bodies[b].force_x, x + at, size);
            assert_memory_equal(view->bodies[b].force_y, y + at, size);
        }
    }
    /* The middle of the upper right particle of the sheet is pulled by (.07, .04). */
    const fw_view_body *sheet = &contact->views[2].bodies[0];
    double right = 0, up = 0;
    for (int n = 0; n < SHEET; ++n) {
        right = fmax(right, sheet->force_x[n]);
        up = fmax(up, sheet->force_y[n]);
    }
    assert_close(right, 0.07, 1e-12);
    assert_close(up, 0.04, 1e-12);
}

static void contact_has_the_forces_of_its_instants(void **state)
{
    (void)state;
    draw("contact", NULL, three, 3, look_at_contact);
}

/* The part of the values between two ends, the upper one in the last bin only. */
static double part_between(const double *values, double from, double until, bool last)
{
    int count = 0;
    for (int n = 0; n < ALL; ++n)
        count += values[n] >= from && (values[n] < until || (last && values[n] == until));
    return count / (double)ALL;
}

static void look_at_stages(const void *plan)
{
    const fw_figure_pairs_plan *stages = plan;
    double values[ALL];
    assert_int_equal(stages->pair_count, 3);
    for (int k = 0; k < 3; ++k) {
        const fw_curve *curve = stages->pairs[k].chart->curves;
        double sum = 0;
        expect_view(stages->pairs[k].view, three[k], "energy");
        assert_fine(fw_playback_read_field(playback, three[k] / 20, "energy", values, &error));
        for (int n = 0; n < curve->count; n += 2) {
            const bool last = n + 2 == curve->count;
            sum += curve->y[n];
            assert_close(curve->y[n], curve->y[n + 1], 0);
            if (!last) assert_close(curve->x[n + 1], curve->x[n + 2], 0);
            assert_close(curve->y[n], part_between(values, curve->x[n], curve->x[n + 1], last),
                         1e-12);
        }
        assert_close(sum, 1, 1e-12);
    }
}

static void stages_have_the_histogram_of_each_view(void **state)
{
    (void)state;
    draw("stages", "energy", three, 3, look_at_stages);
}

static void look_at_histogram(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    double values[ALL], times[64];
    assert_int_equal(map->columns, playback->frame_count);
    assert_int_equal(map->curve_count, 1);
    assert_int_equal(map->curves->count, map->columns);
    assert_fine(fw_playback_read_frame_times(playback, NULL, times, &error));
    for (int column = 0; column < map->columns; ++column) {
        double mean = 0;
        assert_fine(fw_playback_read_field(playback, column, "energy", values, &error));
        for (int n = 0; n < ALL; ++n) mean += values[n] / ALL;
        assert_close(map->p_first + column * map->p_step, times[column], 1e-9);
        assert_close(map->curves->x[column], times[column], 0);
        assert_close(map->curves->y[column], mean, 1e-15);
        for (int row = 0; row < map->rows; ++row) {
            const double middle = map->q_first + row * map->q_step, half = map->q_step / 2;
            const double part = map->values[row * map->columns + column];
            /* What lies within rounding of an edge is in one of two bins. */
            const double wide =
                part_between(values, middle - half * (1 + 1e-9), middle + half * (1 + 1e-9), true);
            const double narrow =
                part_between(values, middle - half * (1 - 1e-9), middle + half * (1 - 1e-9), false);
            assert_true(part >= narrow - 1e-12 && part <= wide + 1e-12);
        }
    }
}

static void histogram_has_a_column_for_each_frame(void **state)
{
    (void)state;
    draw("histogram", "energy", NULL, 0, look_at_histogram);
}

/* Every tenth frame of 41, and the last one only where it is one of them. */
static void film_shows_every_tenth_frame(void **state)
{
    (void)state;
    char file[128];
    if (system("ffmpeg -version >/dev/null 2>&1") != 0) skip();
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    snprintf(file, sizeof file, "%s/film.gif", folder);
    const fw_film_wish wish = {.file = file, .kind = "motion", .every = 10};
    look = NULL;
    looks = 0;
    assert_fine(fw_film_make(folder, &wish, nowhere, &error));
    assert_int_equal(looks, 5);
    for (int n = 0; n < 5; ++n) assert_int_equal(film_steps[n], 200 * n);
    fclose(nowhere);
}

/* --- the map of an analysis --- */

static const char stability[] =
    "title: where the automaton is stable\n"
    "materials: {sheet: {elastic-automaton: {c1: .4, c2: .2}}}\n"
    "bodies: {sheet: {material: sheet, shape: {rectangle: [3, 3]}}}\n"
    "run: {steps: 2}\n"
    "analysis: {map: {stability-map: {c1: [.5, 1.5], c2: [.2, 1.4], points: [5, 4], waves: 64}}}\n"
    "pictures: {map: {kind: analysis, analysis: map}}\n";

/* The fastest wave obeys q^2 - h q + 1 = 0 in half a step, h^2 = 2 (c1^2 + c2^2): c1 is to the
 * right and c2 upwards, in ranges that are not each other's. */
static void look_at_map(const void *plan)
{
    const fw_figure_map_plan *map = plan;
    assert_int_equal(map->columns, 5);
    assert_int_equal(map->rows, 4);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 5; ++column) {
            const double c1 = map->p_first + column * map->p_step;
            const double c2 = map->q_first + row * map->q_step;
            const double h = sqrt(2 * (c1 * c1 + c2 * c2));
            const double q = h > 2 ? (h + sqrt(h * h - 4)) / 2 : 1;
            assert_close(c1, 0.5 + 0.25 * column, 1e-12);
            assert_close(c2, 0.2 + 0.4 * row, 1e-12);
            assert_close(map->values[row * 5 + column], q * q, 1e-9);
        }
    assert_int_equal(map->curve_count, 1);
    for (int n = 0; n < map->curves->count; ++n)
        assert_close(hypot(map->curves->x[n], map->curves->y[n]), sqrt(2), 1e-12);
}

static void map_of_an_analysis_has_its_axes(void **state)
{
    (void)state;
    char directory[64];
    const fw_plot_wish wish = {.file = NEVER_DRAWN, .picture = "map"};
    make_folder(directory, sizeof directory);
    run_scenario(stability, directory);
    draw_from(directory, &wish, look_at_map);
    remove_folder(directory);
}

/* --- an experiment beside its control --- */

static int columns_drawn, curves_drawn;
static char beams_folder[64];

fw_status __wrap_fw_figure_columns(const fw_page *page, const fw_figure_stack_plan *plans,
                                   int count, fw_error *e);
fw_status __wrap_fw_figure_curves(const fw_page *page, const fw_chart *chart, fw_label x,
                                  const fw_axis_name *names, int name_count, fw_error *e);

/* The left column is the experiment, the right one its control, with their own particles at the
 * same step, and their own numbers. */
fw_status __wrap_fw_figure_columns(const fw_page *page, const fw_figure_stack_plan *plans,
                                   int count, fw_error *e)
{
    static const char *const sides[] = {"", "/control"};
    static const char *const names[] = {"experiment, ", "control, "};
    (void)page, (void)e;
    ++columns_drawn;
    assert_int_equal(count, 2);
    assert_fine(fw_playback_open(&playback, beams_folder, &error));
    fw_profile_table *table;
    assert_fine(fw_profile_table_read(&table, playback, 'x', &error));
    fw_playback_close(playback);
    for (int k = 0; k < 2; ++k) {
        char path[96];
        double x[256], y[256];
        int64_t steps[64], frame = 0;
        const fw_view *view = plans[k].views;
        snprintf(path, sizeof path, "%s%s", beams_folder, sides[k]);
        assert_fine(fw_playback_open(&playback, path, &error));
        assert_true(playback->particle_count <= 256 && playback->frame_count <= 64);
        assert_fine(fw_playback_read_frame_times(playback, steps, NULL, &error));
        while (steps[frame] != view->step) ++frame;
        assert_fine(fw_playback_read_positions(playback, frame, x, y, &error));
        assert_memory_equal(view->bodies[1].x, x + view->bodies[0].count,
                            (size_t)view->bodies[1].count * sizeof *x);
        assert_true(strncmp(view->name, names[k], strlen(names[k])) == 0);
        assert_int_equal(view->step, plans[0].views->step);
        fw_playback_close(playback);
        const fw_outcome *column = fw_profile_table_column(table, FW_PROFILE_RETURN_FORCE);
        int found = 0, known = 0;
        for (int c = 0; c < plans[k].chart_count; ++c) {
            const fw_curve *curve = plans[k].charts[c].curves;
            if (!strstr(plans[k].charts[c].label.text, "return force")) continue;
            ++found;
            assert_int_equal(curve->count, table->bin_count);
            for (int b = 0; b < curve->count; ++b) {
                const double wanted = k == 0 ? column[b].mean : column[b].control;
                known += isfinite(wanted) && column[b].mean != column[b].control;
                if (isfinite(wanted)) assert_close(curve->y[b], wanted, 0);
            }
        }
        assert_int_equal(found, 1);
        assert_true(known > 3);
    }
    fw_profile_table_destroy(table);
    return FW_OK;
}

/* Slip to the right; the force of the first body on the second, which it drags along, so that what
 * the loop encloses is what rubbing takes. */
fw_status __wrap_fw_figure_curves(const fw_page *page, const fw_chart *chart, fw_label x,
                                  const fw_axis_name *names, int name_count, fw_error *e)
{
    (void)page, (void)x, (void)names, (void)name_count, (void)e;
    ++curves_drawn;
    double slip[2 * 512], force[2 * 512], area = 0;
    int64_t steps[512];
    const fw_curve *curve = chart->curves;
    assert_fine(fw_playback_open(&playback, beams_folder, &error));
    assert_true(playback->sample_count <= 512);
    assert_fine(fw_playback_read_sample_times(playback, steps, NULL, &error));
    assert_fine(fw_playback_read_observable(playback, fw_playback_find_observable(playback, "slip"),
                                            slip, &error));
    assert_fine(fw_playback_read_observable(
        playback, fw_playback_find_observable(playback, "interface-force"), force, &error));
    int n = 0;
    for (int row = 0; row < playback->sample_count; ++row) {
        if (steps[row] < 1500 || steps[row] > 2500) continue;
        assert_close(curve->x[n], slip[2 * row + 1], 0);
        assert_close(curve->y[n], -force[2 * row + 1], 0);
        if (n > 0) area += (curve->x[n] - curve->x[n - 1]) * (curve->y[n] + curve->y[n - 1]) / 2;
        ++n;
    }
    assert_int_equal(n, curve->count);
    assert_true(n > 50 && area > 0);
    fw_playback_close(playback);
    return FW_OK;
}

static void profile_and_loop_are_of_their_own_sides(void **state)
{
    (void)state;
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    make_quick_folder(beams_folder, sizeof beams_folder);
    write_scenario(beams_folder, "file.yaml", small_beams);
    const outcome seen =
        run_program(beams_folder, "run file.yaml -o . --quiet --no-plot --set study.seeds=1 "
                                  "--set run.record-every=100 --set expect=[]");
    assert_int_equal(seen.code, 0);
    const fw_plot_wish profile = {.file = NEVER_DRAWN, .kind = "profile"};
    assert_fine(fw_plot_one(beams_folder, &profile, nowhere, &error));
    assert_int_equal(columns_drawn, 1);
    const fw_plot_wish loop = {.file = NEVER_DRAWN, .kind = "loop"};
    assert_fine(fw_plot_one(beams_folder, &loop, nowhere, &error));
    assert_int_equal(curves_drawn, 1);
    fclose(nowhere);
    remove_folder(beams_folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(motion_shows_its_instants_in_order),
        cmocka_unit_test(field_shows_its_own_at_its_instant),
        cmocka_unit_test(strip_shows_its_instants_at_one_scale),
        cmocka_unit_test(contact_has_the_forces_of_its_instants),
        cmocka_unit_test(stages_have_the_histogram_of_each_view),
        cmocka_unit_test(histogram_has_a_column_for_each_frame),
        cmocka_unit_test(map_of_an_analysis_has_its_axes),
        cmocka_unit_test(profile_and_loop_are_of_their_own_sides),
        cmocka_unit_test(film_shows_every_tenth_frame),
    };
    return cmocka_run_group_tests(tests, make_run, remove_run);
}
