/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trajectory_parts.h - the inside of a results file that is written: trajectory.c makes it and goes
 * on with it, trajectory_rows.c adds to it and ends it. */
#ifndef FW_TRAJECTORY_PARTS_H
#define FW_TRAJECTORY_PARTS_H

#include "experiments/results/trajectory.h"
#include "experiments/storage/series.h"

struct fw_trajectory {
    fw_folder *folder;
    fw_hdf5 *file;
    fw_series *frames, *samples;
    int *counts, body_count, particle_count;
    int position, velocity, force, *fields, field_count; /* quantities of the frames; -1: none */
    int *components, observable_count;
    int *moments;   /* of the frames: each observable, as it was measured at the frame's step */
    double *sample; /* the last one, all components; not a number before the first */
    int64_t sample_step;
    size_t sample_width;
};

#endif
