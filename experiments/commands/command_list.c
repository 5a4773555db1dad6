/* SPDX-License-Identifier: GPL-3.0-or-later */
/* command_list.c - what there is to run, to measure and to write: list, show, quantities,
 * reference. */
#include "experiments/commands/command.h"
#include "experiments/measures/quantity.h"
#include "experiments/scenario/catalogue.h"
#include "experiments/scenario/schema.h"

#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"

fw_status fw_command_list(const fw_arguments *arguments, fw_error *error)
{
    (void)arguments;
    for (const fw_catalogue_entry *entry = fw_catalogue; entry->name; ++entry) {
        fw_scenario *scenario;
        FW_TRY(
            fw_scenario_read(&scenario, entry->name, entry->text, entry->length, NULL, 0, error));
        printf("%-18s %s", entry->name, scenario->title);
        if (scenario->source) printf("  [%s]", scenario->source);
        printf("\n");
        fw_scenario_destroy(scenario);
    }
    return FW_OK;
}

fw_status fw_command_show(const fw_arguments *arguments, fw_error *error)
{
    const fw_catalogue_entry *entry;
    FW_TRY(fw_catalogue_find(&entry, arguments->words[0], error));
    fwrite(entry->text, 1, entry->length, stdout);
    return FW_OK;
}

static void print_fields(const fw_solid_model *model)
{
    printf("\nFields of a %s solid (record.fields, plot --field):\n", model->name);
    for (const fw_field *field = model->fields; field->name; ++field)
        printf("  %-20s %s\n", field->name, field->meaning);
}

fw_status fw_command_quantities(const fw_arguments *arguments, fw_error *error)
{
    static const char *const scope[] = {
        [FW_SCOPE_SCENE] = "scene",       [FW_SCOPE_BODIES] = "body or scene",
        [FW_SCOPE_BODY] = "body",         [FW_SCOPE_SITE] = "site",
        [FW_SCOPE_WALL] = "wall",         [FW_SCOPE_PISTON] = "piston",
        [FW_SCOPE_GRIP] = "grip",         [FW_SCOPE_STUDY] = "study",
        [FW_SCOPE_ANALYSIS] = "analysis",
    };
    (void)arguments;
    (void)error;
    printf("Quantities (measure, expect.quantity, plot --observable):\n");
    printf("  %-20s %-14s %-12s %-16s %s\n", "name", "measured of", "components", "unit",
           "meaning");
    for (const fw_quantity *q = fw_quantity_first(); q; q = fw_quantity_next(q))
        printf("  %-20s %-14s %-12s %-16s %s\n", q->name, scope[q->scope],
               q->components[0] ? q->components : "-", q->unit, q->meaning);
    print_fields(&fw_lb_solid_model);
    print_fields(&fw_particles_model);
    print_fields(&fw_linear_lattice_model);
    print_fields(&fw_elastic_automaton_model);
    return FW_OK;
}

fw_status fw_command_reference(const fw_arguments *arguments, fw_error *error)
{
    (void)arguments;
    return fw_schema_print(stdout, error);
}
