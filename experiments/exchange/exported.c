/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exported.c - frames of a results file, read one after the other into the same arrays. Start
 * reading at fw_exported_read(). */
#include "exported.h"

#include "core/array.h"
#include "experiments/storage/whole_file.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static bool add_vector(fw_exported *e, const char *name)
{
    const size_t count = (size_t)e->playback->particle_count;
    fw_exported_vector *vector = &e->vectors[e->vector_count++];
    *vector = (fw_exported_vector){name, fw_array_of_doubles(count), fw_array_of_doubles(count)};
    return vector->x && vector->y;
}

static bool allocate(fw_exported *e)
{
    const fw_playback *playback = e->playback;
    const size_t count = (size_t)playback->particle_count;
    const size_t frames = (size_t)playback->frame_count;
    bool complete = add_vector(e, "position");
    if (playback->velocity) complete = add_vector(e, "velocity") && complete;
    if (playback->force) complete = add_vector(e, "force") && complete;
    e->steps = fw_array_allocate(frames, sizeof *e->steps);
    e->times = fw_array_of_doubles(frames);
    e->body = fw_array_allocate(count, sizeof *e->body);
    e->mass = fw_array_of_doubles(count);
    e->fields = calloc((size_t)playback->field_count + 1, sizeof *e->fields);
    if (!complete || !e->steps || !e->times || !e->body || !e->mass || !e->fields) return false;
    for (int f = 0; f < playback->field_count; ++f) {
        e->fields[f] = fw_array_of_doubles(count);
        if (!e->fields[f]) return false;
    }
    return true;
}

fw_status fw_exported_open(fw_exported *e, const char *path, int64_t every, fw_error *error)
{
    assert(every >= 1);
    *e = (fw_exported){.path = path, .every = every};
    FW_TRY(fw_playback_open(&e->playback, path, error));
    if (!allocate(e)) return fw_fail_memory(error, "a frame");
    for (int b = 0; b < e->playback->body_count; ++b)
        for (int n = 0; n < e->playback->bodies[b].count; ++n)
            e->body[e->playback->bodies[b].first + n] = b;
    if (e->playback->mass) FW_TRY(fw_playback_read_masses(e->playback, e->mass, error));
    return fw_playback_read_frame_times(e->playback, e->steps, e->times, error);
}

void fw_exported_close(fw_exported *e)
{
    for (int v = 0; v < e->vector_count; ++v) {
        free(e->vectors[v].x);
        free(e->vectors[v].y);
    }
    for (int f = 0; e->fields && f < e->playback->field_count; ++f) free(e->fields[f]);
    free(e->fields);
    free(e->steps);
    free(e->times);
    free(e->body);
    free(e->mass);
    fw_playback_close(e->playback);
    *e = (fw_exported){0};
}

int64_t fw_exported_count(const fw_exported *e)
{
    return (e->playback->frame_count + e->every - 1) / e->every;
}

fw_status fw_exported_read(fw_exported *e, int64_t frame, fw_error *error)
{
    fw_playback *playback = e->playback;
    for (int v = 0; v < e->vector_count; ++v) {
        fw_exported_vector *vector = &e->vectors[v];
        FW_TRY((strcmp(vector->name, "position") == 0 ? fw_playback_read_positions
                : strcmp(vector->name, "velocity") == 0
                    ? fw_playback_read_velocities
                    : fw_playback_read_forces)(playback, frame, vector->x, vector->y, error));
    }
    for (int f = 0; f < playback->field_count; ++f)
        FW_TRY(
            fw_playback_read_field(playback, frame, playback->fields[f].name, e->fields[f], error));
    return FW_OK;
}

/* Frames from `first` on. */
static fw_status write_from(fw_exported *e, const char *name, int64_t first,
                            void (*head)(FILE *out, const fw_exported *e),
                            void (*frame)(FILE *out, const fw_exported *e, int64_t number),
                            fw_error *error)
{
    fw_whole_file *file;
    fw_status status = FW_OK;
    FW_TRY(fw_whole_file_begin(&file, name, error));
    FILE *out = fw_whole_file_stream(file);
    if (head) head(out, e);
    for (int64_t n = first; status == FW_OK && n < e->playback->frame_count; n += e->every) {
        status = fw_exported_read(e, n, error);
        if (status == FW_OK) frame(out, e, n);
    }
    if (status == FW_OK) return fw_whole_file_commit(file, error);
    fw_whole_file_abandon(file);
    return status;
}

fw_status fw_exported_write(fw_exported *e, const char *name,
                            void (*head)(FILE *out, const fw_exported *e),
                            void (*frame)(FILE *out, const fw_exported *e, int64_t number),
                            fw_error *error)
{
    return write_from(e, name, 0, head, frame, error);
}

fw_status fw_exported_write_last(fw_exported *e, const char *name,
                                 void (*frame)(FILE *out, const fw_exported *e, int64_t number),
                                 fw_error *error)
{
    return write_from(e, name, e->playback->frame_count - 1, NULL, frame, error);
}
