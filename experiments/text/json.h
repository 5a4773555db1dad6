/* SPDX-License-Identifier: GPL-3.0-or-later */
/* json.h - writes JSON (RFC 8259) onto a stream, indented, whatever the texts and numbers are.
 * Objects and lists are begun and ended; everything else is one value. `key` names a value in an
 * object and is NULL in a list and at the root. */
#ifndef FW_JSON_H
#define FW_JSON_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* Start with {.out = stream}. Failures are the stream's. */
typedef struct fw_json {
    FILE *out;
    int depth;
    bool filled; /* the innermost object or list has a value already */
} fw_json;

void fw_json_begin(fw_json *json, const char *key, char bracket); /* '{' or '[' */
void fw_json_end(fw_json *json, char bracket);                    /* '}' or ']' */
/* NULL writes null; bytes that are not UTF-8 come out as U+FFFD. */
void fw_json_text(fw_json *json, const char *key, const char *text);
/* With the digits that give the same double back; null where it is not finite: JSON has no word for
 * that. */
void fw_json_number(fw_json *json, const char *key, double number);
void fw_json_integer(fw_json *json, const char *key, int64_t number);
void fw_json_flag(fw_json *json, const char *key, bool flag);

#endif
