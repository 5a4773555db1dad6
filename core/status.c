/* SPDX-License-Identifier: GPL-3.0-or-later */
/* status.c - sentences of failures. Keeps no state. */
#include "core/status.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* A byte in the middle of a letter of UTF-8. */
static bool continues(char byte)
{
    return ((unsigned char)byte & 0xc0) == 0x80;
}

/* A text that is too long loses its middle, which is that of a long path: the end has the reason.
 */
static void keep_both_ends(char sentence[FW_SENTENCE_SIZE], const char *text)
{
    static const char gap[] = "[...]";
    const size_t length = strlen(text), room = FW_SENTENCE_SIZE - 1;
    if (length <= room) {
        memcpy(sentence, text, length + 1);
        return;
    }
    size_t head = (room - strlen(gap)) / 2, tail = length - (room - strlen(gap) - head);
    while (head > 0 && continues(text[head])) --head;
    while (continues(text[tail])) ++tail;
    snprintf(sentence, FW_SENTENCE_SIZE, "%.*s%s%s", (int)head, text, gap, text + tail);
}

/* Longer than any path and what is said of it. */
enum { LONGEST = 4 * 4096 };

fw_status fw_fail(fw_error *error, fw_status status, const char *format, ...)
{
    if (error) {
        char text[LONGEST];
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(text, sizeof text, format, arguments);
        va_end(arguments);
        error->status = status;
        keep_both_ends(error->sentence, text);
    }
    return status;
}

fw_status fw_fail_memory(fw_error *error, const char *what)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory for %s", what);
}

fw_status fw_fail_impossible(fw_error *error, const char *what)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "%s: a mistake in the program itself, please report it",
                   what);
}

fw_status fw_fail_within(fw_error *error, const char *format, ...)
{
    if (!error) return FW_SYSTEM_FAILED;
    char prefix[LONGEST], text[LONGEST + FW_SENTENCE_SIZE + 2];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(prefix, sizeof prefix, format, arguments);
    va_end(arguments);
    snprintf(text, sizeof text, "%s: %s", prefix, error->sentence);
    keep_both_ends(error->sentence, text);
    return error->status;
}
