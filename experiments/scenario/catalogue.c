/* SPDX-License-Identifier: GPL-3.0-or-later */
/* catalogue.c - looks names up in the catalogue. Keeps no state. */
#include "experiments/scenario/catalogue.h"

#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <string.h>

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
