/* SPDX-License-Identifier: GPL-3.0-or-later */
/* document_reader.c - from a text to a document. The only door to libyaml, whose events become a
 * tree of nodes.
 * State: one reader per text, gone when the tree stands.
 * Invariant: a tree is never deeper than FW_DOCUMENT_DEPTH and has at most FW_DOCUMENT_NODES
 * nodes, so that whoever walks it may recurse. Start reading at read_text(). */
#include "experiments/text/document.h"

#include "document_parts.h"
#include "experiments/text/text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

/* Libyaml's words, and those of a person who writes a scenario. */
static const char *in_plain_words(const char *problem)
{
    static const char *const words[][2] = {
        {"while parsing a flow sequence", "in the list [...]"},
        {"while parsing a flow mapping", "in the mapping {...}"},
        {"while parsing a block mapping", "in the indented mapping"},
        {"while parsing a block collection", "in the indented list"},
        {"while parsing a block sequence", "in the indented list"},
        {"while scanning a quoted scalar", "in the quoted text"},
        {"while parsing a quoted scalar", "in the quoted text"},
        {"while scanning a plain scalar", "in the text"},
        {"while scanning a block scalar", "in the lines of text"},
        {"while scanning a simple key", "in the key"},
        {"while scanning for the next token", ""},
        {"did not find expected ',' or ']'", "a ',' or the closing ']' is missing"},
        {"did not find expected ',' or '}'", "a ',' or the closing '}' is missing"},
        {"did not find expected key", "a key was expected here; is the line indented like the "
                                      "others?"},
        {"did not find expected '-' indicator", "a '-' was expected here; is the line indented "
                                                "like the others?"},
        {"did not find expected node content", "a value is missing"},
        {"did not find expected <document start>", "more follows after the end of the scenario"},
        {"could not find expected ':'", "a ':' with a blank behind it is missing after the key"},
        {"mapping values are not allowed in this context",
         "a ':' cannot stand here; a text with ': ' in it needs quotes, and lines of one mapping "
         "begin "
         "in one column: look at the line before too"},
        {"block sequence entries are not allowed in this context", "a '-' cannot stand here"},
        {"found unexpected end of stream", "the file ends before the closing quote"},
        {"found unexpected document indicator", "the text ends before the closing quote"},
        {"found character that cannot start any token",
         "a value cannot begin with this character; use blanks, not tabs, to indent"},
        {"found a tab character that violates indentation",
         "a tab where blanks are needed to indent"},
        {"found a tab character where an indentation space is expected",
         "a tab where blanks are needed to indent"},
        {NULL, NULL}};
    if (!problem) return "";
    for (int n = 0; words[n][0]; ++n)
        if (!strcmp(problem, words[n][0])) return words[n][1];
    return problem;
}

/* --- from events to nodes --- */

typedef struct reader {
    fw_document *document;
    int setting; /* number of the --set option, or 0 */
    yaml_parser_t parser;
    fw_node *root;
    fw_node *open[FW_DOCUMENT_DEPTH]; /* lists and mappings that are not yet closed */
    int depth;
    fw_node *keyed; /* a node that has its key and waits for its value */
    int documents;
    int node_count;
} reader;

static fw_place place_of(const reader *r, yaml_mark_t mark)
{
    return (fw_place){(int)mark.line + 1, (int)mark.column + 1, r->setting};
}

static fw_status syntax_failed(reader *r, fw_error *error)
{
    yaml_parser_t *parser = &r->parser;
    if (parser->error == YAML_MEMORY_ERROR) return fw_document_fail_memory(r->document, error);
    const char *context = in_plain_words(parser->context);
    const char *problem = in_plain_words(parser->problem);
    fw_place place = place_of(r, parser->problem_mark);
    if (*context && !r->setting)
        return fw_document_fail(r->document, place, error, "%s (%s that begins in line %d)",
                                problem, context, (int)parser->context_mark.line + 1);
    return fw_document_fail(r->document, place, error, "%s", problem);
}

