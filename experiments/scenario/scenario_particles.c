/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_particles.c - what a scenario says of movable particles: their material, where they are
 * placed, and the dynamics that all of them share. Keeps no state. */
#include "scenario_parts.h"

/* The sentence of a part of the solid, at the place where its cause was written. */
static fw_status pass_on(const fw_scenario *scenario, fw_place place, const fw_error *inner,
                         fw_error *error)
{
    return fw_scenario_fail(scenario, place, error, "%s", inner->sentence);
}

/* --- materials --- */

static fw_status read_potential(const fw_scenario *scenario, const fw_node *node,
                                fw_scenario_particles *particles, fw_error *error)
{
    fw_pair_potential *potential = &particles->potential;
    if (!node) {
        *potential = fw_pair_potential_default();
        return FW_OK;
    }
    potential->kind = fw_node_find(node, "morse") ? FW_MORSE : FW_LENNARD_JONES;
    potential->cut = fw_smooth_cut_over(potential->cut.inner, potential->cut.outer);
    fw_error inner;
    if (fw_pair_potential_check(potential, &inner) == FW_OK) return FW_OK;
    return pass_on(scenario, node->first->key_place, &inner, error);
}

static fw_status read_return_force(const fw_scenario *scenario, const fw_node *node,
                                   fw_scenario_particles *particles, fw_error *error)
{
    fw_return_force *force = &particles->return_force;
    if (!node) {
        *force = fw_return_force_default();
        return FW_OK;
    }
    const fw_node *symmetry = fw_node_find(node, "symmetry"), *angle = fw_node_find(node, "angle");
    if (particles->symmetry % 2 != 0)
        return fw_scenario_fail(
            scenario, symmetry->place, error,
            "the symmetry is %lld, expected an even number (6 for hexagonal "
            "bodies, 4 for square ones): with an odd one the two particles of a "
            "bond would not pull equally",
            (long long)particles->symmetry);
    force->fold = (int)particles->symmetry;
    force->distance = particles->potential.distance;
    force->cut = fw_smooth_cut_over(force->cut.inner, force->cut.outer);
    particles->own_angle = angle != NULL;
    if (angle && force->axes == FW_AXES_COROTATING)
        return fw_scenario_fail(scenario, angle->key_place, error,
                                "the return force has both an 'angle' and corotating axes, which "
                                "find theirs by themselves; expected 'axes: lab' or no angle");
    fw_error inner;
    if (fw_return_force_check(force, &inner) == FW_OK) return FW_OK;
    const fw_node *reach = fw_node_find(node, "reach");
    return pass_on(scenario, reach ? reach->place : node->key_place, &inner, error);
}

fw_status fw_scenario_read_particles(const fw_scenario *scenario, const fw_node *node,
                                     fw_scenario_particles *particles, fw_error *error)
{
    FW_TRY(read_potential(scenario, fw_node_find(node, "potential"), particles, error));
    return read_return_force(scenario, fw_node_find(node, "return-force"), particles, error);
}

/* --- bodies --- */

fw_status fw_scenario_read_placed(const fw_scenario *scenario, const fw_node *node,
                                  fw_scenario_body *body, fw_error *error)
{
    fw_scenario_shape *shape = &body->shape;
    double box[4];
    if (scenario->materials[body->material].kind != FW_MOVABLE_PARTICLES)
        return fw_scenario_fail(scenario, node->key_place, error,
                                "bodies.%s is placed at random, which only movable particles can "
                                "be: the others live on a lattice",
                                body->name);
    FW_TRY(fw_schema_fill(scenario->document, "placed", node, shape, error));
    const fw_node *corners = fw_node_find(node, "box");
    fw_node_numbers(corners, box);
    shape->kind = FW_SHAPE_PLACED;
    shape->low = (fw_vec2){box[0], box[1]};
    shape->high = (fw_vec2){box[2], box[3]};
    shape->count = fw_node_integer(fw_node_find(node, "count"));
    shape->columns = (int)shape->count;
    shape->rows = 1;
    shape->last_column = shape->columns - 1;
    if (shape->low.x < shape->high.x && shape->low.y < shape->high.y) return FW_OK;
    return fw_scenario_fail(scenario, corners->place, error,
                            "bodies.%s.shape.placed.box goes from [%g, %g] to [%g, %g], expected "
                            "the lower left corner first and the upper right one next",
                            body->name, box[0], box[1], box[2], box[3]);
}

/* --- dynamics --- */

static bool same_potential(const fw_pair_potential *a, const fw_pair_potential *b)
{
    return a->kind == b->kind && a->depth == b->depth && a->distance == b->distance &&
           (a->kind != FW_MORSE || a->steepness == b->steepness) && a->cut.inner == b->cut.inner &&
           a->cut.outer == b->cut.outer;
}

fw_status fw_scenario_check_dynamics(fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_material *first = NULL;
    bool moves = false;
    for (int b = 0; b < scenario->body_count; ++b) {
        const fw_scenario_material *material = &scenario->materials[scenario->bodies[b].material];
        moves |= material->kind == FW_MOVABLE_PARTICLES || material->kind == FW_LINEAR_LATTICE;
        if (material->kind != FW_MOVABLE_PARTICLES) continue;
        if (!first) first = material;
        if (!same_potential(&first->particles.potential, &material->particles.potential))
            return fw_scenario_fail(scenario, material->place, error,
                                    "material '%s' has another potential than '%s', expected the "
                                    "same: movable particles of all bodies attract each other",
                                    material->name, first->name);
    }
    int count;
    const fw_node *dynamics = fw_scenario_part(scenario, "dynamics", &count);
    const fw_node *time_step = dynamics ? fw_node_find(dynamics, "time-step") : NULL;
    if (time_step) scenario->dynamics.time_step_place = time_step->place;
    if (moves && scenario->run.reverse_at > 0 && scenario->dynamics.damping > 0)
        return fw_scenario_fail(
            scenario, fw_node_find(dynamics, "damping")->place, error,
            "dynamics.damping is %g in a run that is reversed, expected 0: what "
            "damping took does not come back",
            scenario->dynamics.damping);
    const fw_node *phases = fw_scenario_part(scenario, "phases", &count);
    for (const fw_node *phase = phases ? phases->first : NULL; phase && !moves;
         phase = phase->next) {
        const fw_node *bath = fw_node_find(phase, "damping");
        if (!bath) bath = fw_node_find(phase, "temperature");
        if (bath)
            return fw_scenario_fail(scenario, bath->key_place, error,
                                    "phase '%s' has '%s', which is for movable particles and "
                                    "linear lattices, and no body is one",
                                    phase->key, bath->key);
    }
    if (!dynamics || moves) return FW_OK;
    return fw_scenario_fail(scenario, dynamics->key_place, error,
                            "'dynamics' is for movable particles and linear lattices, and no body "
                            "is one");
}
