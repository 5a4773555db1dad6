/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sealed_file.c - writing and reading files that are whole or not there.
 * State while writing: the file under its temporary name, the checksum so far, the first failure.
 * Start reading at fw_sealed_file_commit(). */
#include "experiments/storage/sealed_file.h"

#include "experiments/storage/checksum.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { SEAL_VERSION = 1, BYTE_ORDER_MARK = 0x01020304 };

typedef struct header {
    char kind[FW_SEAL_KIND_SIZE];
    uint32_t byte_order, version;
    uint64_t size;
} header;

_Static_assert(sizeof(header) == 24, "the header is written as it lies in memory");

struct fw_sealed_file {
    const fw_folder *folder;
    FILE *stream;
    uint64_t checksum, size, written; /* the latter two of the payload */
    int failure;                      /* errno, or 0 */
    char name[FW_PATH_SIZE], fresh_name[FW_PATH_SIZE];
    char fresh_path[FW_PATH_SIZE];
};

static void append(fw_sealed_file *file, const void *bytes, size_t count)
{
    if (file->failure != 0 || count == 0) return;
    if (fwrite(bytes, 1, count, file->stream) != count) file->failure = errno != 0 ? errno : EIO;
    file->checksum = fw_checksum_add(file->checksum, bytes, count);
}

static header header_of(const char *kind, uint64_t size)
{
    header made = {.byte_order = BYTE_ORDER_MARK, .version = SEAL_VERSION, .size = size};
    assert(strlen(kind) <= sizeof made.kind);
    memcpy(made.kind, kind, strlen(kind));
    return made;
}

fw_status fw_sealed_file_create(fw_sealed_file **file, const fw_folder *folder, const char *name,
                                const char *kind, uint64_t size, fw_error *error)
{
    *file = NULL;
    fw_sealed_file *fresh = calloc(1, sizeof *fresh);
    if (!fresh) return fw_fail_memory(error, name);
    fresh->folder = folder;
    fresh->checksum = FW_CHECKSUM_OF_NOTHING;
    fresh->size = size;
    snprintf(fresh->name, sizeof fresh->name, "%s", name);
    snprintf(fresh->fresh_name, sizeof fresh->fresh_name, "%.200s" FW_FRESH_SUFFIX, name);
    fw_status status = fw_folder_path(folder, fresh->fresh_name, fresh->fresh_path, error);
    if (status == FW_OK) {
        int descriptor;
        status = fw_regular_file_create(&descriptor, fresh->fresh_path, error);
        if (status == FW_OK) fresh->stream = fdopen(descriptor, "wb");
        if (status == FW_OK && !fresh->stream) {
            close(descriptor);
            status = fw_fail_memory(error, fresh->fresh_path);
        }
    }
    if (status != FW_OK) {
        free(fresh);
        return status;
    }
    header start = header_of(kind, size);
    append(fresh, &start, sizeof start);
    *file = fresh;
    return FW_OK;
}

void fw_sealed_file_write(fw_sealed_file *file, const void *bytes, size_t count)
{
    append(file, bytes, count);
    file->written += count;
}

fw_status fw_sealed_file_commit(fw_sealed_file *file, fw_error *error)
{
    assert(file->written == file->size);
    uint64_t seal = file->checksum;
    append(file, &seal, sizeof seal);
    /* Data first, name second: a name on the disk never stands for data that is not. */
    if (file->failure == 0 && (fflush(file->stream) != 0 || fsync(fileno(file->stream)) != 0))
        file->failure = errno;
    if (fclose(file->stream) != 0 && file->failure == 0) file->failure = errno;
    fw_status status;
    if (file->failure == 0)
        status = fw_folder_replace(file->folder, file->fresh_name, file->name, error);
    else
        status = fw_fail(error, FW_SYSTEM_FAILED, "cannot write %s: %s", file->fresh_path,
                         strerror(file->failure));
    if (status != FW_OK) fw_folder_discard(file->folder, file->fresh_name);
    free(file);
    return status;
}

/* The payload of the file that is open, in memory. */
static fw_status read_stream(FILE *stream, const char *path, const char *kind,
                             unsigned char **payload, uint64_t *size, fw_error *error)
{
    struct stat facts;
    header start, wanted = header_of(kind, 0);
    uint64_t seal, frame = sizeof start + sizeof seal;
    if (fstat(fileno(stream), &facts) < 0)
        return fw_fail(error, FW_SYSTEM_FAILED, "cannot read %s: %s", path, strerror(errno));
    uint64_t length = (uint64_t)facts.st_size;
    const bool begun = length >= frame && fread(&start, sizeof start, 1, stream) == 1;
    if (ferror(stream))
        return fw_fail(error, FW_SYSTEM_FAILED, "cannot read %s: %s", path, strerror(errno));
    if (!begun)
        return fw_fail(error, FW_BAD_INPUT, "%s is cut short: it has %llu bytes", path,
                       (unsigned long long)length);
    if (memcmp(start.kind, wanted.kind, sizeof wanted.kind) != 0)
        return fw_fail(error, FW_BAD_INPUT, "%s is not of the kind '%s'", path, kind);
    if (start.byte_order != BYTE_ORDER_MARK)
        return fw_fail(error, FW_BAD_INPUT, "%s comes from a machine with another byte order",
                       path);
    if (start.version != SEAL_VERSION)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s has version %u of its format; this program reads %u", path,
                       start.version, (unsigned)SEAL_VERSION);
    /* Only now is the file's own word on its length worth memory. */
    if (start.size != length - frame)
        return fw_fail(error, FW_BAD_INPUT, "%s is cut short: it has %llu bytes of %llu", path,
                       (unsigned long long)length, (unsigned long long)(start.size + frame));
    unsigned char *bytes = malloc(start.size + 1);
    if (!bytes) return fw_fail_memory(error, path);
    bool whole = fread(bytes, 1, start.size, stream) == start.size &&
                 fread(&seal, sizeof seal, 1, stream) == 1;
    uint64_t checksum = fw_checksum_add(FW_CHECKSUM_OF_NOTHING, &start, sizeof start);
    if (!whole || fw_checksum_add(checksum, bytes, start.size) != seal) {
        free(bytes);
        if (!whole && !ferror(stream))
            return fw_fail(error, FW_BAD_INPUT, "%s became shorter while it was read", path);
        if (!whole)
            return fw_fail(error, FW_SYSTEM_FAILED, "cannot read %s: %s", path, strerror(errno));
        return fw_fail(error, FW_BAD_INPUT, "%s is damaged: its checksum does not match", path);
    }
    *payload = bytes;
    *size = start.size;
    return FW_OK;
}

fw_status fw_sealed_file_read(const fw_folder *folder, const char *name, const char *kind,
                              unsigned char **payload, uint64_t *size, fw_error *error)
{
    char path[FW_PATH_SIZE];
    *payload = NULL;
    *size = 0;
    FW_TRY(fw_folder_path(folder, name, path, error));
    int descriptor;
    FW_TRY(fw_regular_file_open(&descriptor, path, false, error));
    FILE *stream = fdopen(descriptor, "rb");
    if (!stream) {
        close(descriptor);
        return fw_fail_memory(error, path);
    }
    fw_status status = read_stream(stream, path, kind, payload, size, error);
    fclose(stream);
    return status;
}
