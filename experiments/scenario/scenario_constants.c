/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_constants.c - the named numbers under `parameters`: their values, and whether anything
 * depends on one. Keeps no state. */
#include "experiments/text/formula.h"
#include "scenario_parts.h"

#include <string.h>

static bool text_names(const char *text, const char *name)
{
    size_t end;
    return fw_formula_find(text, strlen(text), 0, &(fw_variable){name, 0}, 1, &end) == 0;
}

/* Does any formula below name it? In lists of settings any text is one. */
static bool tree_names(const fw_node *node, const char *name)
{
    if (node->formula && text_names(node->formula, name)) return true;
    const bool settings = node->key && (!strcmp(node->key, "set") || !strcmp(node->key, "control"));
    for (const fw_node *child = node->first; child; child = child->next)
        if (tree_names(child, name) ||
            (settings && child->kind == FW_SCALAR && text_names(child->text, name)))
            return true;
    return false;
}

bool fw_scenario_needs_constant(const fw_scenario *scenario, const char *name)
{
    int count;
    const fw_node *constants = fw_scenario_part(scenario, "parameters", &count);
    for (const fw_node *part = fw_document_root(scenario->document)->first; part; part = part->next)
        if (part != constants && tree_names(part, name)) return true;
    /* They do not need each other in circles. */
    for (const fw_node *other = constants ? constants->first : NULL; other; other = other->next)
        if (other->formula && text_names(other->formula, name) &&
            fw_scenario_needs_constant(scenario, other->key))
            return true;
    return false;
}

int fw_scenario_constants(const fw_scenario *scenario, fw_variable *variables)
{
    int count;
    const fw_node *constants = fw_scenario_part(scenario, "parameters", &count);
    count = 0;
    for (const fw_node *node = constants ? constants->first : NULL; node; node = node->next)
        variables[count++] = (fw_variable){node->key, fw_node_number(node)};
    return count;
}

fw_status fw_scenario_check_constants(const fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *constants = fw_scenario_part(scenario, "parameters", &count);
    for (const fw_node *node = constants ? constants->first : NULL; node; node = node->next)
        if (node->place.setting > 0 && !scenario->study.sweep.is_case &&
            !fw_scenario_needs_constant(scenario, node->key))
            return fw_scenario_fail(scenario, node->place, error,
                                    "the parameter %s changes nothing: no formula names it",
                                    node->key);
    return FW_OK;
}
