/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_cite.c - cite: the BibTeX entries of what an experiment, or a result, rests on. Keeps
 * no state. */
#include "citation.h"
#include "experiments/commands/command.h"
#include "experiments/results/playback.h"
#include "experiments/scenario/catalogue.h"
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

/* A result comes before an experiment of the catalogue that is called the same. */
fw_status fw_command_cite(const fw_arguments *arguments, fw_error *error)
{
    fw_scenario *scenario = NULL;
    char name[FW_NAME_BYTES + 1];
    const char *word = arguments->words[0];
    const bool folder = is_folder(word);
    fw_status status = folder ? load_result(&scenario, word, error) : FW_BAD_INPUT;
    /* A folder that holds no result: its name may still be an experiment's. */
    const fw_catalogue_entry *entry;
    fw_error own;
    if (status == FW_BAD_INPUT && (!folder || fw_catalogue_find(&entry, word, &own) == FW_OK))
        status = fw_command_load(&scenario, word, arguments, name, error);
    if (status == FW_OK) fw_citation_print(stdout, scenario);
    fw_scenario_destroy(scenario);
    return status;
}
