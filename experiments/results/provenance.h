/* SPDX-License-Identifier: GPL-3.0-or-later */
/* provenance.h - where a result comes from: which program, built how, run where and when. */
#ifndef FW_PROVENANCE_H
#define FW_PROVENANCE_H

#include <stddef.h>
#include <stdio.h>

enum { FW_PROVENANCE_SIZE = 256 };

typedef struct fw_provenance {
    const char *program;      /* "fretwork" */
    const char *version;      /* "0.1.0" */
    const char *revision;     /* of the source, "unknown" outside its repository */
    const char *compiler;     /* "GNU 12.2.0" */
    const char *flags;        /* what decides about numbers: the build type and its flags */
    const char *instructions; /* of the kernels that run, "x86-64-v3" */
    char libraries[FW_PROVENANCE_SIZE];
    char host[FW_PROVENANCE_SIZE];  /* name, system and processor architecture */
    char start[FW_PROVENANCE_SIZE]; /* time of the run, as fw_provenance_time */
} fw_provenance;

/* Everything about this program, this machine and this moment. */
fw_provenance fw_provenance_now(void);

/* Says a line on `out` where results in a folder were begun by another revision than this one. */
void fw_provenance_compare(FILE *out, const char *revision, const char *directory);

/* The time in UTC, "2024-05-01T12:00:00Z". */
void fw_provenance_time(char *text, size_t size);

/* The name of the person who runs this, from the system's list of users; their login name, or
 * "unknown", where there is no better. */
void fw_provenance_author(char *text, size_t size);

#endif
