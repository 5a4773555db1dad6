/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep.c - the table of a sweep as panels above the axis of its parameter.
 * Keeps no state. Start reading at draw(). */
#include "plot_sweep.h"

#include "plot_choice.h"

#include "experiments/drawing/figure.h"
#include "experiments/drawing/label.h"
#include "experiments/storage/manifest.h"
#include "experiments/study/sweep.h"
#include "experiments/text/spelling.h"

#include "core/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PANELS_MAX = 32 };

/* A sweep that is drawn. */
typedef struct sweep_result {
    const char *directory;
    fw_scenario *scenario;
    fw_sweep_table table;
} sweep_result;

/* Numbers of one panel in the order of the parameter. */
typedef struct panel_data {
    char label[FW_SWEEP_NAME + 80];
    const char *part;            /* what of the quantity; "": there is only one part */
    const fw_quantity *quantity; /* of it; NULL: not known */
    double *mean, *error, *open, *expected, *within; /* one piece of memory */
    fw_curve curves[2];
} panel_data;

typedef struct drawing {
    const sweep_result *result;
    double *x;
    int *order; /* rows of the table by the parameter */
    int count;
    panel_data panels[PANELS_MAX];
    fw_chart charts[PANELS_MAX];
    bool expected; /* any panel shows what was expected */
    bool open;     /* any error is a lower bound */
} drawing;

/* --- the sweep --- */

static fw_status open_sweep(sweep_result *result, const char *directory, fw_error *error)
{
    fw_folder *folder;
    *result = (sweep_result){.directory = directory};
    FW_TRY(fw_folder_visit(&folder, directory, error));
    const bool finished = fw_folder_has(folder, FW_SWEEP_FILE);
    fw_folder_close(folder);
    if (!finished)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: the sweep is not finished; `fretwork resume %s` goes on with it",
                       directory, directory);
    FW_TRY(fw_sweep_load(&result->scenario, directory, error));
    return fw_sweep_table_read(&result->table, directory, error);
}

static void close_sweep(sweep_result *result)
{
    fw_sweep_table_clear(&result->table);
    fw_scenario_destroy(result->scenario);
}

/* --- which columns --- */

/* "momentum-error.sheet x, largest" is of the quantity momentum-error. */
static bool is_of(const fw_sweep_column *column, const char *quantity)
{
    const size_t length = strlen(quantity);
    return strncmp(column->name, quantity, length) == 0 &&
           (column->name[length] == '\0' || strchr(" .,", column->name[length]));
}

static const fw_quantity *quantity_of(const fw_sweep_column *column)
{
    char name[FW_SWEEP_NAME];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(column->name, " .,"), column->name);
    return fw_quantity_find(name);
}

static bool add_panels(drawing *d, const char *quantity, int columns[PANELS_MAX])
{
    const fw_sweep_table *table = &d->result->table;
    bool found = false;
    for (int c = 0; c < table->column_count; ++c) {
        bool there = false;
        if (!is_of(&table->columns[c], quantity)) continue;
        found = true;
        for (int p = 0; p < d->count; ++p) there = there || columns[p] == c;
        if (!there && d->count < PANELS_MAX) columns[d->count++] = c;
    }
    return found;
}

static fw_status refuse_quantity(const sweep_result *result, const char *name, fw_error *error)
{
    const fw_sweep_table *table = &result->table;
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (int c = 0; c < table->column_count; ++c) {
        const fw_quantity *quantity = quantity_of(&table->columns[c]);
        if (quantity) fw_suggestion_offer(&suggestion, quantity->name);
    }
    if (suggestion.best)
        return fw_fail(error, FW_BAD_INPUT, "%s: the sweep has no %s; did you mean %s?",
                       result->directory, name, suggestion.best);
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: the sweep has no %s, expected a quantity in " FW_SWEEP_FILE,
                   result->directory, name);
}

