/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot_rubbing.c - maps of where a contact sticks, slides and heats. */
#include "experiments/drawing/palette.h"
#include "experiments/pictures/plot.h"
#include "experiments/pictures/plot_parts.h"

#include "contact/scene/scene.h"
#include "tests/support/plotted_run.h"
#include "tests/support/sliding_block.h"

static const char with_maps[] = SLIDING_BLOCK "pictures:\n"
                                              "  where: {kind: slip, body: block}\n"
                                              "  warm: {kind: heat, range: [0, 0.1]}\n"
                                              "  presses: {kind: contact}\n";

static fw_plot_result result;

static double heat_of(const fw_plot_result *of)
{
    const int64_t last = of->playback->sample_count - 1;
    double values[512];
    const int number = fw_playback_find_observable(of->playback, "friction-heat");
    assert_true(last < 512);
    assert_fine(fw_playback_read_observable(of->playback, number, values, &error));
    return values[last];
}

static void heat_over_place_and_time_adds_up(void **state)
{
    (void)state;
    fw_plot_rubbing r;
    const fw_plot_picture picture = {.asked = {.until = INT64_MAX}};
    assert_fine(fw_plot_result_open(&result, folder, &error));
    assert_fine(fw_plot_rubbing_find(&r, &result, &picture, FW_FIELD_HEAT, false, &error));
    assert_int_equal(r.body, 0);
    assert_int_equal(r.row_count, 6);
    double sum = 0;
    const int64_t columns = r.until - r.from;
    for (int64_t n = 0; n < columns * r.row_count; ++n)
        if (isfinite(r.values[n])) sum += 20 * r.values[n];
    assert_true(sum > 0.003);
    assert_close(sum, heat_of(&result), 1e-12);
    for (int row = 0; row < 6; ++row) assert_close(r.places[row], row, 0);
    fw_plot_rubbing_clear(&r);
    fw_plot_result_close(&result);
}

static void what_slid_sticks_in_the_end(void **state)
{
    (void)state;
    fw_plot_rubbing r;
    const fw_plot_picture picture = {.asked = {.until = INT64_MAX}};
    assert_fine(fw_plot_result_open(&result, folder, &error));
    assert_fine(fw_plot_rubbing_find(&r, &result, &picture, FW_FIELD_SLIDING, true, &error));
    const int64_t columns = r.until - r.from;
    double first = 0, last = 0;
    for (int row = 0; row < r.row_count; ++row) {
        first += r.values[row * columns] / r.row_count;
        last += r.values[row * columns + columns - 1] / r.row_count;
    }
    assert_true(first > .8 && first <= 1);
    assert_true(last < .1 && last >= 0);
    fw_plot_rubbing_clear(&r);
    fw_plot_result_close(&result);
}

static void maps_are_drawn_and_refused(void **state)
{
    (void)state;
    FILE *out = tmpfile();
    assert_fine(fw_plot_one(folder, &(fw_plot_wish){.picture = "where"}, out, &error));
    assert_fine(fw_plot_one(folder, &(fw_plot_wish){.picture = "warm"}, out, &error));
    assert_fine(fw_plot_one(folder, &(fw_plot_wish){.kind = "heat"}, out, &error));
    assert_fine(fw_plot_one(folder, &(fw_plot_wish){.picture = "presses"}, out, &error));
    fclose(out);
    char other[64];
    make_folder(other, sizeof other);
    run_scenario(SLIDING_BLOCK, other);
    assert_refused(fw_plot_one(other, &(fw_plot_wish){.kind = "slip"}, stdout, &error),
                   FW_BAD_INPUT, "friction was not recorded particle by particle");
    assert_refused(fw_plot_one(other, &(fw_plot_wish){.kind = "contact"}, stdout, &error),
                   FW_BAD_INPUT, "forces were not recorded");
    remove_folder(other);
}

static fw_status wish_for(fw_plot_wish wish)
{
    FILE *out = tmpfile();
    const fw_status status = fw_plot_one(folder, &wish, out, &error);
    fclose(out);
    return status;
}

