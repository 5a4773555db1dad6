/* SPDX-License-Identifier: GPL-3.0-or-later */
/* study.c - many runs at a time.
 * State: the runs, and their outcome. Invariant: each run is stepped by one thread at a time, and
 * what is averaged is added in the order of seeds. Start reading at fw_study_to_end(). */
#include "experiments/study/study.h"

#include "core/averages.h"
#include "experiments/setup/memory.h"
#include "experiments/storage/csv.h"
#include "experiments/storage/folder.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/summary.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* One run: of the experiment or of its control, with one seed. */
typedef struct fw_replica {
    const fw_scenario *scenario;
    fw_scenario *own; /* NULL: it is the experiment itself */
    fw_run_options options;
    char *directory; /* of its own; NULL: none */
    fw_run *run;
    fw_status status;
    fw_error error;
} fw_replica;

struct fw_study {
    const fw_scenario *scenario;
    int at_once;
    int seed_count, run_count;           /* seeds of the experiment, then those of the control */
    fw_replica *replicas;                /* the first is the experiment itself */
    const fw_measurement **measurements; /* per seed of the experiment */
    fw_profile_table *table;
    double (*layers)[FW_LAYER_MEASURES]; /* of each run */
};

/* --- making --- */

static fw_status fail_replica(const fw_study *study, int number, fw_status status, fw_error *error)
{
    if (status != FW_BAD_INPUT) return status;
    if (number >= study->seed_count)
        return fw_scenario_fail_within(study->scenario, study->scenario->study.control_place,
                                       status, error, "control");
    return fw_fail_within(error, "seed %lld",
                          (long long)study->replicas[number].scenario->run.seed);
}

static fw_status make_scenario(const fw_scenario *scenario, bool control, int64_t seed,
                               fw_scenario **made, fw_error *error)
{
    enum { SETTINGS_MAX = 80 };
    const char *settings[SETTINGS_MAX];
    char seed_setting[48], *text;
    int count = 0;
    snprintf(seed_setting, sizeof seed_setting, "run.seed=%lld", (long long)seed);
    settings[count++] = seed_setting;
    for (int n = 0; control && n < scenario->study.control_count; ++n)
        settings[count++] = scenario->study.control[n];
    FW_TRY(fw_scenario_print(scenario, &text, error));
    /* Nobody has written that text: its lines would say nothing to anybody. */
    fw_status status = fw_scenario_read(made, NULL, text, strlen(text), settings, count, error);
    free(text);
    return control ? fw_scenario_fail_within(scenario, scenario->study.control_place, status, error,
                                             "control")
                   : status;
}

static fw_status make_replica(fw_study *study, int number, const fw_run_options *options,
                              fw_error *error)
{
    fw_replica *replica = &study->replicas[number];
    const bool control = number >= study->seed_count;
    const int64_t seed = study->scenario->run.seed + number % study->seed_count;
    FW_TRY(make_scenario(study->scenario, control, seed, &replica->own, error));
    replica->scenario = replica->own;
    replica->options =
        (fw_run_options){.threads = 1, .overwrite = true, .progress = options->progress};
    char folder[FW_RUN_FOLDER], path[FW_PATH_SIZE];
    if (!options->directory || !fw_study_folder(study->scenario, number, folder)) return FW_OK;
    FW_TRY(fw_path_join(path, options->directory, folder, error));
    FW_TRY(fw_path_check_inner(path, error));
    replica->directory = strdup(path);
    if (!replica->directory) return fw_fail_memory(error, "a study");
    replica->options.directory = replica->directory;
    return FW_OK;
}

int fw_study_run_count(const fw_scenario *scenario)
{
    return (int)scenario->study.seeds * (scenario->study.control_count > 0 ? 2 : 1);
}

bool fw_study_folder(const fw_scenario *scenario, int number, char folder[FW_RUN_FOLDER])
{
    const fw_scenario_study *study = &scenario->study;
    const int seeds = (int)study->seeds;
    const long long seed = (long long)(scenario->run.seed + number % seeds);
    if (number == seeds) {
        snprintf(folder, FW_RUN_FOLDER, FW_CONTROL_FOLDER);
        return true;
    }
    if (number == 0 || !study->keep) return false;
    snprintf(folder, FW_RUN_FOLDER, number < seeds ? "seed-%lld" : FW_CONTROL_FOLDER "-seed-%lld",
             seed);
    return true;
}

