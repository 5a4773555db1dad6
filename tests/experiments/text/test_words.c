/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_words.c - bytes from outside, held against the table of well-formed UTF-8; and what is
 * written of them into sentences, pictures, pages and terminals. */
#define _XOPEN_SOURCE 700
#include "tests/support/laws.h"

#include "experiments/text/markup.h"
#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/terminal.h"
#include "experiments/text/text.h"
#include "experiments/text/xml.h"
#include "tests/support/scratch.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/ioctl.h>

/* The first and the last character of each length, and what lies just beyond; what a picture shows
 * of them. */
static void characters_are_those_of_the_table(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        size_t length; /* of its first character; 0: it is none */
    } rows[] = {
        {"A", 1},
        {"\x7f", 1},
        {"\x80", 0},
        {"\xc1\xbf", 0},
        {"\xc2\x80", 2},
        {"\xdf\xbf", 2},
        {"\xdf\x7f", 0},
        {"\xdf", 0},
        {"\xe0\x9f\xbf", 0},
        {"\xe0\xa0\x80", 3},
        {"\xed\x9f\xbf", 3},
        {"\xed\xa0\x80", 0},
        {"\xed\xbf\xbf", 0},
        {"\xee\x80\x80", 3},
        {"\xef\xbf", 0},
        {"\xf0\x8f\xbf\xbf", 0},
        {"\xf0\x90\x80\x80", 4},
        {"\xf4\x8f\xbf\xbf", 4},
        {"\xf4\x90\x80\x80", 0},
        {"\xf5\x80\x80\x80", 0},
        {"\xff", 0},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char run[FW_MARKUP_RUN];
        const char *text = rows[n].text;
        int level = 0;
        assert_int_equal(fw_text_character(text, strlen(text)), rows[n].length);
        fw_markup_take(&text, &level, run);
        if (rows[n].length > 0)
            assert_string_equal(run, rows[n].text);
        else
            assert_int_equal(run[0], '?');
        assert_int_equal(*text, '\0');
    }
}

static void text_that_is_none_is_found(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int line, column; /* of the fault, or of the end */
        unsigned code;    /* 0: there is none */
    } rows[] = {
        {"a\tb\n", 2, 1, 0},
        {"a\r\nb\rc", 3, 2, 0},
        {"a\r", 2, 1, 0},
        {"\xc3\xa9\xc3\xa9\x01", 1, 3, 1},
        {"\x7f", 1, 1, 0x7f},
        {"a\n\xc2\x85", 2, 1, 0x85},
        {"\xe2\x80\xa8", 1, 1, 0x2028},
        {"x\xe2\x80\xa9", 1, 2, 0x2029},
        {"\xef\xbb\xbfx", 1, 1, 0xfeff},
        {"\xef\xbf\xbe", 1, 1, 0xfffe},
        {"\xef\xbf\xbf", 1, 1, 0xffff},
        {"ab\xf8", 1, 3, 0xf8},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        const fw_text_fault fault = fw_text_check(rows[n].text, strlen(rows[n].text));
        assert_true((fault.what != NULL) == (rows[n].code != 0));
        assert_int_equal(fault.line, rows[n].line);
        assert_int_equal(fault.column, rows[n].column);
        if (fault.what) assert_int_equal(fault.code, rows[n].code);
    }
}

/* A quote ends between characters, on one line. */
static void quotes_are_cut_between_characters(void **state)
{
    (void)state;
    char text[256] = "a\nb\x7f";
    assert_string_equal(fw_text_quote(text, strlen(text)).text, "a b ");
    for (int begin = 0; begin < 3; ++begin) {
        memset(text, 'x', (size_t)begin);
        text[begin] = '\0';
        for (int n = 0; n < 40; ++n) strcat(text, "\xe2\x82\xac");
        const fw_quote quote = fw_text_quote(text, strlen(text));
        const size_t length = strlen(quote.text);
        assert_true(length < FW_QUOTE_SIZE && length >= FW_QUOTE_SIZE - 4);
        assert_null(fw_text_check(quote.text, length).what);
        assert_string_equal(quote.text + length - 3, "...");
    }
    /* No character begins anywhere. */
    memset(text, '\x80', 100);
    assert_string_equal(fw_text_quote(text, 100).text, "...");
}

static void lines_are_whole(void **state)
{
    (void)state;
    char text[] = "one\n\nhalf", *rest = text;
    assert_string_equal(fw_text_line(&rest), "one");
    assert_string_equal(fw_text_line(&rest), "");
    assert_null(fw_text_line(&rest));
    assert_string_equal(rest, "half");
    rest = NULL;
    assert_null(fw_text_line(&rest));
}

/* Raised and lowered runs; what is longer than a run goes on in the next. */
static void markup_is_cut_into_runs(void **state)
{
    (void)state;
    char run[FW_MARKUP_RUN], many[2 * FW_MARKUP_RUN] = "";
    const char *text = "a^{2}b_{i}}\tc";
    static const struct {
        const char *run;
        int level;
    } wanted[] = {{"a", 0}, {"2", 1}, {"b", 0}, {"i", -1}, {"} c", 0}};
    int level = 0;
    for (size_t n = 0; n < sizeof wanted / sizeof *wanted; ++n) {
        fw_markup_take(&text, &level, run);
        assert_string_equal(run, wanted[n].run);
        assert_int_equal(level, wanted[n].level);
    }
    assert_int_equal(*text, '\0');
    memset(many, 'm', sizeof many - 1);
    text = many;
    size_t length = 0;
    while (*text) {
        fw_markup_take(&text, &level, run);
        assert_in_range(strlen(run), 1, FW_MARKUP_RUN - 1);
        length += strlen(run);
    }
    assert_int_equal(length, sizeof many - 1);
}

