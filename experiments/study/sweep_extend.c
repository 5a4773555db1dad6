/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_extend.c - further values of a sweep. Keeps no state. Start reading at fw_sweep_extend().
 */
#include "experiments/study/sweep_extend.h"

#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Points that are added: of a sweep without points a row has one value, and NaN. */
typedef struct addition {
    double point[FW_PARAMETERS_MAX];
    const char *text; /* as it was given */
} addition;

/* --- what is added --- */

static fw_status refuse_name(const fw_scenario_sweep *plan, const char *text, const char *name,
                             fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name);
    for (int p = 0; p < plan->parameter_count; ++p)
        fw_suggestion_offer(&suggestion, plan->parameters[p].name);
    return fw_fail(error, FW_BAD_INPUT, "--add %s: the sweep has no parameter %s%s%s%s", text, name,
                   suggestion.best ? "; did you mean " : ", expected one such as ",
                   suggestion.best ? suggestion.best : plan->parameters[0].name,
                   suggestion.best ? "?" : "");
}

/* One NAME=VALUE of an addition. */
static fw_status read_value(const fw_scenario_sweep *plan, const char *text, const char *part,
                            size_t length, addition *made, fw_error *error)
{
    const char *equals = memchr(part, '=', length);
    char name[FW_NAME_BYTES];
    double value;
    if (!equals || equals - part >= FW_NAME_BYTES)
        return fw_fail(error, FW_BAD_INPUT, "--add %s: expected NAME=VALUE, such as %s=1", text,
                       plan->parameters[0].name);
    snprintf(name, sizeof name, "%.*s", (int)(equals - part), part);
    const size_t rest = length - (size_t)(equals - part) - 1;
    int p = 0;
    while (p < plan->parameter_count && strcmp(plan->parameters[p].name, name) != 0) ++p;
    if (p == plan->parameter_count) return refuse_name(plan, text, name, error);
    if (fw_number_read(equals + 1, rest, &value) != FW_NUMBER_FINE)
        return fw_fail(error, FW_BAD_INPUT, "--add %s: '%s' is no number", text,
                       fw_text_quote(equals + 1, rest).text);
    if (!isnan(made->point[p]))
        return fw_fail(error, FW_BAD_INPUT, "--add %s: %s has two values, expected one", text,
                       name);
    made->point[p] = value;
    return FW_OK;
}

static fw_status read_addition(const fw_scenario_sweep *plan, bool has_points, const char *text,
                               addition *made, fw_error *error)
{
    int count = 0;
    made->text = text;
    for (int p = 0; p < FW_PARAMETERS_MAX; ++p) made->point[p] = NAN;
    for (const char *part = text;; ++count) {
        const size_t length = strcspn(part, ",");
        FW_TRY(read_value(plan, text, part, length, made, error));
        if (!part[length]) break;
        part += length + 1;
    }
    count += 1;
    if (has_points && count != plan->parameter_count)
        return fw_fail(error, FW_BAD_INPUT,
                       "--add %s: the sweep has points, expected a value of each of its %d "
                       "parameters",
                       text, plan->parameter_count);
    if (!has_points && count > 1)
        return fw_fail(error, FW_BAD_INPUT,
                       "--add %s: every value of one parameter meets all values of the others, "
                       "expected one --add for each",
                       text);
    for (int n = 0; n < plan->case_count; ++n)
        if (fw_sweep_is_at(plan, n, made->point))
            return fw_fail(error, FW_BAD_INPUT, "--add %s: the sweep has that already", text);
    return FW_OK;
}

static fw_status refuse_twice(const addition *list, int number, fw_error *error)
{
    for (int n = 0; n < number; ++n) {
        bool same = true;
        for (int p = 0; p < FW_PARAMETERS_MAX; ++p)
            same &= list[n].point[p] == list[number].point[p] ||
                    (isnan(list[n].point[p]) && isnan(list[number].point[p]));
        if (same) return fw_fail(error, FW_BAD_INPUT, "--add %s is given twice", list[number].text);
    }
    return FW_OK;
}

/* --- as settings of the scenario --- */

static void write_number(FILE *out, const char *before, double value)
{
    char text[FW_NUMBER_TEXT];
    fw_number_write(text, value);
    fprintf(out, "%s%s", before, text);
}

/* As it stands in the scenario: with quotes only where it has them. */
static void write_unit(FILE *out, const fw_node *unit)
{
    fputs(unit->quoted ? ", unit: '" : ", unit: ", out);
    for (const char *c = unit->text; *c; ++c)
        fprintf(out, "%s", unit->quoted && *c == '\'' ? "''" : (char[]){*c, '\0'});
    if (unit->quoted) fputc('\'', out);
}

