/* SPDX-License-Identifier: GPL-3.0-or-later */
/* text.h - bytes from outside: is it text, and how to quote a piece of it in a sentence. */
#ifndef FW_TEXT_H
#define FW_TEXT_H

#include <stddef.h>
#include <stdio.h>

/* What is wrong with bytes that should be UTF-8 text, and where. */
typedef struct fw_text_fault {
    const char *what; /* NULL: nothing */
    int line, column; /* of characters, from 1 */
    unsigned code;    /* the byte or character */
} fw_text_fault;

/* The first byte that is not valid UTF-8, or character that no text holds: control characters
 * other than tab and line ends, and the rarer line ends, which editors count differently. */
fw_text_fault fw_text_check(const char *text, size_t length);

/* Bytes of the UTF-8 character at the head of a text that is not empty; 0 where there is none. */
size_t fw_text_character(const char *text, size_t length);

enum { FW_QUOTE_SIZE = 64 };

/* A piece of text for use in a sentence: on one line, cut with "..." where it is too long. */
typedef struct fw_quote {
    char text[FW_QUOTE_SIZE];
} fw_quote;
fw_quote fw_text_quote(const char *text, size_t length);

/* Writes behind what `text` holds already, in a room of `size` bytes; what has no room is cut. */
void fw_text_append(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The first line of *text, ended in place of its line end, and *text goes behind it; NULL when
 * there is no whole line left. */
char *fw_text_line(char **text);

/* Writes a text from outside where somebody may read it on a terminal: control characters, among
 * them those that turn the direction of writing, and bytes that are not UTF-8 are shown as \x1B or
 * \u202E instead of being obeyed. Tabs and line ends stay. */
void fw_text_print(FILE *out, const char *text);
/* The same on one line: tabs and line ends become blanks. */
void fw_text_print_line(FILE *out, const char *text);

#endif