static void xml_holds_no_control_characters(void **state)
{
    (void)state;
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fw_xml_write_text(out, "<\"a\"&b>\x7f\n\xc3\xa9");
    fclose(out);
    assert_string_equal(text, "&lt;&quot;a&quot;&amp;b&gt;  \xc3\xa9");
    free(text);
}

/* Words of any length are compared, or are as far apart as can be. */
static void spelling_counts_mistakes(void **state)
{
    (void)state;
    char lengthy[FW_NAME_BYTES + 1];
    memset(lengthy, 'a', FW_NAME_BYTES);
    lengthy[FW_NAME_BYTES] = '\0';
    static const struct {
        const char *one, *other;
        int distance;
    } rows[] = {{"energy", "energy", 0}, {"Kinetic_Energy", "kinetic-energy", 0},
                {"enrgy", "energy", 1},  {"enegry", "energy", 1},
                {"ab", "ba", 1},         {"", "abc", 3},
                {"abc", "ca", 3}};
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        assert_int_equal(fw_spelling_distance(rows[n].one, rows[n].other), rows[n].distance);
        assert_int_equal(fw_spelling_distance(rows[n].other, rows[n].one), rows[n].distance);
    }
    assert_int_equal(fw_spelling_distance(lengthy, "a"), FW_NAME_BYTES);
    assert_int_equal(fw_spelling_distance("a", lengthy), FW_NAME_BYTES);
    assert_int_equal(fw_spelling_distance(lengthy + 1, "a"), FW_NAME_BYTES - 2);
}

static void numbers_are_read_exactly_or_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        fw_number_fault fault;
        double value;
    } rows[] = {{"0e5", FW_NUMBER_FINE, 0},
                {"-0.00E9", FW_NUMBER_FINE, 0},
                {"1e-400", FW_NUMBER_TOO_SMALL, 0},
                {"0.0E1x", FW_NUMBER_MALFORMED, 0},
                {"1e400", FW_NUMBER_TOO_LARGE, 0},
                {"+.5e1", FW_NUMBER_FINE, 5},
                {"-Infinity", FW_NUMBER_NOT_FINITE, 0}};
    char digits[200];
    double value;
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        value = 7;
        assert_int_equal(fw_number_read(rows[n].text, strlen(rows[n].text), &value), rows[n].fault);
        assert_close(value, rows[n].fault == FW_NUMBER_FINE ? rows[n].value : 7, 0);
    }
    memset(digits, '0', sizeof digits);
    digits[0] = '1';
    assert_int_equal(fw_number_read(digits, 127, &value), FW_NUMBER_FINE);
    assert_close(value, 1e126, 0);
    assert_int_equal(fw_number_read(digits, 128, &value), FW_NUMBER_MALFORMED);
}

/* A terminal's width, with a least one, and colours where they are wanted. */
static void terminals_are_asked(void **state)
{
    (void)state;
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) skip();
    FILE *terminal = fopen(ptsname(master), "w"), *file = tmpfile();
    assert_non_null(terminal);
    static const struct {
        unsigned short columns;
        int width;
    } widths[] = {{0, 80}, {7, 20}, {20, 20}, {133, 133}};
    for (size_t n = 0; n < sizeof widths / sizeof *widths; ++n) {
        const struct winsize size = {.ws_col = widths[n].columns};
        assert_int_equal(ioctl(master, TIOCSWINSZ, &size), 0);
        assert_int_equal(fw_terminal_width(terminal), widths[n].width);
    }
    assert_int_equal(fw_terminal_width(file), 80);
    static const struct {
        const char *without, *kind;
        bool colours;
    } kinds[] = {{NULL, "xterm", true},
                 {"", "xterm", true},
                 {"1", "xterm", false},
                 {NULL, "dumb", false},
                 {NULL, NULL, false}};
    for (size_t n = 0; n < sizeof kinds / sizeof *kinds; ++n) {
        unsetenv("NO_COLOR");
        unsetenv("TERM");
        if (kinds[n].without) setenv("NO_COLOR", kinds[n].without, 1);
        if (kinds[n].kind) setenv("TERM", kinds[n].kind, 1);
        assert_int_equal(fw_terminal_colours(terminal), kinds[n].colours);
        assert_false(fw_terminal_colours(file));
    }
    fclose(terminal);
    fclose(file);
    close(master);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(characters_are_those_of_the_table),
        cmocka_unit_test(text_that_is_none_is_found),
        cmocka_unit_test(quotes_are_cut_between_characters),
        cmocka_unit_test(lines_are_whole),
        cmocka_unit_test(markup_is_cut_into_runs),
        cmocka_unit_test(xml_holds_no_control_characters),
        cmocka_unit_test(spelling_counts_mistakes),
        cmocka_unit_test(numbers_are_read_exactly_or_refused),
        cmocka_unit_test(terminals_are_asked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