static void body_and_steps_can_be_named(void **state)
{
    (void)state;
    assert_fine(wish_for((fw_plot_wish){.kind = "heat", .body = "block", .from = 100}));
    assert_fine(wish_for((fw_plot_wish){.kind = "slip", .from = 100, .until = 200}));
    assert_refused(wish_for((fw_plot_wish){.kind = "slip", .body = "far"}), FW_BAD_INPUT,
                   "nothing rubs body far from step 0 to 300");
    assert_refused(wish_for((fw_plot_wish){.kind = "slip", .body = "blok"}), FW_BAD_INPUT,
                   "there is no body blok");
    assert_refused(wish_for((fw_plot_wish){.kind = "heat", .from = 400}), FW_BAD_INPUT, "step 400");
    assert_refused(wish_for((fw_plot_wish){.kind = "heat", .from = 200, .until = 100}),
                   FW_BAD_INPUT, "from step 200 until step 100, expected a later one");
    assert_refused(wish_for((fw_plot_wish){.kind = "motion", .body = "block"}), FW_BAD_INPUT,
                   "a picture of kind motion does not draw one body");
    assert_refused(wish_for((fw_plot_wish){.kind = "motion", .until = 100}), FW_BAD_INPUT,
                   "does not draw anything from one step until another");
}

/* The top of the bar of colours as it stands in an SVG file. */
static bool svg_has_top_of(const char *path, fw_palette_map map)
{
    char line[4096], wanted[96];
    const fw_colour top = fw_palette_at(map, 1 - .5 / 256);
    snprintf(wanted, sizeof wanted, "rgb(%.4f", 100 * top.red);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    bool found = false;
    while (!found && fgets(line, sizeof line, file)) found = strstr(line, wanted) != NULL;
    fclose(file);
    return found;
}

/* Swings of what sticks take a little heat back in places. The scale begins dark all the same: in
 * the middle of one with two ends no heat would be as grey as no contact. */
static void heat_has_one_scale(void **state)
{
    (void)state;
    char path[128];
    snprintf(path, sizeof path, "%s/heat.svg", folder);
    const fw_plot_wish wish = {.kind = "heat", .range = {-1, 1}, .file = path};
    FILE *out = tmpfile();
    assert_fine(fw_plot_one(folder, &wish, out, &error));
    assert_true(svg_has_top_of(path, FW_PALETTE_SEQUENTIAL));
    assert_false(svg_has_top_of(path, FW_PALETTE_DIVERGING));
    fclose(out);
}

/* The picture lets them be recorded: at rest the floor bears the weight, in each frame. */
static void reactions_bear_the_weight(void **state)
{
    (void)state;
    double x[22], y[22], sum = 0;
    assert_fine(fw_plot_result_open(&result, folder, &error));
    assert_true(result.playback->force);
    const int64_t last = result.playback->frame_count - 1;
    assert_fine(fw_playback_read_forces(result.playback, last, x, y, &error));
    for (int i = 0; i < 18; ++i) sum += y[i];
    /* Weight and reaction; of its weight alone it would be -18 M g. */
    assert_close(sum, 0, 0.02 * 18 * 2.5 * 0.002);
    fw_plot_result_close(&result);
}

static void maps_need_friction(void **state)
{
    (void)state;
    fw_scenario *scenario;
    const char text[] = "title: smooth\n"
                        "materials: {m: {lattice-boltzmann: {}}}\n"
                        "bodies: {b: {material: m, shape: {rectangle: [2, 2]}}}\n"
                        "walls: {floor: {chain: [[-9, -1], [9, -1]]}}\n"
                        "run: {steps: 1}\n"
                        "pictures: {p: {kind: slip}}\n";
    assert_refused(fw_scenario_read(&scenario, "s.yaml", text, strlen(text), NULL, 0, &error),
                   FW_BAD_INPUT, "s.yaml:6:22: pictures.p is of kind 'slip', but nothing rubs");
}

static int set_up(void **state)
{
    (void)state;
    make_folder(folder, sizeof folder);
    run_scenario(with_maps, folder);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heat_over_place_and_time_adds_up),
        cmocka_unit_test(what_slid_sticks_in_the_end),
        cmocka_unit_test(maps_are_drawn_and_refused),
        cmocka_unit_test(body_and_steps_can_be_named),
        cmocka_unit_test(heat_has_one_scale),
        cmocka_unit_test(reactions_bear_the_weight),
        cmocka_unit_test(maps_need_friction),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
