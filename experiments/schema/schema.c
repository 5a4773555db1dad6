/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema.c - is a tree what the table says? Keeps no state but the path to the node at hand.
 * Invariant: what has passed can be read by fw_schema_fill without further questions.
 * Start reading at check_mapping(). */
#include "experiments/schema/schema.h"

#include "experiments/schema/constants.h"
#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <assert.h>
#include <math.h>
#include <string.h>

enum { PATH_SIZE = 320, EXPECTED_SIZE = 400, ALTERNATIVES_MAX = 16 };

typedef struct checker {
    fw_document *document;
    fw_constants constants;
    fw_error *error;
    char path[PATH_SIZE]; /* "bodies.sheet.velocity" */
} checker;

/* --- the path to where we are --- */

static size_t enter(checker *c, const char *name)
{
    size_t before = strlen(c->path);
    snprintf(c->path + before, sizeof c->path - before, "%s%s", before ? "." : "", name);
    return before;
}

static size_t enter_item(checker *c, int number)
{
    char name[16];
    snprintf(name, sizeof name, "%d", number);
    return enter(c, name);
}

static void leave(checker *c, size_t before)
{
    c->path[before] = '\0';
}

/* --- sentences --- */

typedef struct description {
    char text[FW_QUOTE_SIZE + 32];
} description;

static description describe(const fw_node *node, const fw_key *key)
{
    description d;
    if (node->kind == FW_SCALAR && node->length == 0)
        snprintf(d.text, sizeof d.text, "empty");
    else if (node->kind == FW_SCALAR && node->formula)
        snprintf(d.text, sizeof d.text, "'%s' = %s",
                 fw_text_quote(node->formula, strlen(node->formula)).text, node->text);
    else if (node->kind == FW_SCALAR)
        snprintf(d.text, sizeof d.text, "%s'%s'%s", node->quoted ? "the text " : "",
                 fw_text_quote(node->text, node->length).text,
                 key && key->layout && strchr(node->text, ',') ? " without brackets" : "");
    else
        snprintf(d.text, sizeof d.text, "a %s of %d", node->kind == FW_LIST ? "list" : "mapping",
                 node->count);
    return d;
}

static fw_status refuse(checker *c, const fw_node *node, const fw_key *key)
{
    char expected[EXPECTED_SIZE];
    fw_schema_expected(key, expected, sizeof expected);
    return fw_document_fail(c->document, node->place, c->error, "%s is %s, expected %s%s%s",
                            c->path, describe(node, key).text, expected, key->hint ? "; " : "",
                            key->hint ? key->hint : "");
}

fw_status fw_schema_check_key(const fw_document *document, const fw_section *section,
                              const char *path, const char *key, fw_place place, fw_error *error)
{
    if (fw_section_find(section, key)) return FW_OK;
    fw_quote found = fw_text_quote(key, strlen(key));
    fw_suggestion suggestion = fw_suggestion_begin(key);
    char all[EXPECTED_SIZE] = "";
    const char *renamed = NULL;
    for (const fw_key *known = fw_section_first(section); known;
         known = fw_section_next(section, known)) {
        if (known->old_name && !strcmp(known->old_name, key)) renamed = known->name;
        fw_suggestion_offer(&suggestion, known->name);
        size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", used ? ", " : "", known->name);
    }
    const char *in = *path ? " in " : "";
    if (renamed)
        return fw_document_fail(document, place, error,
                                "unknown key '%s'%s%s; it is now called '%s'", found.text, in, path,
                                renamed);
    if (suggestion.best)
        return fw_document_fail(document, place, error, "unknown key '%s'%s%s; did you mean '%s'?",
                                found.text, in, path, suggestion.best);
    return fw_document_fail(document, place, error,
                            "unknown key '%s'%s%s, expected a key of %s: %s", found.text, in, path,
                            section->noun, all);
}

/* --- single values --- */

static bool in_bounds(const fw_key *key, double value)
{
    if ((key->bounds & FW_ABOVE) && !(value > key->low)) return false;
    if ((key->bounds & FW_FROM) && !(value >= key->low)) return false;
    if ((key->bounds & FW_UP_TO) && !(value <= key->high)) return false;
    if ((key->bounds & FW_BELOW) && !(value < key->high)) return false;
    return true;
}

