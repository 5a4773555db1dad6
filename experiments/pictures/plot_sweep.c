/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot_sweep.c - which picture of a sweep, and of which of its numbers.
 * Keeps no state. Start reading at draw(). */
#include "plot_sweep.h"

#include "plot_choice.h"
#include "plot_sweep_parts.h"

#include "experiments/drawing/label.h"
#include "experiments/storage/manifest.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <string.h>

/* --- the sweep --- */

static fw_status open_sweep(fw_plot_sweep *result, const char *directory, fw_error *error)
{
    fw_folder *folder;
    *result = (fw_plot_sweep){.directory = directory};
    FW_TRY(fw_folder_visit(&folder, directory, error));
    const bool finished = fw_folder_has(folder, FW_SWEEP_FILE);
    fw_folder_close(folder);
    if (!finished)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: the sweep is not finished; `fretwork resume %s` goes on with it",
                       directory, directory);
    FW_TRY(fw_sweep_load(&result->scenario, directory, error));
    return fw_sweep_table_read(&result->table, directory,
                               result->scenario->study.sweep.parameter_count, error);
}

static void close_sweep(fw_plot_sweep *result)
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

static bool add_columns(fw_sweep_choice *choice, const fw_sweep_table *table, const char *quantity)
{
    bool found = false;
    for (int c = 0; c < table->column_count; ++c) {
        bool there = false;
        if (!is_of(&table->columns[c], quantity)) continue;
        found = true;
        for (int p = 0; p < choice->count; ++p) there = there || choice->columns[p] == c;
        if (!there && choice->count < FW_SWEEP_PANELS_MAX) choice->columns[choice->count++] = c;
    }
    return found;
}

static fw_status refuse_quantity(const fw_plot_sweep *result, const char *name, fw_error *error)
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

fw_status fw_plot_sweep_choose(fw_sweep_choice *choice, const fw_plot_sweep *sweep,
                               const fw_plot_wish *wish, const fw_scenario_picture *own,
                               fw_error *error)
{
    const fw_scenario *scenario = sweep->scenario;
    const fw_sweep_table *table = &sweep->table;
    *choice = (fw_sweep_choice){0};
    for (int n = 0; n < wish->observable_count; ++n)
        if (!add_columns(choice, table, wish->observables[n]))
            return refuse_quantity(sweep, wish->observables[n], error);
    for (int n = 0; wish->observable_count == 0 && own && n < own->observables.count; ++n)
        if (!add_columns(choice, table, own->observables.item[n].text))
            return refuse_quantity(sweep, own->observables.item[n].text, error);
    if (wish->observable_count > 0 || (own && own->observables.count > 0)) return FW_OK;
    for (int n = 0; n < scenario->expectation_count; ++n)
        add_columns(choice, table, scenario->expectations[n].quantity.text);
    for (int c = 0; c < table->column_count && scenario->expectation_count == 0; ++c)
        add_columns(choice, table, table->columns[c].name);
    return FW_OK;
}

fw_status fw_plot_sweep_along(fw_sweep_along *along, const fw_plot_sweep *sweep,
                              const fw_plot_wish *wish, const fw_scenario_picture *own,
                              fw_error *error)
{
    const fw_sweep_table *table = &sweep->table;
    const char *name = wish->along ? wish->along : own ? own->along_quantity : NULL;
    *along = (fw_sweep_along){-1, -1};
    if (!name && own) along->axis = own->along;
    if (!name) return FW_OK;
    for (int a = 0; a < table->axis_count; ++a)
        if (strcmp(table->axes[a].name, name) == 0) along->axis = a;
    if (along->axis >= 0) return FW_OK;
    for (int c = table->column_count - 1; c >= 0; --c)
        if (is_of(&table->columns[c], name)) along->column = c;
    return along->column >= 0 ? FW_OK : refuse_quantity(sweep, name, error);
}

/* --- words --- */

/* A name in its parts: "wave-front.bar x, rate" has the subject "bar" and the component "x". */
typedef struct name_parts {
    int quantity, subject_at, subject, component_at, component; /* where they begin, how long */
    const char *end;                                            /* ", rate", or "" */
} name_parts;

