/* SPDX-License-Identifier: GPL-3.0-or-later */
/* experiment.c - from plain data to solids, walls and loads. State: fw_experiment, made once and
 * then stepped. Start reading at fw_experiment_create(). */
#include "experiments/setup/experiment.h"

#include "contact/geometry/wall_offset.h"

#include "core/noise.h"
#include "core/particles/particles.h"
#include "experiments/setup/body_range.h"
#include "experiments/setup/build.h"
#include "experiments/setup/overlap.h"
#include "experiments/setup/phase.h"
#include "experiments/setup/solids.h"
#include "period.h"

#include <math.h>
#include <stdlib.h>

static fw_status adopt(fw_experiment *experiment, int number, const char *name, fw_solid *solid,
                       fw_error *error)
{
    fw_status status = fw_scene_adopt_body(experiment->scene, name, solid,
                                           &experiment->bodies[number].solid, error);
    return fw_build_fail(experiment->scenario, number, status, error);
}

/* The first of the bodies that share a solid brings all of them. */
static fw_status add_together(fw_experiment *experiment, int number, const fw_solid_kind *kind,
                              fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    int first = 0, bodies = 0;
    for (int b = 0; b < experiment->body_count; ++b) {
        if (fw_solid_kind_of(scenario, b) != kind) continue;
        if (b < number) return FW_OK;
        experiment->bodies[b].first = first;
        first += experiment->bodies[b].count;
        bodies += 1;
    }
    fw_solid *solid;
    FW_TRY(kind->build_together(scenario, experiment->bodies, &solid, error));
    const char *name =
        bodies > 1 ? fw_scenario_model(scenario, number)->bodies : experiment->bodies[number].name;
    FW_TRY(adopt(experiment, number, name, solid, error));
    for (int b = number + 1; b < experiment->body_count; ++b)
        if (fw_solid_kind_of(scenario, b) == kind)
            experiment->bodies[b].solid = experiment->bodies[number].solid;
    return FW_OK;
}

static fw_status add_body(fw_experiment *experiment, int number, fw_error *error)
{
    const fw_solid_kind *kind = fw_solid_kind_of(experiment->scenario, number);
    const fw_body_range *range = &experiment->bodies[number];
    fw_solid *solid = NULL;
    if (kind->build_together) return add_together(experiment, number, kind, error);
    FW_TRY(kind->build(experiment->scenario, number, &range->sites, &solid, error));
    return adopt(experiment, number, range->name, solid, error);
}

static fw_status make_sites(fw_experiment *experiment, int number, fw_error *error)
{
    const fw_scenario_body *body = &experiment->scenario->bodies[number];
    fw_body_range *range = &experiment->bodies[number];
    FW_TRY(fw_scenario_sites(body, &range->sites, error));
    range->name = body->name;
    range->count = range->sites.count;
    range->spacing = body->lattice.spacing;
    return FW_OK;
}

static fw_status add_force(fw_experiment *experiment, int number, fw_error *error)
{
    static const fw_load_kind kinds[] = {
        [FW_FORCE_EACH] = FW_LOAD_EACH,
        [FW_FORCE_TOTAL] = FW_LOAD_TOTAL,
        [FW_FORCE_ACCELERATION] = FW_LOAD_ACCELERATION,
        [FW_FORCE_RANDOM] = FW_LOAD_RANDOM,
    };
    const fw_scenario_force *force = &experiment->scenario->forces[number];
    const fw_body_range *range = &experiment->bodies[force->body];
    int *particles, count;
    FW_TRY(fw_selection_particles(&force->sites, &range->sites, &particles, &count, error));
    for (int n = 0; n < count; ++n) particles[n] += range->first;
    const fw_load_def def = {.kind = kinds[force->kind],
                             .particles = particles,
                             .particle_count = count,
                             .vector = force->vector,
                             .random = force->random,
                             .balanced = force->balanced,
                             .from = force->from,
                             .until = force->until,
                             .ramp = force->ramp,
                             .period = force->period,
                             .phase = force->phase,
                             .seed = (uint64_t)experiment->scenario->run.seed,
                             .stream = FW_NOISE_FORCE + (uint32_t)number};
    fw_status status = fw_scene_add_load(experiment->scene, range->solid, &def, error);
    free(particles);
    return status;
}

