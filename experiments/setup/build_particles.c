/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_particles.c - movable particles from bodies of a scenario. Keeps no state. Start reading
 * at build(). */
#include "build_langevin.h"
#include "experiments/setup/build.h"

#include "core/particles/particles.h"
#include "core/placement.h"

#include <stdlib.h>

static fw_status place(const fw_scenario *scenario, int number, const fw_sites *sites,
                       fw_vec2 *positions, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    if (body->shape.kind == FW_SHAPE_PLACED) {
        const fw_vec2 origin = body->lattice.origin;
        return fw_placement_random(positions, sites->count, fw_vec2_add(origin, body->shape.low),
                                   fw_vec2_add(origin, body->shape.high), body->shape.apart,
                                   fw_build_seed(scenario, number), error);
    }
    if (body->shape.kind == FW_SHAPE_POINTS)
        for (int l = 0; l < sites->count; ++l)
            positions[l] = fw_vec2_add(body->lattice.origin, body->shape.points[l]);
    else
        fw_lattice_place(&body->lattice, sites->site, sites->count, positions);
    return FW_OK;
}

/* What is needed while the solid is made. */
typedef struct fw_gathering {
    const fw_scenario *scenario;
    const fw_body_range *ranges;
    fw_particle_group_def *groups;
    int *body; /* of the scenario, per group */
    int group_count;
    size_t particle_count, largest;
    fw_vec2 *positions; /* of all groups */
    fw_vec2 *room;      /* twice the largest group */
} fw_gathering;

static bool is_movable(const fw_scenario *scenario, int body)
{
    return scenario->materials[scenario->bodies[body].material].kind == FW_MOVABLE_PARTICLES;
}

static bool allocate(fw_gathering *gathering)
{
    const fw_scenario *scenario = gathering->scenario;
    for (int b = 0; b < scenario->body_count; ++b) {
        if (!is_movable(scenario, b)) continue;
        const size_t count = (size_t)gathering->ranges[b].sites.count;
        gathering->particle_count += count;
        if (count > gathering->largest) gathering->largest = count;
    }
    gathering->groups = calloc((size_t)scenario->body_count + 1, sizeof *gathering->groups);
    gathering->body = calloc((size_t)scenario->body_count + 1, sizeof *gathering->body);
    gathering->positions = fw_array_zeroed(gathering->particle_count, sizeof(fw_vec2));
    gathering->room = fw_array_zeroed(2 * gathering->largest, sizeof(fw_vec2));
    return gathering->groups && gathering->body && gathering->positions && gathering->room;
}

static fw_status gather(fw_gathering *gathering, fw_error *error)
{
    const fw_scenario *scenario = gathering->scenario;
    fw_vec2 *positions = gathering->positions;
    for (int b = 0; b < scenario->body_count; ++b) {
        if (!is_movable(scenario, b)) continue;
        const fw_scenario_body *body = &scenario->bodies[b];
        const fw_scenario_particles *material = &scenario->materials[body->material].particles;
        const fw_sites *sites = &gathering->ranges[b].sites;
        FW_TRY(fw_build_fail(scenario, b, place(scenario, b, sites, positions, error), error));
        FW_TRY(fw_build_patterns(&body->displacement, sites, &body->lattice,
                                 (uint64_t)scenario->run.seed, fw_build_displacement_stream(b),
                                 positions, error));
        fw_particle_group_def *group = &gathering->groups[gathering->group_count];
        *group = (fw_particle_group_def){.name = body->name,
                                         .count = sites->count,
                                         .positions = positions,
                                         .mass = material->mass,
                                         .strength = material->strength,
                                         .return_force = material->return_force};
        if (!material->own_angle) group->return_force.angle = body->lattice.angle;
        gathering->body[gathering->group_count++] = b;
        positions += sites->count;
    }
    return FW_OK;
}

/* The body that a refused solid's sentence is about; the first one where it is about all. */
static int body_at_fault(const fw_gathering *gathering, const fw_particles_def *def)
{
    for (int g = 0; g < def->group_count; ++g) {
        fw_particles_def alone = *def;
        alone.groups = &def->groups[g];
        alone.group_count = 1;
        if (!(def->controls.time_step < fw_particles_time_step_limit(&alone)))
            return gathering->body[g];
    }
    return gathering->body[0];
}

static fw_status create(fw_gathering *gathering, fw_solid **solid, fw_error *error)
{
    const fw_scenario *scenario = gathering->scenario;
    fw_particles_def def = fw_particles_def_default();
    def.groups = gathering->groups;
    def.group_count = gathering->group_count;
    def.potential =
        scenario->materials[scenario->bodies[gathering->body[0]].material].particles.potential;
    def.strength_across = scenario->dynamics.strength_across;
    def.controls = fw_build_controls(scenario);
    def.seed = (uint64_t)scenario->run.seed;
    def.overlap_energy = scenario->dynamics.overlap_energy;
    def.bond_radius = scenario->dynamics.bond_radius;
    FW_TRY(fw_build_fail_step(scenario, body_at_fault(gathering, &def),
                              fw_particles_time_step_limit(&def),
                              fw_particles_create(solid, &def, error), error));
    for (int g = 0; g < def.group_count; ++g) {
        const int b = gathering->body[g];
        FW_TRY(fw_build_motion(scenario, b, &gathering->ranges[b].sites, *solid,
                               fw_particles_group(*solid, g)->first, gathering->room, error));
    }
    return FW_OK;
}

static fw_status build(const fw_scenario *scenario, const fw_body_range *ranges, fw_solid **solid,
                       fw_error *error)
{
    *solid = NULL;
    fw_gathering gathering = {.scenario = scenario, .ranges = ranges};
    fw_status status = FW_OK;
    if (!allocate(&gathering))
        status = fw_fail_memory(error, "the starting state of movable particles");
    if (status == FW_OK) status = gather(&gathering, error);
    if (status == FW_OK) status = create(&gathering, solid, error);
    if (status != FW_OK) {
        fw_solid_destroy(*solid);
        *solid = NULL;
    }
    free(gathering.groups);
    free(gathering.body);
    free(gathering.positions);
    free(gathering.room);
    return status;
}

/* Bodies of movable particles share one solid, and so one time step. */
static fw_status print_limits(FILE *out, const fw_start *start, int *warnings, fw_error *error)
{
    const fw_scenario *scenario = start->scenario;
    const fw_scenario_particles *material =
        &scenario->materials[scenario->bodies[start->body].material].particles;
    const fw_particle_group_def group = {
        .mass = material->mass,
        .strength = fmax(material->strength, scenario->dynamics.strength_across),
        .return_force = material->return_force};
    const fw_particles_def def = {
        .groups = &group, .group_count = 1, .potential = material->potential};
    (void)warnings;
    (void)error;
    fw_build_print_time_step(
        out, start,
        fmin(fw_particles_time_step_limit(&def), fw_particles_start_limit(start->solid, NULL)));
    if (scenario->dynamics.damping > 0)
        fprintf(out, "  %-14s bath of temperature %g, expected up to %.3g with this time step\n",
                "", scenario->dynamics.temperature, fw_particles_hottest(start->solid));
    return FW_OK;
}

const fw_solid_kind fw_particles_solid = {.model = &fw_particles_model,
                                          .bytes_per_particle = 300,
                                          .build_together = build,
                                          .set_bath = fw_langevin_set_bath,
                                          .print_limits = print_limits};
