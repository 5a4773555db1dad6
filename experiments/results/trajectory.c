/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory.c - the results file while a run writes it.
 * State: the folder it holds, the open file, the series of frames and that of samples. Invariant:
 * between two calls the file on disk has its final structure, and every committed row is whole.
 * Start reading at fw_trajectory_create(); trajectory_layout.c makes what never changes, and
 * trajectory_rows.c writes what does. */
#include "trajectory_parts.h"

#include "experiments/results/result_files.h"
#include "experiments/storage/manifest.h"
#include "experiments/storage/sealed_file.h"
#include "trajectory_head.h"
#include "trajectory_layout.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FRESH_FILE FW_TRAJECTORY_FILE FW_FRESH_SUFFIX

/* Samples gathered before they are written, and the longest time that takes in seconds. */
enum { SAMPLE_BLOCK = 256, SAMPLE_SECONDS = 1 };

fw_trajectory_def fw_trajectory_def_default(void)
{
    return (fw_trajectory_def){.directory = "results",
                               .title = "",
                               .scenario = "",
                               .forms = "",
                               .threads = 1,
                               .velocity = true};
}

double fw_trajectory_size(const fw_trajectory_def *def)
{
    double particles = 0, links = 0, components = 0;
    for (int i = 0; i < def->body_count; ++i) {
        particles += def->bodies[i].count;
        links += def->bodies[i].link_count;
    }
    for (int i = 0; i < def->observable_count; ++i) components += def->observables[i].components;
    /* Their rows at frames lie together in chunks, and few frames leave most of one empty. */
    double at_frames = 0;
    for (int i = 0; i < def->observable_count; ++i) {
        const int width = def->observables[i].components;
        const double rows = (double)fw_series_chunk((size_t)width);
        at_frames += width * rows * ceil((double)def->frame_count / rows);
    }
    for (int i = 0; i < def->array_count; ++i)
        components += (double)def->arrays[i].rows * def->arrays[i].columns /
                      fmax(1, (double)def->sample_count);
    double tables = 0;
    for (int g = 0; g < def->group_count; ++g)
        for (int n = 0; n < def->groups[g].table_count; ++n)
            tables += 8 * (double)fw_table_size(&def->groups[g].tables[n]);
    int numbers = 3 * (1 + def->velocity + def->force) + def->field_count;
    return (double)fw_layout_structure(def) + (double)strlen(def->scenario) + tables +
           16 * particles + 8 * links + (double)def->frame_count * (8 * numbers * particles + 16) +
           (double)def->sample_count * (8 * components + 16) + 8 * at_frames;
}

static fw_status allocate(fw_trajectory **trajectory, const fw_trajectory_def *def, fw_error *error)
{
    fw_trajectory *fresh = calloc(1, sizeof *fresh);
    *trajectory = fresh;
    if (!fresh) return fw_fail_memory(error, "the results file");
    fresh->body_count = def->body_count;
    fresh->field_count = def->field_count;
    fresh->observable_count = def->observable_count;
    fresh->counts = calloc((size_t)def->body_count + 1, sizeof *fresh->counts);
    fresh->fields = calloc((size_t)def->field_count + 1, sizeof *fresh->fields);
    fresh->components = calloc((size_t)def->observable_count + 1, sizeof *fresh->components);
    fresh->moments = calloc((size_t)def->observable_count + 1, sizeof *fresh->moments);
    if (!fresh->counts || !fresh->fields || !fresh->components || !fresh->moments)
        return fw_fail_memory(error, "the results file");
    for (int i = 0; i < def->observable_count; ++i) {
        fresh->components[i] = def->observables[i].components;
        fresh->sample_width += (size_t)fresh->components[i];
    }
    fresh->sample_step = -1;
    fresh->sample = fw_array_of_doubles(fresh->sample_width);
    if (!fresh->sample) return fw_fail_memory(error, "a row of results");
    for (int i = 0; i < def->body_count; ++i) {
        fresh->counts[i] = def->bodies[i].count;
        fresh->particle_count += def->bodies[i].count;
    }
    return FW_OK;
}

