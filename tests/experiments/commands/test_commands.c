/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_commands.c - check tells the size that a run comes to have, table the numbers that it
 * measured, and verify's JSON what its tables say. */
#include "tests/support/laws.h"

#include "experiments/results/playback.h"
#include "experiments/text/json.h"
#include "tests/support/program.h"

#include <sys/stat.h>

/* The first number behind a word at the beginning of a line. */
static double number_of(const char *text, const char *word)
{
    char start[64];
    snprintf(start, sizeof start, "\n  %s ", word);
    const char *line = strstr(text, start);
    if (!line) fail_msg("nothing is said of %s in: %s", word, text);
    return strtod(line + strlen(start), NULL);
}

static void check_tells_what_a_run_takes(void **state)
{
    char folder[64], path[128];
    struct stat file;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, "check wall-bounce --set run.record-every=20 -o start.png");
    expect_end(&seen, 0, "");
    assert_int_equal(number_of(seen.out, "bodies"), 1);
    assert_int_equal(number_of(seen.out, "particles"), 400);
    assert_int_equal(number_of(seen.out, "links"), 760); /* 2 * 20 * 19 */
    assert_int_equal(number_of(seen.out, "steps"), 4000);
    assert_int_equal(number_of(seen.out, "frames"), 201);
    assert_int_equal(number_of(seen.out, "samples"), 4001);
    assert_true(number_of(seen.out, "memory") > 1);
    assert_true(number_of(seen.out, "time") > 0);
    assert_non_null(strstr(seen.out, "wall-bounce can be run\n"));
    assert_null(strstr(seen.out, "warning"));
    /* Nothing but the picture, and that is one. */
    shell(folder, "test \"$(ls)\" = start.png && head -c 4 start.png | grep -q PNG");
    double predicted = number_of(seen.out, "results file"),
           kept = number_of(seen.out, "checkpoints");
    seen = run_program(folder, "run wall-bounce --no-plot --set run.record-every=20 -o it");
    expect_end(&seen, 0, "");
    snprintf(path, sizeof path, "%s/it/trajectory.h5", folder);
    assert_int_equal(stat(path, &file), 0);
    assert_close((double)file.st_size / 1e6, predicted, 0.02 * predicted);
    snprintf(path, sizeof path, "%s/it/checkpoint-A", folder);
    assert_int_equal(stat(path, &file), 0);
    assert_close((double)file.st_size / 1e3, kept, 0.02 * kept);
    remove_folder(folder);
}

/* Below the table, whose numbers stay reduced. */
static void a_run_says_what_its_units_are(void **state)
{
    (void)state;
    char folder[64];
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, "run translate -o bare --no-plot --quiet");
    expect_end(&seen, 0, "");
    assert_null(strstr(seen.out, "one unit is"));
    seen = run_program(folder, "run translate -o with --no-plot --quiet --set "
                               "'units={length: 1 mm, time: 2 us, mass: 1 mg}'");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "\nin reduced units; one unit is length 1 mm, mass 1 mg"));
    remove_folder(folder);
}

/* Only where something has one. */
static void check_tells_of_temperatures_where_there_are_any(void **state)
{
    (void)state;
    outcome seen = run_program("/tmp", "check copper");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "temperature 2269 K"));
    seen = run_program("/tmp", "check wall-bounce --set "
                               "'units={length: 1 mm, time: 0.12 us, mass: 3.93 mg}'");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "force 0.2729 MN"));
    assert_null(strstr(seen.out, "temperature"));
}

static void check_warns_and_refuses(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, "check wall-bounce --set bodies.sheet.velocity=[0.3,0.2]");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "warning: at such a speed particles pass each other"));
    assert_non_null(strstr(seen.out, "wall-bounce can be run, with 1 warning\n"));
    /* A body that meets nothing may be as fast as it likes. */
    seen = run_program(folder, "check free-particle --set bodies.particle.velocity=[3,2]");
    expect_end(&seen, 0, "");
    assert_null(strstr(seen.out, "warning"));
    seen = run_program(folder, "check wall-bounce --set bodies.sheet.origin=[50,50]");
    expect_end(&seen, 2, "body sheet starts in wall container");
    seen = run_program(folder, "check wall-bounce --set run.limit=21");
    expect_end(&seen, 3, "of body sheet is at (");
    shell(folder, "test -z \"$(ls)\"");
    remove_folder(folder);
}

