/* SPDX-License-Identifier: GPL-3.0-or-later */
/* playback_frames.c - frames, samples and arrays of a results file that is open. State and
 * invariant: see playback.c. */
#include "playback_parts.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

fw_status fw_playback_refuse(fw_playback *playback, const char *path, fw_error *error)
{
    fw_hdf5_refuse(playback->file->hdf5, path);
    return fw_hdf5_check(playback->file->hdf5, error);
}

fw_dataset fw_playback_find_rows(fw_playback *playback, const char *path, fw_element element,
                                 int64_t rows, int rank, const uint64_t *extent)
{
    fw_shape shape;
    fw_dataset dataset = fw_hdf5_find(playback->file->hdf5, path);
    if (!fw_hdf5_shape(playback->file->hdf5, dataset, &shape) || shape.text ||
        shape.element != element || shape.rank != rank + 1 || rows < 0 ||
        shape.extent[0] < (uint64_t)rows)
        return -1;
    for (int i = 0; i < rank; ++i)
        if (shape.extent[i + 1] != extent[i]) return -1;
    return dataset;
}

static fw_status read_times(fw_playback *playback, const char *element, int64_t count,
                            int64_t *steps, double *times, fw_error *error)
{
    fw_hdf5 *hdf5 = playback->file->hdf5;
    char path[FW_NAME_SIZE + 64];
    for (int time = 0; time < 2; ++time) {
        void *to = time ? (void *)times : (void *)steps;
        if (!to) continue;
        snprintf(path, sizeof path, "%s/%s", element, time ? "time" : "step");
        fw_dataset dataset =
            fw_playback_find_rows(playback, path, time ? FW_F64 : FW_I64, count, 0, NULL);
        if (dataset < 0) return fw_playback_refuse(playback, path, error);
        fw_hdf5_read(hdf5, dataset, time ? FW_F64 : FW_I64, 0, (uint64_t)count, to);
    }
    return fw_hdf5_check(hdf5, error);
}

fw_status fw_playback_read_frame_times(fw_playback *playback, int64_t *steps, double *times,
                                       fw_error *error)
{
    return read_times(playback, FW_PARTICLES "/position", playback->frame_count, steps, times,
                      error);
}

fw_status fw_playback_read_sample_times(fw_playback *playback, int64_t *steps, double *times,
                                        fw_error *error)
{
    char element[FW_NAME_SIZE + 64];
    if (playback->observable_count == 0)
        return fw_fail(error, FW_BAD_INPUT, "the results hold no observables");
    snprintf(element, sizeof element, FW_SERIES "/%s", playback->observables[0].name);
    return read_times(playback, element, playback->sample_count, steps, times, error);
}

/* One frame of an element that may not be there. */
static fw_status read_element(fw_playback *playback, int64_t frame, const char *name, int rank,
                              double *values, fw_error *error)
{
    char path[FW_NAME_SIZE + 64];
    uint64_t extent[] = {(uint64_t)playback->particle_count, 3};
    if (frame < 0 || frame >= playback->frame_count)
        return fw_fail(error, FW_BAD_INPUT, "there is no frame %lld; the results have 0 to %lld",
                       (long long)frame, (long long)playback->frame_count - 1);
    snprintf(path, sizeof path, FW_PARTICLES "/%.*s/value", FW_NAME_SIZE - 1, name);
    fw_dataset dataset =
        fw_playback_find_rows(playback, path, FW_F64, playback->frame_count, rank, extent);
    if (dataset < 0)
        return fw_fail(error, FW_BAD_INPUT, "the frames of these results hold no %s", name);
    fw_hdf5_read(playback->file->hdf5, dataset, FW_F64, (uint64_t)frame, 1, values);
    fw_hdf5_release(dataset);
    return fw_hdf5_check(playback->file->hdf5, error);
}

static fw_status read_vectors(fw_playback *playback, int64_t frame, const char *name, double *x,
                              double *y, fw_error *error)
{
    const double *vectors = playback->file->vectors;
    FW_TRY(read_element(playback, frame, name, 2, playback->file->vectors, error));
    for (int i = 0; i < playback->particle_count; ++i) {
        x[i] = vectors[3 * i];
        y[i] = vectors[3 * i + 1];
    }
    return FW_OK;
}

fw_status fw_playback_read_positions(fw_playback *playback, int64_t frame, double *x, double *y,
                                     fw_error *error)
{
    return read_vectors(playback, frame, "position", x, y, error);
}

fw_status fw_playback_read_velocities(fw_playback *playback, int64_t frame, double *x, double *y,
                                      fw_error *error)
{
    return read_vectors(playback, frame, "velocity", x, y, error);
}

fw_status fw_playback_read_forces(fw_playback *playback, int64_t frame, double *x, double *y,
                                  fw_error *error)
{
    return read_vectors(playback, frame, "force", x, y, error);
}

fw_status fw_playback_read_field(fw_playback *playback, int64_t frame, const char *name,
                                 double *values, fw_error *error)
{
    return read_element(playback, frame, name, 1, values, error);
}

