/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_head.c - putting a file's structure aside and back. Its state is two file names, of
 * which at most one is there. Start reading at fw_head_save(). */
#include "experiments/trajectory_head.h"

#include "experiments/sealed_file.h"
#include "experiments/trajectory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define KIND          "FWHEAD"
#define WHILE_CUTTING FW_TRAJECTORY_FILE ".cutting"
#define AFTER_CUTTING FW_TRAJECTORY_FILE ".head"

static fw_status fail(fw_error *error, const char *attempt, const char *path, int reason)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot %s %s: %s", attempt, path, strerror(reason));
}

/* Exactly `count` bytes at the start of a file, either way; errno, or 0. */
static int transfer(int descriptor, unsigned char *bytes, uint64_t count, bool write)
{
    for (uint64_t done = 0; done < count;) {
        ssize_t moved = write ? pwrite(descriptor, bytes + done, count - done, (off_t)done)
                              : pread(descriptor, bytes + done, count - done, (off_t)done);
        if (moved < 0 && errno == EINTR) continue;
        if (moved <= 0) return moved < 0 ? errno : EIO;
        done += (uint64_t)moved;
    }
    return 0;
}

fw_status fw_head_save(const fw_folder *folder, uint64_t head, uint64_t whole, fw_error *error)
{
    char path[FW_PATH_SIZE];
    FW_TRY(fw_folder_path(folder, FW_TRAJECTORY_FILE, path, error));
    unsigned char *bytes = malloc(head + 1);
    if (!bytes) return fw_fail_memory(error, "the structure of the results file");
    int descriptor = open(path, O_RDONLY);
    int reason = descriptor < 0 ? errno : transfer(descriptor, bytes, head, false);
    if (descriptor >= 0) close(descriptor);
    fw_sealed_file *copy = NULL;
    fw_status status = reason != 0 ? fail(error, "read", path, reason)
                                   : fw_sealed_file_create(&copy, folder, WHILE_CUTTING, KIND,
                                                           sizeof whole + head, error);
    if (status == FW_OK) {
        fw_sealed_file_write(copy, &whole, sizeof whole);
        fw_sealed_file_write(copy, bytes, head);
        status = fw_sealed_file_commit(copy, error);
    }
    free(bytes);
    return status;
}

fw_status fw_head_settle(const fw_folder *folder, bool keep, fw_error *error)
{
    if (keep) return fw_folder_replace(folder, WHILE_CUTTING, AFTER_CUTTING, error);
    return fw_head_remove(folder, error);
}

bool fw_head_is_torn(const fw_folder *folder)
{
    return fw_folder_has(folder, WHILE_CUTTING);
}

/* The room first: without it nothing has changed yet. */
static fw_status put_back(int descriptor, const char *path, unsigned char *head, uint64_t size,
                          uint64_t whole, fw_error *error)
{
    struct stat before;
    if (fstat(descriptor, &before) < 0) return fail(error, "read", path, errno);
    int reason = posix_fallocate(descriptor, 0, (off_t)whole);
    if (reason == EOPNOTSUPP || reason == EINVAL)
        reason = ftruncate(descriptor, (off_t)whole) < 0 ? errno : 0;
    if (reason != 0) {
        if (ftruncate(descriptor, before.st_size) < 0) reason = errno;
        return fail(error, "make room in", path, reason);
    }
    reason = transfer(descriptor, head, size, true);
    if (reason == 0 && fsync(descriptor) < 0) reason = errno;
    return reason == 0 ? FW_OK : fail(error, "write", path, reason);
}

fw_status fw_head_restore(const fw_folder *folder, fw_error *error)
{
    char path[FW_PATH_SIZE];
    unsigned char *payload;
    uint64_t size, whole;
    const char *name = fw_head_is_torn(folder) ? WHILE_CUTTING : AFTER_CUTTING;
    if (!fw_folder_has(folder, name)) return FW_OK;
    FW_TRY(fw_folder_path(folder, FW_TRAJECTORY_FILE, path, error));
    FW_TRY(fw_sealed_file_read(folder, name, KIND, &payload, &size, error));
    fw_status status = FW_OK;
    int descriptor = open(path, O_RDWR);
    if (size < sizeof whole)
        status = fw_fail(error, FW_BAD_INPUT, "%s/%s is empty", path, name);
    else if (descriptor < 0)
        status = fail(error, "open", path, errno);
    if (status == FW_OK) {
        memcpy(&whole, payload, sizeof whole);
        status =
            put_back(descriptor, path, payload + sizeof whole, size - sizeof whole, whole, error);
    }
    if (descriptor >= 0) close(descriptor);
    free(payload);
    return status;
}

fw_status fw_head_remove(const fw_folder *folder, fw_error *error)
{
    FW_TRY(fw_folder_remove(folder, WHILE_CUTTING, error));
    FW_TRY(fw_folder_remove(folder, AFTER_CUTTING, error));
    return fw_folder_sync(folder, error);
}