static int add_element(fw_trajectory *trajectory, const char *name, int rank)
{
    char path[FW_NAME_SIZE + 64];
    uint64_t extent[] = {(uint64_t)trajectory->particle_count, 3};
    snprintf(path, sizeof path, "particles/trajectory/%s", name);
    return fw_series_add(trajectory->frames, path, rank, extent);
}

/* Makes both series, or finds them in the file. */
static fw_status add_series(fw_trajectory *trajectory, const fw_trajectory_def *def, bool fresh,
                            fw_error *error)
{
    bool complete = true;
    trajectory->frames =
        fw_series_create(trajectory->file, "parameters/frames_committed", fresh, 1, 0);
    trajectory->samples = fw_series_create(trajectory->file, "parameters/samples_committed", fresh,
                                           SAMPLE_BLOCK, SAMPLE_SECONDS);
    if (!trajectory->frames || !trajectory->samples)
        return fw_fail_memory(error, "the rows of results");
    trajectory->position = add_element(trajectory, "position", 2);
    trajectory->velocity = def->velocity ? add_element(trajectory, "velocity", 2) : -1;
    trajectory->force = def->force ? add_element(trajectory, "force", 2) : -1;
    complete = trajectory->position >= 0 && (!def->velocity || trajectory->velocity >= 0) &&
               (!def->force || trajectory->force >= 0);
    for (int i = 0; i < def->field_count; ++i) {
        trajectory->fields[i] = add_element(trajectory, def->fields[i].name, 1);
        complete = complete && trajectory->fields[i] >= 0;
    }
    for (int i = 0; i < def->observable_count; ++i) {
        char path[FW_NAME_SIZE + 64];
        uint64_t components = (uint64_t)def->observables[i].components;
        snprintf(path, sizeof path, "parameters/series/%s", def->observables[i].name);
        complete =
            fw_series_add(trajectory->samples, path, components > 1, &components) == i && complete;
        snprintf(path, sizeof path, "observables/%s", def->observables[i].name);
        trajectory->moments[i] =
            fw_series_add(trajectory->frames, path, components > 1, &components);
        complete = complete && trajectory->moments[i] >= 0;
    }
    return complete ? FW_OK : fw_fail_memory(error, "the rows of results");
}

/* After what is still being written. */
static void close_file(fw_trajectory *trajectory)
{
    fw_error ignored;
    fw_series_destroy(trajectory->frames);
    fw_series_destroy(trajectory->samples);
    trajectory->frames = trajectory->samples = NULL;
    fw_hdf5_close(trajectory->file, &ignored);
    trajectory->file = NULL;
}

static void release(fw_trajectory *trajectory)
{
    if (!trajectory) return;
    free(trajectory->counts);
    free(trajectory->fields);
    free(trajectory->components);
    free(trajectory->moments);
    free(trajectory->sample);
    free(trajectory);
}

/* Lays out the whole file; `*cramped` when its structure needs more than `structure` bytes. */
static fw_status lay_out(fw_trajectory *trajectory, const fw_trajectory_def *def, size_t structure,
                         bool *cramped, fw_error *error)
{
    char path[FW_PATH_SIZE];
    FW_TRY(fw_folder_path(trajectory->folder, FRESH_FILE, path, error));
    FW_TRY(fw_hdf5_create(&trajectory->file, path, structure, error));
    fw_layout_make(trajectory->file, def);
    FW_TRY(add_series(trajectory, def, true, error));
    fw_layout_describe(trajectory->file, def);
    fw_series_reserve(trajectory->samples, def->sample_count);
    fw_series_reserve(trajectory->frames, def->frame_count);
    FW_TRY(fw_hdf5_check(trajectory->file, error));
    *cramped = !fw_hdf5_is_compact(trajectory->file);
    if (!*cramped) fw_hdf5_reserve(trajectory->file);
    fw_layout_seal(trajectory->file);
    fw_hdf5_sync(trajectory->file);
    return fw_hdf5_check(trajectory->file, error);
}

