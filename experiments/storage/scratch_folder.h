/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scratch_folder.h - a folder for files on their way, where the system keeps such. */
#ifndef FW_SCRATCH_FOLDER_H
#define FW_SCRATCH_FOLDER_H

#include "core/status.h"
#include "experiments/storage/regular_file.h"

/* Makes a folder that nobody else has, below the one that the environment variable TMPDIR names,
 * or below /tmp, and writes its path. `purpose`, one word, stands in its name. The caller removes
 * it. FW_SYSTEM_FAILED: it cannot be made, and the path is "". */
fw_status fw_scratch_folder_make(char path[FW_PATH_SIZE], const char *purpose, fw_error *error);

#endif