/* The scene speaks of solids; of bodies that share one it could not say which is meant. */
static fw_status refuse_walls(const fw_experiment *experiment, int number, fw_error *error)
{
    const fw_body_range *range = &experiment->bodies[number];
    if (range->count == fw_experiment_solid(experiment, number)->count) return FW_OK;
    for (int w = 0; w < fw_scene_wall_count(experiment->scene); ++w) {
        double depth;
        const int l = fw_overlap_find_behind(experiment->scene, range, w, &depth);
        if (l < 0) continue;
        const fw_vec2 at =
            fw_solid_position(fw_experiment_solid(experiment, number), range->first + l);
        return fw_scenario_fail(
            experiment->scenario, experiment->scenario->bodies[number].place, error,
            "body %s starts in wall %s: particle %d at (%g, %g) lies %g behind "
            "its surface, expected all particles on the free side",
            range->name, fw_wall_name(fw_scene_wall(experiment->scene, w)), l, at.x, at.y, depth);
    }
    return FW_OK;
}

static fw_status refuse_reversal(const fw_experiment *experiment, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    for (int b = 0; b < scenario->body_count && scenario->run.reverse_at > 0; ++b) {
        const fw_solid_model *model = fw_experiment_solid(experiment, b)->model;
        if (!model->reverse)
            return fw_scenario_fail(scenario, scenario->bodies[b].place, error,
                                    "body %s cannot be reversed: the model %s does not know how, "
                                    "expected no run.reverse-at",
                                    scenario->bodies[b].name, model->name);
    }
    return FW_OK;
}

/* What a run would end at as lost in its first step. */
static fw_status refuse_lost(const fw_experiment *experiment, fw_vec2 middle, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    for (int b = 0; b < scenario->body_count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        const int lost = fw_solid_find_lost(solid, middle, scenario->run.limit) - range->first;
        if (lost < 0 || lost >= range->count) continue;
        const fw_vec2 at = fw_solid_position(solid, range->first + lost);
        return fw_scenario_fail(scenario, scenario->bodies[b].place, error,
                                "body %s starts beyond run.limit: particle %d at (%g, %g), "
                                "expected all within %g of (%g, %g)",
                                range->name, lost, at.x, at.y, scenario->run.limit, middle.x,
                                middle.y);
    }
    return FW_OK;
}

static fw_status note_start(fw_experiment *experiment, fw_error *error)
{
    size_t count = (size_t)experiment->body_count;
    experiment->energy_at_start = calloc(count + 1, sizeof *experiment->energy_at_start);
    experiment->momentum_at_start = calloc(count + 1, sizeof *experiment->momentum_at_start);
    experiment->start = calloc(count + 1, sizeof *experiment->start);
    if (!experiment->energy_at_start || !experiment->momentum_at_start || !experiment->start)
        return fw_fail_memory(error, "the start of an experiment");
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        const fw_solid *solid = fw_experiment_solid(experiment, b);
        fw_energies energies = fw_body_range_energies(experiment->scene, &experiment->bodies[b]);
        experiment->energy_at_start[b] = energies.kinetic + energies.elastic;
        experiment->momentum_at_start[b] =
            fw_body_range_momentum(experiment->scene, &experiment->bodies[b]);
        experiment->start[b] = fw_array_zeroed((size_t)range->count, sizeof **experiment->start);
        if (!experiment->start[b]) return fw_fail_memory(error, "the positions at the start");
        for (int l = 0; l < range->count; ++l)
            experiment->start[b][l] = fw_solid_position(solid, range->first + l);
    }
    return FW_OK;
}

static fw_status add_wall(fw_scene *scene, const fw_scenario_wall *wall, double distance,
                          fw_error *error)
{
    fw_wall_def def = wall->def;
    fw_vec2 *points = NULL;
    const fw_piston_def piston = {.mass = wall->piston.mass,
                                  .velocity = wall->piston.velocity,
                                  .damping = wall->piston.damping,
                                  .drive = wall->piston.motion.drive};
    fw_status status = FW_OK;
    if (distance > 0) {
        points = calloc((size_t)def.point_count, sizeof *points);
        status = points ? fw_wall_offset(&wall->def, distance, points, &def, error)
                        : fw_fail_memory(error, "a wall");
    }
    if (status == FW_OK)
        status = wall->is_piston ? fw_scene_add_piston(scene, &def, &piston, error)
                                 : fw_scene_add_wall(scene, &def, error);
    free(points);
    return status;
}

