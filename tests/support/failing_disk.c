/* SPDX-License-Identifier: GPL-3.0-or-later */
/* failing_disk.c - loaded before the C library (LD_PRELOAD), lets a program's call to the disk fail
 * with the error number FW_FAIL_WITH: the first at the place number FW_FAIL_AT (failing_place.h).
 * Only files and folders below FW_FAIL_BELOW, and those that the program makes for a while, count.
 * A write that fails has written half of its sectors. ENOSPC is a disk that is full: only calls
 * that want room fail, and from then on all of them do.
 *
 * State: whether the disk is full, and the streams that write through here: those of the C library
 * would call the system past what is loaded before it. */
#define _GNU_SOURCE
#include "failing_place.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>

enum { STREAMS_MAX = 64, PATH_SIZE = PATH_MAX };

typedef enum call { OPEN = 1, MAKE, READ, WRITE, SYNC, RENAME, CUT, LOCK, CLOSE } call;

static struct {
    FILE *stream;
    int descriptor;
} streams[STREAMS_MAX];
static bool full;

static bool is_below(const char *path)
{
    const char *below = getenv("FW_FAIL_BELOW");
    return (below && strncmp(path, below, strlen(below)) == 0) ||
           strncmp(path, "/tmp/fretwork-film-", 19) == 0 ||
           strncmp(path, "/tmp/fretwork-report-", 21) == 0;
}

static void path_of(int descriptor, char path[PATH_SIZE])
{
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = readlink(link, path, PATH_SIZE - 1);
    path[length > 0 ? length : 0] = '\0';
}

static bool is_ours(int descriptor)
{
    char path[PATH_SIZE];
    if (inside || wanted <= 0) return false;
    path_of(descriptor, path);
    return is_below(path);
}

static bool is_our_name(int folder, const char *name)
{
    char start[PATH_SIZE] = "";
    if (inside || wanted <= 0) return false;
    if (name[0] == '/') return is_below(name);
    if (folder != AT_FDCWD)
        path_of(folder, start);
    else if (!getcwd(start, sizeof start))
        return false;
    return is_below(start);
}

/* Of a call to what is ours. */
static bool fails(call kind, bool wants_room)
{
    const char *number = getenv("FW_FAIL_WITH");
    const int reason = number ? atoi(number) : EIO;
    if (reason == ENOSPC && !wants_room) return false;
    if (!full && !is_wanted((uint64_t)kind)) return false;
    full = reason == ENOSPC;
    errno = reason;
    return true;
}

/* Disks write whole sectors. */
static size_t half_of(size_t count)
{
    enum { SECTOR = 512 };
    return count / 2 / SECTOR * SECTOR;
}

/* --- descriptors --- */

int openat(int folder, const char *name, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    if (is_our_name(folder, name) && fails(OPEN, flags & O_CREAT)) return -1;
    return (int)syscall(SYS_openat, folder, name, flags, mode);
}

int open(const char *name, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    if (is_our_name(AT_FDCWD, name) && fails(OPEN, flags & O_CREAT)) return -1;
    return (int)syscall(SYS_openat, AT_FDCWD, name, flags, mode);
}

