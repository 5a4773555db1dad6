/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_pictures.c - the pictures of a result, drawn into a page; the table of a sweep. Keeps no
 * state. Start reading at fw_report_pictures(). */
#include "experiments/pictures/plot.h"
#include "experiments/storage/regular_file.h"
#include "experiments/storage/scratch_folder.h"
#include "experiments/study/sweep.h"
#include "experiments/text/base64.h"
#include "plot_choice.h"
#include "report_parts.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A drawing of more bytes is kept as points. */
enum { DRAWING_MAX = 400000, PICTURE_MAX = 1 << 28 };

/* Letters of `begin` and of the bytes; to be freed, NULL without memory. */
static char *letters_of(const char *begin, const void *bytes, size_t count)
{
    char *text = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&text, &size);
    if (!memory) return NULL;
    fputs(begin, memory);
    fw_base64 letters = fw_base64_begin(memory);
    fw_base64_write(&letters, bytes, count);
    fw_base64_end(&letters);
    if (fclose(memory) == 0) return text;
    free(text);
    return NULL;
}

fw_status fw_report_bytes(fw_json *json, const char *key, const void *bytes, size_t count,
                          fw_error *error)
{
    char *text = letters_of("", bytes, count);
    if (!text) return fw_fail_memory(error, "a report");
    fw_json_text(json, key, text);
    free(text);
    return FW_OK;
}

/* Draws one picture as a file and reads it. */
static fw_status draw(const char *directory, const char *name, const char *file, FILE *nowhere,
                      char **bytes, size_t *size, fw_error *error)
{
    const fw_plot_wish wish = {.file = file, .picture = name};
    FW_TRY(fw_plot_one(directory, &wish, nowhere, error));
    return fw_regular_file_read(bytes, size, file, PICTURE_MAX, error);
}

static fw_status write_picture(fw_json *json, const char *directory,
                               const fw_scenario_picture *picture, const char *folder,
                               FILE *nowhere, fw_error *error)
{
    char svg[FW_PATH_SIZE + 16], png[FW_PATH_SIZE + 16], *bytes = NULL;
    const char *begin = "data:image/svg+xml;base64,";
    size_t size = 0;
    snprintf(svg, sizeof svg, "%s/picture.svg", folder);
    snprintf(png, sizeof png, "%s/picture.png", folder);
    fw_status status = draw(directory, picture->name, svg, nowhere, &bytes, &size, error);
    if (status == FW_OK && size > DRAWING_MAX) {
        free(bytes);
        bytes = NULL;
        begin = "data:image/png;base64,";
        status = draw(directory, picture->name, png, nowhere, &bytes, &size, error);
    }
    if (status == FW_OK) {
        char *image = letters_of(begin, bytes, size);
        if (!image) status = fw_fail_memory(error, "a picture of a report");
        fw_json_begin(json, NULL, '{');
        fw_json_text(json, "title", picture->title ? picture->title : picture->name);
        if (image) fw_json_text(json, "image", image);
        fw_json_end(json, '}');
        free(image);
    }
    free(bytes);
    unlink(svg);
    unlink(png);
    return status;
}

fw_status fw_report_pictures(fw_json *json, const char *directory, const fw_scenario *scenario,
                             fw_error *error)
{
    char folder[FW_PATH_SIZE];
    const bool sweep = fw_scenario_is_sweep(scenario);
    fw_status status = FW_OK;
    FW_TRY(fw_scratch_folder_make(folder, "report", error));
    FILE *nowhere = fopen("/dev/null", "w");
    if (!nowhere)
        status = fw_fail(error, FW_SYSTEM_FAILED, "cannot open /dev/null: %s", strerror(errno));
    fw_json_begin(json, "pictures", '[');
    for (int n = 0; n < scenario->picture_count && status == FW_OK; ++n)
        if (fw_plot_is_of_case(&scenario->pictures[n]) != sweep)
            status = write_picture(json, directory, &scenario->pictures[n], folder, nowhere, error);
    fw_json_end(json, ']');
    if (nowhere) fclose(nowhere);
    rmdir(folder);
    return status;
}

/* --- the table of a sweep --- */

static void write_heading(fw_json *json, const char *name, const char *unit)
{
    fw_json_begin(json, NULL, '{');
    fw_json_text(json, "name", name);
    fw_json_text(json, "unit", unit);
    fw_json_end(json, '}');
}

static void write_row(fw_json *json, const fw_sweep_table *table, int row)
{
    fw_json_begin(json, NULL, '{');
    fw_json_begin(json, "cells", '[');
    for (int a = 0; a < table->axis_count; ++a)
        fw_json_number(json, NULL, table->values[row * table->axis_count + a]);
    for (int c = 0; c < table->column_count; ++c)
        fw_json_number(json, NULL, table->columns[c].mean[row]);
    fw_json_end(json, ']');
    fw_json_begin(json, "errors", '[');
    for (int a = 0; a < table->axis_count; ++a) fw_json_number(json, NULL, 0);
    for (int c = 0; c < table->column_count; ++c)
        fw_json_number(json, NULL, table->columns[c].error[row]);
    fw_json_end(json, ']');
    if (table->failures && table->failures[row])
        fw_json_text(json, "failure", table->failures[row]);
    fw_json_end(json, '}');
}

fw_status fw_report_table(fw_json *json, const char *directory, const fw_scenario *scenario,
                          fw_error *error)
{
    fw_sweep_table table;
    FW_TRY(fw_sweep_table_read(&table, directory, scenario->study.sweep.parameter_count, error));
    fw_json_begin(json, "table", '{');
    fw_json_begin(json, "head", '[');
    for (int a = 0; a < table.axis_count; ++a)
        write_heading(json, table.axes[a].name, table.axes[a].unit);
    for (int c = 0; c < table.column_count; ++c)
        write_heading(json, table.columns[c].name, table.columns[c].unit);
    fw_json_end(json, ']');
    fw_json_begin(json, "rows", '[');
    for (int row = 0; row < table.row_count; ++row) write_row(json, &table, row);
    fw_json_end(json, ']');
    fw_json_end(json, '}');
    fw_sweep_table_clear(&table);
    return FW_OK;
}
