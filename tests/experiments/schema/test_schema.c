/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_schema.c - the table that describes every key is whole, and so is the reference. */
#include "tests/support/laws.h"

#include "experiments/scenario/scenario.h"

#include <stdlib.h>
#include <string.h>

/* Calls for every key of every section. */
static void each_key(void (*look)(const fw_section *section, const fw_key *key))
{
    const fw_section *sections[FW_SECTIONS_MAX];
    const int count = fw_schema_sections(&fw_scenario_section, sections);
    assert_true(count > 40);
    for (int n = 0; n < count; ++n)
        for (const fw_key *key = fw_section_first(sections[n]); key;
             key = fw_section_next(sections[n], key))
            look(sections[n], key);
}

static void is_found_by_its_name(const fw_section *section, const fw_key *key)
{
    assert_ptr_equal(fw_section_find(section, key->name), key);
    assert_true(strlen(key->name) < FW_NAME_BYTES);
}

static void every_key_stands_once_in_its_section(void **state)
{
    (void)state;
    each_key(is_found_by_its_name);
}

static void says_what_it_is(const fw_section *section, const fw_key *key)
{
    unsigned all = key->forms | key->items;
    if (!key->meaning || !*key->meaning) fail_msg("%s has no meaning", key->name);
    if (!!(all & (FW_FORM_NUMBERS | FW_FORM_INTEGERS)) != !!key->layout)
        fail_msg("%s: layout", key->name);
    if (!!(all & FW_FORM_WORD) != !!key->words) fail_msg("%s: words", key->name);
    if (!!(all & (FW_FORM_MAPPING | FW_FORM_NAMED)) != !!key->subsection)
        fail_msg("%s: subsection", key->name);
    if (!!(key->forms & FW_FORM_LIST) != !!key->items) fail_msg("%s: items", key->name);
    if (key->needs) assert_non_null(fw_section_find(section, key->needs));
    /* A key is required, or one of several, or has a default that the reference can tell. */
    int ways = key->required + key->alternative + (key->default_value || key->default_meaning);
    if (ways != 1) fail_msg("%s.%s: %d defaults", section->noun, key->name, ways);
}

static void every_key_says_what_it_is(void **state)
{
    (void)state;
    each_key(says_what_it_is);
}

/* What is written is as large as what it is written into. */
static void has_a_place(const fw_section *section, const fw_key *key)
{
    int length = 1;
    if (key->place == 0) fail_msg("%s of %s has no place", key->name, section->noun);
    if (key->place == FW_NOT_STORED) return;
    for (const char *c = key->layout ? key->layout : ""; *c; ++c) length += *c == ',';
    if (key->forms == FW_FORM_NUMBERS && (size_t)length * sizeof(double) > key->size)
        fail_msg("%s of %s does not fit into its place", key->name, section->noun);
    if (key->forms == FW_FORM_INTEGERS && (size_t)length * sizeof(int) != key->size)
        fail_msg("%s of %s does not fit into its place", key->name, section->noun);
    if (key->forms == FW_FORM_WORD) assert_int_equal(key->size, sizeof(int));
}

static void every_key_has_a_place_or_says_that_it_is_not_stored(void **state)
{
    (void)state;
    each_key(has_a_place);
}

static int depth_of(const fw_section *section, int depth)
{
    int deepest = depth;
    if (depth > 20) return depth;
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key)) {
        if (!key->subsection) continue;
        int below = depth_of(key->subsection, depth + 1);
        if (below > deepest) deepest = below;
    }
    return deepest;
}

static void sections_do_not_contain_each_other(void **state)
{
    (void)state;
    assert_true(depth_of(&fw_scenario_section, 1) < 10);
}

static int defaults;

static void has_a_default_that_passes(const fw_section *section, const fw_key *key)
{
    if (!key->default_value || key->default_meaning) return;
    char text[400], sentence[80];
    snprintf(text, sizeof text, "%s: %s\n", key->name, key->default_value);
    fw_document *document;
    fw_error error;
    assert_int_equal(fw_document_parse(&document, "default", text, strlen(text), &error), FW_OK);
    fw_status status = fw_schema_check(document, section, &error);
    /* Others that are missing are complained about after all values. */
    snprintf(sentence, sizeof sentence, "%s is", key->name);
    if (status != FW_OK && strstr(error.sentence, sentence)) fail_msg("%s", error.sentence);
    fw_document_destroy(document);
    defaults += 1;
}

/* Each default goes the way of a written value: it must pass the same check. */
static void every_default_is_a_value_that_may_be_written(void **state)
{
    (void)state;
    each_key(has_a_default_that_passes);
    assert_true(defaults > 20);
}

static char *print_reference(void)
{
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    fw_error error;
    assert_int_equal(fw_schema_print(&fw_scenario_section, out, &error), FW_OK);
    fclose(out);
    return text;
}

static const char *reference;

static void is_in_the_reference(const fw_section *section, const fw_key *key)
{
    char row[100];
    (void)section;
    snprintf(row, sizeof row, "\n| `%s` | ", key->name);
    assert_non_null(strstr(reference, row));
}

static void the_reference_names_every_key_and_breaks_no_table(void **state)
{
    (void)state;
    char *text = print_reference();
    reference = text;
    each_key(is_in_the_reference);
    for (const char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        if (line[0] != '|') continue;
        int bars = 0;
        for (const char *c = line; *c; ++c) bars += *c == '|' && (c == line || c[-1] != '\\');
        if (bars != 6) fail_msg("%d bars in %s", bars, line);
    }
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_stands_once_in_its_section),
        cmocka_unit_test(every_key_says_what_it_is),
        cmocka_unit_test(every_key_has_a_place_or_says_that_it_is_not_stored),
        cmocka_unit_test(sections_do_not_contain_each_other),
        cmocka_unit_test(every_default_is_a_value_that_may_be_written),
        cmocka_unit_test(the_reference_names_every_key_and_breaks_no_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
