/* SPDX-License-Identifier: GPL-3.0-or-later */
/* result_files.c - names of files, and what they begin with. Keeps no state. Start reading at
 * fw_result_file_check(). */
#include "experiments/results/result_files.h"

#include "experiments/results/checkpoint.h"
#include "experiments/results/trajectory.h"
#include "experiments/storage/claim.h"
#include "experiments/storage/hdf5_file.h"
#include "experiments/storage/manifest.h"
#include "experiments/storage/sealed_file.h"
#include "trajectory_head.h"

#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* With which an HDF5 file begins. */
#define HDF5_SIGNATURE "\x89HDF\r\n\x1a\n"

/* How a file is known. */
typedef enum known_by { BY_START, BY_CREATOR, BY_MANIFEST } known_by;

static const struct {
    const char *name;
    known_by how;
    const char *start; /* of a file that is known by it; an unfinished one may be empty */
} files[] = {
    {"checkpoint-A", BY_START, FW_CHECKPOINT_KIND},
    {"checkpoint-A" FW_FRESH_SUFFIX, BY_START, FW_CHECKPOINT_KIND},
    {"checkpoint-B", BY_START, FW_CHECKPOINT_KIND},
    {"checkpoint-B" FW_FRESH_SUFFIX, BY_START, FW_CHECKPOINT_KIND},
    {FW_HEAD_WHILE_CUTTING, BY_START, FW_HEAD_KIND},
    {FW_HEAD_WHILE_CUTTING FW_FRESH_SUFFIX, BY_START, FW_HEAD_KIND},
    {FW_HEAD_AFTER_CUTTING, BY_START, FW_HEAD_KIND},
    {FW_TRAJECTORY_FILE, BY_CREATOR, NULL},
    {FW_TRAJECTORY_FILE FW_FRESH_SUFFIX, BY_START, HDF5_SIGNATURE},
    {FW_CLAIM_FILE, BY_START, FW_CLAIM_KIND},
    {FW_SWEEP_FILE, BY_MANIFEST, NULL},
    {FW_SWEEP_SCENARIO, BY_MANIFEST, NULL},
    /* The last: it lists the others. */
    {FW_MANIFEST_FILE, BY_START, FW_MANIFEST_KIND},
    {FW_MANIFEST_FILE FW_FRESH_SUFFIX, BY_START, FW_MANIFEST_KIND},
};

enum { FILES = sizeof files / sizeof files[0] };

const char *fw_result_file(int number)
{
    return number < FILES ? files[number].name : NULL;
}

/* A regular file that begins with these letters, or has none at all. */
static bool begins_with(const char *path, const char *start)
{
    int descriptor;
    fw_error ignored;
    struct stat facts = {0};
    char found[16] = {0};
    if (fw_regular_file_open(&descriptor, path, false, &ignored) != FW_OK) return false;
    const ssize_t length = read(descriptor, found, strlen(start));
    const bool same = length == (ssize_t)strlen(start) && memcmp(found, start, strlen(start)) == 0;
    const bool empty = fstat(descriptor, &facts) == 0 && facts.st_size == 0;
    close(descriptor);
    return same || empty;
}

/* A results file that can be opened names its maker. One that cannot, as it was damaged or cut
 * when its run was killed, is known by what lies beside it. */
static bool is_our_trajectory(const char *directory, const char *path)
{
    fw_hdf5 *file;
    fw_error ignored;
    char creator[64];
    int descriptor;
    if (fw_regular_file_open(&descriptor, path, false, &ignored) != FW_OK) return false;
    close(descriptor);
    if (fw_hdf5_open(&file, path, false, &ignored) == FW_OK) {
        const bool ours =
            fw_hdf5_read_attribute(file, "h5md/creator", "name", creator, sizeof creator) &&
            strcmp(creator, "fretwork") == 0;
        fw_hdf5_close(file, &ignored);
        return ours;
    }
    for (int n = 0; n < FILES; ++n) {
        char beside[FW_PATH_SIZE];
        struct stat facts;
        if (files[n].how != BY_START || strstr(files[n].name, FW_FRESH_SUFFIX)) continue;
        if (fw_path_join(beside, directory, files[n].name, &ignored) == FW_OK &&
            stat(beside, &facts) == 0 && facts.st_size > 0 && begins_with(beside, files[n].start))
            return true;
    }
    return false;
}

fw_status fw_result_file_check(const char *directory, int number, fw_error *error)
{
    char path[FW_PATH_SIZE];
    bool ours = false;
    FW_TRY(fw_path_join(path, directory, files[number].name, error));
    switch (files[number].how) {
    case BY_START:
        ours = begins_with(path, files[number].start);
        break;
    case BY_CREATOR:
        ours = is_our_trajectory(directory, path);
        break;
    case BY_MANIFEST:
        return fw_manifest_check(directory, files[number].name, error);
    }
    return ours ? FW_OK : fw_fail(error, FW_BAD_INPUT, "%s is not this program's", path);
}
