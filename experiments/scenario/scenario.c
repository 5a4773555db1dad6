/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario.c - from a text to plain data: parse, apply --set, check every key, fill in, check what
 * belongs together. Keeps no state beyond the scenario it makes.
 * Start reading at build(). */
#include "experiments/scenario/scenario.h"

#include "experiments/schema/settings.h"
#include "experiments/text/number.h"
#include "experiments/text/spelling.h"
#include "experiments/text/text.h"
#include "scenario_parts.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const fw_key scenario_keys[] = {
    {"title", AT_TEXT(fw_scenario, title), REQUIRED,
     .meaning = "what the experiment shows, in one line"},
    {"source", AT_TEXT(fw_scenario, source), .default_meaning = "none",
     .meaning = "paper and figure that it reproduces"},
    {"figure", AT_TEXT(fw_scenario, figure), .default_meaning = "none",
     .meaning = "short name of that figure, for `fretwork list`"},
    {"group", AT_WORD(fw_scenario, group),
     WORDS({"own", FW_GROUP_OWN}, {"start-here", FW_GROUP_START_HERE},
           {"lb-solid", FW_GROUP_LB_SOLID}, {"elastic-automaton", FW_GROUP_ELASTIC_AUTOMATON},
           {"movable-particles", FW_GROUP_MOVABLE_PARTICLES},
           {"walls-and-contact", FW_GROUP_WALLS_AND_CONTACT}, {"friction", FW_GROUP_FRICTION},
           {"studies", FW_GROUP_STUDIES}),
     .default_value = "own", .meaning = "what it is good for, for `fretwork list`"},
    {"takes", AT_NUMBER(fw_scenario, takes), ABOVE_ZERO, .default_meaning = "unknown",
     .unit = "seconds", .meaning = "how long a run took on two processors, for `fretwork list`"},
    {"small", AT_NAME(fw_scenario, small), .default_meaning = "none",
     .meaning = "named experiment that stands for this one where time is short: `fretwork verify` "
                "without names leaves this one to `--full`"},
    {"about", AT_TEXT(fw_scenario, about), .default_meaning = "none",
     .meaning = "anything else a reader should know"},
    {"parameters", FW_FORM_CONSTANTS, NOT_STORED, .default_meaning = "none",
     .hint = "such as {A: 2, F: 24*A}",
     .meaning = "named numbers, which formulas in the place of any number may use, as `24*A`; a "
                "sweep may vary them. Formulas are those of `study.sweep`"},
    {"units", AT_OBJECT(fw_scenario, units), .subsection = &fw_units_section,
     .default_meaning = "reduced units alone", .meaning = "what the reduced units are in nature"},
    {"materials", FW_FORM_NAMED, .subsection = &fw_material_section, .least = 1,
     .most = FW_NAMED_MAX, REQUIRED, NOT_STORED, .meaning = "materials by name"},
    {"bodies", FW_FORM_NAMED, .subsection = &fw_body_section, .least = 1, .most = FW_NAMED_MAX,
     REQUIRED, NOT_STORED, .meaning = "bodies by name"},
    {"walls", FW_FORM_NAMED, .subsection = &fw_wall_section, .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "none", .meaning = "walls by name"},
    {"forces", FW_FORM_NAMED, .subsection = &fw_force_section, .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "none", .meaning = "forces by name; those on the same particle add up"},
    {"grips", FW_FORM_NAMED, .subsection = &fw_grip_section, .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "none", .meaning = "rigid blocks of particles by name"},
    {"phases", FW_FORM_NAMED, .subsection = &fw_phase_section, .most = FW_NAMED_MAX, NOT_STORED,
     .default_meaning = "one phase, the whole run",
     .meaning = "parts of the run by name, in order"},
    {"profile", FW_FORM_MAPPING, .subsection = &fw_profile_section, NOT_STORED,
     .default_meaning = "none", .meaning = "what is averaged across the scene"},
    {"study", FW_FORM_MAPPING, .subsection = &fw_study_section, NOT_STORED,
     .default_meaning = "one run", .meaning = "replicas over seeds, and a control"},
    {"dynamics", AT_OBJECT(fw_scenario, dynamics), .subsection = &fw_dynamics_section,
     .default_meaning = "its defaults",
     .meaning = "how movable particles and linear lattices move"},
    {"contact", FW_FORM_MAPPING, .subsection = &fw_contact_section, NOT_STORED,
     .default_meaning = "frictionless", .meaning = "how bodies that keep out of each other rub"},
    {"run", AT_OBJECT(fw_scenario, run), .subsection = &fw_run_section, REQUIRED,
     .meaning = "how long, and what happens on the way"},
    {"record", AT_OBJECT(fw_scenario, record), .subsection = &fw_record_section,
     .default_meaning = "positions and velocities",
     .meaning = "what the results file holds of each particle"},
    {"measure", AT_NAMES(FW_FORM_PATH, fw_scenario, measure), .most = 256,
     .default_meaning = "a standard set",
     .meaning = "observables to be measured, beside those that `expect` and `pictures` name"},
    {"expect", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = &fw_expectation_section,
     .most = FW_NAMED_MAX, NOT_STORED, .default_meaning = "nothing",
     .meaning = "what must come out"},
    {"pictures", FW_FORM_NAMED, .subsection = &fw_picture_section, .most = 64, NOT_STORED,
     .default_meaning = "the motion", .meaning = "pictures by name"},
    {"analysis", FW_FORM_NAMED, .subsection = &fw_analysis_section, .most = 64, NOT_STORED,
     .default_meaning = "none", .meaning = "what is computed without running, by name"},
    {.name = NULL}};

