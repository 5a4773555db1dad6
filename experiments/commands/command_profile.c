/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_profile.c - the profile of a result as a table. Keeps no state. Start reading at
 * fw_command_profile(). */
#include "experiments/commands/command.h"
#include "experiments/measures/profile_table.h"
#include "experiments/study/sweep.h"
#include "experiments/text/spelling.h"

#include <string.h>

static fw_status find_column(const char *name, fw_profile_column *column, fw_error *error)
{
    *column = FW_PROFILE_COLUMNS;
    if (!name) return FW_OK;
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (int c = 0; c < FW_PROFILE_COLUMNS; ++c) {
        *column = (fw_profile_column)c;
        if (strcmp(fw_profile_columns[c].name, name) == 0) return FW_OK;
        fw_suggestion_offer(&suggestion, fw_profile_columns[c].name);
    }
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "a profile has no field %s; did you mean %s?", name,
                       suggestion.best);
    return fw_fail(
        error, FW_BAD_INPUT,
        "a profile has no field %s, expected return-force, bond-return-force, order, "
        "density, temperature, drift-velocity, bond-breaking-rate, relative-displacement or "
        "diffusivity",
        name);
}

/* The axis that the scenario has; another one was not measured. */
static fw_status find_axis(const fw_scenario *scenario, const fw_arguments *arguments, char *axis,
                           fw_error *error)
{
    *axis = scenario->profile.axis ? 'y' : 'x';
    const char *wish = arguments->axis;
    if (!wish || (wish[0] == *axis && wish[1] == '\0')) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "--axis %s, but the run took its profile across %c; a run takes another one "
                   "with `fretwork run NAME --set profile.axis=`, x or y",
                   wish, *axis);
}

static fw_status print_profile(fw_playback *playback, const fw_scenario *scenario,
                               const fw_arguments *arguments, fw_error *error)
{
    char axis;
    fw_profile_column column;
    fw_profile_table *table;
    FW_TRY(find_column(arguments->field, &column, error));
    FW_TRY(find_axis(scenario, arguments, &axis, error));
    FW_TRY(fw_profile_table_read(&table, playback, axis, error));
    fw_profile_table_print(table, column, &scenario->units, stdout);
    fw_profile_table_destroy(table);
    return FW_OK;
}

fw_status fw_command_profile(const fw_arguments *arguments, fw_error *error)
{
    fw_playback *playback;
    FW_TRY(fw_sweep_refuse(arguments->words[0], error));
    FW_TRY(fw_playback_open(&playback, arguments->words[0], error));
    fw_scenario *scenario = NULL;
    fw_status status = fw_scenario_read(&scenario, arguments->words[0], playback->scenario,
                                        strlen(playback->scenario), NULL, 0, error);
    if (status == FW_OK) {
        status = print_profile(playback, scenario, arguments, error);
        fw_scenario_destroy(scenario);
    }
    fw_playback_close(playback);
    return status;
}
