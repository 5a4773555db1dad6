/* SPDX-License-Identifier: GPL-3.0-or-later */
/* phase.c - grips, and the phases that drive them and pistons. State: the phase that the scene has
 * the parameters of, kept in the experiment. Start reading at fw_phase_enter(). */
#include "phase.h"

#include "core/particles/linear_lattice.h"
#include "core/particles/particles.h"

#include <math.h>
#include <stdlib.h>

/* --- grips --- */

/* How far out a place lies on that side. */
static double outward(const fw_solid *solid, int particle, int side)
{
    switch (side) {
    case 0:
        return -solid->x[particle];
    case 1:
        return solid->x[particle];
    case 2:
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
static int find_shared(const fw_experiment *experiment, const fw_scenario_grip *grip,
                       const int *particles, int count, int *shared)
{
    const fw_scenario *scenario = experiment->scenario;
    for (int g = 0; g < fw_scene_grip_count(experiment->scene); ++g) {
        const fw_grip *earlier = fw_scene_observe_grip(experiment->scene, g);
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

static fw_status add_grip(fw_experiment *experiment, const fw_scenario_grip *grip, fw_error *error)
{
    const fw_body_range *range = &experiment->bodies[grip->body];
    int *particles, count;
    FW_TRY(fw_selection_particles(&grip->sites, &range->sites, &particles, &count, error));
    for (int n = 0; n < count; ++n) particles[n] += range->first;
    if (grip->layer > 0)
        keep_layer(grip, fw_experiment_solid(experiment, grip->body), particles, &count);
    int shared = 0;
    const int earlier = find_shared(experiment, grip, particles, count, &shared);
    if (earlier >= 0) {
        const fw_site site = range->sites.site[shared - range->first];
        free(particles);
        return fw_scenario_fail(experiment->scenario, grip->place, error,
                                "grip '%s' holds site [%d, %d] of body '%s', which grip '%s' holds "
                                "already",
                                grip->name, site.i, site.j, range->name,
                                experiment->scenario->grips[earlier].name);
    }
    const fw_grip_def def = {.name = grip->name,
                             .particles = particles,
                             .particle_count = count,
                             .drive = grip->motion.drive};
    fw_status status = fw_scene_add_grip(experiment->scene, range->solid, &def, error);
    free(particles);
    if (status != FW_BAD_INPUT) return status;
    const fw_error inner = *error;
    return fw_scenario_fail(experiment->scenario, grip->place, error, "%s", inner.sentence);
}

fw_status fw_grips_add(fw_experiment *experiment, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    for (int n = 0; n < scenario->grip_count; ++n)
        FW_TRY(add_grip(experiment, &scenario->grips[n], error));
    return FW_OK;
}

/* --- phases --- */

static fw_status set_bath(fw_experiment *experiment, const fw_scenario_phase *phase,
                          fw_error *error)
{
    const fw_scenario_dynamics *dynamics = &experiment->scenario->dynamics;
    const double damping = phase->damping >= 0 ? phase->damping : dynamics->damping;
    const double temperature = phase->temperature >= 0 ? phase->temperature : dynamics->temperature;
    for (int b = 0; b < fw_scene_body_count(experiment->scene); ++b) {
        fw_solid *solid = fw_scene_body(experiment->scene, b);
        if (fw_solid_is_particles(solid)) {
            FW_TRY(fw_particles_set_damping(solid, damping, error));
            FW_TRY(fw_particles_set_temperature(solid, temperature, error));
        } else if (fw_solid_is_linear_lattice(solid)) {
            fw_langevin_controls controls = ((fw_langevin *)solid)->controls;
            controls.damping = damping;
            controls.temperature = temperature;
            fw_langevin_set_controls((fw_langevin *)solid, &controls);
        }
    }
    return FW_OK;
}

/* The drive of a grip in a phase: the phase's, or its own. */
static const fw_drive *drive_in(const fw_scenario *scenario, const fw_scenario_phase *phase,
                                int grip)
{
    for (int n = 0; n < phase->drive_count; ++n)
        if (phase->drives[n].grip == grip) return &phase->drives[n].motion.drive;
    return &scenario->grips[grip].motion.drive;
}

static fw_status set_pistons(fw_experiment *experiment, const fw_scenario_phase *phase,
                             fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    for (int w = 0; w < scenario->wall_count; ++w) {
        const fw_scenario_piston *own = &scenario->walls[w].piston;
        const fw_drive *drive = &own->motion.drive;
        double damping = own->damping;
        fw_place place = scenario->walls[w].place;
        if (!scenario->walls[w].is_piston) continue;
        for (int n = 0; n < phase->piston_count; ++n) {
            const fw_phase_piston *other = &phase->pistons[n];
            if (other->wall != w) continue;
            drive = &other->motion.drive;
            if (other->damping >= 0) damping = other->damping;
            place = other->place;
        }
        fw_error inner;
        const fw_status status =
            fw_piston_set_drive(fw_scene_piston(experiment->scene, w), drive, damping, &inner);
        if (status != FW_OK) return fw_scenario_fail(scenario, place, error, "%s", inner.sentence);
    }
    return FW_OK;
}

fw_status fw_phase_enter(fw_experiment *experiment, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    const int64_t step = fw_scene_steps(experiment->scene);
    if (scenario->phase_count == 0) return FW_OK;
    int now = 0;
    while (now < scenario->phase_count - 1 && step >= scenario->phases[now].until) now += 1;
    if (now == experiment->phase) return FW_OK;
    const fw_scenario_phase *phase = &scenario->phases[now];
    FW_TRY(set_bath(experiment, phase, error));
    for (int n = 0; n < scenario->grip_count; ++n)
        FW_TRY(fw_grip_set_drive(fw_scene_grip(experiment->scene, n), drive_in(scenario, phase, n),
                                 error));
    FW_TRY(set_pistons(experiment, phase, error));
    experiment->phase = now;
    return FW_OK;
}
