/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sealed_file.h - a file that is there whole or not at all.
 *
 * It is written under another name, handed to the disk and then renamed, and its last eight bytes
 * are a checksum of all others. So whatever happens while it is written, the earlier file of that
 * name stays; and whatever happens to it afterwards is noticed when it is read.
 *
 *     kind (8 bytes) | byte order | version | length of the payload | payload | checksum */
#ifndef FW_SEALED_FILE_H
#define FW_SEALED_FILE_H

#include "core/status.h"
#include "experiments/storage/folder.h"

#include <stddef.h>
#include <stdint.h>

enum { FW_SEAL_KIND_SIZE = 8 };

/* What the name of a file ends with before it is whole; one that was left behind is replaced. */
#define FW_FRESH_SUFFIX ".new"

typedef struct fw_sealed_file fw_sealed_file;

/* Starts a file with a payload of exactly `size` bytes. `kind` says what it is, in at most 8
 * letters. The folder must stay open until the file is committed or abandoned. */
fw_status fw_sealed_file_create(fw_sealed_file **file, const fw_folder *folder, const char *name,
                                const char *kind, uint64_t size, fw_error *error);
/* Appends to the payload. The commit reports a failure. */
void fw_sealed_file_write(fw_sealed_file *file, const void *bytes, size_t count);
/* Seals the file and puts it in the place of an earlier one; releases it in any case. On failure
 * the earlier one stays. */
fw_status fw_sealed_file_commit(fw_sealed_file *file, fw_error *error);

/* The payload of a file, in memory to be freed. FW_BAD_INPUT when it is missing, of another kind,
 * cut short or altered; FW_SYSTEM_FAILED when it cannot be read. */
fw_status fw_sealed_file_read(const fw_folder *folder, const char *name, const char *kind,
                              unsigned char **payload, uint64_t *size, fw_error *error);

#endif