/* Those of the wish, else of the picture, else what is expected, else everything. */
static fw_status choose_columns(drawing *d, const fw_plot_wish *wish,
                                const fw_scenario_picture *own, int columns[PANELS_MAX],
                                fw_error *error)
{
    const sweep_result *result = d->result;
    const fw_scenario *scenario = result->scenario;
    for (int n = 0; n < wish->observable_count; ++n)
        if (!add_panels(d, wish->observables[n], columns))
            return refuse_quantity(result, wish->observables[n], error);
    for (int n = 0; wish->observable_count == 0 && own && n < own->observables.count; ++n)
        if (!add_panels(d, own->observables.item[n].text, columns))
            return refuse_quantity(result, own->observables.item[n].text, error);
    if (wish->observable_count > 0 || (own && own->observables.count > 0)) return FW_OK;
    for (int n = 0; n < scenario->expectation_count; ++n)
        add_panels(d, scenario->expectations[n].quantity.text, columns);
    for (int c = 0; c < result->table.column_count && scenario->expectation_count == 0; ++c)
        add_panels(d, result->table.columns[c].name, columns);
    return FW_OK;
}

/* --- panels --- */

static fw_status order_rows(drawing *d, fw_error *error)
{
    const fw_sweep_table *table = &d->result->table;
    const size_t count = (size_t)table->value_count;
    d->x = fw_array_of_doubles(count);
    d->order = calloc(count, sizeof *d->order);
    if (!d->x || !d->order) return fw_fail_memory(error, "a picture of a sweep");
    for (int v = 0; v < table->value_count; ++v) {
        int at = v;
        for (; at > 0 && d->x[at - 1] > table->values[v]; --at) {
            d->x[at] = d->x[at - 1];
            d->order[at] = d->order[at - 1];
        }
        d->x[at] = table->values[v];
        d->order[at] = v;
    }
    return FW_OK;
}

/* "kinetic fraction", "layer contact (force)" beside the axis: words in place of the name, and the
 * unit where that says more. What of it is drawn, "sheet, minimum", would be too long there. */
static void name_panel(panel_data *panel, const fw_sweep_column *column)
{
    char quantity[FW_SWEEP_NAME];
    const size_t length = strcspn(column->name, " .,");
    snprintf(quantity, sizeof quantity, "%.*s", (int)length, column->name);
    fw_label_print(panel->label, sizeof panel->label, quantity, column->unit);
    panel->part = column->name + length + strspn(column->name + length, " .,");
}

static fw_status fill_panel(drawing *d, int number, const fw_sweep_column *column, bool logarithmic,
                            fw_error *error)
{
    panel_data *panel = &d->panels[number];
    const int count = d->result->table.value_count;
    bool expected = false;
    panel->mean = fw_array_of_doubles(5 * (size_t)count);
    if (!panel->mean) return fw_fail_memory(error, "a picture of a sweep");
    panel->error = panel->mean + count;
    panel->open = panel->error + count;
    panel->expected = panel->open + count;
    panel->within = panel->expected + count;
    for (int k = 0; k < count; ++k) {
        const int row = d->order[k];
        panel->mean[k] = column->mean[row];
        panel->error[k] = isfinite(column->error[row]) ? column->error[row] : 0;
        panel->open[k] = column->at_least[row];
        d->open = d->open || panel->open[k] != 0;
        panel->expected[k] = column->expected[row];
        panel->within[k] = isfinite(column->within[row]) ? column->within[row] : 0;
        expected = expected || isfinite(panel->expected[k]);
    }
    name_panel(panel, column);
    panel->quantity = quantity_of(column);
    d->expected = d->expected || expected;
    panel->curves[0] = (fw_curve){.label = panel->part[0] ? panel->part
                                           : expected     ? "measured"
                                                          : NULL,
                                  .count = count,
                                  .x = d->x,
                                  .y = panel->mean,
                                  .error = panel->error,
                                  .open = panel->open,
                                  .look = FW_CURVE_LINE_AND_MARKERS,
                                  .colour = 1};
    panel->curves[1] = (fw_curve){.label = "expected",
                                  .count = count,
                                  .x = d->x,
                                  .y = panel->expected,
                                  .error = panel->within,
                                  .look = FW_CURVE_MARKERS,
                                  .colour = FW_CURVE_GREY};
    d->charts[number] = (fw_chart){.label = panel->label,
                                   .curves = panel->curves,
                                   .curve_count = expected ? 2 : 1,
                                   .logarithmic = logarithmic};
    return FW_OK;
}

