/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_sweep.c - the sweep of a study, and how a scenario becomes one of its cases: the case's
 * settings are applied to the document, which from then on says only which case it is. So a case as
 * it was run reads back as what it is, a later change of it (its control) is not undone, and it
 * does not depend on what other cases there are. Keeps no state. Start reading at
 * fw_scenario_read_sweep(). */
#include "experiments/schema/settings.h"
#include "experiments/text/number.h"
#include "experiments/text/substitution.h"
#include "experiments/text/text.h"
#include "scenario_parts.h"

#include <stdlib.h>
#include <string.h>

static const fw_key sweep_keys[] = {
    {"parameters", FW_FORM_NAMED, .subsection = &fw_parameter_section, .least = 1,
     .most = FW_PARAMETERS_MAX, REQUIRED, NOT_STORED, .old_name = "parameter",
     .hint = "such as {A: {values: [1, 2, 3], unit: force}}",
     .meaning = "names of your own for what is varied. Without `points` every value of one meets "
                "every value of the others, those of the last one first"},
    {"points", FW_FORM_LIST, .items = FW_FORM_POINT, .least = 1, .most = FW_CASES_MAX, NOT_STORED,
     .default_meaning = "all combinations", .old_name = "values",
     .meaning = "in place of the parameters' own values: the cases, as [{A: 1, p: 2}, {A: 3, p: "
                "5}]"},
    {"set", FW_FORM_LIST, .items = FW_FORM_TEXT, .least = 1, .most = 64, NOT_STORED,
     .default_meaning = "required unless all are names of the scenario's `parameters`",
     .meaning = "changes, as `--set` has them; in their values formulas of the parameters, as "
                "`24*A`, `sqrt(A^2 + p^2)` or `rint(0.1/v)`, stand for numbers"},
    {"case", FW_FORM_NUMBER | FW_FORM_POINT, NOT_STORED, .default_meaning = "all of them",
     .meaning = "the only one to be run, as a study by itself: {A: 1, p: 2}; of one parameter its "
                "value is enough"},
    {.name = NULL}};

const fw_section fw_sweep_section = {
    "`study.sweep`", "a sweep",
    "A study for each point, with its results in `DIR/PARAMETER=VALUE`, or "
    "`DIR/A=1,p=2` of two parameters. `DIR/sweep.csv` has means and standard errors of what is "
    "expected, and of the layer's measures, against the parameters. A parameter with the name of "
    "one of the scenario's `parameters` takes its place. Formulas know `+ - * / ^`, "
    "comparisons, `(c ? a : b)`, `sqrt`, `exp`, `ln`, `log10`, `sin`, `cos`, `tan`, `atan2`, "
    "`abs`, `min`, `max`, `rint` (the nearest whole number), `pi`, and others of muParser.",
    .keys = sweep_keys};

/* --- settings --- */

enum { VARIABLES_MAX = FW_PARAMETERS_MAX + FW_CONSTANTS_MAX };

/* The setting at a point, in memory of the document. used[VARIABLES_MAX], or NULL: which variables
 * it names, the parameters first. */
static fw_status substitute(const fw_scenario *scenario, const fw_node *item, const double *values,
                            bool *used, const char **setting, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    fw_variable variables[VARIABLES_MAX];
    char *text;
    for (int p = 0; p < sweep->parameter_count; ++p)
        variables[p] = (fw_variable){sweep->parameters[p].name, values[p]};
    const int count = sweep->parameter_count +
                      fw_scenario_constants(scenario, variables + sweep->parameter_count);
    const fw_status status =
        fw_substitution_write(item->text, variables, count, &text, used, error);
    FW_TRY(fw_scenario_fail_again(scenario, item->place, status, error));
    *setting = fw_document_copy(scenario->document, text, strlen(text));
    free(text);
    return *setting ? FW_OK : fw_document_fail_memory(scenario->document, error);
}

