/* SPDX-License-Identifier: GPL-3.0-or-later */
/* phase.c - grips, and the phases that drive them and pistons. State: the phase that the scene has
 * the parameters of, kept by the caller. Start reading at fw_phase_enter(). */
#include "experiments/setup/phase.h"

#include "core/particles/langevin.h"
#include "experiments/setup/solids.h"

#include <math.h>
#include <stdlib.h>

/* --- grips --- */

/* How far out a place lies on that side. */
static double outward(const fw_solid *solid, int particle, fw_outer_side side)
{
    switch (side) {
    case FW_SIDE_LEFT:
        return -solid->x[particle];
    case FW_SIDE_RIGHT:
        return solid->x[particle];
    case FW_SIDE_BOTTOM:
        return -solid->y[particle];
    default:
        return solid->y[particle];
    }
}

/* Leaves of the selected particles those within the layer. */
static void keep_layer(const fw_scenario_grip *grip, const fw_solid *solid, int *particles,
                       int *count)
{
    double face = -INFINITY;
    int kept = 0;
    for (int n = 0; n < *count; ++n) face = fmax(face, outward(solid, particles[n], grip->side));
    for (int n = 0; n < *count; ++n)
        if (outward(solid, particles[n], grip->side) > face - grip->layer)
            particles[kept++] = particles[n];
    *count = kept;
}

/* The first of the particles that an earlier grip holds as well: that grip, or -1. */
static int find_shared(const fw_scenario *scenario, const fw_scene *scene,
                       const fw_scenario_grip *grip, const int *particles, int count, int *shared)
{
    for (int g = 0; g < fw_scene_grip_count(scene); ++g) {
        const fw_grip *earlier = fw_scene_observe_grip(scene, g);
        const int *held = fw_grip_particles(earlier);
        if (scenario->grips[g].body != grip->body) continue;
        for (int n = 0, k = 0; n < count && k < fw_grip_particle_count(earlier);) {
            *shared = particles[n];
            if (particles[n] == held[k]) return g;
            if (particles[n] < held[k])
                ++n;
            else
                ++k;
        }
    }
    return -1;
}

static fw_status add_grip(const fw_scenario *scenario, fw_scene *scene, const fw_body_range *range,
                          const fw_scenario_grip *grip, fw_error *error)
{
    int *particles, count;
    FW_TRY(fw_selection_particles(&grip->sites, &range->sites, &particles, &count, error));
    for (int n = 0; n < count; ++n) particles[n] += range->first;
    if (grip->layer > 0) keep_layer(grip, fw_body_range_solid(scene, range), particles, &count);
    int shared = 0;
    const int earlier = find_shared(scenario, scene, grip, particles, count, &shared);
    if (earlier >= 0) {
        const fw_site site = range->sites.site[shared - range->first];
        free(particles);
        return fw_scenario_fail(scenario, grip->place, error,
                                "grip '%s' holds site [%d, %d] of body '%s', which grip '%s' holds "
                                "already",
                                grip->name, site.i, site.j, range->name,
                                scenario->grips[earlier].name);
    }
    const fw_grip_def def = {.name = grip->name,
                             .particles = particles,
                             .particle_count = count,
                             .drive = grip->motion.drive};
    fw_status status = fw_scene_add_grip(scene, range->solid, &def, error);
    free(particles);
    return fw_scenario_fail_again(scenario, grip->place, status, error);
}

fw_status fw_grips_add(const fw_scenario *scenario, fw_scene *scene, const fw_body_range *ranges,
                       fw_error *error)
{
    for (int n = 0; n < scenario->grip_count; ++n)
        FW_TRY(add_grip(scenario, scene, &ranges[scenario->grips[n].body], &scenario->grips[n],
                        error));
    return FW_OK;
}

/* --- phases --- */

static fw_langevin_controls controls_in(const fw_scenario *scenario, const fw_scenario_phase *phase)
{
    const fw_scenario_dynamics *dynamics = &scenario->dynamics;
    return (fw_langevin_controls){
        .time_step = dynamics->time_step,
        .damping = phase->damping >= 0 ? phase->damping : dynamics->damping,
        .temperature = phase->temperature >= 0 ? phase->temperature : dynamics->temperature};
}