/* What a run warns of is said by check before, and stands in the table of the run. */
static void warnings_are_in_check_and_in_the_table(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, "check bounce-as-printed");
    expect_end(&seen, 0, "");
    const char *wall = strstr(seen.out, "warning: the surface of wall ");
    assert_non_null(wall);
    assert_non_null(strstr(wall, "is 'componentwise'"));
    assert_non_null(strstr(seen.out, "bounce-as-printed can be run, with 1 warning\n"));
    seen = run_program(folder, "run bounce-as-printed -q --no-plot -o it");
    expect_end(&seen, 0, "is 'componentwise'");
    wall = strstr(seen.out, "\nwarning: the surface of wall ");
    assert_non_null(wall);
    const char *fold = strstr(wall + 1, "\nwarning: ");
    assert_non_null(fold);
    assert_non_null(strstr(fold, "the edge of body body crosses itself near"));
    assert_null(strstr(fold + 1, "\nwarning: ")); /* it is said once */
    seen = run_program(folder, "run wall-bounce -q --no-plot -o other");
    assert_null(strstr(seen.out, "warning"));
    remove_folder(folder);
}

static const char pressed[] =
    "title: a gas above a floor\n"
    "materials: {gas: {movable-particles: {strength: 0}}}\n"
    "bodies: {cloud: {material: gas, shape: {rectangle: [5, 5]}, temperature: 1}}\n"
    "dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}\n"
    "walls: {floor: {chain: [[-10, -3], [20, -3]]}}\n"
    "run: {steps: 20}\n"
    "profile: {every: 5, bin: 1, far: [0.5, 3]}\n"
    "study: {seeds: 2, control: ['bodies.cloud.origin=[0, -4]']}\n";

/* Nothing is begun where the control cannot be, and the sentence names the control's place. */
static void what_a_control_cannot_begin_is_refused_before(void **state)
{
    static const char *const lines[] = {"check pressed.yaml", "run pressed.yaml -q -o it",
                                        "verify pressed.yaml -q"};
    static const char sentence[] = "fretwork: pressed.yaml:8:28: control: body cloud starts in "
                                   "wall floor: particle 0 at (0, -4) lies 1 behind its surface";
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "pressed.yaml", pressed);
    for (int n = 0; n < 3; ++n) {
        outcome seen = run_program(folder, lines[n]);
        expect_end(&seen, 2, sentence);
        assert_string_equal(seen.out, "");
    }
    shell(folder, "test \"$(ls)\" = pressed.yaml");
    remove_folder(folder);
}

/* Reads the next cell, in quotes or not; returns what is behind its comma or line end. */
static char *next_cell(char *at, char *cell, size_t size)
{
    char stop = ',';
    size_t length = 0;
    if (*at == '"') {
        stop = '"';
        ++at;
    }
    while (*at && *at != stop && *at != '\n' && length < size - 1) cell[length++] = *at++;
    cell[length] = '\0';
    if (*at == '"') ++at;
    return *at ? at + 1 : at;
}

static void table_gives_the_same_numbers_back(void **state)
{
    char folder[64], path[128], cell[256];
    fw_playback *playback;
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, "run free-particle --no-plot -o it");
    expect_end(&seen, 0, "");
    snprintf(path, sizeof path, "%s/it", folder);
    assert_fine(fw_playback_open(&playback, path, &error));
    assert_int_equal(playback->sample_count, 101);
    double momentum[101][2], position[101][2], times[101];
    int64_t steps[101];
    int p = fw_playback_find_observable(playback, "momentum"),
        r = fw_playback_find_observable(playback, "position.particle[0,0]");
    assert_fine(fw_playback_read_observable(playback, p, momentum[0], &error));
    assert_fine(fw_playback_read_observable(playback, r, position[0], &error));
    assert_fine(fw_playback_read_sample_times(playback, steps, times, &error));
    fw_playback_close(playback);

    seen = run_program(folder, "table it --observable position.particle[0,0],momentum.y,momentum");
    expect_end(&seen, 0, "");
    char *at = strstr(seen.out, "\nstep,");
    assert_non_null(at);
    assert_non_null(strstr(seen.out, "\n# units: steps,time,length,length,momentum,momentum\n"));
    static const char *const names[] = {
        "step",       "time",      "position.particle[0,0].x", "position.particle[0,0].y",
        "momentum.y", "momentum.x"};
    ++at;
    for (int n = 0; n < 6; ++n) {
        at = next_cell(at, cell, sizeof cell);
        assert_string_equal(cell, names[n]);
    }
    for (int row = 0; row < 101; ++row) {
        const double wanted[] = {(double)steps[row], times[row],       position[row][0],
                                 position[row][1],   momentum[row][1], momentum[row][0]};
        for (int n = 0; n < 6; ++n) {
            at = next_cell(at, cell, sizeof cell);
            assert_true(strtod(cell, NULL) == wanted[n]);
        }
    }
    assert_string_equal(at, "");

    seen = run_program(folder, "table it -o all.csv");
    expect_end(&seen, 0, "");
    assert_string_equal(seen.out, "");
    shell(folder, "test $(wc -l < all.csv) = 104 && test \"$(ls)\" = \"$(printf 'all.csv\\nit')\"");
    remove_folder(folder);
}

