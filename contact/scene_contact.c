/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_contact.c - the contact phase of a step: from runs of candidates to holds. */
#include "contact/scene_parts.h"

#include <math.h>
#include <stdlib.h>

/* A colour of an automaton moves in every second tick only, and then for both: it meets the walls
 * where they were when it moved last. Otherwise a wall would run over a colour that rests. */
void scene_follow_wall(fw_scene *scene, int w, int ticks)
{
    const double now = fw_scene_time(scene);
    const double since = fmax(0, now - (ticks - 1) * scene->tick);
    scene_wall *wall = &scene->walls[w];
    wall->place = fw_wall_displacement(wall->wall, since);
    wall->motion =
        fw_vec2_subtract(fw_wall_displacement(wall->wall, now + scene->tick), wall->place);
}

void scene_place_barriers(fw_scene *scene, int ticks)
{
    for (int w = 0; w < scene->wall_count; ++w) scene_follow_wall(scene, w, ticks);
    for (int f = 0; f < scene->facet_count; ++f) {
        fw_barrier *barrier = &scene->barriers[f];
        barrier->place = scene->walls[barrier->facet->wall].place;
        barrier->motion = scene->walls[barrier->facet->wall].motion;
    }
}

fw_status scene_refresh_skin(fw_scene *scene, scene_body *body, fw_error *error)
{
    if (body->skin_revision != body->solid->skin_revision) {
        fw_skin_destroy(body->skin);
        body->skin = NULL;
        FW_TRY(fw_skin_create(&body->skin, body->solid, error));
        body->skin_revision = body->solid->skin_revision;
        fw_solid_predict(body->solid, fw_skin_particles(body->skin), fw_skin_count(body->skin),
                         fw_skin_predictions(body->skin));
    }
    return fw_skin_refresh(body->skin, body->solid, scene->broadphase, error);
}

static int compare_contacts(const void *left, const void *right)
{
    const scene_contact *a = left, *b = right;
    return (a->particle > b->particle) - (a->particle < b->particle);
}

static void list_near(fw_scene *scene, fw_run run)
{
    for (int n = 0; n < run.facet_count; ++n) scene->near[n] = scene->barriers[run.facets[n]];
}

/* One particle of a run. Where the walls push it further than its free path, the list is extended
 * and the particle solved again, from the same memory. */
static fw_status constrain_entry(fw_scene *scene, scene_body *body, int run_number, int entry,
                                 fw_error *error)
{
    int particle = fw_skin_particles(body->skin)[entry];
    const fw_vec2 position = fw_solid_position(body->solid, particle);
    const fw_prediction *free = &fw_skin_predictions(body->skin)[entry];
    fw_contact_memory *memory = body->memory ? &body->memory[particle] : NULL;
    const fw_contact_memory before = memory ? *memory : (fw_contact_memory){0};
    for (;;) {
        fw_run run = fw_skin_run(body->skin, run_number);
        fw_constraint constraint =
            fw_constrain(position, free, scene->near, run.facet_count, scene->barriers, memory);
        if (!constraint.held) return FW_OK;
        FW_TRY(fw_skin_extend(body->skin, scene->broadphase, run_number,
                              fw_vec2_add(position, constraint.displacement), error));
        fw_run extended = fw_skin_run(body->skin, run_number);
        if (extended.facet_count == run.facet_count) {
            body->contacts[body->contact_count++] = (scene_contact){particle, constraint};
            return FW_OK;
        }
        list_near(scene, extended);
        if (memory) *memory = before;
    }
}

/* A force acts on its particle for `ticks`, from one move to the next. */
static void book(fw_scene *scene, const fw_constraint *constraint, int ticks)
{
    for (int n = 0; n < constraint->touch_count; ++n) {
        const fw_touch *touch = &constraint->touch[n];
        fw_wall_account *account = &scene->accounts[touch->wall];
        account->force = fw_vec2_add(account->force, fw_vec2_scale(ticks, touch->force));
        account->work += touch->work;
        account->dissipated += touch->dissipated;
        bool counted = false;
        for (int m = 0; m < n; ++m) counted |= constraint->touch[m].wall == touch->wall;
        account->contacts += !counted;
    }
    scene->clock.unresolved += constraint->unresolved;
}

fw_status scene_constrain_body(fw_scene *scene, scene_body *body, fw_error *error)
{
    body->contact_count = 0;
    if (scene->wall_count == 0) return FW_OK;
    for (int n = 0; n < fw_skin_run_count(body->skin); ++n) {
        fw_run run = fw_skin_run(body->skin, n);
        if (run.facet_count == 0 && !body->memory) continue;
        list_near(scene, run);
        for (int entry = run.first; entry < run.first + run.count; ++entry)
            if (!body->gripped || !body->gripped[fw_skin_particles(body->skin)[entry]])
                FW_TRY(constrain_entry(scene, body, n, entry, error));
    }
    /* Runs follow a curve through space that is another one after a restart; sums go by particle.
     */
    qsort(body->contacts, (size_t)body->contact_count, sizeof *body->contacts, compare_contacts);
    for (int n = 0; n < body->contact_count; ++n)
        book(scene, &body->contacts[n].constraint, body->solid->model->ticks_per_step);
    return FW_OK;
}

static int compare_holds(const void *left, const void *right)
{
    const fw_hold *a = left, *b = right;
    return (a->particle > b->particle) - (a->particle < b->particle);
}

void scene_collect_holds(fw_scene *scene, int number)
{
    scene_body *body = &scene->bodies[number];
    body->hold_count = body->contact_count;
    for (int n = 0; n < body->contact_count; ++n) {
        const scene_contact *contact = &body->contacts[n];
        body->holds[n] = (fw_hold){contact->particle, contact->constraint.displacement,
                                   contact->constraint.force};
    }
    if (!body->gripped) return;
    for (int n = 0; n < scene->grip_count; ++n) {
        if (scene->grips[n].body != number) continue;
        fw_grip *grip = scene->grips[n].grip;
        fw_grip_hold(grip, body->solid, fw_scene_time(scene), body->holds + body->hold_count);
        body->hold_count += fw_grip_particle_count(grip);
    }
    qsort(body->holds, (size_t)body->hold_count, sizeof *body->holds, compare_holds);
}
