/* SPDX-License-Identifier: GPL-3.0-or-later */
/* recorder.c - frames, rows and checkpoints of a run.
 * State: counters of what was written; they are part of each checkpoint. Invariant: rows and
 * frames that a checkpoint counts are on disk before it is. Start reading at
 * fw_recorder_create(). */
#include "experiments/study/recorder.h"

#include "experiments/results/checkpoint.h"
#include "file_plan.h"
#include "frame.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct fw_recorder {
    fw_observer *observer;
    fw_experiment *experiment; /* of the observer */
    fw_file_plan plan;
    fw_frame frame;
    fw_trajectory *trajectory;
    fw_checkpoint *checkpoint;
    int section_count;
    fw_checkpoint_section *sections;
    fw_state_list *states;
    fw_written written; /* part of every checkpoint */
    char warnings[FW_WARNINGS_SIZE + 1];
};

/* The scene's sections, the recorder's own counters, and what is followed beside the scene. */
static fw_status list_sections(fw_recorder *r, fw_error *error)
{
    int count = fw_scene_section_count(r->experiment->scene);
    r->section_count = count + 2;
    r->sections = calloc((size_t)r->section_count, sizeof *r->sections);
    r->states = calloc((size_t)r->section_count, sizeof *r->states);
    if (!r->sections || !r->states) return fw_fail_memory(error, "a checkpoint");
    for (int n = 0; n < count; ++n) {
        r->sections[n].name = fw_scene_section(r->experiment->scene, n, &r->states[n]);
        r->sections[n].state = &r->states[n];
    }
    fw_state_list_add(&r->states[count], "written", FW_I64, sizeof r->written / sizeof(int64_t),
                      &r->written);
    r->sections[count] = (fw_checkpoint_section){"recorder", &r->states[count]};
    fw_observer_state(r->observer, &r->states[count + 1]);
    r->sections[count + 1] = (fw_checkpoint_section){"observer", &r->states[count + 1]};
    return FW_OK;
}

static fw_status prepare(fw_recorder **recorder, fw_observer *observer,
                         const fw_measurement *measurement, const char *directory, int threads,
                         fw_error *error)
{
    fw_recorder *made = calloc(1, sizeof *made);
    *recorder = made;
    if (!made) return fw_fail_memory(error, "a recorder");
    made->observer = observer;
    made->experiment = observer->experiment;
    FW_TRY(fw_file_plan_make(&made->plan, observer, measurement, directory, threads, error));
    FW_TRY(fw_frame_make(&made->frame, made->experiment, &made->plan.def, error));
    return list_sections(made, error);
}

static fw_status give_up(fw_recorder **recorder, fw_status status)
{
    if (status == FW_OK) return FW_OK;
    fw_recorder_destroy(*recorder);
    *recorder = NULL;
    return status;
}

fw_status fw_recorder_create(fw_recorder **recorder, fw_observer *observer,
                             const fw_measurement *measurement, const char *directory,
                             bool overwrite, int threads, fw_error *error)
{
    fw_status status = prepare(recorder, observer, measurement, directory, threads, error);
    if (status == FW_OK) {
        fw_recorder *r = *recorder;
        r->plan.def.overwrite = overwrite;
        status = fw_trajectory_create(&r->trajectory, &r->plan.def, error);
        if (status == FW_OK)
            status = fw_checkpoint_open(&r->checkpoint, directory, r->plan.scenario, error);
        if (status != FW_OK) {
            fw_trajectory_abandon(r->trajectory);
            r->trajectory = NULL;
        }
    }
    return give_up(recorder, status);
}