static void clear_drawing(drawing *d)
{
    for (int p = 0; p < d->count; ++p) free(d->panels[p].mean);
    free(d->x);
    free(d->order);
    free(d);
}

static fw_status fill(drawing *d, const fw_plot_wish *wish, const fw_scenario_picture *own,
                      fw_error *error)
{
    int columns[PANELS_MAX];
    FW_TRY(choose_columns(d, wish, own, columns, error));
    FW_TRY(order_rows(d, error));
    const bool logarithmic = wish->logarithmic || (own && own->logarithmic);
    for (int p = 0; p < d->count; ++p)
        FW_TRY(fill_panel(d, p, &d->result->table.columns[columns[p]], logarithmic, error));
    return FW_OK;
}

/* --- the picture --- */

/* What a quantity means, where it says so by itself: "the same far from it" does not. */
static void explain(const fw_quantity *quantity, char *caption, size_t size)
{
    const size_t used = strlen(caption);
    if (!quantity || strncmp(quantity->meaning, "the ", 4) == 0) return;
    if (strstr(caption, quantity->meaning)) return;
    snprintf(caption + used, size - used, "%s: %s. ", quantity->name, quantity->meaning);
}

static fw_status draw_panels(const drawing *d, const char *file, const char *title, fw_error *error)
{
    const fw_sweep_table *table = &d->result->table;
    const int64_t seeds = d->result->scenario->study.seeds;
    char label[FW_NAME_BYTES + 80], caption[2048] = "";
    fw_page page = fw_page_default();
    fw_label_print(label, sizeof label, table->parameter, table->unit);
    for (int p = 0; p < d->count; ++p) explain(d->panels[p].quantity, caption, sizeof caption);
    const size_t used = strlen(caption);
    snprintf(caption + used, sizeof caption - used, "%s%s%sReduced units.",
             seeds > 1 ? "Means over the seeds, with standard errors as bars. " : "",
             d->open ? "Dotted bars: the series is too short for its correlation, the error is a "
                       "lower bound. "
                     : "",
             d->expected ? "Grey: what is expected, with its tolerance as a bar. " : "");
    page.title = title;
    page.caption = caption;
    page.file = file;
    return fw_figure_series(&page, d->charts, d->count, label, NULL, 0, error);
}

static fw_status draw(const sweep_result *result, const fw_plot_wish *wish,
                      const fw_scenario_picture *own, FILE *out, fw_error *error)
{
    char path[FW_PATH_SIZE], name[FW_NAME_BYTES + 8];
    snprintf(name, sizeof name, "%.*s.png", FW_NAME_BYTES, own ? own->name : "sweep");
    FW_TRY(fw_path_join(path, result->directory, name, error));
    const char *file = wish->file ? wish->file : path;
    drawing *d = calloc(1, sizeof *d);
    if (!d) return fw_fail_memory(error, "a picture of a sweep");
    d->result = result;
    fw_status status = fill(d, wish, own, error);
    if (status == FW_OK)
        status =
            draw_panels(d, file, own && own->title ? own->title : result->scenario->title, error);
    if (status == FW_OK && !wish->file) status = fw_manifest_enter(result->directory, name, error);
    if (status == FW_OK) fprintf(out, "picture: %s\n", file);
    clear_drawing(d);
    return status;
}

