/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_head.c - putting a file's structure aside and back. Its state is two file names, of
 * which at most one is there. Start reading at fw_head_save(). */
#include "trajectory_head.h"

#include "experiments/results/trajectory.h"
#include "experiments/storage/checksum.h"
#include "experiments/storage/hdf5_file.h"
#include "experiments/storage/sealed_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { SIGNATURE_SIZE = 8 }; /* with which an HDF5 file begins */

static fw_status fail(fw_error *error, const char *attempt, const char *path, int reason)
{
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot %s %s: %s", attempt, path, strerror(reason));
}

/* Bytes from byte `first` of a file on, and on to the disk; errno, or 0. */
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

/* What the copy begins with. */
typedef struct start {
    uint64_t whole, seal_at, seal;
} start;

static fw_status save(int descriptor, const fw_folder *folder, const char *path,
                      const fw_head_facts *facts, fw_error *error)
{
    start begin = {.whole = facts->whole, .seal_at = facts->seal_at};
    unsigned char *bytes = malloc(facts->size + 1);
    if (!bytes) return fw_fail_memory(error, "the structure of the results file");
    int reason = fw_read_bytes(descriptor, bytes, 0, facts->size);
    if (reason == 0)
        reason = fw_read_bytes(descriptor, &begin.seal, facts->seal_at, sizeof begin.seal);
    fw_sealed_file *copy = NULL;
    fw_status status = reason != 0
                           ? fail(error, "read", path, reason)
                           : fw_sealed_file_create(&copy, folder, FW_HEAD_WHILE_CUTTING,
                                                   FW_HEAD_KIND, sizeof begin + facts->size, error);
    if (status == FW_OK) {
        fw_sealed_file_write(copy, &begin, sizeof begin);
        fw_sealed_file_write(copy, bytes, facts->size);
        status = fw_sealed_file_commit(copy, error);
    }
    free(bytes);
    return status;
}

static fw_status open_results(int *descriptor, char path[FW_PATH_SIZE], const fw_folder *folder,
                              bool writable, fw_error *error)
{
    FW_TRY(fw_folder_path(folder, FW_TRAJECTORY_FILE, path, error));
    return fw_regular_file_open(descriptor, path, writable, error);
}

fw_status fw_head_save(const fw_folder *folder, const fw_head_facts *facts, fw_error *error)
{
    char path[FW_PATH_SIZE];
    int descriptor;
    FW_TRY(open_results(&descriptor, path, folder, false, error));
    const fw_status status = save(descriptor, folder, path, facts, error);
    close(descriptor);
    return status;
}

fw_status fw_head_seal(const fw_folder *folder, uint64_t seal_at, fw_error *error)
{
    char path[FW_PATH_SIZE];
    int descriptor;
    uint64_t seal = FW_CHECKSUM_OF_NOTHING;
    FW_TRY(open_results(&descriptor, path, folder, true, error));
    int reason =
        fw_checksum_file(descriptor, FW_HDF5_SUPERBLOCK, seal_at - FW_HDF5_SUPERBLOCK, &seal);
    if (reason == 0)
        reason = write_through(descriptor, (const unsigned char *)&seal, seal_at, sizeof seal);
    close(descriptor);
    return reason == 0 ? FW_OK : fail(error, "write", path, reason);
}

fw_status fw_head_settle(const fw_folder *folder, bool keep, fw_error *error)
{
    if (keep) return fw_folder_replace(folder, FW_HEAD_WHILE_CUTTING, FW_HEAD_AFTER_CUTTING, error);
    return fw_head_remove(folder, error);
}

bool fw_head_is_torn(const fw_folder *folder)
{
    return fw_folder_has(folder, FW_HEAD_WHILE_CUTTING);
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

/* The copy and what never changes in the file give the seal that the file had: so it is a copy of
 * this very file. */
static fw_status check_origin(int descriptor, const char *path, const char *name,
                              const start *begin, const unsigned char *head, uint64_t size,
                              fw_error *error)
{
    struct stat facts;
    uint64_t sum = FW_CHECKSUM_OF_NOTHING;
    if (fstat(descriptor, &facts) < 0) return fail(error, "read", path, errno);
    const uint64_t length = (uint64_t)facts.st_size;
    if (size >= FW_HDF5_SUPERBLOCK)
        sum = fw_checksum_add(sum, head + FW_HDF5_SUPERBLOCK, size - FW_HDF5_SUPERBLOCK);
    if (size >= FW_HDF5_SUPERBLOCK && size <= begin->seal_at && begin->seal_at < length &&
        length <= begin->whole &&
        fw_checksum_file(descriptor, size, begin->seal_at - size, &sum) == 0 && sum == begin->seal)
        return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "%s, beside %s, belongs to another results file", name,
                   path);
}

/* From here on the file may be in any state, and its name says so. */
static fw_status restore(int descriptor, const char *path, const fw_folder *folder,
                         const start *begin, const unsigned char *head, uint64_t size,
                         fw_error *error)
{
    FW_TRY(make_room(descriptor, path, begin->whole, error));
    if (!fw_head_is_torn(folder))
        FW_TRY(fw_folder_replace(folder, FW_HEAD_AFTER_CUTTING, FW_HEAD_WHILE_CUTTING, error));
    const int reason = write_through(descriptor, (const unsigned char *)&begin->seal,
                                     begin->seal_at, sizeof begin->seal);
    if (reason != 0) return fail(error, "write", path, reason);
    return put_back(descriptor, path, head, size, error);
}

fw_status fw_head_restore(const fw_folder *folder, fw_error *error)
{
    char path[FW_PATH_SIZE];
    unsigned char *payload;
    uint64_t size;
    int descriptor = -1;
    start begin;
    const char *name = fw_head_is_torn(folder) ? FW_HEAD_WHILE_CUTTING : FW_HEAD_AFTER_CUTTING;
    if (!fw_folder_has(folder, name)) return FW_OK;
    FW_TRY(fw_sealed_file_read(folder, name, FW_HEAD_KIND, &payload, &size, error));
    fw_status status = open_results(&descriptor, path, folder, true, error);
    if (status == FW_OK && size < sizeof begin)
        status = fw_fail(error, FW_BAD_INPUT, "%s, beside %s, is empty", name, path);
    if (status == FW_OK) {
        const unsigned char *head = payload + sizeof begin;
        size -= sizeof begin;
        memcpy(&begin, payload, sizeof begin);
        status = check_origin(descriptor, path, name, &begin, head, size, error);
        if (status == FW_OK) status = restore(descriptor, path, folder, &begin, head, size, error);
    }
    if (descriptor >= 0) close(descriptor);
    free(payload);
    return status;
}

fw_status fw_head_remove(const fw_folder *folder, fw_error *error)
{
    FW_TRY(fw_folder_remove(folder, FW_HEAD_WHILE_CUTTING, error));
    FW_TRY(fw_folder_remove(folder, FW_HEAD_AFTER_CUTTING, error));
    return fw_folder_sync(folder, error);
}
