/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_rows.c - frames, samples and the end of a results file. State and invariant: see
 * trajectory.c. Start reading at fw_trajectory_write_frame(). */
#include "core/solid.h"
#include "experiments/results/provenance.h"
#include "frame_kernels.h"
#include "trajectory_head.h"
#include "trajectory_layout.h"
#include "trajectory_parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A body of fewer particles is not worth a second thread; rows of more than MANY are larger than
 * the nearest caches. */
enum { ALONE = 16384, MANY = 65536 };

/* Between arrays that would else begin at the same place of their pages. */
enum { APART = 40 };

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

/* Where the rows of one body go; NULL: frames do not hold them. */
typedef struct frame_rows {
    double *position, *velocity, *force;
    bool past_cache;
} frame_rows;

static double *behind(double *rows, int count)
{
    return rows ? rows + 3 * (size_t)count : NULL;
}

static void put(const frame_rows *rows, double *to, const double *x, const double *y, int count)
{
    if (to) FW_KERNELS_CHOSEN(fw_frames)->rows(x, y, count, rows->past_cache, to);
}

/* Particles first .. first + count - 1 of a body. */
static void write_block(const fw_frame_body *body, int first, int count, const frame_rows *rows)
{
    double made[4][FW_FRAME_BLOCK + APART];
    const double *x = body->x, *y = body->y, *velocity_x = body->velocity_x,
                 *velocity_y = body->velocity_y;
    int from = first;
    if (body->solid) {
        const fw_motions motions = {made[0], made[1], made[2], made[3]};
        body->solid->model->motions(body->solid, body->first + first, count, &motions);
        x = made[0], y = made[1], velocity_x = made[2], velocity_y = made[3];
        from = 0;
    }
    put(rows, behind(rows->position, first), x + from, y + from, count);
    if (rows->velocity)
        put(rows, behind(rows->velocity, first), velocity_x + from, velocity_y + from, count);
    if (rows->force)
        put(rows, behind(rows->force, first), body->force_x + first, body->force_y + first, count);
}

static void write_body(const fw_frame_body *body, int count, const frame_rows *rows)
{
#pragma omp parallel if (count > ALONE)
    {
#pragma omp for schedule(static)
        for (int first = 0; first < count; first += FW_FRAME_BLOCK) {
            const int left = count - first;
            write_block(body, first, left < FW_FRAME_BLOCK ? left : FW_FRAME_BLOCK, rows);
        }
        if (rows->past_cache) FW_KERNELS_CHOSEN(fw_frames)->settle();
    }
}

static double *fill(fw_trajectory *trajectory, int quantity)
{
    return quantity < 0 ? NULL : fw_series_fill(trajectory->frames, quantity);
}

static void write_vectors(fw_trajectory *trajectory, const fw_frame_body *bodies)
{
    frame_rows rows = {.position = fill(trajectory, trajectory->position),
                       .velocity = fill(trajectory, trajectory->velocity),
                       .force = fill(trajectory, trajectory->force),
                       .past_cache = trajectory->particle_count > MANY};
    for (int body = 0; body < trajectory->body_count; ++body) {
        const int count = trajectory->counts[body];
        write_body(&bodies[body], count, &rows);
        rows.position = behind(rows.position, count);
        rows.velocity = behind(rows.velocity, count);
        rows.force = behind(rows.force, count);
    }
}

fw_status fw_trajectory_write_frame(fw_trajectory *trajectory, int64_t step, double time,
                                    const fw_frame_body *bodies, fw_error *error)
{
    write_vectors(trajectory, bodies);
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
