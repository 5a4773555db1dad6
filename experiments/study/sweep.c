/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep.c - studies one after the other, or side by side.
 * State: the cases, and what came out of each. Invariant: the table is there when all cases are
 * finished or have diverged; until then all that is known lies in their folders. Start reading at
 * fw_sweep_to_end(). */
#include "experiments/study/sweep.h"

#include "experiments/setup/memory.h"
#include "experiments/storage/manifest.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/study.h"
#include "sweep_case.h"
#include "sweep_outcome.h"
#include "sweep_seeds.h"
#include "sweep_threshold.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

struct fw_sweep {
    const fw_scenario *scenario;
    fw_scenario *grown; /* by bisection: it is the scenario then; NULL before */
    fw_run_options options;
    fw_folder *folder; /* NULL: nothing is written */
    int case_count;
    fw_sweep_case *cases;
    fw_verdicts verdicts;
};

/* --- making --- */

/* Those that the scenario has and the sweep has not. */
static fw_status make_cases(fw_sweep *sweep, fw_error *error)
{
    const int count = sweep->scenario->study.sweep.case_count, first = sweep->case_count;
    fw_sweep_case *cases = realloc(sweep->cases, (size_t)count * sizeof *cases);
    if (!cases) return fw_fail_memory(error, "a sweep");
    sweep->cases = cases;
    memset(cases + first, 0, (size_t)(count - first) * sizeof *cases);
    while (sweep->case_count < count) {
        fw_sweep_case *c = &cases[sweep->case_count++];
        FW_TRY(fw_sweep_case_make(c, sweep->scenario, sweep->case_count - 1, error));
        if (sweep->options.progress) sweep->options.progress->total += fw_study_work(c->scenario);
    }
    return FW_OK;
}

static fw_status create(fw_sweep **sweep, const fw_scenario *scenario,
                        const fw_run_options *options, fw_error *error)
{
    fw_sweep *made = calloc(1, sizeof *made);
    *sweep = made;
    if (!made) return fw_fail_memory(error, "a sweep");
    made->scenario = scenario;
    made->options = *options;
    return make_cases(made, error);
}

/* What only shows when a run begins, such as a body that starts in a wall. */
static fw_status check_cases(const fw_sweep *sweep, fw_error *error)
{
    for (int n = 0; n < sweep->case_count; ++n) {
        const fw_status status = fw_sweep_case_check(&sweep->cases[n], error);
        FW_TRY(fw_scenario_fail_case(sweep->scenario, n, status, error));
    }
    return FW_OK;
}

static fw_status give_up(fw_sweep **sweep, fw_status status)
{
    if (status == FW_OK) return FW_OK;
    if (*sweep) fw_folder_abandon((*sweep)->folder);
    if (*sweep) (*sweep)->folder = NULL;
    fw_sweep_destroy(*sweep);
    *sweep = NULL;
    return status;
}

void fw_sweep_destroy(fw_sweep *sweep)
{
    if (!sweep) return;
    for (int n = 0; n < sweep->case_count; ++n) fw_sweep_case_clear(&sweep->cases[n]);
    fw_folder_close(sweep->folder);
    fw_verdicts_clear(&sweep->verdicts);
    free(sweep->cases);
    fw_scenario_destroy(sweep->grown);
    free(sweep);
}

/* --- its folder --- */

/* *folder is NULL where nothing of that name is there. */
static fw_status visit(fw_folder **folder, const char *path, fw_error *error)
{
    fw_error own;
    if (fw_folder_visit(folder, path, &own) != FW_SYSTEM_FAILED) return FW_OK;
    *error = own;
    return FW_SYSTEM_FAILED;
}

/* An earlier result goes, or is kept: then nothing begins. */
static fw_status clear_folder(const char *path, bool overwrite, fw_error *error)
{
    fw_folder *folder;
    FW_TRY(visit(&folder, path, error));
    if (!folder) return FW_OK;
    fw_status status = FW_OK;
    if (fw_trajectory_is_in(folder))
        status =
            overwrite ? fw_trajectory_discard(folder, error) : fw_trajectory_refuse(path, error);
    fw_folder_close(folder);
    return status;
}

static fw_status clear_folders(const fw_sweep *sweep, bool overwrite, fw_error *error)
{
    char path[FW_PATH_SIZE];
    FW_TRY(clear_folder(sweep->options.directory, overwrite, error));
    for (int n = 0; n < sweep->case_count; ++n) {
        FW_TRY(fw_path_join(path, sweep->options.directory, sweep->cases[n].name, error));
        FW_TRY(clear_folder(path, overwrite, error));
    }
    return FW_OK;
}

