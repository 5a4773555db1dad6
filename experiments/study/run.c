/* SPDX-License-Identifier: GPL-3.0-or-later */
/* run.c - the life of a run. Several may run at a time, each in a thread of its own; they write
 * their results one after the other, since HDF5 can do no better.
 * State: the experiment, its series, its recorder. Invariant: what the newest checkpoint speaks of
 * is in the results file. Start reading at fw_run_to_end(). */
#include "experiments/study/run.h"

#include "experiments/measures/warning.h"
#include "experiments/results/playback.h"
#include "experiments/setup/memory.h"
#include "experiments/study/interrupt.h"
#include "experiments/study/recorder.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Seconds between two checkpoints where the scenario does not say. */
static const double CHECKPOINT_SECONDS = 60;

struct fw_run {
    const fw_scenario *scenario;
    fw_run_options options;
    fw_observer *observer;
    fw_experiment *experiment; /* of the observer */
    fw_measurement *measurement;
    fw_recorder *recorder; /* NULL: nothing is written */
    double checkpointed;   /* clock of the last checkpoint */
    fw_warning warning;
};

static fw_status create(fw_run **run, const fw_scenario *scenario, const fw_run_options *options,
                        fw_error *error)
{
    fw_run *made = calloc(1, sizeof *made);
    *run = made;
    if (!made) return fw_fail_memory(error, "a run");
    made->scenario = scenario;
    made->options = *options;
    omp_set_num_threads(options->threads > 0 ? options->threads : 1);
    FW_TRY(fw_memory_check(scenario, 1, error));
    FW_TRY(fw_observer_create(&made->observer, scenario, error));
    made->experiment = made->observer->experiment;
    return fw_measurement_create(&made->measurement, made->observer, error);
}

static fw_status measure(fw_run *run, fw_error *error)
{
    const double *row = fw_measurement_take(run->measurement, run->experiment);
    if (!run->recorder) return FW_OK;
    int64_t last = run->measurement->count - 1;
    return fw_recorder_write_row(run->recorder, run->measurement->steps[last],
                                 run->measurement->times[last], row, error);
}

enum { LOOKED = 1, HURRIED = 2, FOLDED = 4 };

/* What was said is not said again by a run that goes on. */
static int64_t warned(const fw_run *run)
{
    return (run->warning.looked ? LOOKED : 0) | (run->warning.hurried ? HURRIED : 0) |
           (run->warning.folded ? FOLDED : 0);
}

/* Says what is new to the user, and keeps it in the results. */
static fw_status look(fw_run *run, fw_error *error)
{
    char *lines = NULL;
    size_t size = 0;
    if (!run->options.warnings && !run->recorder) return FW_OK;
    run->warning.out = open_memstream(&lines, &size);
    if (!run->warning.out) return fw_fail_memory(error, "warnings");
    fw_status status = fw_warning_look(&run->warning, run->experiment, error);
    if (fclose(run->warning.out) != 0 && status == FW_OK)
        status = fw_fail_memory(error, "warnings");
    run->warning.out = NULL;
    if (run->options.warnings && lines) fputs(lines, run->options.warnings);
    if (status == FW_OK && run->recorder)
        status = fw_recorder_add_warnings(run->recorder, lines, warned(run), error);
    free(lines);
    return status;
}

static fw_status record(fw_run *run, fw_error *error)
{
    FW_TRY(look(run, error));
    return run->recorder ? fw_recorder_write_frame(run->recorder, error) : FW_OK;
}

static fw_status checkpoint(fw_run *run, fw_error *error)
{
    if (!run->recorder) return FW_OK;
    FW_TRY(fw_scene_settle(run->experiment->scene, error));
    run->checkpointed = fw_progress_clock();
    fw_interrupt_hold();
    const fw_status status = fw_recorder_checkpoint(run->recorder, error);
    fw_interrupt_release();
    return status;
}

/* The start counts as a step of its own: with its checkpoint a run can go on whatever ends it, and
 * a disk without room for checkpoints shows before the first step. */
static fw_status record_start(fw_run *run, fw_error *error)
{
    FW_TRY(measure(run, error));
    FW_TRY(record(run, error));
    return checkpoint(run, error);
}

fw_status fw_run_make(fw_run **run, const fw_scenario *scenario, const fw_run_options *options,
                      fw_error *error)
{
    const fw_status status = create(run, scenario, options, error);
    if (status != FW_OK) {
        fw_run_destroy(*run);
        *run = NULL;
    }
    return status;
}

