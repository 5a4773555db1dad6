/* SPDX-License-Identifier: GPL-3.0-or-later */
/* markup.c - cuts a line of text into runs.
 * Keeps no state. Start reading at fw_markup_take(). */
#include "experiments/text/markup.h"

#include <stdbool.h>
#include <string.h>

/* Length of the character at `text`: 1 to 4 bytes, or 0 where it is no UTF-8. Cairo would refuse
 * the whole picture for one wrong byte. */
static int character_length(const char *text)
{
    const unsigned char *bytes = (const unsigned char *)text;
    int length = bytes[0] < 0x80   ? 1
                 : bytes[0] < 0xc2 ? 0
                 : bytes[0] < 0xe0 ? 2
                 : bytes[0] < 0xf0 ? 3
                 : bytes[0] < 0xf5 ? 4
                                   : 0;
    for (int k = 1; k < length; ++k) {
        if ((bytes[k] & 0xc0) != 0x80) return 0;
    }
    if (bytes[0] == 0xe0 && bytes[1] < 0xa0) return 0;
    if (bytes[0] == 0xed && bytes[1] > 0x9f) return 0; /* halves of surrogate pairs */
    if (bytes[0] == 0xf0 && bytes[1] < 0x90) return 0;
    if (bytes[0] == 0xf4 && bytes[1] > 0x8f) return 0;
    return length;
}

void fw_markup_take(const char **text, int *level, char run[FW_MARKUP_RUN])
{
    size_t used = 0;
    const char *at = *text;
    while (*at && used + 5 < FW_MARKUP_RUN) {
        bool opens = *level == 0 && (*at == '^' || *at == '_') && at[1] == '{';
        bool closes = *level != 0 && *at == '}';
        if (opens || closes) {
            if (used > 0) break;
            *level = closes ? 0 : *at == '^' ? 1 : -1;
            at += closes ? 1 : 2;
            continue;
        }
        int length = character_length(at);
        if (length == 0 || (unsigned char)*at < ' ') {
            run[used++] = length == 0 ? '?' : ' ';
            at += 1;
        } else {
            memcpy(run + used, at, (size_t)length);
            used += (size_t)length;
            at += length;
        }
    }
    run[used] = '\0';
    *text = at;
}
