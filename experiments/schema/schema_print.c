/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema_print.c - the table in words: what a sentence says was expected, and the reference.
 * Keeps no state. Start reading at append_forms(). */
#include "experiments/schema/schema.h"
#include "experiments/text/text.h"

#include <assert.h>
#include <errno.h>
#include <string.h>

void fw_schema_list_words(const fw_word *words, char *out, size_t size)
{
    snprintf(out, size, "%s", words[0].name && words[1].name ? "one of " : "");
    for (const fw_word *word = words; word->name; ++word)
        fw_text_append(out, size, "%s%s", word == words ? "" : ", ", word->name);
}

/* " above 0 and up to 1", " from 0 to below 1", or "". */
static void list_bounds(const fw_key *key, char *out, size_t size)
{
    out[0] = '\0';
    if (key->bounds & FW_ABOVE) fw_text_append(out, size, " above %.13g", key->low);
    if (key->bounds & FW_FROM)
        fw_text_append(out, size,
                       key->bounds & (FW_UP_TO | FW_BELOW) ? " from %.13g" : " of at least %.13g",
                       key->low);
    if (key->bounds & FW_UP_TO)
        fw_text_append(out, size, "%s %.13g", key->bounds & FW_ABOVE ? " and up to" : " to",
                       key->high);
    if (key->bounds & FW_BELOW)
        fw_text_append(out, size, "%s below %.13g", key->bounds & FW_ABOVE ? " and" : " to",
                       key->high);
}

/* "a mapping with 'material', 'shape' and others": what must be in it. */
static void append_mapping(const fw_section *section, char *out, size_t size)
{
    enum { ALTERNATIVES_MAX = 16 };
    fw_text_append(out, size, "a mapping");
    fw_word alternatives[ALTERNATIVES_MAX + 1] = {{NULL, 0}};
    char required[256] = "";
    int count = 0;
    for (const fw_key *key = fw_section_first(section); key; key = fw_section_next(section, key)) {
        assert(count < ALTERNATIVES_MAX);
        if (key->alternative) alternatives[count++].name = key->name;
        if (key->required)
            fw_text_append(required, sizeof required, "%s%s", *required ? ", " : "", key->name);
    }
    if (*required) fw_text_append(out, size, " with %s", required);
    if (count == 0) return;
    char words[300];
    fw_schema_list_words(alternatives, words, sizeof words);
    fw_text_append(out, size, "%s%s", *required ? " and " : " with ", words);
}

/* Each form in words, for a sentence or, with fewer of them, for the reference. */
static void append_forms(const fw_key *key, unsigned forms, bool sentence, char *out, size_t size)
{
    static const struct {
        unsigned form;
        const char *words;
    } simple[] = {{FW_FORM_TEXT, "a text"},
                  {FW_FORM_NAME, "a name"},
                  {FW_FORM_FLAG, "true or false"},
                  {FW_FORM_NUMBER, "a number"},
                  {FW_FORM_ANGLE, "an angle"},
                  {FW_FORM_INTEGER, "a whole number"},
                  {FW_FORM_PATH, "a name, or names with dots between them"}};
    if (forms == FW_FORM_SELECTION) {
        fw_text_append(out, size, "%s",
                       sentence ? "all, a side, [[i, j], ...] or a mapping" : "a selection");
        return;
    }
    char bounds[80], words[300];
    list_bounds(key, bounds, sizeof bounds);
    const char *join = "";
    for (size_t n = 0; n < sizeof simple / sizeof simple[0]; ++n)
        if (forms & simple[n].form) {
            bool bounded = simple[n].form & (FW_FORM_NUMBER | FW_FORM_ANGLE | FW_FORM_INTEGER);
            fw_text_append(out, size, "%s%s%s", join, simple[n].words, bounded ? bounds : "");
            if (simple[n].form == FW_FORM_ANGLE && sentence) fw_text_append(out, size, " degrees");
            join = " or ";
        }
    if (forms & FW_FORM_WORD) {
        fw_schema_list_words(key->words, words, sizeof words);
        fw_text_append(out, size, "%s%s", join, words);
        join = " or ";
    }
    if (forms & (FW_FORM_NUMBERS | FW_FORM_INTEGERS)) {
        fw_text_append(out, size, "%s%s, each a %snumber%s", join, key->layout,
                       forms & FW_FORM_INTEGERS ? "whole " : "", bounds);
        join = " or ";
    }
    if (forms & FW_FORM_SYMMETRIC) {
        fw_text_append(out, size, "%sa number%s, [xx, xy, yy] or [[xx, xy], [xy, yy]]", join,
                       bounds);
        join = " or ";
    }
    if (forms & (FW_FORM_POINT | FW_FORM_CONSTANTS)) {
        fw_text_append(out, size, "%snames with a number each", join);
        join = " or ";
    }
    if (forms & FW_FORM_LIST) {
        fw_text_append(out, size, "%sa list of items, each ", join);
        append_forms(key, key->items, sentence, out, size);
        join = ", or ";
    }
    if (forms & FW_FORM_MAPPING) {
        fw_text_append(out, size, "%s", join);
        if (sentence)
            append_mapping(key->subsection, out, size);
        else
            fw_text_append(out, size, "keys of *%s*", key->subsection->heading);
    }
    if (forms & FW_FORM_NAMED) {
        fw_text_append(out, size, "%snames of your own, each with ", join);
        append_forms(key, FW_FORM_MAPPING, sentence, out, size);
    }
}

