/* SPDX-License-Identifier: GPL-3.0-or-later */
/* analysis.c - the kinds of analyses, and the memory of their results. Keeps no state. Start
 * reading at fw_analysis_create(). */
#include "analysis_parts.h"

#include "core/array.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    fw_status (*compute)(fw_analysis *analysis, const fw_scenario *scenario, fw_error *error);
} kinds[] = {
    [FW_ANALYSIS_STABILITY_MAP] = {"stability-map", fw_analysis_map},
    [FW_ANALYSIS_DISPERSION] = {"dispersion", fw_analysis_dispersion},
    [FW_ANALYSIS_PLANE_MODE] = {"plane-mode", fw_analysis_mode},
    [FW_ANALYSIS_BODY_STABILITY] = {"body-stability", fw_analysis_body},
    [FW_ANALYSIS_BOLTZMANN_REFERENCE] = {"boltzmann-reference", fw_analysis_reference},
};

double *fw_analysis_add(fw_analysis *analysis, const char *name, const char *unit,
                        const char *meaning, int rows, int columns, fw_error *error)
{
    assert(analysis->table_count < FW_ANALYSIS_TABLES_MAX);
    fw_table *table = &analysis->tables[analysis->table_count];
    *table = (fw_table){.name = name,
                        .unit = unit,
                        .meaning = meaning,
                        .rank = columns > 0 ? 2 : 1,
                        .extent = {rows, columns}};
    table->values = fw_array_of_doubles((size_t)fw_table_size(table));
    if (table->values)
        analysis->table_count += 1;
    else
        fw_fail_memory(error, "the arrays of an analysis");
    return table->values;
}

fw_status fw_analysis_create(fw_analysis **analysis, const fw_scenario *scenario, int number,
                             fw_error *error)
{
    const fw_scenario_analysis *what = &scenario->analyses[number];
    *analysis = NULL;
    fw_analysis *made = calloc(1, sizeof *made);
    if (!made) return fw_fail_memory(error, "an analysis");
    made->what = what;
    const fw_status status = kinds[what->kind].compute(made, scenario, error);
    if (status != FW_OK) {
        fw_analysis_destroy(made);
        return fw_scenario_fail_within(scenario, what->place, status, error, "analysis %s",
                                       what->name);
    }
    *analysis = made;
    return FW_OK;
}

void fw_analysis_destroy(fw_analysis *analysis)
{
    if (!analysis) return;
    for (int n = 0; n < analysis->table_count; ++n) free(analysis->tables[n].values);
    free(analysis);
}

const char *fw_analysis_kind_name(fw_analysis_kind kind)
{
    return kinds[kind].name;
}

const fw_table *fw_analysis_find(const fw_analysis *analysis, const char *name)
{
    for (int n = 0; n < analysis->table_count; ++n)
        if (strcmp(analysis->tables[n].name, name) == 0) return &analysis->tables[n];
    return NULL;
}
