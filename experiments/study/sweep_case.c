/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_case.c - one case.
 * Invariant: a case is finished when its results file is, which is the last that its study
 * writes. State: fw_sweep_case, the caller's. Start reading at fw_sweep_case_complete(). */
#include "sweep_case.h"

#include "experiments/results/playback.h"
#include "experiments/results/provenance.h"
#include "experiments/storage/claim.h"
#include "experiments/storage/folder.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/study.h"
#include "experiments/text/text.h"
#include "experiments/study/summary.h"

#include <stdlib.h>
#include <string.h>

/* An expectation has one number in all cases: they are compared by it. */
static fw_status check_expectations(const fw_scenario *scenario, const fw_scenario *sweep,
                                    fw_error *error)
{
    if (scenario->expectation_count == sweep->expectation_count) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "it has %d expectations, expected the %d of the sweep",
                   scenario->expectation_count, sweep->expectation_count);
}

fw_status fw_sweep_case_make(fw_sweep_case *made, const fw_scenario *sweep, int number,
                             fw_error *error)
{
    fw_scenario_case_name(sweep, number, made->name);
    FW_TRY(fw_scenario_read_case(&made->scenario, sweep, number, error));
    const fw_status status = check_expectations(made->scenario, sweep, error);
    return fw_scenario_fail_case(sweep, number, status, error);
}

void fw_sweep_case_clear(fw_sweep_case *c)
{
    fw_verdicts_clear(&c->verdicts);
    fw_scenario_destroy(c->scenario);
    c->scenario = NULL;
}

fw_status fw_sweep_case_check(const fw_sweep_case *c, fw_error *error)
{
    fw_study *study;
    FW_TRY(fw_study_begin(&study, c->scenario, &(fw_run_options){.threads = 1}, error));
    fw_study_destroy(study);
    return FW_OK;
}

/* --- cases that are there already --- */

static fw_status compare_scenarios(const fw_sweep_case *c, const fw_playback *playback,
                                   const char *path, fw_error *error)
{
    char *text;
    FW_TRY(fw_scenario_print(c->scenario, &text, error));
    const bool same = strcmp(text, playback->scenario) == 0;
    free(text);
    if (same) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s holds results of another scenario than the sweep that it lies in", path);
}

static bool is_over(fw_sweep_stage stage)
{
    return stage == FW_STAGE_FINISHED || stage == FW_STAGE_FAILED;
}

/* What the results say, unless somebody is writing them; `claimed`: nobody else is. */
static fw_status look(fw_sweep_case *c, const fw_run_options *options, bool claimed,
                      fw_sweep_stage *found, fw_error *error)
{
    fw_playback *playback;
    const char *path = options->directory;
    FW_TRY(fw_playback_open(&playback, path, error));
    const fw_status status = compare_scenarios(c, playback, path, error);
    *found = strcmp(playback->exit_reason, FW_RUN_FINISHED) == 0 ? FW_STAGE_FINISHED
             : playback->exit_status == FW_DIVERGED              ? FW_STAGE_FAILED
                                                                 : FW_STAGE_BEGUN;
    if (*found == FW_STAGE_FAILED) fw_fail(&c->failure, FW_DIVERGED, "%s", playback->exit_reason);
    if (status == FW_OK && options->warnings && (claimed || is_over(*found)))
        fw_provenance_compare(options->warnings, playback->revision, path);
    fw_playback_close(playback);
    return status;
}

static bool has_results(const char *path)
{
    return fw_folder_path_has(path, FW_TRAJECTORY_FILE);
}

static fw_status read_layer(fw_sweep_case *c, const char *path, fw_error *error)
{
    fw_playback *playback;
    fw_profile_table *table;
    FW_TRY(fw_playback_open(&playback, path, error));
    const fw_status status = fw_profile_table_read(&table, playback, 'x', error);
    fw_playback_close(playback);
    FW_TRY(status);
    memcpy(c->layer, table->layer, sizeof c->layer);
    fw_profile_table_destroy(table);
    return FW_OK;
}

