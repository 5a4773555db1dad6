/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_head.c - putting a file's structure aside and back. Its state is two file names, of
 * which at most one is there. Start reading at fw_head_save(). */
#include "trajectory_head.h"

#include "experiments/results/trajectory.h"
#include "experiments/storage/sealed_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define KIND          "FWHEAD"
#define WHILE_CUTTING FW_TRAJECTORY_FILE ".cutting"
#define AFTER_CUTTING FW_TRAJECTORY_FILE ".head"

enum { SIGNATURE_SIZE = 8 }; /* with which an HDF5 file begins */

static fw_status fail(fw_error *error, const char *attempt, const char *path, int reason)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot %s %s: %s", attempt, path, strerror(reason));
}

/* Exactly `count` bytes from byte `first` of a file on; errno, or 0. */
static int read_bytes(int descriptor, unsigned char *bytes, uint64_t first, uint64_t count)
{
    for (uint64_t done = 0; done < count;) {
        ssize_t moved = pread(descriptor, bytes + done, count - done, (off_t)(first + done));
        if (moved < 0 && errno == EINTR) continue;
        if (moved <= 0) return moved < 0 ? errno : EIO;
        done += (uint64_t)moved;
    }
    return 0;
}

/* The same the other way, and on to the disk. */
static int write_through(int descriptor, const unsigned char *bytes, uint64_t first, uint64_t count)
{
    for (uint64_t done = 0; done < count;) {
        ssize_t moved = pwrite(descriptor, bytes + done, count - done, (off_t)(first + done));
        if (moved < 0 && errno == EINTR) continue;
        if (moved <= 0) return moved < 0 ? errno : EIO;
        done += (uint64_t)moved;
    }
    return fsync(descriptor) < 0 ? errno : 0;
}

fw_status fw_head_save(const fw_folder *folder, uint64_t head, uint64_t whole, fw_error *error)
{
    char path[FW_PATH_SIZE];
    FW_TRY(fw_folder_path(folder, FW_TRAJECTORY_FILE, path, error));
    unsigned char *bytes = malloc(head + 1);
    if (!bytes) return fw_fail_memory(error, "the structure of the results file");
    int descriptor = open(path, O_RDONLY);
    int reason = descriptor < 0 ? errno : read_bytes(descriptor, bytes, 0, head);
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

/* Room for the whole file; without it nothing has changed yet. */
static fw_status make_room(int descriptor, const char *path, uint64_t whole, fw_error *error)
{
    struct stat before;
    if (fstat(descriptor, &before) < 0) return fail(error, "read", path, errno);
    int reason = posix_fallocate(descriptor, 0, (off_t)whole);
    if (reason == EOPNOTSUPP || reason == EINVAL)
        reason = ftruncate(descriptor, (off_t)whole) < 0 ? errno : 0;
    if (reason == 0) return FW_OK;
    if (ftruncate(descriptor, before.st_size) < 0) reason = errno;
    return fail(error, "make room in", path, reason);
}

/* A kill between two pages leaves half of each structure, in which HDF5 would find wrong rows
 * without noticing. So the signature, by which it knows its files, goes first and comes last. */
static fw_status put_back(int descriptor, const char *path, const unsigned char *head,
                          uint64_t size, fw_error *error)
{
    static const unsigned char nothing[SIGNATURE_SIZE] = {0};
    int reason = write_through(descriptor, nothing, 0, SIGNATURE_SIZE);
    if (reason == 0)
        reason =
            write_through(descriptor, head + SIGNATURE_SIZE, SIGNATURE_SIZE, size - SIGNATURE_SIZE);
    if (reason == 0) reason = write_through(descriptor, head, 0, SIGNATURE_SIZE);
    return reason == 0 ? FW_OK : fail(error, "write", path, reason);
}

fw_status fw_head_restore(const fw_folder *folder, fw_error *error)
{
    char path[FW_PATH_SIZE];
    unsigned char *payload;
    uint64_t size, whole;
    const bool torn = fw_head_is_torn(folder);
    const char *name = torn ? WHILE_CUTTING : AFTER_CUTTING;
    if (!fw_folder_has(folder, name)) return FW_OK;
    FW_TRY(fw_folder_path(folder, FW_TRAJECTORY_FILE, path, error));
    FW_TRY(fw_sealed_file_read(folder, name, KIND, &payload, &size, error));
    fw_status status = FW_OK;
    int descriptor = open(path, O_RDWR);
    if (size < sizeof whole + SIGNATURE_SIZE)
        status = fw_fail(error, FW_BAD_INPUT, "%s, beside %s, is empty", name, path);
    else if (descriptor < 0)
        status = fail(error, "open", path, errno);
    if (status == FW_OK) {
        memcpy(&whole, payload, sizeof whole);
        status = make_room(descriptor, path, whole, error);
    }
    /* From here on the file may be in any state, and its name says so. */
    if (status == FW_OK && !torn)
        status = fw_folder_replace(folder, AFTER_CUTTING, WHILE_CUTTING, error);
    if (status == FW_OK)
        status = put_back(descriptor, path, payload + sizeof whole, size - sizeof whole, error);
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