/* The scenario's picture that is wished for; NULL: none is. */
static fw_status find_picture(const sweep_result *result, const fw_plot_wish *wish,
                              const fw_scenario_picture **own, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    *own = NULL;
    for (int n = 0; n < scenario->picture_count; ++n) {
        const fw_scenario_picture *picture = &scenario->pictures[n];
        if (wish->picture ? strcmp(picture->name, wish->picture) != 0
                          : picture->kind != FW_PICTURE_SWEEP)
            continue;
        *own = picture;
        if (picture->kind == FW_PICTURE_SWEEP) return FW_OK;
        break;
    }
    if (!wish->picture) return FW_OK;
    if (!*own)
        return fw_fail(error, FW_BAD_INPUT, "%s has no picture %s", result->directory,
                       wish->picture);
    char name[FW_CASE_NAME];
    fw_scenario_case_name(scenario, 0, name);
    return fw_fail(error, FW_BAD_INPUT,
                   "%s holds a sweep, and the picture %s is one of its cases: `fretwork plot "
                   "%s/%s --picture %s`",
                   result->directory, wish->picture, result->directory, name, wish->picture);
}

static fw_status check_wish(const char *directory, const fw_plot_wish *wish, fw_error *error)
{
    if (wish->picture && wish->kind)
        return fw_fail(error, FW_BAD_INPUT,
                       "both the picture %s and the kind %s, expected one of the two",
                       wish->picture, wish->kind);
    if (wish->kind && strcmp(wish->kind, "sweep") != 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s holds a sweep; pictures of kind %s are drawn in the folders of its "
                       "cases, here those of kind sweep",
                       directory, wish->kind);
    const char *stray = wish->field ? "a field" : wish->step_count > 0 ? "steps" : NULL;
    if (!stray) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT, "a picture of kind sweep does not draw %s", stray);
}

fw_status fw_plot_sweep_one(const char *directory, const fw_plot_wish *wish, FILE *out,
                            fw_error *error)
{
    sweep_result result;
    const fw_scenario_picture *own;
    FW_TRY(check_wish(directory, wish, error));
    fw_status status = open_sweep(&result, directory, error);
    if (status == FW_OK) status = find_picture(&result, wish, &own, error);
    if (status == FW_OK) status = draw(&result, wish, own, out, error);
    close_sweep(&result);
    return status;
}

/* The pictures of single runs, in the folder of each case. One case that fails does not keep the
 * others from being drawn. */
static fw_status draw_cases(const sweep_result *result, FILE *out, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    fw_status status = FW_OK;
    bool any = false;
    for (int n = 0; n < scenario->picture_count; ++n)
        any |= fw_plot_is_of_case(&scenario->pictures[n]);
    for (int n = 0; any && n < scenario->study.sweep.value_count; ++n) {
        char name[FW_CASE_NAME], folder[FW_PATH_SIZE];
        fw_error own = {0};
        fw_scenario_case_name(scenario, n, name);
        fw_status done = fw_path_join(folder, result->directory, name, &own);
        if (done == FW_OK) done = fw_plot_all(folder, out, &own);
        if (status == FW_OK && done != FW_OK) *error = own;
        if (status == FW_OK) status = done;
    }
    return status;
}

fw_status fw_plot_sweep_all(const char *directory, FILE *out, fw_error *error)
{
    sweep_result result;
    fw_status status = open_sweep(&result, directory, error);
    int drawn = 0;
    for (int n = 0; status == FW_OK && n < result.scenario->picture_count; ++n) {
        if (result.scenario->pictures[n].kind != FW_PICTURE_SWEEP) continue;
        status = draw(&result, &(fw_plot_wish){0}, &result.scenario->pictures[n], out, error);
        drawn += 1;
    }
    if (status == FW_OK && drawn == 0) status = draw(&result, &(fw_plot_wish){0}, NULL, out, error);
    if (status == FW_OK) status = draw_cases(&result, out, error);
    close_sweep(&result);
    return status;
}

fw_status fw_plot_draw_sweep(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error)
{
    (void)picture;
    return fw_fail(error, FW_BAD_INPUT,
                   "%s holds a single run, and pictures of kind sweep are drawn in the folder of a "
                   "sweep",
                   result->directory);
}