/* All values of one parameter, those of the cases that there are first; its unit stays. */
static void write_parameter(FILE *out, const fw_scenario_sweep *plan, int p,
                            const fw_node *parameters, const addition *additions, int count)
{
    const fw_node *unit = fw_node_find(fw_node_find(parameters, plan->parameters[p].name), "unit");
    const char *before = "";
    fprintf(out, "study.sweep.parameters.%s={values: [", plan->parameters[p].name);
    for (int n = 0; n < plan->case_count; ++n) {
        const double value = fw_sweep_value(plan, n, p);
        bool said = false;
        for (int m = 0; m < n && !said; ++m) said = fw_sweep_value(plan, m, p) == value;
        if (said) continue;
        write_number(out, before, value);
        before = ", ";
    }
    for (int n = 0; n < count; ++n)
        if (!isnan(additions[n].point[p])) write_number(out, ", ", additions[n].point[p]);
    fputc(']', out);
    if (unit) write_unit(out, unit);
    fputc('}', out);
}

static void write_point(FILE *out, const fw_scenario_sweep *plan, const double *point)
{
    fputc('{', out);
    for (int p = 0; p < plan->parameter_count; ++p) {
        fprintf(out, "%s%s", p > 0 ? ", " : "", plan->parameters[p].name);
        write_number(out, ": ", point[p]);
    }
    fputc('}', out);
}

static void write_points(FILE *out, const fw_scenario_sweep *plan, const addition *additions,
                         int count)
{
    fputs("study.sweep.points=[", out);
    for (int n = 0; n < plan->case_count; ++n) {
        if (n > 0) fputs(", ", out);
        write_point(out, plan, plan->values + (size_t)n * (size_t)plan->parameter_count);
    }
    for (int n = 0; n < count; ++n) {
        fputs(", ", out);
        write_point(out, plan, additions[n].point);
    }
    fputc(']', out);
}

/* Settings one after the other, each ended by '\0'; to be freed. */
static char *write_settings(const fw_scenario_sweep *plan, const fw_node *parameters,
                            bool has_points, const addition *additions, int count)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out) return NULL;
    if (has_points) {
        write_points(out, plan, additions, count);
        fputc('\0', out);
    }
    for (int p = 0; !has_points && p < plan->parameter_count; ++p) {
        bool any = false;
        for (int n = 0; n < count; ++n) any |= !isnan(additions[n].point[p]);
        if (!any) continue;
        write_parameter(out, plan, p, parameters, additions, count);
        fputc('\0', out);
    }
    fputc('\0', out);
    if (fclose(out) == 0) return text;
    free(text);
    return NULL;
}

/* --- what must stay --- */

/* Names in `text` the first places where the trees differ. */
static void list_changes(const fw_node *old, const fw_node *fresh, const char *path, char *text,
                         size_t size)
{
    char inner[512];
    if (old && fresh && old->kind == fresh->kind && old->kind == FW_SCALAR &&
        strcmp(fw_node_written(old), fw_node_written(fresh)) == 0)
        return;
    const bool both = old && fresh && old->kind == fresh->kind && old->kind != FW_SCALAR &&
                      (old->kind == FW_MAPPING || old->count == fresh->count);
    if (!both) {
        fw_text_append(text, size, "%s%s", text[0] ? ", " : "", path);
        return;
    }
    int number = 0;
    const fw_node *match = fresh->first;
    for (const fw_node *child = old->first; child; child = child->next, ++number) {
        if (old->kind == FW_MAPPING) match = fw_node_find(fresh, child->key);
        if (old->kind == FW_MAPPING)
            snprintf(inner, sizeof inner, "%s%s%s", path, path[0] ? "." : "", child->key);
        else
            snprintf(inner, sizeof inner, "%s.%d", path, number);
        list_changes(child, match, inner, text, size);
        if (old->kind == FW_LIST) match = match->next;
    }
    for (const fw_node *child = fresh->first; child && old->kind == FW_MAPPING; child = child->next)
        if (!fw_node_find(old, child->key))
            fw_text_append(text, size, "%s%s%s%s", text[0] ? ", " : "", path, path[0] ? "." : "",
                           child->key);
}

static fw_status compare_case(const fw_scenario *old, const fw_scenario *fresh, int number,
                              int match, const char *directory, fw_error *error)
{
    fw_scenario *before, *after = NULL;
    char changes[512] = "", name[FW_CASE_NAME];
    FW_TRY(fw_scenario_read_case(&before, old, number, error));
    const fw_status status = fw_scenario_read_case(&after, fresh, match, error);
    if (status == FW_OK)
        list_changes(fw_document_root(before->document), fw_document_root(after->document), "",
                     changes, sizeof changes);
    fw_scenario_destroy(before);
    fw_scenario_destroy(after);
    FW_TRY(status);
    if (!changes[0]) return FW_OK;
    fw_scenario_case_name(old, number, name);
    return fw_fail(error, FW_BAD_INPUT,
                   "%s: old and new cases would be different things: %s would change in %s",
                   directory, changes, name);
}

