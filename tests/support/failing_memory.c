/* SPDX-License-Identifier: GPL-3.0-or-later */
/* failing_memory.c - loaded before the C library (LD_PRELOAD), lets one allocation of a program
 * fail: the first at the place number FW_FAIL_AT. A place is what the program's own functions, a
 * few calls deep, stood at when they asked; places are numbered as they appear. When that has
 * happened the file FW_FAILED tells who asked (for `addr2line -f -e PROGRAM`). What libraries ask
 * for themselves does not fail.
 *
 * State: the places seen so far. */
#define _GNU_SOURCE
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void *__libc_malloc(size_t bytes);
void *__libc_calloc(size_t count, size_t bytes);
void *__libc_realloc(void *memory, size_t bytes);
void *__libc_memalign(size_t alignment, size_t bytes);

enum { PLACES_MAX = 1 << 15, DEPTH = 4, FRAMES = 16 };

static uint64_t place[PLACES_MAX]; /* a hash table of places; 0: free */
static long place_count, wanted;
static uintptr_t text_base, text_begin, text_end;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static __thread bool inside;

/* The program itself is the first of all that is loaded. */
static int find_text(struct dl_phdr_info *info, size_t size, void *unused)
{
    (void)size, (void)unused;
    for (int k = 0; k < info->dlpi_phnum; ++k) {
        const uintptr_t from = info->dlpi_addr + info->dlpi_phdr[k].p_vaddr;
        if (info->dlpi_phdr[k].p_type != PT_LOAD || !(info->dlpi_phdr[k].p_flags & PF_X)) continue;
        text_base = info->dlpi_addr;
        text_begin = from;
        text_end = from + info->dlpi_phdr[k].p_memsz;
    }
    return 1;
}

static bool is_program(const void *address)
{
    return (uintptr_t)address >= text_begin && (uintptr_t)address < text_end;
}

__attribute__((constructor)) static void begin(void)
{
    void *frame[1];
    const char *number = getenv("FW_FAIL_AT");
    inside = true;
    backtrace(frame, 1); /* loads what it needs */
    dl_iterate_phdr(find_text, NULL);
    inside = false;
    wanted = number ? atol(number) : 0;
}

static uint64_t place_now(void)
{
    void *frame[FRAMES];
    uint64_t hash = 0x9e3779b97f4a7c15;
    const int count = backtrace(frame, FRAMES);
    for (int k = 0, own = 0; k < count && own < DEPTH; ++k) {
        if (!is_program(frame[k])) continue;
        hash = (hash ^ (uintptr_t)frame[k] - text_begin) * 0xff51afd7ed558ccd;
        hash ^= hash >> 32;
        ++own;
    }
    return hash ? hash : 1;
}

/* Is this place new? */
static bool add_place(uint64_t now)
{
    size_t at = now % PLACES_MAX;
    for (; place[at]; at = (at + 1) % PLACES_MAX)
        if (place[at] == now) return false;
    if (place_count + 1 < PLACES_MAX) place[at] = now;
    ++place_count;
    return true;
}

static void tell_who(void)
{
    void *frame[FRAMES];
    const char *name = getenv("FW_FAILED");
    const int file = name ? open(name, O_WRONLY | O_CREAT | O_CLOEXEC, 0600) : -1;
    if (file < 0) return;
    const int count = backtrace(frame, FRAMES);
    for (int k = 0; k < count; ++k)
        if (is_program(frame[k])) dprintf(file, "%#lx\n", (uintptr_t)frame[k] - text_base);
    close(file);
}

static bool fails(const void *caller)
{
    if (inside || wanted <= 0 || !is_program(caller)) return false;
    inside = true;
    pthread_mutex_lock(&lock);
    const bool failed = add_place(place_now()) && place_count == wanted;
    pthread_mutex_unlock(&lock);
    if (failed) tell_who();
    inside = false;
    return failed;
}

void *malloc(size_t bytes)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_malloc(bytes);
}

void *calloc(size_t count, size_t bytes)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_calloc(count, bytes);
}

void *realloc(void *memory, size_t bytes)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_realloc(memory, bytes);
}

void *aligned_alloc(size_t alignment, size_t bytes)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, bytes);
}

char *strdup(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *copy = fails(__builtin_return_address(0)) ? NULL : __libc_malloc(size);
    return copy ? memcpy(copy, text, size) : NULL;
}

char *strndup(const char *text, size_t most)
{
    const size_t length = strnlen(text, most);
    char *copy = fails(__builtin_return_address(0)) ? NULL : __libc_malloc(length + 1);
    if (!copy) return NULL;
    copy[length] = '\0';
    return memcpy(copy, text, length);
}