bool fw_trajectory_is_in(const fw_folder *folder)
{
    return fw_folder_has(folder, FW_TRAJECTORY_FILE) || fw_folder_has(folder, FW_SWEEP_SCENARIO);
}

fw_status fw_trajectory_refuse(const char *directory, fw_error *error)
{
    return fw_fail(error, FW_BAD_INPUT,
                   "%s holds a result already; --overwrite replaces it, -o DIR puts the new one "
                   "elsewhere",
                   directory);
}

/* What belongs to an earlier result: beside a new one it would make no sense. The manifest stays,
 * so that tables and pictures that are still there are known as ours whenever the run is killed. */
static fw_status forget(const fw_folder *folder, fw_error *error)
{
    for (int n = 0; fw_result_file(n); ++n) {
        const char *name = fw_result_file(n);
        const bool stays = strcmp(name, FW_TRAJECTORY_FILE) == 0 || strcmp(name, FRESH_FILE) == 0 ||
                           strcmp(name, FW_MANIFEST_FILE) == 0;
        if (!stays) FW_TRY(fw_folder_remove(folder, name, error));
    }
    return fw_head_remove(folder, error);
}

fw_status fw_trajectory_discard(const fw_folder *folder, fw_error *error)
{
    FW_TRY(fw_folder_remove(folder, FW_TRAJECTORY_FILE, error));
    return forget(folder, error);
}

/* The fresh file becomes the result. One of which nobody knows whether the disk has its name is
 * none. */
static fw_status publish(const fw_folder *folder, fw_error *error)
{
    FW_TRY(forget(folder, error));
    const bool is_there = fw_folder_has(folder, FRESH_FILE);
    const fw_status status = fw_folder_replace(folder, FRESH_FILE, FW_TRAJECTORY_FILE, error);
    if (status != FW_OK && is_there && !fw_folder_has(folder, FRESH_FILE))
        fw_folder_discard(folder, FW_TRAJECTORY_FILE);
    return status;
}

static fw_status create_in(fw_folder *folder, fw_trajectory **trajectory,
                           const fw_trajectory_def *def, fw_error *error)
{
    if (fw_trajectory_is_in(folder) && !def->overwrite)
        return fw_trajectory_refuse(def->directory, error);
    /* Before it is tried: laying out what will never fit could take hours. */
    double needed = fw_trajectory_size(def), room = fw_folder_room(folder);
    if (needed > room)
        return fw_fail(error, FW_SYSTEM_FAILED,
                       "no room for %s/" FW_TRAJECTORY_FILE ", which takes %.3g MB: %.3g MB are "
                       "free",
                       def->directory, needed / 1e6, room / 1e6);
    /* The size of the structure is a suggestion; HDF5 reports afterwards whether it was enough. */
    bool cramped = true;
    for (size_t structure = fw_layout_structure(def); cramped; structure *= 2) {
        if (*trajectory) {
            close_file(*trajectory);
            release(*trajectory);
        }
        FW_TRY(allocate(trajectory, def, error));
        (*trajectory)->folder = folder;
        FW_TRY(lay_out(*trajectory, def, structure, &cramped, error));
    }
    return publish(folder, error);
}

fw_status fw_trajectory_create(fw_trajectory **trajectory, const fw_trajectory_def *def,
                               fw_error *error)
{
    *trajectory = NULL;
    fw_folder *folder;
    FW_TRY(fw_layout_check(def, error));
    FW_TRY(fw_folder_create(&folder, def->directory, error));
    fw_status status = create_in(folder, trajectory, def, error);
    if (status == FW_OK) return FW_OK;
    if (*trajectory) close_file(*trajectory);
    fw_folder_discard(folder, FRESH_FILE);
    fw_folder_abandon(folder);
    release(*trajectory);
    *trajectory = NULL;
    return status;
}