fw_status fw_run_start(fw_run *run, fw_error *error)
{
    const fw_run_options *options = &run->options;
    if (options->directory)
        FW_TRY(fw_recorder_create(&run->recorder, run->observer, run->measurement,
                                  options->directory, options->overwrite, options->threads, error));
    return record_start(run, error);
}

fw_status fw_run_begin(fw_run **run, const fw_scenario *scenario, const fw_run_options *options,
                       fw_error *error)
{
    FW_TRY(fw_run_make(run, scenario, options, error));
    const fw_status status = fw_run_start(*run, error);
    if (status != FW_OK) {
        fw_run_abandon(*run);
        *run = NULL;
    }
    return status;
}

/* The rows that were measured before the checkpoint, from the results file. */
static fw_status restore_rows(fw_run *run, fw_playback *playback, int64_t rows, fw_error *error)
{
    fw_measurement *m = run->measurement;
    size_t count = (size_t)playback->sample_count, width = (size_t)m->width;
    double *table = calloc(count * width + 1, sizeof *table);
    double *column = calloc(count * FW_COMPONENTS_MAX + 1, sizeof *column);
    double *times = calloc(count + 1, sizeof *times);
    int64_t *steps = calloc(count + 1, sizeof *steps);
    fw_status status = FW_OK;
    if (!table || !column || !times || !steps) status = fw_fail_memory(error, "measured rows");
    if (status == FW_OK && rows == 0 && playback->frame_count > 1)
        status = fw_fail(error, FW_BAD_INPUT,
                         "%s holds %lld frames but no checkpoint to go on from; `fretwork run "
                         "--overwrite` computes all of them anew",
                         run->options.directory, (long long)playback->frame_count);
    if (status == FW_OK && (int64_t)count < rows)
        status = fw_fail(error, FW_BAD_INPUT,
                         "%s: the results file has %lld measured rows, expected at least the %lld "
                         "of the checkpoint",
                         run->options.directory, (long long)count, (long long)rows);
    if (status == FW_OK) status = fw_playback_read_sample_times(playback, steps, times, error);
    for (int n = 0; n < m->probe_count && status == FW_OK; ++n) {
        const fw_probe *probe = &m->probes[n];
        int number = fw_playback_find_observable(playback, probe->label);
        if (number < 0 || playback->observables[number].components != probe->components) {
            status = fw_fail(error, FW_BAD_INPUT,
                             "%s: the results file has no observable %s as this program measures "
                             "it, so the run cannot go on",
                             run->options.directory, probe->label);
            break;
        }
        status = fw_playback_read_observable(playback, number, column, error);
        for (size_t row = 0; row < count && status == FW_OK; ++row)
            memcpy(table + row * width + probe->first, column + row * (size_t)probe->components,
                   (size_t)probe->components * sizeof *column);
    }
    for (int64_t row = 0; row < rows && status == FW_OK; ++row)
        fw_measurement_restore(m, steps[row], times[row], table + (size_t)row * width);
    free(table);
    free(column);
    free(times);
    free(steps);
    return status;
}

static fw_status resume(fw_run *run, char *note, fw_error *error)
{
    fw_written written = {0};
    fw_playback *playback;
    FW_TRY(fw_recorder_reopen(&run->recorder, run->observer, run->measurement,
                              run->options.directory, run->options.threads, &written, note, error));
    run->warning.looked = written.warned & LOOKED;
    run->warning.hurried = written.warned & HURRIED;
    run->warning.folded = written.warned & FOLDED;
    FW_TRY(fw_playback_open(&playback, run->options.directory, error));
    char *warnings = strdup(playback->warnings);
    fw_status status = warnings ? FW_OK : fw_fail_memory(error, "warnings");
    if (status == FW_OK) status = restore_rows(run, playback, written.rows, error);
    fw_playback_close(playback);
    if (status == FW_OK) status = fw_recorder_go_on(run->recorder, warnings, error);
    free(warnings);
    FW_TRY(status);
    return written.rows > 0 ? FW_OK : record_start(run, error);
}

fw_status fw_run_resume(fw_run **run, const fw_scenario *scenario, const fw_run_options *options,
                        char note[FW_SENTENCE_SIZE], fw_error *error)
{
    note[0] = '\0';
    fw_status status = create(run, scenario, options, error);
    if (status == FW_OK) status = resume(*run, note, error);
    if (status != FW_OK) {
        fw_run_destroy(*run);
        *run = NULL;
    }
    return status;
}

