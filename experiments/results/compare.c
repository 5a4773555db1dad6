/* SPDX-License-Identifier: GPL-3.0-or-later */
/* compare.c - frame by frame, so that only two frames are held in memory. Keeps no state. Start
 * reading at fw_compare(). */
#include "experiments/results/compare.h"

#include "core/array.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of one thing in both results, and what has been found so far. */
typedef struct pair {
    double *one, *other;
    size_t count;
    int64_t first;  /* row that differs first; -1: none */
    double largest; /* difference */
} pair;

static void look(pair *p, int64_t row)
{
    if (memcmp(p->one, p->other, p->count * sizeof *p->one) == 0) return;
    if (p->first < 0) p->first = row;
    for (size_t n = 0; n < p->count; ++n) {
        const double apart = fabs(p->one[n] - p->other[n]);
        if (apart > p->largest || isnan(apart) > (isnan(p->one[n]) && isnan(p->other[n])))
            p->largest = apart;
    }
}

static int tell(const pair *p, const char *name, const char *row, const int64_t *steps, FILE *out)
{
    if (p->first < 0) return 0;
    fprintf(out, "  %s differs from %s %" PRId64 " (step %" PRId64 ") on, by up to %.2g\n", name,
            row, p->first, steps[p->first], p->largest);
    return 1;
}

static int tell_single(const char *name, FILE *out)
{
    fprintf(out, "  %s is only in one of them\n", name);
    return 1;
}

typedef fw_status (*read_vectors)(fw_playback *playback, int64_t frame, double *x, double *y,
                                  fw_error *error);

static bool has_field(const fw_playback *playback, const char *name)
{
    for (int f = 0; f < playback->field_count; ++f)
        if (strcmp(playback->fields[f].name, name) == 0) return true;
    return false;
}

/* A vector in each particle: `half` numbers of x, then of y. */
static fw_status compare_vectors(fw_playback *one, fw_playback *other, pair *p, read_vectors read,
                                 fw_error *error)
{
    const size_t half = (size_t)one->particle_count;
    p->count = 2 * half;
    p->first = -1;
    p->largest = 0;
    for (int64_t frame = 0; frame < one->frame_count; ++frame) {
        FW_TRY(read(one, frame, p->one, p->one + half, error));
        FW_TRY(read(other, frame, p->other, p->other + half, error));
        look(p, frame);
    }
    return FW_OK;
}

static fw_status compare_field(fw_playback *one, fw_playback *other, pair *p, const char *name,
                               fw_error *error)
{
    p->count = (size_t)one->particle_count;
    p->first = -1;
    p->largest = 0;
    for (int64_t frame = 0; frame < one->frame_count; ++frame) {
        FW_TRY(fw_playback_read_field(one, frame, name, p->one, error));
        FW_TRY(fw_playback_read_field(other, frame, name, p->other, error));
        look(p, frame);
    }
    return FW_OK;
}

static bool allocate(pair *p, size_t count)
{
    p->one = fw_array_of_doubles(count);
    p->other = fw_array_of_doubles(count);
    return p->one && p->other;
}

static void release(pair *p)
{
    free(p->one);
    free(p->other);
}

static fw_status compare_frames(fw_playback *one, fw_playback *other, FILE *out, int *differing,
                                fw_error *error)
{
    pair p;
    int64_t *steps = fw_array_allocate((size_t)one->frame_count + 1, sizeof *steps);
    fw_status status = allocate(&p, 2 * (size_t)one->particle_count) && steps
                           ? fw_playback_read_frame_times(one, steps, NULL, error)
                           : fw_fail_memory(error, "a frame");
    const struct {
        const char *name;
        read_vectors read;
        bool in_one, in_other;
    } vectors[] = {{"position", fw_playback_read_positions, true, true},
                   {"velocity", fw_playback_read_velocities, one->velocity, other->velocity},
                   {"force", fw_playback_read_forces, one->force, other->force}};
    for (int v = 0; v < 3 && status == FW_OK; ++v) {
        if (vectors[v].in_one != vectors[v].in_other)
            *differing += tell_single(vectors[v].name, out);
        if (!vectors[v].in_one || !vectors[v].in_other) continue;
        status = compare_vectors(one, other, &p, vectors[v].read, error);
        if (status == FW_OK) *differing += tell(&p, vectors[v].name, "frame", steps, out);
    }
    for (int f = 0; f < one->field_count && status == FW_OK; ++f) {
        const char *name = one->fields[f].name;
        if (!has_field(other, name)) {
            *differing += tell_single(name, out);
            continue;
        }
        status = compare_field(one, other, &p, name, error);
        if (status == FW_OK) *differing += tell(&p, name, "frame", steps, out);
    }
    release(&p);
    free(steps);
    return status;
}

