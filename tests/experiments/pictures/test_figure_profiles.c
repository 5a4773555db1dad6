/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_figure_profiles.c - what the picture of a profile along y hands to its figure, looked at on
 * its way there: the axis of the profile lies from left to right, in units of nature, with the
 * frame in which the bodies are still there, with and without a control. */
#include "tests/support/laws.h"

#include "experiments/measures/profile_table.h"
#include "experiments/results/playback.h"
#include "tests/support/program.h"
#include "tests/support/seen_figures.h"

/* Two crystals on top of each other; one unit of length is half a nanometre. */
#define STACKED(more)                                                                              \
    "title: two crystals rub\n"                                                                    \
    "units: {length: 0.5 nm, energy: 0.2 eV, mass: 60 u}\n"                                        \
    "materials: {grain: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}\n"         \
    "bodies:\n"                                                                                    \
    "  lower: {material: grain, lattice: hexagonal, shape: {rectangle: [4, 5]}, origin: [0, "      \
    "-4.3]}\n"                                                                                     \
    "  upper: {material: grain, lattice: hexagonal, shape: {rectangle: [3, 5]}, origin: [.5, .8]"  \
    "}\n"                                                                                          \
    "dynamics: {damping: 1, temperature: 0.001}\n"                                                 \
    "record: {fields: [return-force]}\n" more

static const char rubbed[] = STACKED("walls: {floor: {chain: [[-9, -9], [9, -9]]}}\n"
                                     "run: {steps: 40, record-every: 10, measure-every: 2}\n"
                                     "profile: {axis: y, every: 10, far: [2, 4], contact: 1.5}\n"
                                     "study: {seeds: 2, control: ['dynamics.temperature=0']}\n");

/* The upper one flies away to the side of its profile. */
static const char lost[] = STACKED("run: {steps: 200, record-every: 20, measure-every: 20}\n"
                                   "profile: {axis: y, every: 20, far: [2, 4], contact: 1.5}\n");

static char folder[64], said_name[128];
static bool controlled;
static int stacks;

/* Views and charts of one side against its results. */
static void look_at_side(const fw_figure_stack_plan *plan, const char *directory,
                         fw_profile_table *table, bool control)
{
    fw_playback *playback;
    static double x[64], y[64];
    static int64_t steps[64];
    const fw_view *view = plan->views;
    assert_fine(fw_playback_open(&playback, directory, &error));
    assert_int_equal(playback->particle_count, 35);
    assert_fine(fw_playback_read_frame_times(playback, steps, NULL, &error));
    int64_t frame = 0;
    while (steps[frame] != view->step) ++frame;
    assert_fine(fw_playback_read_positions(playback, frame, x, y, &error));
    assert_memory_equal(view->bodies[1].x, y + 20, 15 * sizeof *y);
    assert_memory_equal(view->bodies[1].y, x + 20, 15 * sizeof *x);
    assert_memory_equal(view->bodies[0].x, y, 20 * sizeof *y);
    assert_int_equal(view->wall_count, 0);
    fw_playback_close(playback);

    assert_string_equal(plan->label.text, "y (nm)");
    assert_string_equal(plan->y_label.text, "x (nm)");
    assert_close(plan->label.factor, .5, 1e-12);
    assert_int_equal(plan->region_count, 3);
    assert_close(plan->regions[0].from, -plan->regions[0].until, 1e-12);
    const fw_outcome *column = fw_profile_table_column(table, FW_PROFILE_RETURN_FORCE);
    const fw_curve *curve = plan->charts[0].curves;
    assert_int_equal(curve->count, table->bin_count);
    for (int b = 0; b < curve->count; ++b) {
        const double wanted = control ? column[b].control : column[b].mean;
        assert_close(curve->x[b], (table->edges[b] + table->edges[b + 1]) / 2, 0);
        assert_true(curve->y[b] == wanted || (isnan(wanted) && isnan(curve->y[b])));
    }
    /* A bin more at either end. */
    const double bin = table->edges[1] - table->edges[0];
    assert_close(plan->range.low, table->edges[0] - bin, 1e-12);
    assert_close(plan->range.high, table->edges[table->bin_count] + bin, 1e-12);
}

static fw_profile_table *read_table(void)
{
    fw_playback *playback;
    fw_profile_table *table;
    assert_fine(fw_playback_open(&playback, folder, &error));
    assert_fine(fw_profile_table_read(&table, playback, 'y', &error));
    fw_playback_close(playback);
    return table;
}

fw_status __wrap_fw_figure_columns(const fw_page *page, const fw_figure_stack_plan *plans,
                                   int count, fw_error *e);
