/* SPDX-License-Identifier: GPL-3.0-or-later */
/* whole_file.c - write, bring to disk, rename.
 * Keeps no state. Invariant: at every moment the name shows either what was there before or all of
 * the new bytes. Start reading at fw_whole_file_write(). */
#include "experiments/storage/whole_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#define PART ".part-" /* and the number of the process that writes */

/* write(2) may take only a part, or be interrupted. */
static int write_all(int file, const char *bytes, size_t count)
{
    while (count > 0) {
        ssize_t written = write(file, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes += written;
        count -= (size_t)written;
    }
    return 0;
}

/* Writes and closes; 0 or the errno of what went wrong first. Pipes cannot be synchronised, which
 * is no failure. */
static int fill(int file, const void *bytes, size_t count)
{
    int reason = write_all(file, bytes, count);
    if (!reason && fsync(file) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS) {
        reason = errno;
    }
    if (close(file) != 0 && !reason) reason = errno;
    return reason;
}

/* To be freed; NULL without memory. */
static char *folder_of(const char *name)
{
    const char *slash = strrchr(name, '/');
    return slash ? strndup(name, (size_t)(slash - name) + 1) : strdup(".");
}

/* Without this the new name itself could be lost with the power. A folder that cannot be opened
 * for reading still holds the file: nothing to report. */
static void synchronise_folder(const char *name)
{
    char *folder = folder_of(name);
    if (!folder) return;
    int handle = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle >= 0) {
        fsync(handle);
        close(handle);
    }
    free(folder);
}

/* Whether nobody writes a temporary file any more: its lock is free, and the process that gave it
 * its number is gone. The one detects writers on other machines, the other of one that has not
 * locked yet. */
static bool is_abandoned(int folder, const char *temporary, const char *number)
{
    char *end;
    struct stat facts;
    const long process = strtol(number, &end, 10);
    if (end == number || *end != '\0' || process <= 0) return false;
    if (process == (long)getpid()) return true;
    if (kill((pid_t)process, 0) == 0 || errno != ESRCH) return false;
    const int file = openat(folder, temporary, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return false;
    const bool free_now =
        fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && flock(file, LOCK_EX | LOCK_NB) == 0;
    close(file);
    return free_now;
}

/* Temporary files of this name whose writers were killed. */
static void remove_abandoned(const char *name)
{
    char *folder = folder_of(name);
    const char *slash = strrchr(name, '/'), *own = slash ? slash + 1 : name;
    const size_t length = strlen(own);
    DIR *listing = folder ? opendir(folder) : NULL;
    free(folder);
    if (!listing) return;
    for (const struct dirent *entry = readdir(listing); entry; entry = readdir(listing)) {
        const char *found = entry->d_name;
        if (strncmp(found, own, length) != 0 || strncmp(found + length, PART, strlen(PART)) != 0)
            continue;
        if (is_abandoned(dirfd(listing), found, found + length + strlen(PART)))
            unlinkat(dirfd(listing), found, 0);
    }
    closedir(listing);
}

static int write_and_rename(const char *name, const char *temporary, const void *bytes,
                            size_t count)
{
    remove_abandoned(name);
    int file = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0) return errno;
    flock(file, LOCK_EX | LOCK_NB); /* where the file system has no locks, numbers must do */
    int reason = fill(file, bytes, count);
    if (!reason && rename(temporary, name) != 0) reason = errno;
    if (reason) unlink(temporary);
    return reason;
}

fw_status fw_whole_file_write(const char *name, const void *bytes, size_t count, fw_error *error)
{
    struct stat present;
    int reason;
    if (stat(name, &present) == 0 && !S_ISREG(present.st_mode)) {
        /* A pipe that nobody reads is refused, not waited for. */
        int file = open(name, O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (file >= 0) fcntl(file, F_SETFL, O_WRONLY);
        reason = file < 0 ? errno : fill(file, bytes, count);
    } else {
        size_t size = strlen(name) + 32;
        char *temporary = malloc(size);
        if (!temporary) return fw_fail_memory(error, "the name of a temporary file");
        snprintf(temporary, size, "%s" PART "%ld", name, (long)getpid());
        reason = write_and_rename(name, temporary, bytes, count);
        free(temporary);
        if (!reason) synchronise_folder(name);
    }
    if (!reason) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot write '%s' (%zu bytes): %s", name, count,
                   strerror(reason));
}