/* Escapes in double quotes can write what the file itself may not hold. */
static fw_status check_text(reader *r, const yaml_event_t *event, fw_error *error)
{
    const char *text = (const char *)event->data.scalar.value;
    fw_text_fault fault = fw_text_check(text, event->data.scalar.length);
    if (!fault.what) return FW_OK;
    return fw_document_fail(r->document, place_of(r, event->start_mark), error,
                            "the text holds %s (hexadecimal %02X), expected none", fault.what,
                            fault.code);
}

static fw_status make_node(reader *r, const yaml_event_t *event, fw_node_kind kind, fw_node **node,
                           fw_error *error)
{
    fw_document *document = r->document;
    fw_place place = place_of(r, event->start_mark);
    if (++r->node_count > FW_DOCUMENT_NODES)
        return fw_document_fail(document, place, error, "more than %d values, expected fewer",
                                FW_DOCUMENT_NODES);
    *node = r->keyed;
    if (!*node) *node = fw_document_allocate(document, 1, sizeof **node);
    if (!*node) return fw_document_fail_memory(document, error);
    (*node)->kind = kind;
    (*node)->place = place;
    if (!r->keyed) (*node)->key_place = place;
    if (r->depth == 0)
        r->root = *node;
    else
        fw_node_append(r->open[r->depth - 1], *node);
    r->keyed = NULL;
    return FW_OK;
}

static fw_status read_key(reader *r, const yaml_event_t *event, fw_error *error)
{
    fw_document *document = r->document;
    fw_place place = place_of(r, event->start_mark);
    if (event->type != YAML_SCALAR_EVENT)
        return fw_document_fail(document, place, error, "a %s as a key, expected a word",
                                event->type == YAML_MAPPING_START_EVENT ? "mapping" : "list");
    const char *text = (const char *)event->data.scalar.value;
    size_t length = event->data.scalar.length;
    if (length == 0 || length >= FW_NAME_BYTES)
        return fw_document_fail(document, place, error,
                                "the key '%s' is %zu characters long, expected 1 to %d",
                                fw_text_quote(text, length).text, length, FW_NAME_BYTES - 1);
    FW_TRY(check_text(r, event, error));
    r->keyed = fw_document_allocate(document, 1, sizeof *r->keyed);
    if (!r->keyed) return fw_document_fail_memory(document, error);
    r->keyed->key = fw_document_copy(document, text, length);
    r->keyed->key_place = place;
    return r->keyed->key ? FW_OK : fw_document_fail_memory(document, error);
}

static fw_status read_scalar(reader *r, const yaml_event_t *event, fw_error *error)
{
    fw_node *node;
    FW_TRY(check_text(r, event, error));
    FW_TRY(make_node(r, event, FW_SCALAR, &node, error));
    yaml_scalar_style_t style = event->data.scalar.style;
    node->length = event->data.scalar.length;
    node->text =
        fw_document_copy(r->document, (const char *)event->data.scalar.value, node->length);
    node->quoted = style != YAML_PLAIN_SCALAR_STYLE;
    return node->text ? FW_OK : fw_document_fail_memory(r->document, error);
}

static fw_status open_node(reader *r, const yaml_event_t *event, fw_error *error)
{
    fw_node *node;
    fw_node_kind kind = event->type == YAML_MAPPING_START_EVENT ? FW_MAPPING : FW_LIST;
    if (r->depth == FW_DOCUMENT_DEPTH)
        return fw_document_fail(r->document, place_of(r, event->start_mark), error,
                                "lists and mappings within each other more than %d deep",
                                FW_DOCUMENT_DEPTH);
    FW_TRY(make_node(r, event, kind, &node, error));
    r->open[r->depth++] = node;
    return FW_OK;
}

static int compare_keys(const void *left, const void *right)
{
    const fw_node *a = *(fw_node *const *)left, *b = *(fw_node *const *)right;
    int order = strcmp(a->key, b->key);
    if (order) return order;
    if (a->key_place.line != b->key_place.line)
        return a->key_place.line < b->key_place.line ? -1 : 1;
    return (a->key_place.column > b->key_place.column) -
           (a->key_place.column < b->key_place.column);
}

