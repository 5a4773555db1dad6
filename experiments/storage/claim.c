/* SPDX-License-Identifier: GPL-3.0-or-later */
/* claim.c - a locked file in a folder.
 * State: its open descriptor. Invariant: whoever has the lock on the file of that name has the
 * claim; a file that lost its name gives none. Start reading at fw_claim_take(). */
#include "experiments/storage/claim.h"

#include "experiments/storage/folder.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

struct fw_claim {
    int descriptor;
    char directory[FW_PATH_SIZE], path[FW_PATH_SIZE];
};

/* Is the open file still the one of that name? Its last holder may have removed it meanwhile. */
static bool has_name(int descriptor, const char *path)
{
    struct stat own, named;
    return fstat(descriptor, &own) == 0 && lstat(path, &named) == 0 && own.st_dev == named.st_dev &&
           own.st_ino == named.st_ino;
}

/* *descriptor -1: somebody else has the lock. */
static fw_status lock_file(int *descriptor, const char *path, fw_error *error)
{
    for (;;) {
        *descriptor = open(path, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0666);
        /* Its last holder may have removed the folder as well. */
        if (*descriptor < 0 && errno == ENOENT) return FW_OK;
        if (*descriptor < 0)
            return fw_fail(error, FW_SYSTEM_FAILED, "cannot make %s: %s", path, strerror(errno));
        if (flock(*descriptor, LOCK_EX | LOCK_NB) < 0) {
            const int reason = errno;
            close(*descriptor);
            *descriptor = -1;
            if (reason == EWOULDBLOCK) return FW_OK;
            return fw_fail(error, FW_SYSTEM_FAILED, "cannot lock %s: %s", path, strerror(reason));
        }
        if (has_name(*descriptor, path)) return FW_OK;
        close(*descriptor);
    }
}

/* For people who wonder. */
static void write_holder(int descriptor)
{
    char machine[256] = "";
    gethostname(machine, sizeof machine - 1);
    if (ftruncate(descriptor, 0) == 0)
        dprintf(descriptor, FW_CLAIM_KIND "%s, process %ld\n", machine, (long)getpid());
}

/* Somebody may be at work there without a claim, as `fretwork resume` of the folder is. */
static fw_status look_for_holder(bool *held, const char *directory, fw_error *error)
{
    fw_folder *folder = NULL;
    fw_error reason;
    const fw_status status = fw_folder_open(&folder, directory, &reason);
    fw_folder_close(folder);
    *held = status == FW_BAD_INPUT;
    if (status == FW_OK || *held) return FW_OK;
    *error = reason;
    return status;
}

fw_status fw_claim_take(fw_claim **claim, const char *directory, fw_error *error)
{
    *claim = NULL;
    fw_claim *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, directory);
    snprintf(made->directory, sizeof made->directory, "%s", directory);
    fw_status status = fw_folder_make(directory, error);
    if (status == FW_OK) status = fw_path_join(made->path, directory, FW_CLAIM_FILE, error);
    if (status == FW_OK) status = lock_file(&made->descriptor, made->path, error);
    if (status != FW_OK || made->descriptor < 0) {
        free(made);
        return status;
    }
    bool held;
    status = look_for_holder(&held, directory, error);
    if (status != FW_OK || held) {
        fw_claim_release(made);
        return status;
    }
    write_holder(made->descriptor);
    *claim = made;
    return FW_OK;
}

void fw_claim_tidy(const char *directory)
{
    char path[FW_PATH_SIZE];
    fw_error ignored;
    fw_claim *claim = NULL;
    if (fw_path_join(path, directory, FW_CLAIM_FILE, &ignored) != FW_OK || access(path, F_OK) != 0)
        return;
    if (fw_claim_take(&claim, directory, &ignored) == FW_OK) fw_claim_release(claim);
}

void fw_claim_release(fw_claim *claim)
{
    if (!claim) return;
    /* While it is locked nobody else can have the file of that name. */
    unlink(claim->path);
    close(claim->descriptor);
    rmdir(claim->directory);
    free(claim);
}
