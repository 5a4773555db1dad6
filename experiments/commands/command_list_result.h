/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_list_result.h - what `list` says of a result. */
#ifndef FW_COMMAND_LIST_RESULT_H
#define FW_COMMAND_LIST_RESULT_H

#include "core/status.h"

#include <stdbool.h>

/* Is the word of `list` a folder of results, or a results file? A word without a slash may be that
 * of an experiment. */
bool fw_command_is_result(const char *word);
/* FW_BAD_INPUT: it holds no result, or a sweep. */
fw_status fw_command_list_result(const char *directory, bool json, fw_error *error);

#endif
