/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_linear.c - linear lattices of a scenario. Keeps no state. */
#include "scenario_parts.h"

static const fw_key linear_lattice_keys[] = {
    {"k1", AT_NUMBER(fw_scenario_linear, k1), .default_value = "10", .unit = "force/length",
     .meaning = "of a bond against any displacement"},
    {"k2", AT_NUMBER(fw_scenario_linear, k2), .default_value = "50", .unit = "force/length",
     .meaning = "of a bond against displacement along it, beyond k1"},
    {"compensated", AT_FLAG(fw_scenario_linear, compensated), .default_value = "true",
     .meaning = "surface forces make up for what k1 does to a body that turns; without them a "
                "specimen with free sides shows another Poisson ratio"},
    {"mass", AT_NUMBER(fw_scenario_linear, mass), ABOVE_ZERO, .default_value = "1", .unit = "mass",
     .meaning = "of each particle"},
    {.name = NULL}};

const fw_section fw_linear_section = {
    "`materials.NAME.linear-lattice`", "a linear lattice",
    "Popov and Filippov's Eqs 1-12: particles on a hexagonal lattice, tied for ever to their "
    "neighbours, F = k1 u + k2 e (e . u) for a bond of direction e whose ends are displaced by u "
    "against each other.",
    .keys = linear_lattice_keys};

const fw_material_model fw_linear_material = {.bodies = "linear lattices",
                                              .lattices = 1 << FW_HEXAGONAL,
                                              .why = "the linear lattice has six bonds per site",
                                              .body_keys = " spin temperature ",
                                              .has_dynamics = true,
                                              .citation = "popov2007"};