double fw_study_work(const fw_scenario *scenario)
{
    return fw_study_run_count(scenario) * fw_run_work(scenario);
}

static fw_status create(fw_study **study, const fw_scenario *scenario,
                        const fw_run_options *options, fw_error *error)
{
    fw_study *made = calloc(1, sizeof *made);
    *study = made;
    if (!made) return fw_fail_memory(error, "a study");
    made->scenario = scenario;
    made->at_once = options->at_once;
    made->seed_count = (int)scenario->study.seeds;
    made->run_count = fw_study_run_count(scenario);
    FW_TRY(fw_memory_check(scenario, made->run_count, error));
    made->replicas = calloc((size_t)made->run_count, sizeof *made->replicas);
    made->measurements = calloc((size_t)made->seed_count, sizeof *made->measurements);
    if (!made->replicas || !made->measurements) return fw_fail_memory(error, "a study");
    made->replicas[0].scenario = scenario;
    made->replicas[0].options = *options;
    /* The results are finished when the whole study is. */
    made->replicas[0].options.keep_open = true;
    for (int n = 1; n < made->run_count; ++n) FW_TRY(make_replica(made, n, options, error));
    /* A sweep has counted the work of all its cases at the beginning. */
    if (options->progress && !scenario->study.sweep.is_case)
        options->progress->total += fw_study_work(scenario);
    return FW_OK;
}

/* All runs from that number on, before any folder is taken: what only shows when a run is built, a
 * body of the control that starts in a wall, a seed that finds no place for its particles. The
 * first run comes first: what is wrong with all of them is reported of it, at its own place. */
static fw_status make_runs(fw_study *study, int first, fw_error *error)
{
    for (int n = first; n < study->run_count; ++n) {
        fw_replica *replica = &study->replicas[n];
        const fw_status status =
            fw_run_make(&replica->run, replica->scenario, &replica->options, error);
        FW_TRY(n > 0 ? fail_replica(study, n, status, error) : status);
    }
    return FW_OK;
}

/* One after the other, as folders are made. */
static fw_status start_runs(fw_study *study, int first, fw_error *error)
{
    for (int n = first; n < study->run_count; ++n)
        FW_TRY(fw_run_start(study->replicas[n].run, error));
    return FW_OK;
}

static fw_status give_up(fw_study **study, bool begun, fw_status status)
{
    if (status == FW_OK) return FW_OK;
    for (int n = 0; begun && *study && (*study)->replicas && n < (*study)->run_count; ++n) {
        fw_run_abandon((*study)->replicas[n].run);
        (*study)->replicas[n].run = NULL;
    }
    fw_study_destroy(*study);
    *study = NULL;
    return status;
}

fw_status fw_study_begin(fw_study **study, const fw_scenario *scenario,
                         const fw_run_options *options, fw_error *error)
{
    fw_status status = create(study, scenario, options, error);
    if (status == FW_OK) status = make_runs(*study, 0, error);
    if (status == FW_OK) status = start_runs(*study, 0, error);
    return give_up(study, true, status);
}

fw_status fw_study_resume(fw_study **study, const fw_scenario *scenario,
                          const fw_run_options *options, char note[FW_SENTENCE_SIZE],
                          fw_error *error)
{
    fw_status status = create(study, scenario, options, error);
    if (status == FW_OK) {
        fw_replica *first = &(*study)->replicas[0];
        status = fw_run_resume(&first->run, scenario, &first->options, note, error);
    }
    if (status == FW_OK) status = make_runs(*study, 1, error);
    if (status == FW_OK) status = start_runs(*study, 1, error);
    return give_up(study, false, status);
}

void fw_study_destroy(fw_study *study)
{
    if (!study) return;
    for (int n = 0; study->replicas && n < study->run_count; ++n) {
        fw_run_destroy(study->replicas[n].run);
        fw_scenario_destroy(study->replicas[n].own);
        free(study->replicas[n].directory);
    }
    free(study->replicas);
    free(study->measurements);
    free(study->layers);
    fw_profile_table_destroy(study->table);
    free(study);
}

/* --- running --- */

static void run_replica(fw_replica *replica)
{
    replica->status = fw_run_to_end(replica->run, &replica->error);
}

