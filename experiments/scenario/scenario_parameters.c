/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_parameters.c - what a sweep varies: its parameters, their values, and the points at
 * which they meet. Keeps no state. Start reading at fw_scenario_read_parameters(). */
#include "experiments/text/formula.h"
#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"
#include "scenario_parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { VALUES_MAX = 1024 };

typedef enum spacing { LINEAR, LOGARITHMIC } spacing;

/* A parameter as it is written. */
typedef struct written {
    double from, to, tolerance;
    int64_t count;
    spacing spacing;
    const char *unit;
} written;

static const fw_key parameter_keys[] = {
    {"values", FW_FORM_LIST, .items = FW_FORM_NUMBER, .least = 1, .most = VALUES_MAX, NOT_STORED,
     .default_meaning = "see `from`",
     .meaning = "all different, in the order in which they are run"},
    {"from", AT_NUMBER(written, from), .needs = "to", .default_value = "0",
     .default_meaning = "see `values`", .meaning = "first value of a range"},
    {"to", AT_NUMBER(written, to), .needs = "from", .default_value = "0",
     .default_meaning = "see `values`", .meaning = "last value of a range"},
    {"count", AT_INTEGER(written, count), .needs = "from", FROM_TO(2, VALUES_MAX),
     .default_value = "2", .default_meaning = "see `values`",
     .meaning = "how many values a range has, both ends among them"},
    {"tolerance", AT_NUMBER(written, tolerance), .needs = "to", ABOVE_ZERO, .default_value = "0",
     .default_meaning = "no bisection",
     .meaning = "in place of `count`: the range is bisected for the value at which the number that "
                "one expectation names `crosses` its level, until it is known so well; one "
                "parameter at most"},
    {"spacing", AT_WORD(written, spacing), .needs = "to",
     WORDS({"linear", LINEAR}, {"logarithmic", LOGARITHMIC}), .default_value = "linear",
     .meaning = "of a range: equal steps (to 12 digits), or equal factors (to 6 digits)"},
    {"unit", AT_TEXT(written, unit), .default_meaning = "none",
     .meaning = "for the axis of pictures"},
    {.name = NULL}};

const fw_section fw_parameter_section = {
    "Parameters of `study.sweep`", "a parameter",
    "Either `values`, or a range of `count` values `from` one `to` another, or a range that is "
    "bisected to a `tolerance`; neither, where the sweep has `points`.",
    .keys = parameter_keys};

/* Values of one parameter on their way to the points. */
typedef struct value_list {
    int count;
    double *values;
} value_list;

/* --- one parameter --- */

/* It stands in one line of the table, and beside the axis of pictures. */
static fw_status check_unit(const fw_scenario *scenario, const char *name, const fw_node *unit,
                            fw_error *error)
{
    enum { LONGEST = 63 };
    bool plain = !unit || unit->length <= LONGEST;
    for (const char *c = unit ? unit->text : ""; *c; ++c) plain &= (unsigned char)*c >= ' ';
    if (plain) return FW_OK;
    return fw_scenario_fail(scenario, unit->place, error,
                            "the unit of %s is '%s', expected at most %d bytes in one line", name,
                            fw_text_quote(unit->text, unit->length).text, LONGEST);
}

/* As somebody would write it: 0.3, not 0.30000000000000004. */
static double round_to(double value, int digits)
{
    char text[FW_NUMBER_TEXT];
    snprintf(text, sizeof text, "%.*g", digits, value);
    return fw_number_scan(text, NULL);
}

static double value_of_range(const written *w, int64_t number)
{
    const double part = (double)number / (double)(w->count - 1);
    if (number == 0) return w->from;
    if (number == w->count - 1) return w->to;
    if (w->spacing == LOGARITHMIC) return round_to(w->from * pow(w->to / w->from, part), 6);
    const double value = w->from + part * (w->to - w->from);
    const double rounding = 1e-12 * fmax(fabs(w->from), fabs(w->to));
    return fabs(value) < rounding ? 0 : round_to(value, 12);
}

/* A range without a number of values: its ends come first, and what lies between follows from
 * them. */
