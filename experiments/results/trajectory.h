/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory.h - the results file of a run, DIR/trajectory.h5, as it is written.
 *
 * H5MD 1.1: particles/trajectory holds all bodies one after the other, in three dimensions with
 * z = 0; observables/NAME has a row per frame, as readers of H5MD expect, and
 * parameters/series/NAME one per sample; parameters holds also the scenario, the seed, the
 * provenance, warnings, profiles, analyses, and how many frames and samples count. Everything is
 * laid out when the file is created; while a run writes, only numbers change. A frame counts once
 * it is whole, so whatever ends the process, a reader finds every frame that counts. playback.h
 * reads it.
 *
 * Quantities are in the reduced units of the solids. All arrays given here belong to the caller and
 * are copied before the call returns. */
#ifndef FW_TRAJECTORY_H
#define FW_TRAJECTORY_H

#include "experiments/units/units.h"

#include "core/status.h"
#include "experiments/storage/folder.h"
#include "experiments/storage/table.h"

#include <stdbool.h>
#include <stdint.h>

#define FW_TRAJECTORY_FILE "trajectory.h5"
/* What a folder holds in place of it, where its results are those of a sweep (sweep.h): the sweep's
 * scenario, and its table. */
#define FW_SWEEP_SCENARIO "sweep-as-run.yaml"
#define FW_SWEEP_FILE     "sweep.csv"
/* The exit reasons of a run that reached its end, and of one that still runs or was killed. */
#define FW_RUN_FINISHED "finished"
#define FW_RUN_RUNNING  "running"

enum { FW_NAME_SIZE = 128, FW_EXIT_REASON_SIZE = 512, FW_WARNINGS_SIZE = 8192 };

typedef struct fw_trajectory fw_trajectory;

typedef struct fw_trajectory_body {
    const char *name;
    int count;             /* particles */
    const double *mass;    /* of each particle; NULL in all bodies: masses are not stored */
    const int (*links)[2]; /* link_count pairs of the body's particles */
    int link_count;
} fw_trajectory_body;

/* A number per particle and frame besides positions, such as "strain". */
typedef struct fw_trajectory_field {
    const char *name, *unit;
    const char *meaning;
} fw_trajectory_field;

/* A time series. Its name may not contain a slash. */
typedef struct fw_observable {
    const char *name;
    const char *unit;    /* "energy", "length / time"; "1" for pure numbers */
    const char *meaning; /* one line */
    int components;      /* 1: a scalar; more: a vector */
} fw_observable;

/* Numbers that belong to the run as a whole and are known at its end, such as a profile: under
 * parameters/NAME, where NAME is "GROUP/ARRAY". NaN until they are written. */
typedef struct fw_trajectory_array {
    char name[FW_NAME_SIZE];
    const char *unit, *meaning;
    int rows, columns; /* columns 1: a list; rows 1: the columns alone */
} fw_trajectory_array;
/* Arrays that belong together, kept under parameters/analysis/NAME. */
typedef struct fw_table_group {
    const char *name;
    const fw_table *tables;
    int table_count;
} fw_table_group;

/* Plain data that describes the file; start from fw_trajectory_def_default(). */
typedef struct fw_trajectory_def {
    const char *directory;
    bool overwrite;        /* an earlier result in the folder is replaced, else refused */
    const char *author;    /* NULL: whoever runs the program */
    const char *title;     /* of the experiment */
    const char *scenario;  /* its text as run, after every --set */
    const fw_units *units; /* what the reduced ones are in nature; NULL: nobody said */
    const char *forms;     /* of bodies whose solid has several, a line each: "BODY: FORM" */
    uint64_t seed;
    int threads;
    const fw_trajectory_body *bodies;
    int body_count;
    bool velocity, force; /* whether frames hold them */
    const fw_trajectory_field *fields;
    int field_count;
    const fw_observable *observables;
    int observable_count;
    const fw_trajectory_array *arrays;
    int array_count;
    const fw_table_group *groups;
    int group_count;
    int64_t frame_count;  /* frames that the run will write, at most */
    int64_t sample_count; /* rows of observables that the run will write, at most */
} fw_trajectory_def;

fw_trajectory_def fw_trajectory_def_default(void);

/* Bytes that the file will take. */
double fw_trajectory_size(const fw_trajectory_def *def);

