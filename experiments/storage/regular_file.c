/* SPDX-License-Identifier: GPL-3.0-or-later */
/* regular_file.c - opening what is a file and nothing else. Keeps no state. */
#include "experiments/storage/regular_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

fw_status fw_path_join(char path[FW_PATH_SIZE], const char *directory, const char *name,
                       fw_error *error)
{
    const int length = snprintf(path, FW_PATH_SIZE, "%s/%s", directory, name);
    if (length >= 0 && length < FW_PATH_SIZE) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "the path %s/%s is longer than %d bytes", directory, name,
                   FW_PATH_SIZE - 1);
}

fw_status fw_path_beside(char path[FW_PATH_SIZE], const char *directory, const char *ending,
                         fw_error *error)
{
    size_t length = strlen(directory);
    while (length > 1 && directory[length - 1] == '/') --length;
    size_t last = length;
    while (last > 0 && directory[last - 1] != '/') --last;
    char *real = NULL;
    const bool dots = length > last && length - last <= 2;
    if (dots && strncmp(directory + last, "..", length - last) == 0) {
        real = realpath(directory, NULL);
        if (!real)
            return fw_fail(error, FW_SYSTEM_FAILED, "cannot find the folder %s: %s", directory,
                           strerror(errno));
        directory = real;
        length = strlen(real);
    }
    const int written = snprintf(path, FW_PATH_SIZE, "%.*s%s", (int)length, directory, ending);
    free(real);
    if (written < FW_PATH_SIZE) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "the name '%.60s...' is too long", path);
}

/* O_NONBLOCK: a pipe without a writer would be waited for before it could be seen to be one. */
fw_status fw_regular_file_open(int *descriptor, const char *path, bool writable, fw_error *error)
{
    struct stat facts;
    const int flags = writable ? O_RDWR | O_NOFOLLOW : O_RDONLY;
    *descriptor = open(path, flags | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (*descriptor < 0) {
        const int reason = errno;
        if (reason == ELOOP && writable)
            return fw_fail(error, FW_BAD_INPUT, "%s is a link, which is not written through", path);
        if (reason == ENXIO || reason == EISDIR)
            return fw_fail(error, FW_BAD_INPUT, "%s is not a file", path);
        const bool missing = reason == ENOENT || reason == ENOTDIR || reason == ELOOP;
        return fw_fail(error, missing ? FW_BAD_INPUT : FW_SYSTEM_FAILED, "cannot open %s: %s", path,
                       strerror(reason));
    }
    const int reason = fstat(*descriptor, &facts) < 0 ? errno : 0;
    if (reason == 0 && S_ISREG(facts.st_mode)) return FW_OK;
    close(*descriptor);
    *descriptor = -1;
    if (reason != 0)
        return fw_fail(error, FW_SYSTEM_FAILED, "cannot open %s: %s", path, strerror(reason));
    return fw_fail(error, FW_BAD_INPUT, "%s is not a file", path);
}

fw_status fw_regular_file_create(int *descriptor, const char *path, fw_error *error)
{
    *descriptor = -1;
    if (unlink(path) == 0 || errno == ENOENT)
        *descriptor = open(path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (*descriptor >= 0) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot write %s: %s", path, strerror(errno));
}

fw_status fw_regular_file_read(char **bytes, size_t *size, const char *path, size_t most,
                               fw_error *error)
{
    int descriptor;
    struct stat facts = {0};
    *bytes = NULL;
    *size = 0;
    FW_TRY(fw_regular_file_open(&descriptor, path, false, error));
    fw_status status = FW_OK;
    if (fstat(descriptor, &facts) < 0)
        status = fw_fail(error, FW_SYSTEM_FAILED, "cannot read %s: %s", path, strerror(errno));
    else if ((size_t)facts.st_size > most)
        status = fw_fail(error, FW_BAD_INPUT, "%s has %lld bytes, expected at most %zu", path,
                         (long long)facts.st_size, most);
    if (status == FW_OK) *bytes = malloc((size_t)facts.st_size + 1);
    if (status == FW_OK && !*bytes) status = fw_fail_memory(error, path);
    while (status == FW_OK && *size < (size_t)facts.st_size) {
        const ssize_t moved = read(descriptor, *bytes + *size, (size_t)facts.st_size - *size);
        if (moved < 0 && errno == EINTR) continue;
        if (moved < 0)
            status = fw_fail(error, FW_SYSTEM_FAILED, "cannot read %s: %s", path, strerror(errno));
        if (moved <= 0) break;
        *size += (size_t)moved;
    }
    close(descriptor);
    if (status == FW_OK) {
        (*bytes)[*size] = '\0';
        return FW_OK;
    }
    free(*bytes);
    *bytes = NULL;
    *size = 0;
    return status;
}

fw_status fw_path_check_inner(const char *path, fw_error *error)
{
    struct stat facts;
    if (lstat(path, &facts) < 0 || S_ISDIR(facts.st_mode)) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "%s is %s, expected a folder of results or nothing", path,
                   S_ISLNK(facts.st_mode) ? "a link" : "no folder");
}
