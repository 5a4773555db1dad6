/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_quantities.c - what can be measured, recorded and expected: all of it, one by name, or
 * what speaks of words. Keeps no state. Start reading at fw_command_quantities(). */
#include "experiments/commands/command.h"
#include "experiments/measures/quantity.h"
#include "experiments/setup/solids.h"
#include "experiments/text/json.h"
#include "experiments/text/spelling.h"
#include "lookup.h"

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

typedef struct wanted {
    const fw_arguments *arguments;
    const char *name; /* exactly that; NULL: all that speaks of the words */
} wanted;

/* `models`: whose it is; NULL: any body's. */
static bool is_wanted(const wanted *w, const char *name, const char *meaning, const char *models)
{
    const char *const texts[] = {name, meaning, models};
    return w->name ? strcmp(name, w->name) == 0 : fw_lookup_fits(w->arguments, texts, 3);
}

/* A field of one group: those of each model's solids, and at last those of contact. */
typedef struct listed_field {
    const char *name, *unit, *meaning; /* NULL: there are no more */
    const char *of;
    const char *model; /* NULL: any */
} listed_field;
enum { FIELD_GROUPS = FW_MATERIAL_KINDS + 1 };

static listed_field field_at(int group, int n)
{
    if (group == FW_MATERIAL_KINDS) {
        const fw_contact_field *field = &fw_contact_fields[n];
        return (listed_field){field->name, field->unit, field->meaning, "whatever body is rubbed",
                              NULL};
    }
    const fw_solid_model *model = model_at(group);
    const fw_field *field = &model->fields[n];
    return (listed_field){field->name, field->unit, field->meaning, model->name, model->name};
}

/* The quantities that the words look up; FW_BAD_INPUT where there are none. */
static fw_status choose(wanted *w, const fw_arguments *arguments, fw_error *error)
{
    const char *word = arguments->word_count == 1 ? arguments->words[0] : "";
    fw_suggestion suggestion = fw_suggestion_begin(word);
    bool named = false, found = false;
    *w = (wanted){arguments, NULL};
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q)) {
        named |= strcmp(q->name, word) == 0;
        found |= is_wanted(w, q->name, q->meaning, q->model);
        fw_suggestion_offer(&suggestion, q->name);
    }
    listed_field field;
    for (int g = 0; g < FIELD_GROUPS; ++g)
        for (int n = 0; (field = field_at(g, n)).name; ++n) {
            named |= strcmp(field.name, word) == 0;
            found |= is_wanted(w, field.name, field.meaning, field.model);
            fw_suggestion_offer(&suggestion, field.name);
        }
    if (named) w->name = word;
    if (named || found) return FW_OK;
    const fw_quote quote = fw_lookup_quote(arguments);
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT,
                       "there is no quantity and no field '%s'; did you mean '%s'?", quote.text,
                       suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "there is no quantity and no field '%s', and none speaks of it; expected one of "
                   "`fretwork quantities`",
                   quote.text);
}

/* {quantities: [{name, of, components: [...], unit, meaning, models}],
 *  fields: [{name, model, unit, meaning}]}; model(s) null: any; no components: a number. */
static void write_json(const wanted *w)
{
    fw_json json = {.out = stdout};
    fw_json_begin(&json, NULL, '{');
    fw_json_begin(&json, "quantities", '[');
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q)) {
        if (!is_wanted(w, q->name, q->meaning, q->model)) continue;
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
    listed_field field;
    for (int g = 0; g < FIELD_GROUPS; ++g)
        for (int n = 0; (field = field_at(g, n)).name; ++n) {
            if (!is_wanted(w, field.name, field.meaning, field.model)) continue;
            fw_json_begin(&json, NULL, '{');
            fw_json_text(&json, "name", field.name);
            fw_json_text(&json, "model", field.model);
            fw_json_text(&json, "unit", field.unit);
            fw_json_text(&json, "meaning", field.meaning);
            fw_json_end(&json, '}');
        }
    fw_json_end(&json, ']');
    fw_json_end(&json, '}');
}

static const char *article_of(const listed_field *field)
{
    return !field->model ? "" : strchr("aeiou", field->of[0]) ? "an " : "a ";
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
    listed_field field;
    for (int g = 0; g < FIELD_GROUPS; ++g)
        for (int n = 0; (field = field_at(g, n)).name; ++n)
            if (strcmp(field.name, word) == 0)
                printf("%s, a field of %s%s%s: %s\n  %-12s %s\n", word, article_of(&field),
                       field.of, field.model ? " solid" : "", field.meaning, "unit", field.unit);
}

static void print_table(const wanted *w)
{
    bool begun = false;
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q)) {
        if (!is_wanted(w, q->name, q->meaning, q->model)) continue;
        if (!begun)
            printf("Quantities (measure, expect.quantity, plot --observable):\n"
                   "  %-20s %-14s %-12s %-16s %s\n",
                   "name", "measured of", "components", "unit", "meaning");
        begun = true;
        printf("  %-20s %-14s %-12s %-16s %s\n", q->name, scopes[q->scope],
               q->components[0] ? q->components : "-", q->unit, q->meaning);
    }
    listed_field field;
    for (int g = 0; g < FIELD_GROUPS; ++g) {
        bool named = false;
        for (int n = 0; (field = field_at(g, n)).name; ++n) {
            if (!is_wanted(w, field.name, field.meaning, field.model)) continue;
            if (!named)
                printf("%sFields of %s%s%s (record.fields, plot --field):\n", begun ? "\n" : "",
                       article_of(&field), field.of, field.model ? " solid" : "");
            begun = named = true;
            printf("  %-20s %-16s %s\n", field.name, field.unit, field.meaning);
        }
    }
}

fw_status fw_command_quantities(const fw_arguments *arguments, fw_error *error)
{
    wanted w;
    FW_TRY(choose(&w, arguments, error));
    if (arguments->json)
        write_json(&w);
    else if (w.name)
        print_one(w.name);
    else
        print_table(&w);
    return FW_OK;
}
