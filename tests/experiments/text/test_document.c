/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_document.c - texts become trees that know their lines, or a sentence; numbers are read
 * exactly or not at all. */
#include "tests/support/laws.h"

#include "experiments/text/document.h"
#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

static fw_document *parse(const char *text)
{
    fw_document *document;
    fw_error error;
    fw_status status = fw_document_parse(&document, "a.yaml", text, strlen(text), &error);
    if (status != FW_OK) fail_msg("%s", error.sentence);
    return document;
}

static void every_node_knows_where_it_was_written(void **state)
{
    (void)state;
    fw_document *document = parse("# a comment\ntitle: \"A: b\"\nbox:\n  - [1, 2]\n  - {x: y}\n");
    fw_node *root = fw_document_root(document);
    assert_int_equal(root->kind, FW_MAPPING);
    assert_int_equal(root->count, 2);
    fw_node *title = fw_node_find(root, "title"), *box = fw_node_find(root, "box");
    assert_null(fw_node_find(root, "Title"));
    assert_string_equal(title->text, "A: b");
    assert_true(title->quoted);
    assert_int_equal(title->key_place.line, 2);
    assert_int_equal(title->key_place.column, 1);
    assert_int_equal(title->place.column, 8);
    assert_int_equal(box->count, 2);
    fw_node *two = box->first->last;
    assert_string_equal(two->text, "2");
    assert_false(two->quoted);
    assert_int_equal(two->place.line, 4);
    assert_int_equal(two->place.column, 9);
    assert_string_equal(box->last->first->key, "x");
    fw_document_destroy(document);
    fw_document_destroy(NULL);
}

static void assert_same_tree(const fw_node *a, const fw_node *b)
{
    assert_int_equal(a->kind, b->kind);
    assert_int_equal(a->count, b->count);
    if (a->key) assert_string_equal(a->key, b->key);
    if (a->kind == FW_SCALAR) {
        assert_int_equal(a->length, b->length);
        assert_memory_equal(a->text, b->text, a->length);
        if (a->quoted) assert_true(b->quoted);
    }
    for (a = a->first, b = b->first; a; a = a->next, b = b->next) assert_same_tree(a, b);
}

static void what_is_printed_reads_back(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "a: 1",
        "a: [1, -2.5e-3, .5, 1., +3]\nb: {c: d, e: {f: [[1, 2], [3, 4]]}}",
        "a: \"1\"\nb: 'it''s'\nc: \"quote \\\" and \\\\ and \\t tab\"",
        "a: |\n  #..#\n  .##.\nb: |-\n  no end\n  here\nc: |+\n  two ends\n\n\nd: |2\n   first\n  "
        "x\n",
        "a: text with, comma\nb: a [1] {2} # not this\n",
        "- - 1\n  - 2\n- a: 1\n  b: 2\n- []\n- {}\n- ''",
        "\"odd key\": 1\n\"a:b\": 2\n\"#\": 3\n'- x': 4\n---x: 5",
        "é: \xE2\x82\xAC \xF0\x9F\x98\x80\nc: ~\nd:\ne: \"\\r\\n x \"",
        "long: [aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa, bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb, "
        "cccccccccccccccccccccccccccccccccc, {d: eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee}]",
        "plain words over\n",
        "' a': 1\n'a ': 2\n'a  b': 3\n'a b': 4\n' ': 5",
        "a: \"\\n begins\"\nb: \"one\\ttab\\nx\"\nc: \"one\\r\\nx\"\nd: \"\\n\"\ne: \" x\\ny\"",
        "a: |\n  one\n\n\n  two\n\n  three",
        "b: 2020-01-01\nc: '...'\nd: \"---\"\ne: a  b\nf: ' a'\ng: 'a '",
    };
    for (size_t n = 0; n < sizeof texts / sizeof texts[0]; ++n) {
        fw_document *before = parse(texts[n]);
        char *text = NULL;
        size_t length;
        FILE *out = open_memstream(&text, &length);
        fw_error error;
        assert_int_equal(fw_document_print(before, out, &error), FW_OK);
        fclose(out);
        fw_document *after = parse(text);
        assert_same_tree(fw_document_root(before), fw_document_root(after));
        free(text);
        fw_document_destroy(after);
        fw_document_destroy(before);
    }
}