static fw_status let_pistons_meet(const fw_scenario *scenario, fw_scene *scene, fw_error *error)
{
    for (int w = 0; w < scenario->wall_count; ++w)
        for (int n = 0; n < scenario->walls[w].piston.meets_count; ++n)
            FW_TRY(fw_scene_let_meet(scene, w, scenario->walls[w].piston.meets[n], error));
    return FW_OK;
}

/* Bodies that share a solid have one surface. */
static fw_status set_friction(const fw_experiment *experiment, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    const int solids = fw_scene_body_count(experiment->scene);
    int *surfaces = calloc((size_t)solids + 1, sizeof *surfaces);
    if (!surfaces) return fw_fail_memory(error, "the surfaces of bodies");
    fw_status status = FW_OK;
    for (int b = 0; b < scenario->body_count && status == FW_OK; ++b) {
        const fw_body_range *range = &experiment->bodies[b];
        const int own = scenario->bodies[b].surface;
        if (range->first > 0 && own != surfaces[range->solid])
            status = fw_scenario_fail(scenario, scenario->bodies[b].place, error,
                                      "body %s has another surface than the bodies of movable "
                                      "particles before it, expected the same",
                                      range->name);
        surfaces[range->solid] = own;
    }
    if (status == FW_OK)
        status = fw_scene_set_surfaces(experiment->scene, scenario->contact.surface_count,
                                       scenario->contact.pairs, surfaces, error);
    free(surfaces);
    return status;
}

static double largest_distance(const fw_scenario_contact *contact)
{
    double largest = contact->distance;
    for (int n = 0; n < contact->surface_count * contact->surface_count; ++n)
        largest = fmax(largest, contact->distances[n]);
    return largest;
}

/* It is counted from an edge, which what is solid between its links has; one that follows from
 * where particles flow, or that is ragged within a step, says nothing so exactly. */
static bool keeps_distance(const fw_solid_model *model)
{
    return model->solid_between_links && !model->list_links && model->ticks_per_step == 1;
}

static fw_status set_distances(const fw_experiment *experiment, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    if (!(largest_distance(&scenario->contact) > 0)) return FW_OK;
    for (int b = 0; b < experiment->body_count; ++b) {
        const fw_solid_model *model = fw_experiment_solid(experiment, b)->model;
        if (keeps_distance(model)) continue;
        return fw_scenario_fail(scenario, scenario->bodies[b].place, error,
                                "contact.distance is kept by LB solids and linear lattices, but "
                                "body %s is of model %s",
                                scenario->bodies[b].name, model->name);
    }
    return fw_scene_set_distances(experiment->scene, scenario->contact.distances, error);
}

/* What the scene refuses is said at the body that it names, or else at the walls. */
static fw_status begin_scene(fw_experiment *experiment, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    fw_place place = scenario->wall_count > 0 ? scenario->walls[0].place : (fw_place){0};
    FW_TRY(set_friction(experiment, error));
    FW_TRY(set_distances(experiment, error));
    if (fw_scenario_records_force(scenario)) fw_scene_keep_forces(experiment->scene);
    const fw_status status = fw_scene_begin(experiment->scene, error);
    const int refused = fw_scene_refused_body(experiment->scene);
    for (int b = 0; b < scenario->body_count; ++b)
        if (experiment->bodies[b].solid == refused) place = scenario->bodies[b].place;
    return fw_scenario_fail_again(scenario, place, status, error);
}

