/* SPDX-License-Identifier: GPL-3.0-or-later */
/* folder.c - a results folder, held while somebody writes into it.
 * State: an open descriptor of the folder with the system's lock on it, which ends with the
 * process, however that ends. Start reading at fw_folder_create(). */
#include "experiments/folder.h"

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
    bool fresh; /* made by fw_folder_create */
    char path[];
};

fw_status fw_folder_visit(fw_folder **folder, const char *path, fw_error *error)
{
    *folder = NULL;
    int descriptor = open(path, O_RDONLY | O_DIRECTORY);
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

/* The folders above the last name of `path`. */
static void make_parents(const char *path)
{
    char above[FW_PATH_SIZE];
    if (strlen(path) >= sizeof above) return;
    for (const char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        memcpy(above, path, (size_t)(slash - path));
        above[slash - path] = '\0';
        mkdir(above, 0777);
    }
}

fw_status fw_folder_create(fw_folder **folder, const char *path, fw_error *error)
{
    *folder = NULL;
    if (path[0] == '\0') return fw_fail(error, FW_BAD_INPUT, "the results folder has no name");
    make_parents(path);
    bool fresh = mkdir(path, 0777) == 0;
    if (!fresh && errno != EEXIST) {
        bool misnamed = errno == ENOTDIR || errno == ENAMETOOLONG || errno == ELOOP;
        return fw_fail(error, misnamed ? FW_BAD_INPUT : FW_SYSTEM_FAILED,
                       "cannot make the folder %s: %s", path, strerror(errno));
    }
    FW_TRY(fw_folder_open(folder, path, error));
    (*folder)->fresh = fresh;
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
    if (folder && folder->fresh) rmdir(folder->path);
    fw_folder_close(folder);
}

bool fw_folder_has(const fw_folder *folder, const char *name)
{
    return faccessat(folder->descriptor, name, F_OK, 0) == 0;
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
    int length = snprintf(path, FW_PATH_SIZE, "%s/%s", folder->path, name);
    if (length >= 0 && length < FW_PATH_SIZE) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "the path of the results folder is longer than %d bytes",
                   FW_PATH_SIZE);
}

fw_status fw_folder_remove(const fw_folder *folder, const char *name, fw_error *error)
{
    if (unlinkat(folder->descriptor, name, 0) == 0 || errno == ENOENT) return FW_OK;
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot remove %s/%s: %s", folder->path, name,
                   strerror(errno));
}

void fw_folder_discard(const fw_folder *folder, const char *name)
{
    int descriptor = openat(folder->descriptor, name, O_WRONLY | O_TRUNC);
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