/* As they are written: plain words without quotes, lines as lines. */
static void texts_are_printed_as_they_are_read_best(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        {"{a b: 1, 'a  b': ' x', 'a ': x y}", "a b: 1\n\"a  b\": \" x\"\n\"a \": x y\n"},
        {"a: \"one\\n\\ntwo\\n\"", "a: |\n  one\n\n  two\n"},
        {"a: \"one\\ntwo\\n\\n\"", "a: \"one\\ntwo\\n\\n\"\n"},
        {"a: \"\\none\"", "a: \"\\none\"\n"},
        {"a: \"one\\t\\ntwo\"", "a: \"one\\t\\ntwo\"\n"},
        {"[---, ..., -a]", "- \"---\"\n- \"...\"\n- -a\n"},
    };
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char text[256] = "";
        fw_error error;
        fw_document *document = parse(rows[n][0]);
        FILE *out = fmemopen(text, sizeof text, "w");
        assert_int_equal(fw_document_print(document, out, &error), FW_OK);
        fclose(out);
        assert_string_equal(text, rows[n][1]);
        fw_document_destroy(document);
    }
}

static void what_cannot_be_written_is_told(void **state)
{
    (void)state;
    fw_error error;
    fw_document *document = parse("a: 1");
    FILE *out = fopen("/dev/full", "w");
    assert_non_null(out);
    setvbuf(out, NULL, _IONBF, 0);
    assert_int_equal(fw_document_print(document, out, &error), FW_SYSTEM_FAILED);
    assert_string_equal(error.sentence, "a.yaml cannot be written out: No space left on device");
    fclose(out);
    fw_document_destroy(document);
}

/* Large pieces lie apart, and what comes behind them goes on beside what came before. */
static void memory_of_a_document_holds_what_is_put_there(void **state)
{
    (void)state;
    fw_document *document = parse("- a\n");
    assert_null(fw_node_find(fw_document_root(document), "a"));
    assert_null(fw_document_allocate(document, SIZE_MAX / 4, 8));
    char *before = fw_document_allocate(document, 8, 1);
    char *large = fw_document_allocate(document, 1 << 14, 2), *empty;
    char *behind = fw_document_allocate(document, 8, 1);
    assert_true(before && large && behind);
    for (size_t n = 0; n < 1 << 15; ++n) assert_int_equal(large[n], 0);
    memset(large, 'x', 1 << 15);
    for (int n = 0; n < 8; ++n) assert_int_equal(before[n] | behind[n], 0);
    assert_true(behind > before && behind - before <= 64);
    empty = fw_document_allocate(document, 0, 0);
    assert_non_null(empty);
    fw_document_destroy(document);
}

