/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_make.c - making a scene, its state, and putting it back to a saved one. State: that of
 * scene_parts.h. Start reading at fw_scene_begin(). */
#include "contact/geometry/wall.h"
#include "scene_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A particle may start this far behind a wall, in units of the coordinates' size: rounding of a
 * position that was meant to lie on the surface. */
static const double ON_SURFACE = 1e-14;

fw_status fw_scene_create(fw_scene **scene, fw_vec2 middle, double limit, fw_error *error)
{
    *scene = calloc(1, sizeof **scene);
    if (!*scene) return fw_fail_memory(error, "a scene");
    (*scene)->middle = middle;
    (*scene)->limit = limit;
    (*scene)->ticks_per_step = 1;
    return FW_OK;
}

void fw_scene_destroy(fw_scene *scene)
{
    if (!scene) return;
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        free(body->name);
        fw_solid_destroy(body->solid);
        fw_boundary_destroy(body->boundary);
        free(body->memory);
        free(body->contacts);
        free(body->entry_end);
        free(body->entry_of);
        free(body->memory_before);
        free(body->gripped);
        free(body->constraints);
        free(body->carries);
        fw_contour_clear(&body->fold);
        scene_destroy_records(body);
    }
    scene_destroy_edges(scene);
    fw_broadphase_destroy(scene->broadphase);
    for (int w = 0; w < scene->wall_count; ++w) {
        fw_wall_destroy(scene->walls[w].wall);
        fw_piston_destroy(scene->walls[w].piston);
    }
    for (int n = 0; n < scene->load_count; ++n) fw_load_destroy(scene->loads[n].load);
    for (int n = 0; n < scene->grip_count; ++n) fw_grip_destroy(scene->grips[n].grip);
    free(scene->grips);
    free(scene->bodies);
    free(scene->walls);
    free(scene->ledgers);
    free(scene->loads);
    free(scene->candidates);
    free(scene->near);
    free(scene->met);
    free(scene->pairs);
    free(scene->distances);
    free(scene->passable);
    free(scene);
}

/* Room for one more element at the end of an array that grows by one while a scene is made. */
static void *grown(void *array, int count, size_t size)
{
    return realloc(array, ((size_t)count + 1) * size);
}

fw_status fw_scene_adopt_body(fw_scene *scene, const char *name, fw_solid *solid, int *body,
                              fw_error *error)
{
    scene_body *bodies = grown(scene->bodies, scene->body_count, sizeof *bodies);
    char *copy = strdup(name);
    if (bodies) scene->bodies = bodies;
    if (!bodies || !copy) {
        free(copy);
        fw_solid_destroy(solid);
        return fw_fail_memory(error, "a body");
    }
    if (scene->body_count > 0 && solid->tick != scene->tick) {
        fw_fail(error, FW_BAD_INPUT,
                "body %s takes time steps of %g, expected %g like the bodies before it", name,
                solid->tick, scene->tick);
        free(copy);
        fw_solid_destroy(solid);
        return FW_BAD_INPUT;
    }
    if (scene->body_count > 0 && solid->model->ticks_per_step != scene->ticks_per_step) {
        fw_fail(error, FW_BAD_INPUT,
                "body %s moves %s, expected all bodies of a scene to do so or none", name,
                solid->model->ticks_per_step == 2 ? "in half-steps, one colour after the other"
                                                  : "all at once, those before it in half-steps");
        free(copy);
        fw_solid_destroy(solid);
        return FW_BAD_INPUT;
    }
    scene->tick = solid->tick;
    scene->ticks_per_step = solid->model->ticks_per_step;
    *body = scene->body_count;
    scene->bodies[scene->body_count++] = (scene_body){.name = copy, .solid = solid};
    return FW_OK;
}

