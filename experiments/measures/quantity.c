/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quantity.c - the tables of all quantities as one. Keeps no state. Start reading at
 * fw_quantity_find(). */
#include "experiments/measures/quantity.h"

#include <string.h>

static const fw_quantity *const tables[] = {
    fw_common_quantities,      fw_shape_quantities,     fw_contact_quantities,
    fw_elastic_quantities,     fw_boltzmann_quantities, fw_particle_quantities,
    fw_automaton_quantities,   fw_grip_quantities,      fw_piston_quantities,
    fw_certificate_quantities, fw_layer_quantities,     NULL};

const fw_renamed_quantity fw_renamed_quantities[] = {
    {"grip-way", "grip-path-length"},
    {"layer-exchanges", "layer-bond-breaking"},
    {"layer-exchanges-far", "layer-bond-breaking-far"},
    {"layer-exchanges-over-control", "layer-bond-breaking-over-control"},
    {"layer-exchanges-over-far", "layer-bond-breaking-over-far"},
    {"layer-mobility", "layer-relative-displacement"},
    {"layer-mobility-far", "layer-relative-displacement-far"},
    {"layer-mobility-over-control", "layer-relative-displacement-over-control"},
    {"layer-mobility-over-far", "layer-relative-displacement-over-far"},
    {"noise-heat", "thermostat-heat"},
    {"piston-way", "piston-path-length"},
    {"twin-error", "reference-error"},
    {"unrest", "rest-residual"},
    {"wave-way", "wave-path"},
    {NULL, NULL}};

static const fw_quantity *first_from(int table)
{
    while (tables[table] && !tables[table]->name) ++table;
    return tables[table];
}

const fw_quantity *fw_quantity_first(void)
{
    return first_from(0);
}

const fw_quantity *fw_quantity_next(const fw_quantity *quantity)
{
    if (quantity[1].name) return quantity + 1;
    for (int table = 0; tables[table]; ++table)
        for (const fw_quantity *q = tables[table]; q->name; ++q)
            if (q == quantity) return first_from(table + 1);
    return NULL;
}

const fw_quantity *fw_quantity_find(const char *name)
{
    for (const fw_quantity *quantity = fw_quantity_first(); quantity;
         quantity = fw_quantity_next(quantity))
        if (strcmp(quantity->name, name) == 0) return quantity;
    return NULL;
}

bool fw_quantity_fits(const fw_quantity *quantity, const char *model)
{
    const size_t length = strlen(model);
    if (!quantity->model) return true;
    for (const char *at = quantity->model; *at; at += at[0] == ' ') {
        const size_t word = strcspn(at, " ");
        if (word == length && memcmp(at, model, length) == 0) return true;
        at += word;
    }
    return false;
}

int fw_quantity_component_count(const fw_quantity *quantity)
{
    int count = 1;
    for (const char *c = quantity->components; *c; ++c) count += *c == ' ';
    return count;
}

void fw_quantity_component_name(const fw_quantity *quantity, int component, char name[8])
{
    const char *at = quantity->components;
    for (; component > 0; --component) at += strcspn(at, " ") + 1;
    size_t length = strcspn(at, " ");
    memcpy(name, at, length);
    name[length] = '\0';
}

int fw_quantity_find_component(const fw_quantity *quantity, const char *name)
{
    for (int c = 0; c < fw_quantity_component_count(quantity); ++c) {
        char own[8];
        fw_quantity_component_name(quantity, c, own);
        if (strcmp(own, name) == 0) return c;
    }
    return -1;
}
