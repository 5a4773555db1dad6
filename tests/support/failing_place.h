/* SPDX-License-Identifier: GPL-3.0-or-later */
/* failing_place.h - where in a program something fails, for what is loaded before the C library
 * (LD_PRELOAD). The place (place.h) with number FW_FAIL_AT is wanted. When it is reached the file
 * FW_FAILED tells who called (for `addr2line -f -e PROGRAM`). Other
 * programs, which it starts, are left alone, and so is what the compiler lets it do at its end (the
 * counters of tests/coverage).
 *
 * State: which place is wanted. */
#ifndef FW_FAILING_PLACE_H
#define FW_FAILING_PLACE_H

#include "place.h"

#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { DEPTH = 4 };

static long wanted;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static __thread bool inside;

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
    const char *number = getenv("FW_FAIL_AT");
    inside = true;
    begin_places();
    inside = false;
    wanted = number && is_fretwork() ? atol(number) : 0;
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
    const bool reached = add_place(place_now(kind, DEPTH)) && place_count == wanted;
    pthread_mutex_unlock(&lock);
    if (reached) tell_who();
    inside = false;
    return reached;
}

#endif
