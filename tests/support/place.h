/* SPDX-License-Identifier: GPL-3.0-or-later */
/* place.h - where in a program something is asked for. A place is what the program's own functions,
 * a few calls deep, stand at; places are numbered as they appear.
 *
 * State: the places seen so far. */
#ifndef FW_PLACE_H
#define FW_PLACE_H

#include <execinfo.h>
#include <link.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* The program's own functions lie deep below those of the libraries that they call. */
enum { PLACES_MAX = 1 << 15, FRAMES = 64 };

static uint64_t place[PLACES_MAX]; /* a hash table of places; 0: free */
static long place_count;
static uintptr_t text_base, text_begin, text_end;

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

/* To be called first: the first call loads what it needs. */
static void begin_places(void)
{
    void *frame[1];
    backtrace(frame, 1);
    dl_iterate_phdr(find_text, NULL);
}

/* Of `depth` functions; `kind` tells apart what is called for from one place. */
static uint64_t place_now(uint64_t kind, int depth)
{
    void *frame[FRAMES];
    uint64_t hash = 0x9e3779b97f4a7c15 + kind;
    const int count = backtrace(frame, FRAMES);
    for (int k = 0, own = 0; k < count && own < depth; ++k) {
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

#endif
