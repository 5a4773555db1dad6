/* SPDX-License-Identifier: GPL-3.0-or-later */
/* document.h - a text in the subset of YAML that scenarios are written in, as a tree of nodes.
 *
 * Strict: one document, no anchors and aliases, no tags, no key twice, valid UTF-8, at most
 * FW_DOCUMENT_BYTES long and FW_DOCUMENT_DEPTH deep. Every node has the place where it was written,
 * so that whoever finds fault with it can say the line. All memory of a document lives until it is
 * destroyed, and goes at once. */
#ifndef FW_DOCUMENT_H
#define FW_DOCUMENT_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum {
    FW_DOCUMENT_BYTES = 16 << 20,
    FW_DOCUMENT_NODES = 1 << 20,
    FW_DOCUMENT_DEPTH = 24,
    FW_NAME_BYTES = 64 /* of a key, and so of the name of a body or wall */
};

/* Where something was written: line and column from 1; or `setting` > 0, the number of the --set
 * option on the command line that wrote it. All zero: nowhere in the document. */
typedef struct fw_place {
    int line, column;
    int setting;
} fw_place;

typedef enum fw_node_kind { FW_SCALAR, FW_LIST, FW_MAPPING } fw_node_kind;

typedef struct fw_node fw_node;
struct fw_node {
    fw_node_kind kind;
    fw_place place;      /* of the value */
    const char *key;     /* in a mapping: the key; NULL in a list and for the root */
    fw_place key_place;  /* of the key, or of the value where there is no key */
    const char *text;    /* of a scalar, without quotes */
    size_t length;       /* of text, in bytes */
    bool quoted;         /* "1" is a text, 1 a number */
    const char *formula; /* what was written where text is its value; NULL: text was */
    int count;           /* children of a list or mapping */
    fw_node *first;      /* in the order of writing */
    fw_node *last;
    fw_node *next; /* sibling */
};

typedef struct fw_document fw_document;

/* Reads `length` bytes. `file` is what sentences call it; copied. NULL: nobody wrote the text, and
 * sentences about it name no place but --set options. On failure *document is NULL: FW_BAD_INPUT
 * with "FILE:LINE:COLUMN: ..." */
fw_status fw_document_parse(fw_document **document, const char *file, const char *text,
                            size_t length, fw_error *error);
/* The same for a file on disk. FW_BAD_INPUT also where it cannot be read. */
fw_status fw_document_load(fw_document **document, const char *path, fw_error *error);
void fw_document_destroy(fw_document *document);
/* The same tree with the same places, to be changed by itself. FW_SYSTEM_FAILED without memory. */
fw_status fw_document_clone(fw_document **clone, const fw_document *document, fw_error *error);

/* Reads the value that a --set option gives; sentences about it will name `option`. The node is
 * the document's, but not yet in its tree. */
fw_status fw_document_parse_value(fw_document *document, const char *option, const char *text,
                                  fw_node **value, fw_error *error);

fw_node *fw_document_root(const fw_document *document);
const char *fw_document_file(const fw_document *document);

/* What was written: the formula, or the text, of a scalar. */
const char *fw_node_written(const fw_node *scalar);
/* The child of that key, or NULL. */
fw_node *fw_node_find(const fw_node *mapping, const char *key);
/* Makes `child`, which has no parent yet, the last one. */
void fw_node_append(fw_node *parent, fw_node *child);

/* Takes `child`, which is one of them, out of the children of `parent`. */
void fw_node_remove(fw_node *parent, const fw_node *child);

/* Zeroed memory that lives as long as the document; NULL when there is none. */
void *fw_document_allocate(fw_document *document, size_t count, size_t size);
/* A copy of the text with a '\0' behind it; NULL when there is no memory. */
const char *fw_document_copy(fw_document *document, const char *text, size_t length);
/* FW_SYSTEM_FAILED: no memory to read this document. */
fw_status fw_document_fail_memory(const fw_document *document, fw_error *error);

/* Writes the tree as YAML that parses to the same tree: places differ, and a text may come out in
 * quotes. Where formulas are written their values stand behind them, as comments of their lines.
 * FW_SYSTEM_FAILED where `out` cannot be written. */
fw_status fw_document_print(const fw_document *document, FILE *out, fw_error *error);

/* FW_BAD_INPUT with "FILE:LINE:COLUMN: sentence", or "--set OPTION: sentence" for what a --set
 * option wrote; the sentence alone where the text has no file, or the place is nowhere. */
fw_status fw_document_fail(const fw_document *document, fw_place place, fw_error *error,
                           const char *format, ...) __attribute__((format(printf, 4, 5)));

#endif