/* A case that another process is writing, as `fretwork resume` of it alone would. */
static fw_status refuse_held(const fw_sweep *sweep, fw_error *error)
{
    char path[FW_PATH_SIZE];
    for (int n = 0; n < sweep->case_count; ++n) {
        fw_folder *folder;
        FW_TRY(fw_path_join(path, sweep->options.directory, sweep->cases[n].name, error));
        FW_TRY(visit(&folder, path, error));
        if (!folder) continue;
        const bool result = fw_trajectory_is_in(folder);
        fw_folder_close(folder);
        if (!result) continue;
        FW_TRY(fw_folder_open(&folder, path, error));
        fw_folder_close(folder);
    }
    return FW_OK;
}

static fw_status write_scenario(const fw_sweep *sweep, fw_error *error)
{
    char *text;
    FW_TRY(fw_scenario_print(sweep->scenario, &text, error));
    const fw_status status =
        fw_manifest_write(sweep->options.directory, FW_SWEEP_SCENARIO, text, strlen(text), error);
    free(text);
    return status;
}

static fw_status take_folder(fw_sweep *sweep, fw_error *error)
{
    const char *directory = sweep->options.directory;
    if (!directory) return FW_OK;
    FW_TRY(fw_folder_create(&sweep->folder, directory, error));
    FW_TRY(refuse_held(sweep, error));
    if (!sweep->options.overwrite) FW_TRY(clear_folders(sweep, false, error));
    FW_TRY(clear_folders(sweep, true, error));
    return write_scenario(sweep, error);
}

fw_status fw_sweep_begin(fw_sweep **sweep, const fw_scenario *scenario,
                         const fw_run_options *options, fw_error *error)
{
    fw_status status = create(sweep, scenario, options, error);
    if (status == FW_OK) status = check_cases(*sweep, error);
    if (status == FW_OK) status = take_folder(*sweep, error);
    return give_up(sweep, status);
}

fw_status fw_sweep_open(fw_sweep **sweep, const fw_scenario *scenario,
                        const fw_run_options *options, fw_error *error)
{
    fw_status status = create(sweep, scenario, options, error);
    if (status == FW_OK) status = fw_folder_open(&(*sweep)->folder, options->directory, error);
    return give_up(sweep, status);
}

fw_status fw_sweep_resume(fw_sweep **sweep, const fw_scenario *scenario,
                          const fw_run_options *options, fw_error *error)
{
    FW_TRY(fw_sweep_open(sweep, scenario, options, error));
    if (!fw_folder_has((*sweep)->folder, FW_SWEEP_FILE)) return FW_OK;
    return give_up(sweep, fw_fail(error, FW_BAD_INPUT,
                                  "%s: the sweep is finished, there is nothing to resume",
                                  options->directory));
}

/* The old table goes first: what is left of a kill in between is a sweep to be resumed. */
fw_status fw_sweep_grow(fw_sweep **sweep, const fw_scenario *scenario,
                        const fw_run_options *options, fw_error *error)
{
    fw_status status = create(sweep, scenario, options, error);
    if (status == FW_OK) status = check_cases(*sweep, error);
    if (status == FW_OK) status = fw_folder_open(&(*sweep)->folder, options->directory, error);
    if (status == FW_OK) status = fw_folder_remove((*sweep)->folder, FW_SWEEP_FILE, error);
    if (status == FW_OK) status = write_scenario(*sweep, error);
    return give_up(sweep, status);
}

/* --- running --- */

/* As many as there are processors, cases, and room in memory for. */
static int choose_jobs(const fw_sweep *sweep, int first)
{
    const int processors = omp_get_num_procs(), wanted = sweep->options.at_once;
    int jobs = wanted > 0 && wanted < processors ? wanted : processors;
    fw_error ignored;
    if (jobs > sweep->case_count - first) jobs = sweep->case_count - first;
    for (int n = first; n < sweep->case_count; ++n) {
        const fw_scenario *scenario = sweep->cases[n].scenario;
        const int runs = fw_study_run_count(scenario);
        while (jobs > 1 && fw_memory_check(scenario, runs * jobs, &ignored) != FW_OK) jobs -= 1;
    }
    return jobs;
}

/* Side by side each case has one thread for its particles, and its share of the processors for its
 * seeds. */
