/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_layout.c - what a results file says besides its rows. Keeps no state; start reading at
 * fw_layout_make(), in the order of the H5MD 1.1 specification. */
#include "trajectory_layout.h"

#include "experiments/results/provenance.h"
#include "experiments/results/unit_attribute.h"
#include "experiments/storage/series.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SEAL        "parameters/seal"
#define EXIT_STATUS "parameters/provenance/exit_status"

#define UNITS "reduced: lattice spacing, particle mass and time unit of the material"

/* Elements that H5MD or this program give a meaning of their own. */
static const char *const taken[] = {"box",     "position", "velocity", "force",  "mass", "image",
                                    "species", "id",       "body",     "charge", NULL};

static fw_status check_name(const char *kind, const char *name, fw_error *error)
{
    size_t length = strlen(name);
    if (length == 0 || length >= FW_NAME_SIZE || strchr(name, '/') || strcmp(name, ".") == 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "the %s '%.200s' needs a name of 1 to %d bytes without slashes", kind, name,
                       FW_NAME_SIZE - 1);
    return FW_OK;
}

fw_status fw_layout_check(const fw_trajectory_def *def, fw_error *error)
{
    double particles = 0;
    for (int i = 0; i < def->body_count; ++i) {
        FW_TRY(check_name("body", def->bodies[i].name, error));
        particles += def->bodies[i].count;
    }
    /* HDF5 keeps the size of a chunk in 32 bits, and a frame of vectors is one chunk. */
    if (particles < 1 || particles > 4294967295.0 / 24)
        return fw_fail(error, FW_BAD_INPUT, "results hold 1 to %.0f particles, not %.0f",
                       4294967295.0 / 24, particles);
    for (int i = 0; i < def->field_count; ++i) {
        const char *name = def->fields[i].name;
        FW_TRY(check_name("field", name, error));
        for (int j = 0; taken[j]; ++j)
            if (strcmp(taken[j], name) == 0)
                return fw_fail(error, FW_BAD_INPUT, "a field cannot be named '%s'", name);
        for (int j = 0; j < i; ++j)
            if (strcmp(def->fields[j].name, name) == 0)
                return fw_fail(error, FW_BAD_INPUT, "there are two fields named '%s'", name);
    }
    for (int g = 0; g < def->group_count; ++g)
        FW_TRY(check_name("analysis", def->groups[g].name, error));
    for (int i = 0; i < def->observable_count; ++i) {
        const char *name = def->observables[i].name;
        FW_TRY(check_name("observable", name, error));
        if (def->observables[i].components < 1)
            return fw_fail(error, FW_BAD_INPUT, "the observable '%s' has no components", name);
        for (int j = 0; j < i; ++j)
            if (strcmp(def->observables[j].name, name) == 0)
                return fw_fail(error, FW_BAD_INPUT, "there are two observables named '%s'", name);
    }
    if (def->frame_count < 0 || def->sample_count < 0)
        return fw_fail(error, FW_BAD_INPUT, "results hold no negative number of frames");
    return FW_OK;
}

size_t fw_layout_structure(const fw_trajectory_def *def)
{
    size_t elements = (size_t)(1 + def->velocity + def->force + def->field_count);
    size_t objects = 64 + elements + 2 * (size_t)def->observable_count + (size_t)def->array_count;
    for (int g = 0; g < def->group_count; ++g) objects += 1 + (size_t)def->groups[g].table_count;
    size_t bodies = (size_t)def->body_count * FW_NAME_SIZE;
    size_t chunks = elements * (size_t)def->frame_count;
    for (int i = 0; i < def->observable_count; ++i) {
        const size_t rows = fw_series_chunk((size_t)def->observables[i].components);
        chunks += (size_t)(def->sample_count + def->frame_count) / rows + 2;
    }
    /* HDF5's tree of chunk addresses takes about 60 bytes for each, its nodes being nearly full. */
    return 32768 + 4096 * objects + bodies + 64 * chunks;
}