void fw_schema_expected(const fw_key *key, char *out, size_t size)
{
    out[0] = '\0';
    append_forms(key, key->forms, true, out, size);
}

/* --- the reference --- */

static void print_default(const fw_key *key, FILE *out)
{
    if (key->required)
        fputs("*required*", out);
    else if (key->alternative)
        fputs("*one of these*", out);
    else if (key->default_meaning)
        fputs(key->default_meaning, out);
    else if (key->default_value)
        fprintf(out, "`%s`", key->default_value);
}

/* In a table of Markdown a bar would begin the next column. */
static void print_cell(const char *text, FILE *out)
{
    for (; *text; ++text) {
        if (*text == '|') fputc('\\', out);
        fputc(*text, out);
    }
}

static void print_key(const fw_key *key, FILE *out)
{
    char forms[600] = "";
    append_forms(key, key->forms, false, forms, sizeof forms);
    fprintf(out, "| `%s` | %s | %s | ", key->name, forms, key->unit ? key->unit : "");
    print_default(key, out);
    fputs(" | ", out);
    print_cell(key->meaning, out);
    if (key->needs) fprintf(out, "; goes with `%s`", key->needs);
    fputs(" |\n", out);
}

fw_status fw_schema_print(const fw_section *root, FILE *out, fw_error *error)
{
    fprintf(
        out,
        "A scenario is YAML: one document, no anchors, aliases and tags. Lengths, masses and "
        "times are in reduced units. A number is written as `12`, `-0.5` or `2.5e-3`, is "
        "finite and at most %g in size; a whole number has neither point nor exponent and is "
        "at most %g in size (%d for sites); angles and phases are in degrees; a name is a "
        "letter followed by letters, digits, `-` or `_`. In the place of a number a formula "
        "may stand, of the names in `parameters`: `24*A`, `\"max(A, 2)\"` in quotes where it has "
        "commas. Whatever is not in these tables is refused.\n",
        FW_NUMBER_MAX, FW_INTEGER_MAX, FW_COORDINATE_MAX);
    const fw_section *sections[FW_SECTIONS_MAX];
    const int count = fw_schema_sections(root, sections);
    for (int n = 0; n < count; ++n) {
        const fw_section *section = sections[n];
        fprintf(out, "\n### %s\n\n%s\n\n", section->heading, section->meaning);
        fputs("| key | value | unit | default | meaning |\n|---|---|---|---|---|\n", out);
        for (const fw_key *key = fw_section_first(section); key;
             key = fw_section_next(section, key))
            print_key(key, out);
    }
    if (!ferror(out)) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "the reference cannot be written: %s", strerror(errno));
}
