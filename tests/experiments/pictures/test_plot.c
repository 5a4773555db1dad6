/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_plot.c - which pictures of a results folder are drawn, that nothing is drawn under a wrong
 * name, and what is said where there is nothing to draw. */
#include "tests/support/laws.h"

#include "experiments/commands/command.h"
#include "experiments/pictures/plot.h"
#include "experiments/scenario/scenario.h"

#include "tests/support/plotted_run.h"

#include <sys/stat.h>
#include <sys/wait.h>

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
    assert_refused(
        plot_one(&(fw_plot_wish){.kind = "movie"}), FW_BAD_INPUT,
        "expected one of motion, forces, contact, field, strip, structure, stages, histogram, "
        "series, profile, loop, slip, heat, "
        "analysis, or sweep, map in the folder of a sweep");
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
                   FW_BAD_INPUT, "from step 20 until step 0, expected a later one");
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
    snprintf(path, sizeof path, "%s/sealed.png", folder);
    assert_int_equal(chmod(folder, 0555), 0);
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        /* Root may write anywhere, so somebody else tries. */
        if (geteuid() == 0 && setuid(65534) != 0) _exit(1);
        const fw_status status = plot_one(&(fw_plot_wish){.file = path});
        _exit(status == FW_SYSTEM_FAILED && strstr(error.sentence, "sealed.png") ? 0 : 2);
    }
    int ending;
    assert_int_equal(waitpid(child, &ending, 0), child);
    assert_int_equal(chmod(folder, 0755), 0);
    assert_true(WIFEXITED(ending) && WEXITSTATUS(ending) == 0);
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
    refuse_picture("{kind: structure, instants: [0, 1, 2, 3, 4, 5, 6]}",
                   "shows 7 instants, expected at most 6 side by side");
    refuse_picture("{kind: stages, instants: [0, 1, 2, 3, 4, 5, 6]}", "at most 6");
    refuse_picture("{kind: structure, field: speed}", "'field'");
    refuse_picture("{kind: histogram, instants: [0]}", "'instants'");
    refuse_picture("{kind: sweep}", "the study has no 'sweep'");
    refuse_picture("{kind: profile}", "the scenario has no 'profile'");
}

/* Each kind has a name of its own, and reads only keys that the schema knows. */
static void kinds_are_told_apart_and_read_known_keys(void **state)
{
    (void)state;
    const fw_section *picture = fw_section_find(&fw_scenario_section, "pictures")->subsection;
    for (int k = 0; k < FW_PICTURE_KINDS; ++k) {
        char keys[128], *rest = keys;
        for (int other = 0; other < k; ++other)
            assert_string_not_equal(fw_picture_rows[k].name, fw_picture_rows[other].name);
        snprintf(keys, sizeof keys, "%s", fw_picture_rows[k].keys);
        for (char *key = strtok_r(keys, " ", &rest); key; key = strtok_r(NULL, " ", &rest)) {
            if (!fw_section_find(picture, key)) fail_msg("%s is no key of a picture", key);
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
