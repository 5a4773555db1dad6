/* SPDX-License-Identifier: GPL-3.0-or-later */
/* array.c - aligned memory, state lists, sums in a fixed order. Keeps no state. */
#include "core/array.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { ALIGNMENT = 64, ABREAST = 4, BLOCK = FW_SUM_RUN / ABREAST, LARGE_PAGE = 1 << 21 };

void fw_state_list_add(fw_state_list *list, const char *name, fw_element element, size_t count,
                       void *data)
{
    assert(list->count < FW_STATE_CAPACITY);
    list->array[list->count++] = (fw_array){name, element, count, data};
}

size_t fw_element_size(fw_element element)
{
    switch (element) {
    case FW_F64:
    case FW_I64:
        return 8;
    case FW_I32:
        return 4;
    case FW_U8:
        return 1;
    }
    return 0;
}

void fw_array_ask_for_large_pages(void *memory, size_t bytes)
{
#if defined(MADV_HUGEPAGE)
    if (bytes < 2 * LARGE_PAGE) return;
    const size_t page = (size_t)sysconf(_SC_PAGESIZE),
                 gap = (page - (uintptr_t)memory % page) % page;
    /* Where the system does not want to, pages stay small. */
    (void)madvise((char *)memory + gap, bytes - gap, MADV_HUGEPAGE);
#else
    (void)memory;
    (void)bytes;
#endif
}

size_t fw_array_page(size_t bytes)
{
    return bytes < 2 * LARGE_PAGE ? (size_t)sysconf(_SC_PAGESIZE) : LARGE_PAGE;
}

void *fw_array_allocate(size_t count, size_t element_size)
{
    if (element_size != 0 && count > (SIZE_MAX / 2) / element_size) return NULL;
    size_t bytes = (count * element_size + ALIGNMENT) / ALIGNMENT * ALIGNMENT;
    void *memory = aligned_alloc(ALIGNMENT, bytes);
    if (!memory) return NULL;
    fw_array_ask_for_large_pages(memory, bytes);
    memset(memory, 0, bytes);
    return memory;
}

void *fw_array_zeroed(size_t count, size_t element_size)
{
    void *memory = calloc(count + 1, element_size);
    if (memory) fw_array_ask_for_large_pages(memory, count * element_size);
    return memory;
}

double *fw_array_of_doubles(size_t count)
{
    return fw_array_allocate(count, sizeof(double));
}

uint64_t fw_state_list_hash(const fw_state_list *list)
{
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < list->count; ++i) {
        const unsigned char *byte = list->array[i].data;
        size_t bytes = list->array[i].count * fw_element_size(list->array[i].element);
        for (size_t b = 0; b < bytes; ++b) hash = (hash ^ byte[b]) * 1099511628211u;
    }
    return hash;
}

/* Each block is summed from its first value to its last. A processor waits for every addition of
 * such a chain, so four blocks are summed side by side. */
static void sum_blocks(const double *values, double sums[ABREAST])
{
    double a = 0, b = 0, c = 0, d = 0;
    for (size_t i = 0; i < BLOCK; ++i) {
        a += values[i];
        b += values[BLOCK + i];
        c += values[2 * BLOCK + i];
        d += values[3 * BLOCK + i];
    }
    sums[0] = a;
    sums[1] = b;
    sums[2] = c;
    sums[3] = d;
}

double fw_array_sum(const double *values, size_t count)
{
    return fw_array_sum_on(0, values, count);
}

double fw_array_sum_on(double total, const double *values, size_t count)
{
    size_t begin = 0;
    for (; begin + ABREAST * BLOCK <= count; begin += ABREAST * BLOCK) {
        double sums[ABREAST];
        sum_blocks(values + begin, sums);
        for (int k = 0; k < ABREAST; ++k) total += sums[k];
    }
    for (; begin < count; begin += BLOCK) {
        size_t end = begin + BLOCK < count ? begin + BLOCK : count;
        double block = 0;
        for (size_t i = begin; i < end; ++i) block += values[i];
        total += block;
    }
    return total;
}
