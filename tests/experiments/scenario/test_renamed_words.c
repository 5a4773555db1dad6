/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_renamed_words.c - who writes a key or a quantity under its old name is told the new one. */
#include "tests/support/laws.h"

#include "experiments/measures/quantity.h"
#include "experiments/scenario/scenario.h"
#include "tests/support/program.h"

static int check_old_name(const fw_document *document, const fw_section *section, const fw_key *key)
{
    char sentence[200];
    if (!key->old_name) return 0;
    assert_null(fw_section_find(section, key->old_name));
    assert_int_equal(fw_schema_check_key(document, section, "here", key->old_name,
                                         (fw_place){.line = 1, .column = 1}, &error),
                     FW_BAD_INPUT);
    snprintf(sentence, sizeof sentence, "unknown key '%s' in here; it is now called '%s'",
             key->old_name, key->name);
    if (!strstr(error.sentence, sentence)) fail_msg("%s", error.sentence);
    return 1;
}

static void the_refusal_of_an_old_key_names_the_new_one(void **state)
{
    (void)state;
    static const char text[] = "title: t\n";
    const fw_section *sections[FW_SECTIONS_MAX];
    fw_document *document;
    int renamed = 0;
    assert_int_equal(fw_document_parse(&document, "t.yaml", text, sizeof text - 1, &error), FW_OK);
    const int count = fw_schema_sections(&fw_scenario_section, sections);
    for (int n = 0; n < count; ++n)
        for (const fw_key *key = fw_section_first(sections[n]); key;
             key = fw_section_next(sections[n], key))
            renamed += check_old_name(document, sections[n], key);
    assert_true(renamed >= 2);
    fw_document_destroy(document);
}

static void the_refusal_of_an_old_quantity_names_the_new_one(void **state)
{
    (void)state;
    char folder[64];
    int count = 0;
    make_quick_folder(folder, sizeof folder);
    for (const fw_renamed_quantity *q = fw_renamed_quantities; q->name; ++q, ++count) {
        char line[200], sentence[200];
        assert_null(fw_quantity_find(q->old_name));
        assert_non_null(fw_quantity_find(q->name));
        snprintf(line, sizeof line, "run bounce --set expect.0.quantity=%s", q->old_name);
        snprintf(sentence, sizeof sentence, "quantity %s is not known; it is now called %s\n",
                 q->old_name, q->name);
        const outcome seen = run_program(folder, line);
        expect_end(&seen, 2, sentence);
    }
    assert_true(count > 0);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_refusal_of_an_old_key_names_the_new_one),
        cmocka_unit_test(the_refusal_of_an_old_quantity_names_the_new_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
