/* SPDX-License-Identifier: GPL-3.0-or-later */
/* arena.h - many arrays, as all of one body, in one piece of memory.
 *
 * Arrays that are allocated one by one start at the same place of a page when they are large, and a
 * loop over a dozen of them meets itself in a single set of the nearest cache: the LB solid's step
 * takes 3 to 5 times as long. In an arena each array starts STAGGER bytes further into its page
 * than the one before, and their common size is known before anything is allocated. A cache line
 * before each array and one behind it belong to nobody: kernels may read and write there, and treat
 * the ends of arrays like all the rest.
 *
 * Use: add every array, then allocate. Until then the pointers are untouched; after a failure they
 * are all NULL.
 *
 * Public, since a solid's head has one; may change. */
#ifndef FW_ARENA_H
#define FW_ARENA_H

#include "core/public.h"
#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

FW_PUBLIC_BEGIN

typedef struct fw_arena_array {
    void *pointer; /* to the pointer that is set */
    size_t bytes;
} fw_arena_array;

enum { FW_ARENA_CAPACITY = 96 };
typedef struct fw_arena {
    int count;
    fw_arena_array array[FW_ARENA_CAPACITY];
    size_t bytes; /* of all arrays and the gaps between them; SIZE_MAX: more than there can be */
    void *block;  /* as allocated */
    char *memory; /* from the first page on; NULL before fw_arena_allocate */
} fw_arena;

/* `pointer` is the address of a pointer to elements of that size; it must live as long as the
 * arena. A full arena is a programmer's mistake. */
void fw_arena_add(fw_arena *arena, void *pointer, size_t count, size_t element_size);
#define FW_ARENA_ADD(arena, member, count) fw_arena_add(arena, &(member), count, sizeof *(member))

/* Zeroed memory for all of them, each on a 64-byte boundary; a count of zero gives a valid pointer.
 * FW_SYSTEM_FAILED: "not enough memory for `what` (so many MB)". */
fw_status fw_arena_allocate(fw_arena *arena, const char *what, fw_error *error);
/* Legal at any time, also for an arena of zeros. */
void fw_arena_release(fw_arena *arena);

FW_PUBLIC_END

#endif
