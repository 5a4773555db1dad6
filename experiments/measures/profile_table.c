/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profile_table.c - the outcome of a study on its way to files and people. Keeps no state. Start
 * reading at fw_profile_table_values(). */
#include "experiments/measures/profile_table.h"

#include "experiments/storage/csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS = sizeof(fw_outcome) / sizeof(double) };

fw_status fw_profile_table_create(fw_profile_table **table, int bin_count, char axis,
                                  fw_error *error)
{
    const size_t cells = (size_t)bin_count * FW_PROFILE_COLUMNS;
    const fw_outcome unknown = {NAN, NAN, NAN, NAN};
    *table = calloc(1, sizeof **table);
    if (!*table) return fw_fail_memory(error, "a table of profiles");
    (*table)->axis = axis;
    (*table)->bin_count = bin_count;
    (*table)->edges = calloc((size_t)bin_count + 1, sizeof *(*table)->edges);
    (*table)->columns = calloc(cells, sizeof *(*table)->columns);
    if (!(*table)->edges || !(*table)->columns) {
        fw_profile_table_destroy(*table);
        *table = NULL;
        return fw_fail_memory(error, "a table of profiles");
    }
    for (size_t n = 0; n < cells; ++n) (*table)->columns[n] = unknown;
    for (int n = 0; n < FW_LAYER_MEASURES; ++n) (*table)->layer[n] = unknown;
    return FW_OK;
}

void fw_profile_table_destroy(fw_profile_table *table)
{
    if (!table) return;
    free(table->edges);
    free(table->columns);
    free(table);
}

/* --- the results file --- */

enum { ARRAYS = 1 + FW_PROFILE_COLUMNS + FW_LAYER_MEASURES };

static fw_trajectory_array array_of(int n, int bin_count)
{
    fw_trajectory_array array = {.rows = bin_count, .columns = PARTS};
    if (n == 0) {
        array = (fw_trajectory_array){.rows = bin_count + 1, .columns = 1};
        snprintf(array.name, sizeof array.name, "profile/edges");
        array.unit = "length";
        array.meaning = "edges of the bins";
    } else if (n <= FW_PROFILE_COLUMNS) {
        const fw_profile_column_row *row = &fw_profile_columns[n - 1];
        snprintf(array.name, sizeof array.name, "profile/%s", row->name);
        array.unit = row->unit;
        array.meaning = row->meaning;
    } else {
        const fw_quantity *quantity = &fw_layer_quantities[n - 1 - FW_PROFILE_COLUMNS];
        snprintf(array.name, sizeof array.name, "layer/%s", quantity->name + strlen("layer-"));
        array.rows = 1;
        array.unit = quantity->unit;
        array.meaning = quantity->meaning;
    }
    return array;
}

fw_status fw_profile_table_arrays(fw_trajectory_array **arrays, int *count, int bin_count,
                                  fw_error *error)
{
    *count = ARRAYS;
    *arrays = calloc(ARRAYS, sizeof **arrays);
    if (!*arrays) return fw_fail_memory(error, "the arrays of a profile");
    for (int n = 0; n < ARRAYS; ++n) (*arrays)[n] = array_of(n, bin_count);
    return FW_OK;
}

static double *values_of(const fw_profile_table *table, int n)
{
    if (n == 0) return table->edges;
    if (n <= FW_PROFILE_COLUMNS)
        return &fw_profile_table_column(table, (fw_profile_column)(n - 1))->mean;
    return (double *)&table->layer[n - 1 - FW_PROFILE_COLUMNS].mean;
}

const double *fw_profile_table_values(const fw_profile_table *table, int n)
{
    return values_of(table, n);
}

fw_status fw_profile_table_read(fw_profile_table **table, fw_playback *playback, char axis,
                                fw_error *error)
{
    int rows = fw_playback_array_rows(playback, "profile/edges", 1);
    *table = NULL;
    FW_TRY(fw_playback_check(playback, error));
    if (rows < 2)
        return fw_fail(error, FW_BAD_INPUT,
                       "the results hold no profile, expected those of a scenario with the key "
                       "'profile'");
    FW_TRY(fw_profile_table_create(table, rows - 1, axis, error));
    fw_status status = FW_OK;
    for (int n = 0; n < ARRAYS && status == FW_OK; ++n) {
        const fw_trajectory_array array = array_of(n, rows - 1);
        status = fw_playback_read_array(playback, array.name, array.rows, array.columns,
                                        values_of(*table, n), error);
    }
    if (status == FW_OK) return FW_OK;
    fw_profile_table_destroy(*table);
    *table = NULL;
    return status;
}

/* --- CSV --- */

