/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_table.c - the observables of a result as comma-separated values. Two lines that begin
 * with # (title and units), one of names, then one per sample. Numbers have the digits that give
 * the same doubles back. Keeps no state. Start reading at fw_command_table(). */
#include "experiments/commands/command.h"
#include "experiments/measures/column.h"
#include "experiments/storage/csv.h"
#include "experiments/study/sweep.h"
#include "experiments/text/text.h"

#include "core/array.h"

#include <stdlib.h>
#include <string.h>

typedef struct table {
    fw_playback *playback;
    int count;
    fw_column *columns;
    int64_t *steps;
    double *times;
    double **values; /* per observable, components next to each other; NULL: in no column */
} table;

static void release(table *t)
{
    for (int o = 0; t->values && o < t->playback->observable_count; ++o) free(t->values[o]);
    free(t->values);
    free(t->times);
    free(t->steps);
    free(t->columns);
    fw_playback_close(t->playback);
}

static fw_status read_values(table *t, fw_error *error)
{
    size_t rows = (size_t)t->playback->sample_count;
    t->steps = fw_array_allocate(rows, sizeof *t->steps);
    t->times = fw_array_of_doubles(rows);
    t->values = calloc((size_t)t->playback->observable_count + 1, sizeof *t->values);
    if (!t->steps || !t->times || !t->values) return fw_fail_memory(error, "a table");
    FW_TRY(fw_playback_read_sample_times(t->playback, t->steps, t->times, error));
    for (int n = 0; n < t->count; ++n) {
        int o = t->columns[n].observable;
        if (t->values[o]) continue;
        t->values[o] = fw_array_of_doubles(rows * (size_t)t->playback->observables[o].components);
        if (!t->values[o]) return fw_fail_memory(error, "a table");
        FW_TRY(fw_playback_read_observable(t->playback, o, t->values[o], error));
    }
    return FW_OK;
}

static void write_head(const table *t, FILE *out)
{
    char name[FW_COLUMN_NAME];
    fputs("# ", out);
    fw_text_print_line(out, t->playback->title);
    const char *time = t->playback->time_physical;
    fprintf(out, "\n# units: steps,time%s%s", time[0] ? " = " : "", time);
    for (int n = 0; n < t->count; ++n) {
        const fw_playback_observable *of = &t->playback->observables[t->columns[n].observable];
        char unit[FW_UNITS_SAID];
        snprintf(unit, sizeof unit, "%s%s%s", of->unit, of->physical[0] ? " = " : "", of->physical);
        fputc(',', out);
        fw_csv_write_text(out, unit);
    }
    fputs("\nstep,time", out);
    for (int n = 0; n < t->count; ++n) {
        fputc(',', out);
        fw_column_name(t->playback, &t->columns[n], name);
        fw_csv_write_text(out, name);
    }
    fputc('\n', out);
}

static void write_table(FILE *out, const void *object)
{
    const table *t = object;
    write_head(t, out);
    for (int64_t row = 0; row < t->playback->sample_count; ++row) {
        fprintf(out, "%lld,%.17g", (long long)t->steps[row], t->times[row]);
        for (int n = 0; n < t->count; ++n) {
            int o = t->columns[n].observable;
            int64_t at = row * t->playback->observables[o].components + t->columns[n].component;
            fputc(',', out);
            fw_csv_write_number(out, t->values[o][at]);
        }
        fputc('\n', out);
    }
}

fw_status fw_command_table(const fw_arguments *arguments, fw_error *error)
{
    const char *directory = arguments->words[0];
    table t = {0};
    char *text;
    const char **names;
    int count;
    FW_TRY(fw_sweep_refuse(directory, error));
    FW_TRY(fw_playback_open(&t.playback, directory, error));
    fw_status status = fw_column_names_read(arguments->observable, &text, &names, &count, error);
    if (status == FW_OK)
        status = fw_columns_find(t.playback, directory, names, count, &t.columns, &t.count, error);
    free(names);
    free(text);
    if (status == FW_OK) status = read_values(&t, error);
    if (status == FW_OK && arguments->output)
        status = fw_csv_save(arguments->output, write_table, &t, error);
    else if (status == FW_OK)
        write_table(stdout, &t);
    release(&t);
    return status;
}
