/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hdf5_file.c - opening, flushing and closing files, and their failures.
 * State: the file's handle, the datasets made in it, its first failure; and, since HDF5 has but one
 * state for all files, the lock of the door. Invariant: after a failure no call reaches HDF5 any
 * more, except the one that closes. Start reading at
 * fw_hdf5_create(); hdf5_make.c and hdf5_data.c do the rest. */
#include "hdf5_parts.h"

#include "experiments/storage/checksum.h"
#include "experiments/storage/regular_file.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static pthread_mutex_t door;
static pthread_once_t door_made = PTHREAD_ONCE_INIT;

static void make_door(void)
{
    pthread_mutexattr_t kind;
    pthread_mutexattr_init(&kind);
    pthread_mutexattr_settype(&kind, PTHREAD_MUTEX_RECURSIVE);
    pthread_mutex_init(&door, &kind);
    pthread_mutexattr_destroy(&kind);
}

int fw_hdf5_lock(void)
{
    pthread_once(&door_made, make_door);
    return pthread_mutex_lock(&door);
}

void fw_hdf5_unlock(const int *held)
{
    if (*held == 0) pthread_mutex_unlock(&door);
}

/* The operating system's error number is only in the text of HDF5's error stack. */
static herr_t find_errno(unsigned depth, const H5E_error2_t *entry, void *number)
{
    (void)depth;
    const char *found = entry->desc ? strstr(entry->desc, "errno = ") : NULL;
    if (found) *(int *)number = atoi(found + strlen("errno = "));
    return 0;
}

/* The system's error number in what HDF5 says of its last call, or 0; forgets what it said. The
 * next call to HDF5 would forget it too. */
static int take_errno(void)
{
    int number = 0;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_errno, &number);
    H5Eclear2(H5E_DEFAULT);
    return number;
}

/* The sentence with the system's reason, or `otherwise` when the system had none. */
static fw_status explain(fw_error *error, const char *path, const char *attempt,
                         fw_status otherwise, const char *reason)
{
    const int number = take_errno();
    if (number != 0) otherwise = FW_SYSTEM_FAILED;
    return fw_fail(error, otherwise, "cannot %s %s: %s", attempt, path,
                   number != 0 ? strerror(number) : reason);
}

void fw_hdf5_fail_writing(fw_hdf5 *file, const char *object)
{
    char reason[FW_SENTENCE_SIZE];
    file->broken = true;
    snprintf(reason, sizeof reason, "HDF5 refuses %s", object);
    if (file->failure.status == FW_OK)
        explain(&file->failure, file->path, "write", FW_SYSTEM_FAILED, reason);
}

void fw_hdf5_fail_reading(fw_hdf5 *file)
{
    if (file->failure.status == FW_OK)
        explain(&file->failure, file->path, "read", FW_BAD_INPUT, "it is damaged or foreign");
}

void fw_hdf5_miss(fw_hdf5 *file)
{
    const int number = take_errno();
    if (number != 0 && file->failure.status == FW_OK)
        fw_fail(&file->failure, FW_SYSTEM_FAILED, "cannot read %s: %s", file->path,
                strerror(number));
}

bool fw_hdf5_failed(const fw_hdf5 *file)
{
    return file->failure.status != FW_OK;
}

/* HDF5 prints nothing by itself, and does not try to write at exit what could not be written
 * before: with a full disk that never ends. */
static void quieten(void)
{
    H5dont_atexit();
    H5open();
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
}

static hid_t access_properties(size_t structure)
{
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    /* Without caches a write goes to its final place at once. */
    H5Pset_cache(access, 0, 0, 0, 0);
    H5Pset_sieve_buf_size(access, 0);
    /* Structure in one block at the head, raw data behind it without gaps. */
    if (structure > 0) H5Pset_meta_block_size(access, structure);
    H5Pset_small_data_block_size(access, 0);
    /* Readers may look at a running file; two writers are kept apart by the folder's lock. */
    H5Pset_file_locking(access, false, true);
    return access;
}