static const struct {
    const char *text, *sentence; /* after "a.yaml:" */
} broken[] = {
    {"", "1:1: nothing is written there, expected a scenario"},
    {"# only a comment\n", "1:1: nothing is written there, expected a scenario"},
    {"a: 1\na: 2\n", "2:1: 'a' is given a second time, after line 1"},
    {"x: {b: 1, c: 2, b: 3}\n", "1:17: 'b' is given a second time, after line 1"},
    {"a: &name [1]\nb: *name\n",
     "1:4: an anchor '&name'; a scenario is written out in full, without anchors and aliases"},
    {"a: *name\n",
     "1:4: an alias '*name'; a scenario is written out in full, without anchors and aliases"},
    {"a: &a [*a, *a]\n",
     "1:4: an anchor '&a'; a scenario is written out in full, without anchors and aliases"},
    {"a: !!int 3\n", "1:4: a tag 'tag:yaml.org,2002:int'; a scenario has no tags"},
    {"a: 1\n---\nb: 2\n", "2:1: a second document begins, expected one scenario in a file"},
    {"? [1, 2]\n: 3\n", "1:3: a list as a key, expected a word"},
    {"? {a: 2}\n: 3\n", "1:3: a mapping as a key, expected a word"},
    {"a: [1, 2\nb: 3\n", "2:2: a ',' or the closing ']' is missing (in the list [...] that begins "
                         "in line 1)"},
    {"a: {b: 1, c: 2\n", "2:1: a ',' or the closing '}' is missing (in the mapping {...} that "
                         "begins in line 1)"},
    {"a: \"open\nb: 1\n", "3:1: the file ends before the closing quote (in the quoted text that "
                          "begins in line 1)"},
    {"a: 1\n  b: 2\n", "2:4: a ':' cannot stand here; a text with ': ' in it needs quotes, and "
                       "lines of one mapping begin in one column: look at the line before too"},
    {"a: 1\nb\nc: 2\n", "3:1: a ':' with a blank behind it is missing after the key (in the key "
                        "that begins in line 2)"},
    {"a: one: two\n", "1:7: a ':' cannot stand here; a text with ': ' in it needs quotes, and "
                      "lines of one mapping begin in one column: look at the line before too"},
    {"a: 1\n\tb: 2\n",
     "2:1: a tab where blanks are needed to indent (in the text that begins in line 1)"},
    {"a: @b\n", "1:4: a value cannot begin with this character; use blanks, not tabs, to indent"},
    {"a:\n  - 1\n b: 2\n", "3:2: a key was expected here; is the line indented like the others? "
                           "(in the indented mapping that begins in line 1)"},
    {"a: \"\\0\"\n", "1:4: the text holds a control character (hexadecimal 00), expected none"},
    {"\"a\\0b\": 1\n", "1:1: the text holds a control character (hexadecimal 00), expected none"},
    {"a: \x01\n", "1:4: a control character (hexadecimal 01), expected plain text in UTF-8"},
    {"a: \xFF\xFE\n", "1:4: a byte that is not UTF-8 text (hexadecimal FF), expected plain text in "
                      "UTF-8"},
    {"\n\xC3\xA9: \xC0\x80\n", "2:4: a byte that is not UTF-8 text (hexadecimal C0), expected "
                               "plain text in UTF-8"},
    {"a: \xED\xA0\x80\n", "1:4: a byte that is not UTF-8 text (hexadecimal ED), expected plain "
                          "text in UTF-8"},
    {"a: \xE2\x82", "1:4: a byte that is not UTF-8 text (hexadecimal E2), expected plain text in "
                    "UTF-8"},
    {"\x89HDF\r\n\x1A\n", "1:1: a byte that is not UTF-8 text (hexadecimal 89), expected plain "
                          "text in UTF-8"},
    {"'': 1\n", "1:1: the key '' is 0 characters long, expected 1 to 63"},
    {"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa: 1\n",
     "1:1: the key 'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...' is 70 "
     "characters long, expected 1 to 63"},
    {"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[", "1:25: lists and mappings within each other more than 24 "
                                      "deep"},
};

static void what_is_not_a_tree_gets_a_sentence(void **state)
{
    (void)state;
    int wrong = 0;
    for (size_t n = 0; n < sizeof broken / sizeof broken[0]; ++n) {
        char expected[FW_SENTENCE_SIZE];
        snprintf(expected, sizeof expected, "a.yaml:%s", broken[n].sentence);
        fw_document *document;
        fw_error error = {FW_OK, "accepted"};
        fw_status status =
            fw_document_parse(&document, "a.yaml", broken[n].text, strlen(broken[n].text), &error);
        if (status != FW_BAD_INPUT || strcmp(error.sentence, expected) != 0) {
            print_error("  found    %s\n  expected %s\n", error.sentence, expected);
            wrong += 1;
        }
        fw_document_destroy(document);
    }
    assert_int_equal(wrong, 0);
}

static void line_ends_and_byte_order_mark_do_not_matter(void **state)
{
    (void)state;
    fw_document *document = parse("\xEF\xBB\xBF"
                                  "a: 1\r\nb:\r\n  c: 2\r\n");
    fw_node *b = fw_node_find(fw_document_root(document), "b");
    assert_string_equal(b->first->text, "2");
    assert_int_equal(b->first->place.line, 3);
    fw_document_destroy(document);
}

static void counts_are_limited(void **state)
{
    (void)state;
    size_t length = 4 * (size_t)FW_DOCUMENT_NODES;
    char *text = malloc(length);
    assert_non_null(text);
    for (size_t n = 0; n < length; n += 2) memcpy(text + n, n ? "1," : "[1", 2);
    fw_document *document;
    fw_error error;
    assert_int_equal(fw_document_parse(&document, "a.yaml", text, length, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, ": more than 1048576 values, expected fewer"));
    free(text);
    length = (size_t)FW_DOCUMENT_BYTES + 1;
    text = malloc(length);
    assert_non_null(text);
    memset(text, ' ', length);
    assert_int_equal(fw_document_parse(&document, "a.yaml", text, length, &error), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "a.yaml:1:1: 16777217 bytes, expected at most 16777216");
    free(text);
}