static name_parts parts_of(const char *name)
{
    const char *comma = strrchr(name, ',');
    const int quantity = (int)strcspn(name, " .,");
    const int end = comma ? (int)(comma - name) : (int)strlen(name);
    int space = end;
    for (int n = quantity; n < end; ++n)
        if (name[n] == ' ') space = n;
    name_parts parts = {.quantity = quantity, .end = name + end};
    parts.component_at = space + (space < end);
    parts.component = end - parts.component_at;
    parts.subject_at = quantity + (name[quantity] == '.');
    parts.subject = space > parts.subject_at ? space - parts.subject_at : 0;
    return parts;
}

/* Is the same quantity of something else in the table? */
static bool is_of_several(const fw_sweep_column *column, const fw_sweep_table *table)
{
    const name_parts own = parts_of(column->name);
    for (int c = 0; c < table->column_count; ++c) {
        const char *name = table->columns[c].name;
        const name_parts other = parts_of(name);
        if (other.quantity != own.quantity ||
            strncmp(name, column->name, (size_t)own.quantity) != 0)
            continue;
        if (other.subject != own.subject ||
            strncmp(name + other.subject_at, column->name + own.subject_at, (size_t)own.subject) !=
                0)
            return true;
    }
    return false;
}

const char *fw_plot_sweep_label(const fw_sweep_column *column, const fw_sweep_table *table,
                                const fw_units *units, bool whole, char *text, size_t size,
                                fw_label *label)
{
    char quantity[FW_SWEEP_NAME + 8] = "";
    const char *name = column->name;
    const name_parts parts = parts_of(name);
    fw_text_append(quantity, sizeof quantity, "%.*s", parts.quantity, name);
    if (whole && parts.component > 0)
        fw_text_append(quantity, sizeof quantity, " %.*s", parts.component,
                       name + parts.component_at);
    if (whole && parts.subject > 0 && is_of_several(column, table))
        fw_text_append(quantity, sizeof quantity, " of %.*s", parts.subject,
                       name + parts.subject_at);
    if (whole) fw_text_append(quantity, sizeof quantity, "%s", parts.end);
    *label = fw_plot_label(text, size, quantity, column->unit, units);
    const char *part = name + parts.quantity;
    return part + strspn(part, " .,");
}

void fw_plot_sweep_explain(const fw_sweep_column *column, char *caption, size_t size)
{
    const fw_quantity *quantity = quantity_of(column);
    /* "the same far from it" says nothing by itself. */
    if (!quantity || strncmp(quantity->meaning, "the ", 4) == 0) return;
    if (strstr(caption, quantity->meaning)) return;
    fw_text_append(caption, size, "%s: %s. ", quantity->name, quantity->meaning);
}

void fw_plot_sweep_say_seeds(int64_t seeds, char *caption, size_t size)
{
    if (seeds > 1)
        fw_text_append(caption, size, "Means over %lld seeds, with their standard errors. ",
                       (long long)seeds);
    else
        fw_text_append(caption, size,
                       "One seed: an error, where there is one, is that of a mean over time. ");
}

/* --- the picture --- */

static fw_status draw(const fw_plot_sweep *result, const fw_plot_wish *wish,
                      const fw_scenario_picture *own, FILE *out, fw_error *error)
{
    char path[FW_PATH_SIZE], name[FW_NAME_BYTES + 8];
    const char *map = fw_picture_rows[FW_PICTURE_MAP].name;
    const bool is_map = own ? own->kind == FW_PICTURE_MAP : wish->kind && !strcmp(wish->kind, map);
    const fw_picture_kind kind = is_map ? FW_PICTURE_MAP : FW_PICTURE_SWEEP;
    FW_TRY(fw_plot_check_wish(wish, kind, error));
    snprintf(name, sizeof name, "%.*s.png", FW_NAME_BYTES,
             own ? own->name : fw_picture_rows[kind].name);
    FW_TRY(fw_path_join(path, result->directory, name, error));
    fw_page page = fw_plot_page(wish);
    page.file = wish->file ? wish->file : path;
    page.title = own && own->title ? own->title : result->scenario->title;
    FW_TRY((is_map ? fw_plot_sweep_map : fw_plot_sweep_curves)(result, wish, own, &page, error));
    if (!wish->file) FW_TRY(fw_manifest_enter(result->directory, name, error));
    fprintf(out, "picture: %s\n", page.file);
    return FW_OK;
}

