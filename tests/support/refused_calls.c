/* SPDX-License-Identifier: GPL-3.0-or-later */
/* refused_calls.c - what a test named *_refused_calls calls of the system, put before the C library
 * by the linker (--wrap).
 * State: which call is refused, and how many of its kind there still are before it. */
#include "tests/support/refused_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

static atomic_int wanted, left;
static int with;

void refuse_call(refused_call kind, int which, int reason)
{
    with = reason;
    left = which;
    wanted = (int)kind;
}

bool call_was_refused(void)
{
    const bool refused = wanted == REFUSED_NONE;
    wanted = REFUSED_NONE;
    return refused;
}

static bool is_refused(refused_call kind)
{
    if (wanted != (int)kind || --left > 0) return false;
    wanted = REFUSED_NONE;
    errno = with > 0 ? with : 0;
    return true;
}

/* How many of `count` bytes move; -1: the call fails. */
static ssize_t part_of(size_t count)
{
    return with == BY_HALF ? (ssize_t)(count / 2) : with == NOTHING_MOVES ? 0 : -1;
}

int __real_open(const char *name, int flags, ...);
int __wrap_open(const char *name, int flags, ...);
int __wrap_open(const char *name, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const int mode = flags & O_CREAT ? va_arg(rest, int) : 0;
    va_end(rest);
    return is_refused(REFUSED_OPEN) ? -1 : __real_open(name, flags, mode);
}

int __real_fstat(int descriptor, struct stat *facts);
int __wrap_fstat(int descriptor, struct stat *facts);
int __wrap_fstat(int descriptor, struct stat *facts)
{
    return is_refused(REFUSED_FSTAT) ? -1 : __real_fstat(descriptor, facts);
}

ssize_t __real_read(int descriptor, void *bytes, size_t count);
ssize_t __wrap_read(int descriptor, void *bytes, size_t count);
ssize_t __wrap_read(int descriptor, void *bytes, size_t count)
{
    if (!is_refused(REFUSED_READ)) return __real_read(descriptor, bytes, count);
    return part_of(count) > 0 ? __real_read(descriptor, bytes, count / 2) : part_of(count);
}

ssize_t __real_pread(int descriptor, void *bytes, size_t count, off_t at);
ssize_t __wrap_pread(int descriptor, void *bytes, size_t count, off_t at);
ssize_t __wrap_pread(int descriptor, void *bytes, size_t count, off_t at)
{
    if (!is_refused(REFUSED_PREAD)) return __real_pread(descriptor, bytes, count, at);
    return part_of(count) > 0 ? __real_pread(descriptor, bytes, count / 2, at) : part_of(count);
}

ssize_t __real_pwrite(int descriptor, const void *bytes, size_t count, off_t at);
ssize_t __wrap_pwrite(int descriptor, const void *bytes, size_t count, off_t at);
ssize_t __wrap_pwrite(int descriptor, const void *bytes, size_t count, off_t at)
{
    if (!is_refused(REFUSED_PWRITE)) return __real_pwrite(descriptor, bytes, count, at);
    return part_of(count) > 0 ? __real_pwrite(descriptor, bytes, count / 2, at) : part_of(count);
}

/* Of a file that ends sooner than it should. */
size_t __real_fread(void *bytes, size_t size, size_t count, FILE *stream);
size_t __wrap_fread(void *bytes, size_t size, size_t count, FILE *stream);
size_t __wrap_fread(void *bytes, size_t size, size_t count, FILE *stream)
{
    return __real_fread(bytes, size, is_refused(REFUSED_FREAD) ? count / 2 : count, stream);
}

int __real_fsync(int descriptor);
int __wrap_fsync(int descriptor);
int __wrap_fsync(int descriptor)
{
    return is_refused(REFUSED_FSYNC) ? -1 : __real_fsync(descriptor);
}

int __real_flock(int descriptor, int operation);
int __wrap_flock(int descriptor, int operation);
int __wrap_flock(int descriptor, int operation)
{
    return is_refused(REFUSED_FLOCK) ? -1 : __real_flock(descriptor, operation);
}

int __real_access(const char *name, int mode);
int __wrap_access(const char *name, int mode);
int __wrap_access(const char *name, int mode)
{
    return is_refused(REFUSED_ACCESS) ? -1 : __real_access(name, mode);
}

int __real_fclose(FILE *stream);
int __wrap_fclose(FILE *stream);
int __wrap_fclose(FILE *stream)
{
    const bool refused = is_refused(REFUSED_FCLOSE);
    const int reason = errno, status = __real_fclose(stream);
    errno = reason;
    return refused ? EOF : status;
}
