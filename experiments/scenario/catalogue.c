/* SPDX-License-Identifier: GPL-3.0-or-later */
/* catalogue.c - looks names up in the catalogue, and loads what a user names. Keeps no state. */
#include "experiments/scenario/catalogue.h"

#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

fw_status fw_catalogue_find(const fw_catalogue_entry **entry, const char *name, fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (*entry = fw_catalogue; (*entry)->name; ++*entry) {
        if (!strcmp((*entry)->name, name)) return FW_OK;
        fw_suggestion_offer(&suggestion, (*entry)->name);
    }
    *entry = NULL;
    fw_quote found = fw_text_quote(name, strlen(name));
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "there is no experiment '%s'; did you mean '%s'?",
                       found.text, suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "there is no experiment '%s', expected one that `fretwork list` shows, or a "
                   "scenario file",
                   found.text);
}

static bool is_file(const char *word)
{
    size_t length = strlen(word);
    return strchr(word, '/') || (length > 5 && strcasecmp(word + length - 5, ".yaml") == 0) ||
           (length > 4 && strcasecmp(word + length - 4, ".yml") == 0);
}

fw_status fw_catalogue_load(fw_scenario **scenario, const char *word, const char *const *settings,
                            int setting_count, char name[FW_NAME_BYTES + 1], fw_error *error)
{
    *scenario = NULL;
    if (is_file(word)) {
        const char *base = strrchr(word, '/') ? strrchr(word, '/') + 1 : word;
        size_t length = strrchr(base, '.') && strrchr(base, '.') > base
                            ? (size_t)(strrchr(base, '.') - base)
                            : strlen(base);
        snprintf(name, FW_NAME_BYTES + 1, "%.*s", (int)(length < 64 ? length : 64), base);
        const fw_catalogue_entry *entry;
        fw_error own;
        if (access(word, F_OK) != 0 && fw_catalogue_find(&entry, name, &own) == FW_OK &&
            strcmp(entry->name, name) == 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "there is no file %s; the experiment %s is called without .yaml, "
                           "`fretwork show %s > %s` makes the file",
                           word, name, name, word);
        return fw_scenario_load(scenario, word, settings, setting_count, error);
    }
    const fw_catalogue_entry *entry;
    FW_TRY(fw_catalogue_find(&entry, word, error));
    snprintf(name, FW_NAME_BYTES + 1, "%s", entry->name);
    char file[FW_NAME_BYTES + 8];
    snprintf(file, sizeof file, "%s.yaml", entry->name);
    return fw_scenario_read(scenario, file, entry->text, entry->length, settings, setting_count,
                            error);
}
