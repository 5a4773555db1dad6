/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scenario_boltzmann.c - lattice Boltzmann materials of a scenario. Keeps no state. */
#include "scenario_parts.h"

static const fw_key lattice_boltzmann_keys[] = {
    {"rest-mass", AT_SYMMETRIC(fw_scenario_boltzmann, rest_mass), .default_value = "0",
     .unit = "mass^(1/2)",
     .meaning = "M0 of Chopard and Marconi: inertia beside that of the links. As a matrix it must "
                "be symmetric: another one would create energy"},
    {"damping", AT_NUMBER(fw_scenario_boltzmann, damping), FROM_TO_BELOW(0, 0.5),
     .hint = "0 is none, and what was mu is 1 - damping", .default_value = "0",
     .meaning = "each step takes twice this part of the momentum. 0 is none; the mu of the "
                "paper is 1 - damping"},
    {"link-stiffness", AT_SYMMETRIC(fw_scenario_boltzmann, link_stiffness), ABOVE_ZERO,
     .default_value = "1", .unit = "force/length",
     .meaning = "of every link; as a matrix it must be symmetric and positive definite"},
    {"break-at", AT_NUMBER(fw_scenario_boltzmann, break_at), ABOVE_ZERO,
     .default_meaning = "links never break", .unit = "length",
     .meaning = "a link whose ends are displaced from each other by more than this breaks"},
    {.name = NULL}};

const fw_section fw_boltzmann_section = {
    "`materials.NAME.lattice-boltzmann`", "a lattice Boltzmann material",
    "The solid of Chopard and Marconi (2002). One step takes one unit of time. A particle has the "
    "mass M = (M0^2 + k links)/2, k the link stiffness; each component of the displacement is a "
    "wave of its own (Poisson ratio 0), with speed (k/M)^(1/2).",
    .keys = lattice_boltzmann_keys};

const fw_material_model fw_boltzmann_material = {
    .bodies = "lattice Boltzmann bodies",
    .lattices = 1 << FW_SQUARE,
    .why = "the lattice Boltzmann solid has four links per site",
    .body_keys = " rest-mass link-stiffness ",
    .citation = "chopard2002",
    .break_at = offsetof(fw_scenario_material, boltzmann.break_at),
    .link_stiffness = offsetof(fw_scenario_material, boltzmann.link_stiffness)};