static fw_run_options options_of_case(const fw_sweep *sweep, int jobs)
{
    const int processors = omp_get_num_procs(), wanted = sweep->options.at_once;
    const int all = wanted > 0 && wanted < processors ? wanted : processors;
    fw_run_options options = sweep->options;
    options.overwrite = true; /* whatever was there and counted has been looked at */
    if (jobs < 2) return options;
    options.threads = 1;
    options.at_once = all / jobs;
    return options;
}

/* The sentence of a single run says nothing of the others. */
static fw_status report_case(const fw_sweep *sweep, int number, fw_status status, fw_error *error)
{
    const char *name = sweep->cases[number].name, *directory = sweep->options.directory;
    if (!fw_interrupt_is(status)) return status;
    if (!directory)
        return fw_fail(error, status, "interrupted in case %d of %d, %s", number + 1,
                       sweep->case_count, name);
    return fw_fail(error, status,
                   "interrupted in case %d of %d, %s; `fretwork resume %s` goes on from here",
                   number + 1, sweep->case_count, name, directory);
}

static fw_status complete_case(fw_sweep *sweep, int number, fw_run_options options, fw_error *error)
{
    fw_sweep_case *c = &sweep->cases[number];
    char path[FW_PATH_SIZE];
    fw_progress_name(options.progress, "%.64s %d/%d %.64s", options.name ? options.name : "sweep",
                     number + 1, sweep->case_count, c->name);
    if (options.directory) {
        FW_TRY(fw_path_join(path, options.directory, c->name, error));
        options.directory = path;
    }
    return report_case(sweep, number, fw_sweep_case_complete(c, &options, error), error);
}

/* Every case from that one on in turn, by whoever is free. A case that fails leaves the others;
 * what stops one for another reason, as a signal or a full disk, stops all, and the first in order
 * is reported. */
static fw_status complete_all(fw_sweep *sweep, int begin, fw_error *error)
{
    const int jobs = choose_jobs(sweep, begin);
    const fw_run_options options = options_of_case(sweep, jobs);
    fw_status stopped = FW_OK;
    int first = sweep->case_count;
    bool going = true;
    omp_set_max_active_levels(options.at_once > 1 ? 2 : 1);
#pragma omp parallel for schedule(dynamic, 1) num_threads(jobs) if (jobs > 1)
    for (int n = begin; n < sweep->case_count; ++n) {
        fw_error own = {0};
        bool go_on;
#pragma omp atomic read
        go_on = going;
        if (!go_on) continue;
        const fw_status status = complete_case(sweep, n, options, &own);
        if (status == FW_OK || status == FW_DIVERGED) continue;
#pragma omp atomic write
        going = false;
#pragma omp critical(sweep)
        if (n < first) {
            first = n;
            stopped = status;
            *error = own;
        }
    }
    return stopped;
}

/* --- the outcome --- */

static fw_status write_seeds(const fw_sweep *sweep, const fw_sweep_table *table, fw_error *error)
{
    const char *directory = sweep->options.directory, *title = sweep->scenario->title;
    fw_sweep_seeds seeds;
    fw_status status =
        fw_sweep_seeds_collect(&seeds, table, sweep->scenario, sweep->cases, directory, error);
    if (status == FW_OK) status = fw_sweep_seeds_write(&seeds, title, directory, error);
    if (status == FW_OK) status = fw_sweep_seeds_write_hdf5(&seeds, title, directory, error);
    fw_sweep_seeds_clear(&seeds);
    return status;
}

static fw_status write_table(const fw_sweep *sweep, fw_error *error)
{
    const char *directory = sweep->options.directory;
    fw_sweep_table table;
    if (!directory) return FW_OK;
    /* The table comes last: with it the sweep is finished. */
    FW_TRY(fw_sweep_thresholds_write(directory, sweep->scenario, sweep->cases, error));
    fw_status status = fw_sweep_outcome_table(&table, sweep->scenario, sweep->cases, error);
    if (status == FW_OK) status = write_seeds(sweep, &table, error);
    if (status == FW_OK)
        status = fw_sweep_table_write(&table, sweep->scenario->title, directory, error);
    fw_sweep_table_clear(&table);
    return status;
}

