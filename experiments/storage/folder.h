/* SPDX-License-Identifier: GPL-3.0-or-later */
/* folder.h - the folder in which a run keeps its results.
 * Whoever writes into it holds it: a second writer is refused, readers are not. */
#ifndef FW_FOLDER_H
#define FW_FOLDER_H

#include "core/status.h"
#include "experiments/storage/regular_file.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct fw_folder fw_folder;

/* Makes the folder, and those above it, where they are missing, and holds it. FW_SYSTEM_FAILED when
 * it cannot be made or written to, FW_BAD_INPUT when another process holds it. */
fw_status fw_folder_create(fw_folder **folder, const char *path, fw_error *error);
/* The same without holding it. */
fw_status fw_folder_make(const char *path, fw_error *error);
/* Holds a folder that is there; FW_BAD_INPUT when it is not. */
fw_status fw_folder_open(fw_folder **folder, const char *path, fw_error *error);
/* A folder that is there, without holding it: for readers, and beside its holder. */
fw_status fw_folder_visit(fw_folder **folder, const char *path, fw_error *error);
/* Releases it. NULL is legal. */
void fw_folder_close(fw_folder *folder);
/* Releases it, and removes it and those above it as far as fw_folder_create made them and they
 * are empty. NULL is legal. */
void fw_folder_abandon(fw_folder *folder);

/* Whether there is anything of that name, if only a link. */
bool fw_folder_has(const fw_folder *folder, const char *name);
/* The same of the folder of that path, as it is now. */
bool fw_folder_path_has(const char *folder, const char *name);
/* Bytes that are free where it lies; INFINITY where the system does not know. */
double fw_folder_room(const fw_folder *folder);
/* "FOLDER/name" into `path` of FW_PATH_SIZE bytes; FW_BAD_INPUT when that is too long. */
fw_status fw_folder_path(const fw_folder *folder, const char *name, char *path, fw_error *error);
/* Whether there was anything to remove makes no difference. */
fw_status fw_folder_remove(const fw_folder *folder, const char *name, fw_error *error);
/* Removes a file that something may hold open, and gives its space back at once. */
void fw_folder_discard(const fw_folder *folder, const char *name);
/* `fresh` takes the place of `name` in one step, for good: the folder is synchronised. */
fw_status fw_folder_replace(const fw_folder *folder, const char *fresh, const char *name,
                            fw_error *error);
/* Waits until the disk has the names. */
fw_status fw_folder_sync(const fw_folder *folder, fw_error *error);

#endif