static void json_holds_any_text_and_number(void **state)
{
    char *text;
    size_t size;
    (void)state;
    fw_json json = {.out = open_memstream(&text, &size)};
    fw_json_begin(&json, NULL, '{');
    fw_json_text(&json, "quote\"d", "a\\b\n\tc\x01 \xc3\xa9 \xff\xc3");
    fw_json_begin(&json, "list", '[');
    fw_json_number(&json, NULL, 0.1);
    fw_json_number(&json, NULL, NAN);
    fw_json_number(&json, NULL, -INFINITY);
    fw_json_integer(&json, NULL, INT64_MIN);
    fw_json_begin(&json, NULL, '{');
    fw_json_end(&json, '}');
    fw_json_end(&json, ']');
    fw_json_flag(&json, "flag", false);
    fw_json_text(&json, "none", NULL);
    fw_json_end(&json, '}');
    fclose(json.out);
    assert_string_equal(text,
                        "{\n"
                        "  \"quote\\\"d\": \"a\\\\b\\n\\tc\\u0001 \xc3\xa9 \\ufffd\\ufffd\",\n"
                        "  \"list\": [\n"
                        "    0.1,\n"
                        "    null,\n"
                        "    null,\n"
                        "    -9223372036854775808,\n"
                        "    {}\n"
                        "  ],\n"
                        "  \"flag\": false,\n"
                        "  \"none\": null\n"
                        "}\n");
    free(text);
}

/* Of every kind of verdict one; the friction ratio of a wall that nothing touched is no number. */
static const char judged[] =
    "title: \"a \\\"falling\\\" particle\"\n"
    "source: Körper\n"
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}, velocity: [0.5, 0]}}\n"
    "walls: {floor: {chain: [[-50, -9], [50, -9]]}}\n"
    "run: {steps: 4}\n"
    "expect:\n"
    "  - {quantity: position, site: [0, 0], body: speck, component: x, value: 2.5, within: 0.25}\n"
    "  - {quantity: energy, value: 0.0625, within-relative: 0.01, source: half, note: so}\n"
    "  - {quantity: energy, above: 0.01, below: 1}\n"
    "  - {quantity: friction-ratio, wall: floor, below: 1}\n";

static void verify_writes_its_verdicts_as_json(void **state)
{
    char folder[64], path[128], arguments[256];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    snprintf(path, sizeof path, "%s/judged.yaml", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(judged, file);
    fclose(file);
    outcome seen = run_program(folder, "verify judged.yaml damping -q --json verdicts.json");
    expect_end(&seen, 1, "");
    assert_non_null(strstr(seen.out, "2 experiments, 9 expectations, 2 failed\n"));
    outcome alone = run_program(folder, "verify judged.yaml damping -q --json -");
    expect_end(&alone, 1, "");
    snprintf(path, sizeof path, "%s/alone.json", folder);
    file = fopen(path, "w");
    assert_non_null(file);
    fputs(alone.out, file);
    fclose(file);
    snprintf(arguments, sizeof arguments, "verdicts %s/verdicts.json %s/alone.json", folder,
             folder);
    int status = run_python("results.py", arguments);
    if (status > 0) fail_msg("results.py %s failed", arguments);
    /* What cannot be written is said, and what was there stays. */
    seen = run_program(folder, "verify damping -q --json nowhere/verdicts.json");
    expect_end(&seen, 4, "cannot write 'nowhere/verdicts.json'");
    seen = run_program(folder, "verify wall-bounce -q --set run.limit=21 --json verdicts.json");
    expect_end(&seen, 3, "fretwork: wall-bounce: step ");
    status = run_python("results.py", arguments);
    if (status > 0) fail_msg("results.py %s failed", arguments);
    remove_folder(folder);
    skip_unseen();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(check_tells_what_a_run_takes),
        cmocka_unit_test(a_run_says_what_its_units_are),
        cmocka_unit_test(check_tells_of_temperatures_where_there_are_any),
        cmocka_unit_test(check_warns_and_refuses),
        cmocka_unit_test(what_a_control_cannot_begin_is_refused_before),
        cmocka_unit_test(warnings_are_in_check_and_in_the_table),
        cmocka_unit_test(table_gives_the_same_numbers_back),
        cmocka_unit_test(json_holds_any_text_and_number),
        cmocka_unit_test(verify_writes_its_verdicts_as_json),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
