/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_automaton.c - elastic automata of a scenario: their materials, what their bodies may
 * have, and the analyses. Keeps no state. */
#include "core/lattice.h"
#include "scenario_parts.h"

#include <string.h>

/* --- materials --- */

/* A key that has to stand beside another one. */
static fw_status find_partner(const fw_scenario *scenario, const fw_node *node, const char *key,
                              const fw_node *beside, const fw_node **partner, fw_error *error)
{
    *partner = fw_node_find(node, key);
    if (*partner) return FW_OK;
    return fw_scenario_fail(scenario, beside->key_place, error,
                            "elastic-automaton has '%s' but no '%s', expected both", beside->key,
                            key);
}

fw_status fw_scenario_read_automaton(const fw_scenario *scenario, const fw_node *node,
                                     fw_scenario_automaton *material, fw_error *error)
{
    const fw_node *given, *partner;
    fw_error inner;
    if ((given = fw_node_find(node, "chopard"))) {
        if (given->text[0] != 't')
            return fw_scenario_fail(scenario, given->place, error,
                                    "elastic-automaton.chopard is 'false', expected 'true', or c1 "
                                    "and c2 in its place");
        material->speeds = fw_automaton_chopard();
        return FW_OK;
    }
    if ((given = fw_node_find(node, "shear-modulus"))) {
        FW_TRY(find_partner(scenario, node, "poisson-ratio", given, &partner, error));
        if (fw_automaton_speeds_from_moduli(&material->speeds, fw_node_number(given),
                                            fw_node_number(partner), &inner) != FW_OK)
            return fw_scenario_fail(scenario, given->place, error, "%s", inner.sentence);
    } else {
        given = fw_node_find(node, "c1");
        FW_TRY(find_partner(scenario, node, "c2", given, &partner, error));
    }
    if (fw_automaton_speeds_check(material->speeds, &inner) == FW_OK) return FW_OK;
    return fw_scenario_fail(scenario, given->place, error, "%s", inner.sentence);
}

/* --- bodies --- */

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

static fw_status check_period(const fw_scenario *scenario, const fw_scenario_body *body,
                              fw_error *error)
{
    const fw_scenario_shape *shape = &body->shape;
    const int columns = shape->last_column - shape->first_column + 1;
    const int rows = shape->last_row - shape->first_row + 1;
    if (columns % 2 == 0 && rows % 2 == 0) return FW_OK;
    return fw_scenario_fail(scenario, body->shape_place, error,
                            "bodies.%s is periodic and has %d columns and %d rows, expected even "
                            "numbers: across an odd one two cells of one colour would meet",
                            body->name, columns, rows);
}

fw_status fw_scenario_check_automaton(const fw_scenario *scenario, const fw_node *node,
                                      const fw_scenario_body *body, fw_error *error)
{
    const fw_scenario_material *material = &scenario->materials[body->material];
    const bool automaton = material->kind == FW_ELASTIC_AUTOMATON;
    const fw_node *lattice = fw_node_find(node, "lattice");
    FW_TRY(check_modes(scenario, fw_node_find(node, "displacement"), automaton, body, error));
    FW_TRY(check_modes(scenario, fw_node_find(node, "velocities"), false, body, error));
    if (!automaton) return FW_OK;
    if (body->lattice.kind != FW_SQUARE)
        return fw_scenario_fail(scenario, lattice->place, error,
                                "bodies.%s.lattice is 'hexagonal', expected 'square': the cells of "
                                "an elastic automaton are black and white in turn",
                                body->name);
    return material->automaton.boundary == FW_EDGES_PERIODIC ? check_period(scenario, body, error)
                                                             : FW_OK;
}

/* Half-steps are a clock of their own: the scene's ticks would be whole steps for one body and half
 * of them for another. */
fw_status fw_scenario_check_clock(const fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_body *automaton = NULL, *other = NULL;
    for (int b = 0; b < scenario->body_count; ++b) {
        const fw_scenario_body *body = &scenario->bodies[b];
        const bool halves = scenario->materials[body->material].kind == FW_ELASTIC_AUTOMATON;
        *(halves ? &automaton : &other) = body;
    }
    if (!automaton || !other) return FW_OK;
    return fw_scenario_fail(scenario, automaton->place, error,
                            "body '%s' is an elastic automaton, which moves in half-steps, and "
                            "'%s' is not, expected bodies that share one clock: such two belong in "
                            "scenarios of their own",
                            automaton->name, other->name);
}

/* --- analyses --- */

static fw_status find_automaton(const fw_scenario *scenario, const fw_node *node, int *material,
                                fw_error *error)
{
    int count;
    const fw_node *name = fw_node_find(node, "material");
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "materials", &count), "material",
                            name, material, error));
    if (scenario->materials[*material].kind == FW_ELASTIC_AUTOMATON) return FW_OK;
    return fw_scenario_fail(scenario, name->place, error,
                            "material '%s' is not an elastic automaton, expected one", name->text);
}