static fw_status compare_cases(const fw_scenario *old, const fw_scenario *fresh,
                               const char *directory, fw_error *error)
{
    const fw_scenario_sweep *plan = &old->study.sweep, *larger = &fresh->study.sweep;
    for (int n = 0; n < plan->case_count; ++n) {
        const double *point = plan->values + (size_t)n * (size_t)plan->parameter_count;
        int match = 0;
        while (match < larger->case_count && (larger->parameter_count != plan->parameter_count ||
                                              !fw_sweep_is_at(larger, match, point)))
            ++match;
        if (match == larger->case_count) {
            char name[FW_CASE_NAME];
            fw_scenario_case_name(old, n, name);
            return fw_fail(error, FW_BAD_INPUT, "%s: the case %s would be lost", directory, name);
        }
        FW_TRY(compare_case(old, fresh, n, match, directory, error));
    }
    return FW_OK;
}

/* --- all of it --- */

static fw_status read_larger(fw_scenario **made, const fw_scenario *sweep, const char *changes,
                             const char *const *settings, int setting_count, fw_error *error)
{
    enum { ALL_MAX = 512 };
    const char *all[ALL_MAX];
    int count = 0;
    char *text;
    assert(setting_count <= ALL_MAX - FW_PARAMETERS_MAX);
    for (const char *change = changes; *change; change += strlen(change) + 1) all[count++] = change;
    for (int n = 0; n < setting_count; ++n) all[count++] = settings[n];
    FW_TRY(fw_scenario_print(sweep, &text, error));
    const fw_status status = fw_scenario_read(made, NULL, text, strlen(text), all, count, error);
    free(text);
    return status;
}

fw_status fw_sweep_extend(fw_scenario **made, const fw_scenario *sweep, const char *directory,
                          const char *const *additions, int addition_count,
                          const char *const *settings, int setting_count, fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    const fw_node *study = fw_node_find(fw_document_root(sweep->document), "study");
    const fw_node *lines = fw_node_find(study, "sweep");
    const fw_node *parameters = fw_node_find(lines, "parameters");
    const bool has_points = fw_node_find(lines, "points") != NULL;
    *made = NULL;
    if (plan->tolerance > 0)
        return fw_fail(error, FW_BAD_INPUT,
                       "%s: the sweep bisects %s, whose values follow from each other: nothing can "
                       "be added",
                       directory, plan->parameters[plan->bisected].name);
    if (addition_count == 0)
        return fw_fail(error, FW_BAD_INPUT, "%s: nothing to add, expected --add such as --add %s=1",
                       directory, plan->parameters[0].name);
    addition *list = calloc((size_t)addition_count, sizeof *list);
    fw_status status = list ? FW_OK : fw_fail_memory(error, "what is added to a sweep");
    for (int n = 0; status == FW_OK && n < addition_count; ++n) {
        status = read_addition(plan, has_points, additions[n], &list[n], error);
        if (status == FW_OK) status = refuse_twice(list, n, error);
    }
    char *changes =
        status == FW_OK ? write_settings(plan, parameters, has_points, list, addition_count) : NULL;
    free(list);
    FW_TRY(status);
    if (!changes) return fw_fail_memory(error, "what is added to a sweep");
    status = read_larger(made, sweep, changes, settings, setting_count, error);
    free(changes);
    if (status == FW_OK && !fw_scenario_is_sweep(*made))
        status = fw_fail(error, FW_BAD_INPUT, "%s: it would be a sweep no longer", directory);
    if (status == FW_OK) status = compare_cases(sweep, *made, directory, error);
    if (status == FW_OK) return FW_OK;
    fw_scenario_destroy(*made);
    *made = NULL;
    return status;
}

fw_status fw_sweep_add_points(fw_scenario **made, const fw_scenario *sweep, const double *points,
                              int count, fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    addition *list = calloc((size_t)count, sizeof *list);
    for (int n = 0; list && n < count; ++n)
        memcpy(list[n].point, points + (size_t)n * (size_t)plan->parameter_count,
               (size_t)plan->parameter_count * sizeof *points);
    char *changes = list ? write_settings(plan, NULL, true, list, count) : NULL;
    free(list);
    if (!changes) return fw_fail_memory(error, "further points of a sweep");
    const fw_status status = read_larger(made, sweep, changes, NULL, 0, error);
    free(changes);
    return status;
}
