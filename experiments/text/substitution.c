/* SPDX-License-Identifier: GPL-3.0-or-later */
/* substitution.c - goes through a setting word by word. Keeps no state. */
#include "experiments/text/substitution.h"

#include "experiments/text/number.h"

#include <stdbool.h>
#include <string.h>

static const char word_ends[] = " \t,:[]{}'\"";

size_t fw_substitution_room(size_t length)
{
    return length * FW_NUMBER_TEXT + 1;
}

/* What the parameter is multiplied with in a word that speaks of it. */
static bool find_factor(const char *word, size_t length, const char *parameter, double *factor)
{
    const size_t size = strlen(parameter);
    if (length < size || memcmp(word + length - size, parameter, size) != 0) return false;
    const size_t before = length - size;
    *factor = before == 0 ? 1 : -1;
    if (before == 0 || (before == 1 && word[0] == '-')) return true;
    return word[before - 1] == '*' && fw_number_read(word, before - 1, factor) == FW_NUMBER_FINE;
}

int fw_substitution_write(const char *setting, const char *parameter, double value, char *out)
{
    const char *equals = strchr(setting, '=');
    size_t head = equals ? (size_t)(equals - setting) + 1 : strlen(setting);
    int count = 0;
    memcpy(out, setting, head);
    out += head;
    for (const char *at = setting + head; *at;) {
        double factor;
        size_t length = strcspn(at, word_ends);
        if (length > 0 && at[length] != ':' && find_factor(at, length, parameter, &factor)) {
            fw_number_write(out, factor * value);
            out += strlen(out);
            count += 1;
        } else {
            length += length == 0;
            memcpy(out, at, length);
            out += length;
        }
        at += length;
    }
    *out = '\0';
    return count;
}