static void make_metadata(fw_hdf5 *file, const fw_trajectory_def *def, const fw_provenance *now)
{
    char person[FW_PROVENANCE_SIZE];
    const int version[] = {1, 1};
    fw_provenance_author(person, sizeof person);
    fw_hdf5_make_group(file, "h5md");
    fw_hdf5_attach_integers(file, "h5md", "version", version, 2);
    fw_hdf5_make_group(file, "h5md/author");
    fw_hdf5_attach_text(file, "h5md/author", "name", def->author ? def->author : person);
    fw_hdf5_make_group(file, "h5md/creator");
    fw_hdf5_attach_text(file, "h5md/creator", "name", now->program);
    fw_hdf5_attach_text(file, "h5md/creator", "version", now->version);
}

/* An array over all particles, made of one value per body or per particle. */
static void make_identities(fw_hdf5 *file, const fw_trajectory_def *def, uint64_t count)
{
    int32_t *numbers = fw_array_allocate(count, sizeof *numbers);
    if (!numbers) {
        fw_hdf5_give_up(file, "the numbers of the particles");
        return;
    }
    int32_t *next = numbers;
    for (int body = 0; body < def->body_count; ++body)
        for (int i = 0; i < def->bodies[body].count; ++i) *next++ = body;
    /* The first data of the file: what lies in front of it is structure, see fw_layout_head. */
    fw_dataset species =
        fw_hdf5_make_array(file, "particles/trajectory/species", FW_I32, 1, &count);
    fw_hdf5_write(file, species, FW_I32, 0, count, numbers);
    /* One species per body: both elements are the same dataset. */
    fw_hdf5_link(file, "particles/trajectory/species", "particles/trajectory/body");
    for (uint64_t i = 0; i < count; ++i) numbers[i] = (int32_t)i;
    fw_dataset id = fw_hdf5_make_array(file, "particles/trajectory/id", FW_I32, 1, &count);
    fw_hdf5_write(file, id, FW_I32, 0, count, numbers);
    free(numbers);
}

static void make_masses(fw_hdf5 *file, const fw_trajectory_def *def, uint64_t count)
{
    bool known = true;
    for (int body = 0; body < def->body_count; ++body) known = known && def->bodies[body].mass;
    if (!known) return;
    double *masses = fw_array_of_doubles(count);
    if (!masses) {
        fw_hdf5_give_up(file, "the masses of the particles");
        return;
    }
    double *next = masses;
    for (int body = 0; body < def->body_count; ++body)
        for (int i = 0; i < def->bodies[body].count; ++i) *next++ = def->bodies[body].mass[i];
    fw_dataset mass = fw_hdf5_make_array(file, "particles/trajectory/mass", FW_F64, 1, &count);
    fw_hdf5_write(file, mass, FW_F64, 0, count, masses);
    fw_unit_attach(file, def->units, "particles/trajectory/mass", "mass");
    free(masses);
}

static void make_particles(fw_hdf5 *file, const fw_trajectory_def *def)
{
    const int dimension = 3;
    const char *const boundary[] = {"none", "none", "none"};
    uint64_t count = 0;
    for (int body = 0; body < def->body_count; ++body) count += (uint64_t)def->bodies[body].count;
    fw_hdf5_make_group(file, "particles");
    fw_hdf5_make_group(file, "particles/trajectory");
    fw_hdf5_attach_text(file, "particles/trajectory", "units", UNITS);
    fw_hdf5_make_group(file, "particles/trajectory/box");
    fw_hdf5_attach_integers(file, "particles/trajectory/box", "dimension", &dimension, 0);
    fw_hdf5_attach_texts(file, "particles/trajectory/box", "boundary", boundary, 3);
    make_identities(file, def, count);
    make_masses(file, def, count);
    const char **names = calloc((size_t)def->body_count, sizeof *names);
    if (!names) {
        fw_hdf5_give_up(file, "the names of the bodies");
        return;
    }
    for (int body = 0; body < def->body_count; ++body) names[body] = def->bodies[body].name;
    fw_hdf5_attach_texts(file, "particles/trajectory/species", "bodies", names, def->body_count);
    free(names);
}

