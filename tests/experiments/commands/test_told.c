/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_told.c - what commands tell of a result, of a sweep, of a run that is not finished and of
 * folders without any of these. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

static const char flight[] =
    "title: two sheets\n"
    "materials: {rubber: {lattice-boltzmann: {rest-mass: 0}}}\n"
    "bodies:\n"
    "  one: {material: rubber, shape: {rectangle: [3, 2]}, velocity: [0.1, 0]}\n"
    "  two: {material: rubber, shape: {rectangle: [2, 2]}, origin: [9, 0]}\n"
    "run: {steps: 6, record-every: 3, limit: 50}\n"
    "record: {force: true, fields: [speed, strain-yy]}\n"
    "measure: [energy]\n"
    "profile: {axis: y, every: 2, far: [0, 4]}\n";

#define SPECK                                                                                      \
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"                                     \
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}, velocity: [0.5, 0]}}\n"          \
    "run: {steps: 8, limit: 50}\n"                                                                 \
    "expect: [{quantity: energy, above: 0}]\n"

static const char swept[] =
    "title: swept\n" SPECK "study: {sweep: {parameters: {v: {values: [0.1, 0.2]}}, set: "
    "['bodies.speck.velocity=[v, 0]']}}\n";
static const char halved[] =
    "title: halved\n"
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}}}\n"
    "run: {steps: 8, limit: 50}\n"
    "study: {sweep: {parameters: {v: {from: 0, to: 0.5, tolerance: 0.1}}, set: "
    "['bodies.speck.velocity=[v, 0]']}}\n"
    "expect: [{quantity: centre-of-mass, component: x, crosses: 2, value: 0.2, within: 0.1}]\n";

static char folder[64];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "flight.yaml", flight);
    write_scenario(folder, "swept.yaml", swept);
    write_scenario(folder, "halved.yaml", halved);
    outcome seen = run_program(folder, "run flight.yaml -q --no-plot -o done");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "run swept.yaml -q --no-plot -o cases");
    expect_end(&seen, 0, "");
    seen = run_program(folder, "run flight.yaml -q --no-plot -o lost --set run.steps=600");
    expect_end(&seen, 3, "of body two is at (");
    shell(folder, "mkdir empty");
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

/* Line by line; what a machine or a day decides stands there with any text. */
static void a_result_is_listed_as_text(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "two sheets\n",
        "  bodies       one (6 particles), two (4 particles)\n",
        "  frames       3, with position, velocity, force\n",
        "  fields       speed, strain-yy\n",
        "  samples      7\n",
        "  observables  energy, contact-return-force\n",
        "  seed         1\n",
        "  run          finished\n",
        "  start        ",
        "  compiler     ",
        "  forms        one: displacements; two: displacements\n",
        "  certificate  no penetration, energy ledger closed to ",
    };
    const outcome seen = run_program(folder, "list done"),
                  file = run_program(folder, "list done/trajectory.h5");
    expect_end(&seen, 0, "");
    expect_end(&file, 0, "");
    assert_string_equal(seen.out, file.out);
    const char *at = seen.out;
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n) {
        const char *found = strstr(at, lines[n]);
        if (!found) fail_msg("'%s' does not stand after the lines before in\n%s", lines[n], at);
        assert_true(found == seen.out || found[-1] == '\n');
        at = found;
    }
}

/* Each body by its own name, with its own particles; links: 7 and 4. */
static void check_tells_bodies_apart(void **state)
{
    (void)state;
    static const char sizes[] = "flight: two sheets\n"
                                "  bodies         2\n"
                                "                 6 particles, one\n"
                                "                 4 particles, two\n"
                                "  particles      10\n"
                                "  links          11\n"
                                "  walls          0\n"
                                "  steps          6\n"
                                "  frames         3\n"
                                "  samples        7 of 2 numbers\n";
    outcome seen = run_program(folder, "check flight.yaml");
    expect_end(&seen, 0, "");
    assert_true(strncmp(seen.out, sizes, strlen(sizes)) == 0);
    seen = run_program(folder, "check flight.yaml --json");
    expect_end(&seen, 0, "");
    assert_non_null(strstr(seen.out, "\"bodies\": [\n"
                                     "    {\n"
                                     "      \"name\": \"one\",\n"
                                     "      \"particles\": 6\n"
                                     "    },\n"
                                     "    {\n"
                                     "      \"name\": \"two\",\n"
                                     "      \"particles\": 4\n"
                                     "    }\n"
                                     "  ],\n"));
}

