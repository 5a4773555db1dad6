/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_rows.c - frames, samples and the end of a results file. State and invariant: see
 * trajectory.c. Start reading at fw_trajectory_write_frame(). */
#include "experiments/results/provenance.h"
#include "trajectory_head.h"
#include "trajectory_layout.h"
#include "trajectory_parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Observables as H5MD's readers take them, row k with frame k: those of the sample that was taken
 * at the frame's step; not a number where none was. */
static void write_moments(fw_trajectory *trajectory, int64_t step)
{
    double *values = trajectory->sample;
    if (trajectory->sample_step != step)
        for (size_t n = 0; n < trajectory->sample_width; ++n) values[n] = NAN;
    for (int i = 0; i < trajectory->observable_count; ++i) {
        fw_series_write(trajectory->frames, trajectory->moments[i], values);
        values += trajectory->components[i];
    }
}

fw_status fw_trajectory_write_frame(fw_trajectory *trajectory, int64_t step, double time,
                                    const fw_frame_body *bodies, fw_error *error)
{
    const int kinds[] = {trajectory->position, trajectory->velocity, trajectory->force};
    for (int kind = 0; kind < 3; ++kind) {
        if (kinds[kind] < 0) continue;
        double *restrict to = fw_series_fill(trajectory->frames, kinds[kind]);
        for (int body = 0; body < trajectory->body_count; ++body) {
            const fw_frame_body *from = &bodies[body];
            const double *x = kind == 0 ? from->x : kind == 1 ? from->velocity_x : from->force_x;
            const double *y = kind == 0 ? from->y : kind == 1 ? from->velocity_y : from->force_y;
            for (int i = 0; i < trajectory->counts[body]; ++i, to += 3) {
                to[0] = x[i];
                to[1] = y[i];
                to[2] = 0;
            }
        }
    }
    for (int field = 0; field < trajectory->field_count; ++field) {
        double *to = fw_series_fill(trajectory->frames, trajectory->fields[field]);
        for (int body = 0; body < trajectory->body_count; ++body) {
            const double *from = bodies[body].fields ? bodies[body].fields[field] : NULL;
            for (int i = 0; i < trajectory->counts[body]; ++i) *to++ = from ? from[i] : NAN;
        }
    }
    write_moments(trajectory, step);
    fw_series_end_row(trajectory->frames, step, time);
    return fw_hdf5_check(trajectory->file, error);
}

fw_status fw_trajectory_write_sample(fw_trajectory *trajectory, int64_t step, double time,
                                     const double *values, fw_error *error)
{
    memcpy(trajectory->sample, values, trajectory->sample_width * sizeof *values);
    trajectory->sample_step = step;
    for (int i = 0; i < trajectory->observable_count; ++i) {
        fw_series_write(trajectory->samples, i, values);
        values += trajectory->components[i];
    }
    fw_series_end_row(trajectory->samples, step, time);
    return fw_hdf5_check(trajectory->file, error);
}

fw_status fw_trajectory_write_array(fw_trajectory *trajectory, const fw_trajectory_array *array,
                                    const double *values, fw_error *error)
{
    char path[FW_NAME_SIZE + 64];
    snprintf(path, sizeof path, "parameters/%s", array->name);
    const uint64_t first_extent = (uint64_t)(array->rows > 1 ? array->rows : array->columns);
    fw_dataset dataset = fw_hdf5_find(trajectory->file, path);
    if (dataset < 0) fw_hdf5_refuse(trajectory->file, path);
    fw_hdf5_write(trajectory->file, dataset, FW_F64, 0, first_extent, values);
    fw_hdf5_release(dataset);
    return fw_hdf5_check(trajectory->file, error);
}

int64_t fw_trajectory_sample_count(const fw_trajectory *trajectory)
{
    return fw_series_count(trajectory->samples);
}

fw_status fw_trajectory_sync(fw_trajectory *trajectory, fw_error *error)
{
    fw_series_commit(trajectory->frames);
    fw_series_commit(trajectory->samples);
    fw_hdf5_sync(trajectory->file);
    return fw_hdf5_check(trajectory->file, error);
}

/* Cuts the room for rows that were not written, with a way back at any moment. */
static fw_status cut(fw_trajectory *trajectory, bool resumable, fw_error *error)
{
    fw_hdf5 *file = trajectory->file;
    const fw_head_facts facts = {.size = fw_layout_head(file),
                                 .seal_at = fw_layout_seal_place(file),
                                 .whole = fw_hdf5_size(file)};
    fw_hdf5_sync(file);
    FW_TRY(fw_hdf5_check(file, error));
    FW_TRY(fw_head_save(trajectory->folder, &facts, error));
    fw_series_reserve(trajectory->samples, fw_series_count(trajectory->samples));
    fw_series_reserve(trajectory->frames, fw_series_count(trajectory->frames));
    fw_hdf5_sync(file);
    trajectory->file = NULL;
    FW_TRY(fw_hdf5_close(file, error));
    FW_TRY(fw_head_seal(trajectory->folder, facts.seal_at, error));
    return fw_head_settle(trajectory->folder, resumable, error);
}

void fw_trajectory_fail(fw_trajectory *trajectory, fw_status status)
{
    fw_layout_note_status(trajectory->file, status);
}

fw_status fw_trajectory_finish(fw_trajectory *trajectory, const char *exit_reason, fw_error *error)
{
    char end[FW_PROVENANCE_SIZE];
    fw_provenance_time(end, sizeof end);
    fw_series_commit(trajectory->frames);
    fw_series_commit(trajectory->samples);
    fw_layout_note(trajectory->file, "end", end);
    fw_layout_note(trajectory->file, "exit_reason", exit_reason);
    if (fw_series_count(trajectory->frames) < fw_series_room(trajectory->frames) ||
        fw_series_count(trajectory->samples) < fw_series_room(trajectory->samples))
        return cut(trajectory, strcmp(exit_reason, FW_RUN_FINISHED) != 0, error);
    fw_hdf5_sync(trajectory->file);
    fw_status status = fw_hdf5_close(trajectory->file, error);
    trajectory->file = NULL;
    return status;
}

fw_status fw_trajectory_warn(fw_trajectory *trajectory, const char *warnings, fw_error *error)
{
    fw_layout_warn(trajectory->file, warnings);
    fw_hdf5_flush(trajectory->file);
    return fw_hdf5_check(trajectory->file, error);
}
