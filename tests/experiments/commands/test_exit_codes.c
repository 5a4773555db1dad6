/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_exit_codes.c - every exit code that the help tells of, by every command that can end with
 * it. Those of signals are in test_interruption.c. */
#include "tests/support/laws.h"

#include "tests/support/program.h"

/* Flies alone; its momentum is .5 in x. */
#define FLIGHT                                                                                     \
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"                                     \
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}, velocity: [0.5, 0]}}\n"          \
    "run: {steps: 8, limit: 50}\n"                                                                 \
    "measure: [momentum]\n"

static const char good[] = "title: good\n" FLIGHT "expect: [{quantity: energy, above: 0}]\n";
static const char wrong[] = "title: wrong\n" FLIGHT "expect: [{quantity: energy, below: 0}]\n";
static const char swept[] =
    "title: swept\n" FLIGHT "study: {sweep: {parameters: {v: {values: [0.1, 0.2]}}, set: "
    "['bodies.speck.velocity=[v, 0]']}}\n"
    "expect: [{quantity: energy, below: 0}]\n";

static char folder[64];

static int begin(void **state)
{
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "good.yaml", good);
    write_scenario(folder, "wrong.yaml", wrong);
    write_scenario(folder, "swept.yaml", swept);
    const outcome seen = run_program(folder, "run good.yaml -q -o done");
    expect_end(&seen, 0, "");
    return 0;
}

static int end(void **state)
{
    (void)state;
    remove_folder(folder);
    return 0;
}

static void expect_code(int code, const char *line)
{
    const outcome seen = run_program(folder, line);
    if (seen.code != code)
        fail_msg("`fretwork %s` ends with %d (signal %d), expected %d: %s", line, seen.code,
                 seen.signal, code, seen.err);
    /* A failure is one sentence, and an expectation that fails is none. */
    if (code > 1 && *line) assert_true(strncmp(seen.err, "fretwork: ", 10) == 0);
}

static void what_is_fine_ends_with_0(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "--help",
        "--version",
        "help",
        "help run",
        "run --help",
        "list",
        "list --names",
        "show wall-bounce",
        "check good.yaml",
        "check good.yaml --json",
        "check swept.yaml",
        "check wrong.yaml",
        "run good.yaml -q --no-plot -o again",
        "run wrong.yaml -q --no-plot -o unasked --set expect=[]",
        "verify good.yaml -q",
        "plot done -o picture.png --kind series --observable momentum",
        "table done",
        "quantities",
        "quantities energy",
        "reference run",
        "cite wall-bounce",
        "cite done",
    };
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n) expect_code(0, lines[n]);
}

/* The results are whole all the same. */
static void an_expectation_that_fails_ends_with_1(void **state)
{
    (void)state;
    expect_code(1, "run wrong.yaml -q -o wrong");
    expect_code(1, "run wrong.yaml -q --no-plot -o wrong-plain");
    expect_code(1, "run swept.yaml -q --no-plot -o swept");
    expect_code(1, "verify wrong.yaml -q");
    expect_code(1, "verify good.yaml wrong.yaml -q");
    expect_code(0, "table wrong");
    assert_true(exists(folder, "swept/sweep.csv"));
}

static void bad_input_ends_with_2(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "",
        "nonsense",
        "help nonsense",
        "list --nonsense",
        "show",
        "show nonsense",
        "check nonsense",
        "check good.yaml --set run.steps=-1",
        "run nonsense",
        "run good.yaml -q -o done",
        "run good.yaml -q --set run.stps=3",
        "run good.yaml -q --threads 0",
        "resume done",
        "resume nowhere",
        "verify nonsense",
        "plot nowhere",
        "plot done --kind nonsense",
        "table nowhere",
        "table done --observable nonsense",
        "profile done",
        "quantities nonsense",
        "reference nonsense",
        "cite nonsense",
    };
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n) expect_code(2, lines[n]);
}

/* It flies out of sight. */
static void what_escapes_ends_with_3(void **state)
{
    (void)state;
    expect_code(3, "run good.yaml -q --no-plot -o lost --set run.limit=2");
    expect_code(3, "verify good.yaml -q --set run.limit=2");
    expect_code(3, "verify good.yaml wrong.yaml -q --set run.limit=2");
    expect_code(3, "run swept.yaml -q --no-plot -o lost-cases --set run.limit=1");
    expect_code(3, "resume lost -q --no-plot");
}

/* The device that is always full stands for any disk. */
static void expect_full(const char *line)
{
    char command[512];
    snprintf(command, sizeof command,
             "'%s' %s > /dev/full 2> err; test $? = 4 && grep -q '^fretwork: standard output "
             "cannot be written' err",
             FW_PROGRAM, line);
    shell(folder, command);
}

static void what_cannot_be_written_ends_with_4(void **state)
{
    (void)state;
    expect_code(4, "check good.yaml -o nowhere/start.png");
    expect_code(4, "plot done -o nowhere/picture.png");
    expect_code(4, "table done -o nowhere/table.csv");
    expect_code(4, "verify good.yaml -q --json nowhere/verdicts.json");
    static const char *const lines[] = {
        "--help",
        "--version",
        "help run",
        "list",
        "show wall-bounce",
        "check good.yaml",
        "table done",
        "run good.yaml -q --no-plot -o full",
        "verify good.yaml -q",
        "quantities",
        "reference run",
        "cite wall-bounce",
    };
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n) expect_full(lines[n]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_fine_ends_with_0),
        cmocka_unit_test(an_expectation_that_fails_ends_with_1),
        cmocka_unit_test(bad_input_ends_with_2),
        cmocka_unit_test(what_escapes_ends_with_3),
        cmocka_unit_test(what_cannot_be_written_ends_with_4),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