fw_status fw_trajectory_mend(const char *directory, fw_error *error)
{
    fw_folder *folder;
    FW_TRY(fw_folder_open(&folder, directory, error));
    fw_status status = FW_OK;
    if (!fw_folder_has(folder, FW_TRAJECTORY_FILE))
        status = fw_fail(error, FW_BAD_INPUT,
                         "%s holds no results; a run that ended before it had laid them out is "
                         "started again with `fretwork run`",
                         directory);
    else if (fw_head_is_torn(folder))
        status = fw_head_restore(folder, error);
    if (status == FW_OK && fw_head_is_torn(folder)) status = fw_head_remove(folder, error);
    fw_folder_close(folder);
    return status;
}

/* Everything in the file is what the definition says, and goes back to the given rows. */
static fw_status resume_in(fw_trajectory *trajectory, const fw_trajectory_def *def, int64_t frames,
                           int64_t samples, fw_error *error)
{
    char path[FW_PATH_SIZE];
    FW_TRY(fw_folder_path(trajectory->folder, FW_TRAJECTORY_FILE, path, error));
    FW_TRY(fw_head_restore(trajectory->folder, error));
    FW_TRY(fw_hdf5_open(&trajectory->file, path, true, error));
    FW_TRY(fw_layout_check_seal(trajectory->file, error));
    FW_TRY(fw_layout_compare(trajectory->file, def, error));
    FW_TRY(add_series(trajectory, def, false, error));
    FW_TRY(fw_hdf5_check(trajectory->file, error));
    if (fw_series_count(trajectory->frames) < frames ||
        fw_series_count(trajectory->samples) < samples)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s holds %lld frames and %lld samples, less than the %lld and %lld of the "
                       "checkpoint",
                       path, (long long)fw_series_count(trajectory->frames),
                       (long long)fw_series_count(trajectory->samples), (long long)frames,
                       (long long)samples);
    if (fw_series_room(trajectory->frames) < def->frame_count ||
        (def->observable_count > 0 && fw_series_room(trajectory->samples) < def->sample_count))
        return fw_fail(error, FW_BAD_INPUT, "%s has no room for the %lld frames of this run", path,
                       (long long)def->frame_count);
    fw_series_rewind(trajectory->frames, frames);
    fw_series_rewind(trajectory->samples, samples);
    fw_layout_reopen(trajectory->file);
    fw_hdf5_sync(trajectory->file);
    FW_TRY(fw_hdf5_check(trajectory->file, error));
    return fw_head_remove(trajectory->folder, error);
}

fw_status fw_trajectory_reopen(fw_trajectory **trajectory, const fw_trajectory_def *def,
                               int64_t frames, int64_t samples, fw_error *error)
{
    fw_folder *folder;
    *trajectory = NULL;
    FW_TRY(fw_layout_check(def, error));
    FW_TRY(fw_folder_open(&folder, def->directory, error));
    fw_status status = allocate(trajectory, def, error);
    if (status == FW_OK) {
        (*trajectory)->folder = folder;
        status = resume_in(*trajectory, def, frames, samples, error);
        if (status == FW_OK) return FW_OK;
    }
    if (*trajectory) close_file(*trajectory);
    fw_folder_close(folder);
    release(*trajectory);
    *trajectory = NULL;
    return status;
}

void fw_trajectory_abandon(fw_trajectory *trajectory)
{
    if (!trajectory) return;
    fw_error ignored;
    close_file(trajectory);
    fw_trajectory_discard(trajectory->folder, &ignored);
    fw_folder_abandon(trajectory->folder);
    release(trajectory);
}

void fw_trajectory_destroy(fw_trajectory *trajectory)
{
    if (!trajectory) return;
    close_file(trajectory);
    fw_folder_close(trajectory->folder);
    release(trajectory);
}