static void write_csv(FILE *out, const void *object)
{
    const fw_profile_table *table = object;
    fprintf(out, "%c_from,%c_until", table->axis, table->axis);
    for (int c = 0; c < FW_PROFILE_COLUMNS; ++c) {
        const char *name = fw_profile_columns[c].name;
        fprintf(out, ",%s,%s error,control %s,control %s error", name, name, name, name);
    }
    fprintf(out, "\n");
    for (int b = 0; b < table->bin_count; ++b) {
        fprintf(out, "%.17g,%.17g", table->edges[b], table->edges[b + 1]);
        for (int c = 0; c < FW_PROFILE_COLUMNS; ++c) {
            const fw_outcome *o = &fw_profile_table_column(table, (fw_profile_column)c)[b];
            const double numbers[PARTS] = {o->mean, o->error, o->control, o->control_error};
            for (int n = 0; n < PARTS; ++n) {
                fputc(',', out);
                fw_csv_write_number(out, numbers[n]);
            }
        }
        fprintf(out, "\n");
    }
}

fw_status fw_profile_table_write(const fw_profile_table *table, const char *directory,
                                 const char *name, fw_error *error)
{
    return fw_csv_keep(directory, name, write_csv, table, error);
}

/* --- for people --- */

/* To the second digit of the error: "976 +- 50", "1.573 +- 0.018". */
static void write_with_error(char *text, size_t size, double mean, double error)
{
    const double largest = fmax(fabs(mean), error);
    if (!(error > 0) || largest < 1e-4 || largest >= 1e7) {
        snprintf(text, size, "%.4g +- %.2g", mean, error);
        return;
    }
    const int places = 1 - (int)floor(log10(error));
    const int shown = places < 0 ? 0 : places > 9 ? 9 : places;
    snprintf(text, size, "%.*f +- %.*f", shown, mean, shown, error);
}

static void print_number(FILE *out, double mean, double error)
{
    char text[40];
    if (isnan(mean))
        snprintf(text, sizeof text, "-");
    else if (isnan(error) || isinf(error))
        snprintf(text, sizeof text, "%.4g", mean);
    else
        write_with_error(text, sizeof text, mean, error);
    fprintf(out, "  %-20s", text);
}

enum { UNIT_TEXT = FW_PHYSICAL_TEXT + 32 };

/* "force", or "force = 4.328 pN". */
static const char *say_unit(char text[UNIT_TEXT], const fw_units *units, const char *unit)
{
    char physical[FW_PHYSICAL_TEXT];
    fw_units_print(physical, units, unit, 4);
    snprintf(text, UNIT_TEXT, "%.28s%s%s", unit, physical[0] ? " = " : "", physical);
    return text;
}

static void print_column(const fw_profile_table *table, fw_profile_column column,
                         const fw_units *units, FILE *out)
{
    char unit[UNIT_TEXT];
    const fw_profile_column_row *row = &fw_profile_columns[column];
    fprintf(out, "%s / %s: %s\n", row->name, say_unit(unit, units, row->unit), row->meaning);
    fprintf(out, "%8c  %-20s  %-20s\n", table->axis, "experiment", "control");
    for (int b = 0; b < table->bin_count; ++b) {
        const fw_outcome *o = &fw_profile_table_column(table, column)[b];
        if (isnan(o->mean) && isnan(o->control)) continue;
        fprintf(out, "%8.3f", 0.5 * (table->edges[b] + table->edges[b + 1]));
        print_number(out, o->mean, o->error);
        print_number(out, o->control, o->control_error);
        fprintf(out, "\n");
    }
}

static void print_all(const fw_profile_table *table, FILE *out)
{
    fprintf(out, "%8c", table->axis);
    for (int c = 0; c < FW_PROFILE_COLUMNS; ++c)
        fprintf(out, "  %-20s", fw_profile_columns[c].name);
    fprintf(out, "\n");
    for (int b = 0; b < table->bin_count; ++b) {
        if (isnan(fw_profile_table_column(table, FW_PROFILE_RETURN_FORCE)[b].mean)) continue;
        fprintf(out, "%8.3f", 0.5 * (table->edges[b] + table->edges[b + 1]));
        for (int c = 0; c < FW_PROFILE_COLUMNS; ++c) {
            const fw_outcome *o = &fw_profile_table_column(table, (fw_profile_column)c)[b];
            print_number(out, o->mean, o->error);
        }
        fprintf(out, "\n");
    }
}

void fw_profile_table_print(const fw_profile_table *table, fw_profile_column column,
                            const fw_units *units, FILE *out)
{
    const int width = units && fw_units_given(units) ? 26 : 12;
    if (column == FW_PROFILE_COLUMNS)
        print_all(table, out);
    else
        print_column(table, column, units, out);
    fprintf(out, "\n%-40s  %-20s  %-20s  %-*s  %s\n", "layer", "experiment", "control", width,
            "unit", "meaning");
    for (int n = 0; n < FW_LAYER_MEASURES; ++n) {
        const fw_quantity *quantity = &fw_layer_quantities[n];
        fprintf(out, "%-40s", quantity->name);
        print_number(out, table->layer[n].mean, table->layer[n].error);
        print_number(out, table->layer[n].control, table->layer[n].control_error);
        char unit[UNIT_TEXT];
        fprintf(out, "  %-*s  %s\n", width, say_unit(unit, units, quantity->unit),
                quantity->meaning);
    }
}
