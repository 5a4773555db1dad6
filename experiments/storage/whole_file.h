/* SPDX-License-Identifier: GPL-3.0-or-later */
/* whole_file.h - a file that appears under its name only when all of it is on disk. */
#ifndef FW_WHOLE_FILE_H
#define FW_WHOLE_FILE_H

#include "core/status.h"

#include <stddef.h>
#include <stdio.h>

/* Writes bytes into a temporary neighbour of `name`, brings them to disk and renames; a failure
 * leaves what was there before, and a neighbour that a killed process left goes with the next
 * writing. What exists and is no regular file (a pipe with a reader, a device) is written to
 * directly. FW_SYSTEM_FAILED with a sentence that names the file and the reason. */
fw_status fw_whole_file_write(const char *name, const void *bytes, size_t count, fw_error *error);

/* The same for what is written little by little. */
typedef struct fw_whole_file fw_whole_file;
fw_status fw_whole_file_begin(fw_whole_file **file, const char *name, fw_error *error);
/* Where to write; the file's. */
FILE *fw_whole_file_stream(const fw_whole_file *file);
/* The file in which it is until it gets its name, for another program that writes it. */
const char *fw_whole_file_place(const fw_whole_file *file);
/* Brings it to disk, gives it its name, and releases it; also where that fails. */
fw_status fw_whole_file_commit(fw_whole_file *file, fw_error *error);
/* Releases it; nothing is left of it. NULL is legal. */
void fw_whole_file_abandon(fw_whole_file *file);

#endif
