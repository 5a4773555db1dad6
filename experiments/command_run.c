/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_run.c - run and resume: an experiment with its results, pictures and verdicts. */
#include "experiments/command.h"
#include "experiments/interrupt.h"
#include "experiments/playback.h"
#include "experiments/plot.h"
#include "experiments/provenance.h"
#include "experiments/study.h"
#include "experiments/verdict.h"

#include <stdlib.h>
#include <string.h>

/* What comes after the last step: pictures, the table, and where everything lies. */
static fw_status tell(const fw_scenario *scenario, const fw_study *study, const char *directory,
                      bool no_plot, fw_error *error)
{
    printf("%s\n", scenario->title);
    int failures = fw_verdict_print(stdout, scenario, fw_study_measurement(study));
    printf("results: %s/%s\n", directory, FW_TRAJECTORY_FILE);
    if (fw_study_table(study))
        printf("profile: %s/%s; `fretwork profile %s` prints it\n", directory, FW_PROFILE_FILE,
               directory);
    fflush(stdout);
    if (!no_plot) FW_TRY(fw_plot_all(directory, stdout, error));
    return failures > 0 ? FW_EXPECTATION_FAILED : FW_OK;
}

static fw_status finish(fw_study *study, const fw_scenario *scenario, const char *directory,
                        bool no_plot, fw_error *error)
{
    /* Until here a signal ends the program at once, and whatever it leaves can be resumed. */
    fw_interrupt_watch();
    FW_TRY(fw_study_to_end(study, error));
    return tell(scenario, study, directory, no_plot, error);
}

fw_status fw_command_run(const fw_arguments *arguments, fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1], standard[FW_NAME_BYTES + 16];
    FW_TRY(fw_command_load(&scenario, arguments->words[0], arguments, name, error));
    snprintf(standard, sizeof standard, "results/%s", name);
    const char *directory = arguments->output ? arguments->output : standard;
    const fw_run_options options = {.directory = directory,
                                    .overwrite = arguments->overwrite,
                                    .threads = fw_command_threads(arguments),
                                    .at_once = arguments->threads,
                                    .name = name,
                                    .progress = arguments->quiet ? NULL : stderr,
                                    .cautions = stderr};
    fw_study *study;
    fw_status status = fw_study_begin(&study, scenario, &options, error);
    if (status == FW_OK) {
        status = finish(study, scenario, directory, arguments->no_plot, error);
        fw_study_destroy(study);
    }
    fw_scenario_destroy(scenario);
    return status;
}

/* Results are the same to the last bit only within one build. */
static void compare_revisions(const fw_playback *playback, const char *directory)
{
    fw_provenance now = fw_provenance_now();
    if (strcmp(playback->revision, now.revision) == 0) return;
    fprintf(stderr,
            "fretwork: %s was begun by revision %s and goes on with %s; results of two revisions "
            "may differ in the last digits\n",
            directory, playback->revision, now.revision);
}

/* The scenario of a result, as it was run. */
static fw_status load_scenario_of(const char *directory, fw_scenario **scenario, fw_error *error)
{
    fw_playback *playback;
    FW_TRY(fw_trajectory_mend(directory, error));
    FW_TRY(fw_playback_open(&playback, directory, error));
    fw_status status = FW_OK;
    if (strcmp(playback->exit_reason, FW_RUN_FINISHED) == 0)
        status = fw_fail(error, FW_BAD_INPUT, "%s: the run is finished, there is nothing to resume",
                         directory);
    else
        status = fw_scenario_read(scenario, directory, playback->scenario,
                                  strlen(playback->scenario), NULL, 0, error);
    if (status == FW_OK) compare_revisions(playback, directory);
    fw_playback_close(playback);
    return status;
}

fw_status fw_command_resume(const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0];
    fw_scenario *scenario;
    FW_TRY(load_scenario_of(directory, &scenario, error));
    const fw_run_options options = {.directory = directory,
                                    .threads = fw_command_threads(arguments),
                                    .at_once = arguments->threads,
                                    .name = directory,
                                    .progress = arguments->quiet ? NULL : stderr,
                                    .cautions = stderr};
    fw_study *study;
    char note[FW_SENTENCE_SIZE];
    fw_status status = fw_study_resume(&study, scenario, &options, note, error);
    if (status == FW_OK) {
        if (note[0]) fprintf(stderr, "fretwork: %s\n", note);
        status = finish(study, scenario, directory, arguments->no_plot, error);
        fw_study_destroy(study);
    }
    fw_scenario_destroy(scenario);
    return status;
}