static bool checkpoint_is_due(const fw_run *run, int64_t step)
{
    if (!run->recorder || step == run->scenario->run.steps) return false;
    if (run->scenario->run.checkpoint_every > 0)
        return step % run->scenario->run.checkpoint_every == 0;
    return fw_progress_clock() - run->checkpointed > CHECKPOINT_SECONDS;
}

static bool frame_is_due(const fw_run *run, int64_t step)
{
    return step % run->scenario->run.record_every == 0 || step == run->scenario->run.steps;
}

/* Steps until something is due. */
static int64_t steps_to_go(const fw_run *run)
{
    const int64_t step = fw_scene_steps(run->experiment->scene);
    const int64_t every[] = {run->scenario->run.record_every, run->scenario->run.measure_every,
                             run->scenario->run.checkpoint_every};
    int64_t least = run->scenario->run.steps - step;
    for (size_t n = 0; n < sizeof every / sizeof *every; ++n) {
        if (every[n] == 0) continue;
        const int64_t here = every[n] - step % every[n];
        if (here < least) least = here;
    }
    return least;
}

/* Keeps what is needed to go on, and says so: a failure of its own, also where all went well. */
static fw_status interrupt(fw_run *run, fw_status signal, fw_error *error)
{
    const long long step = fw_scene_steps(run->experiment->scene);
    const long long steps = run->scenario->run.steps;
    FW_TRY(checkpoint(run, error));
    if (!run->recorder)
        return fw_fail(error, signal, "interrupted after %lld of %lld steps", step, steps);
    return fw_fail(error, signal,
                   "interrupted after %lld of %lld steps; `fretwork resume %s` goes on from here",
                   step, steps, run->options.directory);
}

/* Makes those positions right that somebody looks at: measures, frames and what is certified look
 * at boundaries, some quantities and frames further in, and whoever looks at the end everywhere. */
static fw_status settle(const fw_run *run, bool measures, bool frame, bool end, fw_error *error)
{
    fw_scene *scene = run->experiment->scene;
    const bool everywhere = end || (measures && fw_measurement_needs_positions(run->measurement)) ||
                            (frame && run->recorder && fw_recorder_needs_positions(run->recorder));
    if (everywhere) return fw_scene_settle(scene, error);
    return measures || frame ? fw_scene_settle_boundaries(scene, error) : FW_OK;
}

/* 1 to `most` steps. */
static fw_status step_on(fw_run *run, int64_t most, fw_error *error)
{
    const int64_t due = steps_to_go(run);
    FW_TRY(fw_observer_move(run->observer, due < most ? due : most, error));
    const int64_t step = fw_scene_steps(run->experiment->scene);
    const bool measures = fw_measurement_is_due(run->scenario, step);
    const bool frame = frame_is_due(run, step);
    FW_TRY(settle(run, measures, frame, step == run->scenario->run.steps, error));
    if (frame) FW_TRY(fw_scene_check_energy(run->experiment->scene, error));
    if (frame || measures) fw_observer_certify(run->observer);
    if (measures) FW_TRY(measure(run, error));
    if (frame) FW_TRY(record(run, error));
    const fw_status signal = fw_interrupt_seen();
    if (signal != FW_OK) return interrupt(run, signal, error);
    if (checkpoint_is_due(run, step)) FW_TRY(checkpoint(run, error));
    return FW_OK;
}

static double particles_of(const fw_scenario *scenario)
{
    double count = 0;
    for (int b = 0; b < scenario->body_count; ++b) count += (double)scenario->bodies[b].shape.count;
    return count;
}

double fw_run_work(const fw_scenario *scenario)
{
    return particles_of(scenario) * (double)scenario->run.steps;
}

fw_status fw_run_to_end(fw_run *run, fw_error *error)
{
    fw_scene *scene = run->experiment->scene;
    const double step_work = particles_of(run->scenario);
    fw_progress_find(run->options.progress, step_work * (double)fw_scene_steps(scene));
    fw_status status = FW_OK;
    run->checkpointed = fw_progress_clock();
    while (status == FW_OK && fw_scene_steps(scene) < run->scenario->run.steps) {
        const int64_t before = fw_scene_steps(scene);
        status = step_on(run, INT64_MAX, error);
        fw_progress_add(run->options.progress,
                        step_work * (double)(fw_scene_steps(scene) - before));
    }
    if (status != FW_OK) fw_run_fail(run, status, error->sentence);
    return status == FW_OK && !run->options.keep_open ? fw_run_finish(run, error) : status;
}

