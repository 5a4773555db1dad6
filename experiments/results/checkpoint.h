/* SPDX-License-Identifier: GPL-3.0-or-later */
/* checkpoint.h - the state of a run on disk, from which it goes on exactly.
 *
 * Two files, DIR/checkpoint-A and -B, are written in turn as sealed files (sealed_file.h), so that
 * one whole checkpoint is there at any moment. A checkpoint is the arrays of the run's state lists
 * as they lie in memory, in sections ("scene", "sheet", "recorder"); results beyond it are in the
 * results file, which is to be synchronised first (fw_trajectory_sync). */
#ifndef FW_CHECKPOINT_H
#define FW_CHECKPOINT_H

#include "core/array.h"
#include "core/status.h"

#include <stdbool.h>
#include <stdint.h>

enum { FW_CHECKPOINT_NAME_SIZE = 16 };

/* With which the files begin. */
#define FW_CHECKPOINT_KIND "FWCHECKP"

typedef struct fw_checkpoint fw_checkpoint;

/* The state of one object under a name of its own. Both stay the caller's. */
typedef struct fw_checkpoint_section {
    const char *name;
    const fw_state_list *state;
} fw_checkpoint_section;

/* What was loaded. */
typedef struct fw_checkpoint_origin {
    char name[FW_CHECKPOINT_NAME_SIZE]; /* "checkpoint-A" */
    int64_t step;
    bool fallen_back;     /* the newer checkpoint could not be used, and the run lost some steps */
    fw_error newer_error; /* why, when fallen_back */
} fw_checkpoint_origin;

/* Looks at the checkpoints in a folder, which must be there; whole ones are not overwritten before
 * another one is whole. Checkpoints belong to a scenario, given as its text. */
fw_status fw_checkpoint_open(fw_checkpoint **checkpoint, const char *directory,
                             const char *scenario, fw_error *error);
/* NULL is legal. */
void fw_checkpoint_close(fw_checkpoint *checkpoint);

/* Is there any, whole or not? */
bool fw_checkpoint_exists(const fw_checkpoint *checkpoint);

/* Saves the arrays. On failure (FW_SYSTEM_FAILED) the earlier checkpoints are as they were. */
fw_status fw_checkpoint_write(fw_checkpoint *checkpoint, const fw_checkpoint_section *sections,
                              int count, int64_t step, fw_error *error);

/* Bytes of the payload of such a checkpoint. */
uint64_t fw_checkpoint_size(const fw_checkpoint_section *sections, int count);

/* Brings back the newest checkpoint that is whole, into the arrays of the state lists. Sections,
 * names, types and counts must be those that were saved. On failure no array has changed:
 * FW_BAD_INPUT when there is no checkpoint, none is whole, or it belongs to another scenario or
 * state; FW_SYSTEM_FAILED when it cannot be read. `origin` may be NULL. */
fw_status fw_checkpoint_load(fw_checkpoint *checkpoint, const fw_checkpoint_section *sections,
                             int count, fw_checkpoint_origin *origin, fw_error *error);

/* The reader itself: arrays from the payload of a checkpoint, which may be any bytes. `scenario` is
 * the hash that fw_checkpoint_hash gives. On failure (FW_BAD_INPUT) no array has changed. */
fw_status fw_checkpoint_decode(const unsigned char *payload, uint64_t size, uint64_t scenario,
                               const fw_checkpoint_section *sections, int count, int64_t *step,
                               fw_error *error);
uint64_t fw_checkpoint_hash(const char *scenario);

#endif