/* A checkpoint may come from anybody: what it says must be what this run could have written. */
static fw_status check_restored(const fw_recorder *r, const fw_checkpoint_origin *origin,
                                fw_error *error)
{
    const fw_scene *scene = r->experiment->scene;
    const int64_t step = fw_scene_steps(scene), rows = r->written.rows, frames = r->written.frames;
    FW_TRY(fw_scene_restored(r->experiment->scene, error));
    if (r->observer->profile) FW_TRY(fw_profile_restored(r->observer->profile, error));
    if (step != origin->step || step > r->experiment->scenario->run.steps)
        return fw_fail(error, FW_BAD_INPUT, "it is of step %lld and holds step %lld of %lld",
                       (long long)origin->step, (long long)step,
                       (long long)r->experiment->scenario->run.steps);
    if (r->written.warning_bytes < 0 || r->written.warning_bytes > FW_WARNINGS_SIZE)
        return fw_fail(error, FW_BAD_INPUT, "it speaks of %lld bytes of warnings, expected 0 to %d",
                       (long long)r->written.warning_bytes, FW_WARNINGS_SIZE);
    if (rows >= 1 && rows <= r->plan.def.sample_count && frames >= 1 &&
        frames <= r->plan.def.frame_count)
        return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "it speaks of %lld measured rows and %lld frames, expected 1 to %lld and 1 to "
                   "%lld",
                   (long long)rows, (long long)frames, (long long)r->plan.def.sample_count,
                   (long long)r->plan.def.frame_count);
}

static fw_status load(fw_recorder *r, fw_checkpoint_origin *origin, fw_error *error)
{
    FW_TRY(fw_checkpoint_load(r->checkpoint, r->sections, r->section_count, origin, error));
    if (check_restored(r, origin, error) == FW_OK) return FW_OK;
    return fw_fail_within(error, "%s/%s", r->plan.directory, origin->name);
}

static void note_fallback(const fw_checkpoint_origin *origin, char note[FW_SENTENCE_SIZE])
{
    fw_error sentence;
    fw_fail(&sentence, FW_OK,
            "going on from %s at step %lld, since the other checkpoint cannot be used: %s",
            origin->name, (long long)origin->step, origin->newer_error.sentence);
    snprintf(note, FW_SENTENCE_SIZE, "%s", sentence.sentence);
}

fw_status fw_recorder_reopen(fw_recorder **recorder, fw_observer *observer,
                             const fw_measurement *measurement, const char *directory, int threads,
                             fw_written *written, char note[FW_SENTENCE_SIZE], fw_error *error)
{
    fw_status status = prepare(recorder, observer, measurement, directory, threads, error);
    fw_recorder *r = *recorder;
    fw_checkpoint_origin origin = {0};
    if (status == FW_OK)
        status = fw_checkpoint_open(&r->checkpoint, directory, r->plan.scenario, error);
    if (status == FW_OK && !fw_checkpoint_exists(r->checkpoint)) {
        *written = (fw_written){0};
        snprintf(note, FW_SENTENCE_SIZE,
                 "the run ended before its first checkpoint, it begins again");
    } else if (status == FW_OK) {
        status = load(r, &origin, error);
        *written = r->written;
        if (status == FW_OK && origin.fallen_back) note_fallback(&origin, note);
    }
    return give_up(recorder, status);
}

fw_status fw_recorder_go_on(fw_recorder *recorder, const char *warnings, fw_error *error)
{
    snprintf(recorder->warnings, sizeof recorder->warnings, "%.*s",
             (int)recorder->written.warning_bytes, warnings);
    FW_TRY(fw_trajectory_reopen(&recorder->trajectory, &recorder->plan.def,
                                recorder->written.frames, recorder->written.rows, error));
    return fw_trajectory_warn(recorder->trajectory, recorder->warnings, error);
}

/* --- writing --- */

fw_status fw_recorder_write_row(fw_recorder *recorder, int64_t step, double time, const double *row,
                                fw_error *error)
{
    recorder->written.rows += 1;
    return fw_trajectory_write_sample(recorder->trajectory, step, time, row, error);
}

