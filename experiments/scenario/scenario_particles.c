/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_particles.c - materials of movable particles. Keeps no state. Start reading at
 * fw_scenario_read_particles(). */
#include "scenario_parts.h"

#include <math.h>

/* Where something is led to zero: only its first two members are written. */
#define AT_CUT(object, member)                                                                     \
    .forms = FW_FORM_NUMBERS, FW_PLACE(object, member, FW_IS(object, member, fw_smooth_cut))

static const fw_key lennard_jones_keys[] = {
    {"depth", AT_NUMBER(fw_pair_potential, depth), AT_LEAST(0), .default_value = "1",
     .unit = "energy", .meaning = "epsilon, of the minimum"},
    {"distance", AT_NUMBER(fw_pair_potential, distance), ABOVE_ZERO, .default_value = "1",
     .unit = "length", .meaning = "r0, of the minimum"},
    {"cut", AT_CUT(fw_pair_potential, cut), .layout = "[from, to]", AT_LEAST(0),
     .default_value = "[1.4, 1.7]", .unit = "length", .meaning = "where it is led to zero"},
    {.name = NULL}};

static const fw_section fw_lennard_jones_section = {
    "`potential.lennard-jones`", "a Lennard-Jones potential",
    "depth [(distance/r)^12 - 2 (distance/r)^6].", .keys = lennard_jones_keys};

static const fw_key morse_keys[] = {
    {"depth", AT_NUMBER(fw_pair_potential, depth), AT_LEAST(0), .default_value = "1",
     .unit = "energy", .meaning = "of the minimum"},
    {"distance", AT_NUMBER(fw_pair_potential, distance), ABOVE_ZERO, .default_value = "1",
     .unit = "length", .meaning = "r0, of the minimum"},
    {"steepness", AT_NUMBER(fw_pair_potential, steepness), ABOVE_ZERO, .default_value = "6",
     .unit = "1/length", .meaning = "6/r0 has the curvature of Lennard-Jones"},
    {"cut", AT_CUT(fw_pair_potential, cut), .layout = "[from, to]", AT_LEAST(0),
     .default_value = "[1.4, 1.7]", .unit = "length", .meaning = "where it is led to zero"},
    {.name = NULL}};

static const fw_section fw_morse_section = {"`potential.morse`", "a Morse potential",
                                            "depth [(1 - e^(-steepness (r - distance)))^2 - 1].",
                                            .keys = morse_keys};

static const fw_key potential_keys[] = {{"lennard-jones", AT_SAME,
                                         .subsection = &fw_lennard_jones_section, ALTERNATIVE,
                                         .meaning = "the paper's"},
                                        {"morse", AT_SAME, .subsection = &fw_morse_section,
                                         ALTERNATIVE, .meaning = "with a steepness of its own"},
                                        {.name = NULL}};

static const fw_section fw_potential_section = {
    "`potential`", "a pair potential",
    "Led smoothly to zero over its cut; its minimum must lie where it has its full strength.",
    .keys = potential_keys};

static const fw_key return_force_keys[] = {
    {"symmetry", AT_INTEGER(fw_scenario_particles, symmetry), FROM_TO(2, 24), .default_value = "6",
     .meaning =
         "n: how many axes there are around; even, 6 for hexagonal bodies, 4 for square ones"},
    {"amplitude", AT_NUMBER(fw_scenario_particles, return_force.amplitude), REQUIRED, AT_LEAST(0),
     .unit = "force", .meaning = "f0"},
    {"variant", AT_WORD(fw_scenario_particles, return_force.variant),
     WORDS({"conservative", FW_RETURN_CONSERVATIVE}, {"constant", FW_RETURN_CONSTANT}),
     .default_value = "conservative",
     .meaning =
         "conservative: with a potential; constant: the paper's, of constant amplitude, which "
         "heats whatever flows"},
    {"axes", AT_WORD(fw_scenario_particles, return_force.axes),
     WORDS({"lab", FW_AXES_LAB}, {"corotating", FW_AXES_COROTATING}, {"surface", FW_AXES_SURFACE}),
     .default_value = "corotating",
     .meaning =
         "lab: fixed, the body is a torsion pendulum, as in the paper; corotating: they turn "
         "with the body, whose angular momentum is kept; surface: fixed, and forces at the "
         "surface take the torque off"},
    {"angle", AT_ANGLE(fw_scenario_particles, return_force.angle), FROM_TO(-360, 360),
     .default_meaning = "that of the body's lattice", .unit = "degrees",
     .meaning = "of the axes, where they are fixed"},
    {"reach", AT_CUT(fw_scenario_particles, return_force.cut), .layout = "[from, to]", AT_LEAST(0),
     .default_value = "[1.2, 1.4]", .unit = "length",
     .meaning = "where it is led to zero; must end before 2^(1/2) r0, where diagonals are"},
    {.name = NULL}};

