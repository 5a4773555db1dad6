/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solids.c - one row for each material. Constant. */
#include "experiments/setup/solids.h"

#include "core/boltzmann/lb_solid.h"
#include "core/particles/langevin.h"
#include "experiments/setup/build.h"

static const fw_solid_kind solids[] = {
    [FW_LATTICE_BOLTZMANN] = {.bytes_per_particle = 375,
                              .fastest = FW_LB_FASTEST,
                              .build = fw_build_boltzmann,
                              .print_limits = fw_boltzmann_print_limits},
    [FW_MOVABLE_PARTICLES] = {.bytes_per_particle = 470,
                              .build_together = fw_build_particles,
                              .set_bath = fw_langevin_set_bath,
                              .print_limits = fw_particles_print_limits},
    [FW_LINEAR_LATTICE] = {.bytes_per_particle = 486,
                           .build = fw_build_linear,
                           .set_bath = fw_langevin_set_bath,
                           .print_limits = fw_linear_print_limits},
    [FW_ELASTIC_AUTOMATON] = {.bytes_per_particle = 244,
                              .build = fw_build_automaton,
                              .print_limits = fw_automaton_print_limits}};

_Static_assert(sizeof solids / sizeof solids[0] == FW_MATERIAL_KINDS,
               "a row for each fw_material_kind");

const fw_solid_kind *fw_solid_kind_of(const fw_scenario *scenario, int body)
{
    return &solids[scenario->materials[scenario->bodies[body].material].kind];
}
