/* SPDX-License-Identifier: GPL-3.0-or-later */
/* film.h - the motion of a result as a film: one picture per frame, all with the same axes and
 * colours. */
#ifndef FW_FILM_H
#define FW_FILM_H

#include "core/status.h"

#include <stdint.h>
#include <stdio.h>

typedef struct fw_film_wish {
    const char *file;    /* ends as encoder.h says */
    const char *picture; /* one of the scenario's, or NULL */
    const char *kind;    /* motion or field; NULL: the picture's, or field where one was recorded */
    const char *field;   /* whose values are colours; NULL: the picture's own, or the first */
    double range[2];     /* ends of the colours; equal: those of the whole result */
    int64_t every;       /* only every so many frames; 0: so that the film has at most 500 */
    int64_t rate;        /* frames in a second; 0: 25 */
} fw_film_wish;

/* Says on `out` what was made. FW_BAD_INPUT: the result does not hold what is wished for, or
 * another ending; FW_SYSTEM_FAILED: memory, disk, ffmpeg; what fw_interrupt_seen() says where the
 * user ended it, and then nothing is left. */
fw_status fw_film_make(const char *directory, const fw_film_wish *wish, FILE *out, fw_error *error);

#endif
