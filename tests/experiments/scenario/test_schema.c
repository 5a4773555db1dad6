/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_schema.c - the table that describes every key is whole, and so is the reference. */
#include "tests/support/laws.h"

#include "experiments/scenario/schema.h"

#include <stdlib.h>
#include <string.h>

static bool has_section(const char *name)
{
    for (const fw_section *s = fw_schema_sections; s->name; ++s)
        if (!strcmp(s->name, name)) return true;
    return false;
}

static void every_key_stands_once_in_a_section_that_exists(void **state)
{
    (void)state;
    for (const fw_key *key = fw_schema_keys; key->section; ++key) {
        assert_true(has_section(key->section));
        assert_ptr_equal(fw_schema_find(key->section, key->name), key);
        assert_true(strlen(key->name) < FW_NAME_BYTES);
    }
}

static void every_key_says_what_it_is(void **state)
{
    (void)state;
    for (const fw_key *key = fw_schema_keys; key->section; ++key) {
        unsigned all = key->forms | key->items;
        if (!key->meaning || !*key->meaning) fail_msg("%s has no meaning", key->name);
        if (!!(all & (FW_FORM_NUMBERS | FW_FORM_INTEGERS)) != !!key->layout)
            fail_msg("%s: layout", key->name);
        if (!!(all & FW_FORM_WORD) != !!key->words) fail_msg("%s: words", key->name);
        if (!!(all & (FW_FORM_MAPPING | FW_FORM_NAMED)) != !!key->subsection)
            fail_msg("%s: subsection", key->name);
        if (!!(key->forms & FW_FORM_LIST) != !!key->items) fail_msg("%s: items", key->name);
        if (key->subsection) assert_true(has_section(key->subsection));
        if (key->needs) assert_non_null(fw_schema_find(key->section, key->needs));
        /* A key is required, or one of several, or has a default that the reference can tell. */
        int ways = key->required + key->alternative + (key->default_value || key->default_meaning);
        if (ways != 1) fail_msg("%s.%s: %d defaults", key->section, key->name, ways);
    }
}

static int depth_of(const char *section, int depth)
{
    int deepest = depth;
    if (depth > 20) return depth;
    for (const fw_key *key = fw_schema_keys; key->section; ++key) {
        if (strcmp(key->section, section) || !key->subsection) continue;
        int below = depth_of(key->subsection, depth + 1);
        if (below > deepest) deepest = below;
    }
    return deepest;
}

static void sections_do_not_contain_each_other(void **state)
{
    (void)state;
    assert_true(depth_of("scenario", 1) < 10);
}

/* Each default goes the way of a written value: it must pass the same check. */
static void every_default_is_a_value_that_may_be_written(void **state)
{
    (void)state;
    int count = 0;
    for (const fw_key *key = fw_schema_keys; key->section; ++key) {
        if (!key->default_value || key->default_meaning) continue;
        char text[400], sentence[80];
        snprintf(text, sizeof text, "%s: %s\n", key->name, key->default_value);
        fw_document *document;
        fw_error error;
        assert_int_equal(fw_document_parse(&document, "default", text, strlen(text), &error),
                         FW_OK);
        fw_status status = fw_schema_check(document, key->section, &error);
        /* Others that are missing are complained about after all values. */
        snprintf(sentence, sizeof sentence, "%s is", key->name);
        if (status != FW_OK && strstr(error.sentence, sentence)) fail_msg("%s", error.sentence);
        fw_document_destroy(document);
        count += 1;
    }
    assert_true(count > 20);
}

static char *print_reference(void)
{
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    fw_error error;
    assert_int_equal(fw_schema_print(out, &error), FW_OK);
    fclose(out);
    return text;
}

static void the_reference_names_every_key_and_breaks_no_table(void **state)
{
    (void)state;
    char *text = print_reference();
    for (const fw_key *key = fw_schema_keys; key->section; ++key) {
        char row[100];
        snprintf(row, sizeof row, "\n| `%s` | ", key->name);
        assert_non_null(strstr(text, row));
    }
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
        cmocka_unit_test(every_key_stands_once_in_a_section_that_exists),
        cmocka_unit_test(every_key_says_what_it_is),
        cmocka_unit_test(sections_do_not_contain_each_other),
        cmocka_unit_test(every_default_is_a_value_that_may_be_written),
        cmocka_unit_test(the_reference_names_every_key_and_breaks_no_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
