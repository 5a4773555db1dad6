/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_bodies.c - bodies of a scenario. Keeps no state. Start reading at read_body(). */
#include "scenario_parts.h"

#include <string.h>

static const fw_key body_keys[] = {
    {"material", FW_FORM_NAME, REQUIRED, NOT_STORED, .meaning = "one of `materials`"},
    {"shape", FW_FORM_MAPPING, .subsection = &fw_shape_section, REQUIRED, NOT_STORED,
     .meaning = "the sites it occupies"},
    {"lattice", AT_WORD(fw_scenario_body, lattice.kind),
     WORDS({"square", FW_SQUARE}, {"hexagonal", FW_HEXAGONAL}), .default_value = "square",
     .meaning = "square: site [i, j] lies at (i, j); hexagonal: rows along x, site [i, j] at (i + "
                "(j odd)/2, j 3^(1/2)/2)"},
    {"spacing", AT_NUMBER(fw_scenario_body, lattice.spacing), FROM_TO(1e-6, 1e6),
     .default_value = "1", .unit = "length", .meaning = "between neighbouring sites"},
    {"angle", AT_ANGLE(fw_scenario_body, lattice.angle), FROM_TO(-360, 360), .default_value = "0",
     .unit = "degrees",
     .meaning = "by which the lattice is turned about site [0, 0], counter-clockwise"},
    {"origin", AT_VEC2(fw_scenario_body, lattice.origin), .layout = "[x, y]",
     .default_value = "[0, 0]", .unit = "length", .meaning = "where site [0, 0] lies at the start"},
    {"surface", FW_FORM_NAME, NOT_STORED, .default_meaning = "one without a name",
     .meaning = "a name of your own for what it is like where it rubs, see `contact.pairs`"},
    {"velocity", AT_VEC2(fw_scenario_body, velocity), .layout = "[x, y]", .default_value = "[0, 0]",
     .unit = "length/time", .meaning = "of the whole body at the start"},
    {"displacement", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = &fw_pattern_section,
     .most = 4096, NOT_STORED, .default_meaning = "none", .unit = "length",
     .meaning = "of single sites from their places in the lattice at the start"},
    {"velocities", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = &fw_pattern_section,
     .most = 4096, NOT_STORED, .default_meaning = "none", .unit = "length/time",
     .meaning = "of single sites at the start, added to `velocity`"},
    {"spin", AT_NUMBER(fw_scenario_body, spin), .default_value = "0", .unit = "radians/time",
     .meaning = "angular velocity about its middle at the start, counter-clockwise (movable "
                "particles, linear lattice)"},
    {"temperature", AT_NUMBER(fw_scenario_body, temperature), AT_LEAST(0), .default_value = "0",
     .unit = "energy",
     .meaning =
         "of random velocities at the start, which add up to zero (movable particles, linear "
         "lattice)"},
    {"displaced-as-given", AT_FLAG(fw_scenario_body, displaced_as_given), .needs = "displacement",
     .default_value = "false",
     .meaning =
         "elastic automaton: black and white are displaced just as `displacement` says, as in "
         "the paper, which in general sets the body moving; without it white lies where its "
         "black neighbours put it, and the body is at rest"},
    {"rest-mass", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = &fw_mass_change_section,
     .most = 4096, NOT_STORED, .default_meaning = "the material's",
     .meaning = "of single sites (lattice Boltzmann)"},
    {"link-stiffness", FW_FORM_LIST, .items = FW_FORM_MAPPING,
     .subsection = &fw_stiffness_change_section, .most = 4096, NOT_STORED,
     .default_meaning = "the material's", .meaning = "of single links (lattice Boltzmann)"},
    {.name = NULL}};

const fw_section fw_body_section = {"`bodies.NAME`", "a body",
                                    "Particles on the sites of a lattice, all of one material.",
                                    .keys = body_keys};

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

static fw_status check_modes(const fw_scenario *scenario, const fw_node *list, bool allowed,
                             const fw_scenario_body *body, fw_error *error)
{
    for (const fw_node *item = list ? list->first : NULL; item; item = item->next) {
        const fw_node *mode = fw_node_find(item, "mode");
        if (!mode) continue;
        if (!allowed)
            return fw_scenario_fail(scenario, mode->key_place, error,
                                    "bodies.%s.%s has a 'mode', which only a 'displacement' of an "
                                    "elastic automaton can be",
                                    body->name, list->key);
        const fw_node *wave = fw_node_find(mode, "wave-vector");
        if (fw_node_number(wave->first) == 0 && fw_node_number(wave->last) == 0)
            return fw_scenario_fail(scenario, wave->place, error,
                                    "a mode with the wave vector [0, 0], expected a wave");
    }
    return FW_OK;
}