fw_status fw_recorder_write_frame(fw_recorder *recorder, fw_error *error)
{
    const fw_scene *scene = recorder->experiment->scene;
    recorder->written.frames += 1;
    return fw_trajectory_write_frame(recorder->trajectory, fw_scene_steps(scene),
                                     fw_scene_time(scene), fw_frame_fill(&recorder->frame), error);
}

bool fw_recorder_needs_positions(const fw_recorder *recorder)
{
    return fw_frame_needs_positions(&recorder->frame);
}

fw_status fw_recorder_add_warnings(fw_recorder *recorder, const char *lines, int64_t warned,
                                   fw_error *error)
{
    const size_t before = strlen(recorder->warnings), more = strlen(lines);
    recorder->written.warned = warned;
    if (more == 0) return FW_OK;
    /* What there is no room for was said all the same. */
    if (before + more > FW_WARNINGS_SIZE) return FW_OK;
    memcpy(recorder->warnings + before, lines, more + 1);
    recorder->written.warning_bytes = (int64_t)(before + more);
    return fw_trajectory_warn(recorder->trajectory, recorder->warnings, error);
}

const char *fw_recorder_warnings(const fw_recorder *recorder)
{
    return recorder->warnings;
}

fw_status fw_recorder_checkpoint(fw_recorder *recorder, fw_error *error)
{
    FW_TRY(fw_trajectory_sync(recorder->trajectory, error));
    return fw_checkpoint_write(recorder->checkpoint, recorder->sections, recorder->section_count,
                               fw_scene_steps(recorder->experiment->scene), error);
}

fw_status fw_recorder_write_array(fw_recorder *recorder, const fw_trajectory_array *array,
                                  const double *values, fw_error *error)
{
    return fw_trajectory_write_array(recorder->trajectory, array, values, error);
}

fw_status fw_recorder_write_certificate(fw_recorder *recorder, fw_error *error)
{
    const fw_trajectory_def *def = &recorder->plan.def;
    for (int n = 0; n < def->array_count; ++n) {
        const int item = fw_certificate_find(def->arrays[n].name);
        if (item < 0) continue;
        FW_TRY(fw_recorder_write_array(recorder, &def->arrays[n],
                                       &recorder->observer->certificate.worst[item], error));
    }
    return FW_OK;
}

fw_status fw_recorder_finish(fw_recorder *recorder, fw_status status, const char *reason,
                             fw_error *error)
{
    if (status == FW_DIVERGED) fw_trajectory_fail(recorder->trajectory, status);
    return fw_trajectory_finish(recorder->trajectory, reason ? reason : FW_RUN_FINISHED, error);
}

void fw_recorder_abandon(fw_recorder *recorder)
{
    if (!recorder) return;
    fw_trajectory_abandon(recorder->trajectory);
    recorder->trajectory = NULL;
    fw_recorder_destroy(recorder);
}

void fw_recorder_destroy(fw_recorder *recorder)
{
    if (!recorder) return;
    fw_trajectory_destroy(recorder->trajectory);
    fw_checkpoint_close(recorder->checkpoint);
    fw_frame_clear(&recorder->frame);
    fw_file_plan_clear(&recorder->plan);
    free(recorder->sections);
    free(recorder->states);
    free(recorder);
}

fw_status fw_recorder_size(fw_observer *observer, const fw_measurement *measurement,
                           fw_results_size *size, fw_error *error)
{
    fw_recorder *r;
    /* Nothing is created on disk: only the definition is made. */
    fw_status status = prepare(&r, observer, measurement, "", 1, error);
    if (status == FW_OK)
        *size = (fw_results_size){
            .frames = r->plan.def.frame_count,
            .rows = r->plan.def.sample_count,
            .row_width = measurement->width,
            .file = fw_trajectory_size(&r->plan.def),
            .checkpoint = (double)fw_checkpoint_size(r->sections, r->section_count),
        };
    fw_recorder_destroy(r);
    return status;
}
