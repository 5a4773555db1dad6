/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot.c - pictures from a results folder: that they show what was computed, that nothing is
 * drawn under a wrong name, and what is said where there is nothing to draw. */
#include "tests/support/laws.h"

#include "experiments/commands/command.h"
#include "experiments/pictures/plot.h"
#include "experiments/pictures/plot_exact.h"
#include "experiments/pictures/plot_extent.h"
#include "experiments/pictures/plot_parts.h"
#include "experiments/scenario/schema.h"
#include "experiments/study/run.h"

#include "tests/support/recorded_run.h"

#include <sys/stat.h>

/* A sheet that comes to rest under forces, with stiff links and a heavy particle, and an uneven rod
 * that flies freely. */
static const char scenario_text[] =
    "title: A short run\n"
    "materials:\n"
    "  felt: {lattice-boltzmann: {damping: 0.2}}\n"
    "  steel: {lattice-boltzmann: {rest-mass: 0.5}}\n"
    "bodies:\n"
    "  sheet:\n"
    "    material: felt\n"
    "    shape: {rectangle: [3, 3]}\n"
    "    rest-mass: [{sites: [[2, 2]], value: 2}]\n"
    "    link-stiffness: [{sites: bottom, links: inside, value: [3, 0.5, 2]}]\n"
    "  rod:\n"
    "    material: steel\n"
    "    shape: {rectangle: [4, 1]}\n"
    "    origin: [10, 0]\n"
    "    velocity: [0.01, 0.02]\n"
    "    rest-mass: [{sites: right, value: 3}]\n"
    "    velocities: [{random: 0.05}]\n"
    "walls:\n"
    "  floor: {chain: [[-100, -90], [100, -90]]}\n"
    "forces:\n"
    "  pull: {body: sheet, sites: [[2, 2]], force: [0.07, 0.04]}\n"
    "  twist: {body: sheet, sites: [[1, 0]], force: [-0.02, -0.05]}\n"
    "  hold: {body: sheet, sites: [[0, 0]], force: [-0.05, 0.01]}\n"
    "run: {steps: 800, record-every: 20}\n"
    "record: {force: true, fields: [energy]}\n"
    "measure: [energy, momentum, elongation, centre-of-mass, reaction]\n"
    "pictures:\n"
    "  motion: {kind: motion, instants: [0, 390, 800]}\n"
    "  forces: {kind: forces}\n"
    "  speeds: {kind: field, field: speed}\n"
    "  strip: {kind: field, instants: [0, 800]}\n"
    "  series: {kind: series, observables: [energy, elongation.sheet.x, momentum.rod, reaction]}\n";

static char folder[64];

/* --- the run that all tests draw --- */

static void run_scenario(const char *text, const char *directory)
{
    fw_scenario *scenario;
    fw_run *run;
    const fw_run_options options = {.directory = directory, .threads = 1, .name = "test"};
    assert_fine(fw_scenario_read(&scenario, "test.yaml", text, strlen(text), NULL, 0, &error));
    assert_fine(fw_run_begin(&run, scenario, &options, &error));
    assert_fine(fw_run_to_end(run, &error));
    fw_run_destroy(run);
    fw_scenario_destroy(scenario);
}

static int make_run(void **state)
{
    (void)state;
    make_folder(folder, sizeof folder);
    run_scenario(scenario_text, folder);
    return 0;
}

