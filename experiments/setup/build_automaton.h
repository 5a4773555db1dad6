/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_automaton.h - elastic automata as a scenario describes them. Shared by the builder, the
 * quantities and the analyses. */
#ifndef FW_BUILD_AUTOMATON_H
#define FW_BUILD_AUTOMATON_H

#include "core/automaton/automaton_dispersion.h"
#include "core/automaton/elastic_automaton.h"
#include "experiments/scenario/scenario.h"

/* A body as it starts. */
fw_status fw_build_automaton(const fw_scenario *scenario, int body, const fw_sites *sites,
                             fw_solid **solid, fw_error *error);

/* A mode of the endless lattice with |white| = 1, in the phase and, where both branches are one, in
 * the polarisation that the reference promises. */
fw_status fw_build_automaton_mode(const fw_scenario_automaton *material, const fw_lattice *lattice,
                                  fw_vec2 wave, int branch, fw_automaton_mode *mode,
                                  fw_error *error);

#endif