const fw_section fw_scenario_section = {
    "The scenario", "a scenario", "The keys at the beginning of a line.", .keys = scenario_keys};

fw_status fw_scenario_fail(const fw_scenario *scenario, fw_place place, fw_error *error,
                           const char *format, ...)
{
    char sentence[FW_SENTENCE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    return fw_document_fail(scenario->document, place, error, "%s", sentence);
}

fw_status fw_scenario_fail_again(const fw_scenario *scenario, fw_place place, fw_status status,
                                 fw_error *error)
{
    if (status != FW_BAD_INPUT) return status;
    const fw_error inner = *error;
    return fw_document_fail(scenario->document, place, error, "%s", inner.sentence);
}

fw_status fw_scenario_fail_within(const fw_scenario *scenario, fw_place place, fw_status status,
                                  fw_error *error, const char *format, ...)
{
    if (status != FW_BAD_INPUT) return status;
    char part[FW_SENTENCE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(part, sizeof part, format, arguments);
    va_end(arguments);
    fw_fail_within(error, "%s", part);
    return fw_scenario_fail_again(scenario, place, status, error);
}

const fw_node *fw_scenario_part(const fw_scenario *scenario, const char *key, int *count)
{
    const fw_node *part = fw_node_find(fw_document_root(scenario->document), key);
    *count = part ? part->count : 0;
    return part;
}

fw_status fw_scenario_allocate(const fw_scenario *scenario, size_t count, size_t size, void *room,
                               fw_error *error)
{
    void *made = fw_document_allocate(scenario->document, count, size);
    memcpy(room, &made, sizeof made);
    return made ? FW_OK : fw_document_fail_memory(scenario->document, error);
}

fw_status fw_scenario_find(const fw_scenario *scenario, const fw_node *named, const char *kind,
                           const fw_node *name, int *index, fw_error *error)
{
    fw_suggestion suggestion = fw_suggestion_begin(name->text);
    *index = 0;
    for (const fw_node *child = named ? named->first : NULL; child; child = child->next) {
        if (!strcmp(child->key, name->text)) return FW_OK;
        fw_suggestion_offer(&suggestion, child->key);
        *index += 1;
    }
    *index = -1;
    if (suggestion.best)
        return fw_scenario_fail(scenario, name->place, error,
                                "there is no %s '%s'; did you mean '%s'?", kind, name->text,
                                suggestion.best);
    if (!named || !named->first)
        return fw_scenario_fail(scenario, name->place, error,
                                "there is no %s '%s': the scenario has none at all", kind,
                                name->text);
    return fw_scenario_fail(scenario, name->place, error,
                            "there is no %s '%s', expected one that the scenario names, such as "
                            "'%s'",
                            kind, name->text, named->first->key);
}

static fw_status refuse_lines(const fw_scenario *scenario, const char *key, fw_error *error)
{
    int count;
    const fw_node *node = fw_scenario_part(scenario, key, &count);
    if (!node || !strchr(node->text, '\n')) return FW_OK;
    return fw_scenario_fail(scenario, node->place, error,
                            "%s has more than one line, expected one; longer texts belong in "
                            "'about'",
                            key);
}

static fw_status refuse_twins(const fw_scenario *scenario, const char *what,
                              const fw_schema_names *names, fw_error *error)
{
    for (int n = 1; n < names->count; ++n)
        for (int m = 0; m < n; ++m)
            if (!strcmp(names->item[n].text, names->item[m].text))
                return fw_scenario_fail(scenario, names->item[n].place, error,
                                        "%s names '%s' twice", what, names->item[n].text);
    return FW_OK;
}

static fw_status read_units(fw_scenario *scenario, fw_error *error)
{
    const char *key;
    int count;
    const fw_status status = fw_units_complete(&scenario->units, &key, error);
    const fw_node *units = fw_scenario_part(scenario, "units", &count);
    if (status != FW_BAD_INPUT) return status;
    return fw_scenario_fail_again(scenario, fw_node_find(units, key)->place, status, error);
}

static fw_status build(fw_scenario *scenario, const char *const *settings, int setting_count,
                       fw_error *error)
{
    fw_document *document = scenario->document;
    FW_TRY(fw_settings_apply(document, &fw_scenario_section, settings, setting_count, error));
    FW_TRY(fw_schema_check(document, &fw_scenario_section, error));
    FW_TRY(fw_scenario_take_files(scenario, error));
    FW_TRY(fw_scenario_read_sweep(scenario, error));
    FW_TRY(fw_scenario_check_constants(scenario, error));
    FW_TRY(fw_schema_fill(document, &fw_scenario_section, fw_document_root(document), scenario,
                          error));
    FW_TRY(refuse_lines(scenario, "title", error));
    FW_TRY(refuse_lines(scenario, "figure", error));
    FW_TRY(read_units(scenario, error));
    FW_TRY(fw_scenario_complete_run(scenario, error));
    FW_TRY(refuse_twins(scenario, "measure", &scenario->measure, error));
    FW_TRY(refuse_twins(scenario, "record.fields", &scenario->record.fields, error));
    FW_TRY(fw_scenario_read_materials(scenario, error));
    FW_TRY(fw_scenario_read_bodies(scenario, error));
    FW_TRY(fw_scenario_check_materials(scenario, error));
    FW_TRY(fw_scenario_check_dynamics(scenario, error));
    FW_TRY(fw_scenario_read_walls(scenario, error));
    FW_TRY(fw_scenario_read_contact(scenario, error));
    FW_TRY(fw_scenario_read_forces(scenario, error));
    FW_TRY(fw_scenario_read_grips(scenario, error));
    FW_TRY(fw_scenario_read_phases(scenario, error));
    FW_TRY(fw_scenario_read_study(scenario, error));
    FW_TRY(fw_scenario_read_analyses(scenario, error));
    FW_TRY(fw_scenario_read_expectations(scenario, error));
    return fw_scenario_read_pictures(scenario, error);
}

/* Takes the document over, whatever happens. The control of its study is not looked at. */
static fw_status make(fw_scenario **scenario, fw_document *document, const char *const *settings,
                      int setting_count, fw_error *error)
{
    *scenario = calloc(1, sizeof **scenario);
    if (!*scenario) {
        fw_document_destroy(document);
        return fw_fail_memory(error, "a scenario");
    }
    (*scenario)->document = document;
    fw_status status = build(*scenario, settings, setting_count, error);
    if (status == FW_OK) return FW_OK;
    fw_scenario_destroy(*scenario);
    *scenario = NULL;
    return status;
}

/* The control must be a scenario as well: better refused now than after the runs of the experiment.
 */
static fw_status check_control(const fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_study *study = &scenario->study;
    fw_document *document;
    fw_scenario *control;
    if (study->control_count == 0) return FW_OK;
    FW_TRY(fw_document_clone(&document, scenario->document, error));
    const fw_status status = make(&control, document, study->control, study->control_count, error);
    fw_scenario_destroy(control);
    return fw_scenario_fail_within(scenario, study->control_place, status, error, "control");
}

static fw_status create(fw_scenario **scenario, fw_document *document, const char *const *settings,
                        int setting_count, fw_error *error)
{
    FW_TRY(make(scenario, document, settings, setting_count, error));
    const fw_status status = check_control(*scenario, error);
    if (status == FW_OK) return FW_OK;
    fw_scenario_destroy(*scenario);
    *scenario = NULL;
    return status;
}

fw_status fw_scenario_read(fw_scenario **scenario, const char *file, const char *text,
                           size_t length, const char *const *settings, int setting_count,
                           fw_error *error)
{
    *scenario = NULL;
    fw_document *document;
    FW_TRY(fw_document_parse(&document, file, text, length, error));
    return create(scenario, document, settings, setting_count, error);
}

fw_status fw_scenario_load(fw_scenario **scenario, const char *path, const char *const *settings,
                           int setting_count, fw_error *error)
{
    *scenario = NULL;
    fw_document *document;
    FW_TRY(fw_document_load(&document, path, error));
    return create(scenario, document, settings, setting_count, error);
}

bool fw_scenario_is_sweep(const fw_scenario *scenario)
{
    return scenario->study.sweep.case_count > 0 && !scenario->study.sweep.is_case;
}

fw_status fw_scenario_read_case(fw_scenario **made, const fw_scenario *sweep, int number,
                                fw_error *error)
{
    const fw_scenario_sweep *plan = &sweep->study.sweep;
    char setting[FW_PARAMETERS_MAX * (FW_NAME_BYTES + FW_NUMBER_TEXT + 4) + 32];
    const char *const settings[] = {setting};
    fw_document *document;
    *made = NULL;
    snprintf(setting, sizeof setting, "study.sweep.case={");
    for (int p = 0; p < plan->parameter_count; ++p) {
        char value[FW_NUMBER_TEXT];
        fw_number_write(value, fw_sweep_value(plan, number, p));
        fw_text_append(setting, sizeof setting, "%s%s: %s", p > 0 ? ", " : "",
                       plan->parameters[p].name, value);
    }
    fw_text_append(setting, sizeof setting, "}");
    FW_TRY(fw_document_clone(&document, sweep->document, error));
    const fw_status status = create(made, document, settings, 1, error);
    return fw_scenario_fail_case(sweep, number, status, error);
}

void fw_scenario_destroy(fw_scenario *scenario)
{
    if (!scenario) return;
    for (int n = 0; n < scenario->body_count; ++n) fw_sites_clear(&scenario->bodies[n].shape.sites);
    fw_document_destroy(scenario->document);
    free(scenario);
}

fw_status fw_scenario_print(const fw_scenario *scenario, char **text, fw_error *error)
{
    *text = NULL;
    size_t length;
    FILE *out = open_memstream(text, &length);
    fw_status status = out ? fw_document_print(scenario->document, out, error) : FW_OK;
    if (!out || fclose(out) != 0) status = fw_fail_memory(error, "the scenario as run");
    if (status != FW_OK) {
        free(*text);
        *text = NULL;
    }
    return status;
}
