/* SPDX-License-Identifier: GPL-3.0-or-later */
/* disk_recorder.c - loaded before the C library (LD_PRELOAD), writes a line into the file
 * FW_DISK_RECORD for each write, fsync and rename of a program, with the file's name and size:
 *
 *     write SIZE PATH        after a write(2) or pwrite(2)
 *     fsync SIZE PATH
 *     rename SIZE PATH TO    before it happens
 *
 * Streams write past it, which their sizes show. Keeps no state. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { PATH_SIZE = PATH_MAX, LINE_SIZE = 3 * PATH_MAX };

static void note(const char *line, int length)
{
    const char *name = getenv("FW_DISK_RECORD");
    if (!name || length <= 0 || length >= LINE_SIZE) return;
    const int file = open(name, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) return;
    syscall(SYS_write, file, line, (size_t)length);
    close(file);
}

static void path_of(int descriptor, char path[PATH_SIZE])
{
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = readlink(link, path, PATH_SIZE - 1);
    path[length > 0 ? length : 0] = '\0';
}

static void note_file(const char *what, int descriptor)
{
    char path[PATH_SIZE], line[LINE_SIZE];
    struct stat facts;
    path_of(descriptor, path);
    if (path[0] != '/' || fstat(descriptor, &facts) != 0) return;
    if (!S_ISREG(facts.st_mode) && !S_ISDIR(facts.st_mode)) return;
    note(line, snprintf(line, sizeof line, "%s %lld %s\n", what,
                        S_ISREG(facts.st_mode) ? (long long)facts.st_size : 0LL, path));
}

static void make_absolute(int folder, const char *name, char path[2 * PATH_SIZE])
{
    char start[PATH_SIZE] = "";
    if (name[0] != '/' && folder == AT_FDCWD && !getcwd(start, sizeof start)) start[0] = '\0';
    if (name[0] != '/' && folder != AT_FDCWD) path_of(folder, start);
    snprintf(path, 2 * PATH_SIZE, "%s%s%s", start, start[0] ? "/" : "", name);
}

ssize_t write(int descriptor, const void *bytes, size_t count)
{
    const ssize_t written = syscall(SYS_write, descriptor, bytes, count);
    if (written > 0) note_file("write", descriptor);
    return written;
}

ssize_t pwrite(int descriptor, const void *bytes, size_t count, off_t place)
{
    const ssize_t written = syscall(SYS_pwrite64, descriptor, bytes, count, place);
    if (written > 0) note_file("write", descriptor);
    return written;
}

ssize_t pwrite64(int descriptor, const void *bytes, size_t count, off64_t place)
{
    return pwrite(descriptor, bytes, count, place);
}

int fsync(int descriptor)
{
    const int status = (int)syscall(SYS_fsync, descriptor);
    if (status == 0) note_file("fsync", descriptor);
    return status;
}

int renameat(int from_folder, const char *from, int to_folder, const char *to)
{
    char path[2 * PATH_SIZE], target[2 * PATH_SIZE], line[LINE_SIZE];
    struct stat facts = {0};
    make_absolute(from_folder, from, path);
    make_absolute(to_folder, to, target);
    if (stat(path, &facts) == 0)
        note(line, snprintf(line, sizeof line, "rename %lld %s %s\n", (long long)facts.st_size,
                            path, target));
    return (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, 0u);
}

int rename(const char *from, const char *to)
{
    return renameat(AT_FDCWD, from, AT_FDCWD, to);
}
