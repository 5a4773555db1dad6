/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lines.h - a file as lines of words; for the files of this folder alone. */
#ifndef FW_LINES_H
#define FW_LINES_H

#include "experiments/configuration/configuration.h"

typedef struct fw_lines {
    const char *path;
    char *rest; /* what was not read yet */
    int number; /* of the line that was read last, from 1 */
} fw_lines;

enum { FW_WORDS = 32 };
typedef struct fw_words {
    int count;
    char *word[FW_WORDS]; /* those behind are passed over */
} fw_words;

/* The next line, without its end; NULL at the end of the file. */
char *fw_lines_next(fw_lines *lines);
/* Cuts it at its blanks, and ends it where a '#' begins. */
fw_words fw_words_cut(char *line);

/* FW_BAD_INPUT with the place in front of the sentence. */
fw_status fw_lines_fail(const fw_lines *lines, fw_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* The number a word is. `what` is for the sentence: "x of a particle". */
fw_status fw_lines_number(const fw_lines *lines, const char *word, const char *what, double *value,
                          fw_error *error);

/* Room for particles, whose count stands in the line just read. */
fw_status fw_configuration_make(fw_configuration *configuration, const fw_lines *lines,
                                const char *count, fw_error *error);
/* Sets particle n from the words of its place, and its kind. All must have the z of the first. */
fw_status fw_configuration_set(fw_configuration *configuration, const fw_lines *lines, int n,
                               char *const words[3], const char *kind, double *plane,
                               fw_error *error);

fw_status fw_configuration_read_xyz(fw_configuration *configuration, fw_lines *lines,
                                    fw_error *error);
fw_status fw_configuration_read_lammps(fw_configuration *configuration, fw_lines *lines,
                                       fw_error *error);

#endif
