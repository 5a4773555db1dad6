/* SPDX-License-Identifier: GPL-3.0-or-later */
/* playback.h - the results file of a run, as it is read: for tables, profiles and pictures.
 * Only what counts is shown (see trajectory.h), so a file may be read while its run goes on or
 * after it was killed. A file that is damaged, cut short or not ours gives one sentence;
 * so does one of an earlier version of the program, which had no seal. */
#ifndef FW_PLAYBACK_H
#define FW_PLAYBACK_H

#include "core/status.h"
#include "experiments/results/trajectory.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct fw_playback_body {
    char name[FW_NAME_SIZE];
    int first, count; /* its particles among all */
} fw_playback_body;

typedef struct fw_playback_field {
    char name[FW_NAME_SIZE];
    char unit[64];
    char physical[FW_PHYSICAL_TEXT]; /* what one of it is in nature, "0.74 eV"; "": nobody said */
    char meaning[256];
} fw_playback_field;

typedef struct fw_playback_observable {
    char name[FW_NAME_SIZE];
    char unit[64];
    char physical[FW_PHYSICAL_TEXT]; /* as of a field */
    char meaning[256];
    int components;
} fw_playback_observable;

/* Everybody may read the head; all of it belongs to the playback. */
typedef struct fw_playback {
    int particle_count;
    int64_t frame_count, sample_count;
    fw_playback_body *bodies;
    int body_count;
    const int (*links)[2]; /* pairs of particles, numbered among all */
    int link_count;
    char time_physical[FW_PHYSICAL_TEXT]; /* of a time of 1; "": nobody said */
    bool velocity, force, mass;           /* whether the file has them */
    fw_playback_field *fields;
    int field_count;
    fw_playback_observable *observables;
    int observable_count;
    char *title, *scenario;
    uint64_t seed;
    char *exit_reason, *revision, *start, *end; /* of the run; see provenance.h */
    int64_t exit_status; /* how it failed, as an fw_status; FW_OK where it has not */
    char *warnings;      /* what the user was warned of, a line each; "" if of nothing */
    struct fw_playback_file *file;
} fw_playback;

/* `path` is a results folder or a results file. FW_BAD_INPUT: there is none, or it is not one;
 * FW_SYSTEM_FAILED: it cannot be read. */
fw_status fw_playback_open(fw_playback **playback, const char *path, fw_error *error);
/* The first failure in reading it. What the functions without an error say is only so without one.
 */
fw_status fw_playback_check(const fw_playback *playback, fw_error *error);
/* A text of the run's provenance, such as "instructions" (results-format.md), malloc'ed. NULL: the
 * file has none of that name, or cannot be read (fw_playback_check). */
char *fw_playback_fact(fw_playback *playback, const char *name);
/* NULL is legal. */
void fw_playback_close(fw_playback *playback);

/* Steps and times of all frames, or of all samples; either array may be NULL. */
fw_status fw_playback_read_frame_times(fw_playback *playback, int64_t *steps, double *times,
                                       fw_error *error);
fw_status fw_playback_read_sample_times(fw_playback *playback, int64_t *steps, double *times,
                                        fw_error *error);

/* Of one frame, one number per particle. FW_BAD_INPUT when the file has no such frame or element.
 */
fw_status fw_playback_read_positions(fw_playback *playback, int64_t frame, double *x, double *y,
                                     fw_error *error);
fw_status fw_playback_read_velocities(fw_playback *playback, int64_t frame, double *x, double *y,
                                      fw_error *error);
fw_status fw_playback_read_forces(fw_playback *playback, int64_t frame, double *x, double *y,
                                  fw_error *error);
fw_status fw_playback_read_field(fw_playback *playback, int64_t frame, const char *name,
                                 double *values, fw_error *error);
fw_status fw_playback_read_masses(fw_playback *playback, double *masses, fw_error *error);

/* Arrays of the run as a whole (fw_trajectory_array), by name. Rows of an array of so many columns,
 * 0 if there is none, or it cannot be read (fw_playback_check). */
int fw_playback_array_rows(fw_playback *playback, const char *name, int columns);
fw_status fw_playback_read_array(fw_playback *playback, const char *name, int rows, int columns,
                                 double *values, fw_error *error);
/* An array of an analysis: rank, extent and `values`, which is malloc'ed; name, unit and meaning
 * stay NULL. FW_BAD_INPUT: the results hold no such array. */
fw_status fw_playback_read_table(fw_playback *playback, const char *group, const char *name,
                                 fw_table *table, fw_error *error);

/* Index in `observables`, or -1. */
int fw_playback_find_observable(const fw_playback *playback, const char *name);
/* All samples of an observable, components of one sample next to each other:
 * sample_count * components numbers. */
fw_status fw_playback_read_observable(fw_playback *playback, int observable, double *values,
                                      fw_error *error);

#endif
