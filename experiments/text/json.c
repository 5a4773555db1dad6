/* SPDX-License-Identifier: GPL-3.0-or-later */
/* json.c - commas, indentation and escapes. State: fw_json, the caller's. */
#include "experiments/text/json.h"

#include "experiments/text/number.h"
#include "experiments/text/text.h"

#include <math.h>
#include <string.h>

static void write_character(FILE *out, unsigned char c)
{
    if (c == '"' || c == '\\')
        fprintf(out, "\\%c", c);
    else if (c == '\n')
        fputs("\\n", out);
    else if (c == '\t')
        fputs("\\t", out);
    else if (c < 0x20 || c == 0x7F)
        fprintf(out, "\\u%04x", c);
    else
        fputc(c, out);
}

static void write_string(FILE *out, const char *text)
{
    const char *const end = text + strlen(text);
    fputc('"', out);
    while (*text) {
        size_t size = fw_text_character(text, (size_t)(end - text));
        if (size == 0) {
            fputs("\\ufffd", out);
            text += 1;
            continue;
        }
        for (size_t n = 0; n < size; ++n) write_character(out, (unsigned char)text[n]);
        text += size;
    }
    fputc('"', out);
}

/* Comma, line, indentation and key: what comes before every value. */
static void begin_value(fw_json *json, const char *key)
{
    if (json->filled) fputc(',', json->out);
    if (json->depth > 0) fprintf(json->out, "\n%*s", 2 * json->depth, "");
    json->filled = true;
    if (!key) return;
    write_string(json->out, key);
    fputs(": ", json->out);
}

void fw_json_begin(fw_json *json, const char *key, char bracket)
{
    begin_value(json, key);
    fputc(bracket, json->out);
    json->depth += 1;
    json->filled = false;
}

void fw_json_end(fw_json *json, char bracket)
{
    json->depth -= 1;
    if (json->filled) fprintf(json->out, "\n%*s", 2 * json->depth, "");
    fputc(bracket, json->out);
    json->filled = true;
    if (json->depth == 0) fputc('\n', json->out);
}

void fw_json_text(fw_json *json, const char *key, const char *text)
{
    begin_value(json, key);
    if (text)
        write_string(json->out, text);
    else
        fputs("null", json->out);
}

void fw_json_number(fw_json *json, const char *key, double number)
{
    char text[FW_NUMBER_TEXT] = "null";
    begin_value(json, key);
    if (isfinite(number)) fw_number_write(text, number);
    fputs(text, json->out);
}

void fw_json_integer(fw_json *json, const char *key, int64_t number)
{
    begin_value(json, key);
    fprintf(json->out, "%lld", (long long)number);
}

void fw_json_flag(fw_json *json, const char *key, bool flag)
{
    begin_value(json, key);
    fputs(flag ? "true" : "false", json->out);
}
