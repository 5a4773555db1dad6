/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_table.c - the outcome of a sweep on its way to its file and back.
 * Invariant: a column has a number, or NaN, for every case. State: fw_sweep_table, the caller's.
 * Start reading at part_of(), which says how a column lies in memory. */
#include "experiments/study/sweep_table.h"

#include "experiments/results/trajectory.h"
#include "experiments/storage/csv.h"
#include "experiments/storage/manifest.h"
#include "experiments/text/number.h"
#include "experiments/text/text.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEAN, ERROR, AT_LEAST, EXPECTED, WITHIN, PARTS };
static const char *const part_names[PARTS] = {"", " error", " error is lower bound", " expected",
                                              " within"};

/* How many values the parameters have in all rows together. */
static size_t value_count(const fw_sweep_table *table)
{
    return (size_t)table->row_count * (size_t)table->axis_count;
}

fw_status fw_sweep_table_create(fw_sweep_table *table, const fw_scenario_sweep *sweep,
                                int seed_count, fw_error *error)
{
    *table = (fw_sweep_table){.axis_count = sweep->parameter_count,
                              .row_count = sweep->case_count,
                              .seed_count = seed_count};
    for (int a = 0; a < table->axis_count; ++a) {
        const fw_scenario_parameter *parameter = &sweep->parameters[a];
        fw_sweep_axis *axis = &table->axes[a];
        snprintf(axis->name, sizeof axis->name, "%s", parameter->name);
        snprintf(axis->unit, sizeof axis->unit, "%s", parameter->unit ? parameter->unit : "");
    }
    table->values = fw_array_of_doubles(value_count(table));
    table->failures = calloc((size_t)table->row_count + 1, sizeof *table->failures);
    if (!table->values || !table->failures) return fw_fail_memory(error, "the table of a sweep");
    memcpy(table->values, sweep->values, value_count(table) * sizeof *table->values);
    return FW_OK;
}

void fw_sweep_table_clear(fw_sweep_table *table)
{
    for (int c = 0; c < table->column_count; ++c) free(table->columns[c].mean);
    for (int v = 0; table->failures && v < table->row_count; ++v) free(table->failures[v]);
    free(table->columns);
    free(table->failures);
    free(table->values);
    *table = (fw_sweep_table){0};
}

/* All parts of a column share one piece of memory. */
static double *part_of(const fw_sweep_table *table, int column, int part)
{
    return table->columns[column].mean + (size_t)part * (size_t)table->row_count;
}

fw_sweep_column *fw_sweep_table_column(fw_sweep_table *table, const char *name, const char *unit)
{
    for (int c = 0; c < table->column_count; ++c)
        if (strcmp(table->columns[c].name, name) == 0) return &table->columns[c];
    if (table->column_count == table->column_room) {
        const int room = 2 * table->column_room + 16;
        fw_sweep_column *more = realloc(table->columns, (size_t)room * sizeof *more);
        if (!more) return NULL;
        table->columns = more;
        table->column_room = room;
    }
    const size_t cells = PARTS * (size_t)table->row_count;
    fw_sweep_column *made = &table->columns[table->column_count];
    double *numbers = fw_array_of_doubles(cells);
    if (!numbers) return NULL;
    for (size_t n = 0; n < cells; ++n) numbers[n] = NAN;
    for (int v = 0; v < table->row_count; ++v) numbers[AT_LEAST * table->row_count + v] = 0;
    *made = (fw_sweep_column){.mean = numbers,
                              .error = numbers + table->row_count,
                              .at_least = numbers + AT_LEAST * table->row_count,
                              .expected = numbers + EXPECTED * table->row_count,
                              .within = numbers + WITHIN * table->row_count};
    snprintf(made->name, sizeof made->name, "%s", name);
    snprintf(made->unit, sizeof made->unit, "%s", unit);
    table->column_count += 1;
    return made;
}

bool fw_sweep_table_fail(fw_sweep_table *table, int row, const char *reason)
{
    free(table->failures[row]);
    table->failures[row] = strdup(reason);
    return table->failures[row] != NULL;
}

static bool has_failures(const fw_sweep_table *table)
{
    for (int v = 0; v < table->row_count; ++v)
        if (table->failures[v]) return true;
    return false;
}

/* --- writing --- */

#define SEEDS   "seeds"
#define FAILURE "failure"