static const fw_section fw_return_force_section = {
    "`return-force`", "a return force",
    "On each bond of direction phi: -amplitude sin(symmetry (phi - axes)) across the bond.",
    .keys = return_force_keys};

static const fw_key movable_particles_keys[] = {
    {"potential", AT_OBJECT(fw_scenario_particles, potential), .subsection = &fw_potential_section,
     .default_meaning = "Lennard-Jones with its defaults", .meaning = "between any two particles"},
    {"return-force", AT_SAME, .subsection = &fw_return_force_section, .default_meaning = "none",
     .meaning = "on bonds inside a body"},
    {"mass", AT_NUMBER(fw_scenario_particles, mass), ABOVE_ZERO, .default_value = "1",
     .unit = "mass", .meaning = "of each particle"},
    {"strength", AT_NUMBER(fw_scenario_particles, strength), AT_LEAST(0), .default_value = "1",
     .meaning = "factor on the potential inside a body; at 0 its particles are a gas"},
    {.name = NULL}};

const fw_section fw_particles_section = {
    "`materials.NAME.movable-particles`", "a material of movable particles",
    "The solid of Popov and Filippov (2006): particles that attract and repel each other, across "
    "bodies too, and within a body return forces that turn bonds towards the body's axes. It can "
    "flow and melt. All such bodies of a scenario have the same potential.",
    .keys = movable_particles_keys};

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
    return fw_scenario_fail_again(scenario, node->first->key_place,
                                  fw_pair_potential_check(potential, error), error);
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
    const fw_node *reach = fw_node_find(node, "reach");
    return fw_scenario_fail_again(scenario, reach ? reach->place : node->key_place,
                                  fw_return_force_check(force, error), error);
}

static fw_status read_particles(const fw_scenario *scenario, const fw_node *node,
                                fw_scenario_material *material, fw_error *error)
{
    fw_scenario_particles *particles = &material->particles;
    FW_TRY(read_potential(scenario, fw_node_find(node, "potential"), particles, error));
    return read_return_force(scenario, fw_node_find(node, "return-force"), particles, error);
}

static bool same_potential(const fw_pair_potential *a, const fw_pair_potential *b)
{
    return a->kind == b->kind && a->depth == b->depth && a->distance == b->distance &&
           (a->kind != FW_MORSE || a->steepness == b->steepness) && a->cut.inner == b->cut.inner &&
           a->cut.outer == b->cut.outer;
}

static fw_status check_particles(const fw_scenario *scenario, fw_error *error)
{
    const fw_scenario_material *first = NULL;
    for (int b = 0; b < scenario->body_count; ++b) {
        const fw_scenario_material *material = &scenario->materials[scenario->bodies[b].material];
        if (material->kind != FW_MOVABLE_PARTICLES) continue;
        if (!first) first = material;
        if (!same_potential(&first->particles.potential, &material->particles.potential))
            return fw_scenario_fail(scenario, material->place, error,
                                    "material '%s' has another potential than '%s', expected the "
                                    "same: movable particles of all bodies attract each other",
                                    material->name, first->name);
    }
    return FW_OK;
}

/* r0 (m/epsilon)^(1/2), where particles attract. */
static double time_unit(const fw_scenario_material *material)
{
    const fw_scenario_particles *particles = &material->particles;
    const double depth = particles->potential.depth * particles->strength;
    return depth > 0 ? particles->potential.distance * sqrt(particles->mass / depth) : 0;
}

const fw_material_model fw_particles_material = {.bodies = "movable particles",
                                                 .lattices = 1 << FW_SQUARE | 1 << FW_HEXAGONAL,
                                                 .body_keys = " spin temperature ",
                                                 .flows = true,
                                                 .has_dynamics = true,
                                                 .citation = "popov2007",
                                                 .time_unit = time_unit,
                                                 .read = read_particles,
                                                 .check_bodies = check_particles};