static int remove_run(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

/* What a call says on its output. */
static char said[4096];

static fw_status plot_one(const fw_plot_wish *wish)
{
    FILE *out = tmpfile();
    assert_non_null(out);
    fw_status status = fw_plot_one(folder, wish, out, &error);
    rewind(out);
    said[fread(said, 1, sizeof said - 1, out)] = '\0';
    fclose(out);
    return status;
}

static void assert_drawn(const char *directory, const char *name, const char *magic)
{
    char path[256], head[8] = "";
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *file = fopen(path, "rb");
    if (!file) fail_msg("%s was not drawn", path);
    size_t length = fread(head, 1, sizeof head, file);
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    fclose(file);
    if (length < strlen(magic) || memcmp(head, magic, strlen(magic)) != 0 || size < 2000)
        fail_msg("%s is no picture", path);
}

static bool exists(const char *name)
{
    char path[256];
    struct stat facts;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return stat(path, &facts) == 0;
}

/* --- what is found before anything is drawn --- */

static fw_plot_result result;

static void open_result(void)
{
    assert_fine(fw_plot_result_open(&result, folder, &error));
}

/* At rest the forces of the links balance the external ones at every particle. The residual of the
 * sheet falls by far more than 1e-12 in 800 steps at mu = 0.8. */
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
    assert_string_equal(series.charts[0].label, "elongation x (length)");
    assert_int_equal(series.charts[0].curve_count, 2);
    assert_string_equal(series.charts[0].curves[0].label, "sheet");
    assert_string_equal(series.charts[0].curves[1].label, "rod");
    assert_string_equal(series.charts[1].label, "momentum of rod");
    assert_int_equal(series.charts[1].curve_count, 2); /* x is not drawn twice */
    assert_string_equal(series.charts[1].curves[0].label, "x");
    assert_string_equal(series.charts[1].curves[1].label, "y");
    assert_string_equal(series.charts[2].label, "energy");
    assert_null(series.charts[2].curves[0].label);
    assert_string_equal(series.charts[3].label, "reaction y (force)"); /* there is one wall */
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
    assert_string_equal(series.charts[0].label, "length of sheet");
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
    fw_plot_series_clear(&series);
    fw_plot_result_close(&result);
    remove_folder(directory);
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

/* --- which pictures are drawn --- */

static void every_picture_of_the_scenario_is_drawn(void **state)
{
    (void)state;
    FILE *out = tmpfile();
    assert_fine(fw_plot_all(folder, out, &error));
    rewind(out);
    said[fread(said, 1, sizeof said - 1, out)] = '\0';
    fclose(out);
    static const char *const names[] = {"motion.png", "forces.png", "speeds.png", "strip.png",
                                        "series.png"};
    for (int n = 0; n < 5; ++n) {
        char line[128];
        assert_drawn(folder, names[n], "\x89PNG");
        snprintf(line, sizeof line, "picture: %s/%s\n", folder, names[n]);
        if (!strstr(said, line)) fail_msg("nothing said of %s: %s", names[n], said);
    }
    /* Frames are 20 steps apart. */
    assert_non_null(strstr(said, "Nearest recorded steps: 380 for 390."));
}

static void the_ending_says_what_a_picture_becomes(void **state)
{
    (void)state;
    static const struct {
        const char *name, *magic;
    } kinds[] = {{"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}};
    for (int n = 0; n < 3; ++n) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", folder, kinds[n].name);
        assert_fine(plot_one(&(fw_plot_wish){.file = path, .picture = "motion"}));
        assert_drawn(folder, kinds[n].name, kinds[n].magic);
    }
    assert_refused(plot_one(&(fw_plot_wish){.file = "a.gif"}), FW_BAD_INPUT, "a.gif");
}

static void kinds_can_be_chosen_without_a_picture(void **state)
{
    (void)state;
    static const char *const chosen[] = {"motion", "forces", "field", "strip", "series"};
    for (int n = 0; n < 5; ++n) {
        char name[32];
        snprintf(name, sizeof name, "%s.png", chosen[n]);
        assert_fine(plot_one(&(fw_plot_wish){.kind = chosen[n]}));
        assert_drawn(folder, name, "\x89PNG");
    }
    const int64_t steps[] = {800, 0};
    assert_fine(plot_one(
        &(fw_plot_wish){.kind = "motion", .steps = steps, .step_count = 2})); /* any order */
}

static void results_without_pictures_show_the_motion(void **state)
{
    (void)state;
    char directory[64];
    make_folder(directory, sizeof directory);
    run_scenario(
        "title: A particle\n"
        "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
        "bodies: {particle: {material: dust, shape: {rectangle: [1, 1]}, velocity: [1, 2]}}\n"
        "run: {steps: 5}\n",
        directory);
    FILE *out = tmpfile();
    assert_fine(fw_plot_all(directory, out, &error));
    fclose(out);
    assert_drawn(directory, "motion.png", "\x89PNG");
    remove_folder(directory);
}

/* A run that was killed at its start: what there is is drawn, and what is missing is said. */
static void an_unfinished_run_shows_what_it_has(void **state)
{
    (void)state;
    char directory[64];
    fw_scenario *scenario;
    fw_run *run;
    make_folder(directory, sizeof directory);
    const fw_run_options options = {.directory = directory, .threads = 1, .name = "test"};
    assert_fine(fw_scenario_read(&scenario, "test.yaml", scenario_text, strlen(scenario_text), NULL,
                                 0, &error));
    assert_fine(fw_run_begin(&run, scenario, &options, &error));
    fw_run_destroy(run);
    fw_scenario_destroy(scenario);
    FILE *out = tmpfile();
    assert_fine(fw_plot_one(directory, &(fw_plot_wish){.picture = "motion"}, out, &error));
    rewind(out);
    said[fread(said, 1, sizeof said - 1, out)] = '\0';
    fclose(out);
    assert_drawn(directory, "motion.png", "\x89PNG");
    assert_non_null(strstr(said, "Missing, as the results end at step 0: 390, 800."));
    remove_folder(directory);
}

/* --- what is refused --- */

static void unknown_names_are_told_what_was_meant(void **state)
{
    (void)state;
    const char *name[] = {"enrgy"}, *other[] = {"wealth"}, *known[] = {"penetration"};
    assert_refused(plot_one(&(fw_plot_wish){.picture = "moton"}), FW_BAD_INPUT,
                   "no picture moton; did you mean motion?");
    assert_refused(plot_one(&(fw_plot_wish){.picture = "x"}), FW_BAD_INPUT,
                   "no picture x, expected one of motion, forces, speeds, strip, series");
    assert_refused(plot_one(&(fw_plot_wish){.kind = "filed"}), FW_BAD_INPUT,
                   "no pictures of kind filed; did you mean field?");
    assert_refused(plot_one(&(fw_plot_wish){.kind = "movie"}), FW_BAD_INPUT,
                   "expected one of motion, forces, field, strip, series, profile, loop, "
                   "analysis, or sweep in the folder of a sweep");
    assert_refused(plot_one(&(fw_plot_wish){.field = "enegry"}), FW_BAD_INPUT,
                   "no field enegry; did you mean energy?");
    assert_refused(plot_one(&(fw_plot_wish){.field = "strain-xx"}), FW_BAD_INPUT,
                   "the field strain-xx was not recorded (there is energy, speed); to have it, "
                   "name it under record.fields");
    assert_refused(plot_one(&(fw_plot_wish){.observables = name, .observable_count = 1}),
                   FW_BAD_INPUT, "no observable enrgy; did you mean energy?");
    assert_refused(plot_one(&(fw_plot_wish){.observables = other, .observable_count = 1}),
                   FW_BAD_INPUT, "no observable wealth, expected one of energy, ");
    assert_refused(plot_one(&(fw_plot_wish){.observables = known, .observable_count = 1}),
                   FW_BAD_INPUT, "penetration was not measured; to have it, name it under measure");
}

static void wishes_that_contradict_each_other_are_refused(void **state)
{
    (void)state;
    const char *names[] = {"energy"};
    const int64_t late[] = {801}, one[] = {20}, backwards[] = {20, 0};
    assert_refused(plot_one(&(fw_plot_wish){.picture = "motion", .kind = "field"}), FW_BAD_INPUT,
                   "both the picture motion and the kind field");
    assert_refused(plot_one(&(fw_plot_wish){.kind = "motion", .field = "energy"}), FW_BAD_INPUT,
                   "does not draw a field");
    assert_refused(
        plot_one(&(fw_plot_wish){.kind = "field", .observables = names, .observable_count = 1}),
        FW_BAD_INPUT, "does not draw observables");
    assert_refused(plot_one(&(fw_plot_wish){.kind = "motion", .logarithmic = true}), FW_BAD_INPUT,
                   "logarithmic");
    assert_refused(plot_one(&(fw_plot_wish){.kind = "motion", .steps = late, .step_count = 1}),
                   FW_BAD_INPUT, "step 801, but the results hold the steps 0 to 800");
    assert_refused(plot_one(&(fw_plot_wish){.kind = "series", .steps = one, .step_count = 1}),
                   FW_BAD_INPUT, "--at FROM,UNTIL");
    assert_refused(plot_one(&(fw_plot_wish){.kind = "series", .steps = backwards, .step_count = 2}),
                   FW_BAD_INPUT, "--at FROM,UNTIL");
}

static fw_status command(const char *at, const char *observable)
{
    const fw_arguments arguments = {
        .word_count = 1, .words = {folder}, .at = at, .observable = observable};
    return fw_command_plot(&arguments, &error);
}

static void lists_of_the_command_line_are_read_strictly(void **state)
{
    (void)state;
    assert_refused(command("0,5x", NULL), FW_BAD_INPUT, "--at 0,5x");
    assert_refused(command("0,", NULL), FW_BAD_INPUT, "--at 0,");
    assert_refused(command("-5", NULL), FW_BAD_INPUT, "--at -5");
    assert_refused(command("1e2", NULL), FW_BAD_INPUT, "--at 1e2");
    assert_refused(command(NULL, "energy,,momentum"), FW_BAD_INPUT,
                   "--observable energy,,momentum");
    assert_refused(command(NULL, ""), FW_BAD_INPUT, "--observable ");
    const fw_arguments turned = {.word_count = 1, .words = {folder}, .range = "2,1"};
    assert_refused(fw_command_plot(&turned, &error), FW_BAD_INPUT, "--range 2,1, expected two");
    const fw_arguments lone = {.word_count = 1, .words = {folder}, .range = "2"};
    assert_refused(fw_command_plot(&lone, &error), FW_BAD_INPUT, "--range 2, expected two");
    /* The comma of a site does not end a name. */
    assert_refused(command(NULL, "energy,position.sheet[0,3]"), FW_BAD_INPUT,
                   "no observable position.sheet[0,3]");
}

static void results_that_are_not_there_are_refused(void **state)
{
    (void)state;
    assert_refused(fw_plot_all("/nonexistent/results", stdout, &error), FW_BAD_INPUT,
                   "/nonexistent/results");
}

/* One picture that cannot be drawn does not keep the others from being drawn. */
static void a_picture_that_fails_is_reported_after_the_others(void **state)
{
    (void)state;
    char path[128];
    assert_fine(fw_plot_all(folder, stdout, &error));
    snprintf(path, sizeof path, "%s/series.png", folder);
    assert_int_equal(remove(path), 0);
    snprintf(path, sizeof path, "%s/forces.png", folder);
    assert_int_equal(remove(path), 0);
    assert_int_equal(mkdir(path, 0777), 0);
    assert_refused(fw_plot_all(folder, stdout, &error), FW_SYSTEM_FAILED, "forces.png");
    assert_true(exists("series.png"));
    assert_int_equal(rmdir(path), 0);
}

/* Nothing is left behind, and what was there stays. */
static void a_folder_that_cannot_be_written_to_fails_with_a_sentence(void **state)
{
    (void)state;
    char path[128];
    assert_refused(plot_one(&(fw_plot_wish){.file = "/nonexistent/a.png"}), FW_SYSTEM_FAILED,
                   "/nonexistent/a.png");
    if (geteuid() == 0) return; /* root may write anywhere */
    snprintf(path, sizeof path, "%s/sealed.png", folder);
    assert_int_equal(chmod(folder, 0555), 0);
    assert_refused(plot_one(&(fw_plot_wish){.file = path}), FW_SYSTEM_FAILED, "sealed.png");
    assert_int_equal(chmod(folder, 0755), 0);
    assert_false(exists("sealed.png"));
}

/* --- what pictures of a scenario may say --- */

static void refuse_picture(const char *picture, const char *words)
{
    char text[4096], directory[64], path[80];
    fw_scenario *scenario;
    const char *head = strstr(scenario_text, "pictures:\n");
    snprintf(text, sizeof text, "%.*spictures:\n  odd: %s\n", (int)(head - scenario_text),
             scenario_text, picture);
    make_folder(directory, sizeof directory);
    snprintf(path, sizeof path, "%s/run", directory);
    const fw_run_options options = {.directory = path, .threads = 1, .name = "test"};
    error = (fw_error){0};
    fw_status status =
        fw_scenario_read(&scenario, "test.yaml", text, strlen(text), NULL, 0, &error);
    fw_run *run = NULL;
    if (status == FW_OK) status = fw_run_begin(&run, scenario, &options, &error);
    fw_run_destroy(run);
    fw_scenario_destroy(scenario);
    remove_folder(directory);
    assert_int_equal(status, FW_BAD_INPUT);
    if (!strstr(error.sentence, words) || strncmp(error.sentence, "test.yaml:", 10) != 0)
        fail_msg("'%s' does not speak of '%s'", error.sentence, words);
}

/* Before the run, not after it. */
static void pictures_that_cannot_be_drawn_are_refused_before_the_run(void **state)
{
    (void)state;
    refuse_picture("{kind: series, observables: [elongation.w]}",
                   "elongation is not measured of w, expected elongation with the name of a body "
                   "or with one of the components x y");
    refuse_picture("{kind: series, observables: [reaction.sheet]}", "with the name of a wall");
    refuse_picture("{kind: series, observables: [elongation.sheet.x.y]}",
                   "not measured of sheet.x.y");
    refuse_picture("{kind: series, observables: [elongaton.x]}", "did you mean elongation?");
    refuse_picture("{kind: series, observables: [elongation..x]}", "elongation..x");
    refuse_picture("{kind: series, from: 800}", "begins at step 800, but the run ends at 800");
    refuse_picture("{kind: series, from: 5, until: 5}", "ends at step 5, expected 6 to 800");
    refuse_picture("{kind: series, until: 900}", "ends at step 900, expected 1 to 800");
    refuse_picture("{kind: motion, logarithmic: true}", "'logarithmic'");
    refuse_picture("{kind: field, field: enegy}", "no body has a field enegy");
    refuse_picture("{kind: motion, field: energy}",
                   "'field', which a picture of kind 'motion' does not draw");
    refuse_picture("{kind: strip, range: [2, 1]}", "colours from 2 to 1, expected the lower");
    refuse_picture("{kind: sweep}", "the study has no 'sweep'");
    refuse_picture("{kind: profile}", "the scenario has no 'profile'");
}

/* Each kind has a name of its own, and reads only keys that the schema knows. */
static void kinds_are_told_apart_and_read_known_keys(void **state)
{
    (void)state;
    for (int k = 0; k < FW_PICTURE_KINDS; ++k) {
        char keys[128], *rest = keys;
        for (int other = 0; other < k; ++other)
            assert_string_not_equal(fw_picture_rows[k].name, fw_picture_rows[other].name);
        snprintf(keys, sizeof keys, "%s", fw_picture_rows[k].keys);
        for (char *key = strtok_r(keys, " ", &rest); key; key = strtok_r(NULL, " ", &rest)) {
            if (!fw_schema_find("picture", key)) fail_msg("%s is no key of a picture", key);
            assert_true(fw_picture_reads((fw_picture_kind)k, key));
        }
        assert_true(fw_picture_reads((fw_picture_kind)k, "title"));
    }
    assert_false(fw_picture_reads(FW_PICTURE_MOTION, "field"));
    assert_false(fw_picture_reads(FW_PICTURE_SERIES, "observable"));
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
        cmocka_unit_test(a_quantity_that_another_would_flatten_stands_alone),
        cmocka_unit_test(the_exact_solution_is_where_the_automaton_is),
        cmocka_unit_test(every_picture_of_the_scenario_is_drawn),
        cmocka_unit_test(the_ending_says_what_a_picture_becomes),
        cmocka_unit_test(kinds_can_be_chosen_without_a_picture),
        cmocka_unit_test(results_without_pictures_show_the_motion),
        cmocka_unit_test(an_unfinished_run_shows_what_it_has),
        cmocka_unit_test(unknown_names_are_told_what_was_meant),
        cmocka_unit_test(wishes_that_contradict_each_other_are_refused),
        cmocka_unit_test(lists_of_the_command_line_are_read_strictly),
        cmocka_unit_test(results_that_are_not_there_are_refused),
        cmocka_unit_test(a_picture_that_fails_is_reported_after_the_others),
        cmocka_unit_test(a_folder_that_cannot_be_written_to_fails_with_a_sentence),
        cmocka_unit_test(pictures_that_cannot_be_drawn_are_refused_before_the_run),
        cmocka_unit_test(kinds_are_told_apart_and_read_known_keys),
    };
    return cmocka_run_group_tests(tests, make_run, remove_run);
}
