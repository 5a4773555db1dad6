/* SPDX-License-Identifier: GPL-3.0-or-later */
/* array.h - memory for numbers, and the named arrays that make up a state.
 * Everything that changes while a scene runs is named once in a state list; checkpoints, hashes,
 * output and tests walk that list, so that none of them can forget a field.
 *
 * Public, but may change. */
#ifndef FW_ARRAY_H
#define FW_ARRAY_H

#include "core/public.h"

#include <stddef.h>
#include <stdint.h>

FW_PUBLIC_BEGIN

typedef enum fw_element { FW_F64, FW_I32, FW_I64, FW_U8 } fw_element;

/* A view of memory that somebody else owns; valid until its owner changes shape or is destroyed. */
typedef struct fw_array {
    const char *name; /* unique in its list: "position-x", "field-east-x" */
    fw_element element;
    size_t count; /* elements, not bytes */
    void *data;
} fw_array;

/* The state of one object. Filled by the object, walked by everybody. */
enum { FW_STATE_CAPACITY = 64 };
typedef struct fw_state_list {
    int count;
    fw_array array[FW_STATE_CAPACITY];
} fw_state_list;

/* Appends one array; a full list is a programmer's mistake. */
void fw_state_list_add(fw_state_list *list, const char *name, fw_element element, size_t count,
                       void *data);

size_t fw_element_size(fw_element element);

/* Zeroed memory on a 64-byte boundary, so that vector loads never straddle cache lines. NULL when
 * there is none; a count of zero gives a valid pointer. Freed with free(). */
void *fw_array_allocate(size_t count, size_t element_size);
double *fw_array_of_doubles(size_t count);
/* The same on the boundary of malloc(): sooner there where it is large, and what is not touched
 * takes no memory. */
void *fw_array_zeroed(size_t count, size_t element_size);
/* Large memory that nobody has touched yet is to come in large pages where the system has them:
 * they are there sooner, and found sooner. */
void fw_array_ask_for_large_pages(void *memory, size_t bytes);
/* The size of the pages that so much memory is asked for in. The header of malloc() before it comes
 * in a small page, and with that whatever lies in the same large one. */
size_t fw_array_page(size_t bytes);

/* 64-bit FNV-1a over the bytes of all arrays, in list order. */
uint64_t fw_state_list_hash(const fw_state_list *list);

/* Sum in a fixed order that does not depend on threads: blocks of 1024, then the blocks. */
double fw_array_sum(const double *values, size_t count);
/* Goes on with such a sum: what came before was FW_SUM_RUN values, or that several times. So values
 * that are made as they are summed need no more memory than that. */
enum { FW_SUM_RUN = 4096 };
double fw_array_sum_on(double sum, const double *values, size_t count);

FW_PUBLIC_END

#endif
