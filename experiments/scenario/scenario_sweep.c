/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_sweep.c - the sweep of a study, and how a scenario becomes one of its cases: the case's
 * settings are applied to the document, which from then on says only which case it is. So a case as
 * it was run reads back as what it is, and a later change of it (its control) is not undone.
 * Keeps no state. Start reading at fw_scenario_read_sweep(). */
#include "experiments/schema/settings.h"
#include "experiments/text/number.h"
#include "experiments/text/substitution.h"
#include "experiments/text/text.h"
#include "scenario_parts.h"

#include <string.h>

static const fw_key sweep_keys[] = {
    {"parameter", AT_NAME(fw_scenario_sweep, parameter), REQUIRED,
     .meaning = "a name of your own for what is varied"},
    {"unit", AT_TEXT(fw_scenario_sweep, unit), .default_meaning = "none",
     .meaning = "of the parameter, for the axis of pictures"},
    {"values", FW_FORM_LIST, .items = FW_FORM_NUMBER, .least = 1, .most = 1024, REQUIRED,
     NOT_STORED, .meaning = "of the parameter, all different, in the order in which they are run"},
    {"set", FW_FORM_LIST, .items = FW_FORM_TEXT, .least = 1, .most = 64, NOT_STORED,
     .default_meaning = "required without `case`",
     .meaning = "changes, as `--set` has them; in their values the parameter, or a number times it "
                "as `24*A`, stands for its value"},
    {"case", FW_FORM_NUMBER, NOT_STORED, .default_meaning = "all of them",
     .meaning = "the only value to be run, as a study by itself"},
    {.name = NULL}};

const fw_section fw_sweep_section = {
    "`study.sweep`", "a sweep",
    "One study after the other, each with its results in `DIR/PARAMETER=VALUE`. "
    "`DIR/sweep.csv` has means and standard errors of what is expected, and of the layer's "
    "measures, against the parameter.",
    .keys = sweep_keys};

/* --- the sweep --- */

static fw_status read_values(fw_scenario *scenario, const fw_node *list, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *sweep->values,
                                &sweep->values, error));
    for (const fw_node *node = list->first; node; node = node->next) {
        const double value = fw_node_number(node);
        for (int n = 0; n < sweep->value_count; ++n)
            if (sweep->values[n] == value)
                return fw_scenario_fail(scenario, node->place, error,
                                        "study.sweep.values has %s twice, expected values that "
                                        "differ",
                                        node->text);
        sweep->values[sweep->value_count++] = value;
    }
    return FW_OK;
}

/* The setting for a value of the parameter, in memory of the document. */
static fw_status substitute(const fw_scenario *scenario, const fw_node *item, double value,
                            const char **setting, fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    char *text;
    FW_TRY(fw_scenario_allocate(scenario, fw_substitution_room(item->length), sizeof *text, &text,
                                error));
    *setting = text;
    if (fw_substitution_write(item->text, sweep->parameter.text, value, text) > 0) return FW_OK;
    return fw_scenario_fail(scenario, item->place, error,
                            "the parameter %s does not occur in the setting '%s', expected "
                            "KEY=VALUE with %s, or a number times it such as 2*%s, in the value",
                            sweep->parameter.text, fw_text_quote(item->text, item->length).text,
                            sweep->parameter.text, sweep->parameter.text);
}

static fw_status check_setting(const fw_scenario *scenario, const fw_node *item, fw_error *error)
{
    const char *unused;
    FW_TRY(substitute(scenario, item, 1, &unused, error));
    if (strcspn(item->text, ".=") != strlen("study") ||
        strncmp(item->text, "study", strlen("study")) != 0)
        return FW_OK;
    return fw_scenario_fail(scenario, item->place, error,
                            "the setting '%s' changes the study that it is part of, expected "
                            "another key",
                            fw_text_quote(item->text, item->length).text);
}