static fw_status read_bisection(fw_scenario *scenario, const fw_node *node, written *w,
                                fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    const fw_node *tolerance = fw_node_find(node, "tolerance"), *from = fw_node_find(node, "from");
    const fw_node *count = fw_node_find(node, "count");
    if (!from) return FW_OK;
    if (!tolerance && !count)
        return fw_scenario_fail(scenario, from->key_place, error,
                                "%s has 'from' and 'to', expected 'count' too, or 'tolerance' "
                                "where it is bisected",
                                node->key);
    if (!tolerance) return FW_OK;
    if (count)
        return fw_scenario_fail(scenario, tolerance->key_place, error,
                                "%s has both 'count' and 'tolerance', expected one of them",
                                node->key);
    if (sweep->tolerance > 0)
        return fw_scenario_fail(scenario, tolerance->key_place, error,
                                "%s has a 'tolerance' as %s has, expected one parameter that is "
                                "bisected",
                                node->key, sweep->parameters[sweep->bisected].name);
    const double width = fabs(w->to - w->from);
    if (w->tolerance >= width || w->tolerance < 1e-9 * width)
        return fw_scenario_fail(scenario, tolerance->place, error,
                                "%s is bisected from %g to %g with the tolerance %g, expected one "
                                "below their distance, and not below a 1e-9th of it",
                                node->key, w->from, w->to, w->tolerance);
    sweep->tolerance = w->tolerance;
    sweep->bisected = sweep->parameter_count - 1;
    sweep->logarithmic = w->spacing == LOGARITHMIC;
    w->count = 2;
    return FW_OK;
}

static fw_status read_range(const fw_scenario *scenario, const fw_node *node, const written *w,
                            value_list *list, fw_error *error)
{
    if (w->from == w->to)
        return fw_scenario_fail(scenario, fw_node_find(node, "to")->place, error,
                                "the range of %s goes from %g to %g, expected values that differ",
                                node->key, w->from, w->to);
    if (w->spacing == LOGARITHMIC && !(w->from * w->to > 0))
        return fw_scenario_fail(scenario, fw_node_find(node, "from")->place, error,
                                "the range of %s goes from %g to %g, which no equal factors do: "
                                "expected two numbers above 0",
                                node->key, w->from, w->to);
    for (; list->count < w->count; ++list->count)
        list->values[list->count] = value_of_range(w, list->count);
    return FW_OK;
}

static fw_status read_list(const fw_scenario *scenario, const char *name, const fw_node *values,
                           value_list *list, fw_error *error)
{
    for (const fw_node *node = values->first; node; node = node->next) {
        const double value = fw_node_number(node);
        for (int n = 0; n < list->count; ++n)
            if (list->values[n] == value)
                return fw_scenario_fail(scenario, node->place, error,
                                        "the values of %s have %s twice, expected values that "
                                        "differ",
                                        name, node->text);
        list->values[list->count++] = value;
    }
    return FW_OK;
}

static fw_status refuse_empty(const fw_scenario *scenario, const fw_scenario_parameter *parameter,
                              fw_error *error)
{
    return fw_scenario_fail(scenario, parameter->place, error,
                            "%s has no values, expected 'values', or 'from', 'to' and 'count', or "
                            "'points' of the sweep",
                            parameter->name);
}

/* `is_known`: it has the value of the case that the scenario is. */
static fw_status read_parameter(fw_scenario *scenario, const fw_node *node, bool has_points,
                                bool is_known, value_list *list, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    fw_scenario_parameter *made = &sweep->parameters[sweep->parameter_count++];
    written w;
    FW_TRY(fw_scenario_fail_again(scenario, node->key_place,
                                  fw_formula_check_name(node->key, error), error));
    FW_TRY(check_unit(scenario, node->key, fw_node_find(node, "unit"), error));
    w.unit = NULL;
    FW_TRY(fw_schema_fill(scenario->document, &fw_parameter_section, node, &w, error));
    *made = (fw_scenario_parameter){.name = node->key, .place = node->key_place, .unit = w.unit};
    const fw_node *values = fw_node_find(node, "values"), *from = fw_node_find(node, "from");
    if (values && from)
        return fw_scenario_fail(scenario, from->key_place, error,
                                "%s has both 'values' and 'from', expected one of them", node->key);
    const fw_node *given = values ? values : from;
    FW_TRY(read_bisection(scenario, node, &w, error));
    if (given && has_points)
        return fw_scenario_fail(scenario, given->key_place, error,
                                "%s has '%s', but study.sweep has 'points': expected one of the "
                                "two",
                                node->key, given->key);
    if (!given && (has_points || is_known)) return FW_OK;
    if (!given) return refuse_empty(scenario, made, error);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)(values ? values->count : w.count),
                                sizeof *list->values, &list->values, error));
    return values ? read_list(scenario, node->key, values, list, error)
                  : read_range(scenario, node, &w, list, error);
}

