/* SPDX-License-Identifier: GPL-3.0-or-later */
/* manifest.c - names and checksums of files. Keeps no state between calls; the payload of the
 * file is a row of entries. An entry comes before its file and stays: whenever the process ends,
 * a file of that name is either the earlier or the later one, and both are known. Start reading
 * at fw_manifest_enter(). */
#include "experiments/storage/manifest.h"

#include "experiments/storage/checksum.h"
#include "experiments/storage/sealed_file.h"
#include "experiments/storage/whole_file.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { NAME_SIZE = 240, FILE_SIZE_MAX = 1 << 28, ENTRIES_MAX = 1 << 16 };

typedef struct entry {
    char name[NAME_SIZE];
    uint64_t size, checksum;
} entry;

_Static_assert(sizeof(entry) == 256, "entries are written as they lie in memory");

typedef struct manifest {
    fw_folder *folder;
    entry *item;
    size_t count;
} manifest;

static fw_status open_manifest(manifest *m, const char *directory, fw_error *error)
{
    uint64_t size = 0;
    unsigned char *payload = NULL;
    *m = (manifest){0};
    FW_TRY(fw_folder_visit(&m->folder, directory, error));
    if (!fw_folder_has(m->folder, FW_MANIFEST_FILE)) return FW_OK;
    fw_status status =
        fw_sealed_file_read(m->folder, FW_MANIFEST_FILE, FW_MANIFEST_KIND, &payload, &size, error);
    if (status == FW_OK && (size % sizeof(entry) != 0 || size / sizeof(entry) > ENTRIES_MAX)) {
        status =
            fw_fail(error, FW_BAD_INPUT, "%s/" FW_MANIFEST_FILE " is no list of files", directory);
        free(payload);
    }
    if (status != FW_OK) {
        fw_folder_close(m->folder);
        m->folder = NULL;
        return status;
    }
    m->item = (entry *)payload;
    m->count = size / sizeof(entry);
    return FW_OK;
}

static void close_manifest(manifest *m)
{
    fw_folder_close(m->folder);
    free(m->item);
}

static entry entry_of(const char *name, const void *bytes, size_t count)
{
    entry made = {.size = count, .checksum = fw_checksum_add(FW_CHECKSUM_OF_NOTHING, bytes, count)};
    snprintf(made.name, sizeof made.name, "%s", name);
    return made;
}

static bool has_entry(const manifest *m, const entry *wanted)
{
    for (size_t n = 0; n < m->count; ++n)
        if (m->item[n].size == wanted->size && m->item[n].checksum == wanted->checksum &&
            strncmp(m->item[n].name, wanted->name, NAME_SIZE) == 0)
            return true;
    return false;
}

static fw_status add_entry(const manifest *m, const entry *added, fw_error *error)
{
    fw_sealed_file *file;
    const size_t kept = m->count < ENTRIES_MAX ? m->count : ENTRIES_MAX - 1;
    FW_TRY(fw_sealed_file_create(&file, m->folder, FW_MANIFEST_FILE, FW_MANIFEST_KIND,
                                 (kept + 1) * sizeof(entry), error));
    /* The oldest go first. */
    if (kept > 0) fw_sealed_file_write(file, &m->item[m->count - kept], kept * sizeof(entry));
    fw_sealed_file_write(file, added, sizeof *added);
    return fw_sealed_file_commit(file, error);
}

static fw_status enter(const char *directory, const entry *added, fw_error *error)
{
    manifest m;
    FW_TRY(open_manifest(&m, directory, error));
    const fw_status status = has_entry(&m, added) ? FW_OK : add_entry(&m, added, error);
    close_manifest(&m);
    return status;
}

fw_status fw_manifest_write(const char *directory, const char *name, const void *bytes,
                            size_t count, fw_error *error)
{
    char path[FW_PATH_SIZE];
    struct stat facts;
    const entry added = entry_of(name, bytes, count);
    FW_TRY(fw_path_join(path, directory, name, error));
    if (lstat(path, &facts) == 0 && !S_ISREG(facts.st_mode))
        return fw_fail(error, FW_BAD_INPUT, "%s is not a file", path);
    FW_TRY(enter(directory, &added, error));
    return fw_whole_file_write(path, bytes, count, error);
}

/* What is there now, whether the manifest has it or not. */
static fw_status read_file(char **bytes, size_t *size, const char *directory, const char *name,
                           fw_error *error)
{
    char path[FW_PATH_SIZE];
    *bytes = NULL;
    FW_TRY(fw_path_join(path, directory, name, error));
    return fw_regular_file_read(bytes, size, path, FILE_SIZE_MAX, error);
}

fw_status fw_manifest_enter(const char *directory, const char *name, fw_error *error)
{
    char *bytes;
    size_t size;
    FW_TRY(read_file(&bytes, &size, directory, name, error));
    const entry added = entry_of(name, bytes, size);
    free(bytes);
    return enter(directory, &added, error);
}

fw_status fw_manifest_read(char **bytes, size_t *size, const char *directory, const char *name,
                           fw_error *error)
{
    manifest m;
    FW_TRY(read_file(bytes, size, directory, name, error));
    fw_status status = open_manifest(&m, directory, error);
    if (status == FW_OK) {
        const entry found = entry_of(name, *bytes, *size);
        if (!has_entry(&m, &found))
            status = fw_fail(error, FW_BAD_INPUT,
                             "%s/%s is damaged or was changed: the checksum of the folder's list "
                             "of files does not match",
                             directory, name);
        close_manifest(&m);
    }
    if (status == FW_OK) return FW_OK;
    free(*bytes);
    *bytes = NULL;
    return status;
}

fw_status fw_manifest_check(const char *directory, const char *name, fw_error *error)
{
    char *bytes;
    size_t size;
    FW_TRY(fw_manifest_read(&bytes, &size, directory, name, error));
    free(bytes);
    return FW_OK;
}
