/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_bodies.c - materials and bodies of a scenario, with what single sites of a body start
 * with. Keeps no state. Start reading at read_body(). */
#include "scenario_parts.h"

#include <string.h>

static fw_material_kind kind_of(const char *model)
{
    static const char *const models[] = {[FW_LATTICE_BOLTZMANN] = "lattice-boltzmann",
                                         [FW_MOVABLE_PARTICLES] = "movable-particles",
                                         [FW_LINEAR_LATTICE] = "linear-lattice",
                                         [FW_ELASTIC_AUTOMATON] = "elastic-automaton"};
    int kind = 0;
    while (strcmp(models[kind], model) != 0) ++kind; /* the schema knows no other */
    return (fw_material_kind)kind;
}

fw_status fw_scenario_read_materials(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "materials", &count);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->materials,
                                &scenario->materials, error));
    for (const fw_node *node = part->first; node; node = node->next) {
        fw_scenario_material *material = &scenario->materials[scenario->material_count++];
        material->name = node->key;
        material->place = node->key_place;
        FW_TRY(fw_schema_fill(scenario->document, "material", node, material, error));
        material->kind = kind_of(node->first->key);
        if (material->kind == FW_MOVABLE_PARTICLES)
            FW_TRY(fw_scenario_read_particles(scenario, node->first, &material->particles, error));
        if (material->kind == FW_ELASTIC_AUTOMATON)
            FW_TRY(fw_scenario_read_automaton(scenario, node->first, &material->automaton, error));
    }
    return FW_OK;
}

/* --- values of single sites --- */

static fw_status read_pattern(fw_scenario *scenario, const fw_node *node,
                              const fw_scenario_body *body, fw_pattern *pattern, fw_error *error)
{
    static const char *const regular[] = {"gaussian", "wave", "plane-wave", "gradient"};
    FW_TRY(fw_scenario_read_selection(scenario, node, body, &pattern->sites, error));
    const fw_node *given;
    for (size_t n = 0; body->shape.kind == FW_SHAPE_PLACED && n < 4; ++n)
        if ((given = fw_node_find(node, regular[n])))
            return fw_scenario_fail(scenario, given->key_place, error,
                                    "'%s' in body '%s', which is placed at random, expected 'by' "
                                    "or 'random': it has no lattice for a pattern to follow",
                                    given->key, body->name);
    if ((given = fw_node_find(node, "by"))) {
        pattern->kind = FW_PATTERN_UNIFORM;
        pattern->amplitude = (fw_vec2){fw_node_number(given->first), fw_node_number(given->last)};
        return FW_OK;
    }
    if ((given = fw_node_find(node, "gaussian"))) {
        pattern->kind = FW_PATTERN_GAUSSIAN;
        return fw_schema_fill(scenario->document, "gaussian", given, pattern, error);
    }
    if ((given = fw_node_find(node, "plane-wave"))) {
        pattern->kind = FW_PATTERN_PLANE;
        return fw_schema_fill(scenario->document, "plane-wave", given, pattern, error);
    }
    if ((given = fw_node_find(node, "gradient"))) {
        pattern->kind = FW_PATTERN_GRADIENT;
        fw_node_numbers(given, pattern->gradient);
        return FW_OK;
    }
    if ((given = fw_node_find(node, "wave"))) {
        pattern->kind = FW_PATTERN_WAVE;
        return fw_schema_fill(scenario->document, "wave", given, pattern, error);
    }
    if ((given = fw_node_find(node, "mode"))) {
        pattern->kind = FW_PATTERN_MODE;
        return fw_schema_fill(scenario->document, "mode", given, pattern, error);
    }
    pattern->kind = FW_PATTERN_RANDOM;
    pattern->random = fw_node_number(fw_node_find(node, "random"));
    return FW_OK;
}

static fw_status read_patterns(fw_scenario *scenario, const fw_node *list,
                               const fw_scenario_body *body, fw_patterns *patterns, fw_error *error)
{
    if (!list) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *patterns->item,
                                &patterns->item, error));
    for (const fw_node *node = list->first; node; node = node->next)
        FW_TRY(read_pattern(scenario, node, body, &patterns->item[patterns->count++], error));
    return FW_OK;
}

static fw_status read_replacements(fw_scenario *scenario, const fw_node *list, const char *section,
                                   const fw_scenario_body *body, fw_replacements *replacements,
                                   fw_error *error)
{
    if (!list) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *replacements->item,
                                &replacements->item, error));
    for (const fw_node *node = list->first; node; node = node->next) {
        fw_replacement *replacement = &replacements->item[replacements->count++];
        FW_TRY(fw_scenario_read_selection(scenario, node, body, &replacement->sites, error));
        FW_TRY(fw_schema_fill(scenario->document, section, node, replacement, error));
    }
    return FW_OK;
}