/* Pairs of ids, as H5MD's tuples. */
static void make_links(fw_hdf5 *file, const fw_trajectory_def *def)
{
    uint64_t extent[] = {0, 2};
    for (int body = 0; body < def->body_count; ++body)
        extent[0] += (uint64_t)def->bodies[body].link_count;
    if (extent[0] == 0) return;
    int32_t *pairs = fw_array_allocate(2 * extent[0], sizeof *pairs), *next = pairs;
    if (!pairs) {
        fw_hdf5_give_up(file, "the links");
        return;
    }
    int32_t first = 0;
    for (int body = 0; body < def->body_count; ++body) {
        for (int i = 0; i < def->bodies[body].link_count; ++i)
            for (int end = 0; end < 2; ++end) *next++ = first + def->bodies[body].links[i][end];
        first += def->bodies[body].count;
    }
    fw_hdf5_make_group(file, "connectivity");
    fw_dataset links = fw_hdf5_make_array(file, "connectivity/links", FW_I32, 2, extent);
    fw_hdf5_write(file, links, FW_I32, 0, extent[0], pairs);
    fw_hdf5_attach_reference(file, "connectivity/links", "particles_group", "particles/trajectory");
    free(pairs);
}

static void make_text(fw_hdf5 *file, const char *path, size_t capacity, const char *text)
{
    fw_hdf5_write_text(file, fw_hdf5_make_text(file, path, capacity), text);
}

static void make_parameters(fw_hdf5 *file, const fw_trajectory_def *def, const fw_provenance *now)
{
    const struct {
        const char *path, *text;
    } facts[] = {
        {"parameters/provenance/program", now->program},
        {"parameters/provenance/version", now->version},
        {"parameters/provenance/revision", now->revision},
        {"parameters/provenance/compiler", now->compiler},
        {"parameters/provenance/flags", now->flags},
        {"parameters/provenance/instructions", now->instructions},
        {"parameters/provenance/libraries", now->libraries},
        {"parameters/provenance/host", now->host},
        {"parameters/provenance/start", now->start},
    };
    fw_hdf5_make_group(file, "parameters");
    fw_hdf5_attach_text(file, "parameters", "units", UNITS);
    make_text(file, "parameters/title", strlen(def->title), def->title);
    make_text(file, "parameters/scenario", strlen(def->scenario), def->scenario);
    const int64_t seed = (int64_t)def->seed;
    fw_hdf5_write(file, fw_hdf5_make_array(file, "parameters/seed", FW_I64, 0, NULL), FW_I64, 0, 1,
                  &seed);
    fw_hdf5_make_group(file, "parameters/provenance");
    for (size_t i = 0; i < sizeof facts / sizeof *facts; ++i)
        make_text(file, facts[i].path, strlen(facts[i].text), facts[i].text);
    if (*def->forms) make_text(file, "parameters/provenance/forms", strlen(def->forms), def->forms);
    const int64_t threads = def->threads;
    fw_hdf5_write(file, fw_hdf5_make_array(file, "parameters/provenance/threads", FW_I64, 0, NULL),
                  FW_I64, 0, 1, &threads);
}

/* What follows changes; so the seal, which lies in front of it, need not. */
static void make_notes(fw_hdf5 *file)
{
    const int64_t zero = 0;
    fw_hdf5_write(file, fw_hdf5_make_array(file, SEAL, FW_I64, 0, NULL), FW_I64, 0, 1, &zero);
    fw_hdf5_write(file, fw_hdf5_make_array(file, "parameters/provenance/resumed", FW_I64, 0, NULL),
                  FW_I64, 0, 1, &zero);
    make_text(file, "parameters/provenance/end", FW_PROVENANCE_SIZE, "");
    make_text(file, "parameters/provenance/exit_reason", FW_EXIT_REASON_SIZE, FW_RUN_RUNNING);
    fw_hdf5_write(file, fw_hdf5_make_array(file, EXIT_STATUS, FW_I64, 0, NULL), FW_I64, 0, 1,
                  &zero);
    make_text(file, "parameters/warnings", FW_WARNINGS_SIZE, "");
}