/* The first reason stands for all. */
static fw_status report_failures(const fw_sweep *sweep, fw_error *error)
{
    const fw_sweep_case *first = NULL;
    int failed = 0;
    for (int n = sweep->case_count - 1; n >= 0; --n) {
        if (sweep->cases[n].failure.status == FW_OK) continue;
        first = &sweep->cases[n];
        failed += 1;
    }
    if (failed == 0) return FW_OK;
    if (failed == 1)
        return fw_fail(error, FW_DIVERGED, "case %s of %d failed: %s", first->name,
                       sweep->case_count, first->failure.sentence);
    return fw_fail(error, FW_DIVERGED, "%d of %d cases failed; the first is %s: %s", failed,
                   sweep->case_count, first->name, first->failure.sentence);
}

static fw_status conclude(fw_sweep *sweep, fw_error *error)
{
    FW_TRY(fw_sweep_outcome_verdicts(&sweep->verdicts, sweep->scenario, sweep->cases, error));
    FW_TRY(write_table(sweep, error));
    return report_failures(sweep, error);
}

/* The cases that bisection asks for next, checked and written before one of them begins. */
static fw_status grow(fw_sweep *sweep, fw_scenario *larger, fw_error *error)
{
    const int first = sweep->case_count;
    fw_scenario_destroy(sweep->grown);
    sweep->scenario = sweep->grown = larger;
    FW_TRY(make_cases(sweep, error));
    for (int n = first; n < sweep->case_count; ++n)
        FW_TRY(fw_scenario_fail_case(sweep->scenario, n,
                                     fw_sweep_case_check(&sweep->cases[n], error), error));
    return sweep->options.directory ? write_scenario(sweep, error) : FW_OK;
}

fw_status fw_sweep_to_end(fw_sweep *sweep, fw_error *error)
{
    for (int begin = 0;;) {
        fw_scenario *larger;
        FW_TRY(complete_all(sweep, begin, error));
        if (fw_sweep_missing(sweep) > 0) return FW_OK;
        FW_TRY(fw_sweep_bisect(&larger, sweep->scenario, sweep->cases, error));
        if (!larger) return conclude(sweep, error);
        begin = sweep->case_count;
        FW_TRY(grow(sweep, larger, error));
    }
}

int fw_sweep_missing(const fw_sweep *sweep)
{
    int missing = 0;
    for (int n = 0; n < sweep->case_count; ++n) missing += sweep->cases[n].missing;
    return missing;
}

/* Whether anybody is at work on it shows only by trying. */
static fw_status refuse_missing(const fw_sweep *sweep, int first, fw_sweep_stage stage,
                                fw_error *error)
{
    const char *directory = sweep->options.directory;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: %d of %d cases are not finished; the first, %s, has %s. `fretwork resume "
                   "%s` runs those that nobody is running",
                   directory, fw_sweep_missing(sweep), sweep->case_count, sweep->cases[first].name,
                   stage == FW_STAGE_NOT_BEGUN ? "not begun" : "begun", directory);
}

fw_status fw_sweep_collect(fw_sweep *sweep, fw_error *error)
{
    fw_run_options options = sweep->options;
    fw_sweep_stage stage, first_stage = FW_STAGE_NOT_BEGUN;
    char path[FW_PATH_SIZE];
    int first = -1;
    for (int n = 0; n < sweep->case_count; ++n) {
        FW_TRY(fw_path_join(path, sweep->options.directory, sweep->cases[n].name, error));
        options.directory = path;
        const fw_status status = fw_sweep_case_read(&sweep->cases[n], &options, &stage, error);
        if (status != FW_DIVERGED) FW_TRY(status);
        if (first >= 0 || !sweep->cases[n].missing) continue;
        first = n;
        first_stage = stage;
    }
    if (first >= 0) return refuse_missing(sweep, first, first_stage, error);
    fw_scenario *larger;
    FW_TRY(fw_sweep_bisect(&larger, sweep->scenario, sweep->cases, error));
    if (!larger) return conclude(sweep, error);
    const int known = sweep->case_count;
    FW_TRY(grow(sweep, larger, error));
    const char *directory = sweep->options.directory;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: the bisection goes on with %d further cases, which `fretwork sweep %s "
                   "--list` lists and `fretwork resume %s` runs",
                   directory, sweep->case_count - known, directory, directory);
}

const fw_verdicts *fw_sweep_verdicts(const fw_sweep *sweep)
{
    return &sweep->verdicts;
}

int fw_sweep_case_count(const fw_sweep *sweep)
{
    return sweep->case_count;
}

const fw_scenario *fw_sweep_scenario(const fw_sweep *sweep, int number)
{
    return sweep->cases[number].scenario;
}
