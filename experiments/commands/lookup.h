/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lookup.h - what list, quantities and reference look up where no name is given exactly: entries
 * that contain all words of the command line. */
#ifndef FW_LOOKUP_H
#define FW_LOOKUP_H

#include "experiments/commands/option.h"
#include "experiments/text/text.h"

/* Does each word stand in one of the texts, whatever its capitals? Texts may be NULL; an empty word
 * stands in none. */
bool fw_lookup_fits(const fw_arguments *arguments, const char *const *texts, int text_count);

/* The words as one piece of text, for a refusal. */
fw_quote fw_lookup_quote(const fw_arguments *arguments);

#endif
