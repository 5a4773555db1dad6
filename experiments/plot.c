/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "experiments/plot.h"

#include "experiments/command.h"

fw_status fw_plot_all(const char *directory, FILE *out, fw_error *error)
{
    (void)directory;
    (void)out;
    (void)error;
    return FW_OK;
}

fw_status fw_command_plot(const fw_arguments *arguments, fw_error *error)
{
    return fw_plot_all(arguments->words[0], stdout, error);
}