static fw_status read_reference(const fw_scenario *scenario, const fw_node *node,
                                fw_scenario_analysis *analysis, fw_error *error)
{
    int count;
    const fw_node *name = fw_node_find(node, "body");
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "bodies", &count), "body", name,
                            &analysis->body, error));
    const fw_scenario_body *body = &scenario->bodies[analysis->body];
    const fw_scenario_material *material = &scenario->materials[body->material];
    const fw_scenario_automaton *automaton = &material->automaton;
    const fw_automaton_speeds chopard = fw_automaton_chopard();
    if (material->kind != FW_ELASTIC_AUTOMATON ||
        automaton->speeds.transverse != chopard.transverse || automaton->speeds.coupling != 0 ||
        automaton->boundary != FW_EDGES_BOND || automaton->break_at > 0)
        return fw_scenario_fail(
            scenario, name->place, error,
            "body '%s' has no lattice Boltzmann reference, expected one of Chopard's "
            "automaton (chopard: true) with boundary 'bond' that cannot break",
            body->name);
    for (int n = 0; n < scenario->force_count; ++n)
        if (scenario->forces[n].body == analysis->body)
            return fw_scenario_fail(
                scenario, name->place, error,
                "the force '%s' acts on body '%s', expected none on a body that "
                "is compared with its reference solid",
                scenario->forces[n].name, body->name);
    return FW_OK;
}

static fw_status check_rectangle(const fw_scenario *scenario, const fw_node *node,
                                 const fw_scenario_analysis *analysis, fw_error *error)
{
    enum { CELLS_MAX = 400 };
    const int *rectangle = analysis->rectangle;
    if (rectangle[0] <= CELLS_MAX && rectangle[1] <= CELLS_MAX &&
        rectangle[0] * rectangle[1] <= CELLS_MAX)
        return FW_OK;
    return fw_scenario_fail(scenario, fw_node_find(node, "rectangle")->place, error,
                            "rectangle is [%d, %d], expected at most %d cells: the eigenvalues of "
                            "its whole update are computed",
                            rectangle[0], rectangle[1], CELLS_MAX);
}

static fw_status check_ranges(const fw_scenario *scenario, const fw_node *node,
                              const fw_scenario_analysis *analysis, fw_error *error)
{
    const double *ranges[] = {analysis->c1, analysis->c2};
    const char *const keys[] = {"c1", "c2"};
    for (int n = 0; n < 2; ++n)
        if (ranges[n][0] > ranges[n][1] ||
            (ranges[n][0] == ranges[n][1]) != (analysis->points[n] == 1))
            return fw_scenario_fail(scenario, fw_node_find(node, keys[n])->place, error,
                                    "%s is [%g, %g] at %d points, expected the first before the "
                                    "last (or both the same and 1 point)",
                                    keys[n], ranges[n][0], ranges[n][1], analysis->points[n]);
    return FW_OK;
}

static fw_status check_size(const fw_scenario *scenario, const fw_node *node,
                            const fw_scenario_analysis *analysis, fw_error *error)
{
    if (analysis->size % 2 == 0) return FW_OK;
    return fw_scenario_fail(scenario, fw_node_find(node, "size")->place, error,
                            "size is %lld, expected an even number: a periodic body has black and "
                            "white columns in turn",
                            (long long)analysis->size);
}

static fw_status check_wave(const fw_scenario *scenario, const fw_node *node,
                            const fw_scenario_analysis *analysis, fw_error *error)
{
    if (analysis->wave_vector.x != 0 || analysis->wave_vector.y != 0) return FW_OK;
    return fw_scenario_fail(scenario, fw_node_find(node, "wave-vector")->place, error,
                            "wave-vector is [0, 0], expected a wave");
}

static fw_status read_analysis(fw_scenario *scenario, const fw_node *node,
                               fw_scenario_analysis *analysis, fw_error *error)
{
    static const char *const kinds[] = {[FW_ANALYSIS_STABILITY_MAP] = "stability-map",
                                        [FW_ANALYSIS_DISPERSION] = "dispersion",
                                        [FW_ANALYSIS_PLANE_MODE] = "plane-mode",
                                        [FW_ANALYSIS_BODY_STABILITY] = "body-stability",
                                        [FW_ANALYSIS_BOLTZMANN_REFERENCE] = "boltzmann-reference"};
    const fw_node *what = node->first;
    int kind = 0;
    while (strcmp(kinds[kind], what->key) != 0) ++kind; /* the schema knows no other */
    analysis->name = node->key;
    analysis->place = node->key_place;
    analysis->kind = (fw_analysis_kind)kind;
    analysis->material = analysis->body = -1;
    FW_TRY(fw_schema_fill(scenario->document, what->key, what, analysis, error));
    switch (analysis->kind) {
    case FW_ANALYSIS_STABILITY_MAP:
        return check_ranges(scenario, what, analysis, error);
    case FW_ANALYSIS_DISPERSION:
        FW_TRY(find_automaton(scenario, what, &analysis->material, error));
        return check_size(scenario, what, analysis, error);
    case FW_ANALYSIS_PLANE_MODE:
        FW_TRY(find_automaton(scenario, what, &analysis->material, error));
        return check_wave(scenario, what, analysis, error);
    case FW_ANALYSIS_BODY_STABILITY:
        return check_rectangle(scenario, what, analysis, error);
    case FW_ANALYSIS_BOLTZMANN_REFERENCE:
        return read_reference(scenario, what, analysis, error);
    }
    return fw_fail_impossible(error, "an analysis of an unknown kind");
}

fw_status fw_scenario_read_analyses(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "analysis", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->analyses,
                                &scenario->analyses, error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(
            read_analysis(scenario, node, &scenario->analyses[scenario->analysis_count++], error));
    return FW_OK;
}