typedef struct titled {
    const fw_sweep_table *table;
    const char *title;
} titled;

/* Lower bounds, and what was expected, are written of those columns alone of which they are. */
static bool has_part(const fw_sweep_table *table, int column, int part)
{
    const fw_sweep_column *c = &table->columns[column];
    if (part <= ERROR) return true;
    for (int v = 0; v < table->row_count; ++v)
        if (part == AT_LEAST ? c->at_least[v] != 0 : !isnan(c->expected[v])) return true;
    return false;
}

void fw_sweep_table_write_unit(FILE *out, const fw_sweep_table *table, const char *unit)
{
    char said[FW_UNITS_SAID];
    fw_units_say(said, table->units, unit);
    fw_csv_write_text(out, said);
}

static void write_head(FILE *out, const fw_sweep_table *table, const char *title)
{
    char name[FW_SWEEP_NAME + 16];
    fputs("# ", out);
    fw_text_print_line(out, title);
    fputs("\n# units: ", out);
    for (int a = 0; a < table->axis_count; ++a) {
        if (a > 0) fputc(',', out);
        fw_sweep_table_write_unit(out, table, table->axes[a].unit);
    }
    for (int c = 0; c < table->column_count; ++c)
        for (int p = 0; p < PARTS; ++p) {
            if (!has_part(table, c, p)) continue;
            fputc(',', out);
            fw_sweep_table_write_unit(out, table, table->columns[c].unit);
        }
    fputc(',', out);
    if (has_failures(table)) fputc(',', out);
    for (int a = 0; a < table->axis_count; ++a)
        fprintf(out, "%c%s", a > 0 ? ',' : '\n', table->axes[a].name);
    for (int c = 0; c < table->column_count; ++c)
        for (int p = 0; p < PARTS; ++p) {
            if (!has_part(table, c, p)) continue;
            snprintf(name, sizeof name, "%s%s", table->columns[c].name, part_names[p]);
            fputc(',', out);
            fw_csv_write_text(out, name);
        }
    fputs("," SEEDS, out);
    if (has_failures(table)) fputs("," FAILURE, out);
    fputc('\n', out);
}

static void write(FILE *out, const void *object)
{
    const titled *what = object;
    const fw_sweep_table *table = what->table;
    write_head(out, table, what->title);
    for (int v = 0; v < table->row_count; ++v) {
        for (int a = 0; a < table->axis_count; ++a) {
            char value[FW_NUMBER_TEXT];
            fw_number_write(value, table->values[v * table->axis_count + a]);
            fprintf(out, "%s%s", a > 0 ? "," : "", value);
        }
        for (int c = 0; c < table->column_count; ++c)
            for (int p = 0; p < PARTS; ++p) {
                if (!has_part(table, c, p)) continue;
                fputc(',', out);
                fw_csv_write_number(out, part_of(table, c, p)[v]);
            }
        fprintf(out, ",%d", table->seed_count);
        if (has_failures(table)) fputc(',', out);
        if (table->failures[v]) fw_csv_write_text(out, table->failures[v]);
        fputc('\n', out);
    }
}

fw_status fw_sweep_table_write(const fw_sweep_table *table, const char *title,
                               const char *directory, fw_error *error)
{
    return fw_csv_keep(directory, FW_SWEEP_FILE, write, &(titled){table, title}, error);
}

/* --- reading --- */

enum { CELLS_MAX = 4096 };

/* Which column and part of it a cell of each line holds. */
typedef struct layout {
    int count;
    int column[CELLS_MAX], part[CELLS_MAX];
    bool seeds;    /* behind them how many there are */
    bool failures; /* and a reason */
} layout;

/* "energy, mean error" is part 1 of the column "energy, mean", which comes before it. */
static int find_part(const fw_sweep_table *table, const char *name)
{
    if (table->column_count == 0) return 0;
    const char *last = table->columns[table->column_count - 1].name;
    const size_t length = strlen(last);
    if (strncmp(name, last, length) != 0) return 0;
    for (int p = 1; p < PARTS; ++p)
        if (strcmp(name + length, part_names[p]) == 0) return p;
    return 0;
}

/* The unit without what one of it is in nature. */
static char *cut_unit(char *units, char **unit)
{
    char *next = fw_csv_cut(units, unit), *said = strstr(*unit, " = ");
    if (said) *said = '\0';
    return next;
}

