/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_apart.c - bodies that cannot come to anything for a while need not be asked in every tick
 * where they would go.
 *
 * A look at them finds for how many ticks: a solid says how far its boundary can go at most
 * (`reach`), and that is less than what lies between it and all walls, half of what lies between
 * it and other bodies, and what is left to the limit of positions. Until then the tick is that of
 * a free body, to the bit, and several may be taken in one sweep.
 * State: until when, when to look again, and what was found; no result depends on it. Start reading
 * at scene_look_ahead(). */
#include "scene_parts.h"

#include <assert.h>
#include <math.h>

/* Ticks that a look may find. */
enum { STRETCHES = 4 };
static const int stretches[STRETCHES] = {16, 64, 256, 1024};

/* --- what rules it out --- */

/* Loads and grips act in each tick, walls that move may come, and some solids never know. */
static bool can_be_apart(const fw_scene *scene)
{
    if (scene->load_count > 0 || scene->grip_count > 0 || scene->piston_count > 0) return false;
    for (int w = 0; w < scene->wall_count; ++w)
        if (fw_wall_moves(scene->walls[w].wall)) return false;
    for (int b = 0; b < scene->body_count; ++b)
        if (!scene->bodies[b].solid->model->reach) return false;
    return true;
}

static bool is_zero(fw_vec2 v)
{
    return v.x == 0 && v.y == 0;
}

static bool walls_feel_nothing(const fw_scene *scene)
{
    for (int w = 0; w < scene->wall_count; ++w) {
        const fw_wall_ledger *ledger = &scene->ledgers[w];
        if (!is_zero(ledger->force) || !is_zero(ledger->reaction) || ledger->contacts != 0)
            return false;
    }
    return true;
}

static bool bodies_feel_no_other(const scene_joint *joint)
{
    if (joint->row_count > 0 || joint->end_count > 0) return false;
    for (int slot = 0; slot < joint->slot_count; ++slot) {
        const fw_body_ledger *ledger = &joint->bodies[slot];
        if (!is_zero(ledger->force) || !is_zero(ledger->reaction) || ledger->contacts != 0)
            return false;
    }
    return true;
}

/* Nothing of the last ticks is left that the next one would take up. */
static bool has_forgotten(const scene_body *body)
{
    const fw_solid *solid = body->solid;
    if (body->contact_count > 0 || body->constraint_count > 0) return false;
    if (body->felt && (body->felt->now_count > 0 || body->felt->before_count > 0)) return false;
    for (int n = 0; n < solid->boundary_count; ++n) {
        const int i = solid->boundary[n];
        if (body->memory && (body->memory[i].facet != 0 || body->memory[i].reaction != 0))
            return false;
    }
    if (!body->edge || !body->edge->rubs) return true;
    for (int point = 0; point < body->edge->contour.point_count; ++point)
        if (body->edge->rubs[body->edge->contour.particles[point]].other != 0) return false;
    return true;
}

static bool nothing_acts(const fw_scene *scene)
{
    if (!walls_feel_nothing(scene)) return false;
    if (scene->joint && !bodies_feel_no_other(scene->joint)) return false;
    for (int b = 0; b < scene->body_count; ++b)
        if (!has_forgotten(&scene->bodies[b])) return false;
    return true;
}

/* --- how much room there is --- */

static fw_box box_of(const fw_solid *solid)
{
    fw_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int n = 0; n < solid->boundary_count; ++n) {
        const fw_vec2 at = fw_solid_position(solid, solid->boundary[n]);
        box = fw_box_joined(box, (fw_box){at, at});
    }
    return box;
}

/* 0 or less where they meet. */
static double gap_between(fw_box a, fw_box b)
{
    return fmax(fmax(b.low.x - a.high.x, a.low.x - b.high.x),
                fmax(b.low.y - a.high.y, a.low.y - b.high.y));
}

static double room_within_limit(const fw_scene *scene, fw_box box)
{
    return scene->limit - fmax(fmax(scene->middle.x - box.low.x, box.high.x - scene->middle.x),
                               fmax(scene->middle.y - box.low.y, box.high.y - scene->middle.y));
}

/* How far each body may go. */
static double room_of(const fw_scene *scene, int number)
{
    const scene_body *body = &scene->bodies[number];
    const fw_box box = box_of(body->solid);
    double room = room_within_limit(scene, box);
    for (int other = 0; scene->joint && other < scene->body_count && room > 0; ++other) {
        if (other == number || !fw_scene_bodies_meet(scene, number, other)) continue;
        const double gap = gap_between(box, box_of(scene->bodies[other].solid));
        room = fmin(room, (gap - scene_distance_between(scene, number, other)) / 2);
    }
    if (scene->wall_count == 0 || !(room > 0)) return room;
    const double size = fmax(box.high.x - box.low.x, box.high.y - box.low.y);
    return fw_boundary_clearance(body->boundary, body->solid, scene->broadphase,
                                 fmin(room, size + 1));
}

/* --- looking --- */

static bool keep_within_room(const fw_scene *scene, int ticks)
{
    for (int b = 0; b < scene->body_count; ++b) {
        const scene_body *body = &scene->bodies[b];
        if (!(body->solid->model->reach(body->solid, ticks) < body->room)) return false;
    }
    return true;
}

/* Of the stretches, that the last look found and its neighbours: it is seldom another one. Returns
 * its number, or -1. */
static int find_stretch(const fw_scene *scene)
{
    int n = scene->apart.stretch;
    if (!keep_within_room(scene, stretches[n])) {
        while (--n >= 0 && !keep_within_room(scene, stretches[n])) continue;
        return n;
    }
    while (n + 1 < STRETCHES && keep_within_room(scene, stretches[n + 1])) ++n;
    return n;
}

void scene_look_ahead(fw_scene *scene)
{
    scene_apart *apart = &scene->apart;
    if (scene->clock.ticks < apart->look) return;
    apart->look = scene->clock.ticks + stretches[0];
    if (!can_be_apart(scene)) apart->look = INT64_MAX;
    if (!can_be_apart(scene) || !nothing_acts(scene)) return;
    for (int b = 0; b < scene->body_count; ++b)
        if (!((scene->bodies[b].room = room_of(scene, b)) > 0)) return;
    const int found = find_stretch(scene);
    apart->stretch = found > 0 ? found : 0;
    if (found < 0) return;
    assert(scene->ticks_per_step == 1);
    apart->until = apart->look = scene->clock.ticks + stretches[found];
}

int64_t scene_steps_apart(const fw_scene *scene)
{
    return scene->apart.until - scene->clock.ticks;
}

fw_status scene_end_apart(fw_scene *scene, fw_error *error)
{
    if (scene->apart.until == 0) return FW_OK;
    scene->apart.until = 0;
    for (int b = 0; b < scene->body_count; ++b)
        scene->bodies[b].solid->model->place_boundary(scene->bodies[b].solid);
    return scene_renew_search(scene, error);
}
