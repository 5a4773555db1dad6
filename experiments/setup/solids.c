/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solids.c - one row for each material. Constant. */
#include "experiments/setup/solids.h"

#include "core/automaton/elastic_automaton.h"
#include "core/boltzmann/lb_solid.h"
#include "core/particles/langevin.h"
#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"
#include "experiments/setup/build.h"

static const fw_solid_kind boltzmann = {.model = &fw_lb_solid_model,
                                        .bytes_per_particle = 375,
                                        .fastest = FW_LB_FASTEST,
                                        .build = fw_build_boltzmann,
                                        .print_limits = fw_boltzmann_print_limits};

static const fw_solid_kind particles = {.model = &fw_particles_model,
                                        .bytes_per_particle = 470,
                                        .build_together = fw_build_particles,
                                        .set_bath = fw_langevin_set_bath,
                                        .print_limits = fw_particles_print_limits};

static const fw_solid_kind linear = {.model = &fw_linear_lattice_model,
                                     .bytes_per_particle = 486,
                                     .build = fw_build_linear,
                                     .set_bath = fw_langevin_set_bath,
                                     .print_limits = fw_linear_print_limits};

static const fw_solid_kind automaton = {.model = &fw_elastic_automaton_model,
                                        .bytes_per_particle = 244,
                                        .build = fw_build_automaton,
                                        .print_limits = fw_automaton_print_limits};

#define SOLID(id, member, section, word, meaning) &member,
static const fw_solid_kind *const solids[] = {FW_MATERIAL_ROWS(SOLID)};

const fw_solid_kind *fw_solid_kind_at(fw_material_kind kind)
{
    return solids[kind];
}

const fw_solid_kind *fw_solid_kind_of(const fw_scenario *scenario, int body)
{
    return solids[scenario->materials[scenario->bodies[body].material].kind];
}