/* clang-format off */
static const struct {
    const char *line;
    int code;
    const char *err, *out;
} rows[] = {
    {"cite cases", 0, "", "chopard2002"},
    {"cite empty", 2, "cannot open empty/trajectory.h5", ""},
    {"list cases", 2, "cases holds a sweep, expected the folder of one of its cases, such as cases/v=0.1", ""},
    {"list ./empty", 2, "cannot open ./empty/trajectory.h5: No such file or directory", ""},
    {"list empty", 2, "no experiment speaks of 'empty'", ""},
    {"export cases --to csv", 2, "cases holds a sweep", ""},
    {"profile cases", 2, "cases holds a sweep", ""},
    {"profile done --axis y", 0, "", "       y  return-force          bond-return-force"},
    {"profile done --axis x", 2, "--axis x, but the run took its profile across y; a run takes another one with `fretwork run NAME --set profile.axis=`, x or y", ""},
    {"profile done --field density", 0, "", "density / 1/length^2: particles per area\n       y  experiment            control"},
    {"profile done --field ordr", 2, "a profile has no field ordr; did you mean order?", ""},
    {"profile done --field xylophone", 2, "a profile has no field xylophone, expected return-force, bond-return-force, order", ""},
    {"rerun cases", 2, "cases holds a sweep", ""},
    {"rerun lost", 2, "lost: the run is not finished, ", ""},
    {"rerun done/trajectory.h5", 2, "rerun of a results file needs a folder for the new results, expected -o DIR", ""},
    {"rerun done/trajectory.h5 -o third -q --no-plot", 0, "", "done/trajectory.h5 and third are the same, bit by bit\n"},
    {"collect done", 2, "done holds no sweep, whose cases could be collected", ""},
    {"extend done --add v=1", 2, "done holds no sweep that could be extended", ""},
    {"extend cases --add v=0.1", 2, "--add v=0.1: the sweep has that already", ""},
    {"sweep done --case v=1", 2, "done holds no sweep, expected a folder that `fretwork sweep NAME -o DIR --list` has made", ""},
    {"check swept.yaml", 0, "", "2 cases, v=0.1 to v=0.2; what follows is of v=0.1\n"},
    {"check swept.yaml --set 'study.sweep.case={v: 0.2}'", 0, "", "the case v=0.2\n"},
    {"check halved.yaml", 0, "", "and those to which bisection comes between them\n"},
};
/* clang-format on */

static void every_folder_gets_what_it_asks_for(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        const outcome seen = run_program(folder, rows[n].line);
        if (seen.code != rows[n].code || !strstr(seen.err, rows[n].err) ||
            !strstr(seen.out, rows[n].out) || (rows[n].code == 0 && *seen.err))
            fail_msg("fretwork %s\n  exit %d: %s%s\n  expected exit %d: %s%s", rows[n].line,
                     seen.code, seen.err, seen.out, rows[n].code, rows[n].err, rows[n].out);
    }
}

/* OpenMP shows its settings each time that the program begins. */
static void commands_with_threads_begin_anew_to_wait_asleep(void **state)
{
    (void)state;
    char line[512];
    static const struct {
        const char *settings, *words;
        int begins;
    } begun[] = {
        {"", "run --help", 2},
        {"", "list --help", 1},
        {"OMP_WAIT_POLICY=active", "run --help", 1},
        {"GOMP_SPINCOUNT=5", "run --help", 1},
    };
    for (size_t n = 0; n < sizeof begun / sizeof *begun; ++n) {
        snprintf(line, sizeof line,
                 "env -u OMP_WAIT_POLICY -u GOMP_SPINCOUNT OMP_DISPLAY_ENV=true %s '%s' %s "
                 "> out 2> err; test $? = 0 && test -s out && "
                 "test $(grep -c 'DISPLAY ENVIRONMENT BEGIN' err) = %d",
                 begun[n].settings, FW_PROGRAM, begun[n].words, begun[n].begins);
        shell(folder, line);
    }
}

static void unknown_instructions_are_refused(void **state)
{
    (void)state;
    char line[512];
    snprintf(line, sizeof line,
             "FRETWORK_INSTRUCTIONS=fast '%s' list > out 2> err; test $? = 2 && test ! -s out && "
             "echo 'fretwork: no instructions \"fast\", expected one of x86-64-v2 to x86-64-v4' | "
             "cmp - err",
             FW_PROGRAM);
    shell(folder, line);
    snprintf(line, sizeof line, "FRETWORK_INSTRUCTIONS= '%s' list --names > out", FW_PROGRAM);
    shell(folder, line);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_result_is_listed_as_text),
        cmocka_unit_test(check_tells_bodies_apart),
        cmocka_unit_test(every_folder_gets_what_it_asks_for),
        cmocka_unit_test(commands_with_threads_begin_anew_to_wait_asleep),
        cmocka_unit_test(unknown_instructions_are_refused),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