static fw_hdf5 *allocate(const char *path)
{
    fw_hdf5 *file = calloc(1, sizeof *file + strlen(path) + 1);
    if (!file) return NULL;
    strcpy(file->path, path);
    file->id = H5I_INVALID_HID;
    return file;
}

fw_status fw_hdf5_create(fw_hdf5 **file, const char *path, size_t structure, fw_error *error)
{
    FW_HDF5_ALONE;
    *file = NULL;
    quieten();
    fw_hdf5 *fresh = allocate(path);
    if (!fresh) return fw_fail_memory(error, path);
    hid_t access = access_properties(structure);
    /* Not what a link of that name points to. */
    unlink(path);
    /* No object says when it was made: the same numbers are the same file. */
    hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_obj_track_times(creation, false);
    fresh->id = H5Fcreate(path, H5F_ACC_EXCL, creation, access);
    /* At once: the next call to HDF5, whichever it is, clears the reason. */
    fw_status status =
        fresh->id < 0 ? explain(error, path, "create", FW_SYSTEM_FAILED, "HDF5 refuses") : FW_OK;
    H5Pclose(access);
    H5Pclose(creation);
    if (status != FW_OK) {
        free(fresh);
        return status;
    }
    fresh->writable = true;
    *file = fresh;
    return FW_OK;
}

fw_status fw_hdf5_open(fw_hdf5 **file, const char *path, bool writable, fw_error *error)
{
    FW_HDF5_ALONE;
    *file = NULL;
    quieten();
    int descriptor;
    FW_TRY(fw_regular_file_open(&descriptor, path, writable, error));
    close(descriptor);
    fw_hdf5 *opened = allocate(path);
    if (!opened) return fw_fail_memory(error, path);
    hid_t access = access_properties(0);
    opened->id = H5Fopen(path, writable ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access);
    const int reason = opened->id < 0 ? take_errno() : 0;
    H5Pclose(access);
    if (opened->id < 0) {
        free(opened);
        if (reason != 0)
            return fw_fail(error, FW_SYSTEM_FAILED, "cannot read %s: %s", path, strerror(reason));
        return fw_fail(error, FW_BAD_INPUT, "%s is not a whole HDF5 file", path);
    }
    opened->writable = writable;
    *file = opened;
    return FW_OK;
}

/* What cannot be written now could not be written while closing either, and HDF5 is left in pieces
 * by a close that fails: the next file then crashes. So a broken file is left open until the
 * process ends; its descriptor goes on standing for it, and no other file is taken for it. */
fw_status fw_hdf5_close(fw_hdf5 *file, fw_error *error)
{
    FW_HDF5_ALONE;
    if (!file) return FW_OK;
    if (file->writable && !file->broken && H5Fflush(file->id, H5F_SCOPE_LOCAL) < 0)
        fw_hdf5_fail_writing(file, "the file");
    if (!file->broken && H5Fclose(file->id) < 0) fw_hdf5_fail_writing(file, "the file");
    fw_status status = fw_hdf5_check(file, error);
    free(file->made);
    free(file);
    return status;
}

fw_status fw_hdf5_check(const fw_hdf5 *file, fw_error *error)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file) && error) *error = file->failure;
    return file->failure.status;
}

void fw_hdf5_refuse(fw_hdf5 *file, const char *path)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return;
    fw_fail(&file->failure, FW_BAD_INPUT,
            "%s is damaged or foreign: /%s is missing or not as expected", file->path, path);
}

void fw_hdf5_give_up(fw_hdf5 *file, const char *what)
{
    FW_HDF5_ALONE;
    if (!fw_hdf5_failed(file)) fw_fail_memory(&file->failure, what);
}

void fw_hdf5_flush(fw_hdf5 *file)
{
    FW_HDF5_ALONE;
    if (!fw_hdf5_failed(file) && H5Fflush(file->id, H5F_SCOPE_LOCAL) < 0)
        fw_hdf5_fail_writing(file, "the file");
}

int fw_hdf5_descriptor(fw_hdf5 *file)
{
    FW_HDF5_ALONE;
    int *descriptor = NULL;
    if (fw_hdf5_failed(file)) return -1;
    if (H5Fget_vfd_handle(file->id, H5P_DEFAULT, (void **)&descriptor) >= 0) return *descriptor;
    fw_hdf5_fail_writing(file, "a descriptor");
    return -1;
}

