/* SPDX-License-Identifier: GPL-3.0-or-later */
/* test_text_short_memory.c - each piece of memory of a document, which come out of blocks, is once
 * the first of a block that is not there; and so with formulas. */
#include "tests/support/short_memory.h"

#include "experiments/storage/checksum.h"
#include "experiments/text/document.h"
#include "experiments/text/substitution.h"

#include <stdlib.h>

/* A document's first block, by document.c; its pieces end at multiples of the alignment. */
enum { BLOCK = 1 << 15, ALIGNMENT = 16 };

static const char scenario[] = "a: [1, two]\nb: {c: \"it's\"}\nd: |\n  two\n  lines\n";

static fw_status print(const fw_document *document, uint64_t *result, fw_error *error)
{
    /* Nothing of this is the document's. */
    char text[1024] = "";
    FILE *out = fmemopen(text, sizeof text, "w");
    assert_non_null(out);
    const fw_status status = fw_document_print(document, out, error);
    fclose(out);
    *result = fw_checksum_add(*result, text, strlen(text));
    return status;
}

/* Reads, changes, copies and prints; `input`: how much of the first block is left behind the name
 * of its file. */
static fw_status make_documents(const void *input, uint64_t *result, fw_error *error)
{
    static char name[BLOCK];
    fw_document *document, *clone = NULL;
    fw_node *value;
    const size_t room = *(const size_t *)input;
    memset(name, 'f', sizeof name);
    name[sizeof name - 1 - room] = '\0';
    *result = FW_CHECKSUM_OF_NOTHING;
    FW_TRY(fw_document_parse(&document, name, scenario, strlen(scenario), error));
    fw_status status = fw_document_parse_value(document, "e=2*x", "[2*x]", &value, error);
    if (status == FW_OK) {
        fw_node *root = fw_document_root(document);
        value->key = "e";
        value->first->formula = "2*x";
        fw_node_append(root, value);
        status = fw_document_clone(&clone, document, error);
    }
    if (status == FW_OK) status = print(document, result, error);
    if (status == FW_OK) status = print(clone, result, error);
    if (status == FW_OK) {
        /* The copy knows its options. */
        fw_error said;
        fw_document_fail(clone, (fw_place){0, 0, 1}, &said, "wrong");
        assert_string_equal(said.sentence, "--set e=2*x: wrong");
    }
    fw_document_destroy(clone);
    fw_document_destroy(document);
    return status;
}

static void every_piece_of_a_document_may_be_missing(void **state)
{
    (void)state;
    int refused = 0;
    /* What is said of a name so long is cut. */
    for (size_t room = 0; room < 2048; room += ALIGNMENT)
        refused += fail_each_allocation("document", make_documents, &room);
    assert_true(refused > 128);
}

static fw_status compute(const void *input, uint64_t *result, fw_error *error)
{
    static const fw_variable variables[] = {{"speed", 3}};
    char *out;
    double value = 0;
    *result = FW_CHECKSUM_OF_NOTHING;
    FW_TRY(fw_formula_evaluate(input, strlen(input), variables, 1, &value, error));
    *result = fw_checksum_add(*result, &value, sizeof value);
    FW_TRY(fw_substitution_write("a.b=[1, 2*speed]", variables, 1, &out, NULL, error));
    *result = fw_checksum_add(*result, out, strlen(out));
    free(out);
    return FW_OK;
}

static void formulas_say_that_memory_is_missing(void **state)
{
    (void)state;
    assert_int_equal(fail_each_allocation("formula", compute, "2*speed"), 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_piece_of_a_document_may_be_missing),
        cmocka_unit_test(formulas_say_that_memory_is_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
