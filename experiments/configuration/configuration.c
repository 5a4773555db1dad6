/* SPDX-License-Identifier: GPL-3.0-or-later */
/* configuration.c - which format, and what all formats have in common. Keeps no state. Start
 * reading at fw_configuration_read(). */
#include "experiments/configuration/configuration.h"

#include "experiments/storage/regular_file.h"
#include "experiments/text/number.h"
#include "experiments/text/text.h"
#include "lines.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A line of a particle takes some 30 to 300 bytes. */
static const size_t LARGEST = (size_t)1 << 30;

/* --- lines and words --- */

char *fw_lines_next(fw_lines *lines)
{
    char *line = lines->rest;
    if (!line || !*line) return NULL;
    const size_t length = strcspn(line, "\n");
    lines->rest = line[length] ? line + length + 1 : NULL;
    line[length] = '\0';
    if (length > 0 && line[length - 1] == '\r') line[length - 1] = '\0';
    lines->number += 1;
    return line;
}

fw_words fw_words_cut(char *line)
{
    fw_words words = {.count = 0};
    char *next = NULL;
    line[strcspn(line, "#")] = '\0';
    for (char *word = strtok_r(line, " \t", &next); word && words.count < FW_WORDS;
         word = strtok_r(NULL, " \t", &next))
        words.word[words.count++] = word;
    return words;
}

fw_status fw_lines_fail(const fw_lines *lines, fw_error *error, const char *format, ...)
{
    char sentence[FW_SENTENCE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    return fw_fail(error, FW_BAD_INPUT, "%s:%d: %s", lines->path, lines->number, sentence);
}

fw_status fw_lines_number(const fw_lines *lines, const char *word, const char *what, double *value,
                          fw_error *error)
{
    if (fw_number_read(word, strlen(word), value) == FW_NUMBER_FINE) return FW_OK;
    return fw_lines_fail(lines, error, "%s is '%s', expected a number", what,
                         fw_text_quote(word, strlen(word)).text);
}

/* --- particles --- */

fw_status fw_configuration_make(fw_configuration *configuration, const fw_lines *lines,
                                const char *count, fw_error *error)
{
    int64_t number = 0;
    if (fw_integer_read(count, strlen(count), &number) != FW_NUMBER_FINE || number < 1 ||
        number > FW_CONFIGURATION_MOST)
        return fw_lines_fail(lines, error, "there are '%s' particles, expected 1 to %d",
                             fw_text_quote(count, strlen(count)).text, FW_CONFIGURATION_MOST);
    fw_configuration_clear(configuration);
    configuration->place = calloc((size_t)number, sizeof *configuration->place);
    configuration->kind = calloc((size_t)number, sizeof *configuration->kind);
    if (!configuration->place || !configuration->kind) return fw_fail_memory(error, lines->path);
    configuration->count = (int)number;
    return FW_OK;
}

fw_status fw_configuration_set(fw_configuration *configuration, const fw_lines *lines, int n,
                               char *const words[3], const char *kind, double *plane,
                               fw_error *error)
{
    double z;
    FW_TRY(fw_lines_number(lines, words[0], "x", &configuration->place[n].x, error));
    FW_TRY(fw_lines_number(lines, words[1], "y", &configuration->place[n].y, error));
    FW_TRY(fw_lines_number(lines, words[2], "z", &z, error));
    if (isnan(*plane)) *plane = z;
    snprintf(configuration->kind[n], sizeof configuration->kind[n], "%s", kind);
    if (z == *plane) return FW_OK;
    return fw_lines_fail(lines, error, "z is %g, expected %g as of all before: a plane", z, *plane);
}

void fw_configuration_clear(fw_configuration *configuration)
{
    free(configuration->place);
    free(configuration->kind);
    *configuration = (fw_configuration){0};
}

/* --- formats --- */

typedef struct format {
    const char *ending;
    fw_status (*read)(fw_configuration *configuration, fw_lines *lines, fw_error *error);
} format;

static const format formats[] = {{".xyz", fw_configuration_read_xyz},
                                 {".extxyz", fw_configuration_read_xyz},
                                 {".data", fw_configuration_read_lammps},
                                 {".lmp", fw_configuration_read_lammps}};
enum { FORMATS = sizeof formats / sizeof *formats };

static const format *format_of(const char *path)
{
    const char *ending = strrchr(path, '.');
    for (int n = 0; ending && n < FORMATS; ++n)
        if (strcmp(formats[n].ending, ending) == 0) return &formats[n];
    return NULL;
}

fw_status fw_configuration_read(fw_configuration *configuration, const char *path, fw_error *error)
{
    const format *of = format_of(path);
    *configuration = (fw_configuration){0};
    if (!of)
        return fw_fail(error, FW_BAD_INPUT,
                       "the file '%s' is of no known kind, expected one that ends in .xyz, .extxyz "
                       "(extended XYZ), .data or .lmp (LAMMPS)",
                       fw_text_quote(path, strlen(path)).text);
    char *bytes;
    size_t size;
    FW_TRY(fw_regular_file_read(&bytes, &size, path, LARGEST, error));
    fw_lines lines = {.path = path, .rest = bytes};
    fw_status status = FW_OK;
    if (strlen(bytes) != size)
        status = fw_fail(error, FW_BAD_INPUT, "%s has a byte of 0 in it, expected a text", path);
    if (status == FW_OK) status = of->read(configuration, &lines, error);
    free(bytes);
    if (status != FW_OK) fw_configuration_clear(configuration);
    return status;
}
