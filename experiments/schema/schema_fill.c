/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema_fill.c - from checked nodes to plain data, defaults included, at the places that the
 * keys give. Keeps no state. Start reading at fw_schema_fill(). */
#include "core/vec2.h"
#include "experiments/schema/schema.h"
#include "experiments/text/number.h"

#include <assert.h>
#include <limits.h>
#include <string.h>

static const double degree = FW_PI / 180;

double fw_node_number(const fw_node *node)
{
    double value = 0;
    fw_number_fault fault = fw_number_read(node->text, node->length, &value);
    assert(fault == FW_NUMBER_FINE);
    (void)fault;
    return value;
}

int64_t fw_node_integer(const fw_node *node)
{
    int64_t value = 0;
    fw_number_fault fault = fw_integer_read(node->text, node->length, &value);
    assert(fault == FW_NUMBER_FINE);
    (void)fault;
    return value;
}

int fw_node_word(const fw_node *node, const fw_word *words)
{
    for (const fw_word *word = words; word->name; ++word)
        if (!strcmp(word->name, node->text)) return word->value;
    assert(false && "a word that passed the check");
    return 0;
}

void fw_node_numbers(const fw_node *list, double *values)
{
    for (const fw_node *child = list->first; child; child = child->next)
        *values++ = fw_node_number(child);
}

static void fill_integers(const fw_node *list, int *values)
{
    for (const fw_node *child = list->first; child; child = child->next)
        *values++ = (int)fw_node_integer(child);
}

static fw_sym2 read_symmetric(const fw_node *node)
{
    if (node->kind == FW_SCALAR) return fw_sym2_scalar(fw_node_number(node));
    double value[4];
    if (node->count == 3) {
        fw_node_numbers(node, value);
        return (fw_sym2){value[0], value[1], value[2]};
    }
    fw_node_numbers(node->first, value);
    fw_node_numbers(node->last, value + 2);
    return (fw_sym2){value[0], value[1], value[3]};
}

static fw_status fill_names(fw_document *document, const fw_node *list, fw_schema_names *names,
                            fw_error *error)
{
    names->item = fw_document_allocate(document, (size_t)list->count, sizeof *names->item);
    if (!names->item) return fw_document_fail_memory(document, error);
    for (const fw_node *child = list->first; child; child = child->next)
        names->item[names->count++] = (fw_schema_name){child->text, child->place};
    return FW_OK;
}

static fw_status fill_value(fw_document *document, const fw_key *key, const fw_node *node,
                            void *member, fw_error *error)
{
    switch (key->forms) {
    case FW_FORM_TEXT:
        *(const char **)member = node->text;
        return FW_OK;
    case FW_FORM_NAME:
        *(fw_schema_name *)member = (fw_schema_name){node->text, node->place};
        return FW_OK;
    case FW_FORM_FLAG:
        *(bool *)member = node->text[0] == 't';
        return FW_OK;
    case FW_FORM_NUMBER:
        *(double *)member = fw_node_number(node);
        return FW_OK;
    case FW_FORM_ANGLE:
        *(double *)member = fw_node_number(node) * degree;
        return FW_OK;
    case FW_FORM_INTEGER:
        *(int64_t *)member = fw_node_integer(node);
        return FW_OK;
    case FW_FORM_NUMBERS:
        fw_node_numbers(node, member);
        return FW_OK;
    case FW_FORM_INTEGERS:
        fill_integers(node, member);
        return FW_OK;
    case FW_FORM_SYMMETRIC:
        *(fw_sym2 *)member = read_symmetric(node);
        return FW_OK;
    case FW_FORM_LIST:
        return fill_names(document, node, member, error);
    case FW_FORM_WORD: {
        int number = fw_node_word(node, key->words);
        memcpy(member, &number, sizeof number); /* of some enum, whose name is not known here */
        return FW_OK;
    }
    default:
        return fw_fail_impossible(error, "a key of a form that cannot be stored");
    }
}

/* The default is written as it would be in a file: as a node it goes the same way. */
static fw_status fill_default(fw_document *document, const fw_key *key, void *member,
                              fw_error *error)
{
    enum { PARTS = 4 };
    fw_node node = {
        .kind = FW_SCALAR, .text = key->default_value, .length = strlen(key->default_value)};
    fw_node part[PARTS];
    if (key->forms & (FW_FORM_NUMBERS | FW_FORM_INTEGERS)) {
        node = (fw_node){.kind = FW_LIST};
        const char *text = key->default_value + 1;
        while (*text) {
            size_t length = strcspn(text, ",]");
            assert(node.count < PARTS);
            part[node.count] = (fw_node){.kind = FW_SCALAR, .text = text, .length = length};
            fw_node_append(&node, &part[node.count]);
            text += length + strspn(text + length, ", ]");
        }
    }
    return fill_value(document, key, &node, member, error);
}

fw_status fw_schema_fill(fw_document *document, const fw_section *section, const fw_node *mapping,
                         void *object, fw_error *error)
{
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key)) {
        assert(key->place > 0 && "a key says where it is stored, or that it is not");
        if (key->place == FW_NOT_STORED) continue;
        const fw_node *node = mapping ? fw_node_find(mapping, key->name) : NULL;
        void *member = (char *)object + key->place - 1;
        if (key->forms == FW_FORM_MAPPING) {
            /* Of alternatives only the one that was chosen has a place to go. */
            if (node || !key->alternative)
                FW_TRY(fw_schema_fill(document, key->subsection, node, member, error));
        } else if (node) {
            FW_TRY(fill_value(document, key, node, member, error));
        } else if (key->default_value) {
            FW_TRY(fill_default(document, key, member, error));
        }
    }
    return FW_OK;
}
