/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_grips.c - what drives grips and pistons, and the grips of a scenario. Keeps no state.
 * Start reading at fw_scenario_read_grips(). */
#include "scenario_parts.h"

static const fw_key grip_keys[] = {
    {"body", FW_FORM_NAME, REQUIRED, NOT_STORED, .meaning = "one of `bodies`"},
    {"sites", SELECTION, .default_value = "all", NOT_STORED,
     .meaning = "which of its particles; each is in one grip at most"},
    {"side", AT_WORD(fw_scenario_grip, side),
     WORDS({"left", FW_SIDE_LEFT}, {"right", FW_SIDE_RIGHT}, {"bottom", FW_SIDE_BOTTOM},
           {"top", FW_SIDE_TOP}),
     .needs = "layer", .default_value = "left",
     .meaning = "outer face that the layer is measured from"},
    {"layer", AT_NUMBER(fw_scenario_grip, layer), .needs = "side", ABOVE_ZERO,
     .default_meaning = "all the `sites`", .unit = "length",
     .meaning = "only what is so near to the outermost particles of that side"},
    DRIVE_KEYS(fw_scenario_grip, "period", ITSELF),
    {.name = NULL}};

const fw_section fw_grip_section = {
    "`grips.NAME`", "a grip",
    "A rigid block of particles of one body, held together by constraint forces. It does not "
    "turn; "
    "it moves by what drives it and what the rest of the body does to it.",
    .keys = grip_keys};

/* A key that stands here and says nothing without another one, here or elsewhere. */
static fw_status check_partner(const fw_scenario *scenario, const fw_node *written,
                               const fw_node *whole, const char *kind, const char *name,
                               const char *key, const char *partner, fw_error *error)
{
    const fw_node *node = fw_node_find(written, key);
    if (!node || fw_node_find(whole, partner)) return FW_OK;
    return fw_scenario_fail(scenario, node->key_place, error,
                            "%s '%s' has '%s' but no '%s', without which it means nothing", kind,
                            name, key, partner);
}

/* Forces in a component that follows its path, whatever forces say. */
static fw_status check_forces(const fw_scenario *scenario, const fw_node *written,
                              const fw_node *whole, const char *kind, const char *name,
                              const fw_scenario_drive *motion, fw_error *error)
{
    static const char *const forces[] = {"force", "amplitude", "tether"};
    for (int n = 0; n < 3; ++n) {
        const fw_node *force = fw_node_find(written, forces[n]);
        if (!force) continue;
        if ((motion->drive.prescribed_x && fw_node_number(force->first) != 0) ||
            (motion->drive.prescribed_y && fw_node_number(force->last) != 0))
            return fw_scenario_fail(scenario, force->place, error,
                                    "%s '%s' has the %s [%g, %g], but 'hold: %s' moves that "
                                    "component whatever force acts; expected 0 there",
                                    kind, name, forces[n], fw_node_number(force->first),
                                    fw_node_number(force->last), fw_node_find(whole, "hold")->text);
    }
    return FW_OK;
}

/* The phase whose beginning is time 0. */
static fw_status read_origin(const fw_scenario *scenario, const fw_node *written,
                             const fw_node *whole, const char *kind, const char *name,
                             fw_scenario_drive *motion, fw_error *error)
{
    const fw_node *from = fw_node_find(written, "time-from");
    motion->origin = -1;
    if (from && !fw_node_find(whole, "period") && !fw_node_find(whole, "path"))
        return fw_scenario_fail(scenario, from->key_place, error,
                                "%s '%s' has 'time-from' but neither 'period' nor 'path', without "
                                "which it means nothing",
                                kind, name);
    from = fw_node_find(whole, "time-from");
    return from ? fw_scenario_find_phase(scenario, from, &motion->origin, error) : FW_OK;
}

fw_status fw_scenario_read_drive(const fw_scenario *scenario, const fw_node *written,
                                 const fw_node *whole, const char *kind, const char *name,
                                 fw_scenario_drive *motion, fw_error *error)
{
    const fw_node *path = fw_node_find(written, "path");
    motion->drive.prescribed_x = motion->hold == FW_HOLD_X || motion->hold == FW_HOLD_BOTH;
    motion->drive.prescribed_y = motion->hold == FW_HOLD_Y || motion->hold == FW_HOLD_BOTH;
    if (path && motion->hold == FW_HOLD_NONE)
        return fw_scenario_fail(scenario, path->key_place, error,
                                "%s '%s' has a path that no component follows, expected 'hold: "
                                "x', 'y' or 'both'",
                                kind, name);
    static const char *const partners[][2] = {
        {"period", "amplitude"}, {"amplitude", "period"}, {"phase", "period"}};
    for (int n = 0; n < 3; ++n)
        FW_TRY(check_partner(scenario, written, whole, kind, name, partners[n][0], partners[n][1],
                             error));
    FW_TRY(check_forces(scenario, written, whole, kind, name, motion, error));
    return read_origin(scenario, written, whole, kind, name, motion, error);
}

static fw_status read_grip(fw_scenario *scenario, const fw_node *node, fw_scenario_grip *grip,
                           fw_error *error)
{
    grip->name = node->key;
    grip->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, &fw_grip_section, node, grip, error));
    int count;
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "bodies", &count), "body",
                            fw_node_find(node, "body"), &grip->body, error));
    FW_TRY(fw_scenario_read_selection(scenario, node, &scenario->bodies[grip->body], &grip->sites,
                                      error));
    return fw_scenario_read_drive(scenario, node, node, "grip", node->key, &grip->motion, error);
}

fw_status fw_scenario_read_grips(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "grips", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->grips, &scenario->grips,
                                error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_grip(scenario, node, &scenario->grips[scenario->grip_count++], error));
    return FW_OK;
}