static const fw_material_model *model_of(const fw_scenario *scenario, const fw_scenario_body *body)
{
    return fw_material_model_of(scenario->materials[body->material].kind);
}

static fw_status check_lattice(const fw_scenario *scenario, const fw_node *node,
                               const fw_scenario_body *body, fw_error *error)
{
    const fw_node *lattice = fw_node_find(node, "lattice");
    const fw_material_model *model = model_of(scenario, body);
    const bool square = body->lattice.kind == FW_SQUARE;
    if (model->lattices >> body->lattice.kind & 1) return FW_OK;
    return fw_scenario_fail(scenario, lattice ? lattice->place : body->place, error,
                            "bodies.%s.lattice is '%s', expected '%s': %s", body->name,
                            square ? "square" : "hexagonal", square ? "hexagonal" : "square",
                            model->why);
}

/* Does the model have that key, which not all have? */
static bool has_key(const fw_material_model *model, const char *key)
{
    const char *at = strstr(model->body_keys, key);
    return at && at[-1] == ' ' && at[strlen(key)] == ' ';
}

/* Keys of a body that only some models have. */
static fw_status refuse_foreign_keys(const fw_scenario *scenario, const fw_node *node,
                                     const fw_scenario_body *body, fw_error *error)
{
    const fw_material_model *own = model_of(scenario, body);
    for (const fw_node *given = node->first; given; given = given->next) {
        char whose[200] = "";
        if (has_key(own, given->key)) continue;
        for (int kind = 0; kind < FW_MATERIAL_KINDS; ++kind) {
            const fw_material_model *model = fw_material_model_of((fw_material_kind)kind);
            const size_t used = strlen(whose);
            if (has_key(model, given->key))
                snprintf(whose + used, sizeof whose - used, "%s%s", used ? " and " : "",
                         model->bodies);
        }
        if (*whose)
            return fw_scenario_fail(scenario, given->key_place, error,
                                    "bodies.%s has '%s', which only %s have", body->name,
                                    given->key, whose);
    }
    return FW_OK;
}

static fw_status read_body(fw_scenario *scenario, const fw_node *node, fw_scenario_body *body,
                           fw_error *error)
{
    body->name = node->key;
    body->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, &fw_body_section, node, body, error));
    int count;
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "materials", &count), "material",
                            fw_node_find(node, "material"), &body->material, error));
    FW_TRY(check_lattice(scenario, node, body, error));
    FW_TRY(refuse_foreign_keys(scenario, node, body, error));
    const fw_node *shape = fw_node_find(node, "shape");
    body->shape_place = shape->key_place;
    FW_TRY(fw_scenario_read_shape(scenario, shape, body, error));
    static const char *const of_lattices[] = {"lattice", "spacing"};
    for (int n = 0; n < 2 && fw_shape_is_free(body->shape.kind); ++n) {
        const fw_node *stray = fw_node_find(node, of_lattices[n]);
        if (stray)
            return fw_scenario_fail(
                scenario, stray->key_place, error,
                "bodies.%s has '%s', but its particles are placed freely, not on a lattice",
                body->name, stray->key);
    }
    FW_TRY(limit_sites(scenario, body, error));
    FW_TRY(fw_scenario_read_patterns(scenario, fw_node_find(node, "displacement"), body,
                                     &body->displacement, error));
    FW_TRY(fw_scenario_read_patterns(scenario, fw_node_find(node, "velocities"), body,
                                     &body->velocities, error));
    FW_TRY(check_modes(scenario, fw_node_find(node, "displacement"),
                       model_of(scenario, body)->has_modes, body, error));
    FW_TRY(check_modes(scenario, fw_node_find(node, "velocities"), false, body, error));
    if (model_of(scenario, body)->check_body)
        FW_TRY(model_of(scenario, body)->check_body(scenario, body, error));
    FW_TRY(fw_scenario_read_replacements(scenario, fw_node_find(node, "rest-mass"),
                                         &fw_mass_change_section, body, &body->rest_mass, error));
    return fw_scenario_read_replacements(scenario, fw_node_find(node, "link-stiffness"),
                                         &fw_stiffness_change_section, body, &body->link_stiffness,
                                         error);
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