/* --- points --- */

static int find_parameter(const fw_scenario_sweep *sweep, const char *name)
{
    for (int p = 0; p < sweep->parameter_count; ++p)
        if (strcmp(sweep->parameters[p].name, name) == 0) return p;
    return -1;
}

static fw_status refuse_name(const fw_scenario *scenario, const char *name, fw_place place,
                             fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    fw_suggestion suggestion = fw_suggestion_begin(name);
    char known[300] = "";
    for (int p = 0; p < sweep->parameter_count; ++p) {
        fw_suggestion_offer(&suggestion, sweep->parameters[p].name);
        fw_text_append(known, sizeof known, "%s%s", p > 0 ? ", " : "", sweep->parameters[p].name);
    }
    const fw_quote quote = fw_text_quote(name, strlen(name));
    if (suggestion.best)
        return fw_scenario_fail(scenario, place, error,
                                "'%s' is no parameter of study.sweep; did you mean '%s'?",
                                quote.text, suggestion.best);
    return fw_scenario_fail(scenario, place, error,
                            "'%s' is no parameter of study.sweep, expected one of %s", quote.text,
                            known);
}

fw_status fw_scenario_find_parameter(const fw_scenario *scenario, const fw_node *name, int *number,
                                     fw_error *error)
{
    *number = find_parameter(&scenario->study.sweep, name->text);
    return *number >= 0 ? FW_OK : refuse_name(scenario, name->text, name->place, error);
}

fw_status fw_scenario_read_point(const fw_scenario *scenario, const fw_node *node, bool whole,
                                 double *point, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    const char *what = node->key ? node->key : "a point";
    if (sweep->parameter_count == 0)
        return fw_scenario_fail(scenario, node->key_place, error,
                                "'%s' names a value of a sweep, but the study has no 'sweep'",
                                what);
    for (int p = 0; p < sweep->parameter_count; ++p) point[p] = NAN;
    if (node->kind == FW_SCALAR) {
        if (sweep->parameter_count > 1)
            return fw_scenario_fail(scenario, node->place, error,
                                    "'%s' is %s, but study.sweep has %d parameters: expected their "
                                    "names, as {%s: %s}",
                                    what, node->text, sweep->parameter_count,
                                    sweep->parameters[0].name, node->text);
        point[0] = fw_node_number(node);
        return FW_OK;
    }
    for (const fw_node *child = node->first; child; child = child->next) {
        const int p = find_parameter(sweep, child->key);
        if (p < 0) return refuse_name(scenario, child->key, child->key_place, error);
        point[p] = fw_node_number(child);
    }
    for (int p = 0; whole && p < sweep->parameter_count; ++p)
        if (isnan(point[p]))
            return fw_scenario_fail(scenario, node->place, error,
                                    "'%s' has no value of %s, expected one of each parameter", what,
                                    sweep->parameters[p].name);
    return FW_OK;
}

bool fw_sweep_is_at(const fw_scenario_sweep *sweep, int number, const double *point)
{
    for (int p = 0; p < sweep->parameter_count; ++p)
        if (!isnan(point[p]) && point[p] != fw_sweep_value(sweep, number, p)) return false;
    return true;
}

