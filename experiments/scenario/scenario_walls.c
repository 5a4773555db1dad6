/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_walls.c - walls and external forces of a scenario. Keeps no state. */
#include "scenario_parts.h"

/* --- walls --- */

static const fw_node *find_geometry(const fw_node *wall)
{
    static const char *const keys[] = {"box", "polygon", "circle", "chain"};
    const fw_node *found = NULL;
    for (int n = 0; n < 4 && !found; ++n) found = fw_node_find(wall, keys[n]);
    return found;
}

static fw_status read_points(const fw_scenario *scenario, const fw_node *list, fw_wall_def *def,
                             fw_error *error)
{
    fw_vec2 *points;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)list->count, sizeof *points, &points, error));
    def->points = points;
    for (const fw_node *pair = list->first; pair; pair = pair->next)
        points[def->point_count++] =
            (fw_vec2){fw_node_number(pair->first), fw_node_number(pair->last)};
    return FW_OK;
}

static fw_status read_geometry(const fw_scenario *scenario, const fw_node *node, fw_wall_def *def,
                               fw_error *error)
{
    const fw_node *given;
    double values[4];
    fw_vec2 *points;
    if ((given = fw_node_find(node, "polygon"))) {
        def->shape = FW_POLYGON;
        return read_points(scenario, given, def, error);
    }
    if ((given = fw_node_find(node, "chain"))) {
        def->shape = FW_CHAIN;
        return read_points(scenario, given, def, error);
    }
    FW_TRY(fw_scenario_allocate(scenario, 2, sizeof *points, &points, error));
    def->points = points;
    if ((given = fw_node_find(node, "circle"))) {
        fw_node_numbers(given, values);
        def->shape = FW_CIRCLE;
        def->point_count = 1;
        points[0] = (fw_vec2){values[0], values[1]};
        def->radius = values[2];
    } else {
        fw_node_numbers(fw_node_find(node, "box"), values);
        def->shape = FW_BOX;
        def->point_count = 2;
        points[0] = (fw_vec2){values[0], values[1]};
        points[1] = (fw_vec2){values[2], values[3]};
    }
    return FW_OK;
}

static fw_surface read_surface(const fw_node *node)
{
    if (!node) return (fw_surface){.law = FW_FRICTIONLESS};
    static const fw_surface_law laws[] = {FW_FRICTIONLESS, FW_STICK, FW_COMPONENTWISE};
    if (node->kind == FW_SCALAR)
        return (fw_surface){.law =
                                laws[fw_node_word(node, fw_schema_find("wall", "surface")->words)]};
    const fw_node *penalty = fw_node_find(node, "penalty");
    if (penalty) return (fw_surface){.law = FW_PENALTY, .stiffness = fw_node_number(penalty)};
    return (fw_surface){.law = FW_COULOMB,
                        .friction = fw_node_number(fw_node_find(node, "coulomb"))};
}

static fw_status read_piston(const fw_scenario *scenario, const fw_node *node,
                             fw_scenario_wall *wall, fw_error *error)
{
    const fw_node *piston = fw_node_find(node, "piston"), *path = fw_node_find(node, "path");
    if (!piston) return FW_OK;
    wall->is_piston = true;
    if (path)
        return fw_scenario_fail(
            scenario, path->key_place, error,
            "walls.%s has both 'piston' and 'path'; a piston is moved by forces, "
            "or by a path within 'piston'",
            node->key);
    FW_TRY(
        fw_scenario_read_drive(scenario, piston, "piston", node->key, &wall->piston.motion, error));
    const fw_node *velocity = fw_node_find(piston, "velocity");
    const fw_drive *drive = &wall->piston.motion.drive;
    if (velocity && ((drive->prescribed_x && wall->piston.velocity.x != 0) ||
                     (drive->prescribed_y && wall->piston.velocity.y != 0)))
        return fw_scenario_fail(
            scenario, velocity->place, error,
            "piston '%s' has the velocity [%g, %g], expected 0 in the component "
            "that 'hold' names",
            node->key, wall->piston.velocity.x, wall->piston.velocity.y);
    return FW_OK;
}

static fw_status read_wall(fw_scenario *scenario, const fw_node *node, fw_scenario_wall *wall,
                           fw_error *error)
{
    fw_wall_def *def = &wall->def;
    wall->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, "wall", node, wall, error));
    def->name = node->key;
    FW_TRY(read_geometry(scenario, node, def, error));
    def->surface = read_surface(fw_node_find(node, "surface"));
    const fw_node *side = fw_node_find(node, "side");
    if (side && def->shape == FW_CHAIN)
        return fw_scenario_fail(scenario, side->key_place, error,
                                "walls.%s has both 'chain' and 'side'; a chain is free to the left "
                                "of the way along it, so turn its points round instead",
                                node->key);
    fw_error inner;
    if (fw_wall_def_check(def, &inner) != FW_OK)
        return fw_scenario_fail(scenario, find_geometry(node)->place, error, "%s", inner.sentence);
    return read_piston(scenario, node, wall, error);
}

fw_status fw_scenario_read_walls(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "walls", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->walls, &scenario->walls,
                                error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_wall(scenario, node, &scenario->walls[scenario->wall_count++], error));
    return FW_OK;
}

/* --- forces --- */

static fw_status read_force(fw_scenario *scenario, const fw_node *node, fw_scenario_force *force,
                            fw_error *error)
{
    static const struct {
        const char *key;
        fw_force_kind kind;
    } kinds[] = {{"force", FW_FORCE_EACH},
                 {"total", FW_FORCE_TOTAL},
                 {"acceleration", FW_FORCE_ACCELERATION}};
    force->name = node->key;
    force->place = node->key_place;
    FW_TRY(fw_schema_fill(scenario->document, "force", node, force, error));
    int count;
    FW_TRY(fw_scenario_find(scenario, fw_scenario_part(scenario, "bodies", &count), "body",
                            fw_node_find(node, "body"), &force->body, error));
    FW_TRY(fw_scenario_read_selection(scenario, node, &scenario->bodies[force->body], &force->sites,
                                      error));
    force->kind = FW_FORCE_RANDOM;
    for (size_t n = 0; n < sizeof kinds / sizeof kinds[0]; ++n) {
        const fw_node *vector = fw_node_find(node, kinds[n].key);
        if (!vector) continue;
        force->kind = kinds[n].kind;
        force->vector = (fw_vec2){fw_node_number(vector->first), fw_node_number(vector->last)};
    }
    if (force->until <= force->from)
        return fw_scenario_fail(scenario, fw_node_find(node, "until")->place, error,
                                "forces.%s.until is %lld, expected more than 'from', which is %lld",
                                node->key, (long long)force->until, (long long)force->from);
    return FW_OK;
}

fw_status fw_scenario_read_forces(fw_scenario *scenario, fw_error *error)
{
    int count;
    const fw_node *part = fw_scenario_part(scenario, "forces", &count);
    if (!part) return FW_OK;
    FW_TRY(fw_scenario_allocate(scenario, (size_t)count, sizeof *scenario->forces,
                                &scenario->forces, error));
    for (const fw_node *node = part->first; node; node = node->next)
        FW_TRY(read_force(scenario, node, &scenario->forces[scenario->force_count++], error));
    return FW_OK;
}
