/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_streams.c - what reaches a terminal, and what closed streams do to results: nothing. */
#include "tests/support/laws.h"

#include "experiments/text/terminal.h"
#include "experiments/text/text.h"
#include "tests/support/program.h"

/* Fast enough that it is warned of. */
#define HURRIED                                                                                    \
    "run wall-bounce --no-plot --set bodies.sheet.velocity=[0.4,0.3] --set run.steps=200 "         \
    "--set expect=[] --set pictures={} -o "

static void closed_streams_leave_results_alone(void **state)
{
    static const char *const closed[] = {"2>&-", "1>&- 2>&-", "0<&- 1>&- 2>&-", "0<&-"};
    char folder[64], line[512];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    outcome seen = run_program(folder, HURRIED "whole");
    expect_end(&seen, 0, "warning: ");
    for (int n = 0; n < 4; ++n) {
        snprintf(line, sizeof line, "'%s' " HURRIED "'closed %d' %s", FW_PROGRAM, n, closed[n]);
        shell(folder, line);
        snprintf(line, sizeof line, "mv 'closed %d' closed%d", n, n);
        shell(folder, line);
    }
    expect_same_results(folder, "whole", "closed0 closed1 closed2 closed3");
    remove_folder(folder);
    skip_unseen();
}

/* Escapes are refused in scenarios, but not what turns the direction of writing. */
static const char turned[] =
    "title: \"a \\u202EdeR one\"\n"
    "materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}\n"
    "bodies: {speck: {material: dust, shape: {rectangle: [1, 1]}, velocity: [0.5, 0]}}\n"
    "run: {steps: 4}\n"
    "expect:\n"
    "  - {quantity: energy, above: 0, source: \"paper\\u202E\", note: \"so\\u2066\"}\n";

static void expect_shown(const outcome *seen, const char *text)
{
    if (strstr(seen->out, "\xe2\x80\xae") || strpbrk(seen->out, "\033\a\r") ||
        strpbrk(seen->err, "\033\a\r"))
        fail_msg("a control character in: %s%s", seen->out, seen->err);
    if (!strstr(seen->out, text) && !strstr(seen->err, text))
        fail_msg("'%s' is not in: %s%s", text, seen->out, seen->err);
}

static void control_characters_are_shown_as_text(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    write_scenario(folder, "red.yaml", turned);
    outcome seen = run_program(folder, "run red.yaml -q --no-plot -o it");
    assert_int_equal(seen.code, 0);
    expect_shown(&seen, "a \\u202EdeR one\n");
    expect_shown(&seen, "paper\\u202E\n");
    expect_shown(&seen, "so\\u2066\n");
    seen = run_program(folder, "check red.yaml");
    expect_shown(&seen, "red: a \\u202EdeR");
    seen = run_program(folder, "verify red.yaml -q");
    expect_shown(&seen, "red: a \\u202EdeR");
    seen = run_program(folder, "table it");
    expect_shown(&seen, "# a \\u202EdeR");
    /* Words of the command line and names of files. */
    static const char *const lines[] = {"run x\033[31m",
                                        "x\033[31m",
                                        "run red.yaml --x\033[31m=3",
                                        "run red.yaml x\033[31m",
                                        "list x\033[31m",
                                        "run red.yaml --threads x\033[31m",
                                        "plot x\033[31m",
                                        "table it --observable x\033[31m",
                                        "run red.yaml --set x\033[31m=3",
                                        "run ./x\033[31m.yaml",
                                        "quantities x\033[31m",
                                        "reference x\033[31m",
                                        "resume x\033[31m",
                                        "cite x\033[31m",
                                        "plot it --kind x\033[31m"};
    for (size_t n = 0; n < sizeof lines / sizeof *lines; ++n) {
        seen = run_program(folder, lines[n]);
        assert_int_equal(seen.code, 2);
        expect_shown(&seen, "fretwork: ");
    }
    remove_folder(folder);
}

static void expect_printed(const char *text, const char *wanted, bool one_line)
{
    char out[128] = "";
    FILE *stream = fmemopen(out, sizeof out, "w");
    assert_non_null(stream);
    (one_line ? fw_text_print_line : fw_text_print)(stream, text);
    fclose(stream);
    assert_string_equal(out, wanted);
}

static void any_bytes_can_be_printed(void **state)
{
    (void)state;
    expect_printed("plain, K\xc3\xb6rper \xe2\x88\x9a", "plain, K\xc3\xb6rper \xe2\x88\x9a", true);
    expect_printed("a\tb\nc", "a\tb\nc", false);
    expect_printed("a\tb\nc\r", "a b c\\x0D", true);
    expect_printed("\x01\x1b[0m\x7f", "\\x01\\x1B[0m\\x7F", true);
    /* Bytes that are no UTF-8, and a control character in it: CSI in one byte of Latin-1. */
    expect_printed("\xff\xc3(", "\\xFF\\xC3(", true);
    expect_printed("\xc2\x9b"
                   "31m",
                   "\\x9B31m", true);
    expect_printed("\xe2\x80\xae\xef\xbb\xbf", "\\u202E\\uFEFF", true);
    expect_printed("", "", true);
}

static void colours_are_for_terminals_only(void **state)
{
    char folder[64];
    (void)state;
    make_quick_folder(folder, sizeof folder);
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_false(fw_terminal_is(file));
    assert_false(fw_terminal_colours(file));
    assert_int_equal(fw_terminal_width(file), 80);
    fclose(file);
    /* script(1) gives the program a terminal. */
    if (system("command -v script > /dev/null") == 0) {
        shell(folder, "TERM=xterm script -qec '" FW_PROGRAM " verify damping -q' out > /dev/null; "
                      "grep -q '.\\[32mholds' out");
        shell(folder, "TERM=xterm NO_COLOR=1 script -qec '" FW_PROGRAM
                      " verify damping -q' out > /dev/null; ! grep -q '.\\[32m' out && "
                      "grep -q holds out");
        shell(folder, "TERM=dumb script -qec '" FW_PROGRAM
                      " verify damping -q' out > /dev/null; ! grep -q '.\\[32m' out");
    }
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_streams_leave_results_alone),
        cmocka_unit_test(control_characters_are_shown_as_text),
        cmocka_unit_test(any_bytes_can_be_printed),
        cmocka_unit_test(colours_are_for_terminals_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