void fw_layout_make(fw_hdf5 *file, const fw_trajectory_def *def)
{
    fw_provenance now = fw_provenance_now();
    make_metadata(file, def, &now);
    make_particles(file, def);
    make_links(file, def);
    fw_hdf5_make_group(file, "observables");
    make_parameters(file, def, &now);
    fw_hdf5_make_group(file, "parameters/series");
    fw_layout_make_tables(file, def);
    make_notes(file);
    fw_layout_make_arrays(file, def);
}

void fw_layout_describe(fw_hdf5 *file, const fw_trajectory_def *def)
{
    char path[FW_NAME_SIZE + 64], physical[FW_PHYSICAL_TEXT];
    fw_unit_attach(file, def->units, "particles/trajectory/position", "length");
    if (def->units && fw_units_given(def->units)) {
        fw_units_print(physical, def->units, "time", 10);
        fw_hdf5_attach_text(file, "observables", "time", physical);
    }
    if (def->velocity)
        fw_unit_attach(file, def->units, "particles/trajectory/velocity", "length/time");
    if (def->force) fw_unit_attach(file, def->units, "particles/trajectory/force", "force");
    for (int i = 0; i < def->field_count; ++i) {
        snprintf(path, sizeof path, "particles/trajectory/%s", def->fields[i].name);
        fw_hdf5_attach_text(file, path, "meaning", def->fields[i].meaning);
        fw_unit_attach(file, def->units, path, def->fields[i].unit);
    }
    for (int i = 0; i < def->observable_count; ++i) {
        for (int all = 0; all < 2; ++all) {
            const char *group = all ? "parameters/series" : "observables";
            snprintf(path, sizeof path, "%s/%s", group, def->observables[i].name);
            fw_hdf5_attach_text(file, path, "meaning", def->observables[i].meaning);
            snprintf(path, sizeof path, "%s/%s/value", group, def->observables[i].name);
            fw_unit_attach(file, def->units, path, def->observables[i].unit);
        }
    }
}

void fw_layout_note(fw_hdf5 *file, const char *name, const char *text)
{
    char path[FW_NAME_SIZE + 64];
    snprintf(path, sizeof path, "parameters/provenance/%s", name);
    fw_hdf5_write_text(file, fw_hdf5_find(file, path), text);
}

static fw_status compare_bodies(fw_hdf5 *file, const fw_trajectory_def *def, const int32_t *species,
                                const char *names, fw_error *error)
{
    int32_t particle = 0;
    for (int body = 0; body < def->body_count; ++body) {
        const char *name = names + (size_t)body * FW_NAME_SIZE;
        if (strcmp(name, def->bodies[body].name) != 0)
            return fw_fail(error, FW_BAD_INPUT, "the results hold a body '%s' in place of '%s'",
                           name, def->bodies[body].name);
        for (int i = 0; i < def->bodies[body].count; ++i)
            if (species[particle++] != body)
                return fw_fail(error, FW_BAD_INPUT,
                               "the body '%s' has not as many particles in the results as now",
                               name);
    }
    return fw_hdf5_check(file, error);
}

