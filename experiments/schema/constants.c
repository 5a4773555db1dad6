/* SPDX-License-Identifier: GPL-3.0-or-later */
/* constants.c - formulas of named numbers in a document.
 * State: the values, in the document. Invariant: a node whose formula was resolved has its value
 * as text, as a number is written. Start reading at fw_constants_resolve(). */
#include "experiments/schema/constants.h"

#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <string.h>

/* --- what is a formula --- */

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_number(const char *text)
{
    double value;
    return fw_number_read(text, strlen(text), &value) != FW_NUMBER_MALFORMED;
}

/* A name by itself, perhaps with a sign: of a constant, or of what may be meant as one. */
static bool is_name(const char *text, const fw_constants *constants)
{
    const char *name = text + (*text == '-' || *text == '+'), *c = name;
    if (!is_letter(*c)) return false;
    while (is_letter(*c) || is_digit(*c)) ++c;
    return !*c && (constants->count > 0 || strcmp(name, "pi") == 0);
}

/* Has it an operator, between or behind something? "2.5e-" and "-x" have none. */
static bool has_operator(const char *text)
{
    bool operand = false;
    for (const char *c = text; *c; ++c) {
        if (strchr("*/^()<>", *c)) return true;
        const bool exponent =
            c > text + 1 && (c[-1] == 'e' || c[-1] == 'E') && (is_digit(c[-2]) || c[-2] == '.');
        if (strchr("+-", *c) && operand && !exponent) return true;
        operand = operand || is_letter(*c) || is_digit(*c);
    }
    return false;
}

static bool is_formula(const fw_node *node, const fw_constants *constants)
{
    if (node->kind != FW_SCALAR || node->length == 0 || strlen(node->text) != node->length)
        return false;
    if (is_number(node->text)) return false;
    return has_operator(node->text) || is_name(node->text, constants);
}

/* --- values --- */

static fw_status take_value(fw_document *document, fw_node *node, double value, fw_error *error)
{
    char text[FW_NUMBER_TEXT];
    fw_number_write(text, value);
    if (!node->formula) node->formula = node->text;
    node->length = strlen(text);
    node->text = fw_document_copy(document, text, node->length);
    return node->text ? FW_OK : fw_document_fail_memory(document, error);
}

/* `count` of the constants are known. */
static fw_status evaluate(const fw_constants *constants, fw_document *document, fw_node *node,
                          const char *path, fw_error *error)
{
    double value;
    const char *text = fw_node_written(node);
    fw_error reason = {0};
    const fw_status status = fw_formula_evaluate(text, strlen(text), constants->items,
                                                 constants->count, &value, &reason);
    if (status == FW_BAD_INPUT)
        return fw_document_fail(document, node->place, error, "%s: %s", path, reason.sentence);
    *error = status == FW_OK ? *error : reason;
    FW_TRY(status);
    return take_value(document, node, value, error);
}

fw_status fw_constants_resolve(const fw_constants *constants, fw_document *document, fw_node *node,
                               const char *path, fw_error *error)
{
    if (!node->formula && !is_formula(node, constants)) return FW_OK;
    return evaluate(constants, document, node, path, error);
}

/* --- constants --- */

typedef enum stage { UNKNOWN, AT_WORK, KNOWN } stage;

/* Constants on their way to their values: each once all are that its formula names. */
typedef struct reader {
    fw_document *document;
    const char *key;
    fw_error *error;
    fw_node **nodes; /* as the constants */
    stage *stages;
    fw_constants *all;
} reader;

static fw_status make_known(reader *r, int number);

/* Those that the text of a formula names. */
static fw_status make_others_known(reader *r, int number, const char *text)
{
    const size_t length = strlen(text);
    for (size_t at = 0; at < length;) {
        const int other = fw_formula_find(text, length, at, r->all->items, r->all->count, &at);
        if (other < 0) break;
        if (other == number)
            return fw_document_fail(r->document, r->nodes[number]->place, r->error,
                                    "%s.%s is '%s', which needs its own value", r->key,
                                    r->nodes[number]->key, fw_text_quote(text, length).text);
        if (r->stages[other] == AT_WORK)
            return fw_document_fail(r->document, r->nodes[number]->place, r->error,
                                    "%s.%s is '%s', but the value of %s needs that of %s in its "
                                    "turn",
                                    r->key, r->nodes[number]->key, fw_text_quote(text, length).text,
                                    r->nodes[other]->key, r->nodes[number]->key);
        FW_TRY(make_known(r, other));
    }
    return FW_OK;
}

static fw_status make_known(reader *r, int number)
{
    fw_node *node = r->nodes[number];
    char path[2 * FW_NAME_BYTES];
    double value = 0;
    if (r->stages[number] == KNOWN) return FW_OK;
    r->stages[number] = AT_WORK;
    snprintf(path, sizeof path, "%.60s.%.60s", r->key, node->key);
    if (node->formula || is_formula(node, r->all)) {
        FW_TRY(make_others_known(r, number, fw_node_written(node)));
        FW_TRY(evaluate(r->all, r->document, node, path, r->error));
    }
    /* What is no number is refused with all others that are none. */
    if (node->kind == FW_SCALAR && !fw_number_read(node->text, node->length, &value))
        r->all->items[number].value = value;
    r->stages[number] = KNOWN;
    return FW_OK;
}

static fw_status check_name(const fw_document *document, const char *key, const fw_node *node,
                            fw_error *error)
{
    fw_error reason;
    const fw_status status = fw_formula_check_name(node->key, &reason);
    if (status == FW_BAD_INPUT)
        return fw_document_fail(document, node->key_place, error, "%s: %s", key, reason.sentence);
    if (status != FW_OK) *error = reason;
    return status;
}

fw_status fw_constants_read(fw_constants *constants, fw_document *document, const char *key,
                            fw_node *mapping, fw_error *error)
{
    *constants = (fw_constants){0};
    if (!mapping || mapping->kind != FW_MAPPING || mapping->count == 0) return FW_OK;
    if (mapping->count > FW_CONSTANTS_MAX)
        return fw_document_fail(document, mapping->key_place, error,
                                "%s has %d names, expected at most %d", key, mapping->count,
                                FW_CONSTANTS_MAX);
    const size_t count = (size_t)mapping->count;
    reader r = {.document = document, .key = key, .error = error, .all = constants};
    constants->items = fw_document_allocate(document, count, sizeof *constants->items);
    r.nodes = fw_document_allocate(document, count, sizeof *r.nodes);
    r.stages = fw_document_allocate(document, count, sizeof *r.stages);
    if (!constants->items || !r.nodes || !r.stages) return fw_document_fail_memory(document, error);
    for (fw_node *node = mapping->first; node; node = node->next) {
        FW_TRY(check_name(document, key, node, error));
        constants->items[constants->count].name = node->key;
        r.nodes[constants->count++] = node;
    }
    for (int n = 0; n < constants->count; ++n) FW_TRY(make_known(&r, n));
    return FW_OK;
}