fw_status fw_scene_add_wall(fw_scene *scene, const fw_wall_def *def, fw_error *error)
{
    scene_wall *walls = grown(scene->walls, scene->wall_count, sizeof *walls);
    if (!walls) return fw_fail_memory(error, "a wall");
    scene->walls = walls;
    scene_wall *wall = &scene->walls[scene->wall_count];
    *wall = (scene_wall){.end = -1};
    FW_TRY(fw_wall_create(&wall->wall, scene->wall_count, def, error));
    wall->bounds = fw_wall_bounds(wall->wall);
    wall->soft = def->surface.law == FW_PENALTY;
    scene->wall_count += 1;
    return FW_OK;
}

fw_status fw_scene_add_piston(fw_scene *scene, const fw_wall_def *def, const fw_piston_def *piston,
                              fw_error *error)
{
    fw_wall_def driven = *def;
    fw_piston *made;
    if (scene->piston_count == FW_STATE_CAPACITY)
        return fw_fail(error, FW_BAD_INPUT, "piston %s is one too many, expected at most %d",
                       def->name, FW_STATE_CAPACITY);
    driven.path = fw_wall_def_default().path;
    driven.driven = true;
    FW_TRY(fw_piston_create(&made, def->name, piston, error));
    fw_status status = fw_scene_add_wall(scene, &driven, error);
    if (status != FW_OK) {
        fw_piston_destroy(made);
        return status;
    }
    scene->walls[scene->wall_count - 1].piston = made;
    scene->piston_count += 1;
    return FW_OK;
}

fw_status fw_scene_add_grip(fw_scene *scene, int number, const fw_grip_def *def, fw_error *error)
{
    scene_body *body = &scene->bodies[number];
    scene_grip *grips = grown(scene->grips, scene->grip_count, sizeof *grips);
    if (grips) scene->grips = grips;
    if (!body->gripped)
        body->gripped = fw_array_allocate((size_t)body->solid->count, sizeof *body->gripped);
    if (!grips || !body->gripped) return fw_fail_memory(error, "a grip");
    if (body->solid->model->ticks_per_step != 1)
        return fw_fail(error, FW_BAD_INPUT,
                       "grip %s holds a body that moves in half-steps, expected one of particles "
                       "that all move at once",
                       def->name);
    if (scene->grip_count == FW_STATE_CAPACITY)
        return fw_fail(error, FW_BAD_INPUT, "grip %s is one too many, expected at most %d",
                       def->name, FW_STATE_CAPACITY);
    for (int n = 0; n < def->particle_count; ++n)
        if (body->gripped[def->particles[n]])
            return fw_fail(error, FW_BAD_INPUT,
                           "grip %s holds particle %d of body %s, which another grip holds already",
                           def->name, def->particles[n], body->name);
    for (int n = 0; n < scene->grip_count; ++n)
        if (strcmp(fw_grip_name(scene->grips[n].grip), def->name) == 0)
            return fw_fail(error, FW_BAD_INPUT,
                           "two grips are called %s, expected names of their own", def->name);
    scene_grip *grip = &scene->grips[scene->grip_count];
    grip->body = number;
    grip->end = -1;
    FW_TRY(fw_grip_create(&grip->grip, def, error));
    for (int n = 0; n < def->particle_count; ++n)
        body->gripped[def->particles[n]] = (uint8_t)(scene->grip_count + 1);
    scene->grip_count += 1;
    return FW_OK;
}

fw_status fw_scene_add_load(fw_scene *scene, int body, const fw_load_def *def, fw_error *error)
{
    scene_load *loads = grown(scene->loads, scene->load_count, sizeof *loads);
    if (!loads) return fw_fail_memory(error, "an external force");
    scene->loads = loads;
    scene->loads[scene->load_count].body = body;
    FW_TRY(fw_load_create(&scene->loads[scene->load_count].load, def, scene->bodies[body].solid,
                          error));
    scene->load_count += 1;
    return FW_OK;
}

/* What all walls span, for the broadphase's scale. */
static fw_box extent_of(const fw_scene *scene)
{
    fw_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int w = 0; w < scene->wall_count; ++w) box = fw_box_joined(box, scene->walls[w].bounds);
    return box;
}