/* Sorted, so that a mapping of a million keys takes no longer than its text deserves. */
static fw_status refuse_repeated_keys(reader *r, const fw_node *mapping, fw_error *error)
{
    if (mapping->count < 2) return FW_OK;
    fw_node **sorted = malloc((size_t)mapping->count * sizeof(fw_node *));
    if (!sorted) return fw_document_fail_memory(r->document, error);
    size_t count = 0;
    for (fw_node *child = mapping->first; child; child = child->next) sorted[count++] = child;
    qsort(sorted, count, sizeof(fw_node *), compare_keys);
    fw_status status = FW_OK;
    for (size_t n = 1; n < count && status == FW_OK; ++n)
        if (!strcmp(sorted[n]->key, sorted[n - 1]->key))
            status = fw_document_fail(r->document, sorted[n]->key_place, error,
                                      "'%s' is given a second time, after line %d",
                                      fw_text_quote(sorted[n]->key, strlen(sorted[n]->key)).text,
                                      sorted[n - 1]->key_place.line);
    free(sorted);
    return status;
}

static fw_quote quoted(const yaml_char_t *text)
{
    return fw_text_quote((const char *)text, strlen((const char *)text));
}

static fw_status refuse_anchor_and_tag(reader *r, const yaml_event_t *event, fw_error *error)
{
    const yaml_char_t *anchor = NULL, *tag = NULL;
    if (event->type == YAML_ALIAS_EVENT)
        return fw_document_fail(r->document, place_of(r, event->start_mark), error,
                                "an alias '*%s'; a scenario is written out in full, without "
                                "anchors and aliases",
                                quoted(event->data.alias.anchor).text);
    if (event->type == YAML_SCALAR_EVENT) {
        anchor = event->data.scalar.anchor;
        tag = event->data.scalar.tag;
    } else if (event->type == YAML_SEQUENCE_START_EVENT) {
        anchor = event->data.sequence_start.anchor;
        tag = event->data.sequence_start.tag;
    } else if (event->type == YAML_MAPPING_START_EVENT) {
        anchor = event->data.mapping_start.anchor;
        tag = event->data.mapping_start.tag;
    }
    if (anchor)
        return fw_document_fail(r->document, place_of(r, event->start_mark), error,
                                "an anchor '&%s'; a scenario is written out in full, without "
                                "anchors and aliases",
                                quoted(anchor).text);
    if (tag)
        return fw_document_fail(r->document, place_of(r, event->start_mark), error,
                                "a tag '%s'; a scenario has no tags", quoted(tag).text);
    return FW_OK;
}

static fw_status read_event(reader *r, const yaml_event_t *event, fw_error *error)
{
    FW_TRY(refuse_anchor_and_tag(r, event, error));
    switch (event->type) {
    case YAML_DOCUMENT_START_EVENT:
        if (++r->documents > 1)
            return fw_document_fail(r->document, place_of(r, event->start_mark), error,
                                    "a second document begins, expected one scenario in a file");
        return FW_OK;
    case YAML_SCALAR_EVENT:
    case YAML_SEQUENCE_START_EVENT:
    case YAML_MAPPING_START_EVENT: {
        bool in_mapping = r->depth && r->open[r->depth - 1]->kind == FW_MAPPING;
        if (in_mapping && !r->keyed) return read_key(r, event, error);
        return event->type == YAML_SCALAR_EVENT ? read_scalar(r, event, error)
                                                : open_node(r, event, error);
    }
    case YAML_MAPPING_END_EVENT:
        return refuse_repeated_keys(r, r->open[--r->depth], error);
    case YAML_SEQUENCE_END_EVENT:
        r->depth -= 1;
        return FW_OK;
    default:
        return FW_OK;
    }
}