void fw_hdf5_sync(fw_hdf5 *file)
{
    FW_HDF5_ALONE;
    fw_hdf5_flush(file);
    int descriptor = fw_hdf5_descriptor(file);
    if (descriptor >= 0 && fsync(descriptor) != 0) fw_hdf5_fail_system(file, errno);
}

void fw_hdf5_fail_system(fw_hdf5 *file, int reason)
{
    FW_HDF5_ALONE;
    file->broken = true;
    if (fw_hdf5_failed(file)) return;
    fw_fail(&file->failure, FW_SYSTEM_FAILED, "cannot write %s: %s", file->path, strerror(reason));
}

void fw_hdf5_reserve(fw_hdf5 *file)
{
    FW_HDF5_ALONE;
    fw_hdf5_flush(file);
    uint64_t whole = fw_hdf5_size(file);
    int descriptor = fw_hdf5_descriptor(file);
    if (descriptor < 0) return;
    int reason = posix_fallocate(descriptor, 0, (off_t)whole);
    if (reason == 0 || reason == EOPNOTSUPP || reason == EINVAL) return;
    file->broken = true;
    fw_fail(&file->failure, FW_SYSTEM_FAILED, "no room for %s, which takes %.3g MB: %s", file->path,
            (double)whole / 1e6, strerror(reason));
}

uint64_t fw_hdf5_size(fw_hdf5 *file)
{
    FW_HDF5_ALONE;
    hsize_t size = 0;
    if (!fw_hdf5_failed(file) && H5Fget_filesize(file->id, &size) < 0) fw_hdf5_fail_reading(file);
    return size;
}

uint64_t fw_hdf5_checksum(fw_hdf5 *file, uint64_t end)
{
    FW_HDF5_ALONE;
    uint64_t sum = FW_CHECKSUM_OF_NOTHING;
    if (file->writable) fw_hdf5_flush(file);
    const int descriptor = fw_hdf5_descriptor(file);
    if (descriptor < 0 || end < FW_HDF5_SUPERBLOCK) return 0;
    const int reason =
        fw_checksum_file(descriptor, FW_HDF5_SUPERBLOCK, end - FW_HDF5_SUPERBLOCK, &sum);
    if (reason != 0 && !fw_hdf5_failed(file))
        fw_fail(&file->failure, FW_SYSTEM_FAILED, "cannot read %s: %s", file->path,
                strerror(reason));
    return sum;
}

const char *fw_hdf5_path(const fw_hdf5 *file)
{
    return file->path;
}

bool fw_hdf5_is_compact(fw_hdf5 *file)
{
    FW_HDF5_ALONE;
    fw_hdf5_flush(file);
    uint64_t raw = 0;
    for (int i = 0; i < file->made_count; ++i) raw += H5Dget_storage_size(file->made[i]);
    return file->head + raw == fw_hdf5_size(file);
}

uint64_t fw_hdf5_address(fw_hdf5 *file, fw_dataset dataset)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return 0;
    haddr_t address = H5Dget_offset(dataset);
    if (address == HADDR_UNDEF) fw_hdf5_fail_reading(file);
    return address == HADDR_UNDEF ? 0 : address;
}

uint64_t fw_hdf5_row_address(fw_hdf5 *file, fw_dataset dataset, uint64_t row)
{
    FW_HDF5_ALONE;
    if (fw_hdf5_failed(file)) return 0;
    const hsize_t start[H5S_MAX_RANK] = {row};
    haddr_t address = HADDR_UNDEF;
    hsize_t size = 0;
    if (H5Dget_chunk_info_by_coord(dataset, start, NULL, &address, &size) < 0 ||
        address == HADDR_UNDEF)
        fw_hdf5_fail_writing(file, "a row");
    return address == HADDR_UNDEF ? 0 : address;
}

void fw_hdf5_version(char *text, size_t size)
{
    FW_HDF5_ALONE;
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    snprintf(text, size, "HDF5 %u.%u.%u", major, minor, release);
}