/* The scenario's picture that is wished for; NULL: none is. */
static fw_status find_picture(const fw_plot_sweep *result, const fw_plot_wish *wish,
                              const fw_scenario_picture **own, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    *own = NULL;
    for (int n = 0; n < scenario->picture_count; ++n) {
        const fw_scenario_picture *picture = &scenario->pictures[n];
        const bool wanted = wish->picture ? strcmp(picture->name, wish->picture) == 0
                            : wish->kind
                                ? strcmp(fw_picture_rows[picture->kind].name, wish->kind) == 0
                                : !fw_plot_is_of_case(picture);
        if (!wanted) continue;
        *own = picture;
        if (!fw_plot_is_of_case(picture)) return FW_OK;
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
    if (wish->kind && strcmp(wish->kind, "sweep") != 0 && strcmp(wish->kind, "map") != 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s holds a sweep; pictures of kind %s are drawn in the folders of its "
                       "cases, here those of kind sweep or map",
                       directory, wish->kind);
    return FW_OK;
}

fw_status fw_plot_sweep_one(const char *directory, const fw_plot_wish *wish, FILE *out,
                            fw_error *error)
{
    fw_plot_sweep result;
    const fw_scenario_picture *own;
    FW_TRY(check_wish(directory, wish, error));
    fw_status status = open_sweep(&result, directory, error);
    if (status == FW_OK) status = find_picture(&result, wish, &own, error);
    if (status == FW_OK) status = draw(&result, wish, own, out, error);
    close_sweep(&result);
    return status;
}

/* The first of several failures is told. */
static void keep_first(fw_status *status, fw_error *error, fw_status done, const fw_error *own)
{
    if (*status != FW_OK || done == FW_OK) return;
    *status = done;
    *error = *own;
}

/* The pictures of single runs, in the folder of each case. */
static void draw_cases(const fw_plot_sweep *result, FILE *out, fw_status *status, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    bool any = false;
    for (int n = 0; n < scenario->picture_count; ++n)
        any |= fw_plot_is_of_case(&scenario->pictures[n]);
    for (int n = 0; any && n < scenario->study.sweep.case_count; ++n) {
        char name[FW_CASE_NAME], folder[FW_PATH_SIZE];
        fw_error own = {0};
        fw_scenario_case_name(scenario, n, name);
        fw_status done = fw_path_join(folder, result->directory, name, &own);
        if (done == FW_OK) done = fw_plot_all(folder, out, &own);
        keep_first(status, error, done, &own);
    }
}

/* One picture that fails does not keep the others from being drawn. */
static fw_status draw_all(const fw_plot_sweep *result, FILE *out, fw_error *error)
{
    const fw_scenario *scenario = result->scenario;
    fw_status status = FW_OK;
    int tried = 0;
    for (int n = 0; n < scenario->picture_count; ++n) {
        fw_error own = {0};
        if (fw_plot_is_of_case(&scenario->pictures[n])) continue;
        const fw_status done = draw(result, &(fw_plot_wish){0}, &scenario->pictures[n], out, &own);
        keep_first(&status, error, done, &own);
        tried += 1;
    }
    if (tried == 0) status = draw(result, &(fw_plot_wish){0}, NULL, out, error);
    draw_cases(result, out, &status, error);
    return status;
}

fw_status fw_plot_sweep_all(const char *directory, FILE *out, fw_error *error)
{
    fw_plot_sweep result;
    fw_status status = open_sweep(&result, directory, error);
    if (status == FW_OK) status = draw_all(&result, out, error);
    close_sweep(&result);
    return status;
}

static fw_status refuse_run(const fw_plot_result *result, const fw_plot_picture *picture,
                            fw_error *error)
{
    return fw_fail(error, FW_BAD_INPUT,
                   "%s holds a single run, and pictures of kind %s are drawn in the folder of a "
                   "sweep",
                   result->directory, fw_picture_rows[picture->asked.kind].name);
}

fw_status fw_plot_draw_sweep(const fw_plot_result *result, const fw_plot_picture *picture,
                             fw_error *error)
{
    return refuse_run(result, picture, error);
}

fw_status fw_plot_draw_map(const fw_plot_result *result, const fw_plot_picture *picture,
                           fw_error *error)
{
    return refuse_run(result, picture, error);
}
