/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scratch_folder.c - a folder for files on their way. Keeps no state. */
#include "experiments/storage/scratch_folder.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

fw_status fw_scratch_folder_make(char path[FW_PATH_SIZE], const char *purpose, fw_error *error)
{
    const char *wish = getenv("TMPDIR");
    const char *parent = wish && *wish ? wish : "/tmp";
    const int length = snprintf(path, FW_PATH_SIZE, "%s/fretwork-%s-XXXXXX", parent, purpose);
    if (length < FW_PATH_SIZE && mkdtemp(path)) return FW_OK;
    const char *reason = strerror(length < FW_PATH_SIZE ? errno : ENAMETOOLONG);
    path[0] = '\0';
    return fw_fail(error, FW_SYSTEM_FAILED, "cannot make a folder for a %s in %.200s: %s", purpose,
                   parent, reason);
}