/* Creates the folder where it is missing, and in it the whole file with room for all frames. An
 * earlier result is replaced, checkpoints included, only when the new file is complete; on failure
 * everything is as it was. FW_BAD_INPUT: there is a result already, or a name cannot be used;
 * FW_SYSTEM_FAILED: no permission, no room. */
fw_status fw_trajectory_create(fw_trajectory **trajectory, const fw_trajectory_def *def,
                               fw_error *error);

/* Does the folder hold a result, of a run or a sweep? And the sentence for whoever would put
 * another one there. */
bool fw_trajectory_is_in(const fw_folder *folder);
fw_status fw_trajectory_refuse(const char *directory, fw_error *error);
/* Removes the result from a folder that is held. */
fw_status fw_trajectory_discard(const fw_folder *folder, fw_error *error);
/* Makes the file in a results folder readable where its run was killed while it closed it, so that
 * it can be resumed. FW_BAD_INPUT when there is no such file, or a run is writing it now. */
fw_status fw_trajectory_mend(const char *directory, fw_error *error);

/* Goes on with the file of an interrupted or killed run: its first `frames` frames and `samples`
 * samples stay, the following ones are written anew. `def` is what the file was created with
 * (author, title, scenario, seed and overwrite are not looked at). FW_BAD_INPUT: there is no such
 * file, the run is finished, or the file holds something else than the definition or fewer rows. */
fw_status fw_trajectory_reopen(fw_trajectory **trajectory, const fw_trajectory_def *def,
                               int64_t frames, int64_t samples, fw_error *error);

/* One body in a frame, arrays of one number per particle. What the definition leaves out may
 * be NULL. A body that does not have a field (NULL) gets NaN. */
typedef struct fw_frame_body {
    const double *x, *y;
    const double *velocity_x, *velocity_y;
    const double *force_x, *force_y;
    const double *const *fields; /* in the order of the definition */
    /* Not NULL: positions and velocities are what this solid's model tells by `motions` of its
     * particles from `first` on, in place of the arrays; for frames that hold velocities. */
    const struct fw_solid *solid;
    int first;
} fw_frame_body;

/* Adds a frame of all bodies, in the order of the definition. */
fw_status fw_trajectory_write_frame(fw_trajectory *trajectory, int64_t step, double time,
                                    const fw_frame_body *bodies, fw_error *error);

/* Adds a row of all observables: their components one after the other, in the order of the
 * definition. Rows are gathered; they count after at most some hundred rows or one second, and
 * after fw_trajectory_sync. */
fw_status fw_trajectory_write_sample(fw_trajectory *trajectory, int64_t step, double time,
                                     const double *values, fw_error *error);

/* Writes one of the arrays, rows x columns numbers. */
fw_status fw_trajectory_write_array(fw_trajectory *trajectory, const fw_trajectory_array *array,
                                    const double *values, fw_error *error);

/* Rewrites what the user was warned of, a line each, at most FW_WARNINGS_SIZE bytes. */
fw_status fw_trajectory_warn(fw_trajectory *trajectory, const char *warnings, fw_error *error);

int64_t fw_trajectory_sample_count(const fw_trajectory *trajectory);

/* Lets everything written so far count and waits for the disk; to be called before a checkpoint is
 * written that speaks of it. */
fw_status fw_trajectory_sync(fw_trajectory *trajectory, fw_error *error);

/* Notes how a run that will not reach its end has failed, for fw_playback's exit_status; to be
 * called before fw_trajectory_finish. */
void fw_trajectory_fail(fw_trajectory *trajectory, fw_status status);

/* Notes why and when the run ended, and cuts off the room for frames that were not written. Nothing
 * but destroy may follow. With FW_RUN_FINISHED the file is closed for good; with any other reason
 * it can be reopened. */
fw_status fw_trajectory_finish(fw_trajectory *trajectory, const char *exit_reason, fw_error *error);

/* Removes a result that could not begin, and its folder as far as it was made for it. NULL is
 * legal.
 */
void fw_trajectory_abandon(fw_trajectory *trajectory);

/* Without fw_trajectory_finish before it, the file looks like that of a killed run. NULL is legal.
 */
void fw_trajectory_destroy(fw_trajectory *trajectory);

#endif
