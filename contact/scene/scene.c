/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene.c - one time step on one page: see step_once().
 * State: the clock, what passed through each wall, and what each particle remembers of its contact;
 * the solids keep their own. Candidate lists are no state: results do not depend on them. */
#include "contact/scene/scene.h"

#include "scene_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* 1. load: the external forces of this step. */
static void apply_loads(fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b) {
        fw_solid *solid = scene->bodies[b].solid;
        if (!solid->loaded) continue;
        memset(solid->external_x, 0, (size_t)solid->count * sizeof *solid->external_x);
        memset(solid->external_y, 0, (size_t)solid->count * sizeof *solid->external_y);
        solid->loaded = false;
    }
    for (int n = 0; n < scene->load_count; ++n)
        fw_load_apply(scene->loads[n].load, scene->clock.step,
                      scene->bodies[scene->loads[n].body].solid);
}

/* 2. predict: where boundary particles would go, and how they yield to a force. */
static fw_status predict_boundaries(fw_scene *scene, fw_error *error)
{
    FW_TRY(scene_begin_pistons(scene, error));
    for (int b = 0; b < scene->body_count && scene->wall_count > 0; ++b)
        scene_predict_boundary(scene, &scene->bodies[b]);
    return scene_predict_edges(scene, error);
}

/* 3. find, and 4. constrain: which facets are near which run of boundary particles, and the forces
 * that hold contact particles. */
static fw_status constrain_contacts(fw_scene *scene, fw_error *error)
{
    FW_TRY(scene_find_contacts(scene, error));
    return scene_constrain_bodies(scene, error);
}

/* Says in front of the error in which step, and of which body. Returns `status`. */
static fw_status fail_of_body(const fw_scene *scene, int b, fw_status status, fw_error *error)
{
    fw_fail_within(error, "step %lld: body %s", (long long)scene->clock.step,
                   scene->bodies[b].name);
    return status;
}

/* 5. advance: every solid moves, held by contacts and grips. */
static fw_status advance_solids(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        scene_collect_constraints(scene, b);
        const fw_status status =
            fw_solid_move(body->solid, body->constraints, body->constraint_count, error);
        if (status != FW_OK) return fail_of_body(scene, b, status, error);
        scene_carry(scene, b);
    }
    return FW_OK;
}

/* 6. ledger: work, heat and impulse of each wall. */
static void balance_ledger(fw_scene *scene)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        fw_wall_ledger *ledger = &scene->ledgers[w];
        ledger->reaction =
            fw_vec2_scale(0.5, fw_vec2_add(ledger->force, scene->walls[w].force_before));
        ledger->impulse = fw_vec2_add(ledger->impulse, fw_vec2_scale(scene->tick, ledger->force));
        ledger->held += ledger->contacts;
        if (scene->walls[w].cone > 0)
            ledger->overstep =
                fmax(ledger->overstep, scene->walls[w].beyond / scene->walls[w].cone);
    }
}

static fw_status report_lost(const fw_scene *scene, const scene_body *body, int lost,
                             fw_error *error)
{
    const fw_solid *solid = body->solid;
    return fw_fail(error, FW_DIVERGED,
                   "step %lld: particle %d of body %s is at (%g, %g) under the external force "
                   "(%g, %g), expected finite numbers within %g of (%g, %g)",
                   (long long)scene->clock.step, lost, body->name, solid->x[lost], solid->y[lost],
                   solid->external_x[lost], solid->external_y[lost], scene->limit, scene->middle.x,
                   scene->middle.y);
}

