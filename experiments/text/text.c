/* SPDX-License-Identifier: GPL-3.0-or-later */
/* text.c - UTF-8, by the table of well-formed sequences (Unicode 15, table 3-7). Keeps no state. */
#include "experiments/text/text.h"

#include <stdarg.h>
#include <stdbool.h>
#include <string.h>

static bool continues(unsigned char byte)
{
    return (byte & 0xC0) == 0x80;
}

/* Length of the well-formed sequence at `text`, 0 if there is none. */
static size_t read_character(const unsigned char *text, size_t length, unsigned *code)
{
    static const unsigned least[5] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned char first = text[0];
    if (first < 0x80) {
        *code = first;
        return 1;
    }
    size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || size > length) return 0;
    unsigned value = first & (0xFFu >> (size + 1));
    for (size_t n = 1; n < size; ++n) {
        if (!continues(text[n])) return 0;
        value = value << 6 | (text[n] & 0x3Fu);
    }
    bool surrogate = value >= 0xD800 && value <= 0xDFFF;
    if (value < least[size] || value > 0x10FFFF || surrogate) return 0;
    *code = value;
    return size;
}

size_t fw_text_character(const char *text, size_t length)
{
    unsigned code;
    return read_character((const unsigned char *)text, length, &code);
}

static bool is_unprintable(unsigned code)
{
    if (code < 0x20) return code != '\t' && code != '\n' && code != '\r';
    if (code >= 0x7F && code < 0xA0) return true;
    return code == 0x2028 || code == 0x2029 || code == 0xFEFF || code == 0xFFFE || code == 0xFFFF;
}

fw_text_fault fw_text_check(const char *text, size_t length)
{
    const unsigned char *bytes = (const unsigned char *)text;
    fw_text_fault fault = {.line = 1, .column = 1};
    for (size_t at = 0; at < length;) {
        size_t size = read_character(bytes + at, length - at, &fault.code);
        if (size == 0) {
            fault.code = bytes[at];
            fault.what = "a byte that is not UTF-8 text";
            return fault;
        }
        if (is_unprintable(fault.code)) {
            fault.what = "a control character";
            return fault;
        }
        bool line_end = fault.code == '\n' ||
                        (fault.code == '\r' && !(at + 1 < length && text[at + 1] == '\n'));
        fault.line += line_end;
        fault.column = line_end ? 1 : fault.column + 1;
        at += size;
    }
    return fault;
}

fw_quote fw_text_quote(const char *text, size_t length)
{
    fw_quote quote;
    size_t room = FW_QUOTE_SIZE - sizeof "...", used = 0;
    bool cut = length > room;
    if (cut) {
        length = room;
        /* Not in the middle of a character. */
        while (length > 0 && continues((unsigned char)text[length])) --length;
    }
    for (; used < length; ++used) {
        unsigned char byte = (unsigned char)text[used];
        quote.text[used] = byte < 0x20 || byte == 0x7F ? ' ' : (char)byte;
    }
    if (cut) {
        memcpy(quote.text + used, "...", 3);
        used += 3;
    }
    quote.text[used] = '\0';
    return quote;
}

void fw_text_append(char *text, size_t size, const char *format, ...)
{
    const size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

char *fw_text_line(char **text)
{
    char *line = *text, *end = line ? strchr(line, '\n') : NULL;
    if (!end) return NULL;
    *end = '\0';
    *text = end + 1;
    return line;
}

/* --- for terminals --- */

static bool turns_direction(unsigned code)
{
    return code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

static void print(FILE *out, const char *text, bool one_line)
{
    const unsigned char *at = (const unsigned char *)text;
    for (size_t length = strlen(text), size; length > 0; at += size, length -= size) {
        unsigned code;
        size = read_character(at, length, &code);
        if (size == 0) {
            fprintf(out, "\\x%02X", *at);
            size = 1;
        } else if (code == '\n' || code == '\t') {
            fputc(one_line ? ' ' : (int)code, out);
        } else if (code == '\r' || is_unprintable(code) || turns_direction(code)) {
            fprintf(out, code < 0x100 ? "\\x%02X" : "\\u%04X", code);
        } else {
            fwrite(at, 1, size, out);
        }
    }
}

void fw_text_print(FILE *out, const char *text)
{
    print(out, text, false);
}

void fw_text_print_line(FILE *out, const char *text)
{
    print(out, text, true);
}
