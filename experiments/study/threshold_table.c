/* SPDX-License-Identifier: GPL-3.0-or-later */
/* threshold_table.c - thresholds on their way back from their file. Keeps no state. */
#include "experiments/study/threshold_table.h"

#include "experiments/storage/csv.h"
#include "experiments/storage/manifest.h"
#include "experiments/text/text.h"
#include "sweep_threshold.h"

#include <stdlib.h>
#include <string.h>

static bool read_row(char *line, int axis_count, fw_threshold_row *row)
{
    enum { BEFORE = 2, BEHIND = 3, CELLS_MAX = BEFORE + FW_PARAMETERS_MAX + BEHIND };
    char *cell[CELLS_MAX];
    const int count = BEFORE + axis_count + BEHIND;
    for (int n = 0; n < count; ++n) {
        if (!line) return false;
        line = fw_csv_cut(line, &cell[n]);
    }
    if (line) return false;
    snprintf(row->quantity, sizeof row->quantity, "%s", cell[0]);
    row->level = fw_csv_read_number(cell[1]);
    for (int a = 0; a < axis_count; ++a) row->values[a] = fw_csv_read_number(cell[BEFORE + a]);
    row->error = fw_csv_read_number(cell[BEFORE + axis_count]);
    row->seeds = (int)fw_csv_read_number(cell[BEFORE + axis_count + 1]);
    return true;
}

fw_status fw_threshold_table_read(fw_threshold_row **rows, int *count, const char *directory,
                                  int axis_count, fw_error *error)
{
    char *text, *rest;
    size_t size, lines = 0;
    *rows = NULL;
    *count = 0;
    FW_TRY(fw_manifest_read(&text, &size, directory, FW_THRESHOLDS_FILE, error));
    for (const char *c = text; *c; ++c) lines += *c == '\n';
    *rows = calloc(lines + 1, sizeof **rows);
    rest = text;
    bool fine = *rows && fw_text_line(&rest);
    for (char *line; fine && (line = fw_text_line(&rest));)
        fine = read_row(line, axis_count, &(*rows)[(*count)++]);
    free(text);
    if (fine) return FW_OK;
    const bool memory = *rows == NULL;
    free(*rows);
    *rows = NULL;
    *count = 0;
    if (memory) return fw_fail_memory(error, "the thresholds of a sweep");
    return fw_fail(error, FW_BAD_INPUT,
                   "%s/" FW_THRESHOLDS_FILE " does not hold the thresholds of a sweep", directory);
}
