/* SPDX-License-Identifier: GPL-3.0-or-later */
/* read_lammps.c - a data file of LAMMPS: a line that is passed over, "N atoms" and the like, then
 * sections. Of these "Atoms # STYLE" is read, with the styles atomic (id type x y z), charge (id
 * type q x y z), bond, angle and molecular (id molecule type x y z) and full (id molecule type q x
 * y z). Keeps no state. */
#include "lines.h"

#include "experiments/text/number.h"
#include "experiments/text/text.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Which words of a line are the type and the place. */
typedef struct style {
    const char *name;
    int type, place;
} style;

static const style styles[] = {{"atomic", 1, 2}, {"charge", 1, 3},    {"bond", 2, 3},
                               {"angle", 2, 3},  {"molecular", 2, 3}, {"full", 2, 4}};
enum { STYLES = sizeof styles / sizeof *styles };

static fw_status find_style(const style **found, const fw_lines *lines, const char *head,
                            fw_error *error)
{
    const char *comment = strchr(head, '#');
    *found = &styles[0];
    if (!comment) return FW_OK;
    comment += 1 + strspn(comment + 1, " \t");
    const size_t length = strcspn(comment, " \t\r");
    for (int n = 0; n < STYLES; ++n) {
        *found = &styles[n];
        if (strlen(styles[n].name) == length && memcmp(styles[n].name, comment, length) == 0)
            return FW_OK;
    }
    return fw_lines_fail(lines, error,
                         "the style of the atoms is '%s', expected atomic, charge, bond, angle, "
                         "molecular or full",
                         fw_text_quote(comment, length).text);
}

/* Particles by their number, which are 1, 2, ... in any order. */
static fw_status read_atoms(fw_configuration *configuration, fw_lines *lines, const style *of,
                            fw_error *error)
{
    double plane = NAN;
    bool *seen = calloc((size_t)configuration->count, sizeof *seen);
    fw_status status = seen ? FW_OK : fw_fail_memory(error, lines->path);
    for (int n = 0; n < configuration->count && status == FW_OK;) {
        char *line = fw_lines_next(lines);
        if (!line) {
            status = fw_lines_fail(lines, error, "the file ends after %d atoms, expected %d", n,
                                   configuration->count);
            break;
        }
        const fw_words words = fw_words_cut(line);
        if (words.count == 0) continue;
        int64_t id = 0;
        /* With three whole numbers behind the place: through which sides of the box it has gone. */
        const int least = of->place + 3, most = least + 3;
        if (words.count != least && words.count != most)
            status =
                fw_lines_fail(lines, error, "an atom has %d words, expected %d or %d of style %s",
                              words.count, least, most, of->name);
        else if (fw_integer_read(words.word[0], strlen(words.word[0]), &id) != FW_NUMBER_FINE ||
                 id < 1 || id > configuration->count || seen[id - 1])
            status = fw_lines_fail(
                lines, error, "the number of an atom is '%s', expected each of 1 to %d once",
                fw_text_quote(words.word[0], strlen(words.word[0])).text, configuration->count);
        else
            status = fw_configuration_set(configuration, lines, (int)id - 1, words.word + of->place,
                                          words.word[of->type], &plane, error);
        if (status == FW_OK) seen[id - 1] = true;
        n += 1;
    }
    free(seen);
    return status;
}

fw_status fw_configuration_read_lammps(fw_configuration *configuration, fw_lines *lines,
                                       fw_error *error)
{
    fw_lines_next(lines);
    for (char *line; (line = fw_lines_next(lines));) {
        const style *of;
        if (strncmp(line, "Atoms", 5) == 0 && (line[5] == '\0' || strchr(" \t#", line[5]))) {
            if (configuration->count == 0)
                return fw_lines_fail(lines, error, "expected a line 'N atoms' before the atoms");
            FW_TRY(find_style(&of, lines, line, error));
            return read_atoms(configuration, lines, of, error);
        }
        const fw_words words = fw_words_cut(line);
        if (words.count == 2 && strcmp(words.word[1], "atoms") == 0)
            FW_TRY(fw_configuration_make(configuration, lines, words.word[0], error));
    }
    return fw_lines_fail(lines, error, "the file ends without a section 'Atoms'");
}
