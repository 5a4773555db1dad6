/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_extend.c - extend: further values of a sweep; what was run stays as it is. Keeps no
 * state. Start reading at fw_command_extend(). */
#include "experiments/commands/command.h"
#include "experiments/study/leftovers.h"
#include "experiments/study/sweep.h"
#include "experiments/study/sweep_extend.h"
#include "report.h"

static fw_status run(const fw_scenario *scenario, const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0];
    fw_progress progress;
    const fw_run_options options =
        fw_command_run_options(arguments, directory, directory, &progress);
    fw_sweep *sweep;
    FW_TRY(fw_leftovers_check(directory, scenario, error));
    FW_TRY(fw_sweep_grow(&sweep, scenario, &options, error));
    const fw_status status = fw_report_sweep(sweep, scenario, directory, arguments->no_plot, error);
    fw_sweep_destroy(sweep);
    return status;
}

fw_status fw_command_extend(const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0];
    fw_scenario *old, *larger;
    if (!fw_sweep_is_in(directory))
        return fw_fail(error, FW_BAD_INPUT, "%s holds no sweep that could be extended", directory);
    FW_TRY(fw_sweep_load(&old, directory, error));
    fw_status status = fw_sweep_extend(&larger, old, directory, arguments->additions.item,
                                       arguments->additions.count, arguments->settings.item,
                                       arguments->settings.count, error);
    if (status == FW_OK) {
        status = run(larger, arguments, error);
        fw_scenario_destroy(larger);
    }
    fw_scenario_destroy(old);
    return status;
}
