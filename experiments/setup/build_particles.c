/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_particles.c - movable particles and linear lattices from bodies of a scenario. Keeps no
 * state. Start reading at fw_build_particles(). */
#include "experiments/setup/build.h"

#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"
#include "core/placement.h"

#include <stdlib.h>

/* Random places and velocities of each body are drawn from a seed of its own, far from those that
 * anybody gives. */
static uint64_t seed_of_body(const fw_scenario *scenario, int body)
{
    return (uint64_t)scenario->run.seed + ((uint64_t)(body + 1) << 44);
}

static fw_langevin_controls controls_of(const fw_scenario *scenario)
{
    return (fw_langevin_controls){.time_step = scenario->dynamics.time_step,
                                  .damping = scenario->dynamics.damping,
                                  .temperature = scenario->dynamics.temperature};
}

/* A time step beyond the limit is at fault itself, where it was written. */
static fw_status fail_solid(const fw_scenario *scenario, int body, double limit, fw_status status,
                            fw_error *error)
{
    const fw_place place = scenario->dynamics.time_step_place;
    const bool written = place.line > 0 || place.setting > 0;
    if (status != FW_BAD_INPUT || !written || scenario->dynamics.time_step < limit)
        return fw_build_fail(scenario, body, status, error);
    return fw_scenario_fail_within(scenario, place, status, error, "body %s",
                                   scenario->bodies[body].name);
}

/* --- where particles are, and how they move --- */

static fw_status place(const fw_scenario *scenario, int number, const fw_sites *sites,
                       fw_vec2 *positions, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    if (body->shape.kind == FW_SHAPE_PLACED) {
        const fw_vec2 origin = body->lattice.origin;
        return fw_placement_random(positions, sites->count, fw_vec2_add(origin, body->shape.low),
                                   fw_vec2_add(origin, body->shape.high), body->shape.apart,
                                   seed_of_body(scenario, number), error);
    }
    for (int l = 0; l < sites->count; ++l)
        positions[l] = fw_lattice_position(&body->lattice, sites->site[l]);
    return FW_OK;
}

/* Adds velocity, spin about the middle of the places (all particles of a body weigh the same) and
 * the patterns to what is there. */
static fw_status set_in_motion(const fw_scenario *scenario, int number, const fw_sites *sites,
                               const fw_vec2 *positions, fw_vec2 *velocities, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    fw_vec2 middle = {0, 0};
    for (int l = 0; l < sites->count; ++l) middle = fw_vec2_add(middle, positions[l]);
    middle = fw_vec2_scale(1. / sites->count, middle);
    for (int l = 0; l < sites->count; ++l) {
        const fw_vec2 from = fw_vec2_subtract(positions[l], middle);
        const fw_vec2 turning = fw_vec2_scale(body->spin, fw_vec2_turn(from));
        velocities[l] = fw_vec2_add(velocities[l], fw_vec2_add(body->velocity, turning));
    }
    return fw_build_patterns(&body->velocities, sites, &body->lattice, (uint64_t)scenario->run.seed,
                             fw_build_velocity_stream(number), velocities, error);
}

/* Thermal velocities come from the solid, which knows the masses; everything else is added. */
static fw_status add_motion(const fw_scenario *scenario, int number, const fw_sites *sites,
                            fw_solid *solid, int first, fw_vec2 *room, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    fw_vec2 *positions = room, *velocities = room + sites->count;
    if (body->temperature > 0) {
        const fw_langevin_controls hot = {scenario->dynamics.time_step, 1, body->temperature};
        FW_TRY(fw_build_fail(scenario, number, fw_langevin_check_heat(solid, &hot, error), error));
        fw_langevin_draw_velocities(solid, first, sites->count, body->temperature);
    }
    for (int l = 0; l < sites->count; ++l) {
        const int i = first + l;
        positions[l] = fw_solid_position(solid, i);
        velocities[l] = fw_langevin_velocity(solid, i);
    }
    FW_TRY(set_in_motion(scenario, number, sites, positions, velocities, error));
    for (int l = 0; l < sites->count; ++l)
        fw_langevin_set_velocity(solid, first + l, velocities[l]);
    return FW_OK;
}

/* --- movable particles --- */

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
    gathering->positions = calloc(gathering->particle_count, sizeof(fw_vec2));
    gathering->room = calloc(2 * gathering->largest, sizeof(fw_vec2));
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
    def.controls = controls_of(scenario);
    def.seed = (uint64_t)scenario->run.seed;
    def.overlap_energy = scenario->dynamics.overlap_energy;
    def.bond_radius = scenario->dynamics.bond_radius;
    FW_TRY(fail_solid(scenario, body_at_fault(gathering, &def), fw_particles_time_step_limit(&def),
                      fw_particles_create(solid, &def, error), error));
    for (int g = 0; g < def.group_count; ++g) {
        const int b = gathering->body[g];
        FW_TRY(add_motion(scenario, b, &gathering->ranges[b].sites, *solid,
                          fw_particles_group(*solid, g)->first, gathering->room, error));
    }
    return FW_OK;
}

fw_status fw_build_particles(const fw_scenario *scenario, const fw_body_range *ranges,
                             fw_solid **solid, fw_error *error)
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

/* --- linear lattices --- */

static fw_status create_linear(const fw_scenario *scenario, int number, const fw_sites *sites,
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
    def.controls = controls_of(scenario);
    def.seed = seed_of_body(scenario, number);
    FW_TRY(fail_solid(scenario, number, fw_linear_lattice_time_step_limit(def.k1, def.k2, def.mass),
                      fw_linear_lattice_create(solid, &def, error), error));
    return add_motion(scenario, number, sites, *solid, 0, room, error);
}

fw_status fw_build_linear(const fw_scenario *scenario, int number, const fw_sites *sites,
                          fw_solid **solid, fw_error *error)
{
    *solid = NULL;
    fw_vec2 *room = calloc(2 * (size_t)sites->count, sizeof *room);
    if (!room) return fw_fail_memory(error, "the starting state of a linear lattice");
    fw_status status = create_linear(scenario, number, sites, room, solid, error);
    free(room);
    if (status != FW_OK) {
        fw_solid_destroy(*solid);
        *solid = NULL;
    }
    return status;
}

/* --- limits --- */

static void print_time_step(FILE *out, const fw_start *start, double limit)
{
    fprintf(out, "  %-14s stable: time step %g, expected below %.3g\n",
            start->scenario->bodies[start->body].name, start->scenario->dynamics.time_step, limit);
}

/* Bodies of movable particles share one solid, and so one time step. */
fw_status fw_particles_print_limits(FILE *out, const fw_start *start, int *warnings,
                                    fw_error *error)
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
    print_time_step(
        out, start,
        fmin(fw_particles_time_step_limit(&def), fw_particles_start_limit(start->solid, NULL)));
    if (scenario->dynamics.damping > 0)
        fprintf(out, "  %-14s bath of temperature %g, expected up to %.3g with this time step\n",
                "", scenario->dynamics.temperature, fw_particles_hottest(start->solid));
    return FW_OK;
}

fw_status fw_linear_print_limits(FILE *out, const fw_start *start, int *warnings, fw_error *error)
{
    const fw_scenario *scenario = start->scenario;
    const fw_scenario_linear *material =
        &scenario->materials[scenario->bodies[start->body].material].linear;
    (void)warnings;
    (void)error;
    print_time_step(out, start,
                    fw_linear_lattice_time_step_limit(material->k1, material->k2, material->mass));
    return FW_OK;
}