static fw_status read_events(reader *r, fw_error *error)
{
    for (;;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&r->parser, &event)) return syntax_failed(r, error);
        bool end = event.type == YAML_STREAM_END_EVENT;
        fw_status status = read_event(r, &event, error);
        yaml_event_delete(&event);
        if (status != FW_OK || end) return status;
    }
}

/* One tree with memory of the document. `setting` > 0: it was written in that --set option. */
static fw_status read_text(fw_document *document, int setting, const char *text, size_t length,
                           fw_node **root, fw_error *error)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF";
    if (length >= 3 && !memcmp(text, byte_order_mark, 3)) {
        text += 3;
        length -= 3;
    }
    fw_place start = {1, 1, setting};
    if (length > FW_DOCUMENT_BYTES)
        return fw_document_fail(document, start, error, "%zu bytes, expected at most %d", length,
                                FW_DOCUMENT_BYTES);
    fw_text_fault fault = fw_text_check(text, length);
    if (fault.what)
        return fw_document_fail(document, (fw_place){fault.line, fault.column, setting}, error,
                                "%s (hexadecimal %02X), expected plain text in UTF-8", fault.what,
                                fault.code);
    reader r = {.document = document, .setting = setting};
    if (!yaml_parser_initialize(&r.parser)) return fw_document_fail_memory(document, error);
    yaml_parser_set_input_string(&r.parser, (const unsigned char *)text, length);
    yaml_parser_set_encoding(&r.parser, YAML_UTF8_ENCODING);
    fw_status status = read_events(&r, error);
    yaml_parser_delete(&r.parser);
    *root = r.root;
    if (status == FW_OK && !r.root)
        status = fw_document_fail(document, start, error, "nothing is written there, expected %s",
                                  setting ? "a value after '='" : "a scenario");
    return status;
}

/* --- whole documents, and values of options --- */

fw_status fw_document_parse(fw_document **document, const char *file, const char *text,
                            size_t length, fw_error *error)
{
    FW_TRY(fw_document_create(document, file, error));
    fw_node *root;
    fw_status status = read_text(*document, 0, text, length, &root, error);
    if (status == FW_OK) {
        fw_document_set_root(*document, root);
    } else {
        fw_document_destroy(*document);
        *document = NULL;
    }
    return status;
}

/* A name that leads nowhere, or to what is no file, is the user's. */
static fw_status blame(int reason)
{
    const bool name_is_wrong = reason == ENOENT || reason == ENOTDIR || reason == EISDIR ||
                               reason == ELOOP || reason == ENAMETOOLONG || reason == EACCES;
    return name_is_wrong ? FW_BAD_INPUT : FW_SYSTEM_FAILED;
}

fw_status fw_document_load(fw_document **document, const char *path, fw_error *error)
{
    *document = NULL;
    FILE *in = fopen(path, "rb");
    if (!in) return fw_fail(error, blame(errno), "%s: cannot be opened: %s", path, strerror(errno));
    /* One byte more than allowed: enough to see that it is too long, whatever kind of file. */
    size_t room = (size_t)FW_DOCUMENT_BYTES + 4;
    char *text = malloc(room);
    fw_status status = FW_OK;
    if (!text) status = fw_fail(error, FW_SYSTEM_FAILED, "not enough memory to read %s", path);
    size_t length = text ? fread(text, 1, room, in) : 0;
    if (text && ferror(in))
        status = fw_fail(error, blame(errno), "%s: cannot be read: %s", path, strerror(errno));
    fclose(in);
    if (status == FW_OK && length == room)
        status = fw_fail(error, FW_BAD_INPUT, "%s: longer than %d bytes, expected a scenario", path,
                         FW_DOCUMENT_BYTES);
    if (status == FW_OK) status = fw_document_parse(document, path, text, length, error);
    free(text);
    return status;
}

fw_status fw_document_parse_value(fw_document *document, const char *option, const char *text,
                                  fw_node **value, fw_error *error)
{
    int setting;
    *value = NULL;
    FW_TRY(fw_document_add_option(document, option, &setting, error));
    return read_text(document, setting, text, strlen(text), value, error);
}