static fw_status check_setting(const fw_scenario *scenario, const fw_node *item, bool *used,
                               fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    const char *unused;
    bool own[VARIABLES_MAX] = {false}, any = false;
    FW_TRY(substitute(scenario, item, sweep->values, own, &unused, error));
    for (int p = 0; p < VARIABLES_MAX; ++p) any |= own[p];
    for (int p = 0; p < sweep->parameter_count; ++p) used[p] |= own[p];
    const char *name = sweep->parameters[0].name;
    if (!any)
        return fw_scenario_fail(scenario, item->place, error,
                                "no parameter occurs in the setting '%s', expected KEY=VALUE with "
                                "%s, or a formula of it such as 2*%s, in the value",
                                fw_text_quote(item->text, item->length).text, name, name);
    if (strcspn(item->text, ".=") != strlen("study") ||
        strncmp(item->text, "study", strlen("study")) != 0)
        return FW_OK;
    return fw_scenario_fail(scenario, item->place, error,
                            "the setting '%s' changes the study that it is part of, expected "
                            "another key",
                            fw_text_quote(item->text, item->length).text);
}

static bool is_constant(const fw_scenario *scenario, const char *name)
{
    int count;
    const fw_node *constants = fw_scenario_part(scenario, "parameters", &count);
    return constants && fw_node_find(constants, name);
}

/* `list` NULL: there are none, as all that is varied are constants. */
static fw_status read_settings(fw_scenario *scenario, const fw_node *list, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    bool used[FW_PARAMETERS_MAX] = {false};
    FW_TRY(fw_scenario_allocate(scenario, list ? (size_t)list->count : 0, sizeof *sweep->settings,
                                &sweep->settings, error));
    for (const fw_node *item = list ? list->first : NULL; item; item = item->next) {
        FW_TRY(check_setting(scenario, item, used, error));
        sweep->settings[sweep->setting_count++] = item->text;
    }
    for (int p = 0; p < sweep->parameter_count; ++p) {
        const fw_scenario_parameter *parameter = &sweep->parameters[p];
        const bool constant = is_constant(scenario, parameter->name);
        if (used[p] || (constant && fw_scenario_needs_constant(scenario, parameter->name)))
            continue;
        if (!list && !constant)
            return fw_scenario_fail(scenario, sweep->place, error,
                                    "study.sweep has no 'set', which says what the values of %s "
                                    "change: it is none of the scenario's 'parameters'",
                                    parameter->name);
        return fw_scenario_fail(scenario, parameter->place, error,
                                "the parameter %s changes nothing: it occurs in no %s",
                                parameter->name,
                                constant ? "formula" : "setting of study.sweep.set");
    }
    return FW_OK;
}

/* What is compared must be measured in every case. */
static fw_status check_measured(const fw_scenario *scenario, fw_error *error)
{
    int count, expected;
    const fw_node *profile = fw_scenario_part(scenario, "profile", &count);
    fw_scenario_part(scenario, "expect", &expected);
    if (profile || expected > 0) return FW_OK;
    return fw_scenario_fail(scenario, scenario->study.sweep.place, error,
                            "a sweep compares what is expected, or what a profile measures, but "
                            "the scenario has neither 'expect' nor 'profile'");
}

/* --- its cases --- */

/* From here on no other case is in the document. */
static void forget_others(fw_node *node)
{
    static const char *const of_sweep[] = {"points", "set", NULL};
    for (int n = 0; of_sweep[n]; ++n) {
        const fw_node *other = fw_node_find(node, of_sweep[n]);
        if (other) fw_node_remove(node, other);
    }
    fw_node *parameters = fw_node_find(node, "parameters");
    for (fw_node *one = parameters->first; one; one = one->next)
        for (const fw_node *key = one->first; key;) {
            const fw_node *next = key->next;
            if (strcmp(key->key, "unit") != 0) fw_node_remove(one, key);
            key = next;
        }
}

