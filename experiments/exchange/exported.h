/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exported.h - a result on its way to another format: its frames, one after the other. */
#ifndef FW_EXPORTED_H
#define FW_EXPORTED_H

#include "experiments/results/playback.h"

#include <stdio.h>

/* A vector of the plane for each particle: array number n holds component n. */
typedef struct fw_exported_vector {
    const char *name; /* as in the results file: "velocity" */
    double *x, *y;
} fw_exported_vector;

enum { FW_EXPORTED_VECTORS = 3 };

typedef struct fw_exported {
    fw_playback *playback;
    const char *path; /* of the results file; the caller's */
    int64_t every;    /* frames 0, every, 2 every, ... are exported */
    int64_t *steps;   /* of each frame of the file */
    double *times;
    int *body; /* of each particle */
    double *mass;
    /* The frame that was read last: position, then velocity and force as far as there are any. */
    fw_exported_vector vectors[FW_EXPORTED_VECTORS];
    int vector_count;
    double **fields; /* one array for each of playback->fields */
} fw_exported;

/* fw_exported_close() releases it, also where it failed. */
fw_status fw_exported_open(fw_exported *exported, const char *path, int64_t every, fw_error *error);
void fw_exported_close(fw_exported *exported);
/* Number of frames that are exported; the n-th is frame n * every of the file. */
int64_t fw_exported_count(const fw_exported *exported);
fw_status fw_exported_read(fw_exported *exported, int64_t frame, fw_error *error);

/* A file with `head` and then every frame, which is read before `frame` writes it. */
fw_status fw_exported_write(fw_exported *exported, const char *name,
                            void (*head)(FILE *out, const fw_exported *exported),
                            void (*frame)(FILE *out, const fw_exported *exported, int64_t number),
                            fw_error *error);

/* A file with the last frame alone. */
fw_status fw_exported_write_last(fw_exported *exported, const char *name,
                                 void (*frame)(FILE *out, const fw_exported *exported,
                                               int64_t number),
                                 fw_error *error);

/* One format: writes all frames under `name`. */
fw_status fw_export_csv(fw_exported *exported, const char *name, fw_error *error);
fw_status fw_export_data(fw_exported *exported, const char *name, fw_error *error);
fw_status fw_export_extxyz(fw_exported *exported, const char *name, fw_error *error);
fw_status fw_export_vtp(fw_exported *exported, const char *name, fw_error *error);
fw_status fw_export_xdmf(fw_exported *exported, const char *name, fw_error *error);

#endif
