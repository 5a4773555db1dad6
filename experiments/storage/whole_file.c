/* SPDX-License-Identifier: GPL-3.0-or-later */
/* whole_file.c - write, bring to disk, rename.
 * Keeps no state. Invariant: at every moment the name shows either what was there before or all of
 * the new bytes. Start reading at fw_whole_file_write(), or at fw_whole_file_begin(). */
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

/* Pipes cannot be synchronised, which is no failure. */
static bool synchronised(int file)
{
    return fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

/* Writes and closes; 0 or the errno of what went wrong first. */
static int fill(int file, const void *bytes, size_t count)
{
    int reason = write_all(file, bytes, count);
    if (!reason && !synchronised(file)) reason = errno;
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

/* A new temporary file, locked; -1 and errno. */
static int open_temporary(const char *name, const char *temporary)
{
    remove_abandoned(name);
    const int file = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file >= 0) flock(file, LOCK_EX | LOCK_NB); /* without locks numbers must do */
    return file;
}

/* A pipe or a device is written to directly. One that nobody reads is refused, not waited for. */
static int open_directly(const char *name)
{
    const int file = open(name, O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (file >= 0) fcntl(file, F_SETFL, O_WRONLY);
    return file;
}

static bool is_regular_or_new(const char *name)
{
    struct stat present;
    return stat(name, &present) != 0 || S_ISREG(present.st_mode);
}

/* To be freed; NULL without memory. */
static char *temporary_of(const char *name)
{
    const size_t size = strlen(name) + 32;
    char *temporary = malloc(size);
    if (temporary) snprintf(temporary, size, "%s" PART "%ld", name, (long)getpid());
    return temporary;
}

static fw_status fail_memory(fw_error *error)
{
    return fw_fail_memory(error, "the name of a temporary file");
}

static int write_and_rename(const char *name, const char *temporary, const void *bytes,
                            size_t count)
{
    const int file = open_temporary(name, temporary);
    if (file < 0) return errno;
    int reason = fill(file, bytes, count);
    if (!reason && rename(temporary, name) != 0) reason = errno;
    if (reason) unlink(temporary);
    return reason;
}

fw_status fw_whole_file_write(const char *name, const void *bytes, size_t count, fw_error *error)
{
    int reason;
    if (is_regular_or_new(name)) {
        char *temporary = temporary_of(name);
        if (!temporary) return fail_memory(error);
        reason = write_and_rename(name, temporary, bytes, count);
        free(temporary);
        if (!reason) synchronise_folder(name);
    } else {
        const int file = open_directly(name);
        reason = file < 0 ? errno : fill(file, bytes, count);
    }
    if (!reason) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot write '%s' (%zu bytes): %s", name, count,
                   strerror(reason));
}

/* --- little by little --- */

struct fw_whole_file {
    FILE *stream;
    char *temporary; /* NULL: it is written to directly */
    char name[];
};

static void release(fw_whole_file *file)
{
    if (file->stream) fclose(file->stream);
    if (file->temporary) unlink(file->temporary);
    free(file->temporary);
    free(file);
}

static fw_status fail_writing(const char *name, int reason, fw_error *error)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot write '%s': %s", name, strerror(reason));
}

fw_status fw_whole_file_begin(fw_whole_file **file, const char *name, fw_error *error)
{
    fw_whole_file *begun = calloc(1, sizeof *begun + strlen(name) + 1);
    *file = NULL;
    if (!begun) return fail_memory(error);
    strcpy(begun->name, name);
    const bool direct = !is_regular_or_new(name);
    if (!direct) begun->temporary = temporary_of(name);
    if (!direct && !begun->temporary) {
        free(begun);
        return fail_memory(error);
    }
    const int handle = direct ? open_directly(name) : open_temporary(name, begun->temporary);
    const int reason = errno;
    if (handle >= 0) begun->stream = fdopen(handle, "w");
    if (!begun->stream) {
        if (handle < 0) {
            free(begun->temporary); /* it is not ours */
            begun->temporary = NULL;
        } else {
            close(handle);
        }
        release(begun);
        return handle < 0 ? fail_writing(name, reason, error) : fw_fail_memory(error, name);
    }
    *file = begun;
    return FW_OK;
}

FILE *fw_whole_file_stream(const fw_whole_file *file)
{
    return file->stream;
}

const char *fw_whole_file_place(const fw_whole_file *file)
{
    return file->temporary ? file->temporary : file->name;
}

fw_status fw_whole_file_commit(fw_whole_file *file, fw_error *error)
{
    int reason = 0;
    if (fflush(file->stream) != 0) reason = errno;
    if (!reason && ferror(file->stream)) reason = EIO;
    if (!reason && !synchronised(fileno(file->stream))) reason = errno;
    if (fclose(file->stream) != 0 && !reason) reason = errno;
    file->stream = NULL;
    if (!reason && file->temporary && rename(file->temporary, file->name) != 0) reason = errno;
    fw_status status = FW_OK;
    if (reason) {
        status = fail_writing(file->name, reason, error);
    } else if (file->temporary) {
        synchronise_folder(file->name);
        free(file->temporary);
        file->temporary = NULL;
    }
    release(file);
    return status;
}

void fw_whole_file_abandon(fw_whole_file *file)
{
    if (file) release(file);
}