/* Constants have the values of the case, and all formulas too. */
static fw_status apply_constants(fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    char setting[FW_NAME_BYTES + FW_NUMBER_TEXT + 16], value[FW_NUMBER_TEXT];
    const char *const settings[] = {setting};
    bool any = false;
    for (int p = 0; p < sweep->parameter_count; ++p) {
        if (!is_constant(scenario, sweep->parameters[p].name)) continue;
        fw_number_write(value, sweep->values[p]);
        snprintf(setting, sizeof setting, "parameters.%s=%s", sweep->parameters[p].name, value);
        FW_TRY(fw_settings_apply(scenario->document, &fw_scenario_section, settings, 1, error));
        any = true;
    }
    return any ? fw_schema_check(scenario->document, &fw_scenario_section, error) : FW_OK;
}

static fw_status apply_case(fw_scenario *scenario, fw_node *node, const fw_node *set,
                            fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    const char **settings;
    int count = 0;
    FW_TRY(apply_constants(scenario, error));
    FW_TRY(fw_scenario_allocate(scenario, set ? (size_t)set->count : 0, sizeof *settings, &settings,
                                error));
    for (const fw_node *item = set ? set->first : NULL; item; item = item->next)
        FW_TRY(substitute(scenario, item, sweep->values, NULL, &settings[count++], error));
    FW_TRY(fw_settings_apply(scenario->document, &fw_scenario_section, settings, count, error));
    forget_others(node);
    return fw_schema_check(scenario->document, &fw_scenario_section, error);
}

/* What the document says is one of the cases; a case that was made before says nothing of the
 * others, and is its own. */
static fw_status choose_case(fw_scenario *scenario, const fw_node *one, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    double *point;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)sweep->parameter_count, sizeof *point, &point,
                                error));
    FW_TRY(fw_scenario_read_point(scenario, one, true, point, error));
    if (sweep->case_count > 0) FW_TRY(fw_scenario_check_point(scenario, one, point, error));
    sweep->values = point;
    sweep->case_count = 1;
    sweep->is_case = true;
    return FW_OK;
}

fw_status fw_scenario_read_sweep(fw_scenario *scenario, fw_error *error)
{
    int count;
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    const fw_node *study = fw_scenario_part(scenario, "study", &count);
    fw_node *node = study ? fw_node_find(study, "sweep") : NULL;
    if (!node) return FW_OK;
    sweep->place = node->key_place;
    const fw_node *set = fw_node_find(node, "set"), *one = fw_node_find(node, "case");
    FW_TRY(fw_scenario_read_parameters(scenario, node, one && !set, error));
    /* A case that was made before has neither settings nor values, but what it is. */
    const bool known = one && !set && sweep->case_count == 0;
    if (!known) FW_TRY(read_settings(scenario, set, error));
    FW_TRY(check_measured(scenario, error));
    if (!one) return FW_OK;
    FW_TRY(choose_case(scenario, one, error));
    return known ? FW_OK : apply_case(scenario, node, set, error);
}

int fw_scenario_case_name(const fw_scenario *scenario, int number, char name[FW_CASE_NAME])
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    int length = 0;
    for (int p = 0; p < sweep->parameter_count; ++p) {
        char value[FW_NUMBER_TEXT];
        const size_t used = length < FW_CASE_NAME ? (size_t)length : FW_CASE_NAME - 1;
        fw_number_write(value, fw_sweep_value(sweep, number, p));
        length += snprintf(name + used, FW_CASE_NAME - used, "%s%s=%s", p > 0 ? "," : "",
                           sweep->parameters[p].name, value);
    }
    return length;
}

fw_status fw_scenario_fail_case(const fw_scenario *sweep, int number, fw_status status,
                                fw_error *error)
{
    char name[FW_CASE_NAME];
    fw_scenario_case_name(sweep, number, name);
    return fw_scenario_fail_within(sweep, sweep->study.sweep.place, status, error, "the case %s",
                                   name);
}
