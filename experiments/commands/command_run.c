/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_run.c - run and resume: an experiment with its results, pictures and verdicts. Keeps no
 * state. Start reading at fw_command_run(). */
#include "experiments/commands/command.h"
#include "experiments/measures/verdict.h"
#include "experiments/results/playback.h"
#include "experiments/results/provenance.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/leftovers.h"
#include "experiments/study/study.h"
#include "experiments/study/sweep.h"
#include "experiments/text/text.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

static fw_status finish(fw_study *study, const fw_scenario *scenario, const char *directory,
                        bool no_plot, fw_error *error)
{
    fw_verdicts verdicts;
    /* Until here a signal ends the program at once, and whatever it leaves can be resumed. */
    fw_interrupt_watch();
    FW_TRY(fw_study_to_end(study, error));
    FW_TRY(fw_verdicts_create(&verdicts, scenario, fw_study_measurement(study), error));
    const fw_status status = fw_report_result(scenario, &verdicts, fw_study_certificate(study),
                                              fw_study_warnings(study), directory, no_plot, error);
    fw_verdicts_clear(&verdicts);
    return status;
}

static fw_status run(const fw_scenario *scenario, const fw_run_options *options,
                     const fw_leftovers *leftovers, bool no_plot, fw_error *error)
{
    fw_study *study;
    FW_TRY(fw_study_begin(&study, scenario, options, error));
    fw_status status = fw_leftovers_remove(leftovers, error);
    if (status == FW_OK) status = finish(study, scenario, options->directory, no_plot, error);
    fw_study_destroy(study);
    return status;
}

static fw_status run_sweep(const fw_scenario *scenario, const fw_run_options *options,
                           const fw_leftovers *leftovers, bool no_plot, fw_error *error)
{
    fw_sweep *sweep;
    FW_TRY(fw_sweep_begin(&sweep, scenario, options, error));
    fw_status status = fw_leftovers_remove(leftovers, error);
    if (status == FW_OK)
        status = fw_report_sweep(sweep, scenario, options->directory, no_plot, error);
    fw_sweep_destroy(sweep);
    return status;
}

/* A run that was interrupted can go on: that is said before it is replaced. */
static fw_status refuse_unfinished(const char *directory, fw_error *error)
{
    fw_playback *playback;
    fw_error own;
    if (fw_sweep_is_in(directory)) return FW_OK;
    const fw_status status = fw_playback_open(&playback, directory, &own);
    if (status == FW_SYSTEM_FAILED) return fw_fail(error, status, "%s", own.sentence);
    if (status != FW_OK) return FW_OK;
    const bool interrupted = strncmp(playback->exit_reason, "interrupted", 11) == 0;
    fw_playback_close(playback);
    if (!interrupted) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s holds a run that is not finished; `fretwork resume %s` goes on with it, "
                   "--overwrite replaces it",
                   directory, directory);
}

fw_status fw_command_run_scenario(const fw_scenario *scenario, const fw_arguments *arguments,
                                  const char *directory, const char *name, fw_error *error)
{
    fw_progress progress;
    fw_run_options options = fw_command_run_options(arguments, directory, name, &progress);
    options.overwrite = arguments->overwrite;
    fw_leftovers *leftovers;
    if (!arguments->overwrite) FW_TRY(refuse_unfinished(directory, error));
    FW_TRY(fw_leftovers_find(&leftovers, directory, scenario, arguments->overwrite, error));
    const fw_status status = (fw_scenario_is_sweep(scenario) ? run_sweep : run)(
        scenario, &options, leftovers, arguments->no_plot, error);
    fw_leftovers_destroy(leftovers);
    return status;
}

fw_status fw_command_run(const fw_arguments *arguments, fw_error *error)
{
    fw_scenario *scenario;
    char name[FW_NAME_BYTES + 1], standard[FW_NAME_BYTES + 16];
    FW_TRY(fw_command_load(&scenario, arguments->words[0], arguments, name, error));
    snprintf(standard, sizeof standard, "results/%s", name);
    const char *directory = arguments->output ? arguments->output : standard;
    const fw_status status = fw_command_run_scenario(scenario, arguments, directory, name, error);
    fw_scenario_destroy(scenario);
    return status;
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
    if (status == FW_OK) fw_provenance_compare(stderr, playback->revision, directory);
    fw_playback_close(playback);
    return status;
}

static fw_status go_on(const char *directory, const fw_run_options *options, bool no_plot,
                       fw_error *error)
{
    fw_scenario *scenario;
    fw_study *study;
    char note[FW_SENTENCE_SIZE];
    FW_TRY(load_scenario_of(directory, &scenario, error));
    fw_status status = fw_leftovers_check(directory, scenario, error);
    if (status == FW_OK) status = fw_study_resume(&study, scenario, options, note, error);
    if (status == FW_OK) {
        if (note[0]) {
            fputs("fretwork: ", stderr);
            fw_text_print_line(stderr, note);
            fputc('\n', stderr);
        }
        status = finish(study, scenario, directory, no_plot, error);
        fw_study_destroy(study);
    }
    fw_scenario_destroy(scenario);
    return status;
}

static fw_status go_on_with_sweep(const char *directory, const fw_run_options *options,
                                  bool no_plot, fw_error *error)
{
    fw_scenario *scenario;
    fw_sweep *sweep;
    FW_TRY(fw_sweep_load(&scenario, directory, error));
    fw_status status = fw_leftovers_check(directory, scenario, error);
    if (status == FW_OK) status = fw_sweep_resume(&sweep, scenario, options, error);
    if (status == FW_OK) {
        status = fw_report_sweep(sweep, scenario, directory, no_plot, error);
        fw_sweep_destroy(sweep);
    }
    fw_scenario_destroy(scenario);
    return status;
}

fw_status fw_command_resume(const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0];
    fw_progress progress;
    const fw_run_options options =
        fw_command_run_options(arguments, directory, directory, &progress);
    return fw_sweep_is_in(directory)
               ? go_on_with_sweep(directory, &options, arguments->no_plot, error)
               : go_on(directory, &options, arguments->no_plot, error);
}
