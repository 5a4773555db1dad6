/* SPDX-License-Identifier: GPL-3.0-or-later */
/* playback.c - reading a results file.
 * State: the open file and everything in it that does not grow with frames. Invariant: extents and
 * types of all elements were checked against the number of particles when the file was opened, and
 * no memory is allocated on the word of the file alone. Start reading at fw_playback_open();
 * playback_frames.c reads the rest. */
#include "experiments/storage/folder.h"
#include "playback_parts.h"
#include "trajectory_head.h"
#include "trajectory_layout.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define FW_PARTICLES "particles/trajectory"

enum { MAX_MEMBERS = 1024 };

static bool has_element(fw_playback *playback, const char *name, int rank)
{
    char path[FW_NAME_SIZE + 64];
    uint64_t extent[] = {(uint64_t)playback->particle_count, 3};
    snprintf(path, sizeof path, FW_PARTICLES "/%s/value", name);
    return fw_playback_find_rows(playback, path, FW_F64, playback->frame_count, rank, extent) >= 0;
}

static int64_t read_integer(fw_playback *playback, const char *path)
{
    fw_shape shape;
    int64_t value = 0;
    fw_hdf5 *hdf5 = playback->file->hdf5;
    fw_dataset dataset = fw_hdf5_find(hdf5, path);
    if (fw_hdf5_shape(hdf5, dataset, &shape) && !shape.text && shape.rank == 0)
        fw_hdf5_read(hdf5, dataset, FW_I64, 0, 1, &value);
    else
        fw_hdf5_refuse(hdf5, path);
    return value;
}

static char *read_text(fw_playback *playback, const char *path)
{
    char *text = fw_hdf5_read_text(playback->file->hdf5, fw_hdf5_find(playback->file->hdf5, path));
    if (!text) fw_hdf5_refuse(playback->file->hdf5, path);
    return text;
}

/* Names, units and meanings go into sentences, tables and pictures: none with control characters,
 * which a terminal would obey. In UTF-8 those above 127 begin with 0xC2. */
static bool is_plain(const char *name)
{
    for (const unsigned char *c = (const unsigned char *)name; *c; ++c)
        if (*c < 0x20 || *c == 0x7f || (c[0] == 0xc2 && c[1] >= 0x80 && c[1] < 0xa0)) return false;
    return true;
}

/* How many particles there are, and which belong to which body: `species` counts bodies from 0 and
 * never goes down. */
static fw_status read_bodies(fw_playback *playback, fw_error *error)
{
    fw_hdf5 *hdf5 = playback->file->hdf5;
    fw_shape shape;
    fw_dataset dataset = fw_hdf5_find(hdf5, FW_PARTICLES "/species");
    if (!fw_hdf5_shape(hdf5, dataset, &shape) || shape.text || shape.rank != 1 ||
        shape.element != FW_I32 || shape.extent[0] < 1 || shape.extent[0] > INT_MAX / 3 ||
        !fw_hdf5_is_stored(hdf5, dataset))
        return fw_playback_refuse(playback, FW_PARTICLES "/species", error);
    playback->particle_count = (int)shape.extent[0];
    int32_t *species = fw_array_allocate(shape.extent[0], sizeof *species);
    if (!species) return fw_fail_memory(error, "the species of the particles");
    fw_hdf5_read(hdf5, dataset, FW_I32, 0, shape.extent[0], species);
    bool sound = true;
    /* No overflow: particles are fewer than INT_MAX / 3, and a count beyond them is refused. */
    int32_t last = species[playback->particle_count - 1];
    int bodies = last >= 0 && last < playback->particle_count ? last + 1 : 0;
    int32_t before = 0;
    for (int i = 0; i < playback->particle_count; before = species[i++])
        sound = sound && species[i] >= before;
    sound = sound && bodies >= 1;
    if (sound) {
        playback->bodies = calloc((size_t)bodies, sizeof *playback->bodies);
        char *names = calloc((size_t)bodies, FW_NAME_SIZE);
        if (playback->bodies && names) {
            playback->body_count = bodies;
            for (int i = 0; i < playback->particle_count; ++i)
                playback->bodies[species[i]].count += 1;
            sound = fw_hdf5_read_attributes(hdf5, FW_PARTICLES "/species", "bodies", names,
                                            FW_NAME_SIZE, bodies);
            for (int i = 0, first = 0; i < bodies; first += playback->bodies[i++].count) {
                playback->bodies[i].first = first;
                memcpy(playback->bodies[i].name, names + (size_t)i * FW_NAME_SIZE, FW_NAME_SIZE);
                sound = sound && is_plain(playback->bodies[i].name);
            }
        } else {
            fw_hdf5_give_up(hdf5, "the bodies");
        }
        free(names);
    }
    free(species);
    if (!sound) return fw_playback_refuse(playback, FW_PARTICLES "/species", error);
    return fw_hdf5_check(hdf5, error);
}

