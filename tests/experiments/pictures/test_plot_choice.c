/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot_choice.c - from a wish to a picture: its frames, span, words and colours; what is
 * refused; and where a closed form stands for a simulation. */
#include "tests/support/laws.h"

#include "experiments/drawing/palette.h"
#include "experiments/pictures/plot_choice.h"
#include "experiments/pictures/plot_exact.h"

#include "tests/support/plotted_run.h"

static char other[64];
static fw_plot_result result;
static fw_plot_choice choice;

/* Frames are recorded at 0, 4, 8 and 12. */
static const char flight[] =
    "title: a sheet flies\n"
    "source: Somebody 2000\n"
    "figure: Fig. 3\n"
    "materials: {felt: {lattice-boltzmann: {}}}\n"
    "bodies: {sheet: {material: felt, shape: {rectangle: [3, 3]}, velocity: [.1, 0]}}\n"
    "run: {steps: 12, record-every: 4}\n"
    "record: {fields: [speed, energy]}\n"
    "measure: [energy, elastic-energy, momentum]\n"
    "pictures:\n"
    "  early: {kind: motion, instants: [0, 5, 6, 7, 9, 10]}\n"
    "  late: {kind: motion, instants: [0, 10]}\n"
    "  part: {kind: series, observables: [momentum], from: 4}\n";

static void choose(fw_plot_wish wish)
{
    assert_fine(fw_plot_choose(&choice, &result, &wish, &error));
}

/* What was not recorded is said, in the output and in the caption; nothing is shown twice. */
static void no_step_is_drawn_under_another_name(void **state)
{
    (void)state;
    choose((fw_plot_wish){.picture = "early"});
    assert_string_equal(choice.notes, "Nearest recorded steps: 4 for 5, 4 for 6, 8 for 7. Missing, "
                                      "as the results end at step 12: 30, 40.");
    assert_non_null(strstr(choice.caption, "Compare Somebody 2000. Nearest recorded steps: 4 for"));
    assert_int_equal(choice.picture.frame_count, 3);
    for (int k = 0; k < 3; ++k) assert_int_equal(choice.picture.frames[k], k);
    assert_false(choice.picture.fixed_axes);
    fw_plot_choice_clear(&choice);
    choose((fw_plot_wish){.picture = "late"});
    assert_string_equal(choice.notes, "Missing, as the results end at step 12: 30.");
    fw_plot_choice_clear(&choice);
    choose((fw_plot_wish){.picture = "late", .steps = (int64_t[]){8}, .step_count = 1});
    assert_string_equal(choice.notes, "");
    assert_string_equal(choice.caption,
                        "Compare Somebody 2000. Reduced units: a length of 1 is a lattice "
                        "spacing.");
    assert_true(choice.picture.fixed_axes);
    fw_plot_choice_clear(&choice);
}

/* Both ends from the command line, or one of them and the scenario's other. */
static void spans_come_from_both_sides(void **state)
{
    (void)state;
    const struct {
        fw_plot_wish wish;
        int64_t from, until;
    } rows[] = {
        {{.picture = "part"}, 4, INT64_MAX},
        {{.picture = "part", .until = 9}, 4, 9},
        {{.picture = "part", .from = 6}, 6, INT64_MAX},
        {{.picture = "part", .steps = (int64_t[]){0, 8}, .step_count = 2}, 0, 8},
        {{.kind = "histogram", .from = 1, .until = 12}, 1, 12},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        choose(rows[n].wish);
        assert_int_equal(choice.picture.asked.from, rows[n].from);
        assert_int_equal(choice.picture.asked.until, rows[n].until);
        fw_plot_choice_clear(&choice);
    }
}

/* Energies, as far as they were measured; the first field; the map of colours that is named. */
static void what_is_not_named_is_usual(void **state)
{
    (void)state;
    choose((fw_plot_wish){.kind = "series"});
    assert_int_equal(choice.picture.observable_count, 2);
    assert_string_equal(choice.picture.observables[0], "energy");
    assert_string_equal(choice.picture.observables[1], "elastic-energy");
    assert_string_equal(choice.file + strlen(other), "/series.png");
    fw_plot_choice_clear(&choice);
    choose((fw_plot_wish){.kind = "field", .palette = "grey", .range = {1, 2}});
    assert_string_equal(choice.picture.asked.field.text, "speed");
    assert_int_equal(choice.picture.map, fw_palette_find("grey"));
    assert_close(choice.picture.asked.range[1], 2, 0);
    fw_plot_choice_clear(&choice);
    choose((fw_plot_wish){.kind = "field", .steps = (int64_t[]){0, 8}, .step_count = 2});
    assert_int_equal(choice.picture.asked.kind, FW_PICTURE_STRIP);
    fw_plot_choice_clear(&choice);
}

