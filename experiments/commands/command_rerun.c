/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_rerun.c - a result from its file alone: run again, and held against what is there. Keeps
 * no state. Start reading at fw_command_rerun(). */
#include "experiments/commands/command.h"
#include "experiments/results/compare.h"
#include "experiments/storage/regular_file.h"
#include "experiments/study/sweep.h"

#include <string.h>

static fw_status compare(fw_playback *then, const char *before, const char *directory,
                         fw_error *error)
{
    fw_playback *now;
    int differing = 0;
    FW_TRY(fw_playback_open(&now, directory, error));
    fw_status status = fw_compare(then, now, stdout, &differing, error);
    if (status == FW_OK && differing == 0) {
        printf("%s and %s are the same, bit by bit\n", before, directory);
    } else if (status == FW_OK) {
        printf("%s and %s differ, as said above; what could explain it:\n", before, directory);
        if (fw_compare_provenance(then, now, stdout) == 0)
            printf("  nothing that the results know of: program, compiler, flags, instructions "
                   "and libraries are the same\n");
        status = fw_playback_check(then, error);
        if (status == FW_OK) status = fw_playback_check(now, error);
        if (status == FW_OK) status = FW_EXPECTATION_FAILED;
    }
    fw_playback_close(now);
    return status;
}

/* "results/bounce/" becomes "results/bounce-again". */
static fw_status default_name(char name[FW_PATH_SIZE], const char *before, fw_error *error)
{
    const size_t length = strlen(before);
    if (length > 3 && strncmp(before + length - 3, ".h5", 3) == 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "rerun of a results file needs a folder for the new results, expected -o "
                       "DIR");
    return fw_path_beside(name, before, "-again", error);
}

fw_status fw_command_rerun(const fw_arguments *arguments, fw_error *error)
{
    const char *before = arguments->words[0];
    char usual[FW_PATH_SIZE];
    fw_playback *then;
    fw_scenario *scenario = NULL;
    FW_TRY(fw_sweep_refuse(before, error));
    if (!arguments->output) FW_TRY(default_name(usual, before, error));
    const char *directory = arguments->output ? arguments->output : usual;
    FW_TRY(fw_playback_open(&then, before, error));
    fw_status status = FW_OK;
    if (strcmp(then->exit_reason, FW_RUN_FINISHED) != 0)
        status = fw_fail(error, FW_BAD_INPUT, "%s: the run is not finished, %s", before,
                         then->exit_reason);
    if (status == FW_OK)
        status = fw_scenario_read(&scenario, before, then->scenario, strlen(then->scenario), NULL,
                                  0, error);
    if (status == FW_OK)
        status = fw_command_run_scenario(scenario, arguments, directory, before, error);
    /* What it expects was told; here it counts whether it is the same. */
    if (status == FW_OK || status == FW_EXPECTATION_FAILED)
        status = compare(then, before, directory, error);
    fw_scenario_destroy(scenario);
    fw_playback_close(then);
    return status;
}
