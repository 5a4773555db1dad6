/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_contact.c - surfaces of a scenario, and how each pair of them rubs. Keeps no state.
 * Start reading at fw_scenario_read_contact(). */
#include "experiments/text/spelling.h"
#include "scenario_parts.h"

#include <string.h>

static const fw_key friction_keys[] = {
    {"static", FW_FORM_NUMBER, REQUIRED, FROM_TO(0, 1000), NOT_STORED,
     .meaning = "of what sticks, or has just come: it bears at most this times the reaction"},
    {"kinetic", FW_FORM_NUMBER, REQUIRED, FROM_TO(0, 1000), NOT_STORED,
     .meaning = "of what slides, until this times the reaction is enough for it to stick; at most "
                "`static`"},
    {.name = NULL}};

const fw_section fw_friction_section = {
    "`friction`, `coulomb`", "a friction",
    "A number, which is both, or a mapping. The reaction is the mean of the normal forces of two "
    "steps.",
    .keys = friction_keys};

#define FRICTION_FORMS                                                                             \
    FW_FORM_NUMBER | FW_FORM_MAPPING, FROM_TO(0, 1000), .subsection = &fw_friction_section,        \
                                                        NOT_STORED

static const fw_key pair_keys[] = {
    {"between", FW_FORM_LIST, .items = FW_FORM_NAME, REQUIRED, .least = 2, .most = 2, NOT_STORED,
     .meaning = "two surfaces that bodies or walls name, or one of them twice"},
    {"friction", .forms = FRICTION_FORMS, REQUIRED,
     .meaning = "coefficient of friction between them"},
    {"distance", FW_FORM_NUMBER, AT_LEAST(0), NOT_STORED, .unit = "length",
     .default_meaning = "`contact.distance`",
     .meaning = "that bodies with these surfaces keep from each other"},
    {.name = NULL}};

static const fw_section fw_pair_section = {"Items of `contact.pairs`", "a pair of surfaces",
                                           "How two surfaces rub on each other.",
                                           .keys = pair_keys};

static const fw_key contact_keys[] = {
    {"friction", .forms = FRICTION_FORMS, .default_value = "0",
     .meaning = "coefficient of friction between bodies, and between bodies and walls with a "
                "`named` surface: the tangential force is at most this times the reaction"},
    {"distance", FW_FORM_NUMBER, AT_LEAST(0), NOT_STORED, .default_value = "0", .unit = "length",
     .meaning =
         "that LB solids and linear lattices keep from each other and from walls; they start "
         "no nearer"},
    {"pairs", FW_FORM_LIST, .items = FW_FORM_MAPPING, .subsection = &fw_pair_section,
     .most = FW_NAMED_MAX, NOT_STORED, .default_meaning = "none",
     .meaning = "pairs of surfaces with another `friction` or `distance`"},
    {.name = NULL}};

const fw_section fw_contact_section = {
    "`contact`", "a contact",
    "What happens where bodies touch each other, and where surfaces have names.",
    .keys = contact_keys};

fw_status fw_scenario_read_friction(const fw_scenario *scenario, const fw_node *node,
                                    fw_friction *friction, fw_error *error)
{
    *friction = (fw_friction){0};
    if (!node) return FW_OK;
    if (node->kind == FW_SCALAR) {
        friction->kinetic = friction->at_rest = fw_node_number(node);
        return FW_OK;
    }
    friction->kinetic = fw_node_number(fw_node_find(node, "kinetic"));
    friction->at_rest = fw_node_number(fw_node_find(node, "static"));
    if (friction->kinetic <= friction->at_rest) return FW_OK;
    return fw_scenario_fail(scenario, fw_node_find(node, "kinetic")->place, error,
                            "the kinetic coefficient of friction is %g, expected at most the "
                            "static one, %g",
                            friction->kinetic, friction->at_rest);
}

/* Its number; it becomes one where nobody has named it yet. */
static int surface_of(fw_scenario_contact *contact, const fw_node *name)
{
    if (!name) return 0;
    for (int n = 1; n < contact->surface_count; ++n)
        if (!strcmp(contact->surfaces[n], name->text)) return n;
    contact->surfaces[contact->surface_count] = name->text;
    return contact->surface_count++;
}

static fw_status find_surface(const fw_scenario *scenario, const fw_node *name, int *number,
                              fw_error *error)
{
    const fw_scenario_contact *contact = &scenario->contact;
    fw_suggestion suggestion = fw_suggestion_begin(name->text);
    for (*number = 1; *number < contact->surface_count; ++*number) {
        if (!strcmp(contact->surfaces[*number], name->text)) return FW_OK;
        fw_suggestion_offer(&suggestion, contact->surfaces[*number]);
    }
    if (suggestion.best)
        return fw_scenario_fail(scenario, name->place, error,
                                "no body or wall has the surface '%s'; did you mean '%s'?",
                                name->text, suggestion.best);
    return fw_scenario_fail(scenario, name->place, error,
                            "no body or wall has the surface '%s', expected one that a 'surface' "
                            "names",
                            name->text);
}