static fw_status build_broadphase(fw_scene *scene, fw_error *error)
{
    scene->broadphase = fw_broadphase_create(extent_of(scene));
    if (!scene->broadphase) return fw_fail_memory(error, "the broadphase");
    for (int w = 0; w < scene->wall_count; ++w) {
        scene_wall *wall = &scene->walls[w];
        wall->first_facet = fw_broadphase_add_wall(scene->broadphase, wall->wall);
        if (wall->first_facet < 0) return fw_fail_memory(error, "the facets of a wall");
    }
    scene->facet_count = fw_broadphase_facet_count(scene->broadphase);
    scene->candidates = calloc((size_t)scene->facet_count + 1, sizeof *scene->candidates);
    scene->near = calloc((size_t)scene->facet_count + 1, sizeof *scene->near);
    scene->passable = calloc((size_t)scene->facet_count + 1, sizeof *scene->passable);
    scene->ledgers = calloc((size_t)scene->wall_count + 1, sizeof *scene->ledgers);
    if (!scene->candidates || !scene->near || !scene->passable || !scene->ledgers)
        return fw_fail_memory(error, "the facets of all walls");
    for (int f = 0; f < scene->facet_count; ++f) {
        const fw_facet *facet = fw_broadphase_facet(scene->broadphase, f);
        scene->candidates[f] =
            (fw_candidate){.facet = facet,
                           .number = f,
                           .surface = fw_wall_surface(scene->walls[facet->wall].wall)};
    }
    return FW_OK;
}

static bool any_wall_rubs(const fw_scene *scene)
{
    for (int w = 0; w < scene->wall_count; ++w)
        if (fw_wall_surface(scene->walls[w].wall).law == FW_COULOMB) return true;
    return false;
}

static fw_status prepare_body(fw_scene *scene, scene_body *body, fw_error *error)
{
    size_t count = (size_t)body->solid->count;
    FW_TRY(fw_boundary_create(&body->boundary, body->solid, error));
    body->boundary_revision = body->solid->boundary_revision;
    body->contacts = calloc(count, sizeof *body->contacts);
    if (any_wall_rubs(scene)) body->memory = calloc(count, sizeof *body->memory);
    if (!body->contacts || (any_wall_rubs(scene) && !body->memory))
        return fw_fail_memory(error, "the contacts of a body");
    if (scene->piston_count > 0 || body->gripped) {
        body->entry_end = calloc(count, sizeof *body->entry_end);
        if (!body->entry_end) return fw_fail_memory(error, "the contacts of a body");
        for (size_t n = 0; n < count; ++n) body->entry_end[n] = -1;
    }
    if (scene_pistons_take_steps(scene)) {
        body->entry_of = calloc(count, sizeof *body->entry_of);
        body->entry_of_revision = -1;
        if (!body->entry_of) return fw_fail_memory(error, "the contacts of a body");
    }
    if ((scene->piston_count == 0 && !body->gripped) || !body->memory) return FW_OK;
    body->memory_before = calloc(count, sizeof *body->memory);
    return body->memory_before ? FW_OK : fw_fail_memory(error, "the contacts of a body");
}

static fw_status refuse_overlap(const fw_scene *scene, const scene_body *body, fw_error *error)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        const fw_wall *wall = scene->walls[w].wall;
        fw_vec2 place = fw_wall_displacement(wall, 0);
        int deepest = -1;
        double most = 0;
        for (int i = 0; i < body->solid->count; ++i) {
            const fw_vec2 at = fw_solid_position(body->solid, i);
            const double depth = fw_wall_depth(wall, at, place);
            if (depth <= ON_SURFACE * (1 + fabs(at.x) + fabs(at.y)) || depth <= most) continue;
            most = depth;
            deepest = i;
        }
        if (deepest < 0) continue;
        const fw_vec2 at = fw_solid_position(body->solid, deepest);
        return fw_fail(error, FW_BAD_INPUT,
                       "body %s starts in wall %s: particle %d at (%g, %g) lies %g behind "
                       "its surface, expected all particles on the free side%s",
                       body->name, fw_wall_name(wall), deepest, at.x, at.y, most,
                       fw_wall_shape_of(fw_wall_definition(wall))->sided
                           ? ""
                           : ", which is to the left of the way along a chain");
    }
    return FW_OK;
}

