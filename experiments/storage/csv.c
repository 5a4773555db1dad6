/* SPDX-License-Identifier: GPL-3.0-or-later */
/* csv.c - comma-separated values. Keeps no state. */
#include "experiments/storage/csv.h"

#include "experiments/storage/manifest.h"
#include "experiments/storage/whole_file.h"
#include "experiments/text/number.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

void fw_csv_write_text(FILE *out, const char *text)
{
    if (!strpbrk(text, ",\"\r\n")) {
        fputs(text, out);
        return;
    }
    fputc('"', out);
    for (; *text; ++text) {
        if (*text == '"') fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

void fw_csv_write_number(FILE *out, double value)
{
    if (!isnan(value)) fprintf(out, "%.17g", value);
}

double fw_csv_read_number(const char *text)
{
    return text[0] ? fw_number_scan(text, NULL) : NAN;
}

char *fw_csv_cut(char *line, char **value)
{
    char *to = line;
    const bool quoted = *line == '"';
    *value = line;
    if (quoted) ++line;
    for (; *line; ++line) {
        if (quoted && *line == '"') {
            if (line[1] != '"') break;
            ++line;
        } else if (!quoted && (*line == ',' || *line == '\n')) {
            break;
        }
        *to++ = *line;
    }
    line += quoted && *line == '"';
    const bool more = *line == ',';
    *to = '\0';
    return more ? line + 1 : NULL;
}

/* To be freed; FW_SYSTEM_FAILED without memory. */
static fw_status print(char **text, size_t *size, void (*write)(FILE *out, const void *object),
                       const void *object, fw_error *error)
{
    *text = NULL;
    *size = 0;
    FILE *memory = open_memstream(text, size);
    if (memory) write(memory, object);
    if (memory && fclose(memory) == 0) return FW_OK;
    free(*text);
    *text = NULL;
    return fw_fail_memory(error, "a table");
}

fw_status fw_csv_keep(const char *directory, const char *name,
                      void (*write)(FILE *out, const void *object), const void *object,
                      fw_error *error)
{
    char *text;
    size_t size;
    FW_TRY(print(&text, &size, write, object, error));
    const fw_status status = fw_manifest_write(directory, name, text, size, error);
    free(text);
    return status;
}

fw_status fw_csv_save(const char *path, void (*write)(FILE *out, const void *object),
                      const void *object, fw_error *error)
{
    char *text;
    size_t size;
    FW_TRY(print(&text, &size, write, object, error));
    const fw_status status = fw_whole_file_write(path, text, size, error);
    free(text);
    return status;
}
