/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frame.h - the numbers of a frame, body by body, taken from the scene as it is now. */
#ifndef FW_FRAME_H
#define FW_FRAME_H

#include "experiments/results/trajectory.h"
#include "experiments/setup/experiment.h"

typedef struct fw_body_arrays fw_body_arrays;
typedef struct fw_solid_arrays fw_solid_arrays;

typedef struct fw_frame {
    const fw_experiment *experiment; /* observed, as the definition is */
    const fw_trajectory_def *def;
    fw_body_arrays *bodies;
    fw_frame_body *content;
    fw_solid_arrays *solids; /* of the scene: much is computed of whole solids */
} fw_frame;

/* Memory for one frame of what the definition names; to be cleared also after a failure. */
fw_status fw_frame_make(fw_frame *frame, const fw_experiment *experiment,
                        const fw_trajectory_def *def, fw_error *error);
/* One that is all zero may be cleared. */
void fw_frame_clear(fw_frame *frame);

/* Do fw_frame_fill() or its entries look at positions of solids? */
bool fw_frame_needs_positions(const fw_frame *frame);
/* One entry per body, valid until the next call. */
const fw_frame_body *fw_frame_fill(fw_frame *frame);

#endif
