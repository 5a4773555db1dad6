/* SPDX-License-Identifier: GPL-3.0-or-later */
/* csv.h - comma-separated values: written whole, with the digits that give the same doubles back,
 * and read again. */
#ifndef FW_CSV_H
#define FW_CSV_H

#include "core/status.h"

#include <stdio.h>

/* A text (RFC 4180: in quotes where it could be taken for several values); a number, empty where
 * there is none. Neither writes a comma. */
void fw_csv_write_text(FILE *out, const char *text);
void fw_csv_write_number(FILE *out, double value);

/* Cuts the first value off: *value is its text without quotes, written over the line; returns what
 * is behind its comma, or NULL where that was the last one of the line. */
char *fw_csv_cut(char *line, char **value);

/* A number as it was written; NaN where it is empty. */
double fw_csv_read_number(const char *text);

/* What `write` says of `object`, as a file of results that the folder's manifest lists
 * (manifest.h). */
fw_status fw_csv_keep(const char *directory, const char *name,
                      void (*write)(FILE *out, const void *object), const void *object,
                      fw_error *error);
/* The same, as a file that appears whole where the user names it (whole_file.h). */
fw_status fw_csv_save(const char *path, void (*write)(FILE *out, const void *object),
                      const void *object, fw_error *error);

#endif
