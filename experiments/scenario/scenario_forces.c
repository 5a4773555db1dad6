/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_forces.c - external forces of a scenario. Keeps no state. Start reading at
 * fw_scenario_read_forces(). */
#include "scenario_parts.h"

static const fw_key force_keys[] = {
    {"body", FW_FORM_NAME, REQUIRED, NOT_STORED, .meaning = "one of `bodies`"},
    {"sites", SELECTION, .default_value = "all", NOT_STORED, .meaning = "which of its particles"},
    {"force", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED, .unit = "force",
     .meaning = "on each particle"},
    {"total", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED, .unit = "force",
     .meaning = "shared equally among the particles"},
    {"acceleration", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED,
     .unit = "length/time^2", .meaning = "times the mass of each particle, as gravity"},
    {"random", AT_NUMBER(fw_scenario_force, random), ALTERNATIVE, ABOVE_ZERO, .unit = "force",
     .meaning = "on each particle and in each step anew: both components uniform between minus and "
                "plus this"},
    {"balanced", AT_FLAG(fw_scenario_force, balanced), .needs = "random", .default_value = "false",
     .meaning = "the random forces of a step add up to zero"},
    {"from", AT_INTEGER(fw_scenario_force, from), AT_LEAST(0), .default_value = "0",
     .unit = "steps", .meaning = "first step in which it acts"},
    {"until", AT_INTEGER(fw_scenario_force, until), AT_LEAST(1),
     .default_value = "9223372036854775807", .default_meaning = "the end", .unit = "steps",
     .meaning = "first step in which it no longer acts"},
    {"ramp", AT_INTEGER(fw_scenario_force, ramp), AT_LEAST(0), .default_value = "0",
     .unit = "steps", .meaning = "grows to its full size over so many steps after `from`"},
    {"period", AT_NUMBER(fw_scenario_force, period), ABOVE_ZERO, .default_meaning = "constant",
     .unit = "steps", .meaning = "times sin(360 step / period + phase)"},
    {"phase", AT_ANGLE(fw_scenario_force, phase), .needs = "period", FROM_TO(-360, 360),
     .default_value = "0", .unit = "degrees", .meaning = "at step 0"},
    {.name = NULL}};

const fw_section fw_force_section = {"`forces.NAME`", "a force",
                                     "An external force on selected particles of one body.",
                                     .keys = force_keys};

static fw_status read_force(fw_scenario *scenario, const fw_node *node, fw_scenario_force *force,
                            fw_error *error)
{
    static const struct {
        const char *key;
        fw_force_kind kind;
    } kinds[] = {{"force", FW_FORCE_EACH},
                 {"total", FW_FORCE_TOTAL},
                 {"acceleration", FW_FORCE_ACCELERATION}};
    force->name = node->key;
    force->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, &fw_force_section, node, force, error));
    int count;
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "bodies", &count), "body",
                            fw_node_find(node, "body"), &force->body, error));
    FW_TRY(fw_scenario_read_selection(scenario, node, &scenario->bodies[force->body], &force->sites,
                                      error));
    force->kind = FW_FORCE_RANDOM;
    for (size_t n = 0; n < sizeof kinds / sizeof kinds[0]; ++n) {
        const fw_node *vector = fw_node_find(node, kinds[n].key);
        if (!vector) continue;
        force->kind = kinds[n].kind;
        force->vector = (fw_vec2){fw_node_number(vector->first), fw_node_number(vector->last)};
    }
    const fw_node *from = fw_node_find(node, "from");
    if (from && force->from >= scenario->run.steps)
        return fw_scenario_fail(scenario, from->place, error,
                                "forces.%s.from is %lld, expected less than the %lld steps of the "
                                "run: it would never act",
                                node->key, (long long)force->from, (long long)scenario->run.steps);
    if (force->until <= force->from)
        return fw_scenario_fail(scenario, fw_node_find(node, "until")->place, error,
                                "forces.%s.until is %lld, expected more than 'from', which is %lld",
                                node->key, (long long)force->until, (long long)force->from);
    return FW_OK;
}

fw_status fw_scenario_read_forces(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "forces", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->forces,
                                &scenario->forces, error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_force(scenario, node, &scenario->forces[scenario->force_count++], error));
    return FW_OK;
}
