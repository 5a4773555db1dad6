/* SPDX-License-Identifier: GPL-3.0-or-later */
/* whole_file.c - write, bring to disk, rename.
 * Keeps no state. Invariant: at every moment the name shows either what was there before or all of
 * the new bytes. Start reading at fw_whole_file_write(). */
#include "experiments/storage/whole_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

/* Without this the new name itself could be lost with the power. A folder that cannot be opened
 * for reading still holds the file: nothing to report. */
static void synchronise_folder(const char *name)
{
    const char *slash = strrchr(name, '/');
    char *folder = slash ? strndup(name, (size_t)(slash - name) + 1) : strdup(".");
    if (!folder) return;
    int handle = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle >= 0) {
        fsync(handle);
        close(handle);
    }
    free(folder);
}

static int write_and_rename(const char *name, const char *temporary, const void *bytes,
                            size_t count)
{
    int file = open(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) return errno;
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
        int file = open(name, O_WRONLY | O_CLOEXEC);
        reason = file < 0 ? errno : fill(file, bytes, count);
    } else {
        size_t size = strlen(name) + 32;
        char *temporary = malloc(size);
        if (!temporary) return fw_fail_memory(error, "the name of a temporary file");
        snprintf(temporary, size, "%s.part-%ld", name, (long)getpid());
        reason = write_and_rename(name, temporary, bytes, count);
        free(temporary);
        if (!reason) synchronise_folder(name);
    }
    if (!reason) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot write '%s' (%zu bytes): %s", name, count,
                   strerror(reason));
}
