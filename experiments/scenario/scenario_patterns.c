/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_patterns.c - what single sites and links of a body start with. Keeps no state. Start
 * reading at fw_scenario_read_patterns(). */
#include "core/automaton/automaton_dispersion.h"
#include "scenario_parts.h"

static const fw_key gaussian_keys[] = {{"amplitude", AT_VEC2(fw_pattern, amplitude),
                                        .layout = "[x, y]", REQUIRED, .meaning = "at the centre"},
                                       {"centre", AT_VEC2(fw_pattern, centre), .layout = "[i, j]",
                                        REQUIRED, .unit = "sites", .meaning = "need not be a site"},
                                       {"width", AT_NUMBER(fw_pattern, width), REQUIRED, ABOVE_ZERO,
                                        .unit = "sites", .meaning = "standard deviation"},
                                       {.name = NULL}};

static const fw_section fw_gaussian_section = {
    "`gaussian`", "a Gaussian pattern",
    "amplitude exp(-|s - centre|^2 / (2 width^2)) at site s = [i, j].", .keys = gaussian_keys};

static const fw_key wave_keys[] = {
    {"amplitude", AT_VEC2(fw_pattern, amplitude), .layout = "[x, y]", REQUIRED,
     .meaning = "at the crest"},
    {"wave-vector", AT_VEC2(fw_pattern, wave_vector), .layout = "[i, j]", REQUIRED,
     .unit = "radians per site", .meaning = "6.2832/n repeats after n sites"},
    {"phase", AT_ANGLE(fw_pattern, phase), FROM_TO(-360, 360), .default_value = "0",
     .unit = "degrees", .meaning = "at site [0, 0]"},
    {.name = NULL}};

static const fw_section fw_wave_section = {
    "`wave`", "a wave pattern", "amplitude cos(wave-vector . s + phase) at site s = [i, j].",
    .keys = wave_keys};

static const fw_key plane_wave_keys[] = {
    {"amplitude", AT_VEC2(fw_pattern, amplitude), .layout = "[x, y]", REQUIRED,
     .meaning = "at the crest"},
    {"wave-vector", AT_VEC2(fw_pattern, wave_vector), .layout = "[x, y]", REQUIRED,
     .unit = "radians per length", .meaning = "6.2832/wavelength"},
    {"phase", AT_ANGLE(fw_pattern, phase), FROM_TO(-360, 360), .default_value = "0",
     .unit = "degrees", .meaning = "at the body's origin"},
    {.name = NULL}};

static const fw_section fw_plane_wave_section = {
    "`plane-wave`", "a plane wave",
    "amplitude cos(wave-vector . r + phase) at distance r = [x, y] from the body's origin.",
    .keys = plane_wave_keys};

static const fw_key mode_keys[] = {
    {"wave-vector", AT_VEC2(fw_pattern, wave_vector), .layout = "[i, j]", REQUIRED,
     .unit = "radians per site", .meaning = "not zero"},
    {"branch", AT_WORD(fw_pattern, branch), WORDS({"slow", FW_SLOW}, {"fast", FW_FAST}), REQUIRED,
     .meaning = "long waves: slow is transverse, fast longitudinal"},
    {"amplitude", AT_NUMBER(fw_pattern, size), REQUIRED, ABOVE_ZERO, .unit = "length",
     .meaning = "of the white cells' displacement"},
    {"phase", AT_ANGLE(fw_pattern, phase), FROM_TO(-360, 360), .default_value = "0",
     .unit = "degrees", .meaning = "at site [0, 0]"},
    {.name = NULL}};

static const fw_section fw_mode_section = {
    "`mode`", "a mode",
    "A running wave of the endless automaton (Dong Eqs 37-40): Re(a exp(i (wave-vector . s + "
    "omega "
    "t + phase))) at site s = [i, j], a being that of the cell's colour. It runs against its wave "
    "vector. White's a has a real positive x (or y, where x is zero); in a periodic body that the "
    "wave fits into it goes on for ever.",
    .keys = mode_keys};

static const fw_key pattern_keys[] = {
    {"sites", SELECTION, .default_value = "all", NOT_STORED, .meaning = "which sites"},
    {"by", FW_FORM_NUMBERS, .layout = "[x, y]", ALTERNATIVE, NOT_STORED,
     .meaning = "the same for all of them"},
    {"gaussian", FW_FORM_MAPPING, .subsection = &fw_gaussian_section, ALTERNATIVE, NOT_STORED,
     .meaning = "a hill around one site"},
    {"wave", FW_FORM_MAPPING, .subsection = &fw_wave_section, ALTERNATIVE, NOT_STORED,
     .meaning = "a plane wave"},
    {"plane-wave", FW_FORM_MAPPING, .subsection = &fw_plane_wave_section, ALTERNATIVE, NOT_STORED,
     .meaning = "a plane wave in space, whatever the lattice"},
    {"gradient", FW_FORM_NUMBERS, .layout = "[xx, xy, yx, yy]", ALTERNATIVE, NOT_STORED,
     .unit = "1/length",
     .meaning = "xx x + xy y along x, yx x + yy y along y, at [x, y] from the body's origin"},
    {"mode", FW_FORM_MAPPING, .subsection = &fw_mode_section, ALTERNATIVE, NOT_STORED,
     .meaning = "a running wave of an elastic automaton; its displacements are taken as given"},
    {"random", FW_FORM_NUMBER, ALTERNATIVE, ABOVE_ZERO, NOT_STORED,
     .meaning = "each component uniform between minus and plus this, from the run's seed"},
    {.name = NULL}};