static int threads_of(const fw_study *study)
{
    const int cores = omp_get_num_procs();
    const int wanted = study->at_once > 0 ? study->at_once : cores;
    const int most = study->run_count < cores ? study->run_count : cores;
    return wanted < most ? wanted : most;
}

/* Of several runs at a time: steps of all of them, as the progress counts them. */
static fw_status report_signal(const fw_study *study, fw_status status, fw_error *error)
{
    const fw_replica *first = &study->replicas[0];
    long long done = 0;
    for (int n = 0; n < study->run_count; ++n)
        done += fw_scene_steps(fw_run_experiment(study->replicas[n].run)->scene);
    const long long all = (long long)study->run_count * first->scenario->run.steps;
    if (!first->options.directory)
        return fw_fail(error, status, "interrupted after %lld of %lld steps of %d runs", done, all,
                       study->run_count);
    return fw_fail(error, status,
                   "interrupted after %lld of %lld steps of %d runs; `fretwork resume %s` goes on "
                   "with that of seed %lld and begins the other%s again",
                   done, all, study->run_count, first->options.directory,
                   (long long)first->scenario->run.seed, study->run_count > 2 ? "s" : "");
}

static fw_status run_all(fw_study *study, fw_error *error)
{
    if (study->run_count == 1) {
        run_replica(&study->replicas[0]);
    } else {
        /* Each run in a thread of its own, of which it needs no more; never more than cores. */
        const int threads = threads_of(study);
        omp_set_num_threads(1);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
        for (int n = 0; n < study->run_count; ++n) run_replica(&study->replicas[n]);
    }
    fw_progress_end(study->replicas[0].options.progress);
    for (int n = 0; n < study->run_count; ++n) {
        if (study->replicas[n].status == FW_OK) continue;
        if (study->run_count > 1 && fw_interrupt_is(study->replicas[n].status))
            return report_signal(study, study->replicas[n].status, error);
        *error = study->replicas[n].error;
        return study->replicas[n].status;
    }
    return FW_OK;
}

/* --- the outcome --- */

static const fw_observer *observer_of(const fw_study *study, int number)
{
    return fw_run_observer(study->replicas[number].run);
}

/* From the values of all runs, over those that have one: of the experiment, and of its control. */
static fw_outcome outcome_of(const fw_study *study, double *values)
{
    const size_t seeds = (size_t)study->seed_count, all = (size_t)study->run_count;
    const fw_average experiment = fw_average_of_known(values, seeds);
    const fw_average control = fw_average_of_known(values + seeds, all - seeds);
    return (fw_outcome){experiment.mean, experiment.error, control.mean, control.error};
}

static void average_columns(fw_study *study, double *values)
{
    const fw_profile_table *table = study->table;
    for (int c = 0; c < FW_PROFILE_COLUMNS; ++c)
        for (int b = 0; b < table->bin_count; ++b) {
            for (int n = 0; n < study->run_count; ++n)
                values[n] =
                    fw_profile_value(observer_of(study, n)->profile, b, (fw_profile_column)c);
            fw_profile_table_column(table, (fw_profile_column)c)[b] = outcome_of(study, values);
        }
}

static fw_status average_layer(fw_study *study, double *values, fw_error *error)
{
    double(*layers)[FW_LAYER_MEASURES] = study->layers;
    const int seeds = study->seed_count;
    for (int n = 0; n < study->run_count; ++n)
        FW_TRY(fw_layer_of(layers[n], observer_of(study, n),
                           fw_run_measurement(study->replicas[n].run), error));
    for (int n = seeds; n < study->run_count; ++n)
        fw_layer_compare(layers[n - seeds], layers[n], observer_of(study, n)->profile);
    for (int m = 0; m < FW_LAYER_MEASURES; ++m) {
        for (int n = 0; n < study->run_count; ++n) values[n] = layers[n][m];
        study->table->layer[m] = outcome_of(study, values);
    }
    return FW_OK;
}

/* What is expected of a quantity is expected of its mean over the seeds. */
static void compare_seeds(fw_study *study)
{
    if (study->seed_count == 1) return;
    for (int n = 0; n < study->seed_count; ++n)
        study->measurements[n] = fw_run_measurement(study->replicas[n].run);
    fw_run_set_seeds(study->replicas[0].run, study->measurements, study->seed_count);
}