static fw_status read_settings(fw_scenario *scenario, const fw_node *list, fw_error *error)
{
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *sweep->settings,
                                &sweep->settings, error));
    for (const fw_node *item = list->first; item; item = item->next) {
        FW_TRY(check_setting(scenario, item, error));
        sweep->settings[sweep->setting_count++] = item->text;
    }
    return FW_OK;
}

/* It stands in one line of the table, and beside the axis of pictures. */
static fw_status check_unit(const fw_scenario *scenario, const fw_node *unit, fw_error *error)
{
    enum { LONGEST = 63 };
    bool plain = !unit || unit->length <= LONGEST;
    for (const char *c = unit ? unit->text : ""; *c; ++c) plain &= (unsigned char)*c >= ' ';
    if (plain) return FW_OK;
    return fw_scenario_fail(scenario, unit->place, error,
                            "study.sweep.unit is '%s', expected at most %d bytes in one line",
                            fw_text_quote(unit->text, unit->length).text, LONGEST);
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

fw_status fw_scenario_find_value(const fw_scenario *scenario, const fw_node *node, int *number,
                                 fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    if (sweep->value_count == 0)
        return fw_scenario_fail(scenario, node->key_place, error,
                                "'%s' names a value of a sweep, but the study has no 'sweep'",
                                node->key);
    const double value = fw_node_number(node);
    for (*number = 0; *number < sweep->value_count; ++*number)
        if (sweep->values[*number] == value) return FW_OK;
    return fw_scenario_fail(scenario, node->place, error,
                            "'%s' is %s, which is not one of the values of %s in study.sweep",
                            node->key, node->text, sweep->parameter.text);
}

static fw_status apply_case(fw_scenario *scenario, fw_node *node, const fw_node *set,
                            fw_error *error)
{
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    const char **settings;
    int count = 0;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)set->count, sizeof *settings, &settings, error));
    for (const fw_node *item = set->first; item; item = item->next)
        FW_TRY(substitute(scenario, item, sweep->values[sweep->number], &settings[count++], error));
    FW_TRY(fw_settings_apply(scenario->document, &fw_scenario_section, settings, count, error));
    fw_node_remove(node, set);
    return fw_schema_check(scenario->document, &fw_scenario_section, error);
}

fw_status fw_scenario_read_sweep(fw_scenario *scenario, fw_error *error)
{
    int count;
    fw_scenario_sweep *sweep = &scenario->study.sweep;
    const fw_node *study = fw_scenario_part(scenario, "study", &count);
    fw_node *node = study ? fw_node_find(study, "sweep") : NULL;
    if (!node) return FW_OK;
    sweep->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, &fw_sweep_section, node, sweep, error));
    FW_TRY(check_unit(scenario, fw_node_find(node, "unit"), error));
    FW_TRY(read_values(scenario, fw_node_find(node, "values"), error));
    const fw_node *set = fw_node_find(node, "set"), *one = fw_node_find(node, "case");
    if (!set && !one)
        return fw_scenario_fail(scenario, sweep->place, error,
                                "study.sweep has no 'set', which says what the values change");
    if (set) FW_TRY(read_settings(scenario, set, error));
    FW_TRY(check_measured(scenario, error));
    if (!one) return FW_OK;
    FW_TRY(fw_scenario_find_value(scenario, one, &sweep->number, error));
    sweep->is_case = true;
    return set ? apply_case(scenario, node, set, error) : FW_OK;
}

void fw_scenario_case_name(const fw_scenario *scenario, int number, char name[FW_CASE_NAME])
{
    char value[FW_NUMBER_TEXT];
    fw_number_write(value, scenario->study.sweep.values[number]);
    snprintf(name, FW_CASE_NAME, "%.*s=%s", FW_NAME_BYTES - 1, scenario->study.sweep.parameter.text,
             value);
}

fw_status fw_scenario_fail_case(const fw_scenario *sweep, int number, fw_status status,
                                fw_error *error)
{
    char name[FW_CASE_NAME];
    fw_scenario_case_name(sweep, number, name);
    return fw_scenario_fail_within(sweep, sweep->study.sweep.place, status, error, "the case %s",
                                   name);
}
