/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lookup.c - words in texts. Keeps no state. */
#include "lookup.h"

#include <string.h>
#include <strings.h>

static bool stands_in(const char *word, const char *text)
{
    const size_t length = strlen(word);
    for (; text && *text && length > 0; ++text)
        if (strncasecmp(text, word, length) == 0) return true;
    return false;
}

bool fw_lookup_fits(const fw_arguments *arguments, const char *const *texts, int text_count)
{
    for (int w = 0; w < arguments->word_count; ++w) {
        bool found = false;
        for (int t = 0; t < text_count; ++t) found |= stands_in(arguments->words[w], texts[t]);
        if (!found) return false;
    }
    return true;
}

fw_quote fw_lookup_quote(const fw_arguments *arguments)
{
    char all[4 * FW_QUOTE_SIZE] = "";
    for (int w = 0; w < arguments->word_count; ++w)
        fw_text_append(all, sizeof all, "%s%s", w > 0 ? " " : "", arguments->words[w]);
    return fw_text_quote(all, strlen(all));
}
