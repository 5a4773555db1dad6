/* SPDX-License-Identifier: GPL-3.0-or-later */
/* encoder.h - pictures, one after the other, become a film: the only place that knows the program
 * ffmpeg, which does it. */
#ifndef FW_ENCODER_H
#define FW_ENCODER_H

#include "core/status.h"

#define FW_FILM_ENDINGS ".mp4, .webm or .gif"

typedef struct fw_encoder fw_encoder;

/* `name` ends in one of FW_FILM_ENDINGS, which says how the film is kept; `rate` pictures are shown
 * in a second. The name appears when all is on the disk. FW_BAD_INPUT for another ending,
 * FW_SYSTEM_FAILED where ffmpeg is missing or the file cannot be written. */
fw_status fw_encoder_begin(fw_encoder **encoder, const char *name, int rate, fw_error *error);
/* A PNG file, as large as those before it. */
fw_status fw_encoder_add(fw_encoder *encoder, const char *picture, fw_error *error);
/* Ends the film and releases the encoder; also where that fails. */
fw_status fw_encoder_commit(fw_encoder *encoder, fw_error *error);
/* Releases it; nothing is left of the film. NULL is legal. */
void fw_encoder_abandon(fw_encoder *encoder);

#endif
