/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_analyses.c - what a scenario has computed without running. Keeps no state. Start
 * reading at fw_scenario_read_analyses(). */
#include "scenario_parts.h"

#include <string.h>

static const fw_key stability_map_keys[] = {
    {"c1", AT_NUMBERS(fw_scenario_analysis, c1), .layout = "[from, to]", REQUIRED, FROM_TO(0, 10),
     .unit = "spacings/step", .meaning = "both included"},
    {"c2", AT_NUMBERS(fw_scenario_analysis, c2), .layout = "[from, to]", REQUIRED, FROM_TO(0, 10),
     .unit = "spacings/step", .meaning = "both included"},
    {"points", AT_INTEGERS(fw_scenario_analysis, points), .layout = "[c1, c2]", FROM_TO(1, 1025),
     .default_value = "[65, 65]", .meaning = "of the map, ends included"},
    {"waves", AT_INTEGER(fw_scenario_analysis, waves), FROM_TO(4, 1024), .default_value = "64",
     .meaning = "so many times so many wave vectors, multiples of 2 pi/waves; a multiple of 4 has "
                "the worst one, (pi/2, pi/2)"},
    {.name = NULL}};

static const fw_section fw_stability_map_section = {
    "`analysis.NAME.stability-map`", "a stability map",
    "Growth of plane waves of the elastic automaton over the plane of c1 and c2.",
    .keys = stability_map_keys};

static const fw_key dispersion_keys[] = {
    {"material", FW_FORM_NAME, REQUIRED, NOT_STORED,
     .meaning = "one of `materials`, an elastic automaton"},
    {"size", AT_INTEGER(fw_scenario_analysis, size), FROM_TO(4, 256), .default_value = "32",
     .unit = "sites",
     .meaning = "columns and rows of the periodic body, even; wave vectors are multiples of 2 "
                "pi/size"},
    {"steps", AT_INTEGER(fw_scenario_analysis, steps), FROM_TO(1, 100000), .default_value = "64",
     .unit = "steps", .meaning = "that each wave runs"},
    {.name = NULL}};

static const fw_section fw_dispersion_section = {
    "`analysis.NAME.dispersion`", "a dispersion",
    "Frequencies along Gamma-X-M-Gamma: waves that run through a periodic body, beside the closed "
    "form.",
    .keys = dispersion_keys};

static const fw_key plane_mode_keys[] = {{"material", FW_FORM_NAME, REQUIRED, NOT_STORED,
                                          .meaning = "one of `materials`, an elastic automaton"},
                                         {"wave-vector", AT_VEC2(fw_scenario_analysis, wave_vector),
                                          .layout = "[i, j]", REQUIRED, .unit = "radians per site",
                                          .meaning = "not zero"},
                                         {.name = NULL}};

static const fw_section fw_plane_mode_section = {
    "`analysis.NAME.plane-mode`", "a plane wave's modes",
    "Speeds and polarisations of both modes of a wave vector.", .keys = plane_mode_keys};

static const fw_key body_stability_keys[] = {
    {"c1", AT_NUMBER(fw_scenario_analysis, c1[0]), REQUIRED, AT_LEAST(0), .unit = "spacings/step",
     .meaning = "as in the material"},
    {"c2", AT_NUMBER(fw_scenario_analysis, c2[0]), REQUIRED, AT_LEAST(0), .unit = "spacings/step",
     .meaning = "as in the material"},
    {"boundary", AT_WORD(fw_scenario_analysis, boundary),
     WORDS({"bond", FW_EDGES_BOND}, {"trapezoid", FW_EDGES_TRAPEZOID}, {"mirror", FW_EDGES_MIRROR}),
     REQUIRED, .meaning = "as in the material"},
    {"rectangle", AT_INTEGERS(fw_scenario_analysis, rectangle), .layout = "[columns, rows]",
     REQUIRED, AT_LEAST(1), .unit = "sites", .meaning = "at most 400 cells"},
    {.name = NULL}};

static const fw_section fw_body_stability_section = {
    "`analysis.NAME.body-stability`", "a body's stability",
    "Growth by the own update of a rectangle with free edges, stable or not; at most 400 cells.",
    .keys = body_stability_keys};