static fw_status fill(fw_experiment *experiment, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    fw_vec2 middle =
        scenario->body_count > 0 ? scenario->bodies[0].lattice.origin : (fw_vec2){0, 0};
    FW_TRY(fw_scene_create(&experiment->scene, middle, scenario->run.limit, error));
    for (int b = 0; b < scenario->body_count; ++b) FW_TRY(make_sites(experiment, b, error));
    for (int b = 0; b < scenario->body_count; ++b) FW_TRY(add_body(experiment, b, error));
    FW_TRY(refuse_reversal(experiment, error));
    FW_TRY(refuse_lost(experiment, middle, error));
    for (int w = 0; w < scenario->wall_count; ++w) {
        const fw_scenario_wall *wall = &scenario->walls[w];
        FW_TRY(fw_scenario_fail_again(
            scenario, wall->place,
            add_wall(experiment->scene, wall, scenario->contact.distance, error), error));
    }
    FW_TRY(let_pistons_meet(scenario, experiment->scene, error));
    for (int b = 0; b < scenario->body_count; ++b) FW_TRY(refuse_walls(experiment, b, error));
    for (int n = 0; n < scenario->force_count; ++n) FW_TRY(add_force(experiment, n, error));
    FW_TRY(fw_grips_add(scenario, experiment->scene, experiment->bodies, error));
    FW_TRY(fw_phases_check(scenario, experiment->scene, error));
    FW_TRY(fw_period_check(scenario, experiment->scene, error));
    FW_TRY(begin_scene(experiment, error));
    return note_start(experiment, error);
}

fw_status fw_experiment_create(fw_experiment **experiment, const fw_scenario *scenario,
                               fw_error *error)
{
    *experiment = NULL;
    fw_experiment *made = calloc(1, sizeof *made);
    fw_body_range *bodies = calloc((size_t)scenario->body_count + 1, sizeof *bodies);
    if (!made || !bodies) {
        free(made);
        free(bodies);
        return fw_fail_memory(error, "an experiment");
    }
    made->scenario = scenario;
    made->bodies = bodies;
    made->phase = -1;
    made->body_count = scenario->body_count;
    fw_status status = fill(made, error);
    if (status != FW_OK) {
        fw_experiment_destroy(made);
        return status;
    }
    *experiment = made;
    return FW_OK;
}

void fw_experiment_destroy(fw_experiment *experiment)
{
    if (!experiment) return;
    fw_scene_destroy(experiment->scene);
    for (int b = 0; b < experiment->body_count; ++b) fw_sites_clear(&experiment->bodies[b].sites);
    for (int b = 0; experiment->start && b < experiment->body_count; ++b)
        free(experiment->start[b]);
    free(experiment->start);
    free(experiment->energy_at_start);
    free(experiment->momentum_at_start);
    free(experiment->bodies);
    free(experiment);
}

fw_status fw_experiment_advance(fw_experiment *experiment, int64_t most, fw_error *error)
{
    const fw_scenario *scenario = experiment->scenario;
    fw_scene *scene = experiment->scene;
    const int64_t reversal = scenario->run.reverse_at - fw_scene_steps(scene);
    if (reversal > 0 && reversal < most) most = reversal;
    if (scenario->phase_count > 0) most = 1;
    FW_TRY(fw_phase_enter(scenario, scene, experiment->bodies, &experiment->phase, error));
    FW_TRY(fw_scene_advance(scene, most, error));
    if (scenario->run.reverse_at == 0 || fw_scene_steps(scene) != scenario->run.reverse_at)
        return FW_OK;
    FW_TRY(fw_scene_settle(scene, error));
    for (int b = 0; b < fw_scene_body_count(scene); ++b) fw_solid_reverse(fw_scene_body(scene, b));
    return FW_OK;
}

fw_status fw_experiment_step(fw_experiment *experiment, fw_error *error)
{
    FW_TRY(fw_experiment_advance(experiment, 1, error));
    return fw_scene_settle(experiment->scene, error);
}

const fw_solid *fw_experiment_solid(const fw_experiment *experiment, int number)
{
    return fw_body_range_solid(experiment->scene, &experiment->bodies[number]);
}

const fw_solid *fw_experiment_particles(const fw_experiment *experiment)
{
    for (int b = 0; b < experiment->body_count; ++b)
        if (fw_solid_is_particles(fw_experiment_solid(experiment, b)))
            return fw_experiment_solid(experiment, b);
    return NULL;
}

double fw_experiment_energy_at_start(const fw_experiment *experiment, int member)
{
    double start = 0;
    for (int b = 0; b < experiment->body_count; ++b)
        if (experiment->bodies[b].solid == experiment->bodies[member].solid)
            start += experiment->energy_at_start[b];
    return start;
}
