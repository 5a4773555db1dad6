/* SPDX-License-Identifier: GPL-3.0-or-later */
/* result_files.h - the files by which a folder holds a result, and how each is known to be one of
 * this program's, by its name and by what is in it: a folder may hold files of the user's own. */
#ifndef FW_RESULT_FILES_H
#define FW_RESULT_FILES_H

#include "core/status.h"

/* Name number n, from 0 on; NULL behind the last. Files that were left behind before they were
 * whole are among them. */
const char *fw_result_file(int number);
/* Whether file number n of a folder is one of this program's: FW_BAD_INPUT where it is not. */
fw_status fw_result_file_check(const char *directory, int number, fw_error *error);

#endif
