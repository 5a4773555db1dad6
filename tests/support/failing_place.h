/* SPDX-License-Identifier: GPL-3.0-or-later */
/* failing_place.h - where in a program something fails, for what is loaded before the C library
 * (LD_PRELOAD). A place is what the program's own functions, a few calls deep, stood at when they
 * called; places are numbered as they appear, and the one with number FW_FAIL_AT is wanted. When it
 * is reached the file FW_FAILED tells who called (for `addr2line -f -e PROGRAM`). Other
 * programs, which it starts, are left alone, and so is what the compiler lets it do at its end (the
 * counters of tests/coverage).
 *
 * State: the places seen so far. */
#ifndef FW_FAILING_PLACE_H
#define FW_FAILING_PLACE_H

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

/* The program's own functions lie deep below those of the libraries that they call. */
enum { PLACES_MAX = 1 << 15, DEPTH = 4, FRAMES = 64 };

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

static bool is_fretwork(void)
{
    char path[1024];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
    path[length > 0 ? length : 0] = '\0';
    const char *slash = strrchr(path, '/');
    return slash && strcmp(slash + 1, "fretwork") == 0;
}

__attribute__((constructor)) static void begin(void)
{
    void *frame[1];
    const char *number = getenv("FW_FAIL_AT");
    inside = true;
    backtrace(frame, 1); /* loads what it needs */
    dl_iterate_phdr(find_text, NULL);
    inside = false;
    wanted = number && is_fretwork() ? atol(number) : 0;
}

/* `kind` tells apart what is called for from one place. */
static uint64_t place_now(uint64_t kind)
{
    void *frame[FRAMES];
    uint64_t hash = 0x9e3779b97f4a7c15 + kind;
    const int count = backtrace(frame, FRAMES);
    for (int k = 0, own = 0; k < count && own < DEPTH; ++k) {
        if (!is_program(frame[k])) continue;
        hash = (hash ^ ((uintptr_t)frame[k] - text_begin)) * 0xff51afd7ed558ccd;
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

static void stop(void)
{
    wanted = 0;
}

/* What is registered last is called first: here, in the midst of the program, before what it does
 * at its end. */
static void stop_at_end(void)
{
    static bool registered;
    if (!registered) registered = atexit(stop) == 0;
}

/* Is the program for the first time at the place that is wanted? */
static bool is_wanted(uint64_t kind)
{
    if (inside || wanted <= 0) return false;
    inside = true;
    pthread_mutex_lock(&lock);
    stop_at_end();
    const bool reached = add_place(place_now(kind)) && place_count == wanted;
    pthread_mutex_unlock(&lock);
    if (reached) tell_who();
    inside = false;
    return reached;
}

#endif