fw_status fw_scene_begin(fw_scene *scene, fw_error *error)
{
    if (scene->wall_count > 0) {
        FW_TRY(build_broadphase(scene, error));
        for (int b = 0; b < scene->body_count; ++b) {
            FW_TRY(refuse_overlap(scene, &scene->bodies[b], error));
            FW_TRY(prepare_body(scene, &scene->bodies[b], error));
        }
        for (int w = 0; w < scene->wall_count; ++w) {
            const fw_surface surface = fw_wall_surface(scene->walls[w].wall);
            if (surface.law != FW_PENALTY) continue;
            scene->soft_count += 1;
            scene->soft_stiffness += surface.stiffness;
        }
        FW_TRY(scene_check_soft(scene, error));
    }
    FW_TRY(scene_refuse_met(scene, error));
    FW_TRY(scene_make_edges(scene, error));
    FW_TRY(scene_make_records(scene, error));
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        if (body->edge && !body->contacts)
            body->contacts = calloc((size_t)body->solid->count, sizeof *body->contacts);
        if (body->edge && !body->contacts) return fw_fail_memory(error, "the contacts of a body");
        body->constraints = calloc((size_t)body->solid->count, sizeof *body->constraints);
        body->carries = calloc((size_t)body->solid->count, sizeof *body->carries);
        if (!body->constraints || !body->carries)
            return fw_fail_memory(error, "the constraints of a body");
    }
    fw_energies energies = fw_scene_energies(scene);
    scene->energy_at_start = energies.kinetic + energies.elastic;
    scene->momentum_at_start = fw_scene_momentum(scene);
    scene_note_work(scene);
    return FW_OK;
}

int fw_scene_section_count(const fw_scene *scene)
{
    return 1 + scene->body_count + (scene->grip_count > 0) + (scene->piston_count > 0) +
           (scene->joint != NULL);
}

const char *fw_scene_section(fw_scene *scene, int section, fw_state_list *list)
{
    if (section == 0) {
        fw_state_list_add(list, "clock", FW_I64, sizeof scene->clock / sizeof(int64_t),
                          &scene->clock);
        fw_state_list_add(list, "walls", FW_F64,
                          (size_t)scene->wall_count * sizeof *scene->ledgers / sizeof(double),
                          scene->ledgers);
        fw_state_list_add(list, "energy-at-start", FW_F64, 1, &scene->energy_at_start);
        fw_state_list_add(list, "momentum-at-start", FW_F64, 2, &scene->momentum_at_start);
        fw_state_list_add(list, "energy-scale", FW_F64, 1, &scene->energy_scale);
        return "scene";
    }
    if (scene->joint && section + 1 == fw_scene_section_count(scene)) {
        fw_state_list_add(list, "contact", FW_F64, sizeof scene->joint->ledger / sizeof(double),
                          &scene->joint->ledger);
        fw_state_list_add(list, "bodies", FW_F64,
                          (size_t)scene->joint->slot_count * sizeof *scene->joint->bodies /
                              sizeof(double),
                          scene->joint->bodies);
        return "bodies";
    }
    if (section > scene->body_count + (scene->grip_count > 0)) {
        for (int w = 0; w < scene->wall_count; ++w)
            if (scene->walls[w].piston)
                fw_state_list_add(list, fw_wall_name(scene->walls[w].wall), FW_F64,
                                  sizeof(fw_piston_ledger) / sizeof(double),
                                  fw_piston_ledger_of(scene->walls[w].piston));
        return "pistons";
    }
    if (section > scene->body_count) {
        for (int n = 0; n < scene->grip_count; ++n)
            fw_state_list_add(list, fw_grip_name(scene->grips[n].grip), FW_F64,
                              sizeof(fw_grip_ledger) / sizeof(double),
                              fw_grip_ledger_of(scene->grips[n].grip));
        return "grips";
    }
    scene_body *body = &scene->bodies[section - 1];
    body->solid->model->state(body->solid, list);
    if (body->edge && body->edge->rubs)
        fw_state_list_add(list, "body-friction", FW_U8,
                          (size_t)body->solid->count * sizeof *body->edge->rubs, body->edge->rubs);
    if (body->memory)
        fw_state_list_add(list, "contact-memory", FW_U8,
                          (size_t)body->solid->count * sizeof *body->memory, body->memory);
    scene_list_records(body, list);
    return body->name;
}

