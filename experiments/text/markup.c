/* SPDX-License-Identifier: GPL-3.0-or-later */
/* markup.c - cuts a line of text into runs.
 * Keeps no state. Start reading at fw_markup_take(). */
#include "experiments/text/markup.h"

#include "experiments/text/text.h"

#include <stdbool.h>
#include <string.h>

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
        /* Cairo would refuse the whole picture for one wrong byte. */
        const size_t length = fw_text_character(at, strlen(at));
        if (length == 0 || (unsigned char)*at < ' ') {
            run[used++] = length == 0 ? '?' : ' ';
            at += 1;
        } else {
            memcpy(run + used, at, length);
            used += length;
            at += length;
        }
    }
    run[used] = '\0';
    *text = at;
}