static fw_status compare_observable(fw_playback *one, fw_playback *other, int observable,
                                    const int64_t *steps, FILE *out, int *differing,
                                    fw_error *error)
{
    const fw_playback_observable *of = &one->observables[observable];
    const int found = fw_playback_find_observable(other, of->name);
    if (found < 0 || other->observables[found].components != of->components) {
        *differing += tell_single(of->name, out);
        return FW_OK;
    }
    const size_t width = (size_t)of->components, rows = (size_t)one->sample_count;
    pair all, row;
    fw_status status = allocate(&all, rows * width + 1)
                           ? fw_playback_read_observable(one, observable, all.one, error)
                           : fw_fail_memory(error, "what was measured");
    if (status == FW_OK) status = fw_playback_read_observable(other, found, all.other, error);
    row = (pair){.count = width, .first = -1};
    for (size_t n = 0; n < rows && status == FW_OK; ++n) {
        row.one = all.one + n * width;
        row.other = all.other + n * width;
        look(&row, (int64_t)n);
    }
    if (status == FW_OK) *differing += tell(&row, of->name, "sample", steps, out);
    release(&all);
    return status;
}

static fw_status compare_samples(fw_playback *one, fw_playback *other, FILE *out, int *differing,
                                 fw_error *error)
{
    if (one->observable_count == 0) return FW_OK;
    int64_t *steps = fw_array_allocate((size_t)one->sample_count + 1, sizeof *steps);
    fw_status status = steps ? fw_playback_read_sample_times(one, steps, NULL, error)
                             : fw_fail_memory(error, "what was measured");
    for (int o = 0; o < one->observable_count && status == FW_OK; ++o)
        status = compare_observable(one, other, o, steps, out, differing, error);
    free(steps);
    return status;
}

static bool counts_differ(const char *what, int64_t one, int64_t other, FILE *out)
{
    if (one == other) return false;
    fprintf(out, "  %s: %" PRId64 " and %" PRId64 "\n", what, one, other);
    return true;
}

fw_status fw_compare(fw_playback *one, fw_playback *other, FILE *out, int *differing,
                     fw_error *error)
{
    *differing = counts_differ("particles", one->particle_count, other->particle_count, out) +
                 counts_differ("frames", one->frame_count, other->frame_count, out) +
                 counts_differ("samples", one->sample_count, other->sample_count, out) +
                 counts_differ("fields", one->field_count, other->field_count, out) +
                 counts_differ("observables", one->observable_count, other->observable_count, out);
    if (*differing > 0) return FW_OK;
    FW_TRY(compare_frames(one, other, out, differing, error));
    return compare_samples(one, other, out, differing, error);
}

int fw_compare_provenance(fw_playback *one, fw_playback *other, FILE *out)
{
    static const char *const names[] = {"version", "revision",     "compiler",
                                        "flags",   "instructions", "libraries"};
    int differing = 0;
    for (size_t n = 0; n < sizeof names / sizeof *names; ++n) {
        char *first = fw_playback_fact(one, names[n]), *second = fw_playback_fact(other, names[n]);
        if (strcmp(first ? first : "", second ? second : "") != 0) {
            fprintf(out, "  %s: '%s' then, '%s' now\n", names[n], first ? first : "not known",
                    second ? second : "not known");
            differing += 1;
        }
        free(first);
        free(second);
    }
    return differing;
}