static fw_status check_clock(const fw_scene *scene, fw_error *error)
{
    const scene_clock *clock = &scene->clock;
    bool sound = clock->step >= 0 && clock->unresolved >= 0 &&
                 clock->step <= INT64_MAX / scene->ticks_per_step &&
                 clock->ticks == clock->step * scene->ticks_per_step;
    if (sound) return FW_OK;
    return fw_fail(error, FW_BAD_INPUT,
                   "the clock shows %lld steps of %d ticks and %lld ticks, which do not agree",
                   (long long)clock->step, scene->ticks_per_step, (long long)clock->ticks);
}

/* What a particle rubbed on is a segment of another body. */
static fw_status check_rubs(const fw_scene *scene, int number, fw_error *error)
{
    const scene_body *body = &scene->bodies[number];
    for (int i = 0; body->edge && body->edge->rubs && i < body->solid->count; ++i) {
        const scene_rub *rub = &body->edge->rubs[i];
        if (rub->other == 0) continue;
        const bool sound = rub->other > 0 && rub->other <= scene->body_count &&
                           fw_scene_bodies_meet(scene, number, rub->other - 1) &&
                           rub->segment >= 0 && rub->lambda >= 0 && isfinite(rub->lambda) &&
                           isfinite(rub->inertial);
        if (!sound)
            return fw_fail(error, FW_BAD_INPUT,
                           "particle %d of body %s rubs on segment %d of body %d, which there is "
                           "not",
                           i, body->name, rub->segment, rub->other);
    }
    return FW_OK;
}

/* A facet that a particle remembers is one of the scene; without one it has felt no force. */
static fw_status check_memory(const fw_scene *scene, const scene_body *body, fw_error *error)
{
    for (int i = 0; body->memory && i < body->solid->count; ++i)
        if (body->memory[i].facet < 0 || body->memory[i].facet > scene->facet_count ||
            (body->memory[i].facet == 0 && body->memory[i].reaction != 0))
            return fw_fail(error, FW_BAD_INPUT,
                           "particle %d of body %s touches facet %d, expected 1 to %d, or 0 where "
                           "it feels no force",
                           i, body->name, body->memory[i].facet, scene->facet_count);
    return FW_OK;
}

fw_status fw_scene_restored(fw_scene *scene, fw_error *error)
{
    FW_TRY(check_clock(scene, error));
    scene->apart = (scene_apart){0};
    for (int b = 0; b < scene->body_count; ++b) {
        scene_body *body = &scene->bodies[b];
        const fw_status status = fw_solid_restored(body->solid, error);
        if (status != FW_OK) fw_fail_within(error, "body %s", body->name);
        FW_TRY(status);
        FW_TRY(check_memory(scene, body, error));
        FW_TRY(check_rubs(scene, b, error));
        scene_restore_records(body);
        if (!body->boundary) continue;
        fw_boundary_destroy(body->boundary);
        body->boundary = NULL;
        FW_TRY(fw_boundary_create(&body->boundary, body->solid, error));
        body->boundary_revision = body->solid->boundary_revision;
    }
    return scene_restore_edges(scene, error);
}