const fw_section fw_pattern_section = {
    "Items of `displacement` and `velocities`", "a pattern",
    "A value for the selected sites. The patterns of a list add up.", .keys = pattern_keys};

static const fw_key mass_change_keys[] = {
    {"sites", SELECTION, REQUIRED, NOT_STORED, .meaning = "which sites"},
    {"value", AT_SYMMETRIC(fw_replacement, value), REQUIRED, .unit = "mass^(1/2)",
     .meaning = "as in the material"},
    {.name = NULL}};

const fw_section fw_mass_change_section = {
    "Items of `bodies.NAME.rest-mass`", "a change of rest mass",
    "Another rest mass for the selected sites. The last one given holds.",
    .keys = mass_change_keys};

static const fw_key stiffness_change_keys[] = {
    {"sites", SELECTION, REQUIRED, NOT_STORED, .meaning = "which sites"},
    {"links", AT_WORD(fw_replacement, links),
     WORDS({"inside", FW_LINKS_INSIDE}, {"across", FW_LINKS_ACROSS},
           {"touching", FW_LINKS_TOUCHING}),
     .default_value = "inside",
     .meaning =
         "inside: links with both ends selected; across: with one end; touching: with one or both"},
    {"value", AT_SYMMETRIC(fw_replacement, value), REQUIRED, ABOVE_ZERO, .unit = "force/length",
     .meaning = "as in the material"},
    {.name = NULL}};

const fw_section fw_stiffness_change_section = {
    "Items of `bodies.NAME.link-stiffness`", "a change of stiffness",
    "Another stiffness for links of the selected sites. The last one given holds.",
    .keys = stiffness_change_keys};

static fw_status read_pattern(fw_scenario *scenario, const fw_node *node,
                              const fw_scenario_body *body, fw_pattern *pattern, fw_error *error)
{
    static const char *const regular[] = {"gaussian", "wave", "plane-wave", "gradient"};
    FW_TRY(fw_scenario_read_selection(scenario, node, body, &pattern->sites, error));
    const fw_node *given;
    for (size_t n = 0; fw_shape_is_free(body->shape.kind) && n < 4; ++n)
        if ((given = fw_node_find(node, regular[n])))
            return fw_scenario_fail(
                scenario, given->key_place, error,
                "'%s' in body '%s', whose particles are placed freely, expected 'by' "
                "or 'random': it has no lattice for a pattern to follow",
                given->key, body->name);
    if ((given = fw_node_find(node, "by"))) {
        pattern->kind = FW_PATTERN_UNIFORM;
        pattern->amplitude = (fw_vec2){fw_node_number(given->first), fw_node_number(given->last)};
        return FW_OK;
    }
    if ((given = fw_node_find(node, "gaussian"))) {
        pattern->kind = FW_PATTERN_GAUSSIAN;
        return fw_schema_fill(scenario->document, &fw_gaussian_section, given, pattern, error);
    }
    if ((given = fw_node_find(node, "plane-wave"))) {
        pattern->kind = FW_PATTERN_PLANE;
        return fw_schema_fill(scenario->document, &fw_plane_wave_section, given, pattern, error);
    }
    if ((given = fw_node_find(node, "gradient"))) {
        pattern->kind = FW_PATTERN_GRADIENT;
        fw_node_numbers(given, pattern->gradient);
        return FW_OK;
    }
    if ((given = fw_node_find(node, "wave"))) {
        pattern->kind = FW_PATTERN_WAVE;
        return fw_schema_fill(scenario->document, &fw_wave_section, given, pattern, error);
    }
    if ((given = fw_node_find(node, "mode"))) {
        pattern->kind = FW_PATTERN_MODE;
        return fw_schema_fill(scenario->document, &fw_mode_section, given, pattern, error);
    }
    pattern->kind = FW_PATTERN_RANDOM;
    pattern->random = fw_node_number(fw_node_find(node, "random"));
    return FW_OK;
}

fw_status fw_scenario_read_patterns(fw_scenario *scenario, const fw_node *list,
                                    const fw_scenario_body *body, fw_patterns *patterns,
                                    fw_error *error)
{
    if (!list) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *patterns->item,
                                &patterns->item, error));
    for (const fw_node *node = list->first; node; node = node->next)
        FW_TRY(read_pattern(scenario, node, body, &patterns->item[patterns->count++], error));
    return FW_OK;
}

fw_status fw_scenario_read_replacements(fw_scenario *scenario, const fw_node *list,
                                        const fw_section *section, const fw_scenario_body *body,
                                        fw_replacements *replacements, fw_error *error)
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
