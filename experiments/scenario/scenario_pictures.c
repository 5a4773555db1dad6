/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_pictures.c - the pictures of a scenario. Keeps no state. Start reading at
 * fw_scenario_read_pictures(). */
#include "scenario_parts.h"

#include <string.h>

#define PICTURE_WORD(id, draw, name, meaning, keys, needs, frames, field) {name, FW_PICTURE_##id},
static const fw_key picture_keys[] = {
    {"kind", AT_WORD(fw_scenario_picture, kind), REQUIRED,
     .words = (const fw_word[]){FW_PICTURE_ROWS(PICTURE_WORD){NULL, 0}},
     .meaning = FW_PICTURE_MEANINGS},
    {"title", AT_TEXT(fw_scenario_picture, title), .default_meaning = "the scenario's",
     .meaning = "written above it"},
    {"instants", FW_FORM_LIST, .items = FW_FORM_INTEGER, .least = 1, .most = 1024, AT_LEAST(0),
     NOT_STORED, .default_meaning = "chosen by the program", .unit = "steps",
     .meaning = "which are drawn, ascending"},
    {"field", AT_NAME(fw_scenario_picture, field),
     .default_meaning = "the first that is recorded, else return-force or the solid's first",
     .meaning = "field of the solid that is drawn as colour; it is recorded without being "
                "named in `record`"},
    {"range", AT_NUMBERS(fw_scenario_picture, range), .layout = "[low, high]",
     .default_meaning = "from the least to the greatest value of all recorded frames",
     .meaning = "ends of the colour scale"},
    {"observables", AT_NAMES(FW_FORM_PATH, fw_scenario_picture, observables), .most = 64,
     .default_meaning = "the energies; of a sweep, what is expected",
     .meaning =
         "curves of a series: a quantity, as `elongation`, of one body or wall, as "
         "`elongation.chain`, or one component, as `elongation.x`, `elongation.chain.x`; of a "
         "sweep: quantities of `expect`, or measures of the layer; of a map one of them"},
    {"body", AT_NAME(fw_scenario_picture, body), .default_meaning = "the first that rubs",
     .meaning = "body whose particles are shown where they rub"},
    {"from", AT_INTEGER(fw_scenario_picture, from), AT_LEAST(0), .default_value = "0",
     .unit = "steps", .meaning = "first step of a series, or of a map over time"},
    {"until", AT_INTEGER(fw_scenario_picture, until), AT_LEAST(1),
     .default_value = "9223372036854775807", .default_meaning = "the end", .unit = "steps",
     .meaning = "last step of it"},
    {"logarithmic", AT_FLAG(fw_scenario_picture, logarithmic), .default_value = "false",
     .meaning = "the values of a series, or of a map's colours, on logarithmic axes"},
    {"along", FW_FORM_NAME, NOT_STORED, .default_meaning = "that of the most values",
     .meaning = "parameter of a sweep along the x axis, or of a picture of kind sweep a quantity "
                "that the sweep compares, against which the others are drawn"},
    {"level", AT_NUMBER(fw_scenario_picture, level), .default_value = "0",
     .default_meaning = "that which the number `crosses` in `expect`, else no line",
     .meaning =
         "of a map: a line where its number has this value, with the standard errors of "
         "where it passes: found by bisection where the sweep has one, else between cases by "
         "straight lines"},
    {"analysis", AT_NAME(fw_scenario_picture, analysis), .default_meaning = "the only one",
     .meaning = "which analysis is drawn"},
    {.name = NULL}};

const fw_section fw_picture_section = {
    "`pictures.NAME`", "a picture",
    "What `fretwork plot` draws where its options name nothing else.", .keys = picture_keys};

/* Keys that mean nothing for a picture of this kind are refused, not passed over. */
static fw_status check_keys(const fw_scenario *scenario, const fw_node *node,
                            const fw_scenario_picture *picture, fw_error *error)
{
    for (const fw_node *key = node->first; key; key = key->next)
        if (!fw_picture_reads(picture->kind, key->key))
            return fw_scenario_fail(scenario, key->key_place, error,
                                    "pictures.%s has '%s', which a picture of kind '%s' does not "
                                    "draw",
                                    node->key, key->key, fw_picture_rows[picture->kind].name);
    return FW_OK;
}

static bool has_friction(const fw_scenario *scenario)
{
    for (int w = 0; w < scenario->wall_count; ++w)
        if (scenario->walls[w].def.surface.law == FW_COULOMB) return true;
    return fw_scenario_bodies_rub(scenario);
}

