/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export.h - the motion of a result as files of other people's programs. Every value is that of the
 * results file, to the last bit; one frame is held in memory at a time. */
#ifndef FW_EXPORT_H
#define FW_EXPORT_H

#include "core/status.h"

#include <stdint.h>

/* The formats: name and what reads it. */
#define FW_EXPORT_FORMATS "xdmf, extxyz, vtp, csv, data"

typedef struct fw_export_wish {
    const char *directory; /* of the result */
    const char *format;    /* one of FW_EXPORT_FORMATS */
    const char *name; /* file; NULL: DIRECTORY with the format's ending, beside the directory */
    int64_t every;    /* only every so many frames, from the first on; >= 1 */
} fw_export_wish;

/* `name`, to be freed: the file that was made, NULL where it failed. FW_BAD_INPUT for a result that
 * cannot be read or a format that there is none of; FW_SYSTEM_FAILED for what cannot be written. */
fw_status fw_export(const fw_export_wish *wish, char **name, fw_error *error);

#endif