/* Whoever wants no sentence gets the status. */
static void a_sentence_need_not_be_wanted(void **state)
{
    (void)state;
    fw_document *document = parse("a: 1");
    assert_int_equal(fw_document_fail(document, (fw_place){1, 1, 0}, NULL, "wrong"), FW_BAD_INPUT);
    fw_document_destroy(document);
}

static void files_that_cannot_be_read_are_bad_input(void **state)
{
    (void)state;
    fw_document *document;
    fw_error error;
    assert_int_equal(fw_document_load(&document, "/nowhere/a.yaml", &error), FW_BAD_INPUT);
    assert_string_equal(error.sentence,
                        "/nowhere/a.yaml: cannot be opened: No such file or directory");
    assert_int_equal(fw_document_load(&document, "/", &error), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "/: cannot be read: Is a directory");
    assert_int_equal(fw_document_load(&document, "/dev/null/a.yaml", &error), FW_BAD_INPUT);
    assert_string_equal(error.sentence, "/dev/null/a.yaml: cannot be opened: Not a directory");
    char name[300] = "/";
    memset(name + 1, 'n', 298);
    assert_int_equal(fw_document_load(&document, name, &error), FW_BAD_INPUT);
    assert_non_null(strstr(error.sentence, "cannot be opened: File name too long"));
    assert_int_equal(fw_document_load(&document, "/dev/zero", &error), FW_BAD_INPUT);
    assert_string_equal(error.sentence,
                        "/dev/zero: longer than 16777216 bytes, expected a scenario");
}

static void numbers_are_exact_or_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        fw_number_fault fault;
        double value;
    } cases[] = {
        {"0.1", FW_NUMBER_FINE, 0.1},
        {".5", FW_NUMBER_FINE, 0.5},
        {"5.", FW_NUMBER_FINE, 5},
        {"-2.5e-3", FW_NUMBER_FINE, -0.0025},
        {"+7E2", FW_NUMBER_FINE, 700},
        {"5e-324", FW_NUMBER_FINE, 5e-324},
        {"0e-999", FW_NUMBER_FINE, 0},
        {"9007199254740993", FW_NUMBER_FINE, 9007199254740992},
        {"1.7976931348623157e308", FW_NUMBER_FINE, 1.7976931348623157e308},
        {"1.8e308", FW_NUMBER_TOO_LARGE, 0},
        {"1e-400", FW_NUMBER_TOO_SMALL, 0},
        {"nan", FW_NUMBER_NOT_FINITE, 0},
        {"-.INF", FW_NUMBER_NOT_FINITE, 0},
        {"Infinity", FW_NUMBER_NOT_FINITE, 0},
        {"", FW_NUMBER_MALFORMED, 0},
        {".", FW_NUMBER_MALFORMED, 0},
        {"-", FW_NUMBER_MALFORMED, 0},
        {"e5", FW_NUMBER_MALFORMED, 0},
        {"2.5e", FW_NUMBER_MALFORMED, 0},
        {"2.5e+", FW_NUMBER_MALFORMED, 0},
        {"1.0x", FW_NUMBER_MALFORMED, 0},
        {"1 ", FW_NUMBER_MALFORMED, 0},
        {" 1", FW_NUMBER_MALFORMED, 0},
        {"0x10", FW_NUMBER_MALFORMED, 0},
        {"1e5.5", FW_NUMBER_MALFORMED, 0},
        {"--1", FW_NUMBER_MALFORMED, 0},
        {"1,5", FW_NUMBER_MALFORMED, 0},
        {"1/3", FW_NUMBER_MALFORMED, 0},
    };
    for (size_t n = 0; n < sizeof cases / sizeof cases[0]; ++n) {
        double value = 0;
        fw_number_fault fault = fw_number_read(cases[n].text, strlen(cases[n].text), &value);
        if (fault != cases[n].fault || value != cases[n].value)
            fail_msg("'%s' gives fault %d and %.17g", cases[n].text, (int)fault, value);
    }
}

