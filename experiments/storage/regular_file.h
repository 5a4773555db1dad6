/* SPDX-License-Identifier: GPL-3.0-or-later */
/* regular_file.h - files of results, opened so that nothing else is taken for one: a pipe or a
 * device is refused and never waited for, a link is not written through, and what is created was
 * not there before. Also the paths that lead to them. */
#ifndef FW_REGULAR_FILE_H
#define FW_REGULAR_FILE_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

enum { FW_PATH_SIZE = 4096 };

/* "DIRECTORY/NAME"; FW_BAD_INPUT when that is too long. */
fw_status fw_path_join(char path[FW_PATH_SIZE], const char *directory, const char *name,
                       fw_error *error);
/* What stands beside a folder: "results/bounce/" and "-again" are "results/bounce-again". A folder
 * that is called "." or ".." goes by its real path. FW_BAD_INPUT when that is too long,
 * FW_SYSTEM_FAILED when it cannot be found. */
fw_status fw_path_beside(char path[FW_PATH_SIZE], const char *directory, const char *ending,
                         fw_error *error);

/* Opens a file that is there. Reading follows links, writing does not. FW_BAD_INPUT when it is
 * missing or no regular file, FW_SYSTEM_FAILED when the system refuses. */
fw_status fw_regular_file_open(int *descriptor, const char *path, bool writable, fw_error *error);
/* Makes an empty file. A file or a link of that name is removed first; what a link points to stays
 * as it is. */
fw_status fw_regular_file_create(int *descriptor, const char *path, fw_error *error);
/* All bytes of a file and a 0 behind them, to be freed. As open; FW_BAD_INPUT beyond `most` bytes.
 */
fw_status fw_regular_file_read(char **bytes, size_t *size, const char *path, size_t most,
                               fw_error *error);

/* FW_BAD_INPUT where there is something else than a folder under that name, such as a link to one:
 * results within results are not written elsewhere. FW_OK where there is nothing. */
fw_status fw_path_check_inner(const char *path, fw_error *error);

#endif
