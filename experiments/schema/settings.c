/* SPDX-License-Identifier: GPL-3.0-or-later */
/* settings.c - walks from the root of a document along the keys of a --set option, with the schema
 * at its side, and puts the value there. Keeps no state but the walk. Start reading at walk(). */
#include "settings.h"

#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <string.h>

enum { PATH_SIZE = 256 };

typedef struct step {
    fw_document *document;
    fw_error *error;
    fw_node *value; /* what the option gives */
    fw_node *at;    /* where the walk is */
    const fw_section
        *section;         /* of the keys of `at`; NULL where these are names, or it is a list */
    const fw_key *key;    /* that led here */
    char path[PATH_SIZE]; /* the same in words */
} step;

static fw_status fail_without(step *s, const char *name)
{
    return fw_document_fail(s->document, s->value->place, s->error,
                            "%s has no '%s', because it is %s", s->path,
                            fw_text_quote(name, strlen(name)).text,
                            s->at->kind == FW_SCALAR ? "a single value" : "a list");
}

/* The value takes the place of what is there; key and neighbours stay. */
static void replace(fw_node *node, const fw_node *value)
{
    fw_node fresh = *value;
    fresh.key = node->key;
    fresh.key_place = value->place;
    fresh.next = node->next;
    *node = fresh;
}

static fw_status add(step *s, const char *key, fw_node **child)
{
    *child = fw_document_allocate(s->document, 1, sizeof **child);
    if (!*child) return fw_document_fail_memory(s->document, s->error);
    (*child)->kind = FW_MAPPING;
    (*child)->place = (*child)->key_place = s->value->place;
    if (key) {
        (*child)->key = fw_document_copy(s->document, key, strlen(key));
        if (!(*child)->key) return fw_document_fail_memory(s->document, s->error);
    }
    fw_node_append(s->at, *child);
    return FW_OK;
}

static void remove_other_alternatives(fw_node *mapping, const fw_section *section,
                                      const fw_key *chosen)
{
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key)) {
        if (key == chosen || !key->alternative) continue;
        const fw_node *other = fw_node_find(mapping, key->name);
        if (other) fw_node_remove(mapping, other);
    }
}

static fw_status enter_key(step *s, const char *name, bool last, fw_node **child)
{
    FW_TRY(fw_schema_check_key(s->document, s->section, s->path, name, s->value->place, s->error));
    s->key = fw_section_find(s->section, name);
    *child = fw_node_find(s->at, name);
    if (s->key->alternative) remove_other_alternatives(s->at, s->section, s->key);
    if (!*child) {
        bool can_grow =
            last || (s->key->forms & (FW_FORM_MAPPING | FW_FORM_NAMED | FW_FORM_CONSTANTS));
        if (!can_grow)
            return fw_document_fail(s->document, s->value->place, s->error,
                                    "there is no '%s' yet; give it as a whole", name);
        FW_TRY(add(s, name, child));
    }
    s->section = s->key->forms & FW_FORM_MAPPING ? s->key->subsection : NULL;
    return FW_OK;
}

static fw_status enter_name(step *s, const char *name, bool last, fw_node **child)
{
    *child = fw_node_find(s->at, name);
    s->section = s->key->subsection;
    if (*child) return FW_OK;
    if (last) return add(s, name, child);
    fw_quote found = fw_text_quote(name, strlen(name));
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (const fw_node *known = s->at->first; known; known = known->next)
        fw_suggestion_offer(&suggestion, known->key);
    if (suggestion.best)
        return fw_document_fail(s->document, s->value->place, s->error,
                                "there is no '%s' in %s; did you mean '%s'?", found.text, s->path,
                                fw_text_quote(suggestion.best, strlen(suggestion.best)).text);
    return fw_document_fail(s->document, s->value->place, s->error, "there is no '%s' in %s",
                            found.text, s->path);
}

static fw_status enter_item(step *s, const char *name, bool last, fw_node **child)
{
    int64_t number = -1;
    fw_number_fault fault = fw_integer_read(name, strlen(name), &number);
    s->section = s->key->subsection;
    bool append = last && number == s->at->count;
    if (fault != FW_NUMBER_FINE || number < 0 || (number >= s->at->count && !append))
        return fw_document_fail(s->document, s->value->place, s->error,
                                "%s is a list of %d items, which count from 0; there is no '%s'",
                                s->path, s->at->count, fw_text_quote(name, strlen(name)).text);
    if (append) return add(s, NULL, child);
    *child = s->at->first;
    while (number-- > 0) *child = (*child)->next;
    return FW_OK;
}

static fw_status enter(step *s, const char *name, bool last)
{
    fw_node *child;
    if (s->at->kind == FW_LIST)
        FW_TRY(enter_item(s, name, last, &child));
    else if (s->at->kind != FW_MAPPING)
        return fail_without(s, name);
    else if (s->section)
        FW_TRY(enter_key(s, name, last, &child));
    else
        FW_TRY(enter_name(s, name, last, &child));
    size_t used = strlen(s->path);
    snprintf(s->path + used, sizeof s->path - used, "%s%s", used ? "." : "",
             fw_text_quote(name, strlen(name)).text);
    s->at = child;
    return FW_OK;
}

/* Along the keys before '='. */
static fw_status walk(step *s, const char *setting, const char *equals)
{
    for (const char *part = setting; part <= equals;) {
        size_t length = strcspn(part, ".=");
        char name[FW_NAME_BYTES];
        if (length == 0 || length >= sizeof name)
            return fw_document_fail(s->document, s->value->place, s->error,
                                    "a key of %zu characters, expected 1 to %d", length,
                                    FW_NAME_BYTES - 1);
        memcpy(name, part, length);
        name[length] = '\0';
        part += length + 1;
        FW_TRY(enter(s, name, part > equals));
    }
    return FW_OK;
}

static fw_status apply(fw_document *document, const fw_section *root, const char *setting,
                       fw_error *error)
{
    const char *equals = strchr(setting, '=');
    if (!equals)
        return fw_fail(error, FW_BAD_INPUT, "--set %s: expected KEY=VALUE, such as run.steps=1000",
                       fw_text_quote(setting, strlen(setting)).text);
    step s = {
        .document = document, .error = error, .at = fw_document_root(document), .section = root};
    FW_TRY(fw_document_parse_value(document, setting, equals + 1, &s.value, error));
    FW_TRY(walk(&s, setting, equals));
    replace(s.at, s.value);
    return FW_OK;
}

fw_status fw_settings_apply(fw_document *document, const fw_section *root,
                            const char *const *settings, int count, fw_error *error)
{
    /* Anything else than a mapping is refused by fw_schema_check, in better words. */
    if (fw_document_root(document)->kind != FW_MAPPING) return FW_OK;
    for (int n = 0; n < count; ++n) FW_TRY(apply(document, root, settings[n], error));
    return FW_OK;
}
