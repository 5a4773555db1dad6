/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_langevin.c - what the builders of point masses share. Keeps no state. */
#include "build_langevin.h"

#include "experiments/setup/build.h"

/* Random places and velocities of each body are drawn from a seed of its own, far from those that
 * anybody gives. */
uint64_t fw_build_seed(const fw_scenario *scenario, int body)
{
    return (uint64_t)scenario->run.seed + ((uint64_t)(body + 1) << 44);
}

fw_langevin_controls fw_build_controls(const fw_scenario *scenario)
{
    return (fw_langevin_controls){.time_step = scenario->dynamics.time_step,
                                  .damping = scenario->dynamics.damping,
                                  .temperature = scenario->dynamics.temperature};
}

/* A time step beyond the limit is at fault itself, where it was written. */
fw_status fw_build_fail_step(const fw_scenario *scenario, int body, double limit, fw_status status,
                             fw_error *error)
{
    const fw_place place = scenario->dynamics.time_step_place;
    const bool written = place.line > 0 || place.setting > 0;
    if (status != FW_BAD_INPUT || !written || scenario->dynamics.time_step < limit)
        return fw_build_fail(scenario, body, status, error);
    return fw_scenario_fail_within(scenario, place, status, error, "body %s",
                                   scenario->bodies[body].name);
}

static void turn_about_middle(const fw_scenario_body *body, const fw_sites *sites,
                              const fw_vec2 *positions, fw_vec2 *velocities)
{
    fw_vec2 middle = {0, 0};
    for (int l = 0; l < sites->count; ++l) middle = fw_vec2_add(middle, positions[l]);
    middle = fw_vec2_scale(1. / sites->count, middle);
    for (int l = 0; l < sites->count; ++l) {
        const fw_vec2 from = fw_vec2_subtract(positions[l], middle);
        const fw_vec2 turning = fw_vec2_scale(body->spin, fw_vec2_turn(from));
        velocities[l] = fw_vec2_add(velocities[l], fw_vec2_add(body->velocity, turning));
    }
}

/* Thermal velocities come from the solid, which knows the masses; everything else is added. A spin
 * is about the middle of the places: all particles of a body weigh the same. */
fw_status fw_build_motion(const fw_scenario *scenario, int number, const fw_sites *sites,
                          fw_solid *solid, int first, fw_vec2 *room, fw_error *error)
{
    const fw_scenario_body *body = &scenario->bodies[number];
    if (body->temperature > 0) {
        const fw_langevin_controls hot = {scenario->dynamics.time_step, 1, body->temperature};
        FW_TRY(fw_build_fail(scenario, number, fw_langevin_check_heat(solid, &hot, error), error));
        fw_langevin_draw_velocities(solid, first, sites->count, body->temperature);
    }
    if (body->spin == 0) fw_langevin_add_velocity(solid, first, sites->count, body->velocity);
    if (body->spin == 0 && body->velocities.count == 0) return FW_OK;
    fw_vec2 *positions = room, *velocities = room + sites->count;
    for (int l = 0; l < sites->count; ++l) {
        positions[l] = fw_solid_position(solid, first + l);
        velocities[l] = fw_langevin_velocity(solid, first + l);
    }
    if (body->spin != 0) turn_about_middle(body, sites, positions, velocities);
    FW_TRY(fw_build_patterns(&body->velocities, sites, &body->lattice, (uint64_t)scenario->run.seed,
                             fw_build_velocity_stream(number), velocities, error));
    for (int l = 0; l < sites->count; ++l)
        fw_langevin_set_velocity(solid, first + l, velocities[l]);
    return FW_OK;
}

void fw_build_print_time_step(FILE *out, const fw_start *start, double limit)
{
    fprintf(out, "  %-14s stable: time step %g, expected below %.3g\n",
            start->scenario->bodies[start->body].name, start->scenario->dynamics.time_step, limit);
}