static void whole_numbers_are_written_out(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        fw_number_fault fault;
        int64_t value;
    } cases[] = {
        {"0", FW_NUMBER_FINE, 0},
        {"-7", FW_NUMBER_FINE, -7},
        {"+12", FW_NUMBER_FINE, 12},
        {"9223372036854775807", FW_NUMBER_FINE, INT64_MAX},
        {"-9223372036854775808", FW_NUMBER_FINE, INT64_MIN},
        {"9223372036854775808", FW_NUMBER_TOO_LARGE, 0},
        {"-9223372036854775809", FW_NUMBER_TOO_LARGE, 0},
        {"1e6", FW_NUMBER_NOT_WHOLE, 0},
        {"2.0", FW_NUMBER_NOT_WHOLE, 0},
        {"007", FW_NUMBER_NOT_WHOLE, 0},
        {"", FW_NUMBER_MALFORMED, 0},
        {"1_000", FW_NUMBER_MALFORMED, 0},
        {"0b1", FW_NUMBER_MALFORMED, 0},
        {"nan", FW_NUMBER_NOT_FINITE, 0},
    };
    for (size_t n = 0; n < sizeof cases / sizeof cases[0]; ++n) {
        int64_t value = 0;
        fw_number_fault fault = fw_integer_read(cases[n].text, strlen(cases[n].text), &value);
        if (fault != cases[n].fault || value != cases[n].value)
            fail_msg("'%s' gives fault %d and %lld", cases[n].text, (int)fault, (long long)value);
    }
}

static void numbers_are_written_as_short_as_they_read_back(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } rows[] = {{0, "0"},           {-0.0, "0"},
                {1e15, "1e+15"},    {1e14, "100000000000000"},
                {0.1, "0.1"},       {1. / 3, "0.3333333333333333"},
                {5e-324, "5e-324"}, {0.1 + 0.2, "0.30000000000000004"},
                {INFINITY, "inf"},  {NAN, "nan"}};
    for (size_t n = 0; n < sizeof rows / sizeof *rows; ++n) {
        char text[FW_NUMBER_TEXT];
        fw_number_write(text, rows[n].value);
        assert_string_equal(text, rows[n].text);
    }
}

static void the_locale_changes_no_number(void **state)
{
    (void)state;
    static const char *const with_comma[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", NULL};
    const char *const *name = with_comma;
    while (*name && !setlocale(LC_ALL, *name)) ++name;
    if (!*name) skip(); /* this machine has no locale that writes 0,5 */
    double value = 0;
    assert_int_equal(fw_number_read("0.5", 3, &value), FW_NUMBER_FINE);
    assert_close(value, 0.5, 0);
    assert_int_equal(fw_number_read("0,5", 3, &value), FW_NUMBER_MALFORMED);
    setlocale(LC_ALL, "C");
}

static void the_word_that_was_meant_is_found(void **state)
{
    (void)state;
    assert_int_equal(fw_spelling_distance("velocity", "velocity"), 0);
    assert_int_equal(fw_spelling_distance("velocty", "velocity"), 1);
    assert_int_equal(fw_spelling_distance("vleocity", "velocity"), 1); /* neighbours swapped */
    assert_int_equal(fw_spelling_distance("Rest_Mass", "rest-mass"), 0);
    assert_int_equal(fw_spelling_distance("", "abc"), 3);
    fw_suggestion suggestion = fw_suggestion_begin("dampng");
    fw_suggestion_offer(&suggestion, "rest-mass");
    assert_null(suggestion.best);
    fw_suggestion_offer(&suggestion, "dampen");
    fw_suggestion_offer(&suggestion, "damping");
    assert_string_equal(suggestion.best, "damping");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_node_knows_where_it_was_written),
        cmocka_unit_test(what_is_printed_reads_back),
        cmocka_unit_test(texts_are_printed_as_they_are_read_best),
        cmocka_unit_test(what_cannot_be_written_is_told),
        cmocka_unit_test(memory_of_a_document_holds_what_is_put_there),
        cmocka_unit_test(what_is_not_a_tree_gets_a_sentence),
        cmocka_unit_test(line_ends_and_byte_order_mark_do_not_matter),
        cmocka_unit_test(counts_are_limited),
        cmocka_unit_test(a_sentence_need_not_be_wanted),
        cmocka_unit_test(files_that_cannot_be_read_are_bad_input),
        cmocka_unit_test(numbers_are_exact_or_refused),
        cmocka_unit_test(whole_numbers_are_written_out),
        cmocka_unit_test(numbers_are_written_as_short_as_they_read_back),
        cmocka_unit_test(the_locale_changes_no_number),
        cmocka_unit_test(the_word_that_was_meant_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