static fw_status evaluate(fw_study *study, fw_error *error)
{
    const fw_profile *profile = observer_of(study, 0)->profile;
    const int bins = fw_profile_bin_count(profile);
    FW_TRY(fw_profile_table_create(&study->table, bins, study->scenario->profile.axis ? 'y' : 'x',
                                   error));
    for (int b = 0; b <= bins; ++b) study->table->edges[b] = fw_profile_edge(profile, b);
    double *values = calloc((size_t)study->run_count, sizeof *values);
    study->layers = calloc((size_t)study->run_count, sizeof *study->layers);
    fw_status status =
        values && study->layers ? FW_OK : fw_fail_memory(error, "the outcome of a study");
    if (status == FW_OK) {
        average_columns(study, values);
        status = average_layer(study, values, error);
    }
    free(values);
    if (status == FW_OK)
        fw_run_set_outcome(study->replicas[0].run, study->table->layer, study->layers[0]);
    return status;
}

/* --- files --- */

static void write_layers(FILE *out, const void *object)
{
    const fw_study *study = object;
    fputs("seed,run", out);
    for (int m = 0; m < FW_LAYER_MEASURES; ++m) fprintf(out, ",%s", fw_layer_quantities[m].name);
    fputc('\n', out);
    for (int n = 0; n < study->run_count; ++n) {
        const bool control = n >= study->seed_count;
        fprintf(out, "%lld,%s", (long long)study->replicas[n].scenario->run.seed,
                control ? "control" : "experiment");
        for (int m = 0; m < FW_LAYER_MEASURES; ++m) {
            fputc(',', out);
            fw_csv_write_number(out, study->layers[n][m]);
        }
        fputc('\n', out);
    }
}

static fw_status write_profile(fw_study *study, const char *directory, fw_error *error)
{
    fw_trajectory_array *arrays;
    int count;
    FW_TRY(fw_profile_table_arrays(&arrays, &count, study->table->bin_count, error));
    fw_status status = FW_OK;
    for (int n = 0; n < count && status == FW_OK; ++n)
        status = fw_run_write_array(study->replicas[0].run, &arrays[n],
                                    fw_profile_table_values(study->table, n), error);
    free(arrays);
    FW_TRY(status);
    FW_TRY(fw_profile_table_write(study->table, directory, FW_PROFILE_FILE, error));
    return fw_csv_keep(directory, FW_LAYER_FILE, write_layers, study, error);
}

/* Of whatever expects something, and of a case, which a sweep that goes on reads back. */
static fw_status write_summary(const fw_study *study, const char *directory, fw_error *error)
{
    const fw_scenario *scenario = study->scenario;
    if (scenario->expectation_count == 0 && !scenario->study.sweep.is_case) return FW_OK;
    return fw_summary_write(directory, study->scenario, fw_study_measurement(study), error);
}

fw_status fw_study_to_end(fw_study *study, fw_error *error)
{
    const char *directory = study->replicas[0].options.directory;
    const fw_status status = run_all(study, error);
    /* Of the experiment itself there are results, which say that another run has failed. */
    if (status == FW_DIVERGED && study->replicas[0].status == FW_OK)
        fw_run_fail(study->replicas[0].run, status, error->sentence);
    FW_TRY(status);
    if (study->scenario->profile.every != 0) FW_TRY(evaluate(study, error));
    compare_seeds(study);
    for (int n = 1; n < study->seed_count; ++n)
        fw_run_join_certificate(study->replicas[0].run, study->replicas[n].run);
    if (!directory) return FW_OK;
    if (study->table) FW_TRY(write_profile(study, directory, error));
    FW_TRY(write_summary(study, directory, error));
    return fw_run_finish(study->replicas[0].run, error);
}

fw_run *fw_study_run(fw_study *study)
{
    return study->replicas[0].run;
}

const fw_measurement *fw_study_measurement(const fw_study *study)
{
    return fw_run_measurement(study->replicas[0].run);
}

const fw_certificate *fw_study_certificate(const fw_study *study)
{
    return fw_run_certificate(study->replicas[0].run);
}

const char *fw_study_warnings(const fw_study *study)
{
    return fw_run_warnings(study->replicas[0].run);
}

const fw_profile_table *fw_study_table(const fw_study *study)
{
    return study->table;
}
