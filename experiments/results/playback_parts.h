/* SPDX-License-Identifier: GPL-3.0-or-later */
/* playback_parts.h - the inside of a results file that is read: playback.c opens it and looks at
 * all that does not grow with frames, playback_frames.c reads the rest on demand. */
#ifndef FW_PLAYBACK_PARTS_H
#define FW_PLAYBACK_PARTS_H

#include "experiments/results/playback.h"
#include "experiments/storage/hdf5_file.h"

#define FW_PARTICLES "particles/trajectory"
#define FW_SERIES    "parameters/series"

typedef struct fw_playback_file {
    fw_hdf5 *hdf5;
    double *vectors; /* one row of particles */
    int (*links)[2]; /* those of the playback */
} fw_playback_file;

/* Lets the reading fail because of what is at `path`. */
fw_status fw_playback_refuse(fw_playback *playback, const char *path, fw_error *error);
/* The dataset at `path` if its rows are arrays of these extents and there are at least `rows`. */
fw_dataset fw_playback_find_rows(fw_playback *playback, const char *path, fw_element element,
                                 int64_t rows, int rank, const uint64_t *extent);

#endif