/* A number of at most `most` in size where a single one may be. */
static fw_status check_number(checker *c, fw_node *node, const fw_key *key, double most)
{
    FW_TRY(fw_constants_resolve(&c->constants, c->document, node, c->path, c->error));
    if (node->kind != FW_SCALAR || (node->quoted && !node->formula)) return refuse(c, node, key);
    double value = 0;
    int64_t integer = 0;
    bool whole = key->forms & FW_FORM_INTEGER;
    fw_number_fault fault = whole ? fw_integer_read(node->text, node->length, &integer)
                                  : fw_number_read(node->text, node->length, &value);
    if (whole) value = (double)integer;
    bool huge = fault == FW_NUMBER_TOO_LARGE || fault == FW_NUMBER_NOT_FINITE || fabs(value) > most;
    if (fault == FW_NUMBER_FINE && !huge && in_bounds(key, value)) return FW_OK;

    char expected[EXPECTED_SIZE];
    fw_schema_expected(key, expected, sizeof expected);
    const description found = describe(node, NULL);
    if (fault == FW_NUMBER_TOO_SMALL)
        return fw_document_fail(c->document, node->place, c->error,
                                "%s is %s, which is not 0 but too small for a number here", c->path,
                                found.text);
    if (fault == FW_NUMBER_NOT_WHOLE && node->formula)
        return fw_document_fail(c->document, node->place, c->error,
                                "%s is %s, expected %s, which rint(...) makes", c->path, found.text,
                                expected);
    if (fault == FW_NUMBER_NOT_WHOLE)
        return fw_document_fail(c->document, node->place, c->error,
                                "%s is %s, expected %s, written without point, exponent or "
                                "leading zeros",
                                c->path, found.text, expected);
    if (huge && !(key->bounds & (FW_UP_TO | FW_BELOW)))
        return fw_document_fail(c->document, node->place, c->error,
                                "%s is %s, expected %s, finite and at most %.15g in size", c->path,
                                found.text, expected, most);
    return refuse(c, node, key);
}

/* How many values a layout such as "[x, y]" has. */
static int layout_length(const char *layout)
{
    int length = 1;
    for (const char *c = layout; *c; ++c) length += *c == ',';
    return length;
}

static fw_status check_numbers(checker *c, fw_node *node, const fw_key *key, bool whole)
{
    if (node->kind != FW_LIST || node->count != layout_length(key->layout))
        return refuse(c, node, key);
    fw_key single = *key;
    single.forms = whole ? FW_FORM_INTEGER : FW_FORM_NUMBER;
    int number = 0;
    for (fw_node *child = node->first; child; child = child->next) {
        size_t before = enter_item(c, number++);
        FW_TRY(check_number(c, child, &single, whole ? FW_COORDINATE_MAX : FW_NUMBER_MAX));
        leave(c, before);
    }
    return FW_OK;
}

static fw_status check_symmetric(checker *c, fw_node *node, const fw_key *key)
{
    fw_key single = *key;
    single.forms = FW_FORM_NUMBER;
    if (node->kind == FW_SCALAR) {
        return node->length ? check_number(c, node, &single, FW_NUMBER_MAX) : refuse(c, node, key);
    }
    bool full = node->kind == FW_LIST && node->count == 2;
    if (!full && !(node->kind == FW_LIST && node->count == 3)) return refuse(c, node, key);

    /* Entries may be negative; the matrix as a whole has the bounds. */
    single.bounds = FW_UNBOUNDED;
    double entry[4];
    int count = 0;
    for (fw_node *row = node->first; row; row = row->next) {
        if (full && (row->kind != FW_LIST || row->count != 2)) return refuse(c, node, key);
        for (fw_node *child = full ? row->first : row; child; child = child->next) {
            size_t before = enter_item(c, count);
            FW_TRY(check_number(c, child, &single, FW_NUMBER_MAX));
            leave(c, before);
            entry[count++] = fw_node_number(child);
            if (!full) break;
        }
    }
    if (full && entry[1] != entry[2])
        return fw_document_fail(c->document, node->place, c->error,
                                "%s is a matrix with %.17g to the right of %.17g on its diagonal "
                                "but %.17g below it, expected a symmetric one: any other would "
                                "create energy from nothing",
                                c->path, entry[1], entry[0], entry[2]);
    double xx = entry[0], xy = entry[1], yy = full ? entry[3] : entry[2];
    if ((key->bounds & FW_ABOVE) && !(xx > 0 && yy > 0 && xx * yy - xy * xy > 0))
        return fw_document_fail(c->document, node->place, c->error,
                                "%s is [[%.17g, %.17g], [%.17g, %.17g]], expected a positive "
                                "definite matrix: this one is zero or negative in some direction",
                                c->path, xx, xy, xy, yy);
    return FW_OK;
}