int close(int descriptor)
{
    const bool written =
        is_ours(descriptor) && (fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY;
    const int status = (int)syscall(SYS_close, descriptor);
    return written && fails(CLOSE, false) ? -1 : status;
}

ssize_t read(int descriptor, void *bytes, size_t count)
{
    if (is_ours(descriptor) && fails(READ, false)) return -1;
    return syscall(SYS_read, descriptor, bytes, count);
}

ssize_t pread(int descriptor, void *bytes, size_t count, off_t at)
{
    if (is_ours(descriptor) && fails(READ, false)) return -1;
    return syscall(SYS_pread64, descriptor, bytes, count, at);
}

ssize_t write(int descriptor, const void *bytes, size_t count)
{
    if (!is_ours(descriptor) || !fails(WRITE, true))
        return syscall(SYS_write, descriptor, bytes, count);
    const int reason = errno;
    syscall(SYS_write, descriptor, bytes, half_of(count));
    errno = reason;
    return -1;
}

ssize_t pwrite(int descriptor, const void *bytes, size_t count, off_t at)
{
    if (!is_ours(descriptor) || !fails(WRITE, true))
        return syscall(SYS_pwrite64, descriptor, bytes, count, at);
    const int reason = errno;
    syscall(SYS_pwrite64, descriptor, bytes, half_of(count), at);
    errno = reason;
    return -1;
}

int fsync(int descriptor)
{
    return is_ours(descriptor) && fails(SYNC, false) ? -1 : (int)syscall(SYS_fsync, descriptor);
}

int flock(int descriptor, int operation)
{
    if (is_ours(descriptor) && fails(LOCK, false)) return -1;
    return (int)syscall(SYS_flock, descriptor, operation);
}

int ftruncate(int descriptor, off_t size)
{
    if (is_ours(descriptor) && fails(CUT, false)) return -1;
    return (int)syscall(SYS_ftruncate, descriptor, size);
}

int posix_fallocate(int descriptor, off_t from, off_t size)
{
    if (is_ours(descriptor) && fails(CUT, true)) return errno;
    return syscall(SYS_fallocate, descriptor, 0, from, size) == 0 ? 0 : errno;
}

/* --- names --- */

int renameat(int from_folder, const char *from, int to_folder, const char *to)
{
    if (is_our_name(to_folder, to) && fails(RENAME, false)) return -1;
    return (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, 0u);
}

int rename(const char *from, const char *to)
{
    return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

int mkdir(const char *name, mode_t mode)
{
    if (is_our_name(AT_FDCWD, name) && fails(MAKE, true)) return -1;
    return (int)syscall(SYS_mkdir, name, mode);
}

char *mkdtemp(char *name)
{
    if (is_our_name(AT_FDCWD, name) && fails(MAKE, true)) return NULL;
    char *(*next)(char *) = (char *(*)(char *))dlsym(RTLD_NEXT, "mkdtemp");
    return next(name);
}

DIR *opendir(const char *name)
{
    if (is_our_name(AT_FDCWD, name) && fails(OPEN, false)) return NULL;
    DIR *(*next)(const char *) = (DIR * (*)(const char *)) dlsym(RTLD_NEXT, "opendir");
    return next(name);
}

/* --- streams --- */

static ssize_t read_stream(void *cookie, char *bytes, size_t count)
{
    return read((int)(intptr_t)cookie, bytes, count);
}

static ssize_t write_stream(void *cookie, const char *bytes, size_t count)
{
    const ssize_t written = write((int)(intptr_t)cookie, bytes, count);
    return written > 0 ? written : 0;
}

static int seek_stream(void *cookie, off64_t *at, int from)
{
    const off_t reached = lseek((int)(intptr_t)cookie, *at, from);
    *at = reached;
    return reached < 0 ? -1 : 0;
}

static int close_stream(void *cookie)
{
    const int descriptor = (int)(intptr_t)cookie;
    pthread_mutex_lock(&lock);
    for (int n = 0; n < STREAMS_MAX; ++n)
        if (streams[n].stream && streams[n].descriptor == descriptor) streams[n].stream = NULL;
    pthread_mutex_unlock(&lock);
    return close(descriptor);
}

FILE *fdopen(int descriptor, const char *mode)
{
    static const cookie_io_functions_t calls = {read_stream, write_stream, seek_stream,
                                                close_stream};
    if (!is_ours(descriptor)) {
        FILE *(*next)(int, const char *) =
            (FILE * (*)(int, const char *)) dlsym(RTLD_NEXT, "fdopen");
        return next(descriptor, mode);
    }
    FILE *stream = fopencookie((void *)(intptr_t)descriptor, mode, calls);
    pthread_mutex_lock(&lock);
    for (int n = 0; n < STREAMS_MAX && stream; ++n) {
        if (streams[n].stream) continue;
        streams[n].stream = stream;
        streams[n].descriptor = descriptor;
        break;
    }
    pthread_mutex_unlock(&lock);
    return stream;
}

FILE *fopen(const char *name, const char *mode)
{
    if (!is_our_name(AT_FDCWD, name)) {
        FILE *(*next)(const char *, const char *) =
            (FILE * (*)(const char *, const char *)) dlsym(RTLD_NEXT, "fopen");
        return next(name, mode);
    }
    const int way = strchr(mode, '+') ? O_RDWR : mode[0] == 'r' ? O_RDONLY : O_WRONLY;
    const int fresh = mode[0] == 'w' ? O_CREAT | O_TRUNC : mode[0] == 'a' ? O_CREAT | O_APPEND : 0;
    const int descriptor = open(name, way | fresh | O_CLOEXEC, 0666);
    return descriptor < 0 ? NULL : fdopen(descriptor, mode);
}

int fileno(FILE *stream)
{
    int found = -1;
    pthread_mutex_lock(&lock);
    for (int n = 0; n < STREAMS_MAX; ++n)
        if (streams[n].stream == stream) found = streams[n].descriptor;
    pthread_mutex_unlock(&lock);
    return found >= 0 ? found : fileno_unlocked(stream);
}

/* Programs made for large files call these by other names. */
#define AS(name) __attribute__((alias(#name)))
int open64(const char *name, int flags, ...) AS(open);
int openat64(int folder, const char *name, int flags, ...) AS(openat);
FILE *fopen64(const char *name, const char *mode) AS(fopen);
ssize_t pread64(int descriptor, void *bytes, size_t count, off64_t at) AS(pread);
ssize_t pwrite64(int descriptor, const void *bytes, size_t count, off64_t at) AS(pwrite);
int ftruncate64(int descriptor, off64_t size) AS(ftruncate);
int posix_fallocate64(int descriptor, off64_t from, off64_t size) AS(posix_fallocate);