static void what_cannot_be_drawn_is_refused(void **state)
{
    (void)state;
    static const char span[] = "a series is drawn from one step to a later one, expected --at "
                               "FROM,UNTIL, or --from and --until";
    static const int64_t many[] = {0, 4, 8, 12};
    const struct {
        fw_plot_wish wish;
        const char *words;
    } rows[] = {
        {{.kind = "series", .steps = many, .step_count = 1}, span},
        {{.kind = "series", .steps = many, .step_count = 2, .from = 4}, span},
        {{.kind = "series", .steps = many, .step_count = 2, .until = 4}, span},
        {{.kind = "series", .steps = many + 3, .step_count = 1}, span},
        {{.kind = "motion", .steps = (int64_t[]){-1}, .step_count = 1},
         ": step -1, but the results hold the steps 0 to 12"},
        {{.kind = "motion", .steps = (int64_t[]){13}, .step_count = 1},
         ": step 13, but the results hold the steps 0 to 12"},
        {{.picture = "erly"}, "has no picture erly; did you mean early?"},
        {{.picture = "nothing-like-it"},
         "has no picture nothing-like-it, expected one of early, late, part"},
        {{.kind = "feild"}, "no pictures of kind feild; did you mean field?"},
        {{.kind = "nothing-like-it"}, ", or sweep, map in the folder of a sweep"},
        {{.field = "sped"}, "has no field sped; did you mean speed?"},
        {{.field = "kinetic-temprature"}, "was not recorded (there is speed, energy); to have it"},
        {{.kind = "sweep"}, "no pictures of kind sweep"},
        {{.picture = "late", .kind = "motion"},
         "both the picture late and the kind motion, expected one of the two"},
        {{.kind = "series", .level = &(double){1}}, "kind series does not draw a level"},
        {{.kind = "motion", .logarithmic = true}, "does not draw anything on logarithmic axes"},
        {{.kind = "motion", .range = {1, 2}}, "does not draw a range of colours"},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        assert_refused(fw_plot_choose(&choice, &result, &rows[n].wish, &error), FW_BAD_INPUT,
                       rows[n].words);
        fw_plot_choice_clear(&choice);
    }
}

/* --- closed forms --- */

#define MODE                                                                                       \
    "displacement: [{mode: {wave-vector: [0.7853981633974483, 0], branch: fast, "                  \
    "amplitude: 0.3}}]"

/* The wave runs freely as long as nothing but it moves the cells, and nothing holds them. */
static void a_closed_form_is_that_of_a_free_wave(void **state)
{
    (void)state;
    static const struct {
        const char *boundary, *body, *rest, *field;
        bool exists;
    } rows[] = {
        {"periodic", MODE, "", "displacement-x", true},
        {"periodic", MODE, "", "displacement-y", true},
        {"periodic", MODE, "", "speed", false},
        {"periodic", MODE, "", NULL, false},
        {"bond", MODE, "", "displacement-x", false},
        {"periodic", "displacement: [{random: 0.1}]", "", "displacement-x", false},
        {"periodic", "velocity: [0.1, 0]", "", "displacement-x", false},
        {"periodic", MODE ", velocity: [0.1, 0]", "", "displacement-x", false},
        {"periodic", MODE ", velocity: [0, 0.1]", "", "displacement-x", false},
        {"periodic", MODE ", velocities: [{random: 0.1}]", "", "displacement-x", false},
        {"periodic", MODE, "forces: {f: {body: square, force: [0.1, 0]}}\n", "displacement-x",
         false},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char text[1024];
        fw_plot_result of = {.directory = other};
        snprintf(text, sizeof text,
                 "title: a wave\nmaterials: {foam: {elastic-automaton: {c1: 0.5, c2: 1, boundary: "
                 "%s}}}\nbodies: {square: {material: foam, shape: {rectangle: [8, 8]}, %s}}\n%s"
                 "run: {steps: 2}\n",
                 rows[n].boundary, rows[n].body, rows[n].rest);
        assert_fine(fw_scenario_read(&of.scenario, "w.yaml", text, strlen(text), NULL, 0, &error));
        if (fw_plot_exact_exists(&of, rows[n].field) != rows[n].exists) fail_msg("row %zu", n);
        fw_scenario_destroy(of.scenario);
    }
}

static int set_up(void **state)
{
    (void)state;
    make_folder(other, sizeof other);
    run_scenario(flight, other);
    assert_fine(fw_plot_result_open(&result, other, &error));
    /* As of a run that was to go on and ended early. */
    result.scenario->pictures[0].instants[4] = result.scenario->pictures[1].instants[1] = 30;
    result.scenario->pictures[0].instants[5] = 40;
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    fw_plot_result_close(&result);
    remove_folder(other);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_step_is_drawn_under_another_name),
        cmocka_unit_test(spans_come_from_both_sides),
        cmocka_unit_test(what_is_not_named_is_usual),
        cmocka_unit_test(what_cannot_be_drawn_is_refused),
        cmocka_unit_test(a_closed_form_is_that_of_a_free_wave),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