static fw_status check_needs(const fw_scenario *scenario, const fw_node *node,
                             const fw_scenario_picture *picture, fw_error *error)
{
    const fw_picture_row *row = &fw_picture_rows[picture->kind];
    const fw_place place = fw_node_find(node, "kind")->place;
    if (row->needs & FW_PICTURE_NEEDS_SWEEP && scenario->study.sweep.parameter_count == 0)
        return fw_scenario_fail(scenario, place, error,
                                "pictures.%s is of kind '%s', but the study has no 'sweep'",
                                node->key, row->name);
    if (row->needs & FW_PICTURE_NEEDS_TWO_PARAMETERS && scenario->study.sweep.parameter_count != 2)
        return fw_scenario_fail(scenario, place, error,
                                "pictures.%s is of kind '%s', but study.sweep has %d parameter%s, "
                                "expected two",
                                node->key, row->name, scenario->study.sweep.parameter_count,
                                scenario->study.sweep.parameter_count == 1 ? "" : "s");
    if (row->needs & FW_PICTURE_NEEDS_PROFILE && scenario->profile.every == 0)
        return fw_scenario_fail(scenario, place, error,
                                "pictures.%s is of kind '%s', but the scenario has no 'profile'",
                                node->key, row->name);
    if (row->needs & FW_PICTURE_NEEDS_TWO_GRIPS && scenario->grip_count < 2)
        return fw_scenario_fail(scenario, place, error,
                                "pictures.%s is of kind '%s', %s, but the scenario has %d grips, "
                                "expected two that rub",
                                node->key, row->name, row->meaning, scenario->grip_count);
    if (row->needs & FW_PICTURE_NEEDS_FRICTION && !has_friction(scenario))
        return fw_scenario_fail(scenario, place, error,
                                "pictures.%s is of kind '%s', but nothing rubs: no surface of a "
                                "wall is 'coulomb', and there is no contact.friction",
                                node->key, row->name);
    return FW_OK;
}

static fw_status check_span(const fw_scenario *scenario, const fw_node *node,
                            const fw_scenario_picture *picture, fw_error *error)
{
    const fw_node *until = fw_node_find(node, "until"), *from = fw_node_find(node, "from");
    if (picture->from >= scenario->run.steps && from && scenario->run.steps > 0)
        return fw_scenario_fail(scenario, from->place, error,
                                "pictures.%s begins at step %lld, but the run ends at %lld",
                                node->key, (long long)picture->from,
                                (long long)scenario->run.steps);
    if (until && (picture->until <= picture->from || picture->until > scenario->run.steps))
        return fw_scenario_fail(scenario, until->place, error,
                                "pictures.%s ends at step %lld, expected %lld to %lld", node->key,
                                (long long)picture->until, (long long)picture->from + 1,
                                (long long)scenario->run.steps);
    const int64_t end = until ? picture->until : scenario->run.steps;
    if ((from || until) && fw_scenario_count_samples(scenario, picture->from, end) < 1)
        return fw_scenario_fail(scenario, (until ? until : from)->place, error,
                                "pictures.%s shows the steps %lld to %lld, in which nothing is "
                                "measured: run.measure-every is %lld",
                                node->key, (long long)picture->from, (long long)end,
                                (long long)scenario->run.measure_every);
    return FW_OK;
}

/* The ends of the colour scale. */
static fw_status check_range(const fw_scenario *scenario, const fw_node *node,
                             const fw_scenario_picture *picture, fw_error *error)
{
    const fw_node *range = fw_node_find(node, "range");
    if (!range || picture->range[0] < picture->range[1]) return FW_OK;
    return fw_scenario_fail(scenario, range->place, error,
                            "pictures.%s has colours from %g to %g, expected the lower value "
                            "first",
                            node->key, picture->range[0], picture->range[1]);
}

static fw_status check_body(const fw_scenario *scenario, const fw_node *node, fw_error *error)
{
    int count, index;
    const fw_node *part = fw_scenario_part(scenario, "bodies", &count);
    const fw_node *named = fw_node_find(node, "body");
    return named ? fw_scenario_find(scenario, part, "body", named, &index, error) : FW_OK;
}

/* The one named, or the only one. */
static fw_status check_analysis(const fw_scenario *scenario, const fw_node *node,
                                fw_scenario_picture *picture, fw_error *error)
{
    if (!(fw_picture_rows[picture->kind].needs & FW_PICTURE_NEEDS_ANALYSIS)) return FW_OK;
    int count, index;
    const fw_node *part = fw_scenario_part(scenario, "analysis", &count);
    const fw_node *named = fw_node_find(node, "analysis");
    if (named) return fw_scenario_find(scenario, part, "analysis", named, &index, error);
    if (count != 1)
        return fw_scenario_fail(scenario, picture->place, error,
                                "pictures.%s draws an analysis, of which the scenario has %d, "
                                "expected the key 'analysis'",
                                picture->name, count);
    picture->analysis = (fw_schema_name){part->first->key, part->first->key_place};
    return FW_OK;
}