static void name_surfaces(fw_scenario *scenario)
{
    int count, n = 0;
    const fw_node *bodies = fw_scenario_part(scenario, "bodies", &count);
    for (const fw_node *body = bodies->first; body; body = body->next)
        scenario->bodies[n++].surface =
            surface_of(&scenario->contact, fw_node_find(body, "surface"));
    const fw_node *walls = fw_scenario_part(scenario, "walls", &count);
    n = 0;
    for (const fw_node *wall = walls ? walls->first : NULL; wall; wall = wall->next, ++n) {
        const fw_node *surface = fw_node_find(wall, "surface");
        if (!surface || surface->kind != FW_MAPPING) continue;
        const fw_node *name = fw_node_find(surface, "named");
        if (name) scenario->walls[n].def.surface.number = 1 + surface_of(&scenario->contact, name);
    }
}

bool fw_scenario_bodies_rub(const fw_scenario *scenario)
{
    const int count = scenario->contact.surface_count;
    for (int n = 0; n < count * count; ++n)
        if (scenario->contact.pairs[n].kinetic > 0) return true;
    return false;
}

static fw_status read_pair(fw_scenario *scenario, const fw_node *node, bool *given, fw_error *error)
{
    fw_scenario_contact *contact = &scenario->contact;
    const fw_node *between = fw_node_find(node, "between");
    int a, b;
    FW_TRY(find_surface(scenario, between->first, &a, error));
    FW_TRY(find_surface(scenario, between->last, &b, error));
    const int ab = a * contact->surface_count + b, ba = b * contact->surface_count + a;
    if (given[ab])
        return fw_scenario_fail(scenario, between->place, error,
                                "the pair of surfaces '%s' and '%s' stands there twice",
                                between->first->text, between->last->text);
    given[ab] = given[ba] = true;
    FW_TRY(fw_scenario_read_friction(scenario, fw_node_find(node, "friction"), &contact->pairs[ab],
                                     error));
    contact->pairs[ba] = contact->pairs[ab];
    const fw_node *distance = fw_node_find(node, "distance");
    if (!distance) return FW_OK;
    contact->distances[ab] = contact->distances[ba] = fw_node_number(distance);
    for (int w = 0; w < scenario->wall_count; ++w) {
        const int own = scenario->walls[w].def.surface.number - 1;
        if (own != a && own != b) continue;
        return fw_scenario_fail(scenario, distance->place, error,
                                "bodies keep contact.distance from walls, and wall %s is of the "
                                "surface '%s': expected no distance of its own",
                                scenario->walls[w].def.name, contact->surfaces[own]);
    }
    return FW_OK;
}

fw_status fw_scenario_read_contact(fw_scenario *scenario, fw_error *error)
{
    fw_scenario_contact *contact = &scenario->contact;
    const int most = 1 + scenario->body_count + scenario->wall_count;
    int count;
    bool *given;
    fw_friction common;
    const fw_node *part = fw_scenario_part(scenario, "contact", &count);
    FW_TRY(fw_scenario_allocate(scenario, (size_t)most, sizeof *contact->surfaces,
                                &contact->surfaces, error));
    contact->surface_count = 1;
    name_surfaces(scenario);
    const size_t pairs = (size_t)contact->surface_count * (size_t)contact->surface_count;
    FW_TRY(fw_scenario_allocate(scenario, pairs, sizeof *contact->pairs, &contact->pairs, error));
    FW_TRY(fw_scenario_allocate(scenario, pairs, sizeof *given, &given, error));
    FW_TRY(fw_scenario_read_friction(scenario, part ? fw_node_find(part, "friction") : NULL,
                                     &common, error));
    for (size_t n = 0; n < pairs; ++n) contact->pairs[n] = common;
    const fw_node *distance = part ? fw_node_find(part, "distance") : NULL;
    if (distance) contact->distance = fw_node_number(distance);
    FW_TRY(fw_scenario_allocate(scenario, pairs, sizeof *contact->distances, &contact->distances,
                                error));
    for (size_t n = 0; n < pairs; ++n) contact->distances[n] = contact->distance;
    const fw_node *list = part ? fw_node_find(part, "pairs") : NULL;
    for (const fw_node *pair = list ? list->first : NULL; pair; pair = pair->next)
        FW_TRY(read_pair(scenario, pair, given, error));
    return FW_OK;
}