fw_status fw_run_advance(fw_run *run, int64_t most, fw_error *error)
{
    fw_scene *scene = run->experiment->scene;
    const int64_t left = run->scenario->run.steps - fw_scene_steps(scene);
    const int64_t end = fw_scene_steps(scene) + (most < left ? most : left);
    fw_status status = FW_OK;
    while (status == FW_OK && fw_scene_steps(scene) < end)
        status = step_on(run, end - fw_scene_steps(scene), error);
    if (status == FW_OK) status = fw_scene_settle(scene, error);
    if (status != FW_OK) fw_run_fail(run, status, error->sentence);
    return status;
}

fw_status fw_run_stop(fw_run *run, fw_error *error)
{
    const fw_status status = interrupt(run, FW_INTERRUPTED, error);
    fw_run_fail(run, status, error->sentence);
    return status;
}

void fw_run_close(fw_run *run)
{
    fw_recorder_destroy(run->recorder);
    run->recorder = NULL;
}

fw_status fw_run_write_array(fw_run *run, const fw_trajectory_array *array, const double *values,
                             fw_error *error)
{
    return run->recorder ? fw_recorder_write_array(run->recorder, array, values, error) : FW_OK;
}

fw_status fw_run_finish(fw_run *run, fw_error *error)
{
    if (!run->recorder) return FW_OK;
    fw_interrupt_hold();
    fw_status status = fw_recorder_write_certificate(run->recorder, error);
    if (status == FW_OK) status = fw_recorder_finish(run->recorder, FW_OK, NULL, error);
    fw_interrupt_release();
    return status;
}

/* The reason goes into the file as far as the disk still takes it. */
void fw_run_fail(fw_run *run, fw_status status, const char *reason)
{
    fw_error ignored;
    if (!run->recorder) return;
    fw_interrupt_hold();
    fw_recorder_finish(run->recorder, status, reason, &ignored);
    fw_interrupt_release();
}

const char *fw_run_warnings(const fw_run *run)
{
    return run->recorder ? fw_recorder_warnings(run->recorder) : "";
}

void fw_run_set_outcome(fw_run *run, const fw_outcome *outcome, const double *outcome_of_seeds)
{
    run->measurement->outcome_of_seeds = outcome_of_seeds;
    run->measurement->outcome = outcome;
}

void fw_run_set_seeds(fw_run *run, const fw_measurement *const *seeds, int count)
{
    run->measurement->seeds = seeds;
    run->measurement->seed_count = count;
}

void fw_run_join_certificate(fw_run *run, const fw_run *other)
{
    fw_certificate_join(&run->observer->certificate, &other->observer->certificate);
}

const fw_certificate *fw_run_certificate(const fw_run *run)
{
    return &run->observer->certificate;
}

void fw_run_abandon(fw_run *run)
{
    if (!run) return;
    fw_recorder_abandon(run->recorder);
    run->recorder = NULL;
    fw_run_destroy(run);
}

void fw_run_destroy(fw_run *run)
{
    if (!run) return;
    fw_run_close(run);
    fw_measurement_destroy(run->measurement);
    fw_warning_clear(&run->warning);
    fw_observer_destroy(run->observer);
    free(run);
}

const fw_experiment *fw_run_experiment(const fw_run *run)
{
    return run->experiment;
}

const fw_observer *fw_run_observer(const fw_run *run)
{
    return run->observer;
}

const fw_measurement *fw_run_measurement(const fw_run *run)
{
    return run->measurement;
}

fw_status fw_run_size(const fw_run *run, fw_results_size *size, fw_error *error)
{
    return fw_recorder_size(run->observer, run->measurement, size, error);
}

fw_status fw_run_rehearse(fw_run *run, double seconds, double *seconds_per_step, fw_error *error)
{
    const fw_scene *scene = run->experiment->scene;
    int64_t first = fw_scene_steps(scene);
    double started = fw_progress_clock(), now = started;
    while (now - started < seconds && fw_scene_steps(scene) < run->scenario->run.steps) {
        FW_TRY(step_on(run, INT64_MAX, error));
        now = fw_progress_clock();
    }
    int64_t steps = fw_scene_steps(scene) - first;
    *seconds_per_step = steps > 0 ? (now - started) / (double)steps : 0;
    return FW_OK;
}
