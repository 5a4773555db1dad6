/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_linear.c - linear lattices from bodies of a scenario. Keeps no state. */
#include "build_langevin.h"
#include "core/particles/linear_lattice.h"
#include "experiments/setup/build.h"

#include <stdlib.h>

static fw_status create(const fw_scenario *scenario, int number, const fw_sites *sites,
                        fw_vec2 *room, fw_solid **solid, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    const fw_scenario_linear *material = &scenario->materials[body->material].linear;
    FW_TRY(fw_build_patterns(&body->displacement, sites, &body->lattice,
                             (uint64_t)scenario->run.seed, fw_build_displacement_stream(number),
                             room, error));
    fw_linear_lattice_def def = fw_linear_lattice_def_default();
    def.lattice = body->lattice;
    def.sites = sites;
    def.displacements = room;
    def.mass = material->mass;
    def.k1 = material->k1;
    def.k2 = material->k2;
    def.compensated = material->compensated;
    def.controls = fw_build_controls(scenario);
    def.seed = fw_build_seed(scenario, number);
    FW_TRY(fw_build_fail_step(scenario, number,
                              fw_linear_lattice_time_step_limit(def.k1, def.k2, def.mass),
                              fw_linear_lattice_create(solid, &def, error), error));
    return fw_build_motion(scenario, number, sites, *solid, 0, room, error);
}

static fw_status build(const fw_scenario *scenario, int number, const fw_sites *sites,
                       fw_solid **solid, fw_error *error)
{
    *solid = NULL;
    fw_vec2 *room = fw_array_zeroed(2 * (size_t)sites->count, sizeof *room);
    if (!room) return fw_fail_memory(error, "the starting state of a linear lattice");
    fw_status status = create(scenario, number, sites, room, solid, error);
    free(room);
    if (status != FW_OK) {
        fw_solid_destroy(*solid);
        *solid = NULL;
    }
    return status;
}

static fw_status print_limits(FILE *out, const fw_start *start, int *warnings, fw_error *error)
{
    const fw_scenario *scenario = start->scenario;
    const fw_scenario_linear *material =
        &scenario->materials[scenario->bodies[start->body].material].linear;
    (void)warnings;
    (void)error;
    fw_build_print_time_step(
        out, start, fw_linear_lattice_time_step_limit(material->k1, material->k2, material->mass));
    return FW_OK;
}

const fw_solid_kind fw_linear_solid = {.model = &fw_linear_lattice_model,
                                       .bytes_per_particle = 335,
                                       .build = build,
                                       .set_bath = fw_langevin_set_bath,
                                       .print_limits = print_limits};
