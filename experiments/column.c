/* SPDX-License-Identifier: GPL-3.0-or-later */
/* column.c - which observables a list of names means. Keeps no state. Start reading at
 * fw_columns_find(). */
#include "experiments/column.h"

#include "experiments/quantity.h"
#include "experiments/spelling.h"

#include <stdlib.h>
#include <string.h>

/* A piece of a text. */
typedef struct piece {
    const char *text;
    size_t length;
} piece;

static bool equals(piece name, const char *text, size_t length)
{
    return name.length == length && memcmp(name.text, text, length) == 0;
}

/* "momentum.sheet" is the momentum of sheet. */
static const fw_quantity *quantity_of(const char *label)
{
    char quantity[FW_NAME_SIZE];
    snprintf(quantity, sizeof quantity, "%.*s", (int)strcspn(label, "."), label);
    return fw_quantity_find(quantity);
}

static bool is_called(piece name, const char *label)
{
    return equals(name, label, strlen(label)) || equals(name, label, strcspn(label, "."));
}

/* Does the name mean this observable? *component: which one of it, or -1: all. */
static bool is_meant(piece name, const fw_playback_observable *observable, int *component)
{
    const fw_quantity *quantity = quantity_of(observable->name);
    *component = -1;
    if (is_called(name, observable->name)) return true;
    size_t dot = name.length;
    while (dot > 0 && name.text[dot - 1] != '.') --dot;
    if (!quantity || dot == 0 || !is_called((piece){name.text, dot - 1}, observable->name))
        return false;
    char part[16];
    snprintf(part, sizeof part, "%.*s", (int)(name.length - dot), name.text + dot);
    *component = fw_quantity_find_component(quantity, part);
    return *component >= 0 && *component < observable->components;
}

static void add_column(const fw_playback *playback, int observable, int component,
                       fw_column *columns, int *count)
{
    const fw_playback_observable *of = &playback->observables[observable];
    const fw_quantity *quantity = quantity_of(of->name);
    char part[16];
    for (int n = 0; n < *count; ++n)
        if (columns[n].observable == observable && columns[n].component == component) return;
    fw_column *added = &columns[(*count)++];
    *added = (fw_column){.observable = observable, .component = component};
    if (quantity && fw_quantity_component_count(quantity) == of->components)
        fw_quantity_component_name(quantity, component, part);
    else
        snprintf(part, sizeof part, "%d", component + 1);
    snprintf(added->name, sizeof added->name, "%s%s%s", of->name, of->components > 1 ? "." : "",
             of->components > 1 ? part : "");
}

static fw_status refuse(const fw_playback *playback, const char *directory, piece name,
                        fw_error *error)
{
    char word[FW_NAME_SIZE], known[512] = "";
    snprintf(word, sizeof word, "%.*s", (int)name.length, name.text);
    if (name.length == 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "--observable has an empty name, expected names parted by commas");
    if (fw_quantity_find(word))
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: %s was not measured; to have it, name it under measure and run again",
                       directory, word);
    fw_guess guess = fw_guess_begin(word);
    for (int n = 0; n < playback->observable_count; ++n) {
        const char *label = playback->observables[n].name;
        fw_guess_offer(&guess, label);
        size_t used = strlen(known);
        snprintf(known + used, sizeof known - used, "%s%s", n > 0 ? ", " : "", label);
    }
    if (guess.best)
        return fw_fail(error, FW_BAD_INPUT, "%s has no observable %s; did you mean %s?", directory,
                       word, guess.best);
    return fw_fail(error, FW_BAD_INPUT, "%s has no observable %s, expected one of %s", directory,
                   word, known);
}

/* Length of the name at the head of a list; a site as in "position.sheet[0,3]" is part of it. */
static size_t name_length(const char *list)
{
    size_t length = 0;
    for (bool site = false; list[length] && (list[length] != ',' || site); ++length) {
        if (list[length] == '[') site = true;
        if (list[length] == ']') site = false;
    }
    return length;
}

static int add_meant(const fw_playback *playback, piece name, fw_column *columns, int *count)
{
    int found = 0, component;
    for (int o = 0; o < playback->observable_count; ++o) {
        if (!is_meant(name, &playback->observables[o], &component)) continue;
        found += 1;
        for (int c = 0; c < playback->observables[o].components; ++c)
            if (component < 0 || component == c) add_column(playback, o, c, columns, count);
    }
    return found;
}

fw_status fw_columns_find(const fw_playback *playback, const char *directory, const char *names,
                          fw_column **columns, int *count, fw_error *error)
{
    size_t most = 1;
    *count = 0;
    for (int o = 0; o < playback->observable_count; ++o)
        most += (size_t)playback->observables[o].components;
    *columns = calloc(most, sizeof **columns);
    if (!*columns) return fw_fail_memory(error, "the columns of a table");
    for (int o = 0; !names && o < playback->observable_count; ++o)
        for (int c = 0; c < playback->observables[o].components; ++c)
            add_column(playback, o, c, *columns, count);
    for (const char *at = names; at;) {
        piece name = {at, name_length(at)};
        if (add_meant(playback, name, *columns, count) == 0)
            return refuse(playback, directory, name, error);
        at = at[name.length] ? at + name.length + 1 : NULL;
    }
    return FW_OK;
}