fw_status fw_phases_check(const fw_scenario *scenario, const fw_scene *scene, fw_error *error)
{
    for (int p = 0; p < scenario->phase_count; ++p) {
        const fw_scenario_phase *phase = &scenario->phases[p];
        const fw_langevin_controls controls = controls_in(scenario, phase);
        for (int b = 0; b < fw_scene_body_count(scene); ++b) {
            const fw_solid *solid = fw_scene_observe_body(scene, b);
            if (!fw_solid_is_langevin(solid)) continue;
            FW_TRY(fw_scenario_fail_within(scenario, phase->place,
                                           fw_langevin_check_heat(solid, &controls, error), error,
                                           "phase %s", phase->name));
        }
    }
    return FW_OK;
}

static fw_status set_bath(const fw_scenario *scenario, fw_scene *scene, const fw_body_range *ranges,
                          const fw_scenario_phase *phase, fw_error *error)
{
    const fw_langevin_controls controls = controls_in(scenario, phase);
    for (int b = 0; b < scenario->body_count; ++b) {
        const fw_solid_kind *kind = fw_solid_kind_of(scenario, b);
        if (kind->set_bath)
            FW_TRY(kind->set_bath(fw_scene_body(scene, ranges[b].solid), controls.damping,
                                  controls.temperature, error));
    }
    return FW_OK;
}

double fw_phase_time(const fw_scenario *scenario, const fw_scene *scene, int phase)
{
    if (fw_scene_body_count(scene) == 0) return 0;
    const fw_solid *solid = fw_scene_observe_body(scene, 0);
    /* As the scene counts its time: their difference is 0 at the first step, not a rounding. */
    return (double)(scenario->phases[phase].from * solid->model->ticks_per_step) * solid->tick;
}

/* With its time 0, now that steps have a duration. */
static fw_drive complete(const fw_scenario *scenario, const fw_scene *scene,
                         const fw_scenario_drive *motion)
{
    fw_drive drive = motion->drive;
    if (motion->origin >= 0) drive.origin = fw_phase_time(scenario, scene, motion->origin);
    return drive;
}

fw_drive fw_phase_grip(const fw_scenario *scenario, const fw_scene *scene, int phase, int grip)
{
    const fw_scenario_phase *in = &scenario->phases[phase];
    const fw_scenario_drive *motion = &scenario->grips[grip].motion;
    for (int n = 0; n < in->drive_count; ++n)
        if (in->drives[n].grip == grip) motion = &in->drives[n].motion;
    return complete(scenario, scene, motion);
}

/* What the phase says of the piston, or NULL. */
static const fw_phase_piston *find_piston(const fw_scenario *scenario, int phase, int wall)
{
    const fw_scenario_phase *in = &scenario->phases[phase];
    for (int n = 0; n < in->piston_count; ++n)
        if (in->pistons[n].wall == wall) return &in->pistons[n];
    return NULL;
}

fw_drive fw_phase_piston_drive(const fw_scenario *scenario, const fw_scene *scene, int phase,
                               int wall)
{
    const fw_phase_piston *other = find_piston(scenario, phase, wall);
    return complete(scenario, scene, other ? &other->motion : &scenario->walls[wall].piston.motion);
}

static fw_status set_pistons(const fw_scenario *scenario, fw_scene *scene, int phase,
                             fw_error *error)
{
    for (int w = 0; w < scenario->wall_count; ++w) {
        if (!scenario->walls[w].is_piston) continue;
        const fw_phase_piston *other = find_piston(scenario, phase, w);
        const fw_drive drive = fw_phase_piston_drive(scenario, scene, phase, w);
        const double damping =
            other && other->damping >= 0 ? other->damping : scenario->walls[w].piston.damping;
        const fw_place place = other ? other->place : scenario->walls[w].place;
        const fw_status status =
            fw_piston_set_drive(fw_scene_piston(scene, w), &drive, damping, error);
        FW_TRY(fw_scenario_fail_again(scenario, place, status, error));
    }
    return FW_OK;
}

fw_status fw_phase_enter(const fw_scenario *scenario, fw_scene *scene, const fw_body_range *ranges,
                         int *current, fw_error *error)
{
    const int64_t step = fw_scene_steps(scene);
    if (scenario->phase_count == 0) return FW_OK;
    int now = 0;
    while (now < scenario->phase_count - 1 && step >= scenario->phases[now].until) now += 1;
    if (now == *current) return FW_OK;
    FW_TRY(set_bath(scenario, scene, ranges, &scenario->phases[now], error));
    for (int n = 0; n < scenario->grip_count; ++n) {
        const fw_drive drive = fw_phase_grip(scenario, scene, now, n);
        FW_TRY(fw_grip_set_drive(fw_scene_grip(scene, n), &drive, error));
    }
    FW_TRY(set_pistons(scenario, scene, now, error));
    *current = now;
    return FW_OK;
}
