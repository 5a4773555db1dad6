/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_seeds.c - the numbers of single seeds, collected from the cases' own tables. Keeps no state
 * but what its caller holds. Start reading at fw_sweep_seeds_collect(). */
#include "sweep_seeds.h"

#include "experiments/storage/csv.h"
#include "experiments/storage/folder.h"
#include "experiments/storage/manifest.h"
#include "experiments/study/study.h"
#include "experiments/study/summary.h"
#include "experiments/text/number.h"
#include "experiments/text/text.h"
#include "sweep_outcome.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double *column_of(const fw_sweep_seeds *seeds, const char *name)
{
    for (int c = 0; c < seeds->table->column_count; ++c)
        if (strcmp(seeds->table->columns[c].name, name) == 0) return seeds->columns[c];
    return NULL;
}

static fw_status create(fw_sweep_seeds *seeds, const fw_sweep_table *table,
                        const fw_scenario *sweep, fw_error *error)
{
    *seeds = (fw_sweep_seeds){.table = table,
                              .seed_count = (int)sweep->study.seeds,
                              .row_count = table->row_count * (int)sweep->study.seeds,
                              .first = sweep->run.seed};
    seeds->columns = calloc((size_t)table->column_count + 1, sizeof *seeds->columns);
    bool fine = seeds->columns != NULL;
    for (int c = 0; fine && c < table->column_count; ++c) {
        seeds->columns[c] = fw_array_of_doubles((size_t)seeds->row_count);
        fine = seeds->columns[c] != NULL;
        for (int r = 0; fine && r < seeds->row_count; ++r) seeds->columns[c][r] = NAN;
    }
    return fine ? FW_OK : fw_fail_memory(error, "the seeds of a sweep");
}

void fw_sweep_seeds_clear(fw_sweep_seeds *seeds)
{
    for (int c = 0; seeds->columns && c < seeds->table->column_count; ++c) free(seeds->columns[c]);
    free(seeds->columns);
    *seeds = (fw_sweep_seeds){0};
}

/* --- from the folders of cases --- */

static fw_status read_expectations(fw_sweep_seeds *seeds, const fw_sweep_case *c, int number,
                                   const char *path, fw_error *error)
{
    const size_t count = (size_t)seeds->seed_count;
    double *values = fw_array_of_doubles((size_t)c->verdicts.count * count);
    if (!values) return fw_fail_memory(error, "the seeds of a sweep");
    const fw_status status = fw_summary_read_seeds(path, c->scenario, values, error);
    for (int k = 0; status == FW_OK && k < c->verdicts.count; ++k) {
        char name[FW_SWEEP_NAME];
        fw_sweep_outcome_name(&c->verdicts.item[k], name);
        double *column = column_of(seeds, name);
        if (column)
            memcpy(column + (size_t)number * count, values + (size_t)k * count,
                   count * sizeof *values);
    }
    free(values);
    return status;
}

/* Rows of the experiment, in the order of the seeds, before those of the control. */
static bool read_layer_rows(fw_sweep_seeds *seeds, int number, char *text)
{
    char *names = fw_text_line(&text), *name, *cell;
    double *columns[FW_LAYER_MEASURES];
    if (!names) return false;
    names = fw_csv_cut(names, &name);
    names = names ? fw_csv_cut(names, &name) : NULL;
    for (int m = 0; m < FW_LAYER_MEASURES; ++m) {
        if (!names) return false;
        names = fw_csv_cut(names, &name);
        columns[m] = column_of(seeds, name);
    }
    for (int n = 0; n < seeds->seed_count; ++n) {
        char *line = fw_text_line(&text);
        for (int k = 0; k < 2 && line; ++k) line = fw_csv_cut(line, &cell);
        for (int m = 0; m < FW_LAYER_MEASURES; ++m) {
            if (!line) return false;
            line = fw_csv_cut(line, &cell);
            if (columns[m]) columns[m][number * seeds->seed_count + n] = fw_csv_read_number(cell);
        }
    }
    return true;
}

static fw_status read_layer(fw_sweep_seeds *seeds, int number, const char *path, fw_error *error)
{
    char *text;
    size_t size;
    FW_TRY(fw_manifest_read(&text, &size, path, FW_LAYER_FILE, error));
    const bool fine = read_layer_rows(seeds, number, text);
    free(text);
    if (fine) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "%s/" FW_LAYER_FILE " does not hold the layers of %d seeds",
                   path, seeds->seed_count);
}

fw_status fw_sweep_seeds_collect(fw_sweep_seeds *seeds, const fw_sweep_table *table,
                                 const fw_scenario *sweep, const fw_sweep_case *cases,
                                 const char *directory, fw_error *error)
{
    char path[FW_PATH_SIZE];
    FW_TRY(create(seeds, table, sweep, error));
    for (int n = 0; n < table->row_count; ++n) {
        if (cases[n].failure.status != FW_OK) continue;
        FW_TRY(fw_path_join(path, directory, cases[n].name, error));
        FW_TRY(read_expectations(seeds, &cases[n], n, path, error));
        if (cases[n].scenario->profile.every != 0) FW_TRY(read_layer(seeds, n, path, error));
    }
    return FW_OK;
}

/* --- the table --- */

typedef struct titled {
    const fw_sweep_seeds *seeds;
    const char *title;
} titled;

static void write_row(FILE *out, const fw_sweep_seeds *seeds, int row)
{
    const fw_sweep_table *table = seeds->table;
    const double *point = table->values + row / seeds->seed_count * table->axis_count;
    for (int a = 0; a < table->axis_count; ++a) {
        char value[FW_NUMBER_TEXT];
        fw_number_write(value, point[a]);
        fprintf(out, "%s,", value);
    }
    fprintf(out, "%lld", (long long)(seeds->first + row % seeds->seed_count));
    for (int c = 0; c < table->column_count; ++c) {
        fputc(',', out);
        fw_csv_write_number(out, seeds->columns[c][row]);
    }
    fputc('\n', out);
}

static void write(FILE *out, const void *object)
{
    const titled *what = object;
    const fw_sweep_table *table = what->seeds->table;
    fputs("# ", out);
    fw_text_print_line(out, what->title);
    fputs("\n# units: ", out);
    for (int a = 0; a < table->axis_count; ++a) {
        fw_sweep_table_write_unit(out, table, table->axes[a].unit);
        fputc(',', out);
    }
    for (int c = 0; c < table->column_count; ++c) {
        fputc(',', out);
        fw_sweep_table_write_unit(out, table, table->columns[c].unit);
    }
    fputc('\n', out);
    for (int a = 0; a < table->axis_count; ++a) fprintf(out, "%s,", table->axes[a].name);
    fputs("seed", out);
    for (int c = 0; c < table->column_count; ++c) {
        fputc(',', out);
        fw_csv_write_text(out, table->columns[c].name);
    }
    fputc('\n', out);
    for (int r = 0; r < what->seeds->row_count; ++r) write_row(out, what->seeds, r);
}

fw_status fw_sweep_seeds_write(const fw_sweep_seeds *seeds, const char *title,
                               const char *directory, fw_error *error)
{
    return fw_csv_keep(directory, FW_SEEDS_FILE, write, &(titled){seeds, title}, error);
}
