/* SPDX-License-Identifier: GPL-3.0-or-later */
/* manifest.h - which files of a folder the program has written, and whether they are still as it
 * wrote them: DIR/manifest, a sealed file, keeps the name and the checksum of each. So a table that
 * was damaged is noticed when it is read again, and a file of the user's own that happens to have
 * the name of one of ours is not taken for it. */
#ifndef FW_MANIFEST_H
#define FW_MANIFEST_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

#define FW_MANIFEST_FILE "manifest"
#define FW_MANIFEST_KIND "FWFILES" /* with which it begins */

/* Writes DIRECTORY/NAME as a whole (whole_file.h) after the manifest has it. FW_BAD_INPUT where
 * there is something else than a file of that name. */
fw_status fw_manifest_write(const char *directory, const char *name, const void *bytes,
                            size_t count, fw_error *error);
/* Enters a file that the program has written by another way. */
fw_status fw_manifest_enter(const char *directory, const char *name, fw_error *error);

/* All bytes of a file and a 0 behind them, to be freed. FW_BAD_INPUT where it is missing or not as
 * the program wrote it. */
fw_status fw_manifest_read(char **bytes, size_t *size, const char *directory, const char *name,
                           fw_error *error);
/* FW_OK where a file is there as the program wrote it, FW_BAD_INPUT where it is not. */
fw_status fw_manifest_check(const char *directory, const char *name, fw_error *error);

#endif