/* Looks at what is sure to be right without fw_solid_place(). */
static fw_status check_finite(const fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count; ++b) {
        const fw_solid *solid = scene->bodies[b].solid;
        const int lost = solid->model->place
                             ? fw_solid_find_lost_boundary(solid, scene->middle, scene->limit)
                             : fw_solid_find_lost(solid, scene->middle, scene->limit);
        if (lost >= 0) return report_lost(scene, &scene->bodies[b], lost, error);
    }
    for (int w = 0; w < scene->wall_count && scene->piston_count > 0; ++w) {
        const fw_vec2 at = fw_scene_wall_displacement(scene, w);
        if (!scene->walls[w].piston || (fabs(at.x) <= scene->limit && fabs(at.y) <= scene->limit))
            continue;
        return fw_fail(
            error, FW_DIVERGED,
            "step %lld: piston %s is displaced by (%g, %g) under the push (%g, %g) of the "
            "bodies, expected finite numbers within %g",
            (long long)scene->clock.step, fw_wall_name(scene->walls[w].wall), at.x, at.y,
            scene->walls[w].push.x, scene->walls[w].push.y, scene->limit);
    }
    return FW_OK;
}

static fw_status step_once(fw_scene *scene, fw_error *error)
{
    FW_TRY(scene_end_apart(scene, error));
    for (int tick = 0; tick < scene->ticks_per_step; ++tick) {
        apply_loads(scene);
        FW_TRY(predict_boundaries(scene, error));
        FW_TRY(constrain_contacts(scene, error));
        scene_book_contacts(scene);
        scene_book_joint(scene);
        FW_TRY(advance_solids(scene, error));
        FW_TRY(scene_check_room(scene, error));
        scene_advance_pistons(scene);
        balance_ledger(scene);
        scene->clock.ticks += 1;
    }
    scene->clock.step += 1;
    scene_note_work(scene);
    FW_TRY(check_finite(scene, error));
    scene_look_ahead(scene);
    return FW_OK;
}

/* Nothing ever acts on the bodies, and nobody has to look at each of their steps. */
static bool is_free(const fw_scene *scene)
{
    for (int b = 0; b < scene->body_count; ++b)
        if (!scene->bodies[b].solid->model->place) return false;
    return scene->wall_count == 0 && scene->load_count == 0 && scene->grip_count == 0 &&
           !scene->joint;
}

/* What is left of step_once() then. */
static fw_status step_free(fw_scene *scene, int steps, fw_error *error)
{
    const int ticks = steps * scene->ticks_per_step;
    for (int b = 0; b < scene->body_count; ++b) {
        const fw_status status = fw_solid_move_free(scene->bodies[b].solid, ticks, error);
        if (status != FW_OK) return fail_of_body(scene, b, status, error);
    }
    scene->clock.ticks += ticks;
    scene->clock.step += steps;
    scene_note_work(scene);
    return FW_OK;
}

fw_status fw_scene_advance(fw_scene *scene, int64_t most, fw_error *error)
{
    int64_t left = FW_SCENE_SETTLES_EVERY - scene->clock.step % FW_SCENE_SETTLES_EVERY;
    if (!is_free(scene)) {
        const int64_t apart = scene_steps_apart(scene);
        if (apart <= 0) return step_once(scene, error);
        if (apart < left) left = apart;
    }
    return step_free(scene, (int)(most < left ? most : left), error);
}

static fw_status settle(const fw_scene *scene, scene_body *body, fw_error *error)
{
    fw_solid *solid = body->solid;
    if (!solid->model->place) return FW_OK;
    fw_solid_place(solid);
    const int lost = fw_solid_find_lost(solid, scene->middle, scene->limit);
    return lost < 0 ? FW_OK : report_lost(scene, body, lost, error);
}

fw_status fw_scene_settle(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count; ++b) FW_TRY(settle(scene, &scene->bodies[b], error));
    return FW_OK;
}

/* Loads do work on all particles, wherever they are. */
fw_status fw_scene_settle_boundaries(fw_scene *scene, fw_error *error)
{
    for (int b = 0; b < scene->body_count; ++b) {
        fw_solid *solid = scene->bodies[b].solid;
        const fw_solid_model *model = solid->model;
        if (model->stays_within && !solid->loaded &&
            model->stays_within(solid, scene->middle, scene->limit))
            model->place_boundary(solid);
        else
            FW_TRY(settle(scene, &scene->bodies[b], error));
    }
    return FW_OK;
}

fw_status fw_scene_step(fw_scene *scene, fw_error *error)
{
    FW_TRY(step_once(scene, error));
    return fw_scene_settle(scene, error);
}