fw_status fw_layout_compare(fw_hdf5 *file, const fw_trajectory_def *def, fw_error *error)
{
    uint64_t count = 0;
    for (int body = 0; body < def->body_count; ++body) count += (uint64_t)def->bodies[body].count;
    char *reason = fw_hdf5_read_text(file, fw_hdf5_find(file, "parameters/provenance/exit_reason"));
    bool finished = reason && strcmp(reason, FW_RUN_FINISHED) == 0;
    free(reason);
    if (!reason) fw_hdf5_refuse(file, "parameters/provenance/exit_reason");
    FW_TRY(fw_hdf5_check(file, error));
    if (finished) return fw_fail(error, FW_BAD_INPUT, "the run in %s is finished", def->directory);
    fw_shape shape;
    fw_dataset species = fw_hdf5_find(file, "particles/trajectory/species");
    FW_TRY(fw_hdf5_check(file, error));
    if (!fw_hdf5_shape(file, species, &shape) || shape.element != FW_I32 || shape.rank != 1 ||
        shape.extent[0] != count)
        return fw_fail(error, FW_BAD_INPUT, "the results in %s are not of %llu particles",
                       def->directory, (unsigned long long)count);
    int32_t *numbers = fw_array_allocate(count, sizeof *numbers);
    char *names = calloc((size_t)def->body_count + 1, FW_NAME_SIZE);
    fw_status status = FW_OK;
    if (numbers && names) {
        fw_hdf5_read(file, species, FW_I32, 0, count, numbers);
        fw_hdf5_read_attributes(file, "particles/trajectory/species", "bodies", names, FW_NAME_SIZE,
                                def->body_count);
        status = fw_hdf5_check(file, error);
        if (status == FW_OK) status = compare_bodies(file, def, numbers, names, error);
    } else {
        status = fw_fail_memory(error, "the bodies of the results");
    }
    free(numbers);
    free(names);
    return status;
}

void fw_layout_reopen(fw_hdf5 *file)
{
    int64_t resumed = 0;
    fw_dataset counter = fw_hdf5_find(file, "parameters/provenance/resumed");
    fw_hdf5_read(file, counter, FW_I64, 0, 1, &resumed);
    resumed += 1;
    fw_hdf5_write(file, counter, FW_I64, 0, 1, &resumed);
    fw_layout_note_status(file, FW_OK);
    fw_layout_note(file, "end", "");
    fw_layout_note(file, "exit_reason", FW_RUN_RUNNING);
}

void fw_layout_note_status(fw_hdf5 *file, fw_status status)
{
    const int64_t number = status;
    fw_hdf5_write(file, fw_hdf5_find(file, EXIT_STATUS), FW_I64, 0, 1, &number);
}

void fw_layout_warn(fw_hdf5 *file, const char *warnings)
{
    fw_hdf5_write_text(file, fw_hdf5_find(file, "parameters/warnings"), warnings);
}

uint64_t fw_layout_seal_place(fw_hdf5 *file)
{
    return fw_hdf5_address(file, fw_hdf5_find(file, SEAL));
}

void fw_layout_seal(fw_hdf5 *file)
{
    const uint64_t sum = fw_hdf5_checksum(file, fw_layout_seal_place(file));
    fw_hdf5_write(file, fw_hdf5_find(file, SEAL), FW_I64, 0, 1, &sum);
}

fw_status fw_layout_check_seal(fw_hdf5 *file, fw_error *error)
{
    uint64_t sum = 0;
    fw_shape shape;
    const fw_dataset seal = fw_hdf5_find(file, SEAL);
    FW_TRY(fw_hdf5_check(file, error));
    if (seal < 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s has no seal: it is foreign, or of a version of this program that did "
                       "not seal its results yet, and cannot be read; run its scenario again",
                       fw_hdf5_path(file));
    if (!fw_hdf5_shape(file, seal, &shape) || shape.text || shape.rank != 0 ||
        shape.element != FW_I64)
        fw_hdf5_refuse(file, SEAL);
    fw_hdf5_read(file, seal, FW_I64, 0, 1, &sum);
    const bool whole = sum == fw_hdf5_checksum(file, fw_layout_seal_place(file));
    FW_TRY(fw_hdf5_check(file, error));
    if (whole) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s is damaged: the checksum of its structure does not match",
                   fw_hdf5_path(file));
}

uint64_t fw_layout_head(fw_hdf5 *file)
{
    return fw_hdf5_address(file, fw_hdf5_find(file, "particles/trajectory/species"));
}
