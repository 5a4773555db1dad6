/* SPDX-License-Identifier: GPL-3.0-or-later */
/* column.c - which observables names mean. Keeps no state. Start reading at fw_columns_find(). */
#include "experiments/measures/column.h"

#include "experiments/measures/quantity.h"
#include "experiments/text/spelling.h"

#include <stdlib.h>
#include <string.h>

static bool equals(const char *name, size_t length, const char *text, size_t text_length)
{
    return length == text_length && memcmp(name, text, length) == 0;
}

/* "momentum.sheet" is the momentum of sheet. */
static const fw_quantity *quantity_of(const char *label)
{
    char quantity[FW_NAME_SIZE];
    snprintf(quantity, sizeof quantity, "%.*s", (int)strcspn(label, "."), label);
    return fw_quantity_find(quantity);
}

static bool is_called(const char *name, size_t length, const char *label)
{
    return equals(name, length, label, strlen(label)) ||
           equals(name, length, label, strcspn(label, "."));
}

/* Does the name mean this observable? *component: which one of it, or -1: all. */
static bool is_meant(const char *name, const fw_playback_observable *observable, int *component)
{
    const fw_quantity *quantity = quantity_of(observable->name);
    const char *dot = strrchr(name, '.');
    *component = -1;
    if (is_called(name, strlen(name), observable->name)) return true;
    if (!quantity || !dot || !is_called(name, (size_t)(dot - name), observable->name)) return false;
    *component = fw_quantity_find_component(quantity, dot + 1);
    return *component >= 0 && *component < observable->components;
}

static void add_column(const fw_playback *playback, int observable, int component,
                       fw_column *columns, int *count)
{
    const fw_playback_observable *of = &playback->observables[observable];
    const fw_quantity *quantity = quantity_of(of->name);
    for (int n = 0; n < *count; ++n)
        if (columns[n].observable == observable && columns[n].component == component) return;
    fw_column *added = &columns[(*count)++];
    *added = (fw_column){.observable = observable, .component = component};
    if (of->components == 1) return;
    if (quantity && fw_quantity_component_count(quantity) == of->components)
        fw_quantity_component_name(quantity, component, added->part);
    else
        snprintf(added->part, sizeof added->part, "%d", component + 1);
}

static fw_status refuse(const fw_playback *playback, const char *directory, const char *name,
                        fw_error *error)
{
    char known[512] = "";
    if (fw_quantity_find(name))
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: %s was not measured; to have it, name it under measure and run again",
                       directory, name);
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (int n = 0; n < playback->observable_count; ++n) {
        const char *label = playback->observables[n].name;
        fw_suggestion_offer(&suggestion, label);
        size_t used = strlen(known);
        snprintf(known + used, sizeof known - used, "%s%s", n > 0 ? ", " : "", label);
    }
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "%s has no observable %s; did you mean %s?", directory,
                       name, suggestion.best);
    return fw_fail(error, FW_BAD_INPUT, "%s has no observable %s, expected one of %s", directory,
                   name, known);
}

static bool add_meant(const fw_playback *playback, const char *name, fw_column *columns, int *count)
{
    bool found = false;
    int component;
    for (int o = 0; o < playback->observable_count; ++o) {
        if (!is_meant(name, &playback->observables[o], &component)) continue;
        found = true;
        for (int c = 0; c < playback->observables[o].components; ++c)
            if (component < 0 || component == c) add_column(playback, o, c, columns, count);
    }
    return found;
}

fw_status fw_columns_find(const fw_playback *playback, const char *directory,
                          const char *const *names, int name_count, fw_column **columns, int *count,
                          fw_error *error)
{
    size_t most = 1;
    *count = 0;
    for (int o = 0; o < playback->observable_count; ++o)
        most += (size_t)playback->observables[o].components;
    *columns = calloc(most, sizeof **columns);
    if (!*columns) return fw_fail_memory(error, "what is shown of a result");
    for (int o = 0; !names && o < playback->observable_count; ++o)
        for (int c = 0; c < playback->observables[o].components; ++c)
            add_column(playback, o, c, *columns, count);
    for (int n = 0; names && n < name_count; ++n)
        if (!add_meant(playback, names[n], *columns, count))
            return refuse(playback, directory, names[n], error);
    return FW_OK;
}

void fw_column_name(const fw_playback *playback, const fw_column *column, char name[FW_COLUMN_NAME])
{
    snprintf(name, FW_COLUMN_NAME, "%s%s%s", playback->observables[column->observable].name,
             column->part[0] ? "." : "", column->part);
}

static size_t name_length(const char *list)
{
    size_t length = 0;
    for (bool site = false; list[length] && (list[length] != ',' || site); ++length) {
        if (list[length] == '[') site = true;
        if (list[length] == ']') site = false;
    }
    return length;
}

fw_status fw_column_names_read(const char *list, char **text, const char ***names, int *count,
                               fw_error *error)
{
    *text = NULL;
    *names = NULL;
    *count = 0;
    if (!list) return FW_OK;
    *text = strdup(list);
    *names = calloc(strlen(list) + 1, sizeof **names); /* more than enough */
    if (!*text || !*names) return fw_fail_memory(error, "the names of observables");
    for (char *name = *text;;) {
        size_t length = name_length(name);
        bool last = name[length] == '\0';
        if (length == 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "--observable %s, expected names with commas between them", list);
        name[length] = '\0';
        (*names)[(*count)++] = name;
        if (last) return FW_OK;
        name += length + 1;
    }
}