static fw_status check_word(checker *c, fw_node *node, const fw_key *key)
{
    fw_suggestion suggestion = fw_suggestion_begin(node->text);
    for (const fw_word *word = key->words; word->name; ++word) {
        if (!strcmp(word->name, node->text)) return FW_OK;
        fw_suggestion_offer(&suggestion, word->name);
    }
    if (!suggestion.best) return refuse(c, node, key);
    char expected[EXPECTED_SIZE];
    fw_schema_expected(key, expected, sizeof expected);
    return fw_document_fail(
        c->document, node->place, c->error, "%s is '%s', expected %s; did you mean '%s'?", c->path,
        fw_text_quote(node->text, node->length).text, expected, suggestion.best);
}

static bool is_name(const char *text, size_t length)
{
    if (length == 0 || length >= FW_NAME_BYTES) return false;
    for (size_t n = 0; n < length; ++n) {
        char c = text[n];
        bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        bool other = (c >= '0' && c <= '9') || c == '-' || c == '_';
        if (!letter && !(other && n > 0)) return false;
    }
    return true;
}

/* Names with a dot between each two. */
static bool is_path(const char *text, size_t length)
{
    for (;;) {
        const char *dot = memchr(text, '.', length);
        if (!dot) return is_name(text, length);
        size_t part = (size_t)(dot - text);
        if (!is_name(text, part)) return false;
        text += part + 1;
        length -= part + 1;
    }
}

/* --- values made of others --- */

static fw_status check_mapping(checker *c, fw_node *mapping, const fw_section *section);
static fw_status check_value(checker *c, fw_node *node, const fw_key *key);

static fw_status check_list(checker *c, fw_node *node, const fw_key *key)
{
    int most = key->most ? key->most : FW_ITEMS_MAX;
    if (node->count < key->least || node->count > most)
        return fw_document_fail(c->document, node->place, c->error,
                                "%s has %d items, expected %d to %d", c->path, node->count,
                                key->least, most);
    fw_key item = *key;
    item.forms = key->items;
    item.items = 0;
    int number = 0;
    for (fw_node *child = node->first; child; child = child->next) {
        size_t before = enter_item(c, number++);
        FW_TRY(check_value(c, child, &item));
        leave(c, before);
    }
    return FW_OK;
}

static fw_status check_named(checker *c, fw_node *node, const fw_key *key)
{
    if (node->kind != FW_MAPPING) return refuse(c, node, key);
    if (node->count < key->least || node->count > key->most)
        return fw_document_fail(c->document, node->place, c->error,
                                "%s has %d names, expected %d to %d", c->path, node->count,
                                key->least, key->most);
    fw_key named = *key;
    named.forms = FW_FORM_MAPPING;
    for (fw_node *child = node->first; child; child = child->next) {
        size_t length = strlen(child->key);
        if (!is_name(child->key, length))
            return fw_document_fail(c->document, child->key_place, c->error,
                                    "'%s' as a name in %s, expected a letter and then letters, "
                                    "digits, '-' or '_'",
                                    fw_text_quote(child->key, length).text, c->path);
        size_t before = enter(c, child->key);
        FW_TRY(check_value(c, child, &named));
        leave(c, before);
    }
    return FW_OK;
}

/* {A: 2.5, p: 1}, also of constants, whose values are known by now. */
static fw_status check_point(checker *c, fw_node *node, const fw_key *key)
{
    const fw_key number = {.name = key->name, .forms = FW_FORM_NUMBER};
    if (node->count == 0) return refuse(c, node, key);
    for (fw_node *child = node->first; child; child = child->next) {
        size_t before = enter(c, child->key);
        FW_TRY(check_number(c, child, &number, FW_NUMBER_MAX));
        leave(c, before);
    }
    return FW_OK;
}

static fw_status check_scalar(checker *c, fw_node *node, const fw_key *key)
{
    if (key->forms & FW_FORM_SYMMETRIC) return check_symmetric(c, node, key);
    if (key->forms & (FW_FORM_NUMBER | FW_FORM_ANGLE))
        return check_number(c, node, key, FW_NUMBER_MAX);
    if (key->forms & FW_FORM_INTEGER) return check_number(c, node, key, FW_INTEGER_MAX);
    if (node->length == 0) return refuse(c, node, key);
    if (key->forms & FW_FORM_TEXT) return FW_OK;
    if (key->forms & FW_FORM_WORD) return check_word(c, node, key);
    if (key->forms & FW_FORM_FLAG)
        return !node->quoted && (!strcmp(node->text, "true") || !strcmp(node->text, "false"))
                   ? FW_OK
                   : refuse(c, node, key);
    if (key->forms & FW_FORM_NAME)
        return is_name(node->text, node->length) ? FW_OK : refuse(c, node, key);
    if (key->forms & FW_FORM_PATH)
        return is_path(node->text, node->length) ? FW_OK : refuse(c, node, key);
    return refuse(c, node, key);
}