static const fw_key boltzmann_reference_keys[] = {
    {"body", FW_FORM_NAME, REQUIRED, NOT_STORED,
     .meaning = "one of `bodies`, of Chopard's automaton with boundary `bond`, on which no force "
                "acts"},
    {"half-steps", AT_INTEGER(fw_scenario_analysis, ticks), FROM_TO(1, 10000000),
     .default_value = "1000", .meaning = "that are compared"},
    {.name = NULL}};

static const fw_section fw_boltzmann_reference_section = {
    "`analysis.NAME.boltzmann-reference`", "a lattice Boltzmann reference",
    "Runs the lattice Boltzmann solid that Chopard's automaton is (M0 = 0, two of its steps for "
    "one "
    "of the automaton), from the same start, between the same walls, and compares.",
    .keys = boltzmann_reference_keys};

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
                                 fw_scenario_analysis *analysis, fw_error *error)
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
                              fw_scenario_analysis *analysis, fw_error *error)
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

static fw_status read_dispersion(const fw_scenario *scenario, const fw_node *node,
                                 fw_scenario_analysis *analysis, fw_error *error)
{
    FW_TRY(find_automaton(scenario, node, &analysis->material, error));
    return check_size(scenario, node, analysis, error);
}

static fw_status read_plane_mode(const fw_scenario *scenario, const fw_node *node,
                                 fw_scenario_analysis *analysis, fw_error *error)
{
    FW_TRY(find_automaton(scenario, node, &analysis->material, error));
    return check_wave(scenario, node, analysis, error);
}

/* Per kind: its key, and what is read or checked once its keys have been filled in. */
static const struct {
    fw_key key;
    fw_status (*read)(const fw_scenario *scenario, const fw_node *node,
                      fw_scenario_analysis *analysis, fw_error *error);
} analyses[] = {
    [FW_ANALYSIS_STABILITY_MAP] = {{"stability-map", FW_FORM_MAPPING,
                                    .subsection = &fw_stability_map_section, ALTERNATIVE,
                                    NOT_STORED, .meaning = "which c1 and c2 are stable"},
                                   check_ranges},
    [FW_ANALYSIS_DISPERSION] = {{"dispersion", FW_FORM_MAPPING,
                                 .subsection = &fw_dispersion_section, ALTERNATIVE, NOT_STORED,
                                 .meaning = "frequencies, simulated and in closed form"},
                                read_dispersion},
    [FW_ANALYSIS_PLANE_MODE] = {{"plane-mode", FW_FORM_MAPPING,
                                 .subsection = &fw_plane_mode_section, ALTERNATIVE, NOT_STORED,
                                 .meaning = "speeds and polarisations of one wave vector"},
                                read_plane_mode},
    [FW_ANALYSIS_BODY_STABILITY] = {{"body-stability", FW_FORM_MAPPING,
                                     .subsection = &fw_body_stability_section, ALTERNATIVE,
                                     NOT_STORED, .meaning = "of a boundary rule"},
                                    check_rectangle},
    [FW_ANALYSIS_BOLTZMANN_REFERENCE] = {
        {"boltzmann-reference", FW_FORM_MAPPING, .subsection = &fw_boltzmann_reference_section,
         ALTERNATIVE, NOT_STORED, .meaning = "two solids that are one",
         .old_name = "boltzmann-twin"},
        read_reference}};

const fw_section fw_analysis_section = {
    "`analysis.NAME`", "an analysis",
    "What is computed without running: numbers that `expect` can speak of, and arrays in the "
    "results file under parameters/analysis/NAME.",
    FW_ROWS(analyses)};

static fw_status read_analysis(fw_scenario *scenario, const fw_node *node,
                               fw_scenario_analysis *analysis, fw_error *error)
{
    const fw_node *what = node->first;
    int kind = 0;
    while (strcmp(analyses[kind].key.name, what->key) != 0) ++kind; /* one of them, as checked */
    analysis->name = node->key;
    analysis->place = node->key_place;
    analysis->kind = (fw_analysis_kind)kind;
    analysis->material = analysis->body = -1;
    FW_TRY(
        fw_schema_fill(scenario->document, analyses[kind].key.subsection, what, analysis, error));
    return analyses[kind].read(scenario, what, analysis, error);
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
