/* SPDX-License-Identifier: GPL-3.0-or-later */
/* read_xyz.c - XYZ: a number of particles, a line that may say what the columns are
 * (Properties=species:S:1:pos:R:3:...), a line for each particle; again for each frame. The last
 * frame is kept. Keeps no state. */
#include "lines.h"

#include "experiments/text/number.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Which words of a line are the species and the place. */
typedef struct columns {
    int species, place; /* -1: there is no species */
} columns;

/* A width that nothing can have leads beyond all words. */
static int columns_of(const char *width)
{
    int64_t count = 0;
    const bool fine = fw_integer_read(width, strlen(width), &count) == FW_NUMBER_FINE;
    return fine && count > 0 && count < FW_WORDS ? (int)count : FW_WORDS;
}

/* Plain XYZ has the species first. */
static fw_status find_columns(columns *found, const fw_lines *lines, char *comment, fw_error *error)
{
    char *list = strstr(comment, "Properties="), *next = NULL;
    *found = (columns){.species = 0, .place = 1};
    if (!list) return FW_OK;
    *found = (columns){.species = -1, .place = -1};
    list += strlen("Properties=");
    list[strcspn(list, " \t")] = '\0';
    int column = 0;
    for (char *name = strtok_r(list, ":", &next); name; name = strtok_r(NULL, ":", &next)) {
        const char *kind = strtok_r(NULL, ":", &next), *width = strtok_r(NULL, ":", &next);
        if (!kind || !width)
            return fw_lines_fail(lines, error,
                                 "Properties ends after '%s', expected NAME:KIND:WIDTH", name);
        if (strcmp(name, "species") == 0) found->species = column;
        if (strcmp(name, "pos") == 0 && strcmp(width, "3") == 0) found->place = column;
        column += columns_of(width);
    }
    if (found->place >= 0 && found->place + 3 <= FW_WORDS) return FW_OK;
    return fw_lines_fail(lines, error, "Properties has no 'pos:R:3', the places of the particles");
}

static fw_status read_particle(fw_configuration *configuration, const fw_lines *lines, int n,
                               char *line, columns in, double *plane, fw_error *error)
{
    const fw_words words = fw_words_cut(line);
    const int least = in.species < in.place + 3 ? in.place + 3 : in.species + 1;
    if (words.count < least)
        return fw_lines_fail(lines, error, "particle %d has %d words, expected %d or more", n,
                             words.count, least);
    return fw_configuration_set(configuration, lines, n, words.word + in.place,
                                in.species < 0 ? "" : words.word[in.species], plane, error);
}

static fw_status read_frame(fw_configuration *configuration, fw_lines *lines, const char *count,
                            fw_error *error)
{
    columns in;
    double plane = NAN;
    FW_TRY(fw_configuration_make(configuration, lines, count, error));
    char *comment = fw_lines_next(lines);
    if (!comment) return fw_lines_fail(lines, error, "the file ends after the number of particles");
    FW_TRY(find_columns(&in, lines, comment, error));
    for (int n = 0; n < configuration->count; ++n) {
        char *line = fw_lines_next(lines);
        if (!line)
            return fw_lines_fail(lines, error, "the file ends after %d particles, expected %d", n,
                                 configuration->count);
        FW_TRY(read_particle(configuration, lines, n, line, in, &plane, error));
    }
    return FW_OK;
}

fw_status fw_configuration_read_xyz(fw_configuration *configuration, fw_lines *lines,
                                    fw_error *error)
{
    bool found = false;
    for (char *line; (line = fw_lines_next(lines));) {
        const fw_words words = fw_words_cut(line);
        if (words.count == 0) continue;
        if (words.count > 1)
            return fw_lines_fail(lines, error, "expected the number of particles alone on a line");
        FW_TRY(read_frame(configuration, lines, words.word[0], error));
        found = true;
    }
    return found ? FW_OK
                 : fw_fail(error, FW_BAD_INPUT, "%s is empty, expected a number of particles",
                           lines->path);
}