static fw_status check_value(checker *c, fw_node *node, const fw_key *key)
{
    if (key->forms & FW_FORM_NAMED) return check_named(c, node, key);
    if (node->kind == FW_SCALAR) return check_scalar(c, node, key);
    if (node->kind == FW_MAPPING && key->forms & (FW_FORM_POINT | FW_FORM_CONSTANTS))
        return check_point(c, node, key);
    if (node->kind == FW_MAPPING)
        return key->forms & FW_FORM_MAPPING ? check_mapping(c, node, key->subsection)
                                            : refuse(c, node, key);
    if (key->forms & FW_FORM_NUMBERS) return check_numbers(c, node, key, false);
    if (key->forms & FW_FORM_INTEGERS) return check_numbers(c, node, key, true);
    if (key->forms & FW_FORM_SYMMETRIC) return check_symmetric(c, node, key);
    return key->forms & FW_FORM_LIST ? check_list(c, node, key) : refuse(c, node, key);
}

/* --- mappings --- */

static const char *where(const checker *c)
{
    return *c->path ? c->path : "the scenario";
}

static fw_status check_alternatives(checker *c, const fw_node *mapping, const fw_section *section)
{
    const fw_node *given = NULL;
    fw_word all[ALTERNATIVES_MAX + 1] = {{NULL, 0}};
    int count = 0;
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key)) {
        if (!key->alternative) continue;
        assert(count < ALTERNATIVES_MAX);
        all[count++].name = key->name;
        const fw_node *node = fw_node_find(mapping, key->name);
        if (node && given) {
            bool later = node->key_place.line > given->key_place.line ||
                         (node->key_place.line == given->key_place.line &&
                          node->key_place.column > given->key_place.column);
            return fw_document_fail(c->document, later ? node->key_place : given->key_place,
                                    c->error, "%s has both '%s' and '%s', expected one of them",
                                    where(c), given->key, node->key);
        }
        if (node) given = node;
    }
    if (given || count == 0) return FW_OK;
    char expected[EXPECTED_SIZE];
    fw_schema_list_words(all, expected, sizeof expected);
    return fw_document_fail(c->document, mapping->place, c->error, "%s is incomplete, expected %s",
                            where(c), expected);
}

static fw_status check_presence(checker *c, const fw_node *mapping, const fw_section *section)
{
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key)) {
        const fw_node *node = fw_node_find(mapping, key->name);
        if (key->required && !node)
            return fw_document_fail(c->document, mapping->key ? mapping->key_place : mapping->place,
                                    c->error, "%s has no '%s', which %s must have", where(c),
                                    key->name, section->noun);
        if (node && key->needs && !fw_node_find(mapping, key->needs))
            return fw_document_fail(c->document, node->key_place, c->error,
                                    "%s has '%s' but no '%s', without which it means nothing",
                                    where(c), key->name, key->needs);
    }
    return check_alternatives(c, mapping, section);
}

static fw_status check_mapping(checker *c, fw_node *mapping, const fw_section *section)
{
    /* Unknown keys first: a misspelt one would also be missed as required. */
    for (const fw_node *child = mapping->first; child; child = child->next)
        FW_TRY(fw_schema_check_key(c->document, section, c->path, child->key, child->key_place,
                                   c->error));
    for (fw_node *child = mapping->first; child; child = child->next) {
        size_t before = enter(c, child->key);
        FW_TRY(check_value(c, child, fw_section_find(section, child->key)));
        leave(c, before);
    }
    return check_presence(c, mapping, section);
}

static fw_status read_constants(checker *c, const fw_node *root, const fw_section *section)
{
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key))
        if (key->forms & FW_FORM_CONSTANTS)
            return fw_constants_read(&c->constants, c->document, key->name,
                                     fw_node_find(root, key->name), c->error);
    return FW_OK;
}

fw_status fw_schema_check(fw_document *document, const fw_section *section, fw_error *error)
{
    fw_node *root = fw_document_root(document);
    checker c = {.document = document, .error = error};
    if (root->kind != FW_MAPPING)
        return fw_document_fail(document, root->place, error,
                                "the scenario is %s, expected keys such as 'title: ...' in lines "
                                "of their own",
                                describe(root, NULL).text);
    FW_TRY(read_constants(&c, root, section));
    return check_mapping(&c, root, section);
}