static fw_status read_case(fw_sweep_case *c, const char *path, fw_error *error)
{
    if (c->scenario->profile.every != 0) FW_TRY(read_layer(c, path, error));
    return fw_summary_read(path, c->scenario, &c->verdicts, error);
}

/* --- running --- */

static fw_status run_case(fw_sweep_case *c, const fw_run_options *options, fw_sweep_stage found,
                          fw_error *error)
{
    fw_study *study;
    char note[FW_SENTENCE_SIZE] = "";
    if (found == FW_STAGE_BEGUN)
        FW_TRY(fw_study_resume(&study, c->scenario, options, note, error));
    else
        FW_TRY(fw_study_begin(&study, c->scenario, options, error));
    if (note[0] && options->warnings) {
        fputs("fretwork: ", options->warnings);
        fw_text_print_line(options->warnings, note);
        fputc('\n', options->warnings);
    }
    fw_status status = fw_study_to_end(study, error);
    if (status == FW_OK && fw_study_table(study))
        memcpy(c->layer, fw_study_table(study)->layer, sizeof c->layer);
    if (status == FW_OK)
        status = fw_verdicts_create(&c->verdicts, c->scenario, fw_study_measurement(study), error);
    fw_study_destroy(study);
    if (status == FW_DIVERGED) c->failure = *error;
    return status;
}

/* A case that is at its end, one way or the other. */
static fw_status take_result(fw_sweep_case *c, const fw_run_options *options, fw_sweep_stage stage,
                             fw_error *error)
{
    fw_progress_find(options->progress, fw_study_work(c->scenario));
    if (stage == FW_STAGE_FINISHED) return read_case(c, options->directory, error);
    *error = c->failure;
    return FW_DIVERGED;
}

fw_status fw_sweep_case_read(fw_sweep_case *c, const fw_run_options *options, fw_sweep_stage *stage,
                             fw_error *error)
{
    fw_error own = {0};
    *stage = FW_STAGE_NOT_BEGUN;
    c->missing = true;
    if (!has_results(options->directory)) return FW_OK;
    /* A file that is being laid out, or was torn when its run was killed, says nothing yet; one
     * that says it is of another scenario does. */
    *stage = FW_STAGE_BEGUN;
    const fw_status status = look(c, options, false, stage, &own);
    const bool told = is_over(*stage) || status == FW_SYSTEM_FAILED;
    if (status != FW_OK && told) *error = own;
    if (!told) return FW_OK;
    FW_TRY(status);
    c->missing = false;
    return take_result(c, options, *stage, error);
}

/* The claim is ours: nobody else changes what lies there. */
static fw_status go_on(fw_sweep_case *c, const fw_run_options *options, fw_error *error)
{
    fw_sweep_stage found = FW_STAGE_NOT_BEGUN;
    if (options->directory && has_results(options->directory)) {
        FW_TRY(fw_trajectory_mend(options->directory, error));
        FW_TRY(look(c, options, true, &found, error));
    }
    if (is_over(found)) return take_result(c, options, found, error);
    const fw_status signal = fw_interrupt_seen();
    return signal == FW_OK ? run_case(c, options, found, error) : signal;
}

fw_status fw_sweep_case_complete(fw_sweep_case *c, const fw_run_options *options, fw_error *error)
{
    fw_claim *claim;
    fw_sweep_stage stage;
    if (!options->directory) return go_on(c, options, error);
    /* What is finished needs no claim, and could be on a disk that takes none. */
    FW_TRY(fw_sweep_case_read(c, options, &stage, error));
    if (is_over(stage)) {
        fw_claim_tidy(options->directory);
        return FW_OK;
    }
    FW_TRY(fw_claim_take(&claim, options->directory, error));
    if (!claim) return FW_OK;
    c->missing = false;
    const fw_status status = go_on(c, options, error);
    fw_claim_release(claim);
    return status;
}
