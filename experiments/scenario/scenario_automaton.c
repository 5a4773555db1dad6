/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_automaton.c - elastic automata of a scenario: their materials, and what their bodies
 * may have. Keeps no state. Start reading at fw_scenario_read_automaton(). */
#include "core/lattice.h"
#include "scenario_parts.h"

#include <math.h>
#include <string.h>

static const fw_key elastic_automaton_keys[] = {
    {"c1", AT_NUMBER(fw_scenario_automaton, speeds.transverse), ALTERNATIVE, AT_LEAST(0),
     .unit = "spacings/step", .meaning = "speed of transverse waves; c1^2 is the shear modulus"},
    {"c2", AT_NUMBER(fw_scenario_automaton, speeds.coupling), .needs = "c1", AT_LEAST(0),
     .default_meaning = "must stand beside `c1`", .unit = "spacings/step",
     .meaning = "couples x and y; c2^2 is lambda plus the shear modulus, at 0 they know nothing of "
                "each other"},
    {"shear-modulus", FW_FORM_NUMBER, ALTERNATIVE, ABOVE_ZERO, NOT_STORED,
     .unit = "(spacings/step)^2", .meaning = "in place of c1 and c2, with `poisson-ratio`"},
    {"poisson-ratio", FW_FORM_NUMBER, .needs = "shear-modulus", FROM_TO(-1, 0.999), NOT_STORED,
     .default_meaning = "must stand beside `shear-modulus`",
     .meaning = "that of the plane, lambda/(lambda + 2 mu)"},
    {"chopard", FW_FORM_FLAG, ALTERNATIVE, NOT_STORED,
     .meaning = "`true`: Chopard's automaton, c1 = 2^(1/2) and c2 = 0, which is the lattice "
                "Boltzmann solid with M0 = 0"},
    {"boundary", AT_WORD(fw_scenario_automaton, boundary),
     WORDS({"bond", FW_EDGES_BOND}, {"trapezoid", FW_EDGES_TRAPEZOID}, {"mirror", FW_EDGES_MIRROR},
           {"periodic", FW_EDGES_PERIODIC}),
     .default_value = "bond",
     .meaning =
         "what a missing neighbour contributes. bond: nothing; trapezoid: nothing, and bonds "
         "along an edge count half; both conserve energy and momentum. mirror: what the "
         "opposite neighbour does; keeps neither. periodic: the body's frame closes upon "
         "itself, its columns and rows must be even"},
    {"damping", AT_NUMBER(fw_scenario_automaton, damping), FROM_TO_BELOW(0, 1),
     .hint = "0 is none, and what was a is 1 - damping", .default_value = "0",
     .meaning = "part of a wave that each step takes. 0 is none; the a of the paper is "
                "1 - damping. A lattice Boltzmann solid with half of it is damped alike"},
    {"black", AT_WORD(fw_scenario_automaton, black), WORDS({"even", 0}, {"odd", 1}),
     .default_value = "even",
     .meaning = "the sites [i, j] that move first: those with i + j even, or odd"},
    {"break-at", AT_NUMBER(fw_scenario_automaton, break_at), ABOVE_ZERO,
     .default_meaning = "bonds never break", .unit = "length",
     .meaning = "a bond whose ends are displaced from each other by more than this breaks; needs "
                "boundary `bond` and a c2 at which every bond's matrix is positive"},
    {.name = NULL}};

const fw_section fw_automaton_section = {
    "`materials.NAME.elastic-automaton`", "an elastic automaton",
    "The solid of Dong, Zhang, Xu and Gan: black and white cells move in turn, each reflected "
    "about the place that its neighbours give. One step is a black and a white half-step and "
    "takes one unit of time. Waves run at c1 (transverse) and (c1^2 + c2^2)^(1/2) (longitudinal) "
    "spacings per step; c1^2 + c2^2 must not exceed 2. A boundary rule that is unstable for a "
    "body, by the spectral radius of the body's own update, is refused. If one body of a scenario "
    "is an automaton, all must be: it moves in half-steps.",
    .keys = elastic_automaton_keys};

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

