/* SPDX-License-Identifier: GPL-3.0-or-later */
/* folder.c - a results folder, held while somebody writes into it.
 * State: an open descriptor of the folder with the system's lock on it, which ends with the
 * process, however that ends. Start reading at fw_folder_create(). */
#include "experiments/storage/folder.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

struct fw_folder {
    int descriptor;
    size_t made; /* length of the topmost folder of the path that fw_folder_create made; 0: none */
    char path[];
};

fw_status fw_folder_visit(fw_folder **folder, const char *path, fw_error *error)
{
    *folder = NULL;
    int descriptor = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        bool missing = errno == ENOENT || errno == ENOTDIR;
        return fw_fail(error, missing ? FW_BAD_INPUT : FW_SYSTEM_FAILED,
                       "cannot open the folder %s: %s", path, strerror(errno));
    }
    fw_folder *opened = calloc(1, sizeof *opened + strlen(path) + 1);
    if (!opened) {
        close(descriptor);
        return fw_fail_memory(error, path);
    }
    opened->descriptor = descriptor;
    strcpy(opened->path, path);
    *folder = opened;
    return FW_OK;
}

fw_status fw_folder_open(fw_folder **folder, const char *path, fw_error *error)
{
    FW_TRY(fw_folder_visit(folder, path, error));
    /* Some network file systems know no locks on folders; there a second writer goes unnoticed. */
    if (flock((*folder)->descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return FW_OK;
    fw_folder_close(*folder);
    *folder = NULL;
    return fw_fail(error, FW_BAD_INPUT, "another run is writing into %s", path);
}

/* Makes every folder on the way to `path` that is missing, and that one; 0 or errno. *made: length
 * of the topmost one that was made, 0 if none was. */
static int make_folders(const char *path, size_t *made)
{
    char above[FW_PATH_SIZE];
    *made = 0;
    if (strlen(path) >= sizeof above) return ENAMETOOLONG;
    for (const char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        memcpy(above, path, (size_t)(slash - path));
        above[slash - path] = '\0';
        if (mkdir(above, 0777) == 0 && *made == 0) *made = (size_t)(slash - path);
    }
    if (mkdir(path, 0777) < 0) return errno == EEXIST ? 0 : errno;
    if (*made == 0) *made = strlen(path);
    return 0;
}

/* Those that make_folders made, as far as they are empty. */
static void remove_folders(const char *path, size_t made)
{
    char above[FW_PATH_SIZE];
    size_t length = strlen(path);
    if (made == 0 || length >= sizeof above) return;
    memcpy(above, path, length + 1);
    for (; length >= made; --length) {
        if (above[length] != '\0' && above[length] != '/') continue;
        above[length] = '\0';
        rmdir(above);
    }
}

static fw_status make(const char *path, size_t *made, fw_error *error)
{
    if (path[0] == '\0') return fw_fail(error, FW_BAD_INPUT, "the results folder has no name");
    const int reason = make_folders(path, made);
    if (reason == 0) return FW_OK;
    const bool misnamed = reason == ENOTDIR || reason == ENAMETOOLONG || reason == ELOOP;
    remove_folders(path, *made);
    return fw_fail(error, misnamed ? FW_BAD_INPUT : FW_SYSTEM_FAILED,
                   "cannot make the folder %s: %s", path, strerror(reason));
}

fw_status fw_folder_make(const char *path, fw_error *error)
{
    size_t made;
    return make(path, &made, error);
}

fw_status fw_folder_create(fw_folder **folder, const char *path, fw_error *error)
{
    size_t made;
    *folder = NULL;
    FW_TRY(make(path, &made, error));
    const fw_status status = fw_folder_open(folder, path, error);
    /* Where another run has it now it is no longer ours to remove. */
    if (status == FW_SYSTEM_FAILED) remove_folders(path, made);
    FW_TRY(status);
    (*folder)->made = made;
    if (access(path, W_OK | X_OK) == 0) return FW_OK;
    fw_fail(error, FW_SYSTEM_FAILED, "cannot write into the folder %s: %s", path, strerror(errno));
    fw_folder_abandon(*folder);
    *folder = NULL;
    return FW_SYSTEM_FAILED;
}

void fw_folder_close(fw_folder *folder)
{
    if (!folder) return;
    close(folder->descriptor);
    free(folder);
}

void fw_folder_abandon(fw_folder *folder)
{
    if (folder) remove_folders(folder->path, folder->made);
    fw_folder_close(folder);
}

bool fw_folder_has(const fw_folder *folder, const char *name)
{
    struct stat facts;
    return fstatat(folder->descriptor, name, &facts, AT_SYMLINK_NOFOLLOW) == 0;
}

bool fw_folder_path_has(const char *folder, const char *name)
{
    char path[FW_PATH_SIZE];
    fw_error ignored;
    struct stat facts;
    return fw_path_join(path, folder, name, &ignored) == FW_OK && lstat(path, &facts) == 0;
}

double fw_folder_room(const fw_folder *folder)
{
    struct statvfs facts;
    /* What is kept for the superuser counts as well: whether it may be had shows soon enough. */
    if (fstatvfs(folder->descriptor, &facts) < 0 || facts.f_blocks == 0) return INFINITY;
    return (double)facts.f_bfree * (double)facts.f_frsize;
}

fw_status fw_folder_path(const fw_folder *folder, const char *name, char *path, fw_error *error)
{
    return fw_path_join(path, folder->path, name, error);
}

fw_status fw_folder_remove(const fw_folder *folder, const char *name, fw_error *error)
{
    if (unlinkat(folder->descriptor, name, 0) == 0 || errno == ENOENT) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot remove %s/%s: %s", folder->path, name,
                   strerror(errno));
}

void fw_folder_discard(const fw_folder *folder, const char *name)
{
    struct stat facts;
    /* A file of two names is somebody else's as well: only this name goes. */
    int descriptor =
        openat(folder->descriptor, name, O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0 && fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode) &&
        facts.st_nlink == 1 && ftruncate(descriptor, 0) < 0)
        errno = 0; /* its space comes back when its last holder ends */
    if (descriptor >= 0) close(descriptor);
    unlinkat(folder->descriptor, name, 0);
}

fw_status fw_folder_replace(const fw_folder *folder, const char *fresh, const char *name,
                            fw_error *error)
{
    if (renameat(folder->descriptor, fresh, folder->descriptor, name) < 0)
        return fw_fail(error, FW_SYSTEM_FAILED, "cannot write %s/%s: %s", folder->path, name,
                       strerror(errno));
    return fw_folder_sync(folder, error);
}

fw_status fw_folder_sync(const fw_folder *folder, fw_error *error)
{
    /* A file system that cannot synchronise folders says EINVAL; there is nothing better to do. */
    if (fsync(folder->descriptor) == 0 || errno == EINVAL) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot write the folder %s: %s", folder->path,
                   strerror(errno));
}