/* FW_BAD_INPUT where a table is not as expected, FW_SYSTEM_FAILED without memory. */
static fw_status read_names(fw_sweep_table *table, layout *cells, char *units, char *names)
{
    char *unit, *name;
    for (int a = 0; a < table->axis_count; ++a) {
        if (!names || !units) return FW_BAD_INPUT;
        units = cut_unit(units, &unit);
        snprintf(table->axes[a].unit, sizeof table->axes[a].unit, "%s", unit);
        names = fw_csv_cut(names, &name);
        snprintf(table->axes[a].name, sizeof table->axes[a].name, "%s", name);
    }
    while (names && units && cells->count < CELLS_MAX) {
        units = cut_unit(units, &unit);
        names = fw_csv_cut(names, &name);
        if (strcmp(name, SEEDS) == 0) {
            cells->seeds = true;
            continue;
        }
        if (!names && strcmp(name, FAILURE) == 0) {
            cells->failures = true;
            break;
        }
        const int part = find_part(table, name);
        if (part == 0 && !fw_sweep_table_column(table, name, unit)) return FW_SYSTEM_FAILED;
        cells->column[cells->count] = table->column_count - 1;
        cells->part[cells->count++] = part;
    }
    return !names && !units && cells->seeds ? FW_OK : FW_BAD_INPUT;
}

static fw_status read_values(fw_sweep_table *table, const layout *cells, char *line, int row)
{
    char *cell;
    for (int a = 0; a < table->axis_count; ++a) {
        if (!line) return FW_BAD_INPUT;
        line = fw_csv_cut(line, &cell);
        table->values[row * table->axis_count + a] = fw_number_scan(cell, NULL);
    }
    for (int n = 0; n < cells->count; ++n) {
        if (!line) return FW_BAD_INPUT;
        line = fw_csv_cut(line, &cell);
        part_of(table, cells->column[n], cells->part[n])[row] = fw_csv_read_number(cell);
    }
    if (!line) return FW_BAD_INPUT;
    line = fw_csv_cut(line, &cell);
    table->seed_count = (int)fw_csv_read_number(cell);
    if (!cells->failures) return line ? FW_BAD_INPUT : FW_OK;
    if (!line) return FW_BAD_INPUT;
    line = fw_csv_cut(line, &cell);
    if (line) return FW_BAD_INPUT;
    return !cell[0] || fw_sweep_table_fail(table, row, cell) ? FW_OK : FW_SYSTEM_FAILED;
}

static int count_lines(const char *text)
{
    int count = 0;
    for (; *text; ++text) count += *text == '\n';
    return count;
}

static fw_status read_lines(fw_sweep_table *table, layout *cells, char *text)
{
    static const char units_head[] = "# units: ";
    table->row_count = count_lines(text) - 3;
    fw_text_line(&text);
    char *units = fw_text_line(&text), *names = fw_text_line(&text);
    if (!names || table->row_count <= 0 || strncmp(units, units_head, strlen(units_head)) != 0)
        return FW_BAD_INPUT;
    table->values = fw_array_of_doubles(value_count(table));
    table->failures = calloc((size_t)table->row_count, sizeof *table->failures);
    if (!table->values || !table->failures) return FW_SYSTEM_FAILED;
    fw_status status = read_names(table, cells, units + strlen(units_head), names);
    for (int v = 0; status == FW_OK && v < table->row_count; ++v)
        status = read_values(table, cells, fw_text_line(&text), v);
    return status;
}

fw_status fw_sweep_table_read(fw_sweep_table *table, const char *directory, int axis_count,
                              fw_error *error)
{
    char *text;
    size_t size;
    *table = (fw_sweep_table){.axis_count = axis_count};
    FW_TRY(fw_manifest_read(&text, &size, directory, FW_SWEEP_FILE, error));
    layout *cells = calloc(1, sizeof *cells);
    const fw_status status = cells ? read_lines(table, cells, text) : FW_SYSTEM_FAILED;
    free(cells);
    free(text);
    if (status == FW_OK) return FW_OK;
    fw_sweep_table_clear(table);
    if (status == FW_SYSTEM_FAILED) return fw_fail_memory(error, "the table of a sweep");
    return fw_fail(error, FW_BAD_INPUT, "%s/" FW_SWEEP_FILE " is not the table of a sweep",
                   directory);
}