static fw_status read_automaton(const fw_scenario *scenario, const fw_node *node,
                                fw_scenario_material *owner, fw_error *error)
{
    fw_scenario_automaton *material = &owner->automaton;
    const fw_node *given, *partner;
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
        const fw_status status = fw_automaton_speeds_from_moduli(
            &material->speeds, fw_node_number(given), fw_node_number(partner), error);
        FW_TRY(fw_scenario_fail_again(scenario, given->place, status, error));
    } else {
        given = fw_node_find(node, "c1");
        FW_TRY(find_partner(scenario, node, "c2", given, &partner, error));
    }
    return fw_scenario_fail_again(scenario, given->place,
                                  fw_automaton_speeds_check(material->speeds, error), error);
}

/* --- bodies --- */

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

/* The smallest eigenvalue of a bond's matrix: below 0 a body with broken bonds can be unstable. */
static fw_status find_least(fw_automaton_speeds speeds, double angle, double *least,
                            fw_error *error)
{
    fw_automaton_matrices matrices;
    FW_TRY(fw_automaton_matrices_make(&matrices, speeds, angle, error));
    *least = fw_automaton_matrices_least(&matrices);
    return FW_OK;
}

/* Bonds may break up to some c2 only, which Poisson's ratio follows from. */
static fw_status check_fracture(const fw_scenario *scenario, const fw_scenario_body *body,
                                fw_error *error)
{
    enum { HALVINGS = 60 };
    static const double positive = 1e-9;
    const fw_scenario_material *material = &scenario->materials[body->material];
    const fw_automaton_speeds speeds = material->automaton.speeds;
    double least, low = 0, high = speeds.coupling;
    int count;
    FW_TRY(find_least(speeds, body->lattice.angle, &least, error));
    if (least > positive) return FW_OK;
    for (int n = 0; n < HALVINGS; ++n) {
        const double middle = (low + high) / 2;
        FW_TRY(find_least((fw_automaton_speeds){speeds.transverse, middle}, body->lattice.angle,
                          &least, error));
        *(least > positive ? &low : &high) = middle;
    }
    const fw_node *node =
        fw_node_find(fw_node_find(fw_scenario_part(scenario, "materials", &count), material->name),
                     "elastic-automaton");
    const fw_node *ratio = fw_node_find(node, "poisson-ratio"), *c2 = fw_node_find(node, "c2");
    const double mu = speeds.transverse * speeds.transverse,
                 nu = (low * low - mu) / (low * low + mu);
    if (ratio)
        return fw_scenario_fail(scenario, ratio->place, error,
                                "poisson-ratio is %s, expected -1 to %.4g where bonds break, so "
                                "that what is left of a body is stable",
                                ratio->text, floor(nu * 1e4) / 1e4);
    return fw_scenario_fail(scenario, c2 ? c2->place : material->place, error,
                            "c2 is %g, expected 0 to %.4g where bonds break and c1 is %g, so that "
                            "what is left of a body is stable",
                            speeds.coupling, floor(low * 1e4) / 1e4, speeds.transverse);
}

static fw_status check_automaton(const fw_scenario *scenario, const fw_scenario_body *body,
                                 fw_error *error)
{
    const fw_scenario_automaton *material = &scenario->materials[body->material].automaton;
    if (material->boundary == FW_EDGES_BOND && material->break_at > 0)
        FW_TRY(check_fracture(scenario, body, error));
    return material->boundary == FW_EDGES_PERIODIC ? check_period(scenario, body, error) : FW_OK;
}

/* Half-steps are a clock of their own: the scene's ticks would be whole steps for one body and half
 * of them for another. */
static fw_status check_clock(const fw_scenario *scenario, fw_error *error)
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

const fw_material_model fw_automaton_material = {
    .bodies = "elastic automata",
    .lattices = 1 << FW_SQUARE,
    .why = "the cells of an elastic automaton are black and white in turn",
    .body_keys = " displaced-as-given ",
    .has_modes = true,
    .citation = "dong2012",
    .break_at = offsetof(fw_scenario_material, automaton.break_at),
    .read = read_automaton,
    .check_body = check_automaton,
    .check_bodies = check_clock};
