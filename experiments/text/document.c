/* SPDX-License-Identifier: GPL-3.0-or-later */
/* document.c - a tree of nodes and its memory.
 * State: the tree, the texts of --set options, and the blocks of memory that hold them all.
 * Invariant: nothing of a document is freed before the whole. Start reading at struct fw_document;
 * how a text becomes a tree is in document_reader.c. */
#include "experiments/text/document.h"

#include "document_parts.h"
#include "experiments/text/text.h"

#include <assert.h>
#include <stdalign.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

typedef struct block {
    struct block *next;
    size_t used, size;
    alignas(max_align_t) char bytes[];
} block;

typedef struct option {
    struct option *next;
    int number;
    const char *text;
} option;

struct fw_document {
    const char *file;
    fw_node *root;
    option *options; /* the latest first */
    block *blocks;   /* the one in use first */
};

/* --- memory --- */

void *fw_document_allocate(fw_document *document, size_t count, size_t size)
{
    enum { BLOCK_SIZE = 1 << 15 };
    if (size && count > (SIZE_MAX >> 2) / size) return NULL;
    size_t alignment = alignof(max_align_t);
    size_t wanted = (count * size + alignment - 1) / alignment * alignment;
    block *in_use = document->blocks;
    if (!in_use || in_use->size - in_use->used < wanted) {
        size_t room = wanted > BLOCK_SIZE ? wanted : BLOCK_SIZE;
        block *fresh = calloc(1, sizeof *fresh + room);
        if (!fresh) return NULL;
        fresh->size = room;
        /* A large piece has a block to itself; the one in use still has room for small ones. */
        if (in_use && wanted > BLOCK_SIZE / 4) {
            fresh->next = in_use->next;
            in_use->next = fresh;
        } else {
            fresh->next = in_use;
            document->blocks = fresh;
        }
        in_use = fresh;
    }
    void *piece = in_use->bytes + in_use->used;
    in_use->used += wanted;
    return piece;
}

const char *fw_document_copy(fw_document *document, const char *text, size_t length)
{
    char *copy = fw_document_allocate(document, length + 1, 1);
    if (copy) memcpy(copy, text, length);
    return copy;
}

void fw_document_destroy(fw_document *document)
{
    if (!document) return;
    for (block *next, *at = document->blocks; at; at = next) {
        next = at->next;
        free(at);
    }
    free(document);
}

/* --- sentences --- */

/* What sentences call a text without a file. */
static const char UNWRITTEN[] = "a scenario";

fw_status fw_document_fail(const fw_document *document, fw_place place, fw_error *error,
                           const char *format, ...)
{
    fw_error unwanted;
    if (!error) error = &unwanted;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->sentence, sizeof error->sentence, format, arguments);
    va_end(arguments);
    error->status = FW_BAD_INPUT;
    if (place.setting == 0 && (!document->file || place.line == 0)) return error->status;
    if (place.setting == 0)
        return fw_fail_within(error, "%s:%d:%d", document->file, place.line, place.column);
    const option *given = document->options;
    for (; given->number != place.setting; given = given->next) assert(given->next);
    return fw_fail_within(error, "--set %s", fw_text_quote(given->text, strlen(given->text)).text);
}

fw_status fw_document_fail_memory(const fw_document *document, fw_error *error)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory to read %s",
                   fw_document_file(document));
}

/* --- documents --- */

fw_status fw_document_create(fw_document **document, const char *file, fw_error *error)
{
    *document = calloc(1, sizeof **document);
    if (*document && file) (*document)->file = fw_document_copy(*document, file, strlen(file));
    if (*document && (!file || (*document)->file)) return FW_OK;
    fw_document_destroy(*document);
    *document = NULL;
    return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory to read %s",
                   file ? file : UNWRITTEN);
}

void fw_document_set_root(fw_document *document, fw_node *root)
{
    document->root = root;
}

fw_status fw_document_add_option(fw_document *document, const char *text, int *number,
                                 fw_error *error)
{
    option *fresh = fw_document_allocate(document, 1, sizeof *fresh);
    if (!fresh) return fw_document_fail_memory(document, error);
    fresh->text = fw_document_copy(document, text, strlen(text));
    if (!fresh->text) return fw_document_fail_memory(document, error);
    fresh->number = document->options ? document->options->number + 1 : 1;
    fresh->next = document->options;
    document->options = fresh;
    *number = fresh->number;
    return FW_OK;
}

/* --- copies --- */

/* No deeper than FW_DOCUMENT_DEPTH. NULL without memory. */
static fw_node *clone_node(fw_document *document, const fw_node *node)
{
    fw_node *clone = fw_document_allocate(document, 1, sizeof *clone);
    if (!clone) return NULL;
    *clone = (fw_node){.kind = node->kind,
                       .place = node->place,
                       .key_place = node->key_place,
                       .length = node->length,
                       .quoted = node->quoted};
    if (node->key) clone->key = fw_document_copy(document, node->key, strlen(node->key));
    if (node->text) clone->text = fw_document_copy(document, node->text, node->length);
    if (node->formula)
        clone->formula = fw_document_copy(document, node->formula, strlen(node->formula));
    if ((node->key && !clone->key) || (node->text && !clone->text)) return NULL;
    if (node->formula && !clone->formula) return NULL;
    for (const fw_node *child = node->first; child; child = child->next) {
        fw_node *copy = clone_node(document, child);
        if (!copy) return NULL;
        fw_node_append(clone, copy);
    }
    return clone;
}

static bool clone_options(fw_document *document, const option *options)
{
    option **end = &document->options;
    for (const option *given = options; given; given = given->next) {
        option *copy = fw_document_allocate(document, 1, sizeof *copy);
        if (!copy) return false;
        copy->number = given->number;
        copy->text = fw_document_copy(document, given->text, strlen(given->text));
        *end = copy;
        end = &copy->next;
        if (!copy->text) return false;
    }
    return true;
}

fw_status fw_document_clone(fw_document **clone, const fw_document *document, fw_error *error)
{
    FW_TRY(fw_document_create(clone, document->file, error));
    (*clone)->root = clone_node(*clone, document->root);
    if ((*clone)->root && clone_options(*clone, document->options)) return FW_OK;
    fw_document_destroy(*clone);
    *clone = NULL;
    return fw_document_fail_memory(document, error);
}

/* --- nodes --- */

fw_node *fw_document_root(const fw_document *document)
{
    return document->root;
}

const char *fw_document_file(const fw_document *document)
{
    return document->file ? document->file : UNWRITTEN;
}

const char *fw_node_written(const fw_node *scalar)
{
    return scalar->formula ? scalar->formula : scalar->text;
}

fw_node *fw_node_find(const fw_node *mapping, const char *key)
{
    if (mapping->kind != FW_MAPPING) return NULL;
    for (fw_node *child = mapping->first; child; child = child->next)
        if (!strcmp(child->key, key)) return child;
    return NULL;
}

void fw_node_append(fw_node *parent, fw_node *child)
{
    assert(parent->kind != FW_SCALAR && !child->next);
    if (parent->last)
        parent->last->next = child;
    else
        parent->first = child;
    parent->last = child;
    parent->count += 1;
}

void fw_node_remove(fw_node *parent, const fw_node *child)
{
    fw_node *before = NULL;
    for (fw_node *at = parent->first; at != child; at = at->next) before = at;
    if (before)
        before->next = child->next;
    else
        parent->first = child->next;
    if (parent->last == child) parent->last = before;
    parent->count -= 1;
}
