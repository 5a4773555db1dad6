/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_folder.c - a sweep as its folder has it, without holding that: what lies there, and one
 * case of it. Keeps no state. Start reading at fw_sweep_load(). */
#include "experiments/study/sweep.h"

#include "experiments/storage/manifest.h"
#include "sweep_case.h"

#include <stdlib.h>
#include <string.h>

bool fw_sweep_is_in(const char *directory)
{
    return fw_folder_path_has(directory, FW_SWEEP_SCENARIO);
}

fw_status fw_sweep_load(fw_scenario **scenario, const char *directory, fw_error *error)
{
    char path[FW_PATH_SIZE], *text;
    size_t size;
    *scenario = NULL;
    FW_TRY(fw_path_join(path, directory, FW_SWEEP_SCENARIO, error));
    FW_TRY(fw_manifest_read(&text, &size, directory, FW_SWEEP_SCENARIO, error));
    const fw_status status = fw_scenario_read(scenario, path, text, size, NULL, 0, error);
    free(text);
    FW_TRY(status);
    if (fw_scenario_is_sweep(*scenario)) return FW_OK;
    fw_scenario_destroy(*scenario);
    *scenario = NULL;
    return fw_fail(error, FW_BAD_INPUT, "%s is not the scenario of a sweep", path);
}

fw_status fw_sweep_refuse(const char *directory, fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_CASE_NAME];
    if (!fw_sweep_is_in(directory)) return FW_OK;
    FW_TRY(fw_sweep_load(&scenario, directory, error));
    fw_scenario_case_name(scenario, 0, name);
    fw_scenario_destroy(scenario);
    return fw_fail(error, FW_BAD_INPUT,
                   "%s holds a sweep, expected the folder of one of its cases, such as %s/%s",
                   directory, directory, name);
}

/* Number of the case of that name. */
static fw_status find_case(const fw_scenario *scenario, const char *directory, const char *name,
                           int *number, fw_error *error)
{
    char known[FW_CASE_NAME];
    for (*number = 0; *number < scenario->study.sweep.case_count; ++*number) {
        fw_scenario_case_name(scenario, *number, known);
        if (strcmp(known, name) == 0) return FW_OK;
    }
    fw_scenario_case_name(scenario, 0, known);
    return fw_fail(error, FW_BAD_INPUT, "%s: the sweep has no case %s, expected one such as %s",
                   directory, name, known);
}

fw_status fw_sweep_run_case(const fw_scenario *scenario, const char *name,
                            const fw_run_options *options, bool *taken, fw_error *error)
{
    fw_run_options own = *options;
    fw_sweep_case c = {.missing = false};
    char path[FW_PATH_SIZE];
    int number;
    *taken = false;
    FW_TRY(find_case(scenario, options->directory, name, &number, error));
    FW_TRY(fw_path_join(path, options->directory, name, error));
    own.directory = path;
    own.overwrite = true;
    fw_status status = fw_sweep_case_make(&c, scenario, number, error);
    if (status == FW_OK) status = fw_sweep_case_complete(&c, &own, error);
    *taken = c.missing;
    fw_sweep_case_clear(&c);
    return status;
}