fw_status fw_playback_read_masses(fw_playback *playback, double *masses, fw_error *error)
{
    fw_dataset dataset = fw_playback_find_rows(playback, FW_PARTICLES "/mass", FW_F64,
                                               playback->particle_count, 0, NULL);
    FW_TRY(fw_playback_check(playback, error));
    if (dataset < 0) return fw_fail(error, FW_BAD_INPUT, "the results hold no masses");
    fw_hdf5_read(playback->file->hdf5, dataset, FW_F64, 0, (uint64_t)playback->particle_count,
                 masses);
    return fw_hdf5_check(playback->file->hdf5, error);
}

fw_status fw_playback_read_table(fw_playback *playback, const char *group, const char *name,
                                 fw_table *table, fw_error *error)
{
    char path[3 * FW_NAME_SIZE];
    fw_hdf5 *hdf5 = playback->file->hdf5;
    fw_shape shape;
    *table = (fw_table){.rank = 0};
    snprintf(path, sizeof path, "parameters/analysis/%.*s/%.*s", FW_NAME_SIZE - 1, group,
             FW_NAME_SIZE - 1, name);
    fw_dataset dataset = fw_hdf5_find(hdf5, path);
    FW_TRY(fw_playback_check(playback, error));
    if (dataset < 0)
        return fw_fail(error, FW_BAD_INPUT, "the results hold no %s of an analysis %s", name,
                       group);
    if (!fw_hdf5_shape(hdf5, dataset, &shape) || shape.text || shape.element != FW_F64 ||
        shape.rank < 1 || shape.rank > 2 || shape.extent[0] > INT_MAX ||
        (shape.rank == 2 && shape.extent[1] > INT_MAX) || !fw_hdf5_is_stored(hdf5, dataset))
        return fw_playback_refuse(playback, path, error);
    table->rank = shape.rank;
    for (int axis = 0; axis < shape.rank; ++axis) table->extent[axis] = (int)shape.extent[axis];
    table->values = fw_array_of_doubles((size_t)fw_table_size(table));
    if (!table->values) return fw_fail_memory(error, "the arrays of an analysis");
    fw_hdf5_read(hdf5, dataset, FW_F64, 0, shape.extent[0], table->values);
    fw_hdf5_release(dataset);
    return fw_hdf5_check(hdf5, error);
}

int fw_playback_find_observable(const fw_playback *playback, const char *name)
{
    for (int i = 0; i < playback->observable_count; ++i)
        if (strcmp(playback->observables[i].name, name) == 0) return i;
    return -1;
}

fw_status fw_playback_read_observable(fw_playback *playback, int observable, double *values,
                                      fw_error *error)
{
    char path[FW_NAME_SIZE + 64];
    const fw_playback_observable *wanted = &playback->observables[observable];
    uint64_t components = (uint64_t)wanted->components;
    snprintf(path, sizeof path, FW_SERIES "/%s/value", wanted->name);
    fw_dataset dataset = fw_playback_find_rows(playback, path, FW_F64, playback->sample_count,
                                               components > 1, &components);
    if (dataset < 0) return fw_playback_refuse(playback, path, error);
    fw_hdf5_read(playback->file->hdf5, dataset, FW_F64, 0, (uint64_t)playback->sample_count,
                 values);
    fw_hdf5_release(dataset);
    return fw_hdf5_check(playback->file->hdf5, error);
}

static fw_dataset find_array(fw_playback *playback, const char *name, int columns, int *rows)
{
    char path[FW_NAME_SIZE + 64];
    fw_shape shape;
    snprintf(path, sizeof path, "parameters/%s", name);
    fw_dataset dataset = fw_hdf5_find(playback->file->hdf5, path);
    *rows = 0;
    if (dataset < 0 || !fw_hdf5_shape(playback->file->hdf5, dataset, &shape) || shape.text ||
        shape.element != FW_F64 || shape.rank < 1 || shape.rank > 2 ||
        shape.extent[0] > (uint64_t)INT_MAX)
        return -1;
    const uint64_t found = shape.rank == 2 ? shape.extent[1] : columns > 1 ? shape.extent[0] : 1;
    if (found != (uint64_t)columns || !fw_hdf5_is_stored(playback->file->hdf5, dataset)) return -1;
    *rows = shape.rank == 1 && columns > 1 ? 1 : (int)shape.extent[0];
    return dataset;
}

int fw_playback_array_rows(fw_playback *playback, const char *name, int columns)
{
    int rows;
    fw_hdf5_release(find_array(playback, name, columns, &rows));
    return rows;
}

fw_status fw_playback_read_array(fw_playback *playback, const char *name, int rows, int columns,
                                 double *values, fw_error *error)
{
    int found;
    fw_dataset dataset = find_array(playback, name, columns, &found);
    if (dataset < 0 || found != rows) return fw_playback_refuse(playback, name, error);
    fw_hdf5_read(playback->file->hdf5, dataset, FW_F64, 0, (uint64_t)(rows > 1 ? rows : columns),
                 values);
    fw_hdf5_release(dataset);
    return fw_hdf5_check(playback->file->hdf5, error);
}
