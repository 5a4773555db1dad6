/* SPDX-License-Identifier: GPL-3.0-or-later */
/* recorder.h - what a run leaves on disk: the results file and its checkpoints. */
#ifndef FW_RECORDER_H
#define FW_RECORDER_H

#include "experiments/measures/measurement.h"
#include "experiments/results/trajectory.h"

typedef struct fw_recorder fw_recorder;

/* What was written so far; a checkpoint speaks of it. */
typedef struct fw_written {
    int64_t frames, rows;
    int64_t warned, warning_bytes; /* what was warned of, as the run counts it; and its text */
} fw_written;

/* Creates the results file with room for the whole run. Everything given is observed and must live
 * as long as the recorder. */
fw_status fw_recorder_create(fw_recorder **recorder, fw_observer *observer,
                             const fw_measurement *measurement, const char *directory,
                             bool overwrite, int threads, fw_error *error);

/* First half of a resume: loads the newest checkpoint into the scene. *written reports how much
 * it speaks, of no rows where there is none yet and the scene is at its start; *note what the user
 * should know, if not empty. FW_BAD_INPUT: it holds what this run cannot have written. */
fw_status fw_recorder_reopen(fw_recorder **recorder, fw_observer *observer,
                             const fw_measurement *measurement, const char *directory, int threads,
                             fw_written *written, char note[FW_SENTENCE_SIZE], fw_error *error);
/* Second half: cuts the results file back to the checkpoint, and its warnings, which are given,
 * too, and goes on writing behind it. */
fw_status fw_recorder_go_on(fw_recorder *recorder, const char *warnings, fw_error *error);

fw_status fw_recorder_write_row(fw_recorder *recorder, int64_t step, double time, const double *row,
                                fw_error *error);
fw_status fw_recorder_write_frame(fw_recorder *recorder, fw_error *error);
/* Do frames need the positions of all particles, as fw_scene_settle() leaves them? */
bool fw_recorder_needs_positions(const fw_recorder *recorder);
fw_status fw_recorder_checkpoint(fw_recorder *recorder, fw_error *error);

fw_status fw_recorder_write_array(fw_recorder *recorder, const fw_trajectory_array *array,
                                  const double *values, fw_error *error);

/* The observer's, as it is now. */
fw_status fw_recorder_write_certificate(fw_recorder *recorder, fw_error *error);

/* Keeps what the user was warned of, a line each, beside the results, and `warned` for the next
 * checkpoint. */
fw_status fw_recorder_add_warnings(fw_recorder *recorder, const char *lines, int64_t warned,
                                   fw_error *error);
const char *fw_recorder_warnings(const fw_recorder *recorder);

/* Ends the file; FW_OK and `reason` NULL: the run reached its end. */
fw_status fw_recorder_finish(fw_recorder *recorder, fw_status status, const char *reason,
                             fw_error *error);
void fw_recorder_destroy(fw_recorder *recorder);
/* The same, of a run that could not begin: nothing of it stays on disk. */
void fw_recorder_abandon(fw_recorder *recorder);

/* What a whole run leaves on disk, in bytes and rows. */
typedef struct fw_results_size {
    int64_t frames, rows;
    int row_width;     /* numbers measured at a time */
    double file;       /* the results file */
    double checkpoint; /* one of the two */
} fw_results_size;
/* Nothing is made; the observer is only looked at. */
fw_status fw_recorder_size(fw_observer *observer, const fw_measurement *measurement,
                           fw_results_size *size, fw_error *error);

#endif