/* Is it the name of a number in the table of the sweep, and none of a parameter? */
static bool is_compared(const fw_scenario *scenario, const char *name)
{
    static const char layer[] = "layer-";
    const fw_scenario_sweep *sweep = &scenario->study.sweep;
    for (int p = 0; p < sweep->parameter_count; ++p)
        if (strcmp(sweep->parameters[p].name, name) == 0) return false;
    for (int n = 0; n < scenario->expectation_count; ++n)
        if (strcmp(scenario->expectations[n].quantity.text, name) == 0) return true;
    return scenario->profile.every != 0 && strncmp(name, layer, strlen(layer)) == 0;
}

/* What of a sweep is drawn along x; a map shows one quantity. */
static fw_status check_sweep(const fw_scenario *scenario, const fw_node *node,
                             fw_scenario_picture *picture, fw_error *error)
{
    const fw_node *along = fw_node_find(node, "along");
    picture->along = -1;
    picture->has_level = fw_node_find(node, "level") != NULL;
    if (along && picture->kind == FW_PICTURE_SWEEP && is_compared(scenario, along->text))
        picture->along_quantity = along->text;
    else if (along)
        FW_TRY(fw_scenario_find_parameter(scenario, along, &picture->along, error));
    if (picture->kind != FW_PICTURE_MAP || picture->observables.count < 2) return FW_OK;
    return fw_scenario_fail(scenario, picture->observables.item[1].place, error,
                            "pictures.%s shows %d observables, expected one, which is all that the "
                            "colours of a map can show",
                            picture->name, picture->observables.count);
}

static fw_status read_instants(const fw_scenario *scenario, const fw_node *list,
                               fw_scenario_picture *picture, fw_error *error)
{
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *picture->instants,
                                &picture->instants, error));
    for (const fw_node *node = list->first; node; node = node->next) {
        int64_t instant = fw_node_integer(node);
        int count = picture->instant_count;
        if (instant > scenario->run.steps)
            return fw_scenario_fail(scenario, node->place, error,
                                    "pictures.%s shows step %lld, but the run ends at %lld",
                                    picture->name, (long long)instant,
                                    (long long)scenario->run.steps);
        if (count && instant <= picture->instants[count - 1])
            return fw_scenario_fail(scenario, node->place, error,
                                    "pictures.%s shows step %lld after step %lld, expected "
                                    "ascending steps",
                                    picture->name, (long long)instant,
                                    (long long)picture->instants[count - 1]);
        picture->instants[picture->instant_count++] = instant;
    }
    const bool pairs = picture->kind == FW_PICTURE_STRUCTURE || picture->kind == FW_PICTURE_STAGES;
    if (!pairs || list->count <= FW_PICTURE_PAIRS_MAX) return FW_OK;
    return fw_scenario_fail(scenario, list->place, error,
                            "pictures.%s shows %d instants, expected at most %d side by side",
                            picture->name, list->count, FW_PICTURE_PAIRS_MAX);
}

fw_status fw_scenario_read_pictures(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "pictures", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->pictures,
                                &scenario->pictures, error));
    for (const fw_node *node = part->first; node; node = node->next) {
        fw_scenario_picture *picture = &scenario->pictures[scenario->picture_count++];
        picture->name = node->key;
        picture->place = node->key_place;
        FW_TRY(fw_schema_fill(scenario->document, &fw_picture_section, node, picture, error));
        FW_TRY(check_keys(scenario, node, picture, error));
        FW_TRY(check_needs(scenario, node, picture, error));
        FW_TRY(check_span(scenario, node, picture, error));
        FW_TRY(check_body(scenario, node, error));
        FW_TRY(check_range(scenario, node, picture, error));
        FW_TRY(check_analysis(scenario, node, picture, error));
        FW_TRY(check_sweep(scenario, node, picture, error));
        const fw_node *instants = fw_node_find(node, "instants");
        if (instants) FW_TRY(read_instants(scenario, instants, picture, error));
    }
    return FW_OK;
}

bool fw_scenario_records_force(const fw_scenario *scenario)
{
    for (int p = 0; p < scenario->picture_count; ++p)
        if (fw_picture_rows[scenario->pictures[p].kind].needs & FW_PICTURE_NEEDS_FORCE) return true;
    return scenario->record.force;
}
