/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_export.c - the motion of a result for other people's programs. Keeps no state. */
#include "experiments/commands/command.h"
#include "experiments/exchange/export.h"
#include "experiments/study/sweep.h"

#include <stdlib.h>

fw_status fw_command_export(const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0];
    char *name;
    FW_TRY(fw_sweep_refuse(directory, error));
    if (!arguments->to)
        return fw_fail(error, FW_BAD_INPUT, "export needs a format, expected --to and one of %s",
                       FW_EXPORT_FORMATS);
    const fw_export_wish wish = {.directory = directory,
                                 .format = arguments->to,
                                 .name = arguments->output,
                                 .every = arguments->every > 0 ? arguments->every : 1};
    FW_TRY(fw_export(&wish, &name, error));
    printf("exported: %s\n", name);
    free(name);
    return FW_OK;
}