static fw_status read_links(fw_playback *playback, fw_error *error)
{
    fw_hdf5 *hdf5 = playback->file->hdf5;
    fw_shape shape;
    fw_dataset dataset = fw_hdf5_find(hdf5, "connectivity/links");
    if (dataset < 0) return FW_OK;
    if (!fw_hdf5_shape(hdf5, dataset, &shape) || shape.text || shape.element != FW_I32 ||
        shape.rank != 2 || shape.extent[0] > INT_MAX / 2 || shape.extent[1] != 2 ||
        !fw_hdf5_is_stored(hdf5, dataset))
        return fw_playback_refuse(playback, "connectivity/links", error);
    int(*links)[2] = fw_array_allocate(shape.extent[0], sizeof *links);
    playback->file->links = links;
    if (!links) return fw_fail_memory(error, "the links");
    playback->links = (const int(*)[2])links;
    playback->link_count = (int)shape.extent[0];
    fw_hdf5_read(hdf5, dataset, FW_I32, 0, shape.extent[0], links);
    for (int i = 0; i < playback->link_count; ++i)
        for (int end = 0; end < 2; ++end)
            if (links[i][end] < 0 || links[i][end] >= playback->particle_count)
                return fw_playback_refuse(playback, "connectivity/links", error);
    return fw_hdf5_check(hdf5, error);
}

/* Names of the members of a group, to be freed; NULL without memory. */
static char (*list_members(fw_playback *playback, const char *path, int *count))[FW_NAME_SIZE]
{
    char(*names)[FW_NAME_SIZE] = calloc(MAX_MEMBERS, sizeof *names);
    *count = 0;
    if (!names) return NULL;
    *count = fw_hdf5_list(playback->file->hdf5, path, names[0], FW_NAME_SIZE, MAX_MEMBERS);
    if (*count < 0) fw_hdf5_refuse(playback->file->hdf5, path);
    *count = *count < 0 ? 0 : *count > MAX_MEMBERS ? MAX_MEMBERS : *count;
    return names;
}

/* Every element with one number per particle is a field. */
static fw_status read_fields(fw_playback *playback, fw_error *error)
{
    int count;
    char(*names)[FW_NAME_SIZE] = list_members(playback, FW_PARTICLES, &count);
    playback->fields = calloc((size_t)count + 1, sizeof *playback->fields);
    if (!names || !playback->fields) {
        free(names);
        return fw_fail_memory(error, "the names of the fields");
    }
    for (int i = 0; i < count; ++i) {
        if (!is_plain(names[i]) || !has_element(playback, names[i], 1)) continue;
        char path[FW_NAME_SIZE + 64];
        fw_playback_field *field = &playback->fields[playback->field_count++];
        memcpy(field->name, names[i], FW_NAME_SIZE);
        snprintf(path, sizeof path, FW_PARTICLES "/%s", names[i]);
        fw_hdf5_read_attribute(playback->file->hdf5, path, "meaning", field->meaning,
                               sizeof field->meaning);
        fw_hdf5_read_attribute(playback->file->hdf5, path, "unit", field->unit, sizeof field->unit);
        fw_hdf5_read_attribute(playback->file->hdf5, path, "physical", field->physical,
                               sizeof field->physical);
        if (!is_plain(field->meaning) || !is_plain(field->unit) || !is_plain(field->physical))
            fw_hdf5_refuse(playback->file->hdf5, path);
    }
    free(names);
    return fw_hdf5_check(playback->file->hdf5, error);
}

static fw_status read_observables(fw_playback *playback, fw_error *error)
{
    fw_hdf5 *hdf5 = playback->file->hdf5;
    int count;
    char(*names)[FW_NAME_SIZE] = list_members(playback, FW_SERIES, &count);
    playback->observables = calloc((size_t)count + 1, sizeof *playback->observables);
    if (!names || !playback->observables) {
        free(names);
        return fw_fail_memory(error, "the names of the observables");
    }
    for (int i = 0; i < count; ++i) {
        char path[FW_NAME_SIZE + 64];
        fw_shape shape;
        fw_playback_observable *added = &playback->observables[playback->observable_count++];
        memcpy(added->name, names[i], FW_NAME_SIZE);
        snprintf(path, sizeof path, FW_SERIES "/%s", names[i]);
        fw_hdf5_read_attribute(hdf5, path, "meaning", added->meaning, sizeof added->meaning);
        snprintf(path, sizeof path, FW_SERIES "/%s/value", names[i]);
        fw_hdf5_read_attribute(hdf5, path, "unit", added->unit, sizeof added->unit);
        fw_hdf5_read_attribute(hdf5, path, "physical", added->physical, sizeof added->physical);
        if (!fw_hdf5_shape(hdf5, fw_hdf5_find(hdf5, path), &shape) || shape.text ||
            shape.element != FW_F64 || (shape.rank != 1 && shape.rank != 2) ||
            shape.extent[0] < (uint64_t)playback->sample_count ||
            (shape.rank == 2 && (shape.extent[1] < 1 || shape.extent[1] > INT_MAX)) ||
            !is_plain(names[i]) || !is_plain(added->unit) || !is_plain(added->physical) ||
            !is_plain(added->meaning))
            fw_hdf5_refuse(hdf5, is_plain(names[i]) ? path : FW_SERIES);
        else
            added->components = shape.rank == 2 ? (int)shape.extent[1] : 1;
    }
    free(names);
    return fw_hdf5_check(hdf5, error);
}

