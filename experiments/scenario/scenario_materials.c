/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_materials.c - the table of materials, and those of a scenario. Keeps no state. */
#include "scenario_parts.h"

#include <string.h>

/* Per row: key, lattices, keys of bodies, what it can, and how it is read and checked. */
static const fw_material_model models[] = {
    [FW_LATTICE_BOLTZMANN] = {{"lattice-boltzmann", AT_OBJECT(fw_scenario_material, boltzmann),
                               ALTERNATIVE, .subsection = &fw_lattice_boltzmann_section,
                               .meaning = "the lattice Boltzmann solid"},
                              .bodies = "lattice Boltzmann bodies",
                              .lattices = 1 << FW_SQUARE,
                              .why = "the lattice Boltzmann solid has four links per site",
                              .body_keys = " rest-mass link-stiffness ",
                              .break_at = offsetof(fw_scenario_material, boltzmann.break_at)},
    [FW_MOVABLE_PARTICLES] = {{"movable-particles", AT_OBJECT(fw_scenario_material, particles),
                               ALTERNATIVE, .subsection = &fw_movable_particles_section,
                               .meaning = "movable lattice particles"},
                              .bodies = "movable particles",
                              .lattices = 1 << FW_SQUARE | 1 << FW_HEXAGONAL,
                              .body_keys = " spin temperature ",
                              .can_be_placed = true,
                              .has_dynamics = true,
                              .read = fw_scenario_read_particles,
                              .check_bodies = fw_scenario_check_particles},
    [FW_LINEAR_LATTICE] = {{"linear-lattice", AT_OBJECT(fw_scenario_material, linear), ALTERNATIVE,
                            .subsection = &fw_linear_lattice_section,
                            .meaning = "the linear lattice"},
                           .bodies = "linear lattices",
                           .lattices = 1 << FW_HEXAGONAL,
                           .why = "the linear lattice has six bonds per site",
                           .body_keys = " spin temperature ",
                           .has_dynamics = true},
    [FW_ELASTIC_AUTOMATON] = {
        {"elastic-automaton", AT_OBJECT(fw_scenario_material, automaton), ALTERNATIVE,
         .subsection = &fw_elastic_automaton_section, .meaning = "the elastic automaton"},
        .bodies = "elastic automata",
        .lattices = 1 << FW_SQUARE,
        .why = "the cells of an elastic automaton are black and white in turn",
        .body_keys = " displaced-as-given ",
        .has_modes = true,
        .break_at = offsetof(fw_scenario_material, automaton.break_at),
        .read = fw_scenario_read_automaton,
        .check_body = fw_scenario_check_automaton,
        .check_bodies = fw_scenario_check_clock}};

_Static_assert(sizeof models / sizeof models[0] == FW_MATERIAL_KINDS,
               "a row for each fw_material_kind");

const fw_section fw_material_section = {"`materials.NAME`", "a material",
                                        "What a body is made of: one model of a solid.",
                                        FW_ROWS(models)};

const fw_material_model *fw_material_model_of(fw_material_kind kind)
{
    return &models[kind];
}

double fw_material_break_at(const fw_scenario_material *material)
{
    double stretch = 0;
    const size_t offset = models[material->kind].break_at;
    if (offset > 0) memcpy(&stretch, (const char *)material + offset, sizeof stretch);
    return stretch;
}

const fw_material_model *fw_scenario_model(const fw_scenario *scenario, int body)
{
    return &models[scenario->materials[scenario->bodies[body].material].kind];
}

fw_status fw_scenario_read_materials(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "materials", &count);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->materials,
                                &scenario->materials, error));
    for (const fw_node *node = part->first; node; node = node->next) {
        fw_scenario_material *material = &scenario->materials[scenario->material_count++];
        int kind = 0;
        while (strcmp(models[kind].key.name, node->first->key) != 0) ++kind;
        material->name = node->key;
        material->place = node->key_place;
        material->kind = (fw_material_kind)kind;
        FW_TRY(fw_schema_fill(scenario->document, &fw_material_section, node, material, error));
        if (models[kind].read) FW_TRY(models[kind].read(scenario, node->first, material, error));
    }
    return FW_OK;
}

fw_status fw_scenario_check_materials(const fw_scenario *scenario, fw_error *error)
{
    for (int kind = 0; kind < FW_MATERIAL_KINDS; ++kind)
        if (models[kind].check_bodies) FW_TRY(models[kind].check_bodies(scenario, error));
    return FW_OK;
}