/* --- bodies --- */

static fw_status limit_sites(const fw_scenario *scenario, const fw_scenario_body *body,
                             fw_error *error)
{
    int64_t total = 0;
    for (int n = 0; n < scenario->body_count; ++n) total += scenario->bodies[n].shape.count;
    if (total <= FW_SITES_MAX) return FW_OK;
    return fw_scenario_fail(scenario, body->shape_place, error,
                            "with bodies.%s the bodies have %lld sites, expected at most %d",
                            body->name, (long long)total, FW_SITES_MAX);
}

static fw_status check_lattice(const fw_scenario *scenario, const fw_node *node,
                               const fw_scenario_body *body, fw_error *error)
{
    const fw_node *lattice = fw_node_find(node, "lattice");
    const fw_material_kind kind = scenario->materials[body->material].kind;
    if (kind == FW_LATTICE_BOLTZMANN && body->lattice.kind != FW_SQUARE)
        return fw_scenario_fail(scenario, lattice->place, error,
                                "bodies.%s.lattice is 'hexagonal', expected 'square': the lattice "
                                "Boltzmann solid has four links per site",
                                body->name);
    if (kind == FW_LINEAR_LATTICE && body->lattice.kind != FW_HEXAGONAL)
        return fw_scenario_fail(scenario, lattice ? lattice->place : body->place, error,
                                "bodies.%s.lattice is 'square', expected 'hexagonal': the linear "
                                "lattice has six bonds per site",
                                body->name);
    return FW_OK;
}

/* Keys of a body that only some models have. */
static fw_status refuse_foreign_keys(const fw_scenario *scenario, const fw_node *node,
                                     const fw_scenario_body *body, fw_error *error)
{
    enum {
        BOLTZMANN = 1 << FW_LATTICE_BOLTZMANN,
        POINT_MASSES = 1 << FW_MOVABLE_PARTICLES | 1 << FW_LINEAR_LATTICE,
        AUTOMATON = 1 << FW_ELASTIC_AUTOMATON
    };
    static const struct {
        const char *key;
        unsigned kinds;
        const char *whose;
    } keys[] = {{"rest-mass", BOLTZMANN, "lattice Boltzmann bodies have"},
                {"link-stiffness", BOLTZMANN, "lattice Boltzmann bodies have"},
                {"spin", POINT_MASSES, "movable particles and linear lattices have"},
                {"temperature", POINT_MASSES, "movable particles and linear lattices have"},
                {"displaced-as-given", AUTOMATON, "elastic automata have"}};
    const unsigned own = 1u << scenario->materials[body->material].kind;
    for (size_t n = 0; n < sizeof keys / sizeof keys[0]; ++n) {
        const fw_node *given = fw_node_find(node, keys[n].key);
        if (given && !(keys[n].kinds & own))
            return fw_scenario_fail(scenario, given->key_place, error,
                                    "bodies.%s has '%s', which only %s", body->name, keys[n].key,
                                    keys[n].whose);
    }
    return FW_OK;
}

static fw_status read_body(fw_scenario *scenario, const fw_node *node, fw_scenario_body *body,
                           fw_error *error)
{
    body->name = node->key;
    body->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, "body", node, body, error));
    int count;
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "materials", &count), "material",
                            fw_node_find(node, "material"), &body->material, error));
    FW_TRY(check_lattice(scenario, node, body, error));
    FW_TRY(refuse_foreign_keys(scenario, node, body, error));
    const fw_node *shape = fw_node_find(node, "shape");
    body->shape_place = shape->key_place;
    FW_TRY(fw_scenario_read_shape(scenario, shape, body, error));
    FW_TRY(limit_sites(scenario, body, error));
    FW_TRY(read_patterns(scenario, fw_node_find(node, "displacement"), body, &body->displacement,
                         error));
    FW_TRY(
        read_patterns(scenario, fw_node_find(node, "velocities"), body, &body->velocities, error));
    FW_TRY(fw_scenario_check_automaton(scenario, node, body, error));
    FW_TRY(read_replacements(scenario, fw_node_find(node, "rest-mass"), "mass-change", body,
                             &body->rest_mass, error));
    return read_replacements(scenario, fw_node_find(node, "link-stiffness"), "stiffness-change",
                             body, &body->link_stiffness, error);
}

fw_status fw_scenario_read_bodies(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "bodies", &count);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->bodies,
                                &scenario->bodies, error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_body(scenario, node, &scenario->bodies[scenario->body_count++], error));
    return FW_OK;
}
