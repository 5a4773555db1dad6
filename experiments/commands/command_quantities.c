/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_quantities.c - what can be measured, recorded and expected: all of it, or one by name.
 * Keeps no state. Start reading at fw_command_quantities(). */
#include "experiments/commands/command.h"
#include "experiments/measures/quantity.h"
#include "experiments/setup/solids.h"
#include "experiments/text/json.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <string.h>

static const char *const scopes[] = {
    [FW_SCOPE_SCENE] = "scene",       [FW_SCOPE_BODIES] = "body or scene",
    [FW_SCOPE_BODY] = "body",         [FW_SCOPE_SITE] = "site",
    [FW_SCOPE_WALL] = "wall",         [FW_SCOPE_PISTON] = "piston",
    [FW_SCOPE_GRIP] = "grip",         [FW_SCOPE_STUDY] = "study",
    [FW_SCOPE_ANALYSIS] = "analysis",
};

static const fw_solid_model *model_at(int kind)
{
    return fw_solid_kind_at((fw_material_kind)kind)->model;
}

/* NULL: all of them. */
static bool is_wanted(const char *name, const char *word)
{
    return !word || strcmp(name, word) == 0;
}

static fw_status check_word(const char *word, fw_error *error)
{
    if (!word) return FW_OK;
    const char *first = NULL; /* that has the word in its name or meaning */
    fw_suggestion suggestion = fw_suggestion_begin(word);
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q)) {
        if (strcmp(q->name, word) == 0) return FW_OK;
        fw_suggestion_offer(&suggestion, q->name);
        if (!first && (strstr(q->name, word) || strstr(q->meaning, word))) first = q->name;
    }
    for (int m = 0; m < FW_MATERIAL_KINDS; ++m)
        for (const fw_field *field = model_at(m)->fields; field->name; ++field) {
            if (strcmp(field->name, word) == 0) return FW_OK;
            fw_suggestion_offer(&suggestion, field->name);
        }
    const fw_quote quote = fw_text_quote(word, strlen(word));
    if (!suggestion.best && first && word[0])
        return fw_fail(error, FW_BAD_INPUT,
                       "there is no quantity and no field '%s'; %s is one that speaks of it, "
                       "`fretwork quantities | grep %s` shows all",
                       quote.text, first, quote.text);
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT,
                       "there is no quantity and no field '%s'; did you mean '%s'?", quote.text,
                       suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "there is no quantity and no field '%s', expected one of `fretwork quantities`",
                   quote.text);
}

/* {quantities: [{name, of, components: [...], unit, meaning, models}],
 *  fields: [{name, model, meaning}]}; models null: any; no components: a number. */
static void write_json(const char *word)
{
    fw_json json = {.out = stdout};
    fw_json_begin(&json, NULL, '{');
    fw_json_begin(&json, "quantities", '[');
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q)) {
        if (!is_wanted(q->name, word)) continue;
        fw_json_begin(&json, NULL, '{');
        fw_json_text(&json, "name", q->name);
        fw_json_text(&json, "of", scopes[q->scope]);
        fw_json_begin(&json, "components", '[');
        for (int c = 0; q->components[0] && c < fw_quantity_component_count(q); ++c) {
            char name[8];
            fw_quantity_component_name(q, c, name);
            fw_json_text(&json, NULL, name);
        }
        fw_json_end(&json, ']');
        fw_json_text(&json, "unit", q->unit);
        fw_json_text(&json, "meaning", q->meaning);
        fw_json_text(&json, "models", q->model);
        fw_json_end(&json, '}');
    }
    fw_json_end(&json, ']');
    fw_json_begin(&json, "fields", '[');
    for (int m = 0; m < FW_MATERIAL_KINDS; ++m)
        for (const fw_field *field = model_at(m)->fields; field->name; ++field) {
            if (!is_wanted(field->name, word)) continue;
            fw_json_begin(&json, NULL, '{');
            fw_json_text(&json, "name", field->name);
            fw_json_text(&json, "model", model_at(m)->name);
            fw_json_text(&json, "meaning", field->meaning);
            fw_json_end(&json, '}');
        }
    fw_json_end(&json, ']');
    fw_json_end(&json, '}');
}

static void print_one(const char *word)
{
    const fw_quantity *q = fw_quantity_find(word);
    if (q) {
        printf("%s: %s\n", q->name, q->meaning);
        printf("  %-12s %s\n  %-12s %s\n  %-12s %s\n", "measured of", scopes[q->scope],
               "components", q->components[0] ? q->components : "-", "unit", q->unit);
        if (q->model) printf("  %-12s %s\n", "models", q->model);
    }
    for (int m = 0; m < FW_MATERIAL_KINDS; ++m)
        for (const fw_field *field = model_at(m)->fields; field->name; ++field)
            if (strcmp(field->name, word) == 0)
                printf("%s, a field of a %s solid: %s\n", word, model_at(m)->name, field->meaning);
}

static void print_all(void)
{
    printf("Quantities (measure, expect.quantity, plot --observable):\n");
    printf("  %-20s %-14s %-12s %-16s %s\n", "name", "measured of", "components", "unit",
           "meaning");
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q))
        printf("  %-20s %-14s %-12s %-16s %s\n", q->name, scopes[q->scope],
               q->components[0] ? q->components : "-", q->unit, q->meaning);
    for (int m = 0; m < FW_MATERIAL_KINDS; ++m) {
        printf("\nFields of a %s solid (record.fields, plot --field):\n", model_at(m)->name);
        for (const fw_field *field = model_at(m)->fields; field->name; ++field)
            printf("  %-20s %s\n", field->name, field->meaning);
    }
}

fw_status fw_command_quantities(const fw_arguments *arguments, fw_error *error)
{
    const char *word = arguments->word_count > 0 ? arguments->words[0] : NULL;
    FW_TRY(check_word(word, error));
    if (arguments->json)
        write_json(word);
    else if (word)
        print_one(word);
    else
        print_all();
    return FW_OK;
}
