/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_cite.c - cite: the BibTeX entries of what an experiment, or a result, rests on. */
#include "citation.h"
#include "experiments/commands/command.h"
#include "experiments/results/playback.h"
#include "experiments/study/sweep.h"

#include <string.h>
#include <sys/stat.h>

static bool is_folder(const char *word)
{
    struct stat facts;
    return stat(word, &facts) == 0 && S_ISDIR(facts.st_mode);
}

static fw_status load_result(fw_scenario **scenario, const char *directory, fw_error *error)
{
    fw_playback *playback;
    *scenario = NULL;
    if (fw_sweep_is_in(directory)) return fw_sweep_load(scenario, directory, error);
    FW_TRY(fw_playback_open(&playback, directory, error));
    const fw_status status = fw_scenario_read(scenario, directory, playback->scenario,
                                              strlen(playback->scenario), NULL, 0, error);
    fw_playback_close(playback);
    return status;
}

/* A name of the catalogue comes before a folder that happens to be called the same. */
fw_status fw_command_cite(const fw_arguments *arguments, fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1];
    const char *word = arguments->words[0];
    fw_status status = fw_command_load(&scenario, word, arguments, name, error);
    if (status == FW_BAD_INPUT && is_folder(word)) status = load_result(&scenario, word, error);
    if (status == FW_OK) fw_citation_print(stdout, scenario);
    fw_scenario_destroy(scenario);
    return status;
}