fw_status __wrap_fw_figure_columns(const fw_page *page, const fw_figure_stack_plan *plans,
                                   int count, fw_error *e)
{
    char control[96];
    (void)e;
    assert_int_equal(count, 2);
    controlled = true;
    see_figure(page, plans);
    fw_profile_table *table = read_table();
    snprintf(control, sizeof control, "%s/control", folder);
    look_at_side(&plans[0], folder, table, false);
    look_at_side(&plans[1], control, table, true);
    assert_int_equal(strncmp(plans[0].views->name, "experiment, ", 12), 0);
    assert_int_equal(strncmp(plans[1].views->name, "control, ", 9), 0);
    assert_close(page->width, 240, 0);
    fw_profile_table_destroy(table);
    return FW_OK;
}

fw_status __wrap_fw_figure_stack(const fw_page *page, const fw_figure_stack_plan *plan,
                                 fw_error *e);
fw_status __wrap_fw_figure_stack(const fw_page *page, const fw_figure_stack_plan *plan, fw_error *e)
{
    (void)e;
    ++stacks;
    see_figure(page, plan);
    fw_profile_table *table = read_table();
    look_at_side(plan, folder, table, false);
    snprintf(said_name, sizeof said_name, "%s", plan->views->name);
    fw_profile_table_destroy(table);
    return FW_OK;
}

static void run_into_folder(const char *text, const char *settings)
{
    char line[256];
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "file.yaml", text);
    snprintf(line, sizeof line, "run file.yaml -o . -q --no-plot -j 1 %s", settings);
    const outcome seen = run_program(folder, line);
    expect_end(&seen, 0, "");
}

static void draw(const fw_plot_wish *wish)
{
    FILE *nowhere = fopen("/dev/null", "w");
    assert_non_null(nowhere);
    assert_fine(fw_plot_one(folder, wish, nowhere, &error));
    fclose(nowhere);
}

static void profile_along_y_lies_from_left_to_right(void **state)
{
    (void)state;
    const fw_plot_wish wish = {.file = NEVER_DRAWN, .kind = "profile"};
    run_into_folder(rubbed, "");
    draw(&wish);
    assert_true(controlled);
    expect_caption("profiles across y, means over the samples and 2 seeds with standard errors as "
                   "bars. ");
    assert_null(strstr(seen_caption, "left the profile"));
    remove_folder(folder);
}

/* Of the frames the last one in which three quarters of the particles are above the bins: here by
 * counting them. */
static void the_frame_is_one_in_which_the_bodies_are_there(void **state)
{
    (void)state;
    static double x[64], y[64];
    static int64_t steps[64];
    char wanted[32];
    fw_playback *playback;
    run_into_folder(lost, "--set bodies.upper.velocity=[0,8] --set dynamics.damping=0");
    fw_profile_table *table = read_table();
    const double bin = table->edges[1] - table->edges[0];
    const double low = table->edges[0] - bin, high = table->edges[table->bin_count] + bin;
    int64_t last = -1;
    assert_fine(fw_playback_open(&playback, folder, &error));
    assert_fine(fw_playback_read_frame_times(playback, steps, NULL, &error));
    for (int64_t f = 0; f < playback->frame_count; ++f) {
        int there = 0;
        assert_fine(fw_playback_read_positions(playback, f, x, y, &error));
        for (int n = 0; n < 35; ++n) there += y[n] >= low && y[n] <= high;
        if (there >= 27) last = f;
    }
    assert_true(last >= 0 && last + 2 < playback->frame_count);
    const fw_plot_wish wish = {.file = NEVER_DRAWN, .kind = "profile"};
    draw(&wish);
    assert_int_equal(stacks, 1);
    snprintf(wanted, sizeof wanted, "step %lld,", (long long)steps[last]);
    assert_int_equal(strncmp(said_name, wanted, strlen(wanted)), 0);
    expect_caption("profiles across y, means over the samples. ");
    /* One that is asked for by its step is shown, whatever is left of it. */
    const fw_plot_wish late = {
        .file = NEVER_DRAWN, .kind = "profile", .steps = (int64_t[]){200}, .step_count = 1};
    draw(&late);
    assert_int_equal(strncmp(said_name, "step 200,", 9), 0);
    expect_caption("Particles that have left the profile are not shown. ");
    fw_playback_close(playback);
    fw_profile_table_destroy(table);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(profile_along_y_lies_from_left_to_right),
        cmocka_unit_test(the_frame_is_one_in_which_the_bodies_are_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
