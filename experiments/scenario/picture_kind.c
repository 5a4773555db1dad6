/* SPDX-License-Identifier: GPL-3.0-or-later */
/* picture_kind.c - the rows of picture_kind.h as a table. Keeps no state. */
#include "experiments/scenario/picture_kind.h"

#include <string.h>

#define TABLE_ROW(id, draw, name, meaning, keys, needs, frames, field)                             \
    {name, meaning, keys, needs, frames, field},
const fw_picture_row fw_picture_rows[FW_PICTURE_KINDS] = {FW_PICTURE_ROWS(TABLE_ROW)};

bool fw_picture_reads(fw_picture_kind kind, const char *key)
{
    const size_t length = strlen(key);
    if (strcmp(key, "kind") == 0 || strcmp(key, "title") == 0) return true;
    for (const char *word = fw_picture_rows[kind].keys; *word;) {
        const size_t size = strcspn(word, " ");
        if (size == length && memcmp(word, key, length) == 0) return true;
        word += size + (word[size] == ' ');
    }
    return false;
}
