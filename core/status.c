/* SPDX-License-Identifier: GPL-3.0-or-later */
/* status.c - sentences of failures. Keeps no state. */
#include "core/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

fw_status fw_fail(fw_error *error, fw_status status, const char *format, ...)
{
    if (error) {
        va_list arguments;
        va_start(arguments, format);
        error->status = status;
        vsnprintf(error->sentence, sizeof error->sentence, format, arguments);
        va_end(arguments);
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

/* As much of the text as there is room for. */
static void append(fw_error *error, const char *text)
{
    size_t used = strlen(error->sentence), length = strlen(text);
    size_t room = sizeof error->sentence - 1 - used;
    if (length > room) length = room;
    memcpy(error->sentence + used, text, length);
    error->sentence[used + length] = '\0';
}

fw_status fw_fail_within(fw_error *error, const char *format, ...)
{
    char sentence[FW_SENTENCE_SIZE];
    memcpy(sentence, error->sentence, sizeof sentence);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->sentence, sizeof error->sentence, format, arguments);
    va_end(arguments);
    append(error, ": ");
    append(error, sentence);
    return error->status;
}
