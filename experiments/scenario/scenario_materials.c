/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_materials.c - the table of materials, and those of a scenario. Keeps no state. Start
 * reading at fw_scenario_read_materials(). */
#include "scenario_parts.h"

#include <string.h>

#define MODEL(id, member, word, meaning) &fw_##member##_material,
static const fw_material_model *const models[] = {FW_MATERIAL_ROWS(MODEL)};

#define KEY(id, member, word, says)                                                                \
    {word, AT_OBJECT(fw_scenario_material, member), ALTERNATIVE,                                   \
     .subsection = &fw_##member##_section, .meaning = says},
static const fw_key keys[] = {FW_MATERIAL_ROWS(KEY){.name = NULL}};

const fw_section fw_material_section = {"`materials.NAME`", "a material",
                                        "What a body is made of: one model of a solid.",
                                        .keys = keys};

const fw_material_model *fw_material_model_of(fw_material_kind kind)
{
    return models[kind];
}

double fw_material_break_at(const fw_scenario_material *material)
{
    double stretch = 0;
    const size_t offset = models[material->kind]->break_at;
    if (offset > 0) memcpy(&stretch, (const char *)material + offset, sizeof stretch);
    return stretch;
}

const fw_sym2 *fw_material_link_stiffness(const fw_scenario_material *material)
{
    const size_t offset = models[material->kind]->link_stiffness;
    return offset > 0 ? (const fw_sym2 *)(const void *)((const char *)material + offset) : NULL;
}

double fw_material_time_unit(const fw_scenario_material *material)
{
    const fw_material_model *model = models[material->kind];
    return model->time_unit ? model->time_unit(material) : 0;
}

const fw_material_model *fw_scenario_model(const fw_scenario *scenario, int body)
{
    return models[scenario->materials[scenario->bodies[body].material].kind];
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
        while (strcmp(keys[kind].name, node->first->key) != 0) ++kind;
        material->name = node->key;
        material->place = node->key_place;
        material->kind = (fw_material_kind)kind;
        FW_TRY(fw_schema_fill(scenario->document, &fw_material_section, node, material, error));
        if (models[kind]->read) FW_TRY(models[kind]->read(scenario, node->first, material, error));
    }
    return FW_OK;
}

fw_status fw_scenario_check_materials(const fw_scenario *scenario, fw_error *error)
{
    for (int kind = 0; kind < FW_MATERIAL_KINDS; ++kind)
        if (models[kind]->check_bodies) FW_TRY(models[kind]->check_bodies(scenario, error));
    return FW_OK;
}
