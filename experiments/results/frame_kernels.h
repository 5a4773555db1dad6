/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frame_kernels.h - coordinates side by side, as H5MD has them. */
#ifndef FW_FRAME_KERNELS_H
#define FW_FRAME_KERNELS_H

#include "core/instruction_set.h"

enum { FW_FRAME_BLOCK = 1024 /* rows that are made at a time, at most */ };

typedef struct fw_frame_kernels {
    /* Rows (x, y, 0) of `count` particles. `past_cache`: they go to memory at once, since nobody
     * reads them soon; other threads may after settle(). */
    void (*rows)(const double *x, const double *y, int count, bool past_cache, double *to);
    /* Until all that this thread has written past the cache is there. */
    void (*settle)(void);
} fw_frame_kernels;

FW_KERNELS(fw_frame_kernels, fw_frames);

#endif
