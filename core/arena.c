/* SPDX-License-Identifier: GPL-3.0-or-later */
/* arena.c - one allocation for many arrays, staggered within their pages. State: fw_arena, the
 * caller's. Start reading at start_of(). */
#include "core/arena.h"

#include "core/array.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* STAGGER is an odd number of cache lines: 64 arrays in a row start in 64 different sets. */
enum { LINE = 64, PAGE = 4096, STAGGER = 5 * LINE };

/* Where array number `index` begins, if everything before it ends at `end`. */
static size_t start_of(size_t end, int index)
{
    const size_t wanted = (size_t)index * STAGGER % PAGE, free = end + LINE;
    return free + (PAGE + wanted - free % PAGE) % PAGE;
}

void fw_arena_add(fw_arena *arena, void *pointer, size_t count, size_t element_size)
{
    assert(arena->count < FW_ARENA_CAPACITY && !arena->memory);
    const bool fits = arena->bytes < SIZE_MAX / 4 && count <= SIZE_MAX / 4 / element_size;
    const size_t bytes = fits ? count * element_size : 0;
    arena->bytes = fits ? start_of(arena->bytes, arena->count) + bytes : SIZE_MAX;
    arena->array[arena->count++] = (fw_arena_array){pointer, bytes};
}

static void set(const fw_arena_array *array, void *address)
{
    memcpy(array->pointer, &address, sizeof address);
}

fw_status fw_arena_allocate(fw_arena *arena, const char *what, fw_error *error)
{
    assert(!arena->memory);
    /* Arrays begin with the first whole page behind malloc()'s header. */
    const size_t page = fw_array_page(arena->bytes);
    const size_t bytes = ((arena->bytes + LINE) / PAGE + 1) * PAGE + page;
    /* Large memory of calloc() is zero before it is touched: what nobody needs takes no room. */
    if (arena->bytes < SIZE_MAX / 4) arena->block = calloc(bytes, 1);
    if (!arena->block) {
        for (int n = 0; n < arena->count; ++n) set(&arena->array[n], NULL);
        return fw_fail(error, FW_SYSTEM_FAILED, "not enough memory for %s (%.0f MB)", what,
                       (double)arena->bytes * 1e-6);
    }
    fw_array_ask_for_large_pages(arena->block, bytes);
    arena->memory = (char *)arena->block + (page - (uintptr_t)arena->block % page);
    size_t end = 0;
    for (int n = 0; n < arena->count; ++n) {
        const size_t start = start_of(end, n);
        set(&arena->array[n], arena->memory + start);
        end = start + arena->array[n].bytes;
    }
    return FW_OK;
}

void fw_arena_release(fw_arena *arena)
{
    if (!arena->memory) return;
    free(arena->block);
    for (int n = 0; n < arena->count; ++n) set(&arena->array[n], NULL);
    *arena = (fw_arena){0};
}