fw_status fw_scenario_check_point(const fw_scenario *scenario, const fw_node *node,
                                  const double *point, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    for (int n = 0; n < sweep->case_count; ++n)
        if (fw_sweep_is_at(sweep, n, point)) return FW_OK;
    char text[400] = "";
    for (int p = 0; p < sweep->parameter_count; ++p)
        if (!isnan(point[p]))
            fw_text_append(text, sizeof text, "%s%s=%.10g", text[0] ? "," : "",
                           sweep->parameters[p].name, point[p]);
    return fw_scenario_fail(scenario, node->place, error,
                            "'%s' is %s, where study.sweep has no case",
                            node->key ? node->key : "a point", text);
}

static fw_status read_points(fw_scenario *scenario, const fw_node *list, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    const size_t width = (size_t)sweep->parameter_count;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count * width, sizeof *sweep->values,
                                &sweep->values, error));
    for (const fw_node *node = list->first; node; node = node->next) {
        double *point = &sweep->values[(size_t)sweep->case_count * width];
        FW_TRY(fw_scenario_read_point(scenario, node, true, point, error));
        for (int n = 0; n < sweep->case_count; ++n)
            if (fw_sweep_is_at(sweep, n, point))
                return fw_scenario_fail(scenario, node->place, error,
                                        "the points %d and %d of study.sweep are the same, "
                                        "expected points that differ",
                                        n, sweep->case_count);
        sweep->case_count += 1;
    }
    return FW_OK;
}

/* Every value of one with every value of the others; the last parameter changes first. */
static fw_status combine(fw_scenario *scenario, const value_list *lists, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    double count = 1;
    for (int p = 0; p < sweep->parameter_count; ++p) count *= lists[p].count;
    if (count > FW_CASES_MAX)
        return fw_scenario_fail(scenario, sweep->place, error,
                                "study.sweep has %.0f cases, expected at most %d", count,
                                FW_CASES_MAX);
    sweep->case_count = (int)count;
    FW_TRY(fw_scenario_allocate(scenario,
                                (size_t)sweep->case_count * (size_t)sweep->parameter_count,
                                sizeof *sweep->values, &sweep->values, error));
    double *value = sweep->values;
    for (int n = 0; n < sweep->case_count; ++n) {
        int share = sweep->case_count;
        for (int p = 0; p < sweep->parameter_count; ++p) {
            share /= lists[p].count;
            *value++ = lists[p].values[n / share % lists[p].count];
        }
    }
    return FW_OK;
}

/* They are folders. */
static fw_status check_names(const fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    char name[FW_CASE_NAME];
    for (int n = 0; n < sweep->case_count; ++n) {
        const int length = fw_scenario_case_name(scenario, n, name);
        if (length >= FW_CASE_NAME)
            return fw_scenario_fail(scenario, sweep->place, error,
                                    "the folder '%s' of a case would have a name of %d bytes, "
                                    "expected at most %d: give the parameters shorter names",
                                    fw_text_quote(name, strlen(name)).text, length,
                                    FW_CASE_NAME - 1);
    }
    return FW_OK;
}

fw_status fw_scenario_read_parameters(fw_scenario *scenario, const fw_node *sweep_node,
                                      bool is_known, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    const fw_node *node = fw_node_find(sweep_node, "parameters");
    const fw_node *points = fw_node_find(sweep_node, "points");
    value_list lists[FW_PARAMETERS_MAX] = {{0}};
    FW_TRY(fw_scenario_allocate(scenario, (size_t)node->count, sizeof *sweep->parameters,
                                &sweep->parameters, error));
    bool bisects = false;
    for (const fw_node *child = node->first; child; child = child->next)
        bisects |= fw_node_find(child, "tolerance") != NULL;
    /* Points of a bisection are the cases that it has come to so far. */
    for (const fw_node *child = node->first; child; child = child->next)
        FW_TRY(read_parameter(scenario, child, points && !bisects, is_known,
                              &lists[sweep->parameter_count], error));
    if (points) FW_TRY(read_points(scenario, points, error));
    bool all = !points, any = false;
    for (int p = 0; p < sweep->parameter_count; ++p) {
        all = all && lists[p].count > 0;
        any = any || lists[p].count > 0;
    }
    for (int p = 0; any && !all && !points && p < sweep->parameter_count; ++p)
        if (lists[p].count == 0) return refuse_empty(scenario, &sweep->parameters[p], error);
    if (all) FW_TRY(combine(scenario, lists, error));
    return check_names(scenario, error);
}