static fw_status read_head(fw_playback *playback, fw_error *error)
{
    fw_hdf5 *hdf5 = playback->file->hdf5;
    char creator[64];
    if (!fw_hdf5_read_attribute(hdf5, "h5md/creator", "name", creator, sizeof creator) ||
        strcmp(creator, "fretwork") != 0)
        return fw_playback_refuse(playback, "h5md/creator", error);
    FW_TRY(fw_layout_check_seal(hdf5, error));
    playback->frame_count = read_integer(playback, "parameters/frames_committed");
    playback->sample_count = read_integer(playback, "parameters/samples_committed");
    playback->seed = (uint64_t)read_integer(playback, "parameters/seed");
    playback->exit_status = read_integer(playback, "parameters/provenance/exit_status");
    playback->title = read_text(playback, "parameters/title");
    playback->scenario = read_text(playback, "parameters/scenario");
    playback->exit_reason = read_text(playback, "parameters/provenance/exit_reason");
    playback->revision = read_text(playback, "parameters/provenance/revision");
    playback->start = read_text(playback, "parameters/provenance/start");
    playback->end = read_text(playback, "parameters/provenance/end");
    playback->warnings = read_text(playback, "parameters/warnings");
    FW_TRY(fw_hdf5_check(hdf5, error));
    FW_TRY(read_bodies(playback, error));
    if (!has_element(playback, "position", 2))
        return fw_playback_refuse(playback, FW_PARTICLES "/position", error);
    uint64_t count = (uint64_t)playback->particle_count;
    fw_hdf5_read_attribute(playback->file->hdf5, "observables", "time", playback->time_physical,
                           sizeof playback->time_physical);
    if (!is_plain(playback->time_physical)) fw_hdf5_refuse(playback->file->hdf5, "observables");
    playback->velocity = has_element(playback, "velocity", 2);
    playback->force = has_element(playback, "force", 2);
    playback->mass = fw_playback_find_rows(playback, FW_PARTICLES "/mass", FW_F64,
                                           playback->particle_count, 0, NULL) >= 0;
    FW_TRY(read_links(playback, error));
    FW_TRY(read_fields(playback, error));
    FW_TRY(read_observables(playback, error));
    playback->file->vectors = fw_array_of_doubles(3 * count);
    return playback->file->vectors ? FW_OK : fw_fail_memory(error, "a frame of results");
}

/* A file that is being cut may be in any state. */
static fw_status check_torn(const char *directory, fw_error *error)
{
    fw_folder *folder;
    FW_TRY(fw_folder_visit(&folder, directory, error));
    bool torn = fw_head_is_torn(folder);
    fw_folder_close(folder);
    if (!torn) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s/" FW_TRAJECTORY_FILE
                   " is being closed, or its run was killed while it closed "
                   "it; then resume puts it right",
                   directory);
}

fw_status fw_playback_open(fw_playback **playback, const char *path, fw_error *error)
{
    char file[FW_PATH_SIZE];
    struct stat kind;
    bool folder = stat(path, &kind) == 0 && S_ISDIR(kind.st_mode);
    *playback = NULL;
    if (folder) {
        FW_TRY(fw_path_join(file, path, FW_TRAJECTORY_FILE, error));
        FW_TRY(check_torn(path, error));
    }
    const char *const name = folder ? file : path;
    fw_playback *opened = calloc(1, sizeof *opened);
    if (opened) opened->file = calloc(1, sizeof *opened->file);
    if (!opened || !opened->file) {
        free(opened);
        return fw_fail_memory(error, name);
    }
    fw_status status = fw_hdf5_open(&opened->file->hdf5, name, false, error);
    if (status == FW_OK) status = read_head(opened, error);
    if (status != FW_OK) {
        fw_playback_close(opened);
        return status;
    }
    *playback = opened;
    return FW_OK;
}

fw_status fw_playback_check(const fw_playback *playback, fw_error *error)
{
    return fw_hdf5_check(playback->file->hdf5, error);
}

char *fw_playback_fact(fw_playback *playback, const char *name)
{
    char path[FW_NAME_SIZE + 64];
    snprintf(path, sizeof path, "parameters/provenance/%s", name);
    const fw_dataset dataset = fw_hdf5_find(playback->file->hdf5, path);
    return dataset < 0 ? NULL : fw_hdf5_read_text(playback->file->hdf5, dataset);
}

void fw_playback_close(fw_playback *playback)
{
    if (!playback) return;
    fw_error ignored;
    fw_hdf5_close(playback->file->hdf5, &ignored);
    free(playback->file->vectors);
    free(playback->file->links);
    free(playback->file);
    free(playback->bodies);
    free(playback->fields);
    free(playback->observables);
    free(playback->title);
    free(playback->scenario);
    free(playback->exit_reason);
    free(playback->revision);
    free(playback->start);
    free(playback->end);
    free(playback->warnings);
    free(playback);
}
