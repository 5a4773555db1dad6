/* SPDX-License-Identifier: GPL-3.0-or-later */
/* substitution.c - goes through a setting part by part. Keeps no state. Start reading at
 * fw_substitution_write(). */
#include "experiments/text/substitution.h"

#include "experiments/text/number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static bool ends_key(const char *at)
{
    return *at == ':' && (at[1] == '\0' || is_blank(at[1]));
}

/* Bytes to the end of the part that begins there: commas in parentheses are a function's. */
static size_t part_length(const char *text)
{
    int depth = 0;
    const char *at = text;
    for (; *at; ++at) {
        if (*at == '(') depth += 1;
        if (*at == ')') depth -= 1;
        if (depth <= 0 && (strchr(",[]{}'\"", *at) || ends_key(at))) break;
    }
    while (at > text && is_blank(at[-1])) --at;
    return (size_t)(at - text);
}

static bool names_variable(const char *part, size_t length, const fw_variable *variables, int count,
                           bool *used)
{
    bool any = false;
    for (size_t at = 0; at < length;) {
        const int number = fw_formula_find(part, length, at, variables, count, &at);
        if (number < 0) break;
        if (used) used[number] = true;
        any = true;
    }
    return any;
}

static bool is_key(const char *part, size_t length)
{
    const char *behind = part + length;
    while (is_blank(*behind)) ++behind;
    return ends_key(behind);
}

static fw_status write_value(FILE *out, const char *at, const fw_variable *variables, int count,
                             bool *used, fw_error *error)
{
    while (*at) {
        const size_t length = part_length(at);
        if (is_blank(*at) || length == 0) {
            fputc(*at++, out);
            continue;
        }
        if (!is_key(at, length) && names_variable(at, length, variables, count, used)) {
            char number[FW_NUMBER_TEXT];
            double value;
            FW_TRY(fw_formula_evaluate(at, length, variables, count, &value, error));
            fw_number_write(number, value);
            fputs(number, out);
        } else {
            fwrite(at, 1, length, out);
        }
        at += length;
    }
    return FW_OK;
}

fw_status fw_substitution_write(const char *setting, const fw_variable *variables, int count,
                                char **out, bool *used, fw_error *error)
{
    const char *equals = strchr(setting, '=');
    const size_t head = equals ? (size_t)(equals - setting) + 1 : strlen(setting);
    size_t size;
    *out = NULL;
    FILE *stream = open_memstream(out, &size);
    if (!stream) return fw_fail_memory(error, "a setting");
    fwrite(setting, 1, head, stream);
    fw_status status = write_value(stream, setting + head, variables, count, used, error);
    if (fclose(stream) != 0 && status == FW_OK) status = fw_fail_memory(error, "a setting");
    if (status == FW_OK) return FW_OK;
    free(*out);
    *out = NULL;
    return status;
}
